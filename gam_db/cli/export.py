"""``gam export``: the method as a package of another tool.

This module owns the command; :mod:`gam_db.export` writes the package.
"""

import dataclasses
from pathlib import Path
from typing import Annotated

import typer

from gam_db.cli import options
from gam_db.cli.compile import Kind, described
from gam_db.export import Package, write
from gam_db.export.adapters import ADAPTERS

export = typer.Typer(no_args_is_help=True, help="Write the method as a package of another tool.")


@export.callback()
def tools() -> None:
    """Write the method as a package of another tool."""


@export.command()
def dbt(
    folder: Annotated[
        Path,
        typer.Argument(metavar="DIR", help="Where the package goes; empty, or that of an earlier one."),
    ],
    source: options.SourceArgument = None,
    engine: Annotated[str, typer.Option(help=f"What dbt runs on: {', '.join(ADAPTERS)}.")] = "duckdb",
    database: options.DatabaseOption = None,
    config: options.ConfigOption = None,
    schema: Annotated[
        str | None, typer.Option(help="Of the source table; default: that of dbt's target.")
    ] = None,
    prefix: Annotated[
        str | None, typer.Option(help="Begins the names of models (default 'gam_').")
    ] = None,
    lookback: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="How late a row may come: seconds or a text like '1 h' (the default); steps of a "
            "counter (0).",
        ),
    ] = None,
    time_kind: Annotated[
        Kind | None, typer.Option(help="How the time column tells time, where it cannot be seen.")
    ] = None,
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
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
    score_from: options.ScoreFromOption = None,
    pool: options.PoolOption = None,
) -> None:
    """Write a dbt package that keeps the health indicator of SOURCE up to date in the warehouse.

    SOURCE is a table there. Its columns are looked at where gam can see them (a table of --database);
    elsewhere they are called asset, channel, time and value unless named. Calibration must be fixed:
    closed intervals, by --calibrate or in gam.toml. Files of an earlier export are replaced.
    """
    settings = options.settings(
        file=config,
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
        calibration_fraction=None,
        calibration_duration=None,
        calibrate=calibrate,
        exclude=exclude,
        score_from=score_from,
        pool=pool,
    )
    if time_kind is not None:
        said = dataclasses.replace(settings.source, time_kind=time_kind)
        settings = dataclasses.replace(settings, source=said)
    parameters, calibration = settings.method()
    kept = settings.monitor
    package = Package(
        described(settings),
        parameters,
        calibration,
        engine,
        schema,
        kept.prefix if prefix is None else prefix,
        kept.lookback if lookback is None else options.length(lookback),
        kept.park_after,
    )
    written = write(package, folder)
    print(
        f"{len(written)} files of a dbt package are in {folder}. README.md there says what it holds; "
        "`dbt build` builds it."
    )
