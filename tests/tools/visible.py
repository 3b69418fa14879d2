"""What a reader of the stored form sees, as plain rows; and a run that ends where it is told to."""

from typing import Any

import duckdb
import sqlglot
from sqlglot import exp

import harness
from gam_db.composing.pipeline import place
from gam_db.stored.monitor import Monitor
from state_names import called
from strategies import Row

BUCKETS = """
    SELECT asset, channel, bucket_no AS bucket, first_time, last_time, context_time, samples, novel,
        out_of_range, novel_in_window
    FROM gam_state_visible_bucket JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel, bucket_no
"""
NOVEL = """
    SELECT asset, channel, bucket_no AS bucket, cell_key, visits, first_time, last_time
    FROM gam_state_visible_novel JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel, bucket_no, cell_key
"""
STILL = """
    SELECT asset, channel, bucket_no AS bucket, still
    FROM (SELECT version_id, bucket_no, run_id FROM gam_state_visible_bucket) AS seen
    JOIN gam_state_bucket USING (version_id, bucket_no, run_id)
    JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel, bucket_no
"""
STANDING = """
    SELECT asset, channel, still_since
    FROM (
        SELECT version_id, MAX(run_id) AS run_id FROM gam_state_finished_run
        WHERE settled_bucket IS NOT NULL GROUP BY version_id
    ) AS newest JOIN gam_state_run USING (version_id, run_id)
    JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)
    ORDER BY asset, channel
"""


class CrashError(Exception):
    """What stands for the end of a process."""


def crashing(after: int) -> Any:
    """Return a listener that gives up at its so-manieth step."""
    heard = 0

    def listen(_: str) -> None:
        nonlocal heard
        heard += 1
        if heard >= after:
            raise CrashError

    return listen


def rows_of(connection: duckdb.DuckDBPyConnection, query: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = connection.sql(query).to_arrow_table().to_pylist()
    return found


def put(connection: duckdb.DuckDBPyConnection, rows: list[Row]) -> None:
    loaded = harness.arrow(rows)
    connection.register("arriving", loaded)
    connection.execute("INSERT INTO telemetry SELECT * FROM arriving").fetchall()
    connection.unregister("arriving")


def visible(monitor: Monitor, query: str) -> list[dict[str, Any]]:
    """Return rows of the state, by a query that names tables as DuckDB's tests do."""
    tree = sqlglot.parse_one(query, dialect="duckdb")
    placed = {called(name): table for name, table in _tables(monitor).items()}
    place(tree, placed)
    found: list[dict[str, Any]] = monitor.session.fetch(tree).to_pylist()
    return found


def _tables(monitor: Monitor) -> dict[str, exp.Table]:
    return {name.removeprefix("stored_"): table for name, table in monitor.state.tables.nodes().items()}
