"""Strips: the course of each signal in a fixed number of columns, one byte each.

This module owns the code of a byte; ``page/src/colour.js`` reads it. 0: nothing known; 1: calibration;
2: a pause; 3 to 127: at or below the limit, 127 at it; 128 to 255: above it, 255 where all states are
new. A signal without a limit has 3 to 127 for 0 to 1.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

NOTHING, CALIBRATION, PAUSE, LOWEST, AT_LIMIT, ABOVE, HIGHEST = 0, 1, 2, 3, 127, 128, 255


def coded(hi: NDArray[Any], limit: float | None) -> NDArray[np.uint8]:
    """Return the byte of each indicator; above 127 if and only if it is above its limit."""
    reach = 1.0 if limit is None else limit
    low = LOWEST + np.floor(np.clip(hi / max(reach, 1e-12), 0, 1) * (AT_LIMIT - LOWEST))
    high = ABOVE + np.floor(np.clip((hi - reach) / max(1 - reach, 1e-12), 0, 1) * (HIGHEST - ABOVE))
    above = np.zeros(len(hi), bool) if limit is None else hi > limit
    return np.where(above, high, low).astype(np.uint8)


def column_of(time: NDArray[Any], first: int, last: int, columns: int) -> NDArray[np.int64]:
    """Return the column of each time; columns are equally long and hold all from first to last."""
    place = (np.asarray(time, dtype=np.float64) - first) / max(last - first, 1) * columns
    return np.clip(np.floor(place), 0, columns - 1).astype(np.int64)


def strip(
    spans: tuple[NDArray[Any], NDArray[Any], NDArray[Any]],
    limit: float | None,
    calibration: tuple[int, int] | None,
    frame: tuple[int, int, int],
) -> NDArray[np.uint8]:
    """Return the strip of one signal: in each column the highest of the buckets that lie in it.

    Args:
        spans: first time, last time and indicator of each bucket, in order; NaN before a full window.
        limit: of the indicator; None without one.
        calibration: its first and last instant; None without.
        frame: first and last instant of the strip, and its columns.
    """
    first, last, columns = frame
    row = np.zeros(columns, np.uint8)
    if calibration is not None:
        start, end = column_of(np.array(calibration), first, last, columns)
        if calibration[1] >= first:
            row[start : end + 1] = CALIBRATION
    begins, ends, hi = spans
    if len(begins):
        left = column_of(begins, first, last, columns)
        right = column_of(ends, first, last, columns)
        covered, value = np.zeros(columns, bool), np.zeros(columns, np.uint8)
        # A bucket goes on over a pause: of one that takes long only the two ends are known.
        taken = np.asarray(ends, np.float64) - np.asarray(begins, np.float64)
        paused = taken > 3 * max(float(np.median(taken)), 1.0)
        left, right = np.r_[left, right[paused]], np.r_[np.where(paused, left, right), right[paused]]
        hi = np.r_[hi, hi[paused]]
        known = np.isfinite(hi)
        lengths = right - left + 1
        which = np.repeat(np.arange(len(left)), lengths)
        place = np.arange(lengths.sum()) - np.repeat(np.cumsum(lengths) - lengths, lengths) + left[which]
        covered[place] = True
        bytes_of = np.where(known, coded(np.where(known, hi, 0), limit), 0)
        np.maximum.at(value, place, bytes_of[which].astype(np.uint8))
        row[value > 0] = value[value > 0]
        inside = slice(left.min(), right.max() + 1)
        row[inside][~covered[inside] & (row[inside] == NOTHING)] = PAUSE
    return row
