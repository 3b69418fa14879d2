"""Killed at any moment while it scores, SQLite holds what was before or after, nothing between."""

import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from sqlglot import exp

import comparisons
import frozen
import gam_db
import scripts
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor
from sets import amounts
from small_plant import FIRST, LOOKBACK, readings
from strategies import Row
from victims import Moment, Victims
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

#: In the first set and in the full one.
KILLS = 10, 100

#: New rows of each channel between two kills, and how far the rows before them come again.
STEP, AGAIN = 6, 3

PARAMETERS: dict[str, Any] = {"m": 2, "tau": 3, "bins": 4, "window": 20, "stride": 5}
CALIBRATION: dict[str, Any] = {"fraction": 0.7}


@pytest.fixture
def victims() -> Iterator[Victims]:
    program = Victims()
    yield program
    program.close()


def monitor(session: Session) -> Monitor:
    parameters, calibration = gam_db.Parameters(**PARAMETERS), gam_db.Calibration(**CALIBRATION)
    return Monitor(session, gam_db.Source("telemetry"), parameters, calibration, lookback=LOOKBACK)


def seen(session: Session) -> list[Any]:
    return [visible(monitor(session), BUCKETS), visible(monitor(session), NOVEL)]


def reference(rows: list[Row]) -> list[Any]:
    """Return what one run over all rows must show, by NumPy."""
    method = gam_db.Parameters(**PARAMETERS), gam_db.Calibration(**CALIBRATION)
    asked = (readings(0, FIRST), rows, *method)
    comparisons.compared("sqlite", "stored", rows, *method, readings(0, FIRST))
    return [frozen.buckets(*asked), frozen.novel_cells(*asked)]


@amounts("kills", *KILLS)
def test_killed_while_scoring(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(7)
    database = f"sqlite:///{tmp_path / 'plant.db'}"
    table = exp.to_table("telemetry")
    order: dict[str, Any] = {
        "database": database,
        "command": "score",
        "parameters": PARAMETERS,
        "calibration": CALIBRATION,
        "lookback": LOOKBACK,
        "options": {},
    }
    rows = readings(0, FIRST)
    with gam_db.connect(database) as session:
        made = scripts.telemetry(session, rows)
        session.execute(session.engine.create_table(table, exp.select("*").from_(made)))
        monitor(session).migrate()
        monitor(session).calibrate()
    seconds = victims.lifetime(**order)
    expected, number = reference(rows), 0
    while victims.killed < kills:
        late = readings(FIRST + number * STEP - AGAIN, FIRST + (number + 1) * STEP)
        with gam_db.connect(database) as session:
            scripts.arrive(session, table, late)
        rows, number, before = [*rows, *late], number + 1, expected
        expected = reference(rows)
        victims.kill(Moment(1, chance.uniform(0, seconds)), **order)
        with gam_db.connect(database) as session:
            assert seen(session) in (before, expected), number
            monitor(session).score()
            assert seen(session) == expected, number
