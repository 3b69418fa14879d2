"""A small simulated plant with every kind of change, for an example of the page.

This module owns the behaviour of its machines. The plant is an illustration, not evidence.
"""

import datetime as dt
import zlib

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db import data
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters

START = dt.datetime(2026, 3, 2, tzinfo=dt.UTC)
STEP, A_DAY, DAYS = dt.timedelta(minutes=2), 720, 28

PARAMETERS = Parameters(m=3, tau=2, bins=14, window=360, stride=36, max_gap="10 min")
CALIBRATION = Calibration(duration="8 d")
TIME_ZONE = "Europe/Berlin"

_PLANT = data.table("gam_db.report", "plant.toml")

#: The time of its page: the morning after the last reading.
END = START + dt.timedelta(days=DAYS, hours=5)


def telemetry() -> pa.Table:
    """Return the readings of the plant: asset, channel, time (UTC), value; the same at every call."""
    count = DAYS * A_DAY
    begin = int(START.timestamp() * 1_000_000)
    time = begin + np.arange(count, dtype=np.int64) * (STEP // dt.timedelta(microseconds=1))
    parts = []
    for machine, happens in _PLANT["machines"].items():
        for channel in _PLANT["signals"]:
            what, day = happens.get(channel, happens.get("*", ("calm", 0.0)))
            value, mask = _signal(f"{machine}/{channel}", channel, what, day, count)
            names = [pa.repeat(name, int(mask.sum())) for name in (machine, channel)]
            times = pa.array(time[mask], pa.timestamp("us", "UTC"))
            columns = [*names, times, pa.array(value[mask])]
            parts.append(pa.table(columns, names=["asset", "channel", "time", "value"]))
    return pa.concat_tables(parts)


def _signal(
    name: str, channel: str, what: str, day: float, count: int
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Return the values of one signal, and which of them there are."""
    chance = np.random.default_rng(zlib.crc32(name.encode()))
    days = np.arange(count) / A_DAY
    at = np.arange(count) + int(chance.integers(40))
    level, scale = _PLANT["signals"][channel]
    since = np.clip(days - day, 0, None)
    begun = days >= day
    period = 40 + int(chance.integers(4)) * 4
    phase = (at % period) / period
    second = 0.35 + 0.3 * chance.random()
    shape = np.sin(2 * np.pi * phase) + second * np.sin(4 * np.pi * phase + chance.random())
    noise = 0.035 * chance.standard_normal(count)
    noise *= {"wear": 1 + 0.8 * since, "creeps": 1 + 0.22 * since}.get(what, 1.0)
    other_program = np.where(phase < 0.5, 1.1, -0.9) * np.cos(6 * np.pi * phase)
    shape = {
        "program": np.where(begun, other_program, shape),
        "wear": shape * (1 + 0.025 * since),
        "breaks": np.where(begun, 1.5 * shape + 0.6, shape),
        "repaired": np.where(begun & (days < day + 3.2), np.clip(shape, -0.6, 0.5), shape),
        "warms": shape + 0.12 * since,
        "spikes": np.where(begun & (at % 190 < 4), 2.4, shape),
        "coarse": np.round(shape * 3) / 3,
    }.get(what, shape)
    if what == "noise":
        shape, noise = np.zeros(count), chance.uniform(-1, 1, count)
    value = level + scale * (0.8 * shape + noise + 0.05 * np.sin(2 * np.pi * days))
    if what == "stands":
        value = np.where(days < 12, level, value)
    masks = {"silent": ~begun, "late": begun, "weekends": np.floor(days).astype(int) % 7 < 5}
    return np.round(value, 3), masks.get(what, np.ones(count, bool))
