"""The method as an outlier detector of scikit-learn: its own checks, and the numbers of the method."""

import warnings
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from sklearn.utils.estimator_checks import parametrize_with_checks

import gam_db
from gam_db.errors import ParameterError
from gam_db.sklearn import NoveltyDetector


def recording(rows: int, noise: float = 0.02, seed: int = 0) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Two signals of a machine in its cycle."""
    clock = np.arange(rows)
    chance = np.random.default_rng(seed).normal(0, noise, (rows, 2))
    return np.stack([np.sin(clock / 9), np.cos(clock / 5)], axis=1) + chance


#: Checks that want outliers among what was fitted, all of which is healthy here.
UNFIT = ("check_outliers_fit_predict", "check_outliers_train")


@pytest.mark.full
@pytest.mark.filterwarnings("ignore::gam_db.CalibrationWarning")  # few rows of noise are fitted
@parametrize_with_checks(
    [NoveltyDetector(m=1, window=1)],
    expected_failed_checks=lambda _: dict.fromkeys(UNFIT, "what is fitted is healthy"),
)  # type: ignore[untyped-decorator]
def test_checks_of_scikit_learn(estimator: Any, check: Any) -> None:
    """With one sample a vector and one vector a window rows are judged one by one, as checks want."""
    check(estimator)


def test_a_fault_is_told_from_healthy_operation() -> None:
    detector = NoveltyDetector(m=2, tau=3, window=100).fit(recording(6000))
    assert (detector.predict(recording(2000, seed=1)) == 1).mean() > 0.9
    broken = recording(1000, seed=2)
    broken[500:, 1] *= 1.5
    scores = detector.score_samples(broken)
    assert (scores[:500] >= 0).mean() > 0.9
    assert (detector.predict(broken)[600:] == -1).all()
    assert scores[600:].max() < 0


def test_the_numbers_are_those_of_the_method() -> None:
    """The healthy part and a recording in one table, told apart by the calibration."""
    healthy, rows = recording(600), recording(300, noise=0.2, seed=1)
    rows[100, 0] = np.nan
    detector = NoveltyDetector(m=2, tau=2, bins=16, window=20).fit(healthy)
    whole = np.concatenate([healthy[:, 0], rows[:, 0]])
    table = pa.table({"time": [*range(600), *range(700, 1000)], "value": whole})
    parameters = gam_db.Parameters(m=2, tau=2, bins=16, window=20, max_gap=1)
    calibration = gam_db.Calibration(intervals=[(0, 599)])
    found = gam_db.health_indicator(gam_db.Source(table, None, None), parameters, calibration)
    (learnt,) = gam_db.support(gam_db.Source(table, None, None), parameters, calibration).to_pylist()
    limit = 1.0 if learnt["hi_limit"] is None else learnt["hi_limit"]
    alone = (
        NoveltyDetector(m=2, tau=2, bins=16, window=20).fit(healthy[:, :1]).score_samples(rows[:, :1])
    )
    expected = np.zeros(300)
    novel = dict(zip(found["time"].to_pylist(), found["novel_in_window"].to_pylist(), strict=True))
    held = 0
    for row in range(300):
        held = novel.get(700 + row, held)
        expected[row] = limit - held / 20
    assert 700 + 100 not in novel
    np.testing.assert_array_equal(alone, expected)
    assert (detector.score_samples(rows) <= alone).all()


def test_a_parameter_out_of_range_is_refused() -> None:
    with pytest.raises(ParameterError, match="bins is 'many'"):
        NoveltyDetector(bins="many").fit(recording(50))


NOISE = np.random.default_rng(0).normal(size=(300, 5))


@pytest.mark.parametrize(
    ("rows", "settings", "message"),
    [
        (
            NOISE,
            {"bins": 64},
            r"^x0, x1, x2 and 2 more: calibration is too_fine, .* fit more healthy rows",
        ),
        (np.ones((300, 1)), {}, r"^x0: calibration is constant, not ready: it did not move, .* leave"),
        (np.full((60, 1), np.nan), {}, r"^x0: calibration is no_data, not ready: .* without missing"),
        (
            NOISE[:12, :1],
            {"bins": 8, "window": 2},
            r"^x0: calibration is needs_data, .* fit more healthy",
        ),
        (
            recording(3000)[:, :1] * np.where(np.arange(3000) % 100, 1, 1e6)[:, None],  # a wide range
            {"bins": 8},
            r"^x0: calibration is blind, not ready: no shift of up to half",
        ),
    ],
    ids=["too_fine", "constant", "no_data", "needs_data", "blind"],
)
def test_a_calibration_that_is_not_ready_is_warned_of(
    rows: np.ndarray[Any, Any], settings: dict[str, Any], message: str
) -> None:
    """And where no limit judges, no row is an outlier."""
    with pytest.warns(gam_db.CalibrationWarning, match=message) as warned:
        detector = NoveltyDetector(m=2, **settings).fit(rows)
    assert [warning.filename for warning in warned] == [__file__]
    if "blind" not in message:
        assert (detector.predict(rows[::-1] * 3) == 1).all()


def test_a_warning_is_once_for_each_verdict_and_names_features() -> None:
    pandas = pytest.importorskip("pandas", reason="it comes with the extra engines")
    still = pandas.DataFrame(
        {"speed": recording(3000)[:, 0], "door": np.ones(3000), "lid": np.ones(3000)}
    )
    with pytest.warns(gam_db.CalibrationWarning, match=r"^door, lid: calibration is constant") as warned:
        NoveltyDetector().fit(still)
    assert len(warned) == 1


def test_nothing_is_warned_of_a_calibration_that_is_ready() -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        NoveltyDetector(m=2, tau=3).fit(recording(6000))
