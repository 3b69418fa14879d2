"""Settings that calibration chooses (both sides, section 4), against the NumPy reference."""

import math
from random import Random
from typing import Any

import pytest

import automatic_reference
import comparisons
import engines
import gam_db
import harness
import reference
from gam_db import Calibration, Override, Parameters
from gam_db.study import studied
from harness import Row


def stroke(place: int, rise: int = 0) -> float:
    """A stroke of 44 samples with some noise that repeats, and a drift where there is one."""
    return float(10 * abs(place % 44 - 22) + 7919 * place % 17 + rise * (place // 400))


def alike() -> list[Row]:
    """Two siblings that differ."""
    return [
        (asset, "x", i, stroke(i, rise)) for asset, rise in (("a", 0), ("b", 1)) for i in range(3000)
    ]


def damaged() -> list[Row]:
    """Missing samples, two segments, a strange reading, samples that stand still; another channel."""
    rows: list[Row] = []
    for i in range(2400):
        value: float | None = None if i % 97 == 13 else 1e9 if i == 500 else stroke(i)
        rows.append(("a", "x", i + 50 * (i > 1410), 40.0 if 300 < i < 340 else value))
        rows.append(("a", "y", i + 50 * (i > 1410), math.sin(i / 30)))
    return rows


def short() -> list[Row]:
    """A channel that fills grids of two coordinates, one of one, one of none; one that is constant."""
    random = Random(5)
    rows: list[Row] = []
    for i in range(900):
        rows.append(("a", "two", i, random.random()))
        rows.append(("a", "three", i, math.sin(i / 20)))
        rows.append(("a", "still", i, 1.0))
        rows.append(("a", "rising", i, float(i)))
        rows.append(("a", "empty", i, None))
        if i < 150:
            rows.append(("a", "one", i, random.random()))
    return rows


def long() -> list[Row]:
    """A channel of which four stretches are looked at."""
    random = Random(7)
    return [("a", "x", i, math.sin(i / 25) + random.gauss(0, 0.02)) for i in range(21_001)]


CASES: dict[str, tuple[list[Row], dict[str, Any], dict[str, Any]]] = {
    "siblings": (alike(), {}, {"fraction": 0.5}),
    "given bins": (alike(), {"bins": 16}, {"fraction": 0.5}),
    "given tau": (alike(), {"tau": 5, "window": 100}, {"fraction": 0.5}),
    "given window": (alike(), {"window": 60, "tau": 2, "bins": 16}, {"fraction": 0.5}),
    "another m": (alike(), {"m": 2, "least_vectors": 100}, {"fraction": 0.5}),
    "a pool": (alike(), {"stride": 7}, {"fraction": 0.5, "pool": "channel"}),
    "a pool of which one taught nothing": (
        [*alike(), *(("c", "x", i, stroke(i, 2)) for i in range(900))],
        {"target_floor": 0.3},
        {"fraction": 0.5, "pool": "channel", "overrides": {"c": Calibration(intervals=[(9000, 9001)])}},
    ),
    "damaged": (
        damaged(),
        {"max_gap": 10, "still_after": 9},
        {"fraction": 0.9, "exclude": [(200, 210)]},
    ),
    "short": (short(), {"least_vectors": 100, "target_floor": 0.1}, {"fraction": 0.8}),
    "overrides": (
        alike(),
        {"overrides": [Override(asset="b", bins=16, window=80), Override(channel="y", tau=3)]},
        {"fraction": 0.5},
    ),
}


Chosen = dict[tuple[str, str], tuple[Any, ...]]
Means = list[tuple[list[tuple[str, str]], dict[int, int]]]


def chosen(engine: str, rows: list[Row], *method: Any) -> tuple[Chosen, Means]:
    """Return what is taken for each channel, and the mean score of siblings at each delay."""
    session = engines.session(engine)
    with (
        session.lent(harness.arrow(rows)) as table,
        studied(gam_db.Source(table.name), method[0], method[1], session) as study,
    ):
        taken = {
            (row["asset"], row["channel"]): (one.m, one.tau, one.bins, one.window, one.bucket_length)
            for row in study.rows("channels")
            for one in [study.method.settings[row["settings_no"]]]
        }
        means = [
            (sorted((row["asset"], row["channel"]) for row in of.channels), of.scores)
            for of in study.siblings
        ]
    return taken, sorted(means, key=str)


def expected(rows: list[Row], *method: Any) -> tuple[Chosen, Means]:
    """The same by the reference."""
    _, pools = reference.opened(rows, *method)
    means: Means = []
    for family in automatic_reference.siblings(pools):
        scores: dict[int, int] = {}
        if "tau" in pools[family[0][0]].settings.open:
            sums, looked = automatic_reference.compared(family, pools)
            scores = {delay: total // looked for delay, total in sums.items()}
        means.append((sorted((one.asset, one.name) for _, one in family), scores))
    reference.settle(pools)
    taken = {
        (channel.asset, channel.name): (one.m, one.tau, one.bins, one.window, one.stride)
        for pool in pools
        for channel in pool.members
        for one in [pool.settings]
    }
    return taken, sorted(means, key=str)


#: What repeats another case but for a setting.
REPEATED = ("another m", "overrides")


@pytest.mark.parametrize(
    "case", [pytest.param(case, marks=pytest.mark.full) if case in REPEATED else case for case in CASES]
)
def test_the_choice(engine: str, case: str) -> None:
    rows, settings, said = CASES[case]
    everything = {"tau": "auto", "bins": "auto", "window": "auto", **settings}
    method = Parameters(**everything), Calibration(**said)
    found = chosen(engine, rows, *method)
    assert found == expected(rows, *method)
    comparisons.compared(engine, "exact", rows, *method)


@pytest.mark.full
def test_stretches_of_a_long_calibration(engine: str) -> None:
    method = Parameters(tau="auto", bins="auto", window="auto"), Calibration(fraction=1.0)
    found = chosen(engine, long(), *method)
    assert found == expected(long(), *method)
