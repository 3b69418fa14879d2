"""Nothing loads pandas, which Arrow would do to look at a list: neither a run nor a command."""

import subprocess
import sys
from pathlib import Path

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

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


def test_neither_calibration_nor_a_run_loads_pandas() -> None:
    """It takes as long as scoring a million rows."""
    pytest.importorskip("pandas")
    asked = """
import sys
import duckdb
import gam_db
before = "pandas" in sys.modules
with duckdb.connect() as connection:
    connection.execute(
        "CREATE TABLE plant AS SELECT CAST(channel AS TEXT) AS channel, time, "
        "sin(time * channel) AS value FROM range(1, 7) AS named (channel), range(3000) AS tick (time)"
    )
    source, parameters = gam_db.Source("plant", asset=None), gam_db.Parameters(m=1, bins=4, window=10)
    monitor = gam_db.Monitor(connection, source, parameters, gam_db.Calibration(fraction=0.5))
    monitor.migrate()
    monitor.calibrate()
    run = monitor.score()
    loaded = "pandas" in sys.modules
    print(before, len(run.channels), loaded, *{*monitor.limits()["height"].to_pylist()} - {None})
"""
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    words = done.stdout.split()
    assert words[:3] == ["False", "6", "False"]
    assert words[3:], "no limit was found by replaying, which is what reads most tables of ours"


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
