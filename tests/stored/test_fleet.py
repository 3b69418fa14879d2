"""Many channels: reads of the source grow with the groups of channels, not with the channels."""

from collections.abc import Iterator
from typing import Any

import duckdb
import pytest

import comparisons
import frozen
import gam_db
import harness
from gam_db.stored import calibrating
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning import reading, whole_pools
from small_plant import source
from strategies import Row
from test_outside_the_contract import watching
from visible import BUCKETS, put, rows_of

#: Robots a and b, c and d share their supports; e and f are cut more coarsely, and f has a pause.
ROWS: list[Row] = [
    (asset, "torque", time, float(time * (3 + number) % 7 % 4) if time % 31 else None)
    for number, asset in enumerate("abcdef")
    for time in range(20 * number, 300)
    if time % 50 != 20 and not (asset == "f" and 60 < time < 80)
]
PARAMETERS = gam_db.Parameters(
    m=2,
    tau=3,
    bins=4,
    window=20,
    stride=10,
    max_gap=10,
    overrides=[gam_db.Override(asset=asset, bins=3) for asset in "ef"],
)
CALIBRATION = gam_db.Calibration(
    fraction=0.5,
    exclude=[(50, 55)],
    pool=[["a", "b"], ["c", "d"]],
)


@pytest.fixture
def fleet() -> Iterator[tuple[duckdb.DuckDBPyConnection, Monitor]]:
    with watching(ROWS, PARAMETERS, CALIBRATION) as both:
        yield both


@pytest.fixture
def reads(monkeypatch: pytest.MonkeyPatch) -> list[tuple[Any, ...]]:
    """What was asked for, each time that the source was read."""
    found: list[tuple[Any, ...]] = []
    real = reading.Reader.readings

    def noted(self: reading.Reader, *asked: Any) -> Any:
        found.append(asked)
        return real(self, *asked)

    monkeypatch.setattr(reading.Reader, "readings", noted)
    return found


def test_the_fleet_is_scored_as_by_the_reference(
    fleet: tuple[duckdb.DuckDBPyConnection, Monitor],
) -> None:
    expected = frozen.buckets(ROWS, ROWS, PARAMETERS, CALIBRATION)
    harness.assert_same(expected, rows_of(fleet[0], BUCKETS), "buckets")
    comparisons.compared("duckdb", "stored", ROWS, PARAMETERS, CALIBRATION, ROWS)
    assert {row["asset"] for row in expected} == set("abcdef")


@pytest.mark.parametrize("limit", [None, 1])
def test_calibration_is_compared_pool_by_pool(
    fleet: tuple[duckdb.DuckDBPyConnection, Monitor], limit: int | None
) -> None:
    connection, monitor = fleet
    assert monitor.check_state(limit).num_rows == 0
    # A cell of one pool goes; a reading of another channel comes, and comes again, which is no
    # other one, and no vector of it is new.
    connection.execute("UPDATE telemetry SET value = 0 WHERE asset = 'c' AND time = 62").fetchall()
    put(connection, [("f", "torque", 102, 9.0), ("f", "torque", 102, 9.0)])
    found = [row for row in monitor.check_state(limit).to_pylist() if row["part"] == "calibration"]
    shown = {
        row["asset"]: (row["samples_now"] - row["samples_then"], row["differing"] > 0) for row in found
    }
    assert shown == {"c": (0, True), "d": (0, True), "f": (1, False)}


def test_the_state_is_checked_in_few_reads(
    fleet: tuple[duckdb.DuckDBPyConnection, Monitor], reads: list[tuple[Any, ...]]
) -> None:
    fleet[1].check_state()
    # All rows are counted; then buckets of all, calibration of those cut into 4, and of those into 3.
    assert len(reads) == 1 + 1 + 2
    ends = [asked[2] for asked in reads if len(asked) == 3]
    assert len(ends) == 2
    assert all(end < ROWS[-1][2] for end in ends), "nothing is read after calibration"


def test_the_method_is_hashed_once(monkeypatch: pytest.MonkeyPatch) -> None:
    hashes = iter(["the only one"])
    monkeypatch.setattr(calibrating, "method_hash", lambda: next(hashes))
    with duckdb.connect() as connection:
        source(connection, ROWS)
        with Monitor(connection, gam_db.Source("telemetry"), PARAMETERS, CALIBRATION) as monitor:
            monitor.migrate()
            assert monitor.calibrate().num_rows == 6
    assert next(hashes, None) is None


def test_pools_stay_whole() -> None:
    rows: list[dict[str, Any]] = [
        {"asset": str(number), "channel": "x", "support_id": support}
        for number, support in enumerate((1, 2, 1, 3, 4))
    ]
    readings = {(row["asset"], "x"): 4 for row in rows}
    groups = [[row["asset"] for row in group] for group in whole_pools(rows, readings, 8)]
    assert groups == [["0", "2"], ["1", "3"], ["4"]]
    assert list(whole_pools([], readings, 8)) == []
