"""Steps that look along time: mutual information, autocorrelation, the delay, the cycle.

This module makes trees; it runs nothing.
"""

from collections.abc import Iterable, Sequence

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add
from gam_db.pipeline import Pipeline, filled, union_of
from gam_db.selection.search import TAU_RULES, Search

LAGS_OF_SCALE = 100
"""Lags of the autocorrelation at each scale, for the cycle."""
LEAST_ROWS = 3 * LAGS_OF_SCALE
"""A scale with fewer rows adds no lag that the finer one has not."""
_TOGETHER = 25
"""Lags of one window pass: more would widen the table that is kept, fewer would sort more often."""


def add_samples(steps: Pipeline, search: Search) -> None:
    """Add the samples to choose from and their figures."""
    add(steps, "selection/selected")
    add(steps, "selection/extents", {"tau_max": search.tau_max})
    add(steps, "selection/deviations")
    steps.small |= {"selected", "extents", "deviations"}


def add_delays(steps: Pipeline, search: Search, longest_lag: int, samples: int) -> None:
    """Add the curves by lag, the delay and the cycle of every channel.

    Args:
        steps: with those of :func:`add_samples`.
        search: the options.
        longest_lag: the largest lag that a channel allows for mutual information.
        samples: those of the longest channel.
    """
    pairs, echoes = [], []
    for lags in _batches(range(max(longest_lag, LAGS_OF_SCALE) + 1)):
        name = f"lagged_{lags[0]}"
        _add_lagged(steps, name, "selected", lags)
        wanted = [lag for lag in lags if lag <= longest_lag]
        if wanted:
            pairs.append(_add_pairs(steps, name, wanted, search.ami_bins))
        echoes.append(_add_echoes(steps, name, 1, lags))
    finer, scale = "selected", 2
    while samples // scale >= LEAST_ROWS:
        coarser = f"coarser_{scale}"
        add(steps, "selection/coarser", name=coarser, tables={"selected": finer})
        steps.small |= {coarser}
        for lags in _batches(range(1, LAGS_OF_SCALE + 1)):
            name = f"lagged_{scale}_{lags[0]}"
            _add_lagged(steps, name, coarser, lags)
            echoes.append(_add_echoes(steps, name, scale, lags))
        finer, scale = coarser, 2 * scale
    steps.add("pairs", union_of(steps, pairs), template.load("selection/pairs").comment)
    steps.add("echoes", union_of(steps, echoes), template.load("selection/echoes").comment)
    for name in ("information", "autocorrelation", "curve", "minima"):
        add(steps, f"selection/{name}")
    rule = TAU_RULES.index(search.tau_by)
    add(steps, "selection/delays", {"tau": search.tau, "first_rule": rule})
    add(steps, "selection/peaks")
    add(steps, "selection/cycles")
    steps.small |= {"information", "autocorrelation", "curve", "delays", "cycles"}


def _add_lagged(steps: Pipeline, name: str, leveled: str, lags: Sequence[int]) -> None:
    columns = [
        exp.alias_(template.fill("selection/lagged_level", {"lag": lag}), f"level_{lag}")
        for lag in lags
        if lag > 0
    ]
    add(steps, "selection/lagged", {"levels": columns}, name, {"selected": leveled})
    steps.small |= {name}


def _add_pairs(steps: Pipeline, lagged: str, lags: Sequence[int], bins: int) -> str:
    rows = [
        filled("selection/pairs", {"lag": lag, "level": _level(lag), "bins": bins}) for lag in lags
    ]
    return _add_rows(steps, f"pairs_of_{lagged}", rows, "selection/pairs", lagged)


def _add_echoes(steps: Pipeline, lagged: str, scale: int, lags: Sequence[int]) -> str:
    rows = [
        filled("selection/echoes", {"scale": scale, "lag": lag, "level": _level(lag)}) for lag in lags
    ]
    return _add_rows(steps, f"echoes_of_{lagged}", rows, "selection/echoes", lagged)


def _add_rows(steps: Pipeline, name: str, rows: Sequence[exp.Query], path: str, lagged: str) -> str:
    """Add a step of one file, filled once per lag; it is kept, so that what it reads is read once."""
    query = rows[0] if len(rows) == 1 else exp.union(*rows, distinct=False)
    steps.add(name, query, template.load(path).comment, {"lagged": lagged})
    steps.small |= {name}
    return name


def _level(lag: int) -> exp.Expr:
    return exp.column(f"level_{lag}")


def _batches(lags: Iterable[int]) -> list[list[int]]:
    every = list(lags)
    return [every[start : start + _TOGETHER] for start in range(0, len(every), _TOGETHER)]
