"""SQLite's own ways: instants as texts, declared types, other connections, what cannot be opened."""

import datetime as dt
import sqlite3
from pathlib import Path

import pytest
import sqlglot
from sqlglot import exp
from typer.testing import CliRunner

import gam_db
from gam_db.cli import app
from gam_db.clock import TimeKind, instant
from gam_db.engines import engine_named
from gam_db.errors import EngineError, SourceError

SECOND = 1_000_000


def plant(path: Path, form: str) -> sqlite3.Connection:
    """A database with two hours of one joint, its times written in a form of strftime."""
    connection = sqlite3.connect(path, isolation_level=None)
    connection.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time TEXT, value REAL)")
    grow(connection, form, 0, 4800)
    return connection


def grow(connection: sqlite3.Connection, form: str, start: int, end: int) -> None:
    connection.execute(
        "WITH RECURSIVE n(i) AS (SELECT ? UNION ALL SELECT i + 1 FROM n WHERE i + 1 < ?) "
        "INSERT INTO telemetry SELECT 'a', 'x', strftime(?, 1700000000 + i, 'unixepoch'), "
        "(i * 7 % 13) / 13.0 + (i > 4000) * (i % 5) FROM n",
        (start, end, form),
    )


@pytest.mark.parametrize("form", ["%Y-%m-%d %H:%M:%S", "%Y-%m-%dT%H:%M:%S", "%Y-%m-%d %H:%M:%f"])
def test_instants_as_texts_lose_no_row_at_the_edge(tmp_path: Path, form: str) -> None:
    connection = plant(tmp_path / "plant.db", form)
    parameters = gam_db.Parameters(m=2, bins=20, window=500)
    with gam_db.connect(f"sqlite:///{tmp_path / 'plant.db'}") as session:
        source = gam_db.Source("telemetry")
        monitor = gam_db.Monitor(session, source, parameters, lookback="5 min")
        monitor.migrate()
        monitor.calibrate()
        for start in (4800, 6000, 6001):
            report = monitor.score()
            found = report.channels[0]
            if start > 4800:  # the first run reads everything
                assert found["context_rows"] == found["context_expected"]
            grow(connection, form, start, {4800: 6000, 6000: 6001, 6001: 7200}[start])
        monitor.score()
        once = gam_db.health_at_buckets(source, parameters, gam_db.Calibration(), session)
        health = monitor.health()
        # Calibration was frozen on the first 4,800 samples; the exact form takes a fifth of all.
        assert health.num_rows == (7200 - 960) // 100
        assert once.num_rows == (7200 - 1440) // 100
        assert monitor.check_state().num_rows == 0
    connection.close()


def test_a_range_may_end_on_the_last_day_of_the_calendar() -> None:
    engine, column = engine_named("sqlite"), exp.column("time")
    texts = ["9999-12-31 11:00:00", "9999-12-31T12:00:00", "9999-12-31 13:00:00", "2026-01-01"]
    end = instant("9999-12-31 12:00:00", TimeKind.TIMESTAMP, "end")
    connection = sqlite3.connect(":memory:")
    connection.execute("CREATE TABLE t (time TEXT)")
    connection.executemany("INSERT INTO t VALUES (?)", [(text,) for text in texts])
    for earliest, expected in ((None, 3), (end, 1)):
        conditions = engine.in_range(TimeKind.TIMESTAMP, column, earliest, end)
        query = exp.select(exp.Count(this=exp.Star())).from_("t").where(exp.and_(*conditions))
        assert connection.execute(engine.text(query)).fetchone() == (expected,)
    connection.close()


@pytest.mark.parametrize("offset", ["", "Z", "+05:30", "-11:00"])
@pytest.mark.parametrize("parted", [" ", "T"])
def test_texts_tell_their_instant_and_lie_in_its_range(parted: str, offset: str) -> None:
    """STRFTIME takes 59.9995 for the next second; what follows the digits is no digit."""
    engine, column, kind = engine_named("sqlite"), exp.column("time"), TimeKind.TIMESTAMP
    fractions = ["", ".5", ".25", ".123456", ".1234567", ".999", ".9995", ".999999", ".000001"]
    moments = [
        "1969-12-31{}23:59:59",
        "1970-01-01{}00:00:00",
        "2026-11-26{}12:00:59",
        "2026-11-26{}00:01",
    ]
    texts = [
        f"{moment.format(parted)}{fraction}{offset}" for moment in moments[:-1] for fraction in fractions
    ]
    texts += [moments[-1].format(parted) + offset]
    read = engine.micros_of(kind, column)
    connection = sqlite3.connect(":memory:")
    connection.execute("CREATE TABLE t (time TEXT)")
    for text in texts:
        # Python reads digits beyond microseconds as the method does: they are cut off.
        told = dt.datetime.fromisoformat(text)
        told = told if told.tzinfo else told.replace(tzinfo=dt.UTC)
        micros = (told - dt.datetime(1970, 1, 1, tzinfo=dt.UTC)) // dt.timedelta(microseconds=1)
        connection.execute("INSERT INTO t VALUES (?)", [text])
        assert connection.execute(engine.text(exp.select(read).from_("t"))).fetchone() == (micros,), text
        for earliest, latest, expected in (
            (micros, micros, 1),
            (None, micros - 1, 0),
            (micros + 1, None, 0),
        ):
            conditions = engine.in_range(kind, column, earliest, latest)
            query = exp.select(exp.Count(this=exp.Star())).from_("t").where(exp.and_(*conditions))
            assert connection.execute(engine.text(query)).fetchone() == (expected,), text
        connection.execute("DELETE FROM t")
    connection.close()


def test_an_open_connection_keeps_its_ways(tmp_path: Path) -> None:
    mine = sqlite3.connect(tmp_path / "plant.db")
    mine.execute("CREATE TABLE t (asset TEXT, channel TEXT, time INTEGER, value REAL)")
    mine.commit()
    level = mine.isolation_level
    with gam_db.connect(mine) as session:
        assert session.relations() == {"t": ("asset", "channel", "time", "value")}
    assert mine.isolation_level == level
    assert mine.execute("SELECT COUNT(*) FROM t").fetchone() == (0,)
    mine.execute("INSERT INTO t VALUES ('a', 'x', 1, 1.0)")
    with pytest.raises(EngineError, match="transaction open"):
        gam_db.connect(mine)
    mine.close()


def test_a_view_is_judged_by_its_first_value(tmp_path: Path) -> None:
    with sqlite3.connect(tmp_path / "plant.db") as connection:
        connection.execute("CREATE TABLE raw (machine, tick, reading)")
        connection.executemany("INSERT INTO raw VALUES ('a', ?, ?)", [(i, i / 7) for i in range(50)])
        connection.execute("CREATE VIEW telemetry AS SELECT machine, tick + 0 AS tick, reading FROM raw")
    connection.close()
    source = gam_db.Source("telemetry", asset="machine", channel=None, time="tick", value="reading")
    address = f"sqlite:///{tmp_path / 'plant.db'}"
    assert gam_db.support(source, engine=address)["samples"].to_pylist() == [50]


@pytest.mark.parametrize(
    ("address", "message"),
    [
        ("sqlite:///{0}/none.db", "no database file"),
        ("sqlite://server/plant", "three slashes"),
        ("sqlite:///{0}/text.db", "is it a SQLite file"),
    ],
)
def test_what_cannot_be_opened(tmp_path: Path, address: str, message: str) -> None:
    (tmp_path / "text.db").write_text("no database at all, but long enough to look like one\n" * 20)
    source = gam_db.Source("telemetry")
    with pytest.raises(EngineError, match=message):
        gam_db.support(source, engine=address.format(tmp_path))


def test_what_sqlite_has_not(tmp_path: Path) -> None:
    with gam_db.connect(f"sqlite:///{tmp_path / 'plant.db'}") as session:
        with pytest.raises(SourceError, match="does not read files by path"):
            session.relation("telemetry.parquet")
        with pytest.raises(EngineError, match="no schemas"):
            gam_db.Monitor(session, gam_db.Source("t"), schema="plant").migrate()
        session.execute(sqlglot.parse_one("CREATE TABLE telemetry (a INT)"))
        with pytest.raises(SourceError, match="did you mean 'telemetry'"):
            session.relation("telemetri")


def test_the_command_line_takes_an_address(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    plant(tmp_path / "plant.db", "%Y-%m-%d %H:%M:%S").close()
    monkeypatch.setenv("GAM_DATABASE", "sqlite:///plant.db")
    words = {
        "check": ["telemetry"],
        "run": ["telemetry", "--no-out", "--window", "500"],
        "calibrate": ["telemetry", "--window", "500"],
        "score": [],
        "check --state": [],
        "prune": [],
        "drop": ["--yes"],
    }
    for command, more in words.items():
        result = CliRunner().invoke(app, [*command.split(), *more])
        assert result.exit_code in (0, 2, 4), (command, result.output)
    wrong = CliRunner().invoke(app, ["status", "--database", "sqlite:///other.db"])
    assert "no database file other.db" in wrong.stderr
    (tmp_path / "gam.toml").write_text('[source]\ndatabase = "postgresql://me:secret@host/db"\n')
    wrong = CliRunner().invoke(app, ["status"])
    assert "PGPASSWORD" in wrong.stderr
    assert "secret" not in wrong.output


def test_another_writer_and_a_reader(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "plant.db"
    monkeypatch.setattr("gam_db.engines.sqlite.driver.PATIENCE", 0.1)
    connection = plant(path, "%Y-%m-%d %H:%M:%S")
    source = gam_db.Source("telemetry")
    with gam_db.connect(f"sqlite:///{path}") as session:
        monitor = gam_db.Monitor(session, source)
        monitor.migrate()
        connection.execute("BEGIN IMMEDIATE")
        with pytest.raises(EngineError, match="changed the same tables"):
            monitor.calibrate()
        connection.execute("COMMIT")
        assert monitor.calibrate().num_rows == 1
    with (
        gam_db.connect(f"sqlite:///{path}", writable=False) as session,
        pytest.raises(EngineError, match="reading only"),
    ):
        gam_db.Monitor(session, source).score()
    connection.close()
