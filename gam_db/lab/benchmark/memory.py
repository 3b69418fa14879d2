"""Many rows scored from nothing with little memory."""

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gam_db.errors import ConfigurationError
from gam_db.lab.benchmark.measure import Listener, circumstances, parameters
from gam_db.lab.benchmark.stored_run import HOUR, StoredJob

MEANING = (
    "calibrate and score, both from nothing, in one process; the telemetry lies in a DuckDB file, "
    "interleaved by time",
    "peak memory in MiB: largest resident size of the whole process, Python and its packages included; "
    "what DuckDB cannot hold goes to a folder beside the state",
)


@dataclass(frozen=True)
class MemoryPlan:
    """What is to be measured.

    Attributes:
        rows: of the telemetry.
        channels: how many there are.
        memory_limit: of DuckDB.
        threads: of DuckDB; None for all there are.

    Raises:
        ConfigurationError: there are fewer rows than for two hours of each channel.
    """

    rows: int = 100_000_000
    channels: int = 100
    memory_limit: str = "1GB"
    threads: int | None = None

    def __post_init__(self) -> None:
        if self.rows < 2 * HOUR * self.channels:
            raise ConfigurationError(
                f"--rows is {self.rows}; it takes at least {2 * HOUR * self.channels:,} (two hours of "
                f"{self.channels} channels)."
            )

    #: Making the telemetry, and the run itself.
    runs = 2


def measure_memory(plan: MemoryPlan, on_run: Listener = lambda _: None) -> dict[str, Any]:
    """Run the plan and return its figures, ready for JSON.

    Args:
        plan: what to measure.
        on_run: called before each process is started.

    Raises:
        InternalError: a process failed.
    """
    with tempfile.TemporaryDirectory(prefix="gam_benchmark_") as folder:
        job = StoredJob(
            task="telemetry",
            source=str(Path(folder, "telemetry.duckdb")),
            state=str(Path(folder, "state.duckdb")),
            threads=plan.threads,
            channels=plan.channels,
            history=plan.rows // plan.channels - HOUR,
            memory_limit=plan.memory_limit,
        )
        on_run("making the telemetry")
        telemetry = job.run()
        on_run(f"calibrating and scoring under {plan.memory_limit}")
        figures = replace(job, task="from_nothing").run()
    rows = job.channels * (job.history + HOUR)
    return {
        "workload": {
            "channels": plan.channels,
            "rows": rows,
            "source_bytes": telemetry["bytes"],
            **parameters(),
        },
        "memory_limit": plan.memory_limit,
        "threads": plan.threads,
        **circumstances(),
        "meaning": list(MEANING),
        "rows_per_second": round(rows / figures["seconds"]),
        **figures,
    }
