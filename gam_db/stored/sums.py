"""Checksums of what calibration froze, and the rows that a new table is given of an older state.

This module owns which integers of a version and of its bounds are summed, and in which order. The
formula stands in ``sql/stored/mixed.sql``.
"""

from collections.abc import Sequence
from functools import cache

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add
from gam_db.pipeline import Pipeline

#: Integers of ``gam_version`` that are frozen with it; status, reason and the hashes are texts.
OF_VERSION = (
    *("channel_id", "support_id", "parent_id", "version_no", "m", "tau", "bins", "window_length"),
    *("stride", "max_gap", "score_from", "calibration_end", "first_scored", "run_up_from"),
    *("calibration_readings", "calibration_samples", "created"),
)

#: Integers of ``gam_bounds``: those of the certificate.
OF_BOUNDS = ("calibration_vectors", "cells", "seen_once", "blocks", "finest_bins", "vectors_needed")


#: The ends of the range, and what the tables called them when their checksums came.
ENDS, _FIRST_ENDS = ("calibrated_lo", "calibrated_hi"), ("lo", "hi")


def slots(ends: Sequence[str] = ENDS) -> dict[str, template.Slot]:
    """Return the slots of ``sql/stored/checksum_rows.sql``."""
    figures = [
        *(exp.column(name, table="learnt") for name in OF_VERSION),
        *(exp.column(name, table="scale") for name in OF_BOUNDS),
    ]
    return {
        "cell": _mixed(exp.column("cell_key", table="cell"), exp.column("visits", table="cell")),
        "interval": _mixed(
            exp.column("time_from", table="piece"),
            exp.Mod(this=exp.column("time_to", table="piece"), expression=exp.Literal.number(2**31 - 1)),
        ),
        "ends": [exp.alias_(exp.column(name, table="scale"), name) for name in ends],
        "figures": template.added([_figure(one, place) for place, one in enumerate(figures)]),
    }


@cache
def matching_steps() -> Pipeline:
    """Return the steps up to *mismatched*, over the state tables and *wanted* (version_id)."""
    steps = _summing(Pipeline(small=frozenset({"frozen", "wanted"})))  # read several times: planned once
    add(steps, "stored/mismatched")
    return steps


@cache
def first_rows(table: str) -> exp.Query | None:
    """Return what a new table is given of an older state: rows that it lacks; None for none."""
    if table == "horizon":
        steps = Pipeline()
        add(steps, "stored/first_horizons")
        return steps.query("first_horizons")
    if table == "checksum":
        steps = Pipeline()
        add(steps, "stored/unsummed", name="wanted")
        return _summing(steps, _FIRST_ENDS).query("checksum_rows")
    return None


def _summing(steps: Pipeline | None = None, ends: Sequence[str] = ENDS) -> Pipeline:
    steps = steps or Pipeline()
    frozen: list[exp.Expr] = [
        exp.alias_(exp.column(name, table="made"), name) for name in OF_VERSION if name != "support_id"
    ]
    add(steps, "stored/frozen", {"figures": frozen})
    add(steps, "stored/checksum_rows", slots(ends))
    return steps


def _mixed(number: exp.Expr, count: exp.Expr) -> exp.Expr:
    return template.fill("stored/mixed", {"number": number, "count": count})


def _figure(figure: exp.Expr, place: int) -> exp.Expr:
    mixed = _mixed(figure, exp.Literal.number(place))
    return template.fill("stored/figure", {"figure": figure, "mixed": mixed})
