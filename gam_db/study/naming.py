"""Naming: the names of a source that seems to be stored channel by channel, counted one by one.

This module owns which methods are served so, the guess which names there are, and its proof: the rows
of all of them are as many as the source has. A wrong guess costs time, never a number.
"""

from collections.abc import Iterable
from functools import partial

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.bits import Bits
from gam_db.study.running import Running
from gam_db.study.streamed import of_channel, of_each

#: Rows that are glanced at to guess whether channels lie one after another.
GLANCE = 10_000

#: Of so many rows one is looked at, a power of two, to guess where which channels lie.
EVERY = 1024

#: Readings of a channel, on the average, from which on a part of a statement for each is worth its time.
STREAMED_FROM = 50_000

#: Channels of one statement.
MOST_CHANNELS = 256

_NAMES = ("asset", "channel")


def seems_ordered(method: Method, running: Running, scores: bool) -> bool:
    """Tell whether channels seem to be stored one after another.

    If so, *names* is there. Where the vectors will not prove the order of all rows, it is proven.
    """
    bits = running.session.engine.bits
    if bits is None or not _is_plain(method, bits):
        return False
    running.prepare("names")
    is_proven = not vectors_prove(method, scores)
    names = counted(running, is_proven)
    if names is None:
        return False
    running.load("names", names)
    return not is_proven or all(names["in_order"].to_pylist())


def vectors_prove(method: Method, scores: bool) -> bool:
    """Tell whether it is known that the study ``scores``, and no row is before calibration."""
    return scores and all(rule.fraction is not None for rule in method.rules)


def _is_plain(method: Method, bits: Bits) -> bool:
    """Tell whether calibration is one interval, and no sample before it matters: what streams serve."""
    whole = ((LONG_AGO, FAR_AHEAD),)
    has_bits = all(bits.serve(setting.radix**setting.m) for setting in method.settings)
    # What stands still where calibration begins is told by the samples before it.
    may_begin_late = all(setting.still_after is None for setting in method.settings)
    are_intervals = (
        tuple(rule.allowed) == whole
        or (may_begin_late and rule.fraction is None and len(rule.allowed) <= 1)
        for rule in method.rules
    )
    return has_bits and method.is_parted and all(are_intervals)


def seems_apart(running: Running) -> bool:
    """Tell whether the first rows of the step *readings* are of two channels at most."""
    return len(running.query_rows("streams/glance", {"rows": GLANCE})) <= 2


def counted(running: Running, is_proven: bool = False) -> pa.Table | None:
    """Return the rows of the step *names*, if the source seems to be stored channel by channel.

    Args:
        running: the steps *readings* and *names*, on an engine that keeps the order of rows.
        is_proven: add *in_order*: 1 for a channel each of whose rows is later than the one before.

    Returns:
        None where channels do not seem to lie apart, or are short; with a proof also where a row has no
        name, or came meanwhile.
    """
    if not seems_apart(running):
        return None
    guessed = running.query_rows("streams/spread", {"every": EVERY, "mask": EVERY - 1})
    if not guessed or not all(row["together"] for row in guessed) or not _are_named(guessed):
        return None
    (rows,) = {row["rows_in_all"] for row in guessed}
    if len(guessed) > MOST_CHANNELS or rows < STREAMED_FROM * len(guessed):
        return None
    counts = _channel_counts(running, guessed, is_proven)
    if _rows(counts) == rows:
        return counts
    counts = running.session.fetch(running.steps.query("names", running.tables))
    if is_proven:
        rows, names = _rows(counts), counts.select(_NAMES).to_pylist()
        if not _are_named(names):
            return None
        counts = _channel_counts(running, names, is_proven)
        return counts if _rows(counts) == rows else None
    return counts


def _channel_counts(running: Running, names: Iterable[Row], is_proven: bool) -> pa.Table:
    """Return the counts of some channels."""
    proof = [exp.alias_(template.fill("streams/in_order"), "in_order")] if is_proven else []
    channels = [{column: template.text(row[column]) for column in _NAMES} for row in names]
    make = partial(of_channel, "names", proof=proof)
    return running.session.fetch(of_each(running, "named", make, channels, labels=_NAMES))


def _are_named(names: Iterable[Row]) -> bool:
    """Tell whether no name is missing: rows without one are counted by a grouping only."""
    return all(row[column] is not None for row in names for column in _NAMES)


def _rows(names: pa.Table) -> int:
    """Return how many rows of the source have been counted."""
    return sum(sum(names[column].to_pylist()) for column in ("readings", "without_time"))
