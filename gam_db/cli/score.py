"""``gam score``: scores new and late rows of every calibrated channel."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import pyarrow as pa

from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.job import heading, place, watched
from gam_db.cli.options import argument, option
from gam_db.cli.progress import working
from gam_db.cli.render import WORDS, Page, Section, Table, show
from gam_db.cli.status import both_lists, judging, raised, validity
from gam_db.cli.status import watched as watched_of
from gam_db.clock import LONG_AGO, TimeKind, instant, shown_instant
from gam_db.errors import ConfigurationError, printable
from gam_db.findings import Row, need_attention
from gam_db.reading.ahead import ahead_sentences
from gam_db.settings.setting import FLAG, INSTANT, TEXT, setting
from gam_db.settings.source import shown_relation
from gam_db.stored.calibrating import differing
from gam_db.stored.schema.copying import copy
from gam_db.stored.scoring.report import Report
from gam_db.stored.sources import relation_of
from gam_db.stored.state import kind_of
from gam_db.stored.status import assessed


@dataclass(frozen=True)
class Scope:
    """What is scored; see :meth:`gam_db.Monitor.score`."""

    since: str | None = setting(None, INSTANT)
    until: str | None = setting(None, INSTANT)
    full: bool = setting(False, FLAG)
    confirm: bool = setting(False, FLAG)
    everything: bool = setting(False, FLAG)
    asset: str = setting("*", TEXT)
    channel: str = setting("*", TEXT)

    def of(self, kind: TimeKind) -> Row:
        """Return the keywords; instants as they were given, once it is clear that they are such."""
        edges = {"since": ("--from", self.since), "until": ("--to", self.until)}
        return vars(self) | {
            name: None if text is None else shown_instant(instant(text, kind, option), kind)
            for name, (option, text) in edges.items()
        }


@options.of_state(*options.STATE, "lookback", "park_after", "as_json", "quiet", "threads")
def score(
    settings: Settings,
    scope: Scope,
    common: options.Common,
    source: list[str] | None = argument("score.source", None),
    dry_run: bool = option("score.dry_run", False),
    copy_to: Path | None = option("score.copy_to"),
) -> None:
    """Score new and late rows of every calibrated channel.

    You can run it at any time, and again after a crash: the stored results are the same. Exit codes 2
    and 4 mean the same as in `gam status`. 2: an episode needs attention, or an indicator is above its
    limit where a channel has no limit for judgements, or a calibration is not good enough. Otherwise 4:
    the data has a problem to fix, or no channel is watched.
    """
    if dry_run and copy_to is not None:
        raise ConfigurationError("--dry-run writes nothing; leave out --copy.")
    session = options.opened(settings, common.threads, files=[] if copy_to is None else [copy_to])
    with working(session, common.quiet) as on_step:
        relation = options.as_relation(source)
        monitor, monitor_row = watched(session, settings, relation)
        kind = kind_of(monitor_row)
        run = monitor.score(**scope.of(kind), dry_run=dry_run, on_step=on_step)
        stored = (monitor.state, settings.monitor.name)
        silence = settings.monitor.park_after
        status, problems = (None, None) if dry_run else assessed(*stored, silence)
        if copy_to is not None:
            on_step(f"copying to {copy_to}")
            copy(session, monitor.tables, copy_to)
        # Only a settings file can say that channels are to be calibrated otherwise.
        has_settings = settings.parameters or settings.calibration or settings.overrides
        program = monitor.source.program
        others = differing(*stored, *settings.method(), program) if has_settings else []
    urgent = status is not None and need_attention(status.to_pylist())
    figures = {
        **place(settings),
        "source": shown_relation(relation or relation_of(monitor_row)),
        "dry_run": dry_run,
        **_figures(run, kind, status),
        **({} if status is None or problems is None else both_lists(status, problems)),
        "other_settings": [{"asset": asset, "channel": channel} for asset, channel in others],
        "copy": copy_to,
    }
    lacking = problems is not None and problems.num_rows > 0

    def sections() -> Iterator[Section]:
        counted = "" if status is None else f": {watched_of(status)} watched"
        yield f"{heading(settings)}, from {printable(figures['source'])}{counted}"
        if dry_run:
            rows = [
                {**row, "begin": str(row["earliest"] or "the beginning")} for row in figures["ranges"]
            ]
            yield Table("ranges", rows)
        yield from _lines(figures, run, status, settings.file)
        if problems is not None:
            yield from page.problems(problems, False)

    show(Page(figures, sections(), urgent, lacking), common)


def _figures(run: Report, kind: TimeKind, status: pa.Table | None) -> Row:
    """Return the figures of a run and of the status after it; times as in the source."""

    def with_times(rows: Sequence[Row], *times: str) -> list[Row]:
        return [{**row, **{name: _time_text(row[name], kind) for name in times}} for row in rows]

    of_channels = ["asset", "channel", "status", "hi", "hi_limit", "limit_reason", "last_time"]
    return {
        "totals": {
            "channels": sum(row["channels"] for row in run.ranges),
            "rows": sum(row["rows"] for row in run.ranges),
            "buckets": sum(row["buckets"] for row in run.channels),
        },
        "ranges": with_times(run.ranges, "earliest"),
        "channels": with_times(run.channels, "read_from", "read_to"),
        "gone": [{"asset": asset, "channel": channel} for asset, channel in sorted(run.gone)],
        "parked": run.parked,
        "not_calibrated": [
            {"asset": asset, "channel": channel, "rows": row["readings"]}
            for (asset, channel), row in sorted(run.unknown_channels.items())
        ],
        "rows_without_name": run.nameless,
        "rows_without_time": run.undated,
        "ahead": with_times(run.ahead, "ahead_to"),
        "rows_skipped_by_clock": {
            "rows": run.skipped,
            "first": _time_text(run.first_skipped, kind),
            "last": _time_text(run.last_skipped, kind),
        },
        "valid_when": {"held": run.held, "invalid": run.invalid},
        "status": [] if status is None else status.select(of_channels),
        **({} if status is None else raised(status)),
    }


def _time_text(tick: int | None, kind: TimeKind) -> int | str | None:
    if tick is None or tick <= LONG_AGO:
        return None
    return tick if kind.is_counter else shown_instant(tick, kind)


def _lines(figures: Row, run: Report, status: pa.Table | None, file: Path | None) -> Iterator[str]:
    totals, others = figures["totals"], figures["other_settings"]
    read = f"{number_of(totals['channels'], 'channel')}, {number_of(totals['rows'], 'row')}"
    if status is None:
        yield f"would read {read}; wrote nothing"
    else:
        yield f"read {read}; wrote {number_of(totals['buckets'], 'bucket')}, new or changed"
    unknown: Sequence[Row] = ()  # of a run, they and rows that are ahead are data problems
    if status is None:
        yield from ahead_sentences(run.ahead, 0, run.clock)
        unknown = figures["not_calibrated"]
    skipped = figures["rows_skipped_by_clock"]
    of_unknown = number_of(sum(row["rows"] for row in unknown), "row")
    for name, count, thing, named in (
        ("gone", len(figures["gone"]), "channel", figures["gone"]),
        ("parked", figures["parked"], "channel", ()),
        ("not_calibrated", len(unknown), "channel", unknown),
        ("rows_without_name", figures["rows_without_name"], "row", ()),
        ("rows_without_time", figures["rows_without_time"] - skipped["rows"], "row", ()),
        ("rows_skipped", skipped["rows"], "row", ()),
        ("other_settings", len(others), "channel", others),
    ):
        if count:
            names = page.some(sorted(printable(f"{row['asset']} {row['channel']}") for row in named))
            more = {"rows": of_unknown, "file": file, "names": names}
            more |= {"first": skipped["first"], "last": skipped["last"]}
            yield WORDS["score"][name].format(count=number_of(count, thing), **more)
    yield from validity(figures["valid_when"])
    if figures["copy"] is not None:
        yield f"copied to {figures['copy']}"
    if status is None:
        return
    yield f"channels: {page.counted(status.to_pylist())}"
    yield from judging(status)
