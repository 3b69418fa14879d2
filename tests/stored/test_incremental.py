"""The contract of the stored form: whatever the batches, what is stored equals one full recompute."""

import contextlib
from collections.abc import Iterator
from typing import Any

import duckdb
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import comparisons
import frozen
import gam_db
import harness
from batches import KINDS, History, history
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import TABLES
from state_names import called
from visible import BUCKETS, NOVEL, STANDING, STILL, CrashError, crashing, put, rows_of

#: Histories of each kind; each is one of several channels, whose rows arrive each in their own way.
EXAMPLES, CHANNELS = 4, 130


def play(connection: duckdb.DuckDBPyConnection, monitor: Monitor, history: History) -> None:
    """Let a history happen."""
    # Said here, since Hypothesis draws by the text of the test itself: other draws, fewer comparisons.
    put(connection, history.first)
    monitor.calibrate(limit=history.limit)
    for batch in history.batches:
        put(connection, batch.rows)
        for kind, number in batch.runs:
            options: dict[str, Any] = {"limit": history.limit}
            if kind in ("full", "everything"):
                options[kind] = True
            if kind != "crash":
                monitor.score(**options)
                continue
            with contextlib.suppress(CrashError):
                monitor.score(on_step=crashing(number), **options)


@pytest.fixture(scope="module")
def connection() -> Iterator[duckdb.DuckDBPyConnection]:
    """A database for all histories; each begins from an empty one."""
    with duckdb.connect() as connection:
        connection.execute("SET threads = 1")  # sharing a few rows out takes longer than working on them
        connection.execute(
            "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
        )
        with Monitor(connection, gam_db.Source("telemetry")) as monitor:
            monitor.migrate()
        yield connection


def empty(connection: duckdb.DuckDBPyConnection) -> None:
    """Take back all that a history has left."""
    for table in ("telemetry", *(called(table) for table in TABLES if table != "migration")):
        connection.execute(f"TRUNCATE {table}")


@pytest.mark.parametrize(
    "kind", [KINDS[0], *(pytest.param(kind, marks=pytest.mark.thorough) for kind in KINDS[1:])]
)
@settings(max_examples=max(EXAMPLES, settings().max_examples // 25))
@given(seed=st.integers(0, 2**32))
def test_any_history_ends_in_the_tables_of_one_full_run(
    connection: duckdb.DuckDBPyConnection, kind: str, seed: int
) -> None:
    told = history(kind, seed, CHANNELS)
    parameters, calibration = harness.made(told.parameters, told.calibration)
    empty(connection)
    source = gam_db.Source("telemetry")
    reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
    with Monitor(connection, source, parameters, calibration, **reach) as monitor:
        play(connection, monitor, told)
    asked = (told.first, told.final, parameters, calibration)
    harness.assert_same(frozen.buckets(*asked), rows_of(connection, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), rows_of(connection, NOVEL), "novel cells")
    if kind in ("still samples", KINDS[0]):
        harness.assert_same(frozen.still_counts(*asked), rows_of(connection, STILL), "still samples")
    if kind == "still samples":
        since, told_since = frozen.still_since(*asked), rows_of(connection, STANDING)
        assert told_since
        for row in told_since:
            assert row["still_since"] == since[row["asset"], row["channel"]]
    comparisons.compared("duckdb", "stored", told.final, parameters, calibration, told.first)


def test_there_are_two_thousand_histories() -> None:
    assert len(KINDS) * EXAMPLES * CHANNELS >= 2000
