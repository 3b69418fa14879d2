"""Global over the embedding dimension and the delay, with the certificate's floor beside it.

The paper varies m and tau on its industrial fleet and reports that Global falls with m for tau > 5 and
rises with m for tau <= 5; it takes the rise for the curse of dimension: the support grows sparse, and
healthy vectors score, too. Here the same is done on the simulated fleet, where the truth is known, and
on the Langevin system. The certificate's floor says from calibration alone how much healthy data will
score; beside it stands how much it did.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from gam_db import langevin
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.reproduce.evaluated import summary
from gam_db.lab.reproduce.fleet import CALIBRATION, ROBOTS, places
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.lab.reproduce.table2 import agreement
from gam_db.lab.simulate.fleet import Fleet
from gam_db.lab.simulate.outcomes import outcomes_of
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source
from gam_db.study import Study

DIMENSIONS = (2, 3, 4, 5, 6)
DELAYS = (1, 2, 5, 10, 20, 50)
FLEET, LANGEVIN = "fleet", "langevin"

HEALTHY_JOINTS = 2
"""Joints of each healthy robot that are scored: enough, and a third of the time."""
SAMPLES, QUICK_SAMPLES = 100_000, 10_000
WINDOW, QUICK_WINDOW = 5000, 1000
_BINS = 100


@dataclass(frozen=True)
class Cell:
    """One m and one tau.

    Attributes:
        m, tau: the parameters.
        global_score, prog, disc: metrics; the last two are None where there is no fleet.
        mon: monotonicity of the failed channels.
        floor: the certificate's, mean over the channels evaluated.
        healthy: HI of healthy channels after calibration, mean; None where there is none.
        at_end: last HI of the failed channels, mean.
    """

    m: int
    tau: int
    global_score: float
    mon: float
    prog: float | None
    disc: float | None
    floor: float
    healthy: float | None
    at_end: float


@dataclass(frozen=True)
class Trend:
    """How Global goes with m at one delay.

    Attributes:
        tau: the delay.
        by_rank: Spearman's correlation of Global with m.
        change: Global at the largest m less that at the smallest.
        floors: the floor at the smallest and at the largest m.
        passed: the largest m whose floor is within the certificate's target; None if there is none.
        best: the m of the best Global.
    """

    tau: int
    by_rank: float
    change: float
    floors: tuple[float, float]
    passed: int | None
    best: int


def sensitivity(on: str, quick: bool, results: Results, show: Show) -> list[Cell]:
    """Run what has no result yet, and return a cell per m and tau.

    Args:
        on: FLEET or LANGEVIN.
        quick: short series and windows: to see that it works, no evidence.
        results: where results are kept.
        show: told what is at work.

    Raises:
        UserError: see its subclasses.
    """
    cells = []
    data: list[tuple[pa.Table, pa.Table | None]] = []

    def loaded() -> tuple[pa.Table, pa.Table | None]:
        if not data:
            show("simulating")
            data.append(_fleet(quick) if on == FLEET else (langevin.series(0, _steps(quick)), None))
        return data[0]

    for tau in DELAYS:
        for m in DIMENSIONS:
            title = f"m = {m}, tau = {tau}"
            show(title)
            settings = _settings(on, quick, m, tau)
            file = f"sensitivity-{on}{'-quick' if quick else ''}/m{m}-tau{tau}"
            figures = results.get(file, settings, lambda: _run(settings, loaded))  # noqa: B023
            cells.append(Cell(m=m, tau=tau, **figures))
    return cells


def trends(cells: Sequence[Cell]) -> list[Trend]:
    """Return how Global goes with m at each delay."""
    target = Parameters().target_floor
    by_delay = []
    for tau in DELAYS:
        delay_cells = sorted((cell for cell in cells if cell.tau == tau), key=lambda cell: cell.m)
        by_score = [cell.m for cell in sorted(delay_cells, key=lambda cell: cell.global_score)]
        rank = agreement([str(m) for m in by_score], [str(cell.m) for cell in delay_cells])
        by_delay.append(
            Trend(
                tau,
                by_rank=rank or 0.0,
                change=delay_cells[-1].global_score - delay_cells[0].global_score,
                floors=(delay_cells[0].floor, delay_cells[-1].floor),
                passed=max((cell.m for cell in delay_cells if cell.floor <= target), default=None),
                best=by_score[-1],
            )
        )
    return by_delay


def change(cells: Sequence[Cell], number: str) -> float | None:
    """Return a number of the cells at the largest m less that at the smallest, mean over the delays.

    None where it is not known of every cell.
    """
    ends = [
        [getattr(cell, number) for cell in cells if cell.m == m] for m in (DIMENSIONS[0], DIMENSIONS[-1])
    ]
    if None in ends[0] + ends[1]:
        return None
    return float(np.mean(ends[1]) - np.mean(ends[0]))


def foretold(cells: Sequence[Cell]) -> float | None:
    """Return Spearman's correlation of the floor with the healthy HI later seen, over the cells."""
    seen = [cell for cell in cells if cell.healthy is not None]
    by_floor = sorted(seen, key=lambda cell: cell.floor)
    by_healthy = sorted(seen, key=lambda cell: cell.healthy or 0.0)
    names = [[f"{cell.m}/{cell.tau}" for cell in order] for order in (by_floor, by_healthy)]
    return agreement(*names)


def _steps(quick: bool) -> int:
    return 2 * QUICK_SAMPLES if quick else langevin.SAMPLES


def _settings(on: str, quick: bool, m: int, tau: int) -> dict[str, Any]:
    of_fleet = on == FLEET
    return {
        "experiment": "sensitivity",
        "on": on,
        "seed": 0,
        "robots": ROBOTS if of_fleet else None,
        "healthy_joints": HEALTHY_JOINTS if of_fleet else None,
        "samples": (QUICK_SAMPLES if quick else SAMPLES) if of_fleet else _steps(quick),
        "calibration_fraction": CALIBRATION if of_fleet else langevin.CALIBRATION,
        "m": m,
        "tau": tau,
        "bins": _BINS,
        "window": QUICK_WINDOW if quick else WINDOW,
    }


def _run(settings: dict[str, Any], loaded: Callable[[], tuple[pa.Table, pa.Table | None]]) -> Figures:
    series, outcomes = loaded()
    chosen = {name: settings[name] for name in ("m", "tau", "bins", "window")}
    parameters = Parameters.paper(**chosen)
    calibration = Calibration(fraction=settings["calibration_fraction"])
    with DuckSession() as session:
        study = Study(session, Source(series), parameters, calibration)
        health = study.table("bucket_health")
        support = study.table("support_summary")
    metrics, channels = summary(health, outcomes)
    rows = channels.to_pylist()
    failed = [row for row in rows if outcomes is None or row["outcome"] == "failed"]
    calm = {(row["asset"], row["channel"]) for row in rows if row["outcome"] == "healthy"}
    counted = calm | {(row["asset"], row["channel"]) for row in failed}
    floors = [
        row["floor"]
        for row in support.to_pylist()
        if (row["asset"], row["channel"]) in counted and row["verdict"] not in ("constant", "no_data")
    ]
    return {
        "global_score": metrics["global"],
        "mon": metrics["mon"],
        "prog": metrics["prog"],
        "disc": metrics["disc"],
        "floor": float(np.mean(floors)),
        "healthy": _healthy(health, outcomes),
        "at_end": float(np.mean([row["last_hi"] for row in failed])),
    }


def _healthy(health: pa.Table, outcomes: pa.Table | None) -> float | None:
    """Return the mean health indicator of the healthy assets; constant channels never raise theirs."""
    if outcomes is None:
        return None
    healthy = outcomes.filter(outcomes["healthy"])["asset"].combine_chunks()
    of_healthy = health.filter(pc.is_in(health["asset"], value_set=healthy))
    return float(pc.mean(of_healthy["hi"]).as_py())


def _fleet(quick: bool) -> tuple[pa.Table, pa.Table]:
    """Return readings and outcomes of the simulated fleet: joints that failed, and healthy ones."""
    fleet = Fleet(0, QUICK_SAMPLES if quick else SAMPLES)
    joints = [
        fleet.joint(place.robot, place.joint)
        for place in places(fleet.seed, ROBOTS, HEALTHY_JOINTS, constant=True)
    ]
    return pa.concat_tables([joint.readings for joint in joints]), outcomes_of(
        joint.truth for joint in joints
    )
