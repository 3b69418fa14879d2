"""Columns of numbers as text: deflated and base64, the same bytes for the same numbers.

This module owns the form in which the page gets its columns; ``page/src/data.js`` reads it.
"""

import base64
import json
import zlib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Whole numbers up to here are themselves in a double.
EXACT = 2**53


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
