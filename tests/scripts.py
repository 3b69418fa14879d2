"""Running the rendered scripts the way a warehouse team does: no Python of ours between the lines."""

import sqlite3
from typing import Any

import duckdb

import gam_db
from harness import Answer, Row, arrow

TABLE = "telemetry"
#: question -> relation of the view form, and its order
RELATIONS = {
    "health_indicator": ("gam_health", "asset, channel, time"),
    "support": ("gam_support_summary", "asset, channel"),
    "certificate": ("gam_certificate", "asset, channel, block"),
}


def on_duckdb(
    rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> dict[str, Answer]:
    """Answer by the scripts on DuckDB: the view form, and under ``exact`` the exact one."""
    source = gam_db.Source(TABLE)
    with duckdb.connect() as connection:
        connection.register("rows", arrow(rows))
        connection.execute(f"CREATE TABLE {TABLE} AS SELECT * FROM rows")
        exact = gam_db.render("exact", "duckdb", source, parameters, calibration)
        found = {"exact": connection.sql(exact).to_arrow_table().to_pylist()}
        connection.execute(gam_db.render("view", "duckdb", source, parameters, calibration))
        for question, (relation, order) in RELATIONS.items():
            answer = connection.sql(f"SELECT * FROM {relation} ORDER BY {order}")
            found[question] = answer.to_arrow_table().to_pylist()
    return found


def on_sqlite(
    rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> dict[str, Answer]:
    """Answer by the same scripts on SQLite, which has no NaN: it keeps one as NULL, as we mean it."""
    source = gam_db.Source(TABLE)
    connection = sqlite3.connect(":memory:", isolation_level=None)
    try:
        connection.execute(f"CREATE TABLE {TABLE} (asset TEXT, channel TEXT, time INTEGER, value REAL)")
        connection.executemany(f"INSERT INTO {TABLE} VALUES (?, ?, ?, ?)", rows)
        exact = gam_db.render("exact", "sqlite", source, parameters, calibration)
        found = {"exact": _fetched(connection, exact)}
        connection.executescript(gam_db.render("view", "sqlite", source, parameters, calibration))
        for question, (relation, order) in RELATIONS.items():
            found[question] = _fetched(connection, f"SELECT * FROM {relation} ORDER BY {order}")
    finally:
        connection.close()
    return found


def _fetched(connection: sqlite3.Connection, query: str) -> list[dict[str, Any]]:
    cursor = connection.execute(query)
    names = [column[0] for column in cursor.description]
    return [dict(zip(names, row, strict=True)) for row in cursor.fetchall()]
