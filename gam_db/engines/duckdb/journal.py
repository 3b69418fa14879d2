"""A journal of the blocks that a checkpoint of DuckDB overwrites, until the checkpoint is complete.

A checkpoint writes new blocks, and in the end a header that names them. But its lists of contents lie 64
to a block, and new ones fill the gaps between those that the header before names: these blocks are
written over in place. A process that is killed in the middle of that leaves a block that no header can
read. So they are kept first, in ``plant.duckdb.journal``, and who opens the file next puts them back,
unless the new header is there. The log (``plant.duckdb.wal``) has what was committed until then.
"""

import contextlib
import io
import os
import shutil
import zipfile
from pathlib import Path

import duckdb

from gam_db import data

try:
    import fcntl
except ImportError:  # Windows: there is no journal, and a file may be damaged as by DuckDB alone
    fcntl = None  # type: ignore[assignment]

_QUERIES = data.table("gam_db.engines.duckdb", "duckdb.toml")["queries"]

#: Bytes before the first block: what the file is, and two headers, of which the newer one counts.
HEADERS = 3 * 4096

#: Journals of this process at work, which are not left over: its own locks do not keep it out.
_AT_WORK: set[Path] = set()

#: Files that other connections of this process still have open. Closing one would give their lock away,
#: as POSIX locks belong to a process.
_STILL_OPEN: list[io.FileIO] = []


class Journal:
    """Checkpoints of a database file that a killed process cannot leave half done.

    The connection has the file open, by default as its current database.
    """

    def __init__(self, connection: duckdb.DuckDBPyConnection, database: str | None = None) -> None:
        self._connection = connection
        ((self._database, path, self._block_size),) = connection.execute(
            _QUERIES["database"], [database]
        ).fetchall()
        self._log = Path(f"{path}.wal")
        self._path = Path(path).resolve()
        self._journal = journal_of(self._path)
        self._file: io.FileIO | None = None

    def keep(self) -> None:
        """Keep what the next checkpoint writes over.

        Raises:
            OSError: there is no room for it.
        """
        if fcntl is None:
            return
        blocks = self._connection.execute(_QUERIES["blocks"], [self._database]).fetchall()
        if self._file is None:
            self._file = self._path.open("rb", buffering=0)
        of_file, size = self._file.fileno(), self._block_size
        places = {0: HEADERS, **{HEADERS + block * size: size for (block,) in blocks}}
        unfinished = self._journal.with_name(f"{self._journal.name}.new")
        with unfinished.open("wb") as file:
            shutil.copymode(self._path, unfinished)
            with zipfile.ZipFile(file, "w") as archive:
                for place, length in places.items():
                    archive.writestr(str(place), os.pread(of_file, length, place))
            file.flush()
            os.fsync(file.fileno())
        _AT_WORK.add(self._journal)
        unfinished.replace(self._journal)
        folder = os.open(self._journal.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)

    def checkpoint(self, above: int = 0) -> None:
        """Write the log into the file, if it is larger than so many bytes.

        Raises:
            OSError: there is no room for the journal.
            duckdb.Error: DuckDB cannot do it now.
        """
        if self._log.exists() and self._log.stat().st_size > above:
            self.keep()
            self._connection.execute("FROM checkpoint(?)", [self._database]).fetchall()
            self.done()

    def done(self) -> None:
        """Remove the journal: the file is whole."""
        self._journal.unlink(missing_ok=True)
        _AT_WORK.discard(self._journal)

    def close(self, still_open: bool = False) -> None:
        """Let go of the file, after DuckDB has; not if other connections of the process have it open."""
        if self._file is not None and still_open:
            _STILL_OPEN.append(self._file)
        elif self._file is not None:
            self._file.close()
            _AT_WORK.discard(self._journal)
            put_back(self._path)
        self._file = None


def journal_of(path: Path) -> Path:
    """Return the path of the journal of a database file."""
    return path.with_name(f"{path.name}.journal")


def put_back(path: Path) -> None:
    """Undo what a killed process left half done in a database file that may be written.

    A checkpoint that has come as far as its header was whole; then the journal only goes. A file that a
    process has open is left to it.
    """
    path = path.resolve()
    journal = journal_of(path)
    if fcntl is None or journal in _AT_WORK or not journal.exists():
        return
    with contextlib.suppress(OSError, zipfile.BadZipFile), path.open("r+b") as file:
        fcntl.lockf(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        with zipfile.ZipFile(journal) as archive:
            parts = {int(name): archive.read(name) for name in archive.namelist()}
        if file.read(HEADERS) == parts.pop(0):
            for place, part in parts.items():
                file.seek(place)
                file.write(part)
            file.flush()
            os.fsync(file.fileno())
        journal.unlink()
