"""What the method reads of a source, on DuckDB."""

import datetime as dt
from typing import Any

from gam_db import Source
from gam_db.engines.duckdb.session import DuckSession
from gam_db.reading.preparing import prepared


def read(relation: Any, engine: Any = None, **said: Any) -> list[tuple[Any, Any]]:
    """The readings of one signal: time as an integer, and the value."""
    with DuckSession(engine) as session:
        found = prepared(session, Source(relation, None, None, **said))
        rows = session.engine.readings(found.rows, found.relation, found.kind)
        return [(row["time"], row["reading"]) for row in session.fetch(rows).to_pylist()]


def micros(time: dt.datetime) -> int:
    return (time - dt.datetime(1970, 1, 1)) // dt.timedelta(microseconds=1)
