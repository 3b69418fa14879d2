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
from gam_db.errors import EngineError
from gam_db.stored import migrations
from gam_db.stored.monitor import Monitor
from gam_db.stored.proving import Proof, keep
from gam_db.stored.sources import source_of
from gam_db.stored.state import State, kind_of

#: Differences that are shown unless all are asked for.
_SHOWN = 20

#: Parts that follow from the source, and of which is told what was counted.
_MENDED = ("scored", "calibration")

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
        found = monitor.checked_state(on_step=progress.on_step)
    # Only now, and shortly: a DuckDB file that is open for writing is open for nobody else.
    unkept = None
    try:
        _keep(
            found.proof,
            file=config,
            database=database,
            name=name,
            schema=schema,
            prefix=prefix,
            threads=threads,
        )
    except EngineError as error:
        unkept = str(error)
    kind, rows = kind_of(known), found.differences.to_pylist()
    if as_json:
        figures = _figures(said.name, found.proof, unkept, rows, kind)
        print(json.dumps(figures, ensure_ascii=False, indent=1))
    elif not quiet:
        _show(report.console(), said.name, found.proof, rows, kind, everything)
        if unkept is not None:
            report.say(report.console(), f"that this was checked could not be recorded: {unkept}")
    return bool(rows)


def _keep(proof: Proof, **where: Any) -> None:
    """Record the check, in a session that can write."""
    session, tables, settings = monitor_options.opened(**where, writable=True, must_exist=True)
    with session:
        state = State(session, tables)
        keep(state, state.monitor(settings.monitor.name)["monitor_id"], proof)


def _figures(name: str, proof: Proof, unkept: str | None, rows: Sequence[Row], kind: TimeKind) -> Row:
    return {
        "gam_db": gam_db.__version__,
        "monitor": name,
        "checked_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP),
        "recorded": unkept is None,
        "channels": proof.channels,
        "versions": proof.versions,
        "buckets": proof.buckets,
        "differences": [{**row, "day": _day(row), "since": _since(row, kind)} for row in rows],
    }


def _show(
    out: Console, name: str, proof: Proof, rows: Sequence[Row], kind: TimeKind, everything: bool
) -> None:
    if not rows:
        report.say(
            out,
            f"monitor {name}: {proof.channels:,} channels, {proof.buckets:,} buckets: all of it is what "
            "the source gives, and what calibration froze",
        )
        return
    others = {(row["asset"], row["channel"]) for row in rows if row["asset"] is not None}
    report.say(
        out, f"monitor {name}: {len(others):,} of {proof.channels:,} channels are not as they should be"
    )
    for row in rows if everything else rows[:_SHOWN]:
        report.say(out, f"  {_line(row, kind)}")
    if not everything and len(rows) > _SHOWN:
        report.say(out, f"  and {len(rows) - _SHOWN:,} more (--all)")
    since = [row["since"] for row in rows if row["since"] is not None]
    if since:
        report.say(out, f"gam score --from {shown_instant(min(since), kind)} scores them anew")
    if any(row["part"] == "calibration" for row in rows):
        report.say(out, "gam calibrate --again makes new versions of the calibration as it is now")
    if any(row["part"] not in _MENDED and row["since"] is None for row in rows):
        report.say(
            out,
            "what no scoring mends was changed or damaged in the tables: put them back from a copy of "
            "the database; or gam calibrate --again makes new versions, and gam prune --keep-versions 0 "
            "removes the others",
        )


def _line(row: Row, kind: TimeKind) -> str:
    if row["part"] not in _MENDED:
        return _damage(row, kind)
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


def _damage(row: Row, kind: TimeKind) -> str:
    """Return what is said of a difference that the source did not make."""
    said = f"{row['part']}: {row['what']} ({row['differing']:,})"
    if row["since"] is not None:
        said += f", from {shown_instant(row['since'], kind)} on"
    if row["asset"] is None:
        return said
    named = report.printable(f"{row['asset']} {row['channel']}")
    return f"{named}: version {row['version']}: {said}"


def _day(row: Row) -> str | None:
    if row["day"] is None:
        return None
    return (dt.date(1970, 1, 1) + dt.timedelta(days=row["day"])).isoformat()


def _since(row: Row, kind: TimeKind) -> str | None:
    return None if row["since"] is None else shown_instant(row["since"], kind)
