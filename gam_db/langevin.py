"""A simulated machine: the over-damped Langevin system with five wells that drift apart from control.

This module owns that one simulation, for ``gam demo``, documentation and tests. It
knows nothing of the indicator.

The equations are those of the paper (Geometric Attractor Monitoring, its simulated multi-stable
system). The paper leaves the numbers open; those below were *chosen*, by a search for a system whose
average mutual information has its first minimum near 58, whose false nearest neighbours are nearly
gone at m = 3, and on which Discrete Support Estimation comes out near the paper's row. So this series
cannot serve as independent evidence for that row.
"""

import math

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.errors import ParameterError

SAMPLES = 200_000

ASSET, CHANNEL = "simulated", "position"

#: The parameters of the method that belong to this series.
M, TAU, BINS, WINDOW = 3, 58, 100, 5000
CALIBRATION = 0.4

WELLS = (-2.0, -1.0, 0.0, 1.0, 2.0)
"""Centre of each well."""
DRIFTS = (0.25, 0.25, 0.0, 0.0, 0.0)
"""How far each centre has moved at the end."""
STRENGTHS = (3.0, 3.0, 3.0, 3.0, 3.0)
ORDER = (0, 2, 4, 1, 3)
"""The order in which the controller visits the wells."""
GAIN = 4.0
NOISE = 0.06
STEP = 0.03
DWELL = 116
"""Steps spent at each target."""


def simulate(seed: int = 0, samples: int = SAMPLES) -> NDArray[np.float64]:
    """Return the position of the simulated system, step by step (Euler-Maruyama).

    A controller pulls the system through five wells in a fixed cycle. For the first 40 % of the steps
    nothing changes; from then on two wells move away, linearly to the last step, and the controller
    compensates: its targets move as far the other way. The position is without unit, the clock is the
    step number.

    Args:
        seed: of ``numpy.random.default_rng``, which draws the noise.
        samples: steps to simulate, at least 2; wear always ends at the last one.

    Returns:
        The positions, one double per step.

    Raises:
        ParameterError: fewer than 2 samples.
    """
    if samples < 2:
        raise ParameterError(f"samples is {samples}; the simulation takes at least 2.")
    shocks = (NOISE * math.sqrt(STEP) * np.random.default_rng(seed).standard_normal(samples)).tolist()
    step, last = np.arange(samples), samples - 1
    wear = np.where(step <= CALIBRATION * last, 0.0, (step / last - CALIBRATION) / (1 - CALIBRATION))
    visited = np.array(ORDER)[step // DWELL % len(ORDER)]
    targets = (np.array(WELLS)[visited] - wear * np.array(DRIFTS)[visited]).tolist()

    # The loop is plain floats on purpose: every step needs the one before, and NumPy's scalars are slow.
    exp = math.exp
    wells = list(zip(STRENGTHS, WELLS, DRIFTS, strict=True))
    position = targets[0]
    positions = [position]
    for worn, target, shock in zip(wear.tolist()[:-1], targets[:-1], shocks[:-1], strict=True):
        force = GAIN * (target - position)
        for strength, centre, drift in wells:
            away = position - (centre + worn * drift)
            force -= strength * away * exp(-(away * away) / 0.5)
        position += force * STEP + shock
        positions.append(position)
    return np.array(positions)


def series(seed: int = 0, samples: int = SAMPLES) -> pa.Table:
    """Return the simulated system as a long table: asset, channel, time (step number), value.

    Raises:
        ParameterError: fewer than 2 samples.
    """
    position = simulate(seed, samples)
    return pa.table(
        {
            "asset": pa.array([ASSET] * samples),
            "channel": pa.array([CHANNEL] * samples),
            "time": np.arange(samples),
            "value": position,
        }
    )
