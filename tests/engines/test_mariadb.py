"""MariaDB's own ways: names of any sign, lent connections, counters without a sign, who is let in."""

import datetime as dt
import subprocess
from collections.abc import Iterator
from typing import Any
from urllib.parse import urlsplit

import pyarrow as pa
import pymysql
import pytest
from typer.testing import CliRunner

import gam_db
import mariadb_server
from gam_db.cli import app
from gam_db.errors import EngineError, SourceError, StatementError
from gam_db.stored.monitor import Monitor
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
        (f"mariadb://nobody@{place.hostname}:{place.port}/plant", "does not admit this user"),
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
        with pytest.raises(EngineError, match="lacks the privilege"):
            monitor.migrate()
    assert asked(plant, "SHOW TABLES") == before
    asked(plant, "DROP USER reader")


def sent(script: str, charset: str) -> "subprocess.CompletedProcess[str]":
    """Run a script by MariaDB's own client, its session being of a character set."""
    place = urlsplit(mariadb_server.server())
    words = [
        "mariadb",
        f"-h{place.hostname}",
        f"-P{place.port}",
        "-uroot",
        f"--default-character-set={charset}",
    ]
    return subprocess.run([*words, "plant"], input=script, capture_output=True, text=True, check=False)


@pytest.fixture
def autumn(plant: Any) -> Iterator[Any]:
    """Two thousand rows over the end of summer time in a TIMESTAMP, and the same in a DATETIME."""
    start = dt.datetime(2026, 10, 24, 22)
    for table, kind in (("shown", "TIMESTAMP"), ("plain", "DATETIME")):
        asked(plant, f"CREATE TABLE {table} (ts {kind} NULL, value DOUBLE)")
        with plant.cursor() as cursor:
            cursor.execute("SET time_zone = '+00:00'")
            rows = [(start + dt.timedelta(minutes=minute), minute * 7 % 11) for minute in range(2000)]
            cursor.executemany(f"INSERT INTO {table} VALUES (%s, %s)", rows)
    yield plant
    made = ", ".join(f"gam_live_{name}" for name in ("channels", "calibration", "bounds", "support"))
    asked(plant, "DROP VIEW IF EXISTS gam_live_health")
    asked(
        plant,
        f"DROP TABLE IF EXISTS {made}, gam_live_support_summary, gam_live_certificate, gam_live_probes, "
        "shown, plain",
    )


@pytest.mark.parametrize("charset", ["latin1", "utf8mb4"])
@pytest.mark.parametrize(
    ("table", "kind"), [("shown", "timestamp with time zone"), ("plain", "timestamp")]
)
def test_a_view_gives_the_same_rows_in_every_zone(
    autumn: Any, table: str, kind: str, charset: str
) -> None:
    source = gam_db.Source(table, None, None, "ts", time_kind=kind)
    parameters = gam_db.Parameters(m=3, tau=1, bins=16, window=200)
    script = gam_db.render("view", "mariadb", source, parameters, gam_db.Calibration(fraction=0.3))
    first = dt.datetime(2026, 10, 25, 8)
    for made_in in ("+00:00", "+05:30"):
        done = sent(f"SET time_zone = '{made_in}';\n{script}", charset)
        assert done.returncode == 0, done.stderr
        for read_in in ("+00:00", "+01:00"):
            asked(autumn, f"SET time_zone = '{read_in}'")
            found = asked(autumn, "SELECT COUNT(*), MIN(time), MAX(time) FROM gam_live_health")
            assert found == ((1400, first, first + dt.timedelta(minutes=1399)),)


@pytest.mark.parametrize("form", ["view", "exact"])
def test_a_script_stops_at_a_column_that_sessions_show_in_their_zone(autumn: Any, form: str) -> None:
    source = gam_db.Source("shown", None, None, "ts", time_kind="timestamp")
    done = sent(gam_db.render(form, "mariadb", source), "utf8mb4")
    assert done.returncode == 1
    assert "ts is a TIMESTAMP, which each session reads in its own zone" in done.stderr
    assert "gam_live_channels" not in str(asked(autumn, "SHOW TABLES"))


@pytest.mark.parametrize("table", ["shown", "plain"])
def test_a_script_for_a_counter_that_is_assumed_stops_at_calendar_time(autumn: Any, table: str) -> None:
    """Else its casts make numbers such as 20261025080000 of the times."""
    done = sent(gam_db.render("view", "mariadb", gam_db.Source(table, None, None, "ts")), "utf8mb4")
    assert done.returncode == 1
    assert "ts is no counter; make the script anew with --time-kind timestamp" in done.stderr
    assert "gam_live_channels" not in str(asked(autumn, "SHOW TABLES"))


def test_the_database_says_of_what_kind_the_column_is(autumn: Any) -> None:
    words = ["--engine", "mariadb", "--database", mariadb_server.server(), "--no-asset", "--no-channel"]
    for table, kind in (("shown", "timestamp with time zone"), ("plain", "timestamp")):
        done = CliRunner().invoke(app, ["compile", table, *words, "--time", "ts", "--value", "value"])
        assert f"-- Time: {kind}." in done.output
        named = [*words[2:], "--time", "ts", "--value", "value"]
        assert CliRunner().invoke(app, ["compile", table, *named]).output == done.output


def test_dates_that_tell_no_instant_are_named_and_left_out(autumn: Any) -> None:
    asked(autumn, "SET sql_mode = ''")
    odd = ("0000-00-00", "2026-00-10", "2026-05-00")
    asked(autumn, "INSERT INTO plain VALUES " + ", ".join(f"('{day}', 1)" for day in odd))
    asked(autumn, "INSERT INTO shown VALUES ('0000-00-00', 1)")
    session = gam_db.connect(mariadb_server.server())
    parameters = gam_db.Parameters(m=2, bins=4, window=20)
    for table, count in (("plain", 3), ("shown", 1)):
        refused = gam_db.Source(table, None, None, "ts")
        pattern = rf"{count} without time \({count} an infinite time or a date that does not exist\)"
        with pytest.raises(SourceError, match=pattern) as caught:
            gam_db.support(refused, parameters, engine=session)
        condition = str(caught.value).partition('where="')[2].partition('"')[0]
        mended = gam_db.Source(table, None, None, "ts", where=condition)
        (row,) = gam_db.support(mended, parameters, engine=session).to_pylist()
        assert row["samples"] == 2000
    session.close()


def test_a_run_counts_dates_that_tell_no_instant(autumn: Any) -> None:
    session = gam_db.connect(mariadb_server.server())
    source = gam_db.Source("plain", None, None, "ts")
    parameters = gam_db.Parameters(m=2, bins=4, window=20)
    with Monitor(session, source, parameters, prefix="odd_") as monitor:
        monitor.migrate()
        monitor.calibrate()
        asked(autumn, "SET sql_mode = ''")
        asked(autumn, "INSERT INTO plain VALUES ('0000-00-00', 1), ('2026-00-10', 1), (NULL, 2)")
        assert monitor.score().undated == 3
    session.close()
