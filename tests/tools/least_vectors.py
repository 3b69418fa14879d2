"""Measure how many calibration vectors a promise takes.

    python tests/tools/least_vectors.py FLEET.parquet FOLDER

A channel that its first n vectors call `ready` was promised that healthy data stays near the floor.
Printed is, by n, how many were called so, and of how many of them the healthy vectors that follow (as
many as calibration has, 1,000 at least) are beyond the limit all the same: in NumPy, on the first 30 %
of each series of a simulated fleet (`gam simulate fleet`) and of the recordings in FOLDER, for m = 3.
"""

import sys
from collections.abc import Iterator
from pathlib import Path

import duckdb
import numpy as np
from numpy.typing import NDArray

COUNTS = (25, 50, 100, 200, 300, 400, 600, 800, 1200, 1600, 3200)
GRIDS = (8, 16, 32)
TARGET, HEALTHY = 0.05, 0.3


def series(path: Path) -> Iterator[NDArray[np.float64]]:
    """Yield the healthy part of each channel of a file in long form, missing values left out."""
    rows = duckdb.read_parquet(str(path))
    time = "ts" if "ts" in rows.columns else "time" if "time" in rows.columns else "t"
    for name in rows.select("asset, channel").distinct().order("ALL").fetchall():
        same = rows.filter("asset = '{}' AND channel = '{}'".format(*name)).order(time)
        found = same.select("CAST(value AS DOUBLE) AS value").fetchnumpy()["value"]
        values = np.ma.filled(found, np.nan)[: int(HEALTHY * len(found))]
        yield values[np.isfinite(values)]


def judged(values: NDArray[np.float64], count: int, bins: int) -> tuple[float, float] | None:
    """Return the limit of *count* vectors, and the share of novel ones next; None if not ready."""
    taught, after = values[: count + 2], values[: count + max(count, 1000) + 2]
    low, high = taught.min(), taught.max()
    if high == low or len(after) < count + max(count, 1000) + 2:
        return None
    codes = np.minimum((after - low) / (high - low) * bins, bins - 1).astype(int) + 2
    codes[(after < low) | (after > high)] = 0
    keys = codes[2:] + codes[1:-1] * (bins + 3) + codes[:-2] * (bins + 3) ** 2
    _, cells = np.unique(keys[:count], return_inverse=True)
    blocks = 8 * np.arange(count) // count
    first, last = np.full(cells.max() + 1, 8), np.full(cells.max() + 1, -1)
    np.minimum.at(first, cells, blocks)
    np.maximum.at(last, cells, blocks)
    shares = np.bincount(blocks[(first == last)[cells]], minlength=8) / np.bincount(blocks)
    outside = (codes[2:] == 0) | (codes[1:-1] == 0) | (codes[:-2] == 0)
    novel = (~np.isin(keys, keys[:count]) | outside)[count:].mean()
    limit = max(2 * shares.mean(), shares.max(), TARGET)
    return (limit, novel) if shares.mean() <= TARGET else None


def main(fleet: str, folder: str) -> None:
    """Print the table."""
    for path in (Path(fleet), *sorted(Path(folder).glob("*/series.parquet"))):
        channels = list(series(path))
        print(f"\n{path.parent.name}/{path.name}: {len(channels)} channels")
        print("  vectors   ready   beyond their limit   novel later: median, upper tenth")
        for count in COUNTS:
            found = [judged(one, count, bins) for one in channels for bins in GRIDS if len(one) > count]
            ready = [one for one in found if one is not None]
            if ready:
                later = np.array([novel for _, novel in ready])
                wrong = np.mean([novel > limit for limit, novel in ready])
                middle, upper = np.quantile(later, (0.5, 0.9))
                print(f"  {count:7,} {len(ready):7,} {wrong:20.0%} {middle:16.3f} {upper:10.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
