"""What calibration says about itself, for one set (method, section 5)."""

from gam_db import template
from gam_db.method.adding import add_of_set, add_stacked
from gam_db.method.resolved import Method
from gam_db.pipeline import Pipeline, filled


def add_certificate(steps: Pipeline, method: Method, number: int) -> None:
    """Add what calibration says about itself, for one set, and what the channel lacks (section 5)."""
    add_judgement(steps, method, number)
    add_of_set(steps, method, number, "certificate/missing_vectors")


def add_judgement(steps: Pipeline, method: Method, number: int) -> None:
    """Add what calibration says about itself, for one set (section 5)."""
    setting = method.settings[number]
    add_of_set(steps, method, number, "certificate/learnt", {"window": setting.window})
    for name in ("visits", "block_sizes", "cells", "blocks", "cell_shares", "learning"):
        add_of_set(steps, method, number, f"certificate/{name}")
    levels = [
        filled(
            "certificate/levels",
            {"level": level, "divisor": 2**level, "level_bins": -(-setting.grid // 2**level)},
        )
        for level in range(setting.grid.bit_length() + 1)
        if level == 0 or -(-setting.grid // 2**level) >= 2
    ]
    add_stacked(steps, method.named("levels", number), "certificate/levels", levels)
    radix, top = setting.radix, setting.m - 1
    coarse = [
        template.fill("certificate/coarse_term", {"weight": radix**k, "above": radix ** (k + 1)})
        for k in range(top)
    ]
    coarse.append(template.fill("certificate/top_term", {"weight": radix**top}))
    add_of_set(steps, method, number, "certificate/ladder", {"coarse_key": template.added(coarse)})
    add_of_set(steps, method, number, "certificate/spread")
    for name in ("finest", "outlook"):
        add_of_set(
            steps,
            method,
            number,
            f"certificate/{name}",
            {"target_floor": float(setting.target_floor), "least_vectors": setting.least_vectors},
        )
