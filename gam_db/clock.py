"""Time as integers: instants and lengths of users, in microseconds (UTC) or counter steps.

This module owns the conversion of numbers, dates and texts to time. It contains no SQL.
"""

import datetime as dt
import math
import operator
import re
import zoneinfo
from enum import Enum
from fractions import Fraction
from typing import SupportsIndex, TypeAlias, cast

from gam_db.errors import ParameterError, wrong

Instant: TypeAlias = int | str | dt.datetime | dt.date
Length: TypeAlias = int | float | str | dt.timedelta

LONG_AGO = -(2**62)
FAR_AHEAD = 2**62
SECOND = 1_000_000
#: A step of a counter of more than so many usual steps is a jump.
JUMP = 1_000

_EPOCH = dt.datetime(1970, 1, 1, tzinfo=dt.UTC)
_MICROSECOND = dt.timedelta(microseconds=1)
#: Units of a length, in microseconds.
UNITS = {
    "us": 1,
    "ms": 1_000,
    "s": SECOND,
    "min": 60 * SECOND,
    "h": 3_600 * SECOND,
    "d": 86_400 * SECOND,
    "w": 604_800 * SECOND,
}
_YEAR = 31_557_600 * SECOND
_LONG = 2 * _YEAR
#: A unit of numbers since 1970 -> its name, and how many of it are a second.
SINCE_1970 = {
    "s": ("seconds", 1),
    "ms": ("milliseconds", 10**3),
    "us": ("microseconds", 10**6),
    "ns": ("nanoseconds", 10**9),
}
_1990, _2100 = 631_152_000, 4_102_444_800
"""In seconds since 1970; a counter within these bounds is almost certainly a time."""
_WHOLE = re.compile(r"-?[0-9]{1,30}")
_LENGTH = re.compile(r"([0-9]{1,30}(?:\.[0-9]{0,30})?)\s*(us|ms|s|min|h|d|w)")


class TimeKind(Enum):
    """The kinds of time of a source."""

    COUNTER = "counter"
    TIMESTAMP = "timestamp"
    TIMESTAMP_WITH_ZONE = "timestamp with time zone"
    NANOSECONDS = "timestamp in nanoseconds"
    NANOSECONDS_WITH_ZONE = "timestamp in nanoseconds with time zone"

    @property
    def is_counter(self) -> bool:
        """Whether it is an integer counter, not a calendar time."""
        return self is TimeKind.COUNTER

    @property
    def has_zone(self) -> bool:
        """Whether its timestamps have a zone (UTC)."""
        return self in (TimeKind.TIMESTAMP_WITH_ZONE, TimeKind.NANOSECONDS_WITH_ZONE)

    @property
    def furthest(self) -> int:
        """The largest distance from 0, on either side: 64 bits of nanoseconds are 292 years."""
        in_nanoseconds = self in (TimeKind.NANOSECONDS, TimeKind.NANOSECONDS_WITH_ZONE)
        return 2**63 // 1000 if in_nanoseconds else FAR_AHEAD


def instant(value: object, kind: TimeKind, what: str) -> int:
    """Return an instant as an integer: a counter value, or microseconds since 1970 (UTC).

    It is an integer for a counter; a datetime (without zone: UTC), a date, a numpy.datetime64 or an ISO
    8601 text for timestamps. An error calls it *what*.

    Raises:
        ParameterError: the value cannot be an instant of that kind.
    """
    value = _plain(value)
    if kind.is_counter:
        if (whole := _whole(value)) is not None:
            return _bounded(whole, what)
        raise wrong("instant_on_a_counter", what=what, value=value)
    if isinstance(value, str):
        try:
            value = dt.datetime.fromisoformat(value.strip())
        except ValueError:
            raise wrong("no_time", what=what, value=value) from None
    if isinstance(value, dt.date):
        if not isinstance(value, dt.datetime):
            value = dt.datetime(value.year, value.month, value.day)
        return (aware(value) - _EPOCH) // _MICROSECOND
    raise wrong("instant_on_a_calendar", what=what, value=value)


def aware(time: dt.datetime) -> dt.datetime:
    """Return a time with its zone; UTC if it has none."""
    return time if time.tzinfo is not None else time.replace(tzinfo=dt.UTC)


def shown_instant(tick: int, kind: TimeKind) -> str:
    """Return integer time as :func:`instant` takes it: a counter value, or an ISO 8601 text (UTC)."""
    if kind.is_counter:
        return str(tick)
    try:
        return (_EPOCH.replace(tzinfo=None) + tick * _MICROSECOND).isoformat()
    except OverflowError:  # no calendar has the year
        return f"{tick:,} us since 1970"


def time_of(tick: int, kind: TimeKind) -> int | dt.datetime:
    """Return integer time as a counter value, or as a time (UTC)."""
    return tick if kind.is_counter else _EPOCH + tick * _MICROSECOND


def length(value: object, kind: TimeKind, what: str) -> int:
    """Return a length of time as an integer: counter steps, or microseconds.

    It is a number (steps of a counter; seconds where the source has timestamps), a timedelta, or a text
    such as ``"30 d"``, ``"1.5h"``, ``"200ms"``. A fraction of a step is dropped, since an
    integer clock has no such steps. An error calls it *what*.

    Raises:
        ParameterError: the value is not a length of that kind, or is negative.
    """
    value = _plain(value)
    steps: int | None = None
    if kind.is_counter:
        if (whole := _whole(value)) is not None:
            steps = whole
        elif isinstance(value, float) and math.isfinite(value):
            steps = math.floor(value)
        else:
            raise wrong("length_on_a_counter", what=what, value=value)
    elif isinstance(value, dt.timedelta):
        steps = value // _MICROSECOND
    elif isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value):
        # A float counts as it is written: in doubles 2.094 s would be 2093999.9999999998 microseconds.
        exact = Fraction(repr(value)) if isinstance(value, float) else value
        steps = math.floor(exact * SECOND)
    elif isinstance(value, str) and (match := _LENGTH.fullmatch(value.strip())):
        steps = math.floor(Fraction(match[1]) * UNITS[match[2]])
    if steps is None:
        raise wrong("no_length", what=what, value=value)
    if steps < 0:
        raise ParameterError(f"{what} is {value!r}; it must not be negative.")
    return _bounded(steps, what)


def epoch_unit(first: int, last: int) -> str | None:
    """Return the unit in which a counter would be a present-day time; None if none fits."""
    units = (unit for unit, (_, ticks) in SINCE_1970.items() if is_of_our_time(first, last, ticks))
    return next(units, None)


def is_of_our_time(first: int, last: int, ticks: int = SECOND) -> bool:
    """Tell whether instants since 1970, in so many ticks a second, are present-day times."""
    return _1990 * ticks <= first and last <= _2100 * ticks


def shown_length(steps: int, kind: TimeKind) -> str:
    """Return a length of time in words, in its largest unit that is not below 1; years from two on."""
    if kind.is_counter:
        return f"{steps:,} steps"
    if steps >= _LONG:
        return f"{steps / _YEAR:.3g} years"
    for unit in ("d", "h", "min", "s"):
        if steps >= UNITS[unit]:
            return f"{steps / UNITS[unit]:.3g} {unit}"
    return "less than 1 s"


def zone(name: str) -> dt.tzinfo:
    """Return a time zone by its name, or raise a ConfigurationError."""
    if name == "UTC":
        return dt.UTC
    try:
        return zoneinfo.ZoneInfo(name)
    except (ValueError, OSError, zoneinfo.ZoneInfoNotFoundError):
        raise wrong("no_time_zone", name=name) from None


def looks_like_calendar(value: object) -> bool:
    """Tell whether a value given for time can only mean a calendar, not a counter."""
    if isinstance(value, str):
        return not _WHOLE.fullmatch(value.strip())
    return isinstance(value, (dt.date, dt.timedelta)) or (
        type(value).__module__ == "numpy" and (type(value).__name__ in ("datetime64", "timedelta64"))
    )


def _plain(value: object) -> object:
    """Turn NumPy's scalars into Python's; datetime64 beyond microseconds is floored."""
    kind_of = type(value).__name__
    if kind_of in ("datetime64", "timedelta64"):
        return value.astype(f"{kind_of}[us]").item()  # type: ignore[attr-defined]
    if type(value).__module__ == "numpy" and hasattr(value, "item"):
        return cast(object, value.item())
    return value


def _whole(value: object) -> int | None:
    if isinstance(value, bool):
        return None
    if isinstance(value, str):
        digits = value.strip()
        return int(digits) if _WHOLE.fullmatch(digits) else None
    if isinstance(value, float):
        return int(value) if value.is_integer() else None
    try:
        return operator.index(cast(SupportsIndex, value))
    except TypeError:
        return None


def _bounded(value: int, what: str) -> int:
    if not LONG_AGO < value < FAR_AHEAD:
        raise ParameterError(f"{what} is {value}, beyond the range of the clock (2^62).")
    return value
