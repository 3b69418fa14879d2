"""Calibration: when each channel is known to be healthy, and which channels learn together.

This module owns the rules a user can give and their arithmetic on closed intervals. It knows no SQL.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from gam_db.clock import FAR_AHEAD, LONG_AGO, Instant, Length, TimeKind, instant, length
from gam_db.errors import CalibrationError, ParameterError

Interval = tuple[int, int]


@dataclass(frozen=True)
class Calibration:
    """Which part of each channel is calibration (method, section 4).

    One of ``fraction``, ``duration`` and ``intervals``; with none of them, ``fraction=0.2``.

    Attributes:
        fraction: the first floor(fraction * n) samples, missing ones counted; above 0, at most 1.
        duration: from the first sample on, this long (closed); counter steps, or seconds, a timedelta
            or a text such as "30 d" where the source has timestamps.
        intervals: closed intervals (from, to), integers of the counter, or datetimes, dates or ISO
            8601 texts; an empty list means no calibration of its own, for a member of a pool.
        exclude: closed intervals taken out of the above; the end of calibration stays.
        score_from: first instant to be scored; default: after the end of calibration.
        overrides: asset pattern -> Calibration, or None for no calibration of its own; the first
            pattern that matches replaces the general rule as a whole.
        pool: channels that share one support: "channel" pools the channels of the same name of all
            assets; a sequence of sequences of asset patterns pools within each group. Only channels
            with the same parameters are pooled.

    Raises:
        CalibrationError: the rule contradicts itself.
    """

    fraction: float | None = None
    duration: Length | None = None
    intervals: Sequence[tuple[Instant, Instant]] | None = None
    exclude: Sequence[tuple[Instant, Instant]] = ()
    score_from: Instant | None = None
    overrides: Mapping[str, "Calibration | None"] = field(default_factory=dict)
    pool: str | Sequence[Sequence[str]] | None = None

    def __post_init__(self) -> None:
        given = [
            name for name in ("fraction", "duration", "intervals") if getattr(self, name) is not None
        ]
        if not given:
            object.__setattr__(self, "fraction", 0.2)
        elif len(given) > 1:
            raise CalibrationError(
                f"Calibration takes one of fraction, duration, intervals, not {' and '.join(given)}."
            )
        if self.fraction is not None and (
            isinstance(self.fraction, bool)
            or not isinstance(self.fraction, (int, float))
            or not 0 < self.fraction <= 1
        ):
            raise CalibrationError(
                f"The calibration fraction is {self.fraction!r}; it must be above 0 and at most 1."
            )
        for name in ("intervals", "exclude"):
            pairs = getattr(self, name)
            if pairs is None and name == "intervals":
                continue
            if not isinstance(pairs, Iterable):
                raise CalibrationError(f"{name} is {pairs!r}; it takes a list of pairs (from, to).")
            object.__setattr__(self, name, tuple(_pair(name, pair) for pair in pairs))
        if not isinstance(self.overrides, Mapping):
            raise CalibrationError(
                f"overrides is a {type(self.overrides).__name__}; it takes a mapping from asset "
                "patterns to gam_db.Calibration or None."
            )
        for pattern, rule in self.overrides.items():
            if not isinstance(pattern, str):
                raise CalibrationError(
                    f"overrides has the key {pattern!r}; it takes asset patterns, as text."
                )
            if rule is not None and not isinstance(rule, Calibration):
                raise CalibrationError(
                    f"The calibration of {pattern!r} must be a gam_db.Calibration or None."
                )
            if rule is not None and (rule.overrides or rule.pool is not None):
                raise CalibrationError(
                    f"The calibration of {pattern!r} has overrides or a pool of its own; "
                    "only the general one may."
                )
        if self.pool is not None and self.pool != "channel":
            object.__setattr__(self, "pool", _groups(self.pool))

    @property
    def pools(self) -> tuple[tuple[str, ...], ...]:
        """The groups of asset patterns that pool their channels of the same name."""
        if self.pool is None:
            return ()
        if isinstance(self.pool, str):
            return (("*",),)
        return tuple(tuple(group) for group in self.pool)


@dataclass(frozen=True)
class Rule:
    """A calibration rule in integers: what the steps rules and declared are filled with.

    Attributes:
        fraction, duration, declared_end: at most one is not None; none: no calibration of its own.
        score_from: first instant to be scored, where given.
        allowed: disjoint closed intervals, ascending, exclusions taken out.
    """

    fraction: float | None = None
    duration: int | None = None
    declared_end: int | None = None
    score_from: int | None = None
    allowed: tuple[Interval, ...] = ()


def resolve(calibration: Calibration, kind: TimeKind) -> list[Rule]:
    """Return the rules in integers: the general one, then one per override, in order.

    Raises:
        CalibrationError: an instant or a length does not fit the way the source tells time, or an
            interval ends before it begins.
    """
    try:
        return [
            _resolve_one(calibration, kind),
            *(
                Rule() if rule is None else _resolve_one(rule, kind)
                for rule in calibration.overrides.values()
            ),
        ]
    except ParameterError as error:
        raise CalibrationError(str(error)) from error


def _resolve_one(calibration: Calibration, kind: TimeKind) -> Rule:
    score_from = (
        None if calibration.score_from is None else instant(calibration.score_from, kind, "score_from")
    )
    excluded = _closed("exclude", calibration.exclude, kind)
    if calibration.intervals is None:
        allowed = subtract([(LONG_AGO, FAR_AHEAD)], excluded)
        if calibration.fraction is not None:
            return Rule(float(calibration.fraction), None, None, score_from, tuple(allowed))
        lasting = length(calibration.duration, kind, "The calibration duration")
        return Rule(None, lasting, None, score_from, tuple(allowed))
    declared = _closed("intervals", calibration.intervals, kind)
    return Rule(
        declared_end=max((end for _, end in declared), default=None),
        score_from=score_from,
        allowed=tuple(subtract(merge(declared), excluded)),
    )


def merge(intervals: Sequence[Interval]) -> list[Interval]:
    """Return the same instants as disjoint ascending closed intervals; neighbours are joined."""
    joined: list[Interval] = []
    for start, end in sorted(intervals):
        if joined and start <= joined[-1][1] + 1:
            joined[-1] = (joined[-1][0], max(joined[-1][1], end))
        else:
            joined.append((start, end))
    return joined


def subtract(intervals: Sequence[Interval], excluded: Sequence[Interval]) -> list[Interval]:
    """Return what is left of disjoint closed intervals of integers without the excluded ones."""
    left = list(intervals)
    for cut_from, cut_to in merge(excluded):
        left = [
            piece
            for start, end in left
            for piece in ((start, min(end, cut_from - 1)), (max(start, cut_to + 1), end))
            if piece[0] <= piece[1]
        ]
    return left


def _closed(name: str, intervals: Sequence[tuple[Instant, Instant]], kind: TimeKind) -> list[Interval]:
    closed = []
    for number, (start, end) in enumerate(intervals, start=1):
        pair = (
            instant(start, kind, f"The start of {name} {number}"),
            instant(end, kind, f"The end of {name} {number}"),
        )
        if pair[0] > pair[1]:
            raise CalibrationError(f"{name} {number} ends ({end!r}) before it begins ({start!r}).")
        closed.append(pair)
    return closed


def _groups(pool: object) -> tuple[tuple[str, ...], ...]:
    refusal = CalibrationError(
        f"pool is {pool!r}; it takes 'channel' or groups of asset patterns, such as [['a*', 'b*']]."
    )
    if isinstance(pool, str) or not isinstance(pool, Iterable):
        raise refusal
    groups = []
    for group in pool:
        patterns = [group] if isinstance(group, str) or not isinstance(group, Iterable) else list(group)
        if not all(isinstance(pattern, str) for pattern in patterns):
            raise refusal
        groups.append(tuple(patterns))
    return tuple(groups)


def _pair(name: str, pair: Sequence[Instant]) -> tuple[Instant, Instant]:
    if isinstance(pair, str) or not isinstance(pair, Sequence) or len(pair) != 2:
        raise CalibrationError(f"{name} takes pairs (from, to), not {pair!r}.")
    return (pair[0], pair[1])
