"""BEGIN inside a transaction fails, and takes what the transaction had done with it.

Expected: an error or a warning, and the transaction as it was (PostgreSQL warns). Found in 2.0.0: the
transaction is aborted.
"""

import contextlib
import sys

import duckdb

connection = duckdb.connect()
connection.execute("CREATE TABLE a (b INTEGER)")
connection.execute("BEGIN")
connection.execute("INSERT INTO a VALUES (1)")
with contextlib.suppress(duckdb.Error):
    connection.execute("BEGIN")
expected: object = [(1,)]
try:
    connection.execute("COMMIT")
    found: object = connection.execute("SELECT b FROM a").fetchall()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
