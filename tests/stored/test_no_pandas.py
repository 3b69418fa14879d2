"""A run makes its small tables without pandas, which Arrow would load to look at a list."""

import subprocess
import sys
from pathlib import Path

import duckdb
import pyarrow as pa
import pytest
from hypothesis import given
from hypothesis import strategies as st

import small_plant
from gam_db.columns import COUNT, SHARE, WORD, columns, table_of

SCHEMA = columns((COUNT, "count"), (SHARE, "share"), (WORD, "word"))
ROWS = st.lists(
    st.fixed_dictionaries(
        {},
        optional={
            "count": st.none() | st.integers(-(2**63), 2**63 - 1),
            "share": st.none() | st.floats(allow_nan=False),
            "word": st.none() | st.text(st.characters(codec="utf-8"), max_size=5),
            "other": st.integers(),
        },
    ),
    max_size=20,
)


@given(ROWS)
def test_a_table_of_rows_is_the_one_that_arrow_makes(rows: list[dict[str, object]]) -> None:
    made = table_of(rows, SCHEMA)
    made.validate(full=True)
    assert made.equals(pa.Table.from_pylist(rows, schema=SCHEMA))


def test_a_run_loads_no_pandas(tmp_path: Path) -> None:
    """It takes as long as scoring a million rows."""
    pytest.importorskip("pandas")
    path = tmp_path / "plant.duckdb"
    with duckdb.connect(str(path)) as connection:
        small_plant.begin(connection)
    asked = f"""
import sys
sys.path[:] = {sys.path!r}
import duckdb
import small_plant
before = "pandas" in sys.modules
with duckdb.connect({str(path)!r}) as connection:
    run = small_plant.monitor(connection).score()
print(before, len(run.channels), "pandas" in sys.modules)
"""
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "4", "False"]
