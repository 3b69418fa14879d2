"""``gam drop``: remove the state tables, or the rows of one monitor, after asking.

This module owns the command and its question; :mod:`gam_db.stored.dropping` does the work.
"""

from collections.abc import Sequence
from typing import Annotated

import typer

from gam_db.cli import monitor_options, options
from gam_db.errors import ConfigurationError
from gam_db.stored import dropping
from gam_db.stored.dropping import Removal
from gam_db.stored.tables import StateTables


def drop(
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: Annotated[
        str | None,
        typer.Option(
            metavar="MONITOR",
            help="Remove the rows of this monitor only; the tables and all others stay.",
        ),
    ] = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    yes: Annotated[bool, typer.Option("--yes", help="Do not ask.")] = False,
) -> None:
    """Remove the state tables of a schema and prefix, or with --name the rows of one monitor.

    It lists what would go and asks for the name to be typed. The source, a schema and other tables stay.
    """
    session, tables, _ = monitor_options.opened(
        file=config, database=database, schema=schema, prefix=prefix, must_exist=True
    )
    with session:
        found = dropping.removals(session, tables, name)
        if not yes:
            _show(tables, found, name)
            _ask(str(tables) if name is None else name)
        dropping.remove(session, found)
    print(f"removed: {tables}*" if name is None else f"removed: monitor {name} from {tables}*")


def _show(tables: StateTables, found: Sequence[Removal], name: str | None) -> None:
    print("This removes" if name is None else f"This removes, of monitor {name},")
    for removal in found:
        rows = "view" if removal.rows is None else f"{removal.rows} rows"
        print(f"  {tables.shown(removal.name):<32}  {rows}")


def _ask(expected: str) -> None:
    try:
        typed = typer.prompt(f"Type {expected} to remove it", default="", show_default=False)
    except typer.Abort:
        raise ConfigurationError(
            "Nothing was removed: nobody could be asked; say --yes if it is meant."
        ) from None
    if typed != expected:
        raise ConfigurationError(f"Nothing was removed: {expected} was not typed.")
