"""Steps of whole channels: names, samples, calibration intervals (method, sections 2 and 4)."""

from collections.abc import Callable, Sequence

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add, add_stacked
from gam_db.method.programs import add_samples, add_taught_programs, identified_slots
from gam_db.method.resolved import Method
from gam_db.settings.parameters import Parameters


def add_source(steps: Pipeline, method: Method) -> None:
    """Add what speaks of whole channels: names, samples, calibration intervals (sections 2 and 4)."""
    add(steps, "source/names")
    add_rules(steps, method)
    add_channels(steps, method)
    has_programs = method.programs is not None
    add(steps, "source/identified", identified_slots(exp.true(), has_programs))
    add(steps, "source/timeline")
    add_samples(steps, method.programs)
    for name in ("recounted", "series"):
        add(steps, f"source/{name}")
    add_intervals(steps)
    add_taught_programs(steps, method.programs)
    add(steps, "calibration/calibrated")


def add_channels(steps: Pipeline, method: Method) -> None:
    """Add the channels, each with the numbers of its parameters, its rule and its pool."""
    rules = [(asset, "*", number) for number, asset in enumerate(method.assets, start=1)]
    pools = [(asset, "*", n) for n, group in enumerate(method.pools, start=1) for asset in group]
    numbers = {
        "settings_no": by_override(method.parameters, method.settings.index),
        "calibration_no": _chosen(rules),
        "pool_no": _chosen(pools),
    }
    add(steps, "source/channels", numbers)


def by_override(parameters: Parameters, number_of: Callable[[Parameters], int]) -> exp.Expr:
    """Return a number of the parameters that a channel has, by the columns asset and channel."""
    general, *variants = parameters.variants()
    cases = [
        (override.asset, override.channel, number_of(variant))
        for override, variant in zip(parameters.overrides, variants, strict=True)
    ]
    return _chosen(cases, number_of(general))


def add_intervals(steps: Pipeline) -> None:
    """Add when calibration begins and ends, after the step *series* (section 4)."""
    add(steps, "calibration/limits", {"long_ago": LONG_AGO})
    add(steps, "calibration/calibration")


def add_rules(steps: Pipeline, method: Method) -> None:
    """Add how long calibration lasts, and the intervals that are declared, rule by rule (section 4)."""
    names = ("fraction", "duration", "declared_end", "score_from")
    rules = [
        {"calibration_no": number, **{name: getattr(rule, name) for name in names}}
        for number, rule in enumerate(method.rules)
    ]
    add_stacked(steps, "calibration/rules", rules)
    pieces = [
        {"calibration_no": number, "time_from": start, "time_to": end}
        for number, rule in enumerate(method.rules)
        for start, end in rule.allowed
    ]
    if pieces:
        add_stacked(steps, "calibration/declared", pieces)
    else:
        add(steps, "calibration/undeclared", name="declared")


def _chosen(cases: Sequence[tuple[str, str, int]], other: int = 0) -> exp.Expr:
    """Return the number of the first case whose patterns of asset and channel are met, else another."""
    branches: list[tuple[exp.Expr, int]] = []
    for asset, channel, number in cases:
        met = (named_like("asset", asset), named_like("channel", channel))
        conditions = [condition for condition in met if condition is not None]
        if not conditions:
            return template.case(branches, number)
        branches.append((exp.and_(*conditions), number))
    return template.case(branches, other)


def named_like(column: str, pattern: str) -> exp.Expr | None:
    """Return the condition that a name matches a pattern; None for one that matches all."""
    if not pattern.strip("*"):
        return None if pattern else exp.EQ(this=exp.column(column), expression=template.text(""))
    if "*" not in pattern and "?" not in pattern:
        return exp.EQ(this=exp.column(column), expression=template.text(pattern))
    escaped = str.maketrans({"*": "%", "?": "_", "%": "!%", "_": "!_", "!": "!!"})
    text = template.text(pattern.translate(escaped))
    like = exp.Like(this=exp.column(column), expression=text)
    return exp.Escape(this=like, expression=template.text("!"))
