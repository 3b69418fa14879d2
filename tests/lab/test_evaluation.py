"""The evaluation equals its equations in rational numbers, and says why where there is nothing."""

import math
from fractions import Fraction
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evaluation_reference as reference
import gam_db
from evaluation_reference import Series
from gam_db import langevin
from gam_db.lab.evaluation import sampling
from gam_db.lab.evaluation.capacity import largest_range
from gam_db.lab.evaluation.members import Member

pytestmark = pytest.mark.thorough

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


@settings(max_examples=settings().max_examples // 4)
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


# Known answers, and what there is to say where there is none


def single(values: list[int], per_window: int = 3) -> dict[str, Any]:
    """The row of one channel with these counts."""
    table = bucket_table([Series("r", "x", [Fraction(v, WINDOW) for v in values])], per_window)
    (row,) = gam_db.evaluate(table, conventions=QUICK).channels.to_pylist()
    return dict(row)


@pytest.mark.parametrize(
    ("values", "mon", "corr", "rob"),
    [
        ([], "no_values", "no_values", "no_values"),
        ([3], "one_value", "one_value", "short"),
        ([3, 7], 1.0, 1.0, "short"),
        ([7, 3], -1.0, -1.0, "short"),
        ([4] * 30, "constant", "constant", "constant"),
        (list(range(100)), 1.0, 1.0, 1.0),
        ([0, 1, 1, 2], 0.9486832980505138, 0.9486832980505138, "short"),
    ],
)
def test_known_answers(values: list[int], mon: Any, corr: Any, rob: Any) -> None:
    row = single(values)
    for metric, column, expected in (
        ("mon", "mon_signed", mon),
        ("corr", "corr_signed", corr),
        ("rob", "rob", rob),
    ):
        if isinstance(expected, str):
            assert (row[metric], row[f"{metric}_reason"]) == (None, expected)
        else:
            assert row[column] == pytest.approx(expected, abs=1e-15)
            assert row[f"{metric}_reason"] is None


def test_windows_that_do_not_overlap_are_counted() -> None:
    """Buckets 0 to 13 hold 14 strides: four whole windows of three."""
    assert single(list(range(12)))["independent_windows"] == 4
    assert single([])["independent_windows"] is None, "no bucket says how many a window spans"


@pytest.mark.parametrize("size", [23, 57, 104])
def test_scipy_agrees(size: int) -> None:
    """On counts to 1e-12; on doubles as far as their steps go."""
    stats = pytest.importorskip("scipy.stats", reason="SciPy is in the extra benchmark")
    signal = pytest.importorskip("scipy.signal")
    generator = np.random.default_rng(size)
    counts = generator.integers(0, 50, size) + np.arange(size) // 3
    fleet = [Series("r", "x", [Fraction(int(count), 1000) for count in counts])]
    exact = bucket_table(fleet, scale=1000)
    half = size // 10
    index, hi = np.arange(size), counts / 1000
    trend = signal.savgol_filter(hi, 2 * half + 1, 2, mode="interp")
    expected = {
        "mon_signed": stats.spearmanr(hi, index).statistic,
        "corr_signed": stats.pearsonr(hi, index).statistic,
        "rob": math.exp(-np.mean(np.abs(hi - trend)) / np.ptp(hi)),
        "hi_sd": np.std(hi),
    }
    for table, tolerance in ((exact, 1e-12), (exact.drop_columns("novel_in_window"), 2e-8)):
        (row,) = gam_db.evaluate(table, conventions=QUICK).channels.to_pylist()
        for column, value in expected.items():
            assert row[column] == pytest.approx(value, abs=tolerance), column


def test_doubles_keep_their_order() -> None:
    """Ranks are those of the doubles themselves, however near they lie; zero has no sign."""
    hi = [0.0, -0.0, 1e-300, 2e-300, 1e300, -1e300]
    table = pa.table({"asset": ["r"] * 6, "channel": ["x"] * 6, "index": range(6), "hi": hi})
    (row,) = gam_db.evaluate(table, conventions=QUICK).channels.to_pylist()
    order = [Fraction(place) for place in (2, 2, 4, 5, 6, 1)]
    assert row["mon_signed"] == pytest.approx(reference.signed_monotonicity(order, "rank")[0])


@pytest.mark.parametrize("seed", range(5))
def test_printed_numbers_of_the_simulated_machine(seed: int) -> None:
    """A value per vector, 115,001 of them: Mon, Corr and Rob as a separate NumPy count gave them."""
    parameters = gam_db.Parameters(
        m=langevin.M, tau=langevin.TAU, bins=langevin.BINS, window=langevin.WINDOW
    )
    position = langevin.simulate(seed=seed)
    series = pa.table({"t": np.arange(len(position)), "x": position})
    source = gam_db.Source(series, asset=None, channel=None, time="t", value="x")
    health = gam_db.health_indicator(
        source, parameters, gam_db.Calibration(fraction=langevin.CALIBRATION)
    )
    (row,) = gam_db.evaluate(health, conventions=QUICK).channels.to_pylist()
    assert (row["k"], row["independent_windows"]) == (115_001, 23 + 1)
    expected = {
        "mon": [0.9980, 0.9981, 0.9979, 0.9983, 0.9962],
        "corr": [0.9855, 0.9859, 0.9874, 0.9842, 0.9842],
        "rob": [0.9884, 0.9890, 0.9900, 0.9885, 0.9896],
    }
    for metric, printed in expected.items():
        assert row[metric] == pytest.approx(printed[seed], abs=5.01e-5), metric


def test_a_long_series_takes_seconds() -> None:
    """Work grows with the number of values: a plan that pairs 100,000 of them would not end."""
    k = 100_000
    hi = np.arange(k) / k
    table = pa.table({"asset": ["r"] * k, "channel": ["x"] * k, "bucket": np.arange(k), "hi": hi})
    counted = table.append_column("novel_in_window", pa.array(np.arange(k) // 20))
    conventions = gam_db.Conventions(surrogates=2, samples=10, values_per_window=5)
    for one in (table, counted):
        (row,) = gam_db.evaluate(one, conventions=conventions).channels.to_pylist()
        assert row["mon"] == pytest.approx(1, abs=1e-8)
        assert row["rob"] == pytest.approx(1, abs=1e-4)


# Chance and bootstrap


def noisy(names: list[str], size: int = 40) -> list[Series]:
    generator = np.random.default_rng(5)
    values = [[Fraction(int(v), WINDOW) for v in generator.integers(0, WINDOW + 1, size)] for _ in names]
    return [Series(name, "x", one) for name, one in zip(names, values, strict=True)]


def test_chance_is_the_metric_of_random_novelty() -> None:
    """The surrogates are what they are said to be, and their metrics those of the reference."""
    (one,) = noisy(["r"])
    conventions = gam_db.Conventions(surrogates=7, samples=0)
    (row,) = gam_db.evaluate(bucket_table([one]), conventions=conventions).channels.to_pylist()
    member = Member(1, "r", "x", 1, None, 0, 0, 0, 1, 3, WINDOW)
    drawn = sampling.surrogates(member, 40, int(sum(one.values) * WINDOW), conventions)
    assert drawn.shape == (7, 40)
    assert drawn.min() >= 0
    assert drawn.max() <= WINDOW
    rows = [
        reference.of_series(Series("r", "x", [Fraction(int(v)) for v in counts])) for counts in drawn
    ]
    for metric in ("mon", "corr", "rob"):
        found = [row[metric] for row in rows]
        assert row[f"{metric}_chance"] == pytest.approx(np.mean(found), abs=1e-12)
        assert row[f"{metric}_chance_sd"] == pytest.approx(np.std(found), abs=1e-12)


def test_surrogates_have_the_rate_and_the_overlap_of_the_series() -> None:
    """A quarter of 1,000 vectors on average; neighbours share nine tenths of their windows."""
    member = Member(1, "r", "x", 1, None, 0, 0, 0, 1, 10, 1000)
    conventions = gam_db.Conventions(surrogates=200)
    drawn = sampling.surrogates(member, 50, 50 * 250, conventions)
    assert drawn.mean() == pytest.approx(250, abs=3)
    assert drawn.std() == pytest.approx(math.sqrt(1000 * 0.25 * 0.75), rel=0.05)
    assert np.corrcoef(drawn[:, 20], drawn[:, 21])[0, 1] == pytest.approx(0.9, abs=0.05)
    assert abs(np.corrcoef(drawn[:, 20], drawn[:, 35])[0, 1]) < 0.2


def test_few_windows_make_chance_look_like_wear() -> None:
    """With 8 windows that do not overlap, random novelty has a rank correlation of 0.2 to 0.6."""
    (one,) = noisy(["r"], 78)
    conventions = gam_db.Conventions(surrogates=50)
    table = bucket_table([one], per_window=WINDOW)
    (row,) = gam_db.evaluate(table, conventions=conventions).channels.to_pylist()
    assert row["independent_windows"] == 7
    assert 0.2 < row["mon_chance"] < 0.6


def test_a_seed_means_one_answer_and_channels_do_not_change_each_other() -> None:
    def seeded(seed: int) -> gam_db.Conventions:
        return gam_db.Conventions(seed=seed, surrogates=4, samples=20)

    fleet = noisy(["a", "b", "c"])
    told = outcome_table([("a", None, None, False), ("b", None, None, False)])
    first, again, other = (
        gam_db.evaluate(bucket_table(fleet), told, conventions=seeded(seed)) for seed in (1, 1, 2)
    )
    assert first.channels == again.channels
    assert first.summary == again.summary
    assert first.channels["mon_chance"] != other.channels["mon_chance"]
    alone = gam_db.evaluate(bucket_table(fleet[2:]), conventions=seeded(1))
    assert alone.channels["mon_chance"][0] == first.channels["mon_chance"][2]


@pytest.mark.parametrize(
    ("counts", "reason"),
    [([0] * 30, "constant"), ([WINDOW] * 30, "constant"), ([5], "one_value"), ([], "no_values")],
)
def test_where_there_is_no_chance(counts: list[int], reason: str) -> None:
    table = bucket_table([Series("r", "x", [Fraction(v, WINDOW) for v in counts])])
    (row,) = gam_db.evaluate(table).channels.to_pylist()
    assert (row["mon_chance"], row["chance_reason"]) == (None, reason)


def test_intervals_are_quantiles_of_resampled_fleets() -> None:
    """Each drawing is evaluated as a fleet of its own by the reference."""
    fleet = noisy(["a", "b", "c", "d", "e"], 12)
    fates = ["failed", "failed", "failed", "healthy", "healthy"]
    for one, fate in zip(fleet, fates, strict=True):
        one.outcome = fate
    told = outcome_table([(one.asset, None, None, one.outcome == "healthy") for one in fleet])
    conventions = gam_db.Conventions(surrogates=0, samples=21, confidence=0.9)
    summary = gam_db.evaluate(bucket_table(fleet), told, conventions=conventions).summary.to_pylist()
    stratum = {"failed": 0, "healthy": 1}
    found = [
        Member(n, one.asset, "x", n, one.outcome, stratum[fate], 1, 0, 1, 3, WINDOW)
        for n, (one, fate) in enumerate(zip(fleet, fates, strict=True), 1)
    ]
    drawn: dict[int, list[Series]] = {}
    for row in sampling.drawings(found, conventions).to_pylist():
        drawn.setdefault(row["drawing"], []).extend([fleet[row["asset_no"] - 1]] * row["weight"])
    assert {len(members) for members in drawn.values()} == {5}
    assert [one.asset for one in drawn.pop(0)] == ["a", "b", "c", "d", "e"]
    samples = [reference.of_fleet(one, "rank", "range", 0, True) for one in drawn.values()]
    for row in summary:
        values = sorted(
            value for value, _ in (one[row["metric"]] for one in samples) if value is not None
        )
        place = math.floor(0.05 * (len(values) - 1) + 0.5)
        assert row["samples"] == len(values)
        assert row["lower_bound"] == pytest.approx(values[place], abs=1e-12)
        assert row["upper_bound"] == pytest.approx(values[-1 - place], abs=1e-12)


# Sizes and places


@pytest.mark.parametrize("k", [2, 19, 20, 101, 3000, 115_001, 190_000])
def test_the_largest_sums_fit_in_64_bits(k: int) -> None:
    """At the largest range that is allowed, values at its two ends in the order that sums up most."""
    spread = largest_range(k)
    index = np.arange(k)
    names = {"asset": ["r"] * k, "channel": ["x"] * k, "index": index}
    for upper in (index >= k // 2, index % 2 == 1):
        counts = spread * upper.astype(np.int64)
        table = pa.table(names | {"novel_in_window": counts, "hi": counts / spread})
        (row,) = gam_db.evaluate(table, conventions=QUICK).channels.to_pylist()
        assert row["corr_signed"] == pytest.approx(np.corrcoef(counts, index)[0, 1], abs=1e-9)


def test_what_was_found_lies_in_a_database(tmp_path: Path) -> None:
    """Names of tables work as files and Arrow tables do, and a connection keeps nothing of ours."""
    connection = duckdb.connect(str(tmp_path / "plant.duckdb"))
    fleet = bucket_table(noisy(["a", "b"]))
    connection.register("given", fleet)
    connection.execute(
        "CREATE TABLE health AS SELECT asset, channel, bucket, novel_in_window, hi FROM given"
    )
    connection.unregister("given")
    before = connection.execute("SHOW ALL TABLES").fetchall()
    found = gam_db.evaluate("health", engine=connection)
    assert found.channels == gam_db.evaluate(fleet).channels
    assert connection.execute("SHOW ALL TABLES").fetchall() == before
