"""An hour of new rows after a little history, after much, and where a channel is silent."""

import shutil
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gam_db.errors import ConfigurationError, InternalError
from gam_db.lab.benchmark.measure import (
    Listener,
    circumstances,
    median_steps,
    parameters,
    ratio,
    spread,
)
from gam_db.lab.benchmark.stored_run import HOUR, SILENT, StoredJob, done

#: What is measured, in turns.
SIDES = ("small", "large", "script", "parked", "quiet")

MEANING = (
    "small, large: one hour of new rows of every channel, after the smaller and the larger history",
    "script: takes the rows out from the lookback on, counts with NumPy, writes buckets and novel "
    "cells; it proves nothing. gam-db reads as far and writes what differs; what is seen of buckets and "
    "cells in the end is compared",
    "parked, quiet: the same after the larger history with one channel more, silent for longer than "
    "park_after or for half of it",
    "processor: seconds of all threads, user and system, least of the runs; ratios are made of these",
    "seconds: median, least and most of the runs, from before the state is opened until it is closed; "
    "imports are not in it",
    "every run is a fresh process that scores a fresh copy of the same state; the sides take turns",
    "peak memory in MiB: largest resident size of that process, Python and its packages included",
    "rows scanned: what DuckDB's profiler says of the widest scan of the telemetry; rows in range: "
    "the new ones and those that the restart reads again",
)

#: Of processor seconds; each is aimed to stay below :data:`AIM`.
RATIOS = {"large_over_small": ("large", "small"), "parked_over_large": ("parked", "large")}
RATIOS["quiet_over_large"] = ("quiet", "large")
AIM = 1.2

#: Of the same; each is aimed to be at least so much.
GAINS = {
    "script_over_large": ("script", "large", 1.0),
}


@dataclass(frozen=True)
class IncrementalPlan:
    """What is to be measured.

    Attributes:
        rows: of the smaller and of the larger history.
        channels: how many there are, the silent ones aside.
        repeat: runs of each side.
        threads: of DuckDB; None for all there are.

    Raises:
        ConfigurationError: the histories are too short, or not in order.
    """

    rows: tuple[int, int] = (10_000_000, 100_000_000)
    channels: int = 100
    repeat: int = 5
    threads: int | None = None

    def __post_init__(self) -> None:
        small, large = self.rows
        if not 2 * HOUR * self.channels <= small < large:
            raise ConfigurationError(
                f"--rows is {small},{large}; it takes two numbers in order, the smaller at least "
                f"{2 * HOUR * self.channels:,} (two hours of {self.channels} channels)."
            )

    @property
    def runs(self) -> int:
        """How many processes it takes, and looks at the profile."""
        return 2 * 2 + 1 + len(SIDES) * (self.repeat + 1)


def measure_incremental(plan: IncrementalPlan, on_run: Listener = lambda _: None) -> dict[str, Any]:
    """Run the plan and return its figures, ready for JSON.

    Args:
        plan: what to measure.
        on_run: called before each process is started, and before each look at the profile.

    Raises:
        InternalError: a process failed, or repetitions did not do the same.
    """
    with tempfile.TemporaryDirectory(prefix="gam_benchmark_") as name:
        folder = Path(name)
        jobs = _jobs(plan, folder)
        for size in ("small", "large"):
            on_run(f"{size}: making the telemetry")
            replace(jobs[size], task="telemetry").run()
            on_run(f"{size}: calibrating and scoring all but the last hour")
            state = folder / f"{size}_state.duckdb"
            replace(jobs[size], task="prepare", state=str(state)).run()
        for side, job in jobs.items():
            shutil.copy(folder / f"{_size(side)}_state.duckdb", _begun(folder, side))
            done(replace(job, task="leave_out", state=str(_begun(folder, side))))
        runs: dict[str, list[dict[str, Any]]] = {side: [] for side in SIDES}
        for turn in range(plan.repeat):
            for side, job in jobs.items():
                on_run(f"{side}, run {turn + 1} of {plan.repeat}")
                task = "extract" if side == "script" else "score"
                runs[side].append(_on_copy(StoredJob.run, job, folder, side, task))
        explained = {}
        for side, job in jobs.items():
            on_run(f"{side}: explain")
            task = "compare_hour" if side == "script" else "explain"
            explained[side] = _on_copy(done, job, folder, side, task)
    sides = {side: _side(plan, side, runs[side], explained[side]) for side in SIDES}
    processor = {side: figures["processor_seconds"] for side, figures in sides.items()}
    return {
        "workload": {
            "channels": plan.channels,
            "rows": list(plan.rows),
            "new_rows": HOUR * plan.channels,
            "calibration_ticks": jobs["small"].calibration,
            "lookback_ticks": jobs["small"].lookback,
            "park_after_ticks": jobs["small"].park_after,
            **parameters(),
        },
        "repeat": plan.repeat,
        "threads": plan.threads,
        **circumstances(),
        "meaning": list(MEANING),
        "sides": sides,
        "ratios": {
            name: ratio(processor, above, below, "min") for name, (above, below) in RATIOS.items()
        },
        "aim": AIM,
        "gains": {
            name: ratio(processor, above, below, "min") for name, (above, below, _) in GAINS.items()
        },
        "gain_aims": {name: aim for name, (_, _, aim) in GAINS.items()},
    }


def _jobs(plan: IncrementalPlan, folder: Path) -> dict[str, StoredJob]:
    """Return what each side has in common; calibration and lookback are the same for all."""
    small, large = (rows // plan.channels for rows in plan.rows)
    lookback, park_after = min(HOUR, small // 20), min(24 * HOUR, large // 4)
    silent = lookback + park_after
    jobs = {}
    for side in SIDES:
        history = small if side == "small" else large
        jobs[side] = StoredJob(
            task="",
            source=str(folder / f"{_size(side)}.duckdb"),
            threads=plan.threads,
            channels=plan.channels,
            history=history,
            # In the smaller history nothing is asked of them; they only have to be there.
            long_silent=max(history - 2 * silent, history // 2),
            short_silent=max(history - silent // 2, history // 2),
            calibration=small // 5,
            lookback=lookback,
            park_after=park_after,
            left_out={"parked": SILENT[1:], "quiet": SILENT[:1]}.get(side, SILENT),
        )
    jobs["parked"] = replace(jobs["parked"], long_silent=history - 2 * silent)
    return jobs


def _size(side: str) -> str:
    return "small" if side == "small" else "large"


def _begun(folder: Path, side: str) -> Path:
    return folder / f"{side}_begun.duckdb"


def _on_copy(
    how: Callable[[StoredJob], dict[str, Any]], job: StoredJob, folder: Path, side: str, task: str
) -> dict[str, Any]:
    """Do a task on a fresh copy of the state that a side begins with."""
    state = folder / "state.duckdb"
    shutil.copy(_begun(folder, side), state)
    figures = how(replace(job, task=task, state=str(state)))
    state.unlink()
    return figures


def _side(
    plan: IncrementalPlan, side: str, runs: list[dict[str, Any]], explained: dict[str, Any]
) -> dict[str, Any]:
    same = [
        key
        for key in ("channels", "parked", "queries", "rows_in_range", "new_buckets", "new_cells")
        if key in runs[0]
    ]
    for run in runs[1:]:
        if any(run[key] != runs[0][key] for key in same):
            raise InternalError(f"Two runs of the side {side} did not do the same.")
    return {
        "seconds": spread(runs, "seconds", 4),
        "processor_seconds": spread(runs, "processor_seconds", 4),
        "peak_memory": spread(runs, "peak_memory", 0),
        "steps": median_steps(runs) if "steps" in runs[0] else {},
        **{key: runs[0][key] for key in same},
        **{key: explained[key] for key in ("rows_scanned", "scans") if key in explained},
    }
