"""A word that means a missing value takes the header of a CSV file away where it stands there, too.

Expected: the columns are time and bad; one of two values is missing. Found in 2.0.0: time and
column1.
"""

import pathlib
import sys
import tempfile

import duckdb

scratch = tempfile.TemporaryDirectory()
path = pathlib.Path(scratch.name) / "a.csv"
path.write_text("time,bad\n1,2.5\n2,bad\n", encoding="utf-8")
expected = ["time", "bad"]
read = duckdb.connect().execute(f"SELECT * FROM read_csv('{path}', nullstr = 'bad')")
found = [name for name, *_ in read.description]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}, {read.fetchall()}")
sys.exit(found != expected)
