"""Steps that ask the certificate: which m and B can the calibration at hand fill, and the last tables.

This module makes trees; it runs nothing.
"""

import dataclasses

from sqlglot import exp

from gam_db import template
from gam_db.method import Method
from gam_db.method.adding import add, add_of_set
from gam_db.method.certificate import add_certificate
from gam_db.parameters import LARGEST_KEY, Override, Parameters
from gam_db.pipeline import Pipeline, union_of
from gam_db.selection.search import Search


def add_budget(steps: Pipeline, method: Method, search: Search) -> None:
    """Add the certificate of every dimension, and the dimension and grid that go together.

    Args:
        steps: with the embedding and the choice of m.
        method: of the study; it has one set of parameters.
        search: the options.
    """
    general = method.settings[0]
    many = _of_every_dimension(general, search.m_max)
    sets = dataclasses.replace(method, parameters=many)
    steps.small |= sets.small()
    numbers = {setting.m: number for number, setting in enumerate(sets.settings)}
    parts = []
    for m in sorted(m for m in numbers if m <= search.m_max):
        number, setting = numbers[m], sets.settings[numbers[m]]
        key = template.added(
            [
                template.fill(
                    "selection/bin_term",
                    {
                        "coordinate": exp.column(f"u_{k}"),
                        "bins": setting.bins,
                        "weight": setting.radix**k,
                    },
                )
                for k in range(m)
            ]
        )
        slots: dict[str, template.Slot] = {"m": m, "cell_key": key}
        add_of_set(steps, sets, number, "selection/teachable", slots, "learnable")
        add_certificate(steps, sets, number)
        slots = {"m": m, "bins": setting.bins, "window": setting.window}
        add_of_set(steps, sets, number, "selection/budget", slots)
        parts.append(sets.named("budget", number))
    steps.add("budget", union_of(steps, parts), template.load("selection/budget").comment)
    add(steps, "selection/joint", {"m": min(general.m, max(numbers))})
    steps.small |= {*parts, "budget", "joint"}


def add_results(steps: Pipeline, method: Method) -> None:
    """Add the last steps: names instead of integers."""
    general = method.settings[0]
    add(steps, "selection/choices", {"bins": general.bins, "window": general.window})
    for name in ("lag_curve", "dimension_curve", "cycle_curve", "budget_curve"):
        add(steps, f"selection/{name}")


def _of_every_dimension(general: Parameters, m_max: int) -> Parameters:
    """Return parameters with a set for each m whose cells have keys of 64 bits.

    The certificate's steps are made by set; its channels are not those of the overrides here, which
    name no channel: each set holds all of them.
    """
    fitting = [m for m in range(1, m_max + 1) if general.radix**m <= LARGEST_KEY]
    # One set more than is looked at: with a single one its steps would be called like the study's.
    beyond = dataclasses.replace(general, m=fitting[0], tau=general.tau + 1)
    overrides = [Override(asset="", m=m, tau=general.tau) for m in fitting]
    return dataclasses.replace(beyond, overrides=overrides)
