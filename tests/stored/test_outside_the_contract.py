"""What lies outside the contract is shown: rows too late, corrected or gone, and changed calibration."""

from collections.abc import Iterator
from contextlib import contextmanager

import duckdb
import pytest

import comparisons
import frozen
import gam_db
import harness
from gam_db.stored.monitor import Monitor
from small_plant import source
from strategies import Row
from visible import BUCKETS, put, rows_of

pytestmark = pytest.mark.thorough

PARAMETERS = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=10)
CALIBRATION = gam_db.Calibration(intervals=[(0, 99)])

ROWS: list[Row] = [
    (asset, "torque", time, float(time * (3 + number) % 7 % 4))
    for number, asset in enumerate(("r1", "r2"))
    for time in range(400)
    if time % 50 != 20
]


@contextmanager
def watching(
    rows: list[Row], parameters: gam_db.Parameters, calibration: gam_db.Calibration
) -> Iterator[tuple[duckdb.DuckDBPyConnection, Monitor]]:
    """Give a monitor that has scored all rows."""
    with duckdb.connect() as connection:
        source(connection, rows)
        monitor = Monitor(connection, gam_db.Source("telemetry"), parameters, calibration, lookback=20)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        yield connection, monitor


@pytest.fixture
def watched() -> Iterator[tuple[duckdb.DuckDBPyConnection, Monitor]]:
    with watching(ROWS, PARAMETERS, CALIBRATION) as both:
        yield both


def assert_repaired(connection: duckdb.DuckDBPyConnection, rows: list[Row]) -> None:
    asked = (ROWS, rows, PARAMETERS, CALIBRATION)
    harness.assert_same(frozen.buckets(*asked), rows_of(connection, BUCKETS), "buckets")
    comparisons.compared("duckdb", "stored", rows, PARAMETERS, CALIBRATION, ROWS)


def test_a_state_in_order_differs_in_nothing(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    assert watched[1].check_state().num_rows == 0


def test_a_row_within_the_lookback_is_left_to_the_next_run(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    put(connection, [("r1", "torque", 370, 1.0)])
    connection.execute("DELETE FROM telemetry WHERE asset = 'r2' AND time = 385").fetchall()
    assert monitor.check_state().num_rows == 0


def test_a_row_later_than_the_lookback_is_found_and_repaired(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    late = ("r1", "torque", 220, 9.0)
    put(connection, [late])
    monitor.score()
    found = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in found] == [("r1", "scored")]
    assert found[0]["since"] <= 220
    monitor.score(since=found[0]["since"])
    assert_repaired(connection, [*ROWS, late])
    assert monitor.check_state().num_rows == 0


def test_a_late_row_in_the_context_is_seen_by_the_run_itself(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    before = monitor.score().channels
    assert all(row["buckets"] == 0 for row in before), "there is nothing new"
    ends = [row["last_time"] for row in rows_of(connection, BUCKETS) if row["asset"] == "r1"]
    settled = max(end for end in ends if end < ends[-1] - 20)
    late = max(row[2] for row in ROWS if row[0] == "r1" and row[2] < settled)
    connection.execute("DELETE FROM telemetry WHERE asset = 'r1' AND time = ?", [late]).fetchall()
    after = {row["asset"]: row for row in monitor.score().channels}
    assert after["r1"]["context_rows"] == after["r1"]["context_expected"] - 1
    assert after["r2"]["buckets"] == 0
    put(connection, [("r2", "torque", 1 + max(row[2] for row in ROWS), 1.0)])
    after = {row["asset"]: row for row in monitor.score().channels}
    assert after["r2"]["context_rows"] == after["r2"]["context_expected"]


def test_a_corrected_value_is_found_and_repaired(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    connection.execute("UPDATE telemetry SET value = 17 WHERE asset = 'r2' AND time = 205").fetchall()
    found = monitor.check_state().to_pylist()
    # Its bucket, and the next one, whose window holds it.
    assert [(row["asset"], row["part"], row["differing"]) for row in found] == [("r2", "scored", 2)]
    assert found[0]["samples_then"] == found[0]["samples_now"]
    monitor.score(since=found[0]["since"])
    corrected = [(*row[:3], 17.0) if row[0] == "r2" and row[2] == 205 else row for row in ROWS]
    assert_repaired(connection, corrected)


def test_deleted_rows_are_found(watched: tuple[duckdb.DuckDBPyConnection, Monitor]) -> None:
    connection, monitor = watched
    connection.execute("DELETE FROM telemetry WHERE time BETWEEN 150 AND 154").fetchall()
    found = monitor.check_state().to_pylist()
    assert {row["asset"] for row in found} == {"r1", "r2"}
    assert all(row["part"] == "scored" and row["since"] <= 150 for row in found)


def test_a_late_calibration_row_is_counted(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    put(connection, [("r1", "torque", 20, 2.0)])
    monitor.score(everything=True)
    counts = connection.execute(
        "SELECT asset, r.calibration_readings - v.calibration_readings FROM gam_state_run AS r "
        "JOIN gam_state_version AS v USING (version_id) JOIN gam_state_channel USING (channel_id) "
        "WHERE r.calibration_readings IS NOT NULL ORDER BY asset"
    ).fetchall()
    assert counts == [("r1", 1), ("r2", 0)]
    found = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in found] == [("r1", "calibration")]
    assert found[0]["samples_now"] == found[0]["samples_then"] + 1


def test_a_corrected_calibration_value_is_found(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    connection.execute(
        "UPDATE telemetry SET value = 3 - value WHERE asset = 'r1' AND time = 40"
    ).fetchall()
    found = monitor.check_state().to_pylist()
    assert [(row["asset"], row["part"]) for row in found] == [("r1", "calibration")]
    assert found[0]["differing"] > 0


def test_what_was_pruned_is_neither_missed_nor_scored_anew(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection, monitor = watched
    monitor.prune(keep=120)
    kept = rows_of(connection, BUCKETS)
    assert min(row["bucket"] for row in kept) > 0
    connection.execute("DELETE FROM telemetry WHERE time < 200").fetchall()
    found = monitor.check_state()
    assert set(found["part"].to_pylist()) <= {"calibration", "scored"}
    monitor.score(since=150)  # older than what is kept
    assert rows_of(connection, BUCKETS) == kept


def test_the_context_of_single_samples_is_one(
    watched: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    connection = watched[0]
    single = gam_db.Parameters(m=1, bins=4, window=20, stride=10)
    monitor = Monitor(
        connection, gam_db.Source("telemetry"), single, CALIBRATION, lookback=20, name="m = 1"
    )
    monitor.calibrate()
    monitor.score()
    newer = 1 + max(row[2] for row in ROWS)
    put(connection, [(asset, "torque", newer, 1.0) for asset in ("r1", "r2")])
    for row in monitor.score().channels:
        assert row["context_rows"] == row["context_expected"] == 1
