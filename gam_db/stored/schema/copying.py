"""Copying the state alone to another DuckDB file, for readers while scoring writes.

While one process writes a DuckDB file, no other can open it. A copy shows one instant, and holds only
the state: no telemetry, and no free space of deleted rows.
"""

import contextlib
import re
import shutil
from pathlib import Path

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.plan import insertion
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import EngineError, LockedError, SourceError, unwritable
from gam_db.stored.schema import migrations
from gam_db.stored.schema.tables import TABLES, StateTables


def copy(session: Session, tables: StateTables, path: Path) -> None:
    """Write all state tables and views into a DuckDB file of their own.

    It is written beside and renamed, so that a reader finds the old copy or the new one, whole; who has
    the old one open keeps reading that. The tables lie in the copy as they do in the database. It has
    the permissions of the copy before, or else those of the database. What a copy that was killed left
    beside it is removed.

    Raises:
        StateError: there is no state, or it is not of this gam-db.
        SourceError: the file cannot be written, or something else uses it.
        EngineError: a transaction is open, or the database is not a DuckDB file.
    """
    if not isinstance(session, DuckSession):
        raise EngineError(
            f"{session.engine.title} can be read while it is written, so it needs no copy."
        )
    migrations.require(session, tables)
    if path.resolve() in session.files():
        raise SourceError(f"{path} is open in this session; give the copy another name.")
    log = path.with_name(f"{path.name}.wal")
    if log.exists():
        raise SourceError(
            f"{path} is open in a process that changes it, or such a process left it ({log.name} "
            "exists); "
            "give the copy another name."
        )
    if not path.parent.is_dir():
        raise SourceError(f"{path} cannot be written; the folder {path.parent} does not exist.")
    if tables.schema is not None and path.stem.casefold() == tables.schema.casefold():
        raise SourceError(
            f"{path} has the same name as the schema of the state, and DuckDB cannot tell them apart; "
            "give the copy another name."
        )
    unfinished = session.unfinished(path)
    try:
        _remove_left(path)
        with DuckSession(unfinished, writable=True) as target:
            migrations.migrate(target, tables)
        unfinished.chmod(0o600)  # until it has those of the file that it copies
        with session.attached(unfinished) as catalog, session.transaction():
            for name in TABLES:
                if name != "migration":
                    _fill(session, tables, name, catalog)
        like = path if path.exists() else session.file()
        if like is not None:
            shutil.copymode(like, unfinished)
        unfinished.replace(path)
    except OSError as error:
        raise unwritable(path, error, SourceError) from error
    finally:
        for left in path.parent.iterdir():
            if left.name.startswith(unfinished.name):
                left.unlink()


def _remove_left(path: Path) -> None:
    """Remove what copies to this path left that were killed; one at work has its file open."""
    mark = re.compile(re.escape(f".{path.name}.") + "gam_[0-9a-f]{8}")
    left: dict[str, list[Path]] = {}
    for file in path.parent.iterdir():
        if match := mark.match(file.name):
            left.setdefault(match[0], []).append(file)
    for name, files in left.items():
        with contextlib.suppress(LockedError):
            if path.with_name(name) in files:
                _check_unlocked(path.with_name(name))
            for file in files:
                file.unlink(missing_ok=True)


def _check_unlocked(path: Path) -> None:
    """Raise a LockedError if another process has a database file open; it may be no whole one."""
    try:
        DuckSession(path).close()
    except LockedError:
        raise
    except EngineError:
        pass


def _fill(session: DuckSession, tables: StateTables, name: str, catalog: exp.Identifier) -> None:
    source = tables.table(name)
    target = source.copy()
    target.set("db", target.args.get("db") or template.name("main"))
    target.set("catalog", catalog.copy())
    columns = [exp.column(exp.to_identifier(name)) for name in session.describe(source)]
    session.execute(insertion(target, exp.select(*columns).from_(source)))
