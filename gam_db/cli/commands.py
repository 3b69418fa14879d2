"""The list of commands: which there are, in which panel, and where each is.

This module owns that list. A command is imported when it is run. Those of the laboratory come by the
entry points ``gam_db.commands``, so that nothing here imports it.
"""

import importlib
import re
from collections.abc import Iterable
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from typing import Any

import typer
from typer.core import TyperCommand
from typer.main import get_command

from gam_db.errors import ConfigurationError

WATCH, ONCE, LABORATORY = "Watch", "Once", "Laboratory"

#: panel -> where each of its commands is in gam_db.cli
COMMANDS = {
    WATCH: (
        *("check:check", "init:init", "state:migrate", "calibrate:calibrate", "score:score"),
        *("status:status", "alarms:alarms", "alarms:alarm", "alarms:label", "alarms:limits"),
        *("report:report", "state:prune", "state:compact", "state:drop"),
    ),
    ONCE: (
        *("once:run", "demo:demo", "backtest:backtest", "choose:select"),
        *("warehouse:compile", "warehouse:export", "warehouse:engines"),
    ),
}

#: What help says of the laboratory's commands, so that it reads nothing of the laboratory.
OF_LABORATORY = {
    "benchmark": "Measure gam-db on this machine: throughput (the default), the stored form, and other "
    "engines.",
    "evaluate": "Measure how well the health indicators of HEALTH show wear (paper, Eq. 5 to 9).",
    "reproduce": "Run the paper's experiments again. Results are kept as files and used again, so that "
    "what was interrupted goes on where it was.",
    "simulate": "Write a simulated fleet of robots, or the paper's simulated system, with the truth "
    "about it.",
}


def laboratory() -> list[EntryPoint]:
    """Return the commands that come by entry points, by name."""
    return sorted(entry_points(group="gam_db.commands"), key=lambda found: found.name)


def places() -> dict[str, str]:
    """Return where each command of the core is, by its name."""
    return {place.partition(":")[2]: place for panel in COMMANDS.values() for place in panel}


def listed() -> Iterable[TyperCommand]:
    """Return a stand-in of every command: its name, its panel and the first sentence of its help."""
    said = [(name, _sentence(place)) for name, place in places().items()]
    said += [
        (found.name, OF_LABORATORY.get(found.name, f"Comes from {found.module}."))
        for found in laboratory()
    ]
    panels = {place: panel for panel, commands in COMMANDS.items() for place in commands}
    for name, sentence in said:
        panel = panels.get(places().get(name, ""), LABORATORY)
        yield TyperCommand(name, help=sentence, rich_help_panel=panel, rich_markup_mode="markdown")


def _sentence(place: str) -> str:
    """Return the first sentence of a command's help, read without importing its module."""
    module, _, name = place.partition(":")
    text = (Path(__file__).parent / f"{module}.py").read_text(encoding="utf-8")
    begun = rf'^(?:def {name}\(.*?"""|{name} = typer\.Typer\([^)]*help=")'
    found = re.search(rf'{begun}([^"]+?)(?:\n\n|")', text, re.DOTALL | re.MULTILINE)
    assert found is not None, place
    return " ".join(found[1].split())


def loaded(name: str) -> Any:
    """Return the command itself.

    Raises:
        ConfigurationError: it comes by an entry point whose module is not there.
    """
    if name in places():
        module, _, inside = places()[name].partition(":")
        found = getattr(importlib.import_module(f"gam_db.cli.{module}"), inside)
    else:
        entry = next(entry for entry in laboratory() if entry.name == name)
        try:
            found = entry.load()
        except ModuleNotFoundError as error:
            raise ConfigurationError(
                f"gam {name} is part of the laboratory ({entry.module}), which is not installed here."
            ) from error
    if isinstance(found, typer.Typer):
        return get_command(found)
    alone = typer.Typer(add_completion=False, rich_markup_mode="markdown")
    alone.command(name)(found)
    return get_command(alone)
