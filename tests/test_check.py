"""The look before calibration: its figures against NumPy, its notes on series made for each of them."""

import datetime as dt
import math
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given, settings

import gam_db
import harness
import look_reference
from gam_db import Calibration, Parameters, Source, WideSource
from gam_db.checking import Note, look_at, must_be_fixed, notes, propose
from gam_db.checking.words import roundest, setting, spoken
from gam_db.clock import TimeKind, length
from gam_db.engines.duckdb_session import Session
from gam_db.errors import SourceError
from strategies import Case, cases

SHORT = Parameters(window=25)
HALF = Calibration(0.5)
SECOND = 1_000_000
_OF_CALIBRATION = ("calibration_samples", "calibration_lowest", "calibration_highest")
_TIMES = ("first_time", "last_time")


def table(values: Any, times: Any = None, **more: Any) -> pa.Table:
    """A long table of one channel."""
    times = np.arange(len(values)) if times is None else times
    columns = {"time": times, "value": pa.array(values, from_pandas=True), **more}
    columns = {"asset": ["a"] * len(values), "channel": ["x"] * len(values)} | columns
    return pa.table(columns)


def said(
    source: Any, parameters: Parameters = SHORT, calibration: Calibration = HALF
) -> dict[str, Note]:
    """The notes on a source, by subject."""
    source = source if isinstance(source, (Source, WideSource)) else Source(source)
    with Session() as session:
        look = look_at(session, source, parameters, calibration)
    found = notes(look, propose(look))
    assert len({note.subject for note in found}) == len(found)
    for note in found:
        assert "\n" not in note.text
        assert 20 < len(note.text) < 500
    return {note.subject: note for note in found}


def figures(source: Any, **asked: Any) -> dict[str, Any]:
    """The figures of the only channel of a source."""
    source = source if isinstance(source, (Source, WideSource)) else Source(source)
    (row,) = gam_db.check(source, **asked).to_pylist()
    return row  # type: ignore[no-any-return]


def wave(length: int, period: int = 5) -> Any:
    """A cycle that never repeats a value exactly, nor stands still, and has no finest step."""
    t = np.arange(length)
    return np.sin(t * 2 * math.pi / period) + 1e-3 * np.sin(t * 0.7) + 1e-4 * np.cos(t * 0.11)


# Figures


@settings(max_examples=settings().max_examples // 4)
@given(cases())
def test_figures_are_those_of_numpy(case: Case) -> None:
    """The calibration's samples are compared with those that the method counts."""
    rows, parameters, calibration = case
    made = harness.made(parameters, calibration)
    found = gam_db.check(Source(harness.arrow(rows)), *made)
    assert found["first_time"].equals(found["first_tick"])
    assert found["last_time"].equals(found["last_tick"])
    plain = found.drop_columns([*_OF_CALIBRATION, *_TIMES]).to_pylist()
    harness.assert_same(look_reference.figures(rows), plain)

    if not made[1].pools:  # a pool's range is that of all members
        learnt = harness.by_reference("support", rows, *made)
        for left, right in zip(learnt, found.to_pylist(), strict=True):
            assert left["calibration_samples"] == right["calibration_samples"]
            assert (left["lo"], left["hi"]) == tuple(right[name] for name in _OF_CALIBRATION[1:])


@pytest.mark.parametrize("period", [4, 7, 25, 300, 1000])
def test_long_series_agree_too(period: int) -> None:
    values = wave(9001, period)
    values[4000:4100] = np.nan
    rows: list[Any] = [("a", "x", 3 * t, v) for t, v in enumerate(values.tolist())]
    found = gam_db.check(Source(harness.arrow(rows)))
    plain = found.drop_columns([*_OF_CALIBRATION, *_TIMES]).to_pylist()
    expected = look_reference.figures(rows)
    harness.assert_same(expected, plain)
    assert expected[0]["cycle_length"] is not None
    assert abs(expected[0]["cycle_length"] - period) <= max(0.03 * period, 0.5)


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


# Notes, one by one


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
    times = np.arange(1000) * SECOND
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
    assert row["first_time"] == dt.datetime(1970, 1, 1)
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
    with Session() as session:
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
    held = said(table(np.repeat(values[:1000], 2), times=times))
    assert "irregular" in held
    assert "on_change" not in held


def test_bursts_are_regular() -> None:
    times = (np.arange(100)[:, None] * 5000 + np.arange(10)).ravel()
    found = said(table(wave(1000), times=times))
    assert set(found) == {"pauses"}
    assert found["pauses"].text.startswith("99 pauses of 4,991 (usual step 1)")


@pytest.mark.parametrize(
    ("unit", "ticks", "maker"),
    [
        ("seconds", 1, 'make_timestamp("time" * 1000000)'),
        ("milliseconds", 10**3, 'make_timestamp("time" * 1000)'),
        ("microseconds", 10**6, 'make_timestamp("time")'),
        ("nanoseconds", 10**9, 'make_timestamp_ns("time")'),
    ],
)
def test_a_counter_that_counts_from_1970(unit: str, ticks: int, maker: str) -> None:
    times = (1_770_000_000 + np.arange(500)) * ticks
    found = said(table(wave(500), times=times))
    assert set(found) == {"epoch"}
    assert f"looks like {unit} since 1970 (from 2026-02-02 02:40:00)" in found["epoch"].text
    assert maker in found["epoch"].text


def test_timestamps_in_a_wrong_unit() -> None:
    times = (1_770_000_000_000 + np.arange(500) * 1000).astype("datetime64[us]")
    found = said(table(wave(500), times=times))
    assert set(found) == {"calendar"}
    assert "from 1970-01-21" in found["calendar"].text


def test_values_that_are_missing() -> None:
    values = wave(400)
    values[[5, 6, 90]] = [math.nan, math.inf, 2e300]
    found = said(table(values))
    assert set(found) == {"missing"}
    assert found["missing"].text.startswith("3 samples missing (0.75 %")
    assert figures(table(values))["highest"] < 2


def test_constant_channels() -> None:
    alone = said(table(np.full(500, 4.5)))
    assert alone["constant"].must
    moving = table(wave(500), channel=["y"] * 500)
    beside = said(pa.concat_tables([table(np.full(500, 4.5)), moving]))
    assert not beside["constant"].must
    assert beside["constant"].channels == (("a", "x"),)


def test_a_channel_that_moves_only_after_calibration() -> None:
    found = said(table(np.r_[np.full(300, 4.5), wave(700)]))
    assert "not assessable" in found["constant_in_calibration"].text
    assert found["still"].text.startswith("one and the same value for 30 %")
    assert figures(table(np.r_[np.full(300, 4.5), wave(700)]))["longest_still"] == 300


def test_a_channel_without_any_value() -> None:
    nothing = table(pa.array([None] * 300, pa.float64()))
    assert said(nothing)["empty"].must
    beside = pa.concat_tables([nothing, table(wave(300), channel=["y"] * 300)])
    assert not said(beside)["empty"].must


def test_counters_with_and_without_resets() -> None:
    assert said(table(np.arange(600.0)))["counter"].text.startswith("only ever rises: a counter")
    reset = said(table(np.arange(600.0) % 290))["counter"]
    assert reset.text.startswith("only ever rises, but for 2 falls (resets)")
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
    texts = {"speed": ["1.5"] * 400, "mode": ["1"] * 399 + ["auto"], "empty": [None] * 400}
    found = said(table(wave(400), **{name: pa.array(of, pa.string()) for name, of in texts.items()}))
    assert set(found) == {"number_texts"}
    assert "'speed'" in found["number_texts"].text
    assert "mode" not in found["number_texts"].text


def test_too_few_samples_for_a_window() -> None:
    found = said(table(wave(100)), Parameters(window=81), Calibration())
    assert found["short"].must
    assert "(100 in all, 20 of calibration)" in found["short"].text
    assert "short" not in said(table(wave(100)), Parameters(window=80), Calibration())


def test_calibration_that_holds_nothing() -> None:
    nowhere = said(table(wave(500)), SHORT, Calibration(intervals=[(900, 999)]))
    assert nowhere["no_calibration"].must
    pooled = Calibration(intervals=[(900, 999)], pool="channel")
    assert "no_calibration" not in said(table(wave(500)), SHORT, pooled)
    short = said(table(wave(500)), Parameters(window=32))["short_calibration"]
    assert "(250 samples)" in short.text
    assert "short_calibration" not in said(table(wave(500)), Parameters(window=31))


def test_a_window_shorter_than_the_cycle() -> None:
    found = said(table(wave(4000, 100)), Parameters(window=400))
    assert "5 cycles of about 100 samples; take --window 500" in found["short_window"].text
    assert "short_window" not in said(table(wave(4000, 100)), Parameters(window=500))


def test_the_proposed_window() -> None:
    def proposed(values: Any, parameters: Parameters) -> int:
        with Session() as session:
            return propose(look_at(session, Source(table(values)), parameters, Calibration())).window

    assert proposed(wave(4000, 50), Parameters()) == 300  # five cycles, and more than an eighth of 800
    assert proposed(np.random.default_rng(0).standard_normal(4000), Parameters()) == 100
    assert proposed(np.random.default_rng(0).standard_normal(4000), Parameters(window=77)) == 77
    assert proposed(np.zeros(4000), Parameters()) == 5000


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
    assert "us since 1970" in said(table([1.0, 2.0, 3.0], times=times))["calendar"].text


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
