"""What ``gam select`` chose, as ``[[override]]`` groups of gam.toml with the reason of each.

This module owns which keys are written, their reasons, and how a file's own groups are replaced.
"""

import contextlib
import os
import re
import tomllib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from statistics import median_low
from typing import Any

from gam_db.checking.words import number_of
from gam_db.cli import toml_text
from gam_db.cli.config import Settings, load
from gam_db.cli.job import Job
from gam_db.cli.progress import working
from gam_db.cli.render import WORDS
from gam_db.engines.connecting import connect
from gam_db.errors import ConfigurationError, unwritable, wrong
from gam_db.findings import Row
from gam_db.selection.search import Search
from gam_db.selection.select import Selection, Studied, alone, selected_by_all
from gam_db.settings.calibration import WAYS, Calibration
from gam_db.settings.parameters import Parameters, pattern_matches
from gam_db.settings.patterns import Name, grouped
from gam_db.settings.setting import settings_of
from gam_db.study import Study


def chosen(settings: Settings, job: Job, search: Search, threads: int | None) -> Selection:
    """Choose for every channel of a source by itself; a channel that fails is among the failures."""
    parameters, calibration = alone(job.parameters, job.calibration)

    @contextlib.contextmanager
    def studies() -> Iterator[Studied]:
        opened = connect(settings.source.database, threads, writable=False)
        with working(opened) as on_step:
            yield lambda source: Study(opened, source, parameters, calibration, on_step)

    return selected_by_all(studies, job.guess.source, search)


def groups(
    choices: Sequence[Row], job: Job, window: int, extra: Mapping[Name, Mapping[str, Any]]
) -> list[str]:
    """Return the lines of the ``[[override]]`` groups that say what was chosen.

    Members of a pool, which must have the same parameters to learn together, are given the same:
    the median of delay and dimension, the coarsest grid and the longest window. A window is said that is
    not that of the file; ``extra`` is what else is to be said of channels.
    """
    rows = {
        (row["asset"], row["channel"]): row
        for row in choices
        if row["recommended_m"] is not None and row["verdict"] not in ("constant", "no_data")
    }
    names = [(row["asset"], row["channel"]) for row in choices]
    changes = {name: {**extra.get(name, {})} for name in names}
    for names in _together(list(rows), job.calibration.pools):
        for key, of, column in _TAKEN:
            taken = [rows[name][column] for name in names]
            if key == "window" and None in taken:  # calibration is too short for any
                continue
            value = of([1 if number is None else number for number in taken])
            if key != "window" or value != window:
                for name in names:
                    changes[name][key] = value
    by_name = {name: tuple(sorted(values.items())) for name, values in changes.items() if values}
    lines: list[str] = []
    rules = grouped(by_name)
    for (asset, channel), values in rules:
        first = {
            name: next(p for p, _ in rules if all(map(pattern_matches, p, name))) for name in by_name
        }
        members = [rows[name] for name, p in first.items() if p == (asset, channel) and name in rows]
        lines += ["", "[[override]]", *toml_text.comment(_reason(members, job))]
        lines += toml_text.entries({"asset": (asset, ""), "channel": (channel, "")})
        lines += toml_text.entries({key: (_plain(value), "") for key, value in values})
    return lines


_TAKEN = (
    ("m", median_low, "recommended_m"),
    ("tau", median_low, "tau"),
    ("bins", min, "recommended_bins"),
    ("window", max, "recommended_window"),
)


def written(path: Path, settings: Settings, job: Job, choices: Sequence[Row]) -> None:
    """Put the groups of what was chosen into a settings file, in the place of those it has.

    Of its own groups the keys that are not chosen stay, and so does all else of the file. A new one
    holds the parameters that were given beside, and the calibration.
    """
    if not path.parent.is_dir():
        raise ConfigurationError(f"--write is {path}; the folder {path.parent} is not there.")
    if path.exists():
        present, text = load(path), path.read_text(encoding="utf-8")
    else:
        present, entries = settings, {name: (_plain(of), "") for name, of in settings.parameters.items()}
        lines = ["# Settings of gam-db, chosen by gam select.", "", "[parameters]"]
        healthy = ["", "[calibration]", *calibration_lines(settings.calibration)]
        text = "\n".join([*lines, *toml_text.entries(entries), *healthy])
    window = present.parameters.get("window", Parameters().window)
    names = [(row["asset"], row["channel"]) for row in choices]
    taken = {key for key, _, _ in _TAKEN}  # what a file's own group says of these is chosen anew
    extra: dict[Name, dict[str, Any]] = {}
    for name in names:
        changes = next(
            (override.changes() for override in present.overrides if override.names(*name)), {}
        )
        extra[name] = {key: of for key, of in changes.items() if key not in taken}
    remaining, among = [], False
    for line in text.splitlines():
        if re.match(r"\s*\[", line):
            among = re.match(r"\s*\[\[\s*override\s*\]\]", line) is not None
        if not among:
            remaining.append(line)
    lines = [*"\n".join(remaining).rstrip().splitlines(), *groups(choices, job, window, extra)]
    new = "\n".join(lines) + "\n"
    try:
        is_same = {**tomllib.loads(text), "override": None} == {**tomllib.loads(new), "override": None}
    except tomllib.TOMLDecodeError:
        is_same = False
    if not is_same:
        raise wrong("override_cannot_be_replaced", path=path)
    save(path, new)


def calibration_lines(calibration: Mapping[str, Any]) -> list[str]:
    """Return the lines of the section [calibration], and of those of some assets."""
    entries = {
        name: (_plain(value), "as given") for name, value in calibration.items() if name != "overrides"
    }
    if not set(WAYS) & set(calibration):
        entries = {"fraction": (0.2, "the first 20 % of each channel: the default"), **entries}
    lines = toml_text.comment(
        "The healthy part of each channel. If you know when it was healthy, set intervals instead of a "
        "share: intervals = [[FROM, TO]], such as [[2026-03-01, 2026-03-14T18:00:00]] or [[0, 5000]]."
    )
    lines += toml_text.entries(entries)
    for pattern, rule in calibration.get("overrides", {}).items():
        name = toml_text.value(pattern)
        if rule is None:
            lines += ["", "[calibration.overrides]", f"{name} = false"]
            continue
        values = {key: getattr(rule, key) for key in settings_of(Calibration)}
        usual = {key: getattr(Calibration(fraction=1.0), key) for key in values} | {"fraction": None}
        changed = {key: (value, "as given") for key, value in values.items() if value != usual[key]}
        lines += ["", f"[calibration.overrides.{name}]", *toml_text.entries(changed)]
    return lines


def save(path: Path, text: str) -> None:
    """Write a settings file whole or not at all, and only one that can be read and fits together."""
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        unfinished.write_text(text, encoding="utf-8")
        load(unfinished).method()
        unfinished.replace(path)
    except OSError as error:
        raise unwritable(path, error) from error
    finally:
        unfinished.unlink(missing_ok=True)


def _together(names: Sequence[Name], pools: Sequence[Sequence[str]]) -> list[list[Name]]:
    """Return the channels that learn together; one that has no pool stands alone."""
    by_pool: dict[Any, list[Name]] = {}
    for name in names:
        pool = next(
            (group for group in pools if any(pattern_matches(pattern, name[0]) for pattern in group)),
            None,
        )
        by_pool.setdefault(name if pool is None else (pool, name[1]), []).append(name)
    return list(by_pool.values())


def _reason(members: Sequence[Row], job: Job) -> str:
    if not members:
        return "Unchanged; gam select chose nothing."

    def counted(column: str, words: Mapping[str, str]) -> str:
        counts = Counter(row[column] for row in members).most_common()
        return "; ".join(words[key] + (f" ({n})" if len(counts) > 1 else "") for key, n in counts)

    parts = [
        f"tau: {counted('tau_rule', WORDS['tau'])}",
        f"m: {counted('fnn_status', WORDS['unfolds'])}",
    ]
    if floors := [row["recommended_floor"] for row in members if row["verdict"] != "needs_data"]:
        most = f"{min(floors):.3f}" + (f" to {max(floors):.3f}" if max(floors) > min(floors) else "")
        parts.append(f"bins: the finest grid that calibration fills, floor {most}")
    if len(floors) < len(members):
        short = number_of(len(members) - len(floors), "channel")
        parts.append(f"needs_data: no grid passes for {short}, calibrate longer")
    windows = [row for row in members if row["recommended_window"] is not None]
    if any(row["recommended_window"] < _wanted(row, job) for row in windows):
        parts.append("window: at most an eighth of calibration")
    elif cycles := [row["cycle_length"] for row in windows if row["window_status"] == "short"]:
        parts.append(f"window: five cycles of up to {max(cycles):,} samples")
    if none := sum(row["recommended_window"] is None for row in members):
        parts.append(f"no window: calibration of {number_of(none, 'channel')} is too short for any")
    if job.calibration.pools:
        parts.append("one choice for each pool")
    return f"{number_of(len(members), 'channel')}. {'. '.join(parts)}."


def _wanted(row: Row, job: Job) -> int:
    """Return the window that the cycle of a channel wants, or that is asked for."""
    window = job.parameters.closed().window if job.parameters.is_open else job.parameters.window
    return 5 * row["cycle_length"] if row["window_status"] == "short" else int(window)


def _plain(value: Any) -> Any:
    return False if value is None else value
