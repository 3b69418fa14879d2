"""Scoring channels that take turns in the order in which rows are stored: nothing is copied or sorted.

This module owns when that is done in a run, and what proves it: the marks of the vectors, as in the
exact form (:mod:`gam_db.study.rounds`), and once all are made rows are counted again. What does not hold
costs time, never a number.
"""

from collections.abc import Sequence
from functools import partial

from sqlglot import exp

from gam_db.columns import counts, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.adding import OfSet, add
from gam_db.method.bits import Bits
from gam_db.method.census import Slicing, add_trusted_novelty
from gam_db.method.delays import COMPLETE, Ways, add_delays
from gam_db.method.scoring import add_placed
from gam_db.stored.planning.reading import Reader
from gam_db.stored.planning.steps import ENDS, reading_steps
from gam_db.study.rounds import SCALE, Range, Rounds, seem_to_be
from gam_db.study.running import Running


def is_given(
    running: Running,
    reader: Reader,
    assets: Sequence[str] | None,
    group: Sequence[Row],
    method: Method,
    bits: Bits,
) -> bool:
    """Give *seen*, *visited* and *identified* of channels that take turns; tell whether they serve.

    Arguments as for :func:`gam_db.stored.scoring.ordered.is_given`; the method is that of all channels.
    """
    starts, stops = ({row[name] for row in group} for name in ("read_from", "read_until"))
    if len(stops) > 1 or min(stops) < max(starts):
        return False
    edges, between = (min(starts), max(stops)), partial(reader.readings, assets)
    steps = _steps(between(*edges), len(group), method, Slicing.of(*edges), bits)
    if not seem_to_be(Running(running.session, steps), len(group), method.settings):
        return False
    running.keep("support_bits")
    # The newest rows, which are summed up, are copied first: where one is replaced meanwhile, the next
    # run finds another sum.
    since = max(edges[0], edges[1] - 2 * max(row["late_by"] for row in group))
    newest = reading_steps(between(since))
    running.put("identified", newest.query("identified", running.placed))
    seen: list[Row] = []
    if since == edges[0]:  # that is all of them
        running.keep("seen")
        seen = running.rows("seen")
    given, running.steps = running.steps, steps
    try:
        if not seen:
            running.keep("slices")
            seen = _seen(running.rows("slices"))
            running.load("seen", table_of(seen, _SEEN))
        if _are_whole(seen, len(group), method.settings[0].span):
            running.load("scale", table_of([{**row, "complete": 1} for row in group], SCALE))
            read = Range("readings", *edges, 0, seen[0]["rows_read"])
            Rounds(running, between).keep("visited", "rounds", "scale", method.settings[0], read)
            expected = sum(row["rows_read"] for row in seen)
            steps.fill("size", "census/size", {"most": expected + 1})
            (size,) = running.session.rows(steps.query("size"))
            if size["readings"] == expected and not running.largest("visited", "doubled"):
                return True
    finally:
        running.steps = given
    running.forget(but=("cohort", "recount", "support_bits"))
    return False


def _steps(rows: exp.Query, channels: int, method: Method, slicing: Slicing, bits: Bits) -> Pipeline:
    """Return the steps to *visited* of channels that take turns in the order in which rows are stored.

    Given by the caller are *cohort*, *support_bits*, and *scale*: what rounds/rounds.sql asks of each.
    Times are cut for *slices*: what is read of each channel.
    """
    steps = Pipeline(small=frozenset(("turns", "slices", "rounds")))
    steps.add("readings", rows, template.load("source/readings").comment)
    add(steps, "rounds/turns", {"round": channels})
    slots = {"origin": slicing.origin, "width": slicing.width}
    add(steps, "rounds/seen", slots, name="slices")
    one = OfSet(steps, method, 0)
    one.add("rounds/rounds", {"before": 0, "after": 0, "sharp": 0})
    add_delays(one, COMPLETE, Ways(round=channels), "readings", has_bits=True)
    add_trusted_novelty(one, bits)
    add_placed(one, [f"{COMPLETE}novelty"], ENDS, trusting=True)
    return steps


def _seen(slices: Sequence[Row]) -> list[Row]:
    """Return what is read of each channel, of what is read of it slice by slice."""
    seen: dict[int, Row] = {}
    for row in slices:
        nothing = {"rows_read": 0, "context_rows": 0, "missing_samples": 0, "read_to": row["latest"]}
        one = seen.setdefault(row["channel_id"], {"channel_id": row["channel_id"], **nothing})
        one["rows_read"] += row["readings"]
        one["context_rows"] += row["context_rows"]
        one["missing_samples"] += row["missing_samples"]
        one["read_to"] = max(one["read_to"], row["latest"])
    return list(seen.values())


def _are_whole(seen: Sequence[Row], channels: int, span: int) -> bool:
    """Tell whether all channels have as many rows, and each vector's number follows from its round."""
    alike = len(seen) == channels and len({(row["rows_read"], row["read_to"]) for row in seen}) == 1
    return alike and all(row["missing_samples"] == 0 and row["context_rows"] <= span for row in seen)


_SEEN = counts("channel_id rows_read context_rows missing_samples read_to")
