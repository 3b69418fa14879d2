"""gam-db at work, and where inside it the time goes."""

import json
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.benchmark.database import opened
from gam_db.study import Study

PARAMETERS = gam_db.Parameters.paper()
CALIBRATION = gam_db.Calibration(fraction=0.2)
RESULTS = ("bucket_health", "novel_cells")

#: What Study does before its first step: open the file, look at the columns, make the SQL.
FIRST = "look"


class Steps:
    """A clock that is told which step begins; a statement belongs to the step told last."""

    def __init__(self) -> None:
        self.now = FIRST
        self.seconds: defaultdict[str, float] = defaultdict(float)
        self._since = time.perf_counter()

    def begin(self, step: str) -> None:
        """End the step under way and begin another."""
        now = time.perf_counter()
        self.seconds[self.now] += now - self._since
        self.now, self._since = step, now


class ProfiledSession(DuckSession):
    """A session that keeps DuckDB's profile (EXPLAIN ANALYZE) of every statement it runs."""

    def __init__(self, target: Any, steps: Steps) -> None:
        super().__init__(target)
        self.connection.execute("SET enable_profiling = 'no_output'")
        self.profiles: list[tuple[str, dict[str, Any]]] = []
        self._steps = steps

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Do so, and keep the profile."""
        table = super().keep(step, query)
        self._note()
        return table

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Do so, and keep the profile."""
        rows = super().fetch(query)
        self._note()
        return rows

    def _run(self, tree: exp.Expr) -> None:
        super()._run(tree)
        if isinstance(tree, exp.Create):
            self._note()

    def _note(self) -> None:
        profile = json.loads(self.connection.get_profiling_information(format="json"))
        if "operator" in profile:  # there is none where statistics of the table were the answer
            self.profiles.append((self._steps.now, profile))


def run(source: Path, result: Path, threads: int) -> dict[str, float]:
    """Compute both results and write each as a table; return the seconds of every step."""
    steps = Steps()
    with opened(source, threads) as connection, DuckSession(connection) as session:
        _write(session, result, steps)
        steps.begin("close")
    steps.begin("")
    return dict(steps.seconds)


def explain(source: Path, result: Path, threads: int) -> list[dict[str, Any]]:
    """Do the same under DuckDB's profiler; return the seconds by step and kind of operator.

    The seconds are those of all threads together; the profiler itself costs a little.
    """
    steps = Steps()
    with opened(source, threads) as connection:
        session = ProfiledSession(connection, steps)
        with session:
            _write(session, result, steps)
    return [
        {"step": step, "operator": operator, "seconds": seconds, "rows": rows}
        for (step, operator), (seconds, rows) in _added(session.profiles).items()
    ]


def _write(session: DuckSession, result: Path, steps: Steps) -> None:
    table = gam_db.Source("readings", time="t")
    study = Study(
        session, table, PARAMETERS, CALIBRATION, on_step=steps.begin, short_cuts=True, targets=RESULTS
    )
    for step in RESULTS:
        study.write(step, result, step)


def _added(profiles: list[tuple[str, dict[str, Any]]]) -> dict[tuple[str, str], tuple[float, int]]:
    total: dict[tuple[str, str], tuple[float, int]] = {}
    for step, profile in profiles:
        pending = list(profile["operator"])
        while pending:
            operator = pending.pop()
            pending.extend(operator.get("children", ()))
            key = step, str(operator["type"])
            seconds, rows = total.get(key, (0.0, 0))
            total[key] = seconds + operator["timing"], rows + operator["intermediate_rows"]
    return total
