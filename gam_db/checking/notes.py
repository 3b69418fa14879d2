"""All notes on a source, those that must be fixed first; their texts are in ``notes.toml``."""

import json
import shlex
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from operator import itemgetter
from string import Formatter

from gam_db import data
from gam_db.checking.look import REGULAR_WITHIN, Look, Row, is_irregular, is_on_change
from gam_db.checking.program_notes import remarks
from gam_db.checking.proposal import BLOCKS, CYCLES, MOST_STILL, Proposal, room_of
from gam_db.checking.words import extent, instant, number_of, percent, reaching, spoken
from gam_db.clock import JUMP, SECOND, SINCE_1970, TimeKind, epoch_unit, is_of_our_time
from gam_db.columns import name_of
from gam_db.reading.ahead import ahead_sentences
from gam_db.reading.look import nowhere

PART = 0.1
"""Share of a machine's recording that a channel may lack at either end without a note."""
MANY_CONFLICTS = 0.1
"""Share of the instants above which different values are no accident."""
MANY_JUMPS = 3
"""Pauses of a counter up to which a long one is a jump; with more it comes in bursts."""
LONG_STILL = 0.2
"""Share of the samples that one value holds without a break, above which there is a note."""
FEW_VALUES = 10
"""Distinct values up to which a signal is a state rather than a measurement."""
EXACT_UP_TO = 2**53
"""Up to here each integer is a double."""
_LEAST_RISES = 50
_FALLS_OF_COUNTER = 0.01
_HOUR = 3_600 * SECOND

#: The text of each subject, with slots in braces.
SENTENCES: dict[str, str] = data.table("gam_db.checking", "notes.toml")


@dataclass(frozen=True)
class Note:
    """A note on a source, for users before they watch it."""

    subject: str  # one word, the same for the same finding: for programs
    must: bool  # it must be fixed, or there is no result, or a wrong one
    text: str  # the finding and what to do, in plain words
    #: (asset, channel) of those concerned; none where it concerns the source as a whole.
    channels: tuple[tuple[str, str], ...] = ()


#: What makes a word of a sentence of the channels concerned.
Worded = Callable[[Sequence[Row]], str | int]


def notes(look: Look, proposal: Proposal) -> list[Note]:
    """Return all notes on a source: those that must be fixed first, then in a fixed order."""
    source_notes = [*_on_times(look, proposal), *_on_amounts(look, proposal), *_on_values(look)]
    for subject, words, names in remarks(look):
        source_notes.append(Note(subject, False, SENTENCES[subject].format(**words), names))
    return sorted(source_notes, key=lambda note: not note.must)


def must_be_fixed(source_notes: Sequence[Note]) -> bool:
    """Tell whether a source cannot be used as it is."""
    return any(note.must for note in source_notes)


def _noted(
    subject: str, rows: Sequence[Row], must: bool = False, **words: str | int | Worded
) -> list[Note]:
    """Return the note on some channels, if any; a slot without a word shows the extent of its column."""
    if not rows:
        return []
    columns = {column for _, column, *_ in Formatter().parse(SENTENCES[subject]) if column}
    texts = {name: word(rows) if callable(word) else word for name, word in words.items()}
    texts |= {column: extent([row[column] for row in rows]) for column in columns - words.keys()}
    names = tuple((row["asset"], row["channel"]) for row in rows)
    return [Note(subject, must, SENTENCES[subject].format(**texts), names)]


def _whole(subject: str, must: bool = False, **words: str) -> list[Note]:
    return [Note(subject, must, SENTENCES[subject].format(**words))]


def _on_times(look: Look, proposal: Proposal) -> list[Note]:
    spaced = [row for row in look.channels if row["typical_step"] is not None]
    alike = [row for row in look.channels if row["samples"] == 1 and row["repeated"]]
    cut = [row for row in spaced if (gap := look.gap(row)) is not None and gap < row["typical_step"]]
    jumping = [
        row
        for row in spaced
        if look.kind.is_counter
        and 0 < row["pauses"] <= MANY_JUMPS
        and row["longest_pause"] > JUMP * row["typical_step"]
    ]
    on_change = [row for row in spaced if is_on_change(row)]
    irregular = [row for row in spaced if is_irregular(row) and not is_on_change(row)]

    def step(edge: Callable[[Iterable[int]], int], of: str) -> Worded:
        return lambda concerned: spoken(edge(row[of] for row in concerned), look.kind)

    def usual(concerned: Sequence[Row]) -> str:
        return reaching(*(str(step(edge, "typical_step")(concerned)) for edge in (min, max)))

    short, long = step(min, "short_step"), step(max, "long_step")
    return [
        *_noted("one_instant", alike, must=len(alike) == len(look.channels)),
        *_ahead(look),
        *_clock(look),
        *_noted("jump", jumping, usual=usual, longest_pause=step(max, "longest_pause")),
        *_repeated(look),
        *_noted("short_gap", cut, must=True, usual=usual),
        *_pauses(look, spaced, proposal, usual),
        *_noted("on_change", on_change, short=short, long=long),
        *_noted("irregular", irregular, short=short, long=long),
        *_rates(spaced, look.kind),
    ]


def _ahead(look: Look) -> list[Note]:
    """Rows that are later than now; where most channels are ahead alike, times are local."""
    sentences = ahead_sentences(look.ahead, len(look.channels), look.clock)
    names = tuple((row["asset"], row["channel"]) for row in look.ahead)
    return [
        Note(subject, subject == "local_times", sentence, names)
        for subject, sentence in zip(("ahead", "local_times"), sentences, strict=False)
    ]


def is_heeded(look: Look, row: Row) -> bool:
    """Tell whether max_gap separates the pauses of a channel from its steps."""
    gap = look.gap(row)
    return gap is not None and row["longest_step"] <= gap < row["shortest_pause"]


def _clock(look: Look) -> list[Note]:
    """A counter that counts from 1970, or a calendar that does not end up in our time."""
    if not look.channels:
        return []
    first = min(row["first_tick"] for row in look.channels)
    last = max(row["last_tick"] for row in look.channels)
    if look.kind.is_counter:
        if (unit := epoch_unit(first, last)) is None:
            return []
        units, ticks = SINCE_1970[unit]
        seen = instant(first * SECOND // ticks, TimeKind.TIMESTAMP)
        return _whole("epoch", units=units, first=seen, unit=unit)
    if is_of_our_time(first, last):
        return []
    return _whole("calendar", first=instant(first, look.kind), last=instant(last, look.kind))


def _repeated(look: Look) -> list[Note]:
    """Instants that are there more than once, with different values or with the same."""
    many, few, repeating = [], [], []
    for row in look.channels:
        if row["conflicts"] >= MANY_CONFLICTS * row["samples"]:
            many += [row] * bool(row["conflicts"])
            continue
        few += [row] * bool(row["conflicts"])
        repeating += [row] * (row["repeated"] > row["conflicts"] and row["samples"] > 1)

    def share(concerned: Sequence[Row]) -> str:
        return percent(
            sum(row["conflicts"] for row in concerned) / sum(row["samples"] for row in concerned)
        )

    def count(column: str) -> Worded:
        return lambda concerned: f"{sum(row[column] for row in concerned):,}"

    def autumn(concerned: Sequence[Row]) -> str:
        """An hour of repeated instants is what local time has when the clocks go back."""
        hours = [row["repeated"] * (row["typical_step"] or 0) / _HOUR for row in concerned]
        is_calendar = look.kind in (TimeKind.TIMESTAMP, TimeKind.NANOSECONDS)
        if is_calendar and all(
            1 <= round(hour) <= 12 and abs(hour - round(hour)) <= 0.02 for hour in hours
        ):
            sentence = "; about an hour of them, as local time has when clocks go back"
            return f"{sentence}: say --source-time-zone, or store UTC"
        return ""

    return [
        *_noted("conflicts", many, must=True, share=share),
        *_noted("few_conflicts", few, count=count("conflicts"), autumn=autumn),
        *_noted("repeated", repeating, count=count("repeated"), autumn=autumn),
    ]


def _pauses(look: Look, rows: Sequence[Row], proposal: Proposal, usual: Worded) -> list[Note]:
    paused = [row for row in rows if row["pauses"] and not is_irregular(row)]

    def count(pausing: Sequence[Row]) -> str:
        number = extent([row["pauses"] for row in pausing])
        return f"{number} pause{'s' * (number != '1')}{' each' * (len(pausing) > 1)}"

    def lengths(pausing: Sequence[Row]) -> str:
        shortest = min(row["shortest_pause"] for row in pausing)
        longest = max(row["longest_pause"] for row in pausing)
        more = "" if shortest == longest else f" to {spoken(longest, look.kind)}"
        return f"{spoken(shortest, look.kind)}{more}"

    if all(is_heeded(look, row) for row in paused):
        advice = ", and max_gap sees to it"
    elif proposal.max_gap is not None:
        advice = f"; take --max-gap {json.dumps(proposal.max_gap.value)}"
    else:
        advice = "; no one max_gap suits all, gam init writes one for each channel"
    return _noted("pauses", paused, count=count, lengths=lengths, usual=usual, advice=advice)


def _rates(rows: Sequence[Row], kind: TimeKind) -> list[Note]:
    """Several sampling steps in one table; those that hardly differ count as one."""
    alike: list[list[int]] = []
    for step in sorted(row["typical_step"] for row in rows):
        if not alike or step > REGULAR_WITHIN * alike[-1][0]:
            alike.append([])
        alike[-1].append(step)
    rates = [f"{spoken(steps[0], kind)} ({number_of(len(steps), 'channel')})" for steps in alike]
    return _whole("rates", rates=", ".join(rates)) if len(rates) > 1 else []


def _invalid(look: Look) -> list[Note]:
    """How many rows are missing by the condition on readings."""
    if (condition := look.source.valid_when) is None:
        return []
    rows = [row for row in look.channels if row["invalid"]]
    if not rows:
        return _whole("valid", condition=condition)
    return _noted("invalid", rows, share=_share_of("invalid", "readings"), condition=condition)


def _on_amounts(look: Look, proposal: Proposal) -> list[Note]:
    """Return notes on rows without names or time, on calibration, and on the window."""
    source_notes = []
    if any(look.nameless.values()):
        what, where, advice = nowhere(look.source, look.nameless, look.undated, look.engine)
        source_notes += _whole("nameless", True, found=what, where=shlex.quote(where), advice=advice)
    if look.undated is not None and look.undated.twice:
        zone, count = look.source.source_time_zone or "", f"{look.undated.twice:,}"
        source_notes += _whole("twice", zone=zone, count=count)
    source_notes += _invalid(look)
    if not look.channels:
        why = "; is the condition right?" * (look.source.where is not None)
        source_notes += _whole("nothing", True, why=why)
    held = [row for row in look.channels if row["lowest"] is not None]
    # What a channel lacks of calibration, its pool may have.
    alone = [] if look.method.calibration.pools else held
    without = [row for row in alone if row["calibration_lowest"] is None]
    brief = [
        row
        for row in alone
        if row["calibration_lowest"] is not None
        and row["lowest"] < row["highest"]
        and room_of(look, row) < look.setting(row).window
    ]
    short = [
        row
        for row in held
        if row["samples"] - max(row["calibration_samples"], look.setting(row).span)
        < look.setting(row).window
    ]
    open_parameters = look.method.requested  # what is proposed of an open window heeds cycles
    cycling = [
        row
        for row in look.channels
        if CYCLES * (row["cycle_length"] or 0) > look.setting(row).window
        and (open_parameters is None or "window" not in open_parameters.of(*name_of(row)).open_settings)
    ]
    longest = max((row["cycle_length"] for row in cycling), default=0)
    enough = max(proposal.window or 0, CYCLES * longest)
    fits = all(room_of(look, row) >= enough for row in cycling)
    return [
        *source_notes,
        *_partial(look),
        *_noted("no_calibration", without, must=len(without) == len(held)),
        *_noted("short_calibration", brief, blocks=BLOCKS),
        *_noted("short", short, must=len(short) == len(held)),
        *_noted("short_window" if fits else "few_cycles", cycling, cycles=CYCLES, enough=enough),
    ]


def _partial(look: Look) -> list[Note]:
    """Return notes on channels that lack a large part of the recording of their asset."""
    late: list[Row] = []
    early: list[Row] = []
    for _, of_asset in groupby(look.channels, key=itemgetter("asset")):
        rows = list(of_asset)
        begin, end = min(row["first_tick"] for row in rows), max(row["last_tick"] for row in rows)
        late += (row for row in rows if row["first_tick"] - begin > PART * (end - begin))
        early += (row for row in rows if end - row["last_tick"] > PART * (end - begin))

    def least(edge: str) -> Worded:
        return lambda concerned: instant(min(row[edge] for row in concerned), look.kind)

    return [
        *_noted("begins_late", late, first=least("first_tick")),
        *_noted("ends_early", early, last=least("last_tick")),
    ]


def _on_values(look: Look) -> list[Note]:
    """Missing ones, constants, long standstills, few levels, counters."""
    empty = [row for row in look.channels if row["lowest"] is None]
    held = [row for row in look.channels if row["lowest"] is not None]
    moving = [row for row in held if row["lowest"] < row["highest"]]
    constant = [row for row in held if row["lowest"] == row["highest"]]
    asleep = [
        row
        for row in moving
        if row["calibration_samples"]
        and row["calibration_lowest"] is not None
        and row["calibration_lowest"] == row["calibration_highest"]
    ]
    counters: list[Row] = []
    still: list[Row] = []
    for row in moving:
        if row["rises"] >= _LEAST_RISES and row["falls"] <= _FALLS_OF_COUNTER * row["rises"]:
            counters.append(row)
        elif row["longest_still"] >= LONG_STILL * row["samples"]:
            still.append(row)
    # Still samples that take much of calibration, where somebody set that they do.
    left_out = [
        row
        for row in moving
        if look.setting(row).still_after is not None
        and row["calibration_still"] >= MOST_STILL * max(row["calibration_samples"], 1)
    ]
    coarse = [
        row
        for row in moving
        if row["values_seen"] > FEW_VALUES and (_levels(row) or 2**31) < look.setting(row).grid
    ]
    value = getattr(look.source, "value", None)
    # Integers and decimals that are no doubles: neighbours become one.
    beyond = [
        row
        for row in held
        if (value or row["channel"]) in look.exact
        and max(abs(row["lowest"]), abs(row["highest"])) >= EXACT_UP_TO
    ]
    names = ", ".join(map(repr, look.number_texts))
    nowhere = len(empty) == len(look.channels)
    meaning = "; is it the right value column?" if nowhere else ": not assessable"
    return [
        *_noted("empty", empty, must=nowhere, meaning=meaning),
        *_noted(
            *("missing", [row for row in held if row["missing"]]),
            each=lambda concerned: " each" * (len(concerned) > 1),
            share=lambda concerned: (
                "at most " * (len(concerned) > 1)
                + percent(max(row["missing"] / row["samples"] for row in concerned))
            ),
        ),
        *_noted("constant", constant, must=not moving, all="" if moving else "; nothing to watch"),
        *_noted("constant_in_calibration", asleep),
        *_noted("still", still, share=_share_of("longest_still", "samples")),
        *_noted(
            *("still_after", left_out),
            share=_share_of("calibration_still", "calibration_samples"),
            longest=lambda concerned: f"{max(row['longest_run'] for row in concerned):,}",
        ),
        *_noted("counter", counters, resets=_resets),
        *_noted("states", [row for row in moving if row["values_seen"] <= FEW_VALUES]),
        *_noted(
            *("coarse", coarse),
            levels=lambda concerned: extent([_levels(row) or 0 for row in concerned]),
            least=lambda concerned: min(_levels(row) or 0 for row in concerned),
        ),
        *_noted("beyond", beyond),
        *(_whole("number_texts", names=names) if names else ()),
    ]


def _levels(row: Row) -> int | None:
    """How many levels the resolution of a channel leaves in its range; None if it has none."""
    if row["quantum"] is None:
        return None
    count = (row["highest"] - row["lowest"]) / row["quantum"] + 1.5
    return int(count) if count < 2**31 else None


def _share_of(part: str, all_of_it: str) -> Worded:
    """Which share a column is of another one, from the least to the greatest."""

    def worded(rows: Sequence[Row]) -> str:
        shares = [row[part] / row[all_of_it] for row in rows]
        least, most = percent(min(shares)), percent(max(shares))
        return least if least == most else f"{least.removesuffix(' %')} to {most}"

    return worded


def _resets(rows: Sequence[Row]) -> str:
    falls = extent([row["falls"] for row in rows])
    return f", but for {falls} fall{'s' * (falls != '1')} (resets)" if falls != "0" else ""
