"""Work on PostgreSQL that is stopped: the server stops as well, and it is told in one line."""

import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from typing import Any

import psycopg
import pytest

from small_postgres import administrator, database

GAM = (sys.executable, "-c", "from gam_db.cli import main; main()")

#: Sleeps for each row; a statement over all of them takes minutes.
SLOW = "pg_catalog.pg_sleep(0.2) IS NOT NULL"


@pytest.fixture
def plant() -> Iterator[tuple[str, Any]]:
    with database() as name, administrator(name) as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT 'a' AS asset, 'x' AS channel, t AS time, "
            "CAST(t % 7 AS double precision) AS value FROM generate_series(1, 900) AS t"
        )
        yield name, connection


def begun(name: str, plant: Any, *words: str) -> "subprocess.Popen[str]":
    """Begin a run, and wait until the server sleeps for it."""
    info = plant.info
    address = f"postgresql://{info.user}@{info.host}:{info.port}/{name}"
    process = subprocess.Popen(
        [
            *GAM,
            "run",
            "telemetry",
            "--database",
            address,
            "--where",
            SLOW,
            "--where-any",
            "--no-out",
            *words,
        ],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    until = time.monotonic() + 60
    while not sleeping(plant) and process.poll() is None and time.monotonic() < until:
        time.sleep(0.05)
    if not sleeping(plant):
        process.kill()
        pytest.fail(f"it never came to the server: {process.communicate()}")
    return process


def sleeping(plant: "psycopg.Connection[Any]") -> int:
    """How many statements of others sleep on the server."""
    query = (
        "SELECT count(*) FROM pg_stat_activity WHERE state = 'active' AND query LIKE '%pg_sleep%' "
        "AND pid <> pg_backend_pid()"
    )
    ((found,),) = plant.execute(query).fetchall()
    return int(found)


def test_control_c_stops_the_statement_on_the_server(plant: tuple[str, Any]) -> None:
    name, connection = plant
    process = begun(name, connection)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=30)
    assert process.returncode == 130
    assert told == "gam: interrupted; no file was left half written.\n"
    assert sleeping(connection) == 0


def test_so_does_a_limit_of_time(plant: tuple[str, Any]) -> None:
    name, connection = plant
    process = begun(name, connection, "--timeout", "8")
    _, told = process.communicate(timeout=60)
    assert process.returncode == 75
    assert told.startswith("gam: It took longer than --timeout 8")
    assert told.count("\n") == 1
    assert sleeping(connection) == 0


def test_a_server_that_ends_the_connection_is_told_to_be_asked_again(plant: tuple[str, Any]) -> None:
    name, connection = plant
    process = begun(name, connection)
    connection.execute(
        "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE query LIKE '%pg_sleep%' "
        "AND pid <> pg_backend_pid()"
    )
    _, told = process.communicate(timeout=30)
    assert process.returncode == 75
    assert told.startswith("gam: The connection to PostgreSQL was lost")
    assert told.count("\n") == 1
