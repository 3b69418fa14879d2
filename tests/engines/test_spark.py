"""Spark's own ways: a folder of tables, the user's session, time zones, what is read and refused."""

import datetime as dt
import threading
from decimal import Decimal
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import sqlglot
from sqlglot import exp

import engines
import gam_db
import harness
from gam_db.composing.pipeline import filled, place
from gam_db.engines.session import Session
from gam_db.engines.spark import OVER
from gam_db.engines.spark.driver import SparkDriver
from gam_db.engines.spark.tables import Rewriting
from gam_db.errors import EngineError, GamError, SourceError, UserError
from gam_db.stored.planning.reading import near
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables

PARAMETERS = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
START = 1_709_990_000_000_000  # within a day of a change of the clocks in New York


@pytest.fixture(scope="module", autouse=True)
def spark() -> Session:
    session = engines.session("spark")
    assert isinstance(session, Session)
    return session


@pytest.fixture
def theirs(spark: Session) -> Any:
    """A session of a user, whose clocks show New York's time.

    It makes programs of its queries, as Spark does by itself: else it cannot list its tables.
    """
    from pyspark.sql import SparkSession

    session = SparkSession.builder.getOrCreate().newSession()
    session.conf.set("spark.sql.codegen.factoryMode", "FALLBACK")
    session.conf.set("spark.sql.session.timeZone", "America/New_York")
    return session


def readings(start: int, end: int) -> pa.Table:
    """Two channels that repeat a pattern, and later on less so."""
    return harness.arrow(
        [
            (asset, "x", time, float(time % (5 + number) if time % (37 - time // 10) else time % 11))
            for number, asset in enumerate("ab")
            for time in range(start, end)
        ]
    )


def told(session: Session, query: str) -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = session.fetch(sqlglot.parse_one(query, dialect="duckdb")).to_pylist()
    return rows


def do(session: Session, statement: str) -> None:
    session.execute(sqlglot.parse_one(statement, dialect="spark"))


# The folder


def test_a_folder_is_found_again_and_two_sessions_see_one_another(tmp_path: Path) -> None:
    address = f"spark://{tmp_path / 'a plant'}"
    with gam_db.connect(address) as first, gam_db.connect(address) as second:
        assert isinstance(first, Session)
        assert isinstance(second, Session)
        do(first, "CREATE TABLE counts (name STRING, n BIGINT) USING PARQUET")
        do(first, "CREATE OR REPLACE VIEW doubled AS SELECT name, 2 * n AS twice FROM counts")
        assert told(second, "SELECT twice FROM doubled") == []
        for number in (1, 2):
            do(first, f"INSERT INTO counts (name, n) SELECT 'a' AS name, {number} AS n")
            total = "SELECT CAST(SUM(twice) AS BIGINT) AS total FROM doubled"
            assert told(second, total) == [{"total": sum(range(number + 1)) * 2}]
        gone = sqlglot.parse_one("SELECT 2 AS n", dialect="duckdb")
        assert isinstance(gone, exp.Query)
        second.delete(exp.to_table("counts"), ["n"], gone)
        assert told(first, "SELECT twice FROM doubled") == [{"twice": 2}]
        assert len(list((tmp_path / "a plant").glob("counts-*"))) == 1
        do(first, "CREATE OR REPLACE VIEW doubled AS SELECT name, 4 * n AS twice FROM counts")
        assert told(second, "SELECT twice FROM doubled") == [{"twice": 4}]
    with gam_db.connect(address, writable=False) as third:
        assert isinstance(third, Session)
        assert third.relations() == {"counts": ("name", "n"), "doubled": ("name", "twice")}
        assert told(third, "SELECT twice FROM doubled") == [{"twice": 4}]
        with pytest.raises(EngineError, match="reading only"):
            do(third, "INSERT INTO counts (name, n) SELECT 'b' AS name, 7 AS n")
    with gam_db.connect(address) as last:
        assert isinstance(last, Session)
        do(last, "DROP VIEW doubled")
        do(last, "DROP TABLE counts")
        assert last.relations() == {}
    assert not list((tmp_path / "a plant").glob("counts-*"))


def test_what_a_killed_process_left_is_not_seen_and_goes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with gam_db.connect(f"spark://{tmp_path}") as session:
        assert isinstance(session, Session)
        do(session, "CREATE TABLE counts (n BIGINT) USING PARQUET")
        do(session, "INSERT INTO counts (n) SELECT 1 AS n UNION ALL SELECT 2 AS n")
        gone = sqlglot.parse_one("SELECT 2 AS n")
        assert isinstance(gone, exp.Query)
        with monkeypatch.context() as patched:
            patched.setattr("gam_db.engines.spark.folder.Folder.put", _killed)
            with pytest.raises(KeyboardInterrupt):
                session.delete(exp.to_table("counts"), ["n"], gone)
        assert len(list(tmp_path.glob("counts-*"))) == 2
        assert told(session, "SELECT n FROM counts ORDER BY n") == [{"n": 1}, {"n": 2}]
        session.delete(exp.to_table("counts"), ["n"], gone)
        assert told(session, "SELECT n FROM counts") == [{"n": 1}]
        assert len(list(tmp_path.glob("counts-*"))) == 1


def _killed(*_: object) -> None:
    raise KeyboardInterrupt


def test_rows_that_come_while_a_table_is_rewritten_are_not_lost(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with (
        gam_db.connect(f"spark://{tmp_path}") as session,
        gam_db.connect(f"spark://{tmp_path}") as other,
    ):
        assert isinstance(session, Session)
        assert isinstance(other, Session)
        do(session, "CREATE TABLE counts (n BIGINT) USING PARQUET")
        do(session, "INSERT INTO counts (n) SELECT 1 AS n")

        write_beside = Rewriting.write_beside

        def interrupted(*arguments: Any) -> None:
            write_beside(*arguments)
            do(other, "INSERT INTO counts (n) SELECT 3 AS n")

        monkeypatch.setattr(Rewriting, "write_beside", interrupted)
        gone = sqlglot.parse_one("SELECT 1 AS n")
        assert isinstance(gone, exp.Query)
        with pytest.raises(EngineError, match="Another connection"):
            session.delete(exp.to_table("counts"), ["n"], gone)
        assert told(session, "SELECT n FROM counts ORDER BY n") == [{"n": 1}, {"n": 3}]


# The user's session


@pytest.mark.full
def test_the_users_session_keeps_its_ways_and_its_tables(theirs: Any, tmp_path: Path) -> None:
    schema = "plant_in_new_york"
    theirs.sql(f"CREATE SCHEMA {schema} LOCATION '{tmp_path / 'metastore'}'")
    theirs.sql(f"USE {schema}")
    theirs.conf.set("spark.sql.ansi.enabled", "false")
    theirs.createDataFrame(readings(0, 300)).createOrReplaceTempView("telemetry")
    calibration = gam_db.Calibration(intervals=[(0, 120)])
    with gam_db.connect(theirs) as session:
        monitor = gam_db.Monitor(session, gam_db.Source("telemetry"), PARAMETERS, calibration)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        monitor.score(full=True)
        found = monitor.health().to_pylist()
        monitor.prune()
        assert monitor.health().to_pylist() == found
        sizes = monitor.prune().to_pylist()
        assert [row["bucket_rows"] for row in sizes] == [row["bucket_rows_after"] for row in sizes]
    with gam_db.connect() as duck:
        source = gam_db.Source(readings(0, 300))
        once = gam_db.Monitor(duck, source, PARAMETERS, calibration)
        once.migrate()
        once.calibrate()
        once.score()
        assert once.health().to_pylist() == found
    assert theirs.conf.get("spark.sql.session.timeZone") == "America/New_York"
    assert theirs.conf.get("spark.sql.ansi.enabled") == "false"
    seen = theirs.sql("SELECT hi FROM gam_health ORDER BY asset, channel, bucket").toArrow()
    assert seen["hi"].to_pylist() == [row["hi"] for row in found]


@pytest.mark.parametrize("zone", [None, "UTC"])
def test_instants_are_right_in_any_zone(
    theirs: Any, spark: Session, tmp_path: Path, zone: str | None
) -> None:
    """Times around a change of New York's clocks, in a table of Spark and in a file."""
    times = pa.array([START + n * 300_000_000 for n in range(300)], pa.timestamp("us", zone))
    rows = pa.table({"t": times, "value": pa.array([Decimal(n % 7) / 4 for n in range(300)])})
    pq.write_table(rows, tmp_path / "rows.parquet")
    source: dict[str, Any] = {"asset": None, "channel": None, "time": "t"}
    with gam_db.connect(theirs) as session:
        found = gam_db.health_indicator(
            gam_db.Source(str(tmp_path / "rows.parquet"), **source), PARAMETERS, engine=session
        )
    expected = gam_db.health_indicator(
        gam_db.Source(str(tmp_path / "rows.parquet"), **source), PARAMETERS
    )
    assert found["time"].cast(pa.int64()) == expected["time"].cast(pa.int64())
    assert found["time"].type == pa.timestamp("us", zone)
    assert found["novel"] == expected["novel"]


# What is read


@pytest.mark.full
def test_a_run_reads_its_range_only(spark: Session, tmp_path: Path) -> None:
    for asset in ("007", "8"):
        folder = tmp_path / "telemetry.parquet" / f"asset={asset}"
        folder.mkdir(parents=True)
        times = pa.array([START + n * 1_000_000 for n in range(100)], pa.timestamp("us"))
        values = pa.array([float(n % 5) for n in range(100)])
        pq.write_table(pa.table({"t": times, "value": values}), folder / "rows.parquet")
    source = gam_db.Source(str(tmp_path / "telemetry.parquet"), channel=None, time="t")
    relation = spark.relation(source.relation)
    assert spark.describe(relation)["asset"] == "string"
    conditions = spark.engine.in_range(
        gam_db.clock.TimeKind.TIMESTAMP, exp.column("t"), START + 50_000_000, None
    )
    query = exp.select("value").from_(relation).where(*conditions, "asset IN ('007')")
    plan = explained(spark, query)
    assert "PushedFilters: [IsNotNull(t), GreaterThanOrEqual(t,2024-03-09T" in plan
    assert "PartitionFilters: [isnotnull(asset" in plan
    assert spark.fetch(query).num_rows == 50
    tables = StateTables(prefix=engines.fresh_name("range"))
    gam_db.Monitor(spark, source, prefix=tables.prefix).migrate()
    rows = exp.select("novel").from_(tables.table("bucket")).where("version_id = 3 AND last_time > 7")
    assert isinstance(spark.driver, SparkDriver)
    # Where no join or sum needs the groups, Spark leaves the others out as well, and does not say so.
    spark.driver.fetch("SET spark.sql.sources.bucketing.autoBucketedScan.enabled=false")
    plan = explained(spark, rows)
    spark.driver.fetch("SET spark.sql.sources.bucketing.autoBucketedScan.enabled=true")
    assert "SelectedBucketsCount: 1 out of 4" in plan
    group = [{"version_id": 3, "first_bucket": 900}]
    past = filled(
        "stored/scoring/past_buckets", {"buckets": 50, "differing": [], "near": near(group, 50)}
    )
    cohort = pa.table({"channel_id": [3], "version_id": [3], "first_bucket": [900]})
    with spark.lent(cohort) as lent:
        place(past, {**tables.nodes(), "cohort": lent})
        assert "EqualTo(version_id,3), GreaterThanOrEqual(bucket_no" in explained(spark, past)
    assert "EqualTo(version_id,3), GreaterThan(last_time,7)" in plan


def explained(session: Session, query: exp.Query) -> str:
    assert isinstance(session.driver, SparkDriver)
    text = session.engine.text(query)
    return str(session.driver.fetch(f"EXPLAIN EXTENDED {text}")["plan"][0])


def test_odd_names_and_decimals(spark: Session) -> None:
    rows = readings(0, 120)
    odd: dict[str, Any] = {
        "asset": "select",
        "channel": "a `tick`",
        "time": "order by",
        "value": "Ünit; --",
    }
    numbers = pa.array([Decimal(f"{value:.3f}") for value in rows["value"].to_pylist()])
    table = rows.set_column(3, "value", numbers).rename_columns(list(odd.values()))
    with spark.lent(table) as lent:
        found = gam_db.support(gam_db.Source(lent.name, **odd), PARAMETERS, engine=spark)
    assert found.to_pylist() == gam_db.support(gam_db.Source(rows), PARAMETERS).to_pylist()


def test_text_files_are_read(spark: Session, tmp_path: Path) -> None:
    lines = [f"a,x,{dt.datetime(2024, 1, 1) + dt.timedelta(seconds=n)},{n % 5}" for n in range(100)]
    (tmp_path / "rows.csv").write_text("\n".join(["asset,channel,time,value", *lines]))
    source = gam_db.Source(str(tmp_path / "rows.csv"))
    found = gam_db.support(source, PARAMETERS, engine=spark)
    assert found.to_pylist() == gam_db.support(source, PARAMETERS).to_pylist()


def test_delta_and_iceberg_are_rendered() -> None:
    delta = rendered(OVER["delta"], StateTables())
    assert "USING DELTA" in delta
    assert "CLUSTER BY (version_id, bucket_no)" in delta
    iceberg = rendered(OVER["iceberg"], StateTables())
    assert "USING ICEBERG" in iceberg
    assert "PARTITIONED BY ( BUCKET(4, version_id) )" in " ".join(iceberg.split())


# What is refused


def bad(tmp_path: Path) -> dict[str, tuple[Any, str]]:
    """What cannot be opened, and what is said."""
    (tmp_path / "a file").write_text("no folder")
    return {
        "no folder": ("spark://", "names no folder"),
        "no folder on a cluster": ("spark://127.0.0.1:7077", "names no folder"),
        "a file": (f"spark://{tmp_path}/a file", "cannot be written"),
        "another master": (f"spark://127.0.0.1:1{tmp_path}", "a process can run only one Spark"),
    }


@pytest.mark.parametrize("case", ["no folder", "no folder on a cluster", "a file", "another master"])
def test_what_cannot_be_opened(spark: Session, tmp_path: Path, case: str) -> None:
    address, message = bad(tmp_path)[case]
    with pytest.raises(EngineError, match=message):
        gam_db.connect(address)


def test_a_folder_that_is_not_there_is_not_made_to_be_read(tmp_path: Path) -> None:
    with pytest.raises(EngineError, match="no folder"):
        gam_db.connect(f"spark://{tmp_path / 'none'}", writable=False)


def test_a_stopped_session_is_refused() -> None:
    class Stopped:
        class sparkContext:  # noqa: N801
            _jsc = None

        _jsparkSession = None  # noqa: N815

    Stopped.__module__ = "pyspark.sql.session"
    with pytest.raises(EngineError, match="is stopped"):
        gam_db.connect(Stopped())


def test_nanoseconds_are_refused(spark: Session, tmp_path: Path) -> None:
    times = pa.array([n * 10**9 for n in range(10)], pa.timestamp("ns"))
    pq.write_table(pa.table({"t": times, "value": [1.0] * 10}), tmp_path / "rows.parquet")
    source = gam_db.Source(str(tmp_path / "rows.parquet"), asset=None, channel=None, time="t")
    with pytest.raises(SourceError, match="does not read timestamps in nanoseconds"):
        gam_db.support(source, engine=spark)


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ("CAST(asset AS BIGINT) = 7", "cannot be read as the type that its column needs"),
        ("no_such_column > 7", "which Spark refuses"),
        ("time + 9223372036854775807 > 0", "beyond 64 bits"),
    ],
)
def test_bad_values_and_conditions_are_said_in_one_line(
    spark: Session, condition: str, message: str
) -> None:
    with spark.lent(readings(0, 30)) as lent:
        source = gam_db.Source(lent.name, where=condition)
        with pytest.raises(UserError, match=message) as refused:
            gam_db.support(source, engine=spark)
    assert "JVM" not in str(refused.value)
    assert "'a'" not in str(refused.value)


def test_a_missing_file_or_table_is_named(spark: Session, tmp_path: Path) -> None:
    with pytest.raises(SourceError, match="does not exist"):
        gam_db.support(gam_db.Source(str(tmp_path / "none.parquet")), engine=spark)
    with pytest.raises(SourceError, match="no table or view 'none'"):
        gam_db.support(gam_db.Source("none"), engine=spark)


def test_java_that_has_ended_is_said() -> None:
    """In the words of py4j: the tests' own Java goes on."""
    from py4j.protocol import Py4JNetworkError

    from gam_db.engines.spark.driver import problem

    told = problem(Py4JNetworkError("Answer from Java side is empty"))
    assert isinstance(told, EngineError)
    assert "has ended" in str(told)
    assert problem(ValueError("ours")) is None


def test_two_sessions_at_once_in_threads(spark: Session, tmp_path: Path) -> None:
    """Each has names of its own; neither sees what the other keeps."""
    problems: list[GamError] = []

    def work(number: int) -> None:
        try:
            with gam_db.connect(f"spark://{tmp_path / str(number)}") as session:
                assert isinstance(session, Session)
                do(session, "CREATE TABLE counts (n BIGINT) USING PARQUET")
                do(session, f"INSERT INTO counts (n) SELECT {number} AS n")
                assert told(session, "SELECT n FROM counts") == [{"n": number}]
        except GamError as error:
            problems.append(error)

    threads = [threading.Thread(target=work, args=(number,)) for number in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not problems
