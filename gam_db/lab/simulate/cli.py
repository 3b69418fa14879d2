"""``gam simulate``: series to try gam-db on, seeded, with the truth about them in a table beside."""

from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console
from rich.progress import track

from gam_db import langevin
from gam_db.cli.progress import interruptible
from gam_db.errors import ConfigurationError
from gam_db.lab.simulate.fleet import SAMPLES, Fleet, robots_of
from gam_db.lab.simulate.outcomes import outcomes_of
from gam_db.lab.simulate.roles import GROUP
from gam_db.lab.simulate.single import langevin_truth
from gam_db.lab.simulate.store import (
    DATABASE_ENDINGS,
    TABLE,
    check_outcomes,
    check_target,
    store_fleet,
    store_outcomes,
    store_series,
    truth_of,
)

simulate = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    help="Simulate a fleet of robots, or the system of the paper.\n\nThe truth about each series is "
    "written beside it.",
)

OutOption = Annotated[
    Path,
    typer.Option(
        metavar="FILE", help="NAME.parquet (truth: NAME.truth.parquet), or a .duckdb file; replaced."
    ),
]
TableOption = Annotated[
    str, typer.Option(help="Table of the .duckdb file (truth: TABLE_truth).", show_default=True)
]
SeedOption = Annotated[int, typer.Option(min=0, help="Of all random numbers.")]


@simulate.command()
def fleet(
    out: OutOption,
    robots: Annotated[int, typer.Option(min=1, help="Robots 1 to N, six joints each.")] = GROUP,
    only: Annotated[
        str | None, typer.Option(metavar="N,N", help="Only these robots, the same as in the fleet.")
    ] = None,
    samples: Annotated[int, typer.Option(help="Instants per joint, at 5 Hz.")] = SAMPLES,
    products: Annotated[
        int,
        typer.Option(
            min=1,
            help="Products that each robot makes, in shifts of a thirtieth of the samples. With 2 or "
            "more the column product says which one; each is half as frequent as the one before.",
        ),
    ] = 1,
    seed: SeedOption = 0,
    table: TableOption = TABLE,
    outcomes: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="Also write what became of the robots, as gam evaluate --outcomes takes it: a name in "
            ".csv or .parquet; replaced.",
        ),
    ] = None,
) -> None:
    """Write robots that wear, rest, are reprogrammed and send dirty rows. Hours stand for months.

    Of every 24 robots five fail, sixteen are healthy and three change without any fault; the truth
    says which, how and from when. At the default size: 39 million rows.
    """
    check_target(out)
    if outcomes is not None:
        check_outcomes(outcomes)
    simulated = Fleet(seed, samples, products=products)
    numbers = list(robots_of(robots)) if only is None else _numbers(only)
    screen = Console(stderr=True)
    with interruptible():
        progress = track(
            numbers, "robots", console=screen, transient=True, disable=not screen.is_terminal
        )
        rows, truths = store_fleet(simulated, progress, out, table)
        if outcomes is not None:
            store_outcomes(outcomes_of(truths), outcomes)
    _tell(rows, out, table)
    if outcomes is not None:
        typer.echo(f"outcomes: {outcomes}")


@simulate.command("langevin")
def langevin_system(
    out: OutOption,
    samples: Annotated[int, typer.Option(help="Steps.")] = langevin.SAMPLES,
    seed: SeedOption = 0,
    table: TableOption = TABLE,
) -> None:
    """Write the paper's multi-stable Langevin system: healthy for 40 %, then wearing to the end.

    Its numbers, which the paper leaves open, were chosen with the paper's row for Discrete Support
    Estimation in view.
    """
    check_target(out)
    with interruptible():
        store_series(langevin.series(seed, samples), langevin_truth(samples), out, table)
    _tell(samples, out, table)


def _numbers(only: str) -> list[int]:
    parts = [part.strip() for part in only.split(",")]
    if not all(part.isascii() and part.isdigit() and int(part) for part in parts):
        raise ConfigurationError(f"--only is {only!r}; it takes numbers of robots from 1, such as 2,22.")
    return sorted({int(part) for part in parts})


def _tell(rows: int, out: Path, table: str) -> None:
    where = f"{out}, table {table}" if out.suffix in DATABASE_ENDINGS else str(out)
    typer.echo(f"{rows:,} readings: {where}")
    typer.echo(f"truth: {truth_of(out, table)}")
