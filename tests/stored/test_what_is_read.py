"""What a run reads of its source is bounded: each engine says so of the statement that reads it."""

import json
import re
from collections.abc import Callable

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from test_views import scanned

#: Rows of each channel before the run, and those that are new then.
BEFORE, NEW = 2_000, 40

PARAMETERS = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5, range="min_max")
CALIBRATION = gam_db.Calibration(intervals=[(0, 200)])

Rows = list[tuple[str, str, int, float]]


def rows(start: int, end: int) -> Rows:
    return [
        (asset, "x", time, float(time % 5))
        for time in range(start, end)
        for asset in ("a", "b", "c", "d")
    ]


def indexed(session: Session, table: exp.Table) -> None:
    """Let the engine find rows by time, as a team would; ClickHouse and Spark are told as they store."""
    name = session.engine.text(table)
    if session.engine.name in ("sqlite", "postgres", "mariadb"):
        session.driver.execute(f"CREATE INDEX {table.name}_time ON {name} (time)")
    if session.engine.name == "clickhouse":
        session.driver.execute(
            f"CREATE TABLE {table.name}_sorted ENGINE = MergeTree ORDER BY time "
            f"SETTINGS index_granularity = 128, allow_nullable_key = 1 AS SELECT * FROM {name}"
        )
        session.driver.execute(f"EXCHANGE TABLES {name} AND {table.name}_sorted")
    if session.engine.name in ("postgres", "mariadb"):
        session.driver.execute(
            {"postgres": "ANALYZE", "mariadb": "ANALYZE TABLE"}[session.engine.name] + f" {name}"
        )


def said(session: Session, statement: str) -> str:
    """Return the rows of an EXPLAIN as one text, a line each."""
    found = session.driver.fetch(statement).to_pylist()
    return "\n".join(" ".join(f"{name}={value}" for name, value in row.items()) for row in found)


def assert_bounded(session: Session, table: str, query: str) -> None:
    """Fail unless the engine's plan of a query reads a part of a table."""
    name = session.engine.name
    if name == "duckdb":
        plan = said(session, f"EXPLAIN (ANALYZE, FORMAT JSON) {query}").partition("explain_value=")[2]
        (from_table,) = scanned(json.loads(plan)["operator"], table)
        assert 0 < from_table <= 4 * (NEW + 60)
    elif name == "sqlite":
        assert f"SEARCH {table} USING INDEX {table}_time (time>?" in said(
            session, f"EXPLAIN QUERY PLAN {query}"
        )
    elif name == "postgres":
        plan = said(session, f"EXPLAIN {query}")
        assert f"{table}_time" in plan
        assert 'Index Cond: (("time" >=' in plan or 'Index Cond: ("time" >=' in plan
    elif name == "mariadb":
        plan = said(session, f"EXPLAIN {query}")
        (line,) = (line for line in plan.splitlines() if f"table={table}" in line)
        assert f"type=range possible_keys={table}_time key={table}_time" in line
    elif name == "clickhouse":
        plan = said(session, f"EXPLAIN indexes = 1 {query}")
        read, there = re.findall(r"Granules: (\d+)/(\d+)", plan)[-1]
        assert 0 < int(read) <= int(there) / 8
    else:
        plan = said(session, f"EXPLAIN {query}")
        assert "GreaterThanOrEqual(time," in plan


@pytest.mark.thorough
def test_a_run_reads_a_part_of_its_source(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    session = engines.session(engine)
    table = scripts.telemetry(session, rows(0, BEFORE))
    indexed(session, table)
    prefix = engines.fresh_name("state")
    source = gam_db.Source(table.name)
    monitor = Monitor(session, source, PARAMETERS, CALIBRATION, lookback=20, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    scripts.arrive(session, table, rows(BEFORE, BEFORE + NEW))
    reading = "readings" if session.engine.reads_first else "identified"
    keep: Callable[..., exp.Table] = Session.keep
    looked = []

    def noted(self: Session, step: str, query: exp.Query) -> exp.Table:
        if step in ("names", reading):
            assert_bounded(session, table.name, session.engine.text(query))
            looked.append(step)
        return keep(self, step, query)

    monkeypatch.setattr(Session, "keep", noted)
    report = monitor.score()
    assert looked == ["names", reading]
    assert 4 * NEW <= sum(row["rows_read"] for row in report.channels) <= 4 * (NEW + 60)
