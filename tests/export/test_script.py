"""Scripts: complete, commented, for every engine; what cannot be rendered says so."""

import sqlite3
from importlib.metadata import version
from pathlib import Path

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
import sqlglot
from sqlglot import exp

import gam_db
from gam_db.engines import NAMES, engine_named
from gam_db.errors import EngineError, ParameterError, SourceError, UserError
from gam_db.export.script import FORMS

PARAMETERS = gam_db.Parameters(max_gap=7, overrides=[gam_db.Override(asset="r_*%", m=2)])
CALIBRATION = gam_db.Calibration(fraction=0.25, exclude=[(3, 5)])
#: What this file parses again, and by what; see test_engines.py.
RUNS = dict.fromkeys(NAMES, lambda: version("sqlglot"))
SOURCE = gam_db.Source("plant.telemetry", time="t", where="quality = 1")


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("engine", NAMES)
def test_every_engine_gets_a_script_that_its_own_grammar_reads(engine: str, form: str) -> None:
    script = gam_db.render(form, engine, SOURCE, PARAMETERS, CALIBRATION)
    dialect = engine_named(engine).dialect
    script = script.replace(engine_named(engine).beginning(), "", 1)
    statements = [tree for tree in sqlglot.parse(script, dialect=dialect) if tree is not None]
    kinds = {tree.key for tree in statements}
    kinds.discard("command")  # what stops a script of MariaDB where the time column has another type
    if form == "view":
        kinds -= {"drop", "transaction", "commit", "alter"}
    assert kinds == {"select" if form == "exact" else "create"}
    for tree in statements:
        assert not list(tree.find_all(exp.Placeholder))
    assert "Eq. 1" in script
    assert "Eq. 2" in script
    assert "Eq. 4" in script


@pytest.mark.parametrize("kind", ["counter", "timestamp"])
@pytest.mark.parametrize("engine", NAMES)
def test_every_engine_tells_time_its_own_way(engine: str, kind: str) -> None:
    source = gam_db.Source("telemetry", time="ts", time_kind=kind)
    script = gam_db.render("exact", engine, source)
    assert f"Time: {kind}." in script


def test_undeclared_time_is_said_to_be_assumed() -> None:
    assert "counter, assumed" in gam_db.render("exact", "postgres", gam_db.Source("telemetry"))


def test_instants_tell_that_the_source_has_timestamps() -> None:
    calibration = gam_db.Calibration(intervals=[("2026-01-01", "2026-02-01")])
    script = gam_db.render("exact", "postgres", gam_db.Source("telemetry"), None, calibration)
    assert "Time: timestamp." in script


def test_a_file_shows_how_it_tells_time(tmp_path: Path) -> None:
    moments = pa.array([0, 1, 2], pa.timestamp("us"))
    path = tmp_path / "odd name's.parquet"
    pq.write_table(pa.table({"time": moments, "value": [1.0, 2.0, 3.0]}), path)
    source = gam_db.Source(path, asset=None, channel=None)
    half = gam_db.Calibration(fraction=0.5)
    script = gam_db.render("exact", "duckdb", source, gam_db.Parameters(m=1, window=1), half)
    assert "Time: timestamp." in script
    with duckdb.connect() as connection:
        assert len(connection.sql(script).fetchall()) == 2


def test_a_script_run_again_begins_anew() -> None:
    script = gam_db.render(
        "view", "duckdb", gam_db.Source("telemetry"), gam_db.Parameters(m=1, window=2), prefix="p_"
    )
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry AS "
            "SELECT 'a' AS asset, 'c' AS channel, i AS time, i % 3 + 0.5 AS value FROM range(30) t(i)"
        )
        connection.execute(script)
        before = connection.sql("SELECT * FROM p_health ORDER BY time").fetchall()
        connection.execute(script)
        assert connection.sql("SELECT * FROM p_health ORDER BY time").fetchall() == before
        tables = {name for (name,) in connection.sql("SHOW TABLES").fetchall()}
    assert tables == {
        *("telemetry", "p_channels", "p_bounds", "p_support"),
        *("p_support_summary", "p_certificate", "p_probes", "p_health"),
        *("p_samples", "p_history", "p_codes", "p_vectors", "p_novelty"),
    }


def test_the_view_sees_rows_that_came_later_and_keeps_its_calibration() -> None:
    script = gam_db.render(
        "view",
        "duckdb",
        gam_db.Source("telemetry"),
        gam_db.Parameters(m=1, bins=2, window=2),
        gam_db.Calibration(fraction=0.5),
    )
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry AS "
            "SELECT 'a' AS asset, 'c' AS channel, i AS time, i % 2 + 0.5 AS value FROM range(8) t(i)"
        )
        connection.execute(script)
        assert connection.sql("SELECT max(hi), count(*) FROM gam_live_health").fetchall() == [(0.0, 4)]
        connection.execute("INSERT INTO telemetry VALUES ('a', 'c', 8, 99), ('a', 'c', 9, 99)")
        assert connection.sql("SELECT max(hi), count(*) FROM gam_live_health").fetchall() == [(1.0, 6)]
        connection.execute("INSERT INTO telemetry VALUES ('a', 'c', 9, 1.5)")
        assert connection.sql("SELECT max(hi), count(*) FROM gam_live_health").fetchall() == [(0.5, 6)]


def test_a_table_may_be_called_as_a_step_of_ours() -> None:
    rows = [("a", "c", time, float(time % 3)) for time in range(12)]
    expected = None
    for name in ("telemetry", "readings", "samples", "channels", "support"):
        script = gam_db.render("exact", "sqlite", gam_db.Source(name), gam_db.Parameters(m=1, window=2))
        connection = sqlite3.connect(":memory:")
        connection.execute(f"CREATE TABLE {name} (asset TEXT, channel TEXT, time INTEGER, value REAL)")
        connection.executemany(f"INSERT INTO {name} VALUES (?, ?, ?, ?)", rows)
        found = connection.execute(script).fetchall()
        connection.close()
        assert len(found) == 10
        assert found == (expected or found)
        expected = found


def test_hostile_names_are_quoted() -> None:
    name = "tele\"metry'; DROP TABLE x; --"
    source = gam_db.Source((name,), asset="a b", channel="select", time='t"', value="v;")
    with duckdb.connect() as connection:
        connection.register(
            "rows",
            pa.table({"a b": ["x"] * 9, "select": ["y"] * 9, 't"': range(9), "v;": [0.0, 1.0, 2.0] * 3}),
        )
        connection.execute("CREATE TABLE x AS SELECT 1 AS kept")
        connection.sql("SELECT * FROM rows").create('"' + name.replace('"', '""') + '"')
        script = gam_db.render("exact", "duckdb", source, gam_db.Parameters(window=2))
        assert len(connection.sql(script).fetchall()) == 7
        assert connection.sql("SELECT kept FROM x").fetchall() == [(1,)]


@pytest.mark.parametrize(
    ("error", "part", "form", "engine", "source"),
    [
        (ParameterError, "'view'", "views", "duckdb", SOURCE),
        (EngineError, "'postgres'", "exact", "postgre", SOURCE),
        (EngineError, "does not read files", "exact", "sqlite", gam_db.Source("x.parquet")),
        (SourceError, "cannot be read", "exact", "duckdb", gam_db.Source("absent.parquet")),
        (SourceError, "Arrow", "exact", "duckdb", gam_db.Source(pa.table({"a": [1]}))),
        (SourceError, "channels=", "exact", "postgres", gam_db.WideSource("wide")),
    ],
)
def test_what_cannot_be_rendered_says_why(
    error: type[UserError], part: str, form: str, engine: str, source: gam_db.Source
) -> None:
    with pytest.raises(error, match=part):
        gam_db.render(form, engine, source)
