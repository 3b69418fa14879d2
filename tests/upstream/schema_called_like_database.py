"""A table of the default schema cannot be named by its database where a schema has the name, too.

Expected: plant.t is the only table that it can be, plant.main.t; there is no plant.plant.t. Found in
2.0.0: Binder Error, "Ambiguous reference to catalog or schema".
"""

import pathlib
import sys
import tempfile

import duckdb

scratch = tempfile.TemporaryDirectory()
connection = duckdb.connect(pathlib.Path(scratch.name) / "plant.duckdb")
connection.execute("CREATE TABLE t AS SELECT 1 AS a")
connection.execute("CREATE SCHEMA plant")
expected = (1,)
try:
    found: object = connection.execute("SELECT a FROM plant.t").fetchone()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
