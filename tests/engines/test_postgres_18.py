"""PostgreSQL 18, beside the age that the system has: the same tests, in a process of their own."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

import postgres_server
from gam_db.engines import EVIDENCE

ROOT = Path(__file__).parents[2]

#: Rooms of the tests that open a server.
ROOMS = (
    *("alarms", "checking", "cli", "engines", "export"),
    *("method", "reading", "report", "stored", "study"),
)


def on_18(*words: str) -> subprocess.CompletedProcess[str]:
    """Run Python on PostgreSQL 18."""
    around = {**os.environ, postgres_server.AGE: "18", "PYTHONPATH": str(ROOT / "tests" / "tools")}
    return subprocess.run([sys.executable, *words], cwd=ROOT, env=around, capture_output=True, text=True)


def passes(*words: str) -> None:
    """Run tests of PostgreSQL; what they say is shown where one fails, or where there are none."""
    told = on_18(
        "-m", "pytest", "-p", "no:xdist", "-q", "--engines", "postgres", *words, "-o", "addopts="
    )
    assert told.returncode == 0, told.stdout[-5000:]


def test_it_is_the_version_of_the_table() -> None:
    told = on_18("-c", "import postgres_server; print(postgres_server.version())")
    assert told.stdout.startswith("18."), told.stderr
    assert EVIDENCE["postgres"].also.split(".")[0] == "18"


def test_a_history() -> None:
    """What gam score leaves and what the printed script leaves is the same."""
    passes("tests/export/test_run_sql.py", "-k", "a_history_leaves_what_gam_score_leaves")


@pytest.mark.full
@pytest.mark.parametrize("room", ROOMS)
def test_the_full_set(room: str) -> None:
    file = Path(__file__).relative_to(ROOT)
    passes(f"tests/{room}", "-k", "postgres", f"--ignore={file}")
