"""Rows that belong nowhere: a right answer or a remedy."""

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

from gam_db import Source
from odd import LENGTH, ROWS, columns, database, expected, health, refused, secret, support, table


@pytest.mark.parametrize("role", ["asset", "channel", "time"])
def test_rows_without_a_name_or_a_time_are_counted_and_refused(role: str) -> None:
    holes = [None if i in (2, 5, 7) else value for i, value in enumerate(columns()[role])]
    refused(
        f'3 without {role}.* where="{role} IS NOT NULL"',
        lambda: support(Source(table(**{role: holes}, value=secret()))),
    )
    whole = Source(table(**{role: holes}), where=f"{role} IS NOT NULL")
    assert health(whole) == expected([row for i, row in enumerate(ROWS) if i not in (2, 5, 7)])


def test_all_that_is_missing_is_counted_at_once() -> None:
    none = [None] + ["a"] * (LENGTH - 1)
    said = refused(
        "1 without asset, 2 without time",
        lambda: support(Source(table(asset=none, time=[None, None, *range(2, LENGTH)]))),
    )
    assert "without channel" not in said


@pytest.mark.parametrize("kind", ["TIMESTAMP", "TIMESTAMPTZ", "TIMESTAMP_NS", "DATE"])
def test_infinite_times_are_no_times(kind: str) -> None:
    connection = database(
        f"CREATE TABLE t AS SELECT 'a' AS asset, 'x' AS channel, "
        f"CASE WHEN i = 3 THEN 'infinity' WHEN i = 4 THEN '-infinity' ELSE '2026-03-01' END::{kind} "
        "AS time, i::DOUBLE AS value FROM range(9) AS r(i)"
    )
    said = refused("2 without time .*infinite time", lambda: support(Source("t"), engine=connection))
    condition = said.partition('where="')[2].partition('"')[0]
    (row,) = support(Source("t", where=condition), engine=connection)
    assert row["samples"] == 1  # of the seven rows at one instant


@pytest.mark.parametrize("first", [2**62, -(2**62), 2**63 - 1, -(2**63)])
def test_counters_beyond_the_clock(first: int) -> None:
    times = [first, *range(1, LENGTH)]
    refused(r"beyond 2\^62.* subtract an offset", lambda: support(Source(table(time=times))))


def test_counters_beyond_64_bits() -> None:
    times = pa.array([2**64 - 1, *range(1, LENGTH)], pa.uint64())
    refused("a counter needs 64 bits", lambda: support(Source(table(time=times, value=secret()))))
