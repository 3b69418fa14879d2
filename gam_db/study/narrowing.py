"""Narrowing: of a source that is counted by slices of time, how little is read sample by sample.

This module owns the range of time in which the edges lie, and that slices are cut finer where these hold
too much.
"""

from collections.abc import Callable, Collection

from sqlglot import exp

from gam_db.engines.session import Row
from gam_db.method.census import EDGES, Slicing, slices_for
from gam_db.study.running import Running

#: Slices that hold so many times what they would of evenly spaced samples are cut finer: that is a pass
#: over their rows, where to read them is a sort.
SKEWED = 4


def narrow(running: Running, between: Callable[[int, int], exp.Query]) -> None:
    """Let the readings of the edges be those between their first and their last instant.

    Args:
        running: steps that trust, at work; nothing is to be done where they keep samples in order.
        between: makes the step *readings* for a range of time.
    """
    steps = running.steps
    if EDGES in steps.steps and (edges := _found(running, between)):
        steps.replace(EDGES, between(*_hull(edges)))


def _found(running: Running, between: Callable[[int, int], exp.Query]) -> list[Row]:
    """Return the slices that must be read, cut finer as long as that halves the range in which they lie.

    They hold too much where times are skewed: one row of long ago, and all others lie in one slice.
    """
    readings = {row["channel_id"]: row["readings"] for row in running.rows("channels")}
    slices, extent = slices_for(sum(readings.values()), max(len(readings), 1)), None
    while True:
        running.keep("edges")
        rows = running.rows("edges")
        edges = [row for row in rows if row["is_edge"]]
        even = sum(readings[row["channel_id"]] for row in edges) / slices
        if sum(row["samples"] for row in edges) <= SKEWED * even:
            return edges
        first, last = _hull(edges)
        # Those of other channels begin and end elsewhere.
        met = [row for row in rows if row["last_time"] >= first and row["first_time"] <= last]
        first, last = _hull(met)
        if extent is None:
            begin, end = _hull(rows)
            extent = end - begin
        if not 0 < 2 * (last - first) < extent:
            return edges
        extent = last - first
        _refine(running, between, Slicing.of(first, last, slices), first, last)


def _refine(
    running: Running, between: Callable[[int, int], exp.Query], slicing: Slicing, first: int, last: int
) -> None:
    """Cut the slices of a range of time finer."""
    steps = running.steps.copied()
    steps.add("ranged", between(first, last))
    cut = {"origin": slicing.origin, "width": slicing.width}
    steps.fill("finer", "census/slices", cut, {"readings": "ranged"})
    steps.fill("refined", "census/refined", {"first": first, "last": last})
    running.put("refined", steps.query("refined", running.placed))
    running.drop("slices")
    running.drop("edges")
    running.rename({"refined": "slices"})


def _hull(slices: Collection[Row]) -> tuple[int, int]:
    """Return the first and the last instant of slices."""
    starts, ends = zip(*((row["first_time"], row["last_time"]) for row in slices), strict=True)
    return min(starts), max(ends)
