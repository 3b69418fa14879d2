"""Killed at any moment (kill -9, Java and all), a run on Spark leaves a state that it passes through.

A victim scores one batch more than the one before it; every second one is killed while it writes. What
is in the folder is looked at by DuckDB, so that looking takes no second Spark. One is killed where the
tests run on Spark; GAM_SPARK_KILLS=30 kills thirty, in some minutes.
"""

import io
import itertools
import os
import random
import signal
import subprocess
import sys
from collections.abc import Iterator
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
from killed_plant import CALIBRATION, PARAMETERS, plant
from victims import Moment, is_at_work
from visible import BUCKETS, NOVEL, rows_of

KILLS = int(os.environ.get("GAM_SPARK_KILLS", "1"))

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
    steps: list[str] = []
    with gam_db.connect(f"spark://{folder}") as session:
        first = spark_victim.monitor(session, 0)
        first.migrate()
        first.calibrate()
        first.score(on_step=steps.append)
    states = [expected(arrived) for arrived in range(len(plant().batches) + 1)]
    found = look(folder)
    assert found == states[0]
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
        if killed == KILLS:
            break
    assert killed == KILLS
    with gam_db.connect(f"spark://{folder}") as session:
        monitor = spark_victim.monitor(session, len(plant().batches))
        monitor.score()
        assert look(folder) == states[-1]
        monitor.compact()
        assert look(folder) == states[-1]
