"""Killed at any moment (kill -9, Java and all), a run on Spark leaves a state that it passes through.

What a kill leaves is the folder as it is at that moment. So one test stops all processes of a run,
Java included, for as long as the folder is copied (``kill -STOP``), tens of times in a run, and looks at
the copies; it costs one warm run instead of a cold Java for every kill. Another one kills: a victim
scores one batch more than the one before it, and every second one is killed while it writes. What is in
a folder is looked at by DuckDB, so that looking takes no second Spark.
"""

import io
import itertools
import os
import random
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import duckdb
import pytest

import comparisons
import engines
import frozen
import gam_db
import harness
import spark_victim
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.spark.folder import Folder
from gam_db.stored.schema.tables import StateTables
from killed_plant import CALIBRATION, PARAMETERS, plant
from stored_rows import emptied
from strategies import Row
from victims import Moment, is_at_work
from visible import BUCKETS, NOVEL, rows_of

#: A kill takes some twenty seconds.
KILLS = int(os.environ.get("GAM_SPARK_KILLS", "10"))

#: Copies of the folder that are looked at, and those of them that are gone on with.
COPIES, RESUMED = 20, 1

#: What is seen of each channel.
Seen = dict[tuple[str, str], list[dict[str, Any]]]


def moments(chance: random.Random, steps: list[str]) -> Iterator[Moment]:
    """Yield random moments: while rows are written, and at the beginning of any step."""
    writing = [number for number, step in enumerate(steps, 1) if step == "writing"]
    while True:
        yield Moment(chance.choice(writing), chance.uniform(0, 2))
        yield Moment(chance.randint(1, len(steps)))


def is_killed(moment: Moment, folder: Path, arrived: int) -> bool:
    """Let a process score, and kill it and its Java; return whether it was still at work."""
    victim = subprocess.Popen(
        [sys.executable, spark_victim.__file__, str(folder), str(arrived)],
        stdout=subprocess.PIPE,
        bufsize=0,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
    )
    assert isinstance(victim.stdout, io.FileIO)
    with victim.stdout as steps:
        if is_at_work(steps, moment.step, moment.delay):
            os.killpg(victim.pid, signal.SIGKILL)
        code = victim.wait()
    assert code in (0, -signal.SIGKILL), f"scoring ended with {code} by itself"
    return code != 0


def look(folder: Path) -> Seen:
    """Return what is visible in the folder, by DuckDB."""
    kept, tables = Folder(folder, writable=False), StateTables()
    with duckdb.connect() as connection:
        emptied(DuckSession(connection), tables)
        for entry in kept.entries().values():
            if entry.data is None or entry.name == tables.table("migration").name:
                continue
            if parts := [str(part) for part in sorted(kept.place(entry).glob("*.parquet"))]:
                connection.execute(f"INSERT INTO {entry.name} BY NAME FROM read_parquet(?)", [parts])
        return by_channel([rows_of(connection, BUCKETS), rows_of(connection, NOVEL)])


def expected(arrived: int) -> Seen:
    """Return what one run over all rows would show, by the reference."""
    asked = (plant().first, after(arrived), *harness.made(PARAMETERS, CALIBRATION))
    return by_channel([frozen.buckets(*asked), frozen.novel_cells(*asked)])


def after(arrived: int) -> list[Row]:
    """Return all rows after so many batches."""
    return [*plant().first, *(row for batch in plant().batches[:arrived] for row in batch)]


def noted(arrived: int) -> None:
    """Note that what is seen after so many batches was compared with the reference."""
    method = harness.made(PARAMETERS, CALIBRATION)
    comparisons.compared("spark", "stored", after(arrived), *method, plant().first)


def by_channel(tables: list[list[dict[str, Any]]]) -> Seen:
    seen: Seen = {}
    for rows in tables:
        for row in rows:
            seen.setdefault((row["asset"], row["channel"]), []).append(row)
    return seen


class Stopping(threading.Thread):
    """Copies a folder again and again while all that writes to it stands still.

    A process of its own stops this one and its Java, copies, and lets them go on. A copy is that of
    the moment, as a kill would have left it: what was written lies with the kernel.
    """

    def __init__(self, folder: Path, copies: Path, java: int, chance: random.Random) -> None:
        super().__init__(daemon=True)
        self.folder, self.copies, self.java, self.chance = folder, copies, java, chance
        self.made: list[Path] = []
        self.over, self.one = threading.Event(), threading.Lock()

    def run(self) -> None:
        while not self.over.wait(self.chance.uniform(0, 0.5)):
            self.copy()

    def copy(self) -> None:
        order = 'kill -STOP $1 $2 && cp -r "$3" "$4"; code=$?; kill -CONT $1 $2; exit $code'
        with self.one:
            copy = self.copies / str(len(self.made))
            words = (str(word) for word in (os.getpid(), self.java, self.folder, copy))
            subprocess.run(["sh", "-c", order, "sh", *words], check=True)
            self.made.append(copy)


def java_of_spark() -> int:
    """Return the number of the process in which Spark works."""
    from pyspark.sql import SparkSession

    context: Any = SparkSession.builder.getOrCreate().sparkContext
    return int(context._jvm.java.lang.ProcessHandle.current().pid())


@pytest.mark.full
def test_what_kills_leave(tmp_path: Path) -> None:
    chance = random.Random(5)
    folder, copies = tmp_path / "plant", tmp_path / "copies"
    copies.mkdir()
    states = [expected(arrived) for arrived in (0, len(plant().batches))]
    engines.session("spark")  # small and quick to start
    with gam_db.connect(f"spark://{folder}") as session:
        first = spark_victim.monitor(session, 0)
        first.migrate()
        first.calibrate()
        first.score()
        assert look(folder) == states[0]
        noted(0)
        stopping = Stopping(folder, copies, java_of_spark(), chance)
        stopping.start()
        # Shown and copied at every step, too: what is between two statements is a moment as any other.
        spark_victim.monitor(session, len(plant().batches)).score(on_step=lambda _: stopping.copy())
        stopping.over.set()
        stopping.join()
        assert look(folder) == states[1]
        noted(len(plant().batches))
    assert len(stopping.made) >= COPIES, "the run was over before there were enough copies"
    seen = {copy: look(copy) for copy in chance.sample(stopping.made, COPIES)}
    for copy, found in seen.items():
        for channel in states[1]:
            assert found.get(channel) in (states[0].get(channel), states[1].get(channel)), copy.name
    early = [copy for copy, found in seen.items() if found != states[1]]
    assert early, "no copy is of a moment before the end"
    for copy in chance.sample(early, min(RESUMED, len(early))):
        with gam_db.connect(f"spark://{copy}") as session:
            monitor = spark_victim.monitor(session, len(plant().batches))
            monitor.score()
            assert look(copy) == states[1]


@pytest.mark.full
def test_killed_while_scoring(tmp_path: Path) -> None:
    chance = random.Random(4)
    engines.session("spark")  # small and quick to start, and so are the victims
    folder = tmp_path / "plant"
    steps: list[str] = []
    with gam_db.connect(f"spark://{folder}") as session:
        first = spark_victim.monitor(session, 0)
        first.migrate()
        first.calibrate()
        first.score(on_step=steps.append)
    states = [expected(arrived) for arrived in range(len(plant().batches) + 1)]
    found = look(folder)
    assert found == states[0]
    noted(0)
    arrived = killed = 0
    for moment in itertools.islice(moments(chance, steps), 10 * KILLS):
        before, arrived = found, min(arrived + 1, len(plant().batches))
        hit = is_killed(moment, folder, arrived)
        killed += hit
        found = look(folder)
        assert hit or found == states[arrived], f"after {killed} kills"
        for channel in states[-1]:
            assert found.get(channel) in (
                before.get(channel),
                states[arrived].get(channel),
            ), f"{channel} after {killed} kills"
        noted(arrived)
        if killed == KILLS:
            break
    assert killed == KILLS
    with gam_db.connect(f"spark://{folder}") as session:
        monitor = spark_victim.monitor(session, len(plant().batches))
        monitor.score()
        assert look(folder) == states[-1]
        noted(len(plant().batches))
        monitor.prune()
        assert look(folder) == states[-1]
