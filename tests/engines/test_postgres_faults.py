"""What goes wrong around a monitor on PostgreSQL: the state as before, and a plain run mends it.

Processes are killed (kill -9) at any moment of scoring; two writers work at once; the server ends
a connection. And what a run reads of its source.
"""

import itertools
import random
import threading
import time
from collections.abc import Callable, Iterator
from typing import Any

import psycopg
import pytest

import gam_db
import postgres_server
from gam_db.errors import ConflictError, EngineError, UserError
from gam_db.stored.monitor import Monitor
from gam_db.stored.scoring.report import Report
from gam_db.study.running import Listener
from sets import amounts
from small_plant import FIRST, LOOKBACK, monitor, readings, whole
from small_postgres import administrator, begin, database, put, rows_of, seen, source, stored
from state_names import called
from strategies import Row
from victims import Moment, Victims

#: How many running processes are killed, in the first set and in the full one.
KILLS = 10, 100

#: Most rows that a run works on at once, so that it takes several transactions.
GROUP = 200

METHOD: dict[str, Any] = {
    "parameters": {"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5},
    "calibration": {"fraction": 0.7},
    "lookback": LOOKBACK,
}


@pytest.fixture(scope="module")
def begun() -> Iterator[str]:
    """A database whose monitor has scored a part of its source; then the rest of it came."""
    with database() as made:
        with administrator(made) as connection:
            begin(connection)
        yield made


@pytest.fixture
def name(begun: str) -> Iterator[str]:
    with database(template=begun) as made:
        yield made


@pytest.fixture
def plant(name: str) -> Iterator[Any]:
    with administrator(name) as connection:
        yield connection


def url(name: str) -> str:
    return postgres_server.server().url_of(name)


def without_doubles(connection: Any) -> bool:
    """Tell whether no row of the state is hidden, or of no run."""
    counts = [
        rows_of(connection, f"SELECT count(*) AS n FROM {called(table)}")
        for table in ("bucket", "visible_bucket", "novel", "visible_novel")
    ]
    return counts[0] == counts[1] and counts[2] == counts[3]


@amounts("kills", *KILLS)
def test_killed_while_scoring(begun: str, kills: int) -> None:
    chance = random.Random(4)
    victims = Victims()
    expected = whole()
    after = {row["asset"]: row["bucket"] for row in expected[0]}
    order: dict[str, Any] = {"command": "score", "options": {"limit": GROUP}, **METHOD}
    try:
        with database(template=begun) as made, administrator(made) as connection:
            before = {row["asset"]: row["bucket"] for row in seen(connection)[0]}
            seconds = victims.lifetime(database=url(made), **order)
        for number in itertools.count():
            moment = [
                Moment(1, chance.uniform(0, seconds)),
                Moment(chance.randint(1, 20), chance.uniform(0, 0.1 * seconds)),
                Moment(chance.randint(1, 20)),
            ][number % 3]
            with database(template=begun) as made:
                if not victims.kill(moment, database=url(made), **order):
                    continue
                with administrator(made) as connection:
                    found = {row["asset"]: row for row in seen(connection)[0]}
                    for asset, last in found.items():
                        assert last["bucket"] in (before[asset], after[asset]), (asset, moment)
                    with gam_db.connect(url(made)) as session:
                        monitor(session).score(limit=GROUP)
                    assert seen(connection) == expected, moment
                    assert without_doubles(connection), moment
            if victims.killed >= kills:
                break
    finally:
        victims.close()


@pytest.mark.parametrize("step", ["identified", "visited", "writing"])
def test_a_connection_that_is_lost(name: str, plant: Any, step: str) -> None:
    before = stored(plant)

    def cut(announced: str) -> None:
        if announced == step:
            plant.execute(
                "SELECT pg_terminate_backend(pid, 10000) FROM pg_stat_activity "
                "WHERE datname = current_database() AND pid <> pg_backend_pid()"
            )

    with (
        gam_db.connect(url(name)) as session,
        pytest.raises(EngineError, match=r"^The connection to PostgreSQL was lost; .* Run it again"),
    ):
        monitor(session).score(on_step=cut)
    assert stored(plant) == before
    with gam_db.connect(url(name)) as session:
        monitor(session).score()
    assert seen(plant) == whole()


# Two writers


def at_once(
    name: str, command: Callable[[Monitor, Listener], Any], step: str, writers: int = 2
) -> list[UserError]:
    """Run a command several times at once, all past a step before any goes on; return refusals."""
    barrier = threading.Barrier(writers, timeout=60)
    refused: list[UserError] = []

    def run() -> None:
        waiting = [step]

        def meet(announced: str) -> None:
            if announced in waiting:
                waiting.remove(announced)
                barrier.wait()

        with gam_db.connect(url(name)) as session:
            try:
                command(monitor(session), meet)
            except UserError as error:
                refused.append(error)

    threads = [threading.Thread(target=run) for _ in range(writers)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return refused


def test_of_three_runs_at_once_no_hidden_row_stays(name: str, plant: Any) -> None:
    """One of them counts: the others wait for it inside their transactions, and are refused."""
    for full in (False, True, True):

        def command(mine: Monitor, meet: Listener, full: bool = full) -> None:
            mine.score(full=full, on_step=meet)

        found = at_once(name, command, "writing", writers=3)
        assert [type(error) for error in found] == [ConflictError] * 2
        assert seen(plant) == whole()
        assert without_doubles(plant)


def test_two_runs_at_once_do_not_double_rows(name: str, plant: Any) -> None:
    expected = whole()
    for full in (False, True, True):

        def command(mine: Monitor, meet: Listener, full: bool = full) -> None:
            mine.score(full=full, on_step=meet)

        found = at_once(name, command, "writing")
        assert [type(error) for error in found] == [ConflictError]
        assert seen(plant) == expected
    with gam_db.connect(url(name)) as session:
        monitor(session).score(full=True)
    assert seen(plant) == expected
    assert without_doubles(plant)


def test_two_calibrations_at_once_do_not_double_versions(plant: Any, name: str) -> None:
    """The second waits for the row that the first holds, and then finds other keys than before."""
    found = at_once(name, lambda mine, meet: mine.calibrate(again=True, on_step=meet), "writing")
    assert [type(error) for error in found] == [ConflictError]
    assert str(found[0]).startswith("Another connection changed")
    versions = "SELECT version_id, channel_id, version_no FROM gam_state_version ORDER BY version_id"
    assert plant.execute(versions).fetchall() == [
        (4 * number + channel, channel, number + 1) for number in (0, 1) for channel in (1, 2, 3, 4)
    ]


@pytest.mark.parametrize("level", ["read committed", "repeatable read", "serializable"])
def test_one_that_waits_for_another_is_refused(name: str, plant: Any, level: str) -> None:
    """Whatever the server's default isolation: the one that comes second is told to run again."""
    plant.execute(f"ALTER DATABASE {name} SET default_transaction_isolation = '{level}'")
    before = len(stored(plant)["version"])
    with psycopg.connect(url(name)) as first, gam_db.connect(url(name)) as session:
        refused: list[UserError] = []

        def second() -> None:
            try:
                monitor(session).calibrate(again=True)
            except UserError as error:
                refused.append(error)

        first.execute("UPDATE gam_state_migration SET applied_at = applied_at WHERE number = 1")
        first.execute(
            "CREATE TEMPORARY TABLE another AS SELECT * FROM gam_state_version WHERE version_id = 1"
        )
        first.execute("UPDATE another SET version_id = 99")
        first.execute("INSERT INTO gam_state_version SELECT * FROM another")
        waiting = threading.Thread(target=second)
        waiting.start()
        blocked = "SELECT count(*) FROM pg_locks WHERE NOT granted"
        while waiting.is_alive() and plant.execute(blocked).fetchall() == [(0,)]:
            waiting.join(0.05)
        first.commit()
        waiting.join()
    assert [str(error)[:26] for error in refused] == ["Another connection changed"]
    assert len(stored(plant)["version"]) == before + 1


def test_two_migrations_at_once(name: str) -> None:
    with database() as empty:
        with administrator(empty) as connection:
            source(connection, readings(0, FIRST))
        found = at_once(empty, lambda mine, _: mine.migrate(), "never")
        assert all(str(error).startswith("Another connection changed") for error in found)
        with administrator(empty) as connection, gam_db.connect(url(empty)) as session:
            monitor(session).migrate()
            numbers = connection.execute("SELECT number FROM gam_state_migration ORDER BY 1").fetchall()
            assert numbers == [(number,) for number in range(1, len(numbers) + 1)]


# What a run reads


def test_a_run_reads_its_range_of_the_source_and_of_what_is_stored() -> None:
    """By the server's own counts of rows."""
    length, late = 6000, 100
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    calibration = gam_db.Calibration(intervals=[(0, 200)])

    def rows(start: int, end: int) -> list[Row]:
        return [
            (asset, "x", t, float(t % 5 or t % 7 if t > 200 else t % 5))
            for t in range(start, end)
            for asset in "abcd"
        ]

    def score(address: str, *before: str) -> Report:
        with gam_db.connect(address) as session:
            plain = gam_db.Source("telemetry")
            mine = Monitor(session, plain, parameters, calibration, lookback=LOOKBACK)
            for command in before:
                getattr(mine, command)()
            return mine.score()

    with database() as made, administrator(made) as connection:
        source(connection, rows(0, length))
        connection.execute("CREATE INDEX ON telemetry (time)")
        score(url(made), "migrate", "calibrate")
        wait_until_alone(connection)
        put(connection, rows(length, length + late))
        connection.execute("VACUUM ANALYZE")
        # What this connection read itself, for the index, is else counted within a second, or later.
        connection.execute("SELECT pg_stat_force_next_flush()")
        connection.execute("SELECT pg_stat_reset()")
        report = score(url(made))
        wait_until_alone(connection)
        assert 0 < sum(row["rows_read"] for row in report.channels) < 4 * 1.5 * late
        there = connection.execute("SELECT COUNT(*) FROM gam_state_bucket").fetchone()[0]
        read = rows_of(
            connection,
            "SELECT relname AS name, seq_tup_read AS walked, idx_tup_fetch AS fetched "
            "FROM pg_stat_user_tables "
            "WHERE relname IN ('telemetry', 'gam_state_bucket', 'gam_state_novel')",
        )
        assert [row["walked"] for row in read] == [0, 0, 0]
        fetched = {row["name"]: row["fetched"] for row in read}
        assert 0 < fetched["telemetry"] < length
        assert 0 < fetched["gam_state_bucket"] < there / 4
        assert 0 < fetched["gam_state_novel"] < there / 4


def wait_until_alone(connection: Any) -> None:
    """Wait for the ends of all other connections: only then has the server counted what they read."""
    others = (
        "SELECT COUNT(*) FROM pg_stat_activity WHERE datname = current_database() "
        "AND backend_type = 'client backend' AND pid <> pg_backend_pid()"
    )
    end = time.monotonic() + 60
    while connection.execute(others).fetchone()[0]:
        assert time.monotonic() < end, "a connection stays open"
        time.sleep(0.05)
