"""The processes of a soak that are no commands of gam, and what they work on.

Run as a program with a role, an address and a folder, it works until a file ``stop`` is in the folder:
``write`` appends rows, ``read`` reads the indicator. Rows come in any order, some again, some too late.
The file ``newest`` holds a time: all rows that are not there yet are at most LATE older.
"""

import random
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from sqlglot import exp

import gam_db
from gam_db.engines.session import Session
from gam_db.errors import RunAgainError
from harness import arrow
from scripts import arrive
from strategies import Row

ASSETS = ("a", "b", "c", "d", "e", "f")
METHOD: dict[str, Any] = {"m": 2, "tau": 1, "bins": 6, "window": 20, "stride": 5}
FRACTION, LOOKBACK, FIRST = 0.8, 5, 400

#: Steps of time that a batch spans, and how late a row may come; beyond LOOKBACK a repair is needed.
SPAN, LATE = 8, 60

TABLE = exp.to_table("telemetry")
ALL = exp.select("asset", "channel", "time", "value").from_(TABLE)


def rows(chance: random.Random, start: int, end: int) -> list[Row]:
    """Return rows of all machines, which repeat a pattern, and later on less so."""
    return [
        (asset, "x", tick, float(chance.randrange(9) if chance.random() < tick / 40_000 else tick % 5))
        for asset in ASSETS
        for tick in range(start, end)
    ]


def begin(session: Session) -> list[Row]:
    """Make the source; return its rows."""
    first = rows(random.Random(8), 0, FIRST)
    with session.lent(arrow(first)) as lent:
        session.execute(session.engine.create_table(TABLE, exp.select("*").from_(lent)))
    return first


def at_work(address: str, work: Callable[[Session], None], writable: bool = True) -> None:
    """Do something in a session of its own, again where only the moment was wrong."""
    while True:
        try:
            with gam_db.connect(address, writable=writable) as session:
                work(session)
            return
        except RunAgainError:
            time.sleep(0.05)


def write(address: str, folder: Path) -> None:
    """Append one batch after another, and in the end what is left."""
    chance, end = random.Random(7), FIRST
    behind: list[Row] = []
    batch: list[Row] = []
    while not (folder / "stop").exists():
        unfinished = folder / "newest.new"
        unfinished.write_text(str(end), encoding="utf-8")
        unfinished.replace(folder / "newest")
        again = chance.sample(batch, min(len(batch), 3))
        made = behind + rows(chance, end, end + SPAN)
        end += SPAN
        # A row is held back for some batches, and then comes late, or too late, but not more than LATE.
        behind = [row for row in made if row[2] >= end - LATE and chance.random() < 0.08]
        held = set(behind)
        batch = [row for row in made if row not in held] + again
        chance.shuffle(batch)
        at_work(address, lambda session, come=batch: arrive(session, TABLE, come))  # type: ignore[misc]
        time.sleep(0.2)
    at_work(address, lambda session: arrive(session, TABLE, behind or batch))


def read(address: str, folder: Path) -> None:
    """Read the indicator; it is whole at any moment."""
    while not (folder / "stop").exists():
        at_work(address, look, writable=False)
        time.sleep(0.2)


def look(session: Session) -> None:
    found = gam_db.Monitor(session, gam_db.Source("telemetry")).health().to_pylist()
    length = METHOD["window"] // METHOD["stride"]
    for asset in ASSETS:
        mine = [row for row in found if row["asset"] == asset]
        assert [row["bucket"] for row in mine] == list(range(len(mine))), asset
        for number, row in enumerate(mine):
            inside = [one["novel"] for one in mine[max(number - length + 1, 0) : number + 1]]
            assert row["novel_in_window"] == (sum(inside) if len(inside) == length else None), row


if __name__ == "__main__":
    {"write": write, "read": read}[sys.argv[1]](sys.argv[2], Path(sys.argv[3]))
