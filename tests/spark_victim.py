"""A process that scores on Spark until it is killed: ``python tests/spark_victim.py FOLDER FIRST``.

It scores the telemetry that has arrived up to batch FIRST, says so, and waits for a word; then one batch
more, and so on. After the last it scores everything anew, again and again.
"""

import sys

import gam_db
import harness
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from test_kills import CALIBRATION, LOOKBACK, PARAMETERS, plant


def monitor(session: Session, batches: int) -> Monitor:
    """Return the monitor of the plant of the tests of kills, after so many batches have arrived."""
    rows = [*plant().first, *(row for batch in plant().batches[:batches] for row in batch)]
    parameters, calibration = harness.made(PARAMETERS, CALIBRATION)
    source = gam_db.Source(session.load(harness.arrow(rows)).name)
    return Monitor(session, source, parameters, calibration, lookback=LOOKBACK)


def main(folder: str, arrived: int) -> None:
    """Score, say so, wait for a word."""
    with gam_db.connect(f"spark://{folder}") as session:
        while True:
            last = arrived >= len(plant().batches)
            watched = monitor(session, arrived)
            print("scoring", arrived, flush=True)
            watched.score(full=last)
            print("scored", arrived, flush=True)
            sys.stdin.readline()
            arrived = min(arrived + 1, len(plant().batches))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
