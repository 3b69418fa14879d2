"""A machine that stands is neither healthy nor alarming: status and fleet say so, and since when."""

import datetime as dt
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import engines
import gam_db
import scripts
from gam_db.cli import app
from gam_db.findings import findings
from gam_db.stored.monitor import Monitor
from gam_db.study import Study
from strategies import Row
from visible import visible
from watched_recordings import RECORDINGS

pytestmark = pytest.mark.thorough

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
    """And so says a run over all of it, after each score."""
    session = engines.session(engine)
    rows = [*moving("moves", range(250)), *moving("stops", range(181))]
    rows += held("stops", range(181, 250), 0.0)  # from the fifth zero on it counts as still
    rows += [*moving("breaks", range(90)), *moving("breaks", range(91, 260, 2))]  # other states
    rows += held("breaks", range(260, 300), 9.0)
    table = scripts.telemetry(session, rows)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("standing")
    calibration = gam_db.Calibration(intervals=[(0, 79)])
    monitor = Monitor(session, source, PARAMETERS, calibration, lookback=0, prefix=prefix)

    def told_by_all() -> dict[str, tuple[str, int | None]]:
        found = findings(Study(session, source, PARAMETERS, calibration))
        assert all(row["is_above"] is None for row in found if row["status"] == "standing")
        return {row["asset"]: (row["status"], row["still_since"]) for row in found}

    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    assert told_by_all() == told(monitor)
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
    assert told_by_all() == told(monitor)
    later = range(260, 280)
    scripts.arrive(session, table, [*moving("moves", later), *moving("stops", later)])
    monitor.score()
    assert told(monitor) == {"moves": ("ok", None), "stops": ("ok", None), "breaks": ("high", 264)}
    assert told_by_all() == told(monitor)
    assert not monitor.check_state().num_rows


#: What ``gam run`` and ``gam status`` say alike of how a channel is at its end.
ALIKE = ("status", "needs_attention", "hi", "judged_by", "silent", "still_since")


def said(*words: str) -> dict[str, Any]:
    result = CliRunner().invoke(app, [*words, "--json"])
    assert result.exit_code in (0, 2, 4), result.output
    figures: dict[str, Any] = json.loads(result.stdout)
    return figures


def agreed(
    source: str, database: str, method: Sequence[str], where: Sequence[str]
) -> dict[tuple[str, str], str]:
    """What a run says of each channel, which must be what a monitor says of it."""
    run = said("run", source, *method, *where, "--no-out")
    said("calibrate", source, *method, "--database", database)
    said("score", "--database", database)
    ours, theirs = (
        {(row["asset"], row["channel"]): [row[name] for name in ALIKE] for row in figures["channels"]}
        for figures in (run, said("status", "--database", database))
    )
    assert ours == theirs
    return {name: row[0] for name, row in ours.items()}


@pytest.mark.parametrize("zone", [None, "UTC"])
def test_a_run_says_so_too(zone: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    rows = [
        *moving("moves", range(250)),
        *moving("stops", range(181)),
        *held("stops", range(181, 250), 0.0),
    ]
    rows += [*moving("paper", range(181)), *held("paper", range(181, 250), 0.0)]
    rows += [
        *moving("ends", range(200)),
        *moving("waits", range(120)),
        *held("waits", range(120, 250), 0.0),
    ]
    start = dt.datetime(2026, 1, 1)
    times = [start + dt.timedelta(hours=time) for _, _, time, _ in rows]
    columns = {
        name: [row[place] for row in rows]
        for place, name in ((0, "asset"), (1, "channel"), (3, "value"))
    }
    table = pa.table({**columns, "ts": pa.array(times, pa.timestamp("us", zone))})
    parquet.write_table(table, "plant.parquet")
    override = '[[override]]\nasset = "paper"\nstill_after = false\n'
    Path("gam.toml").write_text(override)
    method = ["--m=2", "--bins=4", "--window=80", "--stride=4", "--still-after=5"]
    method.append("--calibrate=2026-01-01/2026-01-04T07:00:00")
    assert agreed("plant.parquet", "plant.duckdb", method, []) == {
        ("ends", "x"): "ok",
        ("moves", "x"): "ok",
        ("paper", "x"): "high",
        ("stops", "x"): "standing",
        ("waits", "x"): "standing",
    }
    run = ["run", "plant.parquet", *method, "--no-out", "--all"]
    shown = CliRunner().invoke(app, run).stdout
    assert "2 standing still" in shown
    assert "silent: 1" in shown.splitlines()
    remarks = " ".join(shown.split())
    assert "stops x: stands still since 2026-01-08T16:00:00 UTC" in remarks
    assert "ends x: silent: 2.08 d behind the newest data" in remarks
    Path("gam.toml").write_text(f'{override}[monitor]\npark_after = "3 d"\n')
    assert "silent" not in CliRunner().invoke(app, run).stdout


#: Of each recording the channels that the first set takes; the full set takes all.
SOME = {
    "plant": "channel IN ('L_1', 'A_1', 'C_2')",
    "bearings": "asset LIKE 'Bearing3_1'",
    "actuators": "asset = 'Act_1' AND channel = 'PG_1'",
    "rig": "channel IN ('CE', 'TS1')",
    "cobot": "channel LIKE 'Speed%'",
}


@pytest.mark.parametrize("some", [True, pytest.param(False, marks=pytest.mark.full)])
@pytest.mark.parametrize("name", SOME)
def test_so_it_does_of_recordings_and_of_one_that_froze(
    name: str, some: bool, recordings: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    recording = RECORDINGS[name]
    file = recordings / recording.folder / "series.parquet"
    with duckdb.connect("plant.duckdb") as connection:
        some_rows = SOME[name] if some else "TRUE"
        connection.execute(f"CREATE TABLE telemetry AS SELECT * FROM '{file}' WHERE {some_rows}")
        connection.execute(
            f"""
            INSERT INTO telemetry
            WITH one AS (
              SELECT *, row_number() OVER (ORDER BY {recording.time}) / count(*) OVER () AS part
              FROM telemetry
              WHERE (asset, channel) = (SELECT min((asset, channel)) FROM telemetry)
            )
            SELECT 'frozen', channel, {recording.time}, CASE WHEN part > 0.9 THEN 1 ELSE value END
            FROM one
            """
        )
        columns = [row[0] for row in connection.execute("DESCRIBE telemetry").fetchall()]
    assert columns == ["asset", "channel", recording.time, "value"]
    parameters, calibration = recording.parameters, recording.calibration
    method = [
        f"--bins={parameters.bins}",
        f"--window={parameters.window}",
        f"--max-gap={parameters.max_gap}",
    ]
    method += [f"--time={recording.time}", "--still-after=25", "--rate=1 per 1000 judgements"]
    method.append(f"--calibration-fraction={calibration.fraction or 0.2}")
    told = agreed("telemetry", "plant.duckdb", method, ["--database", "plant.duckdb"])
    frozen = {status for (asset, _), status in told.items() if asset == "frozen"}
    assert frozen <= {"standing", "open", "proving", "high", "setup"}
