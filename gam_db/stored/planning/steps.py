"""The steps of a run: from the rows of a cohort to the rows that it appends to the state tables.

This module owns which files of ``sql/`` a run uses, and in which order; it runs nothing. Everything
that differs from run to run comes in tables (*cohort*, *stamp*), so the steps of a setting are made
once.
"""

import datetime as dt
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO, TimeKind
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method import Method
from gam_db.method.adding import OfSet, add
from gam_db.method.alarms import NEAR, add_counted, add_spreads, band_of
from gam_db.method.bits import Bits
from gam_db.method.calibration import add_learnable
from gam_db.method.certificate import add_judgement
from gam_db.method.delays import INCOMPLETE
from gam_db.method.judgement import limit_slots
from gam_db.method.probe import add_certified, add_probe
from gam_db.method.programs import (
    JUDGED,
    add_judged_programs,
    add_samples,
    add_taught_programs,
    has_programs,
    identified_slots,
)
from gam_db.method.ranges import add_bounds
from gam_db.method.resolved import SMALL_OF_SET
from gam_db.method.scoring import (
    add_buckets,
    add_numbered,
    add_support_bits,
)
from gam_db.method.vectors import span_of
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import MIN_MAX, ROBUST, Parameters
from gam_db.stored.planning.moving import add_moves
from gam_db.stored.planning.published import add_published
from gam_db.stored.planning.setting import NO_FIGURES, Setting

#: What is kept of the vector that ends a bucket, and how it is called there.
ENDS = {"position": "end_position", "context_time": "context_time"}

#: A day, in microseconds.
DAY = 86_400_000_000

#: What a calibration appends of what it learnt: of a support, and of a version.
OF_SUPPORT, OF_VERSION = (
    ("bounds", "block", "ladder", "probe", "program", "support"),
    ("buffered", "band", "extent"),
)
LEARNT = (*OF_SUPPORT, *OF_VERSION)

#: Steps of a run that are kept: what is read once, and what has few rows.
SMALL_STEPS = frozenset(
    (
        *("identified", "timeline", "collapsed", "seen", "run_up", "moving_codes"),
        f"{INCOMPLETE}moving_codes",
        *("judged_programs", "unknown_programs"),
        *("support_bits", "visited", "buckets", "new_buckets", "recount", "stillness"),
    )
)


#: Steps of a plan: a row per version, read several times.
_PLANNED = frozenset(("active", "restart", "newest", "last_reads"))


def plan_steps(monitor_id: int, lookback: int, since: int = 0) -> Pipeline:
    """Return the steps that tell from where on each version must be read; the last is *plan*.

    They rely on what runs recorded, ``since`` the first run that is looked at, and look at no bucket; a
    version without a later run has no restart. The lookback is in the unit of time.
    """
    steps = Pipeline(small=_PLANNED)
    add(steps, "stored/state/active", {"monitor_id": monitor_id})
    add(steps, "stored/scoring/recorded", {"at_least": lookback, "since": since}, name="restart")
    return _planned(steps, since)


def searched_plan_steps(monitor_id: int, lookback: int | None, repair_from: int | None) -> Pipeline:
    """Return steps as :func:`plan_steps` does that look at all buckets instead.

    Without a lookback they begin anew; from the instant ``repair_from`` on they do in any case.
    """
    steps = Pipeline(small=_PLANNED)
    slots = {
        "lookback": FAR_AHEAD if lookback is None else lookback,
        "repair_from": FAR_AHEAD if repair_from is None else repair_from,
        "pruned_stay": 0 if lookback is None else 1,
    }
    add(steps, "stored/state/active", {"monitor_id": monitor_id})
    add(steps, "stored/state/newest")
    add(steps, "stored/scoring/restart", slots)
    return _planned(steps, 0)


def whole_plan_steps(monitor_id: int) -> Pipeline:
    """Return steps as :func:`plan_steps` does, for versions of which rows have gone from the source.

    They begin at the first bucket whose context is still there whole. Given by the caller is
    *oldest_rows* (version_id, oldest_time); *restart* says besides where the buckets begin.
    """
    steps = Pipeline(small=_PLANNED)
    add(steps, "stored/state/active", {"monitor_id": monitor_id})
    add(steps, "stored/state/newest")
    add(steps, "stored/scoring/whole", name="restart")
    return _planned(steps, 0)


def _planned(steps: Pipeline, since: int) -> Pipeline:
    add(steps, "stored/scoring/last_reads", {"long_ago": LONG_AGO, "since": since})
    add(steps, "stored/scoring/plan", {"long_ago": LONG_AGO})
    return steps


def reading_steps(rows: exp.Query, is_ranged: bool = True) -> Pipeline:
    """Return the only steps that read the source, up to *identified*, and *recount* after it.

    The rows are the step *readings*; each channel is read in its own range only, if ``is_ranged``.
    """
    steps = Pipeline()
    steps.add("readings", rows, template.load("source/readings").comment)
    add(steps, "source/names")
    add(steps, "stored/scoring/channels")
    edges = [exp.column(name, table="named") for name in ("read_from", "read_until")]
    ranged = exp.Between(this=exp.column("time", table="reading"), low=edges[0], high=edges[1])
    slots = identified_slots(ranged if is_ranged else exp.true(), has_programs(rows))
    add(steps, "source/identified", slots)
    add(steps, "stored/scoring/calibration")
    add(steps, "stored/scoring/recount")
    return steps


@cache
def scoring_steps(
    setting: Setting,
    kind: TimeKind,
    bits: Bits | None = None,
    compared: bool = False,
    recounted: bool = True,
) -> Pipeline:
    """Return the steps from *identified* to the rows that are appended, of channels of one shape.

    Each instant of a channel is expected once. Where *repeated_instants* has a row, one occurs twice:
    no row must be appended, and *identified* be collapsed. With ``bits`` supports are kept so, and cells
    are looked up in them. Buckets are ``compared`` with what is stored of them, and those before the
    first that differs not written.

    Given by the caller are the state tables, *identified*, *past_buckets*, *recount* (where the rows of
    calibration are ``recounted``), *stamp* (run_id,
    started, committed, deletes_hidden), and *cohort*: the channels, from where on each is read and
    scored, the number of its first bucket, and its lookback; to compare, *former_buckets* and
    *former_novel*.
    """
    # Settings in which the channels of a run may differ are columns.
    columns = ("bins", "radix", *["max_gap"] * (setting.max_gap is not None))
    columns += ("tau", "stride", "buckets") * setting.by_column
    steps = _frozen(columns)
    # Where calibration is scored, too, the steps look first: no vector carries a mark.
    trusting = can_trust(setting, kind)
    add_counting(steps, setting, kind, trusting=trusting, bits=bits, columns=columns)
    _add_stillness(steps, setting, kind)
    if trusting:
        marked: dict[str, template.Slot] = {"names": [exp.column("channel_id")]}
        add(steps, "census/repeated_instants", marked, tables={"marked": "visited"})
    add(steps, "stored/scoring/settled")
    if not recounted:
        add(steps, "stored/scoring/no_recount", name="recount")
        steps.small -= {"recount"}
    add_published(steps, setting.has_programs, compared)
    return steps


def add_counting(
    steps: Pipeline,
    setting: Setting,
    kind: TimeKind,
    has_past: bool = True,
    trusting: bool = False,
    bits: Bits | None = None,
    columns: Sequence[str] = (),
) -> OfSet:
    """Add the steps from *identified* to *new_buckets* and *bucket_counts*; return their set.

    The steps hold *cohort*, and what is frozen of its channels: channels, bounds, calibration, support.
    With ``has_past`` there may be buckets that stay (*stored_visible_bucket*). One that is ``trusting``
    expects each instant once; bits are those of :func:`scoring_steps`. Settings that are ``columns`` of
    the cohort may differ.
    """
    of_set = _add_samples(steps, setting, kind, trusting, columns=columns)
    if setting.has_programs:
        add(steps, "stored/scoring/judged_programs")
        judged = {"numbered_programs": "judged_programs"}
        add(steps, "program/program_samples", name=JUDGED, tables=judged)
    add_support_bits(of_set, bits)
    _add_new_buckets(of_set, trusting, bits)
    buckets = "new_buckets"
    if has_past:
        add(steps, "stored/scoring/past_buckets", past_slots(setting, exp.true()))
        carried = ("channel_id", "bucket_no", "first_time", "last_time", "novel", "out_of_range")
        read = (*carried, *["buckets"] * setting.by_column)
        buckets = "running_buckets"
        steps.add(
            buckets,
            union_of(steps, ["past_buckets", "new_buckets"], read),
            "Running buckets: those of this run after the last window of those that stay.",
        )
    of_set.add("health/bucket_counts", tables={"buckets": buckets})
    return of_set


@cache
def explaining_steps(setting: Setting, kind: TimeKind) -> Pipeline:
    """Return the steps from *identified* to *banded* and *move_counts*, over windows read again.

    They say where the signal was in them, and what of their novelty a change of it as a whole explains.
    """
    steps = _frozen()
    of_set = add_counting(steps, setting, kind, has_past=False)
    band = band_of(exp.column("cell_key", table="visit"), template.node_of(setting.bins))
    add(steps, "stored/alarms/banded", {"window": setting.window_length, "band": band})
    add_moves(of_set)
    steps.small |= {"scored_vectors", "reread", "moves"}  # few windows; a second pass costs as much
    return steps


@cache
def learning_steps(
    setting: Setting,
    kind: TimeKind,
    target_floor: float,
    least_vectors: int,
    is_robust: bool,
    has_pools: bool,
) -> Pipeline:
    """Return the steps from *identified* to what calibration appends, over intervals that are stored.

    Given by the caller are the state tables, *identified*, *cohort*, which is *limits*, too, and
    *numbering*; the last steps are the rows of :data:`LEARNT`, and *recount*.
    """
    steps = Pipeline(small=SMALL_STEPS | SMALL_OF_SET | {"learnt", "certified", "changes"})
    for name in ("channels", "calibration", "calibration_range", "recount"):
        add(steps, f"stored/scoring/{name}")
    rule = ROBUST if is_robust else MIN_MAX
    learning = {"target_floor": target_floor, "least_vectors": least_vectors, "range": rule}
    of_set = _add_samples(steps, setting, kind, learning=learning, has_pools=has_pools)
    add(steps, "calibration/calibrated")
    add_taught_programs(steps, of_set.method.programs)
    add_bounds(of_set)
    add_learnable(of_set)
    add_judgement(of_set)
    add_judged_programs(of_set)
    add_probe(of_set)
    add_certified(steps, has_pools, setting.has_programs)
    add(steps, "judgement/limited", limit_slots(exp.column("target_floor", table="scale")))
    add_counted(steps)
    add_spreads(steps, ())
    for part in (part for part in LEARNT if part != "program" or setting.has_programs):
        slots: dict[str, template.Slot] = {"g": NEAR} if part == "extent" else {}
        add(steps, f"stored/calibrating/{part}_rows", slots)
    return steps


def can_trust(setting: Setting, kind: TimeKind) -> bool:
    """Tell whether there is a trusting form of the steps: where all after calibration is scored."""
    return method_of(setting, kind).is_parted


def _frozen(columns: Sequence[str] = ()) -> Pipeline:
    """Return the steps of the frozen values of the channels of a cohort."""
    steps = Pipeline(small=SMALL_STEPS)
    for name in ("channels", "bounds", "calibration", "support"):
        add(steps, f"stored/scoring/{name}", _read_as(columns) if name == "bounds" else None)
    add(steps, "stored/scoring/calibration_range")
    return steps


def _add_samples(
    steps: Pipeline,
    setting: Setting,
    kind: TimeKind,
    trusting: bool = False,
    learning: Mapping[str, Any] | None = None,
    columns: Sequence[str] = (),
    has_pools: bool = False,
) -> OfSet:
    """Add the steps from *identified* to the samples, and return the one set of the setting."""
    of_set = OfSet(steps, method_of(setting, kind, learning, columns, has_pools), 0)
    if trusting:
        add(steps, "census/trusted_timeline", name="timeline")
        columns = ("channel_id", "time", "value", *["program"] * setting.has_programs)
        rows = union_of(steps, ["identified"], columns)
        steps.add("samples", rows, "Samples: every reading is one.")
        return of_set
    add(steps, "stored/scoring/repeats", name="timeline")
    add_samples(steps, setting.programs)
    return of_set


def _add_new_buckets(of_set: OfSet, trusting: bool = False, bits: Bits | None = None) -> None:
    steps, setting = of_set.steps, of_set.setting
    add(steps, "stored/scoring/seen")
    span = span_of(of_set, "member")
    add(steps, "stored/scoring/run_up", {"span": span, **_read_as(of_set.method.columns)})
    ends = dict(ENDS)
    has_stillness = setting.still_after is not None
    if not of_set.method.is_parted:
        add_numbered(of_set, bits, carried=["still_so_far"] * has_stillness)
    if has_stillness:
        ends["still_so_far"] = "end_still"
    add_buckets(of_set, ends, trusting, bits)
    add(steps, "stored/scoring/bucket_ends")
    add(
        steps,
        "stored/scoring/new_buckets",
        {"differing": _differing("buckets" in of_set.method.columns)},
    )


def past_slots(setting: Setting, near: exp.Expr) -> dict[str, template.Slot]:
    """Return the slots of past_buckets.sql; the condition on *bucket* holds for all of them."""
    buckets: int | exp.Expr = setting.window_length // setting.stride
    if setting.by_column:
        buckets = exp.column("buckets", table="member")
    return {"buckets": buckets, "differing": _differing(setting.by_column), "near": near}


def _differing(by_column: bool) -> list[exp.Expr]:
    """Return the buckets of a window as a column, where channels differ in them."""
    buckets = exp.cast(exp.column("buckets", table="member"), "INT")
    return [exp.alias_(buckets, "buckets")] * by_column


def _add_stillness(steps: Pipeline, setting: Setting, kind: TimeKind) -> None:
    """Add how many samples of each new bucket stand still, and since when the newest do."""
    if setting.still_after is None:
        for name in ("stillness", "still_counts"):
            add(steps, "stored/scoring/no_stillness", name=name)
        steps.small -= {"stillness"}
        return
    codes = f"{INCOMPLETE}moving_codes" if can_trust(setting, kind) else "moving_codes"
    slots, tables = {"long_ago": LONG_AGO}, {"moving_codes": codes}
    add(steps, "stored/scoring/stillness", slots, tables=tables)
    add(steps, "stored/scoring/still_counts")


def _read_as(columns: Sequence[str]) -> dict[str, template.Slot]:
    """Return the slot of the settings that are read as columns of the cohort, as narrow as they are."""
    read = {
        "bins": exp.cast(exp.column("bins", table="member"), "INT"),
        "radix": template.fill("embedding/radix"),
        "tau": exp.cast(exp.column("tau", table="member"), "INT"),
        **{name: exp.column(name, table="member") for name in ("max_gap", "stride", "buckets")},
    }
    return {"settings": [exp.alias_(read[name], name) for name in columns]}


def method_of(
    setting: Setting,
    kind: TimeKind,
    learning: Mapping[str, Any] | None = None,
    columns: Sequence[str] = (),
    has_pools: bool = False,
) -> Method:
    """Return the method of a stored version; its calibration is in the tables, and so are its pools.

    What its certificate was asked for is not needed to score.
    """
    gap: Any = setting.max_gap
    if gap is not None and not kind.is_counter:
        gap = dt.timedelta(microseconds=gap)
    figures = setting._asdict() | {"max_gap": gap, "window": setting.window_length}
    del figures["window_length"]
    for name in NO_FIGURES:
        del figures[name]
    start = None
    if setting.has_start:
        start = 0 if kind.is_counter else dt.date(1970, 1, 1)
    parameters = Parameters(**figures, **(learning or {}))
    calibration = Calibration(score_from=start, pool=[["*"]] if has_pools else None)
    return Method(parameters, calibration, kind, columns=tuple(columns), programs=setting.programs)
