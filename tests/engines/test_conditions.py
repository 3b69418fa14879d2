"""Conditions without --where-any: honest ones give the rows that they mean, others are refused."""

import datetime as dt
import re
import tomllib
from pathlib import Path

import duckdb
import pyarrow as pa
import pytest
from sqlglot import exp
from typer.testing import CliRunner

import engines
from gam_db.cli import app
from gam_db.composing import template
from gam_db.engines import NAMES, engine_named
from gam_db.engines.conditions import allowed_on, check_conditions
from gam_db.errors import ConfigurationError, GamError, SourceError
from gam_db.settings.source import parsed_condition

CASES = tomllib.loads(Path(__file__).with_name("conditions.toml").read_text(encoding="utf-8"))
EXECUTED = tuple(engines.OPENERS)
HONEST = [(of, case) for of in ("every", *EXECUTED) for case in CASES["honest"][of]]
#: What an engine calls otherwise.
ELSEWHERE = {
    ("sqlite", "concat(machine, '!') = 'R7!'"): "known from 3.44 on",
    ("clickhouse", "n & 1 = 1"): "bitAnd",
}

ROWS = pa.table(
    {
        "id": [1, 2, 3, 4, 5, 6, 7, 8],
        "machine": ["R7", "R7-a", "r8", "Press 1", None, "it's", "", "a\\b%"],
        "value": [5.0, -3.5, 0.0, 1000.25, None, 9.0, 2.0, 0.5],
        "n": [1, 2, 3, 4, 5, None, 7, -8],
        "time": pa.array(
            [
                dt.datetime(2026, 3, 2, 6, 30),
                dt.datetime(2026, 3, 2, 23, 59, 59),
                dt.datetime(2026, 3, 7, 12),
                dt.datetime(2026, 12, 31),
                dt.datetime(2027, 1, 1, 0, 0, 1),
                dt.datetime(2026, 2, 28, 10),
                None,
                dt.datetime(2026, 6, 15, 8, 15, 30),
            ],
            pa.timestamp("us"),
        ),
    }
)


#: How what is refused is told: what lets it, or that it is no condition in the words that sqlglot knows.
END = ("where_any = true under [source].", "with values instead of parameters.")


def refusal_of(condition: str, name: str) -> str:
    """Return what is said of a condition, the same of both settings; empty where nothing is."""
    told = []
    for said in ((condition, None), (None, condition)):
        try:
            check_conditions(said[0], said[1], engine_named(name))
        except (ConfigurationError, SourceError) as error:
            told.append(str(error))
    if not told:
        return ""
    of_where, of_validity = told
    assert of_validity == of_where.replace("where is", "valid_when is", 1)
    return of_where


@pytest.mark.parametrize("name", NAMES)
def test_each_engine_refuses_what_no_condition_may_hold(name: str) -> None:
    """With a sentence that names the part and what lets it; all else is refused, too."""
    of = {"databricks": "spark", "redshift": "postgres"}.get(name, name)
    conditions = [*CASES["refused"]["every"], *CASES["refused"].get(of, [])]
    assert len(conditions) > 40
    told = {condition: refusal_of(condition, name) for condition in conditions}
    assert not [condition for condition, said in told.items() if not said.endswith(END)]


@pytest.mark.parametrize(
    ("name", "condition", "sentence"),
    [
        ("postgres", "set_config('a', 'b', false) = 'b'", "may not contain the function set_config,"),
        (
            "postgres",
            "pg_catalog.set_config('a', 'b', false) = 'b'",
            "the function pg_catalog.set_config,",
        ),
        (
            "mariadb",
            "LOAD_FILE('/etc/passwd') = 'a'",
            ("on MariaDB may not contain the function load_file,"),
        ),
        ("postgres", "'a'::regclass IS NULL", "may not contain the type regclass,"),
        ("sqlite", "value IN other_table", "reads other tables or files"),
        ("duckdb", "random() < 0.5", "the function random can return something else each time"),
        ("postgres", "time > 'yesterday'", "'yesterday' can return something else each time"),
    ],
)
def test_the_sentence_names_the_part(name: str, condition: str, sentence: str) -> None:
    with pytest.raises(ConfigurationError) as refused:
        check_conditions(condition, None, engine_named(name))
    assert sentence in str(refused.value).replace('"', "'")
    assert "set --where-any" in refused.value.options


def test_honest_conditions_give_the_rows_that_they_mean(engine: str) -> None:
    session = engines.session(engine)
    conditions = [*CASES["honest"]["every"], *CASES["honest"][engine]]
    with session.lent(ROWS) as rows:
        for case in conditions:
            condition, _, meant = case.rpartition(" :: ")
            if (engine, condition) in ELSEWHERE:
                continue
            check_conditions(condition, condition, session.engine)
            tree = parsed_condition(condition)
            session.check_condition(rows, tree, condition)
            found = session.rows(exp.select("id").from_(rows.copy()).where(tree).order_by("id"))
            assert " ".join(str(row["id"]) for row in found) == meant, condition


@pytest.mark.parametrize("name", NAMES)
def test_what_messages_propose_is_let(name: str) -> None:
    engine = engine_named(name)
    compared = engine.comparable.format(column='"at"')
    dated = engine.dated.format(column='"at"')
    for condition in (dated, f"{compared} < TIMESTAMP '2026-01-01 00:00:00'", '"asset" IS NOT NULL'):
        check_conditions(condition, None, engine)


@pytest.mark.parametrize("name", NAMES)
def test_the_table_names_nodes_and_functions_that_there_are(name: str) -> None:
    """A function that sqlglot knows is a node, and is listed as one; what is there twice is a slip."""
    allowed = allowed_on(name)
    assert all(hasattr(exp, node) for node in allowed.nodes)
    assert all(hasattr(exp.DataType.Type, of) for of in allowed.types)
    for function in allowed.functions:
        tree = parsed_condition(f"{function}(a, b, c) = 1")
        assert tree.find(exp.Anonymous), function


def test_a_condition_is_tried_where_nothing_can_be_written(engine: str) -> None:
    """And what was open or set before is so afterwards."""
    session = engines.session(engine)
    table = exp.Table(this=template.name(engines.fresh_name("written")))
    if engine in ("clickhouse", "spark"):
        pytest.skip("left out: it has no transactions")
    session.execute(exp.Create(this=table, kind="TABLE", expression=exp.select("1 AS a")))
    insert = exp.Insert(this=table.copy(), expression=exp.select("2 AS a"))
    for _ in range(2):
        with pytest.raises(GamError) as refused, session.driver.only_reading():
            session.execute(insert)
        assert re.search("(?i)read.?only", str(refused.value.__cause__))
    session.execute(insert)
    assert session.rows(exp.select("a").from_(table.copy()).order_by("a")) == [{"a": 1}, {"a": 2}]
    session.execute(exp.Drop(tables=[table.copy()], kind="TABLE"))


@pytest.mark.parametrize(
    "command", [("compile", "plant", "--engine"), ("export", "dbt", "package", "plant", "--engine")]
)
def test_a_script_is_held_to_the_list_of_its_engine(
    command: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    words = (*command, "postgres", "--calibrate", "0/99")
    condition = "jsonb_typeof(kind) = 'number'"

    def exit_code(*more: str) -> int:
        return CliRunner().invoke(app, [*words, *more]).exit_code

    assert exit_code("--where", condition) == 0
    assert exit_code("--valid-when", condition) == 0
    assert exit_code("--where", condition, "--engine", "duckdb") == 1
    assert exit_code("--where", "pg_read_file('a') = 'b'") == 1
    assert exit_code("--valid-when", "pg_read_file('a') = 'b'") == 1
    assert exit_code("--where", "pg_read_file('a') = 'b'", "--where-any") == 0


def test_what_was_let_once_need_not_be_let_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A monitor knows its condition; one that is given anew is held to the list."""
    monkeypatch.chdir(tmp_path)
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT 'a' AS asset, 'b' AS channel, t AS time, "
            "CAST(t * t % 7 AS DOUBLE) AS value FROM range(400) AS r(t)"
        )
    method = ("--m", "2", "--tau", "1", "--bins", "4", "--window", "40", "--calibration-fraction", "0.5")
    words = ("calibrate", "telemetry", "--database", "plant.duckdb", *method)
    condition = ("--where", "value < (SELECT 100)")

    def told(*more: str) -> str:
        answer = CliRunner().invoke(app, [*words, *more])
        assert answer.exit_code in (0, 1, 2), answer.stderr
        return answer.stderr

    assert "set --where-any" in told(*condition)
    assert not told(*condition, "--where-any")
    assert "--where-any" not in told("--again")
    assert "set --where-any" in told("--again", "--valid-when", "value < (SELECT 100)")
