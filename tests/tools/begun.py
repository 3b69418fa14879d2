"""States that begin: what migrating makes of an empty DuckDB is made once, and copied from then on.

Six hundred statements take a third of a second, which was a fifteenth of all tests. What tests migrating
itself is marked ``migrates`` and gets the real one, as does whatever is not empty, is no DuckDB, or has
other migrations.
"""

import atexit
import tempfile
from functools import cache
from pathlib import Path

import duckdb

from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.stored.schema import migrations
from gam_db.stored.schema.migration_files import Migration, files
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables
from gam_db.study.running import Listener, unheard

_migrate = migrations.migrate

#: Whether states are copied, for the test that runs.
is_copied = True


def migrate(session: Session, tables: StateTables, on_step: Listener = unheard) -> tuple[Migration, ...]:
    """Do what :func:`gam_db.stored.schema.migrations.migrate` does."""
    is_usual = tables.schema is None and vars(migrations)["files"] is files
    if is_copied and is_usual and isinstance(session, DuckSession):
        there = session.relations()
        if not any(tables.folded(name) in there for name in (*TABLES, *VIEWS)):
            try:
                _copy(session.driver.connection, tables.prefix)
            except duckdb.Error:  # nothing can be written, or a transaction is open: as ever
                return _migrate(session, tables, on_step)
            for name in (*TABLES, *VIEWS):
                on_step(name)
            return files()
    return _migrate(session, tables, on_step)


def _copy(connection: duckdb.DuckDBPyConnection, prefix: str) -> None:
    (current,) = connection.execute("SELECT current_database()").fetchone() or ("",)
    quoted = '"' + current.replace('"', '""') + '"'
    connection.execute(f"ATTACH '{_made(prefix)}' AS begun (READ_ONLY)")
    try:
        connection.execute(f"COPY FROM DATABASE begun TO {quoted}")
    finally:
        connection.execute("DETACH begun")


@cache
def _made(prefix: str) -> Path:
    folder = tempfile.TemporaryDirectory(prefix="gam-begun-")
    atexit.register(folder.cleanup)
    path = Path(folder.name, "state.duckdb")
    with duckdb.connect(path) as connection, DuckSession(connection) as session:
        _migrate(session, StateTables(prefix=prefix))
    return path


def begin_as_copies() -> None:
    """Let all states begin so."""
    migrations.migrate = migrate
