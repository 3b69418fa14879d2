"""EPOCH_US of a TIMESTAMP_NS rounds, where EPOCH_MS of a TIMESTAMP floors.

Expected: the microsecond in which the instant lies, 0 of 999 ns, as date_trunc('microseconds') gives it.
Found in 2.0.0: the nearest one, 1.
"""

import sys

import duckdb

QUERY = "SELECT EPOCH_US(CAST('1970-01-01 00:00:00.000000999' AS TIMESTAMP_NS))"
expected = (0,)
found = duckdb.connect().execute(QUERY).fetchone()
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
