"""``gam migrate``: make the state tables, or bring those of an older gam-db up to date.

This module owns the command; :mod:`gam_db.stored.migrations` does the work.
"""

import datetime as dt
import json
from typing import Annotated

import typer

from gam_db.cli import monitor_options, options
from gam_db.engines import NAMES, engine_named
from gam_db.errors import ConfigurationError
from gam_db.stored import migrations
from gam_db.stored.migrations import Status
from gam_db.stored.roles import Roles
from gam_db.stored.tables import StateTables

PENDING = 2


def migrate(
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    status: Annotated[
        bool,
        typer.Option(
            "--status", help="Change nothing; say what was applied. Exit code 2: some are pending."
        ),
    ] = False,
    sql: Annotated[
        bool,
        typer.Option("--sql", help="Print the script, for a database administrator; open no database."),
    ] = False,
    engine: Annotated[
        str | None, typer.Option(help=f"With --sql: one of {', '.join(NAMES)} (default duckdb).")
    ] = None,
    grants: Annotated[
        str | None,
        typer.Option(
            metavar="owner=NAME,writer=NAME,reader=NAME",
            help="With --sql --engine postgres: let the tables belong to the owner, and give writer "
            "(calibrate, score, check, prune) and reader (status, views) what they need.",
        ),
    ] = None,
    as_json: monitor_options.JsonOption = False,
) -> None:
    """Make the state tables in a database, or bring those of an older gam-db up to date.

    It can be run at any time: what was applied is recorded and not applied again, and rows stay.
    """
    if sql and (status or as_json):
        raise ConfigurationError("--sql prints a script; leave out --status and --json.")
    if engine is not None and not sql:
        raise ConfigurationError("--engine says for which engine --sql prints; add --sql.")
    if grants is not None and not sql:
        raise ConfigurationError("--grants says what --sql prints besides; add --sql.")
    if sql:
        who = None if grants is None else Roles.parsed(grants)
        settings = monitor_options.said(file=config, schema=schema, prefix=prefix)
        script = migrations.rendered(engine_named(engine or "duckdb"), settings.monitor.tables, who)
        print(script, end="")
        return
    session, tables, _ = monitor_options.opened(
        file=config, database=database, schema=schema, prefix=prefix, writable=not status
    )
    with session:
        done = () if status else migrations.migrate(session, tables)
        found = migrations.status(session, tables)
    code = PENDING if found.pending else 0
    if as_json:
        print(json.dumps(_figures(tables, found, [one.number for one in done], code), indent=1))
    elif status:
        _show(tables, found)
    elif done:
        print(f"{tables}*: applied " + ", ".join(f"{one.number} {one.name}" for one in done))
    else:
        print(f"{tables}*: up to date, {len(found.applied)} migrations")
    if code:
        raise typer.Exit(code)


def _show(tables: StateTables, found: Status) -> None:
    for row in found.applied:
        when = dt.datetime.fromtimestamp(row.applied_at / 1e6, dt.UTC).strftime("%Y-%m-%d %H:%M UTC")
        print(f"{row.number:4}  {row.name:<16}  {when}  gam-db {row.gam_version}")
    for migration in found.pending:
        print(f"{migration.number:4}  {migration.name:<16}  pending")
    if found.pending:
        print(f"{tables}*: {len(found.pending)} pending; run `gam migrate`")
    else:
        print(f"{tables}*: up to date")


def _figures(tables: StateTables, found: Status, done: list[int], code: int) -> dict[str, object]:
    return {
        "schema": tables.schema,
        "prefix": tables.prefix,
        "applied": [
            {
                "number": row.number,
                "name": row.name,
                "checksum": row.checksum,
                "applied_at": row.applied_at,
                "gam_version": row.gam_version,
            }
            for row in found.applied
        ],
        "applied_now": done,
        "pending": [{"number": one.number, "name": one.name} for one in found.pending],
        "exit_code": code,
    }
