"""Calibration against a source: a right answer or a remedy."""

import datetime as dt
from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

from gam_db import Calibration, Parameters, Source
from gam_db.errors import CalibrationError, ParameterError
from odd import MICROS, ROWS, SMALL, agreed, expected, health, refused, support, table, timed


def test_calibration_in_pieces() -> None:
    agreed(ROWS, SMALL, Calibration(intervals=[(4, 5), (0, 2)], exclude=[(1, 1)], score_from=2))


@pytest.mark.parametrize(
    ("calibration", "message"),
    [
        (Calibration(intervals=[(5, 1)]), r"intervals 1 ends \(1\) before it begins \(5\)"),
        (Calibration(intervals=[("2026-01-01", "2026-02-01")]), "the source counts time in integers"),
        (Calibration(duration="3 s"), "the source counts time in integers; give a number of counter"),
        (Calibration(duration=dt.timedelta(1)), "the source counts time in integers"),
        (Calibration(score_from="--1"), "score_from is '--1'"),
        (Calibration(exclude=[(0, 2**62)]), "end of exclude 1 .* beyond the range of the clock"),
    ],
)
def test_calibration_that_does_not_fit_a_counter(calibration: Calibration, message: str) -> None:
    refused(message, lambda: support(Source(table()), calibration), CalibrationError)


def test_calibration_that_does_not_fit_a_calendar() -> None:
    source = timed(pa.array(MICROS, pa.timestamp("us")))
    refused(
        "start of intervals 1 is 0, but the time of the source is a timestamp",
        lambda: support(source, Calibration(intervals=[(0, 5)])),
        CalibrationError,
    )
    refused(
        "max_gap is '5', which is not a length of time; .* with a unit",
        lambda: health(source, Parameters(max_gap="5")),
        ParameterError,
    )


def test_numbers_in_words_on_a_counter() -> None:
    said = Calibration(intervals=[("0", " 4 ")], score_from="6")
    assert health(Source(table()), calibration=said) == expected(
        ROWS, calibration=Calibration(intervals=[(0, 4)], score_from=6)
    )


@pytest.mark.parametrize("samples", [1, 0, -3, 2.5, True])
def test_a_run_of_still_samples_has_at_least_two(samples: Any) -> None:
    refused("still_after is", lambda: Parameters(still_after=samples), ParameterError)
