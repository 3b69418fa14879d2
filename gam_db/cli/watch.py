"""``gam calibrate``, ``gam score`` and ``gam status``: a source that is watched, from day to day.

This module owns the commands and their pages; :mod:`gam_db.stored` does the work.
"""

import dataclasses
import datetime as dt
import os
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

import pyarrow as pa
import pyarrow.compute as pc
import typer
from rich.console import Console

from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.job import Job, job_of
from gam_db.cli.progress import working
from gam_db.clock import LONG_AGO, TimeKind, instant, shown_instant, shown_length, zone
from gam_db.config import Settings
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, printable
from gam_db.findings import Row, need_attention, share, shortcomings
from gam_db.guess import SourceSettings
from gam_db.parameters import pattern_matches
from gam_db.source import AnySource, WideSource, is_file, shown_relation, slashed
from gam_db.stored import migrations
from gam_db.stored import status as stored_status
from gam_db.stored.copying import copy
from gam_db.stored.differing import differing
from gam_db.stored.monitor import Monitor
from gam_db.stored.proving import Proof
from gam_db.stored.scoring import Report
from gam_db.stored.sources import SOURCE_COLUMNS, described, relation_of, source_of
from gam_db.stored.state import State, kind_of


def watched(
    session: Session, settings: Settings, relation: str | tuple[str, ...] | None
) -> tuple[Monitor, Row]:
    """Return the monitor that is meant, and its row.

    Args:
        session: on the database that holds the state.
        settings: say which monitor, and how it is kept.
        relation: what to read instead of the relation that it was made from.

    Raises:
        UserError: there is no such monitor.
    """
    migrations.require(session, settings.monitor.tables)
    state = State(session, settings.monitor.tables)
    known = state.monitor(settings.monitor.name)
    channels = state.fetch("stored/known_channels", {"monitor_id": known["monitor_id"]})
    source = source_of(known, channels["channel"].to_pylist(), relation)
    return Monitor(session, source, asked=settings.alarms, **vars(settings.monitor)), known


@options.taking(*options.READ, *options.ALARMS, *options.STATE, state=True)
def calibrate(
    settings: Settings,
    again: Annotated[
        bool, typer.Option("--again", help="Learn every channel anew, even with the same settings.")
    ] = False,
    everything: options.All = False,
    as_json: options.Json = False,
    quiet: options.Quiet = False,
    threads: options.Threads = None,
) -> None:
    """Learn the healthy part of every channel of SOURCE and freeze it in the database.

    A channel gets a new version if it has none with these settings; nothing is forgotten. Which source
    is watched is kept, so later calls, and `gam score`, need no SOURCE. State tables are made where
    there are none. Exit code 2: a new version is not good enough to be watched (too_fine, needs_data),
    or none of them has any calibration.
    """
    place, tables = settings.source.shown_database, settings.monitor.tables
    relation = settings.source.relation
    is_folder = isinstance(relation, str) and Path(relation).is_dir()
    session = options.opened(settings, threads, must_exist=not (is_folder or is_file(relation)))
    with working(session, quiet) as on_step:
        if is_folder and str(relation).casefold() not in session.relations():
            named = dataclasses.replace(settings.source, relation=options.as_folder(str(relation)))
            settings = dataclasses.replace(settings, source=named)
        is_new = not migrations.status(session, tables).applied
        job = _job(session, settings, is_new)
        asked = (job.guess.source, job.parameters, job.calibration, settings.alarms)
        with Monitor(session, *asked, **vars(settings.monitor)) as monitor:
            applied = monitor.migrate() if is_new else []
            rows = monitor.calibrate(again, on_step=on_step).to_pylist()
    urgent = bool(rows) and need_attention(rows)

    def show(out: Console) -> None:
        if applied:
            page.say(out, f"state tables {tables}* were made in {place}")
        _show_versions(out, f"{place}, monitor {settings.monitor.name}", job, rows, everything)
        if isinstance(relation, tuple):
            page.say(
                out,
                "Later runs read these files only; a pattern in quotes ('part-*.parquet') or a folder "
                "as SOURCE reads those to come, too.",
            )

    figures = {
        **job.figures(),
        "database": place,
        "monitor": settings.monitor.name,
        "migrations_applied": applied,
        "new_versions": rows,
        "verdicts": Counter(row["verdict"] for row in rows),
        "needs_attention": urgent,
    }
    page.tell(Exit.ATTENTION if urgent else Exit.FINE, figures, show, as_json, quiet)


def _job(session: Session, settings: Settings, is_new: bool) -> Job:
    """Return what is to be calibrated; what was not said of a known monitor's source is remembered."""
    said, known, tables = settings.source, None, settings.monitor.tables
    if not is_new:
        migrations.require(session, tables)
        state = State(session, tables)
        names = (row for row in state.monitors() if row["name"] == settings.monitor.name)
        known = next(names, None)
        if known is not None:
            channels = state.fetch("stored/known_channels", {"monitor_id": known["monitor_id"]})
            said = _remembered(said, known, channels["channel"].unique().to_pylist())
    if said.relation is None:
        raise ConfigurationError(
            "Name a SOURCE: a Parquet or CSV file, or a table of the database; or put relation under "
            "[source] into gam.toml."
        )
    settings = dataclasses.replace(settings, source=said)
    job = job_of(session, settings, _absolute(said.relation), shown_relation(said.relation))
    if known is not None:
        _check_same(job.guess.source, known)
    return job


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
    remembered |= source.written
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


def _absolute(relation: str | tuple[str, ...]) -> str | tuple[str, ...]:
    """Return a relation as it can be read from any folder, since gam score may run in another one."""
    if not isinstance(relation, str):
        return tuple(str(_absolute(one)) for one in relation)
    if not is_file(relation) or "://" in relation:
        return relation
    return slashed(os.path.abspath(relation), relation)


def _show_versions(out: Console, where: str, job: Job, rows: Sequence[Row], everything: bool) -> None:
    if not rows:
        page.say(out, printable(where))
        page.say(
            out,
            "nothing to do: every channel has a version with these settings; --again learns them anew",
        )
        return
    assets = number_of(len({row["asset"] for row in rows}), "asset")
    versions = number_of(len(rows), "new version")
    page.say(out, f"{printable(f'{where}, from {job.name}')}: {versions} of {assets}{job.settings}")
    for line in job.lines():
        page.say(out, line)
    out.print()
    ordered = sorted(rows, key=lambda row: row["status"] != "setup")
    shown = ordered if everything else ordered[: options.SHOWN]
    names = page.names_of(shown)
    columns = {
        "channel": names,
        "version": [f"{row['version_no']}" for row in shown],
        "reason": [row["reason"] for row in shown],
        "verdict": [row["verdict"] for row in shown],
        "floor": [share(row["floor"]) for row in shown],
        "vectors": [f"{row['vectors']:,}" for row in shown],
        "cells": [f"{row['cells']:,}" for row in shown],
    }
    marks = ["?" if row["status"] == "setup" else " " for row in shown]
    page.table(out, columns, marks, ("reason", "verdict"), ("cells", "vectors"))
    short = (shortcomings(row, (row["m"] - 1) * row["tau"]) for row in shown)
    page.remarks(out, zip(names, short, strict=True), everything)
    page.cut(out, ordered, everything, page.verdicts(ordered[len(shown) :]))
    out.print()
    page.say(out, f"verdicts: {page.verdicts(rows)}")
    if less := [row for row in rows if row["left_out"]]:
        machines = sorted({printable(row["asset"]) for row in less})
        more = f" and {len(machines) - 3:,} more" if len(machines) > 3 else ""
        spans = number_of(sum(row["left_out"] for row in less), "interval")
        page.say(
            out,
            f"left out of calibration, as true_fault or maintenance: {spans} of "
            f"{', '.join(machines[:3])}{more}",
        )
    for line in page.advice(rows):
        page.say(out, line)
    if not need_attention(rows):
        page.say(out, "nothing needs attention")
    if any(row["verdict"] != "no_data" for row in rows):
        page.say(out, "gam score now brings the health indicator up to date")


_WHAT = "What is scored"


@options.taking(*options.STATE, "lookback", "park_after", source=False, state=True)
def score(
    settings: Settings,
    source: Annotated[
        list[str] | None,
        typer.Argument(
            metavar="SOURCE...",
            help="Read this file, these or this table instead, of the same columns. Default: the source "
            "that gam calibrate was given.",
            show_default=False,
        ),
    ] = None,
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
    as_json: options.Json = False,
    quiet: options.Quiet = False,
    threads: options.Threads = None,
) -> None:
    """Score what is new since the last run, and what came late, of every calibrated channel.

    It can be run at any time, and again after a crash: what is stored is then the same. Exit code 2
    means what it does in `gam status`: an episode needs attention, or an indicator is above its limit
    where a channel has none for judgements, or a calibration is not good enough.
    """
    if dry_run and copy_to is not None:
        raise ConfigurationError("--dry-run writes nothing; leave out --copy.")
    session = options.opened(settings, threads, files=[] if copy_to is None else [copy_to])
    with working(session, quiet) as on_step:
        relation = options.one_or_more(source)
        monitor, known = watched(session, settings, relation)
        kind = kind_of(known)
        run = monitor.score(
            since=_instant("--from", since, kind),
            until=_instant("--to", until, kind),
            full=full,
            everything=everything,
            asset=asset,
            channel=channel,
            dry_run=dry_run,
            on_step=on_step,
        )
        status = None if dry_run else monitor.status()
        if copy_to is not None:
            on_step(f"copying to {copy_to}")
            copy(session, monitor.tables, copy_to)
        others = _differing(monitor.state, settings)
    urgent = status is not None and need_attention(status.to_pylist())
    shown = shown_relation(relation or relation_of(known))
    outcome = _Outcome(settings, shown, kind, run, status, others, copy_to)
    figures = {**outcome.figures(), "needs_attention": urgent}

    page.tell(Exit.ATTENTION if urgent else Exit.FINE, figures, outcome.show, as_json, quiet)


def _raised(status: pa.Table) -> Row:
    """Return how many channels are judged by episodes, and the episodes that ask for attention."""
    rows = status.select(["judged_by", "asking", "episode"]).to_pylist()
    return {
        "judged_by_episode": sum(row["judged_by"] == "episode" for row in rows),
        "episodes": [row["episode"] for row in rows if row["asking"]],
    }


def _judging(status: pa.Table) -> Iterator[str]:
    """Yield by what channels are judged, and what is to be looked at."""
    by_episode = _raised(status)["judged_by_episode"]
    if by_episode:
        yield (
            f"{number_of(by_episode, 'channel')} judged by episodes (gam limits), others by the health "
            "indicator and its limit"
        )
    elif len(status) > status["judged_by"].null_count:
        yield "judged by the health indicator and its limit; gam limits says why"
    asking = pc.sum(status["asking"]).as_py()
    if asking:
        yield f"{number_of(asking, 'episode')} to look at; gam alarms shows them"


def _instant(option: str, text: str | None, kind: TimeKind) -> str | None:
    """Return an instant as it was given, once it is clear that it is one; so errors name the option."""
    return None if text is None else shown_instant(instant(text, kind, option), kind)


def _differing(state: State, settings: Settings) -> list[tuple[str, str]]:
    """Return the channels that the settings file, if there is one, would calibrate otherwise."""
    if not (settings.parameters or settings.calibration or settings.overrides):
        return []
    return differing(state, settings.monitor.name, *settings.method())


@dataclasses.dataclass(frozen=True)
class _Outcome:
    """A run and what is known after it.

    Attributes:
        settings: what was asked.
        source: in the user's words.
        kind: how the source tells time.
        run: what was read and made.
        status: of every channel after it; None if nothing was written.
        differing: asset and channel of those that the settings file would have calibrated otherwise.
        copy: where a copy was written, if anywhere.
    """

    settings: Settings
    source: str
    kind: TimeKind
    run: Report
    status: pa.Table | None
    differing: Sequence[tuple[str, str]]
    copy: Path | None

    @property
    def totals(self) -> dict[str, int]:
        """Channels and rows that were read, or would be, and buckets that were written."""
        return {
            "channels": sum(row["channels"] for row in self.run.ranges),
            "rows": sum(row["rows"] for row in self.run.ranges),
            "buckets": sum(row["buckets"] for row in self.run.channels),
        }

    @property
    def late(self) -> tuple[int, Any]:
        """How many channels have other samples than were scored, and from when on to score anew."""
        if self.status is None:
            return 0, None
        count = pc.sum(pc.greater(self.status["differing_contexts"], 0)).as_py() or 0
        return count, pc.min(self.status["repair_from"].cast(pa.int64())).as_py()

    def figures(self) -> dict[str, Any]:
        """Return what --json prints; times are as the source tells them."""
        run, (count, since) = self.run, self.late

        def told(row: Row, *times: str) -> Row:
            return {**row, **{name: self._told(row[name]) for name in times}}

        told_of = ["asset", "channel", "status", "hi", "hi_limit", "limit_reason", "last_time"]
        return {
            "database": self.settings.source.shown_database,
            "monitor": self.settings.monitor.name,
            "source": self.source,
            "dry_run": self.status is None,
            "totals": self.totals,
            "ranges": [told(row, "earliest") for row in run.ranges],
            "channels": [told(row, "read_from", "read_to") for row in run.channels],
            "parked": run.parked,
            "not_calibrated": [
                {"asset": asset, "channel": channel, "rows": rows}
                for (asset, channel), rows in sorted(run.unknown_channels.items())
            ],
            "rows_without_name": run.nameless,
            "rows_without_time": run.undated,
            "late": {"channels": count, "repair_from": self._told(since)},
            "other_settings": [
                {"asset": asset, "channel": channel} for asset, channel in self.differing
            ],
            "status": [] if self.status is None else self.status.select(told_of),
            **({} if self.status is None else _raised(self.status)),
            "copy": self.copy,
        }

    def _told(self, tick: int | None) -> int | str | None:
        if tick is None or tick <= LONG_AGO:
            return None
        return tick if self.kind.is_counter else shown_instant(tick, self.kind)

    def show(self, out: Console) -> None:
        """Print it."""
        where = f"{self.settings.source.shown_database}, monitor {self.settings.monitor.name}"
        page.say(out, f"{printable(where)}: {printable(self.source)}")
        if self.status is None:
            ranges = self.run.ranges
            columns = {
                "from": [f"{self._told(row['earliest']) or 'the beginning'}" for row in ranges],
                "channels": [f"{row['channels']:,}" for row in ranges],
                "rows": [f"{row['rows']:,}" for row in ranges],
            }
            page.table(out, columns)
        for line in self.lines():
            page.say(out, line)

    def lines(self) -> Iterator[str]:
        """Yield what is to be said of it."""
        run, totals = self.run, self.totals
        read = f"{number_of(totals['channels'], 'channel')}, {number_of(totals['rows'], 'row')}"
        if self.status is None:
            yield f"would read {read}; nothing was written"
        else:
            yield f"read {read}; wrote {number_of(totals['buckets'], 'bucket')}, new or anew"
        if run.parked:
            parked = number_of(run.parked, "channel")
            yield f"{parked} parked: looked at once a day, or now by --everything"
        if run.unknown_channels:
            rows = number_of(sum(run.unknown_channels.values()), "row")
            yield (
                f"{rows} of {number_of(len(run.unknown_channels), 'channel')} "
                f"without calibration: {_named(run.unknown_channels)}; gam calibrate gives them one"
            )
        if run.nameless:
            yield f"{number_of(run.nameless, 'row')} without asset or channel, left out"
        if run.undated:
            yield f"{number_of(run.undated, 'row')} without a time, left out"
        count, since = self.late
        if count:
            yield (
                f"{number_of(count, 'channel')} with samples that came later than lookback, or were "
                f"taken away: gam score --from {shown_instant(since, self.kind)} mends them"
            )
        if self.differing:
            yield (
                f"{self.settings.file} has other settings than those by which "
                f"{number_of(len(self.differing), 'channel')} learned: {_named(self.differing)}; "
                "gam calibrate takes them over"
            )
        if self.copy is not None:
            yield f"copied to {self.copy}"
        if self.status is None:
            return
        if set(self.status["verdict"].to_pylist()) <= {"no_data"}:
            yield "no channel has a calibration, so nothing is watched; run gam calibrate"
        else:
            yield f"channels: {page.counted(self.status.to_pylist())}; gam status shows them"
        yield from _judging(self.status)


def _named(channels: Any) -> str:
    return page.some([printable(f"{asset} {channel}") for asset, channel in sorted(channels)])


ASSETS = 20
"""Assets shown unless all are asked for."""


@options.taking(*options.STATE, "park_after", source=False, state=True)
def status(
    settings: Settings,
    asset: Annotated[
        str | None,
        typer.Option(metavar="PATTERN", help="Only these machines; * and ? stand for any text or sign."),
    ] = None,
    everything: options.All = False,
    time_zone: options.TimeZone = "UTC",
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Say how every channel is: verdict, floor, indicator, trend, and what is wrong with its data.

    It reads the state in the database, not the source; of assets, it prints the 20 most urgent unless
    there is --all. A channel needs attention (exit code 2) if an episode of it does (`gam alarms`),
    where it has a limit (`gam limits`), else if its indicator is above its limit; and if its calibration
    is not good enough.
    """
    monitor, silence, shown_in = settings.monitor.name, settings.monitor.park_after, zone(time_zone)
    with options.opened(settings, writable=False) as session:
        channels = stored_status.status(session, settings.monitor.tables, monitor, silence)
        proof = stored_status.proved(session, settings.monitor.tables, monitor)
    unheard = stored_status.unheard_for(channels, silence, dt.datetime.now(dt.UTC))
    if asset is not None:
        channels = _of_assets(channels, asset)
    urgent = need_attention(channels.to_pylist())
    figures = {
        "database": settings.source.shown_database,
        "monitor": monitor,
        "no_data_for_seconds": None if unheard is None else unheard.total_seconds(),
        "proved": None if proof is None else _proved(proof),
        "channels": channels,
        "assets": stored_status.by_asset(channels),
        **_raised(channels),
        "needs_attention": urgent,
    }

    def show(out: Console) -> None:
        where = f"{settings.source.shown_database}, monitor {monitor}"
        page.say(out, _heading(channels, where, shown_in))
        if unheard is not None:
            page.say(out, _silence(unheard))
        page.say(out, _proof(proof, dt.datetime.now(dt.UTC)))
        out.print()
        _show_status(out, channels, everything, shown_in)

    page.tell(Exit.ATTENTION if urgent else Exit.FINE, figures, show, as_json, quiet)


def _of_assets(channels: pa.Table, pattern: str) -> pa.Table:
    named = [pattern_matches(pattern, asset) for asset in channels["asset"].to_pylist()]
    found = channels.filter(pa.array(named, pa.bool_()))
    if not found.num_rows:
        raise ConfigurationError(f"No asset of this monitor is called like {pattern!r}.")
    return found


def _heading(channels: pa.Table, where: str, shown_in: dt.tzinfo) -> str:
    assets = len(channels["asset"].unique())
    newest = pc.max(channels["last_data"]).as_py()
    return (
        f"{printable(where)}: {number_of(channels.num_rows, 'channel')} of "
        f"{number_of(assets, 'asset')}, newest data {page.time_text(newest, shown_in, named=True)}"
    )


def _silence(unheard: dt.timedelta) -> str:
    length = shown_length(unheard // dt.timedelta(microseconds=1), TimeKind.TIMESTAMP)
    return f"no data at all for {length}: is the source filled, and is gam score run?"


def _proof(proof: Proof | None, now: dt.datetime) -> str:
    if proof is None:
        return "the state was never compared with its source; gam check --state does it"
    epoch = dt.datetime(1970, 1, 1, tzinfo=dt.UTC)
    age = (now - epoch) // dt.timedelta(microseconds=1) - proof.proved_at
    ago = shown_length(age, TimeKind.TIMESTAMP)
    found = f"{proof.differences:,} differences" if proof.differences else "no difference"
    return f"the state was last compared with its source {ago} ago: {found} (gam check --state)"


def _proved(proof: Proof) -> dict[str, Any]:
    said = {name: value for name, value in vars(proof).items() if name != "extent"}
    return {**said, "proved_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP)}


def _show_status(out: Console, channels: pa.Table, everything: bool, shown_in: dt.tzinfo) -> None:
    if not channels.num_rows:
        page.say(out, "no channel is calibrated yet; run gam calibrate")
        return
    rows = channels.to_pylist()
    shown = rows if everything else rows[: options.SHOWN]
    page.channels(out, shown, "last_data", "of late", shown_in, everything)
    page.cut(out, rows, everything, page.counted(rows[len(shown) :]))
    out.print()
    assets = stored_status.by_asset(channels).to_pylist()
    if len(assets) > 1:
        _show_assets(out, assets if everything else assets[:ASSETS])
        if not everything and len(assets) > ASSETS:
            page.say(out, f"and {len(assets) - ASSETS:,} more assets; --all")
        out.print()
    for line in _summary(channels, everything):
        page.say(out, line)


def _show_assets(out: Console, rows: Sequence[Row]) -> None:
    def told(name: str) -> Iterator[Any]:
        return (None if row["status"] == "not assessed" else row[name] for row in rows)

    columns = {
        "asset": [row["asset"] for row in rows],
        "worst channel": [printable(row["channel"]) for row in rows],
        "HI": [share(hi) for hi in told("hi")],
        "trend": [page.rise(trend) for trend in told("trend")],
        "channels": [f"{row['channels']:,}" for row in rows],
    }
    for told_of in ("need_attention", "silent"):
        if any(row[told_of] for row in rows):
            columns[told_of.replace("_", " ")] = [f"{row[told_of] or '-'}" for row in rows]
    page.table(out, columns, [page.MARKS.get(row["status"], " ") for row in rows], ("worst channel",))


def _summary(channels: pa.Table, everything: bool) -> Iterator[str]:
    yield "channels: " + page.counted(channels.to_pylist())
    silent = pc.sum(channels["silent"]).as_py()
    if silent:
        yield f"silent: {silent:,}"
    differing = pc.sum(pc.greater(channels["differing_contexts"], 0)).as_py()
    if differing:
        since = pc.min(channels["repair_from"]).as_py()
        yield (
            f"{differing:,} with samples that came later than lookback, or were taken away: gam score "
            f"--from {since.isoformat() if isinstance(since, dt.datetime) else since} mends them all"
        )
    changed = pc.sum(pc.not_equal(channels["calibration_rows_added"], 0)).as_py()
    if changed:
        yield f"{changed:,} with calibration data that changed; gam calibrate --again learns it anew"
    rows = channels.select(["remarks"]).to_pylist()
    yield f"{page.legend(rows, everything)} Trend: HI now less HI a window earlier."
    yield from _judging(channels)
