"""Local time: the instants of a source whose times have no zone, by the clock of a time zone.

This module owns the changes of a zone, as integers, and the formulas made of them. They are data in the
SQL: no engine's own time zones and no setting of a session matter.
"""

import datetime as dt
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from typing import TypeAlias

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO, SECOND, zone
from gam_db.composing import template

#: How far apart its offsets are looked at: no zone has changed twice in so few days since 1970.
_STEP = 4 * 86_400
#: The changes of a zone that are written out, in seconds since 1970: what it showed at the first of them
#: counts before, and what it shows at the last of them counts after.
FIRST = 0
LAST = int(dt.datetime(2050, 1, 1, tzinfo=dt.UTC).timestamp())

#: An offset that no zone has: it marks local times that come twice.
TWICE = 10**15
#: Branches of one CASE: more of them are put into CASEs inside it, so that a row passes few.
_BRANCHES = 8

Shift: TypeAlias = int | None


@dataclass(frozen=True)
class Piece:
    """Local times from ``start`` on, up to the next piece; in microseconds.

    ``shift`` is what they are ahead of UTC, None where no clock shows them; ``second`` is the shift of
    the second pass where they come twice, else the same.
    """

    start: int
    shift: Shift
    second: Shift

    @property
    def is_twice(self) -> bool:
        """True where a clock shows these times twice."""
        return self.shift != self.second


@dataclass(frozen=True)
class LocalTime:
    """The clock of a time zone.

    Attributes:
        name: of the zone, such as Europe/Berlin.
        spans: (first instant, what its clock is ahead of UTC from there on), in microseconds, in order.
    """

    name: str
    spans: tuple[tuple[int, int], ...]

    def earliest(self, instant: int) -> int:
        """Return the earliest local time that is shown at or after an instant."""
        return (
            instant
            if instant <= LONG_AGO
            else min(begin + shift for begin, _, shift in self._from(instant))
        )

    def latest(self, instant: int) -> int:
        """Return the latest local time that is shown at or before an instant."""
        if instant >= FAR_AHEAD:
            return instant
        ended = ((begin, min(end, instant), shift) for begin, end, shift in self._edged())
        return max(end + shift for begin, end, shift in ended if begin <= instant)

    @cached_property
    def every_piece(self) -> list[Piece]:
        """The pieces of all local time, in order; the first one reaches back to the first time."""
        shown = [(begin + shift, end + shift, shift) for begin, end, shift in self._edged()]
        starts = {first for first, _, _ in shown} | {last + 1 for _, last, _ in shown[:-1]}
        pieces: list[Piece] = []
        for start in sorted(starts):
            there = [shift for first, last, shift in shown if first <= start <= last]
            shifts: Sequence[Shift] = there or (None,)
            piece = Piece(start, shifts[0], shifts[-1])
            if not pieces or (pieces[-1].shift, pieces[-1].second) != (piece.shift, piece.second):
                pieces.append(piece)
        return pieces

    def pieces(self, earliest: int = LONG_AGO, latest: int = FAR_AHEAD) -> list[Piece]:
        """Return the pieces that hold the local times from one to another, both included."""
        return [piece for piece, end in self._ended() if end >= earliest and piece.start <= latest]

    def skipped(self) -> list[tuple[int, int]]:
        """Return the local times that no clock shows: the first and the last one of each range."""
        return [(piece.start, end) for piece, end in self._ended() if piece.shift is None]

    def repeated(self, earliest: int = LONG_AGO, latest: int = FAR_AHEAD) -> list[tuple[int, int]]:
        """Return the local times that come twice, likewise, in ranges that meet that of two times."""
        twice = ((piece.start, end) for piece, end in self._ended() if piece.is_twice)
        return [(first, last) for first, last in twice if last >= earliest and first <= latest]

    @property
    def longest_repeat(self) -> int:
        """How far apart, at most, the two instants of one local time are, in microseconds."""
        twice = (piece for piece in self.every_piece if piece.is_twice)
        return max(((piece.shift or 0) - (piece.second or 0) for piece in twice), default=0)

    def _ended(self) -> list[tuple[Piece, int]]:
        """Return each piece with its last time."""
        ends = [*(piece.start - 1 for piece in self.every_piece[1:]), 2 * FAR_AHEAD]
        return list(zip(self.every_piece, ends, strict=True))

    def _edged(self) -> list[tuple[int, int, int]]:
        """Return first and last instant of each span, with its shift."""
        begins = [LONG_AGO, *(begin for begin, _ in self.spans[1:])]
        ends = [*(begin - 1 for begin in begins[1:]), FAR_AHEAD]
        return [
            (begin, end, shift) for begin, end, (_, shift) in zip(begins, ends, self.spans, strict=True)
        ]

    def _from(self, instant: int) -> list[tuple[int, int, int]]:
        return [
            (max(begin, instant), end, shift) for begin, end, shift in self._edged() if end >= instant
        ]


@cache
def local_time(name: str) -> LocalTime:
    """Return the clock of a time zone, or raise a ConfigurationError."""
    there = zone(name)

    def shift(second: int) -> int:
        ahead = dt.datetime.fromtimestamp(second, there).utcoffset()
        return 0 if ahead is None else ahead // dt.timedelta(microseconds=1)

    spans = [(FIRST * SECOND, shift(FIRST))]
    for day in range(FIRST, LAST, _STEP):
        if shift(day + _STEP) == spans[-1][1]:
            continue
        before, after = day, day + _STEP
        while after - before > 1:
            middle = (before + after) // 2
            before, after = (middle, after) if shift(middle) == spans[-1][1] else (before, middle)
        spans.append((after * SECOND, shift(after)))
    return LocalTime(name, tuple(spans))


def by_time(time: exp.Expr, pieces: Sequence[Piece], shift_of: Callable[[Piece], Shift]) -> exp.Expr:
    """Return the piece that holds a local time, packed as a number of 64 bits."""
    steps: list[tuple[int, Shift]] = []
    for piece in pieces:
        if not steps or steps[-1][1] != shift_of(piece):
            steps.append((piece.start, shift_of(piece)))
    return exp.cast(
        _chosen(time, [(start, template.node_of(value)) for start, value in steps]), "BIGINT"
    )


def _chosen(time: exp.Expr, steps: Sequence[tuple[int, exp.Expr]]) -> exp.Expr:
    """Return the value of the last step that begins at or before a time; the first begins before all."""
    size = 1
    while size * _BRANCHES < len(steps):
        size *= _BRANCHES
    parts = [steps[start : start + size] for start in range(0, len(steps), size)]
    values = [part[0][1] if len(part) == 1 else _chosen(time, part) for part in parts]
    if len(parts) == 1:
        return values[0]
    starts = (part[0][0] for part in parts[1:])
    before: Iterable[exp.Expr] = (
        exp.LT(this=time.copy(), expression=template.node_of(start)) for start in starts
    )
    ifs = [
        exp.If(this=condition, true=value) for condition, value in zip(before, values[:-1], strict=True)
    ]
    return exp.Case(ifs=ifs, default=values[-1])
