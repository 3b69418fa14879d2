"""The monitors that a state holds.

This module owns how one is found by its name.
"""

from gam_db.clock import TimeKind
from gam_db.engines.duckdb_session import Session
from gam_db.errors import StateError, nearest
from gam_db.pipeline import filled, place
from gam_db.stored import migrations
from gam_db.stored.tables import StateTables


def time_kind(session: Session, tables: StateTables, monitor: str) -> TimeKind:
    """Return how the source of a monitor tells time.

    Raises:
        StateError: there are no state tables, they are of another gam-db, or hold no such monitor.
    """
    migrations.require(session, tables)
    query = filled("stored/time_kinds")
    place(query, tables.placed())
    known = {row["name"]: row["time_kind"] for row in session.fetch(query).to_pylist()}
    if not known:
        raise StateError(f"The state tables {tables}* hold no monitor yet; run `gam calibrate`.")
    if monitor not in known:
        raise StateError(f"There is no monitor {monitor!r} in {tables}*{nearest(monitor, known)}")
    return TimeKind(known[monitor])
