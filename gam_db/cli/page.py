"""What commands print: prose, tables, courses and remarks for a terminal or a pipe, or one JSON object.

This module owns how things look. What they mean is said by :mod:`gam_db.findings` and its like.
"""

import dataclasses
import datetime as dt
import io
import json
import math
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
import pyarrow as pa
import typer
from rich.cells import cell_len
from rich.console import Console
from rich.table import Column, Table
from rich.text import Text

import gam_db
from gam_db import data
from gam_db.checking.words import number_of
from gam_db.cli.course import Course
from gam_db.cli.exits import Exit
from gam_db.cli.options import SHOWN, Common
from gam_db.clock import TimeKind, aware, shown_length
from gam_db.errors import printable
from gam_db.findings import SEES, Row, is_short, share

MARKS = {"proving": "!", "open": "!", "high": "!", "setup": "?", "waiting": "~"}
_STYLES = {"!": "bold red", "?": "yellow", "^": "yellow", "~": "cyan"}
#: What pages say, by what it is of.
WORDS: Mapping[str, Mapping[str, str]] = data.table("gam_db.cli", "words.toml")

#: What makes the cell of a row: the name of its value, or a function of the row.
Cell = str | Callable[[Row], Any]

_WIDEST = 120
"""Columns beyond which a page is hard to read."""
_NAMED = 5
"""Channels that a remark names."""


#: Where a page goes.
Out = Console


def console() -> Out:
    """Return the console of pages: no markup, so that names mean nothing but themselves."""
    return Console(markup=False, highlight=False, emoji=False)


def text_console(width: int | None = None) -> Console:
    """Return a console whose page is a text, that of its ``file``; None is the width of the terminal."""
    plain_text: dict[str, Any] = {"force_terminal": False, "force_jupyter": False, "color_system": None}
    plain_text |= {"markup": False, "highlight": False, "emoji": False}
    return Console(file=io.StringIO(), width=width, **plain_text)


def tell(
    figures: Mapping[str, Any],
    show: Callable[[Console], None],
    common: Common,
    urgent: bool = False,
    failed: bool = False,
    lacking: bool = False,
) -> None:
    """Print a page, with --json its figures, with --quiet nothing, and end with an exit code.

    A machine that needs attention (``urgent``) comes before data that has to be mended (``lacking``).
    """
    code = Exit.ATTENTION if urgent else Exit.DATA if lacking else Exit.FINE
    code = Exit.OUR_FAULT if failed else code
    if common.as_json:
        print_json({"version": gam_db.__version__, **figures, "exit_code": int(code)})
    elif not common.quiet:
        show(console())
    if code:
        raise typer.Exit(code)


def print_json(figures: Any) -> None:
    """Print a value as JSON."""
    text = json.dumps(plain(figures), ensure_ascii=False, indent=1)
    # JSON lets signs stand that a terminal obeys: those beyond ASCII that cannot be printed.
    print(
        "".join(sign if sign.isprintable() or sign == "\n" else json.dumps(sign)[1:-1] for sign in text)
    )


def plain(value: Any) -> Any:
    """Return a value in the types of JSON; NaN and infinity are null, times are ISO 8601."""
    if isinstance(value, (pa.Table, np.generic)):
        return plain(value.to_pylist() if isinstance(value, pa.Table) else value.item())
    if isinstance(value, Mapping):
        return {str(name): plain(part) for name, part in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(part) for part in value]
    if isinstance(value, float):
        return float(value) if math.isfinite(value) else None
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, (dt.date, dt.datetime)):
        return value.isoformat()
    if dataclasses.is_dataclass(value):
        return plain({field.name: getattr(value, field.name) for field in dataclasses.fields(value)})
    return str(value)


def say(out: Console, *lines: str) -> None:
    """Print lines of prose, folded."""
    for line in lines:
        for part in Text(line).wrap(out, min(out.width, _WIDEST)):
            part.rstrip()
            out.print(part, soft_wrap=True)


def verbatim(out: Console, *texts: str) -> None:
    """Print lines as they are, never folded: what is to be pasted elsewhere."""
    for text in texts:
        for line in text.split("\n"):
            out.print(Text(printable(line)), soft_wrap=True)


def title(out: Console, text: str) -> None:
    """Print a line that stands above others."""
    out.print()
    out.print(Text(text, style="bold"))


def notes(out: Console, lines: Iterable[tuple[str, "str | Course"]]) -> None:
    """Print lines of prose, or courses, each behind a mark or a word."""
    grid = Table.grid(padding=(0, 1))
    for mark, line in lines:
        grid.add_row(Text(mark, _STYLES.get(mark, "")), Text(line) if isinstance(line, str) else line)
    _print(out, grid)


def table(
    out: Console,
    rows: Sequence[Row],
    columns: Mapping[str, Cell],
    mark: Callable[[Row], str] = lambda _: " ",
    left: Sequence[str] = (),
    spare: Sequence[str] = (),
) -> None:
    """Print rows as a table that fits, whatever the names.

    Columns are by heading. A number gets commas, and a dash stands for None. The first column names the
    rows, behind their marks, and is folded where there is no room; one of :class:`Course` takes what is
    left; those of ``left`` hold words; those of ``spare`` go where there is no room, in this order.
    """
    name, *_ = columns
    laid = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold", show_edge=False)
    by_heading = {heading: [cell(row, of) for row in rows] for heading, of in columns.items()}
    for heading, cells in by_heading.items():
        if cells and isinstance(cells[0], Course):
            laid.add_column(heading, width=Course.least, ratio=1, no_wrap=True)
            laid.expand, laid.width = True, min(out.width, _WIDEST)
            continue
        longest = max(map(cell_len, [heading, *cells]))
        if heading == name:
            laid.add_column(f"  {heading}", min_width=min(longest + 2, 18 if spare else 12))
        elif heading in left:
            laid.add_column(heading, min_width=min(longest, 12), overflow="fold")
        else:
            laid.add_column(heading, min_width=longest, justify="right", no_wrap=True)
    for sign, named, *others in zip(map(mark, rows), *by_heading.values(), strict=True):
        first = Table.grid(Column(width=1), Column(overflow="fold"), padding=(0, 1, 0, 0))
        first.add_row(sign, Text(printable(named)))
        laid.add_row(first, *others, style=_STYLES.get(sign, ""))
    if spare and laid.__rich_measure__(out, out.options).minimum > out.width:
        fewer = {heading: of for heading, of in columns.items() if heading != spare[0]}
        table(out, rows, fewer, mark, left, spare[1:])
        return
    _print(out, laid)


def cell(row: Row, of: Cell) -> Any:
    """Return a cell of a row; see :func:`table`."""
    value = row[of] if isinstance(of, str) else of(row)
    return "-" if value is None else f"{value:,}" if isinstance(value, int) else value


def when(heading: str, of: str, rows: Sequence[Row], zone: dt.tzinfo) -> dict[str, Cell]:
    """Return a column of times for :func:`table`, its heading with the time zone they are told in."""
    if any(isinstance(row[of], dt.datetime) for row in rows):
        heading = f"{heading}, {zone}"
    return {heading: lambda row: time_text(row[of], zone)}


def _print(out: Console, laid: Table) -> None:
    """Print a table without blanks at the ends of its lines."""
    for line in out.render_lines(laid, out.options.update(width=min(out.width, _WIDEST)), pad=False):
        text = Text.assemble(*((part.text, part.style or "") for part in line))
        text.rstrip()
        out.print(text, soft_wrap=True)


def channels(
    out: Console, rows: Sequence[Row], time: str, spanned: str, zone: dt.tzinfo, everything: bool
) -> None:
    """Print a line per channel with the ``time`` of it, what their courses span, and their remarks."""
    name = name_in(rows)
    columns: dict[str, Cell] = {
        "channel": name,
        "verdict": "verdict",
        "sees": sees,
        **({"bins": lambda row: str(row["bins"])} if len({row["bins"] for row in rows}) > 1 else {}),
        **floors(rows),
        "HI": lambda row: share(assessed(row, "hi")),
        **({"trend": lambda row: rise(assessed(row, "trend"))} if rows and "trend" in rows[0] else {}),
        "HI, 0 to 1": lambda row: Course(() if assessed(row, "course") is None else row["course"]),
        **(when("since", "onset", rows, zone) if any(row["onset"] is not None for row in rows) else {}),
    }
    last = when("last", time, rows, zone)
    spare = ("sees", *last)  # since when a signal is above comes before when its data ends
    table(out, rows, columns | last, marked, ("verdict", "bins"), spare)
    timed = [row for row in rows if row["course_from"] is not None and row["last_time"] is not None]
    if timed:
        first, last = min(row["course_from"] for row in timed), max(row["last_time"] for row in timed)
        line = f"HI, 0 to 1: {spanned}, from {time_text(first, zone)} to {time_text(last, zone)}"
        if isinstance(first, dt.datetime):
            micros = (aware(last) - aware(first)) // dt.timedelta(microseconds=1)
            line += f" {zone}, {shown_length(micros, TimeKind.TIMESTAMP)}"
        say(out, line)
    remarks(out, ((name(row), row["remarks"]) for row in rows), everything)


def assessed(row: Row, name: str) -> Any:
    """Return a value of a channel that is judged; None of others."""
    return None if row["status"] == "not assessed" else row[name]


def marked(row: Row) -> str:
    """Return the mark of a channel, or of a machine, by its status."""
    mark = MARKS.get(row["status"], " ")
    if mark == " " and row.get("is_far_above"):
        return "^"
    return "?" if mark in " ~" and row.get("verdict") == "blind" else mark


def sees(row: Row) -> str | None:
    """Return the smallest shift that a channel would show, in percent of its usual range."""
    return None if row["sees"] is None else f"{row['sees']} %"


def remarks(out: Console, by_channel: Iterable[tuple[str, Iterable[str]]], everything: bool) -> None:
    """Print what is said of some channels, each remark once, with the channels it is said of.

    Of several channels it is only said of how many there is more to say, unless everything is asked for.
    """
    listed = [(name, list(words)) for name, words in by_channel]
    if not (everything or len(listed) == 1):  # of several channels, a line each is enough
        if more := sum(any(not remark.startswith(SEES) for remark in words) for _, words in listed):
            say(out, f"of {more:,} there is more to say: --all")
        return
    by_remark: dict[str, list[str]] = {}
    for name, words in listed:
        for remark in words:
            by_remark.setdefault(remark, []).append(name)
    if by_remark:
        out.print()
        lines = ((some(names, of=len(listed)), remark) for remark, names in by_remark.items())
        notes(out, (("-", f"{names}: {remark}") for names, remark in lines))


def problems(out: Console, problem_table: pa.Table, everything: bool) -> None:
    """Print data problems (:meth:`gam_db.Monitor.data_problems`), each with what to do."""
    rows = problem_table.to_pylist()
    if not rows:
        return
    out.print(Text(f"data problems: {len(rows):,}", style="bold"))
    shown = rows if everything else rows[:SHOWN]
    notes(out, (("-", f"{row['sentence']}. {row['advice']}") for row in shown))
    kinds = Counter(row["kind"] for row in rows[SHOWN:])
    cut(out, rows, everything, lambda _: ", ".join(f"{count:,} {kind}" for kind, count in kinds.items()))


def name_in(rows: Sequence[Mapping[str, Any]]) -> Callable[[Mapping[str, Any]], str]:
    """Return what names a channel among others: without its asset, if it is the same for all."""
    is_same_asset = len({row["asset"] for row in rows}) <= 1
    return lambda row: printable(row["channel"] if is_same_asset else f"{row['asset']} {row['channel']}")


def amount(rows: Sequence[Row], what: str = "channel") -> str:
    """Return how many channels there are, or what there is of each, and of how many assets."""
    return f"{number_of(len(rows), what)} of {number_of(len({row['asset'] for row in rows}), 'asset')}"


def cut(
    out: Console,
    rows: Sequence[Any],
    everything: bool,
    words: Callable[[Sequence[Any]], str] = lambda _: "",
    most: int = SHOWN,
    what: str = "",
) -> None:
    """Say how many rows were left out of a table, if any were, and what is to be said of them."""
    if not everything and len(rows) > most:
        tally = words(rows[most:])
        say(out, f"and {len(rows) - most:,} more{what}{f' ({tally})' if tally else ''}; --all")


def _tally(rows: Iterable[Row], of: str) -> str:
    """Return how many rows have which value of a column, in the words and the order of the table."""
    count = Counter(row[of] for row in rows)
    return ", ".join(f"{count[name]:,} {word}" for name, word in WORDS[of].items() if count[name])


#: How many calibrations have which verdict.
verdicts = partial(_tally, of="verdict")


def counted(rows: Iterable[Row]) -> str:
    """Return how many channels are what, the most urgent first; none far above its limit is ok."""
    far = {"status": "far above"}
    shown = (row | far if row["status"] == "ok" and row["is_far_above"] else row for row in rows)
    return _tally(shown, of="status")


def unseen(rows: Sequence[Row]) -> list[str]:
    """Return a line that counts the channels that would not see a change, if there are such."""
    counts = Counter(
        change for row in rows if row["would_not_see"] for change in row["would_not_see"].split(", ")
    )
    words = ", ".join(f"{change} ({count:,})" for change, count in counts.most_common())
    return [f"of {len(rows):,} would not see: {words}"] if words else []


def floors(rows: Sequence[Row]) -> dict[str, Cell]:
    """Return the column of floors, and beside it of those by leaving one machine of a pool out."""
    by_machine: dict[str, Cell] = {"by machine": lambda row: share(row["member_floor"])}
    is_pooled = any(row["member_floor"] is not None for row in rows)
    return {"floor": lambda row: share(assessed(row, "floor")), **(by_machine if is_pooled else {})}


def advice(supports: Sequence[Row]) -> list[str]:
    """Return what can be done for calibrations that are not good enough, a line each."""
    texts, lines = WORDS["advice"], []
    if any(row["verdict"] == "no_data" for row in supports):
        lines.append(texts["no_data"])
    if short := sum(row["verdict"] == "needs_data" or is_short(row) for row in supports):
        lines.append(texts["short"].format(short=short, all=len(supports)))
    too_fine = (row for row in supports if row["verdict"] == "too_fine" and not is_short(row))
    if grids := [row["finest_bins"] for row in too_fine]:
        steps = [(bins, sum(other >= bins for other in grids)) for bins in sorted(set(grids))[::-1]]
        ladder = ", ".join(
            f"{bins} bins would do for {'all of them' if count == len(grids) else count}"
            for bins, count in steps
        )
        lines.append(texts["too_fine"].format(ladder=ladder))
    return lines


def legend(rows: Sequence[Row], everything: bool) -> str:
    """Return what the words of a page of channels mean, and no others."""
    shown = rows if everything or len(rows) == 1 else ()
    remarks = " ".join(remark for row in shown for remark in row["remarks"])
    return " ".join(of for word, of in WORDS["legend"].items() if word == "always" or word in remarks)


def time_text(time: Any, zone: dt.tzinfo = dt.UTC, named: bool = False) -> str:
    """Return an instant to the minute, in a time zone, or a counter; a dash where there is none."""
    if time is None:
        return "-"
    if not isinstance(time, dt.datetime):
        return f"{time:,}"
    return f"{aware(time).astimezone(zone):%Y-%m-%d %H:%M}{f' {zone}' * named}"


def rise(trend: float | None) -> str:
    """Return a change of the indicator with its sign: +0.02, -0.31; 0 where it is below 0.005."""
    if trend is None:
        return "-"
    return "0" if abs(trend) < 0.005 else f"{trend:+.2f}"


def some(names: Sequence[str], most: int = _NAMED, of: int = 1) -> str:
    """Return the first names of a list, and how many more there are; a word if it is all ``of`` many."""
    if len(names) == of > 1:
        return "all channels"
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
