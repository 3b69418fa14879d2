"""``gam benchmark alarms``: is the stated rate of false alarms kept, and is wear seen?"""

from typing import Annotated

import typer

from gam_db.cli import options
from gam_db.errors import ConfigurationError
from gam_db.lab.benchmark.alarms.measure import measure
from gam_db.lab.benchmark.alarms.plan import Plan
from gam_db.lab.benchmark.alarms.report import lines
from gam_db.lab.benchmark.cli import shown, told


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
    told(shown(plan.runs, lambda on_run: measure(plan, on_run)), lines, as_json)
