"""Bounds, segments, calibration vectors and support of one set (Eq. 1 and Eq. 3; section 3 and 4)."""

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add, add_of_set
from gam_db.method.resolved import Method
from gam_db.method.vectors import add_short_vectors, add_vectors, code_of
from gam_db.pipeline import Pipeline


def add_calibration(steps: Pipeline, method: Method, number: int) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    setting = method.settings[number]
    add_bounds(steps, method, number)
    add_breaks(steps, method, number)
    if method.is_unbroken(number) and all(len(rule.allowed) <= 1 for rule in method.rules):
        codes = {"code": code_of(setting)}
        add_of_set(steps, method, number, "calibration/calibration_codes", codes)
        add_short_vectors(steps, method, number, "calibration_")
        vectors, learnable = "vectors", "calibration/learnable_short"
    else:
        add_vectors(steps, method, number, "calibration_", until_calibration_end())
        vectors, learnable = "marked_vectors", "calibration/learnable"
    add_of_set(
        steps,
        method,
        number,
        learnable,
        name="learnable",
        tables={vectors: "calibration_vectors"},
    )
    add_of_set(steps, method, number, "support/support")


def add_bounds(steps: Pipeline, method: Method, number: int) -> None:
    """Add the range of the channels of one set, with what later steps must know of the set."""
    setting = method.settings[number]
    said: dict[str, template.Slot] = {
        **{"settings_no": number, "bins": setting.grid, "window": setting.window},
        "target_floor": float(setting.target_floor),
    }
    add(steps, "support/bounds", said, name=method.named("bounds", number))


def add_breaks(steps: Pipeline, method: Method, number: int) -> None:
    """Add where segments begin, for one set."""
    gap = method.gaps[number]
    if gap is None:
        add(steps, "source/unbroken", name=method.named("breaks", number))
    else:
        add(
            steps,
            "source/breaks",
            {"settings_no": number, "max_gap": gap},
            name=method.named("breaks", number),
        )


def until_calibration_end() -> exp.Expr:
    """Return the condition that a sample is not newer than its channel's calibration."""
    return exp.LTE(
        this=exp.column("time", table="sampled"),
        expression=exp.column("calibration_end", table="scale"),
    )
