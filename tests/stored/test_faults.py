"""What goes wrong around a monitor: a clear sentence, the state as before, and a plain run mends it."""

import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import duckdb
import pytest

import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConflictError, EngineError, FullError, UserError
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.tables import TABLES, StateTables
from gam_db.study.running import Listener
from nobody import as_nobody
from small_plant import FIRST, LENGTH, begin, monitor, readings, seen, source, stored, whole
from state_names import called
from visible import put

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]

CONFLICT = r"^Another connection changed .* Run it again"


@pytest.fixture(scope="module")
def expected() -> list[Any]:
    return whole()


@pytest.fixture(scope="module")
def begun(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A file whose monitor has scored a part of its source; then the rest of it came."""
    path = tmp_path_factory.mktemp("begun") / "plant.duckdb"
    with duckdb.connect(path) as connection:
        begin(connection)
    return path


@pytest.fixture
def plant(begun: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(begun, tmp_path))


@pytest.fixture
def connection(plant: Path) -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect(plant) as opened:
        yield opened


# The source


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("ALTER TABLE telemetry RENAME TO readings", r"no table or view 'telemetry' in the database"),
        ("ALTER TABLE telemetry DROP value", r"The relation has no column 'value' for value"),
        ("ALTER TABLE telemetry RENAME asset TO machine", r"no column 'asset' for asset"),
        (
            "ALTER TABLE telemetry ALTER value TYPE VARCHAR",
            r"'value' is of type VARCHAR; readings must be numbers",
        ),
        (
            "ALTER TABLE telemetry ALTER time TYPE TIMESTAMP USING make_timestamp(time)",
            r"is a timestamp; .*made for a counter\.|watches a source whose time is a counter; ",
        ),
        (
            "ALTER TABLE telemetry ALTER time TYPE VARCHAR",
            r"Each value of the time column 'time' must be a time",
        ),
        ("DELETE FROM telemetry", r"The source has no row"),
    ],
)
@pytest.mark.parametrize("command", ["calibrate", "score"])
def test_a_source_that_changed_is_refused(
    connection: duckdb.DuckDBPyConnection, expected: list[Any], change: str, message: str, command: str
) -> None:
    connection.execute("CREATE TABLE original AS FROM telemetry")
    before = stored(connection)
    connection.execute(change)
    with pytest.raises(UserError, match=message) as refused:
        getattr(monitor(connection), command)()
    assert "\n" not in str(refused.value)
    assert stored(connection) == before
    connection.execute("DROP TABLE IF EXISTS telemetry")
    connection.execute("CREATE TABLE telemetry AS FROM original")
    monitor(connection).score()
    assert seen(connection) == expected


def test_nothing_new_is_no_error(connection: duckdb.DuckDBPyConnection, expected: list[Any]) -> None:
    for _ in range(2):
        monitor(connection).score()
        assert seen(connection) == expected


# What lies outside the contract is shown


def test_rows_later_than_lookback_show_in_the_context(
    connection: duckdb.DuckDBPyConnection, expected: list[Any]
) -> None:
    late = "asset = 'a' AND time BETWEEN 260 AND 290 AND time % 3 = 0"
    connection.execute(f"CREATE TABLE late AS FROM telemetry WHERE {late}")
    connection.execute(f"DELETE FROM telemetry WHERE {late}")
    monitor(connection).score()
    connection.execute("INSERT INTO telemetry FROM late")
    report = monitor(connection).score()
    read = [row for row in report.channels if row["read_to"] is not None]
    odd = [row["asset"] for row in read if row["context_rows"] != row["context_expected"]]
    recorded = """
        SELECT asset FROM gam_state_run JOIN gam_state_version USING (version_id)
        JOIN gam_state_channel USING (channel_id)
        WHERE context_rows <> context_expected AND read_to IS NOT NULL
    """
    assert odd == ["a"]
    assert connection.execute(recorded).fetchall() == [("a",)]
    assert seen(connection) != expected
    monitor(connection).score(since=255)
    assert seen(connection) == expected


def test_rows_that_come_late_to_calibration_are_counted() -> None:
    with duckdb.connect() as connection:
        late = [row for row in readings(0, FIRST) if row[0] == "b" and row[2] in (10, 20, 30)]
        source(connection, [row for row in readings(0, FIRST) if row not in late])
        monitor(connection).migrate()
        monitor(connection).calibrate()
        put(connection, [*late, *readings(FIRST, 200)])
        counted = """
            SELECT asset, run.calibration_readings - frozen.calibration_readings
            FROM gam_state_run AS run JOIN gam_state_version AS frozen USING (version_id)
            JOIN gam_state_channel USING (channel_id) ORDER BY asset
        """
        monitor(connection).score()
        # Not counted by every run: it takes the whole source.
        assert {more for _, more in connection.execute(counted).fetchall()} == {None}
        for _ in range(2):
            monitor(connection).score(everything=True)
            found = [row for row in connection.execute(counted).fetchall() if row[1] is not None]
            assert sorted(set(found)) == [("a", 0), ("b", 3), ("c", 0), ("d", 0)]


# The database file


@contextmanager
def small_files(folder: Path, room: int) -> Iterator[None]:
    """Let no file of this process grow beyond so many bytes: what a full disk looks like to it."""
    soft, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (room, hard))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, (soft, hard))


@contextmanager
def ballast(folder: Path, room: int) -> Iterator[None]:
    """Fill the disk of a folder but for so many bytes."""
    heavy = folder / "ballast"
    disk = os.statvfs(folder)
    heavy.write_bytes(bytes(max(disk.f_bavail * disk.f_frsize - room, 0)))
    try:
        yield
    finally:
        heavy.unlink()


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A disk of a few megabytes."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=24m", "tmpfs", str(folder)]
    if subprocess.run(mount, capture_output=True, check=False).returncode:
        pytest.skip("left out: no disk may be mounted here; the limit on files stands in for it")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


#: What a run writes, all of it or nothing.
RUN = {"bucket", "episode", "judgement", "novel", "run", "unplaced"}


def endure(folder: Path, tightness: Callable[[Path, int], Any], expected: list[Any]) -> None:
    """Run every command with more and more room on the disk, until it has enough."""
    path, failures = folder / "plant.duckdb", dict.fromkeys(("migrate", "calibrate", "score"), 0)
    with DuckSession(path, writable=True) as session:
        source(session.connection, readings(0, FIRST))
    for command in failures:
        for room in (0, 3_000, 9_000, 30_000, 100_000, 300_000, 2**22, 2**23):
            with DuckSession(path, writable=True) as session:
                before = stored(session.connection)
            refused: list[EngineError] = []
            with tightness(folder, room):
                try:
                    with gam_db.connect(path, threads=1) as session:
                        getattr(monitor(session), command)()
                except EngineError as error:
                    refused.append(error)
            if not refused:
                break
            failures[command] += 1
            assert isinstance(refused[0], FullError)
            assert re.fullmatch(
                r"The disk of .* is full\. What was .* Make room, and .*", str(refused[0])
            )
            with DuckSession(path, writable=True) as session:
                after = stored(session.connection)
            grown = [table for table in after if after[table] != before.get(table, [])]
            # What is a transaction of its own stays: each migration, the row of a new monitor, and a
            # run, after which comes where signals went.
            assert (
                set(grown) <= {"migrate": {"migration"}, "calibrate": {"monitor"}, "score": RUN}[command]
            )
            assert "run" in grown or not RUN & set(grown)
        with DuckSession(path, writable=True) as session:
            getattr(monitor(session), command)()
            if command == "calibrate":
                put(session.connection, readings(FIRST, LENGTH))
    with DuckSession(path, writable=True) as session:
        assert seen(session.connection) == expected
    assert all(failures.values()), failures


def test_files_that_may_not_grow(tmp_path: Path, expected: list[Any]) -> None:
    endure(tmp_path, small_files, expected)


def test_a_full_disk(small_disk: Path, expected: list[Any]) -> None:
    endure(small_disk, ballast, expected)


def test_a_file_that_may_only_be_read(plant: Path, expected: list[Any]) -> None:
    # Not below tmp_path, where nobody but its owner may look.
    with tempfile.TemporaryDirectory() as folder:
        path = Path(shutil.copy(plant, folder))
        with DuckSession(path, writable=True) as session:
            before = stored(session.connection)
        path.chmod(0o444)
        Path(folder).chmod(0o555)
        with (
            as_nobody(),
            pytest.raises(EngineError, match=("cannot be written: you have only read permission")),
        ):
            gam_db.connect(path)
        Path(folder).chmod(0o755)
        path.chmod(0o644)
        with DuckSession(path) as session:
            for command in ("migrate", "calibrate"):
                getattr(monitor(session), command)()  # nothing is to be done
            with pytest.raises(EngineError, match="open for reading only"):
                monitor(session).score()
            with pytest.raises(EngineError, match="open for reading only"):
                monitor(session).calibrate(again=True)
            assert stored(session.connection) == before
        with DuckSession(path, writable=True) as session:
            monitor(session).score()
            assert seen(session.connection) == expected


def test_a_file_that_another_process_holds(plant: Path, expected: list[Any]) -> None:
    with DuckSession(plant, writable=True) as session:
        before = stored(session.connection)
    holding = "import duckdb, sys; held = duckdb.connect(sys.argv[1]); print(); sys.stdin.read()"
    with subprocess.Popen(
        [sys.executable, "-c", holding, str(plant)], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        holder.stdout.readline()
        with pytest.raises(
            EngineError, match=(r"is open in another process; .* Wait for that " r"process to end")
        ):
            Monitor(plant, gam_db.Source("telemetry"))
        holder.communicate()
    with DuckSession(plant, writable=True) as session:
        assert stored(session.connection) == before
        monitor(session).score()
        assert seen(session.connection) == expected


def test_a_file_that_was_damaged(plant: Path) -> None:
    """As a process leaves it that is killed while DuckDB writes the first block of the file over."""
    whole = plant.read_bytes()
    block = slice(3 * 4096, 3 * 4096 + 2**17)
    plant.write_bytes(whole[: block.start] + bytes(2**17) + whole[block.stop :])
    for writable in (False, True):
        with pytest.raises(EngineError, match=r"is damaged: .* Restore a complete copy"):
            DuckSession(plant, writable=writable)
    plant.write_bytes(whole)
    with DuckSession(plant, writable=True) as session:
        monitor(session).score()


# Two connections of one process


def at_once(
    connection: duckdb.DuckDBPyConnection,
    command: Callable[[Monitor, Listener], Any],
    step: str,
    writers: int = 2,
) -> list[UserError]:
    """Run a command several times at once, all past a step before any goes on; return refusals."""
    barrier = threading.Barrier(writers, timeout=60)
    refused: list[Any] = []

    def run(mine: duckdb.DuckDBPyConnection) -> None:
        waiting = [step]

        def meet(announced: str) -> None:
            if announced in waiting:
                waiting.remove(announced)
                barrier.wait()

        try:
            command(monitor(mine), meet)
        except UserError as error:
            refused.append(error)

    threads = [threading.Thread(target=run, args=(connection.cursor(),)) for _ in range(writers)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return refused


def test_of_three_runs_at_once_one_counts_and_no_hidden_row_stays(
    connection: duckdb.DuckDBPyConnection, expected: list[Any]
) -> None:
    for full in (False, False, True, True):

        def command(mine: Monitor, meet: Listener, full: bool = full) -> None:
            mine.score(full=full, on_step=meet)

        found = at_once(connection, command, "writing", writers=3)
        assert [type(error) for error in found] == [ConflictError] * 2
        assert seen(connection) == expected
        for table in ("bucket", "novel"):
            kept = connection.execute(f"SELECT COUNT(*) FROM {called(table)}").fetchall()
            counted = f"SELECT COUNT(*) FROM {called(f'visible_{table}')}"
            assert kept == connection.execute(counted).fetchall()


def test_two_calibrations_at_once_do_not_double_versions(expected: list[Any]) -> None:
    """One of them is refused, where the other is faster; then there is nothing left to do for it."""
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        found = at_once(connection, lambda mine, meet: mine.calibrate(on_step=meet), "names")
        assert [type(error) for error in found] == [ConflictError]
        assert str(found[0]).startswith("Another connection changed")
        monitor(connection).calibrate()
        assert at_once(connection, lambda mine, meet: mine.calibrate(on_step=meet), "names") == []
        found = at_once(connection, lambda mine, meet: mine.calibrate(again=True, on_step=meet), "names")
        assert len(found) == 1
        versions = "SELECT version_id, channel_id, version_no FROM gam_state_version ORDER BY version_id"
        assert connection.execute(versions).fetchall() == [
            (4 * number + channel, channel, number + 1) for number in (0, 1) for channel in (1, 2, 3, 4)
        ]
        assert len(stored(connection)["monitor"]) == 1
        put(connection, readings(FIRST, LENGTH))
        monitor(connection).score()
        assert seen(connection) == expected


def test_two_migrations_at_once_leave_one_record() -> None:
    with duckdb.connect() as connection, DuckSession(connection.cursor(), writable=True) as other:

        def meanwhile(step: str) -> None:
            if step == TABLES[6]:
                with pytest.raises(ConflictError, match=CONFLICT):
                    migrations.migrate(other, StateTables())

        with DuckSession(connection, writable=True) as session:
            migrations.migrate(session, StateTables(), meanwhile)
        assert monitor(connection).migrate() == []
        assert [row[0] for row in stored(connection)["migration"]] == [one.number for one in files()]
