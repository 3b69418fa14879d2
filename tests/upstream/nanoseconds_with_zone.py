"""A TIMESTAMPTZ_NS compares with no other type of time.

Expected: true, as for TIMESTAMP_NS and TIMESTAMP. Found in 2.0.0: Binder Error, "Cannot compare values
of type TIMESTAMPTZ_NS and type TIMESTAMP WITH TIME ZONE".
"""

import sys

import duckdb

QUERY = """
    SELECT CAST('2026-01-01 00:00:00+00' AS TIMESTAMPTZ_NS)
        < CAST('2026-01-02 00:00:00+00' AS TIMESTAMPTZ)
"""
expected = (True,)
try:
    found: object = duckdb.connect().execute(QUERY).fetchone()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
