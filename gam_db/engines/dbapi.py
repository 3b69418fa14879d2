"""Engines whose client library keeps to PEP 249: what their drivers do alike.

A driver of one of them says what differs: its catalogue, what its types mean, how rows come out.
"""

from collections.abc import Sequence
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.engines.base import temporary, with_columns
from gam_db.engines.driver import Driver
from gam_db.engines.refusals import refusal
from gam_db.errors import UserError


class DbapiDriver(Driver):
    """A connection of such a library, open and with no transaction."""

    begins = "BEGIN"  # the statement that begins a transaction
    place = "?"  # what stands for a value in a statement
    storage: Sequence[exp.Expr] = ()  # what is said of the storage of temporary tables

    def __init__(self, connection: Any, owned: bool) -> None:
        self._connection, self._owned = connection, owned

    def execute(self, statement: str) -> None:
        self._asked(statement)

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query; a column without any value has the type null."""
        cursor = self._connection.cursor()
        cursor.execute(query)
        described = cursor.description
        rows = cursor.fetchall()
        columns = list(zip(*rows, strict=True)) if rows else [()] * len(described)
        arrays = [self.array(one, column) for one, column in zip(described, columns, strict=True)]
        return pa.table(arrays, names=[name for name, *_ in described])

    def array(self, described: Sequence[Any], column: Sequence[Any]) -> pa.Array:
        """Return a column that was fetched as Arrow; ``described`` is what the library says of it."""
        return pa.array(column)

    def begin(self) -> None:
        self._asked(self.begins)

    def commit(self) -> None:
        self._asked("COMMIT")

    def rollback(self) -> None:
        if self.in_transaction():
            self._asked("ROLLBACK")

    def in_transaction(self) -> bool:
        return bool(self._connection.in_transaction)

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.execute(self.engine.text(temporary(table, query, *self.storage)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        types = {field.name: self.type_of(field.type) for field in rows.schema}
        self.execute(self.engine.text(temporary(with_columns(table, types), None, *self.storage)))
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
        return refusal(self.engine.name, *map(str, error.args[:1]))

    def close(self) -> None:
        if self._owned:
            self._connection.close()

    def _asked(self, statement: str, values: Sequence[Any] = ()) -> list[tuple[Any, ...]]:
        """Run a statement; return its rows, none of one that has none."""
        cursor = self._connection.cursor()
        cursor.execute(statement, *([values] if values else []))  # without values no sign stands for one
        return list(cursor.fetchall()) if cursor.description else []
