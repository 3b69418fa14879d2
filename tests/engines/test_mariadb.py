"""MariaDB's own ways: names of any sign, lent connections, counters without a sign, who is let in."""

from collections.abc import Iterator
from typing import Any
from urllib.parse import urlsplit

import pyarrow as pa
import pymysql
import pytest

import gam_db
import mariadb_server
from gam_db.errors import EngineError, SourceError, StatementError
from harness import Row, all_by_engine, all_by_reference, assert_same, made

PARAMETERS = gam_db.Parameters(m=2, bins=4, window=5)
CALIBRATION = gam_db.Calibration(fraction=0.5)
#: What a session sets on a connection, as its owner sees it.
SEEN = (
    "SELECT @@autocommit, @@sql_mode, @@time_zone, @@tx_isolation, @@in_transaction, "
    "@@optimizer_switch, @@character_set_client, @@collation_connection, @@join_buffer_size"
)
HOSTILE = [
    *("a", "A", "a ", "a\\", "a'b", 'q"u', "x`y", "%s", "100%", "é", "e\u0301", "\U0001f600"),
    *("a\tb", "ß", "ss", "{x}", "--", "a_1", "a?1", "\\'"),
]


def opened(**options: Any) -> Any:
    """A connection of PyMySQL to the database of the tests."""
    place = urlsplit(mariadb_server.server())
    return pymysql.connect(
        host=place.hostname, port=place.port, user="root", database="plant", charset="utf8mb4", **options
    )


@pytest.fixture
def plant() -> Iterator[Any]:
    """A connection to a database that holds a small table *telemetry*."""
    connection = opened(autocommit=True)
    with connection.cursor() as cursor:
        cursor.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)")
        rows = [("a", "x", time, float(time * 7 % 4)) for time in range(40)]
        cursor.executemany("INSERT INTO telemetry VALUES (%s, %s, %s, %s)", rows)
    yield connection
    with connection.cursor() as cursor:
        cursor.execute("DROP TABLE IF EXISTS telemetry, counted")
    connection.close()


def asked(connection: Any, statement: str) -> Any:
    with connection.cursor() as cursor:
        cursor.execute(statement)
        return cursor.fetchall()


@pytest.mark.parametrize("column", [0, 1])
def test_names_of_any_sign_are_told_apart(column: int) -> None:
    rows: list[Row] = []
    for place, name in enumerate(HOSTILE):
        key = (name, "x") if column == 0 else ("a", name)
        rows += [(*key, time, float((time * 7 + place) % (4 + place % 3))) for time in range(40)]
    parameters, calibration = made({"m": 2, "bins": 4, "window": 5}, {"fraction": 0.5})
    found = all_by_engine("mariadb", rows, parameters, calibration)
    expected = all_by_reference(rows, parameters, calibration)
    assert len({row[("asset", "channel")[column]] for row in expected["support"]}) == len(HOSTILE)
    for query, answer in expected.items():
        assert_same(answer, found[query], query)


@pytest.mark.parametrize("autocommit", [True, False])
def test_a_lent_connection_is_left_as_it_was(plant: Any, autocommit: bool) -> None:
    with opened(autocommit=autocommit) as mine:
        before = asked(mine, SEEN)
        mine.rollback()
        with gam_db.connect(mine) as session:
            while_used = asked(mine, SEEN)
            found = gam_db.support(gam_db.Source("telemetry"), PARAMETERS, CALIBRATION, session)
            assert found["samples"].to_pylist() == [40]
        assert while_used != before
        assert asked(mine, SEEN) == before


def test_an_open_transaction_is_left_alone(plant: Any) -> None:
    with opened(autocommit=False) as mine:
        asked(mine, "INSERT INTO telemetry VALUES ('b', 'x', 1, 1)")
        before = asked(mine, SEEN)
        with pytest.raises(EngineError, match="transaction open"):
            gam_db.connect(mine)
        assert asked(mine, SEEN) == before
        mine.rollback()
    assert asked(plant, "SELECT COUNT(*) FROM telemetry") == ((40,),)


def test_a_table_that_is_filled_in_part_is_in_nobodys_way(plant: Any) -> None:
    rows = {"asset": ["a"] * 40, "channel": ["x"] * 40, "time": list(range(40))}
    large = pa.table({**rows, "value": pa.array([2**64 - 1] * 40, pa.uint64())})
    good = pa.table({**rows, "value": [float(i * 7 % 4) for i in range(40)]})
    with gam_db.connect(mariadb_server.server()) as session:
        with pytest.raises(StatementError):
            session.load(large)  # the table is there when its first row is refused
        assert gam_db.support(gam_db.Source(good), PARAMETERS, CALIBRATION, session).num_rows == 1


def test_counters_without_a_sign(plant: Any) -> None:
    asked(plant, "CREATE TABLE counted (asset TEXT, channel TEXT, time BIGINT UNSIGNED, value DOUBLE)")
    source, address = gam_db.Source("counted"), mariadb_server.server()
    asked(plant, "INSERT INTO counted SELECT * FROM telemetry")
    found = gam_db.health_indicator(source, PARAMETERS, CALIBRATION, address)
    signed = gam_db.health_indicator(gam_db.Source("telemetry"), PARAMETERS, CALIBRATION, address)
    assert found.num_rows == 20
    assert found == signed
    asked(plant, "INSERT INTO counted VALUES ('a', 'x', 9223372036854775809, 1)")
    with pytest.raises(SourceError, match=r"beyond 2\^62"):
        gam_db.health_indicator(source, PARAMETERS, CALIBRATION, address)


def test_who_is_not_let_in_is_told(plant: Any) -> None:
    place = urlsplit(mariadb_server.server())
    for address, message in (
        (f"mariadb://nobody@{place.hostname}:{place.port}/plant", "let this user in"),
        (f"mariadb://root@{place.hostname}:{place.port}/other", "no such database"),
        (f"mariadb://root@{place.hostname}:{place.port}/plant?ssl=1", "open connection"),
        (f"mariadb://root@{place.hostname}:port/plant", "a port is a number"),
    ):
        with pytest.raises(EngineError, match=message):
            gam_db.connect(address)


def test_a_user_who_may_only_read_leaves_nothing_half_made(plant: Any) -> None:
    before = asked(plant, "SHOW TABLES")
    asked(plant, "CREATE OR REPLACE USER reader IDENTIFIED BY ''")
    asked(plant, "GRANT SELECT ON plant.telemetry TO reader")
    place = urlsplit(mariadb_server.server())
    address = f"mariadb://reader@{place.hostname}:{place.port}/plant"
    with gam_db.connect(address) as session:
        monitor = gam_db.Monitor(session, gam_db.Source("telemetry"), PARAMETERS)
        with pytest.raises(EngineError, match="no right"):
            monitor.migrate()
    assert asked(plant, "SHOW TABLES") == before
    asked(plant, "DROP USER reader")
