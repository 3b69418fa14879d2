"""The paper's table of the Langevin system: every method, some seeds, beside the paper's numbers."""

import statistics
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from gam_db import langevin
from gam_db.lab.reproduce.evaluated import chance, summary
from gam_db.lab.reproduce.methods import METHODS, Task, check_libraries, health
from gam_db.lab.reproduce.paper import TABLE2
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import MIN_MAX, Parameters
from gam_db.settings.source import Source

NUMBERS = ("mon", "corr", "rob", "global_score")
QUICK_SAMPLES = 40_000

_PARAMETERS = Parameters(
    m=langevin.M, tau=langevin.TAU, bins=langevin.BINS, window=langevin.WINDOW, range=MIN_MAX
)
_STRIDE = 100


@dataclass(frozen=True)
class Row:
    """One method over the seeds.

    Attributes:
        method: its name.
        mean, spread: of each number over the seeds; the spread is the standard deviation (ddof 1), None
            with one seed.
        seconds: median, from the raw table to the health indicator.
    """

    method: str
    mean: dict[str, float]
    spread: dict[str, float | None]
    seconds: float


@dataclass(frozen=True)
class Table:
    """The table, and what stands below it.

    Attributes:
        rows: a row per method, best Global first.
        seeds: how many there were.
        samples: steps of each simulation.
        windows: windows of the indicator that do not overlap.
        chance: mean of each number for random novelty.
        agreement: Spearman's correlation of our order with the paper's; None below 3 methods.
        quick: whether everything was shortened.
    """

    rows: list[Row]
    seeds: int
    samples: int
    windows: int
    chance: dict[str, float]
    agreement: float | None
    quick: bool


def table2(methods: Sequence[str], seeds: int, quick: bool, results: Results, show: Show) -> Table:
    """Run what has no result yet, and return the table.

    Args:
        methods: names, out of METHODS.
        seeds: seeds 0, 1, ...; a seed is of the simulation and of the method.
        quick: a fifth of the steps, and training for a moment: to see that it works, no evidence.
        results: where results are kept.
        show: told what is at work.

    Raises:
        UserError: see its subclasses.
    """
    check_libraries(methods)
    runs_by_method: dict[str, list[Figures]] = {name: [] for name in methods}
    for seed in range(seeds):
        for name in methods:
            runs_by_method[name].append(figures_of(name, Task(seed, quick), results, show))
    rows = sorted(
        (_row(name, figures) for name, figures in runs_by_method.items()),
        key=lambda row: -row.mean["global_score"],
    )
    of_chance = [figures["chance"] for runs in runs_by_method.values() for figures in runs]
    return Table(
        rows=rows,
        seeds=seeds,
        samples=_samples(quick),
        windows=runs_by_method[methods[0]][0]["windows"],
        chance={
            metric: statistics.fmean(figures[metric] for figures in of_chance)
            for metric in ("mon", "corr", "rob")
        },
        agreement=agreement([row.method for row in rows], list(TABLE2)),
        quick=quick,
    )


def figures_of(name: str, task: Task, results: Results, show: Show) -> Figures:
    """Return the figures of a method on the system of a seed; where there is no result yet, it is run.

    Returns:
        The NUMBERS, ``chance``, ``values`` (of the indicator), ``windows`` (that do not overlap),
        ``last_hi``, ``seconds`` and ``losses`` (a number for each epoch).
    """
    title = f"{METHODS[name].title}, seed {task.seed}"
    length = "" if task.epochs is None else f"-{task.epochs}-epochs"
    show(title + length.replace("-", " "))
    file = f"table2{'-quick' if task.quick else ''}/{name}-{task.seed}{length}"
    return results.get(file, _settings(name, task), lambda: _run(name, task, title, show))


def agreement(ours: Sequence[str], theirs: Sequence[str]) -> float | None:
    """Return Spearman's correlation of two orders of the same methods; None below three of them."""
    if len(ours) < 3:
        return None
    theirs = [name for name in theirs if name in ours]
    places = [theirs.index(name) for name in ours]
    return float(np.corrcoef(np.arange(len(places)), places)[0, 1])


def _samples(quick: bool) -> int:
    return QUICK_SAMPLES if quick else langevin.SAMPLES


def _settings(name: str, task: Task) -> dict[str, Any]:
    return {
        "experiment": "table2",
        "method": name,
        "seed": task.seed,
        "samples": _samples(task.quick),
        "calibration_fraction": langevin.CALIBRATION,
        "m": _PARAMETERS.m,
        "tau": _PARAMETERS.tau,
        "bins": _PARAMETERS.bins,
        "window": _PARAMETERS.window,
        **METHODS[name].settings(task),
    }


def _run(name: str, task: Task, title: str, show: Show) -> Figures:
    losses: list[float] = []

    def on_epoch(epoch: int, loss: float) -> None:
        losses.append(loss)
        show(f"{title}: epoch {epoch}, loss {loss:.2e}")

    source = Source(langevin.series(task.seed, _samples(task.quick)))
    calibration = Calibration(fraction=langevin.CALIBRATION)
    followed = replace(task, on_epoch=on_epoch)
    table, seconds = health(name, source, _PARAMETERS, calibration, followed)
    metrics, channels = summary(table)
    values = channels["k"][0].as_py()
    return {
        **{number: metrics["global" if number == "global_score" else number] for number in NUMBERS},
        "chance": chance(table, _STRIDE, _PARAMETERS.window),
        "values": values,
        "windows": (values + _PARAMETERS.window - 1) // _PARAMETERS.window,
        "last_hi": channels["last_hi"][0].as_py(),
        "seconds": seconds,
        "losses": losses,
    }


def _row(name: str, runs: Sequence[Figures]) -> Row:
    columns = {number: [run[number] for run in runs] for number in NUMBERS}
    return Row(
        method=name,
        mean={number: statistics.fmean(values) for number, values in columns.items()},
        spread={
            number: statistics.stdev(values) if len(values) > 1 else None
            for number, values in columns.items()
        },
        seconds=statistics.median(run["seconds"] for run in runs),
    )
