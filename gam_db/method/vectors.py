"""Codes and delay vectors (Eq. 1; Phi, method section 3): the complete form and the short one."""

from collections.abc import Sequence

from sqlglot import exp

from gam_db import template
from gam_db.clock import LONG_AGO
from gam_db.method.adding import OfSet
from gam_db.method.slots import coordinates, following, outside
from gam_db.parameters import Parameters


def add_vectors(one: OfSet, prefix: str, read: exp.Expr, carried: Sequence[str] = ()) -> None:
    """Add the complete form of codes and vectors of one set (Eq. 1) over the samples to be read.

    The vectors of calibration are called ``calibration_vectors``, the others ``marked_vectors``. Their
    ``still_so_far`` travels with them where it is ``carried``.
    """
    setting = one.setting
    codes = f"{prefix or 'marked_'}codes"
    carried_code = [] if setting.still_after is None else [exp.column("value")]
    ks = range(1, setting.m)
    delayed = [_delayed(name, k, setting) for name in ("code", "calibrating") for k in ks]
    one.add("support/marked_codes", {"read": read, "carried": carried_code}, codes)
    if carried:
        delayed.append(exp.alias_(template.fill("embedding/still_so_far"), "still_so_far"))
    if setting.still_after is not None:
        moving, marked = f"{prefix or 'marked_'}moving_codes", {"marked_codes": codes}
        one.add("embedding/moving_codes", name=moving, tables=marked)
        codes = moving
    made, renamed = f"{prefix or 'marked_'}vectors", {"marked_codes": codes}
    slots: dict[str, template.Slot] = {
        "touching": exp.or_(*(exp.column(f"calibrating_{k}").eq(1) for k in range(setting.m))),
        "carried": [exp.column(name) for name in carried],
        "context": _context(setting),
        "delayed": delayed,
    }
    one.add("embedding/marked_vectors", slots, made, renamed)


def add_short_vectors(
    one: OfSet, prefix: str, trusting: bool = False, carried: Sequence[str] = ()
) -> None:
    """Add the vectors of one set (Eq. 1) over the codes of the same prefix, where no segment ends.

    Columns of the codes that are ``carried`` travel with the vectors.

    Where it is taken on trust that no instant occurs twice, ``doubled`` = 1 marks each sample that shows
    the contrary, be it the newest one of a vector or not.
    """
    setting = one.setting
    delayed = [_delayed("code", k, setting) for k in range(1, setting.m)]
    whole = template.fill("embedding/whole", {"span": setting.span})
    travelling: list[exp.Expr] = [exp.column(name) for name in carried]
    delayed += travelling
    if trusting:
        # Where the next vector begins with the sample before this one, its time is known already.
        delay = max(setting.span - 1, 0)
        previous = exp.column("context_time" if delay == 1 else "previous_time")
        if delay != 1:
            before = template.fill("embedding/delayed", {"column": exp.column("time"), "delay": 1})
            delayed.append(exp.alias_(before, previous.name))
        doubled = template.fill("embedding/doubled", {"previous_time": previous})
        travelling = [*travelling, exp.alias_(_flag(doubled), "doubled")]
        whole = exp.or_(whole, doubled)
    one.add(
        "embedding/vectors",
        {"delayed": delayed, "carried": travelling, "whole": whole},
        f"{prefix}vectors",
        {"codes": f"{prefix}codes"},
    )


def stream_slots(setting: Parameters, has_context: bool) -> dict[str, template.Slot]:
    """Return the slots of streams/vectors.sql that follow from the parameters alone.

    Where a later run must know from where on it reads, that instant travels with each vector.
    """
    delayed = [_delayed("code", k, setting, "streams/delayed") for k in range(1, setting.m)]
    columns = coordinates(setting)
    if has_context:
        asked: dict[str, template.Slot] = {"column": exp.column("time")}
        asked["delay"] = max(setting.span - 1, 0)
        delayed.append(exp.alias_(template.fill("streams/delayed", asked), "context_time"))
        columns.append(exp.column("context_time"))
    return {**following(setting, ("cell_key", "code")), "coordinates": columns, "delayed": delayed}


def is_outside(setting: Parameters) -> exp.Expr:
    """Return 1 where one of these lies outside the calibrated range, else 0."""
    return _flag(outside(setting))


def _context(setting: Parameters) -> exp.Expr:
    """Return the time from where on the next vector is decided."""
    delay = max(setting.reach - 1, 0)
    if setting.still_after is None:
        return template.fill("embedding/delayed", {"column": exp.column("time"), "delay": delay})
    return template.fill("embedding/context", {"delay": delay, "long_ago": LONG_AGO})


def _flag(condition: exp.Expr) -> exp.Expr:
    """Return 1 where a condition holds, else 0."""
    return template.case([(condition.copy(), 1)], 0)


def _delayed(name: str, k: int, setting: Parameters, path: str = "embedding/delayed") -> exp.Expr:
    delay = template.fill(path, {"column": exp.column(name), "delay": k * setting.tau})
    return exp.alias_(delay, f"{name}_{k}")
