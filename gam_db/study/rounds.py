"""Rounds: channels that take turns in the order in which rows are stored, so that no vector is sorted.

This module owns the guess that they do, and how a range of time is cut into pieces, which an engine
works on side by side: what has no order but that of its rows it takes one after another. That the guess
was right shows by the marks of the vectors (``sql/rounds/vectors.sql``).
"""

from collections.abc import Sequence
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

from gam_db.columns import COUNT, SHARE, WORD, columns
from gam_db.composing import template
from gam_db.engines.session import Row
from gam_db.settings.parameters import Parameters
from gam_db.study.naming import GLANCE
from gam_db.study.running import Between, Running
from gam_db.study.streamed import stacked

#: Rows that DuckDB looks back without a sort: fewer than these. Beyond, it puts all of them in order.
FARTHEST = 2048

#: Rows from which on a piece is worth a part of a statement of its own.
PIECE = 500_000

#: Passes over all rows that cost no more than a sort: one for each set of parameters, and one more for
#: each where samples are missing.
MOST_PASSES = 3

#: What rounds/rounds.sql asks of each channel.
SCALE = columns(
    (COUNT, "channel_id support_id read_from complete taught_from taught_to"),
    (WORD, "asset channel"),
    (SHARE, "lo hi"),
)


def seem_to_be(
    running: Running, channels: int, settings: Sequence[Parameters], has_missing: bool = False
) -> bool:
    """Tell whether so many channels seem to take turns, each once in every round, and that is of use."""
    reach = max(1, *(setting.span for setting in settings))
    passes = len(settings) * (1 + has_missing)
    if not running.session.engine.in_rounds or passes > MOST_PASSES or channels * reach >= FARTHEST:
        return False
    (glanced,) = running.asked("rounds/glance", {"rows": GLANCE, "round": channels})
    return bool(glanced["misplaced"] == 0 and glanced["channels"] == channels)


class Range(NamedTuple):
    """The samples that vectors of one set are made of, which are the same of each of its channels.

    Attributes:
        rows: the step of their readings.
        earliest, latest: the instants that are read.
        skipped: samples of a channel that come before.
        samples: how many they are.
    """

    rows: str
    earliest: int
    latest: int
    skipped: int
    samples: int


class _Piece(NamedTuple):
    """A part of a range: how many of its rounds come before what is read, and before what is asked."""

    before: int
    after: int
    earliest: int
    latest: int


class Rounds:
    """The rounds of a study in which channels :func:`seem_to_be` at turns.

    Its steps are those by rounds, with *slices* of the readings.
    """

    def __init__(self, running: Running, between: Between) -> None:
        self.running, self._between = running, between
        running.keep("turns")
        turns = sorted(running.rows("turns"), key=lambda row: int(row["place"]))
        self._round, first = len(turns), turns[0]
        # Where the channels of a round have one instant, it begins and ends with that. Of all other
        # rounds the vectors prove it; those of a piece also of the last round before it.
        self._are_sharp = len({row["time"] for row in turns}) == 1
        self._named = {name: first[name] for name in ("asset", "channel")}

    @cached_property
    def _slices(self) -> list[Row]:
        """The slices of one channel, in order; asked for where there is something to cut."""
        slices = (row for row in self.running.rows("slices") if row["earliest"] is not None)
        same = (row for row in slices if all(row[name] == of for name, of in self._named.items()))
        return sorted(same, key=lambda row: int(row["earliest"]))

    def keep(self, step: str, listed: str, scale: str, setting: Parameters, read: Range) -> None:
        """Keep a step of one set that is made of vectors; in pieces side by side, if that is worth it.

        ``listed`` and ``scale`` are what the steps *rounds* and *scale* of the set are called.
        """
        running, session = self.running, self.running.session
        running.prepare(step)
        threads = session.threads()
        pieces = self._cut(read, setting, min(threads, read.samples * self._round // PIECE))
        if len(pieces) < 2:
            running.keep(step)
            return
        queries, kept = [], []
        for piece in pieces:
            steps = running.steps.copied()
            slots = {"before": piece.before, "after": piece.after, "sharp": 1}
            steps.fill("piece", "rounds/rounds", slots, {"scale": scale})
            kept.append(session.keep("piece", steps.query("piece", running.placed)))
            steps.replace(read.rows, self._between(piece.earliest, piece.latest))
            queries.append(steps.query(step, {**running.placed, listed: kept[-1]}).copy())
        running.put(step, stacked(queries, threads))
        for table in kept:
            session.forget(table)

    def _cut(self, read: Range, setting: Parameters, number: int) -> list[_Piece]:
        """Return the pieces of a range, up to a number; each ends with a bucket."""
        span, stride = setting.span, setting.bucket_length
        buckets = max(read.samples - span, 0) // stride
        ends = sorted({buckets * one // number * stride for one in range(1, number)} - {0})
        if not (self._are_sharp and ends):
            return []
        context = max(span, 1)  # a piece reads the last round of the one before, whole
        edges = [self._edge(read, end + span, context) for end in ends]
        starts = [
            (0, 0, read.earliest),
            *(
                (end + span - context, end + span, start)
                for end, (start, _) in zip(ends, edges, strict=True)
            ),
        ]
        stops = [*(stop for _, stop in edges), read.latest]
        return [_Piece(*start, stop) for start, stop in zip(starts, stops, strict=True)]

    def _edge(self, read: Range, end: int, samples: int) -> tuple[int, int]:
        """Return the first and last instant of so many samples of a channel, up to a number of them."""
        skipped = read.skipped + end - samples
        counts = [row["readings"] for row in self._slices]
        known = list(zip(self._slices, accumulate(counts, initial=0), strict=False))
        reached = [(one, before) for one, before in known if before < skipped + samples]
        (first, before) = [(one, before) for one, before in reached if before <= skipped][-1]
        steps = self.running.steps.copied()
        steps.replace("readings", self._between(first["earliest"], reached[-1][0]["latest"]))
        names = {name: template.text(of) for name, of in self._named.items()}
        slots = {**names, "skipped": skipped - before, "samples": samples}
        (found,) = Running(self.running.session, steps).asked("rounds/instants", slots)
        return found["earliest"], found["latest"]
