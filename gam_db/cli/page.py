"""Sections that pages of several commands share: channels, remarks, problems of data, counts, advice.

How they look is up to :mod:`gam_db.cli.render`.
"""

import datetime as dt
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import pyarrow as pa

from gam_db.checking.words import number_of
from gam_db.cli.options import SHOWN
from gam_db.cli.render import WORDS, Notes, Section, Table, Title, time_text
from gam_db.clock import TimeKind, aware, shown_length
from gam_db.errors import printable
from gam_db.findings import SEES, Row, is_short

MARKS = {"proving": "!", "open": "!", "high": "!", "setup": "?", "waiting": "~"}

_NAMED = 5
"""Channels that a remark names."""


def channels(
    rows: Sequence[Row], time: str, spanned: str, zone: dt.tzinfo, everything: bool
) -> Iterator[Section]:
    """Yield a line per channel with the ``time`` of it, what their courses span, and their remarks."""
    name, differ = name_in(rows), len({row["bins"] for row in rows}) > 1
    unknown = dict.fromkeys(("floor", "hi", "trend", "course"))  # of channels that are not judged
    cells = [
        {**row, **(unknown if row["status"] == "not assessed" else {}), "name": name(row)}
        | {"several_bins": row["bins"] if differ else None, "newest": row[time]}
        for row in rows
    ]
    yield Table("channels", cells, marked, zone)
    timed = [row for row in rows if row["course_from"] is not None and row["last_time"] is not None]
    if timed:
        first, last = min(row["course_from"] for row in timed), max(row["last_time"] for row in timed)
        line = f"HI, 0 to 1: {spanned}, from {time_text(first, zone)} to {time_text(last, zone)}"
        if isinstance(first, dt.datetime):
            micros = (aware(last) - aware(first)) // dt.timedelta(microseconds=1)
            line += f" {zone}, {shown_length(micros, TimeKind.TIMESTAMP)}"
        yield line
    yield from remarks(((name(row), row["remarks"]) for row in rows), everything)


def marked(row: Row) -> str:
    """Return the mark of a channel, or of a machine, by its status."""
    mark = MARKS.get(row["status"], " ")
    if mark == " " and row.get("is_far_above"):
        return "^"
    return "?" if mark in " ~" and row.get("verdict") == "blind" else mark


def remarks(by_channel: Iterable[tuple[str, Iterable[str]]], everything: bool) -> Iterator[Section]:
    """Yield the remarks on channels, each remark once, with the channels that it is about.

    For several channels it only counts those with further remarks, unless everything is shown.
    """
    listed = [(name, list(words)) for name, words in by_channel]
    if not (everything or len(listed) == 1):  # of several channels, a line each is enough
        if more := sum(any(not remark.startswith(SEES) for remark in words) for _, words in listed):
            yield f"{number_of(more, 'channel')} with further remarks: --all"
        return
    by_remark: dict[str, list[str]] = {}
    for name, words in listed:
        for remark in words:
            by_remark.setdefault(remark, []).append(name)
    if by_remark:
        yield ""
        yield Notes(
            ("-", f"{some(names, of=len(listed))}: {remark}") for remark, names in by_remark.items()
        )


def problems(problem_table: pa.Table, everything: bool) -> Iterator[Section]:
    """Yield data problems (:meth:`gam_db.Monitor.data_problems`), each with what to do."""
    rows = problem_table.to_pylist()
    if not rows:
        return
    yield Title(f"data problems: {len(rows):,}")
    shown = rows if everything else rows[:SHOWN]
    yield Notes(("-", f"{row['sentence']}. {row['advice']}") for row in shown)
    kinds = Counter(row["kind"] for row in rows[SHOWN:])
    yield from cut(rows, everything, lambda _: ", ".join(f"{of:,} {kind}" for kind, of in kinds.items()))


def name_in(rows: Sequence[Mapping[str, Any]]) -> Callable[[Mapping[str, Any]], str]:
    """Return what names a channel among others: without its asset if all have the same."""
    is_same_asset = len({row["asset"] for row in rows}) <= 1
    return lambda row: printable(row["channel"] if is_same_asset else f"{row['asset']} {row['channel']}")


def amount(rows: Sequence[Row], what: str = "channel") -> str:
    """Return how many channels (or else) there are, and of how many assets."""
    return f"{number_of(len(rows), what)} of {number_of(len({row['asset'] for row in rows}), 'asset')}"


def cut(
    rows: Sequence[Any],
    everything: bool,
    words: Callable[[Sequence[Any]], str] = lambda _: "",
    most: int = SHOWN,
    what: str = "",
) -> Iterator[str]:
    """Yield how many rows a table leaves out, if any, with a tally of them."""
    if not everything and len(rows) > most:
        tally = words(rows[most:])
        yield f"and {len(rows) - most:,} more{what}{f' ({tally})' if tally else ''}; --all"


def _tally(rows: Iterable[Row], of: str) -> str:
    """Return how many rows have which value of a column, in the order of the table of words."""
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
    return [f"would not see, of {number_of(len(rows), 'channel')}: {words}"] if words else []


def advice(supports: Sequence[Row]) -> list[str]:
    """Return what to do about calibrations that are not good enough, a line each."""
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


def some(names: Sequence[str], most: int = _NAMED, of: int = 1) -> str:
    """Return the first names of a list, and how many more there are; a word if it is all ``of`` many."""
    if len(names) == of > 1:
        return "all channels"
    return ", ".join(names[:most]) + (f" and {len(names) - most} more" if len(names) > most else "")
