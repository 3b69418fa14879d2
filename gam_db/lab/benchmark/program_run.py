"""One run in a process of its own: ``python -m gam_db.lab.benchmark.program_run JOB``, JOB being JSON.

The clock runs from before the database is opened until it is closed again; imports are not in it.
"""

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from gam_db.errors import InternalError
from gam_db.lab.benchmark import alone, equal, extract, floor, inside, workload

#: The programs that are timed, the first being ours.
PROGRAMS = ("gam", "floor_on_ids", "floor_on_names", "extract")


@dataclass(frozen=True)
class Job:
    """What a process is to do.

    Attributes:
        task: one of :data:`PROGRAMS`, or ``store``, ``explain``, ``compare``.
        folder: of the workload and the results.
        order: one of the orders of the workload.
        threads: of DuckDB, and of the extract script.
        channels, samples: size of the workload.
    """

    task: str
    folder: str
    order: str
    threads: int
    channels: int
    samples: int

    def text(self) -> str:
        """Return the job as JSON."""
        return json.dumps(asdict(self))

    def result(self, program: str) -> Path:
        """Return the file that a program writes its tables into."""
        return Path(self.folder) / f"{program}.duckdb"


def done(job: Job) -> dict[str, Any]:
    """Do a job; return ``seconds``, ``peak_memory`` in MiB, and what the task itself found."""
    job.result(job.task).unlink(missing_ok=True)
    return alone.measured(lambda: _done(job))


def _done(job: Job) -> dict[str, Any]:
    source = Path(job.folder) / f"by_{job.order}.duckdb"
    result = job.result(job.task)
    figures: dict[str, Any] = {}
    if job.task == "gam":
        figures["steps"] = inside.run(source, result, job.threads)
    elif job.task == "extract":
        extract.run(source, result, job.threads)
    elif job.task in PROGRAMS:
        floor.run(source, job.threads, job.task)
    elif job.task == "explain":
        figures["operators"] = inside.explain(source, result, job.threads)
    elif job.task == "store":
        workload.store(source, job.order, job.channels, job.samples)
    elif job.task == "compare":
        figures |= equal.compare(job.result("gam"), job.result("extract"))
    else:
        raise InternalError(f"The benchmark knows no task {job.task!r}.")
    return figures


if __name__ == "__main__":
    alone.answer(lambda job: done(Job(**json.loads(job))))
