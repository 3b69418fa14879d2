"""``gam score``: bring the stored health indicator up to date, reading only what is new.

This module owns the command; :mod:`gam_db.stored.scoring` does the work, and
:mod:`gam_db.cli.score_report` owns the page.
"""

import json
from pathlib import Path
from typing import Annotated

import typer

from gam_db.cli import monitor_options, options, report, score_report
from gam_db.cli.progress import Progress, interruptible
from gam_db.cli.score_report import Outcome
from gam_db.clock import TimeKind, instant, shown_instant
from gam_db.config import Settings
from gam_db.errors import ConfigurationError
from gam_db.findings import any_needs_attention
from gam_db.stored import migrations
from gam_db.stored.copying import copy
from gam_db.stored.differing import differing
from gam_db.stored.monitor import Monitor
from gam_db.stored.sources import source_of
from gam_db.stored.state import State, kind_of

NEEDS_ATTENTION = 2

_WHAT = "What is scored"
_LENGTH = "seconds or a text like"


def score(
    source: Annotated[
        str | None,
        typer.Argument(
            metavar="SOURCE",
            help="Read this file or table instead, which has the same columns. Default: the source that "
            "gam calibrate was given.",
            show_default=False,
        ),
    ] = None,
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    since: Annotated[
        str | None,
        typer.Option(
            "--from",
            metavar="TIME",
            help="Score anew from this instant on, to mend what rows that came too late left wrong.",
            rich_help_panel=_WHAT,
        ),
    ] = None,
    until: Annotated[
        str | None,
        typer.Option(
            "--to",
            metavar="TIME",
            help="Read nothing newer; what was scored after it is hidden until the next run.",
            rich_help_panel=_WHAT,
        ),
    ] = None,
    full: Annotated[
        bool, typer.Option("--full", help="Score everything anew.", rich_help_panel=_WHAT)
    ] = False,
    everything: Annotated[
        bool,
        typer.Option(
            "--everything",
            help="Look at parked channels and count the rows of calibration now; else once a day.",
            rich_help_panel=_WHAT,
        ),
    ] = False,
    asset: Annotated[
        str,
        typer.Option(
            metavar="PATTERN",
            help="Only these machines; * and ? stand for any text or sign.",
            rich_help_panel=_WHAT,
        ),
    ] = "*",
    channel: Annotated[
        str, typer.Option(metavar="PATTERN", help="Only these signals.", rich_help_panel=_WHAT)
    ] = "*",
    lookback: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help=f"How late a row may come: {_LENGTH} '1 h' (the default); steps of a counter (0).",
            rich_help_panel=_WHAT,
        ),
    ] = None,
    park_after: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help=f"A channel silent for longer is looked at once a day: {_LENGTH} '1 d' (the default); "
            "steps of a counter; 'none' for never.",
            rich_help_panel=_WHAT,
        ),
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would be read, and write nothing.")
    ] = False,
    copy_to: Annotated[
        Path | None,
        typer.Option(
            "--copy",
            metavar="FILE",
            help="Then copy the state into a DuckDB file of its own, for readers: no other process can "
            "open the database while this one writes.",
        ),
    ] = None,
    as_json: monitor_options.JsonOption = False,
    quiet: monitor_options.QuietOption = False,
    threads: options.ThreadsOption = None,
) -> None:
    """Score what is new since the last run, and what came late, of every calibrated channel.

    It can be run at any time, and again after a crash: what is stored is then the same. Exit code 2
    means what it does in `gam run`: an indicator is above its limit, or a calibration is not good
    enough.
    """
    if dry_run and copy_to is not None:
        raise ConfigurationError("--dry-run writes nothing; leave out --copy.")
    session, tables, settings = monitor_options.opened(
        file=config,
        database=database,
        name=name,
        schema=schema,
        prefix=prefix,
        threads=threads,
        must_exist=True,
    )
    said = settings.monitor
    with interruptible(), session:
        migrations.require(session, tables)
        state = State(session, tables)
        known = state.monitor(said.name)
        kind = kind_of(known)
        channels = state.fetch("stored/known_channels", {"monitor_id": known["monitor_id"]})
        monitor = Monitor(
            session,
            source_of(known, channels["channel"].to_pylist(), source),
            lookback=said.lookback if lookback is None else options.length(lookback),
            park_after=(
                False
                if park_after == "none"
                else said.park_after
                if park_after is None
                else options.length(park_after)
            ),
            name=said.name,
            schema=tables.schema,
            prefix=tables.prefix,
        )
        with Progress(session, quiet) as progress:
            run = monitor.score(
                since=_instant("--from", since, kind),
                until=_instant("--to", until, kind),
                full=full,
                everything=everything,
                asset=asset,
                channel=channel,
                dry_run=dry_run,
                on_step=progress.on_step,
            )
            status = None if dry_run else monitor.status()
            if copy_to is not None:
                progress.on_step(f"copying to {copy_to}")
                copy(session, tables, copy_to)
        others = _differing(state, settings)
    code = 0
    if status is not None:
        told = zip(status["status"].to_pylist(), status["verdict"].to_pylist(), strict=True)
        code = NEEDS_ATTENTION if any_needs_attention(told) else 0
    outcome = Outcome(
        database=str(settings.source.shown_database),
        monitor=said.name,
        source=known["source"] if source is None else source,
        kind=kind,
        run=run,
        status=status,
        differing=others,
        settings=None if settings.file is None else str(settings.file),
        copy=None if copy_to is None else str(copy_to),
        code=code,
    )
    if as_json:
        print(json.dumps(score_report.figures(outcome), ensure_ascii=False, indent=1))
    elif not quiet:
        score_report.show(report.console(), outcome)
    if code:
        raise typer.Exit(code)


def _instant(option: str, text: str | None, kind: TimeKind) -> str | None:
    """Return an instant as it was given, once it is clear that it is one; so errors name the option."""
    return None if text is None else shown_instant(instant(text, kind, option), kind)


def _differing(state: State, settings: Settings) -> list[tuple[str, str]]:
    """Return the channels that the settings file, if there is one, would calibrate otherwise."""
    if not (settings.parameters or settings.calibration or settings.overrides):
        return []
    return differing(state, settings.monitor.name, *settings.method())
