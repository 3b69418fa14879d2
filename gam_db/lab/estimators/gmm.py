"""GMM: the negative log-likelihood under a mixture of 15 Gaussians (paper, section on baselines)."""

import math
import warnings
from collections.abc import Mapping
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.extras import needed
from gam_db.lab.estimators.base import Estimator, Points, stacked
from gam_db.lab.estimators.points import names_of
from gam_db.method.adding import OfSet
from gam_db.method.resolved import Method

COMPONENTS = 15


def model(points: Points, seed: int) -> Any:
    """Return scikit-learn's mixture, fitted; fewer components where fewer points differ."""
    mixture = needed("sklearn.mixture", "benchmark")
    components = min(COMPONENTS, len(np.unique(points, axis=0)))
    with warnings.catch_warnings():
        # EM that still moves after scikit-learn's 100 rounds is taken as it is, as the defaults do.
        warnings.simplefilter("ignore", needed("sklearn.exceptions", "benchmark").ConvergenceWarning)
        return mixture.GaussianMixture(components, random_state=seed).fit(points)


def fit(points: Mapping[int, Points], seed: int) -> dict[str, pa.Table]:
    """Return ``mixture``: a row per component.

    Columns: component (from 0), bias (log of the weight, of the determinant of U and of
    (2 pi)^(-m/2)), shift_j (mean U) and factor_i_j (U, upper triangular; U times its transpose is the
    precision).
    """
    return {"mixture": stacked({support: _rows(model(of, seed)) for support, of in points.items()})}


def _rows(mixture: Any) -> dict[str, NDArray[np.generic]]:
    factors = mixture.precisions_cholesky_
    m = factors.shape[1]
    log_determinants = np.log(np.diagonal(factors, axis1=1, axis2=2)).sum(axis=1)
    shifts = np.einsum("ci,cij->cj", mixture.means_, factors)
    bias = np.log(mixture.weights_) + log_determinants - 0.5 * m * math.log(2 * math.pi)
    columns: dict[str, NDArray[np.generic]] = {"component": np.arange(len(bias)), "bias": bias}
    columns |= {f"shift_{j}": shifts[:, j] for j in range(m)}
    return columns | {f"factor_{i}_{j}": factors[:, i, j] for j in range(m) for i in range(j + 1)}


def add_scores(steps: Pipeline, method: Method, number: int) -> None:
    """Add the densities of the components and their log-sum-exp."""
    names = names_of(method, number)
    projections = []
    for j in range(len(names)):
        terms = [
            template.fill(
                "lab/estimators/mixture_term",
                {
                    "coordinate": exp.column(x, table="vector"),
                    "factor": exp.column(f"factor_{i}_{j}", table="fitted"),
                },
            )
            for i, x in enumerate(names[: j + 1])
        ]
        shift = exp.column(f"shift_{j}", table="fitted")
        length = template.fill(
            "lab/estimators/apart", {"coordinate": template.added(terms), "place": shift}
        )
        projections.append(exp.alias_(length, f"y_{j}"))
    squares = [
        template.fill("lab/estimators/squared", {"difference": exp.column(f"y_{j}")})
        for j in range(len(names))
    ]
    OfSet(steps, method, number).add(
        "lab/estimators/mixture_densities",
        {"projections": projections, "squared_length": template.added(squares)},
    )
    logs = [f"log_density_{component}" for component in range(COMPONENTS)]
    gathered = [
        exp.alias_(template.fill("lab/estimators/mixture_component", {"component": component}), log)
        for component, log in enumerate(logs)
    ]
    shares = [
        template.fill("lab/estimators/mixture_share", {"log_density": exp.column(log)}) for log in logs
    ]
    OfSet(steps, method, number).add(
        "lab/estimators/mixture_scores",
        {"log_densities": gathered, "shares": template.added(shares)},
        name="scores",
    )


ESTIMATOR = Estimator("gmm", add_scores, fit)
