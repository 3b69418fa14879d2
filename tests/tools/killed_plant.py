"""The plant that is watched by runs which are killed: twelve channels, two settings, a pool."""

import itertools
import random
from dataclasses import dataclass, field
from functools import cache
from typing import Any

from batches import Arrivals
from strategies import Row

PARAMETERS: dict[str, Any] = {
    **{"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5},
    "overrides": [{"asset": "q*", "channel": "*", "m": 3, "tau": 1, "window": 12, "stride": 4}],
}
CALIBRATION: dict[str, Any] = {"fraction": 0.75, "pool": [["p1", "p2", "p3"]]}
ALARMS = "5 per 1000 judgements"
LOOKBACK = 8
METHOD: dict[str, Any] = {
    "parameters": PARAMETERS,
    "calibration": CALIBRATION,
    "lookback": LOOKBACK,
    "alarms": ALARMS,
}

#: Rows of each channel, and those of them that are there when calibration is frozen.
LENGTH, FIRST = 340, 220


@dataclass
class Plant:
    """Twelve channels that repeat a pattern, and later on less so; their rows come in batches."""

    first: list[Row] = field(default_factory=list)
    batches: list[list[Row]] = field(default_factory=list)

    @property
    def final(self) -> list[Row]:
        """All rows, some of them more than once."""
        return [*self.first, *itertools.chain(*self.batches)]


@cache
def plant() -> Plant:
    chance = random.Random(20240229)
    rows: list[Row] = []
    for asset, channel in itertools.product(["a", "b", "p1", "p2", "p3", "q"], ["x", "y"]):
        pattern = [chance.random() for _ in range(chance.randint(3, 6))]
        for time_of in range(LENGTH):
            oddness = 0.02 if time_of < FIRST else 0.2
            usual = pattern[time_of % len(pattern)]
            rows.append(
                (asset, channel, time_of, chance.choice([None, chance.random()]))
                if chance.random() < oddness
                else (asset, channel, time_of, usual)
            )
    first = [row for row in rows if row[2] < FIRST]
    arrivals = Arrivals(chance, first, [row for row in rows if row[2] >= FIRST], LOOKBACK)
    made = Plant(first)
    made.batches += [arrivals.next() for _ in range(4)]
    while arrivals.pending:
        made.batches[-1].extend(arrivals.next())
    return made
