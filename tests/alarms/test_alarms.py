"""Judgements, limits and episodes: by hand, and against a reference in plain loops."""

import datetime as dt
import math
import random
from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import alarms_reference as plain
import comparisons
import engines
import gam_db
import harness
from gam_db.alarms.heights import Rate, by_replay, by_table
from gam_db.errors import ParameterError

RUNS = engines.VERSIONS

W = 4
"""Vectors of a window here; a count is from 0 to 4."""

ROOTS = [612, 1172, 1541, 1837, 2091]
"""floor(sqrt(1000000 k + 375000)) of these counts."""

LIMIT = {"asset": "a", "channel": "x", "reason": None, "blocks": 8}


def table(rows: list[harness.Row]) -> pa.Table:
    names = ("asset", "channel", "time", "value")
    return pa.table({name: [row[i] for row in rows] for i, name in enumerate(names)})


def windows(counts: list[int], asset: str = "a", channel: str = "x") -> list[harness.Row]:
    """Return a source of 8 calm windows and then windows of so many novel vectors, out of range."""
    calm = [0.0, 1.0, 1.0, 0.0] * 8
    values = calm + [9.0 if i < count else 1.0 for count in counts for i in range(W)]
    return [(asset, channel, time, value) for time, value in enumerate(values)]


def asked(
    rows: list[harness.Row], per_thousand: float = 1.0, **changes: Any
) -> tuple[gam_db.Source, gam_db.Parameters, gam_db.Calibration, gam_db.Alarms]:
    parameters = gam_db.Parameters(**{"m": 1, "bins": 2, "window": W, "stride": 2, **changes})
    calibration = gam_db.Calibration(intervals=[(0, 8 * W - 1)])
    alarms = gam_db.Alarms(rate=f"{per_thousand} per 1000 judgements")
    return (
        gam_db.Source(table(rows), "asset", "channel", "time", "value"),
        parameters,
        calibration,
        alarms,
    )


def test_the_limit_of_a_channel_whose_blocks_are_all_0() -> None:
    """Section 2: centre is the root of 0, spread half a root, and the table gives h = 5 at 8 blocks."""
    (limit,) = gam_db.limits(*asked(windows([0]))).to_pylist()
    expected = {"blocks": 8, "centre": 612, "spread": 500, "reference": 1112, "basis": "table"}
    expected |= {
        "quarters": 20,
        "height": 2500,
        "cap": 1250,
        "g": 1,
        "order_ratio": None,
        "reason": None,
    }
    assert {name: limit[name] for name in expected} == expected


@pytest.mark.parametrize(
    ("counts", "evidence", "is_open", "episodes"),
    [
        # A full window adds 2091 - 1112 = 979: three of them reach 2500.
        ([4, 4, 4, 0], [979, 1958, 2937, 2437], [0, 0, 1, 1], [(0, 2, 3)]),
        # A count of 1 adds 60, 0 takes 500 away but never below 0; evidence begins anew after a 0.
        ([1, 0, 4, 4, 4], [60, 0, 979, 1958, 2937], [0, 0, 0, 0, 1], [(2, 4, 4)]),
        # Three windows in a row that are not raised close it; two do not.
        (
            [4, 4, 4, 0, 0, 4, 0, 0, 0],
            [979, 1958, 2937, 2437, 1937, 2916, 2416, 1916, 1416],
            [0, 0, 1, 1, 1, 1, 1, 1, 0],
            [(0, 2, 7)],
        ),
        # Runs with 9 judgements between them are one episode; with 10 they are two.
        (
            [4, 4, 4] + [0] * 11 + [4, 4, 4],
            [979, 1958, 2937, 2437, 1937, 1437, 937, 437] + [0] * 6 + [979, 1958, 2937],
            [0, 0, 1, 1, 1] + [0] * 11 + [1],
            [(0, 2, 4), (14, 16, 16)],
        ),
        # What was left of evidence when an episode ended belongs to that one: the next begins after it.
        (
            [4, 4, 4, 0, 0, 0] + [1] * 11 + [4],
            [979, 1958, 2937, 2437, 1937, 1437, *range(1497, 2098, 60), 3076],
            [0, 0, 1, 1, 1, 0] + [0] * 11 + [1],
            [(0, 2, 4), (5, 17, 17)],
        ),
        # Only the sums of the last 50 judgements, and the one before them, are looked back at.
        ([1] * 52, [60 * j for j in range(1, 51)] + [3000, 3000], [0] * 41 + [1] * 11, [(0, 41, 51)]),
        (
            [4, 4, 4] + [0] * 9 + [4, 4, 4],
            [979, 1958, 2937, 2437, 1937, 1437, 937, 437] + [0] * 4 + [979, 1958, 2937],
            [0, 0, 1, 1, 1] + [0] * 9 + [1],
            [(0, 2, 14)],
        ),
    ],
)
def test_evidence_and_episodes_by_hand(
    counts: list[int], evidence: list[int], is_open: list[int], episodes: list[tuple[int, int, int]]
) -> None:
    said = gam_db.judgements(*asked(windows(counts))).to_pydict()
    assert said["novel"] == counts
    assert said["root"] == [ROOTS[count] for count in counts]
    assert said["evidence"] == evidence
    assert said["is_open"] == is_open
    found = gam_db.episodes(*asked(windows(counts))).to_pylist()
    told = [(row["onset"], row["first_judgement"], row["last_judgement"]) for row in found]
    assert told == episodes
    by_loops = plain.judged([ROOTS[count] for count in counts], 1112, 2500, 1250)
    assert [row["evidence"] for row in by_loops] == evidence
    assert [row["is_open"] for row in by_loops] == is_open


def test_times_of_an_episode_and_what_it_is() -> None:
    (row,) = gam_db.episodes(*asked(windows([0, 4, 4, 4]))).to_pylist()
    assert (row["onset_time"], row["first_time"], row["last_time"]) == (36, 44, 47)
    assert (row["is_open"], row["is_proving"]) == (1, 1)
    later = gam_db.episodes(*asked(windows([0] * 6 + [4, 4, 4] + [0] * 20))).to_pylist()
    assert [(row["first_judgement"], row["is_open"], row["is_proving"]) for row in later] == [(8, 0, 0)]


@pytest.mark.parametrize(("of_b", "centre"), [(5.0, 612), (6.0, 682)])
def test_a_cell_that_another_member_of_the_pool_visited_is_not_counted(of_b: float, centre: int) -> None:
    """Section 2: the last block of a lies beside the first of b. One root of 1172 adds 560 div 8."""
    rows: list[harness.Row]
    rows = [(asset, "x", time, float(time % 2)) for asset in "ab" for time in range(8 * W)]
    rows = [("a", "x", 8 * W - 2, 5.0) if row[0] == "a" and row[2] == 8 * W - 2 else row for row in rows]
    rows = [("b", "x", 2, of_b) if row[0] == "b" and row[2] == 2 else row for row in rows]
    source, parameters, _, alarms = asked(rows, bins=8, range="min_max")
    calibration = gam_db.Calibration(intervals=[(0, 8 * W - 1)], pool="channel")
    limits = gam_db.limits(source, parameters, calibration, alarms).to_pylist()
    assert [row["centre"] for row in limits] == [centre, centre]


def test_no_single_judgement_opens_an_episode() -> None:
    """Section 4: a window of 400 novel vectors adds half a height at most."""
    calm = [(str(i % 2), i) for i in range(3200)]
    rows: list[harness.Row] = [("a", "x", i, float(value)) for value, i in calm]
    rows += [("a", "x", 3200 + i, 9.0) for i in range(800)]
    source = gam_db.Source(table(rows), "asset", "channel", "time", "value")
    parameters = gam_db.Parameters(m=1, bins=2, window=400)
    calibration = gam_db.Calibration(intervals=[(0, 3199)])
    said = gam_db.judgements(
        source, parameters, calibration, gam_db.Alarms(rate="1 per 1000 judgements")
    ).to_pylist()
    assert [(row["root"], row["evidence"], row["is_open"]) for row in said] == [
        (20009, 1250, 0),
        (20009, 2500, 1),
    ]


def test_the_indicator_opens_episodes_where_judgements_have_no_limit() -> None:
    """Section 4: of 6 windows of calibration; one novel vector raises a window, as 0.05 W < 1."""
    counts = [0, 3, 0, 2, 0, 0, 0] + [0] * 10 + [1]
    source, parameters, _, alarms = asked(windows(counts))
    said = source, parameters, gam_db.Calibration(intervals=[(0, 6 * W - 1)]), alarms
    (limit,) = gam_db.limits(*said).to_pylist()
    expected = {"reason": "calibration shorter than 8 windows", "basis": "indicator", "height": 1}
    expected |= {"reference": ROOTS[0], "stated_rate": None, "centre": None}
    assert {name: limit[name] for name in expected} == expected
    found = gam_db.episodes(*said).to_pylist()
    names = ("onset", "first_judgement", "last_judgement", "is_open", "is_proving", "height")
    # Two calm windows come before the counts; each episode begins with its first raised window.
    assert [tuple(row[name] for name in names) for row in found] == [
        (3, 3, 7, 0, 0, 1),
        (19, 19, 19, 1, 0, 1),
    ]


def test_an_unfinished_window_is_no_judgement() -> None:
    rows = windows([1, 2])
    assert gam_db.judgements(*asked(rows[:-1])).num_rows == 1
    assert gam_db.judgements(*asked(rows[: 8 * W])).num_rows == 0


def test_channels_without_a_limit_say_why() -> None:
    short = [("b", "x", time, float(time % 2)) for time in range(7 * W + 3)]
    constant = [("c", "x", time, 1.0) for time in range(9 * W)]
    rows = [*windows([4, 4, 4]), *short, *constant]
    found = {row["asset"]: row for row in gam_db.limits(*asked(rows)).to_pylist()}
    assert found["a"]["reason"] is None
    assert found["b"]["reason"] == "calibration shorter than 8 windows"
    assert found["c"]["reason"] == "constant in calibration"
    assert found["c"]["height"] is found["b"]["rate"] is None
    assert (found["b"]["basis"], found["c"]["basis"]) == ("indicator", None)
    assert {row["asset"] for row in gam_db.judgements(*asked(rows)).to_pylist()} == {"a"}


@pytest.mark.parametrize(
    ("rate", "blocks", "quarters"),
    [
        (1 / 1000, 8, 20),
        (1 / 1000, 10, 18),
        (1 / 1000, 100, 10),
        (1 / 300, 9, 6),
        (0.5, 9, 6),
        (1 / 5000, 12, 32),
        (1e-9, 12, 32),
        (1 / 2000, 8, 34),  # 5 + 8 ln 2 / ln 5 = 8.45
    ],
)
def test_heights_by_the_table(rate: float, blocks: int, quarters: int) -> None:
    assert by_table(rate, blocks).quarters == quarters == plain.table_height(rate, blocks)


def test_heights_by_replay() -> None:
    steep = {4: 40, 5: 20, 6: 10, 7: 5}
    assert by_replay(0.011, 1000, steep).quarters == 6  # 10 x 10 + 7 <= 110
    assert by_replay(0.0107, 1000, steep).quarters == 6
    assert by_replay(0.0106, 1000, steep).quarters == 7
    assert by_replay(0.0007, 1000, steep) == by_replay(0.0008, 1000, steep)
    carried = by_replay(0.0001, 1000, steep)  # halved by each quarter: 0.1 of 40 is log2(400) = 8.64 on
    assert (carried.quarters, carried.basis) == (4 + 9, "extrapolated")
    assert by_replay(1e-9, 1000, steep) == carried, "no rate leaves a channel unwatched"
    assert by_replay(0.0001, 1000, {4: 3, 5: 2}).basis == "none"
    assert by_replay(0.0001, 1000, dict.fromkeys(range(4, 81), 7)).basis == "none"


@pytest.mark.parametrize(
    "rate",
    [
        "",
        "often",
        "0 per month",
        "-1 per day",
        "1 per fortnight",
        "1 per 1000 judgements per channel",
        3,
    ],
)
def test_a_rate_that_is_none_is_refused(rate: Any) -> None:
    with pytest.raises(ParameterError, match="rate is"):
        gam_db.Alarms(rate=rate)


def test_rates_of_all_and_of_each() -> None:
    assert Rate.of("3 per month").per_judgement(2.0, 10.0) == 3 / 30 / 10
    assert Rate.of("3 per year per channel").per_judgement(2.0, 10.0) == 3 / 365 / 2
    assert Rate.of("0.5 per 1000 judgements").per_judgement(None, 0.0) == 0.0005


def dated(
    intervals: list[tuple[dt.datetime, dt.datetime]], rate: str
) -> tuple[gam_db.Source, gam_db.Parameters, gam_db.Calibration, gam_db.Alarms]:
    """Two channels of a reading a second, the second one twice as far apart."""
    rows = windows([0])
    times = [[BEGIN + dt.timedelta(seconds=step * time) for *_, time, _ in rows] for step in (1, 2)]
    data = pa.table(
        {
            "asset": ["a"] * len(rows) + ["b"] * len(rows),
            "time": pa.array(times[0] + times[1], pa.timestamp("us")),
            "value": [value for *_, value in rows] * 2,
        }
    )
    parameters = gam_db.Parameters(m=1, bins=2, window=W, stride=2)
    source = gam_db.Source(data, "asset", None)
    return source, parameters, gam_db.Calibration(intervals=intervals), gam_db.Alarms(rate=rate)


BEGIN = dt.datetime(2026, 1, 1)


def test_judgements_per_day_and_the_rate_of_each() -> None:
    """Section 3: vectors x a day / (W x length of calibration); the rate is that of all, or of each."""
    whole = [(BEGIN, BEGIN + dt.timedelta(seconds=62))]
    limits = gam_db.limits(*dated(whole, "3 per day")).to_pylist()
    # Of a, all 36 samples lie within the interval; of b the first 32.
    per_day = [36 * 86400 / (W * 62), 32 * 86400 / (W * 62)]
    assert [row["judgements_per_day"] for row in limits] == per_day
    assert [row["rate"] for row in limits] == [3 / math.fsum(per_day)] * 2
    assert [row["stated_rate"] for row in limits] == [0.0005] * 2
    each = gam_db.limits(*dated(whole, "60 per month per channel")).to_pylist()
    assert [row["rate"] for row in each] == [2 / per_day[0], 2 / per_day[1]]


def test_a_calibration_of_instants_lasts_from_the_first_to_the_last_sample() -> None:
    instants = [(at, at) for at in (BEGIN + dt.timedelta(seconds=2 * n) for n in range(32))]
    found = gam_db.limits(*dated(instants, "3 per day")).to_pylist()
    assert found[0]["reason"] == "calibration shorter than 8 windows"  # every second one of a
    assert found[1]["judgements_per_day"] == 32 * 86400 / (W * 62)


def test_a_counter_has_no_days() -> None:
    source, parameters, calibration, _ = asked(windows([0]))
    with pytest.raises(ParameterError, match="counts time in integers; give the rate per judgements"):
        gam_db.limits(source, parameters, calibration, gam_db.Alarms("1 per month"))
    (limit,) = gam_db.limits(source, parameters, calibration).to_pylist()
    assert limit["rate"] == 0.0005, "what is asked where nothing is said"


def fleet(chance: random.Random, length: int) -> list[harness.Row]:
    """Channels of few levels that now and then visit a rare one; some drift, some fail later on."""
    rows: list[harness.Row] = []
    usual, drifts = chance.choice([0.0, 0.1, 0.3, 0.3]), chance.choice([0, 0, 0, 1])
    for number in range(chance.choice([3, 9, 9])):
        rare, drift = chance.choice([usual] * 8 + [0.02]), chance.choice([drifts] * 8 + [1 - drifts])
        fault = chance.choice([length, 3 * length // 4])
        for time in range(length - chance.choice([0] * 8 + [3, 150])):
            value = chance.choice([0.0, 1.0, 2.0]) + (drift * time * 6) // length
            if chance.random() < (0.7 if time >= fault else rare):
                value = float(chance.randint(3, 40))
            rows.append((f"a{number}", "x" if number % 3 else "y", time, value))
    return rows


@st.composite
def fleets(draw: st.DrawFn) -> tuple[list[harness.Row], dict[str, Any], dict[str, Any], list[str]]:
    chance = random.Random(draw(st.integers(0, 2**32 - 1)))
    rows = fleet(chance, draw(st.sampled_from([60, 300, 420, 420])))
    window = draw(st.sampled_from([2, 4]))
    parameters: dict[str, Any] = {"m": draw(st.sampled_from([1, 2])), "tau": 1, "bins": 40}
    parameters |= {"window": window, "stride": draw(st.sampled_from([1, window]))}
    parameters |= {"max_gap": None, "target_floor": 0.9, "overrides": []}
    if draw(st.booleans()):
        parameters["overrides"] = [{"asset": "a2", "channel": "*", "window": 2, "stride": 1}]
    calibration: dict[str, Any] = {"fraction": draw(st.sampled_from([0.4, 0.7])), "pool": None}
    if draw(st.booleans()):
        calibration["pool"] = draw(st.sampled_from(["channel", [["a1", "a2"]]]))
    return rows, parameters, calibration, draw(st.sampled_from([[], [], ["y"], ["x", "*"]]))


def test_limits_judgements_and_episodes_equal_the_reference(engine: str) -> None:
    @settings(max_examples=max(engines.examples(engine) // 4, 2))
    @given(case=fleets(), per_thousand=st.sampled_from([0.2, 1.0, 5.0, 30.0]))
    def agrees(case: Any, per_thousand: float) -> None:
        rows, parameters, calibration, family = case
        method = harness.made(parameters, calibration)
        limits = plain.limits(rows, *method, per_thousand, family)
        judgements, episodes = plain.judgements(rows, *method, limits)
        alarms = gam_db.Alarms(rate=f"{per_thousand} per 1000 judgements", family=family)
        session = engines.session(engine)
        with session.lent(harness.arrow(rows)) as lent:
            said = (gam_db.Source(lent.name), *method, alarms, session)
            compare(limits, gam_db.limits(*said).to_pylist())
            compare(judgements, gam_db.judgements(*said).to_pylist())
            compare(episodes, gam_db.episodes(*said).to_pylist())
        comparisons.compared(engine, "exact", rows, *method)

    agrees()


def compare(expected: list[dict[str, Any]], found: list[dict[str, Any]]) -> None:
    assert len(found) == len(expected)
    for ours, theirs in zip(found, expected, strict=True):
        theirs = {name: value for name, value in theirs.items() if name != "key"}
        assert {name: ours[name] for name in theirs} == theirs
