"""Columns: a right answer or a remedy."""

import datetime as dt
import decimal
from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

from gam_db import Source, WideSource
from odd import LENGTH, ROWS, SECRET, SEVEN, expected, health, refused, secret, support, table


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (Source(table(), value="valeu"), "no column 'valeu' for value; did you mean 'value'"),
        (Source(table(), time="Time"), "no column 'Time' for time; did you mean 'time'"),
        (Source(table(), time="timestamp"), "no column 'timestamp' for time"),
        (Source(table(asset=None)), r"\(asset=None if there is only one\)"),
        (Source(table(channel=None)), r"\(channel=None if there is only one\)"),
        (Source(table(channel=None)), "or pass the relation itself, so that gam-db guesses its columns"),
        (Source(table(), time="ts"), r"no column 'ts' for time; there is [^;]*\.$"),
        (WideSource(table(), channels=["value", "torque"]), "no column 'torque' for channel 2"),
        (WideSource(table(value=["high"] * LENGTH)), "no numeric column beside asset and time"),
        (Source(pa.table({})), "Arrow table has no columns"),
    ],
)
def test_a_missing_column_is_named(source: Source, message: str) -> None:
    refused(message, lambda: support(source))


def test_columns_that_cannot_be_names() -> None:
    refused("asset is 5; it takes the name of a column", lambda: Source("t", asset=5))  # type: ignore[arg-type]
    refused("value is None; it takes the name", lambda: Source("t", value=None))  # type: ignore[arg-type]
    refused("time is ''; it takes the name", lambda: Source("t", time=""))
    refused("list of column names", lambda: WideSource("t", channels="value"))
    refused("list of column names", lambda: WideSource("t", channels=5))  # type: ignore[arg-type]
    refused("takes the names of columns", lambda: WideSource("t", channels=["v", 5]))  # type: ignore[list-item]
    refused("name at least one column", lambda: WideSource("t", channels=[]))


@pytest.mark.parametrize(
    ("values", "shown"),
    [
        (["8675309.25"] * LENGTH, "VARCHAR"),
        ([dt.date(2026, 1, 1)] * LENGTH, "DATE"),
        ([b"1"] * LENGTH, "BLOB"),
        ([[SECRET]] * LENGTH, r"DOUBLE\[\]"),
        (pa.array([[SEVEN]] * LENGTH, pa.list_(pa.decimal128(5, 2))), r"DECIMAL\(5,2\)\[\]"),
        ([{"a": SECRET}] * LENGTH, "STRUCT"),
        (pa.nulls(LENGTH), "NULL"),
        (pa.array([1] * LENGTH, pa.duration("us")), "INTERVAL"),
    ],
)
def test_values_that_are_no_numbers(values: Any, shown: str) -> None:
    refused(
        f"value column 'value' is of type .*{shown}.*; readings must be numbers.*view",
        lambda: support(Source(table(value=values))),
    )
    refused("channel column 'value'", lambda: support(WideSource(table(value=values), ["value"])))


@pytest.mark.parametrize(
    "times",
    [
        [f"March {i % 9 + 1}" for i in range(LENGTH)],
        [float(i) for i in range(LENGTH)],
        pa.array([decimal.Decimal(i) for i in range(LENGTH)], pa.decimal128(10, 0)),
        pa.array(range(LENGTH), pa.time64("us")),
        [True] * LENGTH,
        pa.nulls(LENGTH),
    ],
)
def test_times_that_tell_no_time(times: Any) -> None:
    refused(
        "time column 'time' (is of type .* a timestamp or an integer counter|must be a time in ISO)",
        lambda: support(Source(table(time=times, value=secret()))),
    )


@pytest.mark.parametrize(
    "names", [[True] * LENGTH, [1.5] * LENGTH, [b"a"] * LENGTH, [dt.date(2026, 1, 1)] * LENGTH]
)
@pytest.mark.parametrize("role", ["asset", "channel"])
def test_names_that_are_neither_text_nor_integers(role: str, names: list[Any]) -> None:
    refused(
        f"{role} column '{role}' is of type .* must be text or an integer",
        lambda: support(Source(table(**{role: names}))),
    )


def test_declared_kind_of_time() -> None:
    refused(
        "time_kind is 'timestamp', but the column 'time' is of type BIGINT",
        lambda: support(Source(table(), time_kind="timestamp")),
    )
    refused(
        "time_kind is 'calendar'; it takes 'timestamp', 'timestamp with time zone' or 'counter'",
        lambda: support(Source(table(), time_kind="calendar")),
    )
    assert health(Source(table(), time_kind="counter")) == expected(ROWS)
