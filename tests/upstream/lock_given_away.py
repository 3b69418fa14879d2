"""The lock on a file is gone when its process closes any other handle of that file.

POSIX locks (fcntl) belong to a process, not to a handle; those of an open file description do not go so
(F_OFD_SETLK).

Expected: another process cannot open the file while this one has it open for writing. Found in 2.0.0: it
can, once this process has read the file by a handle of its own (a copy, a checksum).
"""

import pathlib
import subprocess
import sys
import tempfile

import duckdb

scratch = tempfile.TemporaryDirectory()
path = pathlib.Path(scratch.name) / "a.duckdb"
connection = duckdb.connect(path)
connection.execute("CREATE TABLE a AS SELECT 1 AS b")
connection.execute("CHECKPOINT")
OTHER = f"import duckdb; duckdb.connect({str(path)!r})"


def is_locked() -> bool:
    """Tell whether another process cannot open the file."""
    return subprocess.run([sys.executable, "-c", OTHER], stderr=subprocess.DEVNULL).returncode != 0


before = is_locked()
path.read_bytes()
after = is_locked()
print(f"DuckDB {duckdb.__version__}: expected locked True, True; found {before}, {after}")
sys.exit(not (before and after))
