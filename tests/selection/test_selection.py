"""Choosing tau, m, B and W: against a plain NumPy version, and against known values."""

import math
from random import Random
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from numpy.typing import NDArray
from pyarrow import compute as pc
from sqlglot import exp

import comparisons
import gam_db
import reference
from gam_db import langevin
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ParameterError, StatementError
from gam_db.selection import lags, neighbours
from gam_db.selection.lags import add_delays, add_samples
from gam_db.selection.search import Search
from gam_db.study import Study
from selection_reference import Asked, Channel, runs_of

Floats = NDArray[np.float64]
WHOLE = gam_db.Calibration(fraction=1.0)


def table(channels: dict[str, Any], times: dict[str, Any] | None = None) -> gam_db.Source:
    """A source with a row per sample, from channel -> values."""
    parts = [
        pa.table(
            {
                "channel": pa.array([name] * len(values), pa.string()),
                "time": np.asarray((times or {}).get(name, np.arange(len(values))), np.int64),
                "value": pa.array(values, pa.float64()),
            }
        )
        for name, values in channels.items()
    ]
    return gam_db.Source(pa.concat_tables(parts), asset=None)


def of(answer: pa.Table, channel: str) -> list[dict[str, Any]]:
    """The rows of one channel, without its names."""
    rows = [row for row in answer.to_pylist() if row["channel"] == channel]
    return [{k: v for k, v in row.items() if k not in ("asset", "channel")} for row in rows]


def choice(selection: gam_db.Selection, channel: str = "value") -> dict[str, Any]:
    """What was chosen for one channel."""
    (row,) = of(selection.choices, channel)
    return row


def lorenz(samples: int, step: float = 0.02) -> Floats:
    """The first coordinate of Lorenz's system, by Runge and Kutta, a thousand steps left out before."""

    def slope(state: Floats) -> Floats:
        x, y, z = state
        return np.array([10 * (y - x), x * (28 - z) - y, x * y - 8 / 3 * z])

    state, found = np.ones(3), []
    for i in range(samples + 1000):
        first = slope(state)
        second = slope(state + step / 2 * first)
        third = slope(state + step / 2 * second)
        fourth = slope(state + step * third)
        state = state + step / 6 * (first + 2 * second + 2 * third + fourth)
        if i >= 1000:
            found.append(state[0])
    return np.array(found)


def damaged(random: np.random.Generator, samples: int) -> dict[str, list[float | None]]:
    """Random and degenerate channels, with missing values here and there."""
    clock = np.arange(samples)
    smooth = np.cumsum(random.standard_normal(samples))
    logistic = np.empty(samples)
    logistic[0] = 0.3
    for i in range(1, samples):
        logistic[i] = 3.9 * logistic[i - 1] * (1 - logistic[i - 1])
    holes = np.sin(clock / 5) + 0.1 * random.standard_normal(samples)
    holes[random.integers(0, samples, 6)] = np.nan
    channels: dict[str, Any] = {
        "walk": smooth,
        "noise": random.standard_normal(samples),
        "logistic": logistic,
        "holes": holes,
        "cycle": np.round(2 * np.sin(clock * 2 * math.pi / 17)),
        "quantised": np.round(3 * np.sin(clock / 6) + 0.6 * random.standard_normal(samples)),
        "spike": np.where(clock == samples // 2, 1e6, random.standard_normal(samples)),
        "flip": clock % 2,
        "huge": np.where(clock % 9 == 4, 1e300, -1e300) * random.random(samples),
        "constant": np.full(samples, 2.5),
        "missing": np.full(samples, np.nan),
        "two": [1.0, 2.0],
        "one": [1.0],
        "few": random.standard_normal(25),
    }
    return {
        name: [None if math.isnan(x) else float(x) for x in values] for name, values in channels.items()
    }


@pytest.mark.parametrize(
    ("seed", "search", "max_gap", "calibration"),
    [
        (1, {"m_max": 4}, None, WHOLE),
        (2, {"m_max": 2, "tau": 2, "theiler": 0, "references": 40, "seed": 7}, 3, WHOLE),
        (
            3,
            {"m_max": 3, "tau_max": 9},
            2,
            gam_db.Calibration(intervals=[(5, 60), (64, 150)], exclude=[(30, 31), (100, 100)]),
        ),
    ],
)
def test_curves_and_choices_are_those_of_the_reference(
    seed: int,
    search: dict[str, Any],
    max_gap: int | None,
    calibration: gam_db.Calibration,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Neighbours through every round of the box search, against comparing all with all."""
    monkeypatch.setattr(neighbours, "BOX_CAPACITY", 0)
    most, most_vectors = (50, 90) if seed == 2 else (lags.MOST_ROWS, neighbours.MOST_VECTORS)
    monkeypatch.setattr(lags, "MOST_ROWS", most)  # of long channels only some take part
    monkeypatch.setattr(neighbours, "MOST_VECTORS", most_vectors)
    random = np.random.default_rng(seed)
    channels = damaged(random, 170)
    channels["long"] = list(np.sin(np.arange(700) / 40) + 0.2 * random.standard_normal(700))
    steps = {
        name: random.choice([1, 1, 1, 1, 1, 1, 1, 1, 1, 4], len(values))
        for name, values in channels.items()
    }
    times = {name: [int(time) for time in np.cumsum(step)] for name, step in steps.items()}
    parameters = gam_db.Parameters(max_gap=max_gap, bins=12, window=10)
    found = gam_db.select(table(channels, times), parameters, calibration, **search)
    for name, values in channels.items():
        inside = [_is_inside(time, calibration) for time in times[name]]
        kept = [math.nan if x is None else x for x, take in zip(values, inside, strict=True) if take]
        asked = Asked(**search, most=most, most_vectors=most_vectors)
        expected = Channel(np.array(kept), runs_of(times[name], inside, max_gap), asked)
        _assert_close(expected.lags, of(found.lags, name), f"{name} lags")
        _assert_close(expected.cycles, of(found.cycles, name), f"{name} cycles")
        _assert_close(expected.dimensions(), of(found.dimensions, name), f"{name} dimensions")
        chosen = choice(found, name)
        for column, value in (expected.delays() | {"cycle_length": expected.cycle()}).items():
            assert chosen[column] == value, f"{name} {column}"


def _is_inside(time: int, calibration: gam_db.Calibration) -> bool:
    if calibration.intervals is None:
        return True
    allowed = any(start <= time <= end for start, end in calibration.intervals)  # type: ignore[operator]
    return allowed and not any(start <= time <= end for start, end in calibration.exclude)  # type: ignore[operator]


def _assert_close(expected: list[dict[str, Any]], found: list[dict[str, Any]], what: str) -> None:
    assert len(expected) == len(found), what
    for left, right in zip(expected, found, strict=True):
        for column, value in left.items():
            other = right[column]
            if isinstance(value, float) and isinstance(other, float):
                # Ratios of Cao's means are of terms in units of 2^-24.
                assert math.isclose(value, other, rel_tol=1e-6, abs_tol=1e-9), (
                    what,
                    column,
                    left,
                    right,
                )
            else:
                assert value == other, (what, column, left, right)


def test_the_budget_is_the_certificate_of_each_dimension() -> None:
    """What is affordable at each m is what the reference's certificate says of that m."""
    random = np.random.default_rng(5)
    values = [float(x) for x in np.sin(np.arange(400) / 9) + 0.1 * random.standard_normal(400)]
    parameters = gam_db.Parameters(bins=14, window=20, target_floor=0.0513, max_gap=2)
    times = [int(time) for time in np.cumsum(random.choice([1] * 60 + [5], 400))]
    calibration = gam_db.Calibration(fraction=0.7)
    source = table({"x": values}, {"x": times})
    found = gam_db.select(source, parameters, calibration, tau=3, m_max=4, references=50)
    budget = of(found.budget, "x")
    assert [row["m"] for row in budget] == [1, 2, 3, 4]
    rows = [("asset", "x", time, value) for time, value in zip(times, values, strict=True)]
    for row in budget:
        same = gam_db.Parameters(m=row["m"], tau=3, bins=14, window=20, target_floor=0.0513, max_gap=2)
        (expected,) = reference.support(rows, same, calibration)
        for column in ("cells", "verdict", "finest_bins", "vectors_needed"):
            assert row[column] == expected[column], (row["m"], column)
        assert row["vectors"] == expected["calibration_vectors"]
        assert row["floor"] == pytest.approx(expected["floor"], rel=1e-9)
        comparisons.compared("duckdb", "select", rows, same, calibration)
    assert {row["verdict"] for row in budget} >= {"ready", "too_fine"}
    wanted = choice(found, "x")["m_fnn"] or parameters.m
    affordable = [row for row in budget if row["m"] <= wanted and row["finest_bins"]]
    fine = [row for row in affordable if row["finest_bins"] >= 10]
    best = (
        max(fine, key=lambda row: row["m"]) if fine else max(affordable, key=lambda r: r["finest_bins"])
    )
    chosen = choice(found, "x")
    assert (chosen["recommended_m"], chosen["recommended_bins"]) == (best["m"], best["finest_bins"])
    assert chosen["recommended_floor"] == best["finest_floor"] <= parameters.target_floor


def test_false_neighbours_of_lorenz() -> None:
    """The method's figures at tau 8, of 3,000 points: 97.8, 4.1 and 0.0 %, so m = 3.

    Compared by hand with NeuroKit2 0.2.13 on this series, with its Theiler window of 10 samples and all
    points as references, m = 1 to 6: false neighbours 98.229, 3.988, 0, 0, 0.135, 0.271 % there and
    here; Cao's E1 and E2 equal in all nine digits that our units leave. (Its test of the attractor's
    size takes the maximum norm, ours the Euclidean one; here they decide alike.) Mutual information
    equals scikit-learn's mutual_info_score of the same bins to four digits at lags 1 to 11. NeuroKit2's
    own choice of a delay bins otherwise, and is no oracle.
    """
    source = table({"value": list(lorenz(3000))})
    found = gam_db.select(source, calibration=WHOLE, tau=8, m_max=4, references=3000)
    shares = [100 * row["false_share"] for row in of(found.dimensions, "value")]
    assert shares == pytest.approx([97.8, 4.1, 0.0, 0.0], abs=0.6)
    chosen = choice(found)
    assert (chosen["m_fnn"], chosen["fnn_status"]) == (3, "fnn")
    assert (chosen["m_cao"], chosen["cao_status"]) == (3, "saturated")


@pytest.mark.parametrize("ami_bins", [16, 32, 64])
def test_the_first_minimum_of_the_langevin_system_does_not_depend_on_the_bins(ami_bins: int) -> None:
    with DuckSession() as session:
        source = table({"value": list(langevin.simulate(0))})
        healthy = gam_db.Calibration(fraction=langevin.CALIBRATION)
        study = Study(session, source, gam_db.Parameters(), healthy)
        search = Search(ami_bins=ami_bins)
        add_samples(study.steps, search, study.method.gaps[0])
        add_delays(study.steps, search, samples=80_000)
        (found,) = study.table("delays").to_pylist()
        (cycle,) = study.table("cycles").to_pylist()
    assert (found["tau"], found["tau_rule"]) == (langevin.TAU, "first_minimum")
    assert abs(cycle["cycle_length"] - 5 * langevin.DWELL) <= 8  # on a scale of 8 samples


def test_no_delay_where_samples_tell_nothing() -> None:
    random = np.random.default_rng(11)
    kinds = {
        "normal": random.standard_normal(2000),
        "uniform": random.random(2000),
        "coin": random.integers(0, 2, 2000),
        "heavy": random.standard_cauchy(2000),
        "constant": np.ones(2000),
    }
    found = gam_db.select(table(kinds), calibration=WHOLE, m_max=3, references=200)
    for name in kinds:
        chosen = choice(found, name)
        assert (chosen["tau"], chosen["tau_rule"]) == (None, "none"), name
    assert choice(found, "normal")["fnn_status"] == "noise_floor"
    assert choice(found, "normal")["cao_status"] == "stochastic"
    assert choice(found, "normal")["window_status"] == "no_cycle"
    constant = choice(found, "constant")
    assert (constant["verdict"], constant["fnn_status"], constant["cao_status"]) == (
        "constant",
        "none",
        "none",
    )


def test_a_window_of_few_cycles_is_short() -> None:
    source = table({"value": list(np.sin(np.arange(3000) * 2 * math.pi / 40))})
    parameters = gam_db.Parameters(window=150)
    found = gam_db.select(source, parameters, WHOLE, m_max=2, references=50)
    chosen = choice(found)
    assert (chosen["cycle_length"], chosen["window_status"]) == (40, "short")
    assert chosen["recommended_window"] == 200


@pytest.mark.parametrize(
    ("rows", "cycle", "asked", "window"),
    [
        (1602, 41, 150, 200),  # five cycles are 205, in hundreds 300; 1,601 vectors hold 8 of 200
        (1599, 41, 150, 199),
        (3000, None, 374, 374),  # 2,998 vectors
        (3000, None, 375, 374),
        (82, None, 100, 10),
        (79, None, 100, None),  # too short for any
        (80, None, 9, 9),
    ],
)
def test_a_window_leaves_eight_blocks(
    rows: int, cycle: int | None, asked: int, window: int | None
) -> None:
    """Of vectors with tau 1 and m 3, or with m 2 one more."""
    clock = np.arange(rows)
    values = np.sin(clock * 2 * math.pi / cycle) if cycle else np.random.default_rng(3).random(rows)
    found = gam_db.select(
        table({"value": list(values)}),
        gam_db.Parameters(window=asked),
        WHOLE,
        tau=1,
        m_max=3,
        references=20,
    )
    chosen = choice(found)
    vectors = {row["m"]: row["vectors"] for row in found.budget.to_pylist()}[chosen["recommended_m"]]
    assert vectors == rows - (chosen["recommended_m"] - 1)
    assert chosen["recommended_window"] == window
    assert window is None or vectors >= 8 * window


def test_a_later_rule_can_be_asked_for() -> None:
    source = table({"value": list(np.sin(np.arange(800) / 20))})
    found = [
        choice(gam_db.select(source, calibration=WHOLE, m_max=2, references=20, tau_by=rule))
        for rule in ("acf_1e", "acf_zero")
    ]
    assert [row["tau_rule"] for row in found] == ["acf_1e", "acf_zero"]
    # acos(1/e) * 20 and pi / 2 * 20, the next lag; the last cycle is not a whole one.
    assert [row["tau"] for row in found] == pytest.approx([24, 32], abs=1)
    assert found[0]["acf_zero"] == found[1]["tau"]


@pytest.mark.parametrize(
    ("option", "said"),
    [
        ({"tau_by": "first_minimun"}, "first_minimum"),
        ({"tau": 0}, "tau is 0"),
        ({"m_max": 1}, "m_max is 1"),
        ({"references": 2.5}, "references is 2.5"),
        ({"ami_bins": 20}, "power of two"),
    ],
)
def test_options_out_of_range_are_refused(option: dict[str, Any], said: str) -> None:
    with pytest.raises(ParameterError, match=said):
        Search(**option)


def shifted(machines: int) -> pa.Table:
    """Machines whose cycle runs three quarters of the time at one level and then at another."""
    random = Random(1)
    rows = []
    for machine in range(machines):
        for i in range(600):
            random.random()
            value = math.sin(i / 5) + random.gauss(0, 0.05) + (1.5 if i > 450 else 0)
            rows.append({"asset": f"a{machine}", "time": i, "value": value})
    return pa.Table.from_pylist(rows)


def test_many_machines_at_once_are_like_each_alone() -> None:
    """With more than 32 of them DuckDB 2.0.0 met a column of a join whose dictionary had changed."""
    plant = shifted(44)
    source = gam_db.Source(plant, channel=None)
    found = gam_db.select(source)
    assert not len(found.failures)
    assert found.choices.num_rows == 44
    own = plant.filter(pc.equal(plant["asset"], "a7"))
    alone = gam_db.select(gam_db.Source(own, channel=None))
    for name in ("choices", "lags", "dimensions", "cycles", "budget"):
        (rows, expected) = (getattr(one, name).to_pylist() for one in (found, alone))
        assert [row for row in rows if row["asset"] == "a7"] == expected, name


@pytest.mark.parametrize("wide", [False, True])
def test_a_channel_that_fails_does_not_lose_the_others(
    wide: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The engine refuses all that is asked of a source that holds one channel, and ends the session."""
    whole = DuckSession.keep

    def keep(self: DuckSession, step: str, query: exp.Query) -> exp.Table:
        made = whole(self, step, query)
        if step == "extents":
            usable = self.fetch(exp.select("usable").from_(made))
            if 300 in usable["usable"].to_pylist():
                self.connection.close()
                raise StatementError("DuckDB refused a statement: out of luck")
        return made

    monkeypatch.setattr(DuckSession, "keep", keep)
    clock = np.arange(400)
    columns: dict[str, Any] = {name: np.sin(clock / 5) for name in ("a", "bad 'one'", "c")}
    columns["bad 'one'"] = [float(x) if i < 300 else None for i, x in enumerate(np.sin(clock / 5))]
    source = (
        gam_db.WideSource(pa.table({"time": clock, **columns}), asset=None) if wide else table(columns)
    )
    found = gam_db.select(source, calibration=WHOLE, m_max=2, references=20)
    assert [row["channel"] for row in found.choices.to_pylist()] == ["a", "c"]
    (failure,) = found.failures.to_pylist()
    assert (failure["asset"], failure["channel"]) == ("asset", "bad 'one'")
    assert "out of luck" in failure["reason"]
    with pytest.raises(StatementError):
        gam_db.select(table({"bad": columns["bad 'one'"]}), calibration=WHOLE, m_max=2)


@pytest.mark.parametrize(
    "samples",
    [
        np.sin(np.arange(3000) * 2 * math.pi / 17.3),
        np.sin(np.arange(3000) * 2 * math.pi / 40),
        np.sin(np.arange(3000) * 2 * math.pi / 50),
        np.sin(np.arange(3000) * 2 * math.pi / 100),
        np.sin(np.arange(3000) * 2 * math.pi / 12.5),
        1e6 + np.sin(np.arange(3000) / 5),
        np.sin(np.arange(3000) / 50).astype(np.float32),
    ],
)
def test_a_clean_sine_unfolds_in_two_dimensions(samples: Floats) -> None:
    """Neighbours at the distance of rounding are none: before there was a unit, m was 4, or none."""
    found = gam_db.select(table({"value": list(samples)}), calibration=WHOLE, m_max=4)
    chosen = choice(found)
    assert (chosen["m_fnn"], chosen["fnn_status"]) == (2, "fnn")
