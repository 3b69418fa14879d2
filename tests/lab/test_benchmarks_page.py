"""docs/benchmarks.md shows what its commands print."""

from pathlib import Path

import pytest

import benchmarks_page
from benchmarks_page import RECORDINGS

PAGE = Path(__file__).parents[2] / "docs" / "benchmarks.md"


@pytest.mark.thorough
@pytest.mark.parametrize(
    "name",
    [name if name == "cobot" else pytest.param(name, marks=pytest.mark.full) for name in RECORDINGS],
)
def test_a_table_is_what_its_commands_print(name: str, recordings: Path) -> None:
    recording = RECORDINGS[name]
    shown = PAGE.read_text(encoding="utf-8").partition(f"## {recording.title}\n\n")[2]
    assert shown.partition("\n\n")[0].splitlines() == benchmarks_page.table(
        recording, recordings.resolve()
    ), f"GAM_TEST_DATA=FOLDER python tests/tools/benchmarks_page.py {name}"
