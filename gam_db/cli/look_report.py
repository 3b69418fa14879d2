"""The report of a look: a line per channel, then what is to be known, as lines for a terminal or a pipe.

This module owns how the look is shown; what the notes mean is said by :mod:`gam_db.checking`.
"""

import json
from collections.abc import Sequence
from typing import Any

from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from gam_db.checking import Look, Note, Proposal
from gam_db.checking.sampling import is_irregular
from gam_db.checking.times import is_heeded
from gam_db.checking.words import instant, number_of, percent, spoken
from gam_db.cli import report
from gam_db.cli.figures import asked, plain
from gam_db.cli.report import Job

_HEADINGS = ("samples", "step", "pauses", "missing", "least", "most", "values", "still", "cycle")
_LEAST_SAYING = ("values", "still", "most", "least")
"""The first to go where the terminal is narrow."""
_LEAST_NAME = 12
_NAMED = 5
"""Channels that a note names."""


def show(
    out: Console,
    job: Job,
    look: Look,
    found: Sequence[Note],
    proposal: Proposal,
    everything: bool = False,
) -> None:
    """Print the report.

    Args:
        out: where to.
        job: for the heading.
        look: what was seen.
        found: the notes on it, in order.
        proposal: what to set.
        everything: show every channel, however many there are.
    """
    for line in _heading(job, look):
        report.say(out, line)
    out.print()
    marks = _marks(found)
    rows = sorted(look.channels, key=lambda row: marks.get(_key(row)) != "!")
    shown = rows if everything else rows[: report.SHOWN]
    for text in _table(out, shown, marks, look):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    if len(rows) > len(shown):
        report.say(out, f"and {len(rows) - len(shown)} more; --all")
    out.print()
    one_asset = len({row["asset"] for row in look.channels}) <= 1
    for note in found:
        _say_note(out, note, one_asset, len(look.channels))
    for line in _ending(found, proposal, look):
        report.say(out, line)


def figures(
    job: Job, look: Look, found: Sequence[Note], proposal: Proposal, code: int
) -> dict[str, Any]:
    """Return the report as one object that JSON can hold; lengths in microseconds or counter steps."""
    return {
        **asked(job),
        "time": "counter" if look.kind.is_counter else "timestamp",
        "channels": [
            plain({name: value for name, value in row.items() if name != "settings_no"})
            for row in look.channels
        ],
        "rows_without": look.nameless,
        "notes": [
            {
                "subject": note.subject,
                "must_be_fixed": note.must,
                "text": note.text,
                "channels": [list(name) for name in note.channels],
            }
            for note in found
        ],
        "proposal": plain(
            {
                "max_gap": None if proposal.max_gap is None else proposal.max_gap.value,
                "max_gap_by_channel": {name: gap.value for name, gap in proposal.gaps.items()},
                "window": proposal.window,
            }
        ),
        "exit_code": code,
    }


def heading(job: Job, look: Look) -> str:
    """Return the source in a line: how much of it there is, and from when to when."""
    assets = number_of(len({row["asset"] for row in look.channels}), "asset")
    channels = number_of(len(look.channels), "channel")
    samples = number_of(sum(row["samples"] for row in look.channels), "sample")
    line = f"{report.printable(job.name)}: {channels} of {assets}, {samples}"
    if look.channels:
        first = instant(min(row["first_tick"] for row in look.channels), look.kind)
        last = instant(max(row["last_tick"] for row in look.channels), look.kind)
        line += f", time from {first} to {last}"
    return line


def note_line(note: Note, one_asset: bool, channels: int) -> str:
    """Return a note as a line, with the channels it concerns, if not all of them."""
    names = [
        report.printable(channel if one_asset else f"{asset} {channel}")
        for asset, channel in note.channels
    ]
    if not names:
        return note.text
    if len(names) == channels and channels > 1:
        return f"all channels: {note.text}"
    return f"{report.some(names, _NAMED)}: {note.text}"


def _heading(job: Job, look: Look) -> list[str]:
    line = heading(job, look)
    if job.settings:
        line += f"; settings from {job.settings}"
    return [line, report.columns_line(job.guess), report.method_line(job.parameters, job.calibration)]


def _marks(found: Sequence[Note]) -> dict[tuple[str, str], str]:
    """Return a mark per channel that has a note: ! must be fixed, ? to be known."""
    marks: dict[tuple[str, str], str] = {}
    for note in found:
        for name in note.channels:
            marks[name] = "!" if note.must else marks.get(name, "?")
    return marks


def _key(row: Any) -> tuple[str, str]:
    return (row["asset"], row["channel"])


def _table(
    out: Console, rows: Sequence[Any], marks: dict[tuple[str, str], str], look: Look
) -> list[Text]:
    """Return a line per channel; where there is no room, columns that say least are left out."""
    if not rows:
        return []
    one_asset = len({row["asset"] for row in rows}) == 1
    names = [
        report.printable(row["channel"] if one_asset else f"{row['asset']} {row['channel']}")
        for row in rows
    ]
    columns = {
        heading: [heading, *cells]
        for heading, cells in zip(
            _HEADINGS, zip(*(_cells(row, look) for row in rows), strict=True), strict=True
        )
    }
    name_width = max(7, *map(cell_len, names))
    free = out.width - 2
    empty = [heading for heading, cells in columns.items() if set(cells[1:]) == {"-"}]
    for heading in (*empty, *_LEAST_SAYING):
        if min(name_width, _LEAST_NAME) + _width(columns) > free:
            columns.pop(heading, None)
    name_width = min(name_width, max(_LEAST_NAME, free - _width(columns)))
    lines = []
    for number, name in enumerate(["channel", *names]):
        mark = marks.get(_key(rows[number - 1]), " ") if number else " "
        style = "bold" if not number else "bold red" if mark == "!" else ""
        line = Text(f"{mark} {report.fit(name, name_width)}", style)
        for cells in columns.values():
            line.append(f"  {cells[number]:>{max(map(cell_len, cells))}}")
        lines.append(line)
    return lines


def _width(columns: dict[str, list[str]]) -> int:
    return sum(2 + max(map(cell_len, cells)) for cells in columns.values())


def _cells(row: Any, look: Look) -> tuple[str, ...]:
    """Return what the table says of a channel, in the order of its headings."""
    return (
        f"{row['samples']:,}",
        _step(row, look),
        f"{row['pauses']:,}" if row["pauses"] else "-",
        percent(row["missing"] / row["samples"]) if row["missing"] else "-",
        _value(row["lowest"]),
        _value(row["highest"]),
        f"{row['values_seen']:,}",
        _still(row["longest_still"] / row["samples"]) if row["longest_still"] > 1 else "-",
        "-" if row["cycle_length"] is None else f"{row['cycle_length']:,}",
    )


def _step(row: Any, look: Look) -> str:
    """Return the usual step in time, and how far nine tenths of the steps are from it at most."""
    if row["typical_step"] is None:
        return "-"
    step = spoken(row["typical_step"], look.kind)
    if is_irregular(row):
        return f"~{step}"
    within = min(row["long_step"], row["longest_step"])
    jitter = max(within - row["typical_step"], row["typical_step"] - row["short_step"])
    return f"{step} ±{percent(jitter / row['typical_step'])}" if jitter else step


def _still(share: float) -> str:
    return percent(share) if share >= 0.01 else "<1 %"


def _value(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{value:,.0f}" if 1e4 <= abs(value) < 1e9 else f"{value:.4g}"


def _say_note(out: Console, note: Note, one_asset: bool, channels: int) -> None:
    mark = "!" if note.must else "-"
    width = min(out.width, 120) - 2
    for number, part in enumerate(report.folded(note_line(note, one_asset, channels), width)):
        style = "bold red" if note.must and number == 0 else ""
        out.print(Text(f"{mark if number == 0 else ' '} ", style).append(part, ""))


def _max_gap(proposal: Proposal) -> list[str]:
    """Return the proposed max_gap as it stands in gam.toml; nothing where there is none."""
    if proposal.max_gap is not None:
        return [f"max_gap = {json.dumps(proposal.max_gap.value)}"]
    return [f"max_gap of {number_of(len(proposal.gaps), 'channel')}"] if proposal.gaps else []


def _ending(found: Sequence[Note], proposal: Proposal, look: Look) -> list[str]:
    must = sum(note.must for note in found)
    lines = []
    if must:
        lines.append(f"{number_of(must, 'point')} marked ! must be fixed before anything is learnt")
    if look.channels:
        open_ended = [
            row
            for row in look.channels
            if row["pauses"] and not (is_heeded(look, row) or is_irregular(row))
        ]
        to_set = _max_gap(proposal) if open_ended else []
        if proposal.window != look.method.parameters.window:
            to_set.append(f"window = {proposal.window} ({proposal.window_reason})")
        if not must:
            lines.append("nothing must be fixed")
        if to_set:
            lines.append(f"to be set: {'; '.join(to_set)} (gam init writes it down)")
    lines.append(
        "step: usual step in time and its jitter (~ irregular). pauses: steps beyond five usual ones. "
        "values: distinct ones among at most 20,480 samples. still: longest stretch of one value. "
        "cycle: in samples, where the signal repeats itself."
    )
    return lines
