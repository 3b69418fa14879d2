"""Scoring channels whose rows come in order of time, in that order: nothing is copied, sorted or joined.

This module owns when that is done in a run, and what proves it: each vector is marked that is not later
than the one before (*doubled*), as in the exact form (:mod:`gam_db.study.streaming`), and once all are
made each channel is counted again. What does not hold costs time, never a number.
"""

from collections.abc import Sequence

from sqlglot import exp

from gam_db.composing.pipeline import Pipeline, filled
from gam_db.method.adding import add
from gam_db.method.bits import Bits
from gam_db.settings.parameters import Parameters
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import Reader
from gam_db.stored.planning.steps import ENDS, reading_steps
from gam_db.study import streaming
from gam_db.study.running import Running


def is_given(
    running: Running,
    reader: Reader,
    assets: Sequence[str] | None,
    group: Sequence[Row],
    setting: Parameters,
    bits: Bits,
) -> bool:
    """Give *seen*, *visited* and *identified* of channels as they are stored; tell whether they serve.

    Args:
        running: the steps of a run that trusts that no instant occurs twice, with its *cohort*.
        reader: of the source.
        assets: those of the channels, where not all are read.
        group: rows of the plan, with ``read_until``: nothing newer is read.
        setting: that of all channels.
        bits: how supports are kept.
    """
    session, steps = running.session, Pipeline()
    steps.add("readings", reader.readings(assets, min(row["read_from"] for row in group)))
    steps.add("glance", filled("streams/glance", {"rows": streaming.GLANCE, "skip": 0}))
    if len(group) > streaming.MOST_CHANNELS or len(session.rows(steps.query("glance"))) > 2:
        return False
    threads = session.threads()
    steps.add("seen", streaming.stacked([_seen(row) for row in group], threads))
    running.put("seen", steps.query("seen"))
    found = {row["channel_id"]: row for row in running.rows("seen")}
    there = [
        {**row, "read_until": found[row["channel_id"]]["read_to"]}
        for row in group
        if row["channel_id"] in found
    ]
    if _are_whole(list(found.values()), setting.span):
        add(steps, "stored/scoring/bounds")
        compared = [streaming.of_channel("exact", row, **_range(row)) for row in there]
        steps.add("exact", streaming.stacked(compared, threads))
        exact = session.rows(steps.query("exact", running.placed))
        running.keep("support_bits")
        vectors = [
            streaming.scored(row, setting, bits, _range(row), row["read_from"], row["read_until"], ENDS)
            for row in there
        ]
        steps.add("visited", streaming.stacked(vectors, threads))
        running.put("visited", steps.query("visited", running.placed))
        # The newest rows, which are summed up, are copied before all are counted again.
        since = min(max(row["read_from"], row["read_until"] - 2 * row["late_by"]) for row in there)
        newest = reading_steps(reader.readings(assets, since))
        running.put("identified", newest.query("identified", running.placed))
        steps.add("again", streaming.stacked([_seen(row) for row in there], threads))
        again = {row["channel_id"]: row for row in session.rows(steps.query("again"))}
        if all(row["is_exact"] for row in exact) and again == found:
            return True
    running.forget(but=("cohort", "recount", "support_bits"))
    return False


def _seen(row: Row) -> exp.Query:
    """Return what is read of a channel, in numbers."""
    range_of: streaming.Slots = {
        "time_from": row["read_from"],
        "time_to": row["read_until"],
        "first_scored": row["first_scored"],
    }
    return streaming.of_channel("seen", row, **range_of)


def _range(row: Row) -> dict[str, float]:
    return {"lo": row["lo"], "hi": row["hi"]}


def _are_whole(seen: Sequence[Row], span: int) -> bool:
    """Tell whether channels have rows enough, and each vector's number follows from its place."""
    rows = sum(row["rows_read"] for row in seen)
    return rows >= max(streaming.STREAMED_FROM * len(seen), 1) and all(
        row["missing_samples"] == 0 and row["context_rows"] <= span for row in seen
    )
