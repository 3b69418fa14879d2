"""The look before calibration: its figures against NumPy, odd sources, and its words."""

import dataclasses
import sqlite3
from contextlib import closing
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import comparisons
import frozen
import gam_db
import harness
import look_reference
import reference
from gam_db import Calibration, Parameters, Source, WideSource
from gam_db.checking.look import add_look
from gam_db.checking.words import roundest, setting, spoken
from gam_db.clock import TimeKind, length
from gam_db.errors import SourceError
from gam_db.method import census
from gam_db.study import Study
from looks import SECOND, figures, said, single, table, wave
from strategies import Case, cases

OF_CALIBRATION = ("calibration_samples", "calibration_lowest", "calibration_highest")
STILL = ("still_after", "calibration_still", "still_runs", "longest_run")
TIMES = ("first_time", "last_time")


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cut short sources into as many slices as long ones."""
    monkeypatch.setattr(census, "IN_SLICE", 1)


# Figures


@settings(max_examples=settings().max_examples // 4)
@given(cases(), st.booleans())
def test_figures_are_those_of_numpy(case: Case, repeats: bool) -> None:
    """The calibration's samples are compared with those that the method counts."""
    rows, parameters, calibration = case
    rows = rows if repeats else single(rows)
    made = harness.made(parameters, calibration)
    found = gam_db.check(Source(harness.arrow(rows)), *made).drop_columns(["notes"])
    assert found["first_time"].equals(found["first_tick"])
    assert found["last_time"].equals(found["last_tick"])
    plain = found.drop_columns([*OF_CALIBRATION, *STILL, *TIMES]).to_pylist()
    harness.assert_same(look_reference.figures(rows), plain)

    for (channel, _), seen in zip(reference.channels(rows, *made), found.to_pylist(), strict=True):
        after = channel.settings.still_after or 25
        channel.settings = dataclasses.replace(channel.settings, still_after=after)
        stands = zip(frozen.stands_still(channel), channel.healthy, strict=True)
        assert seen["calibration_still"] == sum(still and healthy for still, healthy in stands)
        assert seen["still_after"] in (None, after)

    if not made[1].pools:  # a pool's range is that of all members
        learnt = harness.by_reference("support", rows, *made)
        for left, right in zip(learnt, found.to_pylist(), strict=True):
            assert left["calibration_samples"] == right["calibration_samples"]
            ends = (("lowest_dropped", "calibrated_lo"), ("highest_dropped", "calibrated_hi"))
            farthest = [left[calm if left[stray] is None else stray] for stray, calm in ends]
            assert farthest == [right[name] for name in OF_CALIBRATION[1:]]
        comparisons.compared("duckdb", "check", rows, *made)


@pytest.mark.parametrize(
    ("length", "period"), [(9001, 4), (9001, 7), (9001, 25), (9001, 300), (9001, 1000), (100_003, 9000)]
)
def test_long_series_agree_too(length: int, period: int) -> None:
    values = wave(length, period)
    values[4000:4100] = np.nan
    rows: list[Any] = [("a", "x", 3 * t, v) for t, v in enumerate(values.tolist())]
    found = gam_db.check(Source(harness.arrow(rows))).drop_columns(["notes"])
    plain = found.drop_columns([*OF_CALIBRATION, *STILL, *TIMES]).to_pylist()
    expected = look_reference.figures(rows)
    harness.assert_same(expected, plain)
    assert expected[0]["cycle_length"] is not None
    assert abs(expected[0]["cycle_length"] - period) <= max(0.03 * period, 0.5)


def test_sqlite_reads_samples_once_for_each_look() -> None:
    """Not once for each row of a grouping that they are joined with."""
    with closing(sqlite3.connect(":memory:")) as connection, gam_db.connect(connection) as session:
        connection.execute("CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value REAL)")
        rows = [("a", channel, time, time // 3 % 7) for time in range(300) for channel in "xyz"]
        connection.executemany("INSERT INTO telemetry VALUES (?, ?, ?, ?)", rows)
        asked = session, Source("telemetry"), Parameters(), Calibration()
        study = Study(*asked, strict=False)
        add_look(study.steps, study.method, study.instant_of)
        for step in ("step_counts", "longest_stills", "stood", "granules", "quanta"):
            text = f"EXPLAIN QUERY PLAN {session.engine.text(study.query(step))}"
            plan = [(parent, said) for _, parent, _, said in connection.execute(text)]
            ((at, within),) = [
                (place, parent) for place, (parent, said) in enumerate(plan) if said == "SCAN telemetry"
            ]
            around = [said for parent, said in plan[:at] if parent == within]
            assert not [said for said in around if said.startswith("SCAN")], step


def test_the_head_of_a_channel_is_bounded() -> None:
    """Values beyond the first 163,840 samples change the range, not what is looked for in the head."""
    values = np.resize(np.arange(50.0), look_reference.HEAD + 1000)
    values[look_reference.HEAD :] = np.linspace(100, 200, 1000)
    found = figures(table(values))
    assert (found["values_seen"], found["quantum"], found["cycle_length"]) == (50, 1.0, 50)
    assert (found["samples"], found["highest"]) == (look_reference.HEAD + 1000, 200.0)


@pytest.mark.parametrize("walk", [False, True])
def test_noise_and_random_walks_have_no_cycle(walk: bool) -> None:
    noise = np.random.default_rng(0).standard_normal(20_000)
    assert figures(table(np.cumsum(noise) if walk else noise))["cycle_length"] is None


# Layouts, odd sources


def test_a_wide_source() -> None:
    wide = pa.table({"t": np.arange(400), "p": wave(400), "q": pa.array([None] * 399 + [1.0])})
    found = said(WideSource(wide, asset=None, time="t"))
    assert found["missing"].channels == (("asset", "q"),)
    assert found["constant"].channels == (("asset", "q"),)


def test_a_stream_is_read_once() -> None:
    reader = table(wave(300), note=["1"] * 300).to_reader()
    assert "number_texts" in said(Source(reader))


def test_the_clocks_end_is_refused_and_the_widest_span_is_not() -> None:
    with pytest.raises(SourceError, match=r"beyond 2\^62"):
        gam_db.check(Source(table([1.0, 2.0], times=[0, 2**62])))
    found = figures(table([1.0, 2.0, 3.0], times=[1 - 2**62, 0, 2**62 - 1]))
    assert (found["typical_step"], found["pauses"]) == (2**62 - 1, 0)
    said(table([1.0, 2.0, 3.0], times=[1 - 2**62, 0, 2**62 - 1]))


def test_timestamps_beyond_any_calendar() -> None:
    times = pa.array([0, 2**61, 2**61 + 10**6], pa.timestamp("us"))
    assert "us since 1970" in said(table([1.0, 2.0, 3.0], times=times))["ahead"].text
    source = Source(table([1.0, 2.0, 3.0], times=times), clock_tolerance=False)
    assert "us since 1970" in said(source)["calendar"].text


@pytest.mark.parametrize("extreme", [1e300, -1e300, 5e-324])
def test_extreme_values(extreme: float) -> None:
    values = np.where(np.arange(400) % 3 == 0, extreme, 0.0)
    found = figures(table(values))
    assert (found["values_seen"], found["missing"]) == (2, 0)
    said(table(values))


# Words


@pytest.mark.parametrize(
    ("micros", "shown"),
    [
        (7, "7 us"),
        (1500, "1.5 ms"),
        (1_005_000, "1.005 s"),
        (119 * SECOND, "119 s"),
        (300 * SECOND, "5 min"),
        (18_814_125_000, "5.23 h"),
        (10 * 86_400 * SECOND, "10 d"),
        (4000 * 86_400 * SECOND, "4,000 d"),
    ],
)
def test_lengths_are_spoken_and_set(micros: int, shown: str) -> None:
    assert spoken(micros, TimeKind.TIMESTAMP) == shown
    assert length(setting(micros, TimeKind.TIMESTAMP), TimeKind.TIMESTAMP, "x") == micros
    assert setting(micros, TimeKind.COUNTER) == micros


def test_a_round_length_lies_where_it_must() -> None:
    calendar = TimeKind.TIMESTAMP
    assert roundest(2_030_000, 9_039_000, 5_025_000, calendar) == 5 * SECOND
    assert roundest(61 * SECOND, 3_599 * SECOND, 305 * SECOND, calendar) == 300 * SECOND
    assert roundest(7, 9, 35, TimeKind.COUNTER) == 7
    assert roundest(1, 101, 5, TimeKind.COUNTER) == 5
