"""What an estimator of the framework is: how it is fitted, and which steps score vectors by it.

This module owns the interface. The estimators themselves are one file each.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.composing.pipeline import Pipeline
from gam_db.method.resolved import Method

Points: TypeAlias = NDArray[np.float64]
"""Delay vectors in normalised values, a row each, newest sample first: shape (vectors, m)."""

Fit: TypeAlias = Callable[[Mapping[int, Points], int], dict[str, pa.Table]]
AddScores: TypeAlias = Callable[[Pipeline, Method, int], None]


@dataclass(frozen=True)
class Estimator:
    """One way to tell how far a vector is from what calibration visited.

    Attributes:
        name: what users call it.
        add_scores: adds the step ``scores`` of one set of parameters (channel_id, time, score; the
            higher, the less healthy), reading ``scored_points`` and the tables of ``fit``.
        fit: from the points of each support (at least 2 each) and a seed to the rows that scoring
            reads, by name of the table; None where SQL does the fitting, too.
    """

    name: str
    add_scores: AddScores
    fit: Fit | None = None


def stacked(parts: Mapping[int, Mapping[str, NDArray[np.generic]]]) -> pa.Table:
    """Return the rows of all supports as one table, with the column support_id before the others."""
    tables = []
    for support_id, columns in parts.items():
        rows = len(next(iter(columns.values())))
        tables.append(pa.table({"support_id": np.full(rows, support_id, np.int64), **columns}))
    return pa.concat_tables(tables)
