"""Calibration rules and their arithmetic on closed intervals of integers."""

import datetime as dt
import itertools

import pytest

from gam_db.clock import FAR_AHEAD, LONG_AGO, TimeKind
from gam_db.errors import CalibrationError
from gam_db.settings.calibration import Calibration, Rule, merge, resolve, subtract

ALWAYS = ((LONG_AGO, FAR_AHEAD),)
HOUR = 3_600 * 10**6


@pytest.mark.parametrize(
    ("intervals", "joined"),
    [
        ([], []),
        ([(5, 7), (1, 2)], [(1, 2), (5, 7)]),
        ([(1, 3), (2, 5)], [(1, 5)]),
        ([(1, 3), (4, 5)], [(1, 5)]),  # neighbours: no integer lies between
        ([(1, 3), (5, 6)], [(1, 3), (5, 6)]),
        ([(1, 9), (2, 3)], [(1, 9)]),  # the later one ends first
        ([(4, 4), (4, 4)], [(4, 4)]),
    ],
)
def test_merge(intervals: list[tuple[int, int]], joined: list[tuple[int, int]]) -> None:
    assert merge(intervals) == joined


@pytest.mark.parametrize(
    ("excluded", "left"),
    [
        ([], [(1, 9)]),
        ([(1, 9)], []),
        ([(0, 10)], []),
        ([(4, 5)], [(1, 3), (6, 9)]),
        ([(1, 1)], [(2, 9)]),
        ([(9, 9)], [(1, 8)]),
        ([(10, 12)], [(1, 9)]),
        ([(3, 3), (2, 4), (7, 20)], [(1, 1), (5, 6)]),
    ],
)
def test_subtract(excluded: list[tuple[int, int]], left: list[tuple[int, int]]) -> None:
    assert subtract([(1, 9)], excluded) == left


def test_merge_and_subtract_mean_sets_of_integers() -> None:
    """Every pair of intervals within 1..4 and every two cuts: the same integers as Python's sets."""
    pieces = [(start, end) for start in range(1, 5) for end in range(start, 5)]

    def members(intervals: list[tuple[int, int]]) -> set[int]:
        return {number for start, end in intervals for number in range(start, end + 1)}

    for first, second, cut in itertools.product(pieces, repeat=3):
        joined = merge([first, second])
        assert members(joined) == members([first, second])
        assert all(a[1] + 1 < b[0] for a, b in itertools.pairwise(joined))
        left = subtract(joined, [cut])
        assert members(left) == members(joined) - members([cut])
        assert sum(end - start + 1 for start, end in left) == len(members(left))  # disjoint


def test_default_is_a_fifth() -> None:
    assert resolve(Calibration(), TimeKind.COUNTER) == [Rule(fraction=0.2, allowed=ALWAYS)]


def test_fraction_and_duration_allow_all_but_the_exclusions() -> None:
    allowed = ((LONG_AGO, 9), (13, FAR_AHEAD))
    by_fraction = Calibration(fraction=1, exclude=[(10, 12)])
    assert resolve(by_fraction, TimeKind.COUNTER) == [Rule(fraction=1.0, allowed=allowed)]
    by_duration = Calibration(duration=30, exclude=[(10, 12)], score_from=20)
    assert resolve(by_duration, TimeKind.COUNTER) == [Rule(duration=30, score_from=20, allowed=allowed)]


def test_the_end_of_intervals_stays_where_an_exclusion_covers_it() -> None:
    rule = Calibration(intervals=[(20, 30), (1, 5)], exclude=[(4, 22), (28, 40)])
    assert resolve(rule, TimeKind.COUNTER) == [
        Rule(declared_end=30, allowed=((1, 3), (23, 27))),
    ]


def test_no_interval_means_no_calibration_of_its_own() -> None:
    assert resolve(Calibration(intervals=[]), TimeKind.COUNTER) == [Rule()]


def test_calendar() -> None:
    rule = Calibration(
        intervals=[("1970-01-01T01:00:00+01:00", dt.datetime(1970, 1, 1, 2))], score_from="1970-01-02"
    )
    assert resolve(rule, TimeKind.TIMESTAMP) == [
        Rule(declared_end=2 * HOUR, score_from=24 * HOUR, allowed=((0, 2 * HOUR),))
    ]
    assert resolve(Calibration(duration="2 h"), TimeKind.TIMESTAMP_WITH_ZONE)[0].duration == 2 * HOUR
    assert resolve(Calibration(duration=2), TimeKind.NANOSECONDS)[0].duration == 2 * 10**6


def test_overrides_follow_the_general_rule_in_order() -> None:
    rule = Calibration(0.5, overrides={"b*": Calibration(duration=3), "a": None})
    found = resolve(rule, TimeKind.COUNTER)
    assert [r.fraction for r in found] == [0.5, None, None]
    assert [r.duration for r in found] == [None, 3, None]
    assert found[2] == Rule()


def test_pools() -> None:
    assert Calibration().pools == ()
    assert Calibration(pool="channel").pools == (("*",),)
    assert Calibration(pool=["a*", ["b", "c?"]]).pools == (("a*",), ("b", "c?"))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"fraction": 0.5, "duration": 3}, "one of fraction, duration, intervals"),
        ({"fraction": 0}, "above 0 and at most 1"),
        ({"fraction": 1.001}, "above 0 and at most 1"),
        ({"fraction": float("nan")}, "above 0 and at most 1"),
        ({"fraction": "0.5"}, "above 0 and at most 1"),
        ({"fraction": True}, "above 0 and at most 1"),
        ({"intervals": 5}, "intervals is 5; it takes a list of pairs"),
        ({"intervals": (1, 2)}, "intervals takes pairs"),
        ({"intervals": ["12"]}, "intervals takes pairs"),
        ({"intervals": [(1, 2, 3)]}, "intervals takes pairs"),
        ({"exclude": None}, "exclude is None; it takes a list of pairs"),
        ({"overrides": ["a"]}, "overrides is a list; it takes a mapping"),
        ({"overrides": {5: None}}, "asset patterns, as text"),
        ({"overrides": {"a": 0.5}}, "calibration of 'a' must be a gam_db.Calibration or None"),
        ({"overrides": {"a": Calibration(pool="channel")}}, "only the general calibration may"),
        ({"pool": "asset"}, "pool is 'asset'; it takes 'channel' or groups"),
        ({"pool": 5}, "pool is 5; it takes 'channel' or groups"),
        ({"pool": [["a", 5]]}, "it takes 'channel' or groups"),
    ],
)
def test_contradictions_are_refused_at_once(arguments: dict[str, object], message: str) -> None:
    with pytest.raises(CalibrationError, match=message):
        Calibration(**arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("arguments", "kind", "message"),
    [
        ({"intervals": [(1, 2), (9, 8)]}, TimeKind.COUNTER, r"intervals 2 ends \(8\) before it begins"),
        ({"exclude": [(9, 8)]}, TimeKind.COUNTER, r"exclude 1 ends \(8\) before it begins \(9\)"),
        ({"intervals": [("2026-01-01", "2026-01-02")]}, TimeKind.COUNTER, "counts time in integers"),
        ({"intervals": [(1, 2)]}, TimeKind.TIMESTAMP, "the time of the source is a timestamp"),
        ({"duration": "3 s"}, TimeKind.COUNTER, "calibration duration is '3 s'.*counter steps"),
        ({"duration": -1}, TimeKind.COUNTER, "must not be negative"),
        ({"score_from": "soon"}, TimeKind.TIMESTAMP, "score_from is 'soon', which is not a time"),
        ({"intervals": [(0, 2**62)]}, TimeKind.COUNTER, "end of intervals 1 .* beyond the range"),
        (
            {"overrides": {"a": Calibration(duration="3 s")}},
            TimeKind.COUNTER,
            "calibration duration is '3 s'",
        ),
    ],
)
def test_what_does_not_fit_the_source_is_refused(
    arguments: dict[str, object], kind: TimeKind, message: str
) -> None:
    with pytest.raises(CalibrationError, match=message):
        resolve(Calibration(**arguments), kind)  # type: ignore[arg-type]
