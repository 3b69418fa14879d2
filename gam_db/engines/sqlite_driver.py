"""SQLite at work, by the standard library. Timestamps are texts (ISO 8601, UTC) or integer counters."""

import datetime as dt
import decimal
import os
import re
import sqlite3
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import called, deletion
from gam_db.engines.session import CONFLICT, FULL, OPEN, READ_ONLY
from gam_db.engines.sqlite import ENGINE
from gam_db.errors import ConflictError, EngineError, SourceError, UserError

#: Window functions, hints on WITH entries and mathematical functions are all there.
OLDEST = (3, 35)

#: How long a writer waits for another one, in seconds.
PATIENCE = 30

#: Readings worked on at once: SQLite keeps temporary tables on disk, and sorts there.
ROWS_AT_ONCE = 5_000_000

_SCHEME = "sqlite:///"
_NAMES = ("asset", "channel", "name")
_INSTANT = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{6}")
_DECLARED = {"integer": "INTEGER", "real": "REAL", "text": "TEXT"}


def connected(target: Any, writable: bool) -> "SqliteDriver":
    """Open ``sqlite:///PATH`` or ``sqlite://`` (in memory), or take an open connection.

    Raises:
        EngineError: it cannot be opened, is no SQLite database, or this SQLite is too old.
    """
    if sqlite3.sqlite_version_info < OLDEST:
        raise EngineError(
            f"SQLite {sqlite3.sqlite_version} is too old; gam-db needs {'.'.join(map(str, OLDEST))} or "
            "later."
        )
    if isinstance(target, sqlite3.Connection):
        if target.in_transaction:
            raise EngineError(OPEN)
        return SqliteDriver(target, is_ours=False)
    if target in ("sqlite://", "sqlite:///:memory:"):
        return SqliteDriver(sqlite3.connect(":memory:", isolation_level=None), is_ours=True)
    if not target.startswith(_SCHEME):
        raise EngineError(f"{target} names a server; a SQLite file is sqlite:///PATH, three slashes.")
    path = Path(target.removeprefix(_SCHEME))
    if not path.exists() and not (writable and path.parent.is_dir()):
        raise EngineError(f"There is no database file {path}.")
    mode = "rwc" if writable else "ro"
    try:
        connection = sqlite3.connect(
            f"{path.resolve().as_uri()}?mode={mode}", uri=True, isolation_level=None, timeout=PATIENCE
        )
        connection.execute("SELECT COUNT(*) FROM sqlite_master").fetchall()
    except sqlite3.Error as error:
        raise EngineError(f"{path} cannot be opened as a SQLite file; is it one?") from error
    if writable and not os.access(path, os.W_OK):
        connection.close()
        raise EngineError(f"{path} cannot be written: you may only read it.")
    return SqliteDriver(connection, is_ours=True)


class SqliteDriver:
    """A connection to SQLite; see :class:`gam_db.engines.warehouse.Driver`.

    Args:
        connection: open, with no transaction.
        is_ours: whether closing the driver closes it.
    """

    engine = ENGINE
    transactions = True
    errors: tuple[type[Exception], ...] = (sqlite3.Error,)

    def __init__(self, connection: sqlite3.Connection, is_ours: bool) -> None:
        self._connection, self._is_ours = connection, is_ours
        self._level = connection.isolation_level
        # A connection of the user's begins transactions of its own accord otherwise.
        connection.isolation_level = None

    def execute(self, statement: str) -> None:
        """Run one statement."""
        self._connection.execute(statement)

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query; a column without any value has the type null.

        SQLite has no type for instants: a column of texts such as gam-db writes for them comes out as
        timestamps, unless it holds names.
        """
        cursor = self._connection.execute(query)
        names = [column[0] for column in cursor.description]
        rows = cursor.fetchall()
        columns = list(zip(*rows, strict=True)) if rows else [()] * len(names)
        arrays = [_array(name, column) for name, column in zip(names, columns, strict=True)]
        return pa.table(arrays, names=names)

    def begin(self) -> None:
        """Begin a transaction that no other connection can write beside."""
        self._connection.execute("BEGIN IMMEDIATE")

    def commit(self) -> None:
        """End it."""
        self._connection.execute("COMMIT")

    def rollback(self) -> None:
        """Undo it."""
        if self._connection.in_transaction:
            self._connection.execute("ROLLBACK")

    def in_transaction(self) -> bool:
        """Tell whether a transaction is open."""
        return self._connection.in_transaction

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        """Make a temporary table of the rows of a query."""
        self.execute(self.engine.text(_temporary(table.copy(), query)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        """Make a temporary table of the rows of an Arrow table."""
        columns = [
            exp.ColumnDef(this=template.name(field.name), kind=exp.DataType.build(_type_of(field.type)))
            for field in rows.schema
        ]
        self.execute(self.engine.text(_temporary(exp.Schema(this=table.copy(), expressions=columns))))
        places = [exp.Placeholder() for _ in columns]
        values = exp.Values(expressions=[exp.Tuple(expressions=places)])
        insert = exp.Insert(this=table.copy(), expression=values)
        self._connection.executemany(self.engine.text(insert), _plain_rows(rows))

    def drop(self, table: exp.Table) -> None:
        """Drop a temporary table."""
        self.execute(self.engine.text(exp.Drop(tables=[table.copy()], kind="TABLE", exists=True)))

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query."""
        self.execute(self.engine.text(deletion(table, keys, found)))

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node as it is."""
        return table

    def tables(self) -> list[tuple[str, ...]]:
        """Return the tables and views of all attached files: (schema, name)."""
        schemas = [name for _, name, _ in self._connection.execute("PRAGMA database_list")]
        return [(schema, name) for schema in schemas for name in self._names(schema)]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their declared types.

        SQLite declares none for an expression of a view: there the first value tells.
        """
        table = relation.find(exp.Table)
        assert table is not None
        schema = table.args.get("db")
        info = exp.select("name", "type").from_(
            called(
                "PRAGMA_TABLE_INFO", *(template.text(one.name) for one in (table.this, schema) if one)
            )
        )
        rows = self._connection.execute(self.engine.text(info)).fetchall()
        return {
            name: str(declared).upper() or self._first_type(relation, name) for name, declared in rows
        }

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of the main file with their columns.

        Raises:
            EngineError: a schema is named.
        """
        if schema is not None:
            raise EngineError("SQLite has no schemas; leave schema out and give another prefix.")
        found = {}
        for name in self._names("main"):
            rows = self._connection.execute("SELECT name FROM PRAGMA_TABLE_INFO(?)", [name])
            found[name.casefold()] = tuple(column for (column,) in rows)
        return found

    def file(self, path: str) -> exp.Expr:
        """Refuse a file.

        Raises:
            SourceError: SQLite reads none.
        """
        raise SourceError(f"SQLite reads no files by path; load {path} into a table and name that.")

    def time_kind(self, type_name: str) -> TimeKind | None:
        """Return how a column of this type tells time: an integer counts, a text is a timestamp."""
        if "INT" in type_name:
            return TimeKind.COUNTER
        is_date = any(word in type_name for word in ("TIME", "DATE"))
        return TimeKind.TIMESTAMP if is_date or self.is_text(type_name) else None

    def is_numeric(self, type_name: str) -> bool:
        """Tell whether a column of this type holds numbers."""
        return any(word in type_name for word in ("INT", "REAL", "FLOA", "DOUB", "NUM", "DEC"))

    def is_name(self, type_name: str) -> bool:
        """Tell whether a column of this type can name an asset or a channel."""
        return "INT" in type_name or self.is_text(type_name)

    def is_text(self, type_name: str) -> bool:
        """Tell whether a column of this type holds text."""
        return any(word in type_name for word in ("CHAR", "TEXT", "CLOB"))

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once."""
        return ROWS_AT_ONCE

    def problem(self, error: Exception) -> UserError | None:
        """Return what the user can do about an error; None if it is none of the user's."""
        said = str(error)
        if "locked" in said:
            return ConflictError(CONFLICT)
        if "readonly" in said:
            return EngineError(READ_ONLY)
        if "full" in said or "disk I/O" in said:
            return EngineError(FULL)
        if "malformed" in said or "not a database" in said:
            return EngineError("The SQLite file is damaged; put it back from a copy.")
        return None

    def close(self) -> None:
        """Close the connection if it is ours, or leave it as it was."""
        if self._is_ours:
            self._connection.close()
        else:
            self._connection.isolation_level = self._level

    def _names(self, schema: str) -> list[str]:
        master = exp.Table(this=template.name("sqlite_master"), db=template.name(schema))
        names = exp.select("name").from_(master).where(exp.column("type").isin("table", "view"))
        return [name for (name,) in self._connection.execute(self.engine.text(names))]

    def _first_type(self, relation: exp.Expr, name: str) -> str:
        column = template.column(name)
        is_there = exp.Not(this=exp.Is(this=column.copy(), expression=exp.null()))
        first = exp.select(called("TYPEOF", column)).from_(relation.copy()).where(is_there).limit(1)
        row = self._connection.execute(self.engine.text(first)).fetchone()
        return "" if row is None else _DECLARED.get(row[0], "")


def _temporary(made: exp.Expr, query: exp.Query | None = None) -> exp.Create:
    return exp.Create(
        this=made,
        kind="TABLE",
        expression=query,
        properties=exp.Properties(expressions=[exp.TemporaryProperty()]),
    )


def _array(name: str, column: Sequence[Any]) -> pa.Array:
    """Return a column as Arrow; integers among doubles are doubles."""
    if any(isinstance(value, float) for value in column):
        return pa.array(column, pa.float64())
    said = [value for value in column if value is not None]
    if said and name not in _NAMES and all(_INSTANT.fullmatch(str(value)) for value in said):
        instants = [None if value is None else dt.datetime.fromisoformat(value) for value in column]
        return pa.array(instants, pa.timestamp("us"))
    return pa.array(column)


def _type_of(arrow: pa.DataType) -> str:
    if pa.types.is_integer(arrow) or pa.types.is_boolean(arrow):
        return "BIGINT"
    if pa.types.is_floating(arrow) or pa.types.is_decimal(arrow):
        return "DOUBLE"
    return "TEXT"


def _plain_rows(rows: pa.Table) -> Iterator[list[Any]]:
    """Give the rows of an Arrow table as SQLite holds them."""
    for batch in rows.to_batches(max_chunksize=65_536):
        for row in zip(*(column.to_pylist() for column in batch.columns), strict=True):
            yield [_plain(value) for value in row]


def _plain(value: Any) -> Any:
    if isinstance(value, dt.datetime):
        utc = value if value.tzinfo is None else value.astimezone(dt.UTC).replace(tzinfo=None)
        return utc.isoformat(sep=" ", timespec="microseconds")
    if isinstance(value, dt.date):
        return value.isoformat()
    return float(value) if isinstance(value, decimal.Decimal) else value
