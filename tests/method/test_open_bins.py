"""Bins that calibration chooses, in every form."""

import math
from random import Random
from typing import Any

import pytest

import comparisons
import engines
import frozen
import gam_db
import harness
import reference
import scripts
from gam_db import Calibration, Override, Parameters
from gam_db.errors import ParameterError
from gam_db.stored.calibrating import differing
from gam_db.stored.monitor import Monitor
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

#: What this file runs, and how its version is found; see test_engines.py.
RUNS = engines.VERSIONS

OPEN = Parameters(
    m=2,
    bins="auto",
    window=20,
    target_floor=0.1,
    overrides=[
        Override(asset="b", channel="slow", bins=5),
        Override(channel="short", tau=3),
        Override(channel="wide", m=12),
    ],
)
HALF = Calibration(fraction=0.5)


def plant(samples: int = 800) -> list[harness.Row]:
    """Channels that fill grids of different fineness, one that is constant, one without a vector."""
    random = Random(3)
    rows: list[harness.Row] = []
    for asset, noise in (("a", 0.01), ("b", 0.2), ("c", 0.05)):
        for i in range(samples):
            rows.append((asset, "slow", i, math.sin(i / 40) + random.gauss(0, noise)))
            rows.append((asset, "fast", i, math.sin(i / 3) + random.gauss(0, noise)))
            if i < 30:
                rows.append((asset, "short", i, random.random()))
                rows.append((asset, "wide", i, random.random()))
    rows += [("a", "still", i, 1.0) for i in range(samples)]
    rows += [("c", "empty", i, None) for i in range(samples)]
    return rows


def bins_of(rows: list[harness.Row], calibration: Calibration) -> dict[tuple[str, str], int]:
    """What the reference takes for each channel."""
    found = reference.channels(rows, OPEN, calibration)
    return {(channel.asset, channel.name): pool.settings.bins for channel, pool in found}


def test_every_channel_has_the_grid_that_is_chosen(engine: str) -> None:
    """Where some are pooled and some alone both are seen, which is enough for the slower engines."""
    rows = plant()
    pools: list[Any] = [[["a", "b"]], *([None, "channel"] if engine == "duckdb" else [])]
    for pool in pools:
        calibration = Calibration(fraction=0.5, pool=pool)
        taken = bins_of(rows, calibration)
        assert len(set(taken.values())) >= 3, "or the cases say nothing"
        found = harness.all_by_engine(engine, rows, OPEN, calibration)
        for question in harness.QUESTIONS:
            expected = harness.by_reference(question, rows, OPEN, calibration)
            harness.assert_same(expected, found[question], question)
        comparisons.compared(engine, "exact", rows, OPEN, calibration)


def test_members_of_a_pool_have_one_grid_and_each_grid_passes() -> None:
    taken = bins_of(plant(), Calibration(fraction=0.5, pool="channel"))
    assert taken["b", "slow"] == 5
    assert len({of for (_, channel), of in taken.items() if channel == "fast"}) == 1
    support = gam_db.support(gam_db.Source(harness.arrow(plant())), OPEN, HALF).to_pylist()
    alone = bins_of(plant(), HALF)
    found = {(row["asset"], row["channel"]): row["verdict"] for row in support}
    assert {verdict for name, verdict in found.items() if alone[name] > 8} <= {
        *("ready", "constant", "no_data")
    }
    assert "ready" in found.values()


def test_bins_are_frozen_and_no_other_setting(engine: str) -> None:
    """A second calibration under the same words makes no version, though it would find other bins."""
    first, session = plant(300), engines.session(engine)
    table = scripts.telemetry(session, first)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("state")
    monitor = Monitor(session, source, OPEN, HALF, prefix=prefix)
    monitor.migrate()
    made = monitor.calibrate().to_pylist()
    taken = bins_of(first, HALF)
    assert {(row["asset"], row["channel"]): row["bins"] for row in made} == taken
    later: list[harness.Row] = [
        ("a", "slow", i, math.sin(i / 40) + Random(i).gauss(0, 0.3)) for i in range(300, 700)
    ]
    scripts.arrive(session, table, later)
    assert bins_of(first + later, HALF) != taken
    assert monitor.calibrate().num_rows == 0
    assert not differing(monitor.state, monitor.name, OPEN, HALF)
    monitor.score()
    asked = (first, first + later, OPEN, HALF)
    harness.assert_same(frozen.buckets(*asked), visible(monitor, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), visible(monitor, NOVEL), "novel cells")
    shown = monitor.status().to_pylist()
    assert {(row["asset"], row["channel"]): row["bins"] for row in shown} == taken
    said = Parameters(m=2, bins=64, window=20, target_floor=0.1)
    assert Monitor(session, source, said, HALF, prefix=prefix).calibrate().num_rows == len(taken)
    comparisons.compared(engine, "stored", first + later, OPEN, HALF, first)


def test_a_script_which_reads_nothing_has_none() -> None:
    source = gam_db.Source("telemetry", time_kind="counter")
    with pytest.raises(ParameterError, match=r"give bins, or calibrate first, or .*paper\(\)"):
        gam_db.render("exact", "duckdb", source, OPEN)


@pytest.mark.parametrize("bins", ["Auto", "", "100"])
def test_other_words_are_refused(bins: str) -> None:
    with pytest.raises(ParameterError, match="it takes an integer, or 'auto'"):
        Parameters(bins=bins)


def test_bins_that_are_found_make_no_family(engine: str) -> None:
    """Alarms, section 3: settings that calibration resolved by itself do not split a family."""
    rows, session = plant(), engines.session(engine)
    named = Override(asset="b", channel="slow", bins=5)
    parameters = Parameters(m=2, bins="auto", window=20, target_floor=0.1, overrides=[named])
    table = scripts.telemetry(session, rows)
    source = gam_db.Source(table.name)
    monitor = Monitor(session, source, parameters, HALF, prefix=engines.fresh_name("state"))
    monitor.migrate()
    made = monitor.calibrate().to_pylist()
    assert len({row["bins"] for row in made}) >= 3, "or the case says nothing"
    monitor.limits(again=True)
    stored = """
        SELECT asset, channel, limit_no, family FROM gam_state_limit
        JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)
    """
    families: dict[Any, set[Any]] = {}
    for row in visible(monitor, stored):
        is_named = (row["asset"], row["channel"]) == ("b", "slow")
        families.setdefault((row["limit_no"], is_named), set()).add(row["family"])
    assert sorted(families) == [(1, False), (1, True), (2, False), (2, True)]
    assert all(len(one) == 1 for one in families.values())
    assert families[1, False] != families[1, True]
    assert families[2, False] != families[2, True]
    if engine == "duckdb":
        alone = gam_db.limits(gam_db.Source(harness.arrow(rows)), parameters, HALF).to_pylist()
        others = {row["family"] for row in alone if (row["asset"], row["channel"]) != ("b", "slow")}
        assert len(others) == 1
        assert len({row["family"] for row in alone}) == 2
