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
from gam_db.cli.render import WORDS, Page, Section, Table, show
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

    def sections() -> Iterator[Section]:
        if applied:
            yield f"state tables {tables}* were created in {settings.source.shown_database}"
        yield from _sections(heading(settings), job, rows, common.everything, monitor.siblings)
        if isinstance(relation, tuple):
            yield WORDS["calibrate"]["files"]

    figures = {
        **job.figures(),
        **place(settings),
        "migrations_applied": applied,
        "chosen": automatic.figures(monitor.siblings),
        "new_versions": rows,
        "verdicts": Counter(row["verdict"] for row in rows),
        "needs_attention": urgent,
    }
    show(Page(figures, sections(), urgent, lacking), common)


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


def _sections(
    where: str, job: Job, rows: Sequence[Row], everything: bool, siblings: Sequence[Siblings]
) -> Iterator[Section]:
    if not rows:
        yield where
        yield "nothing to do: every channel has a version with these settings; --again learns them again"
        return
    versions = page.amount(rows, "new version")
    yield f"{where}, from {printable(job.name)}: {versions}{job.settings}"
    yield from pools.lines(rows, job.calibration)
    yield from job.lines()
    yield ""
    ordered = sorted(rows, key=lambda row: not _is_poor(row))
    shown = ordered if everything else ordered[: options.SHOWN]
    name = page.name_in(shown)
    cells = [{**row, "name": name(row)} for row in shown]
    yield Table("versions", cells, lambda row: "?" if _is_poor(row) else " ")
    remarks = ((name(row), _remarks(row)) for row in shown)
    yield from page.remarks(remarks, everything)
    yield from page.cut(ordered, everything, page.verdicts)
    yield ""
    yield f"verdicts: {page.verdicts(rows)}"
    yield from automatic.lines(siblings, everything)
    yield from page.unseen(rows)
    if less := [row for row in rows if row["left_out"]]:
        spans = number_of(sum(row["left_out"] for row in less), "interval")
        machines = page.some(sorted({printable(row["asset"]) for row in less}), 3)
        yield f"left out of calibration, as true_fault or maintenance: {spans} of {machines}"
    yield from page.advice(rows)
    if not (need_attention(rows) or any(map(is_blind, rows)) or lack_data(rows)):
        yield "nothing needs attention"
    if any(row["verdict"] != "no_data" for row in rows):
        yield "next: gam score brings the health indicator up to date"


def _remarks(row: Row) -> list[str]:
    short = shortcomings(row, (row["m"] - 1) * row["tau"])
    return [*vouching(row), *short, *sight(row), *dropped(row)]
