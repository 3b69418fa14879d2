"""The steps of a script: each formula is a step, and each step is spelled out once.

A script collapses repeated instants always, and calls channels by their names: with them in every window
a filter on one signal reads no other one's rows. Channels of pools share a support, and machines with
programs have one of each: their scripts are made of the steps of :mod:`gam_db.method.order`.
"""

from collections.abc import Collection, Mapping, Sequence

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import OfSet, add, add_stacked
from gam_db.method.certificate import coarse_key
from gam_db.method.judgement import limit_of, limit_slots
from gam_db.method.parts import LEFT_OUT, PARTS, RESULTS
from gam_db.method.probe import CHANGES, changed_slots, paces, probed_delays, slots_of
from gam_db.method.ranges import _ROUND, DROPPED, ROUNDS, counts_of, is_robust, piece, taught
from gam_db.method.resolved import Method
from gam_db.method.slots import code_of
from gam_db.method.source import by_override, named_like
from gam_db.method.vectors import (
    _before,
    _context,
    _earlier,
    _flag,
    _named,
    _newest,
    add_last_codes,
    compared,
    delays_of,
)
from gam_db.settings.calibration import Rule
from gam_db.settings.source import TimeNode


def printed_pipeline(
    method: Method,
    readings: exp.Query,
    instant_of: TimeNode,
    parts: Collection[str] = PARTS,
    framed: bool = False,
) -> Pipeline:
    """Return the steps of a script.

    The last ones are *health_indicator* and those of :data:`gam_db.method.parts.RESULTS`.

    Args:
        method: without pools and programs.
        readings: the step *readings*.
        instant_of: turns integer time into what the source has.
        parts: of :data:`gam_db.method.parts.PARTS`; the others need the first.
        framed: whether the engine takes frames lightly that begin so many rows before.
    """
    steps = Pipeline()
    for either in list(readings.find_all(exp.Or)):
        if isinstance(either.expression, exp.Is):  # rows without a time are no samples
            either.replace(either.this.unnest())
    steps.add("readings", readings, template.load("source/readings").comment)
    add(steps, "script/samples")
    _add_channels(steps, method)
    edges = {name: instant_of(exp.column(name, table="counted")) for name in ("first_time", "last_time")}
    for number in range(len(method.settings)):
        set_steps = OfSet(steps, method, number)
        _add_learning(set_steps, framed)
        condition = taught(set_steps.setting, exp.column("calibration_vector").eq(1))
        if "certificate" in parts:
            set_steps.add("script/learnt", {"taught": condition})
            set_steps.add("script/visits")
            set_steps.add("script/support")
            _add_certificate(set_steps, parts, edges)
        else:
            set_steps.add("script/cells", {"taught": condition}, "support")
        _add_health(set_steps, instant_of, framed)
    _join(steps, method, "health_indicator")
    names = steps.steps["health_indicator"].query.named_selects
    if "certificate" in parts:
        for name in (name for name, part in RESULTS.items() if part in parts and name != "health"):
            _join(steps, method, name)
        add(
            steps,
            "script/health",
            {"columns": [exp.column(name, table="vector") for name in names if name != "asset"]},
        )
    return steps


#: What a long table's rows are called before they are readings, and after.
_READ_AS = {"asset_name": "asset", "channel_name": "channel", "instant": "time"}


def rename(readings: exp.Query) -> None:
    """Rename the columns of a long table to their later names at once, in place.

    On engines where a column of the source goes before an alias of the same name in a condition.
    """
    for node in readings.find_all(exp.Alias, exp.Column):
        name = node.args.get("alias") if isinstance(node, exp.Alias) else node.this
        if isinstance(name, exp.Identifier) and not name.quoted and name.name in _READ_AS:
            name.set("this", _READ_AS[name.name])


def _join(steps: Pipeline, method: Method, step: str) -> None:
    """Unite the rows of all sets, if there are several."""
    if len(method.settings) > 1:
        parts = [method.named(step, number) for number in range(len(method.settings))]
        steps.add(step, union_of(steps, parts), template.load(f"script/{step}").comment)


def _add_channels(steps: Pipeline, method: Method) -> None:
    """Add the channels, each with its healthy period."""
    first, quota = exp.column("first_time"), exp.column("quota_time")
    ends, begins, scored, quotas = [], [], [], []
    for rule in method.rules:
        end: exp.Expr = exp.null()
        if rule.fraction is not None:
            end = quota
        elif rule.duration is not None:
            end = exp.Add(this=first, expression=template.node_of(rule.duration))
        elif rule.declared_end is not None:
            end = template.node_of(rule.declared_end)
        after = exp.Add(this=end.copy(), expression=exp.Literal.number(1))
        begun = template.node_of(rule.score_from) if rule.score_from is not None else None
        if begun is None and rule.fraction is not None:
            begun = exp.Coalesce(this=after, expressions=[template.node_of(LONG_AGO)])
        elif begun is None:
            begun = template.node_of(LONG_AGO) if isinstance(end, exp.Null) else after
        quotas.append(_quota(rule))
        ends.append(exp.cast(end, "BIGINT") if isinstance(end, exp.Null) else end)
        begins.append(first if rule.declared_end is None else template.node_of(LONG_AGO))
        scored.append(begun)
    slots = {
        "settings_no": by_override(method.parameters, method.settings.index),
        "quota": _of_rule(method, quotas),
        "calibration_from": _of_rule(method, begins),
        "calibration_end": _of_rule(method, ends),
        "first_scored": _of_rule(method, scored),
    }
    add(steps, "script/channels", slots)


def _quota(rule: Rule) -> exp.Expr:
    if rule.fraction is None:
        return exp.cast(exp.null(), "BIGINT")
    return template.fill("script/quota", {"fraction": rule.fraction})


def _of_rule(method: Method, values: Sequence[exp.Expr]) -> exp.Expr:
    """Return the value of the rule that a channel has, by the name of its machine."""
    general, *others = values
    cases: list[tuple[exp.Expr, int | None | exp.Expr]] = []
    for asset, value in zip(method.assets, others, strict=True):
        condition = named_like("asset", asset)
        if condition is None:
            return template.case(cases, value)
        cases.append((condition, value))
    return template.case(cases, general) if cases else general


def _healthy(method: Method) -> exp.Expr:
    """Return the condition that a sample is of the healthy period of its channel."""
    conditions = [_of_period(rule) for rule in method.rules]
    if len(conditions) == 1:
        return conditions[0]
    flags = [template.case([(condition, 1)], 0) for condition in conditions]
    chosen = _of_rule(method, flags)
    for column in chosen.find_all(exp.Column):
        if column.name == "asset":
            column.set("table", exp.to_identifier("scale"))
    return exp.EQ(this=chosen, expression=exp.Literal.number(1))


def _of_period(rule: Rule) -> exp.Expr:
    time = exp.column("time", table="sampled")
    pieces = [
        exp.Between(this=time.copy(), low=template.node_of(start), high=template.node_of(end))
        for start, end in rule.allowed
        if (start, end) != (LONG_AGO, FAR_AHEAD)
    ]
    if not rule.allowed:
        return exp.false()
    if rule.declared_end is not None:
        return exp.or_(*pieces) if pieces else exp.true()
    edges = [exp.column(f"calibration_{edge}", table="scale") for edge in ("from", "end")]
    within = exp.Between(this=time, low=edges[0], high=edges[1])
    return exp.and_(within, exp.or_(*pieces)) if pieces else within


def _add_learning(set_steps: OfSet, framed: bool) -> None:
    """Add Phi and Eq. 1 of one set: from its samples to its vectors."""
    setting, method = set_steps.setting, set_steps.method
    set_steps.add("script/history", {"healthy": _healthy(method)})
    _add_bounds(set_steps)
    compared_columns = compared(setting)
    slots: dict[str, template.Slot] = {"code": code_of(setting), "carried": compared_columns}
    set_steps.add("script/codes", slots)
    codes, over, whole = add_last_codes(set_steps, "", ["calibrating", "first_scored", "value"])
    delays = delays_of(set_steps)
    over |= {f"code_{k}": _before("code", delays[k]) for k in range(1, setting.m)}
    over |= {f"calibrating_{k}": _before("calibrating", delays[k]) for k in range(1, setting.m)}
    calibrating = [exp.column(f"calibrating_{k}") for k in range(setting.m)]
    if framed:
        over["all_healthy"] = template.fill("script/all_healthy", {"span": setting.span})
        healthy: exp.Expr = exp.column("all_healthy")
    else:
        over["oldest_time"] = _before("time", setting.span)
        over["last_uncalibrated"] = _newest(exp.column("calibrating").eq(0), setting.span)
        healthy = _flag(template.fill("embedding/in_calibration"))
    touching = exp.or_(
        *(template.fill("embedding/straddling", {"calibrating": of}) for of in calibrating)
    )
    first = exp.column("first_scored")
    slots = {
        "delayed": [exp.alias_(exp.column("calibrating"), calibrating[0].name), first, *_named(over)],
        "context": _context(setting, setting.span),
        "carried": [
            exp.alias_(healthy, "calibration_vector"),
            exp.alias_(_flag(touching), "straddling"),
            first,
        ],
        "whole": whole,
    }
    set_steps.add("embedding/vectors", slots, tables={"codes": codes})


def _add_bounds(set_steps: OfSet) -> None:
    """Add the range of one set: of all samples of calibration, or of all but a few far from the rest."""
    set_steps.add("script/calibrated")
    if not is_robust(set_steps.setting):
        set_steps.add("script/bounds", {"dropped": [], "carried": []})
        return
    set_steps.add("script/whole", name="range_0")
    for number in range(1, ROUNDS + 1):
        tables = {"range_before": f"range_{number - 1}"}
        set_steps.add("script/range_counts", {"piece": piece()}, counts_of(number), tables)
        set_steps.add(
            "range/narrowed", name=f"range_{number}", tables={"range_counts": counts_of(number)}
        )
    rounds = [set_steps.named(f"range_{number}") for number in range(ROUNDS + 1)]
    names = [name for name in _ROUND if name != "support_id"]
    set_steps.steps.add(
        set_steps.named("rounds"), union_of(set_steps.steps, rounds, ("asset", "channel", *names))
    )
    set_steps.add("script/ranged")
    dropped: list[exp.Expr] = []
    for name, nothing in DROPPED.items():
        column = exp.column(name, table="seen")
        there = exp.Case(ifs=[exp.If(this=exp.column("hit", table="seen").eq(1), true=column)])
        if not isinstance(nothing.this, exp.Null):
            there.set("default", exp.Literal.number(0))
        dropped.append(exp.alias_(there, name))
    carried = [exp.column(name) for name in DROPPED]
    set_steps.add(
        "script/bounds", {"dropped": dropped, "carried": carried}, tables={"calibrated": "ranged"}
    )


def _add_certificate(set_steps: OfSet, parts: Collection[str], edges: Mapping[str, exp.Expr]) -> None:
    """Add the certificate (method, section 5)."""
    setting = set_steps.setting
    bins = {k: -(-setting.grid // 2**k) for k in range(setting.grid.bit_length() + 1)}
    rungs = [k for k in bins if k == 0 or bins[k] >= 2]
    rows = [{"level": k, "divisor": 2**k, "level_bins": bins[k]} for k in rungs]
    add_stacked(set_steps.steps, "certificate/levels", rows, set_steps.named("levels"))
    set_steps.add("script/coarsened", {"coarse_key": coarse_key(setting)})
    for name in ("blocks", "shares", "floors"):
        set_steps.add(f"script/{name}")
    for name in ("verdicts", "spread"):
        set_steps.add(f"script/{name}")
    verdicts = "verdicts"
    learnt: list[exp.Expr] = []
    verdict: exp.Expr = exp.column("verdict", table="learnt")
    if "curve" in parts:
        for name in ("cell_shares", "learned", "learning"):
            set_steps.add(f"script/{name}")
        set_steps.add("certificate/outlook")
        set_steps.add(
            "script/needed", {"columns": _columns(set_steps, verdicts)}, tables={"verdicts": verdicts}
        )
        verdicts = "needed"
        learnt.append(exp.column("vectors_needed", table="learnt"))
    if "probe" in parts:
        _add_probe(set_steps)
        rules = {name: template.fill(f"probe/{name}") for name in ("would_not_see", "blind_reason")}
        for rule in rules.values():
            for column in rule.find_all(exp.Column):
                if column.table == "scale":
                    column.set("table", exp.to_identifier("learnt"))
        columns = _columns(set_steps, verdicts)
        set_steps.add("script/certified", {**rules, "columns": columns}, tables={"verdicts": verdicts})
        verdicts = "certified"
        learnt += [exp.column(name, table="learnt") for name in LEFT_OUT["probe"]]
        blind = exp.column("blind_reason", table="learnt").is_(exp.null())
        verdict = exp.Case(ifs=[exp.If(this=blind, true=verdict)], default=template.text("blind"))
    limits = limit_slots(template.node_of(float(setting.target_floor)))
    held = [column.name for column in learnt]
    for slot in limits.values():
        assert isinstance(slot, exp.Expr)
        _leave_out(slot, ("no_data", "not_vouched", *["blind"] * ("probe" not in parts)))
    reason = limits["limit_reason"]
    assert isinstance(reason, exp.Case)
    is_learnt = exp.column("hit", table="learnt").eq(1)
    nothing = exp.Case(ifs=[exp.If(this=is_learnt, true=exp.Literal.number(1))], default="0")
    none = exp.If(
        this=exp.LT(this=nothing, expression=exp.Literal.number(1)), true=template.text("no calibration")
    )
    reason.set("ifs", [none, *reason.args["ifs"]])
    dropped = tuple(DROPPED) if is_robust(setting) else ()
    slots: dict[str, template.Slot] = {
        "dropped": [exp.alias_(exp.column(name, table="scale"), name) for name in dropped],
        "verdict": verdict,
        "learnt": [exp.alias_(_where_learnt(name), name) for name in held],
        "columns": [
            exp.column(name)
            for name in set_steps.steps.steps[set_steps.named(verdicts)].query.named_selects
        ],
        **limits,
    }
    set_steps.add("script/support_summary", slots, tables={"verdicts": verdicts})
    curve = "curve" in parts
    set_steps.add("script/learned_certificate" if curve else "script/certificate", edges, "certificate")


def _leave_out(rule: exp.Expr, verdicts: Collection[str]) -> None:
    """Drop the verdicts from a rule that no channel of a script can have there."""
    for among in list(rule.find_all(exp.In)):
        values = [value for value in among.expressions if value.name not in verdicts]
        among.set("expressions", values)
        if len(values) == 1:
            among.replace(exp.EQ(this=among.this, expression=values[0]))
    for equal in list(rule.find_all(exp.EQ)):
        if isinstance(equal.expression, exp.Literal) and equal.expression.name in verdicts:
            equal.replace(exp.false())


def _where_learnt(name: str) -> exp.Expr:
    """Return a column of the calibration of a channel, NULL where it has learnt nothing."""
    hit = exp.column("hit", table="learnt").eq(1)
    return exp.Case(ifs=[exp.If(this=hit, true=exp.column(name, table="learnt"))])


def _columns(set_steps: OfSet, step: str) -> list[exp.Expr]:
    names = set_steps.steps.steps[set_steps.named(step)].query.named_selects
    return [exp.alias_(exp.column(name, table="learnt"), name) for name in names if name != "asset"]


def _add_probe(set_steps: OfSet) -> None:
    """Add what the indicator would show if the machine changed (both sides, section 2)."""
    setting = set_steps.setting
    set_steps.add("script/picked", {"picked": template.fill("probe/is_picked")})
    has_gap = set_steps.method.gaps[set_steps.number] is not None
    delays = probed_delays(setting)[1:]
    over, values = _earlier(exp.column("calibration_value"), delays, has_gap)
    if has_gap and delays:
        over["segment_from"] = _newest(exp.column("breaking").eq(1), max(delays) - 1)
    slots: dict[str, template.Slot] = {
        "sample_columns": [exp.column("breaking")] * (has_gap and bool(delays)),
        "delayed": [exp.alias_(of, name) for name, of in over.items()],
        "reached": values,
    }
    codes = "codes"
    for name in ("breaking_codes", "moving_codes"):
        if set_steps.named(name) in set_steps.steps.steps:
            codes = name
    set_steps.add("probe/probed", slots, tables={"codes": codes})
    set_steps.add("probe/usual")
    delays_by_pace = paces(setting.m, setting.tau)
    rows = [
        {"change_no": number, **slots_of(of, delays_by_pace)}
        for number, of in enumerate(CHANGES, start=1)
    ]
    add_stacked(set_steps.steps, "probe/changes", rows, set_steps.named("changes"))
    set_steps.add("probe/changed", changed_slots(set_steps, delays_by_pace))
    set_steps.add("probe/probe", tables={"cells": "support"})
    set_steps.add("probe/sight", {"hi_limit": limit_of(template.node_of(float(setting.target_floor)))})
    set_steps.add("script/probes")


def _add_health(set_steps: OfSet, instant_of: TimeNode, framed: bool) -> None:
    """Add Eq. 4 and Eq. 2 of one set, a row per scored vector."""
    set_steps.add("script/novelty")
    if framed:
        set_steps.add("script/framed_counts", {"before": set_steps.setting.window - 1}, "window_counts")
    else:
        set_steps.add("health/numbered", {"carried": []})
        set_steps.add("health/window_counts")
    time = instant_of(exp.column("time", table="counted"))
    set_steps.add("script/health_indicator", {"time": time})
