"""What is looked at and shown is the same on every engine: check, status, the views, check --state."""

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sqlglot import exp

import engines
import gam_db
import harness
import look_reference
import scripts
import small_plant
from gam_db.method import census
from gam_db.stored.monitor import Monitor
from looks import single
from small_plant import FIRST, LENGTH, LOOKBACK, readings
from strategies import Case, Row, cases
from visible import BUCKETS, NOVEL, visible

pytestmark = pytest.mark.thorough

#: When things were done; all else is the same in two runs.
CLOCKS = ("calibrated_at", "looked_at", "last_run", "created", "run_id")
OF_CALIBRATION = (
    *("calibration_samples", "calibration_lowest", "calibration_highest"),
    *("still_after", "calibration_still", "still_runs", "longest_run"),
)


def test_figures_of_check_are_those_of_numpy(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(census, "IN_SLICE", 1)

    @settings(max_examples=max(engines.examples(engine) // 4, 1))
    @given(case=cases(), repeats=st.booleans())
    def agrees(case: Case, repeats: bool) -> None:
        rows, parameters, calibration = case
        rows = rows if repeats else single(rows)
        table = scripts.telemetry(engines.session(engine), rows)
        asked = (gam_db.Source(table.name), *harness.made(parameters, calibration))
        found = gam_db.check(*asked, engine=engines.session(engine)).drop_columns(["notes"])
        times = ("first_time", "last_time")
        plain = found.drop_columns([*OF_CALIBRATION, *times]).to_pylist()
        harness.assert_same(look_reference.figures(rows), plain)
        scripts.clear(engines.session(engine), table.name, f"{table.name}_none_")

    agrees()


def told(engine: str) -> dict[str, list[dict[str, Any]]]:
    """Score a plant in two runs, change what was read, and return all that is shown of it."""
    session, prefix = engines.session(engine), engines.fresh_name("state")
    table = scripts.telemetry(session, readings(0, FIRST))
    parameters = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
    calibration = gam_db.Calibration(fraction=0.7)
    source = gam_db.Source(table.name)
    monitor = Monitor(session, source, parameters, calibration, lookback=LOOKBACK, prefix=prefix)
    monitor.migrate()
    made = monitor.calibrate().to_pylist()
    scripts.arrive(session, table, readings(FIRST, 200))
    monitor.score()
    scripts.arrive(session, table, readings(200, LENGTH))
    monitor.score()
    seen = {"calibrate": made, "check --state": monitor.check_state().to_pylist()}
    late: list[Row] = [("b", "x", 150, -9.0), ("c", "x", 10, 1.0)]
    scripts.arrive(session, table, late)
    seen["check --state, late rows"] = monitor.check_state().to_pylist()
    seen["buckets"], seen["novel"] = visible(monitor, BUCKETS), visible(monitor, NOVEL)
    seen["status"] = monitor.status().to_pylist()
    seen["health"] = monitor.health().to_pylist()
    for view in ("fleet", "quarantine"):
        query = exp.select("*").from_(monitor.state.tables.table(view))
        seen[view] = sorted(session.fetch(query).to_pylist(), key=repr)
    return {
        name: [{key: value for key, value in row.items() if key not in CLOCKS} for row in rows]
        for name, rows in seen.items()
    }


@pytest.fixture(scope="module")
def expected() -> dict[str, list[dict[str, Any]]]:
    return told("duckdb")


def test_all_that_is_shown_is_what_duckdb_shows(
    engine: str, expected: dict[str, list[dict[str, Any]]]
) -> None:
    found = told(engine)
    for name, rows in expected.items():
        harness.assert_same(rows, found[name], name)
    assert [found["buckets"], found["novel"]] == small_plant.whole()
    assert found["check --state"] == []
    assert {row["part"] for row in found["check --state, late rows"]} == {"scored", "calibration"}
    assert [name for name, rows in found.items() if not rows] == ["check --state"]
