"""Random cases of counters told in calendar time: the same instants, lengths and settings, in a unit.

A case is of :mod:`strategies`; a step of its counter becomes so many microseconds from an instant on.
"""

import datetime as dt
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from strategies import Arguments, Row

EPOCH = dt.datetime(1970, 1, 1)

#: What a counter step or an instant of it becomes.
Told = Callable[[int], Any]


@dataclass(frozen=True)
class Calendar:
    """How a counter is told in calendar time: when its 0 is, and how many microseconds a step lasts."""

    begin: dt.datetime
    unit: int

    def rows(self, rows: list[Row]) -> list[Row]:
        """Return rows whose times are microseconds since 1970."""
        return [(asset, channel, self._micros(time), value) for asset, channel, time, value in rows]

    def in_micros(self, parameters: Arguments, calibration: Arguments) -> tuple[Arguments, Arguments]:
        """Return keyword arguments for a counter of microseconds."""
        return (
            _parameters(parameters, self._length),
            _calibration(calibration, self._length, self._micros),
        )

    def in_words(self, parameters: Arguments, calibration: Arguments) -> tuple[Arguments, Arguments]:
        """Return keyword arguments as they are said of calendar time."""
        return (
            _parameters(parameters, self._delta),
            _calibration(calibration, self._delta, lambda time: self.begin + self._delta(time)),
        )

    def _micros(self, time: int) -> int:
        return (self.begin - EPOCH) // dt.timedelta(microseconds=1) + time * self.unit

    def _length(self, steps: int) -> int:
        return steps * self.unit

    def _delta(self, steps: int) -> dt.timedelta:
        return dt.timedelta(microseconds=steps * self.unit)


def _parameters(said: Arguments, length: Told) -> Arguments:
    made = {name: length(one) if name == "max_gap" and one else one for name, one in said.items()}
    if "overrides" in said:
        made["overrides"] = [_parameters(one, length) for one in said["overrides"]]
    return made


def _calibration(said: Arguments, length: Told, instant: Told) -> Arguments:
    made = dict(said)
    if said.get("duration") is not None:
        made["duration"] = length(said["duration"])
    if said.get("score_from") is not None:
        made["score_from"] = instant(said["score_from"])
    for name in ("intervals", "exclude"):
        if said.get(name):
            made[name] = [(instant(start), instant(end)) for start, end in said[name]]
    for pattern, one in said.get("overrides", {}).items():
        made["overrides"] = {
            **made["overrides"],
            pattern: None if one is None else _calibration(one, length, instant),
        }
    return made
