"""The method as an outlier detector of scikit-learn (extra ``sklearn``), over the same SQL.

This module owns how rows become channels and health indicators become scores.
"""

import warnings
from collections.abc import Mapping
from typing import Any, Self

import numpy as np
import pyarrow as pa
from numpy.typing import ArrayLike, NDArray
from sklearn.base import BaseEstimator, OutlierMixin
from sklearn.utils.validation import check_is_fitted, validate_data

from gam_db import data
from gam_db.engines.connecting import borrowed
from gam_db.errors import CalibrationWarning
from gam_db.health import support
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import WideSource
from gam_db.study import Study

Scores = NDArray[np.float64]

_NAMED = 3
"""Features that a warning names."""


class NoveltyDetector(OutlierMixin, BaseEstimator):  # type: ignore[misc]
    """Tells rows whose recent past healthy operation never visited (Discrete Support Estimation).

    Rows are samples in order of time at equal steps, features are channels, NaN is a missing reading.
    What is fitted is healthy operation; what is scored is taken as a recording of its own, in its
    order, and a row is judged by the last ``window`` delay vectors up to it. So scores of rows belong
    together: other rows before one change its score, unless ``m`` and ``window`` are 1.

    Args:
        m, tau, bins, window, target_floor: as in :class:`gam_db.Parameters`; bins are left to be found.

    Attributes:
        parameters_: the parameters, with the bins that were found.
        limits_: (features,) the health indicator above which a feature is high; 1, which none exceeds,
            where calibration is not good enough to judge by.
        offset_: 0, the score below which a row is an outlier.

    Raises:
        ParameterError: a parameter is out of its range.

    Warns:
        CalibrationWarning: what was fitted is not ``ready`` to judge some feature by; it names the
            features, their verdict and what to do. Those that are not ``blind`` are never outliers.
    """

    def __init__(
        self,
        m: int = 3,
        tau: int = 1,
        bins: int | str = "auto",
        window: int = 100,
        target_floor: float = 0.05,
    ) -> None:
        self.m = m
        self.tau = tau
        self.bins = bins
        self.window = window
        self.target_floor = target_floor

    def fit(self, X: ArrayLike, y: object = None) -> Self:  # noqa: N803
        """Learn healthy operation.

        Args:
            X: (samples, features) of a healthy machine.
            y: ignored.

        Warns:
            CalibrationWarning: it is not ``ready`` to judge some feature by.
        """
        self._healthy = validate_data(
            self, X, dtype=np.float64, ensure_all_finite="allow-nan", ensure_min_samples=2
        )
        settings = {name: getattr(self, name) for name in ("m", "tau", "bins", "window", "target_floor")}
        settings["max_gap"] = 1  # no vector reaches from one recording into another
        settings["least_vectors"] = 1  # a detector judges by what it was given, as all of its kind do
        source, calibration = self._source(self._healthy), Calibration(fraction=1.0)
        with borrowed(None) as session:
            self.parameters_ = Study(
                session, source, Parameters(**settings), calibration
            ).method.parameters
            learnt = support(source, self.parameters_, calibration, session).to_pylist()
        verdict = {row["channel"]: row["verdict"] for row in learnt}
        names = getattr(self, "feature_names_in_", source.value_columns)
        _warn({str(name): verdict[of] for name, of in zip(names, source.value_columns, strict=True)})
        limits = {row["channel"]: row["hi_limit"] for row in learnt}
        feature_limits = [limits[name] for name in source.value_columns]
        self.limits_ = np.array([1.0 if limit is None else limit for limit in feature_limits])
        self.offset_ = 0.0
        return self

    def score_samples(self, X: ArrayLike) -> Scores:  # noqa: N803
        """Return how far below its limit the health indicator is, of the feature that is nearest to it.

        Args:
            X: (samples, features), a recording in order of time.

        Returns:
            (samples,) at least 0 for a healthy row. Vectors that lie before the recording are taken as
            healthy; a row without a vector of its own (one with a missing reading) has the score of the
            row before.
        """
        check_is_fitted(self)
        rows = validate_data(self, X, reset=False, dtype=np.float64, ensure_all_finite="allow-nan")
        before = len(self._healthy)
        source = self._source(np.vstack([self._healthy, rows]), before)
        calibration = Calibration(intervals=[(0, before - 1)])
        with borrowed(None) as session:
            study = Study(session, source, self.parameters_, calibration)
            health = study.table("health_indicator").select(["channel", "time", "novel_in_window"])
        places = {name: place for place, name in enumerate(source.value_columns)}
        channels = health["channel"].combine_chunks().dictionary_encode()
        columns = np.array([places[name] for name in channels.dictionary.to_pylist()], np.int64)
        novel = np.full(rows.shape, np.nan)
        at = health["time"].to_numpy() - before - 1
        if len(at):
            novel[at, columns[channels.indices.to_numpy()]] = health["novel_in_window"].to_numpy()
        last = np.maximum.accumulate(
            np.where(np.isnan(novel), -1, np.arange(len(rows))[:, None]), axis=0
        )
        held = np.where(last < 0, 0.0, np.take_along_axis(novel, np.maximum(last, 0), axis=0))
        scores: Scores = (self.limits_ - held / self.window).min(axis=1)
        return scores

    def decision_function(self, X: ArrayLike) -> Scores:  # noqa: N803
        """Return the scores of :meth:`score_samples`, whose threshold is 0."""
        return self.score_samples(X) - self.offset_

    def predict(self, X: ArrayLike) -> NDArray[np.int64]:  # noqa: N803
        """Return 1 for each healthy row and -1 for each outlier, (samples,)."""
        return np.where(self.decision_function(X) < 0, -1, 1)

    def __sklearn_tags__(self) -> Any:
        """Return what scikit-learn asks of an estimator: missing readings are allowed."""
        tags = super().__sklearn_tags__()
        tags.input_tags.allow_nan = True
        return tags

    @staticmethod
    def _source(rows: Scores, before: int | None = None) -> WideSource:
        """Return rows as a recording; those from ``before`` on are another one, a step later."""
        time = np.arange(len(rows))
        if before is not None:
            time[before:] += 1
        names = [f"x{place}" for place in range(rows.shape[1])]
        table = pa.table({"time": time, **dict(zip(names, rows.T.copy(), strict=True))})
        return WideSource(table, asset=None, time="time", channels=names)


def _warn(verdicts: Mapping[str, str]) -> None:
    """Warn of features, given with their verdicts, that calibration cannot judge well, once for each."""
    for verdict, advice in data.table("gam_db.lab", "sklearn.toml")["verdicts"].items():
        names = [name for name, of in verdicts.items() if of == verdict]
        if names:
            more = f" and {len(names) - _NAMED:,} more" if len(names) > _NAMED else ""
            message = (
                f"{', '.join(names[:_NAMED])}{more}: calibration is {verdict}, not ready: {advice}."
            )
            warnings.warn(message, CalibrationWarning, stacklevel=3)
