"""The metrics of a series, as the pages of this folder need them."""

from typing import Any

import pyarrow as pa

from gam_db.lab.evaluation import Conventions, evaluate

SURROGATES = 20


def summary(
    health: pa.Table,
    outcomes: pa.Table | None = None,
    surrogates: int = 0,
    per_window: int | None = None,
) -> tuple[dict[str, float | None], pa.Table]:
    """Return the metrics of a fleet by name, and the table of its channels.

    Args:
        health: what :func:`gam_db.lab.reproduce.methods.health` returns.
        outcomes: what became of the assets, if it is known.
        surrogates: random series per channel that chance is told by.
        per_window: values of the series that one window spans; needed for chance.
    """
    conventions = Conventions(surrogates=surrogates, samples=0, values_per_window=per_window)
    evaluation = evaluate(health, outcomes, conventions=conventions)
    rows: list[dict[str, Any]] = evaluation.summary.to_pylist()
    return {row["metric"]: row["value"] for row in rows}, evaluation.channels


def chance(health: pa.Table, stride: int, window: int) -> dict[str, float | None]:
    """Return the metrics of chance for a series of every vector, told at every ``stride``-th of them."""
    places = list(range(stride - 1, len(health), stride))
    _, channels = summary(health.take(places), None, SURROGATES, window // stride)
    (row,) = channels.to_pylist()
    return {metric: row[f"{metric}_chance"] for metric in ("mon", "corr", "rob")}
