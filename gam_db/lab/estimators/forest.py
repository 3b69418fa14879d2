"""Isolation Forest (Liu, Ting and Zhou 2008; paper, section on baselines), scikit-learn's defaults.

The score is scikit-learn's ``score_samples`` with the sign turned: higher is less healthy.
"""

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.composing.pipeline import Pipeline
from gam_db.extras import needed
from gam_db.lab.estimators.base import Estimator, Points, stacked
from gam_db.lab.estimators.points import names_of, point_of
from gam_db.method.adding import OfSet
from gam_db.method.resolved import Method

#: Each tree is grown on at most 256 points, and no deeper than log2 of that.
LEVELS = 8
PATH_UNITS = 2.0**40

Columns = dict[str, NDArray[np.generic]]


def model(points: Points, seed: int) -> Any:
    """Return scikit-learn's forest, fitted.

    What it calls contamination moves a threshold of its own and no score.
    """
    forest = needed("sklearn.ensemble", "benchmark").IsolationForest
    return forest(max_samples=min(2**LEVELS, len(points)), random_state=seed).fit(points)


def fit(points: Mapping[int, Points], seed: int) -> dict[str, pa.Table]:
    """Return the trees, with nodes numbered over all supports.

    Returns:
        ``forests``: a row per support: rate, ln 2 / (2^40 * trees * mean path of an average tree).
        ``forest_trees``: a row per tree: root, its first node.
        ``forest_nodes``: a row per node: node, axis, threshold, lower_node, upper_node, path_units
        (length of the path to it, with what an average tree would add for its points, times 2^40).
    """
    forests: dict[int, Columns] = {}
    trees: dict[int, Columns] = {}
    nodes: dict[int, Columns] = {}
    first = 0
    for support, support_points in points.items():
        forest = model(support_points, seed)
        grown = []
        roots = []
        for estimator in forest.estimators_:
            roots.append(first)
            grown.append(_nodes(estimator.tree_, first))
            first += estimator.tree_.node_count
        nodes[support] = {name: np.concatenate([tree[name] for tree in grown]) for name in grown[0]}
        trees[support] = {"root": np.array(roots, np.int64)}
        usual = average_path(np.array([forest.max_samples_]))[0]
        rate = math.log(2) / (PATH_UNITS * len(roots) * usual)
        forests[support] = {"rate": np.array([rate])}
    return {
        "forests": stacked(forests),
        "forest_trees": stacked(trees),
        "forest_nodes": stacked(nodes),
    }


def average_path(points: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return the mean path to a leaf of an isolation tree over so many points (Liu et al., Eq. 1)."""
    many = np.maximum(points, 3)
    path = 2 * (np.log(many - 1) + np.euler_gamma) - 2 * (many - 1) / many
    return np.where(points > 2, path, np.where(points == 2, 1.0, 0.0))


def widened(thresholds: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest doubles that, rounded to 32-bit floats, do not exceed the thresholds.

    Rounding never changes the order of two numbers, so ``float32(x) <= threshold`` and
    ``x <= widened(threshold)`` are the same for every double x. A double half way between two floats
    goes to the one whose last bit is 0.
    """
    below = thresholds.astype(np.float32)
    below = np.where(below > thresholds, np.nextafter(below, np.float32(-np.inf)), below)
    above = np.nextafter(below, np.float32(np.inf))
    half_way = (below.astype(np.float64) + above.astype(np.float64)) / 2
    even = below.view(np.uint32) % 2 == 0
    return np.where(even, half_way, np.nextafter(half_way, -np.inf))


def _nodes(tree: Any, first: int) -> Columns:
    count = tree.node_count
    numbers = np.arange(count)
    depth = np.zeros(count, np.int64)
    leaf = tree.children_left < 0
    for node in numbers[~leaf]:  # a child comes after its parent
        depth[[tree.children_left[node], tree.children_right[node]]] = depth[node] + 1
    path = depth + average_path(tree.n_node_samples)
    return {
        "node": first + numbers,
        "axis": np.where(leaf, 0, tree.feature),
        "threshold": np.where(leaf, 0.0, widened(tree.threshold)),
        "lower_node": first + np.where(leaf, numbers, tree.children_left),
        "upper_node": first + np.where(leaf, numbers, tree.children_right),
        "path_units": np.floor(path * PATH_UNITS + 0.5).astype(np.int64),
    }


def add_scores(steps: Pipeline, method: Method, number: int) -> None:
    """Add the way from the roots to the leaves, a step per level, and the mean path."""
    point = {"point": point_of(method, number)}
    OfSet(steps, method, number).add("lab/estimators/forest_start", point, name="forest_level_0")
    coordinate = exp.Case(
        ifs=[
            exp.If(
                this=exp.EQ(this=exp.column("axis", table="fork"), expression=exp.Literal.number(k)),
                true=exp.column(x, table="point"),
            )
            for k, x in enumerate(names_of(method, number))
        ]
    )
    for level in range(LEVELS):
        OfSet(steps, method, number).add(
            "lab/estimators/forest_step",
            {**point, "coordinate": coordinate},
            name=f"forest_level_{level + 1}",
            tables={"walk": f"forest_level_{level}"},
        )
    OfSet(steps, method, number).add(
        "lab/estimators/forest_scores",
        name="scores",
        tables={"walk": f"forest_level_{LEVELS}"},
    )


ESTIMATOR = Estimator("forest", add_scores, fit)
