"""``gam benchmark``: what the SQL costs on this machine, beside its floor and the extract script."""

from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any

import typer
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

from gam_db.cli import options, render
from gam_db.errors import ConfigurationError, nearest
from gam_db.lab.benchmark import report
from gam_db.lab.benchmark.measure import Listener, Plan, measure
from gam_db.lab.benchmark.program_run import PROGRAMS
from gam_db.lab.benchmark.workload import ORDERS


def benchmark(
    channels: Annotated[int, typer.Option(min=1, help="Channels of the workload.")] = 12,
    samples: Annotated[int, typer.Option(min=100, help="Samples per channel.")] = 1_000_000,
    repeat: Annotated[int, typer.Option(min=1, help="Runs of each program in each case.")] = 3,
    threads: Annotated[str, typer.Option(help="Numbers of threads, with commas.")] = "1,2",
    order: Annotated[str, typer.Option(help=f"How rows lie: {', '.join(ORDERS)}.")] = "channel,time",
    only: Annotated[
        str | None, typer.Option(help=f"Run only some programs: {', '.join(PROGRAMS)}.")
    ] = None,
    explain: Annotated[
        bool, typer.Option("--explain", help="Show where gam-db's time goes, by step and operator.")
    ] = False,
    as_json: options.Json = False,
) -> None:
    """Measure gam-db from raw table to health indicator against the engine's floor and a script.

    Everything is simulated and stays in a temporary folder (about 1 GB at the default size).
    """
    plan = Plan(
        channels=channels,
        samples=samples,
        repeat=repeat,
        threads=tuple(counts("threads", threads)),
        orders=tuple(chosen("order", order, list(ORDERS))),
        programs=PROGRAMS if only is None else tuple(chosen("only", only, PROGRAMS)),
        explain=explain,
    )
    figures = shown(plan.runs, lambda on_run: measure(plan, on_run))
    print_figures(figures, report.lines, as_json)


def print_figures(
    figures: dict[str, Any], lines: Callable[[dict[str, Any]], Iterable[str]], as_json: bool
) -> None:
    """Print figures as JSON, or the lines that are made of them."""
    if as_json:
        render.print_json(figures)
    else:
        for line in lines(figures):
            typer.echo(line)


def shown(runs: int, work: Callable[[Listener], dict[str, Any]]) -> dict[str, Any]:
    """Do some work while a bar on stderr shows how many of its runs are done."""
    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeElapsedColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task("", total=runs)

        def show(run: str) -> None:
            # Called before a run: what is complete are the runs before it.
            progress.update(task, description=run, completed=next(begun))

        begun = iter(range(runs))
        return work(show)


def _parts(option: str, text: str) -> list[str]:
    parts = [part.strip() for part in text.split(",") if part.strip()]
    if not parts:
        raise ConfigurationError(f"--{option} is empty; give at least one value.")
    return list(dict.fromkeys(parts))


def chosen(option: str, text: str, allowed: Sequence[str]) -> list[str]:
    """Return the parts of an option's text, all of which must be known.

    Raises:
        ConfigurationError: one is not, or there is none.
    """
    parts = _parts(option, text)
    for part in parts:
        if part not in allowed:
            raise ConfigurationError(f"--{option} does not know {part!r}{nearest(part, allowed)}")
    return parts


def counts(option: str, text: str) -> list[int]:
    """Return the positive integers of an option's text.

    Raises:
        ConfigurationError: a part is none, or there is no part.
    """
    parts = _parts(option, text)
    for part in parts:
        if not (part.isascii() and part.isdigit() and int(part) > 0):
            raise ConfigurationError(f"--{option} is {part!r}; it takes positive integers, such as 1,2.")
    return [int(part) for part in parts]
