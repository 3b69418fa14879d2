"""Notes on time: the clock, repeated instants, pauses, irregular sampling."""

from collections.abc import Sequence

from gam_db.checking.look import Look, Row
from gam_db.checking.note import Note, noted
from gam_db.checking.proposal import Proposal
from gam_db.checking.sampling import REGULAR_WITHIN, is_irregular, is_on_change
from gam_db.checking.words import extent, instant, number_of, percent, spoken
from gam_db.clock import SECOND, SINCE_1970, TimeKind, epoch_unit, is_of_our_time

MANY_CONFLICTS = 0.1
"""Share of the instants above which different values are no accident."""
_HOUR = 3_600 * SECOND


def times(look: Look, proposal: Proposal) -> list[Note]:
    """Return the notes on time."""
    spaced = [row for row in look.channels if row["typical_step"] is not None]
    return [
        *_one_instant(look.channels),
        *_clock(look),
        *_conflicts(look),
        *_repeated(look),
        *_short_gap(look, spaced),
        *_pauses(look, spaced, proposal),
        *_irregular(spaced, look.kind),
        *_rates(spaced, look.kind),
    ]


def is_heeded(look: Look, row: Row) -> bool:
    """Tell whether max_gap tells the pauses of a channel from its steps."""
    gap = look.gap(row)
    return gap is not None and row["longest_step"] <= gap < row["shortest_pause"]


def _one_instant(rows: Sequence[Row]) -> list[Note]:
    alike = [row for row in rows if row["samples"] == 1 and row["repeated"]]
    return noted(
        "one_instant",
        alike,
        lambda found: (
            "all rows have the same time; name the column that tells when each reading was taken "
            "(--time COLUMN)"
        ),
        must=len(alike) == len(rows),
    )


def _clock(look: Look) -> list[Note]:
    """A counter that counts from 1970, or a calendar that does not end up in our time."""
    if not look.channels:
        return []
    first = min(row["first_tick"] for row in look.channels)
    last = max(row["last_tick"] for row in look.channels)
    if look.kind.is_counter:
        unit = epoch_unit(first, last)
        if unit is not None:
            name, ticks = SINCE_1970[unit]
            seen = instant(first * SECOND // ticks, TimeKind.TIMESTAMP)
            return [
                Note(
                    "epoch",
                    False,
                    f"time looks like {name} since 1970 (from {seen}), but is an integer, so it is "
                    f"taken as a counter and lengths are in {name}; --time-unit {unit} makes calendar "
                    "time of it",
                )
            ]
        return []
    if is_of_our_time(first, last):
        return []
    return [
        Note(
            "calendar",
            False,
            f"time runs from {instant(first, look.kind)} to {instant(last, look.kind)}: damaged "
            "timestamps (leave them out by where=), or a wrong unit when they were made",
        )
    ]


def _conflicts(look: Look) -> list[Note]:
    rows = [row for row in look.channels if row["conflicts"]]
    many = [row for row in rows if _has_many_conflicts(row)]
    few = [row for row in rows if not _has_many_conflicts(row)]
    return [
        *noted(
            "conflicts",
            many,
            lambda found: (
                f"{_share(found, 'conflicts')} of the instants have different values: several signals "
                "or machines under one name? Name the column that tells them apart (--channel, "
                "--asset), or a finer clock (--time)"
            ),
            must=True,
        ),
        *noted(
            "few_conflicts",
            few,
            lambda found: (
                f"{_counts(found, 'conflicts')} instants have different values; the smallest is taken"
                + _autumn(look, found)
            ),
        ),
    ]


def _has_many_conflicts(row: Row) -> bool:
    return bool(row["conflicts"] >= MANY_CONFLICTS * row["samples"])


def _repeated(look: Look) -> list[Note]:
    repeating = [
        row
        for row in look.channels
        if row["repeated"] > row["conflicts"] and row["samples"] > 1 and not _has_many_conflicts(row)
    ]
    return noted(
        "repeated",
        repeating,
        lambda found: (
            f"{_counts(found, 'repeated')} rows repeat an instant that is there already; they count once"
            + _autumn(look, found)
        ),
    )


def _autumn(look: Look, rows: Sequence[Row]) -> str:
    """An hour of repeated instants is what local time has when the clocks go back."""
    if look.kind not in (TimeKind.TIMESTAMP, TimeKind.NANOSECONDS):
        return ""
    for row in rows:
        hours = row["repeated"] * (row["typical_step"] or 0) / _HOUR
        if not (1 <= round(hours) <= 12 and abs(hours - round(hours)) <= 0.02):
            return ""
    return "; about an hour of them, as local time has when clocks go back: store UTC"


def _short_gap(look: Look, rows: Sequence[Row]) -> list[Note]:
    found = [row for row in rows if (gap := look.gap(row)) is not None and gap < row["typical_step"]]
    return noted(
        "short_gap",
        found,
        lambda short: (
            "max_gap is shorter than the usual step of "
            f"{_lengths(short, 'typical_step', look.kind)}: every sample would be a segment of its own, "
            "and no vector would be whole; take a longer one"
        ),
        must=True,
    )


def _pauses(look: Look, rows: Sequence[Row], proposal: Proposal) -> list[Note]:
    kind = look.kind
    found = [row for row in rows if row["pauses"] and not is_irregular(row)]

    def text(pausing: Sequence[Row]) -> str:
        shortest, longest = (
            choose(row[length] for row in pausing)
            for choose, length in ((min, "shortest_pause"), (max, "longest_pause"))
        )
        lengths = (
            f"of {spoken(shortest, kind)}"
            if shortest == longest
            else f"of {spoken(shortest, kind)} to {spoken(longest, kind)}"
        )
        count = extent([row["pauses"] for row in pausing])
        said = f"{count} pause{'s' * (count != '1')} {_each(pausing)}{lengths}"
        said += f" (usual step {_lengths(pausing, 'typical_step', kind)}): no vector should span one"
        if all(is_heeded(look, row) for row in pausing):
            return f"{said}, and max_gap sees to it"
        if proposal.max_gap is not None:
            return f"{said}; take --max-gap {_quoted(proposal.max_gap.value)}"
        return f"{said}; no one max_gap suits all, gam init writes one for each channel"

    return noted("pauses", found, text)


def _irregular(rows: Sequence[Row], kind: TimeKind) -> list[Note]:
    irregular = [row for row in rows if is_irregular(row)]

    def steps(found: Sequence[Row]) -> str:
        short, long = (min(row["short_step"] for row in found), max(row["long_step"] for row in found))
        return f"steps from {spoken(short, kind)} to {spoken(long, kind)}"

    return [
        *noted(
            "on_change",
            [row for row in irregular if is_on_change(row)],
            lambda found: (
                f"irregular {steps(found)} and hardly two equal values in a row: written on change "
                "only (a deadband)? The method counts delays in samples, so resample to a fixed step, "
                "with the last value carried on, in a view"
            ),
        ),
        *noted(
            "irregular",
            [row for row in irregular if not is_on_change(row)],
            lambda found: (
                f"irregular {steps(found)}: delays are counted in samples, so resample to a fixed step "
                "in a view, or read the result with care"
            ),
        ),
    ]


def _rates(rows: Sequence[Row], kind: TimeKind) -> list[Note]:
    """Several sampling steps in one table; those that hardly differ count as one."""
    steps = sorted(row["typical_step"] for row in rows)
    starts: list[int] = []
    for step in steps:
        if not starts or step > REGULAR_WITHIN * starts[-1]:
            starts.append(step)
    if len(starts) < 2:
        return []
    rates = ", ".join(
        f"{spoken(start, kind)} ({number_of(_between(steps, start), 'channel')})" for start in starts
    )
    return [
        Note(
            "rates",
            False,
            f"sampling steps differ: {rates}; delays and windows are counted in samples of each "
            "channel, so tau and window may need an [[override]]",
        )
    ]


def _between(steps: Sequence[int], start: int) -> int:
    return sum(start <= step <= REGULAR_WITHIN * start for step in steps)


def _each(rows: Sequence[Row]) -> str:
    return "each " if len(rows) > 1 else ""


def _counts(rows: Sequence[Row], column: str) -> str:
    return f"{sum(row[column] for row in rows):,}"


def _share(rows: Sequence[Row], column: str) -> str:
    return percent(sum(row[column] for row in rows) / sum(row["samples"] for row in rows))


def _lengths(rows: Sequence[Row], column: str, kind: TimeKind) -> str:
    least, most = min(row[column] for row in rows), max(row[column] for row in rows)
    shown = spoken(least, kind)
    return shown if spoken(most, kind) == shown else f"{shown} to {spoken(most, kind)}"


def _quoted(value: int | str) -> str:
    return f'"{value}"' if isinstance(value, str) else f"{value}"
