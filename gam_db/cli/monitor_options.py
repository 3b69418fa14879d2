"""Options of the commands that work with the state in a database, and what they open.

This module owns the words of the command line; :mod:`gam_db.config` owns what they are laid over.
"""

import os
from pathlib import Path
from typing import Annotated

import typer

from gam_db import config
from gam_db.address import VARIABLE, check, is_url
from gam_db.config import Settings
from gam_db.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, EngineError
from gam_db.stored.tables import StateTables

_STATE = "Where the state lies"

DatabaseOption = Annotated[
    str | None,
    typer.Option(
        metavar="ADDRESS",
        help="Database that holds the state, and the source if that is a table: a DuckDB file, which is "
        "made if it is not there, or a URL such as postgresql://HOST/DATABASE. Default: the environment "
        f"variable {VARIABLE}, or what gam.toml says.",
        rich_help_panel=_STATE,
    ),
]
NameOption = Annotated[
    str | None,
    typer.Option(metavar="MONITOR", help="Monitor (default 'default').", rich_help_panel=_STATE),
]
SchemaOption = Annotated[
    str | None,
    typer.Option(help="Schema of the state tables (default: the current one).", rich_help_panel=_STATE),
]
PrefixOption = Annotated[
    str | None, typer.Option(help="Begins their names (default 'gam_').", rich_help_panel=_STATE)
]
JsonOption = Annotated[bool, typer.Option("--json", help="Print figures as JSON, for scripts.")]
QuietOption = Annotated[bool, typer.Option("--quiet", "-q", help="Print nothing but errors.")]


def said(
    *,
    file: Path | None,
    database: str | None = None,
    name: str | None = None,
    schema: str | None = None,
    prefix: str | None = None,
) -> Settings:
    """Return the settings of the file with the options of a command laid over them.

    Raises:
        ConfigurationError: the file or an option cannot be used.
    """
    return config.load(file).under(
        {"database": database or os.environ.get(VARIABLE)},
        {},
        {},
        {"name": name, "schema": schema, "prefix": prefix},
    )


def opened(
    *,
    file: Path | None,
    database: str | None,
    name: str | None = None,
    schema: str | None = None,
    prefix: str | None = None,
    threads: int | None = None,
    writable: bool = True,
    must_exist: bool = False,
) -> tuple[Session, StateTables, Settings]:
    """Open the database that holds the state.

    Args:
        file: the settings file, as given.
        database: its address, as given; so the next four.
        name: of the monitor.
        schema: of the state tables.
        prefix: of their names.
        threads: processor threads.
        writable: whether the command writes; else the file is only read.
        must_exist: whether the file must be there already; it is never made to be read only.

    Returns:
        The session, to be used in a ``with`` statement; where the state lies; the settings.

    Raises:
        UserError: no database was named, it cannot be opened, or an option cannot be used.
    """
    settings = said(file=file, database=database, name=name, schema=schema, prefix=prefix)
    address = settings.source.database
    if address is None:
        raise ConfigurationError(
            "Say which database holds the state: --database FILE.duckdb, or a URL such as "
            "postgresql://HOST/DATABASE; or put database under [source] into gam.toml."
        )
    check(address)
    tables = settings.monitor.tables
    if must_exist and not is_url(address) and not Path(address).exists():
        raise EngineError(f"There is no database file {address}.")
    return connect(address, threads, writable), tables, settings
