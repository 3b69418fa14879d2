"""A parameter of a table macro in HAVING is a column that is not grouped by.

The body is bound when the macro is made, where the parameter is a column. A constant is right there.

Expected: the macro is made, and gives 3 and 7. Found in 2.0.0: Binder Error, 'column "p" must appear in
the GROUP BY clause or be used in an aggregate function'; without HAVING it is made.
"""

import sys

import duckdb

connection = duckdb.connect()
connection.execute("CREATE TABLE a AS SELECT range AS b FROM range(3)")
expected = (3, 7)
try:
    connection.execute("CREATE MACRO m(p) AS TABLE SELECT SUM(b), p FROM a HAVING p > 1")
    found: object = connection.execute("FROM m(7)").fetchone()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
