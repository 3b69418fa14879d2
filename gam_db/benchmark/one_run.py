"""One run in a process of its own: ``python -m gam_db.benchmark.one_run JOB``, JOB being JSON.

The clock runs from before the database is opened until it is closed again; imports are not in it.
"""

import json
import resource
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from gam_db.benchmark import equal, extract, floor, inside, workload
from gam_db.errors import GamError, InternalError

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


def parsed(output: str) -> dict[str, Any]:
    """Return the figures that a process printed: its last line."""
    figures: dict[str, Any] = json.loads(output.strip().rpartition("\n")[2])
    return figures


def done(job: Job) -> dict[str, Any]:
    """Do a job; return ``seconds``, ``peak_memory`` in MiB, and what the task itself found."""
    source = Path(job.folder) / f"by_{job.order}.duckdb"
    result = job.result(job.task)
    result.unlink(missing_ok=True)
    found: dict[str, Any] = {}
    started = time.perf_counter()
    if job.task == "gam":
        found["steps"] = inside.run(source, result, job.threads)
    elif job.task == "extract":
        extract.run(source, result, job.threads)
    elif job.task in PROGRAMS:
        floor.run(source, job.threads, job.task)
    elif job.task == "explain":
        found["operators"] = inside.explain(source, result, job.threads)
    elif job.task == "store":
        workload.store(source, job.order, job.channels, job.samples)
    elif job.task == "compare":
        found |= equal.compare(job.result("gam"), job.result("extract"))
    else:
        raise InternalError(f"The benchmark knows no task {job.task!r}.")
    found["seconds"] = time.perf_counter() - started
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    found["peak_memory"] = peak / 2**20 if sys.platform == "darwin" else peak / 2**10
    return found


if __name__ == "__main__":
    try:
        print(json.dumps(done(Job(**json.loads(sys.argv[1])))))
    except GamError as error:
        sys.exit(str(error))
