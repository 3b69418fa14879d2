"""``gam calibrate``: the healthy part of every channel, learnt and frozen in a database."""

import contextlib
import dataclasses
import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from gam_db.address import is_url
from gam_db.checking.words import number_of
from gam_db.cli import automatic, options, page, pools
from gam_db.cli.config import Settings
from gam_db.cli.job import Job, channels_of, heading, job_of, place
from gam_db.cli.options import option
from gam_db.cli.progress import working
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import EngineError, printable, wrong
from gam_db.findings import (
    Row,
    dropped,
    is_blind,
    lack_data,
    need_attention,
    shortcomings,
    sight,
    vouching,
)
from gam_db.reading.guess import SourceSettings, folder_or_table
from gam_db.settings.source import AnySource, WideSource, is_file, shown_relation, slashed
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.sources import SOURCE_COLUMNS, described, source_of
from gam_db.stored.state import State
from gam_db.study.automatic import Siblings


@options.taking(*options.READ, *options.ALARMS, *options.STATE, *options.PAGE, "threads", state=True)
def calibrate(
    settings: Settings, common: options.Common, again: bool = option("calibrate.again", False)
) -> None:
    """Learn the healthy states of every channel and freeze them.

    A channel gets a new version if it has none with these settings; earlier versions stay. The database
    stores which source is watched, so later calls and `gam score` need no SOURCE. gam creates the state
    tables if they do not exist. Exit code 2: a new version is not good enough to be watched (too_fine,
    needs_data), or would show no shift of its machine (blind). Otherwise exit code 4: a channel has no
    usable reading in calibration, or no channel can be judged.
    """
    tables, relation = settings.monitor.tables, settings.source.relation
    is_folder = isinstance(relation, str) and Path(relation).is_dir()
    with _none_left_empty(settings.source.database):
        session = options.opened(
            settings, common.threads, must_exist=not (is_folder or is_file(relation))
        )
        with working(session, common.quiet) as on_step:
            named = dataclasses.replace(settings.source, relation=folder_or_table(relation, session))
            settings = dataclasses.replace(settings, source=named)
            is_new = not migrations.status(session, tables).applied
            job = _job(session, settings, is_new)
            arguments = (job.guess.source, job.parameters, job.calibration, settings.alarms)
            with Monitor(session, *arguments, **vars(settings.monitor)) as monitor:
                applied = monitor.migrate() if is_new else []
                rows = monitor.calibrate(again, on_step=on_step).to_pylist()
    urgent = need_attention(rows) or any(map(is_blind, rows))
    lacking = bool(rows) and lack_data(rows)

    def show(out: page.Out) -> None:
        if applied:
            page.say(out, f"state tables {tables}* were made in {settings.source.shown_database}")
        _show(out, heading(settings), job, rows, common.everything, monitor.siblings)
        if isinstance(relation, tuple):
            page.say(out, page.WORDS["calibrate"]["files"])

    figures = {
        **job.figures(),
        **place(settings),
        "migrations_applied": applied,
        "chosen": automatic.figures(monitor.siblings),
        "new_versions": rows,
        "verdicts": Counter(row["verdict"] for row in rows),
        "needs_attention": urgent,
    }
    page.tell(figures, show, common, urgent=urgent, lacking=lacking)


@contextlib.contextmanager
def _none_left_empty(address: str | None) -> Iterator[None]:
    """Remove the file of a database that was made for work which failed before it made a table."""
    path = None if address is None or is_url(address) or Path(address).exists() else Path(address)
    try:
        yield
    except BaseException:
        if path is not None and path.exists():
            is_used = True
            with contextlib.suppress(EngineError), connect(str(path), writable=False) as session:
                is_used = bool(session.driver.tables())
            if not is_used:
                path.unlink()
        raise


def _job(session: Session, settings: Settings, is_new: bool) -> Job:
    """Return what is to be calibrated; what was not said of a known monitor's source is remembered."""
    source, monitor_row, tables = settings.source, None, settings.monitor.tables
    source.check_conditions(session.engine)
    if not is_new:
        migrations.require(session, tables)
        state = State(session, tables)
        names = {row["name"]: row for row in state.monitors()}
        if monitor_row := names.get(settings.monitor.name):
            source = _remembered(
                source, monitor_row, list(dict.fromkeys(channels_of(state, monitor_row)))
            )
            source = dataclasses.replace(source, where_any=True)  # what is remembered was let before
    if source.relation is None:
        raise wrong("no_source_to_calibrate")
    settings = dataclasses.replace(settings, source=source)
    job = job_of(session, settings, _absolute(source.relation), shown_relation(source.relation))
    if monitor_row is not None:
        _check_same(job.guess.source, monitor_row)
    return job


def _remembered(settings: SourceSettings, monitor_row: Row, channels: Sequence[str]) -> SourceSettings:
    """Return what was said of a source, and what its monitor knows where nothing was."""
    source = source_of(monitor_row, channels, settings.relation)
    remembered: Row = {"relation": source.relation}
    shared = {"asset": source.asset or False, "time": source.time, "where": source.where}
    if isinstance(source, WideSource):
        if settings.channel is None and settings.value is None:
            remembered |= shared | {"layout": "wide", "channels": source.channels}
    elif settings.layout != "wide" and settings.channels is None:
        remembered |= shared | {"channel": source.channel or False, "value": source.value}
    remembered |= source.written
    unsaid = {key: value for key, value in remembered.items() if getattr(settings, key) is None}
    return dataclasses.replace(settings, **unsaid)


def _check_same(source: AnySource, monitor_row: Mapping[str, Any]) -> None:
    """Refuse to calibrate on a source that the monitor would not score."""
    here = described(source)
    for column in SOURCE_COLUMNS:
        was, now = monitor_row[column], here[column]
        if was == now or (column == "source" and _absolute(was) == _absolute(str(now))):
            continue
        name, column, was, now = (
            monitor_row["name"],
            column.replace("_", " "),
            was or "none",
            now or "none",
        )
        raise wrong("monitor_of_another_source", name=name, column=column, was=was, now=now)


def _absolute(relation: str | tuple[str, ...]) -> str | tuple[str, ...]:
    """Return a relation as it can be read from any folder, since gam score may run in another one."""
    if not isinstance(relation, str):
        return tuple(str(_absolute(path)) for path in relation)
    if not is_file(relation) or "://" in relation:
        return relation
    return slashed(os.path.abspath(relation), relation)


def _is_poor(row: Row) -> bool:
    """Tell whether a calibration is not good enough to be watched, or blind."""
    return row["status"] == "setup" or is_blind(row)


def _show(
    out: page.Out,
    where: str,
    job: Job,
    rows: Sequence[Row],
    everything: bool,
    siblings: Sequence[Siblings],
) -> None:
    if not rows:
        done = "every channel has a version with these settings; --again learns them anew"
        page.say(out, where, f"nothing to do: {done}")
        return
    versions = page.amount(rows, "new version")
    page.say(out, f"{where}, from {printable(job.name)}: {versions}{job.settings}")
    page.say(out, *pools.lines(rows, job.calibration))
    page.say(out, *job.lines())
    out.print()
    ordered = sorted(rows, key=lambda row: not _is_poor(row))
    shown = ordered if everything else ordered[: options.SHOWN]
    name = page.name_in(shown)
    columns: dict[str, page.Cell] = {
        "channel": name,
        "version": lambda row: str(row["version_no"]),
        "reason": "reason",
        "verdict": "verdict",
        "sees": page.sees,
        **page.floors(shown),
        "vectors": "vectors",
        "cells": "cells",
    }
    left, spare = ("reason", "verdict"), ("cells", "vectors", "sees")
    page.table(out, shown, columns, lambda row: "?" if _is_poor(row) else " ", left, spare)
    remarks = (
        (
            name(row),
            [
                *vouching(row),
                *shortcomings(row, (row["m"] - 1) * row["tau"]),
                *sight(row),
                *dropped(row),
            ],
        )
        for row in shown
    )
    page.remarks(out, remarks, everything)
    page.cut(out, ordered, everything, page.verdicts)
    out.print()
    page.say(out, f"verdicts: {page.verdicts(rows)}", *automatic.lines(siblings, everything))
    page.say(out, *page.unseen(rows))
    if less := [row for row in rows if row["left_out"]]:
        spans = number_of(sum(row["left_out"] for row in less), "interval")
        machines = page.some(sorted({printable(row["asset"]) for row in less}), 3)
        page.say(out, f"left out of calibration, as true_fault or maintenance: {spans} of {machines}")
    page.say(out, *page.advice(rows))
    if not (need_attention(rows) or any(map(is_blind, rows)) or lack_data(rows)):
        page.say(out, "nothing needs attention")
    if any(row["verdict"] != "no_data" for row in rows):
        page.say(out, "gam score now brings the health indicator up to date")
