"""The paired bootstrap over the joints that failed: all resamples there are, the same for every method.

With five joints that failed there are 5^5 = 3125 resamples, each as likely as the others; so none is
drawn at random. Healthy joints are not resampled. The formulas are those of ``sql/lab/evaluation``, of
a few numbers for each joint that are computed there.
"""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Channels = Sequence[Mapping[str, Any]]

METRICS = ("mon", "corr", "rob", "prog", "disc", "global")
_TAIL = 2.5  # per cent, on either side of an interval


@dataclass(frozen=True)
class Paired:
    """Some methods, compared on the same resamples.

    Attributes:
        first: the method that the others are set beside.
        resamples: how many there are.
        best: metric -> method -> share of the resamples in which it is best; a tie is shared. Nothing
            where no method has the metric.
        differences: metric -> method -> 95 % interval of the first method's value less its own.
    """

    first: str
    resamples: int
    best: dict[str, dict[str, float]]
    differences: dict[str, dict[str, tuple[float, float]]]


def resampled(channels: Channels) -> dict[str, Floats]:
    """Return each metric over all resamples of the joints that failed; the first ones are not special.

    Args:
        channels: a row per joint: outcome, mon, corr, rob, last_hi, amplitude, hi_sd. What is None is
            left out of means.
    """
    failed = [row for row in channels if row["outcome"] == "failed"]
    noise = _numbers([row for row in channels if row["outcome"] == "healthy"], "hi_sd")
    picks = np.array(list(itertools.product(range(len(failed)), repeat=len(failed))))
    values = {metric: _means(_numbers(failed, metric)[picks]) for metric in ("mon", "corr", "rob")}
    amplitude = _means(_numbers(failed, "amplitude")[picks])
    ends = _numbers(failed, "last_hi")[picks]
    spread = np.sqrt(_means((ends - _means(ends)[:, None]) ** 2))
    with np.errstate(divide="ignore", invalid="ignore"):
        values["prog"] = np.exp(-spread / amplitude)
        values["disc"] = 1 / (1 + _means(noise[None, :]) / amplitude)
    for metric in ("prog", "disc"):
        values[metric] = np.where(amplitude > 0, values[metric], np.nan)
    values["global"] = _means(np.column_stack([values[metric] for metric in METRICS[:-1]]))
    return values


def paired(fleets: Sequence[Mapping[str, Channels]]) -> Paired:
    """Compare methods on all resamples of each fleet.

    Args:
        fleets: of each fleet the rows of :func:`resampled` by method; the same methods in each.
    """
    names = list(fleets[0])
    parts = [{name: resampled(channels) for name, channels in fleet.items()} for fleet in fleets]
    best: dict[str, dict[str, float]] = {}
    differences: dict[str, dict[str, tuple[float, float]]] = {}
    for metric in METRICS:
        values = np.array([np.concatenate([part[name][metric] for part in parts]) for name in names])
        values = np.where(np.isnan(values), -np.inf, values)
        differences[metric] = {}
        values = values[:, np.isfinite(values).any(axis=0)]
        if not values.size:
            best[metric] = {}
            continue
        is_best = values == values.max(axis=0)
        shares = (is_best / is_best.sum(axis=0)).mean(axis=1)
        best[metric] = dict(zip(names, shares.tolist(), strict=True))
        for name, method_values in zip(names[1:], values[1:], strict=True):
            is_finite = np.isfinite(method_values) & np.isfinite(values[0])
            if is_finite.any():
                less = values[0][is_finite] - method_values[is_finite]
                low, high = np.percentile(less, [_TAIL, 100 - _TAIL])
                differences[metric][name] = float(low), float(high)
    return Paired(names[0], sum(len(part[names[0]]["mon"]) for part in parts), best, differences)


def _numbers(rows: Channels, name: str) -> Floats:
    return np.array([row[name] for row in rows], np.float64)


def _means(values: Floats) -> Floats:
    """Return the mean of each row without NaN; NaN where there is nothing else."""
    is_number = ~np.isnan(values)
    count = is_number.sum(axis=1)
    total = np.where(is_number, values, 0.0).sum(axis=1)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)
