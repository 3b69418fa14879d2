"""A CASE that gives a joined column bare ends a query, and the database in memory.

Where a table is joined to one that is some thousand times smaller, the columns of the small one go on as
indices into one dictionary. The CASE gives the dictionary for vectors of rows that all take that branch,
and plain values for others; the filter above keeps few rows.

Expected: the sum. Found in 2.0.0: INTERNAL Error, "dict-surviving cache: global dictionary column 2
changed identity". After a LEFT JOIN the sum is right.
"""

import sys

import duckdb

connection = duckdb.connect()
connection.execute("CREATE TABLE big AS SELECT x, x % 100 AS k FROM range(1000000) AS r(x)")
connection.execute("CREATE TABLE small AS SELECT k, k AS v FROM range(100) AS r(k)")
QUERY = """
    SELECT SUM(c)
    FROM (SELECT x, CASE WHEN x % 20000 < 10000 THEN v END AS c FROM big {join} small USING (k))
    WHERE HASH(x) % 97 = 1
"""
expected = connection.execute(QUERY.format(join="LEFT JOIN")).fetchone()
try:
    found: object = connection.execute(QUERY.format(join="JOIN")).fetchone()
except duckdb.Error as error:
    found = str(error).partition("\n")[0]
print(f"DuckDB {duckdb.__version__}: expected {expected}, found {found}")
sys.exit(found != expected)
