"""A checkpoint writes over blocks that the header before still needs.

A process that is killed between these blocks and the new header leaves a file that cannot be opened.
Here the blocks that the checkpoint changed lie in the file only in part, as a kill leaves them: the
first pages of one are new, the headers and all else are those before the checkpoint, the log is whole.

Expected: the file opens at every such moment, by its old header and its log. Found in 2.0.0: "Corrupt
database file: computed checksum ... does not match stored checksum".
"""

import pathlib
import sys
import tempfile

import duckdb

HEADERS, BLOCK = 3 * 4096, 2**18

scratch = tempfile.TemporaryDirectory()
folder = pathlib.Path(scratch.name)
path, log = folder / "a.duckdb", folder / "a.duckdb.wal"
with duckdb.connect(path) as connection:
    connection.execute("CREATE TABLE readings AS SELECT range AS n FROM range(1000)")
    for number in range(8):
        connection.execute(f"CREATE TABLE other_{number} AS SELECT range AS n FROM range(9)")
        connection.execute("CHECKPOINT")
connection = duckdb.connect(path)
connection.execute("SET checkpoint_threshold = '1TB'")
connection.execute("INSERT INTO readings SELECT range FROM range(1000)")
before, kept = path.read_bytes(), log.read_bytes()
connection.execute("CHECKPOINT")
after = path.read_bytes()
connection.close()

expected = (2000,)
found: list[object] = []
old = before.ljust(len(after), b"\0")
for start in range(HEADERS, len(after), BLOCK):
    if old[start : start + BLOCK] == after[start : start + BLOCK]:
        continue
    for end in range(start + 4096, min(start + BLOCK, len(after)), 4096):
        if old[end - 4096 : end] == after[end - 4096 : end]:
            continue
        path.write_bytes(old[:start] + after[start:end] + old[end:])
        log.write_bytes(kept)
        try:
            with duckdb.connect(path) as again:
                found.append(again.execute("SELECT COUNT(*) FROM readings").fetchone())
        except duckdb.Error as error:
            found.append(str(error)[:120])
wrong = [one for one in found if one != expected]
print(f"DuckDB {duckdb.__version__}: expected {expected} at {len(found)} moments, found {wrong[:1]}")
sys.exit(bool(wrong) or not found)
