"""``gam init``: a commented gam.toml for a source, from a look at it.

This module owns what is written; :mod:`gam_db.checking` looks, and proposes.
"""

import dataclasses
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any

import typer

from gam_db.address import shown
from gam_db.checking import must_be_fixed, notes
from gam_db.checking.words import spoken
from gam_db.cli import look_report, options, report, toml_text
from gam_db.cli.check import Seen, looked
from gam_db.cli.progress import Progress, interruptible
from gam_db.config import DEFAULT_FILE, Settings
from gam_db.connecting import connect
from gam_db.errors import ConfigurationError
from gam_db.source import Source, is_file

_MEANINGS = {
    "asset": "the column that names the machine",
    "channel": "the column that names the signal",
    "time": "the column with the time",
    "value": "the column with the readings",
    "channels": "the columns with the readings, each a signal",
}
_PARAMETERS = {
    "m": "embedding dimension",
    "tau": "delay, in samples",
    "bins": "bins per axis; gam run says if calibration is too short for so fine a grid",
    "window": "vectors in the moving average",
    "stride": "vectors per bucket",
    "max_gap": "the longest step in time that is no pause",
    "target_floor": "the indicator that a healthy machine may show",
}


def init(
    source: options.SourceArgument = None,
    database: options.DatabaseOption = None,
    out: Annotated[Path, typer.Option("--out", metavar="FILE", help="The file to write.")] = Path(
        DEFAULT_FILE
    ),
    force: Annotated[bool, typer.Option("--force", help="Replace the file if it is there.")] = False,
    quiet: Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")] = False,
    threads: options.ThreadsOption = None,
    asset: options.AssetOption = None,
    no_asset: options.NoAssetOption = False,
    channel: options.ChannelOption = None,
    no_channel: options.NoChannelOption = False,
    time: options.TimeOption = None,
    value: options.ValueOption = None,
    wide: options.WideOption = False,
    where: options.WhereOption = None,
    m: options.MOption = None,
    tau: options.TauOption = None,
    bins: options.BinsOption = None,
    window: options.WindowOption = None,
    stride: options.StrideOption = None,
    max_gap: options.MaxGapOption = None,
    target_floor: options.TargetFloorOption = None,
    calibration_fraction: options.FractionOption = None,
    calibration_duration: options.DurationOption = None,
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
    score_from: options.ScoreFromOption = None,
    pool: options.PoolOption = None,
) -> None:
    """Write a commented gam.toml for SOURCE: its columns, and parameters with the reason for each.

    What is given as an option is taken as it is; columns are guessed and max_gap and window are
    proposed from a look at the source. An existing file is left alone unless --force says otherwise.
    Ends with 2 if something of the source must be fixed first (the file says what).
    """
    settings = options.settings(
        file=None,
        relation=source,
        database=database,
        asset=asset,
        no_asset=no_asset,
        channel=channel,
        no_channel=no_channel,
        time=time,
        value=value,
        wide=wide,
        where=where,
        m=m,
        tau=tau,
        bins=bins,
        window=window,
        stride=stride,
        max_gap=max_gap,
        target_floor=target_floor,
        calibration_fraction=calibration_fraction,
        calibration_duration=calibration_duration,
        calibrate=calibrate,
        exclude=exclude,
        score_from=score_from,
        pool=pool,
        fresh=True,
    )
    relation = options.named_relation(settings)
    if out.exists() and not force:
        raise ConfigurationError(f"{out} is there already; --force replaces it, --out writes another.")
    if not out.parent.is_dir():
        raise ConfigurationError(f"--out is {out}; the folder {out.parent} is not there.")
    with (
        interruptible(),
        connect(settings.source.database, threads, writable=False) as session,
        Progress(session, quiet) as progress,
    ):
        seen = _settled(looked(session, relation, settings, progress.on_step), settings)
    written = text(seen, settings, out.parent)
    unfinished = out.with_name(f".{out.name}.{os.getpid()}")
    try:
        unfinished.write_text(written, encoding="utf-8")
        unfinished.replace(out)
    except OSError as error:
        raise ConfigurationError(f"{out} cannot be written: {error.strerror}.") from error
    finally:
        unfinished.unlink(missing_ok=True)
    lines = report.console()
    if not quiet:
        report.say(lines, look_report.heading(seen.job, seen.look))
        must = sum(note.must for note in seen.notes)
        if must:
            report.say(lines, f"{must} to be fixed first; gam check says what")
        lines.print(f"written: {out}; read it, then: gam run", soft_wrap=True)
    if must_be_fixed(seen.notes):
        raise typer.Exit(2)


def text(seen: Seen, settings: Settings, folder: Path) -> str:
    """Return the text of the settings file.

    Args:
        seen: the source, looked at.
        settings: what was said of it by options.
        folder: where the file will lie; a source is named relative to it.
    """
    one_asset = len({row["asset"] for row in seen.look.channels}) <= 1
    lines = toml_text.comment(
        f"Settings of gam-db. {look_report.heading(seen.job, seen.look)}. Columns and parameters are "
        "proposed from a look at the source; all keys can be left out or changed."
    )
    for note in seen.notes:
        said = look_report.note_line(note, one_asset, len(seen.look.channels))
        first, *more = toml_text.comment(f"{'MUST BE FIXED' if note.must else 'Note'}: {said}")
        lines += ["#", first, *more]
    lines += ["", "[source]", *toml_text.entries(_source(seen, settings, folder))]
    lines += ["", "[parameters]", *toml_text.entries(_parameters(seen, settings))]
    if "max_gap" not in settings.parameters:
        for channel, gap in seen.proposal.gaps.items():
            said_gap = {"channel": (channel, ""), "max_gap": (gap.value, gap.reason)}
            lines += ["", "[[override]]", *toml_text.entries(said_gap)]
    lines += ["", "[calibration]", *_calibration(settings.calibration)]
    return "\n".join(lines) + "\n"


def _settled(seen: Seen, settings: Settings) -> Seen:
    """Return the same with what is proposed set: only what is left to be said is said."""
    changed: dict[str, Any] = {}
    if "window" not in settings.parameters and "stride" not in settings.parameters:
        changed = {"window": seen.proposal.window, "stride": None}
    if "max_gap" not in settings.parameters and seen.proposal.max_gap is not None:
        changed["max_gap"] = seen.proposal.max_gap.value
    parameters = dataclasses.replace(seen.job.parameters, **changed)
    method = dataclasses.replace(seen.look.method, parameters=parameters)
    look = dataclasses.replace(seen.look, method=method)
    return Seen(
        dataclasses.replace(seen.job, parameters=parameters),
        look,
        notes(look, seen.proposal),
        seen.proposal,
    )


def _source(seen: Seen, settings: Settings, folder: Path) -> dict[str, tuple[Any, str]]:
    guess = seen.job.guess
    source = guess.source
    relation, database = seen.job.name, settings.source.database
    said: dict[str, tuple[Any, str]] = {
        "relation": (_from(folder, relation) if is_file(relation) else relation, "the telemetry")
    }
    if database is not None and not is_file(relation):
        address = _from(folder, shown(database))
        said["database"] = (address, "the database that holds the table")
    columns: dict[str, Any] = {"asset": source.asset, "time": source.time}
    if isinstance(source, Source):
        columns |= {"channel": source.channel, "value": source.value}
    else:
        said["layout"] = ("wide", "one column per signal")
        columns["channels"] = list(source.value_columns)
    for role, column in columns.items():
        if column is None:
            said[role] = (False, f"there is no {_MEANINGS[role].removeprefix('the ')}")
        else:
            said[role] = (column, _MEANINGS[role] + (", guessed" if role in guess.guessed else ""))
    if settings.source.where is not None:
        said["where"] = (settings.source.where, "a condition in SQL, applied before everything else")
    return said


def _from(folder: Path, path: str) -> str:
    """Return a path as seen from the folder of the settings file; an absolute one stays."""
    if Path(path).is_absolute() or "://" in path:
        return path
    return Path(os.path.relpath(path, folder)).as_posix()


def _parameters(seen: Seen, settings: Settings) -> dict[str, tuple[Any, str]]:
    parameters, proposal = seen.job.parameters, seen.proposal
    said: dict[str, tuple[Any, str]] = {}
    for name, meaning in _PARAMETERS.items():
        given = name in settings.parameters
        of, why = getattr(parameters, name), "as given" if given else "the default"
        if name == "window" and of == proposal.window and not given:
            why = proposal.window_reason
        elif name == "stride" and not given:
            continue
        elif name == "max_gap" and not given:
            of, why = _gap(seen)
        said[name] = (False if of is None else of, f"{meaning}: {why}")
    steps = sorted(row["typical_step"] for row in seen.look.channels if row["typical_step"])
    if steps and "tau" not in settings.parameters:
        usual = spoken(steps[len(steps) // 2], seen.look.kind)
        said["tau"] = (parameters.tau, f"{_PARAMETERS['tau']} (usual step {usual}): the default")
    return said


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
