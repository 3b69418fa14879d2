"""Packages that the real dbt builds, on a real recording: the integers of gam score, every time."""

import dataclasses
import datetime as dt
from collections.abc import Callable
from pathlib import Path
from typing import Any

import duckdb
import pytest

import dbt_runs
import gam_db
from gam_db.export import Package, write
from gam_db.stored.monitor import Monitor

CHANNELS = ("Current_J0", "Current_J3", "Speed_J1", "Temperature_T0")
PARAMETERS = gam_db.Parameters(m=3, tau=2, bins=12, window=500, stride=20, max_gap="30 s")
LOOKBACK = "2 min"
BUCKETS = """
    SELECT asset, channel, bucket, first_tick, last_tick, samples, novel, out_of_range, novel_in_window,
        window_length, hi
    FROM gam_health ORDER BY asset, channel, bucket
"""
FLEET = """
    SELECT asset, channel, verdict, cells, bucket, novel_in_window
    FROM gam_fleet ORDER BY asset, channel
"""

Rows = list[tuple[Any, ...]]


@pytest.fixture(scope="module")
def recording(recordings: Path) -> Rows:
    path = recordings / "ur3_cobot" / "series.parquet"
    with duckdb.connect() as connection:
        rows = connection.read_parquet(str(path)).order("ts, channel").fetchall()
    return [row for row in rows if row[1] in CHANNELS]


def scored(
    rows: Rows, calibration: gam_db.Calibration, parameters: gam_db.Parameters
) -> tuple[Rows, Rows]:
    """What gam score makes of the same rows, in one run."""
    with duckdb.connect() as connection:
        source = gam_db.Source(dbt_runs.arrow(rows), time="ts")
        monitor = Monitor(connection, source, parameters, calibration, park_after=False)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        return connection.sql(BUCKETS).fetchall(), connection.sql(FLEET).fetchall()


@pytest.mark.parametrize(
    ("engine", "still_after"),
    [
        ("duckdb", None),
        ("postgres", None),
        pytest.param("duckdb", 4, marks=pytest.mark.full),
    ],
)
def test_dbt_builds_what_gam_scores(
    engine: str, still_after: int | None, recording: Rows, tmp_path: Path
) -> None:
    dbt_runs.executable()
    places: dict[str, Callable[[], dbt_runs.Warehouse]] = {
        "duckdb": lambda: dbt_runs.InDuckDB(tmp_path / "plant.duckdb"),
        "postgres": dbt_runs.InPostgres,
    }
    warehouse = places[engine]()
    first, last = recording[0][2], recording[-1][2]
    calibration = gam_db.Calibration(intervals=[(first, first + 0.3 * (last - first))])
    source = gam_db.Source("telemetry", time="ts", time_kind="timestamp")
    folder = tmp_path / "package"
    parameters = dataclasses.replace(PARAMETERS, still_after=still_after)
    write(Package(source, parameters, calibration, engine, lookback=LOOKBACK), folder)

    # The first six tenths, of which every fifth row of the last two minutes is still on its way.
    edge = first + 0.6 * (last - first)
    begin = edge - dt.timedelta(minutes=1.8)
    late = [row for row in recording if begin < row[2] <= edge][::5]
    warehouse.arrive([row for row in recording if row[2] <= edge and row not in late])
    dbt_runs.run(folder, warehouse, "run")
    early = warehouse.rows(BUCKETS)

    warehouse.arrive([*(row for row in recording if row[2] > edge), *late])
    dbt_runs.run(folder, warehouse, "build")
    found = warehouse.rows(BUCKETS)
    expected, fleet = scored(recording, calibration, parameters)
    assert len(early) < len(found)
    assert found == expected
    assert warehouse.rows(FLEET) == fleet

    # Late rows without a value, between the others: vectors go, and with them the last buckets.
    moment = dt.timedelta(milliseconds=3)
    end = recording[-400:]
    gone = [(*row[:2], row[2] + moment, None) for row in end if row[2].second % 5 == 0]
    warehouse.arrive(gone)
    dbt_runs.run(folder, warehouse, "run")
    fewer = warehouse.rows(BUCKETS)
    assert len(fewer) < len(found)
    assert fewer == scored([*recording, *gone], calibration, parameters)[0]
    dbt_runs.run(folder, warehouse, "build", "--full-refresh")
    assert warehouse.rows(BUCKETS) == fewer
