"""A filter on NaN is optimised away on a Parquet file whose statistics leave NaN out.

The statistics of a column of doubles say nothing of NaN (PARQUET-1222); writers such as PyArrow leave it
out of minimum and maximum. DuckDB takes them for bounds of all values.

Expected: one row is NaN. Found in 2.0.0: none is, unless the file is read with can_have_nan = true.
"""

import pathlib
import sys
import tempfile

import duckdb
import pyarrow
from pyarrow import parquet

scratch = tempfile.TemporaryDirectory()
path = str(pathlib.Path(scratch.name) / "a.parquet")
parquet.write_table(pyarrow.table({"a": [1.0, float("nan"), 3.0]}), path)
expected = (1,)
found = duckdb.connect().execute(f"SELECT COUNT(*) FROM '{path}' WHERE isnan(a)").fetchone()
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
