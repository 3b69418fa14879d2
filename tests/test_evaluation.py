"""The evaluation equals its equations in rational numbers, and says why where there is nothing."""

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evaluation_reference as reference
import gam_db
from evaluation_reference import Series
from gam_db.evaluation import sampling
from gam_db.evaluation.members import Member

QUICK = gam_db.Conventions(surrogates=0, samples=0)
WINDOW = 12


def bucket_table(fleet: list[Series], per_window: int = 3, scale: int = WINDOW) -> pa.Table:
    """What health_at_buckets would return, a clock tick of 10 per bucket; values are counts / scale."""
    rows: dict[str, list[Any]] = {name: [] for name in ("asset", "channel", "bucket", "last_time")}
    rows |= {"novel_in_window": [], "hi": []}
    for one in fleet:
        values: list[Fraction | None] = [*[None] * (per_window - 1), *one.values]
        for bucket, value in enumerate(values):
            rows["asset"].append(one.asset)
            rows["channel"].append(one.channel)
            rows["bucket"].append(bucket)
            rows["last_time"].append(10 * bucket + 9)
            rows["novel_in_window"].append(None if value is None else int(value * scale))
            rows["hi"].append(None if value is None else float(value))
    types = dict.fromkeys(rows, pa.int64()) | {"asset": pa.string(), "channel": pa.string()}
    types["hi"] = pa.float64()
    return pa.table({name: pa.array(column, types[name]) for name, column in rows.items()})


def outcome_table(rows: list[tuple[str, str | None, int | None, bool]]) -> pa.Table:
    types = (pa.string(), pa.string(), pa.int64(), pa.bool_())
    columns = list(zip(*rows, strict=True)) if rows else [(), (), (), ()]
    names = ("asset", "channel", "failed_at", "healthy")
    arrays = [pa.array(list(column), kind) for column, kind in zip(columns, types, strict=True)]
    return pa.table(dict(zip(names, arrays, strict=True)))


def assert_close(expected: Any, found: Any, what: str) -> None:
    if isinstance(expected, float) and isinstance(found, float):
        assert found == pytest.approx(expected, rel=1e-12, abs=1e-12), what
    else:
        assert found == expected, what


counts = st.one_of(
    st.lists(st.integers(0, WINDOW), max_size=45),
    st.lists(st.integers(0, 2), min_size=2, max_size=25),
    st.builds(lambda k, at: [0] * at + list(range(k)), st.integers(0, 13), st.integers(0, 20)),
    st.builds(lambda k, n: [k] * n, st.integers(0, WINDOW), st.integers(0, 30)),
)
Fleet = tuple[list[Series], list[tuple[str, str | None, int | None, bool]] | None, dict[str, Any]]


@st.composite
def fleets(draw: st.DrawFn) -> Fleet:
    """Up to four assets of one or two channels; what became of them, or nothing; conventions."""
    known = draw(st.sampled_from([True, True, True, False]))
    fleet, outcomes = [], []
    for number in range(draw(st.integers(1, 4))):
        asset = f"r{number}"
        channels = ["x", "y"][: draw(st.integers(1, 2))]
        fate = draw(st.sampled_from(["failed", "healthy", None])) if known else None
        chosen = draw(st.sampled_from(channels))
        whole = fate == "healthy" or (len(channels) == 1 and draw(st.booleans()))
        ends = draw(st.sampled_from([None, 0, 29, 150, 400])) if fate == "failed" else None
        if fate is not None:
            outcomes.append((asset, None if whole else chosen, ends, fate == "healthy"))
        for channel in channels:
            values = [Fraction(count, WINDOW) for count in draw(counts)]
            told = fate if whole or channel == chosen else None
            fleet.append(Series(asset, channel, values, told))
    conventions = {
        "monotonicity": draw(st.sampled_from(["rank", "rank", "sign"])),
        "amplitude": draw(st.sampled_from(["range", "range", "ends"])),
        "ddof": draw(st.sampled_from([0, 0, 1])),
    }
    return fleet, outcomes if known else None, conventions


def cut(fleet: list[Series], outcomes: list[tuple[str, str | None, int | None, bool]]) -> list[Series]:
    """The series of failed assets without what came after the failure."""
    ends = {asset: failed_at for asset, _, failed_at, _ in outcomes if failed_at is not None}
    return [
        Series(
            one.asset,
            one.channel,
            [
                value
                for place, value in enumerate(one.values, 2)
                if one.outcome != "failed" or 10 * place + 9 <= ends.get(one.asset, math.inf)
            ],
            one.outcome,
        )
        for one in fleet
    ]


@given(drawn=fleets())
def test_every_metric_equals_its_equation(drawn: Fleet) -> None:
    """Ties, constants, short series, one asset, none that failed: integers exactly, ratios to 1e-12."""
    fleet, outcomes, conventions = drawn
    chosen = gam_db.Conventions(**conventions, surrogates=0, samples=0)
    told = None if outcomes is None else outcome_table(outcomes)
    table = bucket_table(fleet)
    found = gam_db.evaluate(table, told, conventions=chosen)
    fleet = cut(fleet, outcomes or [])
    for one, row in zip(fleet, found.channels.to_pylist(), strict=True):
        expected = reference.of_series(one, conventions["monotonicity"])
        for column, value in expected.items():
            assert_close(value, row[column], f"{one.asset} {one.channel} {column}")
        assert all(row[name] is None or row[name] <= 1 + 1e-15 for name in ("mon", "corr", "rob"))
    whole = reference.of_fleet(fleet, **conventions, known=outcomes is not None)
    summary = {row["metric"]: row for row in found.summary.to_pylist()}
    assert list(summary) == ["mon", "corr", "rob", "prog", "disc", "trendability", "global"]
    for metric, (value, reason) in whole.items():
        assert_close(value, summary[metric]["value"], metric)
        assert summary[metric]["reason"] == reason, metric
