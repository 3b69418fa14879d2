"""The paired bootstrap over the joints that failed, against a calculation one resample at a time."""

import itertools
import math
from statistics import fmean, pstdev
from typing import Any

import numpy as np
import pytest

from gam_db.lab.reproduce import bootstrap

ROWS: list[dict[str, Any]] = [
    {"outcome": "failed", "mon": 0.9, "corr": 0.8, "rob": 0.9, "last_hi": 0.5, "amplitude": 0.4},
    {"outcome": "failed", "mon": 0.3, "corr": 0.2, "rob": 0.7, "last_hi": 0.1, "amplitude": 0.1},
    {"outcome": "failed", "mon": 0.6, "corr": None, "rob": 0.8, "last_hi": 0.3, "amplitude": 0.2},
    {"outcome": "healthy", "mon": 0.1, "corr": 0.1, "rob": 0.5, "last_hi": 0.1, "hi_sd": 0.02},
    {"outcome": "healthy", "mon": 0.1, "corr": 0.1, "rob": 0.5, "last_hi": 0.1, "hi_sd": 0.04},
]


def test_resamples_are_all_there_are() -> None:
    found = bootstrap.resampled(ROWS)
    expected = []
    for drawn in itertools.product(ROWS[:3], repeat=3):
        means = [fmean(row[name] for row in drawn) for name in ("mon", "rob", "amplitude")]
        known = [row["corr"] for row in drawn if row["corr"] is not None]
        five = [
            means[0],
            fmean(known) if known else math.nan,
            means[1],
            math.exp(-pstdev(row["last_hi"] for row in drawn) / means[2]),
            1 / (1 + 0.03 / means[2]),
        ]
        expected.append([*five, fmean(one for one in five if not math.isnan(one))])
    assert len(expected) == 27
    values = np.column_stack([found[metric] for metric in bootstrap.METRICS])
    assert np.allclose(values, expected, rtol=1e-12, equal_nan=True)


def test_methods_are_compared_on_the_same_resamples() -> None:
    worse = [row | {"mon": (row["mon"] or 0) - 0.25} for row in ROWS]
    found = bootstrap.paired([{"one": ROWS, "other": worse}])
    assert found.resamples == 27
    assert found.best["mon"] == {"one": 1.0, "other": 0.0}
    assert found.best["prog"] == {"one": 0.5, "other": 0.5}, "a tie is shared"
    assert found.differences["mon"]["other"] == pytest.approx((0.25, 0.25))
    assert found.differences["global"]["other"] == pytest.approx((0.05, 0.054375), abs=1e-9), (
        "in one of 27 resamples no joint has Corr; between the last two values 0.35 of the way"
    )
