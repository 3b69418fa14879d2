"""Calibration: when each channel is known to be healthy, and which channels learn together.

This module owns the rules that users can set, and arithmetic on closed intervals. It contains no SQL.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from gam_db.arguments import public
from gam_db.clock import FAR_AHEAD, LONG_AGO, Instant, Length, TimeKind, instant, length
from gam_db.errors import CalibrationError, ParameterError, wrong
from gam_db.settings.setting import (
    INSTANT,
    LENGTH,
    SHARE,
    Kind,
    Setting,
    check,
    declared,
    setting,
    texts,
)

Interval = tuple[int, int]


def _pairs(_: Setting, name: str, pairs: Any) -> tuple[tuple[Instant, Instant], ...]:
    if isinstance(pairs, str) or not isinstance(pairs, Iterable):
        raise wrong("pairs", name=name, pairs=pairs)
    pairs = tuple(pairs)
    for pair in pairs:
        if isinstance(pair, str) or not isinstance(pair, Sequence) or len(pair) != 2:
            raise ParameterError(f"{name} takes pairs (from, to), not {pair!r}.")
    return tuple((start, end) for start, end in pairs)


def _read_pairs(option: str, texts: Sequence[str]) -> list[tuple[str, str]]:
    pairs = []
    for text in texts:
        start, slash, end = (part.strip() for part in text.partition("/"))
        if not (start and slash and end):
            raise wrong("interval_option", option=option, text=text)
        pairs.append((start, end))
    return pairs


def _groups(_: Setting, name: str, pool: Any) -> Any:
    refusal = wrong("pool", name=name, pool=pool)
    if pool == "channel":
        return pool
    if isinstance(pool, str) or not isinstance(pool, Iterable):
        raise refusal
    groups = []
    for group in pool:
        patterns = [group] if isinstance(group, str) or not isinstance(group, Iterable) else list(group)
        if not all(isinstance(pattern, str) for pattern in patterns):
            raise refusal
        groups.append(tuple(patterns))
    return tuple(groups)


def _read_groups(_: str, texts: Sequence[str]) -> Any:
    if list(texts) == ["channel"]:
        return "channel"
    return [[pattern.strip() for pattern in text.split(",")] for text in texts]


def _patterns(_: Setting, name: str, patterns: Any) -> tuple[str, ...]:
    listed = [patterns] if isinstance(patterns, str) else patterns
    if not texts(listed):
        raise wrong("reference", name=name, patterns=patterns)
    return tuple(listed)


INTERVALS = Kind(_pairs, list[str], _read_pairs, "FROM/TO")
POOL = Kind(_groups, list[str], _read_groups, "GROUP")
PATTERNS = Kind(_patterns, list[str], metavar="ASSET")


@public
@declared
@dataclass(frozen=True)
class Calibration:
    """Which part of each channel is calibration (method, section 4).

    One of ``fraction`` (floor(fraction * n) samples, missing ones counted), ``duration`` (closed) and
    ``intervals`` (closed; an empty list means no calibration of its own, for a member of a pool); with
    none of them, ``fraction=0.2``. Instants are integers of the counter, or datetimes, dates or ISO
    8601 texts; lengths may be timedeltas. Only channels with the same parameters are pooled.

    Where ``reference`` or rules of their own name machines of a pool as healthy, its other members teach
    nothing; ``reference="*"`` lets all of them teach.

    Attributes:
        overrides: asset pattern -> Calibration, or None for no calibration of its own; the first
            pattern that matches replaces the general rule as a whole.

    Raises:
        CalibrationError: the rule contradicts itself.
    """

    fraction: float | None = setting(None, SHARE, least=0)
    duration: Length | None = setting(None, LENGTH)
    intervals: Sequence[tuple[Instant, Instant]] | None = setting(None, INTERVALS)
    exclude: Sequence[tuple[Instant, Instant]] = setting((), INTERVALS)
    score_from: Instant | None = setting(None, INSTANT)
    overrides: Mapping[str, "Calibration | None"] = field(default_factory=dict)
    pool: str | Sequence[Sequence[str]] | None = setting(None, POOL)
    reference: str | Sequence[str] = setting((), PATTERNS)

    def __post_init__(self) -> None:
        check(self, CalibrationError)
        ways = [name for name in WAYS if getattr(self, name) is not None]
        if not ways:
            object.__setattr__(self, "fraction", 0.2)
        elif len(ways) > 1:
            raise wrong("several_ways", names=", ".join(WAYS), given=" and ".join(ways))
        if not isinstance(self.overrides, Mapping):
            raise wrong("calibration_overrides", kind=type(self.overrides).__name__)
        for pattern, rule in self.overrides.items():
            if not isinstance(pattern, str):
                raise wrong("calibration_pattern", pattern=pattern)
            if rule is not None and not isinstance(rule, Calibration):
                raise wrong("calibration_of_pattern", pattern=pattern)
            if rule is not None and (rule.overrides or rule.reference or rule.pool is not None):
                raise wrong("calibration_in_calibration", pattern=pattern)
        if self.reference and self.pool is None:
            raise wrong("reference_without_pool", name=", ".join(self.reference))

    @property
    def pools(self) -> tuple[tuple[str, ...], ...]:
        """The groups of asset patterns that pool their channels of the same name."""
        if self.pool is None:
            return ()
        if isinstance(self.pool, str):
            return (("*",),)
        return tuple(tuple(group) for group in self.pool)

    @property
    def teachers(self) -> tuple[str, ...]:
        """The patterns of healthy assets: of overrides with a rule, and of ``reference``."""
        named = [name for name, rule in self.overrides.items() if rule and rule.intervals != ()]
        return (*named, *self.reference)

    @property
    def cases(self) -> tuple[tuple[str, "Calibration | None"], ...]:
        """Asset patterns with the rule of each; the first that matches applies, else the general rule.

        If an override or ``reference`` names some members of a pool, the other members have no rule.
        Existing machines do not matter: with a name that matches none, no other member teaches.
        """
        named = [*self.overrides.items(), *((pattern, self) for pattern in self.reference)]
        cases: dict[str, Calibration | None] = {}
        for pattern, rule in named:
            cases.setdefault(pattern, rule)
        for group in self.pools:
            is_named = any(patterns_meet(teacher, other) for teacher in self.teachers for other in group)
            for pattern in group:
                cases.setdefault(pattern, None if is_named else self)
        ordered = list(cases.items())
        while ordered and ordered[-1][1] is self:
            ordered.pop()
        return tuple(ordered)


#: The ways to say where calibration lies, one of which is taken.
WAYS = ("fraction", "duration", "intervals")


@dataclass(frozen=True)
class Rule:
    """A calibration rule in integers, for the slots of the steps *rules* and *declared*."""

    #: At most one of the first three is not None; none: no calibration of its own.
    fraction: float | None = None
    duration: int | None = None
    declared_end: int | None = None
    score_from: int | None = None  # first instant to score; None for the default
    allowed: tuple[Interval, ...] = ()  # disjoint closed intervals, ascending, exclusions taken out


def resolve(calibration: Calibration, kind: TimeKind) -> list[Rule]:
    """Return the rules in integers: the general one, then one per case of :attr:`Calibration.cases`.

    Raises:
        CalibrationError: an instant or a length does not fit the time of the source, or an interval
            ends before it begins.
    """
    try:
        return [
            _resolve_rule(calibration, kind),
            *(Rule() if rule is None else _resolve_rule(rule, kind) for _, rule in calibration.cases),
        ]
    except ParameterError as error:
        raise CalibrationError(error.options) from error


def _resolve_rule(calibration: Calibration, kind: TimeKind) -> Rule:
    declared = closed("intervals", calibration.intervals or (), kind)
    within = [(LONG_AGO, FAR_AHEAD)] if calibration.intervals is None else merge(declared)
    share, lasting, begins = calibration.fraction, calibration.duration, calibration.score_from
    return Rule(
        fraction=None if share is None else float(share),
        duration=None if lasting is None else length(lasting, kind, "The calibration duration"),
        declared_end=max((end for _, end in declared), default=None),
        score_from=None if begins is None else instant(begins, kind, "score_from"),
        allowed=tuple(subtract(within, closed("exclude", calibration.exclude, kind))),
    )


def patterns_meet(pattern: str, other: str) -> bool:
    """Tell whether there is a name that both patterns match."""
    waiting = [(0, 0)]
    reached = set(waiting)
    while waiting:
        here, there = waiting.pop()
        first, second = pattern[here : here + 1], other[there : there + 1]
        if not first and not second:
            return True
        further: set[tuple[int, int]] = set()
        if "*" in (first, second):  # it ends, or takes one more sign of the other
            further |= {(here + 1, there)} if first else set()
            further |= {(here, there + 1)} if second else set()
        elif first and second and (first == second or "?" in (first, second)):
            further = {(here + 1, there + 1)}
        waiting += further - reached
        reached |= further
    return False


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
    """Return disjoint closed intervals of integers without the excluded ones."""
    left = list(intervals)
    for cut_from, cut_to in merge(excluded):
        left = [
            piece
            for start, end in left
            for piece in ((start, min(end, cut_from - 1)), (max(start, cut_to + 1), end))
            if piece[0] <= piece[1]
        ]
    return left


def closed(name: str, intervals: Sequence[tuple[Instant, Instant]], kind: TimeKind) -> list[Interval]:
    """Return intervals as closed intervals of integers.

    Raises:
        CalibrationError: an interval ends before it begins.
        ParameterError: a start or end is not an instant.
    """
    pairs = []
    for number, (start, end) in enumerate(intervals, start=1):
        pair = (
            instant(start, kind, f"The start of {name} {number}"),
            instant(end, kind, f"The end of {name} {number}"),
        )
        if pair[0] > pair[1]:
            raise CalibrationError(f"{name} {number} ends ({end!r}) before it begins ({start!r}).")
        pairs.append(pair)
    return pairs
