"""The Langevin system as a table, as ``gam demo``, ``gam simulate`` and ``gam reproduce`` use it."""

import math

import numpy as np
import pyarrow as pa

from gam_db import langevin

ASSET, CHANNEL = "simulated", "position"


def langevin_series(seed: int = 0, samples: int = langevin.SAMPLES) -> pa.Table:
    """Return the simulated system as a long table: asset, channel, time (step number), value.

    Raises:
        ParameterError: fewer than 2 samples.
    """
    position = langevin.simulate(seed, samples)
    return pa.table(
        {
            "asset": pa.array([ASSET] * samples),
            "channel": pa.array([CHANNEL] * samples),
            "time": np.arange(samples),
            "value": position,
        }
    )


def langevin_truth(samples: int = langevin.SAMPLES) -> pa.Table:
    """Return the truth about the system: wear from the first step above 40 % to the last one."""
    return pa.table(
        {
            "asset": pa.array([ASSET]),
            "channel": pa.array([CHANNEL]),
            "kind": pa.array(["failed"]),
            "event": pa.array(["wells drift"]),
            "growth": pa.array(["linear"]),
            "onset": pa.array([math.floor(langevin.CALIBRATION * (samples - 1)) + 1]),
            "failed_at": pa.array([samples - 1]),
        }
    )
