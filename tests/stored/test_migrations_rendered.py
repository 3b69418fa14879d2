"""What each engine makes of the migrations: its types, keys and comments, and whether it runs."""

import itertools
import sqlite3
from pathlib import Path
from typing import Any

import duckdb
import pytest
import sqlglot
from sqlglot import exp

from gam_db.engines import NAMES, engine_named
from gam_db.errors import EngineError
from gam_db.stored.schema import migration_files
from gam_db.stored.schema.migration_files import Migration, files
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]

STATE = StateTables()
ALL = [migration.name for migration in files()]


@pytest.mark.parametrize("name", NAMES)
def test_the_script_of_an_engine_can_be_parsed(name: str) -> None:
    """Each migration makes or changes one thing and is recorded; the grammar knows all of it."""
    engine = engine_named(name)
    script = rendered(engine, STATE).replace(engine.beginning(), "", 1)
    parsed = [one for one in sqlglot.parse(script, dialect=engine.dialect) if one]
    exchanged = [one for one in parsed if one.find(exp.Command)]
    assert [one.name for one in exchanged] == ["EXCHANGE"] * (3 if name == "clickhouse" else 0)
    made = [
        one.find(exp.Table)
        for one in parsed
        if isinstance(one, (exp.Create, exp.Alter)) and one.args["kind"] != "INDEX"
    ]
    made = [table for table in made if table and not table.name.endswith("_filled")]
    names = [name for name, _ in itertools.groupby(table.name for table in made if table)]
    # gam_fleet and gam_health got more columns: each is made only with all of them.
    last = {one.name: one.definition.columns.keys() for one in files()}
    whole = [one for one in files() if one.name not in ("fleet", "health") or has_all(one, last)]
    assert names == [f"gam_{name}" for name, _ in itertools.groupby(one.name for one in whole)]
    filled = [
        one.find(exp.Table)
        for one in parsed
        if isinstance(one, exp.Insert) and not one.args.get("overwrite")
    ]
    tables = [table.name for table in filled if table and not table.name.endswith("_filled")]
    assert sorted(tables) == sorted(["gam_migration"] * len(ALL) + ["gam_checksum", "gam_horizon"])
    others = {type(one) for one in parsed} - {exp.Create, exp.Alter, exp.Insert}
    assert others <= {exp.Comment, exp.Drop, exp.Command, exp.Update, exp.Merge}


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("postgres", "floor DOUBLE PRECISION,\n"),
        ("clickhouse", "bucket_no Int64 COMMENT 'Number of the bucket"),
        ("clickhouse", "novel_in_window Nullable(Int64) COMMENT"),
        ("clickhouse", "\nSETTINGS\n  index_granularity = 512\nCOMMENT 'Full buckets"),
        ("clickhouse", "ORDER BY (support_id)\nCOMMENT 'Range"),
        ("bigquery", "CLUSTER BY version_id, bucket_no\nOPTIONS (\n  description='Full"),
        ("bigquery", "novel_in_window INT64 OPTIONS (\n    description='Novel"),
        ("spark", "INTO 4 BUCKETS\nCOMMENT 'Full"),
        ("databricks", "CLUSTER BY (version_id, bucket_no)\nCOMMENT 'Full"),
        ("snowflake", "CLUSTER BY (version_id, bucket_no)\nCOMMENT='Full"),
        ("redshift", "COMPOUND SORTKEY(version_id, bucket_no)"),
        ("trino", 'COMMENT ON COLUMN "gam_run".run_id IS \'The run'),
        ("sqlite", 'DROP VIEW IF EXISTS "gam_visible_novel"'),
        ("duckdb", 'ALTER TABLE "gam_run"\nADD COLUMN IF NOT EXISTS withdrawn BIGINT'),
        ("postgres", 'COMMENT ON COLUMN "public"."gam_run".withdrawn IS \'In a second'),
        ("clickhouse", "ADD COLUMN IF NOT EXISTS withdrawn Nullable(Int64) COMMENT 'In a second"),
        (
            "bigquery",
            "ADD COLUMN IF NOT EXISTS withdrawn INT64 OPTIONS (\n    description='In a second",
        ),
        ("spark", "ADD COLUMN withdrawn BIGINT COMMENT 'In a second"),
        ("databricks", "ADD COLUMN withdrawn BIGINT COMMENT 'In a second"),
        ("snowflake", "ADD IF NOT EXISTS withdrawn BIGINT COMMENT 'In a second"),
        ("redshift", 'ALTER TABLE "gam_run"\nADD COLUMN withdrawn BIGINT'),
        ("sqlite", "gam_run. Only where it is pending: SQLite cannot be told to add a column once."),
    ],
)
def test_types_keys_and_comments_are_the_engines(name: str, said: str) -> None:
    assert said in rendered(engine_named(name), STATE)


@pytest.mark.parametrize("name", [name for name in NAMES if engine_named(name).schemas])
def test_a_schema_is_made_first(name: str) -> None:
    engine = engine_named(name)
    script = rendered(engine, StateTables("plant")).replace(engine.beginning(), "", 1)
    first = sqlglot.parse(script, dialect=engine.dialect)[0]
    assert isinstance(first, exp.Create)
    assert (first.kind, first.args["exists"]) == ("SCHEMA", True)


def test_an_engine_without_schemas_refuses_one() -> None:
    with pytest.raises(EngineError, match="sqlite has no schemas"):
        rendered(engine_named("sqlite"), StateTables("plant"))


def has_all(one: Migration, last: dict[str, Any]) -> bool:
    """Tell whether a view is made with the columns that it has in the end."""
    return bool(one.definition.columns.keys() == last[one.name])


def test_the_script_runs_on_sqlite() -> None:
    connection = sqlite3.connect(":memory:")
    script = rendered(engine_named("sqlite"), STATE)
    connection.executescript(script)
    with pytest.raises(sqlite3.OperationalError, match="duplicate column"):
        connection.executescript(script)
    connection.executescript(_without_added_columns(script))
    assert connection.execute("SELECT name FROM gam_migration ORDER BY number").fetchall() == [
        (name,) for name in ALL
    ]
    connection.close()


def _without_added_columns(script: str) -> str:
    """Leave out what the script itself says is to be left out where it was applied."""
    parts = script.split("\n\n")
    return "\n\n".join(part for part in parts if "Only where it is pending" not in part)


def test_instants_in_views_are_the_engines(tmp_path: Path) -> None:
    view = (
        "CREATE OR REPLACE VIEW stored_health AS SELECT run_id AS a, "
        "CASE WHEN run_id > 0 THEN MAKE_TIMESTAMP(started) END AS b FROM stored_run;"
        "COMMENT ON VIEW stored_health IS 'x'; COMMENT ON COLUMN stored_health.a IS 'x';"
        "COMMENT ON COLUMN stored_health.b IS 'x';"
    )
    (tmp_path / "0001_health.sql").write_text(view)
    (migration,) = migration_files.read(tmp_path)
    run = f"(1, 1, {'0, ' * 11}1767225599999999, 0{', NULL' * 7})"
    for name in NAMES:
        engine = engine_named(name)
        script = [engine.text(statement) for statement in migration.statements(engine, STATE)]
        assert len(sqlglot.parse(";".join(script), dialect=engine.dialect)) == len(script)
        if name == "duckdb":
            with duckdb.connect() as connection:
                connection.execute(rendered(engine, STATE) + ";".join(script))
                connection.execute(f"INSERT INTO gam_run VALUES {run}")
                found = connection.execute("SELECT CAST(b AS VARCHAR) FROM gam_health").fetchall()
        elif name == "sqlite":
            lite = sqlite3.connect(":memory:")
            lite.executescript(rendered(engine, STATE) + ";".join(script))
            lite.execute(f"INSERT INTO gam_run VALUES {run}")
            found = lite.execute("SELECT b FROM gam_health").fetchall()
            lite.close()
        else:
            continue
        assert found == [("2025-12-31 23:59:59.999999",)]
