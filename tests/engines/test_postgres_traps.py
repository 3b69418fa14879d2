"""PostgreSQL runs nobody else's code: of ten thousand traps on the search_path none is called."""

import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import psycopg
import pytest
from typer.testing import CliRunner

import gam_db
import postgres_server
import postgres_traps
from gam_db.cli import app
from gam_db.errors import EngineError, SourceError
from gam_db.stored.schema.tables import VIEWS
from gam_db.study import Study
from small_plant import readings
from small_postgres import administrator, database, source
from state_names import called

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=4, window=20, stride=5)
HEALTHY = gam_db.Calibration(intervals=[(0, 99)])
SETTINGS = ("--m", "2", "--bins", "4", "--window", "20", "--stride", "5")

#: name of a source -> its columns, its calibration, and how it tells time
SOURCES = {
    "telemetry": ((), ("--calibrate", "0/99"), "counter"),
    "dated": (
        ("--asset", "machine", "--channel", "signal", "--time", "at", "--value", "reading"),
        ("--calibrate", "2026-01-01/2026-01-03"),
        "timestamp",
    ),
}

#: A source as people have it: names of limited length, times with a zone, numbers of limited size.
DATED = """
    CREATE TABLE dated AS
    SELECT asset::varchar(20) AS machine, channel::char(3) AS signal,
        '2026-01-01 00:00:00+00'::timestamptz + time * '30 min'::interval AS at,
        value::numeric(9, 3) AS reading
    FROM telemetry
"""

#: What views keep that is not PostgreSQL's own: functions, operators, types.
FOREIGN = """
    SELECT pg_describe_object(kept.refclassid, kept.refobjid, 0)
    FROM pg_depend AS kept JOIN pg_rewrite AS rule ON rule.oid = kept.objid
    JOIN pg_class AS seen ON seen.oid = rule.ev_class
    WHERE kept.classid = 'pg_rewrite'::regclass AND seen.relname LIKE 'gam%' AND kept.refobjid >= 16384
        AND kept.refclassid IN ('pg_proc'::regclass, 'pg_operator'::regclass, 'pg_type'::regclass)
"""

#: Views without a row: no row is lost, no calibration is long enough for a limit, nothing stands still.
EMPTY = {"unplaced_day", "visible_judgement", "visible_episode", "alarm", "alarm_event", "stillness"}
EMPTY |= {"labelled_episode", "hidden_run", "visible_program", "unjudged_program"}
EMPTY |= {"alarm_band", "alarm_cell"}


class Plant:
    """A database with two sources, in which somebody set traps.

    Args:
        connection: of the superuser.
        path: what search_path says there; the traps lie in the first schema of it.
    """

    def __init__(self, connection: Any, path: str) -> None:
        self.connection = connection
        self.url = postgres_server.server().url_of(connection.info.dbname)
        self.log = postgres_server.server().folder / "log"
        self.read = self.log.stat().st_size
        source(connection, readings(0, 300))
        connection.execute(DATED)
        schema, first, *_ = path.split(", ")
        own_types = first == "pg_catalog"
        assert postgres_traps.set_up(connection, schema, postgres_traps.known(), own_types) > 10_000
        connection.execute(f"ALTER DATABASE {connection.info.dbname} SET search_path = {path}")
        connection.execute(f"ALTER DATABASE {connection.info.dbname} SET log_statement = 'all'")
        connection.execute("SET search_path = pg_catalog")  # what tests ask calls no trap either

    def gam(self, *words: str) -> str:
        """Run a command, on this database unless it is one that opens none."""
        where = () if "--engine" in words else ("--database", self.url)
        result = CliRunner().invoke(app, [*words, *where])
        assert result.exit_code in (0, 2, 4), (words, result.output, self.told())
        self.check(" ".join(words[:2]))
        return result.stdout

    def psql(self, script: str) -> None:
        """Run a script as a database administrator does."""
        command = ["psql", "-X", "-q", "-v", "ON_ERROR_STOP=1", self.url]
        done = subprocess.run(command, input=script, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        self.check(script.partition("\n")[0])

    def check(self, what: str) -> None:
        """No trap was called."""
        assert postgres_traps.calls(self.connection) == 0, (what, self.told())

    def told(self) -> list[str]:
        """Return which traps were called."""
        return postgres_traps.told(self.said())

    def said(self) -> str:
        """Return what the server's log says since this database was made."""
        return self.log.read_bytes()[self.read :].decode(errors="replace")


@pytest.fixture(
    params=["public, traps", pytest.param("traps, pg_catalog, public", marks=pytest.mark.full)]
)
def plant(request: pytest.FixtureRequest) -> Iterator[Plant]:
    with database() as name, administrator(name) as connection:
        yield Plant(connection, request.param)


def test_traps_count(plant: Plant) -> None:
    """What is called under the path of this database is counted, so that zero means something."""
    with psycopg.connect(plant.url) as mine:
        mine.execute("SELECT 2 * 1.5, lower('x'::varchar), count(n) FROM generate_series(1, 3) AS n")
    assert postgres_traps.calls(plant.connection) >= 5
    assert {"* (integer, numeric)", "lower (character varying)", "count (integer)"} <= {*plant.told()}


def test_no_trap_is_called(plant: Plant, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every command over two sources, its scripts in psql, and every view."""
    monkeypatch.chdir(tmp_path)
    for name, (columns, healthy, kind) in SOURCES.items():
        said = (*SETTINGS, *columns, *healthy)
        plant.gam("check", name, *columns)
        plant.gam("init", name, "--out", f"{name}.toml", *columns)
        plant.gam("migrate")
        plant.gam("calibrate", name, *said)
        plant.gam("score")
        plant.gam("score", "--full")
        plant.gam("calibrate", name, *said, "--again")
        plant.gam("score", "--everything")
        plant.gam("status")
        plant.gam("check", name, *columns, "--state")
        with psycopg.connect(plant.url) as reader:
            for view in VIEWS:
                assert reader.execute(f"SELECT * FROM {called(view)}").fetchall() or view in EMPTY
        plant.check("views")
        plant.gam("prune", "--keep-versions", "0", "--keep-novel", "10", "--keep", "100")
        assert plant.connection.execute(FOREIGN).fetchall() == []
        plant.gam("drop", "--yes")
        plant.gam("run", name, "--out", "health.parquet", *said)
        plant.gam("select", name, *columns)
        for form in ("exact", "view"):
            options = ("--form", form, "--engine", "postgres", "--time-kind", kind)
            plant.psql(plant.gam("compile", name, *options, *said))
        assert plant.connection.execute("SELECT 1 FROM public.gam_live_health").fetchall()
        plant.check("view of the script")
        plant.psql(plant.gam("migrate", "--sql", "--engine", "postgres", "--schema", "scripted"))
        assert plant.connection.execute(FOREIGN).fetchall() == []
    own = plant.connection.execute("SELECT DISTINCT proname FROM pg_catalog.pg_proc").fetchall()
    run = postgres_traps.named([plant.said()]) & {name for (name,) in own}
    assert run - postgres_traps.known() - {"gam_live_health_of"} == set()  # the script's own


def test_a_lent_connection_calls_none_and_keeps_its_path(plant: Plant) -> None:
    for autocommit in (True, False):
        with psycopg.connect(plant.url, autocommit=autocommit) as mine:
            before = mine.execute("SHOW search_path").fetchall()
            mine.commit()
            with gam_db.Monitor(mine, gam_db.Source("telemetry"), PARAMETERS, HEALTHY) as monitor:
                monitor.migrate()
                monitor.calibrate()
                assert mine.execute("SHOW search_path").fetchall() == before
                mine.commit()
                monitor.score()
                assert monitor.health().num_rows > 0
                assert monitor.check_state().num_rows == 0
                assert monitor.status().num_rows == 4
            mine.rollback()
            assert mine.execute("SHOW search_path").fetchall() == before
    plant.check("a lent connection")


# What search_path says, read once


@pytest.fixture
def connection() -> Iterator[Any]:
    """A connection to a database with three schemas, two of which hold a table of the same name."""
    with database() as name, administrator(name) as opened:
        for schema in ("first", "second", "aside"):
            opened.execute(f"CREATE SCHEMA {schema}")
        opened.execute("SET search_path = second")
        source(opened, readings(0, 300))
        opened.execute("CREATE TABLE aside.telemetry AS SELECT * FROM telemetry WHERE asset = 'a'")
        opened.execute(f"ALTER DATABASE {name} SET search_path = first, second, aside")
        opened.execute("SET search_path = first, second, aside")
        yield opened


def url(connection: Any) -> str:
    return postgres_server.server().url_of(connection.info.dbname)


def test_tables_lie_where_the_path_says(connection: Any) -> None:
    """The source is the first of its name on the path, the state lies in its first schema."""
    source = gam_db.Source("telemetry")
    with gam_db.Monitor(url(connection), source, PARAMETERS, HEALTHY) as monitor:
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        assert monitor.status().num_rows == 4
    schemas = "SELECT DISTINCT relnamespace::regnamespace::text FROM pg_class WHERE relname LIKE 'gam%'"
    assert connection.execute(schemas).fetchall() == [("first",)]
    connection.execute("SET search_path = aside, first")
    with gam_db.connect(connection) as session:
        assert gam_db.support(source, PARAMETERS, HEALTHY, session).num_rows == 1
    connection.execute("SET search_path = first")
    with gam_db.connect(connection) as session, pytest.raises(SourceError, match="is not searched; wr"):
        gam_db.support(source, PARAMETERS, HEALTHY, session)


def test_a_temporary_table_of_the_users_own(connection: Any) -> None:
    connection.execute("CREATE TEMPORARY TABLE telemetry AS SELECT * FROM telemetry WHERE asset = 'b'")
    with gam_db.connect(connection) as session:
        found = gam_db.support(gam_db.Source("telemetry"), PARAMETERS, HEALTHY, session)
    assert found["asset"].to_pylist() == ["b"]


def test_no_schema_on_the_path(connection: Any) -> None:
    connection.execute("SET search_path = nowhere")
    with gam_db.Monitor(connection, gam_db.Source(("second", "telemetry"))) as monitor:
        assert monitor.check().num_rows == 4
        with pytest.raises(EngineError, match="names no schema that exists; give schema"):
            monitor.migrate()


def test_the_path_after_a_refusal_within_the_users_transaction(connection: Any) -> None:
    with psycopg.connect(url(connection)) as mine:
        mine.execute("SET search_path = second")
        with gam_db.connect(mine) as session:
            for where in ("value < 'x'", "nothing > 0"):
                refused = gam_db.Source("telemetry", where=where)
                with pytest.raises(SourceError):
                    gam_db.support(refused, PARAMETERS, HEALTHY, session)
                assert mine.execute("SHOW search_path").fetchall() == [("second",)]
        mine.commit()
        assert mine.execute("SHOW search_path").fetchall() == [("second",)]


@pytest.mark.parametrize("locally", ["false", "true"])
def test_a_condition_that_sets_the_path_leaves_it_pinned(connection: Any, locally: str) -> None:
    """Neither what gam-db runs after it finds names elsewhere, nor what the user does."""
    settings = "SELECT current_setting('search_path'), current_setting('TimeZone')"
    where = (
        f"set_config('search_path', 'first, pg_catalog', {locally}) <> '' "
        f"AND set_config('TimeZone', 'Asia/Tokyo', {locally}) <> ''"
    )
    setting = gam_db.Source(("second", "telemetry"), where=where)
    with gam_db.connect(url(connection)) as session:
        monitor = gam_db.Monitor(session, setting, PARAMETERS, HEALTHY, schema="second")
        monitor.migrate()
        for step in (monitor.check, monitor.calibrate, monitor.score, monitor.check_state):
            step()
            raw = session.driver._connection.execute(settings).fetchall()  # type: ignore[attr-defined]
            assert raw == [("pg_catalog, pg_temp", "UTC")], step
        with session.transaction():
            study = Study(session, setting, PARAMETERS, HEALTHY)
            assert study.rows("channels")
            raw = session.driver._connection.execute(settings).fetchall()  # type: ignore[attr-defined]
            assert raw == [("pg_catalog, pg_temp", "UTC")]
    for autocommit in (True, False):
        with psycopg.connect(url(connection), autocommit=autocommit) as mine:
            mine.execute("SET search_path = second")
            mine.commit()
            with gam_db.connect(mine) as session:
                gam_db.support(setting, PARAMETERS, HEALTHY, session)
                assert mine.execute("SHOW search_path").fetchall() == [("second",)]
                mine.commit()
                assert mine.execute("SHOW search_path").fetchall() == [("second",)]


# Functions of others that the user does mean


def test_a_condition_names_what_is_not_postgresqls_own(connection: Any) -> None:
    connection.execute(
        """
        CREATE FUNCTION first.halved(x double precision) RETURNS double precision
        LANGUAGE sql AS 'SELECT x / 2';
        CREATE FUNCTION first.near(a bigint, b integer) RETURNS boolean
        LANGUAGE sql AS 'SELECT abs(a - b) < 100';
        CREATE OPERATOR first.<<>> (LEFTARG = bigint, RIGHTARG = integer, FUNCTION = first.near)
        """
    )

    def found(where: str) -> int:
        source = gam_db.Source("telemetry", where=where)
        with gam_db.connect(url(connection)) as session:
            return int(gam_db.support(source, PARAMETERS, gam_db.Calibration(), session).num_rows)

    assert found("first.halved(value) < 100") == 4
    assert found("time OPERATOR(first.<<>>) 100") == 4
    for where in ("halved(value) < 100", "value::citext = 'x'"):
        with pytest.raises(
            SourceError, match=(r"does not exist\. In a condition, only " r"PostgreSQL's own names go")
        ):
            found(where)


def test_a_function_of_the_source_that_looks_names_up(connection: Any) -> None:
    connection.execute(
        """
        CREATE TABLE second.scale AS SELECT 2.0::double precision AS factor;
        CREATE FUNCTION second.scaled(x double precision) RETURNS double precision
        LANGUAGE plpgsql AS 'BEGIN RETURN x * (SELECT factor FROM scale); END';
        CREATE VIEW second.scaled AS
        SELECT asset, channel, time, second.scaled(value) AS value FROM telemetry;
        """
    )
    with gam_db.connect(url(connection)) as session:
        source = gam_db.Source("scaled")
        with pytest.raises(SourceError, match=r'"scale" does not exist.* ALTER FUNCTION'):
            gam_db.support(source, PARAMETERS, HEALTHY, session)
        connection.execute("ALTER FUNCTION second.scaled SET search_path = second")
        assert gam_db.support(source, PARAMETERS, HEALTHY, session).num_rows == 4


def test_a_condition_that_writes_is_refused_when_it_is_tried() -> None:
    """A function that is said to be immutable is called while its query is planned, for no row."""
    with database() as name, administrator(name) as connection:
        source(connection, readings(0, 20))
        connection.execute("CREATE TABLE written (a int)")
        connection.execute(
            "CREATE FUNCTION wrote() RETURNS int LANGUAGE plpgsql "
            "AS 'BEGIN INSERT INTO public.written VALUES (1); RETURN 1; END'"
        )
        connection.execute(
            "CREATE FUNCTION write() RETURNS int IMMUTABLE LANGUAGE plpgsql "
            "AS 'BEGIN RETURN public.wrote(); END'"
        )
        for lent in (connection, postgres_server.server().url_of(name)):
            with pytest.raises(SourceError, match="INSERT in a read-only transaction"):
                gam_db.check(gam_db.Source("telemetry", where="public.write() > 0"), engine=lent)
        assert connection.execute("SELECT * FROM written").fetchall() == []
        connection.execute("INSERT INTO written VALUES (2)")
        with connection.transaction():
            connection.execute("INSERT INTO written VALUES (3)")
            gam_db.check(gam_db.Source("telemetry", where="value < 100"), engine=connection)
            connection.execute("INSERT INTO written VALUES (4)")
        assert connection.execute("SELECT a FROM written ORDER BY a").fetchall() == [(2,), (3,), (4,)]
