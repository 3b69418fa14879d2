"""The stored form of calendar time, in each type of each engine: the integers of a counter.

What is read within the lookback, and what comes late, is asked for by bounds of the column's own type.
"""

import datetime as dt

import pytest
from sqlglot import exp

import comparisons
import engines
import frozen
import gam_db
import harness
import scripts
from gam_db.clock import TimeKind
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from harness import Row
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

#: engine -> types of its columns of times, and of what kind they are.
TYPES: dict[str, dict[str, TimeKind]] = {
    "duckdb": {
        "TIMESTAMP": TimeKind.TIMESTAMP,
        "TIMESTAMPTZ": TimeKind.TIMESTAMP_WITH_ZONE,
        "TIMESTAMP_S": TimeKind.TIMESTAMP,
        "TIMESTAMP_MS": TimeKind.TIMESTAMP,
        "TIMESTAMP_NS": TimeKind.NANOSECONDS,
        "TIMESTAMPTZ_NS": TimeKind.NANOSECONDS_WITH_ZONE,
    },
    "sqlite": {"TEXT": TimeKind.TIMESTAMP},
    "postgres": {
        "TIMESTAMP": TimeKind.TIMESTAMP,
        "TIMESTAMP(0)": TimeKind.TIMESTAMP,
        "TIMESTAMPTZ": TimeKind.TIMESTAMP_WITH_ZONE,
    },
    "mariadb": {"DATETIME(6)": TimeKind.TIMESTAMP, "DATETIME": TimeKind.TIMESTAMP},
    "clickhouse": {
        "DateTime": TimeKind.TIMESTAMP,
        "DateTime64(9, 'Europe/Berlin')": TimeKind.NANOSECONDS_WITH_ZONE,
    },
    "spark": {"TIMESTAMP_NTZ": TimeKind.TIMESTAMP, "TIMESTAMP": TimeKind.TIMESTAMP_WITH_ZONE},
}

METHOD = harness.made({"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.7})
SECOND = 1_000_000
BEGIN = 1_793_000_000 * SECOND


def readings(start: int, end: int) -> list[Row]:
    """Channels of a sample a second that repeat a pattern, and later on less so."""
    return [
        (asset, "x", BEGIN + time * SECOND, float(time % (5 + number) if time % 37 < 20 else time % 11))
        for number, asset in enumerate("ab")
        for time in range(start, end)
    ]


def told(session: Session, of_type: str) -> exp.Expr:
    """Return the time of a row as a column of a type tells it."""
    instant = session.engine.instant_of(TYPES[session.engine.name][of_type], exp.column("time"))
    return exp.Cast(
        this=instant, to=exp.DataType.build(of_type, dialect=session.engine.dialect, udt=True)
    )


def test_it_ends_in_the_tables_of_a_counter(engine: str) -> None:
    for of_type in TYPES[engine]:
        monitor = scored(engines.session(engine), of_type)
        first, final = readings(0, 120), readings(0, 260)
        expected = frozen.buckets(first, final, *METHOD), frozen.novel_cells(first, final, *METHOD)
        harness.assert_same(expected[0], visible(monitor, BUCKETS), f"buckets, {of_type}")
        harness.assert_same(expected[1], visible(monitor, NOVEL), f"novel cells, {of_type}")
        assert not monitor.check_state().num_rows, of_type
        comparisons.compared(engine, "stored", final, *METHOD, first)


def scored(session: Session, of_type: str) -> Monitor:
    """Return a monitor that has scored two batches; a row of the first came with the second."""
    time = told(session, of_type)
    table = scripts.telemetry(session, readings(0, 120), time)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("state")
    monitor = Monitor(session, source, *METHOD, lookback=dt.timedelta(seconds=30), prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    late = readings(195, 196)
    for rows in (readings(120, 195) + readings(196, 200), late + readings(200, 260)):
        scripts.arrive(session, table, rows, time)
        monitor.score()
    return monitor
