"""Killed at any moment while it scores, ClickHouse shows what was before or after, nothing between.

The engine lies in the process that is killed, in a folder of chdb; every look is a process of its own.
"""

import json
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import clickhouse_victims
import comparisons
import frozen
import gam_db
from sets import amounts
from small_plant import FIRST, readings
from strategies import Row
from victims import Moment, Victims

#: In the first set and in the full one.
KILLS = 10, 60

#: New rows of each channel between two kills, and how far the rows before them come again.
STEP, AGAIN = 6, 3

#: Of so many runs one dies between what it appends and its commit.
EVERY = 5


@pytest.fixture
def victims() -> Iterator[Victims]:
    program = Victims(clickhouse_victims.__file__)
    yield program
    program.close()


def reference(rows: list[Row]) -> list[Any]:
    """Return what one run over all rows must show, by NumPy."""
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    asked = (readings(0, FIRST), rows, parameters, gam_db.Calibration(fraction=0.7))
    comparisons.compared("clickhouse", "stored", rows, *asked[2:], asked[0])
    return [frozen.buckets(*asked), frozen.novel_cells(*asked)]


def arriving(number: int) -> list[Row]:
    """Return the rows that come before a kill: new ones, and some that are there already."""
    start = FIRST + number * STEP
    return readings(start - AGAIN, start + STEP)


def by_channel(seen: list[Any]) -> dict[str, list[Any]]:
    """Return rows of buckets and of novel cells, channel by channel."""
    found: dict[str, list[Any]] = {}
    for rows in seen:
        for row in rows:
            found.setdefault(row["asset"], []).append(row)
    return found


@amounts("kills", *KILLS)
def test_killed_while_scoring(tmp_path: Path, victims: Victims, kills: int) -> None:
    chance = random.Random(5)
    into = tmp_path / "seen.json"
    order: dict[str, Any] = {"database": f"chdb:///{tmp_path / 'plant'}", "into": str(into)}
    rows = readings(0, FIRST)
    victims.lifetime(**order, work=["begin"], rows=rows)
    late = arriving(0)
    seconds = victims.lifetime(**order, work=["score", "arrive"], rows=late)
    expected, unfinished, number = reference(rows), 0, 0
    while victims.killed < kills:
        rows += late
        number += 1
        before, expected = by_channel(expected), reference(rows)
        if number % EVERY == 0:
            after = chance.choice(["bucket", "novel"])
            assert victims.kill(Moment(1, 100.0), **order, work=["score"], after=after)
        else:
            victims.kill(Moment(1, chance.uniform(0, seconds)), **order, work=["score"])
        late = arriving(number)
        victims.lifetime(**order, work=["look", "score", "look", "arrive"], rows=late)
        killed, scored = json.loads(into.read_text())
        for asset, found in by_channel(killed["seen"]).items():
            assert found in (before[asset], by_channel(expected)[asset]), (number, asset)
        unfinished = max(unfinished, killed["unfinished"])
        assert scored["seen"] == expected, number
    assert unfinished > 0, "no run died between what it appends and its commit"
    victims.lifetime(**order, work=["prune", "look"])
    (pruned,) = json.loads(into.read_text())
    assert pruned["seen"] == expected
    assert pruned["unfinished"] == 0
    assert pruned["stored"] == len(expected[0]), "hidden rows are left"
