"""Local times once more, by the time zones of Python itself: which instants readings are of.

It shares no code with the package, which writes the changes of a zone out as integers.
"""

import datetime as dt
import zoneinfo
from collections import defaultdict
from typing import Any

Row = tuple[str, str, int, float | None]

_EPOCH = dt.datetime(1970, 1, 1)
_MICROSECOND = dt.timedelta(microseconds=1)


def instants(local: int, zone: str) -> list[int]:
    """Return the instants at which clocks of a zone show a local time, two, one or none."""
    shown, there = _EPOCH + local * _MICROSECOND, zoneinfo.ZoneInfo(zone)
    found = set()
    for fold in (0, 1):
        instant = shown.replace(tzinfo=there, fold=fold).astimezone(dt.UTC)
        if instant.astimezone(there).replace(tzinfo=None) == shown:
            found.add((instant.replace(tzinfo=None) - _EPOCH) // _MICROSECOND)
    return sorted(found)


def shown(instant: int, zone: str) -> int:
    """Return what clocks of a zone show at an instant, in microseconds since 1970."""
    told = (_EPOCH + instant * _MICROSECOND).replace(tzinfo=dt.UTC).astimezone(zoneinfo.ZoneInfo(zone))
    return (told.replace(tzinfo=None) - _EPOCH) // _MICROSECOND


def with_programs(rows: list[Any], zone: str) -> list[Any]:
    """Return rows with programs likewise; of equal readings the one of the least program comes first."""
    together: dict[tuple[str, str, int], list[tuple[float | None, str | None]]] = defaultdict(list)
    for asset, channel, local, value, program in rows:
        together[asset, channel, local].append((value, program))
    found: list[Any] = []
    for (asset, channel, local), told in together.items():
        there = instants(local, zone)
        told.sort(
            key=lambda one: (one[0] is None, one[0] or 0.0, one[1] is None, (one[1] or "").encode())
        )
        for place, of in enumerate(told if there else []):
            found.append((asset, channel, there[-1] if place else there[0], *of))
    return found


def in_utc(rows: list[Row], zone: str) -> list[Row]:
    """Return rows of local time by their instants; those that no clock shows are left out.

    Of the readings of a channel at a local time that comes twice, the smallest is of the first pass and
    the others are of the second; missing ones come last.
    """
    together: dict[tuple[str, str, int], list[float | None]] = defaultdict(list)
    for asset, channel, local, value in rows:
        together[asset, channel, local].append(value)
    found: list[Row] = []
    for (asset, channel, local), values in together.items():
        there = instants(local, zone)
        numbers = sorted(value for value in values if value is not None)
        for place, value in enumerate([*numbers, *[None] * (len(values) - len(numbers))]):
            if there:
                found.append((asset, channel, there[-1] if place else there[0], value))
    return found
