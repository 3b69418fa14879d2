"""Times without a zone that are local ones: the instants of Python's own time zones, in every form."""

import datetime as dt
import random
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from sqlglot import exp
from typer.testing import CliRunner

import comparisons
import dbt_builder
import engines
import frozen
import gam_db
import harness
import local_reference
import reference
import scripts
from gam_db.cli import app
from gam_db.clock import TimeKind
from gam_db.engines.session import Session
from gam_db.errors import SourceError
from gam_db.export import Package
from gam_db.settings.local_time import local_time
from gam_db.stored.monitor import Monitor
from harness import ProgramRow, Row
from visible import BUCKETS, NOVEL, visible

MINUTE = 60 * 10**6
HOUR = 60 * MINUTE
EPOCH = dt.datetime(1970, 1, 1)

#: engine -> the type of a column of local times
TYPES = {
    "duckdb": "TIMESTAMP",
    "sqlite": "TEXT",
    "postgres": "TIMESTAMP",
    "mariadb": "DATETIME(6)",
    "clickhouse": "DateTime64(6)",
    "spark": "TIMESTAMP_NTZ",
}
#: A range without rounds: one query of a zone is long enough to plan.
METHOD = harness.made(
    {"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5, "range": "min_max"}, {"fraction": 0.3}
)


def micros(*day: int) -> int:
    return (dt.datetime(*day) - EPOCH) // dt.timedelta(microseconds=1)  # type: ignore[arg-type]


#: zone -> when a source begins that sees an hour come twice, and how many minutes it lasts.
SPANS = {
    "Europe/Berlin": (micros(2026, 10, 24, 20), 600),
    "Australia/Lord_Howe": (micros(2026, 4, 4, 10), 600),
}
SPRING = micros(2026, 3, 28, 20)


def readings(first: int, minutes: int, zone: str, seed: int = 1) -> list[tuple[int, Row]]:
    """Channels of a sample a minute or two, by local time, each with its instant."""
    chance = random.Random(seed)
    found = []
    for asset, step, shift in (("a", 2, 0), ("b", 5, 0), ("c", 2, 7)):
        for minute in range(0, minutes, step):
            instant = first + minute * MINUTE + shift * 10**6 * (minute % 5)
            value = None if chance.random() < 0.03 else float(chance.randrange(6) + (minute > 400) * 2)
            found.append((instant, (asset, "x", local_reference.shown(instant, zone), value)))
    return found


def told(session: Session) -> exp.Expr:
    """Return the time of a row as a column of the engine tells it."""
    engine = session.engine
    instant = engine.instant_of(TimeKind.TIMESTAMP, exp.column("time"))
    return exp.Cast(
        this=instant, to=exp.DataType.build(TYPES[engine.name], dialect=engine.dialect, udt=True)
    )


def telemetry(session: Session, rows: list[Row] | list[ProgramRow]) -> exp.Table:
    """Make a table of local times that say no zone."""
    if session.engine.name != "clickhouse":
        return scripts.telemetry(session, rows, told(session))
    # A column that is made of a query keeps the zone of what it is made of.
    name = engines.fresh_name("telemetry")
    columns = "asset String, channel String, time DateTime64(6), value Nullable(Float64)"
    columns += ", program Nullable(String)" * any(len(row) > 4 for row in rows)
    session.driver.execute(f"CREATE TABLE {name} ({columns}) ENGINE = MergeTree ORDER BY tuple()")
    scripts.arrive(session, exp.to_table(name), rows, told(session))
    return exp.to_table(name)


def with_ticks(answer: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return an answer with its times as integers; where an engine names their zone, it is UTC."""
    return [
        {name: _tick(value) if isinstance(value, dt.datetime) else value for name, value in row.items()}
        for row in answer
    ]


def _tick(time: dt.datetime) -> int:
    return (time.replace(tzinfo=None) - EPOCH) // dt.timedelta(microseconds=1)


@pytest.mark.parametrize("zone", SPANS)
def test_both_passes_of_the_autumn_hour_are_read(engine: str, zone: str) -> None:
    session = engines.session(engine)
    rows = [row for _, row in readings(*SPANS[zone], zone)]
    table = telemetry(session, rows)
    source = gam_db.Source(table.name, source_time_zone=zone)
    meant = local_reference.in_utc(rows, zone)
    assert len({row[:3] for row in meant}) == len(rows)  # no reading collapses with another
    found = gam_db.health_at_buckets(source, *METHOD, session).to_pylist()
    harness.assert_same(reference.buckets(meant, *METHOD), with_ticks(found), "buckets")
    support = gam_db.support(source, *METHOD, session).to_pylist()
    harness.assert_same(reference.support(meant, *METHOD), with_ticks(support), "support")
    comparisons.compared(engine, "exact", meant, *METHOD)


def test_both_passes_of_an_hour_that_comes_twice_keep_their_programs(engine: str) -> None:
    """Equal readings of one local time are told apart by their programs, the least of the first pass."""
    zone = "Europe/Berlin"
    plain = [row for _, row in readings(*SPANS[zone], zone)]
    rows: list[ProgramRow] = [(*row, "ab"[n // 7 % 2]) for n, row in enumerate(plain) if row[0] != "b"]
    twice = micros(2026, 10, 25, 2, 30)  # both passes tell one reading and two programs
    rows += [("d", "x", twice + k, 1.0, program) for k in range(40) for program in ("b", "a")]
    session = engines.session(engine)
    table = telemetry(session, rows)
    source = gam_db.Source(table.name, source_time_zone=zone, program="program")
    method = harness.made({"m": 2, "bins": 4, "window": 4, "least_vectors": 4}, {"fraction": 0.6})
    meant = local_reference.with_programs(rows, zone)
    health = gam_db.health_indicator(source, *method, session).to_pylist()
    expected = reference.health_indicator(meant, *method)
    harness.assert_same(expected, with_ticks(health), "health")
    summary = gam_db.programs(source, *method, session).to_pylist()
    expected = reference.programs(meant, *method)
    harness.assert_same(expected, with_ticks(summary), "programs")
    assert [row["program"] for row in summary if row["asset"] == "d"] == ["a", "b"]


def test_scripts_read_the_same_instants(engine: str) -> None:
    zone = "Europe/Berlin"
    session = engines.session(engine)
    rows = [row for _, row in readings(*SPANS[zone], zone)]
    table, prefix = telemetry(session, rows), engines.fresh_name("script")
    source = gam_db.Source(table.name, source_time_zone=zone)
    meant = reference.health_indicator(local_reference.in_utc(rows, zone), *METHOD)
    if engine != "clickhouse":  # which plans an entry of WITH anew wherever it is read: minutes
        exact = scripts.fetched(session, gam_db.render("exact", engine, source, *METHOD))
        harness.assert_same(meant, with_ticks(exact), "exact")
    scripts.run(session, gam_db.render("view", engine, source, *METHOD, prefix))
    answers = scripts.answered(session, prefix)
    scripts.check_judged(answers)
    harness.assert_same(meant, with_ticks(answers["health_indicator"]), "view")
    scripts.clear(session, table.name, prefix)


@pytest.mark.parametrize("change", ["autumn", "spring"])
@pytest.mark.parametrize("lookback", ["0 s", "20 min"])
def test_hourly_runs_end_in_the_tables_of_one_over_all(engine: str, change: str, lookback: str) -> None:
    if engine != "duckdb" and lookback != "20 min":
        pytest.skip("one lookback serves for the other engines")
    zone, session = "Europe/Berlin", engines.session(engine)
    first = SPANS[zone][0] if change == "autumn" else SPRING
    arriving = sorted(readings(first, 600, zone), key=lambda one: one[0])
    if lookback == "20 min":  # some come late, and by less than that
        chance = random.Random(2)
        arriving.sort(key=lambda one: one[0] + chance.randrange(19) * MINUTE)
    begun = [row for instant, row in arriving if instant < first + 3 * HOUR]
    table, time = telemetry(session, begun), told(session)
    source = gam_db.Source(table.name, source_time_zone=zone)
    prefix = engines.fresh_name("state")
    monitor = Monitor(session, source, *METHOD, lookback=lookback, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    rest = [row for instant, row in arriving if instant >= first + 3 * HOUR]
    every = 130
    for start in range(0, len(rest), every):
        scripts.arrive(session, table, rest[start : start + every], time)
        monitor.score()
    frozen_at, final = (local_reference.in_utc(rows, zone) for rows in (begun, begun + rest))
    asked = frozen_at, final, *METHOD
    harness.assert_same(frozen.buckets(*asked), visible(monitor, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), visible(monitor, NOVEL), "novel cells")
    assert not monitor.check_state().num_rows
    comparisons.compared(engine, "stored", final, *METHOD, frozen_at)


def test_a_dbt_package_reads_the_same_instants() -> None:
    zone = "Europe/Berlin"
    arriving = sorted(readings(*SPANS[zone], zone), key=lambda one: one[0])
    first = SPANS[zone][0]
    end = EPOCH + dt.timedelta(microseconds=first + 3 * HOUR)
    calibration = gam_db.Calibration(intervals=[(EPOCH, end)])
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry (asset TEXT, channel TEXT, time TIMESTAMP, value DOUBLE)"
        )

        def put(rows: list[Row]) -> None:
            table = harness.arrow(rows)
            connection.register("batch", table)
            connection.execute(
                "INSERT INTO telemetry SELECT asset, channel, make_timestamp(time), value FROM batch"
            )

        source = gam_db.Source("telemetry", source_time_zone=zone)
        package = Package(source, METHOD[0], calibration, lookback="10 min")
        builder = dbt_builder.Builder(package.files(), connection)
        put([row for instant, row in arriving if instant < first + 4 * HOUR])
        builder.build()
        rest = [row for instant, row in arriving if instant >= first + 4 * HOUR]
        for start in range(0, len(rest), 120):
            put(rest[start : start + 120])
            builder.build()
        found = builder.rows(
            "SELECT asset, channel, bucket, last_tick, samples, novel, novel_in_window FROM gam_health "
            "ORDER BY asset, channel, bucket"
        )
    meant = local_reference.in_utc([row for _, row in arriving], zone)
    in_ticks = gam_db.Calibration(intervals=[(0, first + 3 * HOUR)])
    kept = ("asset", "channel", "bucket", "novel", "novel_in_window")
    of_reference = frozen.buckets(meant, meant, METHOD[0], in_ticks)
    assert len(of_reference) > 30
    names = {"bucket_no": "bucket"}
    expected = [{names.get(key, key): value for key, value in row.items()} for row in of_reference]
    shared = [key for key in kept if key in expected[0]]
    assert {"novel", "novel_in_window"} <= set(shared)
    harness.assert_same(
        [{key: row[key] for key in shared} for row in expected],
        [{key: row[key] for key in shared} for row in found],
        "buckets",
    )


def spring() -> pa.Table:
    """A source of a reading a minute, also in the hour that Berlin's clocks skip."""
    start = dt.datetime(2026, 3, 28, 3)
    times = [start + dt.timedelta(minutes=minute) for minute in range(1500)]
    values = [float(minute % 7) for minute in range(1500)]
    return pa.table({"ts": pa.array(times, pa.timestamp("us")), "value": values})


SKIPPED = (
    "60 a local time that does not exist in Europe/Berlin, .* 2026-03-29 02:00:00 to 2026-03-29 02:59:00"
)


def test_an_hour_that_does_not_exist_is_refused_and_its_remedies_help() -> None:
    named: dict[str, Any] = {"asset": None, "channel": None, "time": "ts"}
    source = gam_db.Source(spring(), **named, source_time_zone="Europe/Berlin")
    with pytest.raises(SourceError, match=SKIPPED) as refusal:
        gam_db.support(source, *METHOD)
    said = refusal.value.options
    condition = said.partition('where="')[2].partition('"')[0]
    mended = gam_db.Source(spring(), **named, source_time_zone="Europe/Berlin", where=condition)
    assert gam_db.support(mended, *METHOD)["samples"].to_pylist() == [1440]
    assert "--source-time-zone Etc/GMT-1" in said
    all_year = gam_db.Source(spring(), **named, source_time_zone="Etc/GMT-1")
    assert gam_db.support(all_year, *METHOD)["samples"].to_pylist() == [1500]


def test_a_run_leaves_the_hour_out_that_does_not_exist(engine: str) -> None:
    session, first = engines.session(engine), SPRING
    step = (first + minute * MINUTE for minute in range(600))
    rows: list[Row] = [("a", "x", time + HOUR, float(time // MINUTE % 7)) for time in step]
    begun = [row for row in rows if row[2] < first + 4 * HOUR]
    table = telemetry(session, begun)
    source = gam_db.Source(table.name, source_time_zone="Europe/Berlin")
    monitor = Monitor(session, source, *METHOD, prefix=engines.fresh_name("state"))
    monitor.migrate()
    monitor.calibrate()
    scripts.arrive(session, table, rows[len(begun) :], told(session))
    report = monitor.score()
    assert (report.undated, report.skipped) == (60, 60)
    hour = micros(2026, 3, 29, 2)
    assert (report.first_skipped, report.last_skipped) == (hour, hour + 59 * MINUTE)
    meant = [local_reference.in_utc(some, "Europe/Berlin") for some in (begun, rows)]
    assert len(meant[1]) == len(rows) - 60
    expected = frozen.buckets(meant[0], meant[1], METHOD[0], METHOD[1])
    harness.assert_same(expected, visible(monitor, BUCKETS), "buckets")


def test_what_local_time_leaves_open_is_told_by_check(tmp_path: Path) -> None:
    start = dt.datetime(2026, 10, 24, 22)
    utc = [start + dt.timedelta(minutes=minute) for minute in range(600)]
    shown = [
        local_reference.shown((one - EPOCH) // dt.timedelta(microseconds=1), "Europe/Berlin")
        for one in utc
    ]
    lines = [f"{EPOCH + dt.timedelta(microseconds=time)},{n % 5}" for n, time in enumerate(shown)]
    path = tmp_path / "autumn.csv"
    path.write_text("\n".join(["ts,value", *lines]))
    words = ["check", str(path), "--source-time-zone", "Europe/Berlin", "--window", "50"]
    done = CliRunner().invoke(app, words)
    said = " ".join(done.output.split())
    assert "120 rows have a local time that occurs twice in Europe/Berlin" in said
    assert "repeat an instant" not in said
    assert "written with source_time_zone='Europe/Berlin'" in said


@pytest.mark.parametrize(
    ("column", "said"),
    [
        (pa.array(range(99)), "a counter"),
        (pa.array(range(99), pa.timestamp("us", "UTC")), "a timestamp with time zone"),
        (pa.array(["2026-03-01T10:00:00Z"] * 99), "times with a zone"),
        (pa.array(["2026-03-01 10:00:00+01:00"] * 99), "times with a zone"),
    ],
)
def test_times_that_are_not_local_take_no_time_zone(column: pa.Array, said: str) -> None:
    table = pa.table({"time": column, "value": [1.0] * 99})
    source = gam_db.Source(table, None, None, source_time_zone="Europe/Berlin")
    with pytest.raises(SourceError, match=f"local times, but the time column 'time' contains {said}"):
        gam_db.support(source)


def test_numbers_since_1970_take_no_time_zone() -> None:
    table = pa.table({"time": range(99), "value": [1.0] * 99})
    source = gam_db.Source(table, None, None, time_unit="s", source_time_zone="Europe/Berlin")
    with pytest.raises(SourceError, match="numbers since 1970"):
        gam_db.support(source)


def test_texts_of_sqlite_with_a_zone_take_no_other() -> None:
    session = engines.session("sqlite")
    name = engines.fresh_name("texts")
    session.driver.execute(f"CREATE TABLE {name} (time TEXT, value REAL)")
    session.driver.execute(f"INSERT INTO {name} VALUES ('2026-03-01 10:00:00+01:00', 1)")
    source = gam_db.Source(name, None, None, source_time_zone="Europe/Berlin")
    with pytest.raises(SourceError, match="times with a zone"):
        gam_db.support(source, engine=session)


def test_a_zone_that_there_is_not_is_refused() -> None:
    with pytest.raises(SourceError, match="source_time_zone is 'Europe/Berlim'"):
        gam_db.Source("t", source_time_zone="Europe/Berlim")


def test_text_files_are_read_in_local_time_too(tmp_path: Path) -> None:
    start = micros(2026, 10, 24, 22)
    rows = [local_reference.shown(start + minute * MINUTE, "Europe/Berlin") for minute in range(600)]
    path = tmp_path / "local.csv"
    lines = [
        f"{EPOCH + dt.timedelta(microseconds=time):%d.%m.%Y %H:%M};{n % 5}"
        for n, time in enumerate(rows)
    ]
    path.write_text("\n".join(["ts;value", *lines]))
    said: dict[str, Any] = {"time_format": "%d.%m.%Y %H:%M", "source_time_zone": "Europe/Berlin"}
    found = gam_db.support(gam_db.Source(str(path), None, None, "ts", **said), *METHOD)
    assert found["samples"].to_pylist() == [600]


@pytest.mark.parametrize(
    "zone", ["Europe/Berlin", "Australia/Lord_Howe", "Africa/Casablanca", "Pacific/Apia", "UTC"]
)
def test_the_clock_of_a_zone_is_that_of_python(zone: str) -> None:
    clock, chance = local_time(zone), random.Random(3)
    edges = [edge for piece in clock.pieces()[1:] for edge in (piece.start - 1, piece.start)]
    drawn = [chance.randrange(0, micros(2049, 12, 1)) for _ in range(300)]
    pieces = clock.pieces()
    for local in [*edges, *drawn]:
        piece = next(one for one in reversed(pieces) if one.start <= local)
        shifts = () if piece.shift is None else {piece.shift, piece.second}
        assert sorted(
            local - shift for shift in shifts if shift is not None
        ) == local_reference.instants(local, zone)


def test_what_is_not_used_adds_nothing() -> None:
    plain = gam_db.render("view", "duckdb", gam_db.Source("t", time_kind="timestamp"))
    utc = gam_db.render(
        "view", "duckdb", gam_db.Source("t", time_kind="timestamp", source_time_zone="UTC")
    )
    assert "shown" not in plain
    assert "zoned" not in plain
    assert "zoned" in utc
