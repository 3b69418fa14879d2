"""Signals of a machine that open together: which openings are one group (alarms, section 5)."""

import json
from pathlib import Path

import typer.testing

import gam_db
import scripts
from gam_db.cli import app
from gam_db.engines.duckdb_session import DuckSession
from strategies import Row
from test_explained import ALARMS, CALM, RAISED, SETTING, W


def test_openings_of_a_machine_within_two_judgements_are_one_group(tmp_path: Path) -> None:
    # The fourth raised window opens an episode: that of each signal three windows after its first.
    begins = {("a", "x"): 0, ("a", "y"): 2, ("a", "z"): 5, ("b", "x"): 0}
    rows: list[Row] = []
    for (asset, channel), begin in begins.items():
        windows = [*CALM, *CALM[:1] * begin, *[RAISED] * (12 - begin)]
        values = [value for window in windows for value in window]
        rows += [(asset, channel, time, value) for time, value in enumerate(values)]
    path = tmp_path / "plant.duckdb"
    with DuckSession(path, writable=True) as session:
        source = gam_db.Source(scripts.telemetry(session, rows).name)
        calibration = gam_db.Calibration(intervals=[(0, 8 * W - 1)])
        monitor = gam_db.Monitor(session, source, gam_db.Parameters(**SETTING), calibration, ALARMS)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        found = {
            (row["asset"], row["channel"]): (row["group"], row["signals_together"])
            for row in monitor.alarms().to_pylist()
        }
    # y opens two judgements after x, z three after y, and another machine's are its own.
    assert found == {("a", "x"): (1, 2), ("a", "y"): (1, 2), ("a", "z"): (3, 1), ("b", "x"): (4, 1)}
    shown = typer.testing.CliRunner().invoke(app, ["alarms", "--database", str(path)])
    words = " ".join(shown.output.split())
    assert words.count("signals of this machine") == 1
    assert "a: 2 signals of this machine within 2 judgements, from episode 1 on" in words
    told = typer.testing.CliRunner().invoke(app, ["alarms", "--database", str(path), "--json"])
    assert {row["signals_together"] for row in json.loads(told.output)["episodes"]} == {1, 2}
