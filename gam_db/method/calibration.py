"""Bounds, segments, calibration vectors and support of one set (Eq. 1 and Eq. 3; section 3 and 4)."""

from sqlglot import exp

from gam_db.method.adding import OfSet
from gam_db.method.vectors import add_short_vectors, add_vectors


def add_calibration(one: OfSet) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    one.add("support/bounds")
    add_breaks(one)
    if one.method.is_unbroken(one.number) and all(len(rule.allowed) <= 1 for rule in one.method.rules):
        one.add("calibration/calibration_codes")
        add_short_vectors(one, "calibration_")
        vectors, learnable = "vectors", "calibration/learnable_short"
    else:
        add_vectors(one, "calibration_", until_calibration_end())
        vectors, learnable = "marked_vectors", "calibration/learnable"
    one.add(learnable, name="learnable", tables={vectors: "calibration_vectors"})
    one.add("support/support")


def add_breaks(one: OfSet) -> None:
    """Add where segments begin, for one set."""
    is_unbroken = one.method.gaps[one.number] is None
    one.add("source/unbroken" if is_unbroken else "source/breaks", name="breaks")


def until_calibration_end() -> exp.Expr:
    """Return the condition that a sample is not newer than its channel's calibration."""
    return exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
