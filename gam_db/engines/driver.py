"""The interface of drivers: each wraps the client library of an engine for a session.

A driver owns what its client library needs; :mod:`gam_db.engines.session` owns what all share.
"""

import contextlib
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Protocol

import pyarrow as pa
from sqlglot import exp

from gam_db.engines.base import Engine, deletion, temporary, with_columns
from gam_db.engines.refusals import refusal
from gam_db.errors import SourceError, UserError
from gam_db.settings.form import Form
from gam_db.settings.source import shown_relation


class Driver(Protocol):
    """A connection to an engine, as its client library has it.

    What has a body here is what most engines do; one that has no transactions leaves those be.
    """

    engine: Engine  # how trees become its text
    #: What the client library raises when the engine refuses something.
    errors: tuple[type[Exception], ...]
    #: The error on the file {path} if the engine reads no files.
    no_files: str = "{path} is a file, which this engine does not read."
    #: How many readings can be worked on at once, where that is fixed: it sorts on its disk.
    most_rows: int = 4_000_000
    #: Begins a transaction that changes nothing; empty where there is none.
    begins_reading: str = ""

    def execute(self, statement: str) -> None:
        """Run one statement."""

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query; columns keep their names, integers are int64, doubles float64."""

    def rows(self, query: str) -> list[dict[str, Any]]:
        """Return the same, each row by the names of its columns."""
        rows: list[dict[str, Any]] = self.fetch(query).to_pylist()
        return rows

    def begin(self) -> None:
        """Begin a transaction, where there are any."""
        return

    def commit(self) -> None:
        """End it."""
        return

    def rollback(self) -> None:
        """Undo it."""
        return

    def in_transaction(self) -> bool:
        """Tell whether a transaction is open that is not ours."""
        return False

    @contextlib.contextmanager
    def only_reading(self) -> Iterator[None]:
        """Let statements change nothing for a while, where the engine can and no transaction is open."""
        if not self.begins_reading or self.in_transaction():
            yield
            return
        self.execute(self.begins_reading)
        try:
            yield
        finally:
            with contextlib.suppress(*self.errors):  # some errors have ended it
                self.rollback()

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        """Make a temporary table of the rows of a query, and let the planner know its size."""

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        """Make a temporary table of the rows of an Arrow table."""

    def drop(self, table: exp.Table) -> None:
        """Drop a table made by :meth:`keep` or :meth:`ingest`."""
        self.execute(self.engine.text(exp.Drop(tables=[table.copy()], kind="TABLE", exists=True)))

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query, as one step."""
        self.execute(self.engine.text(deletion(table, keys, key_rows)))

    def tables(self) -> list[tuple[str, ...]]:
        """Return what can be read, tables and views: (catalogue, schema, name) as far as there are."""

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node of a table by all the names that it takes to read no other one.

        Raises:
            SourceError: it is not where it is looked for, or cannot be read.
        """
        return table

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and the engine's names of their types."""

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, names of tables in lower case."""

    def file(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a file, or some, written in a form.

        Raises:
            SourceError: the engine reads none.
        """
        raise SourceError(self.no_files.format(path=shown_relation(relation)))

    def expect_conditions(self) -> None:
        """Be ready for statements that run a condition of the user's, from now on."""
        return

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once."""
        return self.most_rows

    def threads(self) -> int:
        """Return how many parts of a statement are worked on side by side, where that is known."""
        return 1

    def problem(self, error: Exception) -> UserError | None:
        """Return what the user can do about an error; None if it is none of the user's."""

    def close(self) -> None:
        """Close the connection if it is ours."""


class DbapiDriver(Driver):
    """A connection of a library that keeps to PEP 249, open and with no transaction.

    A driver of one says what differs: its catalogue, what its types mean, how rows come out.
    """

    place = "?"  # what stands for a value in a statement

    def __init__(self, connection: Any, owned: bool) -> None:
        self._connection, self._owned = connection, owned

    def execute(self, statement: str) -> None:
        self._run(statement)

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query; a column without any value has the type null."""
        cursor = self._connection.cursor()
        cursor.execute(query)
        described = cursor.description
        rows = cursor.fetchall()
        columns = list(zip(*rows, strict=True)) if rows else [()] * len(described)
        arrays = [
            self.array(description, column)
            for description, column in zip(described, columns, strict=True)
        ]
        return pa.table(arrays, names=[name for name, *_ in described])

    def array(self, described: Sequence[Any], column: Sequence[Any]) -> pa.Array:
        """Return a column that was fetched as Arrow; ``described`` is what the library says of it."""
        return pa.array(column)

    def begin(self) -> None:
        self._run(self.engine.begins)

    def commit(self) -> None:
        self._run("COMMIT")

    def rollback(self) -> None:
        if self.in_transaction():
            self._run("ROLLBACK")

    def in_transaction(self) -> bool:
        return bool(self._connection.in_transaction)

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.execute(self.engine.text(temporary(table, query, *self.engine.storage.temporary)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        types = {field.name: self.type_of(field.type) for field in rows.schema}
        empty = temporary(with_columns(table, types), None, *self.engine.storage.temporary)
        self.execute(self.engine.text(empty))
        places = exp.Tuple(expressions=[exp.var(self.place) for _ in types])
        insert = exp.Insert(this=table.copy(), expression=exp.Values(expressions=[places]))
        cursor = self._connection.cursor()
        for batch in rows.to_batches(max_chunksize=65_536):
            plain = ([self.plain(value) for value in column.to_pylist()] for column in batch.columns)
            cursor.executemany(self.engine.text(insert), list(zip(*plain, strict=True)))

    def type_of(self, arrow: pa.DataType) -> exp.DataType:
        """Return the type of a column that is to hold Arrow's values."""
        if pa.types.is_integer(arrow) or pa.types.is_boolean(arrow):
            return exp.DataType.build("BIGINT")
        if pa.types.is_floating(arrow) or pa.types.is_decimal(arrow):
            return exp.DataType.build("DOUBLE")
        return exp.DataType.build("TEXT")

    def plain(self, value: Any) -> Any:
        """Return a value of an Arrow table as the library takes it."""
        return value

    def problem(self, error: Exception) -> UserError | None:
        named = getattr(error, "sqlite_errorname", "")
        return refusal(self.engine.name, *map(str, error.args), named)

    def close(self) -> None:
        if self._owned:
            self._connection.close()

    def _run(self, statement: str, values: Sequence[Any] = ()) -> list[tuple[Any, ...]]:
        """Run a statement; return its rows, none of one that has none."""
        cursor = self._connection.cursor()
        cursor.execute(statement, *([values] if values else []))  # without values no sign stands for one
        return list(cursor.fetchall()) if cursor.description else []


def usual(rows: pa.Table) -> pa.Table:
    """Return rows with integers as int64, numbers as float64, names as string; all can be NULL.

    Cause: ClickHouse counts in UInt64, takes the smallest type for a literal, and has columns that
    cannot be NULL. Symptom: one and the same query gives rows of other types than other engines do.
    """
    return rows.cast(pa.schema([(field.name, _usual(field.type)) for field in rows.schema]))


def _usual(arrow: pa.DataType) -> pa.DataType:
    if pa.types.is_integer(arrow):
        return pa.int64()
    if pa.types.is_floating(arrow):
        return pa.float64()
    if pa.types.is_dictionary(arrow):
        return _usual(arrow.value_type)
    if is_text(arrow):
        return pa.string()
    if pa.types.is_timestamp(arrow) and arrow.tz is not None:
        return pa.timestamp(arrow.unit, "UTC")
    return arrow


def is_text(arrow: pa.DataType) -> bool:
    """Tell whether a column holds texts, in whatever form."""
    return bool(
        pa.types.is_string(arrow) or pa.types.is_large_string(arrow) or pa.types.is_string_view(arrow)
    )


def by_table(rows: Iterable[tuple[str, str]]) -> dict[str, tuple[str, ...]]:
    """Return the columns of tables, names of tables in lower case, of rows (table, column) in order."""
    columns: dict[str, tuple[str, ...]] = {}
    for table, column in rows:
        columns[table.casefold()] = (*columns.get(table.casefold(), ()), column)
    return columns
