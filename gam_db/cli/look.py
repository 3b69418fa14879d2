"""``gam check`` and ``gam init``: what a source is like, what must be fixed, and a gam.toml for it.

This module owns the commands and their page; :mod:`gam_db.checking` looks, judges and proposes.
"""

import dataclasses
import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer
from rich.console import Console

from gam_db.address import shown
from gam_db.checking import Look, Note, Proposal, look_at, must_be_fixed, notes, propose
from gam_db.checking.sampling import is_irregular
from gam_db.checking.times import is_heeded
from gam_db.checking.words import instant, number_of, percent, spoken
from gam_db.cli import options, page, toml_text
from gam_db.cli.chosen import chosen, groups, save
from gam_db.cli.exits import Exit
from gam_db.cli.job import Job, job_of
from gam_db.cli.progress import working
from gam_db.cli.state import check_state
from gam_db.config import DEFAULT_FILE, Settings
from gam_db.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, printable
from gam_db.guess import SourceSettings
from gam_db.parameters import Parameters
from gam_db.selection import Search
from gam_db.setting import settings_of
from gam_db.source import Source, is_file, paths_of, slashed


@options.taking(*options.READ, *options.STATE)
def check(
    settings: Settings,
    relation: str | tuple[str, ...] | None,
    state: Annotated[
        bool,
        typer.Option(
            "--state",
            help="Instead, compare all that is stored with the source, and with itself: rows that came "
            "too late, were corrected or went, and what was damaged in the tables. Reads all of it, and "
            "records that it did; ends with 2 if anything differs. --name, --schema and --prefix say "
            "where it lies.",
        ),
    ] = False,
    everything: options.All = False,
    as_json: options.Json = False,
    quiet: options.Quiet = False,
    threads: options.Threads = None,
) -> None:
    """Look at SOURCE before anything is learnt of it: what it is like, what to fix, what to set.

    Per channel: sampling, pauses, missing, repeated and conflicting readings, range, distinct values,
    standstills, cycle. Ends with 2 if something must be fixed: rows without name or time, conflicts
    everywhere, one time for all rows, nothing that moves, too few samples for a window on any channel.
    Nothing is written.
    """
    if state:
        check_state(settings, relation, threads, everything, as_json, quiet)
        return
    named = options.named_relation(settings)
    session = connect(settings.source.database, threads, writable=False)
    with working(session, quiet) as on_step:
        seen = looked(session, named, settings, on_step)
    code = Exit.ATTENTION if must_be_fixed(seen.notes) else Exit.FINE
    page.tell(code, _figures(seen), lambda out: _show(out, seen, everything), as_json, quiet)


@dataclass(frozen=True)
class Seen:
    """A source, looked at: what was asked, what was seen, what is said of it and what to set."""

    job: Job
    look: Look
    notes: list[Note]
    proposal: Proposal


def looked(session: Session, relation: Any, settings: Settings, on_step: Callable[[str], None]) -> Seen:
    """Look at a source as its settings mean it.

    Raises:
        UserError: the source, a parameter or the calibration cannot be used at all.
    """
    job = job_of(session, settings, relation)
    look = look_at(session, job.guess.source, job.parameters, job.calibration, on_step)
    proposal = propose(look)
    return Seen(job, look, notes(look, proposal), proposal)


def _figures(seen: Seen) -> dict[str, Any]:
    """Return what --json prints; lengths in microseconds or counter steps."""
    look, proposal = seen.look, seen.proposal
    return {
        **seen.job.figures(),
        "time": "counter" if look.kind.is_counter else "timestamp",
        "channels": [
            {name: value for name, value in row.items() if name != "settings_no"}
            for row in look.channels
        ],
        "rows_without": look.nameless,
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
            "max_gap": None if proposal.max_gap is None else proposal.max_gap.value,
            "max_gap_by_channel": {name: gap.value for name, gap in proposal.gaps.items()},
            "window": proposal.window,
            "still_after": None if proposal.still is None else proposal.still.value,
            "still_after_by_channel": {name: one.value for name, one in proposal.stills.items()},
        },
    }


def _show(out: Console, seen: Seen, everything: bool) -> None:
    job, look = seen.job, seen.look
    for line in (heading(seen) + job.settings, *job.lines()):
        page.say(out, line)
    marks: dict[tuple[str, str], str] = {}
    for note in seen.notes:
        for name in note.channels:
            marks[name] = "!" if note.must else marks.get(name, "?")
    out.print()
    page.notes(out, (("!" if note.must else "-", note_line(note, look)) for note in seen.notes))
    for line in _ending(seen):
        page.say(out, line)
    rows = sorted(look.channels, key=lambda row: marks.get(_key(row)) != "!")
    out.print()
    if rows:
        shown = rows if everything else rows[: options.SHOWN]
        columns = {"channel": page.names_of(shown), **_columns(shown, look)}
        empty = [heading for heading, cells in columns.items() if set(cells) == {"-"}]
        spare = (*empty, *(name for name in _LEAST_SAYING if name not in empty))
        page.table(out, columns, [marks.get(_key(row), " ") for row in shown], spare=spare)
    page.cut(out, rows, everything)
    if rows:
        page.say(
            out,
            "step: usual step in time and its jitter (~ irregular). pauses: steps beyond five usual "
            "ones. values: distinct ones among at most 20,480 samples. still: longest stretch of one "
            "value. cycle: in samples, where the signal repeats itself.",
        )


def heading(seen: Seen) -> str:
    """Return the source in a line: how much of it there is, and from when to when."""
    look = seen.look
    assets = number_of(len({row["asset"] for row in look.channels}), "asset")
    channels = number_of(len(look.channels), "channel")
    samples = number_of(sum(row["samples"] for row in look.channels), "sample")
    line = f"{printable(seen.job.name)}: {channels} of {assets}, {samples}"
    if look.channels:
        first = instant(min(row["first_tick"] for row in look.channels), look.kind)
        last = instant(max(row["last_tick"] for row in look.channels), look.kind)
        line += f", time from {first} to {last}"
    return line


def note_line(note: Note, look: Look) -> str:
    """Return a note as a line, with the channels it concerns, if not all of them."""
    one_asset, channels = len({row["asset"] for row in look.channels}) <= 1, len(look.channels)
    names = [
        printable(channel if one_asset else f"{asset} {channel}") for asset, channel in note.channels
    ]
    if not names:
        return note.text
    return f"{page.some(names, of=channels)}: {note.text}"


#: The first columns to go where the terminal is narrow.
_LEAST_SAYING = ("values", "still", "most", "least")


def _key(row: Any) -> tuple[str, str]:
    return (row["asset"], row["channel"])


def _columns(rows: Sequence[Any], look: Look) -> dict[str, list[str]]:
    """Return what the table says of channels, by its headings."""

    def cells(of: Callable[[Any], str | None]) -> list[str]:
        return [of(row) or "-" for row in rows]

    return {
        "samples": cells(lambda row: f"{row['samples']:,}"),
        "step": cells(lambda row: _step(row, look)),
        "pauses": cells(lambda row: f"{row['pauses']:,}" if row["pauses"] else None),
        "missing": cells(lambda row: row["missing"] and percent(row["missing"] / row["samples"])),
        "least": cells(lambda row: _value(row["lowest"])),
        "most": cells(lambda row: _value(row["highest"])),
        "values": cells(lambda row: f"{row['values_seen']:,}"),
        "still": cells(_still),
        "cycle": cells(lambda row: row["cycle_length"] and f"{row['cycle_length']:,}"),
    }


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


def _value(value: float | None) -> str | None:
    if value is None:
        return None
    return f"{value:,.0f}" if 1e4 <= abs(value) < 1e9 else f"{value:.4g}"


def _max_gap(proposal: Proposal) -> list[str]:
    """Return the proposed max_gap as it stands in gam.toml; nothing where there is none."""
    if proposal.max_gap is not None:
        return [f"max_gap = {json.dumps(proposal.max_gap.value)}"]
    return [f"max_gap of {number_of(len(proposal.gaps), 'channel')}"] if proposal.gaps else []


def _ending(seen: Seen) -> list[str]:
    proposal, look = seen.proposal, seen.look
    must = sum(note.must for note in seen.notes)
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
        if look.method.parameters.still_after is None and proposal.still is not None:
            to_set.append(f"still_after = {proposal.still.value} ({proposal.still.reason})")
        elif look.method.parameters.still_after is None and proposal.stills:
            to_set.append(f"still_after of {number_of(len(proposal.stills), 'channel')}")
        if proposal.window != look.method.parameters.window:
            to_set.append(f"window = {proposal.window} ({proposal.window_reason})")
        if not must:
            lines.append("nothing must be fixed")
        if to_set:
            lines.append(f"to be set: {'; '.join(to_set)} (gam init writes it down)")
    return lines


@options.taking(*options.READ, fresh=True)
def init(
    settings: Settings,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="The file to write.")] = Path(
        DEFAULT_FILE
    ),
    force: Annotated[bool, typer.Option("--force", help="Replace the file if it is there.")] = False,
    select: Annotated[
        bool,
        typer.Option(
            "--select",
            help="Choose delay, dimension, bins and window of every channel, too, as gam select does.",
        ),
    ] = False,
    quiet: options.Quiet = False,
    threads: options.Threads = None,
) -> None:
    """Write a commented gam.toml for SOURCE: its columns, and parameters with the reason for each.

    What is given as an option is taken as it is; columns are guessed and max_gap and window are
    proposed from a look at the source. An existing file is left alone unless --force says otherwise.
    Ends with 2 if something of the source must be fixed first (the file says what).
    """
    relation = options.named_relation(settings)
    if out.exists() and not force:
        raise ConfigurationError(f"{out} is there already; --force replaces it, --out writes another.")
    if not out.parent.is_dir():
        raise ConfigurationError(f"--out is {out}; the folder {out.parent} is not there.")
    session = connect(settings.source.database, threads, writable=False)
    with working(session, quiet) as on_step:
        seen = _settled(looked(session, relation, settings, on_step), settings)
    choices = chosen(settings, seen.job, Search(), threads).choices.to_pylist() if select else None
    save(out, text(seen, settings, out.parent, choices))
    code = Exit.ATTENTION if must_be_fixed(seen.notes) else Exit.FINE
    page.tell(code, {}, lambda lines: _proposed(lines, seen, out), quiet=quiet)


def _proposed(lines: Console, seen: Seen, out: Path) -> None:
    page.say(lines, heading(seen))
    must = sum(note.must for note in seen.notes)
    if must:
        page.say(lines, f"{must} to be fixed first; gam check says what")
    lines.print(f"written: {printable(str(out))}; read it, then: gam run", soft_wrap=True)


def text(
    seen: Seen, settings: Settings, folder: Path, choices: Sequence[dict[str, Any]] | None = None
) -> str:
    """Return the text of the settings file.

    Args:
        seen: the source, looked at.
        settings: what was said of it by options.
        folder: where the file will lie; a source is named relative to it.
        choices: what ``gam select`` says of each channel, where it was asked.
    """
    lines = toml_text.comment(
        f"Settings of gam-db. {heading(seen)}. Columns and parameters are "
        "proposed from a look at the source; all keys can be left out or changed."
    )
    for note in seen.notes:
        said = note_line(note, seen.look)
        first, *more = toml_text.comment(f"{'MUST BE FIXED' if note.must else 'Note'}: {said}")
        lines += ["#", first, *more]
    lines += ["", "[source]", *toml_text.entries(_source(seen, settings, folder))]
    lines += ["", "[parameters]", *toml_text.entries(_parameters(seen, settings))]
    proposed = _of_channels(seen, settings)
    if choices is not None:
        own = {
            _key(row): {name: value for name, (value, _) in proposed[row["channel"]].items()}
            for row in choices
            if row["channel"] in proposed
        }
        lines += groups(choices, seen.job, seen.job.parameters.window, own)
    else:
        for channel, said_own in proposed.items():
            entries = {"channel": (channel, ""), **said_own}
            lines += ["", "[[override]]", *toml_text.entries(entries)]
    lines += ["", "[calibration]", *_calibration(settings.calibration)]
    return "\n".join(lines) + "\n"


def _of_channels(seen: Seen, settings: Settings) -> dict[str, dict[str, tuple[Any, str]]]:
    """Return what is proposed for channels of one name alone; of overrides only the first applies."""
    gaps = {} if "max_gap" in settings.parameters else seen.proposal.gaps
    stills = {} if "still_after" in settings.parameters else seen.proposal.stills
    made: dict[str, dict[str, tuple[Any, str]]] = {}
    for channel, gap in gaps.items():
        made.setdefault(channel, {})["max_gap"] = gap.value, gap.reason
    for channel, still in stills.items():
        made.setdefault(channel, {})["still_after"] = still.value, still.reason
    return made


def _settled(seen: Seen, settings: Settings) -> Seen:
    """Return the same with what is proposed set: only what is left to be said is said."""
    changed: dict[str, Any] = {}
    if "window" not in settings.parameters and "stride" not in settings.parameters:
        changed = {"window": seen.proposal.window, "stride": None}
    if "max_gap" not in settings.parameters and seen.proposal.max_gap is not None:
        changed["max_gap"] = seen.proposal.max_gap.value
    if "still_after" not in settings.parameters and seen.proposal.still is not None:
        changed["still_after"] = seen.proposal.still.value
    parameters = dataclasses.replace(seen.job.parameters, **changed)
    method = dataclasses.replace(seen.look.method, parameters=parameters.finest())
    look = dataclasses.replace(seen.look, method=method)
    return Seen(
        dataclasses.replace(seen.job, parameters=parameters),
        look,
        notes(look, seen.proposal),
        seen.proposal,
    )


def _source(seen: Seen, settings: Settings, folder: Path) -> dict[str, tuple[Any, str]]:
    guess, known = seen.job.guess, settings_of(SourceSettings)
    source = guess.source
    relation, database = source.relation, settings.source.database
    placed = [_from(folder, one) for one in paths_of(relation)] if is_file(relation) else [relation]
    said: dict[str, tuple[Any, str]] = {
        "relation": (placed[0] if len(placed) == 1 else placed, "the telemetry")
    }
    if database is not None and not is_file(relation):
        address = _from(folder, shown(database))
        said["database"] = (address, "the database that holds the table")
    columns: dict[str, Any] = {"asset": source.asset, "time": source.time}
    if isinstance(source, Source):
        columns |= {"channel": source.channel, "value": source.value}
    else:
        said["layout"] = ("wide", known["layout"].what)
        columns["channels"] = list(source.value_columns)
    for role, column in columns.items():
        if column is None:
            said[role] = (False, f"there is no {known[role].what}")
        else:
            said[role] = (column, known[role].what + (", guessed" if role in guess.guessed else ""))
    said |= {name: (value, known[name].what) for name, value in source.written.items()}
    if settings.source.where is not None:
        said["where"] = (settings.source.where, known["where"].what)
    return said


def _from(folder: Path, path: str) -> str:
    """Return a path as seen from the folder of the settings file; an absolute one stays."""
    if Path(path).is_absolute() or "://" in path:
        return path
    return slashed(Path(os.path.relpath(path, folder)).as_posix(), path)


def _parameters(seen: Seen, settings: Settings) -> dict[str, tuple[Any, str]]:
    parameters, proposal = seen.job.parameters, seen.proposal
    said: dict[str, tuple[Any, str]] = {}
    for name, one in settings_of(Parameters).items():
        given = name in settings.parameters
        of, why = getattr(parameters, name), "as given" if given else "the default"
        if name == "window" and of == proposal.window and not given:
            why = proposal.window_reason
        elif name == "stride" and not given:
            continue
        elif name == "max_gap" and not given:
            of, why = _gap(seen)
        elif name == "still_after" and not given:
            of, why = _stillness(seen)
        said[name] = (False if of is None else of, f"{one.what}: {why}")
    steps = sorted(row["typical_step"] for row in seen.look.channels if row["typical_step"])
    if steps and "tau" not in settings.parameters:
        usual = spoken(steps[len(steps) // 2], seen.look.kind)
        said["tau"] = (
            parameters.tau,
            f"{settings_of(Parameters)['tau'].what} (usual step {usual}): the default",
        )
    return said


def _stillness(seen: Seen) -> tuple[Any, str]:
    still = seen.proposal.still
    if still is not None:
        return still.value, still.reason
    if seen.proposal.stills:
        return False, "none for all channels, see the overrides"
    return False, "never, since nothing stood still for a short part of calibration"


def _gap(seen: Seen) -> tuple[Any, str]:
    gap = seen.proposal.max_gap
    if gap is not None:
        return gap.value, gap.reason
    if seen.proposal.gaps:
        return False, "none for all channels, see the overrides"
    return False, "no limit, since no pause was found"


def _calibration(said: Mapping[str, Any]) -> list[str]:
    known = {name: (value, "as given") for name, value in said.items()}
    if not {"fraction", "duration", "intervals"} & set(said):
        known = {"fraction": (0.2, "the first 20 % of each channel: the default"), **known}
    return [
        *toml_text.comment(
            "The part that is known to be healthy; better than a share is what you know: "
            "intervals = [[FROM, TO]], such as [[2026-03-01, 2026-03-14T18:00:00]] or [[0, 5000]]."
        ),
        *toml_text.entries(known),
    ]
