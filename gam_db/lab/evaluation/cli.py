"""``gam evaluate``: how well the health indicators show wear, by the metrics of the paper.

This module owns the command and how its results look; :mod:`gam_db.lab.evaluation` computes them.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Annotated, Any

import typer

from gam_db.checking.words import number_of
from gam_db.cli import options, page, render
from gam_db.cli.progress import working
from gam_db.cli.render import Column, Table
from gam_db.engines.connecting import connect
from gam_db.errors import ConfigurationError, printable, wrong
from gam_db.lab.evaluation import Conventions, Evaluation, detection_page
from gam_db.lab.evaluation.conventions import Amplitude, Monotonicity
from gam_db.lab.evaluation.detection import detected
from gam_db.lab.evaluation.run import evaluated
from gam_db.settings.source import FILE_ENDINGS, is_file

_FORMS = "Forms of the metrics"
_SAMPLING = "Chance and spread"
_DETECTION = "Labelled events"

Row = dict[str, Any]

_TITLES = {
    "mon": "Mon",
    "corr": "Corr",
    "rob": "Rob",
    "prog": "Prog",
    "disc": "Disc",
    "trendability": "Trendability",
    "global": "Global",
}
_REASONS = {
    "no_values": "no value of the indicator",
    "one_value": "one value only",
    "short": "fewer than 5 values",
    "constant": "the indicator is constant",
    "interpolated": "fewer than 20 values, so the trend passes through all of them and Rob is 1",
    "no_series": "no series has it",
    "no_outcomes": "needs --outcomes",
    "no_failed": "no failed asset with values",
    "one_failed": "takes two failed assets",
    "no_healthy": "no healthy asset with values",
    "no_amplitude": "the failed assets have no amplitude",
}


def evaluate(
    health: Annotated[
        str,
        typer.Argument(
            metavar="HEALTH",
            help="A table of health indicators: the Parquet or CSV file that gam run wrote, or a table "
            "of --database; or any with the columns asset, channel, hi and one of bucket, time, index.",
        ),
    ],
    outcomes: Annotated[
        str | None,
        typer.Option(
            metavar="TABLE",
            help="What became of the assets, a file or a table of --database: columns asset, channel "
            "(which one failed), failed_at (the time, empty if healthy), healthy (true or false).",
        ),
    ] = None,
    database: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS", help="Database that holds the tables (DuckDB); it is only read."
        ),
    ] = None,
    labels: Annotated[
        str | None,
        typer.Option(
            metavar="TABLE",
            help="Events to compare raised values with, a file or a table of --database: columns asset, "
            "channel (empty: all), start, end (empty: no end), event.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    event: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME",
            help="Event that counts (repeatable; default all labels).",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    limit: Annotated[
        float | None,
        typer.Option(
            metavar="SHARE",
            help="Limit above which a value of any channel is raised; default the limit of each "
            "channel, from the column hi_limit of HEALTH or the support file beside it.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    limits: Annotated[
        str | None,
        typer.Option(
            metavar="TABLE",
            help="Limits of the channels: columns asset, channel, hi_limit.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    alarms: Annotated[
        str | None,
        typer.Option(
            metavar="TABLE",
            help="Alarms instead of limits, with columns like --labels: a value is raised in an alarm.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    before: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="Values that long before a label count neither way, such as '2 d' or 500.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    after: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="Values that long after a label count neither way.",
            rich_help_panel=_DETECTION,
        ),
    ] = None,
    everything: options.All = False,
    as_json: options.Json = False,
    threads: options.Threads = None,
    monotonicity: Annotated[
        Monotonicity,
        typer.Option(
            help="rank: Spearman's correlation with time. sign: rises less falls over their number.",
            rich_help_panel=_FORMS,
        ),
    ] = "rank",
    amplitude: Annotated[
        Amplitude,
        typer.Option(
            help="range: highest less lowest value. ends: last less first.", rich_help_panel=_FORMS
        ),
    ] = "range",
    ddof: Annotated[
        int,
        typer.Option(
            min=0, max=1, help="Taken from the number under standard deviations.", rich_help_panel=_FORMS
        ),
    ] = 0,
    values_per_window: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Values that one window spans; default read off what gam run wrote.",
            rich_help_panel=_SAMPLING,
        ),
    ] = None,
    stride: Annotated[
        int | None,
        typer.Option(
            min=1,
            help="Of a table that gam run wrote with a row per vector, take every so many-th value; "
            "default those at bucket ends, 1 for all.",
            rich_help_panel=_SAMPLING,
        ),
    ] = None,
    surrogates: Annotated[
        int,
        typer.Option(
            min=0, help="Series of random novelty per channel; 0 for none.", rich_help_panel=_SAMPLING
        ),
    ] = 20,
    samples: Annotated[
        int,
        typer.Option(min=0, help="Bootstrap samples of the assets.", rich_help_panel=_SAMPLING),
    ] = 1000,
    confidence: Annotated[
        float, typer.Option(help="Share of them inside an interval.", rich_help_panel=_SAMPLING)
    ] = 0.95,
    seed: Annotated[int, typer.Option(min=0, help="Of both.", rich_help_panel=_SAMPLING)] = 0,
) -> None:
    """Measure how well health indicators show wear.

    It prints Mon, Corr and Rob of every channel of HEALTH (paper, Eq. 5 to 9), beside the same of random
    series. With --outcomes it also prints Prog, Disc, trendability and Global of the fleet, with
    bootstrap intervals over the assets.

    With --labels it compares raised values with labelled events instead: F1, beside that of chance,
    false-alarm rate and missed-alarm rate of each machine, and how long before an event it was raised.
    """
    relations = {
        "HEALTH": health,
        "--outcomes": outcomes,
        "--labels": labels,
        "--limits": limits,
        "--alarms": alarms,
    }
    for what, relation in relations.items():
        _check_relation(relation, what, database)
    if labels is not None:
        if outcomes is not None:
            raise wrong("labels_and_outcomes")
        session = connect(database, threads, writable=False)
        with working(session):
            detection = detected(
                session,
                health,
                labels,
                events=event or (),
                limit=limit,
                limits=limits,
                alarms=alarms,
                before=before or 0,
                after=after or 0,
            )
        figures = {"health": health, "labels_of": labels, **vars(detection)}
        lines = detection_page.sections(health, detection, everything)
        render.show(render.Page(figures, lines), options.Common(as_json=as_json))
        return
    _refuse_without_labels(
        event=event or None, limit=limit, limits=limits, alarms=alarms, before=before, after=after
    )
    conventions = Conventions(
        monotonicity=monotonicity,
        amplitude=amplitude,
        ddof=ddof,
        surrogates=surrogates,
        samples=samples,
        confidence=confidence,
        seed=seed,
        values_per_window=values_per_window,
        stride=stride,
    )
    session = connect(database, threads, writable=False)
    with working(session) as on_step:
        evaluation = evaluated(session, health, outcomes, conventions, on_step)
    figures = {"health": health, "outcomes": outcomes, "conventions": conventions, **vars(evaluation)}

    sections = _sections(health, evaluation, conventions, everything)
    render.show(render.Page(figures, sections), options.Common(as_json=as_json))


def _refuse_without_labels(**options: object) -> None:
    for name, value in options.items():
        if value is not None:
            raise wrong("needs_labels", name=f"--{name}")


def _sections(
    name: str, evaluation: Evaluation, conventions: Conventions, everything: bool
) -> Iterator[render.Section]:
    order = {"failed": 0, "healthy": 1, None: 2}
    rows: list[Row] = sorted(evaluation.channels.to_pylist(), key=lambda row: order[row["outcome"]])
    yield from _heading(name, rows, evaluation.unmatched)
    if evaluation.stride > 1:
        yield (
            f"a row per vector: the values at the end of each bucket of {evaluation.stride:,} are "
            "taken; --stride N for others, --stride 1 for all"
        )
    yield ""
    shown = rows if everything else rows[: options.SHOWN]
    name_of = page.name_in(shown)
    cells = [{**row, "name": name_of(row), **_numbers(row)} for row in shown]
    yield Table("evaluated", cells, lambda row: "~" if _is_chance(row) else " ", columns=_COLUMNS)
    yield from page.remarks(((name_of(row), _remarks(row)) for row in shown), everything)
    yield from page.cut(rows, everything)
    yield ""
    interval = Column(f"{100 * conventions.confidence:.4g} % interval", "bounds")
    columns = [*_SUMMARY[:3], interval, *_SUMMARY[3:]]
    yield Table("metrics", list(map(_metric, evaluation.summary.to_pylist())), columns=columns)
    yield ""
    yield _legend(rows, conventions)


def _check_relation(relation: str | None, what: str, database: str | None) -> None:
    if relation is not None and database is None and not is_file(relation):
        raise ConfigurationError(
            f"{what} is {relation!r}, which is no Parquet or CSV file ({', '.join(FILE_ENDINGS)}); if "
            "it is a table, say which database holds it: --database FILE.duckdb."
        )


def _heading(name: str, rows: Sequence[Row], unmatched: int) -> list[str]:
    outcomes = Counter(row["outcome"] for row in rows)
    assets = len({row["asset"] for row in rows})
    line = f"{printable(name)}: {number_of(len(rows), 'channel')} of {number_of(assets, 'asset')}"
    if outcomes["failed"] or outcomes["healthy"]:
        line += f"; channels: {outcomes['failed']:,} failed, {outcomes['healthy']:,} of healthy assets"
        line += f", {outcomes[None]:,} not judged" if outcomes[None] else ""
    lines = [line]
    if unmatched:
        lines.append(
            f"rows of the outcomes that name an asset or channel not in the table: {unmatched:,}"
        )
    return lines


_COLUMNS = [
    Column("channel", "name"),
    Column("outcome", "outcome", optional=True),
    Column("values", "k"),
    Column("windows", "independent_windows"),
    Column("Mon", "mon_text"),
    Column("chance", "chance_text", optional=True),
    Column("Corr", "corr_text"),
    Column("Rob", "rob_text"),
]
_SUMMARY = [
    Column("metric", "title"),
    Column("value", "value_text"),
    Column("± sd", "sd_text"),
    Column("over", "over", left=True),
]


def _numbers(row: Row) -> Row:
    """Return the figures of a channel as texts."""
    return {
        "mon_text": _number(row["mon_signed"], "+"),
        "chance_text": None if row["chance_reason"] == "not_asked" else _number(row["mon_chance"]),
        "corr_text": _number(row["corr_signed"], "+"),
        "rob_text": _number(row["rob"]),
    }


def _is_chance(row: Row) -> bool:
    """Tell whether monotonicity is within two standard deviations of that of random novelty."""
    if row["mon"] is None or row["mon_chance"] is None:
        return False
    return bool(row["mon"] <= row["mon_chance"] + 2 * row["mon_chance_sd"])


def _remarks(row: Row) -> list[str]:
    metrics_by_reason: dict[str, list[str]] = {}
    for metric in ("mon", "corr", "rob"):
        reason = row[f"{metric}_reason"]
        if reason is not None:
            metrics_by_reason.setdefault(reason, []).append(_TITLES[metric])
    return [f"{', '.join(metrics)}: {_REASONS[reason]}" for reason, metrics in metrics_by_reason.items()]


def _metric(row: Row) -> Row:
    """Return the texts of a metric of the fleet."""
    over = {"prog": "failed", "disc": "healthy", "trendability": "failed", "global": "metrics"}
    bounds = f"{_number(row['lower_bound'])} to {_number(row['upper_bound'])}"
    counted = f"{row['counted'] or 0:,} {over.get(row['metric'], 'channels')}"
    return {
        "title": _TITLES[row["metric"]],
        "value_text": _number(row["value"]),
        "sd_text": _number(row["sd"]),
        "bounds": None if row["lower_bound"] is None else bounds,
        "over": _REASONS[row["reason"]] if row["value"] is None else counted,
    }


def _legend(rows: Sequence[Row], conventions: Conventions) -> str:
    mon = "rank correlation with time" if conventions.monotonicity == "rank" else "rises less falls"
    words = [
        "Values: those of the indicator that are there; windows: how many of them do not overlap.",
        f"Mon: {mon}, Corr: correlation with time, both with their signs here, without them in means;",
        "Rob: 1 if the values lie on their trend.",
    ]
    if any(row["mon_chance"] is not None for row in rows):
        words.append(
            f"Chance: the mean Mon, without sign, of {conventions.surrogates:,} series of random "
            "novelty of the same length and rate; ~ marks a Mon within two standard deviations of it."
        )
    if any(row["outcome"] for row in rows):
        words.append(
            "Prog: failed assets end at one level; Disc: they rise above the noise of healthy ones; "
            "trendability: they rise alike; Global: mean of the first five."
        )
    return " ".join(words)


def _number(value: float | None, sign: str = "") -> str:
    return "-" if value is None else f"{value:{sign}.3f}"
