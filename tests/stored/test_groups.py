"""Signals of a machine that open together, and what is told of each: in gam_alarm and gam_fleet."""

import json
from pathlib import Path
from typing import Any

import duckdb
import pytest
import typer.testing

import engines
import gam_db
import scripts
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.monitor import Monitor
from strategies import Row
from test_explained import ALARMS, CALM, RAISED, SETTING, W
from visible import visible

#: How many calm windows each signal has before it is raised; the fourth raised one opens an episode.
BEGINS = {("a", "x"): 0, ("a", "y"): 2, ("a", "z"): 5, ("b", "x"): 0}


def raised(session: Any, prefix: str = "gam_") -> Monitor:
    """A monitor of those signals, scored."""
    rows: list[Row] = []
    for (asset, channel), begin in BEGINS.items():
        windows = [*CALM, *CALM[:1] * begin, *[RAISED] * (12 - begin)]
        values = [value for window in windows for value in window]
        rows += [(asset, channel, time, value) for time, value in enumerate(values)]
    source = gam_db.Source(scripts.telemetry(session, rows).name)
    asked = gam_db.Parameters(**SETTING), gam_db.Calibration(intervals=[(0, 8 * W - 1)]), ALARMS
    monitor = Monitor(session, source, *asked, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    return monitor


def assert_told(monitor: Monitor) -> None:
    """Y opens two judgements after x, z three after y, and another machine's are its own."""
    found = {
        (row["asset"], row["channel"]): (row["incident"], row["signals_together"])
        for row in monitor.alarms().to_pylist()
    }
    assert found == {("a", "x"): (1, 2), ("a", "y"): (1, 2), ("a", "z"): (3, 1), ("b", "x"): (4, 1)}
    query = (
        "SELECT incident_id, is_message FROM gam_alarm_event WHERE what = 'opened' ORDER BY episode_id"
    )
    events = [tuple(row.values()) for row in visible(monitor, query)]
    assert events == [(1, 1), (1, 0), (3, 1), (4, 1)], "one message for each incident"
    begun = {(n, (8 + windows) * W) for n, windows in enumerate(BEGINS.values(), start=1)}
    fleet = visible(monitor, "SELECT judged_by, episode_id, since_tick FROM gam_fleet")
    assert {row["judged_by"] for row in fleet} == {"episode"}
    assert {(row["episode_id"], row["since_tick"]) for row in fleet} == begun
    said = monitor.status().select(["episode", "onset", "remarks"]).to_pylist()
    assert {(row["episode"], row["onset"]) for row in said} == begun
    assert f"episode 2 since {10 * W}: gam alarm 2" in [one for row in said for one in row["remarks"]]
    monitor.label("false_alarm", 1)  # right after calibration: judged by episodes no more
    query = "SELECT status, judged_by, limit_reason FROM gam_fleet WHERE asset = 'a' AND channel = 'x'"
    said = {"status": "setup", "judged_by": None, "limit_reason": "unrepresentative"}
    assert visible(monitor, query) == [said]


def test_openings_of_a_machine_within_two_judgements_are_one_group(tmp_path: Path) -> None:
    path = tmp_path / "plant.duckdb"
    with DuckSession(path, writable=True) as session:
        assert_told(raised(session))
    shown = typer.testing.CliRunner().invoke(app, ["alarms", "--database", str(path)])
    words = " ".join(shown.output.split())
    assert words.count("signals of this machine") == 1, "an episode that ended stays a part of its group"
    assert "a: 2 signals of this machine within 2 judgements are incident 1" in words
    told = typer.testing.CliRunner().invoke(app, ["alarms", "--database", str(path), "--json"])
    assert {row["signals_together"] for row in json.loads(told.output)["episodes"]} == {1, 2}

    run = typer.testing.CliRunner().invoke(app, ["label", "4", "new_program", "--database", str(path)])
    assert "episode 4 (b x, " in run.output
    said = " ".join(run.output.split())
    assert "is labelled new_program: needs no attention, and does not count as above its limit" in said
    run = typer.testing.CliRunner().invoke(app, ["alarm", "2", "--database", str(path)])
    for words in ("30 to 32", "above 40", "-9"):
        assert words in run.output
    for line in ("feedback: none yet", "(! while the episode is open):", "  gam label 2 true_fault "):
        assert line in run.output
    words = " ".join(run.output.split())
    assert "times the alarm threshold; basis table" in words
    assert run.output.startswith(
        "2 signals of this machine opened within two judgements; the strongest, x: "
    )
    printed = run.output.partition("of its database:\n")[2].partition(";\n")[0]
    run = typer.testing.CliRunner().invoke(app, ["alarm", "2", "--database", str(path), "--json"])
    why = json.loads(run.output)
    assert [band["excess"] for band in why["bands"]] == [10.0, 5.0], "none without excess"
    assert [cell["visits"] for cell in why["cells"]] == [14, 7]
    assert words.startswith(f"{why['finding']} What to do next: {why['advice']} episode 2: a / ")
    with duckdb.connect(str(path), read_only=True) as connection:
        rows = connection.execute(why["raw_rows"]).fetchall()
        assert connection.execute(printed).fetchall() == rows, "as it is pasted"
    assert [row[-1] for row in rows] == RAISED * 10, "of this signal, from its onset on"


@pytest.mark.full
def test_groups_bands_and_cells_are_told_on_every_engine(engine: str) -> None:
    monitor = raised(engines.session(engine), engines.fresh_name("raised"))
    assert_told(monitor)
    query = "SELECT band, excess FROM gam_alarm_band WHERE episode_id = 2 ORDER BY band"
    bands = [(row["band"], row["excess"]) for row in visible(monitor, query)]
    assert bands == [(5, -5 / 16), (15, 10.0), (20, 5.0)]
    query = (
        "SELECT visits, steps, displacement FROM gam_alarm_cell WHERE episode_id = 2 ORDER BY cell_rank"
    )
    cells = [tuple(row.values()) for row in visible(monitor, query)]
    assert cells == [(14, 9, -9), (7, 1, 1)], "of its seven judgements"
