"""Scoring channels whose rows come in order of time, in that order: nothing is copied, sorted or joined.

This module owns when that is done in a run, and what proves it: each vector is marked that is not later
than the one before (*doubled*), as in the exact form (:mod:`gam_db.study.streaming`), and once all are
made each channel is counted again. What does not hold costs time, never a number.
"""

from collections.abc import Sequence
from functools import partial

from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.method.bits import Bits
from gam_db.method.vectors import Stream
from gam_db.settings.parameters import Parameters
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import Reader
from gam_db.stored.planning.steps import ENDS
from gam_db.study import naming
from gam_db.study.running import Running
from gam_db.study.streamed import Own, of_channel, of_each, own, scored

_LABEL = ("channel_id",)


def is_given(
    running: Running,
    reader: Reader,
    assets: Sequence[str] | None,
    group: Sequence[Row],
    setting: Parameters,
    bits: Bits,
    gap: int | None,
) -> bool:
    """Give *seen* and *visited* of channels as they are stored; tell whether they serve.

    Args:
        running: the steps of a run that trusts that no instant occurs twice, with its *cohort*.
        reader: of the source.
        assets: those of the channels, where not all are read.
        group: rows of the plan, with ``read_until``: nothing newer is read.
        setting: that of all channels.
        bits: how supports are kept.
        gap: the longest step inside a segment of them; None where no segment ends.
    """
    session, steps = running.session, Pipeline()
    steps.add("readings", reader.readings(assets, min(row["read_from"] for row in group)))
    stored = Running(session, steps)
    if len(group) > naming.MOST_CHANNELS or not naming.seems_apart(stored):
        return False
    seen, read = partial(of_channel, "seen"), [_read(row) for row in group]
    running.put("seen", of_each(stored, "seen", seen, read, labels=_LABEL))
    found = {row["channel_id"]: row for row in running.rows("seen")}
    there = [
        {**row, "read_until": found[row["channel_id"]]["read_to"]}
        for row in group
        if row["channel_id"] in found
    ]
    rows_read = sum(row["rows_read"] for row in found.values())
    if rows_read >= max(naming.STREAMED_FROM * len(found), 1):
        add(steps, "stored/scoring/bounds")
        exact = partial(of_channel, "exact")
        compared = [own(row, lo=row["lo"], hi=row["hi"]) for row in there]
        stored.placed = running.placed
        exactly = session.rows(of_each(stored, "exact", exact, compared))
        running.keep("support_bits")
        vectors = [
            own(
                row,
                **{name: row[name] for name in ("lo", "hi", "support_id")},
                time_from=row["read_from"],
                time_to=row["read_until"],
                first_scored=row["first_scored"],
            )
            for row in there
        ]
        # More rows before those that are scored than a vector takes: as where samples are missing.
        has_more = any(row["context_rows"] > setting.span for row in found.values())
        lacks = has_more or any(row["missing_samples"] for row in found.values())
        make = partial(scored, setting=setting, bits=bits, stream=Stream(lacks, gap), ends=ENDS)
        running.put("visited", of_each(stored, "visited", make, vectors))
        read = [_read(row) for row in there]
        rows = session.rows(of_each(stored, "seen", seen, read, labels=_LABEL))
        again = {row["channel_id"]: row for row in rows}
        if all(row["is_exact"] for row in exactly) and again == found:
            return True
    running.forget(but=("cohort", "recount", "support_bits"))
    return False


def _read(row: Row) -> Own:
    """Return the slots of a channel and of what is read of it."""
    return own(
        row, time_from=row["read_from"], time_to=row["read_until"], first_scored=row["first_scored"]
    )
