"""``gam benchmark alarms|programs``: is the stated rate of false alarms kept, and is wear seen?"""

from typing import Annotated

import typer

from gam_db.cli import options
from gam_db.errors import ConfigurationError
from gam_db.lab.benchmark.alarms import programs as of_programs
from gam_db.lab.benchmark.alarms.measure import measure
from gam_db.lab.benchmark.alarms.plan import ROBOTS, Plan
from gam_db.lab.benchmark.alarms.report import lines
from gam_db.lab.benchmark.cli import counts, print_figures, shown
from gam_db.lab.simulate.fleet import SAMPLES


def alarms(
    fleets: Annotated[int, typer.Option(min=1, help="How many fleets are simulated.")] = 4,
    seed: Annotated[int, typer.Option(min=0, help="Of the first fleet; the next ones count on.")] = 9100,
    everything: Annotated[
        bool, typer.Option("--all", help="Also other estimators, drift, and two products in shifts.")
    ] = False,
    quick: Annotated[
        bool, typer.Option("--quick", help="All paths on little data; judges nothing.")
    ] = False,
    as_json: options.Json = False,
) -> None:
    """Measure whether the stated rate of false alarms is kept, and how early wear is seen.

    Limits, judgements and episodes are the product's own, over simulated fleets: 21 robots each, of
    which five wear.
    """
    if quick and everything:
        raise ConfigurationError("--quick runs all paths; give it without --all.")
    seeds = tuple(range(seed, seed + fleets))
    plan = Plan.quick(seeds[:1]) if quick else Plan(seeds, everything)
    print_figures(shown(plan.runs, lambda on_run: measure(plan, on_run)), lines, as_json)


def programs(
    seeds: Annotated[str, typer.Option(help="Of the fleets, with commas.")] = "1,2,3",
    products: Annotated[
        int, typer.Option(min=2, help="Products that each robot makes, in long shifts.")
    ] = 3,
    robots: Annotated[int, typer.Option(min=1, help="Robots of each fleet.")] = ROBOTS,
    samples: Annotated[int, typer.Option(help="Instants per joint.")] = SAMPLES,
    shift: Annotated[int, typer.Option(min=1, help="Instants of a shift.")] = 10_000,
    as_json: options.Json = False,
) -> None:
    """Measure false alarms and wear of machines with several products, with and without --program.

    Both ways judge the same rows: simulated robots that make several products in shifts. Some of them
    wear.
    """
    plan = Plan(tuple(counts("seeds", seeds)), robots=robots, samples=samples)
    print_figures(
        shown(len(plan.seeds), lambda on_run: of_programs.measure(plan, products, shift, on_run)),
        of_programs.lines,
        as_json,
    )
