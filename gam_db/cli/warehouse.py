"""``gam compile`` and ``gam export``: for a warehouse that runs the method itself."""

import dataclasses
import sys
from pathlib import Path
from typing import Any, Literal

import typer

from gam_db import data
from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.cli.job import watched
from gam_db.cli.options import argument, option
from gam_db.clock import TimeKind
from gam_db.engines import NAMES, engine_named
from gam_db.engines.connecting import connect, engine_of
from gam_db.errors import ConfigurationError, unwritable, wrong
from gam_db.export import Package, write
from gam_db.export import grafana as dashboards
from gam_db.export.models import ADAPTERS
from gam_db.export.monitor import rendered
from gam_db.export.script import render, tells_calendar
from gam_db.method.parts import parts_of
from gam_db.reading import look
from gam_db.reading.guess import SourceSettings, guess
from gam_db.settings.source import AnySource, Source, WideSource, as_folder, is_file
from gam_db.stored.schema.tables import StateTables

Form = Literal["exact", "view", "monitor"]


UNPROBED = (
    "This SQL leaves out the probe: a channel with the verdict ready may still not show a change. "
    "Add the probe with --without nothing, or see it in gam run."
)
#: What a script assumes of a table that gam does not see.
ASSUMED = (
    "The script takes {time} for an integer counter, since gam does not see the table: give "
    "--time-kind timestamp if it is not one, or --database."
)


@options.taking(*options.READ, "time_kind", "name", "lookback", "park_after")
def compile(
    settings: Settings,
    relation: str | tuple[str, ...] | None,
    form: Form = option("compile.form", "view"),
    engine: str | None = option("compile.engine", names=", ".join(NAMES)),
    out: Path | None = option("compile.out"),
    prefix: str | None = option("compile.prefix"),
    schema: str | None = option("compile.schema"),
    without: list[str] | None = option("compile.without"),
) -> None:
    """Print the SQL script that computes the health indicator.

    SOURCE is a table of the engine. gam looks at its columns if it can read it (a file, a folder of
    files, or a table of --database); otherwise they are asset, channel, time and value unless you name
    them.

    With --form monitor it prints one run of a calibrated monitor of --database, without SOURCE. The
    command line of that database executes it again and again, without Python (docs/schedule.md).
    """
    if form == "monitor":
        if relation is not None:
            raise ConfigurationError("A monitor stores its source; leave out SOURCE.")
        about = settings.monitor
        schema = about.schema if schema is None else schema
        prefix = about.prefix if prefix is None else prefix
        about = dataclasses.replace(about, schema=schema, prefix=prefix)
        _write(_run_of(dataclasses.replace(settings, monitor=about), engine), out)
        return
    engine = engine_of(settings.source.database) if engine is None else engine
    parameters, calibration = settings.method()
    if settings.source.database is None and engine_named(engine).reads_files:
        located = dataclasses.replace(settings.source, relation=as_folder(settings.source.relation))
        settings = dataclasses.replace(settings, source=located)
    settings.source.check_conditions(engine_named(engine))
    source = described(settings, engine_named(engine).guard is not None)
    prefix = "gam_live_" if prefix is None else prefix
    parts = _parts(without)
    _write(render(form, engine, source, parameters, calibration, prefix, schema, parts), out)
    printed = parts_of(parameters, parts) if form == "view" else []
    if "certificate" in printed and "probe" not in printed:
        print(f"gam: {UNPROBED}", file=sys.stderr)
    is_seen = settings.source.database is not None or is_file(source.relation)
    if not (is_seen or source.time_kind or tells_calendar(parameters, calibration)):
        print(f"gam: {ASSUMED.format(time=source.time)}", file=sys.stderr)


def _run_of(settings: Settings, engine: str | None) -> str:
    """Return the script of one run of a monitor."""
    with options.opened(settings, writable=False) as session:
        if engine is not None and engine != session.engine.name:
            raise ConfigurationError(
                f"The monitor lies on {session.engine.name}; leave out --engine {engine}."
            )
        monitor, _ = watched(session, settings, None)
        return rendered(monitor)


def _write(script: str, out: Path | None) -> None:
    if out is None:
        print(script, end="")
        return
    try:
        data.put(out, script.encode())
    except OSError as error:
        raise unwritable(out, error) from error


def described(settings: Settings, tells_zones: bool = False) -> AnySource:
    """Return the source with its columns: looked at where it can be seen, else as named.

    A script may have to tell timestamps with a zone from those without one.
    """
    relation, database = settings.source.relation, settings.source.database
    if relation is None:
        raise ConfigurationError("Name a SOURCE: the table that the engine holds, or a file.")
    if database is None and not is_file(relation):
        return _as_named(relation, settings.source)
    with connect(database, writable=False) as session:
        columns = session.describe(session.relation(relation, settings.source))
        source = guess(relation, columns, settings.source, session).source
        kind = look.kind_of(source, columns, session)
    if not (tells_zones and kind is TimeKind.TIMESTAMP_WITH_ZONE):
        kind = TimeKind.COUNTER if kind.is_counter else TimeKind.TIMESTAMP
    return dataclasses.replace(source, time_kind=kind.value)


def _as_named(relation: Any, settings: SourceSettings) -> AnySource:
    asset = None if settings.asset is False else settings.asset or "asset"
    time = settings.time or "time"
    if settings.layout == "wide" or settings.channels is not None:
        if not settings.channels:
            raise wrong("unseen_wide_table")
        return WideSource(
            relation,
            settings.channels,
            asset,
            time,
            settings.where,
            settings.time_kind,
            **settings.written,
        )
    channel = None if settings.channel is False else settings.channel or "channel"
    value, kind = settings.value or "value", settings.time_kind
    return Source(relation, asset, channel, time, value, settings.where, kind, **settings.written)


export = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    help="Write a dbt package or a Grafana dashboard.",
)


@export.command()
@options.taking(
    *(*options.READ, "time_kind", "prefix", "lookback", "park_after"), but=("fraction", "duration")
)
def dbt(
    settings: Settings,
    folder: Path = argument("dbt.folder"),
    engine: str | None = option("dbt.engine", names=", ".join(ADAPTERS)),
    schema: str | None = option("dbt.schema"),
    without: list[str] | None = option("dbt.without"),
) -> None:
    """Write a dbt package that keeps the health indicator up to date.

    SOURCE is a table of the warehouse. gam looks at its columns if it can read it (a table of
    --database); otherwise they are asset, channel, time and value unless you name them. Calibration must
    be fixed: closed intervals, by --calibrate or in gam.toml. Files of an earlier export are replaced.
    """
    engine = engine_of(settings.source.database) if engine is None else engine
    settings.source.check_conditions(engine_named(engine))
    parameters, calibration = settings.method()
    monitor = settings.monitor
    parts = _parts(without)
    how = (engine, schema, monitor.prefix, monitor.lookback, monitor.park_after, parts)
    written = write(Package(described(settings), parameters, calibration, *how), folder)
    print(
        f"{len(written)} files of a dbt package are in {folder}; see README.md there. "
        "`dbt build` builds it."
    )
    if "probe" not in parts_of(parameters, parts):
        print(f"gam: {UNPROBED}", file=sys.stderr)


def _parts(without: list[str] | None) -> list[str] | None:
    """Return what the user leaves out; None where that follows from the settings."""
    return None if not without else [part for part in without if part != "nothing"]


@export.command()
def grafana(
    folder: Path = argument("grafana.folder"),
    engine: str = option("grafana.engine", "postgres", names=", ".join(dashboards.SOURCES)),
    schema: str | None = option("grafana.schema"),
    prefix: str = option("grafana.prefix", "gam_"),
    name: str = option("grafana.name", "default"),
    uid: str = option("grafana.uid", "gam-db"),
) -> None:
    """Write a Grafana dashboard and an alert rule for a monitor.

    Import the dashboard and choose its data source; the alert rule is a provisioning file. Both read
    only the views, with the rights of a reader.
    """
    paths = dashboards.write(engine, folder, StateTables(schema, prefix), name, uid)
    print(f"written: {', '.join(map(str, paths))}; docs/grafana.md explains where they go.")
