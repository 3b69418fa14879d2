"""A clock that stood ahead, calibration rows that come again, rows that belong nowhere."""

import time
from typing import Any

import duckdb
import pytest

import small_plant
from gam_db.stored import pruning
from gam_db.stored.state import first_run_at, now
from gam_db.stored.steps import DAY
from small_plant import FIRST, LENGTH, monitor, readings, source
from visible import put

AHEAD = 400 * DAY


@pytest.fixture
def plant() -> Any:
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        monitor(connection).calibrate()
        yield connection


def ahead(patched: pytest.MonkeyPatch) -> None:
    """Let the clock of this process stand 400 days ahead."""
    true = time.time_ns
    patched.setattr(time, "time_ns", lambda: true() + 1000 * AHEAD)


def asked(connection: duckdb.DuckDBPyConnection, query: str) -> list[tuple[Any, ...]]:
    return connection.execute(query).fetchall()


def test_a_parked_channel_is_read_after_the_clock_stood_ahead(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run() -> int:
        mine = monitor(plant)
        mine.park_after = 5
        return len(mine.score().channels)

    put(plant, [row for row in readings(FIRST, 200) if row[0] != "d"])
    assert [run(), run()] == [4, 3]  # d is parked
    with monkeypatch.context() as patched:
        ahead(patched)
        assert run() == 4
    assert [run(), run()] == [4, 3]  # what was looked at in the future is due, once


def test_calibration_is_counted_after_the_clock_stood_ahead(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    counted = "SELECT COUNT(calibration_readings) FROM gam_run GROUP BY run_id ORDER BY run_id"
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    with monkeypatch.context() as patched:
        ahead(patched)
        monitor(plant).score()
    for _ in range(2):
        monitor(plant).score()
    assert asked(plant, counted) == [(0,), (4,), (4,), (0,)]
    looked = monitor(plant).status()["looked_at"].to_pylist()
    assert all(abs(one.timestamp() - time.time()) < 3600 for one in looked)


def test_versions_of_a_clock_that_stood_ahead_are_counted_at_once() -> None:
    with duckdb.connect() as connection, pytest.MonkeyPatch.context() as patched:
        source(connection, readings(0, FIRST))
        ahead(patched)
        monitor(connection).migrate()
        monitor(connection).calibrate()
        patched.undo()
        for _ in range(2):
            monitor(connection).score()
        counted = "SELECT COUNT(calibration_readings) FROM gam_run GROUP BY run_id ORDER BY run_id"
        assert asked(connection, counted) == [(4,), (0,)]


def test_rows_of_a_run_that_was_cut_short_while_the_clock_stood_ahead_go(
    plant: duckdb.DuckDBPyConnection,
) -> None:
    """Where there are no transactions; what may be at work stays."""
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    dead, alive, refused = first_run_at(now() + AHEAD), first_run_at(now()), first_run_at(now() - 10**6)
    ((newest,),) = asked(plant, "SELECT MAX(run_id) FROM gam_run")
    assert refused < newest < alive
    for run_id in (dead, alive, refused):
        plant.execute(f"INSERT INTO gam_bucket SELECT 1, 90, {run_id}, 0, 0, 0, 5, 0, 0, NULL")
        plant.execute(f"INSERT INTO gam_novel SELECT 1, 90, {run_id}, 7, 1, 0, 0")
    mine = monitor(plant)
    mine.session.transactions = False
    pruning.compact(mine.session, mine.state.tables)
    for table in ("bucket", "novel"):
        left = asked(plant, f"SELECT run_id FROM gam_{table} WHERE bucket_no = 90")
        assert left == [(alive,)], table


def test_runs_go_on_from_ids_of_a_clock_that_stood_ahead(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ids grow, two writers get different ones, and what is at work under one of them is left alone."""
    put(plant, readings(FIRST, 200))
    with monkeypatch.context() as patched:
        ahead(patched)
        monitor(plant).score()
    mine = monitor(plant)
    given = {mine.state.next_run() for _ in range(20)}
    assert len(given) > 10
    ((newest,),) = asked(plant, "SELECT MAX(run_id) FROM gam_run")
    assert min(given) > newest
    plant.execute(f"INSERT INTO gam_bucket SELECT 1, 90, {max(given)}, 0, 0, 0, 5, 0, 0, NULL")
    mine.session.transactions = False
    pruning.compact(mine.session, mine.state.tables)
    assert asked(plant, "SELECT run_id FROM gam_bucket WHERE bucket_no = 90") == [(max(given),)]
    mine.session.transactions = True
    put(plant, readings(200, LENGTH))
    monitor(plant).score()
    assert small_plant.seen(plant) == small_plant.whole()


def test_a_replay_of_calibration_is_no_change(plant: duckdb.DuckDBPyConnection) -> None:
    def added() -> list[int]:
        monitor(plant).score(everything=True)
        found = monitor(plant).status()
        rows = zip(found["asset"], found["calibration_rows_added"], strict=True)
        return [row[1].as_py() for row in sorted(rows, key=lambda row: str(row[0]))]

    assert added() == [0, 0, 0, 0]
    put(plant, readings(0, 50))
    assert added() == [0, 0, 0, 0]
    remarks = " ".join(str(one) for one in monitor(plant).status()["remarks"].to_pylist())
    assert "alibration data changed" not in remarks
    asset, channel, instant, value = readings(0, FIRST)[7]
    put(plant, [(asset, channel, instant, (value or 0.0) + 1), ("b", "x", 20, None)])
    plant.execute("DELETE FROM telemetry WHERE asset = 'c' AND time = 60")
    assert added() == [1, 1, -1, 0]


def test_rows_that_belong_nowhere_stay_known(plant: duckdb.DuckDBPyConnection) -> None:
    monitor(plant).score()
    assert asked(plant, "FROM gam_unplaced_day") == []
    put(plant, readings(FIRST, 200))
    plant.execute(
        "INSERT INTO telemetry VALUES (NULL, 'x', 199, 1), ('a', NULL, 199, 1), ('a', 'x', NULL, 1), "
        "('a', 'y', 199, 1), ('z', 'x', 199, 1), ('z', 'x', 198, 1)"
    )
    report = monitor(plant).score()
    assert (report.nameless, report.undated, sum(report.unknown_channels.values())) == (2, 1, 3)
    monitor(plant).score()
    assert monitor(plant).score(dry_run=True).undated == 1
    found = asked(
        plant,
        "SELECT monitor, runs, nameless, undated, strangers, stranger_channels, day "
        "FROM gam_unplaced_day",
    )
    ((*counts, day),) = found
    assert counts == ["default", 2, 2, 1, 3, 2]
    assert 0 <= time.time() - day.timestamp() + 86_400 < 3 * 86_400
    assert (day.hour, day.minute, day.second, day.microsecond) == (0, 0, 0, 0)
    begun = "SELECT COUNT(DISTINCT started) FROM gam_unplaced JOIN gam_run USING (started)"
    assert asked(plant, begun) == [(2,)]
    plant.execute(f"UPDATE gam_unplaced SET started = started - {366 * DAY}")
    monitor(plant).score()
    monitor(plant).prune()
    assert asked(plant, "SELECT COUNT(*) FROM gam_unplaced") == [(1,)]
