"""The page of ``gam score``: what was read and made, and what is wrong with the data.

This module owns how a run looks, in words and as JSON. It computes nothing.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa
import pyarrow.compute as pc
from rich.console import Console

import gam_db
from gam_db.cli import report
from gam_db.cli.figures import plain
from gam_db.clock import LONG_AGO, TimeKind, shown_instant
from gam_db.stored.scoring import Report

_NAMES = 5
"""Names of channels shown in a line."""


@dataclass(frozen=True)
class Outcome:
    """A run and what is known after it.

    Attributes:
        database, monitor, source: in the user's words.
        kind: how the source tells time.
        run: what was read and made.
        status: of every channel after it; None if nothing was written.
        differing: asset and channel of those that the settings file would have calibrated otherwise.
        settings: that file, if there is one.
        copy: where a copy was written, if anywhere.
        code: the exit code.
    """

    database: str
    monitor: str
    source: str
    kind: TimeKind
    run: Report
    status: pa.Table | None
    differing: Sequence[tuple[str, str]]
    settings: str | None
    copy: str | None
    code: int

    @property
    def totals(self) -> dict[str, int]:
        """Channels and rows that were read, or would be, and buckets that were written."""
        ranges, channels = self.run.ranges, self.run.channels
        return {
            "channels": sum(row["channels"] for row in ranges),
            "rows": sum(row["rows"] for row in ranges),
            "buckets": sum(row["buckets"] for row in channels),
        }

    @property
    def late(self) -> tuple[int, Any]:
        """How many channels have other samples than were scored, and from when on to score anew."""
        if self.status is None:
            return 0, None
        count = pc.sum(pc.greater(self.status["differing_contexts"], 0)).as_py() or 0
        return count, pc.min(self.status["repair_from"].cast(pa.int64())).as_py()


def figures(outcome: Outcome) -> dict[str, Any]:
    """Return a run as one object that JSON can hold; times are as the source tells them."""
    run = outcome.run
    count, since = outcome.late

    def told(tick: int | None) -> int | str | None:
        if tick is None or tick <= LONG_AGO:
            return None
        return tick if outcome.kind.is_counter else shown_instant(tick, outcome.kind)

    return {
        "version": gam_db.__version__,
        "database": outcome.database,
        "monitor": outcome.monitor,
        "source": outcome.source,
        "dry_run": outcome.status is None,
        "totals": outcome.totals,
        "ranges": [{**row, "earliest": told(row["earliest"])} for row in run.ranges],
        "channels": [
            {**row, "read_from": told(row["read_from"]), "read_to": told(row["read_to"])}
            for row in run.channels
        ],
        "parked": run.parked,
        "not_calibrated": [
            {"asset": asset, "channel": channel, "rows": rows}
            for (asset, channel), rows in sorted(run.strangers.items())
        ],
        "rows_without_name": run.nameless,
        "rows_without_time": run.undated,
        "late": {"channels": count, "repair_from": told(since)},
        "other_settings": [{"asset": asset, "channel": channel} for asset, channel in outcome.differing],
        "status": [] if outcome.status is None else plain(_statuses(outcome.status)),
        "copy": outcome.copy,
        "needs_attention": outcome.code != 0,
        "exit_code": outcome.code,
    }


def _statuses(status: pa.Table) -> list[dict[str, Any]]:
    told = status.select(["asset", "channel", "status", "hi", "limit", "last_time"])
    rows: list[dict[str, Any]] = told.to_pylist()
    return rows


def show(out: Console, outcome: Outcome) -> None:
    """Print a run."""
    where = report.printable(f"{outcome.database}, monitor {outcome.monitor}")
    report.say(out, f"{where}: {report.printable(outcome.source)}")
    if outcome.status is None:
        _show_ranges(out, outcome)
    for line in _lines(outcome):
        report.say(out, line)


def _show_ranges(out: Console, outcome: Outcome) -> None:
    """Print what each query would read."""
    cells = [("from", "channels", "rows")]
    for row in outcome.run.ranges:
        begin = row["earliest"]
        told = "the beginning" if begin <= LONG_AGO else shown_instant(begin, outcome.kind)
        cells.append((told, f"{row['channels']:,}", f"{row['rows']:,}"))
    widths = [max(len(row[place]) for row in cells) for place in range(3)]
    for number, (begin, channels, rows) in enumerate(cells):
        line = f"  {begin:<{widths[0]}}  {channels:>{widths[1]}}  {rows:>{widths[2]}}"
        out.print(line, style="" if number else "bold", no_wrap=True, overflow="crop", crop=True)


def _lines(outcome: Outcome) -> Iterator[str]:
    run, totals = outcome.run, outcome.totals
    is_dry = outcome.status is None
    read = f"{_many('channel', totals['channels'])}, {_many('row', totals['rows'])}"
    if is_dry:
        yield f"would read {read}; nothing was written"
    else:
        yield f"read {read}; wrote {_many('bucket', totals['buckets'])}, new or anew"
    if run.parked:
        yield f"{_many('channel', run.parked)} parked: looked at once a day, or now by --everything"
    if run.strangers:
        yield (
            f"{_many('row', sum(run.strangers.values()))} of {_many('channel', len(run.strangers))} "
            f"without calibration: {_named(run.strangers)}; gam calibrate gives them one"
        )
    if run.nameless:
        yield f"{_many('row', run.nameless)} without asset or channel, left out"
    if run.undated:
        yield f"{_many('row', run.undated)} without a time, left out"
    count, since = outcome.late
    if count:
        yield (
            f"{_many('channel', count)} with samples that came later than lookback, or were taken away: "
            f"gam score --from {shown_instant(since, outcome.kind)} mends them"
        )
    if outcome.differing:
        yield (
            f"{outcome.settings} has other settings than those by which "
            f"{_many('channel', len(outcome.differing))} learned: {_named(outcome.differing)}; "
            "gam calibrate takes them over"
        )
    if outcome.copy is not None:
        yield f"copied to {outcome.copy}"
    if outcome.status is None:
        return
    if set(outcome.status["verdict"].to_pylist()) <= {"no_data"}:
        yield "no channel has a calibration, so nothing is watched; run gam calibrate"
    else:
        yield f"channels: {report.counted(outcome.status['status'].to_pylist())}; gam status shows them"


def _many(what: str, count: int) -> str:
    return f"{count:,} {what}{'s' * (count != 1)}"


def _named(channels: Any) -> str:
    names = [report.printable(f"{asset} {channel}") for asset, channel in sorted(channels)]
    return report.some(names, _NAMES)
