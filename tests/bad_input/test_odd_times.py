"""Times: a right answer or a remedy."""

import datetime as dt
from dataclasses import replace
from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

import gam_db
from gam_db import Calibration, Parameters, Source
from harness import Row
from odd import (
    DAY,
    HALF,
    LENGTH,
    MICROS,
    SMALL,
    USUAL,
    USUAL_ROWS,
    VALUES,
    database,
    expected,
    health,
    support,
    timed,
)

#: Some before 1970, and steps of less than a millisecond.
BY_MICROS: list[Row] = [("a", "x", t, v) for t, v in zip(MICROS, VALUES, strict=True)]


@pytest.mark.parametrize("zone", [None, "UTC", "Europe/Paris", "Asia/Kathmandu"])
def test_microseconds(zone: str | None) -> None:
    """An instant is what it is, whatever the zone it is shown in."""
    assert health(timed(pa.array(MICROS, pa.timestamp("us", zone)))) == expected(BY_MICROS)


@pytest.mark.parametrize("zone", [None, "UTC", "Europe/Paris"])
def test_nanoseconds_are_floored(zone: str | None) -> None:
    rests = [0, 1, 500, 999, 1, 999, 499, 501, 0, 7]
    nanos = [micros * 1000 + rest for micros, rest in zip(MICROS, rests, strict=True)]
    assert health(timed(pa.array(nanos, pa.timestamp("ns", zone)))) == expected(BY_MICROS)


def test_nanoseconds_of_one_microsecond_are_one_instant() -> None:
    nanos = [0, 1000, 2000, 2999, 3000, 4000, 5000, 6000, 7000, 8000]
    floored = [("a", "x", n // 1000, v) for n, v in zip(nanos, VALUES, strict=True)]
    (found,) = support(timed(pa.array(nanos, pa.timestamp("ns"))))
    assert (found["samples"], found["conflicts"]) == (9, 1)
    assert health(timed(pa.array(nanos, pa.timestamp("ns")))) == expected(floored)


def test_the_first_and_last_nanosecond() -> None:
    nanos = [-(2**63) + 2, *range(0, 8000, 1000), 2**63 - 2]
    rows = [("a", "x", n // 1000, v) for n, v in zip(nanos, VALUES, strict=True)]
    source = timed(pa.array(nanos, pa.timestamp("ns")))
    assert health(replace(source, clock_tolerance=False)) == expected(rows)


@pytest.mark.parametrize(("unit", "micros"), [("s", 10**6), ("ms", 1000)])
def test_coarse_timestamps(unit: str, micros: int) -> None:
    steps = [-3, -1, 0, 1, 2, 5, 6, 7, 100, 101]
    rows = [("a", "x", n * micros, v) for n, v in zip(steps, VALUES, strict=True)]
    assert health(timed(pa.array(steps, pa.timestamp(unit)))) == expected(rows)
    assert health(timed(pa.array(steps, pa.timestamp(unit, "UTC")))) == expected(rows)


@pytest.mark.parametrize("kind", [pa.date32(), pa.date64()])
def test_dates(kind: pa.DataType) -> None:
    days = [-3, -1, 0, 1, 2, 5, 6, 7, 100, 101]
    dates = [dt.date(1970, 1, 1) + dt.timedelta(days=day) for day in days]
    rows = [("a", "x", day * DAY, v) for day, v in zip(days, VALUES, strict=True)]
    assert health(timed(pa.array(dates, kind))) == expected(rows)


def test_lengths_and_instants_of_the_user_on_a_calendar() -> None:
    """max_gap, an interval and score_from in words: 5 ms, and instants with and without a zone."""
    micros = [0, 1000, 2094, 4188, 5188, 6188, 7188, 12_189, 13_189, 14_189]
    rows = [("a", "x", t, v) for t, v in zip(micros, VALUES, strict=True)]
    start, end = dt.datetime(1970, 1, 1), "1970-01-01T01:00:00.004188+01:00"
    source = timed(pa.array(micros, pa.timestamp("us")))
    for gap in ("2.094 ms", 0.002094, dt.timedelta(microseconds=2094)):
        found = health(
            source,
            Parameters(m=2, bins=4, window=2, max_gap=gap),
            Calibration(intervals=[(start, end)], score_from="1970-01-01T00:00:00.005"),
        )
        counted = Parameters(m=2, bins=4, window=2, max_gap=2094)
        assert found == expected(rows, counted, Calibration(intervals=[(0, 4188)], score_from=5000))


def test_times_come_back_as_the_source_tells_them() -> None:
    def kind(times: Any) -> pa.DataType:
        return gam_db.health_indicator(timed(times), SMALL, HALF).schema.field("time").type

    assert kind(list(range(LENGTH))) == pa.int64()
    assert kind(pa.array(MICROS, pa.timestamp("us"))) == pa.timestamp("us")
    assert kind(pa.array(MICROS, pa.timestamp("us", "Europe/Paris"))) == pa.timestamp("us", "UTC")
    assert kind(pa.array(MICROS, pa.timestamp("ns", "UTC"))) == pa.timestamp("us", "UTC")


@pytest.mark.parametrize("kind", ["TINYINT", "INTEGER", "HUGEINT", "UTINYINT", "UBIGINT", "UHUGEINT"])
def test_counters_of_any_integer_type(kind: str) -> None:
    connection = database(USUAL, f"ALTER TABLE t ALTER time TYPE {kind}")
    assert health(Source("t"), engine=connection) == expected(USUAL_ROWS)
