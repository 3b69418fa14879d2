"""The report: findings as lines for a terminal or a pipe.

This module owns how things look. What they mean is said by :mod:`gam_db.findings`.
"""

import datetime as dt
import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

from gam_db.calibration import Calibration
from gam_db.findings import STATUSES, Finding, Row, is_short, need_attention, share
from gam_db.guess import Guess
from gam_db.parameters import Parameters
from gam_db.source import Source

SHOWN = 40
"""Channels shown unless all are asked for."""

BLOCKS = "▁▂▃▄▅▆▇█"
PLAIN_BLOCKS = "_.,-=+*#"
"""The same scale, for a terminal that has no block characters."""

_READABLE = 120
"""Columns beyond which a line of prose is hard to read."""
_LEAST_COURSE, _MOST_COURSE = 12, 48
MARKS = {"high": ("!", "bold red"), "setup": ("?", "yellow"), "waiting": ("~", "cyan")}
_MEANINGS = {
    "high": "above the limit",
    "setup": "without a good enough calibration",
    "waiting": "less than a window scored yet",
    "ok": "ok",
    "not assessed": "not assessable",
}


@dataclass(frozen=True)
class Job:
    """What was asked, for the heading of a report.

    Attributes:
        name: the source in the user's words.
        guess: its columns.
        parameters, calibration: the method.
        settings: the settings file that was read, if any.
    """

    name: str
    guess: Guess
    parameters: Parameters
    calibration: Calibration
    settings: str | None = None


@dataclass(frozen=True)
class Line:
    """A channel in the table of a report.

    Attributes:
        name: as it is shown; so is time.
        status, verdict, floor, hi, course, remarks: see :class:`~gam_db.findings.Finding`.
        trend: how much the indicator rose of late; None in reports that have no such column.
    """

    name: str
    status: str
    verdict: str
    floor: float | None
    hi: float | None
    course: NDArray[np.float64]
    time: str
    remarks: Sequence[str]
    trend: str | None = None


def console(width: int | None = None) -> Console:
    """Return the console of reports: no markup, so that names mean nothing but themselves."""
    return Console(width=width, markup=False, highlight=False, emoji=False)


def show(out: Console, job: Job, found: Sequence[Finding], everything: bool = False) -> None:
    """Print the report.

    Args:
        out: where to.
        job: for the heading.
        found: the findings, in order.
        everything: show every channel, however many there are.
    """
    for line in _heading(job, found):
        say(out, line)
    out.print()
    shown = found if everything else found[:SHOWN]
    one_asset = len({one.asset for one in shown}) == 1
    for text in channel_lines(out, [_line(one, one_asset) for one in shown]):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    if len(found) > len(shown):
        rest = counted(one.status for one in found[len(shown) :])
        say(out, f"and {len(found) - len(shown)} more ({rest}); --all")
    out.print()
    for line in _summary(found):
        say(out, line)


def sparkline(course: NDArray[np.float64], width: int, blocks: str = BLOCKS) -> str:
    """Return a course as one character per stretch of it, on the fixed scale 0 to 1.

    Args:
        course: shares; NaN where there is none yet, shown as a gap.
        width: characters to use, each the highest of its stretch; a shorter course takes one each.
        blocks: the characters, lowest first.
    """
    return "".join(
        " " if math.isnan(point) else blocks[min(int(point * len(blocks)), len(blocks) - 1)]
        for point in thinned(course, width)
    )


def thinned(course: NDArray[np.float64], points: int) -> list[float]:
    """Return a course in at most so many points: the highest of each stretch, so that no peak is lost.

    NaN where there is no indicator yet.
    """
    if not len(course):
        return []
    stretches = np.array_split(course, min(points, len(course)))
    return [float(np.fmax.reduce(stretch)) for stretch in stretches]


def _heading(job: Job, found: Sequence[Finding]) -> list[str]:
    assets = len({one.asset for one in found})
    samples = sum(one.support["samples"] for one in found)
    machines = f"{assets:,} asset{'s' * (assets != 1)}"
    channels = f"{len(found):,} channel{'s' * (len(found) != 1)}"
    settings = f"; settings from {job.settings}" if job.settings else ""
    return [
        f"{printable(job.name)}: {channels} of {machines}, {samples:,} samples{settings}",
        columns_line(job.guess),
        method_line(job.parameters, job.calibration),
    ]


def columns_line(guess: Guess) -> str:
    """Return which columns are read, and which of them were guessed."""
    source = guess.source
    named = {"asset": source.asset, "time": source.time}
    if isinstance(source, Source):
        named = {
            "asset": source.asset,
            "channel": source.channel,
            "time": source.time,
            "value": source.value,
        }
    shown = {role: column for role, column in named.items() if column is not None}
    line = "columns: " + " ".join(f"{role}={printable(column)}" for role, column in shown.items())
    if not isinstance(source, Source):
        names = [printable(name) for name in source.value_columns]
        line += f"; wide table, signals: {some(names)}"
    if guess.guessed:
        guessed = [role for role in guess.guessed if role != "layout"]
        line += f"; guessed: {'all' if len(guessed) == len(shown) else ', '.join(guessed)}"
    if "layout" in guess.guessed:
        line += f"; taken as {guess.guessed['layout']}"
    if guess.unused:
        line += f"; not used: {some([printable(name) for name in guess.unused])}"
    return line


def method_line(parameters: Parameters, calibration: Calibration) -> str:
    """Return the parameters and the calibration in one line."""
    said = [
        f"{name}={getattr(parameters, name)}"
        for name in ("m", "tau", "bins", "window", "stride", "max_gap", "target_floor")
        if getattr(parameters, name) is not None
    ]
    if parameters.overrides:
        said.append(f"{len(parameters.overrides)} overrides")
    return f"method: {' '.join(said)}; calibration: {healthy_part(calibration)}"


def healthy_part(calibration: Calibration) -> str:
    """Return what is calibration, in words."""
    if calibration.fraction is not None:
        healthy = f"the first {100 * calibration.fraction:.4g} % of each channel"
    elif calibration.duration is not None:
        healthy = f"the first {calibration.duration} of each channel"
    else:
        pieces = len(calibration.intervals or ())
        healthy = f"{pieces} interval{'s' * (pieces != 1)}"
    if calibration.pool is not None:
        healthy += ", pooled"
    return healthy


def channel_lines(out: Console, channels: Sequence[Line]) -> list[Text]:
    """Return a line per channel, and under it what is to be said of it; the first is the heading."""
    blocks = BLOCKS if can_show(out, BLOCKS) else PLAIN_BLOCKS
    names = [printable(one.name) for one in channels]
    verdict = max([7, *(len(one.verdict) for one in channels)])
    time_width = max([4, *(len(one.time) for one in channels)])
    trend = f"{'trend':>5}  " if any(one.trend is not None for one in channels) else ""
    free = out.width - (2 + 2 + verdict + 2 + 5 + 2 + 5 + 2 + len(trend) + 2 + time_width)
    name_width = min(max([7, *map(cell_len, names)]), max(12, free - _LEAST_COURSE))
    course = min(_MOST_COURSE, max(_LEAST_COURSE, free - name_width))
    lines = [
        Text(
            f"  {fit('channel', name_width)}  {'verdict':{verdict}}  floor     HI  "
            f"{trend}{fit('HI, 0 to 1', course)}  last",
            style="bold",
        )
    ]
    for one, name in zip(channels, names, strict=True):
        mark, style = MARKS.get(one.status, (" ", ""))
        is_shown = one.status != "not assessed"
        line = Text(f"{mark} {fit(name, name_width)}  {one.verdict:{verdict}}  ", style)
        line.append(f"{share(one.floor if is_shown else None):>5}  ")
        line.append(f"{share(one.hi if is_shown else None):>5}  ")
        if trend:
            line.append(f"{one.trend if is_shown else '-':>5}  ")
        line.append(fit(sparkline(one.course, course, blocks) if is_shown else "", course))
        line.append(f"  {one.time}")
        line.rstrip()
        lines.append(line)
        for remark in folded("; ".join(one.remarks), out.width - 4):
            lines.append(
                Text(f"    {remark}", style="dim" if one.status in ("ok", "not assessed") else "")
            )
    return lines


def _line(one: Finding, one_asset: bool) -> Line:
    return Line(
        name=one.channel if one_asset else f"{one.asset} {one.channel}",
        status=one.status,
        verdict=one.verdict,
        floor=one.support["floor"],
        hi=one.hi,
        course=one.course,
        time=time_text(one.time),
        remarks=one.remarks,
    )


def _summary(found: Sequence[Finding]) -> list[str]:
    supports = [one.support for one in found]
    lines = [
        "verdicts: " + verdicts(supports),
        "channels: " + counted(one.status for one in found),
        *advice(supports),
    ]
    short = [
        one
        for one in found
        if one.status in ("high", "ok", "waiting")
        and one.support["calibration_vectors"] < 8 * one.window
    ]
    if short:
        lines.append(
            f"{len(short)} ready, but on a calibration shorter than 8 windows: their floors come from "
            "blocks shorter than a window"
        )
    if not need_attention(found):
        lines.append("nothing needs attention")
    return [*lines, " ".join(legend(remark for one in found for remark in one.remarks))]


def verdicts(supports: Sequence[Row]) -> str:
    """Return how many calibrations have which verdict."""
    count = Counter(row["verdict"] for row in supports)
    order = ("ready", "too_fine", "needs_data", "constant", "no_data")
    return ", ".join(f"{count[name]:,} {name}" for name in order if count[name])


def advice(supports: Sequence[Row]) -> list[str]:
    """Return what can be done for calibrations that are not good enough, a line each.

    Args:
        supports: a row per channel, with its verdict and finest_bins.
    """
    lines = []
    if any(row["verdict"] == "no_data" for row in supports):
        lines.append(
            "no_data: say which part is healthy by --calibrate FROM/TO, --calibration-duration or "
            "--calibration-fraction, where it holds data"
        )
    short = sum(is_short(row) for row in supports)
    if short:
        lines.append(
            f"too little calibration in {short:,} of {len(supports):,}: say a longer healthy part by "
            "--calibrate FROM/TO, --calibration-duration or --calibration-fraction; a coarser grid "
            "would pass and see nothing"
        )
    too_fine = [row for row in supports if row["verdict"] == "too_fine" and not is_short(row)]
    grids = [row["finest_bins"] for row in too_fine]
    if grids:
        lines.append(
            f"grid too fine: {_ladder(grids)} (--bins, or [[override]] in gam.toml); the coarser the "
            "grid, the less it sees, so a longer calibration is better where it can be had"
        )
    return lines


def legend(said: Iterable[str]) -> list[str]:
    """Return what the words of a report mean, and no others.

    Args:
        said: its remarks.
    """
    words = [
        "HI: share of the last window's vectors in states that calibration never visited.",
        "Floor: what a healthy machine would show, from calibration itself.",
    ]
    remarks = " ".join(said)
    if "limit" in remarks:
        words.append(
            "Limit: twice the floor, the highest block of calibration or target_floor, whichever is "
            "largest."
        )
    if "out of range" in remarks:
        words.append("Out of range: holding a value beyond all those of calibration.")
    if "incomplete" in remarks:
        words.append("Incomplete: holding a missing sample, and left out.")
    return words


def _ladder(grids: Sequence[int]) -> str:
    """Return how many channels each grid would do for, the finest grid first."""
    steps = sorted(set(grids), reverse=True)
    counted = [(bins, sum(other >= bins for other in grids)) for bins in steps]
    return ", ".join(
        f"{bins} bins would do for " + ("all of them" if count == len(grids) else f"{count}")
        for bins, count in counted
    )


def counted(statuses: Iterable[str]) -> str:
    """Return how many channels are what, in words, the most urgent first."""
    count = Counter(statuses)
    return ", ".join(f"{count[status]:,} {_MEANINGS[status]}" for status in STATUSES if count[status])


def printable(name: str) -> str:
    """Return a name of the source with nothing in it that a terminal would obey."""
    return "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in name)


def time_text(time: Any) -> str:
    """Return an instant to the minute, or a counter; a dash where there is none."""
    if time is None:
        return "-"
    return f"{time:%Y-%m-%d %H:%M}" if isinstance(time, dt.datetime) else f"{time:,}"


def fit(text: str, width: int) -> str:
    """Return a text of exactly so many cells; what is too long loses its middle."""
    if cell_len(text) > width:
        head, tail = text[: width - width // 2 - 1], text[-(width // 2) :]
        while cell_len(head) + 1 + cell_len(tail) > width:
            head, tail = (head[:-1], tail) if cell_len(head) > cell_len(tail) else (head, tail[1:])
        text = f"{head}…{tail}"
    return text + " " * (width - cell_len(text))


def some(names: Sequence[str], most: int = 8) -> str:
    """Return the first names of a list, and how many more there are."""
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")


def folded(text: str, width: int) -> list[str]:
    """Return a text as lines of at most so many cells."""
    return [str(line).rstrip() for line in Text(text).wrap(Console(), width)] if text else []


def say(out: Console, line: str) -> None:
    """Print a line of prose, folded."""
    for part in folded(line, min(out.width, _READABLE)):
        out.print(Text(part))


def can_show(out: Console, text: str) -> bool:
    """Tell whether the terminal's alphabet has these characters."""
    try:
        text.encode(out.encoding)
    except (UnicodeEncodeError, LookupError):
        return False
    return True
