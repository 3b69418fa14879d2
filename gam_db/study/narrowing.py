"""Narrowing: the ranges of channels that are read as they are stored, round by round.

This module owns which channels are counted in a round (:mod:`gam_db.method.ranges` has the steps).
"""

from collections.abc import Callable, Mapping
from functools import partial

from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.ranges import ROUNDS, counts_of, is_robust, piece
from gam_db.study.running import Running
from gam_db.study.streamed import channel_slots, of_channel


def narrow(
    method: Method,
    running: Running,
    number: int,
    pieces: Mapping[int, Row],
    give: Callable[..., None],
) -> None:
    """Give the counts of calibration samples of one set in pieces of its ranges, as far as rounds go.

    Pieces are the interval of each channel that has one; ``give`` is that of the streams.
    """
    if not is_robust(method.settings[number]):
        return
    members = [row for row in running.rows("channels") if row["channel_id"] in pieces]
    for round_no in range(1, ROUNDS + 1):
        before, counts, after = (
            method.named(of, number)
            for of in (f"range_{round_no - 1}", counts_of(round_no), f"range_{round_no}")
        )
        ranges = {row["support_id"]: row for row in running.rows(before)}
        parts = []
        for row in members:
            if (of := ranges.get(row["support_id"])) is not None:
                times = {name: pieces[row["channel_id"]][name] for name in ("time_from", "time_to")}
                left = {name: of[name] for name in ("support_id", "lo", "hi", "allowed")}
                parts.append(channel_slots(row, **times, **left))
        if not parts:
            return
        give(counts, partial(of_channel, "range_counts", piece=piece()), parts, "support_id")
        running.keep(after)
