"""Heights of evidence: from the requested rate of false alarms to a height (alarms, section 3).

This module owns the rate and the choice of a height from a few counts. It knows no SQL and no source.
"""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from gam_db.errors import wrong

LEAST, MOST = 4, 80
"""The heights that a replay tries, in quarters of a spread."""

UNSTATED = 32
"""The height where no rate can be stated."""

STATED_FROM = 0.0005
"""The lowest rate that simulated fleets kept, per judgement; heights for less are estimates."""

_DAYS = {"day": 1, "week": 7, "month": 30, "year": 365}
_RATE = re.compile(
    r"((?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?) per (day|week|month|year|1000 judgements)"
    r"( per channel)?"
)
_BLOCKS = (8, 12, 16, 24, 48)
#: Rate per judgement -> heights by blocks.
_TABLE = {1 / 5000: (13, 8, 6.5, 5, 4), 1 / 1000: (5, 4, 3.5, 3, 2.5), 1 / 300: (1.5,) * 5}


@dataclass(frozen=True)
class Rate:
    """A requested rate of false alarms."""

    number: float  # of them
    days: int | None  # in so many days; None for in 1,000 judgements
    per_channel: bool  # of each channel, not of all

    @classmethod
    def of(cls, text: object) -> "Rate":
        """Return the rate of a text.

        Raises:
            ParameterError: it says none.
        """
        match = _RATE.fullmatch(" ".join(text.split())) if isinstance(text, str) else None
        number = float(match[1]) if match else 0.0
        days = None if match is None else _DAYS.get(match[2])
        if match is None or not 0 < number < math.inf or (days is None and match[3]):
            raise wrong("no_rate", said=text)
        return cls(number, days, match[3] is not None)

    def per_judgement(self, of_channel: float | None, total: float) -> float:
        """Return the rate of a channel by its judgements a day, and those of all with a limit."""
        if self.days is None:
            return self.number / 1000
        days = of_channel if self.per_channel else total
        assert days
        return self.number / self.days / days


@dataclass(frozen=True)
class Height:
    """A height in quarters of a spread, and its basis: replay, extrapolated, table or none."""

    quarters: int
    basis: str


def by_replay(rate: float, judgements: int, episodes: Mapping[int, int]) -> Height:
    """Return the height for a rate per judgement, of a family whose calibration was replayed.

    What is less than can be stated is raised to that. Episodes are by height, in quarters; a height
    without any may be left out.
    """
    expected = judgements * max(rate, 1 / (10 * judgements))
    for quarters in range(LEAST, MOST + 1):
        if 10 * episodes.get(quarters, 0) + 7 <= expected * 10:
            return Height(quarters, "replay")
    if (height := _carried_on(expected, episodes)) is None:
        return Height(UNSTATED, "none")
    empty = (quarters for quarters in range(LEAST, MOST + 1) if not episodes.get(quarters, 0))
    return Height(max(_in_quarters(height), next(empty, MOST)), "extrapolated")


def by_table(rate: float, blocks: int) -> Height:
    """Return the height for a channel of at least 8 blocks by the table for normal blocks."""
    heights = [float(np.interp(blocks, _BLOCKS, by_blocks)) for by_blocks in _TABLE.values()]
    return Height(_in_quarters(float(np.interp(math.log(rate), np.log([*_TABLE]), heights))), "table")


def _carried_on(expected: float, episodes: Mapping[int, int]) -> float | None:
    """Return the height of so many episodes: ln x on h, by least squares with weights x."""
    points = [(quarters / 4, count) for quarters, count in sorted(episodes.items()) if count > 0]
    if len(points) < 3:
        return None
    weight = math.fsum(x for _, x in points)
    mean_h = math.fsum(x * h for h, x in points) / weight
    mean_y = math.fsum(x * math.log(x) for _, x in points) / weight
    spread = math.fsum(x * (h - mean_h) ** 2 for h, x in points)
    slope = math.fsum(x * (h - mean_h) * (math.log(x) - mean_y) for h, x in points) / spread
    return mean_h + (math.log(expected) - mean_y) / slope if slope < 0 else None


def _in_quarters(height: float) -> int:
    return math.ceil(4 * height - 1e-9)
