"""``gam check --state``: is what was scored still what the source gives?

This module owns the page; :mod:`gam_db.stored.checking` compares.
"""

import datetime as dt
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from rich.console import Console

import gam_db
from gam_db.cli import monitor_options, report
from gam_db.cli.progress import Progress, interruptible
from gam_db.clock import TimeKind, shown_instant
from gam_db.stored import migrations
from gam_db.stored.monitor import Monitor
from gam_db.stored.sources import source_of
from gam_db.stored.state import State, kind_of

#: Differences that are shown unless all are asked for.
_SHOWN = 20

Row = dict[str, Any]


def check_state(
    *,
    source: str | None,
    database: str | None,
    config: Path | None,
    name: str | None,
    schema: str | None,
    prefix: str | None,
    threads: int | None,
    everything: bool,
    as_json: bool,
    quiet: bool,
) -> bool:
    """Compare the state of a monitor with its source, and print what differs.

    Args:
        source: what to read instead of the relation that the monitor was made from.
        database: its address, as given; so the next four.
        config: the settings file.
        name: of the monitor.
        schema: of the state tables.
        prefix: of their names.
        threads: processor threads.
        everything: print every difference.
        as_json: print figures instead.
        quiet: print nothing.

    Returns:
        Whether anything differs.

    Raises:
        UserError: there is no such monitor, or its source cannot be used.
    """
    session, tables, settings = monitor_options.opened(
        file=config,
        database=database,
        name=name,
        schema=schema,
        prefix=prefix,
        threads=threads,
        writable=False,
        must_exist=True,
    )
    said = settings.monitor
    with interruptible(), session, Progress(session, quiet) as progress:
        migrations.require(session, tables)
        state = State(session, tables)
        known = state.monitor(said.name)
        channels = state.fetch("stored/known_channels", {"monitor_id": known["monitor_id"]})
        monitor = Monitor(
            session,
            source_of(known, channels["channel"].to_pylist(), source),
            lookback=said.lookback,
            name=said.name,
            schema=tables.schema,
            prefix=tables.prefix,
        )
        rows = monitor.check_state(on_step=progress.on_step).to_pylist()
    kind = kind_of(known)
    if as_json:
        print(
            json.dumps(_figures(said.name, channels.num_rows, rows, kind), ensure_ascii=False, indent=1)
        )
    elif not quiet:
        _show(report.console(), said.name, channels.num_rows, rows, kind, everything)
    return bool(rows)


def _figures(name: str, channels: int, rows: Sequence[Row], kind: TimeKind) -> Row:
    return {
        "gam_db": gam_db.__version__,
        "monitor": name,
        "channels": channels,
        "differences": [{**row, "day": _day(row), "since": _since(row, kind)} for row in rows],
    }


def _show(
    out: Console, name: str, channels: int, rows: Sequence[Row], kind: TimeKind, everything: bool
) -> None:
    if not rows:
        report.say(
            out,
            f"monitor {name}: {channels:,} channels, every settled bucket and every cell of calibration "
            "is what the source gives",
        )
        return
    others = {(row["asset"], row["channel"]) for row in rows}
    report.say(out, f"monitor {name}: {len(others):,} of {channels:,} channels differ from the source")
    for row in rows if everything else rows[:_SHOWN]:
        report.say(out, f"  {_line(row, kind)}")
    if not everything and len(rows) > _SHOWN:
        report.say(out, f"  and {len(rows) - _SHOWN:,} more (--all)")
    since = [row["since"] for row in rows if row["since"] is not None]
    if since:
        report.say(out, f"gam score --from {shown_instant(min(since), kind)} scores them anew")
    if any(row["part"] == "calibration" for row in rows):
        report.say(out, "gam calibrate --again makes new versions of the calibration as it is now")


def _line(row: Row, kind: TimeKind) -> str:
    named = report.printable(f"{row['asset']} {row['channel']}")
    counted = f"{row['samples_then']:,} then, {row['samples_now']:,} now"
    if row["part"] == "calibration":
        return f"{named}: calibration: rows {counted}; {row['differing']:,} cells visited otherwise"
    day = _day(row)
    when = "" if day is None else f" {day}"
    return (
        f"{named}:{when} samples {counted}; {row['differing']:,} buckets differ, from "
        f"{shown_instant(row['since'], kind)} on"
    )


def _day(row: Row) -> str | None:
    if row["day"] is None:
        return None
    return (dt.date(1970, 1, 1) + dt.timedelta(days=row["day"])).isoformat()


def _since(row: Row, kind: TimeKind) -> str | None:
    return None if row["since"] is None else shown_instant(row["since"], kind)
