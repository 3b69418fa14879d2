"""What estimators are fitted on and score, in plain loops and NumPy: no code of the package.

Channels, pools and the vectors to learn and to score come from ``reference``; what is added here is the
normalised value of a sample (section 3 of the method: min and max of calibration) and the moving average
of scores in integers.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

import reference
from reference import Channel, Pool, Row

Points = NDArray[np.float64]

FARTHEST = 1e6


def normalised(x: float, pool: Pool) -> float:
    """(x - lo) / (hi - lo), or x - lo where that is 0; at most a million."""
    lo, hi = pool.lo, pool.hi
    assert lo is not None
    assert hi is not None
    away = x - lo
    if hi > lo:
        with np.errstate(over="ignore"):
            away = float(np.float64(away) / np.float64(hi - lo))
    return max(-FARTHEST, min(FARTHEST, away))


def points(channel: Channel, pool: Pool, vectors: Sequence[Sequence[int]]) -> Points:
    """The coordinates of vectors of one channel, a row each."""
    rows = []
    for vector in vectors:
        samples = [channel.values[position] for position in vector]
        rows.append([normalised(x, pool) for x in samples if x is not None])
    return np.array(rows, np.float64).reshape(-1, pool.settings.m)


def learnt(pool: Pool) -> Points:
    """All calibration vectors of a pool, member by member, in order."""
    return np.concatenate([points(member, pool, member.learnt) for member in pool.members])


def scored(
    rows: Sequence[Row], parameters: Any, calibration: Any
) -> Iterator[tuple[Channel, Pool, list[int], Points]]:
    """Every channel with its pool, the times of its scored vectors and their points."""
    for channel, pool in reference.channels(rows, parameters, calibration):
        if pool.lo is not None:
            times = [channel.times[vector[0]] for vector in channel.scored]
            yield channel, pool, times, points(channel, pool, channel.scored)


def centroid(healthy: Points, vectors: Points) -> Points:
    """Distances to the centre of mass."""
    distances: Points = np.sqrt(((vectors - healthy.mean(axis=0)) ** 2).sum(axis=1))
    return distances


def moving_mean(scores: Sequence[float], window: int) -> list[float | None]:
    """Eq. 2 over scores rounded to 2^-20, in integers of any size, divided last."""
    most = 2**62 // window
    units = [max(-most, min(most, math.floor(score * 2**20 + 0.5))) for score in scores]
    return [
        sum(units[i + 1 - window : i + 1]) / (2**20 * window) if i + 1 >= window else None
        for i in range(len(units))
    ]
