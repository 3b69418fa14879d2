"""A process on Spark that is made to be killed: ``python tests/tools/spark_victim.py FOLDER ARRIVED``.

It scores the telemetry that has arrived up to a batch (of the last one: everything anew), says every
step before it is taken. One that takes longer than PATIENCE, in seconds, hangs, and ends itself.
"""

import signal
import sys

import gam_db
import harness
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from killed_plant import CALIBRATION, LOOKBACK, PARAMETERS, plant

#: Java alone may take a minute to start on a busy machine.
PATIENCE = 1200


def monitor(session: Session, batches: int) -> Monitor:
    """Return the monitor of the plant of the tests of kills, after so many batches have arrived."""
    rows = [*plant().first, *(row for batch in plant().batches[:batches] for row in batch)]
    parameters, calibration = harness.made(PARAMETERS, CALIBRATION)
    source = gam_db.Source(session.load(harness.arrow(rows)).name)
    return Monitor(session, source, parameters, calibration, lookback=LOOKBACK)


def say(word: str) -> None:
    """Say a word to whoever listens, at once."""
    print(word, flush=True)


def main(folder: str, arrived: int) -> None:
    """Score, and say every step."""
    signal.alarm(PATIENCE)
    with gam_db.connect(f"spark://{folder}") as session:
        monitor(session, arrived).score(full=arrived >= len(plant().batches), on_step=say)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
