"""Centroid: the distance to the centre of mass of the healthy vectors (paper, section on baselines)."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.lab.estimators.base import Estimator
from gam_db.lab.estimators.points import names_of, squared_distance
from gam_db.method.adding import OfSet
from gam_db.method.resolved import Method


def add_scores(steps: Pipeline, method: Method, number: int) -> None:
    """Add the centre, fitted in SQL on all calibration vectors, and the distances to it."""
    means = [
        exp.alias_(
            template.fill("lab/estimators/centroid_mean", {"coordinate": exp.column(x, table="point")}),
            f"centre_{k}",
        )
        for k, x in enumerate(names_of(method, number))
    ]
    OfSet(steps, method, number).add("lab/estimators/centroid", {"means": means})
    distance = {"squared_distance": squared_distance(method, number, "centre")}
    OfSet(steps, method, number).add("lab/estimators/centroid_scores", distance, name="scores")
    steps.small |= {method.named("centroid", number)}


ESTIMATOR = Estimator("centroid", add_scores)
