"""The metrics of method section 9 written from their equations, in rational numbers.

Shares no code with the package and knows no SQL. Roots and exponentials are taken last, in doubles.
"""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from statistics import fmean
from typing import Any

Values = Sequence[Fraction]
Metric = tuple[float | None, str | None]


@dataclass
class Series:
    """One series with its outcome: asset, channel, values, and ``failed``, ``healthy`` or None."""

    asset: str
    channel: str
    values: list[Fraction]
    outcome: str | None = None


def mean(values: Sequence[Fraction | int]) -> Fraction:
    return sum(map(Fraction, values), Fraction(0)) / len(values)


def variance(values: Values, ddof: int) -> Fraction | None:
    middle = mean(values)
    if len(values) <= ddof:
        return None
    return sum(((value - middle) ** 2 for value in values), Fraction(0)) / (len(values) - ddof)


def pearson(left: Values, right: Values) -> float | None:
    """Correlation; None where one side is constant."""
    a = [value - mean(left) for value in left]
    b = [value - mean(right) for value in right]
    square = sum(x * x for x in a) * sum(y * y for y in b)
    product = sum(x * y for x, y in zip(a, b, strict=True))
    if not square:
        return None
    return math.copysign(math.sqrt(product * product / square), product)


def ranks(values: Values) -> list[Fraction]:
    """Ranks from 1, equal values sharing the mean of theirs."""
    return [
        mean([place for place, other in enumerate(sorted(values), 1) if other == value])
        for value in values
    ]


def signed_monotonicity(values: Values, form: str) -> Metric:
    if len(values) < 2:
        return None, "one_value" if values else "no_values"
    if form == "sign":
        steps = [(b > a) - (b < a) for a, b in itertools.pairwise(values)]
        return sum(steps) / len(steps), None
    found = pearson(ranks(values), [Fraction(i) for i in range(len(values))])
    return found, "constant" if found is None else None


def signed_correlation(values: Values) -> Metric:
    if len(values) < 2:
        return None, "one_value" if values else "no_values"
    found = pearson(values, [Fraction(i) for i in range(len(values))])
    return found, "constant" if found is None else None


def quadratic(points: Values) -> list[Fraction]:
    """The least-squares quadratic through equally spaced points, at the points, by elimination."""
    n = len(points)
    if n < 3:
        return list(points)
    power = [sum(Fraction(i) ** p for i in range(n)) for p in range(5)]
    rows = [
        [power[p + q] for q in range(3)] + [sum(y * i**p for i, y in enumerate(points))]
        for p in range(3)
    ]
    for p in range(3):
        rows[p] = [entry / rows[p][p] for entry in rows[p]]
        for q in range(3):
            if q != p:
                rows[q] = [x - rows[q][p] * y for x, y in zip(rows[q], rows[p], strict=True)]
    return [rows[0][3] + rows[1][3] * i + rows[2][3] * i * i for i in range(n)]


def trend(values: Values) -> list[Fraction]:
    """Savitzky-Golay, order 2, window 2 floor(K / 10) + 1; ends from the first and last window."""
    h = len(values) // 10
    first, last = quadratic(values[: 2 * h + 1]), quadratic(values[len(values) - 2 * h - 1 :])
    middle = [quadratic(values[i - h : i + h + 1])[h] for i in range(h, len(values) - h)]
    return [*first[:h], *middle, *last[h + 1 :]]


def robustness(values: Values) -> Metric:
    if len(values) < 5:
        return None, "short" if values else "no_values"
    amplitude = max(values) - min(values)
    if not amplitude:
        return None, "constant"
    distance = mean([abs(h - t) for h, t in zip(values, trend(values), strict=True)])
    return math.exp(-(distance / amplitude)), "interpolated" if len(values) < 20 else None


def amplitude_of(values: Values, form: str) -> Fraction:
    return values[-1] - values[0] if form == "ends" else max(values) - min(values)


def of_series(series: Series, monotonicity: str = "rank") -> dict[str, Any]:
    """The row of a channel, without chance."""
    mon, mon_reason = signed_monotonicity(series.values, monotonicity)
    corr, corr_reason = signed_correlation(series.values)
    rob, rob_reason = robustness(series.values)
    return {
        "asset": series.asset,
        "channel": series.channel,
        "outcome": series.outcome,
        "k": len(series.values),
        "mon": None if mon is None else abs(mon),
        "mon_signed": mon,
        "corr": None if corr is None else abs(corr),
        "corr_signed": corr,
        "rob": rob,
        "mon_reason": mon_reason,
        "corr_reason": corr_reason,
        "rob_reason": rob_reason,
    }


def likeness(left: Values, right: Values) -> float | None:
    """Size of the correlation of two series at 101 equal shares of their lives."""
    lives = [
        [values[math.floor(Fraction(g * (len(values) - 1), 100) + Fraction(1, 2))] for g in range(101)]
        for values in (left, right)
    ]
    found = pearson(*lives)
    return None if found is None else abs(found)


def of_fleet(
    fleet: Sequence[Series], monotonicity: str, amplitude: str, ddof: int, known: bool
) -> dict[str, Metric]:
    """The metrics of a fleet, in which an asset that was drawn twice stands twice."""
    failed = [one for one in fleet if one.outcome == "failed" and one.values]
    healthy = [one for one in fleet if one.outcome == "healthy" and one.values]
    shown = failed if known else [one for one in fleet if one.values]
    rows = [of_series(one, monotonicity) for one in shown]
    found: dict[str, Metric] = {}
    for name in ("mon", "corr", "rob"):
        values = [row[name] for row in rows if row[name] is not None]
        found[name] = (fmean(values), None) if values else (None, "no_series")
    spread = [variance(one.values, ddof) for one in healthy]
    noise = [math.sqrt(one) for one in spread if one is not None]
    lengths = [amplitude_of(one.values, amplitude) for one in failed]
    length = mean(lengths) if lengths else None
    lacking = "no_outcomes" if not known else "no_failed" if not failed else None
    if lacking or len(failed) == 1:
        found["prog"] = None, lacking or "one_failed"
    elif length is None or length <= 0:
        found["prog"] = None, "no_amplitude"
    else:
        ends = variance([one.values[-1] for one in failed], ddof)
        assert ends is not None
        found["prog"] = math.exp(-math.sqrt(ends) / length), None
    if lacking or not noise:
        found["disc"] = None, lacking or "no_healthy"
    elif length is None or length <= 0:
        found["disc"] = None, "no_amplitude"
    else:
        found["disc"] = 1 / (1 + fmean(noise) / length), None
    five = [value for value, _ in found.values() if value is not None]
    found["global"] = (fmean(five), None) if five else (None, "no_series")
    lived = [one for one in failed if len(one.values) > 1]
    pairs = [
        likeness(one.values, other.values)
        for i, one in enumerate(lived)
        for other in lived[:i]
        if one.asset != other.asset
    ]
    sizes = [size for size in pairs if size is not None]
    if pairs and len(sizes) == len(pairs):
        found["trendability"] = min(sizes), None
    else:
        reason = lacking or ("one_failed" if len(failed) == 1 else "constant")
        found["trendability"] = None, reason
    return found
