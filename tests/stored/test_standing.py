"""A machine that stands is neither healthy nor alarming: status and fleet say so, and since when."""

from typing import Any

import engines
import gam_db
import scripts
from gam_db.stored.monitor import Monitor
from strategies import Row
from visible import visible

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=4, window=80, stride=4, still_after=5)
FLEET = "SELECT asset, status, urgency, needs_attention, hi FROM gam_fleet ORDER BY asset"


def moving(asset: str, times: range) -> list[Row]:
    return [(asset, "x", time, (0.0, 1.0, 2.0, 3.0)[time % 4]) for time in times]


def held(asset: str, times: range, value: float) -> list[Row]:
    return [(asset, "x", time, value) for time in times]


def told(monitor: Monitor) -> dict[str, tuple[str, int | None]]:
    """Return status and since when it stands, of each asset."""
    rows: list[dict[str, Any]] = monitor.status().to_pylist()
    fleet = {row["asset"]: row for row in visible(monitor, FLEET)}
    for row in rows:
        assert fleet[row["asset"]]["status"] == row["status"]
        assert fleet[row["asset"]]["needs_attention"] == (row["status"] == "high")
    return {row["asset"]: (row["status"], row["still_since"]) for row in rows}


def test_a_signal_that_stands_still_is_standing(engine: str) -> None:
    session = engines.session(engine)
    rows = [*moving("moves", range(250)), *moving("stops", range(181))]
    rows += held("stops", range(181, 250), 0.0)  # from the fifth zero on it counts as still
    rows += [*moving("breaks", range(90)), *moving("breaks", range(91, 260, 2))]  # other states
    rows += held("breaks", range(260, 300), 9.0)
    table = scripts.telemetry(session, rows)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("standing")
    calibration = gam_db.Calibration(intervals=[(0, 79)])
    monitor = Monitor(session, source, PARAMETERS, calibration, lookback=0, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    assert told(monitor) == {
        "moves": ("ok", None),
        "stops": ("standing", 184),
        "breaks": ("high", 264),
    }
    said = {row["asset"]: row["remarks"] for row in monitor.status().to_pylist()}
    assert "stands still since 184" in said["stops"]
    assert "stands still since 264" in said["breaks"]
    assert not any("stands" in remark for remark in said["moves"])

    later = range(250, 260)
    scripts.arrive(session, table, [*moving("moves", later), *held("stops", later, 0.0)])
    monitor.score()
    assert told(monitor)["stops"] == ("standing", 184)
    later = range(260, 280)
    scripts.arrive(session, table, [*moving("moves", later), *moving("stops", later)])
    monitor.score()
    assert told(monitor) == {"moves": ("ok", None), "stops": ("ok", None), "breaks": ("high", 264)}
    assert not monitor.check_state().num_rows
