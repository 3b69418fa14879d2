"""Novelty (Eq. 4) and its running counts (Eq. 2) of one set: per vector, and in buckets."""

from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import union_of
from gam_db.method.adding import OfSet
from gam_db.method.bits import Bits
from gam_db.method.calibration import add_marked_codes
from gam_db.method.delays import COMPLETE, INCOMPLETE
from gam_db.method.programs import JUDGED, coded
from gam_db.method.vectors import add_vectors, compared, span_of, varying
from gam_db.settings.parameters import LARGEST_KEY, Parameters


def add_support_bits(set_steps: OfSet, bits: Bits | None) -> None:
    """Add the support of one set as bits, where the engine keeps it so and its grid is small enough."""
    setting = set_steps.setting
    if bits is not None and bits.serve(setting.radix**setting.m):
        cells = bits.gathered(exp.column("cell_key"), setting.radix**setting.m)
        set_steps.add("support/support_bits", {"bits": cells})


def add_novelty(
    set_steps: OfSet,
    carried: Sequence[exp.Expr],
    bits: Bits | None,
    prefix: str = "",
    monitored: str = "monitored",
    by_sets: bool = False,
) -> None:
    """Add Eq. 4 over *monitored* of a prefix.

    It is by the support as bits where there is one, else by the support as a set if the engine looks
    that up at less cost, else by a join.
    """
    slots: dict[str, template.Slot] = {"carried": carried}
    file, setting = "score/novelty", set_steps.setting
    if by_sets:
        file, sought = "census/novelty_set", _set_key(setting, "vector")
        slots["sought"] = sought[0] if len(sought) == 1 else exp.Tuple(expressions=sought)
        slots["cell"] = _set_key(setting, "healthy")
    if bits is not None and bits.serve(setting.radix**setting.m):
        held = (exp.column("bits", table="healthy"), exp.column("cell_key", table="vector"))
        file, slots["is_held"] = "score/novelty_bits", bits.held(*held)
    renamed = {"monitored": f"{prefix}{monitored}"}
    set_steps.add(file, slots, f"{prefix}novelty", renamed)


def add_scoring(set_steps: OfSet, bits: Bits | None = None) -> None:
    """Add Eq. 4 and the running counts of Eq. 2 of one set, a row per scored vector."""
    if set_steps.method.is_cut():
        add_numbered(set_steps, bits)
    else:
        _add_vectors_from_run_up(set_steps, "", ["oldest_time"], exp.true())
        straddling = template.case([(template.fill("score/straddling"), 1)], 0)
        _add_counted(set_steps, "", template.fill("score/counted"), straddling, bits=bits)
    set_steps.add("health/window_counts")


def add_numbered(set_steps: OfSet, bits: Bits | None = None, carried: Sequence[str] = ()) -> None:
    """Add Eq. 4 of one set by its intervals, also where samples of calibration are scored.

    The vectors' ``still_so_far`` travels with them where it is ``carried``.
    """
    add_marked_codes(set_steps, "", exp.true(), JUDGED)
    add_vectors(set_steps, "", ["calibration_vector", "straddling", *carried])
    counted = exp.and_(template.fill("score/counted"), template.fill("score/untaught"))
    _add_counted(set_steps, "", counted, exp.column("straddling", table="vector"), carried, bits)


def add_incomplete(
    set_steps: OfSet, carried: Sequence[str], bits: Bits | None = None, by_sets: bool = False
) -> None:
    """Add Eq. 4 of channels with missing samples, whose vectors must be numbered one by one.

    Others stay as well where their mark ``doubled`` is ``carried``, and 1.
    """
    counted: exp.Expr = template.fill("score/counted")
    if "doubled" in carried:
        counted = exp.or_(counted, exp.column("doubled", table="vector").eq(1))
    unasked = exp.cast(exp.null(), "INT")
    _add_counted(set_steps, INCOMPLETE, counted, unasked, carried, bits, by_sets)


def _add_counted(
    set_steps: OfSet,
    prefix: str,
    counted: exp.Expr,
    straddling: exp.Expr,
    carried: Sequence[str] = (),
    bits: Bits | None = None,
    by_sets: bool = False,
) -> None:
    """Add Eq. 4 of the vectors of a prefix that are counted, and number them."""
    renamed = {name: f"{prefix}{name}" for name in ("vectors", "novelty")}
    travelling = [_carried(name) for name in carried]
    monitored_columns: list[exp.Expr] = [
        exp.alias_(straddling, "straddling"),
        *travelling,
        *_stride(set_steps, "scale"),
    ]
    slots: dict[str, template.Slot] = {"carried": monitored_columns, "counted": counted}
    set_steps.add("score/monitored", slots, f"{prefix}monitored", renamed)
    travelling = [_carried("straddling"), *travelling, *_stride(set_steps, "vector")]
    add_novelty(set_steps, travelling, bits, prefix, by_sets=by_sets)
    columns = [*(exp.column(name) for name in carried), *_stride(set_steps)]
    named: dict[str, template.Slot] = {"carried": columns}
    set_steps.add("health/numbered", named, f"{prefix}numbered", renamed)


def add_running(set_steps: OfSet, parts: Sequence[str]) -> None:
    """Add the scored vectors of one set as *numbered*, over the steps that hold them with their numbers.

    Every sample before the first of them is one of calibration.
    """
    running_steps, columns = (
        [],
        ("channel_id", "time", "cell_key", "out_of_range", "straddling", "number"),
    )
    for part in parts:
        is_counted = part == f"{INCOMPLETE}numbered"
        counted = exp.column("novel_so_far", table="vector")
        so_far = counted if is_counted else template.fill("health/novel_so_far")
        running_steps.append(f"{part}_running")
        set_steps.add("health/running", {"novel_so_far": so_far}, running_steps[-1], {"vectors": part})
    rows = union_of(
        set_steps.steps,
        [set_steps.named(step) for step in running_steps],
        [*columns, "novel", "novel_so_far"],
    )
    set_steps.steps.add(set_steps.named("numbered"), rows, template.load("health/running").comment)


def add_buckets(
    set_steps: OfSet,
    ends: Mapping[str, str] | None = None,
    trusting: bool = False,
    bits: Bits | None = None,
) -> None:
    """Add Eq. 4 of one set in full buckets, and the novel cells of each.

    Where every channel is scored from the end of its calibration on, vectors of half the columns give
    the same buckets; else *numbered* is read. A ``trusting`` run, of the former alone, takes it that no
    instant occurs twice; *visited* then has ``doubled``, the proof to the contrary.

    Ends are columns of the vector that ends a bucket, and what they are called in *visited*; they travel
    with all vectors and cost time, so there are none unless asked for.
    """
    ends = ends or {}
    if set_steps.method.is_parted:
        marks = [*["doubled"] * trusting, *["still_so_far"] * ("still_so_far" in ends)]
        parts = ["incomplete_numbered"]
        # Where segments end or samples stand still, vectors are numbered as where some are missing.
        is_whole = set_steps.method.is_unbroken(set_steps.number)
        if is_whole:
            _add_complete_scoring(set_steps, marks, bits)
            parts = ["complete_novelty", *parts]
        _add_vectors_from_run_up(set_steps, INCOMPLETE, marks, None if is_whole else exp.true())
        add_incomplete(set_steps, marks, bits)
    else:
        parts = ["numbered"]
    add_scored_groups(set_steps, parts, ends, trusting)


def add_scored_groups(
    set_steps: OfSet,
    parts: Sequence[str],
    ends: Mapping[str, str] | None = None,
    trusting: bool = False,
    counted: str = "visited",
) -> None:
    """Add the groups of scored vectors, which lie with their numbers in some steps; see add_buckets.

    Buckets are made of the step ``counted``: where it is not *visited*, its rows are not parted by cell.
    """
    marks = ("doubled",) if trusting else ()
    columns = (
        "channel_id",
        "time",
        "number",
        "cell_key",
        "novel",
        "out_of_range",
        "position",
        *(ends or {}),
        *marks,
        *(column.name for column in _stride(set_steps)),
    )
    set_steps.steps.add(
        set_steps.named("scored_vectors"),
        union_of(
            set_steps.steps, [set_steps.named(part) for part in parts], list(dict.fromkeys(columns))
        ),
        "Scored vectors: every scored vector with its number.",
    )
    for name in dict.fromkeys(("visited", counted)):
        slots = visited_slots(set_steps.setting, ends, trusting, name == "visited")
        if stride := _stride(set_steps):
            slots["stride"] = stride[0]
        set_steps.add("health/visited", slots, name)
    set_steps.add("health/buckets", tables={"visited": counted})
    set_steps.add("health/novel_cells")


def visited_slots(
    setting: Parameters,
    ends: Mapping[str, str] | None = None,
    trusting: bool = False,
    by_cell: bool = True,
) -> dict[str, template.Slot]:
    """Return the slots of health/visited.sql; see :func:`add_buckets` and :func:`add_scored_groups`."""
    ends = ends or {}
    cell: exp.Expr = exp.column("novel_cell")
    part = cell
    if not by_cell:
        novel = exp.column("novel_cell", table="visit")
        cell = exp.alias_(exp.Min(this=novel), "novel_cell")
        part = exp.case().when(novel.is_(exp.null()), "0").else_("1")
    carried = list(ends)
    needed: exp.Expr = exp.false()
    gathered = [_gathered(name, alias, "closing") for name, alias in ends.items()]
    if trusting:
        carried.append("doubled")
        marked = exp.cast(exp.Max(this=exp.column("doubled", table="visit")), "SMALLINT")
        gathered.append(exp.alias_(marked, "doubled"))
        needed = exp.column("doubled").eq(1)
    return {
        "stride": setting.bucket_length,
        "outside": exp.column("out_of_range"),
        "carried": [exp.column(name) for name in carried],
        "needed": needed,
        "gathered": gathered,
        "cell": cell,
        "part": part,
    }


def _add_complete_scoring(set_steps: OfSet, marks: Sequence[str], bits: Bits | None) -> None:
    """Add Eq. 1 and Eq. 4 of channels without missing samples, with their marks."""
    prefix = COMPLETE
    _add_vectors_from_run_up(set_steps, prefix, marks)
    travelling = [_carried(mark) for mark in marks]
    carried = [number_of(span_of(set_steps, "scale")), *travelling, *_stride(set_steps, "scale")]
    slots: dict[str, template.Slot] = {"carried": carried, "counted": exp.true()}
    set_steps.add("score/monitored", slots, f"{prefix}monitored", {"vectors": f"{prefix}vectors"})
    add_novelty(
        set_steps, [_carried("number"), *travelling, *_stride(set_steps, "vector")], bits, prefix
    )


def number_of(span: int | exp.Expr) -> exp.Expr:
    """Return the column of a vector's number where no sample is missing, of a span in samples."""
    return exp.alias_(template.fill("score/number", {"span": span}), "number")


def _stride(set_steps: OfSet, table: str | None = None) -> list[exp.Expr]:
    """Return the column of the vectors of a bucket, of a table, where channels differ in them."""
    if "stride" not in set_steps.method.columns:
        return []
    column = exp.column("stride", table=table)
    return [column if table is None else exp.alias_(column, "stride")]


def _add_vectors_from_run_up(
    set_steps: OfSet, prefix: str, marks: Sequence[str], read: exp.Expr | None = None
) -> None:
    """Add codes and vectors of channels with, or without, missing samples, or of those to ``read``."""
    of_prefix = exp.column("complete", table="scale").eq(int(prefix == COMPLETE))
    carried = [*compared(set_steps.setting), *varying(set_steps)]
    slots, tables = coded(set_steps, JUDGED)
    slots |= {"read": read or of_prefix, "carried": carried}
    set_steps.add("support/codes", slots, f"{prefix}codes", tables)
    add_vectors(set_steps, prefix, marks)


def _set_key(setting: Parameters, table: str) -> list[exp.Expr]:
    """Return the lookup key of a cell of a support: one number, if eight million supports fit."""
    support_id, cell_key = (exp.column(name, table=table) for name in ("support_id", "cell_key"))
    cells = setting.radix**setting.m
    if cells > LARGEST_KEY >> 23:
        return [support_id, cell_key]
    slots: dict[str, template.Slot] = {"support_id": support_id, "cells": cells, "cell_key": cell_key}
    return [template.fill("census/set_key", slots)]


def _gathered(name: str, alias: str, where: str) -> exp.Expr:
    """Return the largest value of a column, of the rows alone where another one is 1."""
    value = exp.column(name, table="visit")
    chosen = exp.If(this=exp.column(where, table="visit").eq(1), true=value)
    return exp.alias_(exp.Max(this=exp.Case(ifs=[chosen])), alias)


def _carried(name: str) -> exp.Expr:
    return exp.alias_(exp.column(name, table="vector"), name)
