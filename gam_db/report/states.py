"""States: cells as codes on their axes, the nearest healthy one of each, and which readings are new.

This module owns how a stored key is read back (method, sections 2 and 3).
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

#: New cells that are compared at once with all healthy ones.
_AT_ONCE = 256


def axes_of(keys: NDArray[Any], bins: int, m: int) -> NDArray[np.int64]:
    """Return the codes of cells, one row per axis; the first axis is the newest coordinate."""
    rest, axes = np.asarray(keys, dtype=np.int64), []
    for _ in range(m):
        axes.append(rest % (bins + 3))
        rest = rest // (bins + 3)
    return np.array(axes, dtype=np.int64).reshape(m, len(keys))


def distances(new: NDArray[np.int64], healthy: NDArray[np.int64]) -> NDArray[np.int64]:
    """Return how far the nearest healthy cell is: the largest step on any axis; -1 for none."""
    if not healthy.shape[1]:
        return np.full(new.shape[1], -1)
    away = []
    for start in range(0, new.shape[1], _AT_ONCE):
        some = new[:, start : start + _AT_ONCE]
        away.append(np.abs(some[:, :, None] - healthy[:, None, :]).max(axis=0).min(axis=1))
    return np.concatenate(away) if away else np.zeros(0, np.int64)


def codes(values: NDArray[Any], low: float | None, high: float | None, bins: int) -> NDArray[np.int64]:
    """Return the code of each reading, NaN where missing: ``sql/support/code.sql`` in NumPy."""
    if low is None or high is None:
        return np.where(np.isnan(values), 0, 1).astype(np.int64)
    with np.errstate(invalid="ignore", divide="ignore"):
        place = np.floor((values - low) / (high - low) * bins) if high > low else np.zeros(len(values))
    code = np.where(place >= bins, bins + 1, 2 + place)
    code = np.where(values < low, 1, np.where(values > high, bins + 2, code))
    return np.where(np.isnan(values), 0, code).astype(np.int64)


def are_new(
    time: NDArray[Any], values: NDArray[Any], signal: Mapping[str, Any], healthy: NDArray[Any]
) -> NDArray[np.bool_]:
    """Tell which readings of a piece end in a state that is in no healthy cell.

    Args:
        time: of readings, in order and without one left out between them.
        values: of the readings, NaN where missing.
        signal: bins, m, tau, max_gap, calibrated_lo and calibrated_hi.
        healthy: keys of the support.

    Returns:
        One flag per reading; False where no whole vector ends.
    """
    bins, m, tau = signal["bins"], signal["m"], signal["tau"]
    code = codes(values, signal["calibrated_lo"], signal["calibrated_hi"], bins)
    span, count = (m - 1) * tau, len(values)
    new = np.zeros(count, bool)
    if count <= span:
        return new
    key = np.zeros(count - span, np.int64)
    for axis in range(m):
        start = span - axis * tau
        key += code[start : start + count - span] * (bins + 3) ** axis
    new[span:] = ~np.isin(key, healthy)
    whole = ~np.isnan(values)
    for axis in range(m):
        new[span:] &= whole[span - axis * tau : count - axis * tau]
    if signal["max_gap"] is not None:
        segment = np.cumsum(np.diff(time, prepend=time[:1]) > signal["max_gap"])
        new[span:] &= segment[span:] == segment[: count - span]
    return new
