"""Discrete Support Estimation, the default, seen as one estimator among others (paper, Eq. 3 and 4)."""

from gam_db.composing.pipeline import Pipeline
from gam_db.lab.estimators.base import Estimator
from gam_db.method.adding import OfSet
from gam_db.method.resolved import Method


def add_scores(steps: Pipeline, method: Method, number: int) -> None:
    """Add novelty, 0 or 1, as the score."""
    OfSet(steps, method, number).add("lab/estimators/novelty_scores", name="scores")


ESTIMATOR = Estimator("dse", add_scores)
