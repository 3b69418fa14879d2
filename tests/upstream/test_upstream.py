"""Defects of DuckDB that docs/quirks.md works around: each reproducer says which version has it."""

import tomllib
from pathlib import Path

import pytest

import duckdbs
from gam_db.engines import engine_named

HERE = Path(__file__).parent
SCRIPTS = sorted(path.stem for path in HERE.glob("*.py") if path != Path(__file__))
MENDED = tomllib.loads((HERE / "mended.toml").read_text(encoding="utf-8"))


def parts(version: str) -> list[int]:
    return [int(part) for part in version.split(".")[:3]]


@pytest.mark.parametrize("script", SCRIPTS)
@pytest.mark.parametrize("folder", ["", *duckdbs.FOLDERS], ids=lambda folder: Path(folder).name)
def test_a_version_has_the_defect_until_it_is_mended(script: str, folder: str) -> None:
    """A reproducer ends with 1 where the defect is there, with 0 where it is not."""
    done = duckdbs.run(folder, str(HERE / f"{script}.py"))
    version = duckdbs.version(folder)
    assert f"DuckDB {version}: expected " in done.stdout, done.stderr
    has_it = script not in MENDED or parts(version) < parts(MENDED[script])
    assert done.returncode == has_it, f"write into mended.toml what is new: {done.stdout}"


@pytest.mark.parametrize("script", SCRIPTS)
def test_no_workaround_is_left_of_what_every_allowed_version_has_mended(script: str) -> None:
    oldest = engine_named("duckdb").oldest or ""
    is_needed = script not in MENDED or parts(f"{oldest}.0") < parts(MENDED[script])
    assert is_needed, "take the reproducer away, and the workaround of docs/quirks.md"


def test_each_reproducer_stands_in_the_page() -> None:
    page = (HERE.parents[1] / "docs" / "quirks.md").read_text(encoding="utf-8")
    assert [script for script in SCRIPTS if f"`{script}.py`" not in page] == []
    assert MENDED.keys() <= {*SCRIPTS}
