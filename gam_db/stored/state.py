"""The stored state of monitors, read and appended to by the files of ``sql/stored``.

This module owns how state tables are read and appended to. It decides nothing.
"""

import contextlib
import secrets
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.columns import table_of
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.composing.plan import insertion
from gam_db.engines.session import CONFLICT, Row, Session
from gam_db.errors import ConfigurationError, ConflictError, EngineError, StateError, nearest
from gam_db.stored.schema.migration_files import columns_of
from gam_db.stored.schema.tables import StateTables

#: The slots of a file, and tables that stand for what it reads besides.
Slots: TypeAlias = Mapping[str, template.Slot] | None
TableNodes: TypeAlias = Mapping[str, exp.Table] | None

#: A run id is the time of the run with this many random bits below, so that two writers differ.
_RANDOM_BITS = 10


def now() -> int:
    """Return this instant in microseconds (UTC)."""
    return time.time_ns() // 1000


def first_run_at(instant: int) -> int:
    """Return the smallest id of a run that begins at an instant (microseconds, UTC)."""
    return instant << _RANDOM_BITS


@dataclass(frozen=True)
class State:
    """The state tables in one database.

    Attributes:
        session: an open session, for writing where anything is to be appended.
        tables: where the tables lie.
    """

    session: Session
    tables: StateTables

    def fetch(self, path: str, slots: Slots = None, tables: TableNodes = None) -> pa.Table:
        """Return the rows of one file of ``sql/`` that reads state tables, and perhaps some others."""
        return self.session.fetch(self.query(path, slots, tables))

    def rows(self, path: str, slots: Slots = None, tables: TableNodes = None) -> list[Row]:
        """Return the same, each row by the names of its columns."""
        return self.session.rows(self.query(path, slots, tables))

    def query(self, path: str, slots: Slots = None, tables: TableNodes = None) -> exp.Query:
        """Return the query of such a file, filled, over where its tables lie."""
        query = filled(path, slots)
        place(query, {**self.tables.nodes(), **(tables or {})})
        return query

    def append(self, table: str, query: exp.Query) -> None:
        """Append the rows of a query to a state table; columns go by name."""
        self.session.execute(insertion(self.tables.table(table), query))

    def append_rows(self, table: str, rows: Sequence[Row]) -> None:
        """Append rows, if any, to a state table: the values of its columns, NULL for missing ones."""
        if not rows:
            return
        schema = columns_of(table)
        with self.session.lent(table_of(rows, schema)) as lent:
            names = [exp.column(exp.to_identifier(name)) for name in schema.names]
            self.append(table, exp.select(*names).from_(lent))

    def hidden(self, table: str, run_id: int, after: int, near: exp.Expr) -> exp.Query:
        """Return the query of the rows of a table that a run has replaced; the slots are the file's."""
        slots: Slots = {"run_id": run_id, "after": after, "near": near}
        return self.query("stored/state/superseded", slots, {"appended": self.tables.table(table)})

    def monitors(self) -> list[dict[str, Any]]:
        """Return the monitors of this database."""
        return self.rows("stored/state/monitors")

    def monitor(self, name: str) -> dict[str, Any]:
        """Return a monitor by its name.

        Raises:
            ConfigurationError: no monitor has that name.
        """
        monitors = self.monitors()
        for row in monitors:
            if row["name"] == name:
                return row
        raise ConfigurationError(
            f"There is no monitor {name!r} yet in {self.tables.shown('monitor')} "
            "(`gam calibrate` makes it)" + nearest(name, [row["name"] for row in monitors])
        )

    def last_numbers(self) -> dict[str, int]:
        """Return the largest key in use: of monitor, channel, version, support and run."""
        rows = self.rows("stored/state/last_numbers")
        return {row["kind"]: row["last_id"] or 0 for row in rows}

    def keys(self) -> dict[str, int]:
        """Return the largest key in use, but for runs: what calibrating adds to."""
        return {kind: last for kind, last in self.last_numbers().items() if kind != "run"}

    @contextlib.contextmanager
    def alone(self, keys: dict[str, int]) -> Iterator[None]:
        """Do all inside as one transaction, whose new keys no other writer gives.

        Two calibrations at once would give the same keys twice. So each touches one row, which only one
        of them may, and one that begins when the other has ended finds other keys than it was made for.
        Without transactions the other is noticed at the end.

        Args:
            keys: what :meth:`keys` said before the decision on what to write; brought up to date.

        Raises:
            ConflictError: another connection was faster; nothing of this transaction was written.
            EngineError: without transactions: another one wrote at the same time, and both are there.
        """
        with self.session.transaction():
            if self.session.transactions:
                for statement in _touching(self.tables.table("migration"), "number", 1, "applied_at"):
                    self.session.execute(statement)
            if self.keys() != keys:
                raise ConflictError(CONFLICT)
            yield
            keys.update(self.keys())
            if self.rows("stored/state/doubled"):
                raise EngineError(
                    f"Another process wrote to {self.tables}* at the same time, and some channels "
                    "occur twice. Remove the monitor (`gam drop --monitor`), and calibrate it again, "
                    "one process at a time."
                )

    def lock(self, monitor_id: int) -> None:
        """Keep others from publishing or pruning runs of a monitor until this transaction ends, if any.

        Raises:
            ConflictError: another one does so, and the engine does not wait for it.
        """
        if self.session.transactions:
            for statement in locking(self.tables, monitor_id):
                self.session.execute(statement)

    def next_run(self) -> int:
        """Return a run id above all others, which no other writer gives at the same time."""
        newest = self.last_numbers()["run"]
        return max(newest + 1, first_run_at(now())) + secrets.randbits(_RANDOM_BITS)


def locking(tables: StateTables, monitor_id: int) -> list[exp.Expr]:
    """Return the statements that keep other transactions from publishing runs of a monitor."""
    return _touching(tables.table("monitor"), "monitor_id", monitor_id, "created")


def _touching(table: exp.Table, key: str, value: int, column: str) -> list[exp.Expr]:
    """Return what changes a row and changes it back: the same value alone is no change to DuckDB."""
    row, touched = exp.column(key).eq(value), exp.column(column)
    return [
        exp.update(table.copy(), {column: again}, row.copy()) for again in (touched + 1, touched - 1)
    ]


def kind_of(monitor: Mapping[str, Any]) -> TimeKind:
    """Return the kind of time of the source of a monitor.

    Raises:
        StateError: its row says nothing that gam-db writes.
    """
    try:
        return TimeKind(monitor["time_kind"])
    except ValueError as error:
        raise StateError(
            f"The row of the monitor {monitor['name']!r} was changed by hand: there is no kind of time "
            f"{monitor['time_kind']!r}. Restore it from a copy of the database."
        ) from error
