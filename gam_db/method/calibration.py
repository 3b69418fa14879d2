"""Bounds, segments, calibration vectors and support of one set (Eq. 1 and Eq. 3; section 3 and 4)."""

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import OfSet, add
from gam_db.method.vectors import add_short_vectors, add_vectors, code_of


def add_calibration(one: OfSet) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    setting = one.setting
    add_bounds(one)
    add_breaks(one)
    if one.method.is_unbroken(one.number) and all(len(rule.allowed) <= 1 for rule in one.method.rules):
        codes = {"code": code_of(setting)}
        one.add("calibration/calibration_codes", codes)
        add_short_vectors(one, "calibration_")
        vectors, learnable = "vectors", "calibration/learnable_short"
    else:
        add_vectors(one, "calibration_", until_calibration_end())
        vectors, learnable = "marked_vectors", "calibration/learnable"
    one.add(learnable, name="learnable", tables={vectors: "calibration_vectors"})
    one.add("support/support")


def add_bounds(one: OfSet) -> None:
    """Add the range of the channels of one set, with what later steps must know of the set."""
    setting = one.setting
    said: dict[str, template.Slot] = {
        **{"settings_no": one.number, "bins": setting.grid, "window": setting.window},
        "target_floor": float(setting.target_floor),
    }
    add(one.steps, "support/bounds", said, name=one.named("bounds"))


def add_breaks(one: OfSet) -> None:
    """Add where segments begin, for one set."""
    gap = one.method.gaps[one.number]
    if gap is None:
        add(one.steps, "source/unbroken", name=one.named("breaks"))
    else:
        add(
            one.steps,
            "source/breaks",
            {"settings_no": one.number, "max_gap": gap},
            name=one.named("breaks"),
        )


def until_calibration_end() -> exp.Expr:
    """Return the condition that a sample is not newer than its channel's calibration."""
    return exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
