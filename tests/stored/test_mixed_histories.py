"""Histories with everything in the mix end in the tables of one full run, on engines of each kind.

Repairs, full runs, two writers at once, runs cut short, pruning, new versions, a clock that
jumps, rows that come late, too late (a repair follows) and again.
"""

import contextlib
import time
from typing import Any

import pytest

import comparisons
import engines
import frozen
import gam_db
import harness
import scripts
from batches import KINDS, History, history
from gam_db.engines.session import Session
from gam_db.errors import ConflictError, ParameterError
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning.steps import DAY
from sets import amounts
from strategies import Row
from visible import BUCKETS, NOVEL, CrashError, crashing, visible

pytestmark = pytest.mark.thorough

#: Histories of an engine in the first set and in the full one; each is one of so many channels.
HISTORIES = {
    "duckdb": (1, 400),
    "sqlite": (1, 200),
    "postgres": (1, 100),
    "mariadb": (1, 60),
    "clickhouse": (1, 12),
}
CHANNELS = 12

ACTIVE = "WHERE version_id IN (SELECT MAX(version_id) FROM gam_state_version GROUP BY channel_id)"


class Course:
    """A history as it happens on an engine."""

    def __init__(self, session: Session, told: History, patched: pytest.MonkeyPatch) -> None:
        self.session, self.told, self.patched = session, told, patched
        self.method = harness.made(told.parameters, told.calibration)
        self.arrived = list(told.first)
        self.first = list(told.first)  # what was there when the newest version was made
        self.table = scripts.telemetry(session, told.first)
        self.prefix = engines.fresh_name("mixed")

    def monitor(self) -> Monitor:
        reach: dict[str, Any] = {"lookback": self.told.lookback, "park_after": self.told.park_after}
        source = gam_db.Source(self.table.name)
        return Monitor(self.session, source, *self.method, prefix=self.prefix, **reach)

    def play(self) -> None:
        """Let it happen."""
        self.monitor().migrate()
        self.monitor().calibrate(limit=self.told.limit)
        for batch in self.told.batches:
            if batch.rows:
                scripts.arrive(self.session, self.table, batch.rows)
                self.arrived += batch.rows
            for what, number in batch.runs:
                self.do(what, number)

    def do(self, what: str, number: int) -> None:
        limit: dict[str, Any] = {"limit": self.told.limit}
        mine = self.monitor()
        if what == "recalibrate":
            mine.calibrate(again=True, **limit)
            self.first = list(self.arrived)
        elif what == "clock":
            true = self.true_time
            self.patched.setattr(time, "time_ns", lambda: true() + number * 1000 * DAY)
        elif what == "prune":
            mine.prune(keep=number)
        elif what == "hidden":
            mine.prune()
        elif what == "crash":
            with contextlib.suppress(CrashError):
                mine.score(on_step=crashing(number), **limit)
        elif what.startswith("beside"):
            self.beside(what.removeprefix("beside "), number)
        else:
            options: dict[str, Any] = {"from": {"since": number}, "score": {}}.get(what, {what: True})
            try:
                mine.score(**options, **limit)
            except ParameterError:  # it repairs nothing where nothing is scored yet
                assert what == "from"
                mine.score(**limit)

    true_time = staticmethod(time.time_ns)

    def beside(self, what: str, number: int) -> None:
        """Let a second writer work from beginning to end inside a run, which may then be refused."""
        heard = 0

        def listen(_: str) -> None:
            nonlocal heard
            heard += 1
            if heard == number:
                self.do(what, number)

        try:
            self.monitor().score(on_step=listen, limit=self.told.limit)
        except ConflictError:
            self.do("score", 0)

    def seen(self, query: str) -> list[dict[str, Any]]:
        return visible(self.monitor(), query.replace("ORDER", f"{ACTIVE} ORDER"))

    def assert_as_one_full_run(self) -> None:
        """Compare what is seen of the active versions; of pruned ones the buckets that are left."""
        asked = (self.first, self.told.final, *self.method)
        shown = self.seen(BUCKETS)
        left = {key(row) for row in shown}
        for expected, found, what in (
            (frozen.buckets(*asked), shown, "buckets"),
            (frozen.novel_cells(*asked), self.seen(NOVEL), "novel cells"),
        ):
            wanted = [row for row in expected if key(row) in left] if self.told.is_pruned else expected
            harness.assert_same(wanted, found, what)
        # Late rows may belong to calibration; all else is as the source and the state say.
        wrong = [row for row in self.monitor().check_state().to_pylist() if row["part"] != "calibration"]
        assert not wrong


def key(row: dict[str, Any]) -> tuple[Any, ...]:
    return row["asset"], row["channel"], row["bucket"]


@amounts("is_full", False, True)
def test_any_mix_ends_in_the_tables_of_one_full_run(engine: str, is_full: bool) -> None:
    for seed in range(HISTORIES[engine][is_full]):
        told = history(KINDS[seed % len(KINDS)], seed, CHANNELS, mixed=True)
        engines.begin(engine)
        with pytest.MonkeyPatch.context() as patched:
            course = Course(engines.session(engine), told, patched)
            course.play()
        course.assert_as_one_full_run()
        rows: list[Row] = told.final
        comparisons.compared(engine, "stored", rows, *course.method, course.first)
