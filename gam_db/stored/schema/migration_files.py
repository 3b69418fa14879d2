"""The files of ``migrations/``: read, checked, placed where the state lies, rendered for an engine.

A file makes one table or one view, or adds columns to a table and may fill them, with the comments of
all that; it is safe to run twice, and calls the tables ``stored_run`` and so on. Its checksum is that of
its bytes. A table that repeats what others hold is given the rows that it lacks in an older state
(:func:`gam_db.stored.schema.checksums.first_rows`).
"""

import hashlib
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path

import pyarrow as pa
import sqlglot
from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.columns import COUNT, SHARE, WORD
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.engines.base import Engine
from gam_db.engines.storage import Addition, Definition, Filling
from gam_db.stored.schema import checksums
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables, insertion
from gam_db.version import __version__

RECORD = ("number", "name", "checksum", "applied_at", "gam_version")


@dataclass(frozen=True)
class Migration:
    """A file of ``migrations/``.

    It is parsed when it is asked what it makes: a state in order needs no more than the checksums.

    Attributes:
        number: 1, 2, ... without a gap.
        name: the table or view that it makes or changes, without prefix. A view may be made again.
        content: its bytes.
        before: those with smaller numbers.
    """

    number: int
    name: str
    content: bytes = field(repr=False)
    before: tuple["Migration", ...] = field(default=(), repr=False, compare=False)

    @cached_property
    def checksum(self) -> str:
        """SHA-256 of its bytes."""
        return hashlib.sha256(self.content).hexdigest()

    @cached_property
    def definition(self) -> Definition | Addition:
        """What it makes or adds, in the words of the file."""
        first, *more = self._statements
        about = [one for one in more if isinstance(one, exp.Comment)]
        columns = {one.this.name: one.expression for one in about if one.args["kind"] == "COLUMN"}
        if isinstance(first, exp.Create):
            (whole,) = (one.expression for one in about if one.args["kind"] != "COLUMN")
            return Definition(first, whole, columns)
        added = [one.args["actions"][0] for one in (first, *more) if isinstance(one, exp.Alter)]
        table = exp.to_table(f"stored_{self.name}")
        return Addition(table, {column.name: column for column in added}, columns)

    @cached_property
    def filling(self) -> Filling | None:
        """What the rows that are there have in columns that it adds; None for NULL."""
        updates = (one for one in self._statements if isinstance(one, exp.Update))
        return next((Filling(made_by([*self.before, self])[self.name], one) for one in updates), None)

    @cached_property
    def _statements(self) -> list[exp.Expr]:
        return parsed(self.content)

    def statements(
        self, engine: Engine, tables: StateTables, present: Collection[str] = (), fresh: bool = False
    ) -> list[exp.Expr]:
        """Return the statements for an engine, with the tables in their place.

        Columns of the table that are ``present`` are not added. Where a state begins ``fresh``, no table
        of it has a row that would have to be filled.
        """
        if isinstance(self.definition, Addition):
            columns = self.definition.columns
            missing = {name: columns[name] for name in columns if name not in present}
            extended = engine.storage.extend(
                Addition(tables.table(self.name), missing, self.definition.comments)
            )
            if fresh or self.filling is None:
                return extended
            whole, update = self.filling.whole, self.filling.update.copy()
            create = whole.create.copy()
            create.this.set("this", tables.table(self.name))
            place(update, tables.placed())
            filling = Filling(Definition(create, whole.comment, whole.columns), update)
            return [*extended, *engine.fill(filling)]
        made = placed(self.definition, self.name, engine, tables)
        rows = None if fresh else checksums.first_rows(self.name)
        if rows is None:
            return made
        rows = rows.copy()
        place(rows, tables.placed())
        return [*made, insertion(tables.table(self.name), rows)]


def placed(about: Definition, name: str, engine: Engine, tables: StateTables) -> list[exp.Expr]:
    """Return the statements that make a table or view, for an engine, with the tables in their place."""
    create = about.create.copy()
    target = create.this.this if isinstance(create.this, exp.Schema) else create.this
    target.replace(tables.table(name))
    if create.expression is not None:
        place(create.expression, tables.placed())
        for instant in list(create.find_all(exp.UnixToTime)):
            found = engine.instant_of(TimeKind.TIMESTAMP, instant.this.copy())
            instant.replace(exp.paren(found) if isinstance(instant.parent, exp.Binary) else found)
    return engine.storage.define(Definition(create, about.comment, about.columns))


def record(migrations: Sequence[Migration], tables: StateTables, applied_at: int) -> exp.Expr:
    """Return the statement that records migrations, unless they are recorded already."""
    rows = [
        filled(
            "stored/state/migration_record",
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
    return insertion(tables.table("migration"), values)


@cache
def definitions() -> dict[str, Definition]:
    """Return what all migrations make together, by name: tables, then views after what they read."""
    return made_by(files())


@cache
def columns_of(table: str) -> pa.Schema:
    """Return the columns of a state table, as Arrow has them."""
    kinds = {"BIGINT": COUNT, "DOUBLE": SHARE, "TEXT": WORD}
    made = definitions()[table].create.this.expressions
    return pa.schema([(column.name, kinds[column.kind.sql()]) for column in made])


def made_by(migrations: Iterable[Migration]) -> dict[str, Definition]:
    """Return what migrations make together, by name: tables, then views after what they read."""
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
    return {name: made[name] for name in (*TABLES, *VIEWS) if name in made}


@cache
def files() -> tuple[Migration, ...]:
    """Return the migrations of this gam-db, in order."""
    installed = Path(__file__).parents[2] / "migrations"
    checkout = Path(__file__).parents[3] / "migrations"
    return read(installed if installed.is_dir() else checkout)


def read(folder: Path) -> tuple[Migration, ...]:
    """Read the migrations of a folder, in order; what they must be like is tested."""
    found: list[Migration] = []
    for path in sorted(folder.glob("*.sql")):
        number, _, name = path.stem.partition("_")
        found.append(Migration(int(number), name, path.read_bytes(), tuple(found)))
    return tuple(found)


def parsed(content: bytes) -> list[exp.Expr]:
    """Return the statements of a file, without what is said beside them."""
    found = sqlglot.parse(content.decode(), dialect="duckdb")
    statements = [statement for statement in found if statement is not None]
    for statement in statements:
        for node in statement.walk():
            node.comments = None
            node._meta = None
    return statements
