"""The paper's tables of its industrial fleet, on the simulated one: all methods, and long contexts."""

import statistics
from collections.abc import Sequence
from dataclasses import dataclass, replace

from gam_db.lab.estimators import DSE
from gam_db.lab.reproduce.bootstrap import Paired, paired
from gam_db.lab.reproduce.fleet import FULL, QUICK, Plan, measured
from gam_db.lab.reproduce.methods import check_libraries
from gam_db.lab.reproduce.paper import printed
from gam_db.lab.reproduce.results import Results, Show
from gam_db.lab.reproduce.table2 import agreement

METRICS = ("mon", "corr", "rob", "prog", "disc", "global")
SPREAD = ("mon", "corr", "rob")

HEALTHY_JOINTS = 1
"""Joints of each healthy robot in the table of long contexts, whose networks are dear."""


@dataclass(frozen=True)
class Row:
    """One method over the fleets.

    Attributes:
        method: its name.
        mean: of each metric over the fleets; None where no fleet has it.
        spread: the standard deviation of Mon, Corr and Rob over the joints that failed, mean over the
            fleets.
        seconds: from the raw table of a joint to its indicator: mean and standard deviation over the
            joints.
    """

    method: str
    mean: dict[str, float | None]
    spread: dict[str, float | None]
    seconds: tuple[float, float]


@dataclass(frozen=True)
class FleetTable:
    """A table of the fleet, and what stands below it.

    Attributes:
        number: of the paper's table.
        rows: a row per method, best Global first.
        seeds: how many fleets there were.
        plan: which part of each, and by which settings.
        joints: how many failed, and how many of healthy robots, over all fleets.
        paired: the paired bootstrap; its first method is DSE where it is there.
        agreement: Spearman's correlation of our order with the paper's; None below 3 methods.
    """

    number: int
    rows: list[Row]
    seeds: int
    plan: Plan
    joints: tuple[int, int]
    paired: Paired
    agreement: float | None


def table1(
    names: Sequence[str],
    seeds: int,
    quick: bool,
    results: Results,
    show: Show,
    healthy_joints: int | None = None,
) -> FleetTable:
    """Run what has no result yet, and return the table of all methods.

    Args:
        names: methods.
        seeds: fleets 0, 1, ...; a seed is of the simulation and of the method.
        quick: fewer robots, shorter series, training for a moment: no evidence.
        results: where results are kept.
        show: told what is at work.
        healthy_joints: of each healthy robot; None for all six (quick: one).

    Raises:
        UserError: see its subclasses.
    """
    return _table(1, names, seeds, _plan(quick, healthy_joints), results, show)


def table3(
    names: Sequence[str],
    seeds: int,
    quick: bool,
    results: Results,
    show: Show,
    healthy_joints: int | None = HEALTHY_JOINTS,
) -> FleetTable:
    """Run what has no result yet, and return the table of long contexts; as :func:`table1`."""
    return _table(3, names, seeds, _plan(quick, healthy_joints), results, show)


def _plan(quick: bool, healthy_joints: int | None) -> Plan:
    plan = QUICK if quick else FULL
    return plan if healthy_joints is None else replace(plan, healthy_joints=healthy_joints)


def _table(
    number: int, names: Sequence[str], seeds: int, plan: Plan, results: Results, show: Show
) -> FleetTable:
    check_libraries(names)
    names = sorted(names, key=lambda name: name != DSE)
    fleets = [measured(plan, seed, names, results, show) for seed in range(seeds)]
    places = [place for seed in range(seeds) for place in plan.places(seed)]
    rows = []
    for name in names:
        runs = [fleet[name] for fleet in fleets]
        seconds = [number for figures in runs for number in figures["seconds"]]
        rows.append(
            Row(
                method=name,
                mean={m: _mean([figures["metrics"][m] for figures in runs]) for m in METRICS},
                spread={m: _mean([figures["spread"][m] for figures in runs]) for m in SPREAD},
                seconds=(statistics.fmean(seconds), statistics.pstdev(seconds)),
            )
        )
    rows.sort(key=lambda row: -(row.mean["global"] or 0.0))
    theirs = [name for name in printed(number) if name in names]
    return FleetTable(
        number=number,
        rows=rows,
        seeds=seeds,
        plan=plan,
        joints=(sum(place.fails for place in places), sum(not place.fails for place in places)),
        paired=paired([{name: fleet[name]["channels"] for name in names} for fleet in fleets]),
        agreement=agreement([row.method for row in rows if row.method in theirs], theirs),
    )


def _mean(values: Sequence[float | None]) -> float | None:
    there = [value for value in values if value is not None]
    return statistics.fmean(there) if there else None
