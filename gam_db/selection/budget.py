"""Steps that use the certificate: the m and B that a calibration can fill, and the last tables.

This module makes trees; it runs nothing.
"""

import dataclasses

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method import Method
from gam_db.method.adding import OfSet, add, add_stacked
from gam_db.method.certificate import add_judgement
from gam_db.selection.search import Search
from gam_db.settings.parameters import LARGEST_KEY, Override, Parameters

_BESIDE = 1
"""The set whose certificate is this one; number 0 is that of the study."""

#: What the certificate must know of a learner.
_BOUNDS = ("channel_id", "support_id", "calibrated_lo", "calibrated_hi", "bins", "window_length")


def add_budget(steps: Pipeline, method: Method, search: Search) -> None:
    """Add the certificate of every dimension, and the dimension and grid that go together.

    The cell of a vector of m coordinates has zeros for the others, so that one certificate, made for
    the largest m, serves all of them. The method has one set of parameters.
    """
    general = method.settings[0]
    fitting = [m for m in range(1, search.m_max + 1) if general.radix**m <= LARGEST_KEY]
    beside = Override(m=fitting[-1], tau=general.tau + 1)  # a set with a name of its own
    sets = dataclasses.replace(method, parameters=dataclasses.replace(general, overrides=[beside]))
    steps.small |= sets.small() | {"learners", "budget", "joint"}
    add_stacked(steps, "selection/learners", [{"m": m, "window": general.window} for m in fitting])
    taught = [{"m": m, "cell_key": _cell_key(general, m)} for m in fitting]
    add_stacked(steps, "selection/teachable", taught, sets.named("learnable", _BESIDE))
    steps.add(
        sets.named("bounds", _BESIDE),
        exp.select(*_BOUNDS).from_(exp.to_table("learners")),
        "Bounds, as far as the certificate needs them: which support a learner fills.",
    )
    beside_set = OfSet(steps, sets, _BESIDE)
    add_judgement(beside_set, by_halves=True)
    beside_set.add("certificate/verdicts")
    tables = {name: beside_set.named(name) for name in ("verdicts", "ladder")}
    add(steps, "selection/budget", tables=tables)
    add(steps, "selection/joint", {"m": min(general.m, fitting[-1])})


def add_results(steps: Pipeline, method: Method) -> None:
    """Add the last steps: names instead of integers."""
    general = method.settings[0]
    add(steps, "selection/choices", {"bins": general.grid, "window": general.window})
    for name in ("lag_curve", "dimension_curve", "cycle_curve", "budget_curve"):
        add(steps, f"selection/{name}")


def _cell_key(setting: Parameters, m: int) -> exp.Expr:
    return template.added(
        [
            template.fill(
                "selection/code_term", {"code": exp.column(f"c_{k}"), "weight": setting.radix**k}
            )
            for k in range(m)
        ]
    )
