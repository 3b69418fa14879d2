"""What calibration says about itself, for one set (method, section 5)."""

from gam_db import template
from gam_db.method.adding import OfSet, add_stacked
from gam_db.pipeline import filled


def add_certificate(one: OfSet) -> None:
    """Add what calibration says about itself, for one set, and what the channel lacks (section 5)."""
    add_judgement(one)
    one.add("certificate/missing_vectors")


def add_judgement(one: OfSet) -> None:
    """Add what calibration says about itself, for one set (section 5)."""
    setting = one.setting
    one.add("certificate/learnt", {"window": setting.window})
    for name in ("visits", "block_sizes", "cells", "blocks", "cell_shares", "learning"):
        one.add(f"certificate/{name}")
    levels = [
        filled(
            "certificate/levels",
            {"level": level, "divisor": 2**level, "level_bins": -(-setting.grid // 2**level)},
        )
        for level in range(setting.grid.bit_length() + 1)
        if level == 0 or -(-setting.grid // 2**level) >= 2
    ]
    add_stacked(one.steps, one.named("levels"), "certificate/levels", levels)
    radix, top = setting.radix, setting.m - 1
    coarse = [
        template.fill("certificate/coarse_term", {"weight": radix**k, "above": radix ** (k + 1)})
        for k in range(top)
    ]
    coarse.append(template.fill("certificate/top_term", {"weight": radix**top}))
    one.add("certificate/ladder", {"coarse_key": template.added(coarse)})
    one.add("certificate/spread")
    for name in ("finest", "outlook"):
        one.add(
            f"certificate/{name}",
            {"target_floor": float(setting.target_floor), "least_vectors": setting.least_vectors},
        )
