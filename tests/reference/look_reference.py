"""The figures of ``gam check`` in NumPy, from their description; shares no code with gam_db.

``figures(rows)`` takes (asset, channel, time, value) rows and gives one dict per channel, in order, with
the columns of ``gam_db.check`` except those of calibration.
"""

import math
from collections import defaultdict
from itertools import pairwise
from typing import Any

import numpy as np

Row = tuple[str, str, int, float | None]

PAUSE = 5
SCALES = (1, 4, 16, 64, 256)
BLOCKS, LAGS = 160, 80
HEAD = 4 * BLOCKS * SCALES[-1]
VALUES = HEAD // 32  # of each quarter


def figures(rows: list[Row]) -> list[dict[str, Any]]:
    """Return what is to be seen of each channel."""
    found: dict[tuple[str, str], list[tuple[int, float]]] = defaultdict(list)
    for asset, channel, time, value in rows:
        usable = value is not None and -1e300 <= value <= 1e300
        found[asset, channel].append((time, float(value) if usable and value is not None else math.nan))
    names = sorted(found, key=lambda name: (name[0].encode(), name[1].encode()))
    return [{"asset": a, "channel": c, **of_channel(found[a, c])} for a, c in names]


def of_channel(rows: list[tuple[int, float]]) -> dict[str, Any]:
    """Return the figures of one channel."""
    instants: dict[int, list[float]] = defaultdict(list)
    for time, value in rows:
        instants[time] += [] if math.isnan(value) else [value]
    times = sorted(instants)
    values = np.array([min(instants[time], default=math.nan) for time in times])
    answer: dict[str, Any] = {
        "readings": len(rows),
        "without_time": 0,
        "samples": len(times),
        "repeated": len(rows) - len(times),
        "conflicts": sum(len(set(held)) > 1 for held in instants.values()),
        "missing": int(np.isnan(values).sum()),
        "first_tick": times[0],
        "last_tick": times[-1],
    }
    answer |= of_steps([later - earlier for earlier, later in pairwise(times)])
    answer |= of_values(values)
    cycle, strength = cycle_of(values[:HEAD])
    return answer | {"cycle_length": cycle, "cycle_strength": strength}


def of_steps(steps: list[int]) -> dict[str, Any]:
    """Return the figures of the steps in time."""
    if not steps:
        names = ("typical_step", "short_step", "long_step", "typical_steps")
        lengths = ("longest_step", "shortest_pause", "longest_pause")
        return dict.fromkeys((*names, *lengths)) | {"pauses": 0}
    ordered = sorted(steps)

    def rank(parts: int, of: int) -> int:
        return ordered[-(-parts * len(ordered) // of) - 1]

    usual = rank(1, 2)
    pauses = [step for step in ordered if step > PAUSE * usual]
    return {
        "typical_step": usual,
        "short_step": rank(1, 20),
        "long_step": rank(19, 20),
        "typical_steps": steps.count(usual),
        "pauses": len(pauses),
        "longest_step": max(step for step in ordered if step <= PAUSE * usual),
        "shortest_pause": min(pauses, default=None),
        "longest_pause": max(pauses, default=None),
    }


def of_values(values: Any) -> dict[str, Any]:
    """Return the figures of the values, in order of time."""
    pairs = list(pairwise(values.tolist()))
    held = values[~np.isnan(values)]
    longest = run = 0
    for number, value in enumerate(values.tolist()):
        run = 0 if math.isnan(value) else run + 1 if number and value == values[number - 1] else 1
        longest = max(longest, run)
    seen = np.concatenate([quarter[:VALUES] for quarter in quarters(values[:HEAD])])
    distinct = np.unique(seen[~np.isnan(seen)])
    width = float(held.max() - held.min()) if held.size else 0.0
    apart = [float(step) for step in np.diff(distinct) if step > width * 1e-9]
    return {
        "lowest": float(held.min()) if held.size else None,
        "highest": float(held.max()) if held.size else None,
        "rises": sum(later > earlier for earlier, later in pairs),
        "falls": sum(later < earlier for earlier, later in pairs),
        "stills": sum(later == earlier for earlier, later in pairs),
        "longest_still": longest,
        "values_seen": len(distinct),
        "quantum": min(apart, default=None),
    }


def quarters(values: Any) -> list[Any]:
    """Cut a series into four: sample i of n belongs to quarter floor(4 i / n)."""
    number = np.arange(len(values)) * 4 // max(len(values), 1)
    return [values[number == quarter] for quarter in range(4)]


def cycle_of(values: Any, whole: Any = None) -> tuple[int | None, float | None]:
    """Return the shortest period about as strong as the strongest, and the strength of that."""
    held = values[~np.isnan(values)]
    if not held.size or held.min() == held.max():
        return None, None
    codes = np.floor((values - held.min()) / (held.max() - held.min()) * 1023)
    peaks: list[tuple[int, float]] = []
    for scale in SCALES:
        found = correlations([blocks(quarter, scale) for quarter in quarters(codes)])
        lags = [lag for lag, _ in found]
        course = [strength for _, strength in found]
        for i in range(1, len(found) - 1):
            is_peak = course[i - 1] < course[i] >= course[i + 1] and course[i] >= 0.4
            deep = course[i] - min(course[:i]) >= 0.2
            if is_peak and deep and lags[i] >= (4 if scale == 1 else 20):
                peaks.append((lags[i] * scale, course[i]))
    if not peaks:
        return None, None
    strongest = max(strength for _, strength in peaks)
    return min(period for period, strength in peaks if strength >= strongest - 0.1), strongest


def blocks(quarter: Any, scale: int) -> Any:
    """Return the sums of full blocks; NaN where a sample is missing."""
    count = min(len(quarter) // scale, BLOCKS)
    return quarter[: count * scale].reshape(count, scale).sum(axis=1)


def correlations(parts: list[Any]) -> list[tuple[int, float]]:
    """Return (lag, correlation) of the parts together, each about its own mean."""
    answer = []
    for lag in range(1, LAGS + 1):
        pairs = covariance = early_variance = late_variance = 0
        for part in parts:
            whole = [None if math.isnan(x) else int(x) for x in part.tolist()]
            both = [
                (x, y)
                for x, y in zip(whole, whole[lag:], strict=False)
                if x is not None and y is not None
            ]
            n = len(both)
            early, late = sum(x for x, _ in both), sum(y for _, y in both)
            pairs += n
            covariance += n * sum(x * y for x, y in both) - early * late
            early_variance += n * sum(x * x for x, _ in both) - early * early
            late_variance += n * sum(y * y for _, y in both) - late * late
        if pairs >= 4 * lag and early_variance > 0 and late_variance > 0:
            answer.append((lag, covariance / math.sqrt(float(early_variance) * float(late_variance))))
    return answer
