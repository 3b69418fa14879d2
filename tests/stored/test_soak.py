"""A soak: a writer, scorers, readers, repairs and checks side by side, each a process of its own.

It takes ten minutes on each engine; GAM_SOAK_SECONDS says otherwise. While one process has a DuckDB file
open for writing no other can open it, so there they take turns, by trying again.
"""

import json
import os
import subprocess
import sys
import threading
import time
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

import frozen
import gam_db
import harness
import postgres_server
import soaking
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.full

SECONDS = float(os.environ.get("GAM_SOAK_SECONDS", "600"))

GAM = (sys.executable, "-c", "from gam_db.cli import main; main()")

#: What a command may end with: fine, something needs attention, only the moment was wrong.
ENDS = (0, 2, 75)


class Soak:
    """Processes at work in a folder that has a gam.toml.

    Attributes:
        ends: role -> exit code -> how often.
        failures: what was said by those that ended otherwise than they may.
    """

    def __init__(self, folder: Path, address: str) -> None:
        self.folder, self.address = folder, address
        self.ends: dict[str, Counter[int]] = {}
        self.failures: list[Any] = []
        self.stop = folder / "stop"
        paths = os.pathsep.join(path for path in sys.path if path)
        self.environment = {**os.environ, "PYTHONPATH": paths}

    def process(self, role: str, *words: str) -> int:
        """Run a process to its end, and note how it ended."""
        done = subprocess.run(
            words, cwd=self.folder, env=self.environment, capture_output=True, text=True, check=False
        )
        self.ends.setdefault(role, Counter())[done.returncode] += 1
        if done.returncode not in ENDS:
            self.failures.append((role, words, done.returncode, done.stderr[-2000:]))
        return done.returncode

    def gam(self, role: str, *words: str) -> int:
        return self.process(role, *GAM, *words, "--retry", "5")

    def again_and_again(self, role: str, *words: str) -> None:
        while not self.stop.exists():
            self.gam(role, *words)

    def repairs(self) -> None:
        """Score anew from the oldest row on that can have come since the repair before."""
        begin = soaking.FIRST - soaking.LATE
        while not self.stop.exists():
            newest = self.newest()
            is_full = self.ends["repair"].total() % 5 == 4 if "repair" in self.ends else False
            words = ("--full",) if is_full else ("--from", str(begin))
            if self.gam("repair", "score", *words) in (0, 2):
                begin = newest - soaking.LATE
        self.begin = begin

    def newest(self) -> int:
        written = self.folder / "newest"
        return int(written.read_text(encoding="utf-8")) if written.exists() else soaking.FIRST

    def run(self, seconds: float) -> None:
        """Let them work for so long, then wait for them, and repair what came too late in the end."""
        program = (sys.executable, soaking.__file__)
        where = (self.address, str(self.folder))
        threads = [
            threading.Thread(target=self.process, args=("writer", *program, "write", *where)),
            threading.Thread(target=self.process, args=("reader", *program, "read", *where)),
            threading.Thread(target=self.again_and_again, args=("scorer", "score")),
            threading.Thread(target=self.again_and_again, args=("scorer", "score")),
            threading.Thread(target=self.again_and_again, args=("status", "status", "--json")),
            threading.Thread(target=self.again_and_again, args=("check", "check", "--state")),
            threading.Thread(target=self.repairs),
        ]
        for thread in threads:
            thread.start()
        time.sleep(seconds)
        self.stop.touch()
        for thread in threads:
            thread.join()
        assert self.gam("last", "score", "--from", str(self.begin)) in (0, 2)
        assert self.gam("last", "score") in (0, 2)


def test_a_soak_ends_in_the_tables_of_one_full_run(engine: str, tmp_path: Path) -> None:
    if engine == "postgres":
        from small_postgres import database  # it needs psycopg, which the README's environment lacks

        with database() as name:
            soaked(tmp_path, postgres_server.server().url_of(name))
        return
    place = tmp_path / "plant.db"
    soaked(tmp_path, {"duckdb": f"{place}", "sqlite": f"sqlite:///{place}"}[engine])


def soaked(folder: Path, address: str) -> None:
    lines = [f"{name} = {value}" for name, value in soaking.METHOD.items()]
    (folder / "gam.toml").write_text(
        f'[source]\nrelation = "telemetry"\ndatabase = {json.dumps(address)}\n[parameters]\n'
        + "\n".join(lines)
        + f"\n[calibration]\nfraction = {soaking.FRACTION}\n[monitor]\nlookback = {soaking.LOOKBACK}\n",
        encoding="utf-8",
    )
    with gam_db.connect(address) as session:
        first = soaking.begin(session)
    soak = Soak(folder, address)
    for command in ("migrate", "calibrate", "score"):
        assert soak.gam("first", command) in (0, 2), soak.failures
    soak.run(SECONDS)
    print({role: dict(ends) for role, ends in soak.ends.items()})
    assert not soak.failures
    for role in ("scorer", "repair", "status", "check"):
        assert soak.ends[role][0] + soak.ends[role][2] > 0, soak.ends
    assert soak.gam("last", "check", "--state") == 0
    with gam_db.connect(address, writable=False) as session:
        query = session.fetch(soaking.ALL)
        final = [tuple(row.values()) for row in query.to_pylist()]
        method = harness.made(soaking.METHOD, {"fraction": soaking.FRACTION})
        monitor = gam_db.Monitor(session, gam_db.Source("telemetry"), *method)
        for expected, shown in ((frozen.buckets, BUCKETS), (frozen.novel_cells, NOVEL)):
            harness.assert_same(expected(first, final, *method), visible(monitor, shown), shown)
    print(f"{len(final):,} rows")
