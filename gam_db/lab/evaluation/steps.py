"""The steps of an evaluation, in order, and what their slots hold.

This module makes trees; it runs nothing.
"""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.lab.evaluation.conventions import Conventions
from gam_db.method.adding import add, add_stacked

#: Steps that others read more than once, and the last ones before the results: kept on the way.
TABLE_STEPS = ("centred", "moments", "prefixes", "series_metrics")

#: Parts of a series' chance level: their numbers and columns.
_TREND_PARTS = ((0, "mon"), (1, "corr_size"), (2, "rob"))

#: Further parts of the fleet's metrics: number, column, stratum.
_FLEET_PARTS = ((3, "last_hi", 0), (4, "amplitude", 0), (5, "hi_sd", 1))

#: Fleet metrics in the order of the summary: name, column, its spread over series, what it averages.
_METRICS = (
    ("mon", "mon", "mon_sd", "mon_counted"),
    ("corr", "corr_size", "corr_sd", "corr_counted"),
    ("rob", "rob", "rob_sd", "rob_counted"),
    ("prog", "prog", None, "failed_counted"),
    ("disc", "disc", None, "healthy_counted"),
    ("trendability", "trendability", None, "failed_counted"),
    ("global", "global_score", None, "available"),
)


def looking_steps(indicator: exp.Query, stride: int = 1) -> Pipeline:
    """Return the steps *indicator*, which is the given query, and *candidates*.

    Args:
        indicator: the query.
        stride: take every so many-th of its values only.
    """
    if stride == 1:
        steps = Pipeline()
        steps.add("indicator", indicator, template.load("lab/evaluation/indicator").comment)
    else:
        steps = window_steps(indicator)
        add(steps, "lab/evaluation/bucket_ends", {"stride": stride}, "indicator")
    add(steps, "lab/evaluation/candidates")
    return steps


def window_steps(indicator: exp.Query) -> Pipeline:
    """Return the steps *raw_indicator*, which is the query of an indicator, and *window_lengths*."""
    steps = Pipeline()
    steps.add("raw_indicator", indicator, template.load("lab/evaluation/indicator").comment)
    add(steps, "lab/evaluation/window_lengths")
    return steps


def series_steps(conventions: Conventions, counts: bool) -> Pipeline:
    """Return the steps from *selected*, which is given, to *series_metrics*.

    Args:
        conventions: forms of the metrics.
        counts: whether the indicator is a count of novel vectors.
    """
    steps = Pipeline(small=frozenset((*TABLE_STEPS, "part_means")))
    _add_series(steps, conventions, counts)
    return steps


def chance_steps(conventions: Conventions, units: int) -> Pipeline:
    """Return the steps from *selected* and *surrogates*, which are given, to *chance_levels*."""
    steps = series_steps(conventions, counts=True)
    rows = [{"part": part, "quantity": exp.column(column)} for part, column in _TREND_PARTS]
    add_stacked(steps, "lab/evaluation/chance_parts", rows, "drawn")
    _add_means(steps, conventions, units)
    add(steps, "lab/evaluation/chance_levels")
    return steps


def evaluation_steps(conventions: Conventions, counts: bool, units: int, reasons: bool) -> Pipeline:
    """Return the steps of an evaluation after the look.

    *indicator*, *members*, *drawings*, *life_shares* and *chance* are given. The last steps are
    *channel_summary* (a row per channel) and *fleet_summary* (a row per metric).

    Args:
        conventions: forms of the metrics.
        counts: whether the indicator is a count of novel vectors.
        units: in which shares are counted; see :func:`gam_db.lab.evaluation.sampling.units`.
        reasons: whether outcomes are known at all.
    """
    steps = Pipeline(small=frozenset((*TABLE_STEPS, "part_means", "life_points", "fleet_metrics")))
    add(steps, "lab/evaluation/selected")
    add(steps, "lab/evaluation/rates")
    _add_series(steps, conventions, counts)
    add(steps, "lab/evaluation/channel_summary")
    add(steps, "lab/evaluation/rated")
    rows = [_part(part, column, 0, 0) for part, column in _TREND_PARTS]
    rows += [_part(part, column, stratum, 1) for part, column, stratum in _FLEET_PARTS]
    add_stacked(steps, "lab/evaluation/parts", rows)
    add(steps, "lab/evaluation/drawn")
    _add_means(steps, conventions, units)
    for name in ("fleet_parts", "life_points", "life_pairs", "trendability", "fleet_metrics"):
        add(steps, f"lab/evaluation/{name}")
    metrics = [_metric(number, *metric, reasons) for number, metric in enumerate(_METRICS)]
    add_stacked(steps, "lab/evaluation/metric_values", metrics)
    add(steps, "lab/evaluation/fleet_summary", {"tail": (1 - conventions.confidence) / 2})
    return steps


def detection_steps(limit: float | None, by_alarms: bool) -> Pipeline:
    """Return the steps from *indicator* and *labels*, which are given, to *detection*.

    Args:
        limit: a limit for all channels; None for those of *channel_limits*, which is given.
        by_alarms: whether values are raised in *alarms*, which is given, and not by a limit.
    """
    steps = Pipeline(small=frozenset(("label_leads", "label_counts", "detection_counts")))
    if by_alarms:
        add(steps, "lab/evaluation/raised_in_alarm", {}, "raised")
    else:
        add(steps, "lab/evaluation/raised_by_limit", {"limit": limit}, "raised")
    for name in ("raised_machines", "timeline", "label_leads"):
        add(steps, f"lab/evaluation/{name}")
    for name in ("label_counts", "detection_counts", "detection"):
        add(steps, f"lab/evaluation/{name}")
    return steps


def _add_series(steps: Pipeline, conventions: Conventions, counts: bool) -> None:
    add(steps, "lab/evaluation/ordered")
    level = "counted_level" if counts else "measured_level"
    add(steps, "lab/evaluation/levels", {"level": template.fill(f"lab/evaluation/{level}")})
    for name in ("centred", "moments", "prefixes", "windows", "trends", "residuals"):
        add(steps, f"lab/evaluation/{name}")
    add(
        steps,
        "lab/evaluation/series_metrics",
        {
            "monotonicity": template.fill(f"lab/evaluation/{conventions.monotonicity}_monotonicity"),
            "amplitude": template.fill(f"lab/evaluation/{conventions.amplitude}_amplitude"),
            "ddof": conventions.ddof,
        },
    )


def _add_means(steps: Pipeline, conventions: Conventions, units: int) -> None:
    add(steps, "lab/evaluation/scaled", {"units": units})
    add(steps, "lab/evaluation/part_means", {"ddof": conventions.ddof})


def _part(part: int, column: str, stratum: int, with_outcome: int) -> dict[str, template.Slot]:
    return {
        "part": part,
        "quantity": exp.column(column),
        "from_stratum": stratum,
        "with_outcome": with_outcome,
    }


def _metric(
    number: int, name: str, column: str, spread: str | None, counted: str, reasons: bool
) -> dict[str, template.Slot]:
    path = {"prog": "prog_reason", "disc": "disc_reason", "trendability": "trendability_reason"}
    reason: exp.Expr = template.text("no_outcomes")
    if reasons or name not in path:
        reason = template.fill(f"lab/evaluation/{path.get(name, 'mean_reason')}")
    return {
        "metric": template.text(name),
        "number": number,
        "value": exp.column(column),
        "spread": None if spread is None else exp.column(spread),
        "counted": exp.column(counted),
        "reason": reason,
    }
