"""Real recordings: every figure of reference_counts.csv, to the integer.

That file holds what a separate NumPy count gave for each series of five public recordings under four
sets of parameters. Its counts of monitored vectors leave the straddling ones out.
"""

import csv
from collections import Counter, defaultdict
from pathlib import Path
from typing import Any

import duckdb
import pytest
from sqlglot import exp

import comparisons
import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.study import Study

DATASETS = ("production_plant", "femto_bearings", "hydraulic_rig", "hydraulic_actuators", "ur3_cobot")
SETTINGS = (("3", "1", "100"), ("3", "1", "20"), ("1", "1", "100"), ("3", "5", "10"))
ROWS = 740


#: What is counted among the vectors, on the engine: millions of them need not be fetched.
TOTALS = (
    exp.select("asset", "channel", "straddling", "COUNT(*) AS vectors")
    .select("SUM(novel) AS novel", "SUM(out_of_range) AS out_of_range")
    .group_by("asset", "channel", "straddling")
)

Counts = dict[tuple[str, ...], list[dict[str, str]]]


def counts(recordings: Path) -> Counts:
    """Return the rows of the reference by data set and parameters."""
    found: Counts = defaultdict(list)
    with (recordings / "reference_counts.csv").open() as lines:
        for row in csv.DictReader(lines):
            found[row["dataset"], row["m"], row["tau"], row["B"]].append(row)
    return found


def series(recordings: Path, dataset: str) -> gam_db.Source:
    """Return the source of a recording."""
    time = "ts" if dataset == "ur3_cobot" else "t"
    return gam_db.Source(recordings / dataset / "series.parquet", time=time)


def test_every_row_of_the_reference_is_asked_for(recordings: Path) -> None:
    found = counts(recordings)
    assert set(found) == {(dataset, *setting) for dataset in DATASETS for setting in SETTINGS}
    assert sum(map(len, found.values())) == ROWS


@pytest.mark.parametrize(
    "setting",
    [
        SETTINGS[0],
        *(pytest.param(setting, marks=pytest.mark.thorough) for setting in SETTINGS[3::3]),
        *(pytest.param(setting, marks=pytest.mark.full) for setting in SETTINGS[1:3]),
    ],
    ids="/".join,
)
@pytest.mark.parametrize("dataset", DATASETS)
def test_reference_counts(recordings: Path, dataset: str, setting: tuple[str, ...]) -> None:
    with DuckSession() as session:
        agrees(session, series(recordings, dataset), counts(recordings)[dataset, *setting], setting)


def agrees(
    session: Session, source: gam_db.Source, expected: list[dict[str, str]], setting: tuple[str, ...]
) -> None:
    """Compare what a session makes of a recording with its rows of the reference."""
    m, tau, bins = map(int, setting)
    gaps = {row["channel"]: int(row["gap"]) for row in expected}
    usual = Counter(gaps.values()).most_common(1)[0][0]
    parameters = gam_db.Parameters(
        m=m,
        tau=tau,
        bins=bins,
        max_gap=usual,
        range="min_max",
        overrides=[
            gam_db.Override(channel=channel, max_gap=gap)
            for channel, gap in gaps.items()
            if gap != usual
        ],
    )
    calibration = gam_db.Calibration(fraction=float(expected[0]["cal"]))
    study = Study(session, source, parameters, calibration)
    try:
        rows = study.table("support_summary").to_pylist()
        totals = session.fetch(TOTALS.from_(study.running.query("health_indicator").subquery("vectors")))
    finally:
        study.running.forget()
    learnt = {(row["asset"], row["channel"]): row for row in rows}
    scored: dict[tuple[Any, ...], dict[str, int]] = defaultdict(lambda: defaultdict(int))
    for row in totals.to_pylist():
        scored[row["asset"], row["channel"], row["straddling"]] = row
    for row in expected:
        channel = (row["asset"], row["channel"])
        support, monitored, straddling = learnt[channel], scored[*channel, 0], scored[*channel, 1]
        assert (support["calibrated_lo"], support["calibrated_hi"]) == (
            float(row["lo"]),
            float(row["hi"]),
        ), channel
        found = {
            "n": support["samples"],
            "n_cal_samples": support["calibration_samples"],
            "n_cal": support["calibration_vectors"],
            "cells": support["cells"],
            "null_vectors": support["missing_vectors"],
            "n_mon": monitored["vectors"],
            "novel": monitored["novel"],
            "out_of_range": monitored["out_of_range"],
            "n_straddling": straddling["vectors"],
            "novel_straddling": straddling["novel"],
        }
        assert found == {name: int(row[name]) for name in found}, channel
        comparisons.compared_recording(session.engine.name, "exact", row["dataset"], *channel, *setting)


def test_view_of_a_recording_equals_the_exact_form(recordings: Path) -> None:
    source = series(recordings, "ur3_cobot")
    parameters = gam_db.Parameters(window=500, bins=20, max_gap="5 s")
    exact = gam_db.health_indicator(source, parameters)
    with duckdb.connect() as connection:
        connection.execute(gam_db.render("view", "duckdb", source, parameters))
        view = connection.sql("SELECT * FROM gam_live_health ORDER BY asset, channel, time")
        rows = view.to_arrow_table().select(exact.column_names)  # it judges, too
        assert rows.cast(exact.schema).equals(exact)
        one = connection.sql(
            "SELECT time, hi FROM gam_live_health_of('ur3', 'Current_J3') ORDER BY time"
        ).fetchall()
    times = [str(name) for name in exact["channel"].to_pylist()]
    expected = [
        (row["time"], row["hi"])
        for name, row in zip(times, exact.select(["time", "hi"]).to_pylist(), strict=True)
        if name == "Current_J3"
    ]
    assert one == expected
