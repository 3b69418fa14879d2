"""``gam reproduce``: the paper's experiments, run again, beside the paper's numbers."""

import textwrap
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer
from rich.console import Console

from gam_db.cli.progress import interruptible
from gam_db.errors import ConfigurationError, nearest
from gam_db.lab.estimators import DSE
from gam_db.lab.reproduce import figures as drawings
from gam_db.lab.reproduce import fleet_page, page
from gam_db.lab.reproduce import fleet_tables as tables
from gam_db.lab.reproduce import recordings as recorded
from gam_db.lab.reproduce import sensitivity as sensed
from gam_db.lab.reproduce import table2 as langevin
from gam_db.lab.reproduce import training as lengths
from gam_db.lab.reproduce.methods import LONG_METHODS, METHODS, chosen
from gam_db.lab.reproduce.results import FOLDER, Results, Show
from gam_db.lab.simulate.roles import JOINTS

reproduce = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    help="Run the experiments of the paper again.\n\nResults are stored as files and reused, so an "
    "interrupted experiment continues.",
)

ResultsOption = Annotated[
    Path, typer.Option(metavar="FOLDER", help="Where results are kept, a small file for each run.")
]
QuickOption = Annotated[bool, typer.Option("--quick", help="Short and hardly trained; no evidence.")]
MethodsOption = Annotated[str | None, typer.Option(metavar="A,B", help=f"Some of {', '.join(METHODS)}.")]
FleetsOption = Annotated[int, typer.Option(min=1, help="Seeds 0, 1, ... of fleet and method.")]
JointsOption = Annotated[
    int | None,
    typer.Option(
        min=0, max=JOINTS, help="Of each healthy robot; fewer take less time, 0 leaves Disc out."
    ),
]

_WIDTH = 100


@reproduce.command()
def table1(
    methods: MethodsOption = None,
    seeds: FleetsOption = 1,
    healthy_joints: JointsOption = None,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Compare all methods on the simulated fleet (the paper's first table). Networks take hours."""
    names = chosen(methods, list(METHODS))
    with interruptible(), _shown() as show:
        table = tables.table1(names, seeds, quick, Results(results), show, healthy_joints)
    _print(fleet_page.fleet_table(table))


@reproduce.command()
def table2(
    methods: MethodsOption = None,
    seeds: Annotated[int, typer.Option(min=1, help="Seeds 0, 1, ... of simulation and method.")] = 5,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Compare all methods on the Langevin system (the paper's second table). Networks take minutes."""
    names = chosen(methods, list(METHODS))
    with interruptible(), _shown() as show:
        table = langevin.table2(names, seeds, quick, Results(results), show)
    _print(page.table2(table))


@reproduce.command()
def table3(
    methods: Annotated[
        str | None, typer.Option(metavar="A,B", help=f"Some of {', '.join([DSE, *LONG_METHODS])}.")
    ] = None,
    seeds: FleetsOption = 1,
    healthy_joints: JointsOption = tables.HEALTHY_JOINTS,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Compare networks that read a long context with DSE (the paper's third table). Takes hours."""
    there = [DSE, *LONG_METHODS]
    names = chosen(methods, there, there)
    with interruptible(), _shown() as show:
        table = tables.table3(names, seeds, quick, Results(results), show, healthy_joints)
    _print(fleet_page.fleet_table(table))


@reproduce.command()
def training(
    methods: Annotated[
        str, typer.Option(metavar="A,B", help="Networks of the table of the Langevin system.")
    ] = ",".join(lengths.NETWORKS),
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Train networks for 1, 5, 20 and 100 epochs: how the order of methods depends on it."""
    networks = [name for name, method in METHODS.items() if method.library == "torch"]
    names = chosen(methods, networks, networks)
    with interruptible(), _shown() as show:
        study = lengths.training(names, quick, Results(results), show)
    _print(fleet_page.training(study))


@reproduce.command()
def figures(
    out: Annotated[
        Path, typer.Option(metavar="FOLDER", help="Where the drawings (SVG) go; made if not there.")
    ] = Path("figures"),
    only: Annotated[
        str | None, typer.Option(metavar="N,N", help="Some of 2, 3, 4, 5, 6, as the paper numbers them.")
    ] = None,
    methods: MethodsOption = None,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Draw the paper's figures from results; what has no result yet is run."""
    names = chosen(methods, list(METHODS))
    numbers = list(drawings.FIGURES) if only is None else [part.strip() for part in only.split(",")]
    for number in numbers:
        if number not in drawings.FIGURES:
            raise ConfigurationError(
                f"--only is {only!r}; it takes some of {', '.join(drawings.FIGURES)}."
            )
    with interruptible(), _shown() as show:
        files = drawings.figures(numbers, out, names, quick, Results(results), show)
    _print(map(str, files))


@reproduce.command()
def recordings(
    data: Annotated[
        Path,
        typer.Option(
            metavar="FOLDER",
            envvar="GAM_TEST_DATA",
            help="Folder of the recordings, with production_plant and femto_bearings in it.",
        ),
    ],
    only: Annotated[
        str | None, typer.Option(metavar="A,B", help=f"Some of {', '.join(recorded.RECORDINGS)}.")
    ] = None,
    methods: Annotated[
        str | None,
        typer.Option(metavar="A,B", help=f"Some of {', '.join(METHODS)}; default: the cheap ones."),
    ] = None,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Compare methods on real machines that ran to failure, beside the level of chance."""
    names = chosen(methods, [name for name, method in METHODS.items() if method.cheap])
    sets = [part.strip() for part in (only or ",".join(recorded.RECORDINGS)).split(",")]
    for name in sets:
        if name not in recorded.RECORDINGS:
            raise ConfigurationError(
                f"--only does not know {name!r}{nearest(name, recorded.RECORDINGS)}"
            )
    with interruptible(), _shown() as show:
        rows = recorded.recordings(data, sets, names, quick, Results(results), show)
    _print(page.recordings(rows))


@reproduce.command()
def sensitivity(
    on: Annotated[str, typer.Option(help="fleet or langevin.")] = sensed.FLEET,
    quick: QuickOption = False,
    results: ResultsOption = FOLDER,
) -> None:
    """Vary m and tau: Global, and what the certificate says of it from calibration alone."""
    if on not in (sensed.FLEET, sensed.LANGEVIN):
        raise ConfigurationError(f"--on is {on!r}; it takes {sensed.FLEET} or {sensed.LANGEVIN}.")
    with interruptible(), _shown() as show:
        cells = sensed.sensitivity(on, quick, Results(results), show)
    _print(page.sensitivity_page(on, cells, quick))


@contextmanager
def _shown() -> Iterator[Show]:
    """Yield what shows a line of progress on stderr; nothing unless that is a terminal."""
    screen = Console(stderr=True)
    if not screen.is_terminal:
        yield lambda text: None
        return
    with screen.status("") as status:
        yield status.update


def _print(lines: Iterable[str]) -> None:
    for line in lines:
        # Only sentences are folded: a table's line stays one.
        long = len(line) > _WIDTH and "  " not in line.strip()
        indent = " " * (len(line) - len(line.lstrip()))
        typer.echo(textwrap.fill(line, _WIDTH, subsequent_indent=indent) if long else line)
