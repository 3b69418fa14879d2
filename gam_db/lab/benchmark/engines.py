"""The comparison of engines: in the database, beside taking the rows out, and the engine's own floor."""

import secrets
import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gam_db.address import shown
from gam_db.lab.benchmark import alone, inside
from gam_db.lab.benchmark.engine_run import PROGRAMS, EngineJob
from gam_db.lab.benchmark.measure import Listener, circumstances, median_steps, parameters, ratio, spread

MEANING = (
    "gam: from the raw table to the indicator at bucket ends, in a table of the engine; extract: rows "
    "out in order by the driver of gam-db, NumPy, buckets back in; floor: one window pass that looks "
    "back twice",
    "processor: seconds of all threads (user and system), of a server on this machine and of Spark too; "
    "least of the runs: what the ratios are made of; ratios of the median seconds stand beside",
    "seconds: median, least and most of the runs, from the open session to the results written; "
    "connecting and imports are not in it",
    "every run is a fresh process, and the three take turns; peak memory is that of Python's process, "
    "without a server or Spark's",
    "extract takes for granted that nothing is missing and no instant occurs twice; gam finds out",
)

RATIOS = {"gam_over_floor": ("gam", "floor"), "extract_over_gam": ("extract", "gam")}

#: Engines that need no server: name -> address in a folder of the benchmark.
EMBEDDED = {
    "duckdb": "duckdb:///{folder}/plant.duckdb",
    "sqlite": "sqlite:///{folder}/plant.sqlite",
    "clickhouse": "chdb:///{folder}/chdb",
    "spark": "spark://{folder}/spark",
}


@dataclass(frozen=True)
class EnginesPlan:
    """What is to be measured.

    Attributes:
        engines: names of embedded engines, or addresses.
        channels, samples: size of the workload; samples per channel.
        repeat: runs of each program on each engine.
    """

    engines: tuple[str, ...] = tuple(EMBEDDED)
    channels: int = 12
    samples: int = 1_000_000
    repeat: int = 3

    @property
    def runs(self) -> int:
        """How many processes it takes."""
        return len(self.engines) * (3 + len(PROGRAMS) * self.repeat)


def measure_engines(plan: EnginesPlan, on_run: Listener = lambda _: None) -> dict[str, Any]:
    """Run the plan and return its figures, ready for JSON.

    Args:
        plan: what to measure.
        on_run: called before each process is started.

    Raises:
        InternalError: the integers of gam and of the script differ, or a process failed.
    """
    with tempfile.TemporaryDirectory(prefix="gam_benchmark_") as folder:
        cases = [_case(plan, engine, folder, on_run) for engine in plan.engines]
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


def _case(plan: EnginesPlan, engine: str, folder: str, on_run: Listener) -> dict[str, Any]:
    address = EMBEDDED.get(engine, engine).format(folder=Path(folder).resolve())
    prefix = f"gam_benchmark_{secrets.token_hex(4)}_"
    job = EngineJob("store", address, prefix, plan.channels, plan.samples)

    def run(task: str, turn: str = "") -> dict[str, Any]:
        on_run(f"{shown(engine)}: {task}{turn}")
        return alone.run("engine_run", task, replace(job, task=task).text())

    run("store")
    try:
        runs: dict[str, list[dict[str, Any]]] = {program: [] for program in PROGRAMS}
        for turn in range(plan.repeat):
            for program in PROGRAMS:
                runs[program].append(run(program, f", run {turn + 1} of {plan.repeat}"))
        compared = run("compare")
    finally:
        run("clear")
    seconds = {program: spread(of, "seconds", 3) for program, of in runs.items()}
    processor = {program: spread(of, "processor_seconds", 3) for program, of in runs.items()}
    return {
        "engine": shown(engine),
        "processor_seconds": processor,
        "seconds": seconds,
        "peak_memory": {program: spread(of, "peak_memory", 0) for program, of in runs.items()},
        **{name: ratio(processor, *programs, "min") for name, programs in RATIOS.items()},
        **{f"{name}_by_clock": ratio(seconds, *programs, "median") for name, programs in RATIOS.items()},
        "steps": {name: median_steps(runs[name]) for name in ("gam", "extract")},
        "buckets": compared["buckets"],
        "sums": compared["sums"],
        "integers_equal": True,  # else a process would have failed
    }
