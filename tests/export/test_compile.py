"""``gam compile``: the script of the library, from the command line."""

import sqlite3
from pathlib import Path

import duckdb
import pytest
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app


def invoke(*words: str) -> Result:
    return CliRunner().invoke(app, ["compile", *words])


def test_it_prints_what_the_library_renders() -> None:
    found = invoke("telemetry", "--engine", "postgres", "--form", "exact", "--bins", "20", "--time", "t")
    expected = gam_db.render(
        "exact", "postgres", gam_db.Source("telemetry", time="t"), gam_db.Parameters(bins=20)
    )
    assert found.exit_code == 0
    assert found.stdout == expected


def test_columns_of_a_database_table_are_looked_at(tmp_path: Path) -> None:
    path, script = tmp_path / "plant.duckdb", tmp_path / "gam.sql"
    with duckdb.connect(str(path)) as connection:
        connection.execute(
            "CREATE TABLE readings AS SELECT 'r1' AS robot, 'j1' AS joint, "
            "TIMESTAMP '2026-01-01' + INTERVAL (i) SECOND AS ts, sin(i) AS torque FROM range(400) t(i)"
        )
    made = invoke("readings", "--database", str(path), "--window", "50", "--out", str(script))
    assert (made.exit_code, made.stdout) == (0, "")
    with duckdb.connect(str(path)) as connection:
        connection.execute(script.read_text())
        rows = connection.sql(
            "SELECT min(asset), min(channel), count(*) FROM gam_live_health"
        ).fetchall()
    assert rows == [("r1", "j1", 320)]


def test_a_folder_is_read_by_the_engine_that_reads_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """For another engine its name is that of a table."""
    monkeypatch.chdir(tmp_path)
    Path("plant").mkdir()
    readings = "'x' AS channel, i AS time, sin(i) AS value FROM range(400) t(i)"
    with duckdb.connect() as connection:
        for asset in "ab":
            rows = connection.sql(f"SELECT '{asset}' AS asset, {readings}")
            rows.write_parquet(f"plant/{asset}.parquet")
        connection.execute(invoke("plant", "--window", "50").stdout)
        found = connection.sql("SELECT DISTINCT asset FROM gam_live_health ORDER BY asset").fetchall()
    assert found == [("a",), ("b",)]
    assert 'FROM public."plant"' in invoke("plant", "--engine", "postgres").stdout


def test_a_column_that_a_script_cannot_read_as_time_is_refused_with_a_remedy(tmp_path: Path) -> None:
    """`gam run` reads it."""
    path = tmp_path / "plant.parquet"
    with duckdb.connect() as connection:
        connection.sql(
            "SELECT 'a' AS asset, 'x' AS channel, strftime(to_timestamp(i), '%Y-%m-%dT%H:%M:%S') AS ts, "
            "sin(i) AS value FROM range(400) t(i)"
        ).write_parquet(str(path))
    found = invoke(str(path))
    assert found.exit_code == 1
    said = " ".join(found.stderr.split())
    assert "The time column 'ts' is of type VARCHAR; it must be a timestamp" in said
    assert "by a function that takes its format and rejects trailing characters" in said


def test_a_schema_takes_all_that_is_made() -> None:
    with duckdb.connect() as connection:
        connection.execute('CREATE SCHEMA "the plant"')
        connection.execute(
            "CREATE TABLE telemetry AS "
            "SELECT 'a' AS asset, 'x' AS channel, i AS time, sin(i) AS value FROM range(400) t(i)"
        )
        for _ in range(2):  # a script begins with dropping what it makes
            connection.execute(invoke("telemetry", "--window", "50", "--schema", "the plant").stdout)
        made = "FROM duckdb_tables() UNION ALL SELECT schema_name FROM duckdb_views() WHERE NOT internal"
        schemas = connection.sql(f"SELECT schema_name {made}").fetchall()
        assert sorted(set(schemas)) == [("main",), ("the plant",)]
        assert schemas.count(("main",)) == 1
        assert connection.sql('FROM "the plant".gam_live_health').fetchall()
        found = connection.sql("FROM \"the plant\".gam_live_health_of('a', 'x')").fetchall()
        assert found


def test_postgres_writes_the_schema_of_all_tables() -> None:
    script = invoke("telemetry", "--engine", "postgres", "--schema", "the plant").stdout
    assert script.count("\nSET search_path TO pg_catalog, pg_temp;\n") == 1
    assert 'FROM public."telemetry"' in script
    assert 'ALTER VIEW "the plant".gam_live_new_health RENAME TO gam_live_health;' in script


@pytest.mark.parametrize(
    ("part", "words"),
    [
        ("Name a SOURCE", []),
        ("'postgres'", ["t", "--engine", "postgre"]),
        ("--channel", ["t", "--wide"]),
        ("cannot be written", ["t", "--out", "/nowhere/at/all.sql"]),
        ("m <= ", ["t", "--m", "12"]),
        ("sqlite has no schemas", ["t", "--engine", "sqlite", "--schema", "s"]),
    ],
)
def test_errors_are_one_paragraph(
    part: str, words: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    found = invoke(*words)
    assert found.exit_code == 1
    assert part in " ".join(found.stderr.split())
    assert "Traceback" not in found.stderr


def test_a_script_without_the_probe_is_said_not_to_ask_what_would_be_seen() -> None:
    """Its channels are called ready where gam run may call them blind."""
    for words, is_unprobed in (
        (["--paper"], True),
        (["--paper", "--without", "probe"], True),
        (["--paper", "--without", "nothing"], False),
        (["--paper", "--without", "certificate"], False),
        (["--tau", "1", "--m", "3", "--bins", "20", "--window", "500"], False),
    ):
        found = invoke("telemetry", "--time-kind", "counter", *words)
        assert found.exit_code == 0
        assert ("may still not show a change" in " ".join(found.stderr.split())) == is_unprobed


def test_the_engine_of_the_database_is_the_default(tmp_path: Path) -> None:
    path = tmp_path / "plant.db"
    with sqlite3.connect(path) as connection:
        connection.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time INTEGER, value REAL)")
    address = f"sqlite:///{path}"
    made = invoke("telemetry", "--database", address)
    assert made.exit_code == 0, made.output
    assert made.stdout == invoke("telemetry", "--database", address, "--engine", "sqlite").stdout
    assert made.stdout != invoke("telemetry", "--database", address, "--engine", "duckdb").stdout


def test_what_is_assumed_of_a_table_that_nobody_sees_is_said() -> None:
    assumed = "takes ts for an integer counter"
    assert assumed in invoke("telemetry", "--time", "ts").stderr
    for words in (["--time-kind", "counter"], ["--calibration-duration", "3 d"]):
        assert assumed not in invoke("telemetry", "--time", "ts", *words).stderr
