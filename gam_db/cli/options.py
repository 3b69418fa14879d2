"""Options that commands share: their names and help, and how they become settings.

This module owns the words of the command line; :mod:`gam_db.config` owns what they are laid over.
"""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from gam_db import config
from gam_db.address import VARIABLE
from gam_db.config import Settings
from gam_db.errors import ConfigurationError
from gam_db.source import FILE_ENDINGS, is_file

DATABASE_ENDINGS = (".duckdb", ".db")

_COLUMNS = "Columns, guessed where not named"
_PARAMETERS = "Parameters of the method"
_CALIBRATION = "Calibration, the healthy part: default the first 20 %"

SourceArgument = Annotated[
    str | None,
    typer.Argument(
        metavar="SOURCE",
        help="A Parquet or CSV file (wildcards allowed), or a table of --database. Default: what "
        "gam.toml says.",
        show_default=False,
    ),
]
DatabaseOption = Annotated[
    str | None,
    typer.Option(
        metavar="ADDRESS",
        help="Database that holds the table, a DuckDB file or a URL such as postgresql://HOST/DATABASE; "
        f"it is only read. Default: the environment variable {VARIABLE}.",
    ),
]
ConfigOption = Annotated[
    Path | None, typer.Option(help="Settings file; default ./gam.toml if it is there.")
]
ThreadsOption = Annotated[int | None, typer.Option(min=1, help="Processor threads; default all.")]

AssetOption = Annotated[
    str | None, typer.Option(help="Column that names the machine.", rich_help_panel=_COLUMNS)
]
NoAssetOption = Annotated[
    bool, typer.Option("--no-asset", help="It is one machine.", rich_help_panel=_COLUMNS)
]
ChannelOption = Annotated[
    list[str] | None,
    typer.Option(
        help="Column that names the signal. With --wide: a column that holds one (repeatable; "
        "default all numeric ones).",
        rich_help_panel=_COLUMNS,
    ),
]
NoChannelOption = Annotated[
    bool, typer.Option("--no-channel", help="It is one signal.", rich_help_panel=_COLUMNS)
]
TimeOption = Annotated[
    str | None,
    typer.Option(help="Column with a timestamp or an integer counter.", rich_help_panel=_COLUMNS),
]
ValueOption = Annotated[
    str | None, typer.Option(help="Column with the readings.", rich_help_panel=_COLUMNS)
]
WideOption = Annotated[
    bool, typer.Option("--wide", help="The table has one column per signal.", rich_help_panel=_COLUMNS)
]
WhereOption = Annotated[
    str | None,
    typer.Option(
        metavar="CONDITION",
        help="Rows to take, as a condition in SQL, for example \"machine = 'R7'\".",
        rich_help_panel=_COLUMNS,
    ),
]

MOption = Annotated[
    int | None, typer.Option("--m", help="Embedding dimension (default 3).", rich_help_panel=_PARAMETERS)
]
TauOption = Annotated[
    int | None, typer.Option("--tau", help="Delay, in samples (default 1).", rich_help_panel=_PARAMETERS)
]
BinsOption = Annotated[
    int | None, typer.Option("--bins", help="Bins per axis (default 100).", rich_help_panel=_PARAMETERS)
]
WindowOption = Annotated[
    int | None,
    typer.Option(
        "--window", help="Vectors in the moving average (default 5000).", rich_help_panel=_PARAMETERS
    ),
]
StrideOption = Annotated[
    int | None,
    typer.Option(
        "--stride",
        help="Vectors per bucket; divides the window (default gcd(window, 100)).",
        rich_help_panel=_PARAMETERS,
    ),
]
MaxGapOption = Annotated[
    str | None,
    typer.Option(
        "--max-gap",
        metavar="LENGTH",
        help="Longest step in time that is no pause: seconds or a text like '5 min'; steps of a "
        "counter; 'none' for no limit (the default).",
        rich_help_panel=_PARAMETERS,
    ),
]
TargetFloorOption = Annotated[
    float | None,
    typer.Option(
        "--target-floor",
        help="Indicator that a healthy machine may show (default 0.05).",
        rich_help_panel=_PARAMETERS,
    ),
]

EstimatorOption = Annotated[
    str,
    typer.Option(
        metavar="NAME",
        help="What scores vectors: dse (the method itself), or centroid, gmm, forest, ocsvm, which have "
        'no certificate and no limit. The last three need pip install "gam-db[benchmark]".',
        rich_help_panel=_PARAMETERS,
    ),
]

FractionOption = Annotated[
    float | None,
    typer.Option(help="The first share of each channel's samples.", rich_help_panel=_CALIBRATION),
]
DurationOption = Annotated[
    str | None,
    typer.Option(
        metavar="LENGTH",
        help="From the first sample on: seconds or a text like '30 d'; steps of a counter.",
        rich_help_panel=_CALIBRATION,
    ),
]
CalibrateOption = Annotated[
    list[str] | None,
    typer.Option(
        metavar="FROM/TO",
        help="A healthy interval, both ends included: 2026-03-01/2026-03-14T18:00:00, or 0/5000 "
        "for a counter (repeatable).",
        rich_help_panel=_CALIBRATION,
    ),
]
ExcludeOption = Annotated[
    list[str] | None,
    typer.Option(
        metavar="FROM/TO", help="Taken out of calibration (repeatable).", rich_help_panel=_CALIBRATION
    ),
]
ScoreFromOption = Annotated[
    str | None,
    typer.Option(
        metavar="TIME",
        help="First instant to score; default: after calibration.",
        rich_help_panel=_CALIBRATION,
    ),
]
PoolOption = Annotated[
    list[str] | None,
    typer.Option(
        metavar="GROUP",
        help="Machines that learn together, signal by signal: 'channel' for all of them, or names "
        "(* and ? allowed) with commas between (repeatable).",
        rich_help_panel=_CALIBRATION,
    ),
]


def settings(
    *,
    file: Path | None,
    relation: str | None,
    database: str | None,
    asset: str | None,
    no_asset: bool,
    channel: Sequence[str] | None,
    no_channel: bool,
    time: str | None,
    value: str | None,
    wide: bool,
    where: str | None,
    m: int | None,
    tau: int | None,
    bins: int | None,
    window: int | None,
    stride: int | None,
    max_gap: str | None,
    target_floor: float | None,
    calibration_fraction: float | None,
    calibration_duration: str | None,
    calibrate: Sequence[str] | None,
    exclude: Sequence[str] | None,
    score_from: str | None,
    pool: Sequence[str] | None,
    fresh: bool = False,
) -> Settings:
    """Return the settings of the file with the options of a command laid over them; ``fresh``: no file.

    Raises:
        ConfigurationError: the file or an option cannot be used.
    """
    if asset is not None and no_asset:
        raise ConfigurationError("--asset and --no-asset contradict each other; give one of them.")
    if channel and no_channel:
        raise ConfigurationError("--channel and --no-channel contradict each other; give one of them.")
    if wide and (value is not None or no_channel):
        raise ConfigurationError(
            "--wide means one column per signal; leave out --value and --no-channel."
        )
    if channel and len(channel) > 1 and not wide:
        raise ConfigurationError("Several --channel are columns of a wide table; add --wide.")
    columns = {
        "relation": relation,
        "database": database or (None if is_file(relation) else os.environ.get(VARIABLE)),
        "asset": False if no_asset else asset,
        "time": time,
        "value": value,
        "where": where,
        "layout": "wide" if wide else None,
        "channels": tuple(channel) if wide and channel else None,
        "channel": False if no_channel else channel[0] if channel and not wide else None,
    }
    parameters = {
        "m": m,
        "tau": tau,
        "bins": bins,
        "window": window,
        "stride": stride,
        "max_gap": False if max_gap == "none" else length(max_gap),
        "target_floor": target_floor,
    }
    calibration = {
        "fraction": calibration_fraction,
        "duration": length(calibration_duration),
        "intervals": _intervals("--calibrate", calibrate),
        "exclude": _intervals("--exclude", exclude),
        "score_from": score_from,
        "pool": _pools(pool),
    }
    said = Settings() if fresh else config.load(file)
    return said.under(columns, parameters, calibration)


def named_relation(settings: Settings) -> str:
    """Return the relation that was named: a file, or a table of the database.

    Raises:
        ConfigurationError: none was named, or it is neither.
    """
    relation, database = settings.source.relation, settings.source.database
    if relation is None:
        raise ConfigurationError(
            "Name a SOURCE: a Parquet or CSV file, or a table with --database FILE.duckdb; or put "
            "relation under [source] into gam.toml. `gam demo` needs none."
        )
    if database is None and not is_file(relation):
        if Path(relation).suffix in DATABASE_ENDINGS:
            raise ConfigurationError(
                f"{relation} is a database; name the table: gam run TABLE --database {relation}."
            )
        raise ConfigurationError(
            f"{relation!r} is no Parquet or CSV file ({', '.join(FILE_ENDINGS)}); if it is a table, say "
            "which database holds it: --database FILE.duckdb."
        )
    return relation


def length(text: str | None) -> int | float | str | None:
    """A plain number has no unit; anything else is left to the clock, which knows the units."""
    if text is None:
        return None
    for number in (int, float):
        try:
            return number(text)
        except ValueError:
            continue
    return text


def _intervals(option: str, texts: Sequence[str] | None) -> list[tuple[str, str]] | None:
    if not texts:
        return None
    pairs = []
    for text in texts:
        start, slash, end = (part.strip() for part in text.partition("/"))
        if not (start and slash and end):
            raise ConfigurationError(
                f"{option} is {text!r}; write FROM/TO, such as 2026-03-01/2026-03-14 or 0/5000."
            )
        pairs.append((start, end))
    return pairs


def _pools(texts: Sequence[str] | None) -> Any:
    if not texts:
        return None
    if list(texts) == ["channel"]:
        return "channel"
    return [[pattern.strip() for pattern in text.split(",")] for text in texts]
