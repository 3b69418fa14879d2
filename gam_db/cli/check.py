"""``gam check``: sampling and problems of a source, and whether a state agrees with its source."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from typing import Any

from gam_db.checking import Look, Note, Proposal, look_at, must_be_fixed, notes, propose
from gam_db.checking.look import is_irregular
from gam_db.checking.notes import is_heeded
from gam_db.checking.program_notes import totals
from gam_db.checking.words import instant, number_of, percent, spoken
from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.job import Job, reading, watched
from gam_db.cli.options import option
from gam_db.cli.progress import working
from gam_db.cli.render import WORDS, Notes, Page, Section, Table, show
from gam_db.clock import TimeKind, shown_instant
from gam_db.columns import name_of
from gam_db.engines.session import Session
from gam_db.errors import EngineError, printable
from gam_db.findings import Row
from gam_db.stored.checking.proving import keep
from gam_db.stored.state import State, kind_of
from gam_db.study.running import Listener

#: Parts of a state that follow from the source, whose rows are counted.
_MENDED = ("scored", "calibration")


@options.taking(*options.READ, *options.STATE, *options.PAGE, "threads")
def check(
    settings: Settings,
    common: options.Common,
    relation: str | tuple[str, ...] | None,
    state: bool = option("check.state", False),
) -> None:
    """Check a source: its sampling, problems and suggested settings.

    It shows per channel: sampling, pauses, missing, repeated and conflicting readings, range, distinct
    values, standstills, cycle. With --program it also shows what each machine ran and how much of it
    calibration holds; without it, a column that looks like a program. Exit code 2 means that something
    must be fixed: rows without name or time, conflicts everywhere, one time for all rows, no signal that
    moves, or too few samples for a window on every channel. It writes nothing.
    """
    if state:
        _check_state(settings, relation, common)
        return
    with reading(settings, common) as (session, job, on_step):
        seen = looked(session, job, on_step)
    show(Page(_figures(seen), _sections(seen, common), must_be_fixed(seen.notes)), common)


@dataclass(frozen=True)
class Seen:
    """A source after a look: the job, the look, notes on it and proposals."""

    job: Job
    look: Look
    notes: list[Note]
    proposal: Proposal


def looked(session: Session, job: Job, on_step: Listener) -> Seen:
    """Look at a source as its settings mean it."""
    look = look_at(session, job.guess.source, job.parameters, job.calibration, on_step)
    proposal = propose(look)
    return Seen(job, look, notes(look, proposal), proposal)


def _figures(seen: Seen) -> Row:
    """Return what --json prints; lengths in microseconds or counter steps."""
    look, proposal = seen.look, seen.proposal
    gap, still = (suggestion and suggestion.value for suggestion in (proposal.max_gap, proposal.still))
    return {
        **seen.job.figures(),
        "time": "counter" if look.kind.is_counter else "timestamp",
        "channels": [
            {name: value for name, value in row.items() if name != "settings_no"}
            for row in look.channels
        ],
        "rows_without": look.nameless,
        "programs": look.programs,
        "program_columns": [asdict(candidate) for candidate in look.candidates],
        "notes": [
            {
                "subject": note.subject,
                "must_be_fixed": note.must,
                "text": note.text,
                "channels": note.channels,
            }
            for note in seen.notes
        ],
        "proposal": {
            "max_gap": gap,
            "max_gap_by_channel": {name: suggestion.value for name, suggestion in proposal.gaps.items()},
            "window": proposal.window,
            "window_by_channel": {
                name: suggestion.value for name, suggestion in proposal.windows.items()
            },
            "still_after": still,
            "still_after_by_channel": {
                name: suggestion.value for name, suggestion in proposal.stills.items()
            },
        },
    }


def _sections(seen: Seen, common: options.Common) -> Iterator[Section]:
    job, look = seen.job, seen.look
    yield heading(seen) + job.settings
    yield from job.lines()
    noted = {name for note in seen.notes for name in note.channels}
    urgent = {name for note in seen.notes for name in note.channels if note.must}

    def mark(row: Row) -> str:
        return "!" if name_of(row) in urgent else "?" if name_of(row) in noted else " "

    yield ""
    yield Notes(("!" if note.must else "-", note_line(note, look)) for note in seen.notes)
    yield from _ending(seen)
    if look.programs:
        of = totals(look)
        yield ""
        yield f"programs ({look.source.program}): {len(of):,}"
        yield from (f"  {total.line(look.kind.is_counter)}" for total in common.of(of))
        yield from page.cut(of, common.everything, what=" programs")
    yield ""
    rows = sorted(look.channels, key=lambda row: mark(row) != "!")
    name = page.name_in(rows)
    shown = [
        {**row, "name": name(row), "step": _step(row, look), "still": _still(row)}
        | {of: row[of] or None for of in ("pauses", "cycle_length")}
        | {"missing_share": row["missing"] / row["samples"] if row["missing"] else None}
        for row in common.of(rows)
    ]
    yield Table("check", shown, mark)
    yield from page.cut(rows, common.everything)


def heading(seen: Seen) -> str:
    """Return the source in a line: how much of it there is, and from when to when."""
    look = seen.look
    samples = number_of(sum(row["samples"] for row in look.channels), "sample")
    line = f"{printable(seen.job.name)}: {page.amount(look.channels)}, {samples}"
    if look.channels:
        first = instant(min(row["first_tick"] for row in look.channels), look.kind)
        last = instant(max(row["last_tick"] for row in look.channels), look.kind)
        line += f", time from {first} to {last}"
    return line


def note_line(note: Note, look: Look) -> str:
    """Return a note as a line, with the channels it concerns, if not all of them."""
    if not note.channels:
        return note.text
    name = page.name_in(look.channels)
    names = [name({"asset": asset, "channel": channel}) for asset, channel in note.channels]
    return f"{page.some(names, of=len(look.channels))}: {note.text}"


def _step(row: Any, look: Look) -> str | None:
    """Return the usual step in time, and how far nine tenths of the steps are from it at most."""
    if row["typical_step"] is None:
        return None
    step = spoken(row["typical_step"], look.kind)
    if is_irregular(row):
        return f"~{step}"
    within = min(row["long_step"], row["longest_step"])
    jitter = max(within - row["typical_step"], row["typical_step"] - row["short_step"])
    return f"{step} ±{percent(jitter / row['typical_step'])}" if jitter else step


def _still(row: Any) -> str | None:
    share = row["longest_still"] / row["samples"]
    return None if row["longest_still"] <= 1 else percent(share) if share >= 0.01 else "<1 %"


def _ending(seen: Seen) -> list[str]:
    proposal, look = seen.proposal, seen.look
    must = sum(note.must for note in seen.notes)
    points = f"{number_of(must, 'point')} marked ! must be fixed before gam can learn"
    lines = [points] if must else []
    if not look.channels:
        return lines
    parameters = look.method.parameters
    to_set = []
    pauses = any(
        row["pauses"] and not (is_heeded(look, row) or is_irregular(row)) for row in look.channels
    )
    if pauses and proposal.max_gap is not None:
        to_set.append(f"max_gap = {json.dumps(proposal.max_gap.value)}")
    elif pauses and proposal.gaps:
        to_set.append(f"max_gap of {number_of(len(proposal.gaps), 'channel')}")
    if parameters.still_after is None and proposal.still is not None:
        to_set.append(f"still_after = {proposal.still.value} ({proposal.still.reason})")
    elif parameters.still_after is None and proposal.stills:
        to_set.append(f"still_after of {number_of(len(proposal.stills), 'channel')}")
    if proposal.window is None:
        lines.append(f"no window: {proposal.window_reason}")
    elif proposal.window != parameters.window:
        to_set.append(f"window = {proposal.window} ({proposal.window_reason})")
    if proposal.windows:
        to_set.append(f"a shorter window of {number_of(len(proposal.windows), 'channel')}")
    lines += [] if must else ["nothing must be fixed"]
    return lines + (
        [f"suggested settings: {'; '.join(to_set)} (gam init writes them)"] if to_set else []
    )


def _check_state(
    settings: Settings, relation: str | tuple[str, ...] | None, common: options.Common
) -> None:
    """Compare the state of a monitor with its source, or another relation, and print what differs."""
    name = settings.monitor.name
    session = options.opened(settings, common.threads, writable=False)
    with working(session, common.quiet) as on_step:
        monitor, monitor_row = watched(session, settings, relation)
        comparison = monitor.checked_state(on_step=on_step)
    # Only now, and shortly: a DuckDB file that is open for writing is open for nobody else.
    unkept = None
    try:
        with options.opened(settings, common.threads) as session:
            state = State(session, settings.monitor.tables)
            keep(state, state.monitor(name)["monitor_id"], comparison.proof)
    except EngineError as error:
        unkept = error.options
    kind, proof = kind_of(monitor_row), comparison.proof
    rows = [_with_times(row, kind, "since") for row in comparison.differences.to_pylist()]
    apart = [_with_times(row, kind, "since", "until") for row in comparison.uncompared.to_pylist()]
    sinces = [since for since in comparison.differences["since"].to_pylist() if since is not None]

    def sections() -> Iterator[str]:
        others = {(row["asset"], row["channel"]) for row in rows if row["asset"] is not None}
        texts = WORDS["check"]
        sentence = texts["differs" if rows else "in_part" if apart else "same"]
        yield sentence.format(name=name, proof=proof, others=len(others))
        yield from (f"  {_line(row)}" for row in common.of(rows))
        yield from page.cut(rows, common.everything)
        if sinces:
            yield f"gam score --from {shown_instant(min(sinces), kind)} scores them again"
        if any(row["part"] == "calibration" for row in rows):
            yield "gam calibrate --again makes new versions from the calibration as it is now"
        parts = {row["part"] for row in rows if row["since"] is None}
        if "source" in parts:
            yield texts["unseen"]
        if not parts <= {"source", *_MENDED}:
            yield texts["damaged"]
        yield from (f"  {_left(row)}" for row in common.of(apart))
        yield from page.cut(apart, common.everything)
        yield texts["held"]
        if unkept is not None:
            yield f"the time of this check could not be recorded: {unkept}"

    figures = {
        "monitor": name,
        "checked_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP),
        "recorded": unkept is None,
        **{name: getattr(proof, name) for name in ("channels", "versions", "buckets")},
        "differences": rows,
        "uncompared": apart,
    }
    show(Page(figures, sections(), urgent=bool(rows)), common)


def _line(row: Row) -> str:
    """Return a difference as a line."""
    named = printable(f"{row['asset']} {row['channel']}")
    since = "" if row["since"] is None else f", from {row['since']} on"
    if row["part"] not in _MENDED:
        difference = f"{row['part']}: {row['what']} ({row['differing']:,}){since}"
        return difference if row["asset"] is None else f"{named}: version {row['version']}: {difference}"
    counted = f"{row['samples_then']:,} then, {row['samples_now']:,} now"
    if row["part"] == "calibration":
        others = "" if row["what"] is None else f"; differing: {row['what']}"
        return f"{named}: calibration: rows {counted}{others}"
    return f"{named}: {row['what']}; samples in them {counted}{since}"


def _left(row: Row) -> str:
    """Return a part that is not compared as a line."""
    named = printable(f"{row['asset']} {row['channel']}")
    sentence = WORDS["check"][row["why"].replace(" ", "_")]
    edge = row["until"] if row["since"] is None else row["since"]
    return f"{named}: {row['part']}: {sentence.format(edge=edge or 'now')}"


def _with_times(row: Row, kind: TimeKind, *times: str) -> Row:
    """Return a row with its times as text."""
    shown = {name: None if row[name] is None else shown_instant(row[name], kind) for name in times}
    return row | shown
