"""BigQuery's text on GoogleSQL, by the reference implementation: the same integers, and the stored form.

Everything that gam-db sends to an engine is run here but UPDATE, which is analysed. What the service
itself does (storage, quotas, transactions) is not seen.
"""

import datetime as dt
import importlib.metadata
import math
from dataclasses import replace
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from hypothesis import given, settings
from sqlglot import exp

import comparisons
import gam_db
import googlesql
import harness
import scripts
from gam_db.clock import TimeKind
from gam_db.engines import engine_named
from gam_db.engines.session import Session
from gam_db.method import Method, pipeline
from gam_db.settings.source import readings
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import dropping, migrations
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables
from googlesql import GoogleSqlError, Plant, Table
from googlesql_driver import GoogleSqlDriver
from state_names import called
from strategies import Case, cases
from test_spec import GROUPS, arguments_of, compare, compare_all
from test_spec import Case as Worked

BIGQUERY = engine_named("bigquery")
COLUMNS = {"asset": "STRING", "channel": "STRING", "time": "INT64", "value": "FLOAT64"}
SOURCE = gam_db.Source("telemetry")

#: What this file runs, and how its version is found; see test_engines.py.
RUNS = {"bigquery": lambda: importlib.metadata.version("zetasql")}


def plant(rows: Any, **columns: str) -> Plant:
    return Plant({"telemetry": Table({**COLUMNS, **columns}, list(rows))})


def dicts(table: Table) -> harness.Answer:
    return [dict(zip(table.columns, row, strict=True)) for row in table.rows]


def answer(
    question: str,
    rows: list[harness.Row],
    parameters: gam_db.Parameters,
    calibration: gam_db.Calibration,
) -> harness.Answer:
    """Answer by one query; that of the health indicator is what ``gam compile`` prints."""
    if question == "health_indicator":
        text = gam_db.render("exact", "bigquery", SOURCE, parameters, calibration)
    else:
        method = Method(parameters, calibration, TimeKind.COUNTER)
        read = readings(SOURCE, exp.to_table("telemetry"), lambda node: node)
        text = BIGQUERY.text(pipeline(method, read, lambda node: node).query(harness.STEPS[question]))
    return dicts(plant(rows).run(text))


def asked(case: Worked) -> frozenset[str]:
    """The questions of a case that are tried here: a query takes half a second to be analysed."""
    questions = {question for question, _, _ in case.expected}
    is_whole = case.name.startswith(("certificate", "eq2"))
    return frozenset(questions if is_whole else questions & {"health_indicator"})


def grouped() -> dict[str, list[Worked]]:
    """Return the cases that are asked together: those of one source that have the same questions."""
    groups: dict[str, list[Worked]] = {}
    for said, group in GROUPS.items():
        for case in group:
            if questions := asked(case):
                key = f"{said.partition(': ')[2]}: {', '.join(sorted(questions))}"
                groups.setdefault(key, []).append(case)
    return groups


TRIED = grouped()


@pytest.mark.parametrize("group", TRIED)
def test_cases(group: str) -> None:
    """One that is asked alone has its settings as they are written."""
    together, questions = TRIED[group], asked(TRIED[group][0])

    def answers(*arguments: Any) -> dict[str, harness.Answer]:
        return {question: answer(question, *arguments) for question in questions}

    tried = [
        replace(case, expected=[one for one in case.expected if one[0] in questions])
        for case in together
    ]
    if len(tried) == 1:
        compare(tried[0], answers(*arguments_of(tried[0])))
    else:
        compare_all(tried, answers)
    for case in together:
        comparisons.compared("bigquery", "exact", *arguments_of(case))


@settings(max_examples=max(3, settings().max_examples // 30))
@given(case=cases())
def test_random_sources_give_the_integers_of_the_reference(case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    for question in ("health_indicator", "support", "certificate"):
        expected = harness.by_reference(question, *arguments)
        harness.assert_same(expected, answer(question, *arguments), question)
    comparisons.compared("bigquery", "exact", *arguments)


def test_the_view_form_equals_the_reference() -> None:
    rows: list[harness.Row] = [
        (asset, "x", time, math.nan if time == 31 else float(time % 5 if time % 17 else time % 3))
        for asset in ("a1", "a2")
        for time in range(60)
    ]
    parameters = gam_db.Parameters(m=2, tau=2, bins=4, window=6)
    calibration = gam_db.Calibration(fraction=0.5, pool="channel")
    made = plant(rows)
    for statement in googlesql.statements(
        gam_db.render("view", "bigquery", SOURCE, parameters, calibration)
    ):
        made.execute(statement)
    for question, (relation, order) in scripts.RELATIONS.items():
        expected = harness.by_reference(question, rows, parameters, calibration)
        found = dicts(made.run(f"SELECT * FROM gam_live_{relation} ORDER BY {', '.join(order)}"))
        assert expected
        harness.assert_same(expected, found, question)
    comparisons.compared("bigquery", "view", rows, parameters, calibration)


@pytest.mark.parametrize("kind", ["TIMESTAMP", "DATETIME", "DATE"])
def test_instants_come_and_go(kind: str) -> None:
    text = gam_db.render(
        "exact", "bigquery", gam_db.Source("telemetry", time_kind="timestamp"), gam_db.Parameters(m=1)
    )
    if kind != "TIMESTAMP":
        resolved = googlesql.analyzed(text, plant([], time=kind).tables)
        columns = resolved.resolved_query_stmt_node.output_column_list
        assert googlesql.NAMES[columns[2].column.type.type_kind] == "TIMESTAMP"
        return
    first = dt.datetime(1969, 12, 31, 23, 59, 59, 999_999, dt.UTC)
    times = [first + dt.timedelta(seconds=second) for second in range(20)]
    rows = [("a", "x", time, float(number % 3)) for number, time in enumerate(times)]
    found = dicts(plant(rows, time=kind).run(text))
    assert [row["time"] for row in found] == times[4:]


def telemetry(until: int) -> list[list[Any]]:
    return [
        [asset, "x", time, float(time % (5 + number) if time % (37 - time // 10) else time % 11)]
        for number, asset in enumerate("ab")
        for time in range(until)
    ]


def monitor(engine: Any) -> Monitor:
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    calibration = gam_db.Calibration(fraction=0.7)
    return Monitor(engine, SOURCE, parameters, calibration, lookback=7)


def differing(found: pa.Table, expected: pa.Table) -> list[str]:
    """Return the columns whose values differ; instants are NULL here, of whichever type."""
    assert found.column_names == expected.column_names
    return [one for one in found.column_names if found[one].to_pylist() != expected[one].to_pylist()]


def test_the_stored_form_gives_what_duckdb_gives() -> None:
    """Migrated, calibrated, scored twice, looked at, pruned and dropped, with the same rows."""
    made = plant(telemetry(120))
    there = monitor(Session(GoogleSqlDriver(made)))
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)"
        )
        connection.executemany("INSERT INTO telemetry VALUES (?, ?, ?, ?)", telemetry(120))
        here = monitor(connection)
        for one in (there, here):
            one.migrate()
        assert differing(there.calibrate(), here.calibrate()) == []
        for one in (there, here):
            one.score()
        made.tables["telemetry"] = Table(COLUMNS, telemetry(200))
        late = [row for row in telemetry(200) if row[2] >= 120]
        connection.executemany("INSERT INTO telemetry VALUES (?, ?, ?, ?)", late)
        for one in (there, here):
            one.score()
        health = there.health()
        assert differing(health, here.health()) == []
        assert max(health["novel_in_window"].drop_null().to_pylist()) > 0
        assert there.check_state().num_rows == 0
        assert differing(there.prune(keep=40), here.prune(keep=40)) == []
        assert there.status()["asset"] == here.status()["asset"]
    tables = there.state.tables
    dropping.remove(there.session, dropping.removals(there.session, tables, "default"))
    assert not made.tables["gam_state_bucket"].rows
    dropping.remove(there.session, dropping.removals(there.session, tables))
    assert list(made.relations()) == ["telemetry"]


def test_the_migrations_can_be_run_twice() -> None:
    made = Plant({})
    script = migrations.rendered(BIGQUERY, StateTables())
    for statement in [*googlesql.statements(script), *googlesql.statements(script)]:
        made.execute(statement)
    assert len(made.tables["gam_state_migration"].rows) == len(files())
    assert set(made.relations()) == {called(name) for name in (*TABLES, *VIEWS)}
    for view in VIEWS:
        assert not made.run(f"SELECT * FROM {called(view)}").rows
    schema, *_ = googlesql.statements(migrations.rendered(BIGQUERY, StateTables("plant")))
    assert googlesql.analyzed(schema, {})


@pytest.mark.parametrize(
    ("said", "statement"),
    [
        ("Function not found", "SELECT ISFINITE(value) AS a FROM telemetry"),
        ("No matching signature", "SELECT asset + 1 AS a FROM telemetry"),
        (
            "neither grouped nor aggregated",
            "SELECT asset, COUNT(*) AS n FROM telemetry GROUP BY channel",
        ),
        ("only one output column", "DELETE FROM telemetry WHERE (time, value) IN (SELECT 1, 2)"),
        ("Type not found", "SELECT CAST(time AS DOUBLE) AS a FROM telemetry"),
        ("division by zero", "SELECT 1 / 0 AS a"),
    ],
)
def test_it_refuses_what_bigquery_refuses(said: str, statement: str) -> None:
    made = plant([])
    with pytest.raises(GoogleSqlError, match=said):
        made.execute(statement) if statement.startswith("DELETE") else made.run(statement)
