"""One run on an engine in a process of its own: ``python -m gam_db.lab.benchmark.engine_run JOB``.

The clock runs from the open session to the results written; connecting and imports are not in it.
"""

import json
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from sqlglot import exp

import gam_db
from gam_db.composing.pipeline import filled, place
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import InternalError
from gam_db.lab.benchmark import alone, workload
from gam_db.lab.benchmark.extract import STRIDE, WINDOW, counted
from gam_db.lab.benchmark.inside import CALIBRATION, PARAMETERS, Steps
from gam_db.study import Study

#: What is timed, the first being ours.
PROGRAMS = ("gam", "extract", "floor")

_COLUMNS = ("asset", "channel", "t", "value")
_COUNTED = ("novel", "out_of_range", "novel_in_window")


@dataclass(frozen=True)
class EngineJob:
    """What a process is to do.

    Attributes:
        task: one of :data:`PROGRAMS`, or ``store``, ``compare``, ``clear``.
        address: of the database.
        prefix: begins the names of all tables of this comparison.
        channels, samples: size of the workload.
    """

    task: str
    address: str
    prefix: str
    channels: int
    samples: int

    def text(self) -> str:
        """Return the job as JSON."""
        return json.dumps(asdict(self))

    def table(self, name: str) -> exp.Table:
        """Return one of the tables of this comparison."""
        return exp.to_table(f"{self.prefix}{name}")


def done(job: EngineJob) -> dict[str, Any]:
    """Do a job; return ``seconds``, ``peak_memory`` of this process in MiB, and what was found."""
    work = {
        "store": _store,
        "gam": _gam,
        "extract": _extract,
        "floor": _floor,
        "compare": _compare,
        "clear": _clear,
    }
    if job.task not in work:
        raise InternalError(f"The benchmark knows no task {job.task!r}.")
    with connect(job.address) as session:
        if job.task in PROGRAMS:
            _drop(session, job, job.task)
        return alone.measured(lambda: work[job.task](session, job), session.engine.name)


def _store(session: Session, job: EngineJob) -> dict[str, Any]:
    """Make the table of telemetry, channel after channel."""
    for place_of, rows in enumerate(workload.batches("channel", job.channels, job.samples)):
        with session.lent(rows.select(list(_COLUMNS))) as lent:
            _append(session, job.table("telemetry"), exp.select(*_COLUMNS).from_(lent), not place_of)
    return {}


def _gam(session: Session, job: EngineJob) -> dict[str, Any]:
    """Compute the buckets in the engine, into a table of it."""
    steps = Steps()
    source = gam_db.Source(job.table("telemetry").name, time="t")
    targets = ["bucket_health"]
    study = Study(
        session, source, PARAMETERS, CALIBRATION, on_step=steps.begin, short_cuts=True, targets=targets
    )
    query = study.query(*targets).copy()
    query.set("order", None)
    steps.begin("bucket_health")
    _append(session, job.table("gam"), query, True)
    steps.begin("")
    return {"steps": dict(steps.seconds)}


def _extract(session: Session, job: EngineJob) -> dict[str, Any]:
    """Take the rows out, count with NumPy, write the buckets back."""
    steps = Steps()
    steps.begin("fetch")
    query = exp.select(*_COLUMNS).from_(job.table("telemetry")).order_by("asset", "channel", "t")
    rows = session.fetch(query)
    steps.begin("count")
    buckets = []
    for start in range(0, rows.num_rows, job.samples):
        piece = rows.slice(start, job.samples)
        of_buckets, _ = counted(piece)
        not_full = of_buckets["bucket"] < WINDOW // STRIDE - 1
        names = {
            role: pa.repeat(pa.scalar(piece[role][0].as_py(), pa.string()), len(not_full))
            for role in ("asset", "channel")
        }
        masked = {name: pa.array(of_buckets[name], mask=not_full) for name in ("novel_in_window", "hi")}
        buckets.append(pa.table({**names, **of_buckets, **masked}))
    steps.begin("write")
    bucket_table = pa.concat_tables(buckets)
    with session.lent(bucket_table) as lent:
        _append(session, job.table("extract"), exp.select(*bucket_table.column_names).from_(lent), True)
    steps.begin("")
    return {"steps": dict(steps.seconds)}


def _floor(session: Session, job: EngineJob) -> dict[str, Any]:
    """Look back twice in every channel: the least that the engine must do."""
    query = filled("lab/benchmark/floor_on_names")
    place(query, {"readings": job.table("telemetry")})
    session.fetch(query)
    return {}


def _compare(session: Session, job: EngineJob) -> dict[str, Any]:
    """Compare the integers of gam and of the script, and take a checksum of them.

    Raises:
        InternalError: they differ.
    """
    columns = ("asset", "channel", "bucket", *_COUNTED)
    ours, theirs = (
        session.fetch(
            exp.select(*columns).from_(job.table(name)).order_by("asset", "channel", "bucket")
        ).to_pylist()
        for name in ("gam", "extract")
    )
    if ours != theirs:
        raise InternalError(f"On {session.engine.title} gam and the script count differently.")
    counts = np.array([[row[name] or 0 for name in _COUNTED] for row in ours], np.int64)
    sums = counts.sum(axis=0).tolist()
    return {"buckets": len(ours), "sums": dict(zip(_COUNTED, sums, strict=True))}


def _clear(session: Session, job: EngineJob) -> dict[str, Any]:
    for name in ("telemetry", "gam", "extract"):
        _drop(session, job, name)
    return {}


def _append(session: Session, table: exp.Table, query: exp.Query, is_new: bool) -> None:
    if is_new:
        session.execute(session.engine.create_table(table, query))
        return
    names = [exp.to_identifier(name) for name in query.named_selects]
    session.execute(exp.Insert(this=exp.Schema(this=table, expressions=names), expression=query))


def _drop(session: Session, job: EngineJob, name: str) -> None:
    session.execute(exp.Drop(tables=[job.table(name)], kind="TABLE", exists=True))


if __name__ == "__main__":
    alone.answer(lambda job: done(EngineJob(**json.loads(job))))
