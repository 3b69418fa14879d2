"""Removing state: all of it, or the rows of one monitor.

This module owns what belongs to a monitor. Only what the record of migrations lists is touched, also
that of a state of before schema 0.1, and what a migration that was cut short left beside its record:
tables and views with the names and the columns of this gam-db. Other tables stay, whatever their prefix.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from sqlglot import exp

from gam_db.engines.session import Session
from gam_db.errors import StateError, nearest
from gam_db.stored.schema.migration_files import files
from gam_db.stored.schema.migrations import Relations, former, recorded
from gam_db.stored.schema.tables import TABLES, VIEWS, StateTables


@dataclass(frozen=True)
class Removal:
    """What would be removed of one table or view.

    Attributes:
        name: of the table, without prefix.
        table: its node.
        rows: how many; None for a view.
        statement: what drops it, or the keys of the rows that go.
    """

    name: str
    table: exp.Table
    rows: int | None
    statement: exp.Drop | exp.Query


def removals(session: Session, tables: StateTables, monitor: str | None = None) -> tuple[Removal, ...]:
    """Return the tables and views to remove, in a possible order; write nothing.

    That is the rows of a monitor, or without one all tables and views.

    Raises:
        StateError: there is no state, no such monitor, or a newer gam-db made the state.
    """
    there = session.relations(tables.schema)
    state_names = _state_names(session, tables, there)
    names_before, of_before = former(session, tables, there)
    if of_before:
        tables, state_names = names_before, {row.name for row in of_before}
    present = [
        name for name in (*TABLES, *VIEWS) if name in state_names and tables.folded(name) in there
    ]
    if not present:
        raise StateError(f"There are no state tables {tables}* in this database.")
    if monitor is not None:
        rows_of = _conditions(tables, _monitor_id(session, tables, monitor))
        return tuple(
            Removal(
                name,
                tables.table(name),
                _count(session, tables.table(name), owned),
                exp.select(owned.this.copy()).distinct().from_(tables.table(name)).where(owned),
            )
            for name, owned in rows_of.items()
            if name in present
        )
    return tuple(_dropped(session, tables, name) for name in reversed(present))


def remove(session: Session, pending: Sequence[Removal]) -> None:
    """Remove what :func:`removals` returns: all or nothing, if the engine has transactions.

    Raises:
        EngineError: the database cannot be written.
    """
    with session.transaction():
        for removal in pending:
            if isinstance(removal.statement, exp.Drop):
                session.execute(removal.statement)
            else:
                keys = removal.statement.named_selects
                session.delete(removal.table, keys, removal.statement)


def _state_names(session: Session, tables: StateTables, there: Relations) -> set[str]:
    """Return the names of the tables and views that are certainly of this state.

    The record lists files. A name counts if its file is listed, or if it has the columns that it has
    here: a migration may have been cut short.
    """
    if tables.folded("migration") not in there:
        return set()
    listed = {row.name for row in recorded(session, tables, there)}
    if not listed <= {migration.name for migration in files()}:
        return set()
    return {
        name
        for migration in files()
        for name, about in migration.definitions.items()
        if migration.name in listed or there.get(tables.folded(name)) == tuple(about.columns)
    }


def _dropped(session: Session, tables: StateTables, name: str) -> Removal:
    table, kind = tables.table(name), "VIEW" if name in VIEWS else "TABLE"
    rows = None if name in VIEWS else _count(session, table)
    return Removal(name, table, rows, exp.Drop(tables=[table.copy()], kind=kind))


def _conditions(tables: StateTables, monitor_id: int) -> dict[str, exp.Expr]:
    """Return which rows of each table belong to a monitor, in the order in which they can go."""

    def among(key: str, table: str, owned: exp.Expr) -> exp.Expr:
        keys = exp.select(key).from_(tables.table(table)).where(owned)
        return exp.column(key).isin(query=keys)

    of_monitor = exp.column("monitor_id").eq(exp.Literal.number(monitor_id))
    of_channels = among("channel_id", "channel", of_monitor)
    of_versions = among("version_id", "version", of_channels)
    of_supports = among("support_id", "version", of_channels)
    return {
        **dict.fromkeys(
            ("bucket", "novel", "unknown_program", "judgement", "run", "horizon", "calibration"),
            of_versions,
        ),
        **dict.fromkeys(("checksum", "buffered", "band", "extent", "limit"), of_versions),
        **dict.fromkeys(("band_visit", "move"), of_versions),
        **dict.fromkeys(("block", "ladder", "probe", "program", "support", "bounds"), of_supports),
        "version": of_channels,
        **dict.fromkeys(("proof", "episode", "label", "channel", "unplaced", "left_out"), of_monitor),
        "monitor": of_monitor,
    }


def _monitor_id(session: Session, tables: StateTables, monitor: str) -> int:
    query = exp.select("monitor_id", "name").from_(tables.table("monitor"))
    ids = {row["name"]: row["monitor_id"] for row in session.rows(query)}
    if monitor not in ids:
        raise StateError(
            f"There is no monitor {monitor!r} in the state tables {tables}*{nearest(monitor, ids)}"
        )
    return int(ids[monitor])


def _count(session: Session, table: exp.Table, owned: exp.Expr | None = None) -> int:
    query = exp.select(exp.alias_(exp.Count(this=exp.Star()), "found")).from_(table.copy())
    return int(session.rows(query.where(owned))[0]["found"])
