"""Planning: a run relies on what the last one recorded, and looks at no more of what is stored.

The tests of PostgreSQL, ClickHouse and Spark show the same of these engines.
"""

import json
import sqlite3
from collections.abc import Container, Iterator
from contextlib import closing
from functools import partial
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from sqlglot import exp

import by_hand
import gam_db
import small_plant
from gam_db.clock import LONG_AGO
from gam_db.composing.pipeline import Pipeline, filled, place
from gam_db.engines.base import deletion
from gam_db.errors import ParameterError
from gam_db.stored import scoring
from gam_db.stored.planning import Row, reading
from gam_db.stored.planning.reading import near, plan_rows, searched_plan_rows
from gam_db.stored.planning.steps import plan_steps
from gam_db.stored.pruning import prune
from gam_db.stored.scoring.report import Wanted
from gam_db.study.running import Running
from small_plant import FIRST, LENGTH, LOOKBACK, monitor, readings, seen, source
from state_names import called
from test_views import scanned
from visible import put

pytestmark = pytest.mark.thorough


@pytest.fixture
def plant() -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        monitor(connection).calibrate()
        yield connection


def planned(connection: duckdb.DuckDBPyConnection, lookback: int, is_searched: bool) -> list[Row]:
    with monitor(connection) as mine:
        plan = searched_plan_rows if is_searched else plan_rows
        with Running(mine.session, Pipeline(), mine.tables.nodes()) as running:
            rows = plan(running, 1, lookback)
    return sorted(({**row, "oldest_bucket": 0} for row in rows), key=lambda row: str(row["asset"]))


@pytest.fixture
def searches(monkeypatch: pytest.MonkeyPatch) -> list[int | None]:
    """The lookbacks of all plans that looked at the buckets."""
    found: list[int | None] = []

    def noted(running: Running, monitor_id: int, lookback: int | None, *more: int | None) -> list[Row]:
        found.append(lookback)
        return searched_plan_rows(running, monitor_id, lookback, *more)

    monkeypatch.setattr(scoring, "searched_plan_rows", noted)
    monkeypatch.setattr("gam_db.stored.planning.reading.searched_plan_rows", noted)
    return found


def test_what_was_recorded_is_what_a_search_finds(
    plant: duckdb.DuckDBPyConnection, searches: list[int | None]
) -> None:
    stops = [FIRST + 1, FIRST + 4, 150, 151, 200, LENGTH]
    for start, end in zip([FIRST, *stops], stops, strict=False):
        put(plant, readings(start, end))
        monitor(plant).score()
        recorded = planned(plant, LOOKBACK, False)
        assert recorded == planned(plant, LOOKBACK, True)
        ends = plant.execute(
            "SELECT last_time + 1, context_time FROM gam_state_visible_bucket "
            "JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id) "
            "WHERE bucket_no = ? - 1 ORDER BY asset",
            [recorded[0]["first_bucket"]],
        ).fetchall()
        assert [(row["first_scored"], row["read_from"]) for row in recorded] == ends
    assert searches == []
    assert max(row["first_bucket"] for row in planned(plant, LOOKBACK, False)) > 20
    assert seen(plant) == small_plant.whole()


#: Version, where its data to read begins, how far it was read, and when: today is from 150 on;
#: what begins before 140 is silent.
VERSIONS = (
    *((1, 180, 200, 990), (2, 150, 199, 990), (3, 149, 199, 990), (4, 140, 199, 990)),
    *((5, 100, 120, 990), (6, 100, 199, 990), (7, 130, 125, 990)),  # silent; two have sent something
    *((8, 100, 120, 900), (9, 100, 120, 1001)),  # a look is due; so it is where the clock stood ahead
    (10, 5, LONG_AGO, LONG_AGO),  # new
)


@pytest.mark.parametrize(
    ("changed", "cohorts", "today_from"),
    [
        ({}, [0, 0, 1, 1, 3, 3, 3, 2, 2, 2], 190),
        ({"everything": 1}, [0, 0, 1, 1, 2, 2, 2, 2, 2, 2], 190),
        ({"silence": None}, [0, 0, 1, 1, 1, 1, 1, 1, 1, 2], 190),
        ({"silence": 200}, [0, 0, 1, 1, 1, 1, 1, 1, 1, 2], 190),
        # The newest data is that of version 1, but for rows ahead of the clock.
        ({"latest": 195}, [0, 1, 1, 1, 3, 3, 3, 2, 2, 2], 185),
        ({"lookback": 11}, [0, 0, 0, 1, 3, 3, 3, 2, 2, 2], 189),
        ({"among": (3, 4, 5, 10)}, [0, 0, 3, 2], 189),
        ({"among": (10,)}, [2], LONG_AGO - 10),
    ],
)
def test_channels_of_a_run_are_read_in_three_cohorts(
    changed: dict[str, Any], cohorts: list[int], today_from: int
) -> None:
    """A silent one has a value to look for after what was read, or where it is none of the silent."""
    slots = {"lookback": 10, "silence": 60, "latest": 500, "started": 1000, "day": 100, "everything": 0}
    slots |= {name: value for name, value in changed.items() if name != "among"}
    numbers = changed.get("among", range(1, 11))
    chosen = exp.column("version_id", table="frozen").isin(*numbers)
    found = by_hand.step(
        "stored/scoring/cohorts",
        {**slots, "long_ago": LONG_AGO, "chosen": chosen},
        plan=by_hand.rows("version_id read_from read_until looked_at", *VERSIONS),
    )
    assert [row[:2] for row in found] == list(zip(numbers, cohorts, strict=True))
    assert {row[3] for row in found} == {today_from}
    if not changed:
        assert [row[2] for row in found if row[1] == 3] == [121, 140, 130]


def among(assets: Container[str], asset: str, _: str) -> bool:
    return asset in assets


def test_many_versions_are_bounded_by_a_range(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "_LISTED", 1)
    rows: list[Row] = [{"version_id": version, "first_bucket": 4} for version in (7, 3)]
    assert near(rows, 1).sql() == "bucket.version_id BETWEEN 3 AND 7 AND bucket.bucket_no >= 3"
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    put(plant, readings(200, LENGTH))
    # Two groups, each within the range of the other's versions: neither touches what is the other's.
    for assets in ({"a", "d"}, {"b", "c"}):
        asked = Wanted(LOOKBACK, chosen=partial(among, assets))
        with monitor(plant) as mine:
            scoring.Run(mine.state, mine.source, mine.name, asked).go()
    assert seen(plant) == small_plant.whole()


def test_the_plan_reads_no_bucket() -> None:
    tables = {table.name for table in plan_steps(1, LOOKBACK).query("plan").find_all(exp.Table)}
    assert "stored_finished_run" in tables
    assert not {name for name in tables if "bucket" in name}


def test_a_run_that_reads_nothing_leaves_the_record_as_it_was(
    plant: duckdb.DuckDBPyConnection, searches: list[int | None]
) -> None:
    put(plant, readings(FIRST, LENGTH))
    monitor(plant).score()
    before = planned(plant, LOOKBACK, False)
    plant.execute("CREATE TABLE aside AS FROM telemetry; DELETE FROM telemetry WHERE asset <> 'a'")
    monitor(plant).score()
    plant.execute("DELETE FROM telemetry; INSERT INTO telemetry FROM aside")
    kept = ("asset", "first_bucket", "first_scored", "read_from")
    after = planned(plant, LOOKBACK, False)
    assert [[row[name] for name in kept] for row in after] == [
        [row[name] for name in kept] for row in before
    ]
    monitor(plant).score()
    assert seen(plant) == small_plant.whole()
    assert searches == []


def test_runs_of_late_are_enough_or_all_are_looked_at(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    for start in range(FIRST, LENGTH - 20, 5):
        put(plant, readings(start, start + 5))
        monitor(plant).score()
    whole = planned(plant, LOOKBACK, False)
    with monitor(plant) as mine:
        runs = plant.execute("SELECT DISTINCT run_id FROM gam_state_run ORDER BY run_id").fetchall()
        for (since,) in [*runs, (runs[-1][0] + 1,)]:
            monkeypatch.setattr(reading, "recent_run", lambda since=since: since)
            assert planned(plant, LOOKBACK, False) == whole
        steps = [plan_steps(1, LOOKBACK, since) for since in (runs[-1][0], runs[-1][0] + 1)]
        plans = [mine.session.rows(one.query("plan", mine.state.tables.nodes())) for one in steps]
        assert [{row["restarts"] for row in plan} for plan in plans] == [{1}, {0}]
        assert {row["read_until"] for row in plans[1]} == {LONG_AGO}
    put(plant, readings(LENGTH - 20, LENGTH))
    monitor(plant).score()
    assert seen(plant) == small_plant.whole()


def test_where_nothing_is_new_nothing_is_written_anew(plant: duckdb.DuckDBPyConnection) -> None:
    """Of one channel, or of all; the next rows go on from what is stored."""
    every = "SELECT * FROM gam_state_bucket ORDER BY ALL"
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    stored = plant.execute(every).fetchall()
    monitor(plant).score()
    assert plant.execute(every).fetchall() == stored
    assert plant.execute("SELECT COUNT(*) FROM gam_state_run").fetchall() == [(4,)]
    put(plant, [row for row in readings(200, 220) if row[0] == "a"])
    report = monitor(plant).score()
    written = {(row["asset"], row["channel"]): row["buckets"] for row in report.channels}
    assert {channel for channel, buckets in written.items() if buckets} == {
        channel for channel in written if channel[0] == "a"
    }
    put(plant, [row for row in readings(200, 220) if row[0] != "a"])
    put(plant, readings(220, LENGTH))
    monitor(plant).score()
    assert seen(plant) == small_plant.whole()


def test_later_rows_than_the_last_run_allowed_for_are_searched_for(
    plant: duckdb.DuckDBPyConnection, searches: list[int | None]
) -> None:
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    put(plant, readings(200, LENGTH))
    assert planned(plant, 50, False) == planned(plant, 50, True)
    assert searches == [50]
    with gam_db.connect(plant) as session:
        own = monitor(session)
        longer = gam_db.Monitor(session, own.source, own.parameters, own.calibration, lookback=50)
        longer.score()
    assert searches == [50, 50]
    assert planned(plant, 50, False) == planned(plant, 50, True)
    assert searches == [50, 50], "the last run allowed for them"
    assert seen(plant) == small_plant.whole()


def test_pruning_leaves_the_window_before_what_was_recorded(
    plant: duckdb.DuckDBPyConnection, searches: list[int | None]
) -> None:
    put(plant, readings(FIRST, 200))
    monitor(plant).score()
    with monitor(plant) as mine:
        prune(mine.state, keep=0, lookback=0)
    put(plant, readings(200, LENGTH))
    monitor(plant).score()
    assert searches == []
    left, all_there = seen(plant)[0], small_plant.whole()[0]
    assert 4 * 20 < len(left) < len(all_there)
    assert [row for row in all_there if row in left] == left


def test_pruning_leaves_the_newest_record(plant: duckdb.DuckDBPyConnection) -> None:
    """Of a run that only hid buckets, with nothing read since: an older one would say too much."""
    put(plant, readings(FIRST, LENGTH))
    monitor(plant).score()
    plant.execute("DELETE FROM telemetry WHERE time >= 200")
    monitor(plant).score(since=200)
    hidden = planned(plant, LOOKBACK, False)
    plant.execute("DELETE FROM telemetry WHERE asset <> 'a'; DELETE FROM telemetry WHERE time > 0")
    monitor(plant).score()
    with monitor(plant) as mine:
        prune(mine.state)
    kept = ("asset", "first_bucket", "first_scored", "read_from")
    left = [[row[name] for name in kept] for row in planned(plant, LOOKBACK, False)]
    assert left == [[row[name] for name in kept] for row in hidden]


def test_the_past_window_is_found_by_literals(plant: duckdb.DuckDBPyConnection) -> None:
    """The condition reaches the scan; DuckDB says how many rows come out of it."""
    plant.execute(
        "INSERT INTO gam_state_bucket SELECT 1, n, 7, n, n, n, 1, 0, 0, 0, NULL, NULL "
        "FROM range(200000) AS others(n)"
    )
    nothing = "NULL, NULL, 0, 0, 0, 0, 0, 0, 0, NULL, NULL, NULL, NULL, NULL"
    plant.execute(f"INSERT INTO gam_state_run SELECT 7, 1, 0, 0, 0, 0, 0, {nothing}")
    group = [{"version_id": 1, "first_bucket": 199_000}]
    query = filled(
        "stored/scoring/past_buckets", {"buckets": 4, "differing": [], "near": near(group, 4)}
    )
    with monitor(plant) as mine:
        place(query, mine.state.tables.nodes())
        plant.execute(
            "CREATE TEMP TABLE cohort AS SELECT 1 channel_id, 1 version_id, 199000 first_bucket"
        )
        text = mine.session.engine.text(query)
    assert len(plant.execute(text).fetchall()) == 4
    said = plant.execute(f"EXPLAIN (ANALYZE, FORMAT JSON) {text}").fetchall()[0][1]
    assert sum(scanned(json.loads(said)["operator"], "gam_state_bucket")) <= 1004


def test_runs_of_years_are_not_put_in_order(plant: duckdb.DuckDBPyConnection) -> None:
    """By them fleet and plan say when a channel was read, and views what is seen.

    DuckDB says how many rows its windows take.
    """
    monitor(plant).score()
    fleet, plan = everything(plant, "gam_fleet"), planned(plant, LOOKBACK, False)
    buckets = everything(plant, "gam_state_visible_bucket")
    few = len(everything(plant, "gam_state_run"))
    plant.execute(
        "INSERT INTO gam_state_run BY NAME SELECT run.* REPLACE (run_id - back AS run_id) "
        "FROM gam_state_run AS run, range(1, 3000) AS others(back)"
    )
    assert everything(plant, "gam_fleet") == fleet
    assert planned(plant, LOOKBACK, False) == plan
    assert everything(plant, "gam_state_visible_bucket") == buckets
    with monitor(plant) as mine:
        reads = plan_steps(1, LOOKBACK).query("last_reads", mine.state.tables.nodes())
        views = (
            f"SELECT * FROM {called(view)}" for view in ("fleet", "visible_novel", "visible_judgement")
        )
        for text in (*views, mine.session.engine.text(reads)):
            said = plant.execute(f"EXPLAIN (ANALYZE, FORMAT JSON) {text}").fetchall()[0][1]
            pending = json.loads(said)["operator"]
            while pending:
                operator = pending.pop()
                pending += operator.get("children", [])
                if operator["type"] == "WINDOW":
                    assert operator["intermediate_rows"] <= 10 * few


def everything(connection: duckdb.DuckDBPyConnection, view: str) -> list[tuple[object, ...]]:
    return connection.execute(f"SELECT * FROM {view} ORDER BY ALL").fetchall()


def test_sqlite_finds_what_is_stored_by_its_key() -> None:
    """The window that stays, and the rows that a run has replaced; SQLite says how it looks for them."""
    group = [{"version_id": key, "first_bucket": 500} for key in (3, 5)]
    cohort = pa.table({"channel_id": [3, 5], "version_id": [3, 5], "first_bucket": [500, 500]})
    with closing(sqlite3.connect(":memory:")) as connection, gam_db.connect(connection) as session:
        connection.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value REAL)")
        mine = gam_db.Monitor(session, gam_db.Source("telemetry"))
        mine.migrate()
        stored = mine.state.tables.nodes()
        past = filled(
            "stored/scoring/past_buckets", {"buckets": 50, "differing": [], "near": near(group, 50)}
        )
        bucket = stored["stored_bucket"]
        hidden = filled("stored/state/superseded", {"run_id": 7, "after": 4, "near": near(group)})
        place(hidden, {**stored, "appended": bucket})
        gone = deletion(bucket, hidden.named_selects, hidden)
        with session.lent(cohort) as lent:
            place(past, {**stored, "cohort": lent})
            for asked in (past, gone):
                text = f"EXPLAIN QUERY PLAN {session.engine.text(asked)}"
                plan = [row[3] for row in connection.execute(text)]
                assert any(
                    "gam_state_bucket_key (version_id=? AND bucket_no>?)" in step for step in plan
                )
                assert not [step for step in plan if step in ("SCAN written", "SCAN gam_state_bucket")]


def test_what_was_scored_after_an_end_is_hidden_until_the_next_run(
    plant: duckdb.DuckDBPyConnection,
) -> None:
    """Also where it lies before what late rows may still change."""
    mine, end = monitor(plant), FIRST - 3 * LOOKBACK
    mine.score()
    before = seen(plant)
    mine.score(until=end)
    newest = plant.execute("SELECT MAX(last_time) FROM gam_state_visible_bucket").fetchone()
    assert newest is not None
    assert end - 5 <= newest[0] <= end
    assert mine.check_state().num_rows == 0
    mine.score()
    assert seen(plant) == before


def test_an_end_before_all_that_is_read_is_refused(plant: duckdb.DuckDBPyConnection) -> None:
    """Nothing is read of such a channel then, so nothing of it would be hidden."""
    mine = monitor(plant)
    mine.score()
    before = seen(plant)
    ((begin,),) = plant.execute("SELECT MIN(read_from) FROM gam_state_run").fetchall()
    for full in (False, True):
        with pytest.raises(ParameterError, match=rf"end at {begin - 1}: .* a x \(and of 3 more\)"):
            mine.score(until=begin - 1, full=full)
    assert seen(plant) == before
    mine.score(until=begin)
    assert seen(plant)[0] == []
