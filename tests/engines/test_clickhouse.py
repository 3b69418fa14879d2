"""ClickHouse: its types and times, its settings, and how it keeps the state."""

import datetime as dt
import math
import re
import time
from decimal import Decimal
from typing import Any

import clickhouse_connect
import pyarrow as pa
import pytest
import sqlglot
from sqlglot import exp

import by_hand
import engines
import gam_db
import harness
import small_plant
from gam_db.clock import TimeKind
from gam_db.composing.pipeline import Pipeline, filled, place
from gam_db.engines.clickhouse import driver as clickhouse_driver
from gam_db.engines.session import Session
from gam_db.errors import EngineError, SourceError
from gam_db.settings.source import readings as reading_query
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning import reading
from scripts import arrive
from small_plant import FIRST, LENGTH, readings
from visible import BUCKETS, NOVEL, visible


@pytest.fixture
def session() -> Session:
    found = engines.session("clickhouse")
    assert isinstance(found, Session)
    return found


def run(session: Session, *statements: str) -> None:
    for statement in statements:
        session.driver.execute(statement)


def table_of(session: Session, columns: str, rows: str) -> str:
    """Make a table of these columns and rows, and return its name."""
    name = engines.fresh_name("plant")
    run(session, f"CREATE TABLE {name} ({columns}) ENGINE = MergeTree ORDER BY tuple()")
    run(session, f"INSERT INTO {name} {rows}")
    return name


def read(session: Session, relation: Any, **columns: Any) -> list[tuple[Any, ...]]:
    """Return (asset, channel, integer time, value) as gam-db reads them."""
    source = gam_db.Source(relation, **columns)
    node = session.relation(source.relation)
    kind = session.engine.types.time_kind(session.describe(node)[source.time])
    assert kind is not None
    query = reading_query(source, node, lambda time: session.engine.micros_of(kind, time))
    found = session.fetch(query).to_pylist()
    return sorted(tuple(row[c] for c in ("asset", "channel", "time", "reading")) for row in found)


def arrays(session: Session, target: str, *samples: tuple[Any, ...]) -> list[dict[str, Any]]:
    """Return the rows of a file for ClickHouse over samples of one channel, each with its time."""
    steps = Pipeline()
    for name in ("stored", "slices"):
        steps.fill(name, f"arrays/{name}")
    readings = by_hand.rows("asset channel time reading", *(("a", "x", *one) for one in samples))
    with session.lent(readings) as lent:
        found: list[dict[str, Any]] = session.fetch(steps.query(target, {"readings": lent})).to_pylist()
    return found


def test_arrays_take_the_widest_readings_for_what_they_are(session: Session) -> None:
    """1e300 is a number, what is beyond it is missing."""
    held = [(30, 1.1e300), (10, 1e300), (20, -1e300), (40, None), (25, float("inf"))]
    (found,) = arrays(session, "stored", *held)
    assert found["times"] == [10, 20, 25, 30, 40]
    assert found["samples"][:2] == [1e300, -1e300]
    assert all(map(math.isnan, found["samples"][2:]))
    assert (found["without_time"], found["doubled"]) == (0, 0)


def test_a_piece_of_an_array_says_where_it_begins_and_ends(session: Session) -> None:
    held = [(2, -1.0), (1, 5.0), (4, 3.0), (8, None), (16, None)]
    found = [tuple(row.values())[2:] for row in arrays(session, "slices", *held)]
    assert sorted(found) == [(1, 3, 0, 0, -1.0, 5.0, 1, 4), (2, 2, 0, 2, None, None, 8, 16)]


# Types and times


@pytest.mark.parametrize(
    ("type_name", "text", "micros"),
    [
        ("DateTime('Asia/Tokyo')", "2026-03-01 09:00:00", 1772323200000000),
        ("DateTime", "2026-03-01 00:00:00", 1772323200000000),
        ("DateTime64(3)", "2026-03-01 00:00:00.123", 1772323200123000),
        ("DateTime64(6, 'America/New_York')", "2026-02-28 19:00:00.123456", 1772323200123456),
        ("DateTime64(9)", "2026-03-01 00:00:00.123456999", 1772323200123456),
        ("DateTime64(9)", "1969-12-31 23:59:59.999999001", -1),
        ("DateTime64(7)", "1969-12-31 23:59:58.9999999", -1000001),
        ("Date32", "1960-01-01", -315619200000000),
        ("Nullable(DateTime64(6))", "2026-03-01 00:00:00.000001", 1772323200000001),
    ],
)
def test_instants_are_exact_whatever_the_zone_of_the_server(
    session: Session, type_name: str, text: str, micros: int
) -> None:
    named = table_of(
        session,
        f"asset LowCardinality(String), channel FixedString(3), time {type_name}, value Float32",
        f"VALUES ('a', 'x', '{text}', 1.5)",
    )
    assert read(session, named) == [("a", "x", micros, 1.5)]
    with gam_db.connect(opened(session_timezone="America/New_York")) as other:
        assert isinstance(other, Session)
        assert read(other, named) == [("a", "x", micros, 1.5)]


def opened(**settings: Any) -> Any:
    """Return a client of the user's, beside the session of the tests, with settings of its own."""
    client = clickhouse_connect.get_client(interface="chdb")
    for name, value in settings.items():
        client.set_client_setting(name, value)
    return client


def test_decimals_enums_and_reserved_words(session: Session) -> None:
    named = table_of(
        session,
        "`select` Enum8('A' = 1, 'a' = 2), `order by` LowCardinality(Nullable(String)), "
        '`time``stamp` UInt32, `va"l\\\\ue` Nullable(Decimal(18, 4))',
        "VALUES ('A', 'X', 7, 0.1), ('a', 'x', 8, NULL)",
    )
    columns = {"asset": "select", "channel": "order by", "time": "time`stamp", "value": 'va"l\\ue'}
    assert read(session, named, **columns) == [("A", "X", 7, 0.1), ("a", "x", 8, None)]


def test_a_counter_beyond_64_bits_is_refused_not_wrapped(session: Session) -> None:
    named = table_of(
        session,
        "asset String, channel String, time UInt64, value Float64",
        "VALUES ('a', 'x', 18446744073709551615, 1)",
    )
    with pytest.raises(SourceError, match="a counter needs 64 bits"):
        gam_db.health_indicator(gam_db.Source(named), engine=session)


def test_a_refused_query_leaves_nothing_in_the_next_answer(session: Session) -> None:
    with pytest.raises(Exception, match="safely converted"):
        session.driver.fetch("SELECT accurateCast(materialize(18446744073709551615), 'Int64') AS a")
    assert session.driver.fetch("SELECT 3 AS a").to_pylist() == [{"a": 3}]


def test_rows_come_back_as_on_other_engines(session: Session) -> None:
    found = session.driver.fetch(
        "SELECT toUInt64(3) AS a, toLowCardinality('x') AS b, toFloat32(0.5) AS c, count() AS d, "
        "toDateTime64('2026-03-01 00:00:00', 6, 'UTC') AS e, NULL AS f"
    )
    types = [pa.int64(), pa.string(), pa.float64(), pa.int64(), pa.timestamp("us", "UTC"), pa.null()]
    assert found.schema.types == types


def test_arrow_tables_go_in_and_come_out(session: Session) -> None:
    given = pa.table(
        {
            "a": pa.array([1, None], pa.uint16()),
            "b": pa.array(["x", None]).dictionary_encode(),
            "c": pa.array([Decimal("1.25"), None], pa.decimal128(10, 2)),
            "d": pa.array([dt.datetime(2026, 3, 1), None], pa.timestamp("ms")),
            "e": pa.array([float("nan"), None], pa.float64()),
            "select": pa.array([dt.date(1960, 1, 1), None]),
        }
    )
    with session.lent(given) as lent:
        found = session.driver.fetch(f"SELECT * FROM {session.engine.text(lent)} ORDER BY a")
        assert found["a"].to_pylist() == [1, None]
        assert found["b"].to_pylist() == ["x", None]
        assert found["c"].to_pylist() == [Decimal("1.25"), None]
        assert found["d"][0].as_py() == dt.datetime(2026, 3, 1, tzinfo=dt.UTC)
        assert found["e"][0].as_py() != found["e"][0].as_py()
        assert found["select"].to_pylist() == [dt.date(1960, 1, 1), None]
        name = lent.name
    with pytest.raises(SourceError, match="no table or view"):
        session.relation(name)
    with pytest.raises(SourceError, match="a column of the type list"):
        session.load(pa.table({"a": [[1]]}))


# Settings


def test_other_settings_of_a_client_change_nothing(session: Session) -> None:
    rows = readings(0, FIRST)
    table = engines.fresh_name("telemetry")
    with session.lent(harness.arrow(rows)) as lent:
        run(
            session, f"CREATE TABLE {table} ENGINE = Memory AS SELECT * FROM {session.engine.text(lent)}"
        )
    asked = (gam_db.Source(table), gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5))
    expected = gam_db.health_indicator(*asked, engine=session)
    assert expected.num_rows > 0
    odd: dict[str, Any] = {
        "join_use_nulls": 1,
        "group_by_use_nulls": 1,
        "aggregate_functions_null_for_empty": 1,
        "transform_null_in": 1,
        "cast_keep_nullable": 1,
        "session_timezone": "Asia/Tokyo",
    }
    client = opened(**odd)
    with gam_db.connect(client) as other:
        assert gam_db.health_indicator(*asked, engine=other).equals(expected)
    values = client.query("SELECT getSetting('join_use_nulls'), getSetting('transform_null_in')")
    assert values.result_rows == [(True, True)], "the client stays open, and as it was"
    left = "SELECT name FROM system.tables WHERE is_temporary"
    assert client.query(left).result_rows == []
    client.close()


def test_a_limit_is_an_error_and_not_a_part_of_the_rows(session: Session) -> None:
    client = opened(max_result_rows=3, result_overflow_mode="break", max_block_size=3)
    refused = pytest.raises(EngineError, match="TOO_MANY_ROWS_OR_BYTES")
    with gam_db.connect(client) as other, refused:
        other.fetch(
            sqlglot.parse_one("SELECT number FROM system.numbers LIMIT 10", dialect="clickhouse")
        )
    client.close()


def test_a_user_who_may_only_read(session: Session) -> None:
    table = table_of(
        session, "asset String, channel String, time Int64, value Float64", "VALUES ('a','x',1,1)"
    )
    client = opened()
    client.command("SET readonly = 1")
    with pytest.raises(EngineError, match="readonly = 2"):
        gam_db.connect(client)
    client.close()
    client = opened()
    client.command("SET readonly = 2")
    with gam_db.connect(client) as other:
        assert gam_db.check(gam_db.Source(table), engine=other)
        with pytest.raises(EngineError, match="may only read"):
            Monitor(other, gam_db.Source(table), prefix=engines.fresh_name("no")).migrate()
    client.close()


# State


def test_pruning_survives_what_a_killed_process_left(
    session: Session, monkeypatch: pytest.MonkeyPatch
) -> None:
    table = engines.fresh_name("telemetry")
    with session.lent(harness.arrow(readings(0, FIRST))) as lent:
        run(
            session, f"CREATE TABLE {table} ENGINE = Memory AS SELECT * FROM {session.engine.text(lent)}"
        )
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    prefix = engines.fresh_name("state")
    source, calibration = gam_db.Source(table), gam_db.Calibration(fraction=0.7)
    monitor = Monitor(session, source, parameters, calibration, prefix=prefix, lookback=7)
    monitor.migrate()
    monitor.calibrate()
    arrive(session, exp.to_table(table), readings(FIRST, LENGTH))
    monitor.score()
    monitor.score(since=FIRST)
    stored = f"SELECT count() AS n FROM {prefix}state_bucket"
    before = session.driver.fetch(stored)["n"][0].as_py()
    left = f"gam_doomed_{int(time.time())}_00"
    run(session, f"CREATE TABLE {left} (version_id Int64) ENGINE = MergeTree ORDER BY tuple()")
    monitor.prune()
    assert left in session.relations(), "it may be of a process at work"
    monkeypatch.setattr(clickhouse_driver, "_STALE", 0)
    monitor.prune()
    assert not [name for name in session.relations() if name.startswith("gam_doomed")]
    assert [visible(monitor, BUCKETS), visible(monitor, NOVEL)] == small_plant.whole()
    assert session.driver.fetch(stored)["n"][0].as_py() < before


def test_an_incremental_run_reads_its_range_only(session: Session) -> None:
    """Of a source and of buckets ordered by channel and time, a part of the marks is read."""
    table = engines.fresh_name("telemetry")
    run(
        session,
        f"CREATE TABLE {table} (asset String, channel String, time DateTime64(6), value Float64) "
        "ENGINE = MergeTree ORDER BY (time) SETTINGS index_granularity = 100",
        f"INSERT INTO {table} SELECT 'a', 'x', fromUnixTimestamp64Micro(toInt64(number) * 1000000), 1 "
        "FROM numbers(10000)",
    )
    reader = reading.Reader(session, gam_db.Source(table), TimeKind.TIMESTAMP, "plant")
    assert granules(session, reader.readings(earliest=9_900_000_000)) == (2, 100)

    prefix = engines.fresh_name("state")
    monitor = Monitor(session, gam_db.Source(table), prefix=prefix)
    monitor.migrate()
    run(
        session,
        f"INSERT INTO {prefix}state_bucket SELECT number % 16, intDiv(number, 16), 1, 0, 0, 0, 0, 0, "
        "0, 0, NULL, NULL FROM numbers(16 * 10000)",
        f"INSERT INTO {prefix}state_run SELECT 1, number, 0, 0, 0, 0, 0, 0, 0, 0, NULL, NULL, NULL, "
        "0, 0, 0, NULL, NULL, NULL, NULL, NULL FROM numbers(16)",
    )
    condition = "version_id = 5 AND bucket_no >= 9900"
    literal = f"SELECT bucket_no, novel FROM {prefix}state_visible_bucket WHERE {condition}"
    read_of, there = granules(session, sqlglot.parse_one(literal))
    assert (read_of, there) == (1, 312)
    group = [{"version_id": 5, "first_bucket": 9950}]
    asked = filled(
        "stored/scoring/past_buckets",
        {"buckets": 50, "differing": [], "near": reading.near(group, 50)},
    )
    cohort = pa.table({"channel_id": [5], "version_id": [5], "first_bucket": [9950]})
    with session.lent(cohort) as lent:
        place(asked, {**monitor.state.tables.nodes(), "cohort": lent})
        before = marks(session)
        assert session.fetch(asked).num_rows == 50
        assert marks(session) - before <= 6, "of 312, and the runs"


def test_what_a_run_reads_does_not_grow_with_what_is_stored(session: Session) -> None:
    """By the engine's own count of rows: the new ones, and little beside the buckets there are."""
    table = engines.fresh_name("telemetry")
    ordered = "ENGINE = MergeTree ORDER BY time SETTINGS index_granularity = 128"
    columns = "asset String, channel String, time Int64, value Float64"
    run(session, f"CREATE TABLE {table} ({columns}) {ordered}")

    def arrive_from(start: int, end: int) -> None:
        time = f"({start} + intDiv(number, 8))"
        run(
            session,
            f"INSERT INTO {table} SELECT concat('a', toString(number % 8)), 'x', {time}, {time} % 5 "
            f"FROM numbers({8 * (end - start)})",
        )

    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    calibration = gam_db.Calibration(intervals=[(0, 200)])
    source, prefix = gam_db.Source(table), engines.fresh_name("state")
    monitor = Monitor(session, source, parameters, calibration, lookback=20, prefix=prefix)
    monitor.migrate()
    arrive_from(0, 80_000)
    monitor.calibrate()
    monitor.score()
    arrive_from(80_000, 80_100)
    before = counted(session, "SelectedRows")
    report = monitor.score()
    there = 8 * (80_000 // 5)
    assert 0 < sum(row["rows_read"] for row in report.channels) < 8 * 150
    assert counted(session, "SelectedRows") - before < 3 * there / 8


def marks(session: Session) -> int:
    """Return how many marks were read since the engine was started."""
    return counted(session, "SelectedMarks")


def counted(session: Session, event: str) -> int:
    """Return how often something happened since the engine was started."""
    found = session.driver.fetch(f"SELECT value FROM system.events WHERE event = '{event}'")
    return sum(found["value"].to_pylist())


def granules(session: Session, query: exp.Expr) -> tuple[int, int]:
    """Return how many marks of its first table a query reads, and how many there are."""
    explained = session.driver.fetch(f"EXPLAIN indexes = 1 {session.engine.text(query)}")
    plan = "\n".join(explained["explain"].to_pylist())
    counts = re.findall(r"Granules: (\d+)/(\d+)", plan.split("ReadFromMergeTree")[1])
    return int(counts[-1][0]), int(counts[0][1])


def test_a_second_writer_is_noticed(session: Session) -> None:
    table = table_of(
        session, "asset String, channel String, time Int64, value Float64", "VALUES ('a','x',1,1)"
    )
    monitor = Monitor(session, gam_db.Source(table), prefix=engines.fresh_name("state"))
    monitor.migrate()
    channel = pa.table(
        {"channel_id": [1, 1], "monitor_id": [1, 1], "asset": ["a"] * 2, "channel": ["x"] * 2}
    )

    def calibrate(keys: dict[str, int]) -> None:
        with monitor.state.alone(keys):
            monitor.state.append_rows("channel", channel.to_pylist())

    keys = monitor.state.keys()
    with pytest.raises(EngineError, match="some channels occur twice"):
        calibrate(dict(keys))
    with pytest.raises(EngineError, match="Run it again"):
        calibrate(keys)
