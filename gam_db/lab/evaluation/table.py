"""The table of health indicators: which of its columns say what.

This module owns how the tables of gam-db, and any other series of indicators, are told apart and read.
"""

from dataclasses import dataclass
from typing import Any

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.composing import template
from gam_db.composing.pipeline import filled
from gam_db.engines.session import Session
from gam_db.errors import SourceError, nearest
from gam_db.reading.preparing import with_times_read
from gam_db.settings.source import Source

PLACES = ("bucket", "time", "index")
"""Columns that order the values of a channel; the first that is there does."""


@dataclass(frozen=True)
class HealthTable:
    """A table of health indicators.

    Attributes:
        indicator: the query of the step *indicator*.
        kind: how it tells the time that ``failed_at`` is compared with; None if it tells none.
        counts: whether the indicator is a count of novel vectors over a window.
        buckets: whether its values are numbered buckets, of which the first ones are not full.
        vectors: whether it is what gam run writes with a row per vector.
        limited: whether it tells the limit of its channels.
    """

    indicator: exp.Query
    kind: TimeKind | None
    counts: bool
    buckets: bool
    vectors: bool = False
    limited: bool = False


def health_table(session: Session, relation: Any) -> HealthTable:
    """Look at a table of health indicators.

    Raises:
        SourceError: it cannot be read, or a column is missing or of the wrong type.
    """
    node = session.relation(relation)
    columns = session.describe(node)
    for name in ("asset", "channel", "hi"):
        if name not in columns:
            raise SourceError(
                f"The table of health indicators has no column {name!r}{nearest(name, columns)} It "
                "takes what gam run writes, or asset, channel, index and hi."
            )
    for name in ("asset", "channel"):
        if not session.engine.types.is_name(columns[name]):
            raise SourceError(
                f"The column {name!r} is of type {columns[name]}; it must be text or an integer."
            )
    if not session.engine.types.is_numeric(columns["hi"]):
        raise SourceError(f"The column 'hi' is of type {columns['hi']}; it must be a number.")
    place = next((name for name in PLACES if name in columns), None)
    if place is None:
        raise SourceError(
            "The table of health indicators has no column that orders its values; it takes "
            f"{', '.join(PLACES[:-1])} or {PLACES[-1]}."
        )
    time = "last_time" if place == "bucket" and "last_time" in columns else place
    if time == "last_time" and "last_tick" in columns and is_empty(session, node, time):
        time = "last_tick"  # a view of a monitor whose source counts time
    if time in columns:
        node = with_times_read(session, Source(relation, None, None, time, "hi"), columns, node)
    kinds = {name: _kind(session, name, columns[name]) for name in (place, time)}
    counts = "novel_in_window" in columns
    integer_of = session.engine.micros_of
    query = filled(
        "lab/evaluation/indicator",
        {
            "asset": template.column("asset"),
            "channel": template.column("channel"),
            "place": integer_of(kinds[place], template.column(place)),
            "time": integer_of(kinds[time], template.column(time)),
            "hi": template.column("hi"),
            "novel_in_window": template.column("novel_in_window") if counts else None,
            **{
                name: template.column(name) if name in columns else None
                for name in ("vectors_in_window", "hi_limit")
            },
        },
    )
    read_from(query, "health", node)
    vectors = place == "time" and counts and "vectors_in_window" in columns
    kind = None if time == "bucket" else kinds[time]
    return HealthTable(query, kind, counts, place == "bucket", vectors, "hi_limit" in columns)


def read_from(query: exp.Query, name: str, relation: exp.Expr) -> None:
    """Let a query read a relation where it names it; in place."""
    for table in list(query.find_all(exp.Table)):
        if table.name == name and not table.db:
            table.replace(relation.copy())


def is_empty(session: Session, relation: exp.Expr, column: str) -> bool:
    """Tell whether no row of a relation has a value in a column."""
    count = exp.Count(this=template.column(column))
    (row,) = session.rows(exp.select(exp.alias_(count, "count")).from_(relation.copy()))
    return bool(row["count"] == 0)


def _kind(session: Session, name: str, type_name: str) -> TimeKind:
    kind = session.engine.types.time_kind(type_name)
    if kind is None or (name == "bucket" and not kind.is_counter):
        wanted = "an integer" if name == "bucket" else "an integer or a timestamp"
        raise SourceError(f"The column {name!r} is of type {type_name}; it must be {wanted}.")
    return kind
