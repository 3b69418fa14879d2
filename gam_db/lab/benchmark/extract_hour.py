"""The extract script of an hour: what an engineer writes who keeps buckets outside the database.

It reads where the buckets end, the support and the rows from the lookback on, counts with NumPy, and
writes the new buckets and novel cells. As :mod:`gam_db.lab.benchmark.extract`, it shares no code with
the method's SQL, takes for granted that no reading is missing and no instant occurs twice, and has
nobody beside it.
"""

from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.composing import template
from gam_db.lab.benchmark.database import statement
from gam_db.lab.benchmark.extract import BINS, RADIX, STRIDE, WINDOW, _novel_cells

SPAN = WINDOW // STRIDE


def run(connection: duckdb.DuckDBPyConnection, lookback: int) -> dict[str, int]:
    """Bring the buckets of a state up to date, in tables of its own; return what was written.

    Args:
        connection: on the state, with the telemetry beside it.
        lookback: microseconds behind the newest bucket from which on rows are read again; 0 for none.
    """
    versions = connection.execute(statement("hour_versions", {"lookback": lookback})).fetchall()
    window: dict[str, template.Slot] = {"lookback": lookback, "buckets": SPAN}
    past = connection.execute(statement("hour_past", window)).fetchnumpy()
    support = connection.execute(statement("hour_support")).fetchnumpy()
    since: dict[str, template.Slot] = {"earliest": min(row[7] for row in versions)}
    rows = connection.sql(statement("hour_readings", since)).to_arrow_table()
    times, values = rows["t"].to_numpy(), rows["value"].to_numpy()
    places, end = {}, 0
    for asset, channel, count in connection.execute(statement("hour_lengths", since)).fetchall():
        places[asset, channel] = slice(end, end + count)
        end += count
    in_support = np.zeros(RADIX**3, bool)
    buckets, cells = [], []
    for version, asset, channel, support_id, lo, hi, first, context, last in versions:
        mine = places[asset, channel]
        time, value = times[mine], values[mine]
        time, value = time[time >= context], value[time >= context]
        codes = np.minimum(((value - lo) / (hi - lo) * BINS).astype(np.int32), BINS - 1) + np.int32(2)
        codes[value < lo] = 1
        codes[value > hi] = BINS + 2
        keys = codes[2:] + RADIX * codes[1:-1] + RADIX**2 * codes[:-2]
        strange = (codes == 1) | (codes == BINS + 2)
        strange = strange[2:] | strange[1:-1] | strange[:-2]
        new = time[2:] > last
        full = int(new.sum()) // STRIDE * STRIDE
        time, keys, strange = time[2:][new][:full], keys[new][:full], strange[new][:full]
        mine = _of(support["support_id"], support_id)
        in_support[support["cell_key"][mine]] = True
        novel = ~in_support[keys]
        in_support[support["cell_key"][mine]] = False
        before = past["novel"][_of(past["version_id"], version)]
        buckets.append(_buckets(version, first, time, novel, strange, before))
        novel_cells = _novel_cells(time, novel, keys)
        novel_cells["bucket_no"] = novel_cells["bucket_no"] + first
        cells.append(
            pa.table({"version_id": np.full(len(novel_cells["visits"]), version), **novel_cells})
        )
    bucket_table, strangers = pa.concat_tables(buckets), pa.concat_tables(cells)
    connection.begin()
    connection.from_arrow(bucket_table).create("extract_bucket")
    connection.from_arrow(strangers).create("extract_novel")
    connection.commit()
    return {"new_buckets": bucket_table.num_rows, "new_cells": strangers.num_rows}


def _of(keys: NDArray[np.int64], key: int) -> slice:
    """Return where one key stands in a sorted column."""
    return slice(int(np.searchsorted(keys, key)), int(np.searchsorted(keys, key, "right")))


def _buckets(
    version: int, first: int, time: Any, novel: Any, strange: Any, before: NDArray[np.int64]
) -> pa.Table:
    """Return the rows of new buckets; *before* are the novel vectors of the window before them."""
    counts = novel.reshape(-1, STRIDE).sum(axis=1, dtype=np.int64)
    so_far = np.concatenate(([0], np.cumsum(np.concatenate((before, counts)))))
    places = np.arange(len(before) + 1, len(so_far))
    return pa.table(
        {
            "version_id": np.full(len(counts), version),
            "bucket_no": np.arange(first, first + len(counts)),
            "first_time": time[::STRIDE],
            "last_time": time[STRIDE - 1 :: STRIDE],
            "novel": counts,
            "out_of_range": strange.reshape(-1, STRIDE).sum(axis=1, dtype=np.int64),
            "novel_in_window": so_far[places] - so_far[np.maximum(places - SPAN, 0)],
        }
    )
