"""The state of one monitor: what is stored of it, by the files of ``sql/stored``.

This module owns how state tables are read and appended to. It decides nothing.
"""

import secrets
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.duckdb_session import Session
from gam_db.errors import ConfigurationError, nearest
from gam_db.pipeline import filled, place
from gam_db.stored.tables import StateTables

#: A run id is the time of the run with this many random bits below, so that two writers differ.
_RANDOM_BITS = 10


def now() -> int:
    """Return this instant in microseconds (UTC)."""
    return time.time_ns() // 1000


@dataclass(frozen=True)
class State:
    """The state tables in one database.

    Attributes:
        session: an open session, for writing where anything is to be appended.
        tables: where the tables lie.
    """

    session: Session
    tables: StateTables

    def fetch(self, path: str, slots: Mapping[str, template.Slot] | None = None) -> pa.Table:
        """Return the rows of one file of ``sql/`` that reads state tables only."""
        query = filled(path, slots)
        place(query, self.tables.placed())
        return self.session.fetch(query)

    def append(self, table: str, query: exp.Query, columns: Sequence[str] | None = None) -> None:
        """Append the rows of a query to a state table; columns go by name."""
        names = [exp.to_identifier(name) for name in columns or query.named_selects]
        self.session.execute(
            exp.Insert(
                this=exp.Schema(this=self.tables.table(table), expressions=names), expression=query
            )
        )

    def append_rows(self, table: str, rows: pa.Table) -> None:
        """Append an Arrow table to a state table; columns go by name."""
        loaded = self.session.load(rows)
        columns = [exp.column(exp.to_identifier(name)) for name in rows.column_names]
        self.append(table, exp.select(*columns).from_(loaded), rows.column_names)
        self.session.forget(loaded)

    def delete_hidden(self, table: str, run_id: int, after: int) -> None:
        """Delete the rows of a table that a run has replaced."""
        hidden = filled("stored/hidden", {"run_id": run_id, "after": after})
        target = self.tables.table(table)
        place(hidden, {**self.tables.placed(), "appended": target})
        keys = exp.Tuple(expressions=[exp.column(name) for name in hidden.named_selects])
        found = exp.In(this=keys, query=exp.Subquery(this=hidden))
        self.session.execute(exp.Delete(this=target, where=exp.Where(this=found)))

    def monitors(self) -> list[dict[str, Any]]:
        """Return the monitors of this database."""
        rows: list[dict[str, Any]] = self.fetch("stored/monitors").to_pylist()
        return rows

    def monitor(self, name: str) -> dict[str, Any]:
        """Return a monitor by its name.

        Raises:
            ConfigurationError: there is none of that name.
        """
        found = self.monitors()
        for row in found:
            if row["name"] == name:
                return row
        raise ConfigurationError(
            f"There is no monitor {name!r} yet in {self.tables.shown('monitor')} "
            "(`gam calibrate` makes it)" + (nearest(name, [row["name"] for row in found]) or ".")
        )

    def last_numbers(self) -> dict[str, int]:
        """Return the largest key in use: of monitor, channel, version, support and run."""
        rows = self.fetch("stored/last_numbers").to_pylist()
        return {row["kind"]: row["last_id"] or 0 for row in rows}

    def next_run(self) -> int:
        """Return a run id above all others."""
        newest = self.last_numbers()["run"]
        return max(newest + 1, (now() << _RANDOM_BITS) + secrets.randbits(_RANDOM_BITS))


def kind_of(monitor: Mapping[str, Any]) -> TimeKind:
    """Return how the source of a monitor tells time."""
    return TimeKind(monitor["time_kind"])
