"""The simulated fleet in the place of the paper's: its joints, and the indicator of each by each method.

The paper's data are 21 robots of six joints, 16 of them healthy and 5 run to failure. The simulated
ones make two products in turn, and a rare task now and then, all of it from the beginning. Every joint
is learnt and scored alone. A result is kept for each joint and method, with the indicator at bucket
ends.
"""

import functools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import pyarrow as pa

from gam_db.lab.evaluation import Conventions, evaluate
from gam_db.lab.reproduce.methods import Task, health, method_named
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.lab.simulate.fleet import Fleet, Joint
from gam_db.lab.simulate.outcomes import outcomes_of
from gam_db.lab.simulate.roles import JOINTS, role_of
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source

ROBOTS = 21
CALIBRATION = 0.2
BINS = 100


class Place(NamedTuple):
    """A joint of a fleet: numbers from 1, and whether it fails."""

    robot: int
    joint: int
    fails: bool

    @property
    def asset(self) -> str:
        """The name of the robot."""
        return f"robot_{self.robot:02d}"

    @property
    def channel(self) -> str:
        """The name of the joint."""
        return f"joint_{self.joint}"


@dataclass(frozen=True)
class Plan:
    """Which part of a fleet is evaluated, and by which settings.

    Attributes:
        failed, healthy: robots of each kind, the first ones.
        healthy_joints: of each healthy robot.
        samples: instants of a joint.
        shift: samples after which a robot changes to its other product.
        window: W.
        quick: train and fit for a moment only.
    """

    failed: int = 5
    healthy: int = 16
    healthy_joints: int = JOINTS
    samples: int = 100_000
    shift: int = 2_500
    window: int = 5_000
    quick: bool = False

    @property
    def parameters(self) -> Parameters:
        """The paper's m, tau and B."""
        return Parameters.paper(bins=BINS, window=self.window)

    @property
    def folder(self) -> str:
        """Where results of it are kept."""
        return f"fleet{'-quick' if self.quick else ''}"

    def fleet(self, seed: int) -> Fleet:
        """Return the fleet of a seed."""
        return Fleet(seed, self.samples, shift=self.shift)

    def places(self, seed: int) -> list[Place]:
        """Return the joints of a fleet that are evaluated, those that fail first."""
        every = list(places(seed, ROBOTS, self.healthy_joints))
        failed = [place for place in every if place.fails][: self.failed]
        calm = [place for place in every if not place.fails]
        robots = sorted({place.robot for place in calm})[: self.healthy]
        return failed + [place for place in calm if place.robot in robots]


FULL = Plan()
QUICK = Plan(failed=2, healthy=2, healthy_joints=1, samples=20_000, shift=500, window=1_000, quick=True)


def places(
    seed: int, robots: int, healthy_joints: int = JOINTS, constant: bool = False
) -> Iterator[Place]:
    """Yield the joints of a fleet that count: those that fail, and those of healthy robots.

    The other joints of a robot that fails count neither way.

    Args:
        seed: of the fleet.
        robots: how many there are.
        healthy_joints: of each healthy robot.
        constant: with the joint that never moves, which no method can judge.
    """
    for robot in range(1, robots + 1):
        role = role_of(seed, robot)
        if role.kind == "failed" and role.joint is not None:
            yield Place(robot, role.joint, True)
        elif role.kind == "healthy":
            for joint in range(1, healthy_joints + 1):
                if constant or joint != role.constant:
                    yield Place(robot, joint, False)


def series(
    plan: Plan,
    seed: int,
    names: Sequence[str],
    place: Place,
    results: Results,
    show: Show,
    parameters: Parameters | None = None,
) -> dict[str, Figures]:
    """Return the indicators of a joint by method; what has no result yet is run.

    Args:
        plan: of the experiment.
        seed: of the fleet and of the methods.
        names: methods.
        place: the joint.
        results: where results are kept.
        show: told what is at work.
        parameters: of the methods; default those of the plan.

    Returns:
        For each method ``hi`` (at bucket ends; None until the window is full), ``novel_in_window`` (with
        "dse", else None), ``seconds`` (from the raw table to the indicator) and ``losses`` (a number for
        each epoch).
    """
    chosen = parameters or plan.parameters
    title = f"fleet {seed}, {place.asset} {place.channel}"
    simulated = functools.cache(lambda: plan.fleet(seed).joint(place.robot, place.joint))
    # The two scores of a variational autoencoder are those of the same net.
    task = Task(seed, plan.quick, at_buckets=True, nets={})
    by_method: dict[str, Figures] = {}
    for name in names:
        show(f"{title}: {method_named(name).title}")
        settings = {
            "experiment": "fleet",
            "method": name,
            "seed": seed,
            "robot": place.robot,
            "joint": place.joint,
            "samples": plan.samples,
            "shift": plan.shift,
            "calibration_fraction": CALIBRATION,
            "m": chosen.m,
            "tau": chosen.tau,
            "bins": chosen.bins,
            "window": chosen.window,
            **method_named(name).settings(task),
        }
        mark = "" if parameters is None else f"-m{chosen.m}-tau{chosen.tau}"
        file = f"{plan.folder}/{name}{mark}-{seed}-{place.robot:02d}-{place.joint}"
        run = functools.partial(_run, name, simulated, chosen, task, title, show)
        by_method[name] = results.get(file, settings, run)
    return by_method


def measured(
    plan: Plan, seed: int, names: Sequence[str], results: Results, show: Show
) -> dict[str, Figures]:
    """Return what is measured of a whole fleet, by method.

    Returns:
        For each method ``metrics`` (by name), ``spread`` (of mon, corr and rob over the joints that
        failed), ``channels`` (a row per joint: asset, channel, outcome, mon, corr, rob, last_hi,
        amplitude, hi_sd) and ``seconds`` (a number for each joint).
    """
    joints = plan.places(seed)
    by_joint = [series(plan, seed, names, place, results, show) for place in joints]
    answer = {}
    for name in names:
        show(f"fleet {seed}: evaluating {method_named(name).title}")
        table = health_table(joints, [figures[name] for figures in by_joint])
        evaluation = evaluate(table, outcomes(joints), conventions=Conventions(surrogates=0, samples=0))
        summary = {row["metric"]: row for row in evaluation.summary.to_pylist()}
        answer[name] = {
            "metrics": {metric: row["value"] for metric, row in summary.items()},
            "spread": {metric: summary[metric]["sd"] for metric in ("mon", "corr", "rob")},
            "channels": evaluation.channels.to_pylist(),
            "seconds": [figures[name]["seconds"] for figures in by_joint],
        }
    return answer


def health_table(joints: Sequence[Place], by_joint: Sequence[Figures]) -> pa.Table:
    """Return the indicators of some joints by one method as a table that can be evaluated."""
    parts = []
    for place, figures in zip(joints, by_joint, strict=True):
        # A joint without any value has a row all the same, so that joints are those of every method.
        values = figures["hi"] or [None]
        count = len(values)
        columns = {
            "asset": pa.array([place.asset] * count, pa.string()),
            "channel": pa.array([place.channel] * count, pa.string()),
            "bucket": pa.array(range(count), pa.int64()),
            "hi": pa.array(values, pa.float64()),
        }
        if figures["novel_in_window"] is not None:
            columns["novel_in_window"] = pa.array(figures["novel_in_window"], pa.int64())
        parts.append(pa.table(columns))
    return pa.concat_tables(parts)


def outcomes(joints: Sequence[Place]) -> pa.Table:
    """Return what became of the robots; a series of one that failed ends at its failure."""
    rows = [
        {
            "asset": place.asset,
            "channel": place.channel,
            "kind": "failed" if place.fails else "healthy",
            "failed_at": 0 if place.fails else None,
        }
        for place in joints
    ]
    return outcomes_of(rows).drop_columns("failed_at")


def _run(
    name: str, simulated: Any, parameters: Parameters, task: Task, title: str, show: Show
) -> Figures:
    losses: list[float] = []

    def on_epoch(epoch: int, loss: float) -> None:
        losses.append(loss)
        show(f"{title}: {method_named(name).title}, epoch {epoch}, loss {loss:.2e}")

    joint: Joint = simulated()
    calibration = Calibration(fraction=CALIBRATION)
    followed = replace(task, on_epoch=on_epoch)
    table, seconds = health(name, Source(joint.readings), parameters, calibration, followed)
    counts = "novel_in_window" in table.column_names
    return {
        "hi": table["hi"].to_pylist(),
        "novel_in_window": table["novel_in_window"].to_pylist() if counts else None,
        "seconds": seconds,
        "losses": losses,
    }
