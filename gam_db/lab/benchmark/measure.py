"""The measuring: which runs there are, in which order, and what is made of their figures."""

import datetime
import os
import platform
import statistics
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import gam_db
from gam_db.lab.benchmark import alone, inside
from gam_db.lab.benchmark.program_run import PROGRAMS, Job
from gam_db.lab.benchmark.workload import ORDERS

Listener = Callable[[str], None]

#: What a figure of time or memory stands for; printed with the figures.
MEANING = (
    "processor: seconds of all threads (user and system), least of the runs: what the ratios are made "
    "of, since other work on the machine changes it least; ratios of the median seconds stand beside",
    "seconds: median, least and most of the runs, from before the database is opened until it is "
    "closed; imports are not in it",
    "every run is a fresh process; the programs take turns (A B C A B C), never the same one twice "
    "in a row unless it is alone",
    "peak memory in MiB: largest resident size of that process (getrusage, RUSAGE_SELF, ru_maxrss), "
    "Python and its packages included; median, least and most",
    "gam and extract read the names and write both tables; the floors write nothing, and those on "
    "ids read a table that holds integers already",
    "extract takes for granted that nothing is missing and no instant occurs twice; gam finds out",
)

RATIOS = {
    "sql_over_floor": ("gam", "floor_on_ids"),
    "sql_over_floor_on_names": ("gam", "floor_on_names"),
    "extract_over_sql": ("extract", "gam"),
}


@dataclass(frozen=True)
class Plan:
    """What is to be measured.

    Attributes:
        channels, samples: size of the workload; samples per channel.
        repeat: runs of each program in each case.
        threads, orders: the cases are all pairs of them.
        programs: which of the programs are run; ratios need both of theirs.
        explain: one more run of gam in each case under DuckDB's profiler.
    """

    channels: int = 12
    samples: int = 1_000_000
    repeat: int = 3
    threads: tuple[int, ...] = (1, 2)
    orders: tuple[str, ...] = tuple(ORDERS)
    programs: tuple[str, ...] = PROGRAMS
    explain: bool = False

    @property
    def compared(self) -> bool:
        """Whether both programs run that give the same integers."""
        return {"gam", "extract"} <= set(self.programs)

    @property
    def runs(self) -> int:
        """How many processes it takes."""
        per_case = len(self.programs) * self.repeat + self.compared + self.explain
        return len(self.orders) * (1 + len(self.threads) * per_case)


def measure(plan: Plan, on_run: Listener = lambda _: None) -> dict[str, Any]:
    """Run the plan and return its figures, ready for JSON.

    Args:
        plan: what to measure.
        on_run: called before each process is started.

    Raises:
        InternalError: the integers of gam and of extract differ, or a process failed.
    """
    cases = []
    with tempfile.TemporaryDirectory(prefix="gam_benchmark_") as folder:
        for order in plan.orders:
            on_run(f"{ORDERS[order]}: storing the workload")
            run_alone(Job("store", folder, order, 1, plan.channels, plan.samples))
            for threads in plan.threads:
                cases.append(_case(plan, folder, order, threads, on_run))
            Path(folder, f"by_{order}.duckdb").unlink()
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
    }


def parameters() -> dict[str, int]:
    """Return the parameters of the method under which everything is measured."""
    used = inside.PARAMETERS
    return {
        "m": used.m,
        "tau": used.tau,
        "bins": used.grid,
        "window": used.window,
        "stride": used.bucket_length,
    }


def circumstances() -> dict[str, Any]:
    """Return what a figure depends on: versions, cores, date."""
    return {
        "versions": {
            "gam_db": gam_db.__version__,
            "duckdb": version("duckdb"),
            "numpy": version("numpy"),
            "python": platform.python_version(),
        },
        "cores": os.cpu_count(),
        "date": datetime.date.today().isoformat(),
    }


def spread(runs: list[dict[str, Any]], key: str, digits: int) -> dict[str, Any]:
    """Return median, least and most of a figure of several runs, and all of them."""
    figures = [round(run[key], digits) for run in runs]
    return {
        "median": round(statistics.median(figures), digits),
        "min": min(figures),
        "max": max(figures),
        "runs": figures,
    }


def ratio(figures: dict[str, dict[str, Any]], above: str, below: str, key: str) -> float:
    """Return the ratio of a figure of two programs."""
    quotient: float = round(figures[above][key] / figures[below][key], 3)
    return quotient


def median_steps(runs: list[dict[str, Any]], key: str = "steps") -> dict[str, float]:
    """Return the median seconds of each step of several runs."""
    return {step: round(statistics.median(run[key][step] for run in runs), 4) for step in runs[0][key]}


def run_alone(job: Job) -> dict[str, Any]:
    """Do a job in a fresh process and return its figures.

    Raises:
        InternalError: it failed; the message is the last line that it wrote.
    """
    return alone.run("program_run", job.task, job.text())


def _case(plan: Plan, folder: str, order: str, threads: int, on_run: Listener) -> dict[str, Any]:
    def run(task: str, turn: str = "") -> dict[str, Any]:
        on_run(f"{ORDERS[order]}, threads {threads}: {task}{turn}")
        return run_alone(Job(task, folder, order, threads, plan.channels, plan.samples))

    runs: dict[str, list[dict[str, Any]]] = {program: [] for program in plan.programs}
    for turn in range(plan.repeat):
        for program in plan.programs:
            runs[program].append(run(program, f", run {turn + 1} of {plan.repeat}"))
    case: dict[str, Any] = {
        "case": f"{order}-{threads}",
        "order": order,
        "threads": threads,
        "processor_seconds": {
            program: spread(of, "processor_seconds", 4) for program, of in runs.items()
        },
        "seconds": {program: spread(of, "seconds", 4) for program, of in runs.items()},
        "peak_memory": {program: spread(of, "peak_memory", 0) for program, of in runs.items()},
    }
    for name, (above, below) in RATIOS.items():
        both = above in runs and below in runs
        case[name] = ratio(case["processor_seconds"], above, below, "min") if both else None
        case[f"{name}_by_clock"] = ratio(case["seconds"], above, below, "median") if both else None
    if "gam" in runs:
        case["steps"] = median_steps(runs["gam"])
    if plan.compared:
        compared = run("compare")
        case["integers_equal"] = True  # else the process would have failed
        case["rows"] = compared["rows"]
        case["novel_share"] = compared["novel_share"]
    if plan.explain:
        case["operators"] = run("explain")["operators"]
    return case
