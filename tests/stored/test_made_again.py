"""The check of a state makes all of it again beside it: rows that were never made are found, too."""

from typing import Any

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.stored.monitor import Monitor
from strategies import Row

PARAMETERS = gam_db.Parameters(m=2, tau=2, bins=4, window=8, stride=4)
LOOKBACK = 6
CALIBRATED = 79


def series(asset: str, start: int, end: int) -> list[Row]:
    """A channel that repeats a pattern in calibration, and another one later."""
    return [
        (asset, "x", time, float(time % 5 if time <= CALIBRATED else time % 7))
        for time in range(start, end)
    ]


def made(engine: str, assets: str, end: int) -> tuple[Monitor, exp.Table]:
    """A monitor that is calibrated and scored once."""
    session = engines.session(engine)
    table = scripts.telemetry(session, [row for asset in assets for row in series(asset, 0, end)])
    calibration = gam_db.Calibration(intervals=[(0, CALIBRATED)])
    reach: dict[str, Any] = {"lookback": LOOKBACK, "prefix": engines.fresh_name("state")}
    monitor = Monitor(session, gam_db.Source(table.name), PARAMETERS, calibration, **reach)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    return monitor, table


def taken(monitor: Monitor, table: str, condition: str) -> None:
    """Delete rows of a state table, as somebody might by hand."""
    node = monitor.state.tables.table(table)
    rows = exp.select("version_id", "bucket_no").from_(node).where(condition)
    monitor.session.delete(node, ["version_id", "bucket_no"], rows)


def found(monitor: Monitor) -> set[tuple[str, str]]:
    return {(row["asset"], row["part"]) for row in monitor.check_state().to_pylist()}


@pytest.mark.full
def test_buckets_that_are_missing_are_found(engine: str) -> None:
    """At the end, in the middle, and of a whole channel; 120 - 80 vectors are 10 buckets of each."""
    monitor, _ = made(engine, "abcd", 120)
    assert monitor.health().num_rows == 40
    assert found(monitor) == set()
    known = monitor.state.rows("stored/state/active", {"monitor_id": 1})
    number = {row["asset"]: row["version_id"] for row in known}
    for table in ("bucket", "novel"):
        taken(monitor, table, f"version_id = {number['a']} AND bucket_no >= 6")
        taken(monitor, table, f"version_id = {number['b']} AND bucket_no IN (3, 4)")
        taken(monitor, table, f"version_id = {number['c']}")
    told = monitor.check_state().to_pylist()
    scored = {row["asset"]: row for row in told if row["part"] == "scored"}
    assert {asset: row["differing"] for asset, row in scored.items()} == {"a": 4, "b": 2, "c": 10}
    # A bucket begins with the newest sample of its first vector: 80, and 4 later each.
    assert {asset: row["since"] for asset, row in scored.items()} == {"a": 104, "b": 92, "c": 80}
    assert "d" not in {row["asset"] for row in told}
    monitor.score(full=True)
    assert found(monitor) == set()


def test_a_backlog_that_no_run_read_is_missed() -> None:
    """A run has read up to 300; what came later of the time before it is not scored."""
    monitor, table = made("duckdb", "a", 120)
    scripts.arrive(monitor.session, table, series("a", 300, 301))
    monitor.score()
    assert found(monitor) == set()
    scripts.arrive(monitor.session, table, series("a", 120, 250))
    told = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in told] == [("a", "scored")]
    # 130 vectors more are 32 full buckets; the first begins at 120.
    assert (told[0]["differing"], told[0]["since"]) == (32, 120)


def test_a_channel_that_the_last_run_left_out_is_missed() -> None:
    monitor, table = made("duckdb", "ab", 120)
    scripts.arrive(monitor.session, table, [*series("a", 120, 160), *series("b", 120, 160)])
    left = monitor.checked_state()
    assert left.differences.num_rows == 0, "both are the next run's"
    assert set(left.uncompared["why"].to_pylist()) == {"left to the next run"}
    assert left.uncompared["since"].to_pylist() == [119, 119]
    monitor.score(asset="a")
    told = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"], row["differing"]) for row in told] == [("b", "scored", 10)]
    monitor.score()
    assert found(monitor) == set()


def test_a_backlog_is_missed_where_the_newest_bucket_ends_after_it() -> None:
    """Three vectors and the row of 300 fill a bucket; what comes before that row came too late."""
    monitor, table = made("duckdb", "a", 123)
    scripts.arrive(monitor.session, table, series("a", 300, 301))
    monitor.score()
    scripts.arrive(monitor.session, table, series("a", 123, 250))
    told = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in told] == [("a", "scored")]
    # Of 170 vectors before 300 there are 42 full buckets; the first 10 are as they were.
    assert (told[0]["differing"], told[0]["since"]) == (32, 120)
