"""Local times of a source as instants, and the rows of it that lie in a range of these.

This module owns which rows of local time a range can hold, and how they become readings by instants.
"""

from collections.abc import Callable, Sequence

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.settings.local_time import TWICE, by_time
from gam_db.settings.source import (
    AnySource,
    TimeNode,
    clock_of,
    parsed_condition,
    read_from,
    readings,
    stacked,
    under,
    up_to,
)

#: From the ends of a range of time to conditions on the column.
RangeNode = Callable[[int, int], list[exp.Expr]]


def ranged_readings(
    source: AnySource,
    relation: exp.Expr,
    micros_of: TimeNode,
    number_of: TimeNode,
    within: RangeNode,
    unpivots: bool = False,
    earliest: int = LONG_AGO,
    latest: int = FAR_AHEAD,
    validity: bool = False,
    until: exp.Expr | int | None = None,
) -> exp.Query:
    """Return the step *readings* of a source, of the rows from an instant to another.

    Args:
        source: what is read.
        relation: the node that reads it.
        micros_of: turns the time column into integer microseconds, or leaves a counter as it is.
        number_of: reads a column of numbers so that nothing of a value is dropped.
        within: returns the conditions that the time column lies in a range, both ends included.
        unpivots: whether the engine can make a row of each of many columns by itself.
        earliest: the first instant that is read; local times become instants here.
        latest: the last one.
        validity: whether a reading is 1 or 0, as the user's condition on readings holds or not.
        until: an integer time; rows that are later are left out, and rows without a time stay.
    """
    clock = clock_of(source)
    if clock is None:
        ranged = _narrowed(source, within(earliest, latest))
        return readings(ranged, relation, micros_of, number_of, unpivots, validity, until)
    # Local times of the range, and perhaps others: which instants they are is told by the rows.
    edges = clock.earliest(earliest), clock.latest(latest)
    pieces, time = clock.pieces(*edges), exp.column("time")

    def shown(file: str, conditions: Sequence[exp.Expr], **slots: template.Slot) -> exp.Query:
        ranged = _narrowed(source, conditions)
        rows = readings(ranged, relation, micros_of, number_of, unpivots, validity)
        programs = [] if source.program is None else [exp.column("program")]
        filled = template.fill(file, {**slots, "carried": programs})
        read_from(rows.subquery("local_readings", copy=False), filled)
        return filled  # type: ignore[return-value]

    near = within(*edges)
    once = by_time(time, pieces, lambda piece: TWICE if piece.is_twice else piece.shift)
    branches = [shown("source/shown_once", near, shift=once, twice=TWICE)]
    if repeated := clock.repeated(*edges):
        hours = (exp.and_(*within(*ends), copy=False) for ends in repeated)
        among = exp.paren(exp.or_(*hours, copy=False), copy=False)
        passes = [piece for piece in pieces if piece.is_twice]
        first, second = (
            by_time(time, passes, shift_of) for shift_of in (lambda p: p.shift, lambda p: p.second)
        )
        ordered: list[exp.Expr] = []
        if source.program is not None:
            ordered = [template.fill("program/untold"), exp.column("program")]
        shifts: dict[str, template.Slot] = {"shift": first, "second": second, "ordered": ordered}
        branches.append(shown("source/shown_twice", [*near, among], **shifts))
    query = stacked(branches)
    is_whole = (earliest, latest) == (LONG_AGO, FAR_AHEAD)
    if is_whole and until is None:
        return query
    columns = [exp.column(name) for name in query.named_selects]
    ends = template.node_of(earliest), template.node_of(latest)
    zoned = exp.select(*columns).from_(query.subquery("zoned", copy=False))
    return up_to(zoned if is_whole else zoned.where(time.between(*ends), copy=False), "time", until)


def undated(source: AnySource, relation: exp.Expr, micros_of: TimeNode) -> exp.Query:
    """Return what counts the rows that tell no time, by their cause (``sql/source/undated.sql``)."""
    clock, shift = clock_of(source), template.node_of(0)
    if clock is not None:
        pieces = clock.pieces()
        shift = by_time(
            exp.column("clock_time", table="clock"),
            pieces,
            lambda piece: TWICE if piece.is_twice else piece.shift,
        )
    slots: dict[str, template.Slot] = {
        "stored": template.column(source.time),
        "instant": micros_of(template.column(source.time)),
        "shift": shift,
        "twice": TWICE,
        "condition": parsed_condition(source.where),
    }
    filled = template.fill("source/undated", slots)
    read_from(relation, filled)
    return filled  # type: ignore[return-value]


def _narrowed(source: AnySource, conditions: Sequence[exp.Expr]) -> AnySource:
    return under(source, *conditions) if conditions else source
