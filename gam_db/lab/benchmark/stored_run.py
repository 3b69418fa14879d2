"""One run of the stored form in a process of its own: ``python -m gam_db.lab.benchmark.stored_run JOB``.

The telemetry lies in a file that is only read, the state in another; so the state is small enough to be
copied before each run, and every repetition begins from the same one. The clock runs from before the
state is opened until it is closed again, its checkpoint included; imports are not in it.
"""

import datetime as dt
import json
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import gam_db
from gam_db.composing import template
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import InternalError
from gam_db.lab.benchmark import alone, extract_hour
from gam_db.lab.benchmark.database import opened, statement
from gam_db.lab.benchmark.inside import CALIBRATION, PARAMETERS, ProfiledSession, Steps
from gam_db.stored.monitor import Monitor
from gam_db.study import Study

#: The first instant of the telemetry, and the length of what is called the new hour, in ticks.
FIRST = dt.datetime(2024, 1, 1)
HOUR = 3600

#: What the exact form makes of all that the stored form holds.
WHOLE = ("bucket_health", "novel_cells", "support_summary", "certificate")

#: Assets of the workload, of one channel each, that fall silent before the last hour.
SILENT = ("silent_for_long", "silent_for_short")


@dataclass(frozen=True)
class StoredJob:
    """What a process is to do.

    Attributes:
        task: ``telemetry``, ``prepare``, ``leave_out``, ``again``, ``score``, ``extract``, ``explain``,
            ``from_nothing``, ``exact``, ``exact_whole``, ``compare`` or ``compare_hour``.
        source: the file of the telemetry.
        state: the file of the state.
        threads: of DuckDB; None for all there are.
        channels, history: size of the telemetry: channels, and ticks (of one second) before the last
            hour; those that fall silent come on top of the channels.
        long_silent, short_silent: ticks after which those two are silent.
        calibration: ticks; None for the first fifth.
        lookback, park_after: ticks; None for what a monitor takes without a word.
        memory_limit: of DuckDB; None for its own.
        left_out: assets that the monitor is not to watch.
    """

    task: str
    source: str
    state: str = ""
    threads: int | None = None
    channels: int = 0
    history: int = 0
    long_silent: int = 0
    short_silent: int = 0
    calibration: int | None = None
    lookback: int | None = None
    park_after: int | None = None
    memory_limit: str | None = None
    left_out: tuple[str, ...] = ()

    def run(self) -> dict[str, Any]:
        """Do the job in a fresh process and return its figures."""
        return alone.run("stored_run", self.task, json.dumps(asdict(self)))


def done(job: StoredJob) -> dict[str, Any]:
    """Do a job; return ``seconds``, ``peak_memory`` in MiB, and what the task itself found."""
    tasks = {
        "telemetry": _telemetry,
        "prepare": _prepare,
        "leave_out": _leave_out,
        "score": _score,
        "extract": _extract,
        "compare_hour": _compare_hour,
        "explain": _explain,
        "from_nothing": _from_nothing,
        "exact": _exact,
        "exact_whole": _exact_whole,
        "compare": _compare,
    }
    if job.task not in tasks:
        raise InternalError(f"The benchmark knows no task {job.task!r}.")
    return alone.measured(lambda: tasks[job.task](job))


def _telemetry(job: StoredJob) -> dict[str, Any]:
    channels = job.channels + len(SILENT)
    slots: dict[str, template.Slot] = {
        "channels": channels,
        "rows": channels * (job.history + HOUR),
        "history": job.history,
        "long_silent": job.long_silent,
        "short_silent": job.short_silent,
    }
    with opened(Path(job.source)) as connection:
        connection.execute(statement("telemetry", slots))
    return {"bytes": Path(job.source).stat().st_size}


@contextmanager
def _session(job: StoredJob, steps: Steps | None = None) -> Iterator[DuckSession]:
    """Open the state, with the telemetry beside it; profiled where steps are given."""
    with opened(Path(job.state), job.threads) as connection:
        if job.memory_limit is not None:
            connection.execute(statement("limited", {"limit": template.text(job.memory_limit)}))
        connection.execute(statement("attached", {"path": template.text(job.source)}))
        with DuckSession(connection) if steps is None else ProfiledSession(connection, steps) as session:
            yield session


def _monitor(job: StoredJob, session: DuckSession) -> Monitor:
    calibration = CALIBRATION
    if job.calibration is not None:
        calibration = gam_db.Calibration(duration=dt.timedelta(seconds=job.calibration))
    return Monitor(
        session,
        gam_db.Source(("telemetry", "main", "readings"), time="t"),
        PARAMETERS,
        calibration,
        lookback=_length(job.lookback),
        park_after=_length(job.park_after),
    )


def _length(ticks: int | None) -> dt.timedelta | None:
    return None if ticks is None else dt.timedelta(seconds=ticks)


def _prepare(job: StoredJob) -> dict[str, Any]:
    """Calibrate, and score all but the last hour."""
    with _session(job) as session:
        monitor = _monitor(job, session)
        monitor.migrate()
        monitor.calibrate()
        monitor.score(until=FIRST + dt.timedelta(seconds=job.history - 1))
    return {}


def _leave_out(job: StoredJob) -> dict[str, Any]:
    """Take the versions of some assets away, as if they had never been calibrated."""
    with opened(Path(job.state)) as connection:
        for asset in job.left_out:
            connection.execute(statement("without", {"asset": template.text(asset)}))
    return {}


def _score(job: StoredJob) -> dict[str, Any]:
    """Score what is new."""
    steps = Steps()
    with _session(job) as session:
        report = _monitor(job, session).score(on_step=steps.begin)
        steps.begin("close")
    steps.begin("")
    return {
        "steps": dict(steps.seconds),
        "channels": len(report.channels),
        "parked": report.parked,
        "queries": len(report.ranges),
        "rows_in_range": sum(row["rows"] for row in report.ranges),
        "new_buckets": sum(row["buckets"] for row in report.channels),
    }


def _extract(job: StoredJob) -> dict[str, Any]:
    """Let the extract script do the same."""
    with opened(Path(job.state), job.threads) as connection:
        connection.execute(statement("attached", {"path": template.text(job.source)}))
        return extract_hour.run(connection, (job.lookback or 0) * 1_000_000)


def _compare_hour(job: StoredJob) -> dict[str, Any]:
    """Compare what the extract script writes with what is scored, integer by integer."""
    figures = _extract(job)
    with _session(job) as session:
        _monitor(job, session).score()
    with opened(Path(job.state), read_only=True) as connection:
        ((missed,),) = connection.execute(statement("hour_missed")).fetchall()
    if missed:
        raise InternalError(f"The stored form and the extract script disagree in {missed} rows.")
    return figures


def _explain(job: StoredJob) -> dict[str, Any]:
    """Score what is new under DuckDB's profiler: which rows of the telemetry are scanned for it?"""
    steps = Steps()
    session: Any
    with _session(job, steps) as session:
        report = _monitor(job, session).score(on_step=steps.begin)
        scans = [
            {"step": step, **scan} for step, profile in session.profiles for scan in _scans(profile)
        ]
    return {
        "scans": scans,
        "rows_scanned": max((scan["rows_scanned"] for scan in scans), default=0),
        "rows_in_range": sum(row["rows"] for row in report.ranges),
    }


def _scans(profile: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield what each scan of the telemetry looked at, and what it was asked for."""
    pending = list(profile["operator"])
    while pending:
        operator = pending.pop()
        pending.extend(operator.get("children", ()))
        details = operator["extra_info"]
        if str(details.get("Table", "")).startswith("telemetry."):
            filters = details.get("Filters", [])
            yield {
                "rows_scanned": operator.get("rows_scanned", 0),
                "rows_found": operator["intermediate_rows"],
                "filters": filters if isinstance(filters, list) else [filters],
            }


def _from_nothing(job: StoredJob) -> dict[str, Any]:
    """Calibrate and score everything into a new state."""
    Path(job.state).unlink(missing_ok=True)
    calibrating, scoring = Steps(), Steps()
    begun: Counter[str] = Counter()

    def note(step: str) -> None:
        begun[step] += 1
        scoring.begin(step)

    with _session(job) as session:
        monitor = _monitor(job, session)
        monitor.migrate()
        calibrating = Steps()
        monitor.calibrate(on_step=calibrating.begin)
        calibrating.begin("")
        scoring = Steps()
        report = monitor.score(on_step=note)
        scoring.begin("close")
    scoring.begin("")
    return {
        "calibrate": sum(calibrating.seconds.values()),
        "score": sum(scoring.seconds.values()),
        "calibrate_steps": dict(calibrating.seconds),
        "score_steps": dict(scoring.seconds),
        "groups": begun["writing"],
        "buckets": sum(row["buckets"] for row in report.channels),
        "state_bytes": Path(job.state).stat().st_size,
    }


def _exact(job: StoredJob) -> dict[str, Any]:
    """Compute the exact form up to its bucket values, calibration included."""
    with opened(Path(job.source), job.threads, read_only=True) as connection:
        buckets = gam_db.health_at_buckets(
            gam_db.Source("readings", time="t"), PARAMETERS, CALIBRATION, connection
        )
    return {"buckets": buckets.num_rows}


def _exact_whole(job: StoredJob) -> dict[str, Any]:
    """Compute by the exact form all that the stored form holds, and write it."""
    result = Path(job.state).with_name("exact_whole.duckdb")
    result.unlink(missing_ok=True)
    source = gam_db.Source("readings", time="t")
    with opened(Path(job.source), job.threads) as connection, DuckSession(connection) as session:
        study = Study(session, source, PARAMETERS, CALIBRATION, short_cuts=True, targets=WHOLE)
        for step in WHOLE:
            study.write(step, result, step)
    return {}


def _compare(job: StoredJob) -> dict[str, Any]:
    """Compare what is stored with the exact form, integer by integer."""
    with opened(Path(job.state), read_only=True) as connection:
        stored = connection.sql(statement("stored_buckets")).to_arrow_table()
    with opened(Path(job.source), read_only=True) as connection:
        exact = gam_db.health_at_buckets(
            gam_db.Source("readings", time="t"), PARAMETERS, CALIBRATION, connection
        )
    for column in stored.column_names:
        if not stored.column(column).equals(exact.column(column)):
            raise InternalError(f"The stored and the exact form disagree in the column {column}.")
    return {"buckets": stored.num_rows}


if __name__ == "__main__":
    alone.answer(lambda job: done(StoredJob(**json.loads(job))))
