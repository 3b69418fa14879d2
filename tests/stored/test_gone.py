"""Rows that leave the source: what is stored of them stays, and scoring goes on."""

from typing import Any

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.errors import ParameterError
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


def leave(monitor: Monitor, table: exp.Table, until: int) -> None:
    """Let all rows before an instant leave the source."""
    names = list(monitor.session.describe(table))
    asset, channel, time = (exp.column(exp.to_identifier(name)) for name in names[:3])
    rows = exp.select(asset, channel, time).from_(table).where(time.copy() < until)
    monitor.session.delete(table, names[:3], rows)


def buckets(monitor: Monitor) -> list[dict[str, Any]]:
    return [
        {name: row[name] for name in ("asset", "bucket", "first_tick", "last_tick", "novel_in_window")}
        for row in monitor.health().to_pylist()
    ]


@pytest.mark.full
def test_what_is_gone_stays_and_is_no_difference(engine: str) -> None:
    """Buckets of 4 end at 83, 87, .. 119; that of 103 has its context, 2 samples, from 102 on."""
    monitor, table = made(engine, "ab", 120)
    before = buckets(monitor)
    assert len(before) == 20
    leave(monitor, table, 101)
    found = monitor.checked_state()
    assert found.differences.to_pylist() == []
    told = {(row["part"], row["why"], row["until"]) for row in found.uncompared.to_pylist()}
    gone = "gone from the source"
    assert told == {("calibration", gone, 101), ("scored", gone, 101)}
    monitor.score(everything=True)
    assert buckets(monitor) == before
    remarks = monitor.status()["remarks"].to_pylist()
    assert all("calibration, up to 79, is gone from the source" in " ".join(said) for said in remarks)
    # Buckets 0 to 5 of both cannot be made again; 90 lies in bucket 2.
    with pytest.raises(ParameterError, match="remove 12 stored buckets"):
        monitor.score(full=True)
    with pytest.raises(ParameterError, match="remove 8 stored buckets"):
        monitor.score(since=90)
    assert buckets(monitor) == before
    monitor.score(since=104)
    assert buckets(monitor) == before
    # A value that is corrected where rows are still there is found all the same.
    scripts.arrive(monitor.session, table, [("a", "x", 110, 0.0)])
    differing = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in differing] == [("a", "scored")]
    monitor.score(full=True, confirm=True)
    assert {row["first_tick"] for row in buckets(monitor) if row["bucket"] == 0} == {103}


@pytest.mark.full
def test_a_hole_is_no_retention(engine: str) -> None:
    monitor, table = made(engine, "a", 120)
    names = list(monitor.session.describe(table))
    time = exp.column(exp.to_identifier(names[2]))
    rows = exp.select(*map(exp.column, names[:3])).from_(table).where(exp.and_(time > 0, time < 101))
    monitor.session.delete(table, names[:3], rows)
    found = monitor.checked_state()
    assert "scored" in found.differences["part"].to_pylist()
    assert "gone from the source" not in found.uncompared["why"].to_pylist()


@pytest.mark.full
def test_a_machine_that_stood_longer_than_rows_are_kept_is_scored_on(engine: str) -> None:
    """It was scored up to 119, and comes back at 1000, when nothing before 900 is left."""
    monitor, table = made(engine, "ab", 120)
    before = buckets(monitor)
    scripts.arrive(monitor.session, table, [*series("b", 120, 122), *series("b", 950, 1000)])
    monitor.score()
    leave(monitor, table, 900)
    scripts.arrive(monitor.session, table, series("a", 1000, 1031))
    monitor.score()
    now = [row for row in buckets(monitor) if row["asset"] == "a"]
    old = [row for row in before if row["asset"] == "a"]
    assert now[: len(old)] == old, "what is stored stays"
    # 31 samples fill 29 vectors of 3 samples, the first at 1002: 7 full buckets.
    assert [row["first_tick"] for row in now[len(old) :]] == list(range(1002, 1030, 4))
    assert [row["bucket"] for row in now] == list(range(17))
    said = {row["asset"]: row for row in monitor.status().to_pylist()}
    assert said["a"]["differing_contexts"] == 0
    assert any("are gone from the source" in remark for remark in said["a"]["remarks"])
    assert monitor.check_state().num_rows == 0
    scripts.arrive(monitor.session, table, series("a", 1031, 1050))
    monitor.score()
    assert len([row for row in buckets(monitor) if row["asset"] == "a"]) == 10 + 48 // 4
    assert monitor.check_state().num_rows == 0
