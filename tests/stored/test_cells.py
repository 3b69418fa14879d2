"""Cells in units, the ladder and the trend: the views beside arithmetic on the stored keys."""

import dataclasses
import random
from collections import defaultdict
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import engines
import gam_db
import reference
import scripts
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.schema.tables import StateTables
from stored_rows import Plant, emptied
from test_onset import PARAMETERS, made, shown, telemetry

pytestmark = pytest.mark.thorough

CELL = (
    *("asset", "channel", "version_no", "kind", "cell_key", "visits", "first_tick", "last_tick"),
    *("axis", "samples_before", "code", "place", "value_from", "value_to"),
)
TABLES = StateTables(prefix="cell_")


def codes(key: int, bins: int, m: int) -> list[int]:
    """The codes of a key, by division of whole numbers of any size."""
    found = []
    for _ in range(m):
        key, code = divmod(key, bins + 3)
        found.append(code)
    return found


def interval(code: int, bins: int, lo: float, hi: float) -> tuple[str, float | None, float | None]:
    """The interval of a code, bin by bin."""
    if code == 0:
        return "missing", None, None
    if code == 1:
        return "below", None, lo
    if code == bins + 2:
        return "above", hi, None
    edges = [lo + (hi - lo) * place / bins for place in (code - 2, code - 1)]
    return "within", edges[0], hi if code == bins + 1 else edges[1]


def test_cells_are_those_of_the_support_and_of_quarantine_in_units(engine: str) -> None:
    monitor = made(engines.session(engine), telemetry(), 280, 399)
    fleet = {
        (row["asset"], row["channel"]): row
        for row in shown(monitor, "fleet", "asset", "channel", "cells", "calibrated_lo", "calibrated_hi")
    }
    fresh = {
        (row["asset"], row["channel"], row["cell_key"]): row
        for row in shown(
            monitor,
            *("quarantine", "asset", "channel", "cell_key", "visits", "first_tick", "last_tick"),
        )
    }
    found = defaultdict(list)
    for row in shown(monitor, "cell", *CELL):
        found[row["asset"], row["channel"], row["kind"], row["cell_key"]].append(row)
    healthy = [key for key in found if key[2] == "healthy"]
    assert {name: sum(key[:2] == name for key in healthy) for name in fleet} == {
        name: row["cells"] for name, row in fleet.items()
    }
    assert {(*key[:2], key[3]) for key in found if key[2] == "novel"} == set(fresh)
    for (asset, channel, kind, key), rows in found.items():
        rows.sort(key=lambda row: row["axis"])
        assert [row["axis"] for row in rows] == list(range(PARAMETERS.m))
        assert [row["samples_before"] for row in rows] == [
            axis * PARAMETERS.tau for axis in range(PARAMETERS.m)
        ]
        learnt = fleet[asset, channel]
        ends = learnt["calibrated_lo"], learnt["calibrated_hi"]
        for row, code in zip(rows, codes(key, PARAMETERS.grid, PARAMETERS.m), strict=True):
            assert row["code"] == code
            said = (row["place"], row["value_from"], row["value_to"])
            assert said == interval(code, PARAMETERS.grid, *ends)
        if kind == "novel":
            row = fresh[asset, channel, key]
            assert {**row, **{k: rows[0][k] for k in ("visits", "first_tick", "last_tick")}} == row
    once = made(monitor.session, telemetry(), 399)
    assert sorted(map(repr, shown(once, "cell", *CELL))) == sorted(
        map(repr, shown(monitor, "cell", *CELL))
    )


@given(st.data())
@settings(max_examples=15)
def test_a_key_is_decoded_whatever_its_axes(data: st.DataObject) -> None:
    bins = data.draw(st.sampled_from([1, 2, 5, 100, 1621, 2**20, 2**31 - 1]))
    most = max(m for m in range(1, 64) if (bins + 3) ** m <= 2**63 - 1)
    m = data.draw(st.integers(1, most))
    ends = data.draw(st.sampled_from([(-3.0, 7.5), (2.0, 2.0), (1e300, 1.7e308)]))
    keys = {
        sum(data.draw(st.integers(0, bins + 2)) * (bins + 3) ** axis for axis in range(m))
        for _ in range(3)
    } | {(bins + 3) ** m - 1}
    plant = Plant()
    learnt = plant.support(cells=keys, calibrated_lo=ends[0], calibrated_hi=ends[1])
    channel = plant.channel(plant.monitor(), "a", "x")
    retired = plant.support(cells=[1])
    plant.version(channel, retired, 1)
    version = plant.version(channel, learnt, 2, m=m, tau=3, bins=bins)
    plant.run(version, [{max(keys) - 1: 2}, {max(keys) - 1: 1}])
    with DuckSession() as session:
        plant.write(emptied(session, TABLES), TABLES)
        rows = session.connection.sql("SELECT * FROM cell_cell").to_arrow_table().to_pylist()
    assert {(row["kind"], row["cell_key"]) for row in rows} == {
        *(("healthy", key) for key in keys),
        ("novel", max(keys) - 1),
    }
    assert len(rows) == (len(keys) + 1) * m
    for row in rows:
        code = codes(row["cell_key"], bins, m)[row["axis"]]
        assert (row["code"], row["samples_before"]) == (code, 3 * row["axis"])
        said = (row["place"], row["value_from"], row["value_to"])
        assert said == interval(code, bins, *ends)
        assert row["visits"] == (3 if row["kind"] == "novel" else 1)


def test_the_ladder_is_the_floor_on_each_grid(engine: str) -> None:
    chance = random.Random(5)
    rows: list[Any] = [
        (f"r{number}", "x", time, chance.random()) for number in range(3) for time in range(200)
    ]
    rows += [("fine", "x", time, chance.random() ** 2) for time in range(200)]
    parameters = dataclasses.replace(PARAMETERS, overrides=[gam_db.Override("fine", bins=11)])
    calibration = gam_db.Calibration(intervals=[(0, 199)], pool=[["r1", "r2"]])
    session = engines.session(engine)
    source = gam_db.Source(scripts.telemetry(session, rows).name)
    prefix = engines.fresh_name("ladder") + "_"
    monitor = gam_db.Monitor(session, source, parameters, calibration, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    names = {row["channel_id"]: row["asset"] for row in shown(monitor, "channel", "channel_id", "asset")}
    found: dict[Any, dict[int, float]] = {name: {} for name in names.values()}
    ladder = shown(monitor, "ladder", "support_id", "bins", "floor")
    for version in shown(monitor, "version", "channel_id", "support_id"):
        for row in ladder:
            if row["support_id"] == version["support_id"]:
                found[names[version["channel_id"]]][row["bins"]] = row["floor"]
    for channel, pool in reference.channels(rows, parameters, calibration):
        bins = pool.settings.bins
        floors = {
            -(-bins // divisor): reference.floor_of(
                reference.numbered(pool.grid // divisor), pool.blocks
            )
            for divisor in (1, 2, 4, 8)
            if -(-bins // divisor) > 1
        }
        assert sorted(floors) == ([2, 3, 6, 11] if channel.asset == "fine" else [2, 3, 6])
        assert found[channel.asset] == pytest.approx(floors, abs=1e-12)
    assert len(ladder) == 3 + 3 + 4
    assert any(len(set(floors.values())) > 1 for floors in found.values())
    assert monitor.check_state().num_rows == 0


def test_what_rises_below_its_limit_is_told() -> None:
    """By hand: hi of the two windows, the limit 0.2 and a standard deviation of blocks 0.04."""
    cases = {
        "falls": ([9, 9, 2, 2], 0),
        "calm": ([1, 1, 1, 1], 0),
        "little": ([1, 1, 2, 1], 0),
        "half": ([0, 0, 1, 1], 0),
        "rises": ([0, 0, 2, 1], 1),
        "at its limit": ([1, 1, 2, 2], 1),
        "above": ([1, 1, 9, 9], 0),
        "short": ([3, 3], 0),
    }
    plant = Plant()
    monitor = plant.monitor()
    for name, (novel, _) in cases.items():
        learnt = plant.support(floor=0.04, floor_max=0.2, floor_sd=0.04)
        version = plant.version(plant.channel(monitor, "a", name), learnt, target_floor=0.2)
        plant.run(version, [{7: n} if n else {} for n in novel])
    with DuckSession() as session:
        plant.write(emptied(session, TABLES), TABLES)
        rows = session.connection.sql("SELECT * FROM cell_trend").to_arrow_table().to_pylist()
        limits = session.connection.sql("SELECT DISTINCT hi_limit FROM cell_fleet").fetchall()
    assert limits == [(0.2,)]
    assert {row["channel"]: row["is_rising"] for row in rows} == {
        name: said for name, (_, said) in cases.items()
    }
    rise = {row["channel"]: row["rise"] for row in rows}
    assert rise["rises"] == 3 / 20
    assert rise["falls"] == -14 / 20
    assert rise["short"] is None
