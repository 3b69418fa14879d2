"""Bounds, calibration vectors and support of one set (Eq. 1 and Eq. 3; section 3 and 4)."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.method.adding import OfSet
from gam_db.method.programs import TAUGHT, coded
from gam_db.method.ranges import add_bounds
from gam_db.method.ranges import taught as taught_inside
from gam_db.method.vectors import add_vectors, compared, varying


def add_calibration(one: OfSet) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    add_bounds(one)
    is_one = all(len(rule.allowed) <= 1 for rule in one.method.rules)
    if is_one and one.setting.still_after is None and one.method.programs is None:
        one.add("calibration/calibration_codes")
        add_vectors(one, "calibration_")
        add_learnt(one, exp.true())
    else:
        add_learnable(one)
    one.add("support/support")


def add_learnable(one: OfSet) -> None:
    """Add the vectors of one set up to where calibration ends, and which of them it teaches."""
    until = exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
    add_marked_codes(one, "calibration_", until, TAUGHT)
    add_vectors(one, "calibration_", ["calibration_vector"])
    add_learnt(one, exp.column("calibration_vector").eq(1))


def add_marked_codes(one: OfSet, prefix: str, read: exp.Expr, programs: str) -> None:
    """Add the codes of one set over the samples to be read, with which ones are of calibration.

    Where there are programs, the samples that carry their numbers are those of the step ``programs``.
    """
    slots, tables = coded(one, programs)
    slots |= {"read": read, "carried": [*compared(one.setting), *varying(one)]}
    one.add("support/marked_codes", slots, f"{prefix}codes", tables)


def add_learnt(one: OfSet, taught: exp.Expr, proof: str | None = None) -> None:
    """Add *learnable* of one set: vectors that calibration teaches, and what proves a trust wrong."""
    carried, needed = ([exp.column(proof)], exp.column(proof).eq(1)) if proof else ([], exp.false())
    taught = taught_inside(one.setting, taught)
    slots: dict[str, template.Slot] = {"taught": taught, "carried": carried, "needed": needed}
    one.add("calibration/learnable", slots, tables={"vectors": "calibration_vectors"})
