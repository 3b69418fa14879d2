"""The files of ``migrations/``: read, checked, placed where the state lies, rendered for an engine.

A file makes one table or one view, or adds columns to a table and may fill them, with the comments of
all that; it is safe to run twice, and calls the tables ``stored_run`` and so on. Its checksum is that of
its bytes. A table that repeats what others hold is given the rows that it lacks in an older state
(:func:`gam_db.stored.sums.first_rows`).
"""

import dataclasses
import hashlib
import re
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import cast

import pyarrow as pa
import sqlglot
from sqlglot import exp
from sqlglot.errors import SqlglotError

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.columns import COUNT, SHARE, WORD
from gam_db.engines.base import Engine
from gam_db.engines.storage import Addition, Definition, Filling
from gam_db.errors import TemplateError
from gam_db.pipeline import filled, place
from gam_db.stored import sums
from gam_db.stored.tables import TABLES, VIEWS, StateTables
from gam_db.version import __version__

RECORD = ("number", "name", "checksum", "applied_at", "gam_version")

_FILE = re.compile(r"([0-9]{4})_([a-z_]+)\.sql")


@dataclass(frozen=True)
class Migration:
    """A file of ``migrations/``.

    Attributes:
        number: 1, 2, ... without a gap.
        name: the table or view that it makes or changes, without prefix. A view may be made again.
        checksum: SHA-256 of its bytes.
        definition: what it makes or adds, in the words of the file.
        filling: what the rows that are there have in columns that it adds; None for NULL.
    """

    number: int
    name: str
    checksum: str
    definition: Definition | Addition
    filling: Filling | None = None

    def statements(
        self, engine: Engine, tables: StateTables, present: Collection[str] = ()
    ) -> list[exp.Expr]:
        """Return the statements for an engine, with the tables in their place.

        Args:
            engine: what runs them.
            tables: where the state lies.
            present: columns of the table that are there already, and are not added.
        """
        if isinstance(self.definition, Addition):
            missing = {
                name: column for name, column in self.definition.columns.items() if name not in present
            }
            added = Addition(tables.table(self.name), missing, self.definition.comments)
            extended = engine.extend(added)
            return extended if self.filling is None else [*extended, *engine.fill(self._filling(tables))]
        create = self.definition.create.copy()
        target = create.this.this if isinstance(create.this, exp.Schema) else create.this
        target.replace(tables.table(self.name))
        if create.expression is not None:
            place(create.expression, tables.placed())
            for instant in list(create.find_all(exp.UnixToTime)):
                found = engine.instant_of(TimeKind.TIMESTAMP, instant.this.copy())
                instant.replace(exp.paren(found) if isinstance(instant.parent, exp.Binary) else found)
        about = self.definition
        made = engine.define(Definition(create, about.comment, about.columns))
        rows = sums.first_rows(self.name)
        return made if rows is None else [*made, _rows_for(tables, self.name, rows.copy())]

    def _filling(self, tables: StateTables) -> Filling:
        """Return the filling with the tables in their place."""
        assert self.filling is not None
        whole, update = self.filling.whole, self.filling.update.copy()
        create = whole.create.copy()
        create.this.set("this", tables.table(self.name))
        place(update, tables.placed())
        return Filling(Definition(create, whole.comment, whole.columns), update)


def record(migrations: Sequence[Migration], tables: StateTables, applied_at: int) -> exp.Expr:
    """Return the statement that records migrations, unless they are recorded already."""
    rows = [
        filled(
            "stored/migration_record",
            {
                "number": migration.number,
                "name": template.text(migration.name),
                "checksum": template.text(migration.checksum),
                "applied_at": applied_at,
                "gam_version": template.text(__version__),
            },
        )
        for migration in migrations
    ]
    values = rows[0] if len(rows) == 1 else exp.union(*rows, distinct=False, copy=False)
    place(values, tables.placed())
    columns = [exp.to_identifier(name) for name in RECORD]
    return exp.Insert(
        this=exp.Schema(this=tables.table("migration"), expressions=columns), expression=values
    )


@cache
def definitions() -> dict[str, Definition]:
    """Return what all migrations make together, by name: tables, then views after what they read."""
    made = _made(files())
    return {name: made[name] for name in (*TABLES, *VIEWS)}


@cache
def columns_of(table: str) -> pa.Schema:
    """Return the columns of a state table, as Arrow has them."""
    kinds = {"BIGINT": COUNT, "DOUBLE": SHARE, "TEXT": WORD}
    made = definitions()[table].create.this.expressions
    return pa.schema([(column.name, kinds[column.kind.sql()]) for column in made])


def _made(migrations: Iterable[Migration]) -> dict[str, Definition]:
    """Return what migrations make together, by name."""
    made: dict[str, Definition] = {}
    for migration in migrations:
        about = migration.definition
        if isinstance(about, Addition):
            before = made[migration.name]
            create = before.create.copy()
            more = [column.copy() for column in about.columns.values()]
            for column in more:
                column.set("exists", None)
            create.this.set("expressions", [*create.this.expressions, *more])
            about = Definition(create, before.comment, {**before.columns, **about.comments})
        made[migration.name] = about
    return made


@cache
def files() -> tuple[Migration, ...]:
    """Return the migrations of this gam-db, in order."""
    installed = Path(__file__).parent.parent / "migrations"
    checkout = Path(__file__).parent.parent.parent / "migrations"
    return read(installed if installed.is_dir() else checkout)


def read(folder: Path) -> tuple[Migration, ...]:
    """Read and parse the migrations of a folder, in order.

    Raises:
        TemplateError: a file has no number or breaks the form, or the numbers have a gap or repeat.
    """
    found = [_read(path) for path in sorted(folder.glob("*.sql"))]
    for place_of, migration in enumerate(found, start=1):
        if migration.number != place_of:
            raise TemplateError(
                f"The migrations in {folder.name}/ are not numbered 1, 2, ...: number {place_of} is "
                f"{'there twice' if migration.number < place_of else 'missing'}."
            )
        made = [earlier.name for earlier in found[: place_of - 1]]
        if isinstance(migration.definition, Addition) and migration.name not in made:
            raise TemplateError(
                f"The migration number {place_of} adds columns to a table that no file before it makes."
            )
        about = migration.definition
        if isinstance(about, Addition) and not {*about.comments} <= {
            *about.columns,
            *_made(found[: place_of - 1])[migration.name].columns,
        }:
            raise TemplateError(
                f"The migration number {place_of} has a comment on a column that its table has not."
            )
        if migration.filling is not None:
            whole = _made(found[:place_of])[migration.name]
            filling = dataclasses.replace(migration.filling, whole=whole)
            found[place_of - 1] = dataclasses.replace(migration, filling=filling)
    return tuple(found)


def _read(path: Path) -> Migration:
    matched = _FILE.fullmatch(path.name)
    if not matched:
        raise TemplateError(f"migrations/{path.name} is not called like 0001_name.sql.")
    content = path.read_bytes()
    try:
        parsed = sqlglot.parse(content.decode(), dialect="duckdb")
    except SqlglotError as error:
        raise TemplateError(f"migrations/{path.name} cannot be parsed: {error}") from error
    statements = [statement for statement in parsed if statement is not None]
    for statement in statements:
        for node in statement.walk():
            node.comments = None
            node._meta = None
    number, name = int(matched[1]), matched[2]
    updates = [one for one in statements if isinstance(one, exp.Update)]
    statements = [one for one in statements if not isinstance(one, exp.Update)]
    made = _addition if statements and isinstance(statements[0], exp.Alter) else _definition
    definition = made(path.name, name, statements)
    filling = _filling(path.name, name, definition, updates) if updates else None
    return Migration(number, name, hashlib.sha256(content).hexdigest(), definition, filling)


def _rows_for(tables: StateTables, name: str, rows: exp.Query) -> exp.Expr:
    """Return the statement that gives a new table what an older state has to say."""
    columns = [exp.to_identifier(column) for column in rows.named_selects]
    place(rows, tables.placed())
    return exp.Insert(this=exp.Schema(this=tables.table(name), expressions=columns), expression=rows)


def _definition(file: str, name: str, statements: Sequence[exp.Expr]) -> Definition:
    """Return what a file makes: one table or view, called like the file, with all comments."""
    create, *about = statements or [exp.Null()]
    twice = isinstance(create, exp.Create) and (
        create.args.get("exists") if create.kind == "TABLE" else create.args.get("replace")
    )
    if not twice or not all(isinstance(one, exp.Comment) for one in about):
        raise TemplateError(
            f"migrations/{file} holds something else than one table (if not exists) or one view (or "
            "replace) with its comments."
        )
    made = cast(exp.Create, create)
    target = made.find(exp.Table)
    named = made.this.expressions if isinstance(made.this, exp.Schema) else made.expression.selects
    columns = [column.alias_or_name for column in named]
    said = {one.this.name: one.expression for one in about if one.args["kind"] == "COLUMN"}
    whole = [one.expression for one in about if one.args["kind"] == made.kind]
    of_others = [one for one in about if _table_of(one) != f"stored_{name}"]
    if (
        target is None
        or target.name != f"stored_{name}"
        or list(said) != columns
        or len(whole) != 1
        or len(about) != len(said) + 1
        or of_others
    ):
        raise TemplateError(
            f"migrations/{file} must make stored_{name}, with a comment on it and then on each "
            "column, in order."
        )
    return Definition(made, whole[0], said)


def _addition(file: str, name: str, statements: Sequence[exp.Expr]) -> Addition:
    """Return which columns a file adds to the table that it is called after, with all comments."""
    changes = [one for one in statements if isinstance(one, exp.Alter)]
    about = [one for one in statements if isinstance(one, exp.Comment)]
    columns = {
        action.name: action
        for change in changes
        for action in change.args["actions"]
        # Rows that are there have nothing to say in it.
        if isinstance(action, exp.ColumnDef) and action.args.get("exists") and not action.constraints
    }
    said = {one.this.name: one.expression for one in about if one.args["kind"] == "COLUMN"}
    if (
        [*changes, *about] != list(statements)
        or len(columns) != len(changes)
        or any(change.this.name != f"stored_{name}" for change in changes)
        or list(said)[: len(columns)] != list(columns)
        or len(about) != len(said)
        or any(_table_of(one) != f"stored_{name}" for one in about)
    ):
        raise TemplateError(
            f"migrations/{file} must add columns to stored_{name}, one by one (add column if not "
            "exists, NULL in the rows that are there), with a comment on each, in order, and then "
            "perhaps on columns that are there and mean something else from now on."
        )
    return Addition(exp.to_table(f"stored_{name}"), columns, said)


def _filling(
    file: str, name: str, added: Definition | Addition, updates: Sequence[exp.Update]
) -> Filling:
    """Return what a file says of the rows that are there, in the form that every engine has one for."""
    update = updates[0]
    found = update.args["from_"].this if update.args.get("from_") else exp.Null()
    where = update.args["where"].this if update.args.get("where") else exp.Null()
    inner = found.this if isinstance(found, exp.Subquery) else exp.Select()
    group = inner.args.get("group") or exp.Group()
    keys = [key.name for key in group.expressions]
    wanted = [exp.column(key, "kept").eq(exp.column(key, "found")) for key in keys]
    named = list(added.columns) if isinstance(added, Addition) else []
    filled = [one.this.name for one in update.expressions]
    sources = [
        exp.func("COALESCE", exp.column(column, "kept"), exp.column(column, "found"))
        for column in filled
    ]
    if (
        len(updates) > 1
        or (update.this.name, update.this.alias, found.alias) != (f"stored_{name}", "kept", "found")
        or not keys
        or list(where.flatten() if isinstance(where, exp.And) else [where]) != wanted
        or not set(filled) <= set(named)
        or [one.expression for one in update.expressions] != sources
    ):
        raise TemplateError(
            f"migrations/{file} fills columns in a form that not every engine has; it must fill those "
            "that it adds by the one statement that migrations/README.md shows, with all keys in order."
        )
    return Filling(Definition(exp.Create(), exp.Null(), {}), update)


def _table_of(comment: exp.Expr) -> str:
    return str(comment.this.table if isinstance(comment.this, exp.Column) else comment.this.name)
