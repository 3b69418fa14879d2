"""Runs with no Python: what `run.sql` leaves is what `gam score` leaves, number for number."""

import contextlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from sqlglot import exp

import command_lines
import engines
import gam_db
import harness
import scripts
import sets
import test_stored_alarms
from batches import History, history
from gam_db.clock import TimeKind
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import UserError
from gam_db.export.monitor import rendered
from gam_db.stored.monitor import Monitor
from harness import Row
from visible import CrashError, crashing, visible

pytestmark = pytest.mark.thorough

#: Engines whose command lines execute it.
RUNS = ("duckdb", "sqlite", "postgres", "mariadb")

#: Tables that a run writes, and their columns; the numbers of runs differ, and their order counts.
TABLES = {
    "bucket": """version_id, bucket_no, run_id, first_time, last_time, context_time, samples, still,
        novel, out_of_range, novel_in_window""",
    "novel": "version_id, bucket_no, run_id, cell_key, visits, first_time, last_time",
    "run": """version_id, run_id, planned_from, from_bucket, read_from, read_to, rows_read, context_rows,
        context_expected, calibration_readings, lookback, settled_bucket, settled_time, settled_context,
        still_since, hides, made_from, withdrawn""",
    "judgement": """version_id, bucket_no, run_id, judgement_no, first_time, last_time, novel, root,
        reference, height, evidence, is_open, last_zero""",
    "proof": "extent, channels, versions, buckets, differences",
    "unplaced": "nameless, undated, strangers, stranger_channels",
    "left_out": "kind, asset, channel, readings, latest",
}

Stored = dict[str, list[dict[str, Any]]]


def stored(monitor: Monitor) -> Stored:
    """Return the rows of these tables, in order."""
    found = {
        name: visible(monitor, f"SELECT {columns} FROM gam_state_{name}")
        for name, columns in TABLES.items()
    }
    numbers: dict[int, list[int]] = {}
    for row in found["run"]:
        numbers.setdefault(row["version_id"], []).append(row["run_id"])
    for rows in found.values():
        for row in rows:
            for name in row.keys() & {"run_id", "planned_from"}:
                row[name] = sum(number <= row[name] for number in numbers[row["version_id"]])
        rows.sort(key=repr)
    return found


def assert_same(score: Stored, script: Stored, when: str) -> None:
    for name, rows in score.items():
        for number, (one, other) in enumerate(zip(rows, script[name], strict=False)):
            assert one == other, f"{name}, row {number}, {when}"
        assert len(rows) == len(script[name]), f"{name}, {when}"


def executed(engine: str, folder: Path, session: Session, script: str) -> None:
    ended = command_lines.executed(engine, folder, session, script)
    assert ended.returncode == 0, ended.stderr.decode()
    assert ended.stdout == b"", "cron sends what a command prints"


# Histories

Play = Callable[[Path, bool], Iterator[Stored]]


def assert_alike(folder: Path, play: Play) -> None:
    """Let something happen twice, and compare what is stored on the way."""
    places = [folder / "score", folder / "script"]
    for place in places:
        place.mkdir()
    both = map(play, places, (False, True))
    for number, (score, script) in enumerate(zip(*both, strict=True)):
        assert_same(score, script, f"after batch {number}")


def played(engine: str, told: History, folder: Path, is_script: bool) -> Iterator[Stored]:
    """Let a history happen, its runs by a script or not, and the last one by Python in any case."""
    with contextlib.closing(command_lines.opened(engine, folder)) as session:
        table = scripts.telemetry(session, told.first)
        parameters, calibration = harness.made(told.parameters, told.calibration)
        reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
        place, prefix = gam_db.Source(table.name), engines.fresh_name("runs")
        monitor = Monitor(session, place, parameters, calibration, prefix=prefix, **reach)
        monitor.migrate()
        monitor.calibrate()
        script = rendered(monitor)
        for batch in told.batches:
            if batch.rows:
                scripts.arrive(session, table, batch.rows)
            is_last = batch is told.batches[-1]
            for kind, number in batch.runs:
                if kind == "crash":
                    with contextlib.suppress(CrashError):
                        monitor.score(on_step=crashing(number))
                elif is_script and not is_last:
                    executed(engine, folder, session, script)
                else:
                    monitor.score(everything=is_last)
            yield stored(monitor)
        (age,) = visible(monitor, "SELECT age_seconds FROM gam_last_run")
        assert 0 <= age["age_seconds"] < 3600


#: Histories of an engine, in the first set and in the full one.
HISTORIES: dict[str, tuple[list[tuple[str, int]], list[tuple[str, int]]]] = {
    "duckdb": (
        [("given start", 2)],
        [(kind, seed) for kind in ("short form", "pauses", "given start") for seed in range(2, 8)]
        + [(kind, seed) for kind in ("pools", "still samples") for seed in range(1, 8)],
    ),
    "sqlite": ([("still samples", 0)], [("pools", 1), ("pauses", 0), ("short form", 3)]),
    "postgres": ([("still samples", 0)], [("pools", 1), ("pauses", 0), ("short form", 3)]),
    "mariadb": ([("pools", 1)], [("still samples", 0), ("given start", 1)]),
}


def is_refused(engine: str) -> bool:
    """Tell whether no script is printed for an engine, which must say so in one sentence."""
    if engine in RUNS:
        return False
    with pytest.raises(UserError, match=r"(needs|use) Python \(gam score\)"):
        rendered(Monitor(engines.session(engine), gam_db.Source("telemetry")))
    return True


@sets.amounts("is_full", False, True)
def test_a_history_leaves_what_gam_score_leaves(engine: str, is_full: bool, tmp_path: Path) -> None:
    if is_refused(engine):
        return
    for kind, seed in HISTORIES[engine][is_full]:
        told = history(kind, seed, 30 if is_full else 5)
        folder = tmp_path / f"{kind} {seed}"
        folder.mkdir()
        assert_alike(folder, lambda place, by: played(engine, told, place, by))  # noqa: B023


# Calendar time, and what comes once a day

METHOD = harness.made({"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.7})
#: Channels of two lists, in one of which windows have as many buckets as they like.
MIXED = harness.made(
    {
        **{"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5, "least_vectors": 20},
        "overrides": [{"asset": "b", "m": 1}, {"asset": "c", "window": 10}],
    },
    {"fraction": 0.7},
)
SECOND = 1_000_000
DAY = 86_400 * SECOND
BEGIN = 1_793_000_000 * SECOND


def readings(assets: str, start: int, end: int) -> list[Row]:
    """Channels of a sample a second that repeat a pattern, and later on less so."""
    return [
        (asset, "x", BEGIN + time * SECOND, float(time % (5 + n) if time % 37 < 20 else time % 11))
        for n, asset in enumerate(assets)
        for time in range(start, end)
    ]


def doubled(rows: list[Row]) -> list[Row]:
    """Some of the rows, with another value."""
    return [(*row[:3], 7.5) for row in rows[::9]]


#: A second that lies ahead of every clock.
AHEAD = 10**9

NOTHING = range(0)

#: What comes before each run, which seconds the source loses, and whether a day passes. One channel
#: falls silent, and sends again; rows come late and twice, belong nowhere, or are lost.
COURSE: list[tuple[list[Row], range, bool]] = [
    (readings("abc", 120, 200), NOTHING, False),
    (readings("ab", 200, 260) + doubled(readings("a", 240, 260)), NOTHING, False),
    (readings("ab", 260, 262) + readings("z", 255, 262) + readings("b", 150, 152), NOTHING, False),
    ([], NOTHING, True),
    (readings("ab", 262, 400) + readings("a", AHEAD, AHEAD + 3), NOTHING, False),
    ([*readings("ab", 400, 440), ("c", "x", BEGIN + 420 * SECOND, None)], NOTHING, False),
    (readings("abc", 440, 470), range(380, 420), False),
    (readings("abc", 470, 500), range(-120, 465), False),
    (readings("abc", 500, 560), NOTHING, True),
]


def course(engine: str, folder: Path, is_script: bool) -> Iterator[Stored]:
    """Let it happen."""
    with contextlib.closing(command_lines.opened(engine, folder)) as session:
        time: exp.Expr = session.engine.instant_of(TimeKind.TIMESTAMP, exp.column("time"))
        if engine == "sqlite":
            time = exp.cast(time, "TEXT")
        table = scripts.telemetry(session, readings("abc", -120, 120), time)
        place, prefix = gam_db.Source(table.name), engines.fresh_name("days")
        kept: dict[str, Any] = {"prefix": prefix, "lookback": "30 s", "park_after": "60 s"}
        asked = gam_db.Alarms("100 per 1000 judgements")
        monitor = Monitor(session, place, *MIXED, asked, **kept)
        monitor.migrate()
        monitor.calibrate()
        script = rendered(monitor)
        for rows, lost, is_later in COURSE:
            if rows:
                scripts.arrive(session, table, rows, time)
            if lost:
                ends = [
                    session.engine.instant_of(
                        TimeKind.TIMESTAMP, exp.Literal.number(BEGIN + second * SECOND)
                    )
                    for second in (lost.start, lost.stop)
                ]
                time_of = exp.column("time", quoted=True)
                gone = exp.Where(this=exp.and_(time_of >= ends[0], time_of.copy() < ends[1]))
                session.execute(exp.Delete(this=table.copy(), where=gone))
            if is_later:  # all that was done lies two days back
                for name, columns in _TIMES.items():
                    back: dict[str, object] = {one: exp.column(one) - 2 * DAY for one in columns}
                    session.execute(exp.update(monitor.tables.table(name), back))
            if is_script:
                executed(engine, folder, session, script)
            else:
                monitor.score()
            yield stored(monitor)


_TIMES = {"run": ("started", "committed"), "proof": ("proved_at",), "monitor": ("created",)}


def test_what_is_silent_late_lost_or_due_is_as_gam_score_has_it(engine: str, tmp_path: Path) -> None:
    if not is_refused(engine):
        assert_alike(tmp_path, lambda folder, is_script: course(engine, folder, is_script))


def test_a_longer_lookback_than_before_searches_the_buckets(tmp_path: Path) -> None:
    """What the run before has recorded holds for its own lookback alone."""

    def play(folder: Path, is_script: bool) -> Iterator[Stored]:
        with contextlib.closing(command_lines.opened("duckdb", folder)) as session:
            table = scripts.telemetry(session, readings("ab", 0, 120))
            given = session, gam_db.Source(table.name), *METHOD
            Monitor(*given).migrate()
            Monitor(*given).calibrate()
            held = readings("a", 230, 240)
            scripts.arrive(session, table, [row for row in readings("ab", 120, 300) if row not in held])
            Monitor(*given, lookback=SECOND).score()
            scripts.arrive(session, table, held)
            wider = Monitor(*given, lookback=100 * SECOND)
            if is_script:
                executed("duckdb", folder, session, rendered(wider))
            else:
                wider.score()
            found = stored(wider)
            first = min(row["from_bucket"] for row in found["run"] if row["run_id"] == 2)
            assert 0 < first < max(row["bucket_no"] for row in found["bucket"]) - 10
            yield found

    assert_alike(tmp_path, play)


# Judgements and episodes


class Scripted(test_stored_alarms.Course):
    """Alarms that grow, mostly by a script."""

    def do(self, what: str) -> None:
        if what == "score":
            script = rendered(self.monitor())
            executed(self.session.engine.name, Path(), self.session, script)
        else:
            super().do(what)


@pytest.mark.full
@pytest.mark.parametrize("seed", range(2, 30))
def test_alarms_that_grow_by_scripts_are_those_of_all_at_once(seed: int) -> None:
    plant = Scripted("duckdb", seed)
    plant.play()
    plant.assert_as_at_once()


class ScriptedPlant(test_stored_alarms.Plant):
    """A channel whose windows are judged by a script, but where gam score is named."""

    def score(self, *counts: int, **options: Any) -> None:
        by_python = options.pop("by_python", False)
        with pytest.MonkeyPatch.context() as patched:
            if not by_python:
                patched.setattr(self.monitor, "score", self.run)
            super().score(*counts, **options)

    def run(self) -> None:
        executed("duckdb", Path(), self.session, rendered(self.monitor))


def test_the_next_gam_score_opens_and_ends_the_episodes_of_scripts() -> None:
    """Also those that began more than ten judgements ago, from where it looks by itself."""
    with DuckSession() as session:
        plant = ScriptedPlant(session)
        plant.score(0, 4, 4, 4)
        plant.score(*[0] * 30)
        assert plant.told() == []
        assert {row["part"] for row in plant.monitor.check_state().to_pylist()} == set()
        plant.score(0, by_python=True)
        assert plant.told() == [(1, "opened"), (1, "ended")]
        plant.score(4, 4, 4)
        plant.monitor.score()
        assert plant.told() == [(1, "opened"), (1, "ended"), (2, "opened")]
