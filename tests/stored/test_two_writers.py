"""One writer at a time, enforced: what commits while a run is at work is never lost.

A second writer works from beginning to end inside the first one, at each step that the first announces.
Then either both count, or the first one is refused and does it again; the tables are those of one full
run, by the NumPy reference.
"""

import contextlib
import itertools
import re
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from sqlglot import exp

import engines
import frozen
import gam_db
import harness
import scripts
import stored_rows
from gam_db.composing import plan
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import ConflictError, UserError
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.scoring import publishing
from gam_db.stored.state import State
from gam_db.study.running import Listener
from state_names import called
from strategies import Row
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=4, window=8, stride=2)
CALIBRATION = gam_db.Calibration(fraction=0.8)
ASSETS = ("a", "b")
FIRST, LOOKBACK = 40, 1

ACTIVE = "WHERE version_id IN (SELECT MAX(version_id) FROM gam_state_version GROUP BY channel_id)"

#: New rows of each channel before a run, and how far behind their end one of them comes a run too late.
NEW, LATE = 9, 7


@dataclass
class Plant:
    """A monitor over a source that grows; each time some rows come later than a run allows for."""

    session: Session
    rows: list[Row] = field(default_factory=list)
    end: int = 0
    table: Any = None
    prefix: str = ""

    def begin(self) -> None:
        """Freeze calibration."""
        first = self.grown(FIRST, late=False)
        self.table = scripts.telemetry(self.session, first)
        self.prefix = engines.fresh_name("writers")
        self.first = list(first)
        mine = self.monitor()
        mine.migrate()
        mine.calibrate()
        self.arrive(self.grown(NEW))
        mine.score()

    def monitor(self, lookback: int = LOOKBACK) -> Monitor:
        source = gam_db.Source(self.table.name)
        return Monitor(
            self.session, source, PARAMETERS, CALIBRATION, lookback=lookback, prefix=self.prefix
        )

    def grown(self, length: int, late: bool = True) -> list[Row]:
        """Return the next rows: one of each channel is left out, and comes with the call after it."""
        times = range(self.end, self.end + length)
        made = [
            (asset, "x", time, float((time * (number + 1)) % 5 if time % 6 else 7 * number))
            for number, asset in enumerate(ASSETS)
            for time in times
        ]
        held = {self.end + length - LATE} if late else set()
        before, self.left = getattr(self, "left", []), [row for row in made if row[2] in held]
        self.end += length
        return [row for row in made if row[2] not in held] + [(*row[:3], 99.0) for row in before]

    def arrive(self, rows: list[Row]) -> None:
        scripts.arrive(self.session, self.table, rows)
        self.rows += rows

    def assert_as_one_full_run(self, is_pruned: bool = False) -> None:
        """Compare what is seen of the active versions; of pruned ones the buckets that are left."""
        asked = (self.first, [*self.first, *self.rows], PARAMETERS, CALIBRATION)
        for expected, query in ((frozen.buckets, BUCKETS), (frozen.novel_cells, NOVEL)):
            found = visible(self.monitor(), query.replace("ORDER", f"{ACTIVE} ORDER"))
            wanted = expected(*asked)
            if is_pruned:
                assert found or query is NOVEL
                left = {(row["asset"], row["bucket"]) for row in found}
                wanted = [row for row in wanted if (row["asset"], row["bucket"]) in left]
            harness.assert_same(wanted, found, query)

    def steps(self, command: Callable[[Listener], Any]) -> list[str]:
        """Return the steps that a command announces, each once."""
        found: list[str] = []
        command(found.append)
        return list(dict.fromkeys(found))


#: What a second writer does, so that the late rows count.
REPAIRS: dict[str, Callable[[Plant], Any]] = {
    "from": lambda plant: plant.monitor().score(since=plant.end - NEW - LATE),
    "full": lambda plant: plant.monitor().score(full=True),
    "lookback": lambda plant: plant.monitor(lookback=3 * NEW).score(),
}


def inside(step: str, second: Callable[[], Any]) -> Listener:
    """Return a listener in which a second writer works from beginning to end, once, at a step."""
    waiting = [step]

    def listen(announced: str) -> None:
        if announced in waiting:
            waiting.remove(announced)
            second()

    listen.waiting = waiting  # type: ignore[attr-defined]
    return listen


@pytest.fixture
def plant(engine: str) -> Plant:
    made = Plant(engines.session(engine))
    made.begin()
    return made


def played(plant: Plant, steps: dict[str, Callable[[Plant], Any]]) -> list[str]:
    """Let a second writer work at each step of a run of its own; return where the run was refused."""
    refused = []
    for step, second in steps.items():
        plant.arrive(plant.grown(NEW))
        listen = inside(step, lambda second=second: second(plant))  # type: ignore[misc]
        try:
            plant.monitor().score(on_step=listen)
        except ConflictError as error:
            refused.append(step)
            said = str(error)
            assert re.search("run it again", said, re.IGNORECASE), said
            plant.monitor().score()
        assert not listen.waiting, step  # type: ignore[attr-defined]
        plant.assert_as_one_full_run()
    return refused


def steps_of_a_run(plant: Plant) -> list[str]:
    """Return the steps that a run announces."""
    plant.arrive(plant.grown(NEW))
    steps = plant.steps(lambda heard: plant.monitor().score(on_step=heard))
    plant.monitor().score(full=True)
    return steps


def test_a_repair_inside_a_run_is_not_lost(plant: Plant) -> None:
    """Each kind of repair at every third step, or at three steps; all at all are in the full set."""
    steps = ["reading the source", "past_buckets", "writing"]
    if plant.session.engine.name == "duckdb":
        steps = steps_of_a_run(plant)
    repairs = dict(zip(steps, itertools.cycle(REPAIRS.values()), strict=False))
    assert "writing" in played(plant, repairs)


@pytest.mark.full
@pytest.mark.parametrize("repair", REPAIRS)
def test_no_repair_inside_a_run_is_lost(plant: Plant, repair: str) -> None:
    steps = dict.fromkeys(steps_of_a_run(plant), REPAIRS[repair])
    assert {"writing", "past_buckets"} <= set(played(plant, steps))


#: What else may change what a run was planned from.
OTHERS: dict[str, Callable[[Plant], Any]] = {
    "calibrate": lambda plant: plant.monitor().calibrate(again=True),
    "prune": lambda plant: plant.monitor().prune(keep=NEW),
    "hidden": lambda plant: plant.monitor().prune(),
}


@pytest.mark.parametrize("other", OTHERS)
def test_versions_and_pruning_beside_a_repair(plant: Plant, other: str) -> None:
    """Calibrating and pruning inside a repair that begins before all that is kept."""
    is_pruned = other == "prune"  # what comes late to pruned buckets is not counted any more
    plant.arrive(plant.grown(NEW, late=not is_pruned))
    plant.monitor().score(full=True)
    is_duckdb = plant.session.engine.name == "duckdb"
    for step in ("reading the source", "past_buckets", "writing") if is_duckdb else ("past_buckets",):
        plant.arrive(plant.grown(NEW, late=not is_pruned))
        plant.monitor().score()
        listen = inside(step, lambda: OTHERS[other](plant))
        since = plant.end - 4 * NEW
        if other == "calibrate":
            with pytest.raises(ConflictError, match="Run it again"):
                plant.monitor().score(since=since, on_step=listen)
            plant.first = [*plant.first, *plant.rows]
            plant.monitor().score()
        else:
            with contextlib.suppress(ConflictError):
                plant.monitor().score(since=since, on_step=listen)
            plant.monitor().score(since=since)
        assert not listen.waiting, step  # type: ignore[attr-defined]
        plant.assert_as_one_full_run(is_pruned)


@pytest.mark.parametrize(
    "steps", [("names", "writing"), pytest.param((), marks=pytest.mark.full)], ids=["two", "all"]
)
def test_two_monitors_of_one_name_give_no_key_twice(engine: str, steps: tuple[str, ...]) -> None:
    """One calibrates inside the other, at a step of it, up to the one that writes."""
    first = Plant(engines.session(engine))
    first.table = scripts.telemetry(first.session, first.grown(FIRST, late=False))
    first.prefix = engines.fresh_name("writers")
    first.monitor().migrate()
    announced = first.steps(lambda heard: first.monitor().calibrate(on_step=heard))
    refused = []
    for step in steps or announced[: announced.index("writing") + 1]:
        again = Plant(first.session, table=first.table, prefix=engines.fresh_name("writers"))
        again.monitor().migrate()
        listen = inside(step, lambda plant=again: plant.monitor().calibrate())  # type: ignore[misc]
        try:  # before it has looked at what there is, it finds nothing left to do
            assert again.monitor().calibrate(on_step=listen).num_rows == 0
        except ConflictError:
            refused.append(step)
        assert again.monitor().calibrate().num_rows == 0
        found = again.monitor().state.keys()
        assert (found["monitor"], found["channel"], found["version"]) == (1, len(ASSETS), len(ASSETS))
    assert "writing" in refused


def test_of_three_runs_at_once_on_sqlite_no_hidden_row_stays(tmp_path: Path) -> None:
    """Each has planned before any writes; DuckDB and PostgreSQL have tests of their own."""
    address = f"sqlite:///{tmp_path / 'plant.db'}"
    with gam_db.connect(address) as session:
        plant = Plant(session)
        plant.begin()
        plant.arrive(plant.grown(NEW, late=False))
        plant.monitor().score(full=True)
        for full in (False, True):
            plant.arrive(plant.grown(NEW, late=False))
            barrier = threading.Barrier(3, timeout=60)
            refused: list[type] = []

            def run(
                full: bool = full,
                barrier: threading.Barrier = barrier,
                refused: list[type] = refused,
            ) -> None:
                with gam_db.connect(address) as own:
                    mine = Plant(own, table=plant.table, prefix=plant.prefix).monitor()
                    try:
                        mine.score(full=full, on_step=inside("writing", barrier.wait))
                    except UserError as error:
                        refused.append(type(error))

            threads = [threading.Thread(target=run) for _ in range(3)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            assert refused == [ConflictError] * 2
            plant.assert_as_one_full_run()
            for table in ("bucket", "novel"):
                counted = f"SELECT COUNT(*) AS n FROM {called(table)}"
                shown = f"SELECT COUNT(*) AS n FROM {called(f'visible_{table}')}"
                assert visible(plant.monitor(), counted) == visible(plant.monitor(), shown)


# Engines without transactions


def assert_one_stays(session: Session, first_to_look: str) -> None:
    """Stop two runs that were planned from the same between their last row and their look at others.

    Tests of engines without transactions call it; elsewhere the second waits, or is refused inside.

    Args:
        session: on such an engine.
        first_to_look: which of the two goes on first: smaller, larger (by run id), or "larger before the
            other's row".
    """
    plant = Plant(session)
    plant.begin()
    for _ in range(2):
        plant.arrive(plant.grown(NEW))
    append, look = plan.insertion, publishing.look_again
    committing: list[str] = []
    looks: dict[str, Callable[[], None]] = {}

    def appending(table: exp.Table, rows: exp.Query) -> exp.Insert:
        """Let the second one run once the first has compared for the last time."""
        if table.name.endswith("state_run") and not committing:
            committing.append(table.name)
            plant.monitor().score(full=True)
        return append(table, rows)

    def looking(*asked: Any) -> None:
        if not looks:
            looks["larger"] = lambda: look(*asked)
            if first_to_look.startswith("larger before"):
                look(*asked)
            return
        looks["smaller"] = lambda: look(*asked)
        assert run_ids(plant) == 2
        shown = [(row["asset"], row["bucket"]) for row in visible(plant.monitor(), BUCKETS)]
        assert len(shown) == len(set(shown))
        refused = []
        for which in sorted(looks, key=lambda which: which != first_to_look.split()[0]):
            try:
                if which == "smaller" or not first_to_look.endswith("row"):
                    looks[which]()
            except ConflictError:
                refused.append(which)
        outcomes.extend(refused)
        if "smaller" in refused:
            raise ConflictError("the first")

    outcomes: list[str] = []
    with pytest.MonkeyPatch.context() as patched, contextlib.suppress(ConflictError):
        patched.setattr(publishing, "_PATIENCE", 0.2)
        patched.setattr("gam_db.study.running.insertion", appending)
        patched.setattr("gam_db.stored.scoring.portion.look_again", looking)
        # The second one looks when its run has ended: by the tables of that run.
        patched.setattr("gam_db.study.running.Running.forget", lambda *_, **__: None)
        plant.monitor().score()
    # The larger one gives way where it still looks; where it has ended, its result stays.
    assert outcomes == ["larger" if first_to_look == "larger" else "smaller"]
    plant.monitor().score(full=outcomes == ["larger"])
    plant.assert_as_one_full_run()
    plant.monitor().prune()
    plant.assert_as_one_full_run()


def assert_a_run_planned_from_another_is_no_rival(session: Session) -> None:
    """Let a second run be planned from one, and end, between the last row of this one and its look."""
    plant = Plant(session)
    plant.begin()
    plant.arrive(plant.grown(NEW))
    look = publishing.look_again
    looks: list[int] = []

    def looking(*asked: Any) -> None:
        looks.append(asked[-1])
        if len(looks) == 1:
            plant.arrive(plant.grown(NEW))
            plant.monitor(2 * NEW).score()
        look(*asked)

    with pytest.MonkeyPatch.context() as patched:
        patched.setattr("gam_db.stored.scoring.portion.look_again", looking)
        plant.monitor(2 * NEW).score()
    assert len(looks) == 2
    assert run_ids(plant) == 2
    plant.assert_as_one_full_run()


def run_ids(plant: Plant) -> int:
    """Return how many runs have rows since the first one."""
    counted = "SELECT COUNT(DISTINCT run_id) - 1 AS runs FROM gam_state_run WHERE withdrawn IS NULL"
    return int(visible(plant.monitor(), counted)[0]["runs"])


@pytest.mark.parametrize("kind", ["monitor", "channel", "version"])
def test_a_key_that_is_there_twice_is_told(kind: str) -> None:
    """Without transactions two writers may both have given it."""
    plant = stored_rows.Plant()
    plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    (row,) = plant.tables[kind]
    plant.tables[kind].append(dict(row))
    with DuckSession() as session:
        plant.write(session, StateTables())
        found = State(session, StateTables()).fetch("stored/state/doubled").to_pylist()
    assert found == [{"kind": kind, "doubled_id": row[f"{kind}_id"]}]
