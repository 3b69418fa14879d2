"""The oldest and the newest DuckDB that are allowed: the same tests, in a process of their own."""

import os

import pytest

import duckdbs
from gam_db.engines import EVIDENCE, engine_named

ROOMS = (
    "alarms",
    "bad_input",
    "checking",
    "engines",
    "method",
    "reading",
    "selection",
    "stored",
    "study",
)


def test_they_are_what_is_allowed() -> None:
    """The oldest is the one that is said to be, and the newest is not older than that of the table."""
    if not duckdbs.FOLDERS:
        pytest.skip("left out: GAM_DUCKDBS names no folders of other DuckDBs")
    oldest, newest = map(duckdbs.version, duckdbs.FOLDERS)
    assert oldest.startswith(f"{engine_named('duckdb').oldest}.")
    parts = [tuple(map(int, one.split(".")[:3])) for one in (EVIDENCE["duckdb"].also.split()[0], newest)]
    assert parts[0] <= parts[1]


@pytest.mark.full
@pytest.mark.parametrize("age", [0, 1], ids=["oldest", "newest"])
@pytest.mark.parametrize("room", ROOMS)
def test_the_full_set(room: str, age: int) -> None:
    if not duckdbs.FOLDERS:
        pytest.skip("left out: GAM_DUCKDBS names no folders of other DuckDBs")
    file = os.path.relpath(__file__, duckdbs.ROOT)
    words = ("-m", "pytest", "-p", "no:xdist", "-q", "-o", "addopts=", "--engines", "duckdb")
    told = duckdbs.run(duckdbs.FOLDERS[age], *words, f"tests/{room}", f"--ignore={file}")
    assert told.returncode == 0, told.stdout[-5000:]
