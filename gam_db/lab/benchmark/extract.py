"""The extract script: what an engineer writes who takes the telemetry out of the database.

It shares no code with the method's SQL. It may take for granted what gam-db has to find out: no
reading is missing, no instant occurs twice, no range is empty.
"""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.lab.benchmark.database import opened, statement

BINS = 100
WINDOW = 5000  # vectors
STRIDE = 100  # vectors
CALIBRATION = 0.2  # share of the samples

RADIX = BINS + 3

Columns = dict[str, NDArray[Any]]


def run(source: Path, result: Path, threads: int) -> None:
    """Fetch in order, count with NumPy, write both tables into another DuckDB file."""
    with opened(source, threads, read_only=True) as connection:
        channels = connection.execute(statement("extract_lengths")).fetchall()
        readings: pa.Table = connection.sql(statement("extract_readings")).to_arrow_table()
    ends = np.cumsum([length for _, _, length in channels])
    pieces = [
        readings.slice(end - length, length) for end, (_, _, length) in zip(ends, channels, strict=True)
    ]
    # NumPy lets go of the interpreter while it counts, so that channels run side by side.
    with ThreadPoolExecutor(threads) as pool:
        results = list(pool.map(counted, pieces))
    buckets: list[pa.Table] = []
    cells: list[pa.Table] = []
    for channel_id, ((asset, channel, _), (of_buckets, of_cells)) in enumerate(
        zip(channels, results, strict=True), start=1
    ):
        rows = len(of_buckets["bucket"])
        not_full = of_buckets["bucket"] < WINDOW // STRIDE - 1
        buckets.append(
            pa.table(
                {
                    "asset": pa.repeat(pa.scalar(asset, pa.string()), rows),
                    "channel": pa.repeat(pa.scalar(channel, pa.string()), rows),
                    **of_buckets,
                    "novel_in_window": pa.array(of_buckets["novel_in_window"], mask=not_full),
                    "hi": pa.array(of_buckets["hi"], mask=not_full),
                }
            )
        )
        ids = np.full(len(of_cells["cell_key"]), channel_id, np.int32)
        cells.append(pa.table({"channel_id": ids, **of_cells}))
    with opened(result, threads) as connection:
        connection.from_arrow(pa.concat_tables(buckets)).create("bucket_health")
        connection.from_arrow(pa.concat_tables(cells)).create("novel_cells")


def counted(readings: pa.Table) -> tuple[Columns, Columns]:
    """Return buckets and novel cells of one channel."""
    times = readings.column("t").to_numpy()
    values = readings.column("value").to_numpy()
    calibration = int(np.floor(CALIBRATION * len(values)))
    codes = _codes(values, calibration)
    newest, middle, oldest = codes[2:], codes[1:-1], codes[:-2]
    keys = newest + RADIX * middle + RADIX**2 * oldest
    strange = (codes == 1) | (codes == BINS + 2)
    strange = strange[2:] | strange[1:-1] | strange[:-2]

    # The first vector ends at the third sample; only full buckets count.
    learnt = max(calibration - 2, 0)
    full = (len(keys) - learnt) // STRIDE * STRIDE
    scored = slice(learnt, learnt + full)
    # A table of all cells is faster than np.isin.
    support = np.zeros(RADIX**3, bool)
    support[keys[:learnt]] = True
    novel = ~support[keys[scored]]
    times = times[2:][scored]
    return _buckets(times, novel, strange[scored]), _novel_cells(times, novel, keys[scored])


def _codes(values: NDArray[np.float64], calibration: int) -> NDArray[np.int32]:
    healthy = values[:calibration]
    lo, hi = healthy.min(), healthy.max()
    codes = ((values - lo) / (hi - lo) * BINS).astype(np.int32)
    codes = np.minimum(codes, BINS - 1) + np.int32(2)
    codes[values < lo] = 1
    codes[values > hi] = BINS + 2
    return np.asarray(codes)


def _buckets(times: NDArray[np.int64], novel: NDArray[np.bool_], strange: NDArray[np.bool_]) -> Columns:
    counts = novel.reshape(-1, STRIDE).sum(axis=1, dtype=np.int64)
    so_far = np.concatenate(([0], np.cumsum(counts)))
    span = WINDOW // STRIDE
    in_window = np.zeros(len(counts), np.int64)  # the first ones are left out when written
    in_window[span - 1 :] = so_far[span:] - so_far[:-span]
    return {
        "bucket": np.arange(len(counts)),
        "first_time": times[::STRIDE],
        "last_time": times[STRIDE - 1 :: STRIDE],
        "novel": counts,
        "out_of_range": strange.reshape(-1, STRIDE).sum(axis=1, dtype=np.int64),
        "novel_in_window": in_window,
        "hi": in_window / WINDOW,
    }


def _novel_cells(times: NDArray[np.int64], novel: NDArray[np.bool_], keys: NDArray[np.int32]) -> Columns:
    novel_places = np.flatnonzero(novel)
    buckets = novel_places // STRIDE
    both = buckets * RADIX**3 + keys[novel_places]
    order = np.argsort(both, kind="stable")
    both = both[order]
    starts = np.flatnonzero(np.diff(both, prepend=-1))
    ends = np.append(starts, len(both))[1:]
    firsts = novel_places[order[starts]]
    return {
        "bucket_no": buckets[order[starts]],
        "cell_key": keys[firsts].astype(np.int64),
        "visits": ends - starts,
        "first_time": times[firsts],
        "last_time": times[novel_places[order[ends - 1]]],
    }
