"""PostgreSQL's own ways: who is let in, what is refused and how it is said."""

import contextlib
import dataclasses
import sys
import traceback
from collections.abc import Iterator
from typing import Any

import psycopg
import pytest
import sqlglot
from psycopg.rows import dict_row
from sqlglot import exp

import gam_db
import postgres_server
from gam_db.engines.postgres import ENGINE, ROOM
from gam_db.engines.postgres import driver as postgres_driver
from gam_db.engines.postgres import refusals as postgres_refusals
from gam_db.errors import EngineError, SourceError, UserError
from gam_db.settings.source import Source
from small_plant import monitor, readings, whole
from small_postgres import administrator, begin, database, rows_of, seen, source, stored

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=3, window=4, stride=2)
CALIBRATION = gam_db.Calibration(fraction=0.5)


@pytest.fixture
def name() -> Iterator[str]:
    with database() as made:
        yield made


@pytest.fixture
def plant(name: str) -> Iterator[Any]:
    """A connection to a database that holds the small plant, partly scored."""
    with administrator(name) as connection:
        begin(connection)
        yield connection


@pytest.fixture
def connection(name: str) -> Iterator[Any]:
    """A connection to an empty database."""
    with administrator(name) as opened:
        yield opened


def url(name: str, user: str | None = None, **settings: str) -> str:
    said = "%20".join(f"-c%20{key}%3D{value}" for key, value in settings.items())
    return postgres_server.server().url_of(name, user) + f"?options={said}" * bool(said)


# Who is let in


@pytest.fixture
def walled() -> Iterator[None]:
    """A user who needs a password, where others need none."""
    server = postgres_server.server()
    rules = server.folder / "data" / "pg_hba.conf"
    before = rules.read_text()
    with administrator() as connection:
        connection.execute("CREATE ROLE walled LOGIN PASSWORD 'right secret'")
        rules.write_text(f"host all walled 127.0.0.1/32 scram-sha-256\n{before}")
        connection.execute("SELECT pg_reload_conf()")
        yield
        rules.write_text(before)
        connection.execute("SELECT pg_reload_conf()")
        connection.execute("DROP ROLE walled")


@pytest.mark.usefixtures("walled")
def test_a_password(monkeypatch: pytest.MonkeyPatch) -> None:
    address = postgres_server.server().url_of("postgres", "walled")
    with pytest.raises(
        EngineError, match=(r"needs a password; set PGPASSWORD, or write the " r"password into")
    ):
        gam_db.connect(address)
    wrong = address.replace("walled@", "walled:wrong%20secret@")
    with pytest.raises(EngineError, match="does not accept this user and password") as refused:
        gam_db.connect(wrong)
    assert "secret" not in "".join(traceback.format_exception(refused.value))
    monkeypatch.setenv("PGPASSWORD", "right secret")
    with gam_db.connect(address) as session:
        assert session.engine.name == "postgres"


@pytest.mark.parametrize(
    ("address", "message"),
    [
        ("postgresql://gam:secret@{0}/nowhere", "has no such database"),
        ("postgresql://nobody:secret@{0}/postgres", "has no such user"),
        ("postgresql://gam:secret@127.0.0.1:1/postgres", "does not answer: is it running"),
        ("postgresql://gam:secret@no.host.invalid/postgres", "host name .* cannot be resolved"),
        ("postgresql://gam:se@cret@{0}/postgres", "write %40 for @"),
        ("postgresql://gam:se/cret@{0}/postgres", "%2F for /"),
        ("postgresql://gam:secret@{0}/postgres?sslmod=1", "PostgreSQL does not understand the address"),
        ("postgresql://gam:secret@{0}/postgres?sslmode=require", "do not agree on encryption"),
    ],
)
def test_an_address_that_leads_nowhere(address: str, message: str) -> None:
    server = postgres_server.server()
    with pytest.raises(EngineError, match=message) as refused:
        gam_db.connect(address.format(f"{server.host}:{server.port}"))
    shown = "".join(traceback.format_exception(refused.value))
    assert "cret" not in shown.replace("import secrets", "")
    assert "\n" not in str(refused.value)


def test_without_the_driver(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "psycopg", None)
    with pytest.raises(EngineError, match=r'pip install "gam-db\[postgres\]"'):
        gam_db.connect("postgresql:///plant")


def test_an_old_server(monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    monkeypatch.setattr(postgres_driver, "ENGINE", dataclasses.replace(ENGINE, oldest="99"))
    with pytest.raises(EngineError, match=r"^PostgreSQL \d+ is too old; gam-db needs PostgreSQL 99"):
        gam_db.connect(url(name))


# The user's open connection


@pytest.mark.parametrize("autocommit", [True, False])
def test_an_open_connection_stays_as_it_was(plant: Any, autocommit: bool) -> None:
    zone, idle = "Asia/Kolkata", psycopg.pq.TransactionStatus.IDLE
    with psycopg.connect(url(plant.info.dbname), row_factory=dict_row) as mine:
        mine.execute(f"SET TimeZone = '{zone}'")
        mine.commit()
        mine.autocommit = autocommit
        with gam_db.connect(mine) as session:
            monitor(session).score()
            assert mine.info.transaction_status == idle
        settings = mine.execute(
            "SELECT current_setting('TimeZone') AS zone, current_setting('enable_nestloop') AS nested"
        ).fetchall()
        assert settings == [{"zone": zone, "nested": "on"}]
        assert mine.autocommit is autocommit
        tables = mine.execute("SELECT 1 FROM pg_class WHERE relpersistence = 't'").fetchall()
        assert tables == []
    assert seen(plant) == whole()


@pytest.mark.parametrize(
    ("given", "room"), [("4MB", ROOM), ("64kB", ROOM), ("128MB", 2 * ROOM), ("1000000kB", 1_000_000)]
)
def test_a_step_that_is_kept_has_room(name: str, given: str, room: int) -> None:
    """At least so much, never less than the user gave, and for that statement alone."""
    setting = """
    SELECT setting::bigint AS kb FROM "pg_catalog"."pg_settings" WHERE name = 'work_mem'
    """
    with psycopg.connect(url(name)) as mine:
        with gam_db.connect(mine) as session:
            mine.execute(f"SET work_mem = '{given}'")  # after the session began
            before = mine.execute(setting).fetchall()
            kept = session.keep("room", sqlglot.parse_one(setting, dialect="postgres", into=exp.Select))
            assert session.rows(exp.select("kb").from_(kept)) == [{"kb": room}]
            assert session.engine.most_in_set is not None
            assert session.rows(session.engine.most_in_set) == [{"most": room * 16}]
            assert mine.execute(setting).fetchall() == before
        assert mine.execute(setting).fetchall() == before


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"jit": "on"}, "off"),
        ({"jit": "on", "jit_above_cost": "1"}, "on"),
        ({"jit": "on", "jit_above_cost": "-1"}, "off"),
        ({"jit": "off", "jit_above_cost": "1"}, "off"),
    ],
)
@pytest.mark.parametrize("is_lent", [True, False])
def test_only_a_long_step_is_translated(
    name: str, given: dict[str, str], said: str, is_lent: bool
) -> None:
    """On a server that does so, from the cost on that is set there; a sort that is off is no cost."""
    asked = """
    SELECT setting AS jit FROM "pg_catalog"."pg_settings" WHERE name = 'jit' ORDER BY setting
    """
    query = sqlglot.parse_one(asked, dialect="postgres", into=exp.Select)
    with contextlib.ExitStack() as stack:
        target: Any = url(name, **given)
        if is_lent:
            target = stack.enter_context(psycopg.connect(target))
        with gam_db.connect(target) as session:
            kept = session.keep("translated", query)
            assert session.rows(exp.select("jit").from_(kept)) == [{"jit": said}]
            assert session.rows(query) == [{"jit": "off"}]
        if is_lent:
            assert target.execute(asked).fetchall() == [(given["jit"],)]


def test_a_transaction_of_the_user_survives(connection: Any) -> None:
    with psycopg.connect(url(connection.info.dbname)) as mine:
        source(mine, readings(0, 50))
        with gam_db.connect(mine) as session:
            seen_inside = gam_db.health_indicator(Source("telemetry"), PARAMETERS, CALIBRATION, session)
            assert seen_inside.num_rows > 0
            where = Source("telemetry", where="no_such_column > 0")
            with pytest.raises(SourceError, match="no_such_column"):
                gam_db.health_indicator(where, PARAMETERS, CALIBRATION, session)
            with pytest.raises(EngineError, match="has a transaction open; commit it or roll it back"):
                monitor(session).migrate()
        assert mine.info.transaction_status == psycopg.pq.TransactionStatus.INTRANS
        mine.commit()
        with pytest.raises(psycopg.Error):
            mine.execute("SELECT 1 / 0")
        with pytest.raises(EngineError, match="in a failed transaction"):
            gam_db.connect(mine)
    assert rows_of(connection, "SELECT count(*) AS n FROM telemetry") == [{"n": 200}]
    with pytest.raises(EngineError, match=r"^The connection to PostgreSQL is closed"):
        gam_db.connect(mine)


# Privileges


@pytest.fixture
def worker(name: str) -> Iterator[str]:
    """A user without any privilege but to connect."""
    with administrator(name) as connection:
        connection.execute("CREATE ROLE worker LOGIN")
        connection.execute(f"REVOKE ALL ON DATABASE {name} FROM PUBLIC")
        connection.execute(f"GRANT CONNECT ON DATABASE {name} TO worker")
        yield url(name, "worker")
        connection.execute("DROP OWNED BY worker")
        connection.execute("DROP ROLE worker")


def test_what_a_user_lacks_is_named(worker: str, connection: Any) -> None:
    """Each privilege that a message names is granted, until nothing is refused any more."""
    source(connection, readings(0, 120))
    granted: list[str] = []
    for _ in range(10):
        try:
            with gam_db.connect(worker) as session:
                mine = monitor(session)
                mine.check()
                mine.migrate()
                mine.calibrate()
                mine.score()
            break
        except EngineError as error:
            said = str(error)
            assert said.startswith("This PostgreSQL user lacks a privilege: GRANT ")
            grant = said.partition(": ")[2].replace(" TO it.", "")
            granted.append(grant.replace(connection.info.dbname, "plant"))
            connection.execute(f"{grant} TO worker")
    assert granted == [
        "GRANT TEMPORARY ON DATABASE plant",
        "GRANT SELECT ON TABLE telemetry",
        "GRANT CREATE ON SCHEMA public",
    ] or granted == [
        "GRANT SELECT ON TABLE telemetry",
        "GRANT TEMPORARY ON DATABASE plant",
        "GRANT CREATE ON SCHEMA public",
    ]


def test_a_reader_of_the_state_is_told_what_to_ask_for(worker: str, plant: Any) -> None:
    before = stored(plant)
    plant.execute(f"GRANT TEMPORARY ON DATABASE {plant.info.dbname} TO worker")
    plant.execute("GRANT SELECT ON ALL TABLES IN SCHEMA public TO worker")
    with gam_db.connect(worker) as session:
        assert monitor(session).status().num_rows == 4
        with pytest.raises(EngineError, match="GRANT UPDATE ON TABLE gam_state_monitor TO it"):
            monitor(session).score()  # one writer at a time: it locks the row of its monitor
        plant.execute("GRANT UPDATE ON TABLE gam_state_monitor TO worker")
        with pytest.raises(EngineError, match="GRANT INSERT ON TABLE gam_state_bucket TO it"):
            monitor(session).score()
        with pytest.raises(EngineError, match="GRANT UPDATE ON TABLE gam_state_migration TO it"):
            monitor(session).calibrate(again=True)
    assert stored(plant) == before


def test_a_schema_that_an_administrator_made(worker: str, connection: Any) -> None:
    source(connection, readings(0, 120))
    connection.execute("GRANT SELECT ON telemetry TO worker")
    connection.execute(f"GRANT TEMPORARY ON DATABASE {connection.info.dbname} TO worker")
    made = gam_db.Monitor(worker, Source("telemetry"), PARAMETERS, CALIBRATION, schema="Health")
    with made, pytest.raises(EngineError, match="GRANT CREATE ON DATABASE"):
        made.migrate()
    connection.execute('CREATE SCHEMA "Health" AUTHORIZATION worker')
    with gam_db.Monitor(
        worker, Source("telemetry"), PARAMETERS, CALIBRATION, schema="Health", prefix=""
    ) as mine:
        mine.migrate()
        mine.calibrate()
        mine.score()
        assert mine.status().num_rows == 4


def test_a_session_that_may_only_read(plant: Any) -> None:
    before = stored(plant)
    with gam_db.connect(url(plant.info.dbname, default_transaction_read_only="on")) as session:
        assert monitor(session).health().num_rows > 0
        for command in ("score", "check", "status"):
            with pytest.raises(EngineError, match=r"may only read: a standby, or default_transaction"):
                getattr(monitor(session), command)()
    assert stored(plant) == before


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ("DiskFull", "^The disk of the PostgreSQL server is full"),
        ("IoError", "is its disk full"),
        ("ConfigurationLimitExceeded", "temp_file_limit"),
        ("QueryCanceled", "statement_timeout"),
        ("SerializationFailure", "^Another connection changed the same tables"),
        ("DeadlockDetected", "^Another connection changed the same tables"),
        ("LockNotAvailable", "^Another connection changed the same tables"),
        ("UniqueViolation", "^Another connection changed the same tables"),
        ("ConnectionFailure", "was lost; nothing was written"),
        ("AdminShutdown", "was lost; nothing was written"),
        ("OutOfMemory", "ran out of memory"),
        ("SyntaxError", None),
    ],
)
def test_what_is_said_of_a_state(state: str, message: str | None) -> None:
    said = postgres_refusals.of_statement(getattr(psycopg.errors, state)(), "SELECT 1", False)
    if message is None:
        assert said is None
    else:
        with pytest.raises(UserError, match=message):
            raise said or AssertionError


def test_a_statement_that_takes_too_long(plant: Any) -> None:
    with gam_db.connect(url(plant.info.dbname, statement_timeout="500")) as session:
        plant.execute("CREATE VIEW slow AS SELECT *, pg_sleep(0.05)::text FROM telemetry")
        with pytest.raises(EngineError, match="statement_timeout is too short"):
            gam_db.health_indicator(Source("slow"), PARAMETERS, CALIBRATION, session)
