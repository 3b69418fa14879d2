"""Scores of delays and grids, by which calibration chooses its settings (both sides, section 4).

A *learner* is a channel under one delay, and a support here that of a unit (a channel, or a pool) under
one delay: so the steps of the certificate and of the probe serve all delays at once.
"""

from collections.abc import Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import OfSet, add, add_stacked
from gam_db.method.certificate import coarse_key
from gam_db.method.probe import CHANGES, FROZEN, paces
from gam_db.method.slots import all_present, cell_key, code_in, coordinates, outside
from gam_db.method.vectors import add_last_codes
from gam_db.settings.parameters import AUTO, RUNGS, Parameters

DELAYS = (1, 2, 3, 5, 8, 13, 21, 34, 55)
"""Delays to choose from."""

STRETCH = 5000
"""Samples of each of the four stretches that are looked at where calibration has more than these."""

_PROBED_SHIFTS = ("shift +5 %", "shift -5 %", "shift +10 %", "shift -10 %")
"""Of the shifts those that count; of strokes and speeds all do."""

#: Steps that are kept.
_SMALL = frozenset(
    (
        *("sampled", "usual_vectors", "learnt", "block_sizes", "enough"),
        *("taught_passing", "picked", "probed", "usual", "grids", "passing"),
    )
)


def rungs(setting: Parameters) -> tuple[int, ...]:
    """Return the grids to choose from, finest first."""
    if setting.bins != AUTO:
        return (setting.grid,)
    return tuple(bins for bins in RUNGS if bins <= setting.grid)


def add_taught_samples(set_steps: OfSet) -> None:
    """Add *taught_samples* of one set: its calibration samples in order, coded on the finest grid."""
    until = exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
    read: dict[str, template.Slot] = {"read": until, "carried": [exp.column("value")]}
    set_steps.add("support/marked_codes", read, "automatic_codes")
    codes = add_last_codes(set_steps, "automatic_", ["calibrating", "value"])[0]
    parted = [exp.column("calibrating").eq(0)] if set_steps.method.is_cut() else []
    if set_steps.method.gaps[set_steps.number] is not None:
        parted.append(exp.column("breaking").eq(1))
    piece: exp.Expr = exp.Literal.number(0)
    if parted:
        piece = template.fill("automatic/piece", {"parted": exp.or_(*parted)})
    set_steps.add("automatic/taught_samples", {"piece": piece}, tables={"codes": codes})


def scoring(setting: Parameters, grids: Sequence[int], delays: Sequence[int], usual: int) -> Pipeline:
    """Return the steps up to *scores*, over the tables *taught_samples* and *learners*.

    Args:
        setting: of the set; bins are the finest of those to choose from.
        grids: bins to choose from.
        delays: by their numbers.
        usual: the delay of which another one must keep nine tenths of the vectors.
    """
    steps = Pipeline(small=_SMALL)
    add(steps, "automatic/sampled", {"stretch": STRETCH})
    inside = exp.and_(all_present(setting), exp.not_(exp.paren(outside(setting))))
    add(steps, "automatic/usual_vectors", {"delayed": _embedded(setting, usual), "inside": inside})
    taught = [
        {
            "delay_no": number,
            "delayed": _embedded(setting, delay),
            "inside": inside,
            "cell_key": cell_key(setting),
        }
        for number, delay in enumerate(delays)
    ]
    add_stacked(steps, "automatic/teachable", taught)
    block: dict[str, template.Slot] = {
        "place": exp.column("place"),
        "vectors": exp.column("vectors"),
        "window": exp.column("window_length"),
    }
    add(steps, "automatic/learnt", {"block_no": template.fill("certificate/block_no", block)})
    add(steps, "automatic/block_sizes")
    add(steps, "automatic/enough", {"least_vectors": setting.least_vectors})
    _add_grids(steps, setting, grids)
    _add_probe(steps, setting, delays)
    coarse = _coarse_key(setting, exp.column("divisor", table="grid"))
    add(steps, "automatic/scores", {"coarse_key": coarse})
    return steps


def _add_grids(steps: Pipeline, setting: Parameters, grids: Sequence[int]) -> None:
    """Add *grids*, the cells on each grid, and *passing*, the grids that calibration fills."""
    coarser = "enough"
    levels = list(reversed(range(len(grids))))
    for level in levels:
        divisor = grids[0] // grids[level]
        key: exp.Expr = exp.column("cell_key", table="vector")
        if divisor > 1:
            key = _coarse_key(setting, exp.cast(exp.Literal.number(divisor), "DOUBLE"))
        tables = {"coarser": coarser, "cells": f"cells_{level}"}
        add(steps, "automatic/cells", {"level": level, "coarse_key": key}, f"cells_{level}", tables)
        target = float(setting.target_floor)
        slots = {"level": level, "divisor": divisor, "target_floor": target}
        coarser = f"passing_{level}"
        add(steps, "automatic/passing", slots, coarser, tables)
    for name, part in (("grids", "cells"), ("passing", "passing")):
        parts = [f"{part}_{level}" for level in levels]
        steps.small |= set(parts)
        comment = template.load(f"automatic/{part}").comment
        steps.add(name, union_of(steps, parts), comment)


def _coarse_key(setting: Parameters, divisor: exp.Expr) -> exp.Expr:
    """Return the key of a vector's cell on a coarser grid."""
    key = coarse_key(setting)
    for column in list(key.find_all(exp.Column)):
        if column.name == "divisor":
            column.replace(divisor.copy())
        else:
            column.set("table", exp.to_identifier("vector"))
    return key


def _add_probe(steps: Pipeline, setting: Parameters, delays: Sequence[int]) -> None:
    """Add the cells of picked vectors after each change, for the supports that pass."""
    add(steps, "probe/taught_before")
    add(steps, "automatic/taught_passing")
    picked: dict[str, template.Slot] = {"picked": template.fill("probe/is_picked")}
    add(steps, "probe/picked", picked, tables={"taught_before": "taught_passing"})
    rows = [{"delay_no": number, **_speeds(setting, delay)} for number, delay in enumerate(delays)]
    add_stacked(steps, "automatic/probed", rows)
    bounds = exp.select(
        exp.alias_(exp.column("learner_id"), "channel_id"), "calibrated_lo", "calibrated_hi"
    ).from_(exp.to_table("learners"))
    steps.add("learner_bounds", bounds, "Learner bounds: the range of each learner.")
    add(steps, "probe/usual", tables={"bounds": "learner_bounds"})
    numbered_changes = [
        (number, of)
        for number, of in enumerate(CHANGES, start=1)
        if of.shift is None or of.name in _PROBED_SHIFTS
    ]
    changes = [
        {
            "change_no": number,
            "change_name": template.text(of.name),
            "pace": of.pace,
            "rung": of.rung,
            "shift": of.shift,
            "stroke": of.stroke,
        }
        for number, of in numbered_changes
    ]
    add_stacked(steps, "probe/changes", changes)
    moved = [f"y_{k}" for k in range(setting.m)]
    slots: dict[str, template.Slot] = {
        "samples": [exp.alias_(_sample(k), name) for k, name in enumerate(moved)],
        "codes": [
            exp.alias_(code_in(setting.grid, value=exp.column(name)), f"code_{k}")
            for k, name in enumerate(moved)
        ],
        "is_present": all_present(setting),
        "cell_key": cell_key(setting),
    }
    add(steps, "probe/changed", slots)


def _embedded(setting: Parameters, delay: int) -> list[exp.Expr]:
    """Return the delayed codes of a vector, and the piece of its oldest sample."""
    delayed_codes = [
        exp.alias_(_before("code", k * delay), of.name) for k, of in enumerate(coordinates(setting)) if k
    ]
    return [*delayed_codes, exp.alias_(_before("piece", (setting.m - 1) * delay), "oldest_piece")]


def _speeds(setting: Parameters, delay: int) -> dict[str, template.Slot]:
    """Return the slots of automatic/probed.sql: the values of vectors at each pace but frozen."""
    held = {pace: of for pace, of in paces(setting.m, delay).items() if pace != FROZEN}
    needed = sorted({lag for of in held.values() for lag in of if lag})
    farthest = sorted({of[-1] for of in held.values() if of[-1]})  # nearer samples are in no other piece
    delayed = [
        exp.alias_(_before(column, lag), f"{column}_{lag}")
        for column, delays in (("value", needed), ("piece", farthest))
        for lag in delays
    ]
    reached: list[exp.Expr] = []
    for pace in range(FROZEN):
        for k in range(1, setting.m):
            value: exp.Expr = exp.cast(exp.null(), "DOUBLE")
            if pace in held:
                value = exp.column(f"value_{held[pace][k]}")
                if k == setting.m - 1:
                    there = exp.column(f"piece_{held[pace][k]}").eq(exp.column("piece"))
                    value = template.case([(there, value)], None)
            reached.append(exp.alias_(value, f"x_{pace}_{k}"))
    return {"delayed": delayed, "reached": reached}


def _sample(k: int) -> exp.Expr:
    """Return a coordinate of a vector after a change, of the values at each pace."""

    def at(pace: int) -> exp.Expr:
        return exp.column(f"x_{pace}_{k}" if k else "x_0", table="vector")

    pace = exp.column("pace", table="change")
    newest = exp.column("x_0", table="vector")
    paced = template.case(((pace.eq(of), at(of)) for of in range(FROZEN) if k), newest)
    return template.fill("probe/sample", {"usual": at(0), "paced": paced})


def _before(column: str, delay: int) -> exp.Expr:
    """Return the value of a column so many samples before."""
    if not delay:
        return exp.column(column)
    return template.fill("embedding/delayed", {"column": exp.column(column), "delay": delay})
