"""Bounds, calibration vectors and support of one set (Eq. 1 and Eq. 3; section 3 and 4)."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.method.adding import OfSet
from gam_db.method.programs import TAUGHT, coded
from gam_db.method.ranges import add_bounds
from gam_db.method.ranges import taught as taught_inside
from gam_db.method.vectors import add_vectors, compared, varying


def add_calibration(set_steps: OfSet) -> None:
    """Add bounds, calibration vectors and support of one set (section 3, Eq. 1 and Eq. 3)."""
    add_bounds(set_steps)
    is_contiguous = all(len(rule.allowed) <= 1 for rule in set_steps.method.rules)
    if is_contiguous and set_steps.setting.still_after is None and set_steps.method.programs is None:
        set_steps.add("calibration/calibration_codes")
        add_vectors(set_steps, "calibration_")
        add_learnt(set_steps, exp.true())
    else:
        add_learnable(set_steps)
    set_steps.add("support/support")


def add_learnable(set_steps: OfSet) -> None:
    """Add the vectors of one set up to where calibration ends, and which of them it teaches."""
    until = exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
    add_marked_codes(set_steps, "calibration_", until, TAUGHT)
    add_vectors(set_steps, "calibration_", ["calibration_vector"])
    add_learnt(set_steps, exp.column("calibration_vector").eq(1))


def add_marked_codes(set_steps: OfSet, prefix: str, read: exp.Expr, programs: str) -> None:
    """Add the codes of one set over the samples to be read, with which ones are of calibration.

    Where there are programs, the samples that carry their numbers are those of the step ``programs``.
    """
    slots, tables = coded(set_steps, programs)
    slots |= {"read": read, "carried": [*compared(set_steps.setting), *varying(set_steps)]}
    set_steps.add("support/marked_codes", slots, f"{prefix}codes", tables)


def add_learnt(set_steps: OfSet, taught: exp.Expr, proof: str | None = None) -> None:
    """Add *learnable* of one set: vectors that calibration teaches, and what proves a trust wrong."""
    carried, needed = ([exp.column(proof)], exp.column(proof).eq(1)) if proof else ([], exp.false())
    taught = taught_inside(set_steps.setting, taught)
    slots: dict[str, template.Slot] = {"taught": taught, "carried": carried, "needed": needed}
    set_steps.add("calibration/learnable", slots, tables={"vectors": "calibration_vectors"})
