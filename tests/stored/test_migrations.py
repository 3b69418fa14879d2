"""Migrations: fresh, twice, cut short; what is refused; the form of the files."""

import hashlib
from collections.abc import Iterator
from pathlib import Path

import pytest
from sqlglot import exp

import begun
import dictionary
import migration_lint
import sql_lint
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConfigurationError, EngineError, InternalError, StateError
from gam_db.stored.schema import migration_files, migrations
from gam_db.stored.schema.migration_files import definitions, files
from gam_db.stored.schema.migrations import migrate, rendered, require, status
from gam_db.stored.schema.tables import FOR_READERS, TABLES, VIEWS, StateTables
from state_names import called

pytestmark = pytest.mark.migrates

STATE = StateTables()
ALL = [migration.name for migration in files()]


@pytest.fixture
def session() -> Iterator[DuckSession]:
    """A database in memory."""
    with DuckSession(writable=True) as opened:
        yield opened


def rows(session: DuckSession, query: str) -> list[tuple[object, ...]]:
    found: list[tuple[object, ...]] = session.connection.execute(query).fetchall()
    return found


def catalog(session: DuckSession) -> list[tuple[object, ...]]:
    """Everything that a database says of its tables, views, columns and comments."""
    return [
        *rows(session, "SELECT schema_name, table_name, sql, comment FROM duckdb_tables() ORDER BY ALL"),
        *rows(
            session,
            "SELECT schema_name, view_name, sql, comment FROM duckdb_views() WHERE NOT internal "
            "ORDER BY ALL",
        ),
        *rows(
            session,
            "SELECT schema_name, table_name, column_name, data_type, is_nullable, comment "
            "FROM duckdb_columns() WHERE NOT internal ORDER BY ALL",
        ),
    ]


def test_the_names_are_those_of_the_files() -> None:
    assert [name for file in files() for name in file.definitions] == [*TABLES, *VIEWS]
    assert [name for name, made in definitions().items() if made.is_view] == list(VIEWS)


# Applying


def test_what_other_tests_begin_with_is_what_a_migration_makes(monkeypatch: pytest.MonkeyPatch) -> None:
    """But for comments, which are left out there."""
    queries = (
        "SELECT sql FROM duckdb_tables() WHERE NOT temporary ORDER BY ALL",
        "SELECT sql FROM duckdb_views() WHERE NOT internal ORDER BY ALL",
        "SELECT sql FROM duckdb_indexes() ORDER BY ALL",
        "SELECT number, name, checksum, gam_version FROM gam_state_migration ORDER BY ALL",
    )
    found = []
    for is_copied in (False, True):
        monkeypatch.setattr(begun, "is_copied", is_copied)
        with DuckSession() as session:
            assert [one.name for one in begun.migrate(session, STATE)] == [one.name for one in files()]
            found.append([rows(session, query) for query in queries])
            assert begun.migrate(session, STATE) == ()
    assert found[0] == found[1]
    assert sum(map(len, found[0])) == len(definitions()) + len(files()) + len(found[0][2])


def test_a_fresh_database_gets_every_table_with_its_comments(session: DuckSession) -> None:
    assert [migration.name for migration in migrate(session, STATE)] == ALL
    require(session, STATE)
    said = {
        (called(table), name): comment.name if table in FOR_READERS else None
        for table, definition in definitions().items()
        for name, comment in definition.columns.items()
    }
    query = "SELECT table_name, column_name, comment FROM duckdb_columns() WHERE NOT internal"
    assert {(table, column): comment for table, column, comment in rows(session, query)} == said
    query = "SELECT table_name, comment FROM duckdb_tables() UNION ALL SELECT view_name, comment "
    whole = {called(name): definition.comment.name for name, definition in definitions().items()}
    found = rows(session, query + "FROM duckdb_views() WHERE NOT internal")
    assert dict(found) == whole  # type: ignore[arg-type]
    recorded = rows(session, "SELECT number, name, checksum FROM gam_state_migration ORDER BY number")
    assert recorded == [(one.number, one.name, one.checksum) for one in files()]


def test_a_second_time_nothing_is_done(session: DuckSession) -> None:
    migrate(session, STATE)
    rows(session, "INSERT INTO gam_state_channel VALUES (1, 2, 'a', 'c')")
    before = catalog(session), rows(session, "FROM gam_state_migration")
    assert migrate(session, STATE) == ()
    assert (catalog(session), rows(session, "FROM gam_state_migration")) == before
    assert rows(session, "FROM gam_state_channel") == [(1, 2, "a", "c")]


def test_cut_short_anywhere(session: DuckSession, monkeypatch: pytest.MonkeyPatch) -> None:
    """An engine without transactions: what was made of a file stays, its record was not written."""
    monkeypatch.setattr(session, "transactions", False)
    execute = session.execute
    for number, file in enumerate(files()):
        whole = len(file.statements(ENGINE, STATE))
        for cut in (1, whole // 2, whole):
            left = cut

            def failing(statement: exp.Expr) -> None:
                nonlocal left
                left -= 1
                if left < 0:
                    raise EngineError("the power went")
                execute(statement)

            with monkeypatch.context() as short:
                short.setattr(session, "execute", failing)
                with pytest.raises(EngineError, match="power"):
                    migrate(session, STATE)
            assert len(status(session, STATE).applied) == number
        with monkeypatch.context() as older:
            older.setattr(migrations, "files", lambda number=number: files()[: number + 1])
            assert migrate(session, STATE) == (file,)
    require(session, STATE)
    with DuckSession(writable=True) as other:
        migrate(other, STATE)
        assert catalog(session) == catalog(other)


def test_on_duckdb_all_that_is_pending_and_its_record_are_one(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    before, execute = catalog(session), session.execute

    def failing(statement: exp.Expr) -> None:
        if '"gam_fleet"' in ENGINE.text(statement):
            raise EngineError("the power went")
        execute(statement)

    with monkeypatch.context() as cut:
        cut.setattr(session, "execute", failing)
        with pytest.raises(EngineError, match="power"):
            migrate(session, STATE)
    assert catalog(session) == before
    assert status(session, STATE).applied == ()
    migrate(session, STATE)
    require(session, STATE)


def test_several_states_share_a_database(session: DuckSession) -> None:
    places = [
        STATE,
        StateTables(prefix="press_"),
        StateTables('the "plant"', ""),
        StateTables("m", "x_"),
    ]
    for tables in places:
        assert len(migrate(session, tables)) == len(ALL)
    rows(session, "INSERT INTO press_state_channel VALUES (1, 2, 'a', 'c')")
    for tables in places:
        require(session, tables)
    for channels in ("gam_state_channel", "m.x_state_channel", '"the ""plant""".state_channel'):
        assert rows(session, f"FROM {channels}") == []


@pytest.mark.parametrize("tables", [STATE, StateTables("plant", "x_")], ids=str)
def test_the_script_is_what_migrate_does(session: DuckSession, tables: StateTables) -> None:
    """Run twice by hand on DuckDB it leaves what ``gam migrate`` would, and is known to be applied."""
    script = rendered(ENGINE, tables)
    session.connection.execute(script)
    session.connection.execute(script)
    require(session, tables)
    with DuckSession(writable=True) as other:
        migrate(other, tables)
        assert catalog(session) == catalog(other)


# What is refused

OF_BEFORE = r"another form than .* needs: drop them with `gam drop --yes`, then `gam calibrate` makes"


def test_without_any_state(session: DuckSession) -> None:
    assert status(session, STATE).applied == ()
    with pytest.raises(StateError, match=r"There are no state tables gam_\*.*gam migrate"):
        require(session, STATE)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            "INSERT INTO gam_state_migration VALUES (99, 'x', 'y', 0, '7.1')",
            r"gam-db 7\.1 \(migra.* 99\)",
        ),
        ("UPDATE gam_state_migration SET checksum = 'x' WHERE number = 3", OF_BEFORE),
        ("UPDATE gam_state_migration SET name = 'cell' WHERE number = 4", OF_BEFORE),
        (
            "UPDATE gam_state_migration SET checksum = 'x' WHERE number = 3;"
            "INSERT INTO gam_state_migration VALUES (99, 'x', 'y', 0, '7.1')",
            OF_BEFORE,
        ),
        ("DELETE FROM gam_state_migration WHERE number = 3", "changed by hand: it lacks number 3"),
        (
            "INSERT INTO gam_state_migration FROM gam_state_migration WHERE number = 3",
            "a number occurs twice",
        ),
        ("DROP TABLE gam_state_support", "gam_state_support no longer exists"),
        ("DROP VIEW gam_state_visible_novel", "gam_state_visible_novel no longer exists"),
        (
            "ALTER TABLE gam_state_migration RENAME name TO title",
            "The gam_state_migration .* not a state",
        ),
    ],
)
def test_a_state_that_was_changed_is_refused(session: DuckSession, change: str, message: str) -> None:
    migrate(session, STATE)
    rows(session, change)
    before = catalog(session)
    for refusing in (status, migrate, require):
        with pytest.raises(StateError, match=message):
            refusing(session, STATE)
    assert catalog(session) == before


@pytest.mark.parametrize(
    "taken",
    [
        "CREATE TABLE gam_health (asset VARCHAR, channel VARCHAR, hi DOUBLE)",
        "CREATE VIEW GAM_state_visible_bucket AS SELECT 1 AS asset",
    ],
)
def test_tables_of_others_under_our_names_are_left_alone(session: DuckSession, taken: str) -> None:
    """``gam run --out`` and the view form of ``gam compile`` may make a gam_health, too."""
    rows(session, taken)
    before = catalog(session)
    with pytest.raises(StateError, match=r"not a state table of gam-db; give another prefix or schema"):
        migrate(session, STATE)
    assert catalog(session) == before
    migrate(session, StateTables(prefix="other_"))


@pytest.mark.parametrize("number", [0, 2, len(ALL)])
def test_a_status_writes_nothing(tmp_path: Path, number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "plant.duckdb"
    with monkeypatch.context() as older, DuckSession(path, writable=True) as opened:
        older.setattr(migrations, "files", lambda: files()[:number])
        migrate(opened, STATE)
    before = hashlib.sha256(path.read_bytes()).hexdigest()
    with DuckSession(path) as reading:
        found = status(reading, STATE)
        assert [len(found.applied), len(found.pending)] == [number, len(ALL) - number]
        if found.pending:
            with pytest.raises(EngineError, match="reading only"):
                migrate(reading, STATE)
    assert [file.name for file in tmp_path.iterdir()] == [path.name]
    assert hashlib.sha256(path.read_bytes()).hexdigest() == before


def test_an_open_transaction_of_the_user_is_refused_and_left(session: DuckSession) -> None:
    rows(session, "BEGIN")
    rows(session, "CREATE TABLE mine (a INTEGER)")
    with pytest.raises(EngineError, match="transaction open"):
        migrate(session, STATE)
    rows(session, "COMMIT")
    assert set(session.relations()) == {"mine"}
    migrate(session, STATE)


@pytest.mark.parametrize(
    ("schema", "prefix"),
    [
        (None, "a b"),
        (None, "x.y"),
        (None, "1x"),
        (None, "ö"),
        (None, "x" * 41),
        (None, ""),
        ("", "gam_"),
    ],
)
def test_a_place_that_is_none_is_refused(schema: str | None, prefix: str) -> None:
    with pytest.raises(ConfigurationError, match=r"prefix|schema"):
        StateTables(schema, prefix)


def test_there_are_no_other_tables() -> None:
    with pytest.raises(InternalError, match="'runs'"):
        STATE.table("runs")


# The files

GOOD = (
    "CREATE TABLE IF NOT EXISTS stored_{0} (a BIGINT NOT NULL);\n"
    "COMMENT ON TABLE stored_{0} IS 'x'; COMMENT ON COLUMN stored_{0}.a IS 'y';"
)
RUN = GOOD.replace("{0}", "run")
BLOCK = GOOD.replace("{0}", "block")
VIEW = (
    "CREATE OR REPLACE VIEW stored_fleet AS SELECT 1 AS b;"
    "COMMENT ON VIEW stored_fleet IS 'x'; COMMENT ON COLUMN stored_fleet.b IS 'y';"
)


@pytest.mark.parametrize(
    ("made", "message"),
    [
        ({"0001_run": RUN, "0003_block": BLOCK}, "number 2 is missing"),
        ({"0001_run": RUN, "0001_block": BLOCK}, "number 2 is there twice"),
        ({"1_run": RUN}, "1_run.sql is not called like"),
        ({"0001_run": "CREATE TABLE"}, "cannot be parsed"),
        ({"0001_run": "-- nothing"}, "must begin with a table or a view"),
        ({"0001_run": RUN.partition(";")[2] + RUN}, "must begin with a table or a view"),
        ({"0001_run": RUN.replace(" IF NOT EXISTS", "")}, "something else"),
        ({"0001_run": RUN + VIEW.replace(" OR REPLACE", "")}, "something else"),
        ({"0001_run": RUN + "DROP TABLE stored_run"}, "something else"),
        ({"0001_run": BLOCK + RUN.partition(";")[0]}, "with a comment"),
        ({"0001_run": RUN.replace("run.a IS", "run.b IS")}, "with a comment"),
        ({"0001_run": VIEW + BLOCK.replace("TABLE stored_block IS", "TABLE stored_run IS")}, "comment"),
        ({"0001_run": RUN.replace("stored_", "")}, "must make stored_<name>"),
        ({"0001_run": RUN, "0002_more": VIEW + RUN}, "0002_more.sql makes stored_run again"),
    ],
)
def test_a_file_that_breaks_the_form_is_refused(
    tmp_path: Path, made: dict[str, str], message: str
) -> None:
    for name, text in made.items():
        (tmp_path / f"{name}.sql").write_text(text)
    with pytest.raises(migration_lint.MigrationError, match=message):
        migration_lint.check(tmp_path)


def test_a_view_may_be_made_again(tmp_path: Path) -> None:
    for number, text in enumerate((RUN + VIEW, BLOCK + VIEW), start=1):
        (tmp_path / f"000{number}_some.sql").write_text(text)
    migration_lint.check(tmp_path)


def test_the_files_keep_to_the_form() -> None:
    migration_lint.check(Path(__file__).parents[2] / "migrations")


def test_a_checksum_is_that_of_the_bytes(tmp_path: Path) -> None:
    (tmp_path / "0001_run.sql").write_bytes(RUN.encode())
    (first,) = migration_files.read(tmp_path)
    assert first.checksum == hashlib.sha256(RUN.encode()).hexdigest()


@pytest.mark.parametrize("view", VIEWS)
def test_a_query_of_a_view_breaks_no_rule(view: str) -> None:
    assert [str(found) for found in sql_lint.lint(definitions()[view].create.expression)] == []


def test_the_data_dictionary_is_up_to_date() -> None:
    page = Path(__file__).parents[2] / "docs" / "tables.md"
    assert page.read_text(encoding="utf-8") == dictionary.text(), "python tests/tools/dictionary.py"
