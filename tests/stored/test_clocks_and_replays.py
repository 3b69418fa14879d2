"""A clock that stood ahead, calibration rows that come again, rows that belong nowhere."""

import datetime as dt
import time
from dataclasses import dataclass
from typing import Any

import duckdb
import pytest
from sqlglot import exp

import engines
import scripts
import small_plant
from gam_db.engines.session import Session
from gam_db.stored import pruning
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning.steps import DAY
from gam_db.stored.state import first_run_at, now
from small_plant import FIRST, LENGTH, monitor, readings, source
from state_names import called
from visible import put, visible

pytestmark = pytest.mark.thorough

AHEAD = 400 * DAY


@dataclass
class Plant:
    """The small plant on any engine, calibrated."""

    session: Session
    table: exp.Table
    prefix: str

    def monitor(self) -> Monitor:
        return monitor(self.session, self.table.name, self.prefix)

    def put(self, rows: list[Any]) -> None:
        scripts.arrive(self.session, self.table, rows)

    def asked(self, query: str) -> list[tuple[Any, ...]]:
        """Return rows of the state, by a query that names tables as DuckDB's tests do."""
        return [tuple(row.values()) for row in visible(self.monitor(), query)]

    def delete(self, asset: str, instant: int) -> None:
        chosen = exp.and_(exp.column("asset").eq(asset), exp.column("time").eq(instant))
        self.session.execute(exp.Delete(this=self.table.copy(), where=exp.Where(this=chosen)))


@pytest.fixture
def anywhere(engine: str) -> Plant:
    session = engines.session(engine)
    table = scripts.telemetry(session, readings(0, FIRST))
    made = Plant(session, table, engines.fresh_name("clocks"))
    made.monitor().migrate()
    made.monitor().calibrate()
    return made


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
    anywhere: Plant, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run() -> int:
        mine = anywhere.monitor()
        mine.park_after = 5
        return len(mine.score().channels)

    anywhere.put([row for row in readings(FIRST, 200) if row[0] != "d"])
    assert [run(), run()] == [4, 3]  # d is parked
    with monkeypatch.context() as patched:
        ahead(patched)
        assert run() == 4
    assert [run(), run()] == [4, 3]  # what was looked at in the future is due, once


def test_calibration_is_counted_after_the_clock_stood_ahead(
    anywhere: Plant, monkeypatch: pytest.MonkeyPatch
) -> None:
    counted = (
        "SELECT COUNT(calibration_readings) AS n FROM gam_state_run GROUP BY run_id ORDER BY run_id"
    )
    anywhere.put(readings(FIRST, 200))
    anywhere.monitor().score()
    with monkeypatch.context() as patched:
        ahead(patched)
        anywhere.monitor().score()
    for _ in range(2):
        anywhere.monitor().score()
    assert anywhere.asked(counted) == [(0,), (4,), (4,)]
    looked = anywhere.monitor().status()["looked_at"].to_pylist()
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
        counted = "SELECT COUNT(calibration_readings) FROM gam_state_run GROUP BY run_id ORDER BY run_id"
        assert asked(connection, counted) == [(4,)]


def test_rows_of_a_run_that_was_cut_short_while_the_clock_stood_ahead_go(
    plant: duckdb.DuckDBPyConnection,
) -> None:
    """Where there are no transactions; what may be at work stays."""
    put(plant, readings(FIRST, 200))
    refused = first_run_at(now() - 1)
    monitor(plant).score()
    dead, alive = first_run_at(now() + AHEAD), first_run_at(now())
    ((newest,),) = asked(plant, "SELECT MAX(run_id) FROM gam_state_run")
    assert refused < newest < alive
    for run_id in (dead, alive, refused):
        plant.execute(
            f"INSERT INTO gam_state_bucket SELECT 1, 90, {run_id}, 0, 0, 0, 5, 0, 0, NULL, NULL, NULL"
        )
        plant.execute(f"INSERT INTO gam_state_novel SELECT 1, 90, {run_id}, 7, 1, 0, 0")
    mine = monitor(plant)
    mine.session.transactions = False
    pruning.prune(mine.state)
    for table in ("bucket", "novel"):
        left = asked(plant, f"SELECT run_id FROM {called(table)} WHERE bucket_no = 90")
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
    ((newest,),) = asked(plant, "SELECT MAX(run_id) FROM gam_state_run")
    assert min(given) > newest
    plant.execute(
        f"INSERT INTO gam_state_bucket SELECT 1, 90, {max(given)}, 0, 0, 0, 5, 0, 0, NULL, NULL, NULL"
    )
    mine.session.transactions = False
    pruning.prune(mine.state)
    assert asked(plant, "SELECT run_id FROM gam_state_bucket WHERE bucket_no = 90") == [(max(given),)]
    mine.session.transactions = True
    put(plant, readings(200, LENGTH))
    monitor(plant).score()
    assert small_plant.seen(plant) == small_plant.whole()


def test_a_replay_of_calibration_is_no_change(anywhere: Plant) -> None:
    def added() -> list[int]:
        anywhere.monitor().score(everything=True)
        found = anywhere.monitor().status()
        rows = zip(found["asset"], found["calibration_rows_added"], strict=True)
        return [row[1].as_py() for row in sorted(rows, key=lambda row: str(row[0]))]

    assert added() == [0, 0, 0, 0]
    anywhere.put(readings(0, 50))
    assert added() == [0, 0, 0, 0]
    remarks = " ".join(str(one) for one in anywhere.monitor().status()["remarks"].to_pylist())
    assert "alibration data changed" not in remarks
    asset, channel, instant, value = readings(0, FIRST)[7]
    anywhere.put([(asset, channel, instant, (value or 0.0) + 1), ("b", "x", 20, None)])
    anywhere.delete("c", 60)
    assert added() == [1, 1, -1, 0]


def test_rows_that_belong_nowhere_stay_known(anywhere: Plant) -> None:
    anywhere.monitor().score()
    assert anywhere.asked("SELECT * FROM gam_unplaced_day") == []
    anywhere.put(readings(FIRST, 200))
    nowhere = [(None, "x", 199, 1.0), ("a", None, 199, 1.0), ("a", "x", None, 1.0)]
    anywhere.put([*nowhere, ("a", "y", 199, 1.0), ("z", "x", 199, 1.0), ("z", "x", 198, 1.0)])
    report = anywhere.monitor().score()
    strangers = sum(row["readings"] for row in report.unknown_channels.values())
    assert (report.nameless, report.undated, strangers) == (2, 1, 3)
    anywhere.monitor().score(everything=True)
    assert anywhere.monitor().score(dry_run=True).undated == 1
    found = anywhere.asked(
        "SELECT monitor, runs, nameless, undated, strangers, stranger_channels, day "
        "FROM gam_unplaced_day"
    )
    ((*counts, day),) = found
    assert counts == ["default", 2, 2, 1, 3, 2]
    assert 0 <= time.time() - instant_of(day) + 86_400 < 3 * 86_400
    assert instant_of(day) % 86_400 == 0
    begun = (
        "SELECT COUNT(DISTINCT started) AS n FROM gam_state_unplaced JOIN gam_state_run USING (started)"
    )
    assert anywhere.asked(begun) == [(3,)]


def instant_of(day: Any) -> float:
    """Return seconds since 1970; SQLite has no type of its own for an instant."""
    return float(dt.datetime.fromisoformat(str(day)).replace(tzinfo=dt.UTC).timestamp())


def test_what_belongs_nowhere_is_pruned_after_a_year(plant: duckdb.DuckDBPyConnection) -> None:
    put(plant, [("z", "x", 199, 1.0)])
    monitor(plant).score()
    plant.execute(f"UPDATE gam_state_unplaced SET started = started - {366 * DAY}")
    (old,) = asked(plant, "SELECT started FROM gam_state_unplaced")
    monitor(plant).score()
    monitor(plant).prune()
    (young,) = asked(plant, "SELECT started FROM gam_state_unplaced")
    assert young[0] - old[0] > 365 * DAY
