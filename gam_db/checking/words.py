"""Lengths of time, instants and counts as an engineer reads them, and as settings want them."""

import datetime as dt
from collections.abc import Sequence

from gam_db.clock import SECOND, UNITS, TimeKind

_EPOCH = dt.datetime(1970, 1, 1, tzinfo=dt.UTC)
_ROUND_SECONDS = (60, 120, 300, 600, 900, 1_800, 3_600, 7_200, 21_600, 43_200, 86_400)


def spoken(length: int, kind: TimeKind) -> str:
    """Return a length of time in few digits and the unit that suits it; counter steps as they are."""
    if kind.is_counter:
        return f"{length:,}"
    for name in ("d", "h", "min"):
        if length >= 2 * UNITS[name]:
            count = length / UNITS[name]
            return f"{count:.3g} {name}" if count < 1000 else f"{count:,.0f} {name}"
    if length >= SECOND:
        return f"{length / SECOND:.4g} s"
    return f"{length / 1000:.4g} ms" if length >= 1000 else f"{length} us"


def instant(tick: int, kind: TimeKind) -> str:
    """Return an instant as text; years beyond the calendar as microseconds."""
    if kind.is_counter:
        return f"{tick:,}"
    try:
        return f"{_EPOCH + dt.timedelta(microseconds=tick):%Y-%m-%d %H:%M:%S}"
    except OverflowError:
        return f"{tick:,} us since 1970"


def setting(length: int, kind: TimeKind) -> int | str:
    """Return a length exactly, as a setting: a number of counter steps, or a text such as '5 s'."""
    if kind.is_counter:
        return length
    unit = next(unit for unit in ("d", "h", "min", "s", "ms", "us") if length % UNITS[unit] == 0)
    return f"{length // UNITS[unit]} {unit}"


def roundest(least: int, below: int, wanted: int, kind: TimeKind) -> int:
    """Return the round length in [least, below) that is nearest to the wanted one; else ``least``."""
    steps = [factor * 10**power for power in range(19) for factor in (1, 2, 5)]
    if not kind.is_counter:
        steps = [step for step in steps if step < 60 * SECOND]
        steps += [SECOND * seconds for seconds in _ROUND_SECONDS]
    inside = [step for step in steps if least <= step < below]
    return min(inside, key=lambda step: max(step / wanted, wanted / step), default=least)


def number_of(count: int, thing: str) -> str:
    """Return a count with its noun: 1 pause, 12 pauses."""
    return f"{count:,} {thing}{'s' * (count != 1)}"


def extent(values: Sequence[int]) -> str:
    """Return the least and the greatest of some counts: '3', or '3 to 17'."""
    return reaching(f"{min(values):,}", f"{max(values):,}")


def reaching(least: str, most: str) -> str:
    """Return from where to where something reaches, in words; one of them where both are the same."""
    return least if least == most else f"{least} to {most}"


def percent(share: float) -> str:
    """Return a share in percent, with enough digits to be seen."""
    hundred = 100 * share
    return f"{hundred:.0f} %" if hundred >= 10 or not hundred else f"{hundred:.2g} %"
