"""The list of commands: which there are, in which panel, and where each is.

This module owns that list. A command is imported when it is run. Those of the laboratory come by the
entry points ``gam_db.commands``, so that nothing here imports it.
"""

import importlib
import re
from collections.abc import Iterable
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import typer
from typer.core import TyperCommand
from typer.main import get_command

from gam_db import data
from gam_db.errors import wrong
from gam_db.extras import give_pandas

_LISTED: dict[str, dict[str, str]] = data.table("gam_db.cli", "commands.toml")

#: What help says of the laboratory's commands.
OF_LABORATORY = _LISTED["Laboratory"]

#: command of the core -> its module
MODULES = {**_LISTED["Watch"], **_LISTED["Once"]}


def laboratory() -> list[EntryPoint]:
    """Return the commands that come by entry points, by name."""
    return sorted(entry_points(group="gam_db.commands"), key=lambda entry: entry.name)


def listed() -> Iterable[TyperCommand]:
    """Return a stand-in of every command: its name, its panel and the first sentence of its help."""
    commands = [(name, _sentence(name), panel) for panel in ("Watch", "Once") for name in _LISTED[panel]]
    for entry in laboratory():
        sentence = OF_LABORATORY.get(entry.name, f"Comes from {entry.module}.")
        commands.append((entry.name, sentence, "Laboratory"))
    for name, sentence, panel in commands:
        yield TyperCommand(name, help=sentence, rich_help_panel=panel, rich_markup_mode="markdown")


def _sentence(name: str) -> str:
    """Return the first sentence of a command's help, read without importing its module."""
    text = data.text("gam_db.cli", f"{MODULES[name]}.py")
    begun = rf'^(?:def {name}\(.*?"""|{name} = typer\.Typer\([^)]*help=")'
    match = re.search(rf'{begun}([^"]+?)(?:\n\n|")', text, re.DOTALL | re.MULTILINE)
    assert match is not None, name
    return " ".join(match[1].split())


def loaded(name: str) -> Any:
    """Return the command itself; refuse one whose entry point names a module that is not there."""
    if name in MODULES:
        command = getattr(importlib.import_module(f"gam_db.cli.{MODULES[name]}"), name)
    else:
        give_pandas()
        entry = next(entry for entry in laboratory() if entry.name == name)
        try:
            command = entry.load()
        except ModuleNotFoundError as error:
            raise wrong("command_of_laboratory", name=name, module=entry.module) from error
    if isinstance(command, typer.Typer):
        return get_command(command)
    alone = typer.Typer(add_completion=False, rich_markup_mode="markdown")
    alone.command(name)(command)
    return get_command(alone)
