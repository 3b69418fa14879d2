"""Single signals from Python: arrays and series are read as the same data in a table is."""

import datetime as dt
import math
from collections.abc import Callable
from typing import Any

import numpy as np
import pyarrow as pa
import pytest

import gam_db
from gam_db import Parameters, Source, UserError
from gam_db.engines.frames import signal_table

ROWS = 400
SMALL = Parameters(m=2, tau=1, bins=5, window=20)
WAVE = np.array([math.sin(row / 3) for row in range(ROWS)])


def table_of(values: Any = WAVE, name: str = "value", time: Any = None) -> pa.Table:
    return pa.table({"time": range(ROWS) if time is None else time, name: values})


def expected(table: pa.Table) -> list[dict[str, Any]]:
    value = table.column_names[1]
    source = Source(table, asset=None, channel=None, time="time", value=value)
    rows: list[dict[str, Any]] = gam_db.health_indicator(source, SMALL).to_pylist()
    assert len(rows) == 320
    return rows


ARRAYS: dict[str, Callable[[], Any]] = {
    "array": lambda: WAVE,
    "part of a larger array": lambda: np.stack([WAVE, WAVE[::-1]], axis=1)[:, 0],
    "array of the other byte order": lambda: WAVE.astype(">f8"),
    "array of Arrow": lambda: pa.array(WAVE),
    "chunks of Arrow": lambda: pa.chunked_array([WAVE[:100], WAVE[100:]]),
    "categories": lambda: pa.array(WAVE).dictionary_encode(),
}


@pytest.mark.parametrize("what", ARRAYS)
def test_an_array_counts_its_readings(what: str) -> None:
    given = ARRAYS[what]()
    found = gam_db.health_indicator(given, SMALL).to_pylist()
    assert found == expected(table_of())
    assert {(row["asset"], row["channel"]) for row in found} == {("asset", "value")}
    assert [row["time"] for row in found] == list(range(80, 400))
    named = Source(given, asset=None, channel=None)
    assert gam_db.health_indicator(named, SMALL).to_pylist() == found
    assert gam_db.check(given, SMALL)["samples"].to_pylist() == [ROWS]
    assert gam_db.episodes(given, SMALL) == gam_db.episodes(named, SMALL)


@pytest.mark.parametrize("kind", [np.bool_, np.int8, np.uint32, np.float16, np.float32, np.longdouble])
def test_arrays_of_any_numbers(kind: Any) -> None:
    values = (np.round(WAVE * 2) + 2).astype(kind)
    found = gam_db.health_indicator(values, SMALL).to_pylist()
    assert found == expected(table_of(values.astype(float)))


def test_missing_readings_of_arrays_are_missing() -> None:
    holed = WAVE.copy()
    holed[7] = np.nan
    masked = np.ma.masked_array(WAVE, mask=np.arange(ROWS) == 7)
    without = expected(table_of([None if row == 7 else value for row, value in enumerate(WAVE)]))
    for given in (holed, masked):
        assert gam_db.health_indicator(given, SMALL).to_pylist() == without
    (row,) = gam_db.support(holed, SMALL).to_pylist()
    assert (row["samples"], row["missing_vectors"]) == (ROWS, 2)


def test_a_series_is_told_by_its_index() -> None:
    pandas = pytest.importorskip("pandas", reason="it comes with the extra engines")
    first = dt.datetime(2026, 3, 1)
    instants = [first + row * dt.timedelta(seconds=1) for row in range(ROWS)]
    utc = pa.timestamp("us", "UTC")
    counts = [3 * row + 7 for row in range(ROWS)]
    for index, time in (
        (None, None),
        (pandas.DatetimeIndex(instants, name="ts"), instants),
        (pandas.DatetimeIndex(instants).tz_localize("UTC"), pa.array(instants, utc)),
        (counts, counts),
        (np.array(counts, float), counts),
    ):
        series = pandas.Series(WAVE, index=index, name="torque")
        found = gam_db.health_indicator(series, SMALL)
        assert found.to_pylist() == expected(table_of(name="torque", time=time))
        assert set(found["channel"].to_pylist()) == {"torque"}
    unsorted = pandas.Series(WAVE, index=counts).sample(frac=1, random_state=0)
    assert gam_db.health_indicator(unsorted, SMALL).to_pylist() == expected(table_of(time=counts))


def test_a_series_may_be_called_anything() -> None:
    pandas = pytest.importorskip("pandas", reason="it comes with the extra engines")
    for name, channel in (("Time", "Time"), ("machine", "machine"), (0, "0"), ("", "value")):
        found = gam_db.support(pandas.Series(WAVE, name=name), SMALL).to_pylist()
        assert [(row["channel"], row["samples"]) for row in found] == [(channel, ROWS)]
    whole = pandas.Series([1, None, 3], dtype="Int64")
    made = signal_table(whole)
    assert made is not None
    assert made["value"].to_pylist() == [1, None, 3]


class Series:
    """A series as polars has them: Arrow by ``__arrow_c_stream__``, and a name."""

    __module__ = "polars.series.series"
    name, dtype = "torque", "Float64"

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return pa.chunked_array([WAVE]).__arrow_c_stream__(requested_schema)


def test_a_series_of_polars_counts_its_readings() -> None:
    found = gam_db.health_indicator(Series(), SMALL).to_pylist()
    assert found == expected(table_of(name="torque"))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (np.zeros((9, 2)), r"The array has 2 dimensions; .* array\[:, 0\]"),
        (np.array(["1", "2"]), "type <U1; readings must be numbers"),
        (np.array([1, None]), "type object; readings must be numbers"),
        (np.array(["2026-03-01"], "datetime64[s]"), r"type datetime64\[s\]; readings must be numbers"),
        (np.array([1j]), "type complex128; readings must be numbers"),
        (pa.array(["a"]), "type string; readings must be numbers"),
    ],
)
def test_an_array_that_is_no_signal_is_refused(given: Any, message: str) -> None:
    with pytest.raises(UserError, match=message):
        gam_db.support(given)


def test_a_series_or_frame_of_something_else_is_refused() -> None:
    pandas = pytest.importorskip("pandas", reason="it comes with the extra engines")
    mixed = pandas.DataFrame({"time": [1, 2], "value": [1, "a"]})
    for given, message in (
        (pandas.Series([1, "a"]), "type object; readings must be numbers"),
        (pandas.Series([1.0], index=["a"]), "is a Index of the type str, which is not a time"),
        (pandas.Series([1.0], index=[0.5]), "contains fractions or missing values"),
        (pandas.Series([1.0], index=[np.nan]), "contains fractions or missing values"),
        (pandas.Series([1.0], index=pandas.period_range("2026", periods=1)), "is a PeriodIndex"),
        (pandas.Series([1.0], index=pandas.MultiIndex.from_tuples([(1, 2)])), "is a MultiIndex"),
        (mixed, r"The column 'value' contains Python objects .* frame\['value'\]\.astype\(float\)"),
        (Source(mixed, None, None), "The column 'value' contains Python objects"),
    ):
        with pytest.raises(UserError, match=message):
            gam_db.support(given)
