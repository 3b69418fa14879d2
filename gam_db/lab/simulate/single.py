"""The truth about the Langevin system, as ``gam simulate`` and ``gam reproduce`` use it."""

import math

import pyarrow as pa

from gam_db import langevin


def langevin_truth(samples: int = langevin.SAMPLES) -> pa.Table:
    """Return the truth about the system: wear from the first step above 40 % to the last one."""
    return pa.table(
        {
            "asset": pa.array([langevin.ASSET]),
            "channel": pa.array([langevin.CHANNEL]),
            "kind": pa.array(["failed"]),
            "event": pa.array(["wells drift"]),
            "growth": pa.array(["linear"]),
            "onset": pa.array([math.floor(langevin.CALIBRATION * (samples - 1)) + 1]),
            "failed_at": pa.array([samples - 1]),
        }
    )
