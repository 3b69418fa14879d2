"""The reference itself against public recordings, counted once by others.

The recordings are not part of this repository. To run these tests, set GAM_TEST_DATA to the folder
that holds reference_counts.csv and one folder per data set.
"""

import csv
import os
from functools import cache
from pathlib import Path
from types import SimpleNamespace

import pytest

from reference import Row, health_indicator, support

FOLDER = os.environ.get("GAM_TEST_DATA", "")
if not FOLDER:
    pytest.skip(
        "comparison with public recordings left out: to run it, set GAM_TEST_DATA to the folder "
        "with reference_counts.csv",
        allow_module_level=True,
    )

# A healthy robot with missing values and pauses (all of it); of a plant, a channel with a break in
# the recording, and one that is constant during calibration.
WHOLE = {"ur3_cobot"}
SERIES = {("C13", "A_1"), ("C8", "L_3")}
MICROSECONDS = 1_000_000


def expected_rows() -> list[dict[str, str]]:
    """The rows of reference_counts.csv for the series above."""
    with open(Path(FOLDER) / "reference_counts.csv", newline="") as file:
        return [
            row
            for row in csv.DictReader(file)
            if row["dataset"] in WHOLE or (row["asset"], row["channel"]) in SERIES
        ]


EXPECTED = expected_rows()


@cache
def recording(dataset: str, asset: str, channel: str) -> list[Row]:
    """All rows of one series; timestamps become integer microseconds."""
    pa = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    one = [("asset", "=", asset), ("channel", "=", channel)]
    table = parquet.read_table(Path(FOLDER) / dataset / "series.parquet", filters=one)
    time = table.column("ts").cast(pa.int64()) if "ts" in table.column_names else table.column("t")
    pairs = zip(time.to_pylist(), table.column("value").to_pylist(), strict=True)
    return [(asset, channel, t, x) for t, x in pairs]


def test_no_row_is_forgotten() -> None:
    """Four parameter sets for each of 20 + 2 series: a wrong filter would pass unseen."""
    assert len(EXPECTED) == 4 * (20 + 2)


@pytest.mark.parametrize(
    "row", EXPECTED, ids=lambda r: f"{r['asset']}-{r['channel']}-{r['m']}-{r['tau']}-{r['B']}"
)
def test_counts(row: dict[str, str]) -> None:
    """Every column of a row of reference_counts.csv: bounds bit for bit, counts exactly."""
    rows = recording(row["dataset"], row["asset"], row["channel"])
    unit = MICROSECONDS if row["dataset"] == "ur3_cobot" else 1
    parameters = SimpleNamespace(
        m=int(row["m"]),
        tau=int(row["tau"]),
        bins=int(row["B"]),
        window=100,
        stride=None,
        still_after=None,
        max_gap=int(row["gap"]) * unit,
        target_floor=0.05,
        least_vectors=1,
        range="min_max",
        overrides=(),
    )
    calibration = SimpleNamespace(
        fraction=float(row["cal"]),
        duration=None,
        intervals=None,
        exclude=(),
        score_from=None,
        overrides={},
        pool=None,
        reference=(),
    )
    (found,) = support(rows, parameters, calibration)
    scored = health_indicator(rows, parameters, calibration)
    monitored = [vector for vector in scored if not vector["straddling"]]
    straddling = [vector for vector in scored if vector["straddling"]]
    assert (found["calibrated_lo"], found["calibrated_hi"]) == (float(row["lo"]), float(row["hi"]))
    counts = {
        "n": found["samples"],
        "n_cal_samples": found["calibration_samples"],
        "n_cal": found["calibration_vectors"],
        "cells": found["cells"],
        "n_mon": len(monitored),
        "novel": sum(vector["novel"] for vector in monitored),
        "out_of_range": sum(vector["out_of_range"] for vector in monitored),
        "n_straddling": len(straddling),
        "novel_straddling": sum(vector["novel"] for vector in straddling),
        "null_vectors": found["missing_vectors"],
    }
    assert counts == {name: int(row[name]) for name in counts}
