"""A monitor of a source that may be scored as it is stored, compared with the reference."""

from typing import Any

import duckdb

import comparisons
import frozen
import gam_db
import harness
from gam_db.stored.monitor import Monitor
from small_plant import source
from strategies import Row
from visible import BUCKETS, NOVEL, rows_of

LOOKBACK = 12

#: name -> keyword arguments of Parameters
METHODS: dict[str, dict[str, Any]] = {
    "delays": {"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5},
    "neighbours": {"m": 2, "tau": 1, "bins": 4, "window": 20, "stride": 5},
    "one coordinate": {"m": 1, "bins": 5, "window": 12, "stride": 4},
}

RUNS = """
    SELECT asset, channel, from_bucket, read_from, read_to, rows_read, context_rows, context_expected,
        settled_bucket, settled_time, settled_context
    FROM gam_state_run JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
    ORDER BY ALL
"""


def monitor(
    connection: Any, parameters: dict[str, Any], pool: str | None = None, **more: Any
) -> Monitor:
    method = harness.made(parameters, {"fraction": 0.3, "pool": pool})
    return Monitor(connection, gam_db.Source("telemetry"), *method, lookback=LOOKBACK, **more)


def scored(connection: duckdb.DuckDBPyConnection, rows: list[Row], case: str) -> Monitor:
    """Calibrate and score, and compare with the reference."""
    source(connection, rows)
    made = monitor(connection, METHODS[case])
    made.migrate()
    made.calibrate()
    made.score()
    compare(connection, rows, METHODS[case])
    return made


def twice_calibrated(connection: duckdb.DuckDBPyConnection, rows: list[Row], pool: str | None) -> None:
    """Calibrate and score two times; the second supports, and those of a pool, have other numbers."""
    source(connection, rows)
    monitor(connection, METHODS["delays"]).migrate()
    for case in ("neighbours", "delays"):
        made = monitor(connection, METHODS[case], pool)
        made.calibrate()
        made.score()
        older = "version_no < (SELECT MAX(version_no) FROM gam_state_version)"
        connection.execute(f"DELETE FROM gam_state_version WHERE {older}")
        compare(connection, rows, METHODS[case], pool=pool)


def compare(
    connection: duckdb.DuckDBPyConnection,
    rows: list[Row],
    parameters: dict[str, Any],
    first: list[Row] | None = None,
    pool: str | None = None,
) -> None:
    asked = (first or rows, rows, *harness.made(parameters, {"fraction": 0.3, "pool": pool}))
    harness.assert_same(frozen.buckets(*asked), rows_of(connection, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), rows_of(connection, NOVEL), "novel cells")
    comparisons.compared("duckdb", "stored", rows, *asked[2:], asked[0])
