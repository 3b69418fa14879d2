"""Applying migrations: the applied ones of a database, the pending ones, and their record.

If an engine can undo definitions, all pending migrations and their record are one transaction; else the
record of each migration is written after it, and an interrupted migration is applied again. A state of
a newer gam-db is refused, and so is one that other files than these made.
"""

import dataclasses
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.engines.session import CONFLICT, Session
from gam_db.errors import ConflictError, EngineError, StateError
from gam_db.stored.schema import roles
from gam_db.stored.schema.migration_files import RECORD, Migration, create_statements, files, record
from gam_db.stored.schema.roles import Roles
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables
from gam_db.study.running import Listener, unheard
from gam_db.version import __version__

#: The columns of the tables and views there are, by their names in lower case.
Relations: TypeAlias = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True)
class Applied:
    """A row of the record: the migration, when it was applied (microseconds, UTC), by which gam-db."""

    number: int
    name: str
    checksum: str
    applied_at: int
    gam_version: str


@dataclass(frozen=True)
class Status:
    """The migrations applied to a database, and the pending ones; both in order."""

    applied: tuple[Applied, ...]
    pending: tuple[Migration, ...]


def recorded(session: Session, tables: StateTables, there: Relations) -> tuple[Applied, ...]:
    """Return the rows of the record, in order; none if there is no record.

    What is ``there`` is what :meth:`Session.relations` says of the schema.

    Raises:
        StateError: the table is none of ours, or a newer gam-db wrote it.
    """
    if tables.folded("migration") not in there:
        return ()
    _check_columns(tables, "migration", there, RECORD)
    query = exp.select(*RECORD).from_(tables.table("migration")).order_by("number")
    rows = tuple(Applied(**row) for row in session.rows(query))
    newest = len(files())
    if rows and rows[-1].number > newest and all(_is_file(row) for row in rows if row.number <= newest):
        raise StateError(
            f"The state tables {tables}* were last migrated by gam-db {rows[-1].gam_version} (migration "
            f"{rows[-1].number}); this is gam-db {__version__}, which has {newest} migrations. Install "
            "that version or a newer one."
        )
    return rows


def former(
    session: Session, tables: StateTables, there: Relations
) -> tuple[StateTables, tuple[Applied, ...]]:
    """Return what a state of before schema 0.1 called its tables, and its record; no rows if it is none.

    Each of its rows names the table or view that its file made.
    """
    names = dataclasses.replace(tables, apart="")
    is_there = there.get(names.folded("migration")) == RECORD
    if tables.folded("migration") in there or not is_there:
        return names, ()
    rows = recorded(session, names, there)
    return names, rows if all(row.name in (*TABLES, *VIEWS) for row in rows) else ()


def status(session: Session, tables: StateTables, there: Relations | None = None) -> Status:
    """Return the applied and the pending migrations; write nothing.

    Raises:
        StateError: the state is of other files or a newer gam-db, was changed by hand, or its names are
            taken.
    """
    there = session.relations(tables.schema) if there is None else there
    applied = recorded(session, tables, there) or former(session, tables, there)[1]
    _check_record(applied, tables)
    applied_files, pending = files()[: len(applied)], files()[len(applied) :]
    for name in sorted(name for migration in applied_files for name in migration.definitions):
        if tables.folded(name) not in there:
            raise StateError(
                f"{tables.shown(name)} no longer exists; restore it from a copy of the database, or "
                "create it anew, empty, with the statement that `gam migrate --sql` prints for it."
            )
    for migration in pending:
        for name, about in migration.definitions.items():
            if tables.folded(name) in there:
                _check_columns(tables, name, there, tuple(about.columns))
    return Status(applied, pending)


def migrate(session: Session, tables: StateTables, on_step: Listener = unheard) -> tuple[Migration, ...]:
    """Apply the pending migrations and return them: in one transaction, if definitions can be undone.

    A schema is made if it is not there. The name of each table and view is told (``on_step``) before it
    is made.

    Raises:
        StateError: see :func:`status`.
        EngineError: the database cannot be written, or another connection migrates it now.
    """
    pending = status(session, tables).pending
    is_atomic = session.transactions and session.engine.undoes_definitions
    for group in [pending] if is_atomic and pending else [(migration,) for migration in pending]:
        with session.transaction():
            _apply(session, tables, group, on_step)
    return pending


def _apply(session: Session, tables: StateTables, group: Sequence[Migration], on_step: Listener) -> None:
    first = group[0].number
    # After the first one the record is there, and need not be looked for.
    there = session.relations(tables.schema) if first == 1 else {tables.folded("migration"): RECORD}
    if len(recorded(session, tables, there)) >= first:
        raise ConflictError(CONFLICT)
    now = time.time_ns() // 1000
    for statement in _schema(session.engine, tables) if first == 1 else ():
        session.execute(statement)
    for migration in group:
        for name, about in migration.definitions.items():
            on_step(name)
            for statement in create_statements(about, name, session.engine, tables):
                session.execute(statement)
        session.execute(record(migration, tables, now))


def require(session: Session, tables: StateTables) -> None:
    """Refuse a database whose state tables are not those of this gam-db.

    Raises:
        StateError: there are none, some are missing, or they are of a newer gam-db.
    """
    current = status(session, tables)
    if not current.applied:
        raise StateError(f"There are no state tables {tables}* in this database; run `gam migrate`.")
    if current.pending:
        raise StateError(
            f"The state tables {tables}* are of an older gam-db: {len(current.pending)} migrations are "
            "pending; run `gam migrate`."
        )


def rendered(engine: Engine, tables: StateTables, who: Roles | None = None) -> str:
    """Return all migrations as a script of an engine; it can be run again.

    Owner, writer and reader (``who``) are given what they need.

    Raises:
        EngineError: the engine has no schemas, and one is named; or it has other grants.
    """
    head = f"-- gam-db {__version__}: the state tables {tables}*, for {engine.name}; safe to run again."
    parts = [f"{head}\n{engine.beginning()}".rstrip()]
    now = time.time_ns() // 1000
    if who is not None:
        parts.append(_part("-- Who may do what.", roles.before(engine, tables, who), engine))
    for migration in files():
        title = f"-- Migration {migration.number}: {migration.name.replace('_', ' ')}."
        statements = _schema(engine, tables) if migration.number == 1 and who is None else []
        statements += migration.statements(engine, tables)
        recording = engine.text(record(migration, tables, now))
        parts.append(f"{_part(title, statements, engine)}\n{recording};")
    if who is not None:
        parts.append(_part(roles.ALSO, roles.after(tables, who), engine))
    return "\n\n".join(parts) + "\n"


def _part(title: str, statements: Iterable[exp.Expr], engine: Engine) -> str:
    return "\n".join([title, *(f"{engine.text(statement, pretty=True)};" for statement in statements)])


def _schema(engine: Engine, tables: StateTables) -> list[exp.Expr]:
    """Return the statement that makes the schema, where one is named."""
    if tables.schema is None:
        return []
    if not engine.schemas:
        raise EngineError(f"{engine.name} has no schemas; leave schema out and give another prefix.")
    return [exp.Create(this=exp.Table(db=template.name(tables.schema)), kind="SCHEMA", exists=True)]


def _is_file(row: Applied) -> bool:
    """Tell whether an applied migration is a file of this gam-db."""
    checksums = {file.number: (file.name, file.checksum) for file in files()}
    return checksums.get(row.number) == (row.name, row.checksum)


def _check_record(applied: Sequence[Applied], tables: StateTables) -> None:
    for place, row in enumerate(applied, start=1):
        if not _is_file(row):
            raise _of_before(tables, row)
        if row.number != place:
            what = "a number occurs twice" if row.number < place else f"it lacks number {place}"
            raise StateError(
                f"The record {tables.shown('migration')} was changed by hand: {what}; restore it "
                "from a copy of the database."
            )


def _of_before(tables: StateTables, row: Applied) -> StateError:
    return StateError(
        f"gam-db {row.gam_version} made the state tables {tables}* in another form than gam-db "
        f"{__version__} "
        "needs: drop them with `gam drop --yes`, then `gam calibrate` makes them anew."
    )


def _check_columns(tables: StateTables, name: str, there: Relations, columns: tuple[str, ...]) -> None:
    """Refuse a table or view that has the name of a state table but other columns."""
    if there[tables.folded(name)] != columns:
        raise StateError(
            f"The {tables.shown(name)} in the database is not a state table of gam-db; give another "
            "--prefix or --schema, or rename it."
        )
