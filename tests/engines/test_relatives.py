"""SQL for engines that cannot be run here: run on a relative, or parsed by a grammar that is not ours.

Redshift's text runs on PostgreSQL, Databricks' on Spark, as far as their words go; not seen at work are
DATEDIFF, VARCHAR(MAX), sort keys, Delta tables. Snowflake's and Trino's (Athena's) text is parsed by
sqlfluff, which refuses a word in the wrong place and knows nothing of names, types and functions.
"""

import importlib
import re
from collections.abc import Iterator
from importlib.metadata import version
from typing import Any

import pglast
import psycopg
import pytest
from hypothesis import given, settings
from sqlfluff.core import FluffConfig, Linter

import comparisons
import engines
import gam_db
import harness
import postgres_server
import scripts
from gam_db.engines import engine_named
from gam_db.export.script import FORMS
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables
from googlesql import statements
from strategies import Case, cases
from test_spec import CASES
from test_spec import Case as Worked

pytestmark = pytest.mark.migrates

#: What this file runs or parses, and how the version of what does it is found; see test_engines.py.
RUNS = {
    "redshift": lambda: postgres_version(),
    "databricks": lambda: version("pyspark"),
    "snowflake": lambda: version("sqlfluff"),
    "trino": lambda: version("sqlfluff"),
}

SOURCE = gam_db.Source("telemetry")
Answers = dict[str, harness.Answer]


def postgres_version() -> str:
    with psycopg.connect(postgres_server.server().url) as connection:
        return str(connection.info.server_version // 10_000)


def first_of_each_file() -> Iterator[Worked]:
    """A case of each file of the specification, one that asks for the health indicator."""
    seen = set()
    for case in CASES:
        file = case.name.partition(":")[0]
        if file not in seen and any(question == "health_indicator" for question, _, _ in case.expected):
            seen.add(file)
            yield case


def checked(found: Answers, rows: list[harness.Row], parameters: Any, calibration: Any) -> None:
    """Compare what the scripts gave with the reference."""
    for question in scripts.RELATIONS:
        expected = harness.by_reference(question, rows, parameters, calibration)
        harness.assert_same(expected, found[question], question)
        if question == "health_indicator":
            harness.assert_same(expected, found["exact"], "exact")
    for form in FORMS:
        comparisons.compared("redshift", form, rows, parameters, calibration)


def shared(text: str) -> str:
    """Return Redshift's text without the three things that PostgreSQL has not."""
    clock = r"DATEDIFF\(MICROSECOND, CAST\('1970-01-01 00:00:00' AS TIMESTAMP\), GETDATE\(\)\)"
    timed = re.sub(clock, "EXTRACT(EPOCH FROM NOW()) * 1000000", text)
    return re.sub(r"\nCOMPOUND SORTKEY\([\w, ]+\)", "", timed.replace("VARCHAR(MAX)", "VARCHAR"))


def on_postgres(
    connection: psycopg.Connection[dict[str, Any]], rows: list[harness.Row], *method: Any
) -> Answers:
    """Answer by Redshift's scripts on PostgreSQL."""
    connection.execute("DROP TABLE IF EXISTS telemetry CASCADE")
    connection.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value FLOAT8)")
    with connection.cursor() as cursor:
        cursor.executemany("INSERT INTO telemetry VALUES (%s, %s, %s, %s)", rows)
    exact = gam_db.render("exact", "redshift", SOURCE, *method)
    view = gam_db.render("view", "redshift", SOURCE, method[0], method[1], without=())
    texts = [shared(exact), shared(view)]
    found = {"exact": connection.execute(texts[0].encode()).fetchall()}
    for statement in statements(texts[1]):
        connection.execute(statement.encode())
    for question, (relation, order) in scripts.RELATIONS.items():
        answer = connection.execute(
            f"SELECT * FROM gam_live_{relation} ORDER BY {', '.join(order)}".encode()
        )
        found[question] = answer.fetchall()
    if not method[1].pools:
        scripts.check_judged(found)
    return found


@pytest.fixture(scope="module")
def postgres() -> Iterator[psycopg.Connection[dict[str, Any]]]:
    with psycopg.connect(
        postgres_server.server().url, autocommit=True, row_factory=psycopg.rows.dict_row
    ) as connection:
        yield connection


def test_redshift_on_postgresql_gives_the_integers_of_the_specification(
    postgres: psycopg.Connection[dict[str, Any]],
) -> None:
    for case in first_of_each_file():
        arguments = (case.rows, *harness.made(case.parameters, case.calibration))
        checked(on_postgres(postgres, *arguments), *arguments)


@settings(max_examples=max(7, settings().max_examples // 20))
@given(case=cases())
def test_redshift_on_postgresql_gives_the_integers_of_the_reference(
    postgres: psycopg.Connection[dict[str, Any]], case: Case
) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    checked(on_postgres(postgres, *arguments), *arguments)


def test_redshift_keeps_its_state_on_postgresql(postgres: psycopg.Connection[dict[str, Any]]) -> None:
    """Twice, as migrations may be run."""
    script = statements(shared(rendered(engine_named("redshift"), StateTables("plant"))))
    for statement in [*script, *script]:
        postgres.execute(statement.encode())
    found = postgres.execute("SELECT COUNT(*) AS n FROM plant.gam_state_migration").fetchall()
    assert found == [{"n": len(files())}]


def script_of(engine: str) -> str:
    """Return the exact form, the view form and the migrations, with times and patterns in them."""
    source = gam_db.Source("telemetry", time_kind="timestamp")
    calibration = gam_db.Calibration(overrides={"r_*%": None})
    return "\n".join(
        (
            gam_db.render("exact", engine, source, gam_db.Parameters(m=2), calibration),
            gam_db.render("view", engine, SOURCE, gam_db.Parameters(m=2)),
            rendered(engine_named(engine), StateTables("plant")),
        )
    )


def refused(dialect: str, script: str) -> list[str]:
    """Return what the grammar of a dialect says against a script, statement by statement."""
    linter = Linter(config=FluffConfig(overrides={"dialect": dialect}))
    return [
        f"{violation.desc()} in {statement[:60]!r}"
        for statement in statements(script)
        for violation in linter.parse_string(f"{statement};\n").violations
    ]


# In the full set: it takes half a minute, and the fingerprints tell whether a text is another one.
@pytest.mark.full
@pytest.mark.parametrize("engine", ["snowflake", "trino"])
def test_the_grammar_takes_all_scripts(engine: str) -> None:
    assert refused(engine, script_of(engine)) == []


def test_postgresql_parses_what_redshift_shares_with_it() -> None:
    text = script_of("redshift")
    assert shared(text) != text
    assert len(pglast.parse_sql(shared(text))) > 50


@pytest.mark.full
@pytest.mark.parametrize("engine", ["redshift", "databricks"])
def test_the_grammar_takes_the_migrations(engine: str) -> None:
    """With what the relative has not: sort keys, clustering."""
    assert refused(engine, rendered(engine_named(engine), StateTables("plant"))) == []


@pytest.mark.parametrize("engine", ["snowflake", "trino", "redshift", "databricks"])
def test_the_grammar_refuses_something(engine: str) -> None:
    wrong = ("SELECT a FROM t GROUP b;\n", "CREATE TABLE t (a BIGINT,, b BIGINT);\n", "SELECT (1;\n")
    assert [bool(refused(engine, one)) for one in wrong] == [True, True, True]


@pytest.fixture
def spark() -> Any:
    """A session in UTC of the Spark that all tests of this process share."""
    engines.session("spark")
    session = importlib.import_module("pyspark.sql").SparkSession.builder.getOrCreate().newSession()
    session.conf.set("spark.sql.session.timeZone", "UTC")
    session.conf.set("spark.sql.shuffle.partitions", "1")  # 200 tasks for each step otherwise
    return session


def test_databricks_on_spark_gives_the_integers_of_the_reference(spark: Any) -> None:
    rows: list[harness.Row] = [
        ("a1", "x", time, None if time == 31 else float(time % 5 if time % 17 else time % 3))
        for time in range(60)
    ]
    # Spark inlines every step of one query: with the rounds of the range its driver takes over 1 GB.
    parameters = gam_db.Parameters(m=2, tau=2, bins=4, window=6, range="min_max")
    method = parameters, gam_db.Calibration(fraction=0.5)
    spark.createDataFrame(harness.arrow(rows)).createOrReplaceTempView("telemetry")
    found = spark.sql(gam_db.render("exact", "databricks", SOURCE, *method)).toArrow().to_pylist()
    harness.assert_same(harness.by_reference("health_indicator", rows, *method), found)
    comparisons.compared("databricks", "exact", rows, *method)


@pytest.mark.parametrize("form", FORMS)
def test_databricks_reads_as_spark_does(form: str) -> None:
    """So whatever runs on Spark was run for Databricks; its tables are Delta by default."""
    texts = [
        [one.replace(" USING PARQUET AS\n", " AS\n") for one in statements(script)]
        for script in (gam_db.render(form, engine, SOURCE) for engine in ("spark", "databricks"))
    ]
    assert texts[0] == texts[1]
