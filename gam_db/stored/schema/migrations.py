"""Applying migrations: what was applied to a database, what is pending, and the record of it.

Where an engine undoes definitions, all that is pending is one transaction with its record, and a state
that begins is made as it is in the end; else the record of each migration is written after it, and a run
that is cut short applies it again. A state that a newer gam-db made is refused.
"""

import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.engines.session import CONFLICT, Session
from gam_db.engines.storage import Definition
from gam_db.errors import ConflictError, EngineError, StateError
from gam_db.stored.schema import roles
from gam_db.stored.schema.migration_files import RECORD, Migration, files, made_by, placed, record
from gam_db.stored.schema.roles import Roles
from gam_db.stored.schema.tables import VIEWS, StateTables
from gam_db.study.running import Listener, unheard
from gam_db.version import __version__

#: The columns of the tables and views there are, by their names in lower case.
Relations: TypeAlias = Mapping[str, tuple[str, ...]]


@dataclass(frozen=True)
class Applied:
    """A row of the record: what was applied, when (microseconds, UTC) and by which gam-db."""

    number: int
    name: str
    checksum: str
    applied_at: int
    gam_version: str


@dataclass(frozen=True)
class Status:
    """What was applied to a database, and what is still to be applied; both in order."""

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
    _check_own(tables, "migration", there, [RECORD])
    query = exp.select(*RECORD).from_(tables.table("migration")).order_by("number")
    rows = tuple(Applied(**row) for row in session.rows(query))
    if rows and rows[-1].number > len(files()):
        raise StateError(
            f"The state tables {tables}* were last migrated by gam-db {rows[-1].gam_version} (migration "
            f"{rows[-1].number}); this is gam-db {__version__}, which knows {len(files())}. Install "
            "that version or a newer one."
        )
    return rows


def status(session: Session, tables: StateTables, there: Relations | None = None) -> Status:
    """Return what was applied and what is pending; nothing is written.

    Raises:
        StateError: the state is of a newer gam-db, was changed by hand, or its names are taken.
    """
    there = session.relations(tables.schema) if there is None else there
    applied = recorded(session, tables, there)
    _check_record(applied, tables)
    known = files()
    made = {migration.name for migration in known[: len(applied)]}
    for name in sorted(made):
        if tables.folded(name) not in there:
            raise StateError(
                f"{tables.shown(name)} was made once and is no longer there; put it back from a copy of "
                "the database, or make it anew, empty, with what `gam migrate --sql` prints for it."
            )
    pending = known[len(applied) :]
    forms: dict[str, list[tuple[str, ...]]] = {}  # a view that is made again may have more columns
    for migration in pending:
        if isinstance(migration.definition, Definition) and migration.name not in made:
            forms.setdefault(migration.name, []).append(tuple(migration.definition.columns))
    for name in forms:
        if tables.folded(name) in there:
            _check_own(tables, name, there, forms[name])
    return Status(applied, pending)


def migrate(session: Session, tables: StateTables, on_step: Listener = unheard) -> tuple[Migration, ...]:
    """Apply what is pending and return it: all as one with its record where definitions can be undone.

    A schema is made if it is not there. The name of each is told (``on_step``) before it is applied.

    Raises:
        StateError: see :func:`status`.
        EngineError: the database cannot be written, or another connection migrates it now.
    """
    there = session.relations(tables.schema)
    pending = status(session, tables, there).pending
    as_one = session.transactions and session.engine.undoes_definitions
    for group in [pending] if as_one and pending else [(migration,) for migration in pending]:
        with session.transaction():
            _apply(session, tables, group, there, on_step)
    return pending


def _apply(
    session: Session,
    tables: StateTables,
    group: Sequence[Migration],
    there: Relations,
    on_step: Listener,
) -> None:
    """Apply migrations and record them; *there* is what was there before the first of all."""
    first = group[0].number
    # After the first one the record is there, and need not be looked for.
    now_there = session.relations(tables.schema) if first == 1 else {tables.folded("migration"): RECORD}
    if len(recorded(session, tables, now_there)) >= first:
        raise ConflictError(CONFLICT)
    now = time.time_ns() // 1000
    fresh = not any(tables.folded(migration.name) in there for migration in files())
    for statement in _schema(session.engine, tables) if first == 1 else ():
        session.execute(statement)
    at_once = made_by(group) if fresh and len(group) > 1 else {}
    for name, about in at_once.items():
        on_step(name)
        for statement in placed(about, name, session.engine, tables):
            session.execute(statement)
    for migration in () if at_once else group:
        on_step(migration.name)
        # Some columns may be there, of a run that was cut short or of a script that was printed.
        present = there.get(tables.folded(migration.name), ())
        if not (_gets_more(migration) and len(present) > len(migration.definition.columns)):
            for statement in migration.statements(session.engine, tables, present, fresh):
                session.execute(statement)
    session.execute(record(group, tables, now))


def require(session: Session, tables: StateTables) -> None:
    """Refuse a database whose state tables are not those of this gam-db.

    Raises:
        StateError: there are none, some are missing, or they are of a newer gam-db.
    """
    found = status(session, tables)
    if not found.applied:
        raise StateError(f"There are no state tables {tables}* in this database; run `gam migrate`.")
    if found.pending:
        raise StateError(
            f"The state tables {tables}* are of an older gam-db: {len(found.pending)} migrations are "
            "pending; run `gam migrate`."
        )


def rendered(engine: Engine, tables: StateTables, who: Roles | None = None) -> str:
    """Return all migrations as a script of an engine; it can be run on an empty or an older state.

    Where an engine has no ADD COLUMN IF NOT EXISTS, what adds a column says so, and is left out where it
    was applied. Owner, writer and reader (``who``) are given what they need.

    Raises:
        EngineError: the engine has no schemas, and one is named; or it has other grants.
    """
    head = f"-- gam-db {__version__}: the state tables {tables}*, for {engine.name}; safe to run again."
    parts = [f"{head}\n{engine.beginning()}".rstrip()]
    now = time.time_ns() // 1000
    if who is not None:
        parts.append(_part("-- Who may do what.", roles.before(engine, tables, who), engine))
    for migration in files():
        title = f"-- Migration {migration.number}: {tables.shown(migration.name)}."
        statements = _schema(engine, tables) if migration.number == 1 and who is None else []
        statements += [] if _gets_more(migration) else migration.statements(engine, tables)
        statements.append(record([migration], tables, now))
        if any(_adds_once(statement) for statement in statements):
            title += f" Only where it is pending: {engine.title} cannot be told to add a column once."
        if migration.filling is not None:
            title += " What fills the columns has nothing to do where the table is empty."
        parts.append(_part(title, statements, engine))
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


def _gets_more(migration: Migration) -> bool:
    """Tell whether a view is made again with more columns: an engine may refuse to take them away."""
    later = [one for one in files()[migration.number :] if one.name == migration.name]
    columns = {tuple(one.definition.columns) for one in (migration, *later)}
    return migration.name in VIEWS and len(columns) > 1


def _adds_once(statement: exp.Expr) -> bool:
    """Tell whether a statement fails where the column that it adds is there."""
    actions = statement.args["actions"] if isinstance(statement, exp.Alter) else []
    return not all(action.args.get("exists") for action in actions)


def _check_record(applied: Sequence[Applied], tables: StateTables) -> None:
    for place_of, row in enumerate(applied, start=1):
        what = None
        if row.number != place_of:
            what = "it is there twice" if row.number < place_of else f"it lacks number {place_of}"
        elif row.name != (name := files()[place_of - 1].name):
            what = f"migration {row.number} is called {row.name!r} in it and made {tables.shown(name)}"
        if what is not None:
            raise StateError(
                f"The record {tables.shown('migration')} was changed by hand: {what}; put it back "
                "from a copy of the database."
            )
        if row.checksum != files()[place_of - 1].checksum:
            raise StateError(
                f"Migration {row.number} ({row.name}) was applied by gam-db {row.gam_version} with "
                f"another text than gam-db {__version__} has. Drop the state (gam drop --yes), then gam "
                "calibrate makes it anew."
            )


def _check_own(
    tables: StateTables, name: str, there: Relations, forms: Sequence[tuple[str, ...]]
) -> None:
    """Refuse a table that is called like one of ours and has none of the forms that ours has."""
    if there[tables.folded(name)] not in forms:
        raise StateError(
            f"There is a {tables.shown(name)} in the database that is no state table of gam-db; give "
            "another --prefix or --schema, or rename it."
        )
