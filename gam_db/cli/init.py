"""``gam init``: a commented gam.toml for a source, from a look at it.

This module owns the command and the text of the file; :mod:`gam_db.checking` looks and proposes.
"""

import dataclasses
import os
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from gam_db.address import shown
from gam_db.checking import must_be_fixed, notes
from gam_db.checking.words import number_of, spoken
from gam_db.cli import automatic, options, toml_text
from gam_db.cli.check import Seen, heading, looked, note_line
from gam_db.cli.chosen import calibration_lines, chosen, groups, save
from gam_db.cli.config import DEFAULT_FILE, Settings
from gam_db.cli.job import reading
from gam_db.cli.options import option
from gam_db.cli.render import Page, Section, Verbatim, show
from gam_db.columns import name_of
from gam_db.errors import ConfigurationError
from gam_db.reading.guess import SourceSettings
from gam_db.selection.search import Search
from gam_db.settings.parameters import Parameters, pattern_matches
from gam_db.settings.patterns import Name, grouped
from gam_db.settings.setting import settings_of
from gam_db.settings.source import Source, is_file, paths_of, slashed
from gam_db.study.automatic import Siblings


@options.taking(*options.READ, "quiet", "threads", fresh=True)
def init(
    settings: Settings,
    common: options.Common,
    out: Path = option("init.out", Path(DEFAULT_FILE)),
    force: bool = option("init.force", False),
    select: bool = option("init.select", False),
) -> None:
    """Write a commented gam.toml for a source.

    The file holds the columns and the parameters, each with its reason. gam looks at the source to guess
    columns and to propose max_gap and window; options override both. An existing file stays, unless you
    add --force. Exit code 2 means that the source must be fixed first; the file says what.
    """
    if out.exists() and not force:
        raise ConfigurationError(
            f"{out} already exists; --force replaces it, --out writes another file."
        )
    if not out.parent.is_dir():
        raise ConfigurationError(f"--out is {out}; the folder {out.parent} is not there.")
    with reading(settings, common) as (session, job, on_step):
        seen, study = _settled(looked(session, job, on_step), settings), None
        if seen.job.parameters.is_open and not must_be_fixed(seen.notes):
            study = seen.job.study(session, on_step)
            names = sorted(map(name_of, study.rows("channels")))
            study.forget()
    choices = None
    if select:
        choices = chosen(settings, seen.job, Search(), common.threads).choices.to_pylist()
    calibrated = None if study is None else Calibrated(study.method.parameters, study.siblings, names)
    save(out, text(seen, settings, out.parent, choices, calibrated))

    def sections() -> Iterator[Section]:
        yield heading(seen)
        if _proposes_window(settings) and seen.proposal.window is None:
            yield f"no window: {seen.proposal.window_reason}"
        if must := sum(note.must for note in seen.notes):
            yield f"fix {number_of(must, 'problem')} first; gam check shows them"
        yield Verbatim(f"written: {out}; read it, then: gam run")

    show(Page({}, sections(), urgent=must_be_fixed(seen.notes)), common)


EVERY = ("*", "*")


@dataclasses.dataclass(frozen=True)
class Calibrated:
    """What calibration chose: parameters, the siblings it chose for, and the names of all channels."""

    parameters: Parameters
    siblings: Sequence[Siblings]
    names: Sequence[Name]

    def rules(self) -> list[tuple[Name, dict[str, Any], dict[str, str]]]:
        """Return patterns with what is chosen for them and why, the general one last."""
        of_open = {
            name_of(row): (of, of.setting.open_settings) for of in self.siblings for row in of.channels
        }
        by_name = {
            name: tuple((key, getattr(self.parameters.of(*name), key)) for key in ("m", *open_settings))
            for name in self.names
            if name in of_open
            for open_settings in [of_open[name][1]]
        }
        rules = []
        for pattern, values in grouped(by_name):
            of = next(
                of for name, (of, _) in of_open.items() if all(map(pattern_matches, pattern, name))
            )
            rules.append((pattern, dict(values), automatic.reasons(of)))
        return rules


def text(
    seen: Seen,
    settings: Settings,
    folder: Path,
    choices: Sequence[dict[str, Any]] | None = None,
    calibrated: Calibrated | None = None,
) -> str:
    """Return the text of a settings file in a folder, with the choices of ``gam select`` if any.

    *calibrated* is what calibration chooses for open settings.
    """
    lines = toml_text.comment(
        f"Settings of gam-db. {heading(seen)}. gam proposed the columns and parameters from a look at "
        "the source. You can change or remove every key."
    )
    for note in seen.notes:
        sentence = note_line(note, seen.look)
        first, *more = toml_text.comment(f"{'MUST BE FIXED' if note.must else 'Note'}: {sentence}")
        lines += ["#", first, *more]
    lines += ["", "[source]", *toml_text.entries(_source(seen, settings, folder))]
    parameters = _parameters(seen, settings)
    rules = [] if calibrated is None or choices is not None else calibrated.rules()
    if _proposes_window(settings) and seen.proposal.window is None:
        for _, values, _ in rules:
            values.pop("window", None)
    parameters |= {
        name: (of, f"{settings_of(Parameters)[name].what}: {why[name]}")
        for pattern, values, why in rules
        for name, of in values.items()
        if pattern == EVERY
    }
    lines += ["", "[parameters]", *toml_text.entries(parameters)]
    # What is proposed for channels of one name alone; of overrides only the first applies.
    proposed: dict[str, dict[str, tuple[Any, str]]] = {}
    for name, _, of_channels, _ in _unsaid(seen, settings):
        for channel, suggestion in of_channels.items():
            proposed.setdefault(channel, {})[name] = suggestion.value, suggestion.reason
    if _proposes_window(settings) and choices is None:  # which have windows of their own
        for channel, suggestion in seen.proposal.windows.items():
            proposed.setdefault(channel, {})["window"] = suggestion.value, suggestion.reason
    if choices is not None:
        extra = {
            (row["asset"], row["channel"]): {name: value for name, (value, _) in proposals.items()}
            for row in choices
            if (proposals := proposed.get(row["channel"]))
        }
        lines += groups(choices, seen.job, seen.job.parameters.window, extra)
    elif len(rules) > 1:
        # The first override that names a channel is the only one: what is proposed for it goes along.
        for (asset, channel), values, why in rules:
            taken: dict[str, tuple[Any, str]] = {key: (of, why[key]) for key, of in values.items()}
            narrower = [name for name in proposed if name != channel and pattern_matches(channel, name)]
            for name in [*narrower, *([channel] if (asset, channel) != EVERY else [])]:
                named = {"asset": (asset, ""), "channel": (name, "")}
                entries = {**named, **proposed.get(name, {}), **taken}
                lines += ["", "[[override]]", *toml_text.entries(entries)]
    else:
        for channel, proposals in proposed.items():
            entries = {"channel": (channel, ""), **proposals}
            lines += ["", "[[override]]", *toml_text.entries(entries)]
    lines += ["", "[calibration]", *calibration_lines(settings.calibration)]
    return "\n".join(lines) + "\n"


def _unsaid(seen: Seen, settings: Settings) -> list[tuple[str, Any, Mapping[str, Any], str]]:
    """Return proposals for open settings: for all channels, for some, or why there is none."""
    proposal, never = (
        seen.proposal,
        "never, because no signal stood still for a short part of calibration",
    )
    every = (
        ("max_gap", proposal.max_gap, proposal.gaps, "no limit, because the source has no pause"),
        ("still_after", proposal.still, proposal.stills, never),
    )
    return [row for row in every if row[0] not in settings.parameters]


def _proposes_window(settings: Settings) -> bool:
    """Tell whether a window may be proposed: neither it nor what must divide it was given."""
    return not {"window", "stride"} & {*settings.parameters}


def _settled(seen: Seen, settings: Settings) -> Seen:
    """Return the same with what is proposed set: only what is left to be said is said."""
    changed: dict[str, Any] = {}
    if _proposes_window(settings) and seen.proposal.window is not None:
        changed = {"window": seen.proposal.window, "stride": None}
    changed |= {
        name: suggestion.value
        for name, suggestion, *_ in _unsaid(seen, settings)
        if suggestion is not None
    }
    parameters = dataclasses.replace(seen.job.parameters, **changed)
    method = dataclasses.replace(seen.look.method, parameters=parameters.finest())
    look = dataclasses.replace(seen.look, method=method)
    job = dataclasses.replace(seen.job, parameters=parameters)
    return Seen(job, look, notes(look, seen.proposal), seen.proposal)


def _source(seen: Seen, settings: Settings, folder: Path) -> dict[str, tuple[Any, str]]:
    guess, fields = seen.job.guess, settings_of(SourceSettings)
    source = guess.source
    relation, database = source.relation, settings.source.database
    paths = [_from(folder, path) for path in paths_of(relation)] if is_file(relation) else [relation]
    entries: dict[str, tuple[Any, str]] = {
        "relation": (paths[0] if len(paths) == 1 else paths, "the telemetry")
    }
    if database is not None and not is_file(relation):
        entries["database"] = (_from(folder, shown(database)), "the database that holds the table")
    columns: dict[str, Any] = {"asset": source.asset, "time": source.time}
    if isinstance(source, Source):
        columns |= {"channel": source.channel, "value": source.value}
    else:
        entries["layout"] = ("wide", fields["layout"].what)
        columns["channels"] = list(source.value_columns)
    for role, column in columns.items():
        if column is None:
            entries[role] = (False, f"no {fields[role].what}")
        else:
            entries[role] = (column, fields[role].what + (", guessed" if role in guess.guessed else ""))
    entries |= {name: (value, fields[name].what) for name, value in source.written.items()}
    if settings.source.where is not None:
        entries["where"] = (settings.source.where, fields["where"].what)
    return entries


def _from(folder: Path, path: str) -> str:
    """Return a path as seen from the folder of the settings file; an absolute one stays."""
    if Path(path).is_absolute() or "://" in path:
        return path
    return slashed(Path(os.path.relpath(path, folder)).as_posix(), path)


def _parameters(seen: Seen, settings: Settings) -> dict[str, tuple[Any, str]]:
    parameters, proposal = seen.job.parameters, seen.proposal
    proposed: dict[str, tuple[Any, str]] = {}
    for name, suggestion, by_channel, never in _unsaid(seen, settings):
        several = "none for all channels; see the overrides"
        proposed[name] = (
            (False, several if by_channel else never)
            if suggestion is None
            else (suggestion.value, suggestion.reason)
        )
    if proposal.window is None or parameters.window == proposal.window:
        proposed["window"] = (parameters.window, proposal.window_reason)
    entries: dict[str, tuple[Any, str]] = {}
    steps = sorted(row["typical_step"] for row in seen.look.channels if row["typical_step"])
    for name, setting in settings_of(Parameters).items():
        what, of, is_set = setting.what, getattr(parameters, name), name in settings.parameters
        of, why = (of, "as given") if is_set else proposed.get(name, (of, "the default"))
        if name == "tau" and steps and not is_set:
            what += f" (usual step {spoken(steps[len(steps) // 2], seen.look.kind)})"
        if name != "stride" or is_set:
            entries[name] = (False if of is None else of, f"{what}: {why}")
    return entries
