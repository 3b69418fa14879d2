"""``gam check --state``: all that is stored, compared with the source and with itself.

This module owns the page; :mod:`gam_db.stored.checking` compares.
"""

import datetime as dt
from collections.abc import Sequence

from rich.console import Console

from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.monitors import watched
from gam_db.cli.progress import working
from gam_db.clock import TimeKind, shown_instant
from gam_db.config import Settings
from gam_db.errors import EngineError, printable
from gam_db.findings import Row
from gam_db.stored.proving import Proof, keep
from gam_db.stored.state import State, kind_of

#: Parts that follow from the source, and of which is told what was counted.
_MENDED = ("scored", "calibration")
_EPOCH = dt.date(1970, 1, 1)


def check_state(
    settings: Settings, relation: str | tuple[str, ...] | None, common: options.Common
) -> None:
    """Compare the state of a monitor with its source, and print what differs.

    Args:
        settings: say which monitor.
        relation: what to read instead of the relation that it was made from.
        common: how it is printed.

    Raises:
        UserError: there is no such monitor, or its source cannot be used.
    """
    name = settings.monitor.name
    session = options.opened(settings, common.threads, writable=False)
    with working(session, common.quiet) as on_step:
        monitor, known = watched(session, settings, relation)
        found = monitor.checked_state(on_step=on_step)
    # Only now, and shortly: a DuckDB file that is open for writing is open for nobody else.
    unkept = None
    try:
        with options.opened(settings, common.threads) as session:
            state = State(session, settings.monitor.tables)
            keep(state, state.monitor(name)["monitor_id"], found.proof)
    except EngineError as error:
        unkept = str(error)
    kind, rows, proof = kind_of(known), found.differences.to_pylist(), found.proof

    def show(out: Console) -> None:
        _show_differences(out, name, proof, rows, kind, common)
        if unkept is not None:
            page.say(out, f"that this was checked could not be recorded: {unkept}")

    figures = {
        "monitor": name,
        "checked_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP),
        "recorded": unkept is None,
        **{name: getattr(proof, name) for name in ("channels", "versions", "buckets")},
        "differences": [_told(row, kind) for row in rows],
    }
    page.tell(Exit.ATTENTION if rows else Exit.FINE, figures, show, common)


def _show_differences(
    out: Console,
    name: str,
    proof: Proof,
    rows: Sequence[Row],
    kind: TimeKind,
    common: options.Common,
) -> None:
    if not rows:
        page.say(
            out,
            f"monitor {name}: {proof.channels:,} channels, {proof.buckets:,} buckets: all of it is what "
            "the source gives, and what calibration froze",
        )
        return
    others = {(row["asset"], row["channel"]) for row in rows if row["asset"] is not None}
    page.say(
        out, f"monitor {name}: {len(others):,} of {proof.channels:,} channels are not as they should be"
    )
    for row in common.of(rows):
        page.say(out, f"  {_line(_told(row, kind))}")
    page.cut(out, rows, common.everything)
    since = [row["since"] for row in rows if row["since"] is not None]
    if since:
        page.say(out, f"gam score --from {shown_instant(min(since), kind)} scores them anew")
    if any(row["part"] == "calibration" for row in rows):
        page.say(out, "gam calibrate --again makes new versions of the calibration as it is now")
    if any(row["part"] not in _MENDED and row["since"] is None for row in rows):
        page.say(
            out,
            "what no scoring mends was changed or damaged in the tables: put them back from a copy of "
            "the database; or gam calibrate --again makes new versions, and gam prune --keep-versions 0 "
            "removes the others",
        )


def _line(row: Row) -> str:
    """Return what is said of a difference, whose day and time are told."""
    named = printable(f"{row['asset']} {row['channel']}")
    since = "" if row["since"] is None else f", from {row['since']} on"
    if row["part"] not in _MENDED:
        said = f"{row['part']}: {row['what']} ({row['differing']:,}){since}"
        return said if row["asset"] is None else f"{named}: version {row['version']}: {said}"
    counted = f"{row['samples_then']:,} then, {row['samples_now']:,} now"
    if row["part"] == "calibration":
        return f"{named}: calibration: rows {counted}; {row['differing']:,} cells visited otherwise"
    when = "" if row["day"] is None else f" {row['day']}"
    return f"{named}:{when} samples {counted}; {row['differing']:,} buckets differ{since}"


def _told(row: Row, kind: TimeKind) -> Row:
    """Return a difference with its day and time as text."""
    day, since = row["day"], row["since"]
    return row | {
        "day": None if day is None else (_EPOCH + dt.timedelta(days=day)).isoformat(),
        "since": None if since is None else shown_instant(since, kind),
    }
