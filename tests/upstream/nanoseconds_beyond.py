"""A TIMESTAMP_NS cannot be compared with an instant that nanoseconds do not reach.

Expected: true; the year 3000 is later than all that the column can hold. Found in 2.0.0: Conversion
Error, "Could not convert Timestamp to higher precision".
"""

import sys

import duckdb

QUERY = "SELECT CAST('2026-01-01' AS TIMESTAMP_NS) < CAST('3000-01-01' AS TIMESTAMP)"
expected = (True,)
try:
    found: object = duckdb.connect().execute(QUERY).fetchone()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
