"""The small plant in a PostgreSQL database of its own, and what tests ask of it."""

import itertools
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import psycopg
from psycopg.rows import dict_row

import postgres_server
from gam_db.stored.schema import tables
from small_plant import FIRST, LENGTH, monitor, readings
from state_names import called
from strategies import Row
from visible import BUCKETS, NOVEL

TABLES = [name for name in tables.TABLES if name != "migration"]

_numbers = itertools.count()


def administrator(database: str = "postgres", durable: bool = False) -> Any:
    """Connect as the superuser."""
    return psycopg.connect(postgres_server.server(durable).url_of(database), autocommit=True)


@contextmanager
def database(template: str = "template1", durable: bool = False) -> Iterator[str]:
    """Make a database, a copy of another one, and drop it in the end; give its name."""
    name = f"plant_{os.getpid()}_{next(_numbers)}"
    with administrator(durable=durable) as connection:
        connection.execute(f"CREATE DATABASE {name} TEMPLATE {template}")
    try:
        yield name
    finally:
        with administrator(durable=durable) as connection:
            connection.execute(f"DROP DATABASE {name} WITH (FORCE)")


def put(connection: Any, rows: list[Row]) -> None:
    with connection.cursor() as cursor, cursor.copy("COPY telemetry FROM STDIN") as target:
        for row in rows:
            target.write_row(row)


def source(connection: Any, rows: list[Row]) -> None:
    connection.execute(
        "CREATE TABLE telemetry (asset text, channel text, time bigint, value double precision)"
    )
    put(connection, rows)


def begin(connection: Any) -> None:
    """Score a part of the small plant; then the rest of its rows comes."""
    source(connection, readings(0, FIRST))
    mine = monitor(connection)
    mine.migrate()
    mine.calibrate()
    put(connection, readings(FIRST, 200))
    mine.score()
    mine.close()
    put(connection, readings(200, LENGTH))


def rows_of(connection: Any, query: str) -> list[dict[str, Any]]:
    with connection.cursor(row_factory=dict_row) as cursor:
        found: list[dict[str, Any]] = cursor.execute(query).fetchall()
    return found


def seen(connection: Any) -> list[Any]:
    return [rows_of(connection, BUCKETS), rows_of(connection, NOVEL)]


def stored(connection: Any) -> dict[str, list[tuple[Any, ...]]]:
    """Return every row of every state table."""
    return {
        name: sorted(connection.execute(f"SELECT * FROM {called(name)}").fetchall(), key=repr)
        for name in TABLES
    }
