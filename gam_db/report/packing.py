"""What the page gets: columns of numbers as text, the strip of each signal, which states are new.

Columns are deflated and base64, the same bytes for the same numbers; ``page/src/data.js`` reads them. A
strip is the course of a signal in a fixed number of columns, one byte each, which ``page/src/colour.js``
reads. 0: nothing known; 1: calibration; 2: a pause; 3 to 127: at or below the limit, 127 at it; 128 to
255: above it, 255 where all states are new. A signal without a limit has 3 to 127 for 0 to 1.
"""

import base64
import json
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Whole numbers up to here are themselves in a double.
EXACT = 2**53

NOTHING, CALIBRATION, PAUSE, LOWEST, AT_LIMIT, ABOVE, HIGHEST = 0, 1, 2, 3, 127, 128, 255


def packed(values: ArrayLike, kind: str) -> str:
    """Return an array as bytes of a kind (``u1``, ``u4``, ``f4``, ``f8``), little-endian, deflated."""
    array = np.ascontiguousarray(np.asarray(values).astype(np.dtype(kind).newbyteorder("<")))
    return base64.b64encode(zlib.compress(array.tobytes(), 9)).decode()


def ticks(values: ArrayLike) -> str:
    """Return times (integers) as steps from one to the next; the first is the time itself.

    They come back exact up to 2^53, since every partial sum is a time.
    """
    array = np.asarray(values, dtype=np.int64)
    return packed(np.diff(array, prepend=np.int64(0)), "f8")


def tick(value: int | None) -> int | str | None:
    """Return a time for JSON: as text where a double would round it."""
    return value if value is None or abs(value) <= EXACT else str(value)


def short(value: float | None) -> float | None:
    """Return a share or a reading in six digits; None where there is none."""
    return None if value is None or not np.isfinite(value) else float(f"{value:.6g}")


def in_script(data: Any) -> str:
    """Return JSON that may stand inside a ``script`` element: no sign in it ends or opens one."""
    text = json.dumps(data, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def counts(values: NDArray[Any]) -> str:
    """Return counts, cut where 32 bits end."""
    return packed(np.minimum(values, 2**32 - 1), "u4")


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

    Spans are first time, last time and indicator of each bucket, in order, NaN before a full window; the
    frame is the first and last instant of the strip, and its columns.
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
        finite = np.isfinite(hi)
        lengths = right - left + 1
        which = np.repeat(np.arange(len(left)), lengths)
        place = np.arange(lengths.sum()) - np.repeat(np.cumsum(lengths) - lengths, lengths) + left[which]
        covered[place] = True
        bytes_of = np.where(finite, coded(np.where(finite, hi, 0), limit), 0)
        np.maximum.at(value, place, bytes_of[which].astype(np.uint8))
        row[value > 0] = value[value > 0]
        inside = slice(left.min(), right.max() + 1)
        row[inside][~covered[inside] & (row[inside] == NOTHING)] = PAUSE
    return row


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
    time: NDArray[Any],
    values: NDArray[Any],
    signal: Mapping[str, Any],
    healthy: NDArray[Any],
    programs: NDArray[np.int64] | None = None,
) -> NDArray[np.bool_]:
    """Tell which readings of a piece end in a state that is in no healthy cell; not where none ends.

    Readings come in order, without one left out between them, NaN where missing; ``healthy`` holds the
    keys of the support, and programs the number of the program of each reading, -1 of one that is not
    judged.
    """
    bins, m, tau = signal["bins"], signal["m"], signal["tau"]
    code = codes(values, signal["calibrated_lo"], signal["calibrated_hi"], bins)
    span, count = (m - 1) * tau, len(values)
    new = np.zeros(count, bool)
    if count <= span:
        return new
    key, whole = np.zeros(count - span, np.int64), np.ones(count - span, bool)
    for axis in range(m):
        there = slice(span - axis * tau, count - axis * tau)
        key += code[there] * (bins + 3) ** axis
        whole &= ~np.isnan(values[there])
    if programs is not None:
        key += programs[span:] * signal["program_weight"]
        whole &= programs[span:] >= 0
    new[span:] = whole & ~np.isin(key, healthy)
    if signal["max_gap"] is not None:
        segment = np.cumsum(np.diff(time, prepend=time[:1]) > signal["max_gap"])
        new[span:] &= segment[span:] == segment[: count - span]
    return new
