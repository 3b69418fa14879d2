"""Parquet files whose types differ are cast to the type of the first one.

Expected: both values, by a type that holds them, with union_by_name as well as without. Found in 2.0.0:
without it 1.5 becomes 2 (the first file holds integers).
"""

import pathlib
import sys
import tempfile

import duckdb

scratch = tempfile.TemporaryDirectory()
folder = pathlib.Path(scratch.name)
connection = duckdb.connect()
connection.execute(f"COPY (SELECT CAST(1 AS BIGINT) AS a) TO '{folder}/a.parquet'")
connection.execute(f"COPY (SELECT CAST(1.5 AS DOUBLE) AS a) TO '{folder}/b.parquet'")
expected = [(1.0,), (1.5,)]
try:
    found: object = connection.execute(f"SELECT a FROM '{folder}/*.parquet' ORDER BY a").fetchall()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
