"""Sizes and values: a right answer or a remedy."""

import datetime as dt
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import gam_db
import harness
from gam_db import Override, Parameters, Source
from gam_db.errors import ParameterError
from harness import Row
from odd import HALF, ROWS, SMALL, VALUES, agreed, refused, table


def series(*values: float | None) -> list[tuple[int, float | None]]:
    return list(enumerate(values))


PLAIN = series(*VALUES)
NAN, INF = math.nan, math.inf
ODD: dict[str, list[tuple[int, float | None]]] = {
    "one sample": PLAIN[:1],
    "two samples": PLAIN[:2],
    "all missing": series(*[None] * 9),
    "missing in every way": series(0.0, NAN, 1.0, INF, 2.0, None, 1.0, -INF, 1e301, 1.0, 2.0),
    "unordered": [PLAIN[i] for i in (7, 2, 9, 0, 4, 1, 8, 3, 6, 5)],
    "duplicated": PLAIN + PLAIN[3:7] + PLAIN,
    "conflicting": [*PLAIN, (2, 0.5), (7, None), (8, -9.0)],
    "duplicated at the end of calibration": [*PLAIN, (4, 0.25), *PLAIN[4:6]],
    "subnormal range": series(*(5e-324 * v for v in (0, 3, 1, 2, 3, 0, 1, 4, -1, 2))),
    "a range of one ulp": series(*(1.0 + 2.0**-52 * v for v in (0, 1, 0, 1, 0, 1, 1, 2, -1, 0))),
    "up to 1e300": series(*(v * 1e300 for v in (-1, 1, 0, 0.5, -0.5, 0.99, -1, 1, 0.25, 0))),
    "negative zero": series(-0.0, 1.0, 0.0, 1.0, -0.0, 0.0, -0.0, 1.0, -1e-320, -0.0),
    "nothing but zeros": series(-0.0, 0.0, -0.0, 0.0, -0.0, 0.0, -0.0, 1.0),
    "constant": series(*[3.0] * 9),
    "before and after": [(t - 1000, v) for t, v in PLAIN[:7]] + [(t + 10**12, v) for t, v in PLAIN[7:]],
}


@pytest.mark.parametrize("m", [1, 2])
def test_odd_series_are_answered_as_the_reference_does(m: int) -> None:
    """Each is an asset of one source: none may spoil the others either."""
    rows = [(name, "x", time, value) for name, pairs in ODD.items() for time, value in pairs]
    parameters = Parameters(m=m, bins=4, window=2)
    assert len(harness.by_reference("support", rows, parameters, HALF)) == len(ODD)
    agreed(rows, parameters)


@pytest.mark.parametrize(
    ("rows", "parameters"),
    [
        (ROWS, Parameters(m=3, tau=2, bins=4, window=8)),  # fewer than (m-1) tau + W samples
        (ROWS[:4], Parameters(m=3, tau=2, bins=4, window=1)),  # no vector at all
        (ROWS[:5], Parameters(m=3, tau=2, bins=4, window=1)),  # a single one
        (ROWS, Parameters(m=20, bins=5, window=1)),  # the largest key
        (ROWS, Parameters(m=2, bins=2**31, window=1)),
        (
            [("a", "x", t * (2**62 - 1) // 4, float(t % 3)) for t in range(-4, 5)],  # all of the clock
            Parameters(m=2, bins=4, window=1, max_gap=2**60),
        ),
    ],
)
def test_extreme_sizes(rows: list[Row], parameters: Parameters) -> None:
    agreed(rows, parameters)


@pytest.mark.parametrize(
    "call", [gam_db.health_indicator, gam_db.health_at_buckets, gam_db.support, gam_db.certificate]
)
def test_an_empty_source_is_refused(call: Callable[..., object]) -> None:
    empty = Source(table().slice(0, 0))
    refused("has no row", lambda: call(empty, SMALL, HALF))
    refused(r"no row \(after where", lambda: call(Source(table(), where="value > 99"), SMALL, HALF))


@pytest.mark.parametrize(
    ("bins", "m", "fitting"),
    [
        (100, 10, 9),
        (2**31, 3, 2),
        (2**21 - 3, 3, 2),  # R^3 is 2^63 exactly, one too many
        (5, 21, 20),  # R^21 is 2^63, too
        (1, 64, 31),
        (1, 10**6, 31),
    ],
)
def test_too_many_cells_are_refused_with_the_largest_m(bins: int, m: int, fitting: int) -> None:
    refused(f"use m <= {fitting}, or fewer bins", lambda: Parameters(bins=bins, m=m), ParameterError)
    assert Parameters(bins=bins, m=fitting).radix ** fitting < 2**63


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"m": 0}, "m is 0; it must be at least 1"),
        ({"tau": -3}, "tau is -3; it must be at least 1"),
        ({"m": 1.5}, "m is 1.5; it must be an integer"),
        ({"window": "5000"}, "window is '5000'; it takes an integer, or 'auto'"),
        ({"bins": True}, "bins is True; it must be an integer"),
        ({"bins": 2**31 + 1}, "must not exceed 2,147,483,648"),
        ({"m": 3, "tau": 2**30}, r"stay below 2\^31 samples"),
        ({"window": 2**31}, r"stay below 2\^31 samples"),
        ({"stride": 7}, "stride is 7, which does not divide window = 5000"),
        ({"stride": 0}, "stride is 0; it must be at least 1"),
        ({"max_gap": 0}, "max_gap is 0; it must be positive, or None"),
        ({"max_gap": -1.0}, "max_gap is -1.0; it must be positive"),
        ({"max_gap": math.nan}, "max_gap is nan; it must be positive"),
        ({"max_gap": "0 s"}, "max_gap is '0 s'; it must be positive"),
        ({"max_gap": dt.timedelta(0)}, "must be positive"),
        ({"max_gap": "five"}, "max_gap is 'five', which is not a length of time"),
        ({"max_gap": True}, "max_gap is True; give a number, a timedelta or a text"),
        ({"max_gap": [5]}, "give a number, a timedelta or a text"),
        ({"target_floor": 1.5}, "target_floor is 1.5; it must be a share"),
        ({"target_floor": math.nan}, "target_floor is nan; it must be a share"),
        ({"target_floor": "5 %"}, "it must be a share, 0 to 1, such as 0.05"),
        ({"overrides": Override(m=2)}, "it takes a list of gam_db.Override"),
        ({"overrides": [{"m": 2}]}, "overrides holds a dict"),
        ({"overrides": [Override(asset=5, m=2)]}, "asset of an override is 5"),  # type: ignore[arg-type]
        ({"overrides": [Override("a*", "y", m=0)]}, r"override for 'a\*' / 'y': m is 0"),
        ({"overrides": [Override(window=7, stride=2)]}, "does not divide window = 7"),
    ],
)
def test_parameters_out_of_range(arguments: dict[str, Any], message: str) -> None:
    refused(message, lambda: Parameters(**arguments), ParameterError)


def test_numpy_numbers_are_numbers() -> None:
    chosen = Parameters(m=np.int64(2), tau=np.int32(1), bins=np.uint8(4), window=np.int64(2))  # type: ignore[arg-type]
    assert chosen == SMALL
    assert Parameters(max_gap=np.float64(2.5)).max_gap == 2.5
    assert Parameters(max_gap=np.int64(2)).max_gap == 2  # type: ignore[arg-type]
    refused("must be positive", lambda: Parameters(max_gap=np.int64(0)), ParameterError)  # type: ignore[arg-type]
