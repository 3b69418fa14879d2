"""Pages as data, and the one renderer that prints them: for a terminal or a pipe, or as one JSON object.

This module owns how things look. Which sections a page has is up to the commands and
:mod:`gam_db.cli.page`.
"""

import dataclasses
import datetime as dt
import io
import json
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pyarrow as pa
import typer
from rich import table
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

import gam_db
from gam_db import data
from gam_db.checking.words import percent
from gam_db.cli.course import Course
from gam_db.cli.exits import Exit
from gam_db.cli.options import Common
from gam_db.clock import aware
from gam_db.errors import printable
from gam_db.findings import Row, share

#: Texts of pages, by their subject.
WORDS: Mapping[str, Mapping[str, str]] = data.table("gam_db.cli", "words.toml")

_STYLES = {"!": "bold red", "?": "yellow", "^": "yellow", "~": "cyan"}
_WIDEST = 120
"""Columns beyond which a page is hard to read."""


def time_text(time: Any, zone: dt.tzinfo = dt.UTC, named: bool = False) -> str:
    """Return an instant to the minute, in a time zone, or a counter; a dash where there is none."""
    if time is None:
        return "-"
    if not isinstance(time, dt.datetime):
        return f"{time:,}"
    return f"{aware(time).astimezone(zone):%Y-%m-%d %H:%M}{f' {zone}' * named}"


def rise(trend: float) -> str:
    """Return a change of the indicator with its sign: +0.02, -0.31; 0 where it is below 0.005."""
    return "0" if abs(trend) < 0.005 else f"{trend:+.2f}"


def _interval(of: Any) -> str:
    """Return a range of values (place, value_from, value_to), or several."""
    if not isinstance(of, Mapping):
        return " | ".join(map(_interval, of))
    ends = [of[name] for name in ("value_from", "value_to")]
    if of["place"] == "within":
        return " to ".join(f"{end:.4g}" for end in ends)
    return f"{of['place']} {next(end for end in ends if end is not None):.4g}"


#: What makes the cell of a value that is not None; the zone is for times.
FORMATS: Mapping[str, Callable[[Any, dt.tzinfo], Any]] = {
    "text": lambda of, _: printable(of) if isinstance(of, str) else f"{of:,}",
    "number": lambda of, _: str(of),
    "share": lambda of, _: share(of),
    "rate": lambda of, _: f"{of:.3f}",
    "percent": lambda of, _: f"{of} %" if isinstance(of, int) else percent(of),
    "factor": lambda of, _: f"{of:,.1f}",
    "measurement": lambda of, _: f"{of:,.0f}" if 1e4 <= abs(of) < 1e9 else f"{of:.4g}",
    "trend": lambda of, _: rise(of),
    "time": lambda of, zone: time_text(of, zone),
    "interval": lambda of, _: _interval(of),
    "course": lambda of, _: Course(of),
}


@dataclass(frozen=True)
class Column:
    """A column of a table; see ``tables.toml``."""

    heading: str
    key: str
    format: str = "text"
    spare: int = 0
    left: bool = False
    optional: bool = False


@dataclass(frozen=True)
class Table:
    """Rows under columns, each behind its mark, with times in a zone; nothing where there is no row."""

    name: str  # of its columns in tables.toml, and of its headings in the legend
    rows: Sequence[Row]
    mark: Callable[[Row], str] = lambda _: " "
    zone: dt.tzinfo = dt.UTC
    columns: Sequence[Column] = ()

    def shown(self) -> list[tuple[Column, list[Any]]]:
        """Return the columns that have something to show, and their cells."""
        columns = self.columns or [
            Column(**of) for of in data.table("gam_db.cli", "tables.toml")[self.name]
        ]
        shown = []
        for column in columns:
            found = [row.get(column.key) for row in self.rows]
            if column.optional and all(cell is None for cell in found):
                continue
            if column.format == "time" and any(isinstance(cell, dt.datetime) for cell in found):
                column = dataclasses.replace(column, heading=f"{column.heading}, {self.zone}")
            form = FORMATS[column.format]
            empty = Course(()) if column.format == "course" else "-"
            shown.append((column, [empty if cell is None else form(cell, self.zone) for cell in found]))
        return shown


@dataclass(frozen=True)
class Notes:
    """Lines of prose, or courses, each behind a mark or a word."""

    lines: Iterable[tuple[str, str | Course]]


@dataclass(frozen=True)
class Title:
    """A line that stands above others."""

    text: str


@dataclass(frozen=True)
class Verbatim:
    """Lines as they are, never folded: for the clipboard."""

    text: str


#: A part of a page; a text is a line of prose, which is folded.
Section = str | Table | Notes | Title | Verbatim


@dataclass(frozen=True)
class Page:
    """The result of a command: figures for --json, sections for people, and reasons of its exit code.

    A machine that needs attention (``urgent``) comes before a problem of the data (``lacking``).
    """

    figures: Mapping[str, Any]
    sections: Iterable[Section] = ()
    urgent: bool = False
    lacking: bool = False
    failed: bool = False

    @property
    def code(self) -> Exit:
        """How the command ends."""
        if self.failed:
            return Exit.OUR_FAULT
        return Exit.ATTENTION if self.urgent else Exit.DATA if self.lacking else Exit.FINE


def show(page: Page, common: Common) -> None:
    """Print a page, with --json its figures, with --quiet nothing, and end with its exit code."""
    if common.as_json:
        print_json({"version": gam_db.__version__, **page.figures, "exit_code": int(page.code)})
    elif not common.quiet:
        write(page.sections)
    if page.code:
        raise typer.Exit(page.code)


def write(sections: Iterable[Section], out: Console | None = None) -> None:
    """Print sections, and at the end the legend of their words."""
    # No markup, so that names mean nothing but themselves.
    out = out or Console(markup=False, highlight=False, emoji=False)
    legend = _Legend()
    for section in sections:
        if isinstance(section, str):
            _print_prose(out, section)
        elif isinstance(section, Table):
            _print_table(out, section, legend)
        elif isinstance(section, Notes):
            grid = table.Table.grid(padding=(0, 1))
            for mark, line in section.lines:
                legend.remarks += f" {line}"
                grid.add_row(
                    Text(mark, _STYLES.get(mark, "")), Text(line) if isinstance(line, str) else line
                )
            _print(out, grid)
        elif isinstance(section, Title):
            out.print()
            out.print(Text(section.text, style="bold"))
        else:
            for line in section.text.split("\n"):
                out.print(Text(printable(line)), soft_wrap=True)
    if text := legend.text():
        _print_prose(out, text)


def text_of(sections: Iterable[Section], width: int | None = None) -> str:
    """Return sections as a text; *width* None is that of the terminal."""
    plain_text: dict[str, Any] = {"force_terminal": False, "force_jupyter": False, "color_system": None}
    plain_text |= {"markup": False, "highlight": False, "emoji": False}
    out = io.StringIO()
    write(sections, Console(file=out, width=width, **plain_text))
    return out.getvalue()


@dataclass
class _Legend:
    """The words of a page that need an explanation: headings of its tables, and words of its remarks."""

    headings: set[str] = field(default_factory=set)
    remarks: str = ""

    def text(self) -> str:
        """Return what those words mean that the page has, in the order of the table of words."""
        texts = WORDS["legend"].items()
        return " ".join(of for word, of in texts if word in self.headings or f" {word}" in self.remarks)


def _print_prose(out: Console, line: str) -> None:
    for part in Text(line).wrap(out, min(out.width, _WIDEST)):
        part.rstrip()
        out.print(part, soft_wrap=True)


def _print(out: Console, laid: table.Table) -> None:
    """Print a table without blanks at the ends of its lines."""
    for line in out.render_lines(laid, out.options.update(width=min(out.width, _WIDEST)), pad=False):
        text = Text.assemble(*((part.text, part.style or "") for part in line))
        text.rstrip()
        out.print(text, soft_wrap=True)


def _print_table(out: Console, of: Table, legend: _Legend) -> None:
    """Print a table that fits, whatever the names; where there is no room, empty columns go first."""
    if not of.rows:
        return
    shown = of.shown()
    marks = list(map(of.mark, of.rows))
    going = [column for column, cells in shown[1:] if all(cell == "-" for cell in cells)]
    going += sorted(
        (column for column, _ in shown if column.spare and column not in going),
        key=lambda column: column.spare,
    )
    while True:
        laid = _laid(out, shown, marks)
        if not going or laid.__rich_measure__(out, out.options).minimum <= out.width:
            break
        gone = going.pop(0)
        shown = [(column, cells) for column, cells in shown if column is not gone]
    for column, _ in shown:
        heading = column.heading.partition(", ")[0]
        legend.headings |= {heading, f"{of.name}.{heading}"}
    _print(out, laid)


def _laid(
    out: Console, shown: Sequence[tuple[Column, Sequence[Any]]], marks: Sequence[str]
) -> table.Table:
    """Return a table: its first column names the rows, and a course takes the room that is left."""
    laid = table.Table(
        box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="bold", show_edge=False
    )
    is_wide = any(column.spare for column, _ in shown)
    for place, (column, cells) in enumerate(shown):
        if column.format == "course":
            laid.add_column(column.heading, width=Course.least, ratio=1, no_wrap=True)
            laid.expand, laid.width = True, min(out.width, _WIDEST)
            continue
        longest = max(map(cell_len, [column.heading, *cells]))
        if not place:
            laid.add_column(f"  {column.heading}", min_width=min(longest + 2, 18 if is_wide else 12))
        elif column.left:
            laid.add_column(column.heading, min_width=min(longest, 12), overflow="fold")
        else:
            laid.add_column(column.heading, min_width=longest, justify="right", no_wrap=True)
    for sign, named, *others in zip(marks, *(cells for _, cells in shown), strict=True):
        first = table.Table.grid(
            table.Column(width=1), table.Column(overflow="fold"), padding=(0, 1, 0, 0)
        )
        first.add_row(sign, Text(named))
        laid.add_row(first, *others, style=_STYLES.get(sign, ""))
    return laid


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
