"""PostgreSQL: names, times and numbers mean the same as elsewhere, whatever the columns are made of."""

import contextlib
import datetime as dt
from collections.abc import Iterator
from typing import Any

import psycopg
import pyarrow as pa
import pytest
from sqlglot import exp

import gam_db
import postgres_server
from gam_db.clock import TimeKind
from gam_db.engines.postgres import ENGINE
from gam_db.errors import SourceError
from gam_db.settings.source import Source
from gam_db.study import Study
from small_plant import readings
from small_postgres import administrator, database, source

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=3, window=4, stride=2)
CALIBRATION = gam_db.Calibration(fraction=0.5)


@pytest.fixture
def name() -> Iterator[str]:
    with database() as made:
        yield made


@pytest.fixture
def connection(name: str) -> Iterator[Any]:
    """A connection to an empty database."""
    with administrator(name) as opened:
        yield opened


def url(name: str, user: str | None = None, **settings: str) -> str:
    said = "&".join(f"options=-c%20{key}%3D{value}" for key, value in settings.items())
    return postgres_server.server().url_of(name, user) + f"?{said}" * bool(said)


# Names, times and numbers


def health(connection: Any, relation: Any = "telemetry", **columns: Any) -> list[dict[str, Any]]:
    with gam_db.connect(url(connection.info.dbname)) as session:
        given = Source(relation, **columns)
        found: list[dict[str, Any]] = gam_db.health_at_buckets(
            given, PARAMETERS, CALIBRATION, session
        ).to_pylist()
    return found


def expected(rows: pa.Table) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = gam_db.health_at_buckets(
        Source(rows), PARAMETERS, CALIBRATION
    ).to_pylist()
    return found


def pattern(length: int = 40) -> list[float]:
    return [float((number * 7) % 5 if number % 11 else number % 13) for number in range(length)]


@pytest.mark.parametrize("kind", ["timestamp", "timestamptz"])
def test_every_microsecond_is_its_integer(connection: Any, kind: str) -> None:
    """Around the instants at which the formula changes, and where its double has the fewest digits."""
    micros = ENGINE.text(ENGINE.micros_of(TimeKind.TIMESTAMP, exp.column("t")))
    ends = (-2_208_988_800_000_000, 0, 2_208_988_800_000_000)
    for end in ends:
        query = f"""
            SELECT COUNT(*), COUNT(*) FILTER (WHERE {micros} IS DISTINCT FROM n) FROM (
                SELECT n, {kind} '1970-01-01' + (n / 1000000) * interval '1 second'
                    + (n % 1000000) * interval '1 microsecond' AS t
                FROM generate_series({end - 30_000}::bigint, {end + 30_000}::bigint) AS n
            ) AS made
        """
        assert connection.execute(query).fetchall() == [(60_001, 0)]
    infinite = f"SELECT {micros} FROM (VALUES ({kind} 'infinity'), ({kind} '-infinity')) AS made (t)"
    assert connection.execute(infinite).fetchall() == [(None,), (None,)]


def test_the_time_of_a_timestamp_is_computed_once_a_row(connection: Any) -> None:
    """Slices name it three times; without a fence each name of it is the formula."""
    connection.execute(
        "CREATE TABLE telemetry AS SELECT 'a' AS asset, 'x' AS channel, "
        "timestamptz '2026-11-26' + n * interval '1 second' AS time, n % 7 AS value "
        "FROM generate_series(1, 99) AS n"
    )
    with gam_db.connect(url(connection.info.dbname)) as session:
        study = Study(session, Source("telemetry"), PARAMETERS, CALIBRATION, short_cuts=True)
        query = session.engine.text(study.steps.query("slices"))
    plan = "\n".join(line for (line,) in connection.execute(f"EXPLAIN VERBOSE {query}"))
    assert plan.count("date_part") == 1, plan


@pytest.mark.parametrize("kind", ['text COLLATE "folding"', "citext", "text"])
def test_names_that_differ_by_case_are_two_machines(connection: Any, kind: str) -> None:
    connection.execute("CREATE EXTENSION citext")
    try:
        connection.execute(
            "CREATE COLLATION folding "
            "(provider = icu, locale = 'und-u-ks-level2', deterministic = false)"
        )
    except psycopg.errors.FeatureNotSupported:
        if "folding" in kind:
            pytest.skip("left out: this server was built without ICU")
    connection.execute(f"CREATE TABLE telemetry (asset {kind}, channel {kind}, time int, value real)")
    rows = [
        (asset, channel, time, value)
        for asset, channel in (("a", "X"), ("A", "x"), ("B", "x"), ("ä", "x"), ("Z", "x"))
        for time, value in enumerate(pattern())
    ]
    with connection.cursor() as cursor:
        cursor.executemany("INSERT INTO telemetry VALUES (%s, %s, %s, %s)", rows)
    names = ("asset", "channel", "time", "value")
    table = pa.table(dict(zip(names, map(list, zip(*rows, strict=True)), strict=True)))
    assert health(connection) == expected(table)
    state = gam_db.Monitor(url(connection.info.dbname), Source("telemetry"), PARAMETERS, CALIBRATION)
    with state:
        state.migrate()
        state.calibrate()
        state.score()
        assert state.health()["asset"].unique().to_pylist() == ["A", "B", "Z", "a", "ä"]
        assert state.health(asset="a").num_rows == len(expected(table)) // 5


@pytest.mark.parametrize(
    ("kind", "is_refused"),
    [
        ("numeric(12, 3)", False),
        ("smallint", False),
        ("real", False),
        ("reading", False),
        ("text", True),
        ("money", True),
        ("boolean", False),
    ],
)
def test_types_of_readings(connection: Any, kind: str, is_refused: bool) -> None:
    connection.execute("CREATE DOMAIN positive AS numeric(9, 2)")
    connection.execute("CREATE DOMAIN reading AS positive CHECK (VALUE >= 0)")
    connection.execute("CREATE TYPE joint AS ENUM ('j2', 'j1')")
    connection.execute(
        f"CREATE TABLE telemetry AS SELECT 'r'::char(4) AS asset, 'j1'::joint AS channel, n AS time, "
        f"CASE WHEN n % 3 = 0 THEN {'false' if kind == 'boolean' else 0} "
        f"ELSE {'true' if kind == 'boolean' else 1} END::{kind} AS value "
        "FROM generate_series(1, 30) AS n"
    )
    if is_refused:
        with pytest.raises(SourceError, match=f"is of type {kind}; readings must be numbers"):
            health(connection)
        return
    values = [float(number % 3 != 0) for number in range(1, 31)]
    rows = {"asset": ["r"] * 30, "channel": ["j1"] * 30, "time": list(range(1, 31)), "value": values}
    assert health(connection) == expected(pa.table(rows))


def test_a_number_beyond_doubles(connection: Any) -> None:
    source(connection, readings(0, 30))
    connection.execute("ALTER TABLE telemetry ALTER value TYPE numeric")
    connection.execute("UPDATE telemetry SET value = 1e400::numeric WHERE time = 3")
    with pytest.raises(SourceError, match="does not fit into a double or 64 bits"):
        health(connection)


def test_reserved_words(connection: Any) -> None:
    connection.execute('CREATE SCHEMA "order"')
    connection.execute(
        'CREATE TABLE "order"."select" ("user" text, "table" text, "end" bigint, "Group" float)'
    )
    rows = [("a'\"\\%", "x;--", time, value) for time, value in enumerate(pattern())]
    with connection.cursor() as cursor:
        cursor.executemany('INSERT INTO "order"."select" VALUES (%s, %s, %s, %s)', rows)
    names = ("asset", "channel", "time", "value")
    table = pa.table(dict(zip(names, map(list, zip(*rows, strict=True)), strict=True)))
    columns = {"asset": "user", "channel": "table", "time": "end", "value": "Group"}
    assert health(connection, ("order", "select"), **columns) == expected(table)
    with pytest.raises(SourceError, match=r"its schema is not searched; write SCHEMA\.NAME"):
        health(connection, "select", **columns)
    with pytest.raises(SourceError, match=r"no table or view 'selec' .*did you mean 'select'"):
        health(connection, "selec", **columns)
    with pytest.raises(SourceError, match="PostgreSQL does not read the file"):
        health(connection, "plant.parquet")


@pytest.mark.parametrize("zone", ["UTC", "Asia/Kolkata", "America/St_Johns"])
@pytest.mark.parametrize("kind", ["timestamp", "timestamptz", "timestamp(0)", "timestamptz(3)", "date"])
def test_times_in_any_zone(connection: Any, zone: str, kind: str) -> None:
    """Instants are those of UTC, whatever the server, the session or the connection is set to."""
    start = dt.datetime(1969, 12, 20, 22, 13, 20, tzinfo=dt.UTC)
    step = dt.timedelta(days=1) if kind == "date" else dt.timedelta(hours=7, seconds=1)
    fine = dt.timedelta(milliseconds=0 if "(0)" in kind else 250 if kind != "date" else 0)
    if kind == "date":
        start = start.replace(hour=0, minute=0, second=0)
    times = [start + number * (step + fine) for number in range(40)]
    connection.execute(f"ALTER DATABASE {connection.info.dbname} SET TimeZone = '{zone}'")
    connection.execute(f"CREATE TABLE telemetry (asset text, channel text, time {kind}, value float)")
    with connection.cursor() as cursor:
        cursor.execute("SET TimeZone = 'UTC'")
        cursor.executemany(
            "INSERT INTO telemetry VALUES ('a', 'x', %s, %s)", list(zip(times, pattern(), strict=True))
        )
    zoned = "tz" in kind
    held = pa.array(
        [one if zoned else one.replace(tzinfo=None) for one in times],
        pa.timestamp("us", "UTC" if zoned else None),
    )
    rows = pa.table({"asset": ["a"] * 40, "channel": ["x"] * 40, "time": held, "value": pattern()})
    given: dict[str, Any] = {"where": "time >= TIMESTAMP '1969-12-22 00:00:00'"}
    wanted = gam_db.health_at_buckets(Source(rows, **given), PARAMETERS, CALIBRATION).to_pylist()
    assert health(connection, **given) == wanted
    with psycopg.connect(url(connection.info.dbname)) as mine:
        found = gam_db.health_at_buckets(Source("telemetry", **given), PARAMETERS, CALIBRATION, mine)
    assert found.to_pylist() == wanted


@pytest.mark.parametrize("unit", ["s", "ms", "us", "ns"])
def test_arrow_tables_with_times_of_any_precision(name: str, unit: str) -> None:
    scale = {"s": 1, "ms": 10**3, "us": 10**6, "ns": 10**9}[unit]
    times = [(number - 20) * 61 * scale - (scale > 1) for number in range(40)]
    held = pa.array(times, pa.timestamp(unit, "Europe/Paris"))
    rows = pa.table({"asset": ["a"] * 40, "channel": ["x"] * 40, "time": held, "value": pattern()})
    with gam_db.connect(url(name)) as session:
        found = gam_db.health_at_buckets(Source(rows), PARAMETERS, CALIBRATION, session)
    assert found.to_pylist() == expected(rows)


def test_rows_travel_there_and_back(name: str) -> None:
    rows = pa.table(
        {
            "text": pa.array(["x", None, "", 'q"uo\nte, é\\']),
            "count": pa.array([1, None, -(2**63), 2**63 - 1]),
            "value": pa.array([0.1, None, float("-inf"), 5e-324]),
            "flag": pa.array([True, None, False, True]),
            "day": pa.array([dt.date(2026, 1, 1), None, dt.date(1, 1, 1), dt.date(9999, 12, 31)]),
            "instant": pa.array([-1, None, 0, 253402300799999999], pa.timestamp("us", "UTC")),
        }
    )
    with gam_db.connect(url(name)) as session, session.lent(rows) as lent:
        assert session.fetch(exp.select("*").from_(lent)).equals(rows)
        assert session.fetch(exp.select("*").from_(lent).limit(0)).schema == rows.schema


def test_columns_that_postgres_cannot_hold(name: str) -> None:
    rows = pa.table({"asset": ["a"], "channel": ["x"], "time": [1], "value": [{"deep": 1}]})
    with gam_db.connect(url(name)) as session:
        with pytest.raises(SourceError, match="readings must be numbers"):
            gam_db.health_indicator(Source(rows), PARAMETERS, CALIBRATION, session)
        for odd in ({"é" * 32: [1]}, {"t": pa.array([2**62], pa.timestamp("s"))}):
            with pytest.raises(SourceError), contextlib.suppress(KeyError):
                session.relation(pa.table(odd))


def test_infinite_times_are_named_and_left_out(connection: Any) -> None:
    connection.execute(
        "CREATE TABLE odd AS SELECT TIMESTAMP '2026-03-02' + i * INTERVAL '1 minute' AS ts, "
        "i % 7 AS value FROM generate_series(1, 300) AS r(i)"
    )
    connection.execute("INSERT INTO odd VALUES ('infinity', 1), ('-infinity', 2)")
    given: dict[str, Any] = {"asset": None, "channel": None, "time": "ts"}
    with gam_db.connect(url(connection.info.dbname)) as session:
        pattern = r"2 without time \(2 an infinite time or a date that does not exist\)"
        with pytest.raises(SourceError, match=pattern) as caught:
            gam_db.support(Source("odd", **given), PARAMETERS, engine=session)
        condition = str(caught.value).partition('where="')[2].partition('"')[0]
        mended = Source("odd", **given, where=condition)
        assert gam_db.support(mended, PARAMETERS, engine=session)["samples"].to_pylist() == [300]
