"""Wear: how a fault grows from its onset to the failure, and how it shows in a joint's signal."""

import numpy as np
from numpy.typing import NDArray

from gam_db.errors import InternalError

Floats = NDArray[np.float64]

_STEPS = 4
_RECOVERY = (0.3, 0.6)  # share of a step that lubrication takes back
_TRANSIENT = (1.0, 0.6, 0.3)  # of the amplitude, in the samples after a jump


def grown(growth: str, age: Floats, random: np.random.Generator) -> Floats:
    """Return the size of a fault, 0 to 1.

    Args:
        growth: linear, exponential, or steps (each followed by a partial recovery).
        age: 0 at the onset, 1 at the failure; below 0 there is no fault.
        random: draws when steps occur and how much is recovered.
    """
    worn = np.clip(age, 0, 1)
    if growth == "linear":
        return worn
    if growth == "exponential":
        return np.asarray(np.expm1(4 * worn) / np.expm1(4))
    if growth != "steps":
        raise InternalError(f"There is no growth {growth}.")
    up = (np.arange(_STEPS) + random.uniform(0, 0.5, _STEPS)) / _STEPS
    down = up[:-1] + random.uniform(0.3, 0.6, _STEPS - 1) * np.diff(up)
    heights = np.arange(1, _STEPS + 1) / _STEPS
    recovered = heights[:-1] - random.uniform(*_RECOVERY, _STEPS - 1) / _STEPS
    places = np.concatenate([up, down])
    order = np.argsort(places)
    sizes = np.concatenate([[0.0], np.concatenate([heights, recovered])[order]])
    return np.asarray(np.where(age < 0, 0.0, sizes[np.searchsorted(places[order], worn, "right")]))


def shown(
    fault: str,
    size: Floats,
    moves: NDArray[np.int64],
    places: NDArray[np.int64],
    random: np.random.Generator,
) -> Floats:
    """Return what a fault adds to a joint's signal, in shares of its amplitude.

    * friction: an offset with the sign of motion, of another size at each level;
    * backlash: a wider spread at one or two levels;
    * transients: a few samples after the jumps into one or two moves.

    Args:
        fault: one of the three.
        size: of the fault at each sample, 0 to 1.
        moves: number of the move at each sample; the last two moves are the rare one and the wait.
        places: number of the level of each move.
        random: draws which levels and jumps are touched.
    """
    regular = len(places) - 2
    if fault == "friction":
        signs = random.choice([-1.0, 1.0], len(places))
        signs[-1] = 0.0  # the robot waits
        weights = random.uniform(0.5, 1.0, places.max() + 1)
        return np.asarray(size * (signs * weights[places])[moves])
    if fault == "backlash":
        visited = np.unique(places[:regular])
        touched = random.choice(visited, min(len(visited), int(random.integers(1, 3))), replace=False)
        loose = np.isin(places[moves], touched)
        return np.asarray(size * loose * random.uniform(-1, 1, len(moves)))
    if fault != "transients":
        raise InternalError(f"There is no fault {fault}.")
    into = random.choice(regular, int(random.integers(1, 3)), replace=False)
    jumps = np.flatnonzero((moves[1:] != moves[:-1]) & np.isin(moves[1:], into)) + 1
    added = np.zeros(len(moves))
    for later, share in enumerate(_TRANSIENT):
        reached = jumps[jumps + later < len(moves)] + later
        added[reached] = share
    return np.asarray(size * random.choice([-1.0, 1.0]) * added)
