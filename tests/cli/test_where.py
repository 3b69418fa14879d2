"""A condition is SQL with gam's rights: on DuckDB connections of our own it opens no other file."""

from pathlib import Path
from typing import Any

import duckdb
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import gam_db
from gam_db import langevin
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import SourceError
from gam_db.settings.source import parsed_condition

#: Conditions that open another file; they hold on every row if they may.
OPENING = (
    "(SELECT COUNT(*) FROM read_text('other.csv')) = 1",
    "(SELECT COUNT(*) FROM read_csv('other.csv')) = 1",
    "(SELECT COUNT(*) FROM read_parquet('other.parquet')) = 1",
    "(SELECT COUNT(*) FROM 'other.parquet') = 1",
    "(SELECT COUNT(*) FROM parquet_metadata('data/../other.parquet')) >= 1",
    "(SELECT COUNT(*) FROM sniff_csv('other.csv')) = 1",
    "(SELECT COUNT(*) FROM glob('other.*')) = 2",
)

#: What gam demo asks of its series, shorter.
METHOD = ("--m", "2", "--tau", "1", "--bins", "4", "--window", "40")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data" / "more").mkdir(parents=True)
    series = langevin.series()[:900]
    parquet.write_table(series[:500], "data/one.parquet")
    parquet.write_table(series[500:], "data/more/two.parquet")
    parquet.write_table(series[:1], "other.parquet")
    (tmp_path / "other.csv").write_text("a\n1\n", encoding="utf-8")
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute("CREATE VIEW seen AS FROM read_parquet('data/**/*.parquet')")
        connection.execute("CREATE VIEW odd AS SELECT '**a/**.b' AS a, './*/../' AS b, '.' AS c")
        connection.execute("CREATE TABLE kept AS FROM seen")
    return tmp_path


def invoked(*words: str) -> Any:
    return CliRunner().invoke(app, words)


@pytest.mark.parametrize("where", OPENING)
def test_a_condition_opens_no_other_file(where: str) -> None:
    """Even where it was let: by the command line, from Python, and beside a database."""
    answer = invoked("check", "data/one.parquet", "--where", where, "--where-any")
    assert answer.exit_code == 1
    assert "can open the source and the results, and no other file" in answer.stderr
    for source in ("kept", "data/one.parquet"):
        with pytest.raises(SourceError, match="no other file"):
            gam_db.health_indicator(gam_db.Source(source, where=where), engine="plant.duckdb")


def test_nor_does_that_of_a_monitor(folder: Path) -> None:
    source = gam_db.Source("kept", where=OPENING[0])
    with gam_db.Monitor("plant.duckdb", source) as monitor:
        monitor.migrate()
        with pytest.raises(SourceError, match="no other file"):
            monitor.calibrate()


@pytest.mark.parametrize("where", OPENING[::4])
def test_a_lent_connection_keeps_its_settings(where: str) -> None:
    """There a condition may do what the connection may."""
    with duckdb.connect("plant.duckdb") as connection:
        assert gam_db.check(gam_db.Source("kept", where=where), engine=connection).num_rows
        settings = "SELECT current_setting('enable_external_access'), current_setting('allowed_paths')"
        assert connection.execute(settings).fetchall() == [(True, [])]


def test_other_tables_and_the_source_itself_may_be_asked() -> None:
    for where in (
        "time < (SELECT MAX(time) FROM kept)",
        "time >= (SELECT MIN(time) FROM seen)",
        "time >= (SELECT MIN(time) FROM 'data/one.parquet')",
    ):
        words = ("--database", "plant.duckdb", "--where", where, "--where-any", "--no-out")
        answer = invoked("run", "seen", *words, *METHOD)
        assert answer.exit_code in (0, 2), answer.stderr


@pytest.mark.parametrize(
    ("source", "out"),
    [
        (("data/**/*.parquet",), "found.duckdb"),
        (("data/*.parquet",), "found.db"),
        (("seen", "--database", "plant.duckdb"), "found.parquet"),
        (("kept", "--database", "plant.duckdb"), "data/found.duckdb"),
    ],
)
def test_a_condition_changes_nothing_else(folder: Path, source: tuple[str, ...], out: str) -> None:
    """Patterns, views on files, results as Parquet and in a second file, which is written twice."""
    for every in ("vector", "stride"):
        words = ("--where", "value < 1e9", "--every", every)
        answer = invoked("run", *source, *METHOD, "--out", out, *words)
        assert answer.exit_code in (0, 2), answer.stderr
    assert (folder / out).exists()
    assert not list(folder.rglob(".*"))
    assert not list(folder.rglob("*.wal*"))


def test_a_monitor_with_a_condition_is_watched_as_any_other(folder: Path) -> None:
    """Its file is checkpointed, its results are spilt, and its copy is written."""
    (folder / "gam.toml").write_text(
        '[source]\nrelation = "seen"\ndatabase = "plant.duckdb"\nwhere = "value < 1e9"\n'
        "[parameters]\nm = 2\ntau = 1\nbins = 4\nwindow = 40\n",
        encoding="utf-8",
    )
    words = (
        *(("migrate",), ("calibrate",), ("score", "--copy", "copy.duckdb"), ("score", "--full")),
        *(("status",), ("check", "--state")),
    )
    for command in words:
        answer = invoked(*command)
        assert answer.exit_code in (0, 2), (command, answer.stderr)
    with duckdb.connect("copy.duckdb", read_only=True) as copy:
        assert copy.execute("SELECT COUNT(*) > 0 FROM gam_state_bucket").fetchall() == [(True,)]


def test_what_was_not_named_before_is_told_to_be_named() -> None:
    plain = gam_db.Source("data/one.parquet", where="value < 1e9")
    with gam_db.connect() as session:
        assert gam_db.check(plain, engine=session).num_rows
        assert gam_db.check(gam_db.Source(langevin.series()[:900]), engine=session).num_rows
        with pytest.raises(SourceError, match="no other file"):
            gam_db.check(gam_db.Source("data/more/two.parquet"), engine=session)
    with gam_db.connect(files=["data/more/two.parquet"]) as session:
        gam_db.check(plain, engine=session)
        assert gam_db.check(gam_db.Source("data/more/two.parquet"), engine=session).num_rows


def test_another_connection_of_the_process_is_left_alone() -> None:
    """Two connections to one file share its settings."""
    with duckdb.connect("plant.duckdb") as other, gam_db.connect("plant.duckdb") as session:
        assert gam_db.check(gam_db.Source("kept", where="value < 1e9"), engine=session).num_rows
        assert other.execute("SELECT COUNT(*) FROM 'other.parquet'").fetchall() == [(1,)]


def test_remote_sources_are_read_as_before() -> None:
    """What reads them is loaded when it is needed, so nothing is shut."""
    answers = [
        invoked("check", "https://127.0.0.1:9/a.parquet", *where).stderr
        for where in ((), ("--where", "value < 1e9"))
    ]
    assert answers[0] == answers[1]
    assert "cannot be read" in answers[0] or "DuckDB's extension httpfs" in answers[0]
    with DuckSession() as session:
        session.driver.sources.append("s3://bucket/a.parquet")
        loaded = session.load(langevin.series()[:9])
        session.check_condition(loaded, parsed_condition("value < 9"), "value < 9")
        shut = "SELECT current_setting('enable_external_access')"
        assert session.connection.execute(shut).fetchall() == [(True,)]


def test_help_says_whose_rights_a_condition_has() -> None:
    for command in ("run", "check", "calibrate"):
        said = " ".join(invoked(command, "--help").stdout.replace("│", " ").split())
        assert "SQL that runs with your rights" in said
        assert "your own connection" in said
