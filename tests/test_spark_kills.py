"""Killed at any moment (kill -9, Java and all), a run on Spark leaves a state that it passes through.

A victim scores batch after batch; the one that follows it goes on where it was killed. What is in the
folder is looked at by DuckDB, so that looking takes no second Spark. One is killed where the tests
run on Spark; GAM_SPARK_KILLS=30 kills thirty, in some minutes.
"""

import contextlib
import os
import random
import select
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import duckdb

import engines
import frozen
import gam_db
import harness
import spark_victim
from gam_db.engines import engine_named
from gam_db.engines.spark_folder import Folder
from gam_db.stored.migration_files import files
from gam_db.stored.tables import VIEWS, StateTables
from test_incremental import BUCKETS, NOVEL, rows_of
from test_kills import CALIBRATION, PARAMETERS, plant

KILLS = int(os.environ.get("GAM_SPARK_KILLS", "1"))

#: Most seconds that a victim may take for anything.
PATIENCE = 300

#: What is seen of each channel.
Seen = dict[tuple[str, str], list[dict[str, Any]]]


class Victim:
    """A process that scores, in a group of its own with its Java."""

    def __init__(self, folder: Path, arrived: int) -> None:
        self.process = subprocess.Popen(
            [sys.executable, spark_victim.__file__, str(folder), str(arrived)],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            start_new_session=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
        )

    def says(self, word: str, seconds: float = PATIENCE) -> bool:
        """Wait until it says a word; tell whether it did."""
        assert self.process.stdout is not None
        end = time.monotonic() + seconds
        while select.select([self.process.stdout], [], [], max(end - time.monotonic(), 0))[0]:
            line = self.process.stdout.readline()
            assert line, "the victim ended by itself"
            if line.startswith(word.encode()):
                return True
        return False

    def go_on(self) -> None:
        """Let it score the next batch."""
        assert self.process.stdin is not None
        self.process.stdin.write(b"\n")
        self.process.stdin.flush()

    def kill(self) -> None:
        """Kill it and its Java."""
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self.process.pid, signal.SIGKILL)
        self.process.wait()
        for stream in (self.process.stdin, self.process.stdout):
            assert stream is not None
            with contextlib.suppress(BrokenPipeError):
                stream.close()


def look(folder: Path) -> Seen:
    """Return what is visible in the folder, by DuckDB."""
    kept = Folder(folder, writable=False)
    with duckdb.connect() as connection:
        for entry in kept.entries().values():
            if entry.data is None:
                continue
            parts = sorted(kept.place(entry).glob("*.parquet"))
            columns = ", ".join(f"{name} BIGINT" for name in entry.columns)
            if parts:
                rows = connection.read_parquet([str(part) for part in parts])
                rows.create(entry.name)
            else:
                connection.execute(f"CREATE TABLE {entry.name} ({columns})")
        for migration in files():
            if migration.name in VIEWS:
                create, *_ = migration.statements(engine_named("duckdb"), StateTables())
                connection.execute(create.sql(dialect="duckdb"))
        return by_channel([rows_of(connection, BUCKETS), rows_of(connection, NOVEL)])


def expected(arrived: int) -> Seen:
    """Return what one run over all rows would show, by the reference."""
    final = [*plant().first, *(row for batch in plant().batches[:arrived] for row in batch)]
    asked = (plant().first, final, *harness.made(PARAMETERS, CALIBRATION))
    return by_channel([frozen.buckets(*asked), frozen.novel_cells(*asked)])


def by_channel(tables: list[list[dict[str, Any]]]) -> Seen:
    seen: Seen = {}
    for rows in tables:
        for row in rows:
            seen.setdefault((row["asset"], row["channel"]), []).append(row)
    return seen


def test_killed_while_scoring(tmp_path: Path) -> None:
    chance = random.Random(4)
    engines.session("spark")  # small and quick to start, and so are the victims
    folder = tmp_path / "plant"
    with gam_db.connect(f"spark://{folder}") as session:
        spark_victim.monitor(session, 0).migrate()
        spark_victim.monitor(session, 0).calibrate()
    states = [expected(arrived) for arrived in range(len(plant().batches) + 1)]
    assert look(folder) == {}
    arrived, killed, seconds = 0, 0, 1.0
    while killed < KILLS:
        victim = Victim(folder, arrived)
        try:
            assert victim.says("scored")
            assert look(folder) == states[arrived], f"after {killed} kills"
            before, arrived = arrived, min(arrived + 1, len(plant().batches))
            began = time.monotonic()
            while not killed and seconds == 1.0:  # the first pass is watched: how long does one take?
                victim.go_on()
                assert victim.says("scored")
                seconds = time.monotonic() - began
                before, arrived = arrived, min(arrived + 1, len(plant().batches))
            victim.go_on()
            assert victim.says("scoring")
            survived = victim.says("scored", chance.uniform(0, seconds))
        finally:
            victim.kill()
        killed += not survived
        found = look(folder)
        for channel in states[-1]:
            assert found.get(channel) in (
                states[before].get(channel),
                states[arrived].get(channel),
            ), f"{channel} after {killed} kills"
    with gam_db.connect(f"spark://{folder}") as session:
        monitor = spark_victim.monitor(session, len(plant().batches))
        monitor.score()
        assert look(folder) == states[-1]
        monitor.compact()
        assert look(folder) == states[-1]
