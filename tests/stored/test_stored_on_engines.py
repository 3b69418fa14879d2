"""The contract of the stored form on every engine: whatever the batches, the tables of one full run."""

import contextlib
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sqlglot import exp

import comparisons
import engines
import frozen
import gam_db
import harness
import scripts
from batches import KINDS, History, history
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from visible import BUCKETS, NOVEL, STANDING, STILL, CrashError, crashing, visible

#: Histories per engine; each is one of many channels with a series and a lateness of its own. DuckDB has
#: its own, many more, in test_incremental.py.
EXAMPLES = {"duckdb": 1, "sqlite": 2, "postgres": 2, "mariadb": 1, "clickhouse": 2, "spark": 1}


def play(session: Session, table: exp.Table, monitor: Monitor, told: History) -> None:
    """Let a history happen."""
    monitor.migrate()
    monitor.calibrate(limit=told.limit)
    for batch in told.batches:
        if batch.rows:
            scripts.arrive(session, table, batch.rows)
        for kind, number in batch.runs:
            options: dict[str, Any] = {"limit": told.limit}
            if kind in ("full", "everything"):
                options[kind] = True
            if kind != "crash":
                monitor.score(**options)
                continue
            with contextlib.suppress(CrashError):
                monitor.score(on_step=crashing(number), **options)


@pytest.mark.thorough
def test_any_history_ends_in_the_tables_of_one_full_run(engine: str) -> None:
    @settings(max_examples=EXAMPLES[engine])
    @given(kind=st.sampled_from(KINDS), seed=st.integers(0, 2**32))
    def agrees(kind: str, seed: int) -> None:
        told = history(kind, seed)
        parameters, calibration = harness.made(told.parameters, told.calibration)
        session = engines.session(engine)
        table = scripts.telemetry(session, told.first)
        reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
        prefix = engines.fresh_name("state")
        source = gam_db.Source(table.name)
        monitor = Monitor(session, source, parameters, calibration, prefix=prefix, **reach)
        play(session, table, monitor, told)
        asked = (told.first, told.final, parameters, calibration)
        buckets, novel = frozen.buckets(*asked), frozen.novel_cells(*asked)
        harness.assert_same(buckets, visible(monitor, BUCKETS), "buckets")
        harness.assert_same(novel, visible(monitor, NOVEL), "novel cells")
        harness.assert_same(frozen.still_counts(*asked), visible(monitor, STILL), "still samples")
        since = frozen.still_since(*asked)
        for row in visible(monitor, STANDING):
            assert row["still_since"] == since[row["asset"], row["channel"]]
        monitor.prune()
        harness.assert_same(buckets, visible(monitor, BUCKETS), "buckets after pruning")
        harness.assert_same(novel, visible(monitor, NOVEL), "novel cells after pruning")
        comparisons.compared(engine, "stored", told.final, parameters, calibration, told.first)
        # Late rows may change calibration, which stays as it was frozen; nothing that is scored differs.
        assert set(monitor.check_state()["part"].to_pylist()) <= {"calibration"}
        assert monitor.status().num_rows == len({row[:2] for row in told.first})

    agrees()
