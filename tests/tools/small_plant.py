"""A small plant whose monitor has scored a part of its source: what the tests of faults begin with."""

from typing import Any

import duckdb

import comparisons
import frozen
import gam_db
import harness
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import TABLES
from state_names import called
from strategies import Row
from visible import BUCKETS, NOVEL, put, rows_of

FIRST, LENGTH, LOOKBACK = 120, 300, 7


def readings(start: int, end: int) -> list[Row]:
    """Four channels that repeat a pattern, and later on less so."""
    return [
        (asset, "x", time, float(time % (5 + number) if time % (37 - time // 10 % 30) else time % 11))
        for number, asset in enumerate("abcd")
        for time in range(start, end)
    ]


def source(connection: duckdb.DuckDBPyConnection, rows: list[Row]) -> None:
    connection.execute(
        "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE)"
    )
    put(connection, rows)


def monitor(engine: Any, table: str = "telemetry", prefix: str = "gam_") -> Monitor:
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    calibration = gam_db.Calibration(fraction=0.7)
    place = gam_db.Source(table)
    return Monitor(engine, place, parameters, calibration, lookback=LOOKBACK, prefix=prefix)


def stored(connection: duckdb.DuckDBPyConnection) -> dict[str, list[tuple[Any, ...]]]:
    """Return every row of every state table."""
    query = "SELECT table_name FROM duckdb_tables() WHERE table_name LIKE 'gam%'"
    there = {name for (name,) in connection.execute(query).fetchall()}
    return {
        table: connection.execute(f"FROM {called(table)} ORDER BY ALL").fetchall()
        for table in TABLES
        if called(table) in there
    }


def seen(connection: duckdb.DuckDBPyConnection) -> list[Any]:
    return [rows_of(connection, BUCKETS), rows_of(connection, NOVEL)]


def as_by_reference(connection: duckdb.DuckDBPyConnection) -> None:
    """Compare what is seen with what NumPy makes of all rows that are there."""
    rows = connection.execute("SELECT asset, channel, time, value FROM telemetry").fetchall()
    method = harness.made({"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.7})
    asked = (readings(0, FIRST), rows, *method)
    harness.assert_same(frozen.buckets(*asked), rows_of(connection, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), rows_of(connection, NOVEL), "novel cells")
    comparisons.compared("duckdb", "stored", rows, *method, asked[0])


def whole() -> list[Any]:
    """Return what is seen after one run over everything."""
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        monitor(connection).calibrate()
        put(connection, readings(FIRST, LENGTH))
        monitor(connection).score()
        return seen(connection)


def begin(connection: duckdb.DuckDBPyConnection) -> None:
    source(connection, readings(0, FIRST))
    monitor(connection).migrate()
    monitor(connection).calibrate()
    put(connection, readings(FIRST, 200))
    monitor(connection).score()
    put(connection, readings(200, LENGTH))
