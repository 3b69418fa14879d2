"""Parquet files of several types on Spark: column, types and files are said, whatever the names are."""

import datetime as dt
import itertools
from pathlib import Path

import pyarrow as pa
import pytest
from pyarrow import parquet

import engines
import gam_db
from gam_db import Source
from gam_db.errors import SourceError

TIMES = pa.array([dt.datetime(2026, 3, 1, 0, minute) for minute in range(10)], pa.timestamp("us"))
NUMBERS = pa.array([float(number) for number in range(10)])


@pytest.mark.parametrize(
    ("column", "values", "types"),
    [
        ("value", pa.array(range(10)), {"double", "bigint"}),
        ("value", NUMBERS.cast(pa.decimal128(10, 1)), {"double", "decimal(10,1)"}),
        ("value", NUMBERS.cast(pa.float32()), {"double", "float"}),
        ("value", NUMBERS.cast(pa.string()), {"double", "string"}),
        ("ts", TIMES.cast(pa.timestamp("us", "UTC")), {"timestamp_ntz", "timestamp"}),
        ("ts", TIMES.cast(pa.date32(), safe=False), {"timestamp_ntz", "date"}),
    ],
)
def test_types_that_differ_are_named_with_their_files(
    column: str, values: pa.Array, types: set[str], tmp_path: Path
) -> None:
    usual = {"ts": TIMES, "value": NUMBERS}
    for number, names in enumerate(itertools.permutations(("a", "b"))):
        folder = tmp_path / f"{number}.parquet"
        folder.mkdir()
        for name, made in zip(names, (usual, usual | {column: values}), strict=True):
            parquet.write_table(pa.table(made), folder / f"{name}.parquet")
        with pytest.raises(SourceError, match=f"column '{column}' is of type ") as caught:
            gam_db.support(Source(str(folder), None, None, "ts"), engine=engines.session("spark"))
        said = str(caught.value)
        assert "a.parquet" in said
        assert "b.parquet" in said
        assert all(f" {of} in " in said for of in types)
        assert "Run it again" not in said


def test_files_of_one_type_are_read(tmp_path: Path) -> None:
    folder = tmp_path / "same.parquet"
    folder.mkdir()
    for name in "ab":
        parquet.write_table(pa.table({"ts": TIMES, "value": NUMBERS}), folder / f"{name}.parquet")
    small = gam_db.Parameters(m=1, tau=1, bins=2, window=1)
    (found,) = gam_db.support(
        Source(str(folder), None, None, "ts"), small, engine=engines.session("spark")
    ).to_pylist()
    assert found["samples"] == 10
