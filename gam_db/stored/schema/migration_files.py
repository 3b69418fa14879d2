"""The files of ``migrations/``: read, check and render them for an engine and a schema.

A file makes tables or views, each with its comments; it is safe to run twice, and names them
``stored_run`` and so on. Its checksum is that of its bytes. The database gets the comments of columns
only where readers look; all of them are in ``docs/tables.md``.
"""

import hashlib
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
from gam_db.composing.plan import insertion
from gam_db.engines.base import Engine
from gam_db.engines.storage import Definition
from gam_db.stored.schema.tables import FOR_READERS, TABLES, VIEWS, StateTables
from gam_db.version import __version__

RECORD = ("number", "name", "checksum", "applied_at", "gam_version")


@dataclass(frozen=True)
class Migration:
    """A file of ``migrations/``.

    It is parsed when its definitions are read: a state in order needs no more than the checksums.

    Attributes:
        number: 1, 2, ... without a gap.
        name: what its tables or views are about.
        content: its bytes.
    """

    number: int
    name: str
    content: bytes = field(repr=False)

    @cached_property
    def checksum(self) -> str:
        """SHA-256 of its bytes."""
        return hashlib.sha256(self.content).hexdigest()

    @cached_property
    def definitions(self) -> dict[str, Definition]:
        """The tables and views that it makes, by name without prefix, in order."""
        by_name: dict[str, Definition] = {}
        for statement in parsed(self.content):
            if isinstance(statement, exp.Create):
                create = statement
                columns: dict[str, exp.Expr] = {}
            elif statement.args["kind"] == "COLUMN":
                columns[statement.this.name] = statement.expression
            else:
                name = statement.this.name.removeprefix("stored_")
                by_name[name] = Definition(create, statement.expression, columns)
        return by_name

    def statements(self, engine: Engine, tables: StateTables) -> list[exp.Expr]:
        """Return the statements for an engine, with the tables in their place."""
        pairs = self.definitions.items()
        return [
            statement
            for name, about in pairs
            for statement in create_statements(about, name, engine, tables)
        ]


def create_statements(
    about: Definition, name: str, engine: Engine, tables: StateTables
) -> list[exp.Expr]:
    """Return the statements that make a table or view, for an engine, with the tables in their place."""
    create = about.create.copy()
    target = create.this.this if isinstance(create.this, exp.Schema) else create.this
    target.replace(tables.table(name))
    if create.expression is not None:
        place(create.expression, tables.nodes())
        for instant in list(create.find_all(exp.UnixToTime)):
            converted = engine.instant_of(TimeKind.TIMESTAMP, instant.this.copy())
            instant.replace(
                exp.paren(converted) if isinstance(instant.parent, exp.Binary) else converted
            )
        for clock in list(create.find_all(exp.CurrentTimestamp)):
            assert clock.parent is not None  # as microseconds
            clock.parent.replace(engine.clock())
    is_shown = name in FOR_READERS
    return engine.storage.define(Definition(create, about.comment, about.columns, is_shown))


def record(migration: Migration, tables: StateTables, applied_at: int) -> exp.Expr:
    """Return the statement that records a migration, unless it is recorded already."""
    row = filled(
        "stored/state/migration_record",
        {
            "number": migration.number,
            "name": template.text(migration.name),
            "checksum": template.text(migration.checksum),
            "applied_at": applied_at,
            "gam_version": template.text(__version__),
        },
    )
    place(row, tables.nodes())
    return insertion(tables.table("migration"), row)


@cache
def definitions() -> dict[str, Definition]:
    """Return the tables and views of all migrations by name: tables first, views after their inputs."""
    by_name = {name: about for migration in files() for name, about in migration.definitions.items()}
    return {name: by_name[name] for name in (*TABLES, *VIEWS)}


@cache
def columns_of(table: str) -> pa.Schema:
    """Return the columns of a state table, as Arrow has them."""
    kinds = {"BIGINT": COUNT, "DOUBLE": SHARE, "TEXT": WORD}
    column_nodes = definitions()[table].create.this.expressions
    return pa.schema([(column.name, kinds[column.kind.sql()]) for column in column_nodes])


@cache
def files() -> tuple[Migration, ...]:
    """Return the migrations of this gam-db, in order."""
    installed = Path(__file__).parents[2] / "migrations"
    checkout = Path(__file__).parents[3] / "migrations"
    return read(installed if installed.is_dir() else checkout)


def read(folder: Path) -> tuple[Migration, ...]:
    """Read the migrations of a folder, in order; tests check their form."""
    migrations = []
    for path in sorted(folder.glob("*.sql")):
        number, _, name = path.stem.partition("_")
        migrations.append(Migration(int(number), name, path.read_bytes()))
    return tuple(migrations)


def parsed(content: bytes) -> list[exp.Expr]:
    """Return the statements of a file, without the comments in its text."""
    trees = sqlglot.parse(content.decode(), dialect="duckdb")
    statements = [statement for statement in trees if statement is not None]
    for statement in statements:
        for node in statement.walk():
            node.comments = None
            node._meta = None
    return statements
