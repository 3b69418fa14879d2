"""What each engine makes of the migrations: its types, keys and comments, and whether it runs."""

import sqlite3
from pathlib import Path

import duckdb
import pytest
import sqlglot
from sqlglot import exp

from gam_db.engines import NAMES, engine_named
from gam_db.errors import EngineError
from gam_db.stored.schema import migration_files
from gam_db.stored.schema.migration_files import definitions, files
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import FOR_READERS, TABLES, VIEWS, StateTables
from state_names import called

pytestmark = [pytest.mark.thorough, pytest.mark.migrates]

STATE = StateTables()
ALL = [migration.name for migration in files()]


@pytest.mark.parametrize("name", NAMES)
def test_the_script_of_an_engine_can_be_parsed(name: str) -> None:
    """Each table and view is made once, each file is recorded; the grammar knows all of it."""
    engine = engine_named(name)
    script = rendered(engine, STATE).replace(engine.beginning(), "", 1)
    parsed = [one for one in sqlglot.parse(script, dialect=engine.dialect) if one]
    made = [one for one in parsed if isinstance(one, exp.Create) and one.args["kind"] != "INDEX"]
    tables = [table for one in made if (table := one.find(exp.Table))]
    assert [table.name for table in tables] == [called(name) for name in (*TABLES, *VIEWS)]
    filled = [
        table.name for one in parsed if isinstance(one, exp.Insert) and (table := one.find(exp.Table))
    ]
    assert filled == ["gam_state_migration"] * len(ALL)
    others = {type(one) for one in parsed} - {exp.Create, exp.Insert}
    assert others <= {exp.Comment, exp.Drop}


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("postgres", "floor DOUBLE PRECISION,\n"),
        ("clickhouse", "bucket_no Int64,"),
        ("clickhouse", "novel_in_window Nullable(Int64),"),
        ("clickhouse", "\nSETTINGS\n  index_granularity = 512\nCOMMENT 'Full buckets"),
        ("clickhouse", "ORDER BY (support_id)\nCOMMENT 'Range"),
        ("clickhouse", "note Nullable(String) COMMENT 'What"),
        ("bigquery", "CLUSTER BY version_id, bucket_no\nOPTIONS (\n  description='Full"),
        ("bigquery", "novel_in_window INT64,"),
        ("bigquery", "note STRING OPTIONS (\n    description='What"),
        ("spark", "INTO 4 BUCKETS\nCOMMENT 'Full"),
        ("spark", "note STRING COMMENT 'What"),
        ("databricks", "CLUSTER BY (version_id, bucket_no)\nCOMMENT 'Full"),
        ("snowflake", "CLUSTER BY (version_id, bucket_no)\nCOMMENT='Full"),
        ("redshift", "COMPOUND SORTKEY(version_id, bucket_no)"),
        ("trino", "COMMENT ON COLUMN \"gam_fleet\".monitor IS 'The monitor'"),
        ("sqlite", 'DROP VIEW IF EXISTS "gam_state_visible_novel"'),
        ("postgres", 'COMMENT ON COLUMN public."gam_fleet".monitor IS \'The monitor'),
    ],
)
def test_types_keys_and_comments_are_the_engines(name: str, said: str) -> None:
    assert said in rendered(engine_named(name), STATE)


def test_the_script_for_postgresql_is_not_long() -> None:
    script = rendered(engine_named("postgres"), STATE)
    assert script.count("\n") <= 3100
    assert script.count("COMMENT ON COLUMN") == sum(
        len(definitions()[name].columns) for name in FOR_READERS
    )


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


def test_the_script_runs_twice_on_sqlite() -> None:
    connection = sqlite3.connect(":memory:")
    for _ in range(2):
        connection.executescript(rendered(engine_named("sqlite"), STATE))
    assert connection.execute("SELECT name FROM gam_state_migration ORDER BY number").fetchall() == [
        (name,) for name in ALL
    ]
    connection.close()


def test_instants_in_views_are_the_engines(tmp_path: Path) -> None:
    view = (
        "CREATE OR REPLACE VIEW stored_health AS SELECT run_id AS a, "
        "CASE WHEN run_id > 0 THEN MAKE_TIMESTAMP(started) END AS b FROM stored_run;"
        "COMMENT ON VIEW stored_health IS 'x'; COMMENT ON COLUMN stored_health.a IS 'x';"
        "COMMENT ON COLUMN stored_health.b IS 'x';"
    )
    (tmp_path / "0001_health.sql").write_text(view)
    (migration,) = migration_files.read(tmp_path)
    run = f"(1, 1, {'0, ' * 11}1767225599999999, 0{', NULL' * 6})"
    for name in NAMES:
        engine = engine_named(name)
        script = [engine.text(statement) for statement in migration.statements(engine, STATE)]
        assert len(sqlglot.parse(";".join(script), dialect=engine.dialect)) == len(script)
        if name == "duckdb":
            with duckdb.connect() as connection:
                connection.execute(rendered(engine, STATE) + ";".join(script))
                connection.execute(f"INSERT INTO gam_state_run VALUES {run}")
                found = connection.execute("SELECT CAST(b AS VARCHAR) FROM gam_health").fetchall()
        elif name == "sqlite":
            lite = sqlite3.connect(":memory:")
            lite.executescript(rendered(engine, STATE) + ";".join(script))
            lite.execute(f"INSERT INTO gam_state_run VALUES {run}")
            found = lite.execute("SELECT b FROM gam_health").fetchall()
            lite.close()
        else:
            continue
        assert found == [("2025-12-31 23:59:59.999999",)]
