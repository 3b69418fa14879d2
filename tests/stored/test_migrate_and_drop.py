"""``gam migrate`` and ``gam drop``: what they print, change and refuse."""

import dataclasses
import hashlib
import json
import re
from pathlib import Path

import duckdb
import pytest
from typer.testing import CliRunner, Result

from gam_db.cli import app
from gam_db.engines import engine_named
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import EngineError, StateError
from gam_db.stored.schema import dropping
from gam_db.stored.schema.migration_files import create_statements, definitions, files
from gam_db.stored.schema.migrations import migrate, rendered, require
from gam_db.stored.schema.tables import StateTables
from gam_db.version import __version__
from state_names import called

pytestmark = pytest.mark.migrates

STATE = StateTables()
FILE = "plant.duckdb"
TABLES_OF_A_MONITOR = 28


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


def gam(*words: str, typed: str | None = None) -> Result:
    return CliRunner().invoke(app, list(words), input=typed)


def told(result: Result) -> str:
    """What a command says on stderr, on one line."""
    return " ".join(result.stderr.split())


def counts() -> dict[str, int]:
    """The rows of every table in the file, views left out."""
    with duckdb.connect(FILE, read_only=True) as connection:
        names = connection.execute("SELECT schema_name || '.' || table_name FROM duckdb_tables()")
        return {
            name: connection.execute(f"SELECT COUNT(*) FROM {name}").fetchall()[0][0]
            for (name,) in names.fetchall()
        }


def fill(connection: duckdb.DuckDBPyConnection, *monitors: int) -> None:
    """Give each monitor two channels, each with a version of its own and rows in every table."""
    for monitor in monitors:
        connection.execute(
            f"INSERT INTO gam_state_monitor VALUES ({monitor}, 'm{monitor}', 's', 'long', 'a', 'c', "
            "'t', 'v', NULL, 'counter', 0)"
        )
        connection.execute(
            f"INSERT INTO gam_state_unplaced VALUES ({monitor}, 0, 1, 2, 3, 4, 5, 6), "
            f"({monitor}, 1, 1, 2, 3, 4, NULL, NULL)"
        )
        connection.execute(
            f"INSERT INTO gam_state_left_out VALUES ({monitor}, 1, 'unknown', 'z', 'c', 3, 9), "
            f"({monitor}, 1, 'ahead', 'a', 'c', 1, 10)"
        )
        for key in (10 * monitor, 10 * monitor + 1):
            for table, values in {
                "channel": f"{key}, {monitor}, 'a', 'c{key}'",
                "version": f"{key + 100}, {key}, {key + 200}, NULL, 1, 'active', 'r', 3, 1, 10, 50, 10, "
                "NULL, NULL, 0.05, NULL, 0, 0, 0, 0, 'h', 'h', 0, NULL, NULL, 1, NULL, NULL",
                "calibration": f"{key + 100}, 0, 1",
                "bounds": f"{key + 200}, 0, 1, 0, 0, NULL, NULL, 0, 0.5, 1, 2, 3, 4, 5, 'ready', 0, "
                f"0, 0, 1, 0, 5, {', '.join(['NULL'] * 13)}",
                "block": f"{key + 200}, 0, {key}, 0, 1, 2, 3",
                "ladder": f"{key + 200}, 4, 0.5",
                "probe": f"{key + 200}, 1, 'frozen', 9, 3",
                "program": f"{key + 200}, 0, 'p', 9, 3, 'ready'",
                "support": f"{key + 200}, 1, 2, 0, 0, 0, 1",
                "bucket": f"{key + 100}, 0, 1, 0, 1, 0, 1, 1, 0, NULL, NULL, NULL",
                "unknown_program": f"{key + 100}, 0, 1, 'q', 1, 1, 1",
                "novel": f"{key + 100}, 0, 1, 1, 1, 1, 1",
                "run": f"1, {key + 100}, 0, 0, 0, 0, 0, NULL, NULL, 0, NULL, NULL, NULL, 0, 0, 0, "
                "NULL, NULL, NULL, NULL, NULL",
                "checksum": f"{key + 100}, 1, 2, 3, 0, 1, 0.05, 'h', 'h'",
                "horizon": f"{key + 100}, 0, 1",
                "proof": f"{monitor}, {key}, 'state', 2, 2, 2, 0",
                "buffered": f"{key + 100}, 0, 1, 10, 1",
                "band": f"{key + 100}, 1, 0, 10, 1",
                "band_visit": f"{key + 100}, 0, 1, 0, 10, 1",
                "move": f"{key + 100}, 0, 1, 1, 1.0, 2.0, 10, 1, 1, 0",
                "extent": f"{key + 100}, 80, 80, 1000",
                "limit": f"{key + 100}, 1, 0, 0, 'calibrated', '1 per month', 0, 8, 1, 1, 1, 2, 3, "
                "2, 12, 'table', NULL, NULL, 0.001, 0.001, NULL",
                "judgement": f"{key + 100}, 0, 1, 0, 0, 1, 1, 1, 2, 3, 4, 1, NULL",
                "episode": f"{monitor}, {key}, {key}, 0, 'opened', 'open', NULL, {key}, {key + 100}, "
                "0, 0, 0, 0, 0, 1, 4, 3, 0",
                "label": f"{monitor}, {key}, {key}, 'a', 0, 1, 'snoozed', NULL, NULL, 0",
            }.items():
                connection.execute(f"INSERT INTO {called(table)} VALUES ({values})")


# gam migrate


def test_migrate_makes_the_state_and_status_says_so() -> None:
    made = gam("migrate", "--database", FILE)
    assert (made.exit_code, made.stderr) == (0, "")
    assert "gam_*: applied 1 tables, 2 state_views, 3 signals" in made.stdout
    again = gam("migrate", "--database", FILE)
    assert again.stdout == f"gam_*: up to date, {len(files())} migrations\n"
    shown = gam("migrate", "--database", FILE, "--status")
    assert shown.exit_code == 0
    assert len(shown.stdout.splitlines()) == len(files()) + 2


def test_status_writes_nothing_and_tells_what_is_pending() -> None:
    duckdb.connect(FILE).close()
    before = hashlib.sha256(Path(FILE).read_bytes()).hexdigest()
    found = gam("migrate", "--database", FILE, "--status", "--json")
    assert found.exit_code == 2
    figures = json.loads(found.stdout)
    assert [one["number"] for one in figures["pending"]] == [one.number for one in files()]
    assert (figures["applied"], figures["exit_code"]) == ([], 2)
    assert hashlib.sha256(Path(FILE).read_bytes()).hexdigest() == before
    assert [path.name for path in Path().iterdir()] == [FILE]
    assert "pending; run `gam migrate`" in gam("migrate", "--database", FILE, "--status").stdout


def test_the_place_can_come_from_the_settings_file() -> None:
    Path("gam.toml").write_text(
        f"[source]\ndatabase = '{FILE}'\n[monitor]\nschema = 'north'\nprefix = 'x_'\n"
    )
    assert gam("migrate").exit_code == 0
    assert gam("migrate", "--prefix", "y_").exit_code == 0
    found = json.loads(gam("migrate", "--status", "--json").stdout)
    assert (found["schema"], found["prefix"], found["pending"]) == ("north", "x_", [])
    assert {"north.x_state_run", "north.y_state_run"} <= counts().keys()


def test_the_script_is_printed_without_a_database() -> None:
    found = gam("migrate", "--sql", "--engine", "postgres", "--prefix", "x_")
    expected = rendered(engine_named("postgres"), StateTables(prefix="x_"))

    def timeless(script: str) -> list[str]:
        return re.sub(r"\d{16}(?= AS BIGINT\) AS applied_at)", "now", script).splitlines()

    assert found.exit_code == 0
    assert timeless(found.stdout) == timeless(expected)
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize(
    ("words", "part"),
    [
        (["migrate"], "Name the database that holds the state"),
        (["migrate", "--database", FILE, "--status"], "There is no database file"),
        (["migrate", "--sql", "--status"], "leave out --status"),
        (["migrate", "--database", FILE, "--engine", "duckdb"], "add --sql"),
        (["migrate", "--sql", "--engine", "duckdbb"], "'duckdb'"),
        (["migrate", "--database", FILE, "--prefix", "a b"], "prefix is 'a b'"),
        (["migrate", "--database", "nowhere/plant.duckdb"], "There is no database file"),
        (["drop", "--database", FILE], "There is no database file"),
    ],
)
def test_errors_are_one_paragraph_and_make_no_file(words: list[str], part: str) -> None:
    found = gam(*words)
    assert found.exit_code == 1
    assert part in told(found)
    assert list(Path().iterdir()) == []


def test_a_schema_called_like_the_file_is_refused() -> None:
    """DuckDB takes plant.x for a table x of the database plant, and for one of a schema plant."""
    found = gam("migrate", "--database", FILE, "--schema", "Plant")
    assert found.exit_code == 1
    assert "'Plant' has the same name as a database" in told(found)


# gam drop


def test_drop_lists_what_goes_and_asks_for_the_name() -> None:
    gam("migrate", "--database", FILE)
    with duckdb.connect(FILE) as connection:
        fill(connection, 1)
        connection.execute("CREATE TABLE gam_mine AS SELECT 1 AS a")
    before = counts()
    for typed in ("", "yes\n", "gam\n"):
        refused = gam("drop", "--database", FILE, typed=typed)
        assert refused.exit_code == 1
        assert "Nothing was removed" in told(refused)
        assert "gam_state_support" in refused.stdout
        assert ["gam_state_channel", "2"] in [line.split() for line in refused.stdout.splitlines()]
        assert "gam_mine" not in refused.stdout
    assert counts() == before
    assert gam("drop", "--database", FILE, typed="gam_\n").exit_code == 0
    assert counts() == {"main.gam_mine": 1}
    assert "no state tables" in told(gam("drop", "--database", FILE, "--yes"))


def test_one_monitor_goes_and_the_others_stay() -> None:
    gam("migrate", "--database", FILE)
    with duckdb.connect(FILE) as connection:
        fill(connection, 2)
        expected = connection.execute("SELECT * FROM gam_state_bucket ORDER BY ALL").fetchall()
        fill(connection, 1, 3)
    assert gam("drop", "--database", FILE, "--name", "m1", typed="m1\n").exit_code == 0
    removed = gam("drop", "--database", FILE, "--name", "m3", "--yes")
    assert removed.stdout == "removed: monitor m3 from gam_*\n"
    found = counts()
    assert found.pop("main.gam_state_migration") == len(files())
    assert found.pop("main.gam_state_monitor") == 1
    assert len(found) == TABLES_OF_A_MONITOR - 1
    assert set(found.values()) == {2}
    with duckdb.connect(FILE) as connection:
        assert connection.execute("SELECT * FROM gam_state_bucket ORDER BY ALL").fetchall() == expected
    unknown = gam("drop", "--database", FILE, "--name", "m4", "--yes")
    assert unknown.exit_code == 1
    assert "no monitor 'm4'" in told(unknown)
    assert "'m2'" in told(unknown)


def test_other_states_stay() -> None:
    with DuckSession(writable=True) as session:
        others = [StateTables(prefix="gam_x_"), StateTables("plant")]
        for tables in (STATE, *others):
            migrate(session, tables)
        dropping.remove(session, dropping.removals(session, STATE))
        assert not [name for name in session.relations() if not name.startswith("gam_x_")]
        for tables in others:
            require(session, tables)


def test_tables_without_a_record_are_not_ours_to_drop() -> None:
    with DuckSession(writable=True) as session:
        session.connection.execute("CREATE TABLE gam_state_support AS SELECT 1 AS a")
        with pytest.raises(StateError, match=r"no state tables gam_\*"):
            dropping.removals(session, STATE)


def test_a_newer_state_is_not_dropped_and_a_broken_one_is() -> None:
    with DuckSession(writable=True) as session:
        migrate(session, STATE)
        session.connection.execute("DROP TABLE gam_state_support")
        session.connection.execute("INSERT INTO gam_state_migration VALUES (99, 'x', 'y', 0, '7.1')")
        with pytest.raises(StateError, match=r"7\.1"):
            dropping.removals(session, STATE)
        session.connection.execute("DELETE FROM gam_state_migration WHERE number = 99")
        session.connection.execute("UPDATE gam_state_migration SET checksum = 'x' WHERE number = 1")
        dropping.remove(session, dropping.removals(session, STATE))
        assert session.relations() == {}


def test_what_a_migration_that_was_cut_short_left_is_dropped() -> None:
    """Where definitions cannot be undone: the record is there, and none of its rows."""
    with DuckSession(writable=True) as session:
        migrate(session, STATE)
        session.connection.execute("DROP VIEW gam_fleet")
        session.connection.execute("CREATE VIEW gam_fleet AS SELECT 1 AS mine")
        session.connection.execute("DELETE FROM gam_state_migration")
        dropping.remove(session, dropping.removals(session, STATE))
        assert set(session.relations()) == {"gam_fleet"}


def as_of_before(session: DuckSession) -> None:
    """Make the tables of a state under the names of before schema 0.1, and the rows of its record."""
    names = dataclasses.replace(STATE, apart="")
    for name, about in definitions().items():
        for statement in create_statements(about, name, session.engine, names):
            session.execute(statement)
    for number, name in enumerate(("migration", "monitor", "run", "run", "visible_bucket", "fleet"), 1):
        row = f"{number}, '{name}', 'x', 0, '0.0.9'"
        session.connection.execute(f"INSERT INTO gam_migration VALUES ({row})")


def test_a_state_of_before_is_refused_in_one_sentence_and_can_be_dropped() -> None:
    with DuckSession(FILE, writable=True) as session:
        as_of_before(session)
        session.connection.execute(
            "CREATE TABLE telemetry AS SELECT 'a' AS asset, 1 AS time, 1.0 AS value"
        )
        before = session.relations()
    said = (
        "gam: gam-db 0.0.9 made the state tables gam_* in another form than gam-db "
        f"{__version__} needs: drop them with `gam drop --yes`, then `gam calibrate` makes them anew."
    )
    place = ("--database", FILE)
    commands = ("migrate", "calibrate telemetry", "score", "status", "check --state", "prune", "alarms")
    for words in commands:
        found = gam(*words.split(), *place)
        assert (found.exit_code, told(found)) == (1, said), words
    dropped = gam("drop", *place, typed="gam_\n")
    assert ["gam_run", "0"] in [line.split() for line in dropped.stdout.splitlines()]
    with DuckSession(FILE) as session:
        # The record lists six files: of what it does not list nobody knows whose it is.
        gone = {"gam_migration", "gam_monitor", "gam_run", "gam_visible_bucket", "gam_fleet"}
        assert set(session.relations()) == before.keys() - gone


def test_another_state_may_begin_like_ours() -> None:
    """The record of one with the prefix gam_state_ is called as ours is."""
    longer = StateTables(prefix="gam_state_", apart="")
    with DuckSession(writable=True) as session:
        for name, about in definitions().items():
            for statement in create_statements(about, name, session.engine, longer):
                session.execute(statement)
        session.connection.execute(
            "INSERT INTO gam_state_migration VALUES (1, 'migration', 'x', 0, '0')"
        )
        with pytest.raises(StateError, match="no state tables"):
            dropping.removals(session, STATE)
        found = dropping.removals(session, StateTables(prefix="gam_state_"))
        assert [one.table.name for one in found] == ["gam_state_migration"]


def test_all_is_removed_or_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    with DuckSession(writable=True) as session:
        migrate(session, STATE)
        before = session.relations()
        found = dropping.removals(session, STATE)
        execute = session.execute

        def failing(statement: object) -> None:
            if statement is found[-1].statement:
                raise EngineError("the power went")
            execute(statement)  # type: ignore[arg-type]

        monkeypatch.setattr(session, "execute", failing)
        with pytest.raises(EngineError, match="power"):
            dropping.remove(session, found)
        assert session.relations() == before
