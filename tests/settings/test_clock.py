"""Instants and lengths of time as integers, worked out from the calendar by hand."""

import datetime as dt

import numpy as np
import pytest

from gam_db.clock import TimeKind, instant, length, looks_like_calendar
from gam_db.errors import ParameterError

COUNTER, TIMESTAMP = TimeKind.COUNTER, TimeKind.TIMESTAMP
DAY = 86_400 * 10**6  # microseconds
PARIS_IN_SUMMER = dt.timezone(dt.timedelta(hours=2))


@pytest.mark.parametrize(
    ("value", "micros"),
    [
        ("1970-01-01", 0),
        ("1970-01-02T00:00:00.000001", DAY + 1),
        (" 1970-01-02 ", DAY),
        ("1970-01-01T02:00:00+02:00", 0),
        ("1970-01-01T00:00:00Z", 0),
        ("1969-12-31T23:59:59.999999", -1),
        (dt.date(1970, 1, 11), 10 * DAY),
        (dt.datetime(1970, 1, 1, 0, 0, 1), 10**6),  # without zone: UTC
        (dt.datetime(1970, 1, 1, 2, tzinfo=PARIS_IN_SUMMER), 0),
        (dt.datetime(1960, 1, 1), -(10 * 365 + 3) * DAY),  # leap days: 1960, 1964, 1968
        (np.datetime64("1970-01-02"), DAY),
        (np.datetime64("1970-01-01T00:00:00.000001999", "ns"), 1),
        (np.datetime64("1969-12-31T23:59:59.999999999", "ns"), -1),  # floored, not cut off
    ],
)
def test_instant_of_a_calendar(value: object, micros: int) -> None:
    assert instant(value, TIMESTAMP, "it") == micros


@pytest.mark.parametrize(
    ("value", "steps"), [(7, 7), (-7, -7), ("7", 7), (" -7 ", -7), (7.0, 7), (np.int32(7), 7)]
)
def test_instant_of_a_counter(value: object, steps: int) -> None:
    assert instant(value, COUNTER, "it") == steps


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        ("yesterday", TIMESTAMP),
        ("2026-02-30", TIMESTAMP),
        ("", TIMESTAMP),
        (5, TIMESTAMP),  # seconds or microseconds? one would have to guess
        (5.0, TIMESTAMP),
        (None, TIMESTAMP),
        (np.datetime64("NaT"), TIMESTAMP),
        ("2026-01-01", COUNTER),
        (dt.date(2026, 1, 1), COUNTER),
        (1.5, COUNTER),
        (float("nan"), COUNTER),
        (True, COUNTER),
        ("--1", COUNTER),
        ("-", COUNTER),
        ("²", COUNTER),
        ("1" * 5000, COUNTER),
        (2**62, COUNTER),
        (-(2**62), COUNTER),
    ],
)
def test_instant_refuses(value: object, kind: TimeKind) -> None:
    with pytest.raises(ParameterError, match="score_from is "):
        instant(value, kind, "score_from")


@pytest.mark.parametrize(
    ("value", "micros"),
    [
        (0, 0),
        (2, 2 * 10**6),
        (0.5, 500_000),
        (2.094, 2_094_000),  # 2.094 * 1e6 is 2093999.9999999998 in doubles
        ("2.094 s", 2_094_000),
        ("1.001ms", 1_001),
        ("0.009 h", 32_400_000),
        ("7 us", 7),
        ("0.9 us", 0),  # no step of the clock lies between
        ("2min", 120 * 10**6),
        (" 1.5 d ", DAY + DAY // 2),
        ("2. w", 14 * DAY),
        (dt.timedelta(days=1, microseconds=3), DAY + 3),
        (np.timedelta64(1500, "ns"), 1),
        (np.float64(0.25), 250_000),
    ],
)
def test_length_by_a_calendar(value: object, micros: int) -> None:
    assert length(value, TIMESTAMP, "it") == micros


@pytest.mark.parametrize(("value", "steps"), [(5, 5), (5.9, 5), ("5", 5), (0, 0), (np.int64(5), 5)])
def test_length_in_steps(value: object, steps: int) -> None:
    assert length(value, COUNTER, "it") == steps


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        ("10", TIMESTAMP),  # of what?
        ("ten s", TIMESTAMP),
        ("1e3 s", TIMESTAMP),
        ("5 years", TIMESTAMP),
        ("-5 s", TIMESTAMP),
        (-1, TIMESTAMP),
        (dt.timedelta(-1), TIMESTAMP),
        (float("nan"), TIMESTAMP),
        (float("inf"), TIMESTAMP),
        (1e300, TIMESTAMP),
        (True, TIMESTAMP),
        (None, TIMESTAMP),
        ("5 s", COUNTER),
        (dt.timedelta(1), COUNTER),
        (float("inf"), COUNTER),
        (-1, COUNTER),
        (-0.5, COUNTER),
        (2**62, COUNTER),
        (True, COUNTER),
    ],
)
def test_length_refuses(value: object, kind: TimeKind) -> None:
    with pytest.raises(ParameterError, match="max_gap is "):
        length(value, kind, "max_gap")


def test_refusals_say_what_to_write_instead() -> None:
    with pytest.raises(ParameterError, match="write it like 2026-03-01T06:00:00"):
        instant("1 March", TIMESTAMP, "score_from")
    with pytest.raises(ParameterError, match="counts time in integers; give an integer"):
        instant("2026-03-01", COUNTER, "score_from")
    with pytest.raises(ParameterError, match="such as '30 d'"):
        length("30", TIMESTAMP, "max_gap")


@pytest.mark.parametrize(
    ("value", "calendar"),
    [
        ("2026-01-01", True),
        ("5 s", True),
        (dt.date(2026, 1, 1), True),
        (dt.timedelta(1), True),
        (np.timedelta64(1, "s"), True),
        ("5", False),
        ("-5", False),
        (5, False),
        (5.5, False),
        (np.int64(5), False),
    ],
)
def test_what_can_only_mean_a_calendar(value: object, calendar: bool) -> None:
    assert looks_like_calendar(value) is calendar
