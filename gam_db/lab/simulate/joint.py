"""The signal of one joint: levels, jumps between them, noise, drift, and what happens to it."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from gam_db.lab.simulate.program import STANDING, SWITCHED_OFF, Program, Timeline

Floats = NDArray[np.float64]

HERTZ = 5
"""Samples per second."""

_LEVELS = (3, 8)
_NOISE = (0.003, 0.012)  # standard deviation of a level, as a share of the joint's range
_DRIFT = (0.2, 0.6)  # amplitude, as a share of the median standard deviation
_DRIFT_HOURS = (1.0, 5.0)
_HALF_RANGE = (5.0, 200.0)  # torque, N m
_RESOLUTION = 1500  # steps of the controller in the joint's range, about
_TWIN_OFFSET = 0.005  # of the range, at most: twins are not the same machine
_BETWEEN = (0.5, 0.35, 0.15)  # of the jumps have no, one, two samples in between


@dataclass(frozen=True)
class Levels:
    """The levels of torque disturbance that a joint visits, in shares of half its range (-1 to 1).

    Attributes:
        heights: of each level.
        places: number of the level of each move; the last two are the rare move and the wait.
    """

    heights: Floats
    places: NDArray[np.int64]

    def then(self, other: "Levels") -> "Levels":
        """Return the levels of this program and of another one, whose moves are counted on."""
        return Levels(
            np.concatenate([self.heights, other.heights]),
            np.concatenate([self.places, len(self.heights) + other.places]),
        )


@dataclass(frozen=True)
class Scale:
    """What makes a joint one of its own: its range, offset, resolution, noise, drift and clock.

    Attributes:
        half_range: torque that one unit of height stands for.
        offset: torque at height 0.
        decimals: of the controller's resolution.
        drift: amplitude of the thermal drift, in units of height.
        drift_hours: periods of its two waves; drift_phases: their phases.
        clock: seconds by which the joint samples later than the robot's clock.
    """

    half_range: float
    offset: float
    decimals: int
    drift: float
    drift_hours: Floats
    drift_phases: Floats
    clock: float


def drawn_levels(program: Program, random: np.random.Generator) -> Levels:
    """Draw 3 to 8 separated levels, from -1 to 1, and which move stays at which."""
    regular = program.moves - 2
    count = int(random.integers(_LEVELS[0], min(_LEVELS[1], regular) + 1))
    spacing = 2 / (count - 1)
    heights = np.linspace(-1, 1, count)
    heights[1:-1] += random.uniform(-0.25, 0.25, count - 2) * spacing
    every = random.permutation([*range(count), *random.integers(0, count, regular - count)])
    # The rare move reaches a level that no other move does, half way between two of them.
    gap = int(random.integers(count - 1))
    heights = np.append(heights, (heights[gap] + heights[gap + 1]) / 2)
    return Levels(heights, np.append(every, [count, random.integers(count)]))


def drawn_noise(levels: Levels, random: np.random.Generator) -> Floats:
    """Draw the standard deviation of the noise at each level, in units of height."""
    return 2 * random.uniform(*_NOISE, len(levels.heights))


def drawn_scale(noise: Floats, random: np.random.Generator) -> Scale:
    """Draw what makes a joint one of its own."""
    half_range = float(np.exp(random.uniform(*np.log(_HALF_RANGE))))
    return Scale(
        half_range=half_range,
        offset=float(random.uniform(-0.3, 0.3)) * half_range,
        decimals=round(-math.log10(2 * half_range / _RESOLUTION)),
        drift=float(random.uniform(*_DRIFT) * np.median(noise)),
        drift_hours=random.uniform(*_DRIFT_HOURS, 2),
        drift_phases=random.uniform(0, 2 * math.pi, 2),
        clock=float(random.uniform(0, 1 / HERTZ)),
    )


def twin_offset(random: np.random.Generator) -> float:
    """Draw how far the joint of a twin lies beside those of the others, in units of height."""
    return float(2 * _TWIN_OFFSET * random.uniform(-1, 1))


def sampled(timeline: Timeline, seconds: Floats) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return the move and the state of the robot at the given instants."""
    stretch = np.searchsorted(timeline.ends, seconds, "right")
    return timeline.moves[stretch], timeline.states[stretch]


def followed(levels: Levels, moves: NDArray[np.int64], random: np.random.Generator) -> Floats:
    """Return the height at each sample: that of the move's level, with at most two in between."""
    heights = levels.heights[levels.places[moves]]
    jumps = np.flatnonzero(np.diff(heights)) + 1
    between = random.choice(len(_BETWEEN), len(jumps), p=_BETWEEN)
    share = random.uniform(0.1, 0.5, (2, len(jumps)))
    share[1] += 0.4
    before, size = heights[jumps - 1], heights[jumps] - heights[jumps - 1]
    for place in (0, 1):
        reached = (between > place) & (jumps + place < len(heights))
        heights[jumps[reached] + place] = (before + share[place] * size)[reached]
    return heights


def drifting(scale: Scale, seconds: Floats) -> Floats:
    """Return the thermal drift at the given instants, in units of height."""
    waves = [
        np.sin(2 * math.pi * seconds / (3600 * hours) + phase)
        for hours, phase in zip(scale.drift_hours, scale.drift_phases, strict=True)
    ]
    return np.asarray(scale.drift * (0.7 * waves[0] + 0.3 * waves[1]))


def wandering(spread: float, samples: float, count: int, random: np.random.Generator) -> Floats:
    """Return a drift that forgets where it was: its correlation falls by e in so many samples.

    Args:
        spread: its standard deviation, in units of height.
        samples: in which it forgets.
        count: of samples wanted.
        random: draws it.
    """
    every = max(1, int(samples / 50))
    persistence = math.exp(-every / samples)
    knots = spread * random.standard_normal(count // every + 2)
    for number in range(1, len(knots)):
        knots[number] = persistence * knots[number - 1] + math.sqrt(1 - persistence**2) * knots[number]
    return np.interp(np.arange(count), every * np.arange(len(knots)), knots)


def measured(scale: Scale, heights: Floats, states: NDArray[np.int64]) -> Floats:
    """Return the readings: torque at the controller's resolution, frozen while the robot stands."""
    readings = np.round(scale.offset + scale.half_range * heights, scale.decimals)
    stands = states == STANDING
    last = np.maximum.accumulate(np.where(stands, -1, np.arange(len(readings))))
    return np.asarray(readings[np.maximum(last, 0)])


def reporting(states: NDArray[np.int64]) -> NDArray[np.bool_]:
    """Tell at which samples there is a row at all."""
    return np.asarray(states != SWITCHED_OFF)
