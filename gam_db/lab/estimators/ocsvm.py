"""One-Class SVM with radial basis functions (paper, section on baselines): nu 0.01, gamma "scale".

The score is scikit-learn's ``score_samples`` with the sign turned: higher is less healthy.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.composing.pipeline import Pipeline
from gam_db.extras import needed
from gam_db.lab.estimators.base import Estimator, Points, stacked
from gam_db.lab.estimators.points import squared_distance
from gam_db.method.adding import OfSet
from gam_db.method.resolved import Method

NU = 0.01


def model(points: Points) -> Any:
    """Return scikit-learn's machine, fitted; there is nothing random in it."""
    return needed("sklearn.svm", "benchmark").OneClassSVM(kernel="rbf", nu=NU, gamma="scale").fit(points)


def fit(points: Mapping[int, Points], seed: int) -> dict[str, pa.Table]:
    """Return ``machine_vectors``: a row per support vector.

    Columns: gamma, weight (its coefficient in units), unit (the size of one, a power of two) and
    place_0 ... place_(m-1).
    """
    return {"machine_vectors": stacked({support: _rows(of) for support, of in points.items()})}


def _rows(points: Points) -> dict[str, NDArray[np.generic]]:
    machine = model(points)
    weights = machine.dual_coef_[0]
    # The sum of all weights, times at most 1 each, stays below 2^62 units.
    bits = 61 - math.ceil(math.log2(weights.sum()))
    # What gamma="scale" means; scikit-learn keeps the number to itself.
    variance = points.var()
    gamma = 1.0 / (points.shape[1] * variance) if variance != 0 else 1.0
    columns: dict[str, NDArray[np.generic]] = {
        "gamma": np.full(len(weights), gamma),
        "weight": np.ldexp(weights, bits),
        "unit": np.full(len(weights), math.ldexp(1.0, -bits)),
    }
    places = machine.support_vectors_
    return columns | {f"place_{k}": places[:, k] for k in range(places.shape[1])}


def add_scores(steps: Pipeline, method: Method, number: int) -> None:
    """Add the sum over the support vectors."""
    OfSet(steps, method, number).add(
        "lab/estimators/machine_scores",
        {"squared_distance": squared_distance(method, number, "place")},
        name="scores",
    )


ESTIMATOR = Estimator("ocsvm", add_scores, fit)
