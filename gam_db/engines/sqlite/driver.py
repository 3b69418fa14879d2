"""SQLite at work, by the standard library. Timestamps are texts (ISO 8601, UTC) or integer counters."""

import contextlib
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

from gam_db.composing import template
from gam_db.engines.base import called
from gam_db.engines.driver import DbapiDriver
from gam_db.engines.refusals import OPEN
from gam_db.engines.sqlite import ENGINE
from gam_db.errors import EngineError

#: How long a writer waits for another one, in seconds.
PATIENCE = 30

_SCHEME = "sqlite:///"
_NAMES = ("asset", "channel", "name")
_INSTANT = re.compile(r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{6}")
_DECLARED = {"integer": "INTEGER", "real": "REAL", "text": "TEXT"}


def connected(target: Any, writable: bool) -> "SqliteDriver":
    """Open ``sqlite:///PATH`` or ``sqlite://`` (in memory), or take an open connection.

    Raises:
        EngineError: it cannot be opened, is no SQLite database, or this SQLite is too old.
    """
    ENGINE.check_version(sqlite3.sqlite_version)
    if isinstance(target, sqlite3.Connection):
        if target.in_transaction:
            raise EngineError(OPEN)
        return SqliteDriver(target, owned=False)
    if target in ("sqlite://", "sqlite:///:memory:"):
        return SqliteDriver(sqlite3.connect(":memory:", isolation_level=None), owned=True)
    if not target.startswith(_SCHEME):
        raise EngineError(
            f"{target} names a server; for a SQLite file write sqlite:///PATH, with three slashes."
        )
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
        raise EngineError(f"{path} cannot be opened as a SQLite file; is it a SQLite file?") from error
    if writable and not os.access(path, os.W_OK):
        connection.close()
        raise EngineError(f"{path} cannot be written: you have only read permission.")
    return SqliteDriver(connection, owned=True)


class SqliteDriver(DbapiDriver):
    """A connection to SQLite.

    It has no type for instants: a column of texts such as gam-db writes for them comes out as
    timestamps, unless it holds names.
    """

    engine = ENGINE
    errors: tuple[type[Exception], ...] = (sqlite3.Error,)
    no_files = "SQLite does not read files by path; load {path} into a table and name the table."
    most_rows = 5_000_000  # temporary tables are on disk

    def __init__(self, connection: sqlite3.Connection, owned: bool) -> None:
        super().__init__(connection, owned)
        self._level = connection.isolation_level
        # A connection of the user's begins transactions of its own accord otherwise.
        connection.isolation_level = None

    def array(self, described: Sequence[Any], column: Sequence[Any]) -> pa.Array:
        """Return a column as Arrow; integers among doubles are doubles."""
        if any(isinstance(value, float) for value in column):
            return pa.array(column, pa.float64())
        present = [value for value in column if value is not None]
        is_named = described[0] in _NAMES
        if present and not is_named and all(_INSTANT.fullmatch(str(value)) for value in present):
            instants = [None if value is None else dt.datetime.fromisoformat(value) for value in column]
            return pa.array(instants, pa.timestamp("us"))
        return pa.array(column)

    def plain(self, value: Any) -> Any:
        if isinstance(value, dt.datetime):
            utc = value if value.tzinfo is None else value.astimezone(dt.UTC).replace(tzinfo=None)
            return utc.isoformat(sep=" ", timespec="microseconds")
        if isinstance(value, dt.date):
            return value.isoformat()
        return float(value) if isinstance(value, decimal.Decimal) else value

    @contextlib.contextmanager
    def only_reading(self) -> Iterator[None]:
        """Let statements change nothing for a while, also in a transaction."""
        ((before,),) = self._run("PRAGMA query_only")
        self._run("PRAGMA query_only = 1")
        try:
            yield
        finally:
            self._run(f"PRAGMA query_only = {before}")

    def tables(self) -> list[tuple[str, ...]]:
        """Return the tables and views of all attached files: (schema, name)."""
        schemas = [name for _, name, _ in self._run("PRAGMA database_list")]
        return [(schema, name) for schema in schemas for name in self._names(schema)]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their declared types.

        SQLite declares none for an expression of a view: there the first value tells.
        """
        table = relation.find(exp.Table)
        assert table is not None
        return {
            name: str(declared).upper() or self._first_type(relation, name)
            for name, declared in self._info(table.name, table.db or None)
        }

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of the main file with their columns; there are no schemas."""
        if schema is not None:
            raise EngineError("SQLite has no schemas; leave schema out and give another prefix.")
        tables = {name: self._info(name) for name in self._names("main")}
        return {name.casefold(): tuple(column for column, _ in info) for name, info in tables.items()}

    def close(self) -> None:
        super().close()
        if not self._owned:
            self._connection.isolation_level = self._level

    def _info(self, table: str, schema: str | None = None) -> list[tuple[Any, ...]]:
        """Return the columns of a table: name and declared type."""
        return self._run("SELECT name, type FROM PRAGMA_TABLE_INFO(?, ?)", [table, schema])

    def _names(self, schema: str) -> list[str]:
        master = exp.Table(this=template.name("sqlite_master"), db=template.name(schema))
        names = exp.select("name").from_(master).where(exp.column("type").isin("table", "view"))
        return [name for (name,) in self._run(self.engine.text(names))]

    def _first_type(self, relation: exp.Expr, name: str) -> str:
        column = template.column(name)
        is_there = exp.Not(this=exp.Is(this=column.copy(), expression=exp.null()))
        first = exp.select(called("TYPEOF", column)).from_(relation.copy()).where(is_there).limit(1)
        rows = self._run(self.engine.text(first))
        return _DECLARED.get(rows[0][0], "") if rows else ""
