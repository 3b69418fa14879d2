"""The documentation is tested: what it shows is there, and does what it says."""

import re
from pathlib import Path

import pytest

from gam_db import config
from gam_db.engines import NAMES, engine_named
from gam_db.engines.evidence import evidence

ROOT = Path(__file__).parents[2]
README = (ROOT / "README.md").read_text(encoding="utf-8")


def test_every_link_of_the_readme_leads_somewhere() -> None:
    links = re.findall(r"\]\(([^)#:]+)\)", README)
    assert links
    assert [link for link in links if not (ROOT / link).exists()] == []


def test_ci_runs_the_tests_as_the_readme_says() -> None:
    command = re.search(r"^python -m pytest --engines all$", README, re.MULTILINE)
    assert command
    assert command[0] in (ROOT / ".ci" / "run").read_text(encoding="utf-8").splitlines()


def test_the_documented_settings_file_is_read(tmp_path: Path) -> None:
    parameters, calibration = config.load(ROOT / "docs" / "gam.toml").method()
    assert parameters.max_gap == "5 s"
    assert [override.changes() for override in parameters.overrides] == [{"tau": 10, "bins": 20}]
    assert calibration.overrides["robot_8"] is None
    text = (ROOT / "docs" / "gam.toml").read_text(encoding="utf-8")
    for line in text.splitlines()[2:]:
        assert line.strip() in (config.__doc__ or ""), "the docstring of config shows the same file"


@pytest.mark.parametrize("name", NAMES)
def test_the_readme_claims_no_more_than_the_evidence(name: str) -> None:
    rows = [line for line in README.splitlines() if line.startswith(f"| {evidence()[name].evidence} |")]
    assert len(rows) == 1
    assert engine_named(name).title in rows[0]
