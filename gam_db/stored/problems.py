"""Data problems: problems of the data of a monitor, apart from machines that need attention.

``sql/stored/state/data_problems.sql`` finds them, in the state alone. This module owns their table and
their sentences, which are in ``problems.toml``.
"""

import datetime as dt
from collections.abc import Iterable, Mapping, Sequence

import pyarrow as pa

from gam_db import data
from gam_db.checking.words import number_of
from gam_db.clock import TimeKind, shown_instant, shown_length, time_of
from gam_db.columns import COUNT, WORD, columns, name_of
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.reading.ahead import Clock, zone_hours
from gam_db.units import time_type

_WORDS: Mapping[str, Mapping[str, str]] = data.table("gam_db.stored", "problems.toml")

#: The kinds, in the order in which they are listed.
KINDS = tuple(_WORDS)

#: The text for readings without a program.
_NO_PROGRAM = "nothing says what ran"

#: What a problem lacks that is not of a version.
_LACKING: Row = dict.fromkeys(
    ("asset", "channel", "version", "why", "affected", "total", "since", "until"), None
)


def data_problems(rows: Iterable[Row], kind: TimeKind, shown_in: dt.tzinfo = dt.UTC) -> pa.Table:
    """Return data problems as a table, in the order of :data:`KINDS`, then by asset and channel.

    A row is a problem of one channel, or of the monitor, where asset and channel are NULL:

    * ``kind``: outage (of the monitor: its newest row is more than park_after old, or more than half
      of the channels would be silent at once, and then no single one is), unwatched (of the monitor: no
      channel is watched), lost (rows that were scored are gone), late (rows came later than lookback),
      ahead (rows later than now, which are left out until then), local_times (of the monitor: most
      channels are ahead alike by whole or half hours), jump (a counter went on by more than 1,000 usual
      steps at once), calibration (rows came into it after it was learnt), unknown (rows of a channel
      that no calibration knows: a new or renamed one), constant (it did not move in calibration and
      moves now), no_data (no usable reading in calibration), silent (its newest row is more than
      park_after behind the newest of the monitor, or there is none)
    * ``asset``, ``channel``: its names
    * ``count``: rows (lost and late: at least; ahead, calibration, unknown), steps (jump), channels
      (outage, unwatched), novel vectors of the last window (constant), else NULL; ``total``: of how many
      channels (outage, unwatched), else NULL
    * ``since``, ``until``: silent: its newest time, and that of the monitor; outage: its newest time;
      lost and late: the range that was read; constant: until the last scored vector. Timestamps as in
      the source, or integers where it counts; NULL where there is none
    * ``sentence``, ``advice``: what is wrong, and what to do

    Args:
        rows: of data_problems.sql, each with asset, channel, version and why (no_data: why nothing
            could be learnt).
        kind: how the source tells time.
        shown_in: the time zone of the sentences.
    """
    ordered = sorted(
        rows, key=lambda row: (KINDS.index(row["kind"]), *((name or "") for name in name_of(row)))
    )
    problems = [row | _sentences(row, kind, shown_in) for row in ordered]
    time = time_type(kind)
    schema = columns(
        *((WORD, "kind asset channel"), (COUNT, "count total"), (time, "since until")),
        (WORD, "sentence advice"),
    )
    names = {"count": "affected"}
    arrays = [
        pa.array([row[names.get(field.name, field.name)] for row in problems], field.type)
        for field in schema
    ]
    return pa.Table.from_arrays(arrays, schema=schema)


def left_out(rows: Sequence[Row], channels: int) -> list[Row]:
    """Return the problems of channels of which the newest run left rows out.

    Args:
        rows: of left_out_rows.sql.
        channels: how many channels the monitor has.
    """
    problems = [_LACKING | row for row in rows]
    ahead = [{**row, "ahead_to": row["until"]} for row in rows if row["kind"] == "ahead"]
    if ahead:
        started = ahead[0]["started"]
        hours = zone_hours(ahead, channels, Clock(started, started))
        if hours is not None:
            problems.append({**_LACKING, "kind": "local_times", "hours": hours})
    return problems


def programs(rows: Iterable[Row]) -> list[Row]:
    """Return the problems of programs that are not judged, by the rows of program_problems.sql."""
    why = {
        "unknown": "{} was never calibrated",
        "needs_data": "{} is too little in calibration",
    }
    return [
        {
            **_LACKING,
            **row,
            "kind": "program",
            "why": _NO_PROGRAM if row["program"] is None else why[row["verdict"]].format(row["program"]),
        }
        for row in rows
    ]


def jumped(rows: Iterable[Row]) -> list[Row]:
    """Return the problems of counters that jumped, by the rows of jumps.sql."""
    return [
        {
            **_LACKING,
            **{name: row[name] for name in ("asset", "channel")},
            "kind": "jump",
            "affected": row["jump"],
            "until": row["jumped_to"],
        }
        for row in rows
    ]


def _sentences(row: Row, kind: TimeKind, shown_in: dt.tzinfo) -> Row:
    sentences = _WORDS[row["kind"]]
    since, until, count, total = row["since"], row["until"], row["affected"], row["total"]
    words = {
        "name": printable(" ".join(name for name in name_of(row) if name is not None)),
        "count": "" if count is None else f"{count:,}",
        "rows": "" if count is None else number_of(count, "row"),
        "readings": "" if count is None else number_of(count, "reading"),
        "channels": "" if total is None else number_of(total, "channel"),
        "since": "" if since is None else _shown(since, kind, shown_in),
        "until": "" if until is None else _shown(until, kind, shown_in),
        "since_exact": "" if since is None else shown_instant(since, kind),
        "behind": "" if since is None or until is None else shown_length(until - since, kind),
        "version": row["version"],
        "why": None if row["why"] is None else printable(row["why"]),
        "hours": row.get("hours"),
    }
    form = "never" if since is None else "sentence"
    return {"sentence": sentences[form].format(**words), "advice": sentences["advice"].format(**words)}


def _shown(tick: int, kind: TimeKind, shown_in: dt.tzinfo) -> str:
    """Return an instant to the minute, with its zone; a counter as it is."""
    try:
        time = time_of(tick, kind)
    except OverflowError:  # no calendar has the year
        return shown_instant(tick, kind)
    if isinstance(time, int):
        return f"{time:,}"
    return f"{time.astimezone(shown_in):%Y-%m-%d %H:%M} {shown_in}"
