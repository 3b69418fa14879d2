"""The workload: what the joints of a few robots might send, simulated and seeded.

A joint steps through a program of six levels, again and again, with dwell times that vary, plus noise
of the sensor. From 60 % of the recording on it drifts, so that its cells leave the support.
"""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.lab.benchmark.database import opened, statement

#: How the rows lie in the file.
ORDERS = {"channel": "stored by channel", "time": "interleaved by time"}

SEED = 20_240_607
LEVELS = 6
DWELL = (20, 60)  # samples
NOISE = 0.03  # standard deviation; the levels lie between -1 and 1
DRIFT = 0.1  # reached at the end, growing with the square of time
DRIFT_FROM = 0.6  # share of the recording
FIRST_TIME = 1_700_000_000_000_000  # microseconds
TIME_STEP = 10_000  # microseconds: 100 Hz
JOINTS = 6  # channels per robot

_BLOCK = 50_000  # instants per batch where channels are interleaved


def names_of(channel: int) -> tuple[str, str]:
    """Return asset and channel of a channel's number, counted from 0; they sort like the numbers."""
    return f"robot_{channel // JOINTS + 1:04d}", f"joint_{channel % JOINTS + 1}"


def values_of(channel: int, samples: int) -> NDArray[np.float64]:
    """Return the readings of a channel, in order of time; the same ones in every run."""
    random = np.random.default_rng([SEED, channel])
    levels = random.uniform(-1, 1, LEVELS)
    dwell = random.integers(*DWELL, samples // DWELL[0] + 1)
    followed = np.repeat(np.resize(levels, len(dwell)), dwell)[:samples]
    worn = np.clip(np.arange(samples) / samples - DRIFT_FROM, 0, None) / (1 - DRIFT_FROM)
    return np.asarray(followed + DRIFT * worn**2 + NOISE * random.standard_normal(samples))


def store(path: Path, order: str, channels: int, samples: int) -> None:
    """Make a DuckDB file that holds the workload twice: by name and by integer id.

    Args:
        path: the file; it must not exist.
        order: one of :data:`ORDERS`; both hold the same rows.
        channels: how many there are.
        samples: readings per channel.
    """
    with opened(path, threads=1) as connection:
        for table in ("readings", "readings_by_id"):
            connection.execute(statement(table))
        for rows in batches(order, channels, samples):
            named = rows.select(["asset", "channel", "t", "value"])
            connection.from_arrow(named).insert_into("readings")
            by_id = rows.select(["channel_id", "t", "value"])
            connection.from_arrow(by_id).insert_into("readings_by_id")


def batches(order: str, channels: int, samples: int) -> Iterator[pa.Table]:
    """Yield the rows of the workload in an order: asset, channel, channel_id, t, value."""
    times = FIRST_TIME + TIME_STEP * np.arange(samples, dtype=np.int64)
    numbers = np.arange(channels, dtype=np.int32)
    if order == "channel":
        for number in numbers:
            yield _rows(np.full(samples, number), times, values_of(int(number), samples), channels)
        return
    values = np.stack([values_of(int(number), samples) for number in numbers])
    for start in range(0, samples, _BLOCK):
        block = times[start : start + _BLOCK]
        yield _rows(
            np.tile(numbers, len(block)),
            np.repeat(block, channels),
            values[:, start : start + _BLOCK].T.ravel(),
            channels,
        )


def _rows(
    numbers: NDArray[np.int32],
    times: NDArray[np.int64],
    values: NDArray[np.float64],
    channels: int,
) -> pa.Table:
    names = [names_of(number) for number in range(channels)]
    columns = {
        role: pa.DictionaryArray.from_arrays(numbers, [name[place] for name in names]).cast(pa.string())
        for place, role in enumerate(("asset", "channel"))
    }
    return pa.table({**columns, "channel_id": numbers, "t": times, "value": values})
