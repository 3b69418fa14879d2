"""The table of docs/limits.md: ``python tests/tools/limits_page.py``.

Each case is a signal that is healthy in its first half, which is calibration, and changes after it.
"""

from collections.abc import Callable

import numpy as np
import pyarrow as pa

import gam_db

SAMPLES = 24_000
HALF = SAMPLES // 2
PARAMETERS = gam_db.Parameters(m=3, tau=11, bins=16, window=500)
CALIBRATION = gam_db.Calibration(fraction=0.5)

#: A signal of one number per sample.
Signal = np.ndarray[tuple[int, ...], np.dtype[np.float64]]

_INDEX = np.arange(SAMPLES)
_LATER = _INDEX >= HALF
_PRODUCTS = np.array([1.0, 0.8, 0.6])[(_INDEX // 440) % 3]
_STANDING = (_INDEX // 2200) % 10 == 5
_FAULTY = (_INDEX // 500) % 20 == 7


def _stroke(shift: int = 0, turned: int = 0) -> Signal:
    """Return a stroke of 44 samples a cycle between 0 and 1, later moved by so many samples."""
    stroke: Signal = np.abs((_INDEX + shift + turned * _LATER) % 44 - 22) / 22
    return stroke


#: What happens after calibration, and the signal before noise is added.
CASES: dict[str, Callable[[], Signal]] = {
    "nothing": _stroke,
    "all readings shift by 10 % of the stroke": lambda: _stroke() + 0.1 * _LATER,
    "all readings shift by 1 %": lambda: _stroke() + 0.01 * _LATER,
    "all readings shift by 0.3 %, a twentieth of a bin": lambda: _stroke() + 0.003 * _LATER,
    "all readings drift slowly, by 20 % in the end": lambda: (
        _stroke() + 0.2 * np.clip((_INDEX - HALF) / HALF, 0, 1)
    ),
    "the stroke becomes 1.3 times as long, and the sensor clips at 1": lambda: np.minimum(
        _stroke() * np.where(_LATER, 1.3, 1), 1
    ),
    "20 readings in a row are far too high, once": lambda: (
        _stroke() + 2 * ((_INDEX >= HALF + 3000) & (_INDEX < HALF + 3020))
    ),
    "a new product with 0.4 of the stroke runs": lambda: _stroke() * np.where(_LATER, 0.4, 1),
    "of three products only the first is still made": lambda: (
        _stroke() * np.where(_LATER, 1.0, _PRODUCTS)
    ),
    "the machine stops for good; in calibration it stood a tenth of the time": lambda: np.where(
        _LATER | _STANDING, 0.5, _stroke()
    ),
    "the signal loses its phase to another signal of the machine": lambda: _stroke(11, 22),
    "a shift of 30 %, already present in 5 % of calibration": lambda: (
        _stroke() + 0.3 * (_LATER | _FAULTY)
    ),
    "every other reading is missing": lambda: np.where(
        _LATER & (_INDEX % 2 == 0), np.nan, _stroke() + 0.3 * _LATER
    ),
    "a signal that never moved begins to move": lambda: np.where(_LATER, _stroke(), np.nan),
}


def measured() -> str:
    """Return the table: a line for each case."""
    chance = np.random.default_rng(5)
    signals = [case() + chance.normal(0, 0.01, SAMPLES) for case in CASES.values()]
    signals[-1][:HALF] = 0.5
    table = pa.table(
        {
            "machine": np.repeat(list(CASES), SAMPLES),
            "time": np.tile(_INDEX, len(CASES)),
            "value": np.concatenate(signals),
        }
    )
    source = gam_db.Source(table, asset="machine", channel=None, time="time", value="value")
    channels = {row["asset"]: row for row in gam_db.summary(source, PARAMETERS, CALIBRATION).channels}
    health = gam_db.health_indicator(source, PARAMETERS, CALIBRATION).to_pylist()
    raised = {row["asset"] for row in gam_db.episodes(source, PARAMETERS, CALIBRATION).to_pylist()}
    lines = []
    for name in CASES:
        channel = channels[name]
        shares = [row["hi"] for row in health if row["asset"] == name and row["hi"] is not None]
        highest = f"{max(shares):.3f}" if shares else ""
        last = f"{shares[-1]:.3f}" if shares else "not scored"
        limit = channel["hi_limit"]
        verdict = channel["verdict"] + (f", limit {limit:.2f}" if (limit or 0) > 0.05 else "")
        alarm = "**yes**" if name in raised else "no"
        lines.append(f"| {name} | {verdict} | {last} | {highest} | {alarm} |\n")
    return "".join(lines)


if __name__ == "__main__":
    print(measured(), end="")
