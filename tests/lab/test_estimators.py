"""The other estimators: scored by SQL as scikit-learn scores them, over the vectors of the method."""

import sys
from collections.abc import Callable
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sklearn.ensemble import IsolationForest
from sklearn.mixture import GaussianMixture
from sklearn.svm import OneClassSVM

import comparisons
import estimator_reference
import gam_db
import reference
from gam_db import langevin
from gam_db.errors import UserError
from gam_db.lab.estimators import ESTIMATORS, forest, ocsvm
from harness import arrow, assert_same, made
from strategies import Case, cases

pytestmark = pytest.mark.thorough

LEARNT, SCORED = 5000, 100_000
WINDOW = 5000

#: How scikit-learn fits what the paper names; a number of components, a seed -> an estimator.
SCIKIT: dict[str, Callable[[int, int], Any]] = {
    "gmm": lambda components, seed: GaussianMixture(n_components=components, random_state=seed),
    "forest": lambda _, seed: IsolationForest(random_state=seed),
    "ocsvm": lambda *_: OneClassSVM(kernel="rbf", nu=0.01, gamma="scale"),
}
FITTED = list(SCIKIT)


def scikit(name: str, healthy: Any, vectors: Any, seed: int = 0) -> Any:
    """Scores of scikit-learn, the sign turned: higher is less healthy."""
    components = min(15, len(np.unique(healthy, axis=0)))
    return -SCIKIT[name](components, seed).fit(healthy).score_samples(vectors)


@pytest.fixture(scope="module")
def machine() -> tuple[gam_db.Source, gam_db.Parameters, gam_db.Calibration, Any, Any]:
    """A simulated machine: its source, 5,000 vectors to learn and 100,000 to score."""
    span = 2 * langevin.TAU
    series = langevin.simulate(seed=5, samples=LEARNT + SCORED + span)
    healthy = series[: LEARNT + span]
    x = (series - healthy.min()) / (healthy.max() - healthy.min())
    vectors = np.column_stack([x[span:], x[langevin.TAU : -langevin.TAU], x[:-span]])
    table = pa.table({"t": np.arange(len(series)), "x": series})
    return (
        gam_db.Source(table, asset=None, channel=None, time="t", value="x"),
        gam_db.Parameters(m=3, tau=langevin.TAU, window=WINDOW),
        gam_db.Calibration(intervals=[(0, LEARNT + span - 1)]),
        vectors[:LEARNT],
        vectors[LEARNT:],
    )


@pytest.mark.parametrize("name", [*FITTED, "centroid"])
def test_a_hundred_thousand_vectors(name: str, machine: Any) -> None:
    """Scores as scikit-learn's (NumPy's for the centroid); the indicator as a plain integer sum."""
    source, parameters, calibration, healthy, vectors = machine
    found = gam_db.scores(source, parameters, calibration, estimator=name)
    scores = found["score"].to_numpy()
    if name == "centroid":
        expected = estimator_reference.centroid(healthy, vectors)
    else:
        expected = scikit(name, healthy, vectors)
    assert len(scores) == SCORED
    assert np.max(np.abs(scores - expected) / np.abs(expected)) < 1e-9
    units = np.floor(scores * 2**20 + 0.5).astype(np.int64)
    summed = np.concatenate([[0], np.cumsum(units)])
    moving = (summed[WINDOW:] - summed[:-WINDOW]) / (2**20 * WINDOW)
    assert found["hi"].null_count == WINDOW - 1
    assert np.array_equal(found["hi"].drop_null().to_numpy(), moving)


def test_dse_is_one_of_them(machine: Any) -> None:
    """Its score is novelty, its indicator the same to the last bit, per vector and at bucket ends."""
    novel = gam_db.health_indicator(*machine[:3])
    found = gam_db.scores(*machine[:3])
    assert found["score"].to_numpy().tolist() == novel["novel"].to_pylist()
    assert found.select(["asset", "channel", "time", "hi"]).equals(
        novel.select(["asset", "channel", "time", "hi"])
    )
    buckets = gam_db.health_at_buckets(*machine[:3])
    columns = ["asset", "channel", "bucket", "last_time", "hi"]
    assert gam_db.scores_at_buckets(*machine[:3]).equals(buckets.select(columns))


@pytest.mark.thorough
@settings(max_examples=26)
@given(case=cases())
def test_centroid_on_any_source(case: Case) -> None:
    """Missing values, gaps, pools, overrides, several sets: the vectors are those of the method."""
    rows, *arguments = case
    parameters, calibration = made(*arguments)
    expected = []
    for channel, pool, times, vectors in estimator_reference.scored(rows, parameters, calibration):
        healthy = estimator_reference.learnt(pool)
        if len(healthy):
            scores = estimator_reference.centroid(healthy, vectors).tolist()
            expected += [
                {"asset": channel.asset, "channel": channel.name, "time": time, "score": score}
                for time, score in zip(times, scores, strict=True)
            ]
    found = gam_db.scores(gam_db.Source(arrow(rows)), parameters, calibration, estimator="centroid")
    assert_same(expected, found.drop_columns("hi").to_pylist())
    for one, _ in reference.channels(rows, parameters, calibration):
        of_one = [r for r in found.to_pylist() if (r["asset"], r["channel"]) == (one.asset, one.name)]
        means = estimator_reference.moving_mean([r["score"] for r in of_one], one.settings.window)
        assert [row["hi"] for row in of_one] == means
    comparisons.compared("duckdb", "estimators", rows, parameters, calibration)


def wave(length: int) -> list[float | None]:
    return [float((7 * i * i + i) % 23) for i in range(length)]


def damaged(length: int) -> list[float | None]:
    values = wave(length)
    values[3], values[length // 2], values[-4] = None, float("nan"), float("inf")
    return values


#: what is odd -> (values, the share that is calibration)
ODD: dict[str, tuple[list[float | None], float]] = {
    "constant": ([*[4.5] * 20, *[4.5, 5.0, 4.0, 4.5, 7.25] * 3], 0.5),
    "two vectors": (wave(30), 4 / 30),
    "fewer vectors than components": (wave(40), 10 / 40),
    "fewer different vectors than components": ([*[0.0, 3.0, 1.0] * 20, *wave(20)], 0.75),
    "missing values": (damaged(90), 0.6),
}


@pytest.mark.parametrize("name", FITTED)
@pytest.mark.parametrize("odd", ODD)
def test_odd_calibrations(name: str, odd: str) -> None:
    """Where there is little to fit on, scores are still those of scikit-learn for the same points."""
    values, fraction = ODD[odd]
    rows: list[reference.Row] = [("a", "x", time, value) for time, value in enumerate(values)]
    parameters = gam_db.Parameters(m=3, tau=1, window=4)
    calibration = gam_db.Calibration(fraction=fraction)
    ((_, pool, times, vectors),) = estimator_reference.scored(rows, parameters, calibration)
    expected = scikit(name, estimator_reference.learnt(pool), vectors, seed=3)
    source = gam_db.Source(arrow(rows))
    found = gam_db.scores(source, parameters, calibration, estimator=name, seed=3)
    assert found["time"].to_pylist() == times
    scores = found["score"].to_pylist()
    # Near zero scikit-learn's own sums leave less than nine digits.
    assert scores == pytest.approx(expected.tolist(), rel=1e-9, abs=1e-12)
    assert found["hi"].to_pylist() == estimator_reference.moving_mean(scores, 4)


@pytest.mark.parametrize("name", FITTED)
def test_each_channel_has_a_model_of_its_own(name: str) -> None:
    """Two channels, one pool of two and one without calibration vectors, under two embeddings."""
    rows: list[reference.Row] = []
    for number, (asset, length) in enumerate([("a", 60), ("b", 70), ("c", 50), ("d", 3)]):
        rows += [(asset, "x", t, (number + 1.0) * (v or 0)) for t, v in enumerate(wave(length))]
    parameters = gam_db.Parameters(
        m=2, window=5, overrides=[gam_db.Override(asset="a", m=3, tau=2, window=6)]
    )
    calibration = gam_db.Calibration(fraction=0.5, pool=[["b", "c"]])
    found = gam_db.scores(gam_db.Source(arrow(rows)), parameters, calibration, estimator=name)
    seen = set()
    for channel, pool, times, vectors in estimator_reference.scored(rows, parameters, calibration):
        of_one = [row for row in found.to_pylist() if row["asset"] == channel.asset]
        if channel.asset != "d":
            expected = scikit(name, estimator_reference.learnt(pool), vectors)
            assert [row["time"] for row in of_one] == times
            assert [row["score"] for row in of_one] == pytest.approx(
                expected.tolist(), rel=1e-9, abs=1e-12
            )
        seen |= {row["asset"] for row in of_one}
    assert seen == {"a", "b", "c"}


@pytest.mark.parametrize("name", ESTIMATORS)
def test_nothing_to_learn_from(name: str) -> None:
    """No calibration vector at all: no row, but those of DSE, to which all is novel."""
    rows: list[reference.Row] = [("a", "x", time, value) for time, value in enumerate(wave(9))]
    calibration = gam_db.Calibration(intervals=[(0, 1)])
    source = gam_db.Source(arrow(rows))
    found = gam_db.scores(source, gam_db.Parameters(m=3), calibration, estimator=name)
    assert found["score"].to_pylist() == ([1.0] * 7 if name == "dse" else [])


def test_a_score_beyond_all_bounds_is_held() -> None:
    """A reading of 1e300 is a million ranges away; a window of such likelihoods still fits 64 bits."""
    values = [*wave(60), 1e300, -1e300, 1e300, 1e300, 5.0]
    rows: list[reference.Row] = [("a", "x", time, value) for time, value in enumerate(values)]
    source, parameters = gam_db.Source(arrow(rows)), gam_db.Parameters(m=1, window=4)
    found = gam_db.scores(source, parameters, gam_db.Calibration(fraction=0.5), estimator="gmm")
    scores = found["score"].to_pylist()
    assert max(scores) * 2**20 > 2**60
    assert found["hi"].to_pylist() == estimator_reference.moving_mean(scores, 4)
    assert found["hi"].to_pylist()[-2] == 2.0**60 / 2**20


def test_the_sample_is_bounded_and_seeded(machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    source, parameters, calibration, healthy, _ = machine
    known = {tuple(vector) for vector in healthy.tolist()}
    given_points = []
    fit = ocsvm.model

    def recording(points: Any) -> Any:
        given_points.append(points)
        return fit(points)

    monkeypatch.setattr(ocsvm, "model", recording)
    results = [
        gam_db.scores(source, parameters, calibration, estimator="ocsvm", seed=seed, sample=60)
        for seed in (1, 1, 2)
    ]
    assert [points.shape for points in given_points] == [(60, 3)] * 3
    assert all(len({tuple(v) for v in points.tolist()} & known) == 60 for points in given_points)
    assert results[0].equals(results[1])
    assert not results[0].equals(results[2])


floats = st.floats(-4, 4, width=32) | st.floats(-4, 4) | st.sampled_from([0.0, 2.0**-149, 2.0**-126])


@given(threshold=floats, steps=st.integers(-2, 2), offset=st.sampled_from([-0.5, 0.0, 0.5, 1.0]))
def test_widened_thresholds_decide_as_rounded_values(
    threshold: float, steps: int, offset: float
) -> None:
    """Tried where it matters: on floats near the threshold, half way between, and a double beside."""
    wide = forest.widened(np.array([threshold]))[0]
    near = np.float32(threshold)
    after = np.nextafter(near, np.float32(np.inf))
    between = float(near) + offset * (float(after) - float(near))
    for x in (threshold, wide, between, float(after)):
        for _ in range(abs(steps)):
            x = float(np.nextafter(x, np.copysign(np.inf, steps)))
        assert (float(np.float32(x)) <= threshold) == (x <= wide)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"estimator": "gmn"}, "no estimator 'gmn'; did you mean 'gmm'"),
        ({"estimator": "gmm", "sample": 1}, "sample is 1; it must be at least 2"),
        ({"estimator": "gmm", "sample": 0.5}, "sample of scores is a float; it takes an integer"),
        ({"estimator": "gmm", "seed": -1}, "seed is -1; it must be at least 0"),
        ({"estimator": "gmm", "seed": 2**32}, "below 4294967296"),
    ],
)
def test_what_cannot_be_asked(changed: dict[str, Any], message: str, machine: Any) -> None:
    with pytest.raises(UserError, match=message):
        gam_db.scores(*machine[:3], **changed)


@pytest.mark.parametrize("missing", ["sklearn", "sklearn.mixture"])
def test_without_scikit_learn(missing: str, machine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, missing, None)
    with pytest.raises(UserError, match=r'scikit-learn: pip install "gam-db\[benchmark\]"'):
        gam_db.scores(*machine[:3], estimator="gmm")
    assert gam_db.scores(*machine[:3], estimator="centroid").num_rows == SCORED
