"""``gam calibrate``: freeze what the healthy part of each channel teaches, as versions in the database.

This module owns the command and its page; :mod:`gam_db.stored.calibrating` does the work.
"""

import dataclasses
import json
import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import Annotated, Any

import typer
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from gam_db.cli import monitor_options, options, report
from gam_db.cli.figures import asked, plain
from gam_db.cli.progress import Progress, interruptible
from gam_db.config import Settings, SourceSettings
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError
from gam_db.findings import any_needs_attention, share, shortcomings, status_of
from gam_db.guess import guess
from gam_db.source import AnySource, WideSource, is_file
from gam_db.stored import migrations
from gam_db.stored.monitor import Monitor
from gam_db.stored.sources import SOURCE_COLUMNS, described, source_of
from gam_db.stored.state import State
from gam_db.stored.tables import StateTables

NEEDS_ATTENTION = 2

_WIDE = 100
"""Columns below which the counts of calibration are left out, so that names have room."""

Row = dict[str, Any]


def calibrate(
    source: options.SourceArgument = None,
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    again: Annotated[
        bool, typer.Option("--again", help="Learn every channel anew, even with the same settings.")
    ] = False,
    everything: Annotated[
        bool,
        typer.Option("--all", help=f"Print every new version, not only the {report.SHOWN} most urgent."),
    ] = False,
    as_json: monitor_options.JsonOption = False,
    quiet: monitor_options.QuietOption = False,
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
    """Learn the healthy part of every channel of SOURCE and freeze it in the database.

    A channel gets a new version if it has none with these settings; nothing is forgotten. Which source
    is watched is kept, so later calls, and `gam score`, need no SOURCE. State tables are made where
    there are none. Exit code 2: a new version is not good enough to be watched (too_fine, needs_data),
    or none of them has any calibration.
    """
    said = options.settings(
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
    session, tables, settings = monitor_options.opened(
        file=config,
        database=database,
        name=name,
        schema=schema,
        prefix=prefix,
        threads=threads,
        must_exist=not is_file(said.source.relation),
    )
    where_to = f"{settings.source.shown_database}, monitor {settings.monitor.name}"
    with interruptible(), session, Progress(session, quiet) as progress:
        is_new = not migrations.status(session, tables).applied
        job = _job(session, tables, said, settings.monitor.name, is_new)
        with Monitor(
            session,
            job.guess.source,
            job.parameters,
            job.calibration,
            name=settings.monitor.name,
            schema=tables.schema,
            prefix=tables.prefix,
        ) as monitor:
            applied = monitor.migrate() if is_new else []
            rows = monitor.calibrate(again, on_step=progress.on_step).to_pylist()
    code = NEEDS_ATTENTION if rows and _needs_attention(rows) else 0
    if as_json:
        figures = {
            **asked(job),
            "database": settings.source.shown_database,
            "monitor": settings.monitor.name,
            "migrations_applied": applied,
            "new_versions": plain(rows),
            "verdicts": dict(Counter(row["verdict"] for row in rows)),
            "needs_attention": code == NEEDS_ATTENTION,
            "exit_code": code,
        }
        print(json.dumps(figures, ensure_ascii=False, indent=1))
    elif not quiet:
        out = report.console()
        if applied:
            report.say(out, f"state tables {tables}* were made in {settings.source.shown_database}")
        _show(out, where_to, job, rows, everything)
    if code:
        raise typer.Exit(code)


def _job(
    session: Session, tables: StateTables, settings: Settings, name: str, is_new: bool
) -> report.Job:
    """Return what is to be calibrated; what was not said of a known monitor's source is remembered."""
    said = settings.source
    known = None
    if not is_new:
        migrations.require(session, tables)
        state = State(session, tables)
        known = next((row for row in state.monitors() if row["name"] == name), None)
        if known is not None:
            channels = state.fetch("stored/known_channels", {"monitor_id": known["monitor_id"]})
            said = _remembered(said, known, channels["channel"].unique().to_pylist())
    if said.relation is None:
        raise ConfigurationError(
            "Name a SOURCE: a Parquet or CSV file, or a table of the database; or put relation under "
            "[source] into gam.toml."
        )
    relation = _absolute(said.relation)
    parameters, calibration = settings.method()
    guessed = guess(relation, session.describe(session.relation(relation)), said, session)
    if known is not None:
        _check_same(guessed.source, known)
    file = None if settings.file is None else str(settings.file)
    return report.Job(said.relation, guessed, parameters, calibration, file)


def _remembered(said: SourceSettings, known: Row, channels: Sequence[str]) -> SourceSettings:
    """Return what was said of a source, and what its monitor knows where nothing was."""
    source = source_of(known, channels, said.relation)
    remembered: Row = {"relation": source.relation}
    shared = {"asset": source.asset or False, "time": source.time, "where": source.where}
    if isinstance(source, WideSource):
        if said.channel is None and said.value is None:
            remembered |= shared | {"layout": "wide", "channels": source.channels}
    elif said.layout != "wide" and said.channels is None:
        remembered |= shared | {"channel": source.channel or False, "value": source.value}
    unsaid = {key: value for key, value in remembered.items() if getattr(said, key) is None}
    return dataclasses.replace(said, **unsaid)


def _check_same(source: AnySource, known: Mapping[str, Any]) -> None:
    """Refuse to calibrate on a source that the monitor would not score."""
    here = described(source)
    for column in SOURCE_COLUMNS:
        was, now = known[column], here[column]
        if was == now or (column == "source" and _absolute(was) == _absolute(str(now))):
            continue
        raise ConfigurationError(
            f"The monitor {known['name']!r} watches another source: its {column.replace('_', ' ')} is "
            f"{was or 'none'}, that of this one {now or 'none'}. Give this one a monitor of its own by "
            f"--name, or remove that one by gam drop --name {known['name']}."
        )


def _absolute(relation: str) -> str:
    """Return a relation as it can be read from any folder, since gam score may run in another one."""
    return os.path.abspath(relation) if is_file(relation) and "://" not in relation else relation


def _needs_attention(rows: Sequence[Row]) -> bool:
    return any_needs_attention((status_of(row["verdict"], None, None), row["verdict"]) for row in rows)


def _show(out: Console, where_to: str, job: report.Job, rows: Sequence[Row], everything: bool) -> None:
    if not rows:
        report.say(out, report.printable(where_to))
        report.say(
            out,
            "nothing to do: every channel has a version with these settings; --again learns them anew",
        )
        return
    assets = len({row["asset"] for row in rows})
    settings = f"; settings from {job.settings}" if job.settings else ""
    report.say(
        out,
        f"{report.printable(f'{where_to}, from {job.name}')}: {len(rows):,} new "
        f"version{'s' * (len(rows) != 1)} of {assets:,} asset{'s' * (assets != 1)}{settings}",
    )
    report.say(out, report.columns_line(job.guess))
    report.say(out, report.method_line(job.parameters, job.calibration))
    out.print()
    ordered = sorted(rows, key=lambda row: _status(row) != "setup")
    shown = ordered if everything else ordered[: report.SHOWN]
    for text in _lines(out, shown, assets == 1):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    if len(ordered) > len(shown):
        rest = report.verdicts(ordered[len(shown) :])
        report.say(out, f"and {len(ordered) - len(shown):,} more ({rest}); --all")
    out.print()
    report.say(out, "verdicts: " + report.verdicts(rows))
    for line in report.advice(rows):
        report.say(out, line)
    if not _needs_attention(rows):
        report.say(out, "nothing needs attention")
    if any(row["verdict"] != "no_data" for row in rows):
        report.say(out, "gam score now brings the health indicator up to date")


def _lines(out: Console, rows: Sequence[Row], one_asset: bool) -> Iterator[Text]:
    """Yield a line per new version, and under it what is to be said of it; the first is the heading."""
    names = [
        report.printable(row["channel"] if one_asset else f"{row['asset']} {row['channel']}")
        for row in rows
    ]
    cells = [
        {
            "version": f"{row['version_no']}",
            "reason": row["reason"],
            "verdict": row["verdict"],
            "floor": share(row["floor"]),
            "vectors": f"{row['vectors']:,}",
            "cells": f"{row['cells']:,}",
        }
        for row in rows
    ]
    told = [key for key in cells[0] if out.width >= _WIDE or key not in ("vectors", "cells")]
    widths = {key: max([len(key), *(len(row[key]) for row in cells)]) for key in told}
    free = out.width - 2 - sum(width + 2 for width in widths.values())
    width = min(max([7, *map(cell_len, names)]), max(12, free))

    def laid(name: str, row: Mapping[str, str]) -> str:
        padded = [
            f"{row[key]:<{wide}}" if key in ("reason", "verdict") else f"{row[key]:>{wide}}"
            for key, wide in widths.items()
        ]
        return f"{report.fit(name, width)}  {'  '.join(padded)}"

    yield Text(f"  {laid('channel', {key: key for key in widths})}", style="bold")
    for name, row, cell in zip(names, rows, cells, strict=True):
        mark, style = report.MARKS["setup"] if _status(row) == "setup" else (" ", "")
        yield Text(f"{mark} {laid(name, cell)}", style)
        remarks = shortcomings(row, (row["m"] - 1) * row["tau"])
        for remark in report.folded("; ".join(remarks), out.width - 4):
            yield Text(f"    {remark}")


def _status(row: Row) -> str:
    return status_of(row["verdict"], None, None)
