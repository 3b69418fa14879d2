"""The simulated machine: its equations step by step, and the numbers its specification prints."""

import math

import numpy as np
import pyarrow as pa
import pytest

import gam_db
from gam_db import langevin
from gam_db.errors import ParameterError

STEP, NOISE, GAIN, DWELL = 0.03, 0.06, 4.0, 116
CENTRES, DRIFTS, ORDER = (-2, -1, 0, 1, 2), (0.25, 0.25, 0, 0, 0), (0, 2, 4, 1, 3)


def wear(t: int, samples: int) -> float:
    last = samples - 1
    return 0.0 if t <= 0.4 * last else (t / last - 0.4) / 0.6


def drift_of(x: float, t: int, samples: int) -> float:
    """The force at a step, written from the equations."""
    worn = wear(t, samples)
    visited = ORDER[math.floor(t / DWELL) % 5]
    target = CENTRES[visited] - worn * DRIFTS[visited]
    wells = ((c + worn * d) for c, d in zip(CENTRES, DRIFTS, strict=True))
    return GAIN * (target - x) + sum(-3 * (x - c) * math.exp(-((x - c) ** 2) / 0.5) for c in wells)


@pytest.mark.parametrize("samples", [2, 581, 20_000])
def test_each_step_follows_the_equations(samples: int) -> None:
    """What a step adds beyond its force is the generator's noise, in order."""
    x = langevin.simulate(seed=3, samples=samples)
    z = np.random.default_rng(3).standard_normal(samples)
    assert len(x) == samples
    assert x[0] == -2
    for t in {0, *(min(samples - 2, place) for place in (samples // 3, samples // 2, samples))}:
        noise = (x[t + 1] - x[t] - drift_of(x[t], t, samples) * STEP) / (NOISE * math.sqrt(STEP))
        assert noise == pytest.approx(z[t], abs=1e-9)


def test_a_seed_means_one_series() -> None:
    again = langevin.simulate(seed=1, samples=1000)
    assert np.array_equal(langevin.simulate(seed=1, samples=1000), again)
    assert not np.array_equal(langevin.simulate(seed=2, samples=1000), again)


def test_too_few_samples_are_refused() -> None:
    with pytest.raises(ParameterError, match="at least 2"):
        langevin.simulate(samples=1)


@pytest.mark.parametrize(
    ("seed", "cells", "last", "corr"), [(0, 4172, 0.875, 0.9855), (3, 4179, 0.880, 0.9842)]
)
def test_printed_numbers(seed: int, cells: int, last: float, corr: float) -> None:
    """Support, last HI and correlation with the index, as a separate count gave them."""
    position = langevin.simulate(seed=seed)
    series = pa.table({"t": np.arange(len(position)), "x": position})
    source = gam_db.Source(series, asset=None, channel=None, time="t", value="x")
    parameters = gam_db.Parameters(
        m=langevin.M, tau=langevin.TAU, bins=langevin.BINS, window=langevin.WINDOW, range="min_max"
    )
    calibration = gam_db.Calibration(fraction=langevin.CALIBRATION)
    (support,) = gam_db.support(source, parameters, calibration).to_pylist()
    hi = gam_db.health_indicator(source, parameters, calibration)["hi"].drop_null().to_numpy()
    assert support["cells"] == cells
    assert len(hi) == 115_001
    assert hi[-1] == pytest.approx(last, abs=5e-4)
    assert np.corrcoef(np.arange(len(hi)), hi)[0, 1] == pytest.approx(corr, abs=5e-5)
