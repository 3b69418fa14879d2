"""``gam evaluate``: how well the health indicators show wear, by the metrics of the paper.

This module owns the command and how its results look; :mod:`gam_db.lab.evaluation` computes them.
"""

import dataclasses
import json
from collections import Counter
from collections.abc import Sequence
from typing import Annotated, Any

import typer
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

import gam_db
from gam_db.cli import options, report
from gam_db.cli.progress import Progress, interruptible
from gam_db.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.lab.evaluation import Conventions, Evaluation
from gam_db.lab.evaluation.conventions import Amplitude, Monotonicity
from gam_db.lab.evaluation.run import evaluated
from gam_db.source import FILE_ENDINGS, is_file

_FORMS = "Forms of the metrics"
_SAMPLING = "Chance and spread"

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
    everything: Annotated[
        bool, typer.Option("--all", help=f"Print every channel, not only {report.SHOWN}.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print one JSON object instead.")] = False,
    threads: options.ThreadsOption = None,
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
    """Measure how well the health indicators of HEALTH show wear (paper, Eq. 5 to 9).

    Mon, Corr and Rob of every channel, beside what chance gives; with --outcomes also Prog, Disc,
    trendability and Global of the fleet, with bootstrap intervals over the assets.
    """
    for relation, what in ((health, "HEALTH"), (outcomes, "--outcomes")):
        _check_relation(relation, what, database)
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
    with (
        interruptible(),
        connect(database, threads, writable=False) as session,
        Progress(session) as progress,
    ):
        found = evaluated(session, health, outcomes, conventions, progress.on_step)
    if as_json:
        told = {
            "version": gam_db.__version__,
            "health": health,
            "outcomes": outcomes,
            "conventions": dataclasses.asdict(conventions),
            "channels": found.channels.to_pylist(),
            "summary": found.summary.to_pylist(),
            "unmatched": found.unmatched,
            "stride": found.stride,
        }
        print(json.dumps(told, ensure_ascii=False, indent=1))
    else:
        show(report.console(), health, found, conventions, everything)


def show(
    out: Console, name: str, found: Evaluation, conventions: Conventions, everything: bool = False
) -> None:
    """Print an evaluation.

    Args:
        out: where to.
        name: of the table, for the heading.
        found: what was found.
        conventions: of the metrics.
        everything: show every channel, however many there are.
    """
    order = {"failed": 0, "healthy": 1, None: 2}
    rows: list[Row] = sorted(found.channels.to_pylist(), key=lambda row: order[row["outcome"]])
    for line in _heading(name, rows, found.unmatched):
        report.say(out, line)
    if found.stride > 1:
        report.say(
            out,
            f"a row per vector: the values at the end of each bucket of {found.stride:,} are taken; "
            "--stride N for others, --stride 1 for all",
        )
    out.print()
    shown = rows if everything else rows[: report.SHOWN]
    for text in _channels(out, shown):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    if len(rows) > len(shown):
        report.say(out, f"and {len(rows) - len(shown)} more; --all")
    out.print()
    for line in _summary(found.summary.to_pylist(), conventions):
        out.print(Text(line), no_wrap=True, overflow="crop", crop=True)
    out.print()
    report.say(out, _legend(rows, conventions))


def _check_relation(relation: str | None, what: str, database: str | None) -> None:
    if relation is not None and database is None and not is_file(relation):
        raise ConfigurationError(
            f"{what} is {relation!r}, which is no Parquet or CSV file ({', '.join(FILE_ENDINGS)}); if "
            "it is a table, say which database holds it: --database FILE.duckdb."
        )


def _heading(name: str, rows: Sequence[Row], unmatched: int) -> list[str]:
    outcomes = Counter(row["outcome"] for row in rows)
    assets = len({row["asset"] for row in rows})
    line = f"{report.printable(name)}: {len(rows):,} channel{'s' * (len(rows) != 1)} of {assets:,} asset"
    line += "s" * (assets != 1)
    if outcomes["failed"] or outcomes["healthy"]:
        line += f"; channels: {outcomes['failed']:,} failed, {outcomes['healthy']:,} of healthy assets"
        line += f", {outcomes[None]:,} not judged" if outcomes[None] else ""
    lines = [line]
    if unmatched:
        lines.append(
            f"rows of the outcomes that name an asset or channel not in the table: {unmatched:,}"
        )
    return lines


def _channels(out: Console, rows: Sequence[Row]) -> list[Text]:
    one_asset = len({row["asset"] for row in rows}) == 1
    names = [report.printable(row["channel"] if one_asset else _both(row)) for row in rows]
    judged = any(row["outcome"] for row in rows)
    chance = any(row["chance_reason"] != "not_asked" for row in rows)
    columns: list[tuple[str, int]] = [("outcome", 7)] if judged else []
    columns += [("values", 7), ("windows", 7)]
    columns += [("Mon", 6), *([("chance", 6)] if chance else []), ("Corr", 6), ("Rob", 5)]
    free = out.width - 2 - sum(width + 2 for _, width in columns)
    width = min(max([7, *map(cell_len, names)]), max(7, free))
    heads = "".join(f"  {title:>{size}}" for title, size in columns)
    lines = [Text(f"  {report.fit('channel', width)}{heads}", style="bold")]
    for row, name in zip(rows, names, strict=True):
        cells = [row["outcome"] or "-"] if judged else []
        cells += [f"{row['k']:,}", _whole(row["independent_windows"])]
        cells.append(_number(row["mon_signed"], "+"))
        cells += [_number(row["mon_chance"])] if chance else []
        cells += [_number(row["corr_signed"], "+"), _number(row["rob"])]
        weak = _is_chance(row)
        line = "".join(f"  {cell:>{size}}" for cell, (_, size) in zip(cells, columns, strict=True))
        style = "yellow" if weak else ""
        lines.append(Text(f"{'~' if weak else ' '} {report.fit(name, width)}{line}", style))
        remark = _remark(row)
        if remark:
            lines.append(Text(f"    {remark}", "dim"))
    return lines


def _is_chance(row: Row) -> bool:
    """Tell whether monotonicity is within two standard deviations of that of random novelty."""
    if row["mon"] is None or row["mon_chance"] is None:
        return False
    return bool(row["mon"] <= row["mon_chance"] + 2 * row["mon_chance_sd"])


def _remark(row: Row) -> str:
    told: dict[str, list[str]] = {}
    for metric in ("mon", "corr", "rob"):
        reason = row[f"{metric}_reason"]
        if reason is not None:
            told.setdefault(reason, []).append(_TITLES[metric])
    return "; ".join(f"{', '.join(metrics)}: {_REASONS[reason]}" for reason, metrics in told.items())


def _summary(rows: Sequence[Row], conventions: Conventions) -> list[str]:
    share = f"{100 * conventions.confidence:.4g} % interval"
    lines = [f"  {'metric':12}  {'value':>6}  {'± sd':>6}  {share:>15}  over"]
    over = {"prog": "failed", "disc": "healthy", "trendability": "failed", "global": "metrics"}
    for row in rows:
        metric = row["metric"]
        bounds = "-"
        if row["lower_bound"] is not None:
            bounds = f"{_number(row['lower_bound'])} to {_number(row['upper_bound'])}"
        said = f"{row['counted']:,} {over.get(metric, 'channels')}"
        if row["value"] is None:
            said = _REASONS[row["reason"]]
        value, spread = _number(row["value"]), _number(row["sd"])
        lines.append(f"  {_TITLES[metric]:12}  {value:>6}  {spread:>6}  {bounds:>15}  {said}")
    return lines


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


def _both(row: Row) -> str:
    return f"{row['asset']} {row['channel']}"


def _number(value: float | None, sign: str = "") -> str:
    return "-" if value is None else f"{value:{sign}.3f}"


def _whole(value: int | None) -> str:
    return "-" if value is None else f"{value:,}"
