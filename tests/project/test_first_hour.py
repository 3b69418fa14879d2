"""A newcomer's first hour: its cheap part, and all of it from a clone, in processes of its own."""

import os
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

import first_hour

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "docs" / "first-hour.md").read_text(encoding="utf-8")


def test_a_german_csv_file_is_read_as_the_page_says() -> None:
    """The cheap part of the walk."""
    with first_hour.place() as folder:
        parts = list(first_hour.walked(first_hour.in_this_process, folder, first_hour.STEPS[1:4]))
    assert len(parts) == 3
    for part in parts:
        assert part in PAGE, "python tests/tools/first_hour.py > docs/first-hour.md"


@pytest.mark.full
def test_the_first_hour_from_a_clone(tmp_path: Path) -> None:
    """GAM_WALK_PYTHON names the Python of an environment with gam-db; else one is made of a clone."""
    python, environment = os.environ.get("GAM_WALK_PYTHON"), {**os.environ, "COLUMNS": "100"}
    if not python:
        clone, made = tmp_path / "gam-db", tmp_path / "venv"
        python = str(made / "bin" / "python")
        for command in (
            ["git", "clone", "-q", str(ROOT), str(clone)],
            [sys.executable, "-m", "venv", str(made)],
            [python, "-m", "pip", "install", "-q", "-e", str(clone), "pandas"],
        ):
            subprocess.run(command, check=True)
        environment.pop("PYTHONPATH", None)

    def run(typed: str) -> tuple[str, int]:
        words = ["-c", typed]
        if "\n" not in typed:
            words = ["-c", "from gam_db.cli import main; main()", *shlex.split(typed)[1:]]
        done = subprocess.run(
            [python, *words],
            capture_output=True,
            encoding="utf-8",
            cwd=folder,
            env=environment,
            check=False,
        )
        return done.stdout or done.stderr, done.returncode  # a long run says on stderr how it goes

    with tempfile.TemporaryDirectory() as named:  # as long as that of the page: lines are folded
        folder = Path(named)
        first_hour.prepare(folder)
        assert first_hour.page(first_hour.walked(run, folder)) == PAGE
