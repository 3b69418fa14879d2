"""Several monitors in one state: what is said of one is what is said of it alone."""

from typing import Any

from sqlglot import exp

import gam_db
import scripts
from gam_db.stored.alarms import labels as alarms
from gam_db.stored.monitor import Monitor
from strategies import Row
from test_falsified import ALARMS, CALIBRATED, CALM, ENDS, LOOKBACK, PARAMETERS, made

#: One name before, one after that of the monitor that is asked; the keys of both come after its own.
BESIDE = ("a", "z")


def answers(monitor: Monitor) -> dict[str, Any]:
    """Return all that can be asked of a monitor."""
    found: dict[str, Any] = {
        "status": monitor.status(),
        "health": monitor.health(),
        "alarms": monitor.alarms(),
        "limits": monitor.limits(),
        "events": alarms.events(monitor.state, monitor.name),
        "differences": monitor.check_state(),
    }
    told = {name: table.to_pylist() for name, table in found.items()}
    report = monitor.score(dry_run=True)
    told["left_out"] = alarms.left_out(monitor.state, monitor.name)
    told["new"] = (report.channels, report.unknown_channels, report.ranges)
    told["pruned"] = monitor.prune(keep=90, dry_run=True).to_pylist()
    return told


def test_a_monitor_says_the_same_of_its_channels_beside_others() -> None:
    monitor = made("duckdb", ["one", "two"])
    table = gam_db.Source(str(monitor.source.relation))
    rows: list[Row] = [("three", "x", time, float(time % 5)) for time in range(ENDS[-1])]
    scripts.arrive(monitor.session, exp.to_table(str(monitor.source.relation)), rows)
    alone = answers(monitor)
    assert len(alone["alarms"]) == 2
    assert {row["calibration_rows"] for row in alone["status"]} == {CALIBRATED + 1}
    assert alone["left_out"].keys() == {"one"}
    assert alone["new"][1].keys() == {("three", "x")}
    for name in BESIDE:
        calibration = gam_db.Calibration(intervals=[(0, CALM)])
        given: dict[str, Any] = {"lookback": LOOKBACK, "prefix": monitor.prefix, "name": name}
        other = Monitor(monitor.session, table, PARAMETERS, calibration, ALARMS, **given)
        assert other.calibrate().num_rows == 3
        other.score()
        other.label("maintenance", asset="three", span=(CALM + 1, CALM + 5))
    again = answers(monitor)
    for question, said in alone.items():
        assert again[question] == said, question
