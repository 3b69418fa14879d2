"""``gam benchmark alarms``: that it asks the product and counts what it says; never how good that is."""

import json
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.benchmark.alarms import fleets, rivals
from gam_db.lab.benchmark.alarms import programs as of_programs
from gam_db.lab.benchmark.alarms.figures import promise, shares, wear
from gam_db.lab.benchmark.alarms.plan import CALIBRATION, Plan
from gam_db.lab.benchmark.alarms.tables import Judged, Pool
from gam_db.lab.benchmark.cli_stored import benchmarks
from gam_db.lab.simulate.fleet import Fleet
from gam_db.lab.simulate.joint import wandering

PLAN = replace(Plan.quick((3, 4)), robots=4, joints=3, samples=12_000, window=100)
ALARMS = gam_db.Alarms(rate="2 per 1000 judgements", family=["*"])


@pytest.fixture(scope="module")
def read(tmp_path_factory: pytest.TempPathFactory) -> tuple[fleets.Fleets, list[Path]]:
    """Two small fleets as the benchmark reads them, and their files."""
    folder = tmp_path_factory.mktemp("fleets")
    files: list[Path] = []

    def kept(fleet: Fleet, source: gam_db.Source, read: fleets.Fleets) -> None:
        files.append(folder / f"{len(files)}.parquet")
        assert isinstance(source.relation, Path)
        assert any(name[1].startswith(f"f{fleet.seed}_") for name in read.calm)
        parquet.write_table(parquet.read_table(source.relation), files[-1])

    return fleets.read(
        PLAN, map(PLAN.fleet, PLAN.seeds), CALIBRATION, lambda _: None, on_file=kept
    ), files


def test_fleets_put_together_are_judged_as_the_product_judges_them_at_once(
    read: tuple[fleets.Fleets, list[Path]],
) -> None:
    found, files = read
    source = gam_db.Source(
        pa.concat_tables(map(parquet.read_table, files)), "asset", "channel", "time", "value"
    )
    asked = source, PLAN.parameters, CALIBRATION, ALARMS
    with DuckSession() as session:
        judged = Pool(session, found.learnt).judged(ALARMS)
    limits = gam_db.limits(*asked).to_pylist()
    assert {row["basis"] for row in limits} & {"replay", "extrapolated"}
    mine = sorted(judged.limits, key=lambda row: (row["asset"], row["channel"]))
    names = ("asset", "channel", "reason", "reference", "height", "cap", "basis", "stated_rate")
    assert [[row.get(name) for name in names] for row in mine] == [
        [row[name] for name in names] for row in limits
    ]
    episodes = gam_db.episodes(*asked)
    for name in ("onset_time", "first_time", "last_time"):
        place = episodes.column_names.index(name)
        episodes = episodes.set_column(place, name, episodes[name].cast(pa.int64()))
    assert episodes.num_rows
    assert judged.episodes == episodes.to_pylist()
    backtest = gam_db.backtest(*asked)
    told = promise(judged, {(row["asset"], row["channel"]) for row in judged.limits})
    assert told["unstated"]["judgements"] + told["judgements"] == backtest["judgements"]
    assert told["unstated"]["episodes"] + told["episodes"] == backtest["episodes"]
    assert judged.counted == backtest["by_channel"]


def test_what_wears_and_what_is_calm_is_what_the_truth_says(
    read: tuple[fleets.Fleets, list[Path]],
) -> None:
    found, _ = read
    assert len(found.wearing) == 2  # one robot of four wears
    assert not found.calm & found.wearing.keys()
    assert {int(name[1][1:].partition("_")[0]) for name in found.calm} == set(PLAN.seeds)


TRUTH = {"onset": 100, "failed_at": 200, "event": "friction"}


@pytest.mark.parametrize(
    ("opened", "share"),
    [([], None), ([90], None), ([100], None), ([150], 0.5), ([90, 120, 180], 0.2), ([300], 1.0)],
)
def test_a_joint_is_seen_by_an_episode_that_opens_after_its_onset(
    opened: list[int], share: float | None
) -> None:
    told = shares({("a", "x"): opened}, {("a", "x"): TRUTH}, {("a", "x"): "unrepresentative"})
    assert told["median"] == share
    assert told["seen"] == (share is not None)
    assert told["early"] == (share is not None and share < 0.6)
    assert told["by_kind"]["friction"] == {"joints": 1, "seen": told["seen"], "median": share}
    assert told["unseen"] == ({} if share is not None else {"unrepresentative": 1})


def limit(channel: str, **changes: object) -> dict[str, Any]:
    row = {"asset": "a", "channel": channel, "reason": None, "basis": "replay", "quarters": 8}
    return {
        **row,
        "stated_rate": 0.001,
        "order_ratio": 1000,
        "judgements_per_day": 1.0,
        **changes,
    }


def test_a_wearing_joint_without_a_limit_is_not_seen() -> None:
    judged = Judged("1 per month", [limit("x", reason="unrepresentative", basis=None)], [], [])
    told = wear(judged, {("a", "x"): TRUTH}, {})
    assert (told["joints"], told["seen"], told["unseen"]) == (1, 0, {"unrepresentative": 1})


def test_the_promise_counts_every_calm_channel() -> None:
    limits = [
        limit("x"),
        limit("y"),
        limit("loose", basis="none", stated_rate=None),
        limit("short", reason="unrepresentative", basis=None, stated_rate=None, quarters=None),
        limit("wears"),
    ]
    hits = {"x": 0, "y": 2, "loose": 7, "wears": 9}
    counted = [
        {"asset": "a", "channel": name, "judgements": 1000, "episodes": episodes}
        for name, episodes in hits.items()
    ]
    calm = {("a", name) for name in ("x", "y", "loose", "short")}
    told = promise(Judged("1 per 1000 judgements", limits, counted, []), calm)
    assert (told["episodes"], told["judgements"], told["seen"]) == (2, 2000, 0.001)
    assert told["kept"]
    assert told["unstated"] == {"channels": 1, "judgements": 1000, "episodes": 7}
    assert told["withheld"] == {"unrepresentative": 1}
    assert told["calm"] == 4
    counted[0]["episodes"] = counted[1]["episodes"] = 10
    assert not promise(Judged("1 per 1000 judgements", limits, counted, []), calm)["kept"]


@pytest.mark.parametrize(("dispersed", "times"), [(False, (0.3, 3)), (True, (5, 1000))])
def test_the_control_keeps_its_word_on_independent_vectors_only(
    dispersed: bool, times: tuple[float, float], read: tuple[fleets.Fleets, list[Path]]
) -> None:
    chance = np.random.default_rng(5)
    varied = chance.gamma(40, 0.025, (20, 1000)) if dispersed else np.ones((20, 1000))
    channels = range(20)
    names = {number: ("a", str(number)) for number in channels}
    limited = [
        {"channel_id": number, "hi_limit": 0.1, "floor": 0.0225, "vectors": 50_000}
        for number in channels
    ]
    novel = {number: chance.binomial(2500, 0.0225 * varied[number]).tolist() for number in channels}
    with DuckSession() as session:
        pool = Pool(session, read[0].learnt)
        pool.tables["limited"] = pa.Table.from_pylist(limited)
        windows = SimpleNamespace(names=names, novel=novel)
        told = rivals.control(pool, windows, 2500, set(names.values()), 0.001)  # type: ignore[arg-type]
    assert told["judgements"] == 20_000
    assert times[0] <= told["seen"] / told["stated"] <= times[1]


def test_a_drift_has_the_spread_and_forgets_in_the_time_that_are_asked_for() -> None:
    drift = wandering(0.6, 200, 400_000, np.random.default_rng(1))
    assert drift.std() == pytest.approx(0.6, rel=0.1)
    correlation = np.corrcoef(drift[:-200], drift[200:])[0, 1]
    assert correlation == pytest.approx(np.exp(-1), abs=0.08)


def test_two_products_take_turns() -> None:
    """In the first shift only noise differs; in the second one other levels are visited."""
    alone, both = (
        next(Fleet(3, 8000, shift=shift).robot(1)).readings["value"].to_numpy() for shift in (0, 4000)
    )
    apart = np.abs(alone - both) > 0.1 * (np.nanmax(alone) - np.nanmin(alone))
    assert apart[:3000].mean() < 0.2
    assert apart[-3000:].mean() > 0.5


def test_both_ways_judge_the_same_rows_of_a_line_with_products() -> None:
    """All programs are of calibration, or none that returns is: what is judged follows from that."""
    plan = replace(PLAN, seeds=(3,), robots=2, joints=1)
    told = of_programs.measure(plan, 2, 600, lambda _: None)
    without, named = told["without"], told["with"]
    assert without["channels"] == named["channels"] > 0
    assert without["wear"]["joints"] == named["wear"]["joints"]
    assert told["unjudged"] == without["vectors"] - named["vectors"] > 0
    # A channel of calm robots has a row for each product that it makes.
    assert sum(told["programs"].values()) == 2 * (named["channels"] + named["wear"]["joints"])
    assert told["programs"].keys() <= {"ready", "needs_data", "unknown"}
    lines = list(of_programs.lines(told))
    assert lines[0].startswith("Fleets 3: 2 products in shifts of 600 samples, 12,000 samples, W = 100")
    assert f"not judged with the column: {told['unjudged']:,} vectors" in lines[-1]


def test_seeds_of_programs_are_numbers() -> None:
    answer = CliRunner().invoke(benchmarks, ["programs", "--seeds", "1,x"])
    assert isinstance(answer.exception, gam_db.UserError)
    assert "--seeds is 'x'" in answer.exception.options


@pytest.mark.full
def test_all_paths_run_on_little_data() -> None:
    answer = CliRunner().invoke(benchmarks, ["alarms", "--quick", "--json"])
    assert answer.exit_code == 0, answer.stderr
    told = json.loads(answer.stdout)
    assert told["quick"]
    assert {row["form"] for row in told["promise"]} == {
        "one family",
        "a family per fleet",
        "by the table",
    }
    bases = [row["basis"] for row in told["promise"] if row["stated"]]
    assert any("replay" in basis or "extrapolated" in basis for basis in bases)
    assert any(set(basis) == {"table"} for basis in bases)
    assert [row["estimator"] for row in told["rivals"]] == ["dse", "forest", "gmm"]
    assert [row["windows"] for row in told["drift"]] == [0.5, 3, 12]
    assert {"wear", "today", "control", "shifts"} <= told.keys()


def test_quick_and_all_contradict_each_other() -> None:
    answer = CliRunner().invoke(benchmarks, ["alarms", "--quick", "--all"])
    assert isinstance(answer.exception, gam_db.UserError)
    assert "--quick runs all paths" in answer.exception.options
