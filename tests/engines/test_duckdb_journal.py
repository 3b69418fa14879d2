"""A DuckDB file at every moment of a checkpoint: whoever opens it next finds all that was committed.

A killed process leaves a block half written. That is put together here from what lay in the file before
and after a checkpoint; ``tests/stored/test_kills.py`` kills real processes.
"""

import resource
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import duckdb
import pytest
from sqlglot import exp

from gam_db.engines.duckdb import driver as duckdb_driver
from gam_db.engines.duckdb.journal import HEADERS, Journal, journal_of, put_back
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import EngineError, FullError
from nobody import as_nobody

PAGE = 4096

#: Tables of the file, so that its lists of contents take some pages.
TABLES = 8

ROWS = "SELECT COUNT(*), SUM(twice - 2 * number) FROM readings"
MORE = "INSERT INTO readings SELECT range, 2 * range FROM range(1000)"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A file with a thousand rows and several lists of contents."""
    made = tmp_path / "plant.duckdb"
    with duckdb.connect(made) as connection:
        connection.execute(
            "CREATE TABLE readings AS SELECT range AS number, 2 * range AS twice FROM range(1000)"
        )
        for number in range(TABLES):
            connection.execute(f"CREATE TABLE other_{number} AS SELECT range AS n FROM range(9)")
            connection.execute("CHECKPOINT")
    return made


def log_of(path: Path) -> Path:
    return path.with_name(f"{path.name}.wal")


@dataclass
class Checkpoint:
    """What lay in a file and beside it, before a checkpoint and after it."""

    file: bytes
    log: bytes
    journal: bytes
    after: bytes

    def moments(self) -> Iterator[bytes]:
        """Yield the file as it is while blocks are written over, page by page, under the old headers."""
        parts = [HEADERS, *range(HEADERS + 2**18, len(self.after), 2**18)]
        before = self.file.ljust(len(self.after), b"\0")
        for start in parts:
            for end in range(start + PAGE, min(start + 2**18, len(self.after)), PAGE):
                if before[end - PAGE : end] != self.after[end - PAGE : end]:
                    yield before[:start] + self.after[start:end] + before[end:]

    def left(self, path: Path, file: bytes, journal: bool = True) -> None:
        """Put all in its place as a killed process leaves it."""
        path.write_bytes(file)
        log_of(path).write_bytes(self.log)
        journal_of(path).unlink(missing_ok=True)
        if journal:
            journal_of(path).write_bytes(self.journal)


def watched(monkeypatch: pytest.MonkeyPatch, path: Path, write: Callable[[], object]) -> Checkpoint:
    """Return what one checkpoint of a file does, while something is written."""
    seen: list[bytes] = []
    checkpoint, done = Journal.checkpoint, Journal.done

    def before(journal: Journal, above: int = 0) -> None:
        seen[:] = [path.read_bytes(), log_of(path).read_bytes()]
        checkpoint(journal, above)

    def after(journal: Journal) -> None:
        seen.extend((journal_of(path).read_bytes(), path.read_bytes()))
        done(journal)

    with monkeypatch.context() as patch:
        patch.setattr(Journal, "checkpoint", before)
        patch.setattr(Journal, "done", after)
        write()
    return Checkpoint(*seen)


def by_closing(path: Path) -> None:
    with DuckSession(path, writable=True) as session:
        session.connection.execute(MORE)


def by_attaching(path: Path) -> None:
    target = exp.to_table("readings", dialect="duckdb")
    with DuckSession() as session, session.attached(path) as catalog:
        target.set("db", exp.to_identifier("main"))
        target.set("catalog", catalog)
        session.connection.execute(MORE.replace("readings", target.sql("duckdb")))


def counted(path: Path, writable: bool = False) -> tuple[int, int]:
    with DuckSession(path, writable=writable) as session:
        return session.connection.execute(ROWS).fetchall()[0]


@pytest.mark.parametrize("write", [by_closing, by_attaching])
def test_a_half_written_checkpoint_is_undone(
    path: Path, monkeypatch: pytest.MonkeyPatch, write: Callable[[Path], None]
) -> None:
    course = watched(monkeypatch, path, lambda: write(path))
    assert counted(path) == (2000, 0)
    damaged = 0
    for moment in course.moments():
        course.left(path, moment, journal=False)
        try:
            counted(path)
        except EngineError as error:
            assert "is damaged" in str(error)  # noqa: PT017
            damaged += 1
        for writable in (False, True):
            course.left(path, moment)
            assert counted(path, writable) == (2000, 0)
            assert not journal_of(path).exists()
        with duckdb.connect(path) as connection:  # the log has gone into the file
            assert connection.execute(ROWS).fetchall() == [(2000, 0)]
    assert damaged > 1, "without its journal such a file cannot be opened"


def test_a_checkpoint_that_has_its_header_is_kept(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    course = watched(monkeypatch, path, lambda: by_closing(path))
    course.left(path, course.after)
    log_of(path).unlink()
    with duckdb.connect(path) as connection:  # by another program
        connection.execute("DELETE FROM readings WHERE number > 9")
    assert counted(path) == (20, 0)
    assert not journal_of(path).exists()


def test_a_journal_that_is_not_whole_is_none(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    course = watched(monkeypatch, path, lambda: by_closing(path))
    course.left(path, course.file)
    whole = journal_of(path)
    whole.rename(whole.with_name(f"{whole.name}.new"))  # killed while it was written
    assert counted(path) == (2000, 0)
    whole.write_bytes(course.journal[:-100])  # cut by somebody else
    assert counted(path, writable=True) == (2000, 0)


def test_who_may_only_read_is_told(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    course = watched(monkeypatch, path, lambda: by_closing(path))
    with tempfile.TemporaryDirectory() as folder:
        torn = Path(folder) / path.name
        course.left(torn, next(course.moments()))
        torn.chmod(0o444)
        Path(folder).chmod(0o755)
        with as_nobody(), pytest.raises(EngineError, match="half written by a process that was killed"):
            DuckSession(torn)
        assert counted(torn) == (2000, 0)


def test_a_log_beside_a_file_is_read_by_everybody(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    course = watched(monkeypatch, path, lambda: by_closing(path))
    course.left(path, course.file, journal=False)
    assert counted(path) == (2000, 0)
    with duckdb.connect(path, read_only=True) as connection:
        assert connection.execute(ROWS).fetchall() == [(2000, 0)]
    assert log_of(path).read_bytes() == course.log, "a reader changes nothing"
    assert counted(path, writable=True) == (2000, 0)


def test_a_large_log_goes_into_the_file(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(duckdb_driver, "LARGE_LOG", 20_000)
    sizes = []
    with DuckSession(path, writable=True) as session:
        for _ in range(12):
            with session.transaction():
                session.connection.execute(
                    "INSERT INTO readings SELECT range, 2 * range FROM range(300)"
                )
            sizes.append(log_of(path).stat().st_size if log_of(path).exists() else 0)
    assert 0 in sizes
    assert 0 < max(sizes) <= 20_000
    assert sorted(file.name for file in path.parent.iterdir()) == [path.name]
    assert counted(path) == (4_600, 0)


def test_without_room_for_the_journal_the_log_stays(path: Path) -> None:
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    with DuckSession(path, writable=True) as session:
        session.connection.execute(MORE)
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, hard))
        try:
            session.close()
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert log_of(path).exists()
    assert not journal_of(path).exists()
    assert counted(path) == (2000, 0)
    with DuckSession() as session:
        resource.setrlimit(resource.RLIMIT_FSIZE, (100_000, hard))
        try:
            with pytest.raises(FullError, match="a quota or ulimit is reached"):
                session.write(exp.select("1 AS one"), path, "results")
        finally:
            resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))
    assert counted(path, writable=True) == (2000, 0)


def test_the_lock_of_another_connection_of_the_process_stays(path: Path) -> None:
    opening = [sys.executable, "-c", "import duckdb, sys; duckdb.connect(sys.argv[1])", str(path)]
    with duckdb.connect(path) as mine:
        with DuckSession(path, writable=True) as session:
            session.connection.execute(MORE)
        refused = subprocess.run(opening, capture_output=True, text=True, check=False)
        assert "lock" in refused.stderr
        assert mine.execute(ROWS).fetchall() == [(2000, 0)]
    subprocess.run(opening, check=True)


def test_a_journal_at_work_is_left_alone(path: Path) -> None:
    with duckdb.connect(path) as connection:
        journal = Journal(connection)
        journal.keep()
        put_back(path)
        assert journal_of(path).exists()
        journal.done()
        journal.keep()
    journal.close()
    assert not journal_of(path).exists()


def test_results_are_written_with_a_journal(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    kept: list[str] = []
    keep = Journal.keep

    def noted(journal: Journal) -> None:
        keep(journal)
        kept.extend(file.name for file in path.parent.iterdir() if file.name == journal_of(path).name)

    monkeypatch.setattr(Journal, "keep", noted)
    with duckdb.connect() as mine, DuckSession(mine) as session:
        session.write(exp.select("1 AS one"), path, "results")
    assert len(kept) == 2  # before DuckDB could begin, and before our own checkpoint
    assert counted(path) == (1000, 0)
