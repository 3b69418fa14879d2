"""The stored form from nothing, beside the exact form up to the same bucket values."""

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gam_db.lab.benchmark import inside
from gam_db.lab.benchmark.measure import (
    Listener,
    circumstances,
    median_steps,
    parameters,
    ratio,
    run_alone,
    spread,
)
from gam_db.lab.benchmark.program_run import Job
from gam_db.lab.benchmark.stored_run import StoredJob
from gam_db.lab.benchmark.workload import ORDERS

MEANING = (
    "stored: migrate, calibrate and score from nothing into a new state file: ranges, support, "
    "certificate, buckets and novel cells",
    "exact: gam_db.health_at_buckets, calibration included, nothing written",
    "exact, whole: the same with the novel cells and the certificate, all of it written",
    "processor: seconds of all threads, user and system, least of the runs; ratios are made of these",
    "seconds: median, least and most of the runs, from before a database is opened until it is closed; "
    "imports are not in it; calibrate, score: those two calls alone, the state's closing in score",
    "every run is a fresh process; the three take turns",
    "peak memory in MiB: largest resident size of that process, Python and its packages included",
)

#: The processor time of the stored form over that of the exact form that makes and writes the same;
#: aimed to stay below it.
AIM = 1.0


@dataclass(frozen=True)
class StoredPlan:
    """What is to be measured.

    Attributes:
        channels, samples: size of the workload; samples per channel.
        repeat: runs of both in each case.
        threads, orders: the cases are all pairs of them.
    """

    channels: int = 12
    samples: int = 1_000_000
    repeat: int = 3
    threads: tuple[int, ...] = (1, 2)
    orders: tuple[str, ...] = tuple(ORDERS)

    @property
    def runs(self) -> int:
        """How many processes it takes."""
        return len(self.orders) * (1 + len(self.threads) * (3 * self.repeat + 1))


def measure_stored(plan: StoredPlan, on_run: Listener = lambda _: None) -> dict[str, Any]:
    """Run the plan and return its figures, ready for JSON.

    Args:
        plan: what to measure.
        on_run: called before each process is started.

    Raises:
        InternalError: the integers of both forms differ, or a process failed.
    """
    cases = []
    with tempfile.TemporaryDirectory(prefix="gam_benchmark_") as folder:
        for order in plan.orders:
            on_run(f"{ORDERS[order]}: storing the workload")
            run_alone(Job("store", folder, order, 1, plan.channels, plan.samples))
            source = Path(folder, f"by_{order}.duckdb")
            for threads in plan.threads:
                state = str(Path(folder, "state.duckdb"))
                job = StoredJob("from_nothing", str(source), state, threads)
                cases.append(_case(plan, job, order, on_run))
            source.unlink()
    return {
        "workload": {
            "channels": plan.channels,
            "samples": plan.samples,
            "rows": plan.channels * plan.samples,
            "calibration": inside.CALIBRATION.fraction,
            **parameters(),
        },
        "repeat": plan.repeat,
        **circumstances(),
        "meaning": list(MEANING),
        "cases": cases,
        "aim": AIM,
    }


def _case(plan: StoredPlan, job: StoredJob, order: str, on_run: Listener) -> dict[str, Any]:
    def run(task: str, turn: str = "") -> dict[str, Any]:
        on_run(f"{ORDERS[order]}, threads {job.threads}: {task.replace('_', ' ')}{turn}")
        return replace(job, task=task).run()

    stored, exact, whole = [], [], []
    for number in range(plan.repeat):
        turn = f", run {number + 1} of {plan.repeat}"
        stored.append(run("from_nothing", turn))
        exact.append(run("exact", turn))
        whole.append(run("exact_whole", turn))
    compared = run("compare")
    seconds = {
        "stored": spread(stored, "seconds", 4),
        "calibrate": spread(stored, "calibrate", 4),
        "score": spread(stored, "score", 4),
        "exact": spread(exact, "seconds", 4),
        "exact_whole": spread(whole, "seconds", 4),
    }
    sides = {"stored": stored, "exact": exact, "exact_whole": whole}
    processor = {side: spread(of, "processor_seconds", 4) for side, of in sides.items()}
    return {
        "case": f"{order}-{job.threads}",
        "order": order,
        "threads": job.threads,
        "seconds": seconds,
        "processor_seconds": processor,
        "peak_memory": {
            "stored": spread(stored, "peak_memory", 0),
            "exact": spread(exact, "peak_memory", 0),
            "exact_whole": spread(whole, "peak_memory", 0),
        },
        "stored_over_exact": ratio(processor, "stored", "exact", "min"),
        "stored_over_exact_whole": ratio(processor, "stored", "exact_whole", "min"),
        "calibrate_steps": median_steps(stored, "calibrate_steps"),
        "score_steps": median_steps(stored, "score_steps"),
        "buckets": compared["buckets"],
        "integers_equal": True,  # else the process would have failed
        "state_bytes": stored[0]["state_bytes"],
    }
