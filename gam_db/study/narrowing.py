"""Narrowing: of a source that is counted by slices of time, how little is read sample by sample.

This module owns the range of time in which the edges lie, and that slices are cut finer where these hold
too much.
"""

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.engines.session import Row
from gam_db.method.census import EDGES, Slicing, slices_for
from gam_db.study.running import Between, Running

#: Slices that hold so many times what they would of evenly spaced samples are cut finer: that is a pass
#: over their rows, where to read them is a sort.
SKEWED = 4


def narrow(running: Running, between: Between) -> None:
    """Let the readings of the edges be those between their first and their last instant.

    Slices are cut finer as long as that halves the range of those that hold too much, as where one row
    of long ago lets all others lie in one slice. Nothing is to be done where the steps keep samples in
    order.
    """
    steps = running.steps
    if EDGES not in steps.steps:
        return
    readings = [row["readings"] for row in running.rows("channels")]
    slices = slices_for(sum(readings), max(len(readings), 1))
    extent: int | None = None
    while (edge := _asked(running, "edge_range"))["samples"] is not None:
        first, last = edge["first_time"], edge["last_time"]
        steps.replace(EDGES, between(first, last))
        if edge["samples"] * slices <= SKEWED * edge["readings"]:
            return
        if extent is None:
            extent = _length(_asked(running, "met_range", first=LONG_AGO, last=FAR_AHEAD))
        # Slices of other channels begin and end elsewhere.
        met = _asked(running, "met_range", first=first, last=last)
        if not 0 < 2 * _length(met) < extent:
            return
        extent = _length(met)
        _refine(running, met["first_time"], met["last_time"], slices, between)


def _length(range_: Row) -> int:
    length: int = range_["last_time"] - range_["first_time"]
    return length


def _asked(running: Running, what: str, **range_: int) -> Row:
    """Return the only row of a file that reads the edges."""
    running.keep("edges")
    (row,) = running.asked(f"census/{what}", range_)
    return row


def _refine(running: Running, first: int, last: int, slices: int, between: Between) -> None:
    """Cut the slices of a range of time into so many."""
    steps, slicing = running.steps.copied(), Slicing.of(first, last, slices)
    steps.add("ranged", between(first, last))
    cut = {"origin": slicing.origin, "width": slicing.width}
    steps.fill("finer", "census/slices", cut, {"readings": "ranged"})
    steps.fill("refined", "census/refined", {"first": first, "last": last})
    running.put("refined", steps.query("refined", running.placed))
    running.drop("slices")
    running.drop("edges")
    running.rename({"refined": "slices"})
