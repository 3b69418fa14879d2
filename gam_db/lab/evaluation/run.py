"""Evaluation: how well a health indicator shows wear, by the metrics of the paper.

This module owns the public call and the order of its work: look, match outcomes, measure each series,
measure chance, measure the fleet.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, cast

import numpy as np
import pyarrow as pa
from sqlglot import exp

from gam_db.arguments import public
from gam_db.engines.connecting import borrowed
from gam_db.engines.session import Session
from gam_db.errors import SourceError
from gam_db.lab.evaluation import sampling
from gam_db.lab.evaluation.capacity import POINTS
from gam_db.lab.evaluation.conventions import Conventions
from gam_db.lab.evaluation.members import Member, Outcome, as_table, members, outcomes_of, unmatched
from gam_db.lab.evaluation.steps import (
    TABLE_STEPS,
    chance_steps,
    evaluation_steps,
    looking_steps,
    window_steps,
)
from gam_db.lab.evaluation.table import HealthTable, health_table
from gam_db.settings.parameters import LONGEST_STRIDE

Listener = Callable[[str], None]

_CHANCE = pa.schema(
    [
        ("series_id", pa.int64()),
        *(
            (f"{metric}_chance{spread}", pa.float64())
            for metric in ("mon", "corr", "rob")
            for spread in ("", "_sd")
        ),
        ("chance_reason", pa.string()),
    ]
)


@dataclass(frozen=True)
class Evaluation:
    """What was found.

    Attributes:
        channels: a row per channel, ordered: asset, channel, outcome ("failed", "healthy" or NULL), k
            (values of the series), independent_windows (windows that do not overlap; NULL if it is not
            known how many values one spans), mon, mon_signed, corr, corr_signed, rob, a reason for each
            of the three (mon_reason, corr_reason, rob_reason), the chance level of each and its
            standard deviation (mon_chance, mon_chance_sd and so on) with chance_reason, first_hi,
            last_hi, amplitude and hi_sd (standard deviation of the values).
        summary: a row per metric (mon, corr, rob, prog, disc, trendability, global): value, sd (over
            the series, for the first three), counted (series, for global metrics, that it averages),
            lower_bound and upper_bound of the bootstrap interval over assets, samples (in which the
            metric is available), reason.
        unmatched: rows of the outcomes that speak of no channel of the table.
        stride: of a table with a row per vector, every so many-th value was taken; else 1.

    Reasons of a NULL: ``no_values``, ``one_value``, ``short`` (fewer than 5 values), ``constant`` (it
    would be 0 / 0), ``no_outcomes`` (none were given), ``no_failed``, ``one_failed``, ``no_healthy``,
    ``no_amplitude`` (that of the failed assets is not positive in the mean), ``unknown_window``,
    ``not_asked``. One stands beside a value: ``interpolated``, where the trend's window is so short
    (K below 20) that it passes through every value, and robustness is 1 whatever the series.
    """

    channels: pa.Table
    summary: pa.Table
    unmatched: int
    stride: int = 1


@public
def evaluate(
    health: Any,
    outcomes: Any = None,
    engine: Any = None,
    *,
    conventions: Conventions | None = None,
    threads: int | None = None,
) -> Evaluation:
    """Evaluate health indicators (paper, Eq. 5 to 9; method, section 9).

    Args:
        health: the name of a table or view, a Parquet or CSV file, or an Arrow table: what
            :func:`gam_db.health_indicator` or :func:`gam_db.health_at_buckets` returns, or any series
            of indicators with the columns asset, channel, hi (a number, the larger the worse) and one
            of bucket, time, index. Values that are NULL or no number are left out. With a column
            novel_in_window all sums are exact; without it each series is counted in steps of its range
            (2^-27 of it at a thousand values, 2^-14 at 115,000).
        outcomes: what became of the assets: a relation with the columns asset, channel (optional; the
            one that failed), failed_at (a time as in ``health``) and healthy. The series of a failed
            asset is that of its failed channel and ends at ``failed_at``; each channel of a healthy
            asset counts; what is not named counts neither way. None: monotonicity, correlation and
            robustness are averaged over all channels, and there are no other metrics.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.
        conventions: forms of the metrics, and how chance and spread are sampled.
        threads: processor threads; None leaves DuckDB's own choice.

    Raises:
        UserError: see its subclasses; the message says what to mend.
    """
    with borrowed(engine, threads) as session:
        return evaluated(session, health, outcomes, conventions or Conventions())


def evaluated(
    session: Session,
    health: Any,
    outcomes: Any,
    conventions: Conventions,
    on_step: Listener = lambda _: None,
) -> Evaluation:
    """Evaluate in an open session; ``on_step`` is called with the name of each step before it is run."""
    table = health_table(session, health)
    outcome_rows: list[Outcome] | None = None
    if outcomes is not None:
        outcome_rows = outcomes_of(session, outcomes, table.kind)

    stride = _stride(session, table, conventions.stride) if table.vectors else 1
    look = looking_steps(table.indicator, stride)
    on_step("indicator")
    indicator = session.keep("indicator", look.query("indicator"))
    rows = session.fetch(look.query("candidates", {"indicator": indicator})).to_pylist()
    series = members(rows, table, outcome_rows, conventions.values_per_window, stride)
    if outcome_rows and unmatched(outcome_rows, series) == len(outcome_rows):
        raise SourceError("The outcomes speak of no asset or channel of the health indicators.")
    units = sampling.units(sampling.largest_weight(series))
    steps = evaluation_steps(conventions, table.counts, units, outcome_rows is not None)
    tables = {
        "indicator": indicator,
        "members": _relation(session, as_table(series)),
        "drawings": _relation(session, sampling.drawings(series, conventions)),
        "life_shares": _relation(session, _life_shares()),
    }
    for step in TABLE_STEPS:
        on_step(step)
        tables[step] = session.keep(step, steps.query(step, tables))
    rates = session.fetch(steps.query("rates", tables))
    on_step("chance")
    tables["chance"] = _relation(session, _chance(session, series, rates, table.counts, conventions))
    on_step("summary")
    channels = session.fetch(steps.query("channel_summary", tables))
    # A column called corr is refused by some engines.
    names = ["corr" if name == "corr_size" else name for name in channels.column_names]
    return Evaluation(
        channels.rename_columns(names),
        session.fetch(steps.query("fleet_summary", tables)),
        0 if outcome_rows is None else unmatched(outcome_rows, series),
        stride,
    )


def _stride(session: Session, table: HealthTable, stride: int | None) -> int:
    """Return how many vectors a bucket of the table has, by default as for ``gam run``."""
    if stride is not None:
        return stride
    lengths = session.fetch(window_steps(table.indicator).query("window_lengths"))
    return math.gcd(LONGEST_STRIDE, *lengths["vectors_in_window"].to_pylist())


def _chance(
    session: Session, series: list[Member], rates: pa.Table, counts: bool, conventions: Conventions
) -> pa.Table:
    """Return the step *chance*: a row per series, with its chance level or why it has none."""
    rates_by_series = {row["series_id"]: row for row in rates.to_pylist()}
    reasons: list[dict[str, Any]] = []
    drawn: list[tuple[Member, int, int | None]] = []
    for member in series:
        row = rates_by_series.get(member.series_id, {"k": 0, "novel_sum": None})
        novel_sum = row["novel_sum"] if counts else None
        reason = (
            sampling.no_chance(member, row["k"], novel_sum) if conventions.surrogates else "not_asked"
        )
        if reason is None:
            drawn.append((member, row["k"], novel_sum))
        else:
            reasons.append({"series_id": member.series_id, "chance_reason": reason})
    parts = [pa.Table.from_pylist(reasons, _CHANCE)]
    if not drawn:
        return parts[0]
    steps = chance_steps(conventions, sampling.units(conventions.surrogates))
    for batch in sampling.batches(drawn, conventions):
        with session.lent(batch.selected) as selected, session.lent(batch.surrogates) as surrogates:
            tables = {"selected": selected, "surrogates": surrogates}
            levels = session.fetch(steps.query("chance_levels", tables))
        parts.append(
            levels.append_column("chance_reason", pa.nulls(len(levels), pa.string())).cast(_CHANCE)
        )
    return pa.concat_tables(parts)


def _relation(session: Session, table: pa.Table) -> exp.Table:
    return cast(exp.Table, session.relation(table))


def _life_shares() -> pa.Table:
    last = np.full(POINTS, POINTS - 1, np.int64)
    return pa.table({"point_no": np.arange(POINTS), "last_point": last})
