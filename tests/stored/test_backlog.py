"""Two situations in which a channel once became blind: a row of 2099, and a late backlog."""

import math

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.clock import TimeKind
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from harness import Row
from visible import BUCKETS, visible

pytestmark = pytest.mark.thorough

MINUTE = 60_000_000
#: 2026-01-01 and 2099-01-01, in microseconds.
BEGIN, FAR = 1_767_225_600_000_000, 4_070_908_800_000_000
PARAMETERS = gam_db.Parameters(m=2, bins=4, window=60, stride=10)


def rows(first: int, last: int, assets: str = "a", begin: int = 0, step: int = 1) -> list[Row]:
    """Return a row a minute, or a step, of each machine; from 2,301 on the first is broken."""
    return [
        (asset, "x", begin + number * step, math.sin(number / 7) + 5 * (number > 2300 and asset == "a"))
        for asset in assets
        for number in range(first, last)
    ]


def buckets(monitor: Monitor, asset: str) -> int:
    return len([row for row in visible(monitor, BUCKETS) if row["asset"] == asset])


def test_a_live_row_before_the_backlog_of_an_outage_blinds_no_channel(engine: str) -> None:
    """Row 3,000 comes, then 2,000 to 2,869, of which the last are broken; then it goes on."""
    session = engines.session(engine)
    table = scripts.telemetry(session, rows(0, 2000))
    calibration, prefix = gam_db.Calibration(intervals=[(0, 1200)]), engines.fresh_name("backlog")
    source = gam_db.Source(table.name)
    monitor = Monitor(session, source, PARAMETERS, calibration, lookback=60, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    batches = [(3000, 3001), (2000, 2870), (3001, 3011), (3011, 3200)]
    for start, end in batches:
        scripts.arrive(session, table, rows(start, end))
        monitor.score()
    # Of 3,070 rows 1,201 are of calibration; ten vectors are a bucket.
    assert buckets(monitor, "a") == (2000 + 870 + 200 - 1201) // 10
    assert monitor.alarms().num_rows == 1
    assert monitor.check_state().num_rows == 0


def test_a_row_of_2099_blinds_no_channel_and_parks_no_other(
    engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = engines.session(engine)
    now = BEGIN + 2000 * MINUTE
    monkeypatch.setattr(Session, "now", lambda self: now)
    time = session.engine.instant_of(TimeKind.TIMESTAMP, exp.column("time"))
    if engine == "mariadb":
        time = exp.Cast(this=time, to=exp.DataType.build("DATETIME(6)", udt=True))
    table = scripts.telemetry(session, rows(0, 2000, "ab", BEGIN, MINUTE), time)
    calibration, prefix = gam_db.Calibration(duration="1200 min"), engines.fresh_name("ahead")
    monitor = Monitor(session, gam_db.Source(table.name), PARAMETERS, calibration, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    scripts.arrive(session, table, [("a", "x", FAR, 0.1), *rows(2000, 2300, "ab", BEGIN, MINUTE)], time)
    now = BEGIN + 2300 * MINUTE
    assert [(row["asset"], row["ahead_to"]) for row in monitor.score().ahead] == [("a", FAR)]
    scripts.arrive(session, table, rows(2300, 3800, "ab", BEGIN, MINUTE), time)
    now = BEGIN + 3800 * MINUTE
    report = monitor.score()
    assert report.parked == 0
    assert [buckets(monitor, asset) for asset in "ab"] == [(3800 - 1201) // 10] * 2
    status = {row["asset"]: row for row in monitor.status().to_pylist()}
    assert (status["a"]["needs_attention"], status["b"]["needs_attention"]) == (True, False)
    problems = [(row["kind"], row["asset"], row["count"]) for row in monitor.data_problems().to_pylist()]
    assert problems == [("ahead", "a", 1)]
    assert monitor.check_state().num_rows == 0
