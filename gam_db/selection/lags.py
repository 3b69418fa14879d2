"""Steps along time: mutual information, autocorrelation, the delay, the cycle.

This module makes trees; it runs nothing.
"""

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import add
from gam_db.selection.search import TAU_RULES, Search

LAGS_OF_SCALE = 100
"""Lags of the autocorrelation at each scale, for the cycle: its length is known to about 1 %."""
MOST_ROWS = 2**17
"""Of more samples, or rows of a scale, about so many take part in what is estimated by lag."""
_LEAST_ROWS = 3 * LAGS_OF_SCALE
"""A scale with fewer rows adds no lag that the finer one has not."""


def add_samples(steps: Pipeline, search: Search, max_gap: int | None) -> None:
    """Add the samples to choose from, in segments of steps up to ``max_gap``, and their figures."""
    add(steps, "selection/selected", {"max_gap": max_gap})
    add(steps, "selection/extents", {"tau_max": search.tau_max})
    add(steps, "selection/deviations")
    steps.small |= {"selected", "extents", "deviations"}


def add_delays(steps: Pipeline, search: Search, samples: int) -> None:
    """Add the curves by lag, the delay and the cycle of every channel.

    The series is halved until little is left of the longest channel, which has so many samples.
    """
    add(steps, "selection/lags", {"least": LAGS_OF_SCALE})
    add(steps, "selection/pairs", {"bins": search.ami_bins, "most": MOST_ROWS})
    finer, scale, echoes = "selected", 1, []
    while scale == 1 or samples // scale >= _LEAST_ROWS:
        if scale > 1:
            coarser = f"coarser_{scale}"
            add(steps, "selection/coarser", name=coarser, tables={"selected": finer})
            finer = coarser
        name = f"echoes_{scale}"
        least = scale * _LEAST_ROWS if scale > 1 else 1
        slots: dict[str, template.Slot] = {"scale": scale, "least": least, "most": MOST_ROWS * scale}
        add(steps, "selection/echoes", slots, name, {"selected": finer})
        steps.small |= {finer, name}
        echoes.append(name)
        scale *= 2
    steps.add("echoes", union_of(steps, echoes), template.load("selection/echoes").comment)
    for name in ("information", "autocorrelation", "curve", "minima"):
        add(steps, f"selection/{name}")
    rule = TAU_RULES.index(search.tau_by)
    add(steps, "selection/delays", {"tau": search.tau, "first_rule": rule})
    add(steps, "selection/peaks")
    add(steps, "selection/cycles")
    steps.small |= {"lags", "information", "autocorrelation", "curve", "delays", "cycles"}
