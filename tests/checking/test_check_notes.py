"""The notes of the look before calibration, each on a series made for it."""

import datetime as dt
import math
from typing import Any

import numpy as np
import pyarrow as pa
import pytest

import gam_db
from gam_db import Calibration, Parameters, Source
from gam_db.checking import look_at, must_be_fixed, propose
from gam_db.checking.proposal import Proposal, Proposed
from gam_db.engines.duckdb.session import DuckSession
from looks import HALF, SECOND, SHORT, figures, said, table, wave


def test_a_clean_source_has_no_notes() -> None:
    assert said(table(wave(2000))) == {}


def test_rows_that_belong_nowhere_are_counted() -> None:
    values = wave(500)
    rows = table(values, asset=["a"] * 498 + [None] * 2, times=[None] * 3 + list(range(497)))
    notes_of = said(rows)
    assert "3 without time" in notes_of["nameless"].text
    assert "2 without asset" in notes_of["nameless"].text
    assert "channel," not in notes_of["nameless"].text
    assert notes_of["nameless"].must
    found = gam_db.check(Source(rows)).to_pylist()
    assert {(row["asset"], row["readings"], row["without_time"]) for row in found} == {
        ("a", 498, 3),
        (None, 2, 0),
    }


@pytest.mark.parametrize("where", [None, "value > 100"])
def test_a_source_without_usable_rows(where: str | None) -> None:
    rows = table([1.0, 2.0], times=pa.array([None, None], pa.int64()))
    found = said(Source(rows, where=where))
    assert found["nothing"].must
    assert ("condition" in found["nothing"].text) == (where is not None)


def test_one_instant_for_all_rows() -> None:
    found = said(table(wave(300), times=[7] * 300))
    assert found["one_instant"].must
    assert must_be_fixed(list(found.values()))


def test_conflicts_everywhere_are_several_signals_under_one_name() -> None:
    twice = table(np.r_[wave(500), wave(500) + 9], times=np.tile(np.arange(500), 2))
    found = said(twice)
    assert found["conflicts"].must
    assert found["conflicts"].text.startswith("100 % of the instants")
    assert figures(twice)["conflicts"] == 500
    few = table(np.r_[wave(500), [9.0] * 7], times=np.r_[np.arange(500), np.arange(7)])
    assert not said(few)["few_conflicts"].must
    assert said(few)["few_conflicts"].text.startswith("7 instants")


def test_repeated_rows() -> None:
    values = wave(500)
    found = said(table(np.r_[values, values[:9]], times=np.r_[np.arange(500), np.arange(9)]))
    assert set(found) == {"repeated"}
    assert found["repeated"].text.startswith("9 rows repeat")


@pytest.mark.parametrize("unit", ["us", "ns"])
def test_the_hour_that_local_time_repeats(unit: str) -> None:
    start = np.datetime64("2026-10-25T00:00", "us")
    minutes = np.r_[np.arange(180), np.arange(120, 940)] * np.timedelta64(1, "m")
    times = (start + minutes).astype(f"datetime64[{unit}]")
    found = said(table(wave(1000), times=times))
    assert "clocks go back" in found["few_conflicts"].text


def test_pauses_and_the_max_gap_that_tells_them_apart() -> None:
    times = (1_770_000_000 + np.arange(1000)) * SECOND
    times[300:] += 45 * SECOND
    times[600:] += 3_600 * SECOND
    dated = times.astype("datetime64[us]")
    found = said(table(wave(1000), times=dated))
    assert set(found) == {"pauses"}
    assert "2 pauses of 46 s to 60 min" in found["pauses"].text
    assert '--max-gap "5 s"' in found["pauses"].text
    row = figures(table(wave(1000), times=dated))
    assert (row["typical_step"], row["pauses"], row["longest_step"]) == (SECOND, 2, SECOND)
    assert (row["shortest_pause"], row["longest_pause"]) == (46 * SECOND, 3_601 * SECOND)
    assert row["first_time"] == dt.datetime(2026, 2, 2, 2, 40)
    heeded = said(table(wave(1000), times=dated), Parameters(window=25, max_gap="20 s"))
    assert "max_gap sees to it" in heeded["pauses"].text


def test_a_max_gap_below_the_step_leaves_no_vector() -> None:
    found = said(table(wave(500), times=np.arange(500) * 10), Parameters(window=25, max_gap=5))
    assert found["short_gap"].must
    assert "step of 10" in found["short_gap"].text


def test_channels_whose_pauses_no_one_length_tells_apart() -> None:
    fast, slow = np.arange(1000), np.arange(1000) * 50
    fast[500:] += 20
    slow[500:] += 5000
    both = pa.concat_tables(
        [
            table(wave(1000), times=fast, channel=["fast"] * 1000),
            table(wave(1000), times=slow, channel=["slow"] * 1000),
        ]
    )
    with DuckSession() as session:
        proposal = propose(look_at(session, Source(both), SHORT, Calibration()))
    assert proposal.max_gap is None
    assert {name: gap.value for name, gap in proposal.gaps.items()} == {"fast": 5, "slow": 200}
    found = said(both)
    assert "one for each channel" in found["pauses"].text
    assert "1 (1 channel), 50 (1 channel)" in found["rates"].text


def test_data_written_on_change() -> None:
    random = np.random.default_rng(1)
    times = np.cumsum(1 + random.geometric(0.05, 2000))
    values = np.cumsum(random.choice([-1.0, 1.0], 2000))
    found = said(table(values, times=times))
    assert "on_change" in found
    assert "resample" in found["on_change"].text
    assert "pauses" not in found
    with DuckSession() as session:
        assert propose(look_at(session, Source(table(values, times=times)), SHORT, HALF)).max_gap is None
    held = said(table(np.repeat(values[:1000], 2), times=times))
    assert "irregular" in held
    assert "on_change" not in held


def test_bursts_are_regular() -> None:
    times = (np.arange(100)[:, None] * 5000 + np.arange(10)).ravel()
    found = said(table(wave(1000), times=times))
    assert set(found) == {"pauses"}
    assert found["pauses"].text.startswith("99 pauses of 4,991 (usual step 1)")


@pytest.mark.parametrize(
    ("unit", "ticks", "option"),
    [
        ("seconds", 1, "--time-unit s turns"),
        ("milliseconds", 10**3, "--time-unit ms turns"),
        ("microseconds", 10**6, "--time-unit us turns"),
        ("nanoseconds", 10**9, "--time-unit ns turns"),
    ],
)
def test_a_counter_that_counts_from_1970(unit: str, ticks: int, option: str) -> None:
    times = (1_770_000_000 + np.arange(500)) * ticks
    found = said(table(wave(500), times=times))
    assert set(found) == {"epoch"}
    assert f"looks like {unit} since 1970 (from 2026-02-02 02:40:00)" in found["epoch"].text
    assert option in found["epoch"].text


def test_timestamps_in_a_wrong_unit() -> None:
    times = (1_770_000_000_000 + np.arange(500) * 1000).astype("datetime64[us]")
    found = said(table(wave(500), times=times))
    assert set(found) == {"calendar"}
    assert "from 1970-01-21" in found["calendar"].text


def test_values_that_are_missing() -> None:
    values = wave(410)
    values[[5, 6, 90]] = [math.nan, math.inf, 2e300]
    found = said(table(values))
    assert set(found) == {"missing"}
    assert found["missing"].text.startswith("3 samples missing (0.73 %")
    assert figures(table(values))["highest"] < 2


def test_constant_channels() -> None:
    alone = said(table(np.full(500, 4.5)))
    assert alone["constant"].must
    moving = table(wave(500), channel=["y"] * 500)
    beside = said(pa.concat_tables([table(np.full(500, 4.5)), moving]))
    assert not beside["constant"].must
    assert beside["constant"].channels == (("a", "x"),)


def test_a_channel_that_moves_only_after_calibration() -> None:
    found = said(table(np.r_[np.full(300, 4.5), wave(700)]), SHORT, Calibration())
    assert "not assessable" in found["constant_in_calibration"].text
    assert found["still"].text.startswith("the same value without a break for 30 %")
    assert figures(table(np.r_[np.full(300, 4.5), wave(700)]))["longest_still"] == 300


def test_a_channel_without_any_value() -> None:
    nothing = table(pa.array([None] * 300, pa.float64()))
    assert said(nothing)["empty"].must
    beside = pa.concat_tables([nothing, table(wave(300), channel=["y"] * 300)])
    assert not said(beside)["empty"].must


def test_counters_with_and_without_resets() -> None:
    assert said(table(np.arange(600.0)))["counter"].text.startswith("only rises: is it a counter")
    reset = said(table(np.arange(600.0) % 290))["counter"]
    assert reset.text.startswith("only rises, but for 2 falls (resets)")
    assert "counter" not in said(table(wave(600)))


def test_states_and_coarse_resolution() -> None:
    switch = said(table(np.random.default_rng(0).integers(0, 2, 600).astype(float)))
    assert switch["states"].text.startswith("only 2 different values")
    coarse = said(table(np.random.default_rng(0).integers(0, 40, 600) * 0.1))
    assert "(40 levels): --bins 40 loses nothing" in coarse["coarse"].text
    fine = said(
        table(np.random.default_rng(0).integers(0, 40, 600) * 0.1), Parameters(window=25, bins=20)
    )
    assert "coarse" not in fine


def test_text_columns_that_hold_numbers() -> None:
    texts = {"speed": ["1.5"] * 410, "mode": ["1"] * 409 + ["auto"], "empty": [None] * 410}
    found = said(table(wave(410), **{name: pa.array(of, pa.string()) for name, of in texts.items()}))
    assert set(found) == {"number_texts"}
    assert "'speed'" in found["number_texts"].text
    assert "mode" not in found["number_texts"].text


def test_too_few_samples_for_a_window() -> None:
    found = said(table(wave(100)), Parameters(window=81), Calibration())
    assert found["short"].must
    assert "(100 in all, 20 in calibration)" in found["short"].text
    assert "short" not in said(table(wave(100)), Parameters(window=80), Calibration())


def test_channels_that_begin_late_or_end_early() -> None:
    parts = [
        table(wave(1000)[part], times=np.arange(1000)[part], channel=[name] * len(wave(1000)[part]))
        for name, part in (
            ("whole", slice(None)),
            ("late", slice(101, None)),
            ("early", slice(None, 899)),
        )
    ]
    found = said(pa.concat_tables(parts))
    assert found["begins_late"].channels == (("a", "late"),)
    assert "(101 at the earliest)" in found["begins_late"].text
    assert found["ends_early"].channels == (("a", "early"),)
    assert "(898 at the earliest)" in found["ends_early"].text


def test_calibration_that_holds_nothing() -> None:
    nowhere = said(table(wave(500)), SHORT, Calibration(intervals=[(900, 999)]))
    assert nowhere["no_calibration"].must
    pooled = Calibration(intervals=[(900, 999)], pool="channel")
    assert "no_calibration" not in said(table(wave(500)), SHORT, pooled)
    short = said(table(wave(500)), Parameters(window=32))["short_calibration"]
    assert "(250 samples)" in short.text
    assert "short_calibration" not in said(table(wave(500)), Parameters(window=31))


def test_a_window_shorter_than_the_cycle() -> None:
    found = said(table(wave(4000, 40)), Parameters(window=150))
    assert "5 cycles of about 40 samples; use --window 200" in found["short_window"].text
    assert "short_window" not in said(table(wave(4000, 40)), Parameters(window=200))


def test_cycles_that_calibration_does_not_hold_eight_windows_of() -> None:
    found = said(table(wave(4000, 100)), Parameters(window=240))
    assert "short_window" not in found
    text = found["few_cycles"].text
    assert "about 100 samples, and 500 samples are more than an eighth of calibration" in text


def test_the_proposed_window() -> None:
    def proposed(values: Any, parameters: Parameters) -> int | None:
        with DuckSession() as session:
            return propose(look_at(session, Source(table(values)), parameters, Calibration())).window

    assert proposed(wave(4000, 50), Parameters()) == 99  # five cycles are more than an eighth of 798
    assert proposed(wave(16000, 50), Parameters(window=200)) == 300  # five cycles
    assert proposed(np.random.default_rng(0).standard_normal(4000), Parameters()) == 99
    assert proposed(np.random.default_rng(0).standard_normal(4000), Parameters(window=77)) == 77
    assert proposed(np.zeros(4000), Parameters()) == 5000


def proposal_of(source: Any, parameters: Parameters = SHORT) -> Proposal:
    with DuckSession() as session:
        return propose(look_at(session, Source(source), parameters, Calibration(fraction=0.5)))


def stood(*lengths: int, of: int = 1000, channel: str = "x", step: int = 1) -> pa.Table:
    """A wave that stands still so long, again and again from its 100th sample on."""
    values = wave(of)
    for number, length in enumerate(lengths):
        values[100 * (number + 1) : 100 * (number + 1) + length] = 4.5
    times = np.arange(of) * step
    return pa.table({"asset": ["a"] * of, "channel": [channel] * of, "time": times, "value": values})


@pytest.mark.parametrize(
    ("lengths", "proposed"),
    [
        ((24, 24), None),  # none of 25 equal ones
        ((30, 25), 25),  # 7 of 500
        ((74,), None),  # just a tenth
        ((73,), 25),
        ((10, 10, 10, 10, 0, 0, 60), None),  # after calibration
    ],
)
def test_what_stood_still_for_a_short_part_of_calibration_is_proposed(
    lengths: tuple[int, ...], proposed: int | None
) -> None:
    found = proposal_of(stood(*lengths)).still
    assert (None if found is None else found.value) == proposed


def test_the_figures_of_what_stood_still() -> None:
    row = figures(stood(30, 25), calibration=Calibration(fraction=0.5))
    told = ("still_after", "calibration_still", "still_runs", "longest_run")
    assert tuple(row[name] for name in told) == (25, 7, 2, 30)
    assert proposal_of(stood(30, 25)).still == Proposed(
        25, "1.4 % of calibration at most stood still, in 2 runs of at most 30 samples"
    )


def test_samples_in_five_seconds_where_these_are_more() -> None:
    source = stood(60, 30)
    times = pa.array(np.arange(1000) * 100_000, pa.timestamp("us"))
    found = proposal_of(source.set_column(2, "time", times)).still
    assert found is not None
    assert found.value == 50  # at 10 Hz


def test_a_still_after_that_not_all_channels_can_take() -> None:
    source = pa.concat_tables([stood(30, 30), stood(90, 90, 90, channel="y")])
    found = proposal_of(source)
    assert found.still is None
    assert {name: one.value for name, one in found.stills.items()} == {"x": 25}


def test_a_still_after_that_takes_much_of_calibration_is_obeyed_and_said() -> None:
    note = said(stood(90, 90, 90), Parameters(bins=4, window=20, still_after=25))["still_after"]
    assert not note.must
    assert "leaves out 40 % of calibration, in 3 runs of at most 90 samples" in note.text
    assert "still_after" not in said(stood(90, 90, 90))
    assert "still_after" not in said(stood(30, 30), Parameters(bins=4, window=20, still_after=25))


@pytest.mark.parametrize(
    ("cycle", "window", "reason"),
    [
        (50, 50, "1.0 cycles of about 50 samples"),  # 5 cycles are more than a sixteenth of 800
        (200, 50, "0.2 cycles of about 200 samples; calibration has 4 of at least 8 cycles"),
        (None, 40, "a twentieth of the calibration, 800 samples"),
    ],
)
def test_a_window_that_is_left_open(cycle: int | None, window: int, reason: str) -> None:
    """Both sides, section 4: the least of five cycles (or a fortieth) and a sixteenth of calibration."""
    values = np.random.default_rng(0).standard_normal(4000) if cycle is None else wave(4000, cycle)
    with DuckSession() as session:
        look = look_at(session, Source(table(values)), Parameters(window="auto"), Calibration())
    found = propose(look)
    assert (found.window, found.window_reason) == (window, reason)
