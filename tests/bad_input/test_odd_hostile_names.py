"""Hostile names: a right answer or a remedy."""

from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

import harness
from gam_db import Calibration, Override, Parameters, Source
from odd import (
    LENGTH,
    ROWS,
    USUAL,
    USUAL_ROWS,
    VALUES,
    database,
    expected,
    health,
    refused,
    secret,
    support,
    table,
)

HOSTILE = [
    'quo"te',
    "it's",
    '"; DROP TABLE t; --',
    "'); DROP TABLE t; --",
    "/* comment",
    "select",
    "NULL",
    ":slot",
    "$1",
    "%like_!",
    "back\\slash",
    "new\nline",
    "Größe 机器 😀",
    "trailing ",
    "a.b.c.d",
    "main.t x",
    "x" * 200,
    "read_csv('x')",
]
TWINS = ["a", "A", "ä", "Ä", "ss", "ß", "a ", " a", "a\t", "", "a.b", "é", "e\u0301"]


def quoted(name: str) -> str:
    return '"' + name.replace('"', '""') + '"'


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_names_of_tables_and_columns(name: str) -> None:
    """A table of that name, its columns called alike: read, and nothing else is touched."""
    one, two, three = (name + ending for ending in "123")
    asset, channel, time, value = map(quoted, (name, one, two, three))
    connection = database(
        USUAL,
        f"CREATE TABLE {quoted(name)} AS SELECT 'a' AS {asset}, 'x' AS {channel}, i AS {time}, "
        f"(i * 7 % 5)::DOUBLE AS {value} FROM range(10) AS r(i)",
    )
    source = Source(name, name, one, two, three, where=f"{time} >= 0")
    assert health(source, engine=connection) == expected(USUAL_ROWS)
    assert connection.execute("SELECT COUNT(*) FROM duckdb_tables()").fetchall() == [(2,)]
    assert connection.execute("SELECT COUNT(*) FROM t").fetchall() == [(10,)]


def test_hostile_names_of_assets_and_channels() -> None:
    """All at once: none may be taken for another, and patterns without signs mean one asset only."""
    names = HOSTILE + TWINS
    rows = [
        (name, other, t, v)
        for name, other in zip(names, reversed(names), strict=True)
        for _, _, t, v in ROWS
    ]
    plain = [name for name in names if not set(name) & set("*?") and name]
    parameters = Parameters(
        m=2, bins=4, window=2, overrides=[Override(asset=name, bins=2) for name in plain[::2]]
    )
    calibration = Calibration(0.5, overrides={name: Calibration(0.3) for name in plain[::3]})
    found = harness.by_engine("duckdb")("health_indicator", rows, parameters, calibration)
    assert found == expected(rows, parameters, calibration)
    assert len({(row["asset"], row["channel"]) for row in found}) == len(names)


def test_case_twins_of_columns_are_refused_not_mixed_up() -> None:
    """DuckDB folds case: it would call the second one Value_1, and give the first for both."""
    twins = table(Value=secret())
    message = "columns 'value' and 'Value', which DuckDB cannot tell apart; rename one"
    for name in ("value", "Value"):
        refused(message, lambda name=name: support(Source(twins, value=name)))  # type: ignore[misc]
    twice = pa.Table.from_arrays([*twins.columns], [*twins.column_names[:4], "value"])
    refused("'value' and 'value'", lambda: support(Source(twice)))


@pytest.mark.parametrize("name", ["readings", "samples", "source", "channels", "support_summary"])
def test_a_table_called_like_a_step(name: str) -> None:
    connection = database(USUAL.replace("TABLE t", f"TABLE {name}"))
    assert health(Source(name), engine=connection) == expected(USUAL_ROWS)


def test_columns_called_like_ours() -> None:
    mine = table(
        instant=[9] * LENGTH, reading=list(range(LENGTH)), channel_id=VALUES, source_rows=VALUES
    )
    chosen = Source(mine, time="reading", value="channel_id", where="instant = 9 AND reading < 8")
    assert health(chosen) == expected(ROWS[:8])


@pytest.mark.parametrize(
    "relation",
    ["memory.s.t", '"s"."t"', "S.T", ("s", "t")],
)
def test_paths_of_tables(relation: Any) -> None:
    connection = database(
        "CREATE TABLE t AS SELECT 'not this one' AS asset",
        "CREATE SCHEMA s",
        USUAL.replace("t AS", "s.t AS", 1),
    )
    assert health(Source(relation), engine=connection) == expected(USUAL_ROWS)


@pytest.mark.parametrize(
    ("relation", "message"),
    [
        ("telemetri", "no table or view 'telemetri' in the database .*; did you mean 'telemetry'"),
        ("s.telemetry", "no table or view 's.telemetry'"),
        ("telemetry WHERE 1 = 0", "no table or view"),
        ("telemetry; DROP TABLE telemetry", "no table or view"),
        ("telemetry t", "no table or view"),
        (("no", "such"), "no table or view 'no.such'"),
        ("broken", "'broken' is there, but DuckDB cannot read it"),
        ("", "relation is empty"),
        (" ", "relation is empty"),
        ((), "one to three parts"),
        (("a", "b", "c", "d"), "one to three parts"),
        (("telemetry", ""), "one to three parts"),
        (None, "A NoneType is not a source; a source is the name of a table, the path"),
        (5, "A int is not a source; a source is"),
        (b"telemetry", "A bytes is not a source; a source is"),
        ({"time": [1]}, "A dict is not a source; a source is"),
    ],
)
def test_a_relation_that_is_none(relation: Any, message: str) -> None:
    connection = database(
        USUAL.replace("t AS", "telemetry AS", 1),
        "CREATE TABLE gone (i INT)",
        "CREATE VIEW broken AS SELECT i FROM gone",
        "DROP TABLE gone",
    )
    refused(message, lambda: support(Source(relation), engine=connection))
    assert connection.execute("SELECT COUNT(*) FROM telemetry").fetchall() == [(10,)]


@pytest.mark.parametrize("name", ["statement", "tree", "template", "self", "pa", "exp", "duckdb"])
def test_python_variables_are_no_tables(name: str) -> None:
    """DuckDB looks for them by itself; a mistyped name must not end up in one of ours."""
    refused(f"no table or view '{name}' in the database in memory", lambda: support(Source(name)))
    refused(f"no table or view '{name}'", lambda: support(Source(name), engine=database(USUAL)))
