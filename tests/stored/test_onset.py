"""Onset, silence, machines and growth: the views beside what gam_health says of the same buckets."""

import random
from collections import defaultdict
from typing import Any

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.engines.session import Session
from gam_db.stored.monitor import Monitor

pytestmark = pytest.mark.thorough

#: Calibration of drill is shorter than 8 windows, so that its indicator judges it; others have episodes.
WINDOWS = {"drill": 25}
PARAMETERS = gam_db.Parameters(
    m=2,
    tau=1,
    bins=6,
    window=20,
    stride=5,
    overrides=[gam_db.Override(asset=one, window=window, stride=5) for one, window in WINDOWS.items()],
)
CALIBRATION = gam_db.Calibration(intervals=[(0, 199)])

#: (machine, signal) -> from which instant on it goes where it never went, and where its data ends
LEAVES = {
    ("drill", "a"): (300, 400),
    ("drill", "b"): (303, 400),
    ("drill", "c"): (360, 400),
    ("drill", "short"): (250, 270),
    ("lathe", "a"): (200, 400),
    ("lathe", "calm"): (999, 400),
    ("lathe", "back"): (999, 400),
    ("press", "still"): (999, 400),
    ("press", "early"): (999, 214),
}


def telemetry() -> list[Any]:
    """A channel for each; ``back`` leaves and returns, ``still`` does not move in calibration."""
    rows: list[Any] = []
    for (asset, channel), (leaves, ends) in LEAVES.items():
        chance = random.Random(f"{asset} {channel}")
        for time in range(ends):
            value = float(time % 5 + (9 + chance.randrange(3) if time >= leaves else 0))
            if channel == "back" and 260 <= time < 300:
                value = 30.0
            rows.append((asset, channel, time, 1.0 if channel == "still" and time < 200 else value))
    return rows


def made(session: Session, rows: list[Any], *steps: int) -> Monitor:
    """A monitor that scored up to each of the steps."""
    table = scripts.telemetry(session, rows)
    monitor = Monitor(
        session,
        gam_db.Source(table.name),
        PARAMETERS,
        CALIBRATION,
        prefix=engines.fresh_name("onset") + "_",
        lookback=0,
    )
    monitor.migrate()
    monitor.calibrate()
    for until in steps:
        monitor.score(until=until)
    return monitor


def shown(monitor: Monitor, view: str, *columns: str) -> list[dict[str, Any]]:
    """Columns of a view."""
    names = [exp.column(exp.to_identifier(name)) for name in columns]
    query = exp.select(*names).from_(monitor.state.tables.table(view))
    rows: list[dict[str, Any]] = monitor.session.fetch(query).to_pylist()
    return rows


HEALTH = ("asset", "channel", "bucket", "first_tick", "last_tick", "hi", "hi_limit", "verdict")
FLEET = (
    *HEALTH[:2],
    "status",
    "is_above",
    "judged_by",
    "since_tick",
    "since_time",
    "window_from_tick",
    "at_least",
    "silent_for",
    "data_tick",
    "hi_limit",
)
MACHINE = ("asset", "signals", "judged", "above", "not_judged", "since_tick", "together", "data_tick")
ALARM = (
    *("asset", "channel", "episode_id", "status", "needs_attention", "since_tick", "first_tick"),
    *("last_tick", "first_judgement", "last_judgement"),
)
GROWTH = ("asset", "channel", "phase", "number", "last_tick", "healthy", "novel")


def expected_onsets(health: list[dict[str, Any]]) -> dict[Any, tuple[int, int, int]]:
    """Channel -> since, at least, where the window of its onset begins; by a walk over its buckets."""
    found = {}
    buckets = defaultdict(list)
    for row in sorted(health, key=lambda row: row["bucket"]):
        buckets[row["asset"], row["channel"]].append(row)
    for name, rows in buckets.items():
        begun = None
        for row in reversed(rows):
            if row["hi"] is None or row["hi_limit"] is None or not row["hi"] > row["hi_limit"]:
                break
            begun = row
        if begun is not None:
            first = begun["bucket"] - WINDOWS.get(name[0], 20) // 5
            window = [row for row in rows if first < row["bucket"] <= begun["bucket"]]
            cut = begun is rows[0] and begun["bucket"] > 0
            found[name] = (begun["last_tick"], int(cut), window[0]["first_tick"])
    return found


def expected_episodes(alarms: list[dict[str, Any]]) -> dict[Any, tuple[int, int, int]]:
    """Channel -> the same of its episode that is open, or asks."""
    found = {}
    for row in sorted(alarms, key=lambda row: (row["status"] in ("open", "high"), row["episode_id"])):
        if row["status"] in ("open", "high") or row["needs_attention"]:
            windows = row["last_judgement"] - row["first_judgement"] + 1
            window = WINDOWS.get(row["asset"], 20)
            length = (row["last_tick"] - row["first_tick"]) * window // (windows * window - 1)
            found[row["asset"], row["channel"]] = (row["since_tick"], 0, row["since_tick"] - length)
    return found


def compare(monitor: Monitor) -> dict[Any, tuple[int, int, int]]:
    """Compare gam_fleet and gam_machine with what gam_health and gam_alarm say; return the onsets.

    Onsets are those of the indicator at the end of buckets; gam_fleet has those of episodes, which
    windows of their own open, whatever judges.
    """
    fleet = {(row["asset"], row["channel"]): row for row in shown(monitor, "fleet", *FLEET)}
    health = shown(monitor, "health", *HEALTH)
    onsets = expected_onsets(health)
    for row in health:
        assert row["hi_limit"] == fleet[row["asset"], row["channel"]]["hi_limit"]
    above = expected_episodes(shown(monitor, "alarm", *ALARM))
    for name, row in fleet.items():
        assert (
            (name in above) == (row["status"] in ("high", "proving", "open")) == (row["is_above"] == 1)
        )
        assert (row["status"] == "high") == (name in above and row["judged_by"] == "indicator")
        told = (row["since_tick"], row["at_least"], row["window_from_tick"])
        assert told == above.get(name, (None, None, None))
        assert row["since_time"] is None
    for machine in shown(monitor, "machine", *MACHINE):
        members = [row for name, row in fleet.items() if name[0] == machine["asset"]]
        left = {name: said for name, said in above.items() if name[0] == machine["asset"]}
        together = [
            sum(begin <= other[0] <= since for other in left.values())
            for since, _, begin in left.values()
        ]
        assert machine == {
            "asset": machine["asset"],
            "signals": len(members),
            "judged": sum(row["is_above"] is not None for row in members),
            "above": len(left),
            "not_judged": sum(row["is_above"] is None for row in members),
            "since_tick": min((fleet[name]["since_tick"] for name in left), default=None),
            "together": max(together, default=0),
            "data_tick": max(row["data_tick"] for row in members),
        }
    return onsets


def test_the_onset_is_the_first_bucket_of_the_run_that_lasts(engine: str) -> None:
    monitor = made(engines.session(engine), telemetry(), 280, 333, 399)
    onsets = compare(monitor)
    assert {name[1] for name in onsets if name[0] == "drill"} == {"a", "b", "c", "short"}
    assert ("lathe", "back") not in onsets
    together = {row["asset"]: row["together"] for row in shown(monitor, "machine", *MACHINE)}
    assert together == {"drill": 2, "lathe": 1, "press": 0}
    fleet = {(row["asset"], row["channel"]): row for row in shown(monitor, "fleet", *FLEET)}
    assert any(fleet[name]["since_tick"] != since for name, (since, _, _) in onsets.items())
    silent = {name: row["silent_for"] for name, row in fleet.items() if row["silent_for"] is not None}
    assert silent == {("drill", "short"): 130, ("press", "early"): 186}
    once = made(monitor.session, telemetry(), 399)
    assert expected_onsets(shown(once, "health", *HEALTH)) == onsets
    compare(once)


def test_growth_counts_cells_as_they_come(engine: str) -> None:
    monitor = made(engines.session(engine), telemetry(), 399)
    fleet = {
        (row["asset"], row["channel"]): row for row in shown(monitor, "fleet", *HEALTH[:2], "cells")
    }
    novel = defaultdict(set)
    for row in shown(monitor, "quarantine", *HEALTH[:2], "cell_key"):
        novel[row["asset"], row["channel"]].add(row["cell_key"])
    grown = defaultdict(list)
    for row in shown(monitor, "growth", *GROWTH):
        grown[row["asset"], row["channel"]].append(row)
    assert set(grown) == set(fleet)
    for name, rows in grown.items():
        rows.sort(key=lambda row: (row["phase"], row["number"]))
        calibration = [row["healthy"] for row in rows if row["phase"] == "calibration"]
        scored = [row for row in rows if row["phase"] == "scored"]
        cells = fleet[name]["cells"]
        assert calibration == sorted(calibration)
        assert calibration[-1] == cells
        assert calibration[0] > 0
        assert {row["healthy"] for row in scored} <= {cells}
        news = [row["novel"] for row in scored]
        assert news == sorted(news)
        assert (news[-1] if news else 0) == len(novel[name])
    assert any(rows[-1]["novel"] > 3 for rows in grown.values())


def test_where_pruning_cut_the_run_the_oldest_bucket_is_the_least() -> None:
    monitor = made(engines.session("duckdb"), telemetry(), 399)
    before = compare(monitor)
    assert [said for said in before.values() if said[1]] == []
    monitor.prune(keep=60)
    after = compare(monitor)
    assert after["drill", "c"] == before["drill", "c"]
    assert after["drill", "a"][1] == 1
    assert after["drill", "a"][0] > before["drill", "a"][0]
