"""The list of commands: which there are, in which panel, and where each is.

This module owns that list. A command is imported when it is run. Those of the laboratory come by the
entry points ``gam_db.commands``, so that nothing here imports it.
"""

import importlib
from collections.abc import Iterable
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import typer
from typer.core import TyperCommand
from typer.main import get_command

from gam_db.errors import ConfigurationError

WATCH, ONCE, LABORATORY = "Watch", "Once", "Laboratory"

#: panel -> where each of its commands is in gam_db.cli -> the first sentence of its help
COMMANDS = {
    WATCH: {
        "look:check": "Look at SOURCE before anything is learnt of it: what it is like, what to fix, "
        "what to set.",
        "look:init": "Write a commented gam.toml for SOURCE: its columns, and parameters with the "
        "reason for each.",
        "state:migrate": "Make the state tables in a database, or bring those of an older gam-db up "
        "to date.",
        "watch:calibrate": "Learn the healthy part of every channel of SOURCE and freeze it in the "
        "database.",
        "watch:score": "Score what is new since the last run, and what came late, of every calibrated "
        "channel.",
        "watch:status": "Say how every channel is: verdict, floor, indicator, trend, and what is "
        "wrong with its data.",
        "alarms:alarms": "Say which signals are raised: since when, how sure, and what to decide.",
        "alarms:alarm": "Say all that is known of one episode: its judgements, and where the "
        "signal went.",
        "alarms:label": "Keep what is known of an episode, or of a machine in an interval of time.",
        "alarms:limits": "Say by what each channel is judged, or why it is not.",
        "report:report": "Write the page for people who look: which machines left health, since when, "
        "and where they went.",
        "state:prune": "Delete old buckets, novel cells, versions and records of runs; say how large "
        "each channel is.",
        "state:compact": "Delete rows that nobody sees: hidden by a later run, or left by one that "
        "was cut short.",
        "state:drop": "Remove the state tables of a schema and prefix, or with --name the rows of one "
        "monitor.",
    },
    ONCE: {
        "once:run": "Compute the health indicator of every channel of SOURCE, print what was found, "
        "write the table.",
        "once:demo": "Simulate a machine that wears out, and print what `gam run` prints of it. "
        "Writes nothing.",
        "backtest:backtest": "Count how often the limits raise what follows calibration, where nothing "
        "was wrong.",
        "choose:select": "Choose delay, embedding dimension, bins and window for every channel of "
        "SOURCE.",
        "warehouse:compile": "Print the complete SQL script that computes the health indicator of "
        "SOURCE on an engine.",
        "warehouse:export": "Write the method as a package of another tool.",
        "warehouse:engines": "Tell which engines gam-db writes SQL for, and what is known of each at "
        "work.",
    },
}

#: The same sentence of the laboratory's commands, so that help reads nothing of the laboratory.
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
    said = [
        (place.partition(":")[2], sentence, panel)
        for panel, commands in COMMANDS.items()
        for place, sentence in commands.items()
    ]
    for found in laboratory():
        said.append(
            (found.name, OF_LABORATORY.get(found.name, f"Comes from {found.module}."), LABORATORY)
        )
    for name, sentence, panel in said:
        yield TyperCommand(name, help=sentence, rich_help_panel=panel, rich_markup_mode="markdown")


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
