"""``gam compile``: the SQL script of a form, for a warehouse that runs it without Python.

This module owns the command; :mod:`gam_db.script` makes the script.
"""

import dataclasses
from pathlib import Path
from typing import Annotated, Literal

import typer

from gam_db import look
from gam_db.cli import options
from gam_db.config import Settings, SourceSettings
from gam_db.connecting import connect
from gam_db.engines import NAMES
from gam_db.errors import ConfigurationError, SourceError
from gam_db.guess import guess
from gam_db.script import render
from gam_db.source import AnySource, Source, WideSource, is_file

Form = Literal["exact", "view"]
Kind = Literal["timestamp", "counter"]


def compile_script(
    source: options.SourceArgument = None,
    form: Annotated[
        Form, typer.Option(help="exact: one query. view: tables of what was learnt, and a view.")
    ] = "view",
    engine: Annotated[str, typer.Option(help=f"One of {', '.join(NAMES)}.")] = "duckdb",
    database: options.DatabaseOption = None,
    config: options.ConfigOption = None,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Where the script goes; default: printed.")
    ] = None,
    prefix: Annotated[str, typer.Option(help="Begins the names of tables and views.")] = "gam_live_",
    schema: Annotated[
        str | None,
        typer.Option(help="Schema of tables and views (default: the current one; postgres: public)."),
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
    calibration_fraction: options.FractionOption = None,
    calibration_duration: options.DurationOption = None,
    calibrate: options.CalibrateOption = None,
    exclude: options.ExcludeOption = None,
    score_from: options.ScoreFromOption = None,
    pool: options.PoolOption = None,
) -> None:
    """Print the complete SQL script that computes the health indicator of SOURCE on an engine.

    SOURCE is a table of that engine. Its columns are looked at where gam can see them (a file, or a
    table of --database); elsewhere they are called asset, channel, time and value unless named.
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
        calibration_fraction=calibration_fraction,
        calibration_duration=calibration_duration,
        calibrate=calibrate,
        exclude=exclude,
        score_from=score_from,
        pool=pool,
    )
    if time_kind is not None:
        said = dataclasses.replace(settings.source, time_kind=time_kind)
        settings = dataclasses.replace(settings, source=said)
    parameters, calibration = settings.method()
    script = render(form, engine, described(settings), parameters, calibration, prefix, schema)
    if out is None:
        print(script, end="")
        return
    try:
        out.write_text(script, encoding="utf-8")
    except OSError as error:
        raise ConfigurationError(f"{out} cannot be written: {error.strerror}.") from error


def described(settings: Settings) -> AnySource:
    """Return the source with its columns: looked at where it can be seen, else as named.

    Raises:
        UserError: no source was named, or what can be seen of it cannot be used.
    """
    relation, database = settings.source.relation, settings.source.database
    if relation is None:
        raise ConfigurationError("Name a SOURCE: the table that the engine holds, or a file.")
    if database is None and not is_file(relation):
        return _as_named(relation, settings.source)
    with connect(database, writable=False) as session:
        columns = session.describe(session.relation(relation))
        source = guess(relation, columns, settings.source, session).source
        kind = look.kind_of(source, columns, session)
    return dataclasses.replace(source, time_kind="counter" if kind.is_counter else "timestamp")


def _as_named(relation: str, said: SourceSettings) -> AnySource:
    asset = None if said.asset is False else said.asset or "asset"
    time = said.time or "time"
    if said.layout == "wide" or said.channels is not None:
        if not said.channels:
            raise SourceError(
                "A wide table that gam cannot see needs its signals named: --channel COLUMN, repeated."
            )
        return WideSource(relation, said.channels, asset, time, said.where, said.time_kind)
    channel = None if said.channel is False else said.channel or "channel"
    return Source(
        relation, asset, channel, time, said.value or "value", said.where, time_kind=said.time_kind
    )
