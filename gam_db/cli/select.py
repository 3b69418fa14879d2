"""``gam select``: which tau, m, B and W suit each channel, from its healthy part.

This module owns the command; :mod:`gam_db.cli.selection_report` says how its results look.
"""

import contextlib
import json
from collections.abc import Iterator
from typing import Annotated, Literal

import typer

from gam_db.cli import options, report
from gam_db.cli.options import named_relation
from gam_db.cli.progress import Progress, interruptible
from gam_db.cli.selection_report import figures, show
from gam_db.connecting import connect
from gam_db.guess import guess
from gam_db.selection import Search, Studied, alone, selected_by_all
from gam_db.study import Study

_SEARCH = "The search"

TauRule = Literal["first_minimum", "acf_1e", "acf_zero"]


def select(
    source: options.SourceArgument = None,
    database: options.DatabaseOption = None,
    config: options.ConfigOption = None,
    everything: Annotated[
        bool,
        typer.Option("--all", help=f"Print every channel, not only the first {report.SHOWN}."),
    ] = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Print one JSON object with all curves instead.")
    ] = False,
    threads: options.ThreadsOption = None,
    asset: options.AssetOption = None,
    no_asset: options.NoAssetOption = False,
    channel: options.ChannelOption = None,
    no_channel: options.NoChannelOption = False,
    time: options.TimeOption = None,
    value: options.ValueOption = None,
    wide: options.WideOption = False,
    where: options.WhereOption = None,
    tau: Annotated[
        int | None,
        typer.Option(
            "--tau", help="Take this delay, in samples; default chosen.", rich_help_panel=_SEARCH
        ),
    ] = None,
    tau_by: Annotated[
        TauRule,
        typer.Option("--tau-by", help="First rule to try for the delay.", rich_help_panel=_SEARCH),
    ] = "first_minimum",
    tau_max: Annotated[
        int,
        typer.Option("--tau-max", help="Largest delay looked at, in samples.", rich_help_panel=_SEARCH),
    ] = 100,
    m_max: Annotated[
        int,
        typer.Option("--m-max", help="Largest embedding dimension looked at.", rich_help_panel=_SEARCH),
    ] = 6,
    theiler: Annotated[
        int | None,
        typer.Option(
            "--theiler",
            help="Samples within which vectors are no neighbours; default from the data.",
            rich_help_panel=_SEARCH,
        ),
    ] = None,
    references: Annotated[
        int,
        typer.Option(
            "--references", help="Vectors whose neighbours are looked for.", rich_help_panel=_SEARCH
        ),
    ] = 2000,
    seed: Annotated[int, typer.Option(help="Of their sample.", rich_help_panel=_SEARCH)] = 0,
    m: options.MOption = None,
    bins: options.BinsOption = None,
    window: options.WindowOption = None,
    max_gap: options.MaxGapOption = None,
    target_floor: options.TargetFloorOption = None,
    calibration_fraction: options.FractionOption = None,
    calibration_duration: options.DurationOption = None,
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
) -> None:
    """Choose delay, embedding dimension, bins and window for every channel of SOURCE.

    Only the healthy part is looked at (--calibration-fraction 1 for all of it). --bins is the finest
    grid and --window the window that are asked for; --m is taken where no rule finds a dimension.
    Overrides and pools of gam.toml are left out: each channel speaks for itself.
    """
    search = Search(
        tau=tau,
        tau_by=tau_by,
        tau_max=tau_max,
        m_max=m_max,
        theiler=theiler,
        references=references,
        seed=seed,
    )
    settings = options.settings(
        file=config,
        relation=source,
        database=database,
        asset=asset,
        no_asset=no_asset,
        channel=channel,
        no_channel=no_channel,
        time=time,
        value=value,
        wide=wide,
        where=where,
        m=m,
        tau=None,
        bins=bins,
        window=window,
        stride=None,
        max_gap=max_gap,
        target_floor=target_floor,
        calibration_fraction=calibration_fraction,
        calibration_duration=calibration_duration,
        calibrate=calibrate,
        exclude=exclude,
        score_from=None,
        pool=None,
    )
    relation = named_relation(settings)
    parameters, calibration = alone(*settings.method())

    @contextlib.contextmanager
    def studies() -> Iterator[Studied]:
        opened = connect(settings.source.database, threads, writable=False)
        with opened as session, Progress(session) as progress:
            yield lambda given: Study(session, given, parameters, calibration, progress.on_step)

    with interruptible(), connect(settings.source.database, threads, writable=False) as session:
        columns = session.describe(session.relation(relation))
        guessed = guess(relation, columns, settings.source, session)
    with interruptible():
        found = selected_by_all(studies, guessed.source, search)
    file = None if settings.file is None else str(settings.file)
    job = report.Job(relation, guessed, parameters, calibration, file)
    if as_json:
        print(json.dumps(figures(job, search, found), ensure_ascii=False, indent=1))
    else:
        show(report.console(), job, found, everything)
    if len(found.failures):
        raise typer.Exit(3)
