"""A cast of text to TIMESTAMP drops what it cannot use: a zone, AM and PM.

Expected: an error, or the instant that the text means. Found in 2.0.0: the offset and PM are dropped
without a word, and 03/03/26 is a day of the year 3.
"""

import sys

import duckdb

WORDS = {
    "2026-03-03 10:00:00+05:00": "2026-03-03 05:00:00",
    "2026-03-03 10:00:00 PM": "2026-03-03 22:00:00",
    "03/03/26": "2026-03-03 00:00:00",
}

wrong = {}
for word, meant in WORDS.items():
    try:
        read = duckdb.connect().execute("SELECT CAST(CAST(? AS TIMESTAMP) AS VARCHAR)", [word])
    except duckdb.Error:
        continue
    if (found := read.fetchall()) != [(meant,)]:
        wrong[word] = found
print(f"DuckDB {duckdb.__version__}: expected {WORDS} or errors; found {wrong}")
sys.exit(bool(wrong))
