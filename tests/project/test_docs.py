"""The documentation is tested: what it shows is there, and does what it says."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import settings_page
import sql_page
from gam_db.cli import config
from gam_db.engines import EVIDENCE, NAMES, engine_named

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def broken(page: Path) -> list[str]:
    """The links of a page that lead to no file beside it."""
    links = re.findall(r"\]\(([^)#:\s]+)\)", page.read_text(encoding="utf-8"))
    return [link for link in links if not (page.parent / link).exists()]


def test_every_link_of_every_page_leads_somewhere(tmp_path: Path) -> None:
    pages = [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), *ROOT.glob("*/README.md")]
    assert {page.name for page in pages} >= {"README.md", "CONTRIBUTING.md", "decisions.md"}
    assert {str(page): found for page in pages if (found := broken(page))} == {}
    (tmp_path / "page.md").write_text("[it](page.md), [not](there.md)", encoding="utf-8")
    assert broken(tmp_path / "page.md") == ["there.md"]


def test_ci_runs_the_tests_as_the_readme_says() -> None:
    command = re.search(r"^python -m pytest --engines all$", README, re.MULTILINE)
    assert command
    run = (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()
    assert f"{command[0]} --junitxml=durations.xml" in run
    assert "durations.xml" in (ROOT / ".gitignore").read_text(encoding="utf-8").splitlines()


def test_the_documented_settings_file_is_read(tmp_path: Path) -> None:
    parameters, calibration = config.load(ROOT / "docs" / "gam.toml").method()
    assert parameters.max_gap == "5 s"
    assert [override.changes() for override in parameters.overrides] == [{"tau": 10, "bins": 20}]
    assert calibration.overrides["robot_8"] is None
    shown = (ROOT / "docs" / "gam.toml").read_text(encoding="utf-8")
    assert shown == settings_page.text(), "python tests/tools/settings_page.py > docs/gam.toml"


def test_the_catalogue_lists_all_of_sql() -> None:
    """Every file is in it once, under a folder that it knows, with what its head says now."""
    folder = ROOT / "sql"
    page = (folder / "README.md").read_text(encoding="utf-8")
    listed = re.findall(r"^\| \[\w+\]\(([^)]+)\)", page, re.MULTILINE)
    there = (path.relative_to(folder).as_posix() for path in folder.rglob("*.sql"))
    assert sorted(listed) == sorted(there)
    assert page == sql_page.text(), "python tests/tools/sql_page.py > sql/README.md"


def test_the_picture_of_the_house_shows_every_room() -> None:
    """And none that is not there."""
    page = (ROOT / "docs" / "structure.svg").read_text(encoding="utf-8")
    shown = {
        word for text in re.findall(r">([^<>]+)</text>", page) for word in re.findall(r"[\w/]+/", text)
    }
    rooms = {
        f"{one.name}/" for base in ("gam_db", "sql") for one in (ROOT / base).iterdir() if one.is_dir()
    }
    rooms -= {"__pycache__/", "lab/"}
    assert rooms <= shown
    places = [ROOT, ROOT / "gam_db", ROOT / "sql", ROOT / "tests"]
    assert [name for name in shown if not any((place / name).is_dir() for place in places)] == []
    modules = re.findall(r"\b(\w+\.py)\b", page)
    assert [name for name in modules if not (ROOT / "gam_db" / name).exists()] == [
        "test_wall.py",
        "page.py",
    ]


def test_what_the_page_on_reliability_names_is_there() -> None:
    rows = (ROOT / "docs" / "reliability.md").read_text(encoding="utf-8").split("\n|")[3:]
    assert len(rows) > 15
    for row in rows:
        named = re.findall(r"`(\w+/test_\w+\.py)::(test_\w+)`", row)
        assert named, row
        for file, test in named:
            text = (ROOT / "tests" / file).read_text(encoding="utf-8")
            assert f"\ndef {test}(" in text, (file, test)
        assert len(row.split("|")) == 6, row


@pytest.mark.parametrize("name", NAMES)
def test_the_readme_claims_no_more_than_the_evidence(name: str) -> None:
    rows = [line for line in README.splitlines() if line.startswith(f"| {EVIDENCE[name].evidence} |")]
    assert len(rows) == 1
    assert engine_named(name).title in rows[0]


def test_trying_it_takes_two_commands() -> None:
    assert [line.partition(" ")[0] for line in tries()[0]] == ["python3", ".venv/bin/python"]
    assert [line.split()[:2] for line in tries()[1]] == [["uv", "run"]] * 2


@pytest.mark.full
@pytest.mark.parametrize("number", [0, 1])
def test_the_two_commands_work_in_a_clean_clone(number: int, tmp_path: Path) -> None:
    """As a newcomer would type them: nothing but Python (or uv) is there, and no recordings."""
    if number == 1 and shutil.which("uv") is None:
        pytest.skip("left out: uv is not installed")
    clone = tmp_path / "gam-db"
    subprocess.run(["git", "clone", "--quiet", str(ROOT), str(clone)], check=True)
    kept = ("VIRTUAL_ENV", "PYTHONPATH", "GAM_TEST_DATA", "GAM_DBT", "PYTEST_XDIST_WORKER")
    environment = {name: value for name, value in os.environ.items() if name not in kept}
    found = [
        subprocess.run(line, shell=True, cwd=clone, env=environment, capture_output=True, text=True)
        for line in tries()[number]
    ]
    for done in found:
        assert done.returncode == 0, (done.stdout + done.stderr)[-3000:]
    assert "verdicts: 1 ready" in found[0].stdout
    assert re.search(r"\d{3,} passed", found[1].stdout)


def tries() -> list[list[str]]:
    """Return the commands of each of the two ways to try it."""
    section = README.partition("## Try it")[2].partition("\n## ")[0]
    return [block.strip().splitlines() for block in re.findall(r"```sh\n(.*?)```", section, re.DOTALL)]
