"""Notes on time: the clock, repeated instants, pauses, irregular sampling."""

import json
from collections.abc import Callable, Iterable, Sequence
from functools import partial
from itertools import filterfalse

from gam_db.checking.look import Look, Row
from gam_db.checking.note import Note, noted, whole
from gam_db.checking.proposal import Proposal
from gam_db.checking.sampling import REGULAR_WITHIN, is_irregular, is_on_change
from gam_db.checking.words import extent, instant, number_of, percent, reaching, spoken
from gam_db.clock import SECOND, SINCE_1970, TimeKind, epoch_unit, is_of_our_time

MANY_CONFLICTS = 0.1
"""Share of the instants above which different values are no accident."""
_HOUR = 3_600 * SECOND


def times(look: Look, proposal: Proposal) -> list[Note]:
    """Return the notes on time."""
    spaced = [row for row in look.channels if row["typical_step"] is not None]
    alike = [row for row in look.channels if row["samples"] == 1 and row["repeated"]]
    cut = [row for row in spaced if (gap := look.gap(row)) is not None and gap < row["typical_step"]]
    return [
        *noted("one_instant", alike, must=len(alike) == len(look.channels)),
        *_clock(look),
        *_repeated(look),
        *noted("short_gap", cut, must=True, usual=partial(_usual_step, look.kind)),
        *_pauses(look, spaced, proposal),
        *_irregular(spaced, look.kind),
        *_rates(spaced, look.kind),
    ]


def is_heeded(look: Look, row: Row) -> bool:
    """Tell whether max_gap tells the pauses of a channel from its steps."""
    gap = look.gap(row)
    return gap is not None and row["longest_step"] <= gap < row["shortest_pause"]


def _clock(look: Look) -> list[Note]:
    """A counter that counts from 1970, or a calendar that does not end up in our time."""
    if not look.channels:
        return []
    first = min(row["first_tick"] for row in look.channels)
    last = max(row["last_tick"] for row in look.channels)
    if look.kind.is_counter:
        unit = epoch_unit(first, last)
        if unit is None:
            return []
        units, ticks = SINCE_1970[unit]
        seen = instant(first * SECOND // ticks, TimeKind.TIMESTAMP)
        return whole("epoch", units=units, first=seen, unit=unit)
    if is_of_our_time(first, last):
        return []
    return whole("calendar", first=instant(first, look.kind), last=instant(last, look.kind))


def _repeated(look: Look) -> list[Note]:
    """Instants that are there more than once, with different values or with the same."""
    many = [row for row in look.channels if row["conflicts"] and _has_many_conflicts(row)]
    others = [row for row in look.channels if not _has_many_conflicts(row)]
    few = [row for row in others if row["conflicts"]]
    repeating = [row for row in others if row["repeated"] > row["conflicts"] and row["samples"] > 1]

    def share(found: Sequence[Row]) -> str:
        return percent(sum(row["conflicts"] for row in found) / sum(row["samples"] for row in found))

    def count(column: str) -> Callable[[Sequence[Row]], str]:
        return lambda found: f"{sum(row[column] for row in found):,}"

    autumn = partial(_autumn, look.kind)
    return [
        *noted("conflicts", many, must=True, share=share),
        *noted("few_conflicts", few, count=count("conflicts"), autumn=autumn),
        *noted("repeated", repeating, count=count("repeated"), autumn=autumn),
    ]


def _has_many_conflicts(row: Row) -> bool:
    return bool(row["conflicts"] >= MANY_CONFLICTS * row["samples"])


def _autumn(kind: TimeKind, rows: Sequence[Row]) -> str:
    """An hour of repeated instants is what local time has when the clocks go back."""
    if kind not in (TimeKind.TIMESTAMP, TimeKind.NANOSECONDS):
        return ""
    for row in rows:
        hours = row["repeated"] * (row["typical_step"] or 0) / _HOUR
        if not (1 <= round(hours) <= 12 and abs(hours - round(hours)) <= 0.02):
            return ""
    return "; about an hour of them, as local time has when clocks go back: store UTC"


def _pauses(look: Look, rows: Sequence[Row], proposal: Proposal) -> list[Note]:
    found = [row for row in rows if row["pauses"] and not is_irregular(row)]

    def count(pausing: Sequence[Row]) -> str:
        said = extent([row["pauses"] for row in pausing])
        return f"{said} pause{'s' * (said != '1')}{' each' * (len(pausing) > 1)}"

    def lengths(pausing: Sequence[Row]) -> str:
        shortest = min(row["shortest_pause"] for row in pausing)
        longest = max(row["longest_pause"] for row in pausing)
        more = "" if shortest == longest else f" to {spoken(longest, look.kind)}"
        return f"{spoken(shortest, look.kind)}{more}"

    if all(is_heeded(look, row) for row in found):
        advice = ", and max_gap sees to it"
    elif proposal.max_gap is not None:
        advice = f"; take --max-gap {json.dumps(proposal.max_gap.value)}"
    else:
        advice = "; no one max_gap suits all, gam init writes one for each channel"
    usual = partial(_usual_step, look.kind)
    return noted("pauses", found, count=count, lengths=lengths, usual=usual, advice=advice)


def _irregular(rows: Sequence[Row], kind: TimeKind) -> list[Note]:
    def step(edge: Callable[[Iterable[int]], int], of: str) -> Callable[[Sequence[Row]], str]:
        return lambda found: spoken(edge(row[of] for row in found), kind)

    short, long = step(min, "short_step"), step(max, "long_step")
    irregular = [row for row in rows if is_irregular(row)]
    return [
        *noted("on_change", list(filter(is_on_change, irregular)), short=short, long=long),
        *noted("irregular", list(filterfalse(is_on_change, irregular)), short=short, long=long),
    ]


def _rates(rows: Sequence[Row], kind: TimeKind) -> list[Note]:
    """Several sampling steps in one table; those that hardly differ count as one."""
    alike: list[list[int]] = []
    for step in sorted(row["typical_step"] for row in rows):
        if not alike or step > REGULAR_WITHIN * alike[-1][0]:
            alike.append([])
        alike[-1].append(step)
    if len(alike) < 2:
        return []
    said = (f"{spoken(steps[0], kind)} ({number_of(len(steps), 'channel')})" for steps in alike)
    return whole("rates", rates=", ".join(said))


def _usual_step(kind: TimeKind, rows: Sequence[Row]) -> str:
    steps = [row["typical_step"] for row in rows]
    return reaching(spoken(min(steps), kind), spoken(max(steps), kind))
