"""The range that no spike blinds (both sides, section 1), worked out by hand, on every engine."""

from collections.abc import Mapping
from typing import Any

import duckdb
import pytest

import engines
import gam_db
import harness
import reference
from gam_db.findings import dropped, findings
from gam_db.study import Study, naming
from harness import Row

ALL = {"fraction": 1.0}
M2 = {"m": 2, "bins": 16, "window": 20, "stride": 10}

#: A machine that goes from 46 to 54 and back in eight steps.
CYCLE = (46.0, 48.0, 50.0, 52.0, 54.0, 52.0, 50.0, 48.0)


def rows_of(spikes: Mapping[int, float | None], length: int = 240, asset: str = "a") -> list[Row]:
    """Samples of the machine, some of them other values."""
    return [(asset, "x", i, spikes.get(i, CYCLE[i % 8])) for i in range(length)]


#: name -> spikes, length, and what is known by hand: the range, how many were dropped below and above,
#: the farthest of them, and the vectors of two neighbours that are left
CASES: Mapping[str, tuple[Mapping[int, float | None], int, tuple[Any, ...]]] = {
    "nothing is far": ({}, 240, (46.0, 54.0, 0, 0, None, None, 239)),
    "one spike": ({100: 9999.0}, 240, (46.0, 54.0, 0, 1, None, 9999.0, 237)),
    "one on either side": ({100: 1e30, 7: -32768.0}, 240, (46.0, 54.0, 1, 1, -32768.0, 1e30, 235)),
    "the first sample, and one beside a missing one": (
        {0: 32767.0, 9: None, 10: 32767.0},
        240,
        (46.0, 54.0, 0, 2, None, 32767.0, 235),
    ),
    "more than may be dropped": (
        {9: 9999.0, 19: 9999.0, 29: 9999.0, 39: 9999.0},
        240,
        (46.0, 9999.0, 0, 0, None, None, 239),
    ),
    # Of 4,000 samples four may be dropped.
    "four of many": (
        {9: 9999.0, 19: 9999.0, 29: 9999.0, 39: 9999.0},
        4000,
        (46.0, 54.0, 0, 4, None, 9999.0, 3991),
    ),
    # Each round sees the next of them, and there is no fifth round.
    "one behind the other": (
        {9: 1e4, 19: 1e8, 29: 1e12, 39: 1e16, 49: 1e20},
        5000,
        (46.0, 1e4, 0, 4, None, 1e20, 4991),
    ),
    "too few to have a core": ({1: 9999.0}, 4, (46.0, 9999.0, 0, 0, None, None, 3)),
    "one value beside it": (
        {**dict.fromkeys(range(24), 50.0), 9: 9999.0},
        24,
        (50.0, 9999.0, 0, 0, None, None, 23),
    ),
}
NAMES = (
    *("calibrated_lo", "calibrated_hi", "dropped_below", "dropped_above"),
    *("lowest_dropped", "highest_dropped", "calibration_vectors"),
)


def test_what_is_left_out_on_every_engine(engine: str) -> None:
    rows: list[Row] = []
    for name, (spikes, length, _) in CASES.items():
        rows += rows_of(spikes, length, name)
    parameters, calibration = harness.made({**M2, "least_vectors": 1}, ALL)
    found = harness.by_engine(engine)("support", rows, parameters, calibration)
    shown = {row["asset"]: tuple(row[name] for name in NAMES) for row in found}
    assert shown == {name: expected for name, (_, _, expected) in CASES.items()}
    harness.assert_same(reference.support(rows, parameters, calibration), found)


def test_the_paper_takes_all_values() -> None:
    parameters, calibration = harness.made({**M2, "range": "min_max"}, ALL)
    (found,) = gam_db.support(
        gam_db.Source(harness.arrow(rows_of({100: 9999.0}))), parameters, calibration
    ).to_pylist()
    assert tuple(found[name] for name in NAMES) == (46.0, 9999.0, 0, 0, None, None, 239)


@pytest.mark.parametrize("body", ["windows", "census", "streams"])
def test_each_body_leaves_out_the_same(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Later data holds the same spike, which is novel; pools, two sets, missing samples, segments."""
    monkeypatch.setattr(naming, "STREAMED_FROM", 1)
    monkeypatch.setattr(naming, "EVERY", 8)
    monkeypatch.setattr(naming, "GLANCE", 100)
    rows = rows_of({20: 9999.0, 130: 9999.0, 40: None, 150: None})
    rows += [
        ("b", name, time + 30 * (time > 70), value) for _, name, time, value in rows_of({3: -500.0})
    ]
    rows += rows_of({5: 1e30, 6: 2e9}, 200, "c")
    settings = {**M2, "max_gap": 20, "overrides": [{"asset": "c", "range": "min_max"}]}
    calibration = {"fraction": 0.5, "pool": [["a", "b"]]}
    asked = rows, *harness.made(settings, calibration)
    session = engines.session("duckdb")
    with session.lent(harness.arrow(rows if body != "census" else rows[::2] + rows[1::2])) as table:
        more: dict[str, Any] = {} if body == "windows" else {"short_cuts": True}
        study = Study(session, gam_db.Source(table.name), *asked[1:], **more)
        for question, step in harness.STEPS.items():
            if question != "health_indicator":
                harness.assert_same(
                    getattr(reference, "buckets" if "health" in question else question)(*asked),
                    study.table(step).to_pylist(),
                    question,
                )
        assert study.form == body
        study.forget()


def test_later_rounds_are_made_where_one_has_dropped_something() -> None:
    made: list[str] = []
    for spikes in ({}, {100: 9999.0}):
        with gam_db.connect() as session:
            source = gam_db.Source(harness.arrow(rows_of(spikes)))
            study = Study(session, source, *harness.made(M2, ALL), made.append)
            study.table("support_summary")
        rounds = [step for step in made if step.startswith("range_counts")]
        assert rounds == [f"range_counts_{n}" for n in ([1, 2] if spikes else [1])]
        made.clear()


def test_it_is_frozen_checked_and_told(tmp_path: Any) -> None:
    with duckdb.connect(str(tmp_path / "plant.duckdb")) as connection:
        telemetry = harness.arrow(rows_of({100: 9999.0}, 400))  # noqa: F841
        connection.execute("CREATE TABLE telemetry AS FROM telemetry")
        method = harness.made(M2, {"fraction": 0.5})
        monitor = gam_db.Monitor(connection, gam_db.Source("telemetry"), *method)
        monitor.migrate()
        (row,) = monitor.calibrate().to_pylist()
        said = ["1 reading of 9999 left out of the range 46 to 54"]
        assert dropped(row) == said
        monitor.score()
        columns = "dropped_below, dropped_above, lowest_dropped, highest_dropped"
        kept = connection.execute(f"SELECT {columns} FROM gam_state_bounds").fetchall()
        assert kept == [(0, 1, None, 9999.0)]
        assert connection.execute("SELECT is_robust FROM gam_state_version").fetchall() == [(1,)]
        assert monitor.check_state().to_pylist() == []
        assert said[0] in monitor.status().to_pylist()[0]["remarks"]
        assert monitor.calibrate().num_rows == 0  # with the same settings nothing is due
        connection.execute("UPDATE gam_state_bounds SET highest_dropped = 99")
        (wrong,) = monitor.check_state().to_pylist()
        assert wrong["part"] == "calibration"
        connection.execute("UPDATE gam_state_bounds SET dropped_above = 2")
        (wrong,) = monitor.check_state().to_pylist()
        assert wrong["part"] == "frozen"


def test_several_are_told_by_the_farthest() -> None:
    row = {
        "calibrated_lo": 46.0,
        "calibrated_hi": 54.5,
        "lowest_dropped": -1e30,
        "highest_dropped": 99.0,
    }
    assert dropped({**row, "dropped_below": 2, "dropped_above": 1}) == [
        "2 readings down to -1e+30 and 1 reading of 99 left out of the range 46 to 54.5"
    ]
    with gam_db.connect() as session:
        source = gam_db.Source(harness.arrow(rows_of({100: 9999.0}, 400)))
        (found,) = findings(Study(session, source, *harness.made(M2, {"fraction": 0.5})))
    assert "1 reading of 9999 left out of the range 46 to 54" in found["remarks"]
