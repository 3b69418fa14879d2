"""Nothing loads pandas, which Arrow would do to look at a list: neither a run nor a command."""

import subprocess
import sys
from pathlib import Path

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq
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


@pytest.mark.parametrize(
    "words", [["check"], ["run"], ["select"], ["init", "--force"], ["export", "grafana", "out"]]
)
def test_nor_does_a_command(words: list[str], tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    pq.write_table(
        pa.table({"time": range(900), "value": [i % 7 + i / 900 for i in range(900)]}),
        tmp_path / "x.parquet",
    )
    said = words if words[0] == "export" else [*words, "x.parquet"]
    asked = f"""
import sys
from gam_db.cli import main
sys.argv = ["gam", *{said!r}]
try:
    main()
finally:
    print("pandas.core" in sys.modules, file=sys.stderr)
"""
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode in (0, 2), done.stderr
    assert done.stderr.split()[-1] == "False"


def test_who_wants_pandas_gets_it() -> None:
    pytest.importorskip("pandas")
    asked = """
from gam_db import extras
extras.begin_process()
try:
    import pandas
except ImportError:
    print("left")
extras.needed("sklearn", "sklearn")
import pandas
print("given")
"""
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["left", "given"]
