"""``gam check``: what a source looks like, and what must be fixed, before anything is learnt.

This module owns the command; :mod:`gam_db.checking` looks and judges.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

import typer

from gam_db.checking import Look, Note, Proposal, look_at, must_be_fixed, notes, propose
from gam_db.cli import look_report, monitor_options, options, report
from gam_db.cli.check_state import check_state
from gam_db.cli.progress import Progress, interruptible
from gam_db.config import Settings
from gam_db.connecting import connect
from gam_db.engines.session import Session
from gam_db.guess import guess

MUST_BE_FIXED = 2

_OUTPUT = "Output"
_STATE = "Where the state lies, with --state"


def check(
    source: options.SourceArgument = None,
    database: options.DatabaseOption = None,
    config: options.ConfigOption = None,
    state: Annotated[
        bool,
        typer.Option(
            "--state",
            help="Instead, compare all that is stored with the source, and with itself: rows that came "
            "too late, were corrected or went, and what was damaged in the tables. Reads all of it, and "
            "records that it did; ends with 2 if anything differs.",
            rich_help_panel=_STATE,
        ),
    ] = False,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    everything: Annotated[
        bool,
        typer.Option(
            "--all",
            help=f"Print every channel, not only {report.SHOWN} of them.",
            rich_help_panel=_OUTPUT,
        ),
    ] = False,
    as_json: Annotated[
        bool,
        typer.Option("--json", help="Print one JSON object instead.", rich_help_panel=_OUTPUT),
    ] = False,
    quiet: Annotated[
        bool,
        typer.Option("--quiet", "-q", help="Print nothing but errors.", rich_help_panel=_OUTPUT),
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
    m: options.MOption = None,
    tau: options.TauOption = None,
    bins: options.BinsOption = None,
    window: options.WindowOption = None,
    stride: options.StrideOption = None,
    max_gap: options.MaxGapOption = None,
    target_floor: options.TargetFloorOption = None,
    calibration_fraction: options.FractionOption = None,
    calibration_duration: options.DurationOption = None,
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
    score_from: options.ScoreFromOption = None,
    pool: options.PoolOption = None,
) -> None:
    """Look at SOURCE before anything is learnt of it: what it is like, what to fix, what to set.

    Per channel: sampling, pauses, missing, repeated and conflicting readings, range, distinct values,
    standstills, cycle. Ends with 2 if something must be fixed: rows without name or time, conflicts
    everywhere, one time for all rows, nothing that moves, too few samples for a window on any channel.
    Nothing is written.
    """
    if state:
        differs = check_state(
            source=source,
            database=database,
            config=config,
            name=name,
            schema=schema,
            prefix=prefix,
            threads=threads,
            everything=everything,
            as_json=as_json,
            quiet=quiet,
        )
        raise typer.Exit(MUST_BE_FIXED if differs else 0)
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
        tau=tau,
        bins=bins,
        window=window,
        stride=stride,
        max_gap=max_gap,
        target_floor=target_floor,
        calibration_fraction=calibration_fraction,
        calibration_duration=calibration_duration,
        calibrate=calibrate,
        exclude=exclude,
        score_from=score_from,
        pool=pool,
    )
    relation = options.named_relation(settings)
    with (
        interruptible(),
        connect(settings.source.database, threads, writable=False) as session,
        Progress(session, quiet) as progress,
    ):
        seen = looked(session, relation, settings, progress.on_step)
    code = MUST_BE_FIXED if must_be_fixed(seen.notes) else 0
    if as_json:
        said = look_report.figures(seen.job, seen.look, seen.notes, seen.proposal, code)
        print(json.dumps(said, ensure_ascii=False, indent=1))
    elif not quiet:
        look_report.show(report.console(), seen.job, seen.look, seen.notes, seen.proposal, everything)
    if code:
        raise typer.Exit(code)


@dataclass(frozen=True)
class Seen:
    """A source, looked at: what was asked, what was seen, what is said of it and what to set."""

    job: report.Job
    look: Look
    notes: list[Note]
    proposal: Proposal


def looked(session: Session, relation: Any, settings: Settings, on_step: Callable[[str], None]) -> Seen:
    """Look at a source as its settings mean it.

    Raises:
        UserError: the source, a parameter or the calibration cannot be used at all.
    """
    parameters, calibration = settings.method()
    columns = session.describe(session.relation(relation))
    guessed = guess(relation, columns, settings.source, session)
    look = look_at(session, guessed.source, parameters, calibration, on_step)
    proposal = propose(look)
    file = None if settings.file is None else str(settings.file)
    job = report.Job(str(relation), guessed, parameters, calibration, file)
    return Seen(job, look, notes(look, proposal), proposal)
