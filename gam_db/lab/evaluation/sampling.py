"""Sampling: surrogates of random novelty, and drawings of assets; all of it from one seed.

This module owns what is random in an evaluation. The metrics of what it draws are computed by the same
SQL as those of the real series.
"""

import math
import zlib
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.lab.evaluation.conventions import Conventions
from gam_db.lab.evaluation.members import ASIDE, Member

_BATCH = 1_000_000
"""Values of surrogates that are computed at once."""

_VECTORS = 100
"""Vectors that stand behind one value of an indicator that is no count."""


@dataclass(frozen=True)
class Batch:
    """Surrogates of some series: the steps *selected* and *surrogates*."""

    selected: pa.Table
    surrogates: pa.Table


def no_chance(member: Member, k: int, novel_sum: int | None) -> str | None:
    """Return why a series has no chance level, or None if it has one."""
    if k < 2:
        return "one_value" if k else "no_values"
    if novel_sum is not None and (novel_sum == 0 or novel_sum == k * member.window):
        return "constant"
    if not member.values_per_window or (
        novel_sum is not None and member.window % member.values_per_window
    ):
        return "unknown_window"
    return None


def batches(rates: list[tuple[Member, int, int | None]], conventions: Conventions) -> Iterator[Batch]:
    """Draw the surrogates of series, a few series at a time.

    Args:
        rates: series with a chance level, with K and the sum of its counts (None if it has none).
        conventions: number of surrogates, and seed.
    """
    pending: list[tuple[int, NDArray[np.int64]]] = []
    size = 0
    for member, k, novel_sum in rates:
        drawn = surrogates(member, k, novel_sum, conventions)
        pending.append((member.series_id, drawn))
        size += drawn.size
        if size >= _BATCH:
            yield _batch(pending)
            pending, size = [], 0
    if pending:
        yield _batch(pending)


def surrogates(
    member: Member, k: int, novel_sum: int | None, conventions: Conventions
) -> NDArray[np.int64]:
    """Return the counts of random novelty over a window, a row per surrogate and K columns.

    Every vector is novel by chance, with the mean indicator of the real series as its rate; windows
    overlap as those of the series do. Where the indicator is no count the rate is one half: a mean over
    many independent scores looks much the same whatever they are.
    """
    name = zlib.crc32(f"{member.asset}\0{member.channel}".encode())
    generator = np.random.default_rng([conventions.seed, name])
    width = member.values_per_window
    vectors, rate = _VECTORS, 0.5
    if novel_sum is not None:
        vectors, rate = member.window // width, novel_sum / (k * member.window)
    novel = generator.binomial(vectors, rate, (conventions.surrogates, k + width - 1))
    so_far = np.cumsum(np.pad(novel, ((0, 0), (1, 0))), axis=1)
    return so_far[:, width:] - so_far[:, :-width]


def drawings(series: list[Member], conventions: Conventions) -> pa.Table:
    """Return the step *drawings*: how often each asset stands in each drawing, by stratum.

    Drawing 0 is the fleet as it is. Failed and healthy assets are drawn apart, as many as there are.
    """
    columns: list[NDArray[np.int64]] = []
    for stratum in sorted({member.stratum for member in series} - {ASIDE}):
        assets = np.array(sorted({member.asset_no for member in series if member.stratum == stratum}))
        generator = np.random.default_rng([conventions.seed, stratum])
        shares = np.full(len(assets), 1 / len(assets))
        weights = generator.multinomial(len(assets), shares, conventions.samples)
        weights = np.vstack([np.ones((1, len(assets)), np.int64), weights])
        drawing, place = np.nonzero(weights)
        columns.append(
            np.stack([drawing, np.full(len(drawing), stratum), assets[place], weights[drawing, place]])
        )
    names = ("drawing", "stratum", "asset_no", "weight")
    joined = np.concatenate(columns, axis=1) if columns else np.empty((4, 0), np.int64)
    return pa.table({name: joined[row].astype(np.int64) for row, name in enumerate(names)})


def units(largest_weight: int) -> int:
    """Return the power of two in which shares are counted, given the largest sum of weights."""
    return 1 << (61 - math.ceil(math.log2(max(largest_weight, 1))))


def largest_weight(series: list[Member]) -> int:
    """Return the most series that a drawing can hold: every asset the one with the most channels."""
    largest = 1
    for stratum in {member.stratum for member in series} - {ASIDE}:
        channels = Counter(member.asset_no for member in series if member.stratum == stratum)
        largest = max(largest, len(channels) * max(channels.values()))
    return largest


def _batch(pending: list[tuple[int, NDArray[np.int64]]]) -> Batch:
    numbers, places, counts, origins, stands_for = [], [], [], [], []
    number = 0
    for series_id, drawn in pending:
        many, k = drawn.shape
        origins.append(np.arange(number, number + many))
        stands_for.append(np.full(many, series_id))
        numbers.append(np.repeat(origins[-1], k))
        places.append(np.tile(np.arange(k), many))
        counts.append(drawn.ravel())
        number += many
    count = np.concatenate(counts)
    return Batch(
        pa.table(
            {
                "series_id": np.concatenate(numbers),
                "steps": np.ones(len(count), np.int64),
                "place": np.concatenate(places),
                "hi": count.astype(np.float64),
                "novel_in_window": count,
            }
        ),
        pa.table({"series_id": np.concatenate(origins), "stands_for": np.concatenate(stands_for)}),
    )
