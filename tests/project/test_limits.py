"""What docs/limits.md says that it measured is what is measured."""

from pathlib import Path

import pytest

import limits_page

PAGE = Path(__file__).parents[2] / "docs" / "limits.md"


@pytest.mark.thorough
def test_the_table_is_what_is_measured() -> None:
    table = limits_page.measured()
    assert table.count("| **yes** |") == 5
    assert f"|---|---|---|---|---|\n{table}\n" in PAGE.read_text(encoding="utf-8"), (
        "python tests/tools/limits_page.py"
    )
