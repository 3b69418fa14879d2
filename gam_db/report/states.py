"""Which readings of a piece end in a state never seen in health (method, sections 2 and 3)."""

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


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
