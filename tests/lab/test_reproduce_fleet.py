"""The paper's tables of its fleet and its figures: end to end in small, resumed, calculated apart."""

import importlib.util
import itertools
import json
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from statistics import fmean
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import csv
from typer.testing import CliRunner

import evaluation_reference as reference
import gam_db
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.baselines import context, nets
from gam_db.lab.baselines.baseline import Effort, Learner
from gam_db.lab.evaluation import evaluate
from gam_db.lab.reproduce import (
    bootstrap,
    figures,
    fleet,
    fleet_page,
    fleet_tables,
    sensitivity,
    training,
)
from gam_db.lab.reproduce.methods import LONG_METHODS, METHODS
from gam_db.lab.reproduce.paper import TABLE2, printed
from gam_db.lab.reproduce.results import Results
from gam_db.lab.simulate.fleet import Fleet
from gam_db.study import Study

torch_needed = pytest.mark.skipif(
    importlib.util.find_spec("torch") is None,
    reason='left out: pip install "gam-db[benchmark]" to run it (the full set needs it)',
)

SMALL = replace(fleet.QUICK, samples=4_000, shift=100, window=200)
NAMES = ["dse", "centroid"]


@pytest.fixture(autouse=True)
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """The quick form of every command is smaller still."""
    for module in (fleet_tables, figures):
        monkeypatch.setattr(module, "QUICK", SMALL)


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the results of the small fleet by two methods."""
    folder = tmp_path_factory.mktemp("results")
    fleet.measured(SMALL, 0, NAMES, Results(folder), lambda text: None)
    return folder


def invoked(*words: str) -> Any:
    return CliRunner().invoke(app, list(words))


def figures_in(folder: Path) -> dict[str, Any]:
    """All results of a folder, without what no two runs have in common."""
    found = {}
    for file in sorted(folder.rglob("*.json")):
        record = json.loads(file.read_text())
        record["figures"].pop("seconds", None)
        found[file.name] = record
    return found


def test_the_fleet_is_that_of_the_paper() -> None:
    for seed in range(3):
        joints = fleet.FULL.places(seed)
        assert sum(place.fails for place in joints) == 5
        assert len({place.robot for place in joints if not place.fails}) == 16
        assert len(joints) == 5 + 16 * 6 - 1, "one joint never moves"
        assert [place.fails for place in joints] == sorted(
            (place.fails for place in joints), reverse=True
        )


def test_a_joint_alone_equals_the_joint_of_its_robot() -> None:
    simulated = Fleet(3, 2_000, shift=100)
    alone = simulated.joint(4, 5)
    among = list(simulated.robot(4))[4]
    assert alone.truth == among.truth
    assert alone.readings.drop_columns("value").equals(among.readings.drop_columns("value"))
    first, second = (one.readings["value"].fill_null(0).to_numpy() for one in (alone, among))
    assert np.array_equal(first, second, equal_nan=True)


def test_table1_from_the_command_line_and_again_from_its_files(kept: Path) -> None:
    words = ("reproduce", "table1", "--quick", "--methods", ",".join(NAMES), "--results", str(kept))
    first = invoked(*words)
    assert first.exit_code == 0, first.stderr
    for said in ("QUICK", "2 joints that failed, 2 of healthy", "Centroid", "all 4 resamples", "0.70"):
        assert said in " ".join(first.stdout.split())
    record = json.loads(next((kept / "fleet-quick").glob("centroid-0-*.json")).read_text())
    assert record["settings"]["samples"] == 4_000
    assert {"python", "duckdb", "gam-db"} <= set(record["made_with"])
    again = invoked(*words)
    assert again.stdout == first.stdout, "seconds included: nothing was run twice"


def test_the_metrics_are_those_that_the_reference_calculates(kept: Path) -> None:
    table = fleet_tables.table1(NAMES, 1, True, Results(kept), lambda text: None)
    for row in table.rows:
        courses = []
        for place in SMALL.places(0):
            file = kept / "fleet-quick" / f"{row.method}-0-{place.robot:02d}-{place.joint}.json"
            found = json.loads(file.read_text())["figures"]
            values = [Fraction(one) for one in found["hi"] if one is not None]
            outcome = "failed" if place.fails else "healthy"
            courses.append(reference.Series(place.asset, place.channel, values, outcome))
        expected = reference.of_fleet(courses, "rank", "range", 0, True)
        for metric in bootstrap.METRICS:
            # Indicators that are no counts are counted in steps of their range.
            assert row.mean[metric] == pytest.approx(expected[metric][0], abs=1e-5), metric


def test_a_resumed_run_equals_an_uninterrupted_one(kept: Path, tmp_path: Path) -> None:
    seen = []

    def show(text: str) -> None:
        seen.append(text)
        if len(seen) == 6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        fleet.measured(SMALL, 0, NAMES, Results(tmp_path), show)
    assert 0 < len(figures_in(tmp_path)) < len(NAMES) * 4
    fleet.measured(SMALL, 0, NAMES, Results(tmp_path), lambda text: None)
    whole = {name: one for name, one in figures_in(kept).items() if name.startswith(tuple(NAMES))}
    resumed = figures_in(tmp_path)
    assert len(resumed) == len(NAMES) * 4
    assert resumed == {name: whole[name] for name in resumed}


def test_the_fleet_as_it_is_has_the_metrics_of_sql(kept: Path) -> None:
    measured = fleet.measured(SMALL, 0, ["dse"], Results(kept), lambda text: None)["dse"]
    found = bootstrap.resampled(measured["channels"])
    whole = list(itertools.product(range(2), repeat=2)).index((0, 1))
    for metric in bootstrap.METRICS:
        assert found[metric][whole] == pytest.approx(measured["metrics"][metric], rel=1e-9)


def test_the_paper_is_printed_as_it_is() -> None:
    assert set(printed(1)) == set(printed(2)) == set(METHODS)
    assert set(printed(3)) == set(LONG_METHODS)
    for table in (1, 3):
        for row in printed(table).values():
            five = [row.mon, row.corr, row.rob, row.prog, row.disc]
            assert row.global_score == pytest.approx(fmean(one or 0.0 for one in five), abs=0.011)


def test_a_context_ends_at_its_vector_and_a_missing_sample_is_filled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """What a net is given, without a net: newest first, in ranges of calibration."""
    values = np.sin(np.arange(1_000) / 9)
    values[321] = np.nan
    names = {"asset": pa.array(["a"] * 1_000), "channel": pa.array(["c"] * 1_000)}
    series = pa.table({**names, "time": np.arange(1_000), "value": values})
    given: list[tuple[Any, Any]] = []

    def scores(self: Learner, of: Any, learnt: Any, following: Any) -> Any:
        given.append((learnt, following))
        return following[:, 0]

    monkeypatch.setattr(nets, "torch", lambda: None)
    monkeypatch.setattr(Learner, "scores", scores)
    parameters = gam_db.Parameters(m=3, tau=1, window=50)
    with DuckSession() as session:
        study = Study(session, gam_db.Source(series), parameters, gam_db.Calibration(fraction=0.5))
        context.add_long(study, "long_mlp", 0, Effort(1))
        health = study.table("score_bucket_health")
    ((learnt, following),) = given
    filled = np.where(np.isnan(values), values[320], values)
    low, high = np.nanmin(values[:500]), np.nanmax(values[:500])
    scaled = (filled - low) / (high - low)
    # Of the calibration vectors (from time 2 on, three of them spoilt) every tenth; a forecast reads 51.
    times = [time for time in range(2, 500) if time not in (321, 322, 323)][9::10]
    expected = [scaled[time - 50 : time + 1][::-1] for time in times if time >= 50]
    assert np.allclose(learnt, expected)
    scored = list(range(500, 1_000))
    ends = [*scored[49::50], scored[-1]]
    assert np.allclose(following, [scaled[time - 50 : time + 1][::-1] for time in ends])
    # A window is one bucket here, so the indicator is the score of its end.
    assert np.allclose(health["hi"].to_numpy(), following[:-1, 0], atol=1e-5)


def test_the_order_by_length_of_training_is_compared_with_the_papers(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """The more epochs the higher Global, from below all others to above them."""

    def figures_of(name: str, task: Any, results: Results, show: Any) -> dict[str, Any]:
        score = TABLE2[name].global_score if task.epochs is None else task.epochs / 50
        return {"global_score": score, "mon": 0.5, "corr": 0.5, "rob": 0.5, "losses": [1.0]}

    monkeypatch.setattr(training, "figures_of", figures_of)
    monkeypatch.setattr(training, "check_libraries", lambda names: None)
    study = training.training(["ae"], False, Results(tmp_path), lambda text: None)
    assert [one.epochs for one in study.lengths] == [1, 5, 20, 100]
    assert [one.order.index("ae") for one in study.lengths] == [5, 5, 5, 0]
    paper = ["forest", "dse", "gmm", "centroid", "ae", "ocsvm"]
    places = [paper.index(name) for name in study.lengths[0].order]
    assert study.lengths[0].agreement == pytest.approx(np.corrcoef(range(6), places)[0, 1])
    said = list(fleet_page.training(study))
    assert any("1 of 6" in line for line in said)
    assert any(line.strip().startswith("paper") and "5 of 6" in line for line in said)


def test_figures_are_drawn_from_results(
    kept: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scores = {(m, tau): 0.5 + m / 100 + tau / 1000 for m in (2, 3) for tau in (1, 2)}
    cells = [
        sensitivity.Cell(m, tau, score, 0.5, 0.5, 0.5, 0.1, 0.1, 0.5)
        for (m, tau), score in scores.items()
    ]
    monkeypatch.setattr(sensitivity, "DIMENSIONS", (2, 3))
    monkeypatch.setattr(sensitivity, "DELAYS", (1, 2))
    monkeypatch.setattr(sensitivity, "sensitivity", lambda *_: cells)
    words = ("--quick", "--methods", ",".join(NAMES), "--results", str(kept), "--out", str(tmp_path))
    answer = invoked("reproduce", "figures", *words)
    assert answer.exit_code == 0, answer.stderr
    drawn = {file.name: Xml.parse(file).getroot() for file in sorted(tmp_path.iterdir())}
    assert list(drawn) == [f"figure-{number}.svg" for number in (2, 3, 4, 5, 6)]
    words_of = {
        name: [one.text for one in root.iter("{http://www.w3.org/2000/svg}text")]
        for name, root in drawn.items()
    }
    assert "both; black: cells not in the support" in words_of["figure-2.svg"]
    assert {"DSE", "Centroid"} <= set(words_of["figure-3.svg"])
    assert {f"{score:.3f}" for score in scores.values()} <= set(words_of["figure-5.svg"])
    assert {"m = 3", "m = 6"} <= set(words_of["figure-6.svg"])
    for root in drawn.values():
        for one in root.iter():
            for paint in ("fill", "stroke"):
                value = one.get(paint, "none")
                assert value == "none" or value[1:3] == value[3:5] == value[5:7], "greys only"
    record = json.loads((kept / "fleet-quick" / "attractor-0.json").read_text())["figures"]
    assert record["healthy"] == sorted(map(list, {tuple(cell) for cell in record["healthy"]}))
    first, second = (Xml.tostring(drawn[f"figure-{number}.svg"]) for number in (3, 4))
    assert first != second, "two robots"


def test_outcomes_of_a_simulated_fleet_are_read_by_gam_evaluate(tmp_path: Path) -> None:
    out, outcomes = tmp_path / "fleet.parquet", tmp_path / "outcomes.csv"
    words = ("--out", str(out), "--only", "1,2,6,22", "--samples", "4000")
    answer = invoked("simulate", "fleet", *words, "--outcomes", str(outcomes))
    assert answer.exit_code == 0, answer.stderr
    assert f"outcomes: {outcomes}" in answer.stdout
    rows = csv.read_csv(outcomes).to_pylist()
    assert [row["asset"] for row in rows] == ["robot_01", "robot_02", "robot_06"], "22 is a control"
    assert [row["healthy"] for row in rows] == [True, False, False]
    assert [row["channel"] or None for row in rows] == [None, "joint_1", "joint_3"]
    health = tmp_path / "health.parquet"
    run = invoked("run", str(out), "--window", "500", "--out", str(health))
    assert run.exit_code in (0, 2), run.stderr
    told = invoked("evaluate", str(health), "--outcomes", str(outcomes), "--json", "--surrogates", "0")
    assert told.exit_code == 0, told.stderr
    channels = json.loads(told.stdout)["channels"]
    judged = [row for row in channels if row["outcome"] is not None]
    assert [row["outcome"] for row in judged] == ["healthy"] * 6 + ["failed"] * 2
    assert all(row["mon"] is not None for row in judged if row["outcome"] == "failed")
    parquet_form = invoked("simulate", "fleet", *words, "--outcomes", str(tmp_path / "outcomes.parquet"))
    assert parquet_form.exit_code == 0, parquet_form.stderr
    found = evaluate(str(health), str(tmp_path / "outcomes.parquet"))
    assert found.channels["outcome"].to_pylist() == [row["outcome"] for row in channels]


@pytest.mark.parametrize(
    ("words", "refusal"),
    [
        (("reproduce", "table1", "--methods", "long_ae"), "--methods does not know 'long_ae'"),
        (("reproduce", "table3", "--methods", "lon_ae"), "did you mean 'long_ae'"),
        (("reproduce", "training", "--methods", "dse"), "--methods does not know 'dse'"),
        (("reproduce", "figures", "--only", "7"), "it takes some of 2, 3, 4, 5, 6"),
        (("simulate", "fleet", "--out", "f.parquet", "--outcomes", "o.txt"), "in .csv or .parquet"),
        (("simulate", "fleet", "--out", "f.parquet", "--outcomes", "no/o.csv"), "there is no folder no"),
    ],
)
def test_options_are_checked(
    words: tuple[str, ...], refusal: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    answer = invoked(*words)
    assert answer.exit_code == 1
    assert refusal in " ".join(answer.stderr.split())
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "words",
    [
        ("table1", "--methods", "dse,mlp"),
        ("table3",),
        ("training",),
        ("figures", "--methods", "dse,mlp", "--only", "3"),
    ],
)
def test_a_missing_library_is_one_sentence(
    words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)  # importing it raises
    answer = invoked("reproduce", *words, "--quick", "--results", str(tmp_path))
    assert answer.exit_code == 1
    assert 'This needs torch: pip install "gam-db[benchmark]"' in answer.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.full
@torch_needed
def test_networks_from_the_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fleet_tables, "QUICK", replace(SMALL, healthy=1))
    results = ("--quick", "--results", str(tmp_path))
    for command, names in (("table1", "dse,vae_rec,vae_latent"), ("table3", None)):
        options = () if names is None else ("--methods", names)
        answer = invoked("reproduce", command, *options, *results)
        assert answer.exit_code == 0, answer.stderr
    assert "CNN-AE" in answer.stdout
    assert "Cost: the dearest" in answer.stdout
    for name in LONG_METHODS:
        for file in (tmp_path / "fleet-quick").glob(f"{name}-0-*.json"):
            found = json.loads(file.read_text())["figures"]
            values = [one for one in found["hi"] if one is not None]
            assert values
            assert np.isfinite(values).all()
            if not name.endswith("latent"):
                assert len(found["losses"]) == 2
    # The two scores of a variational autoencoder are those of one net, which is trained once.
    trained, scored = (
        [json.loads(file.read_text())["figures"]["losses"] for file in sorted(found)]
        for found in (
            (tmp_path / "fleet-quick").glob(f"{name}-0-*.json") for name in ("vae_rec", "vae_latent")
        )
    )
    assert all(len(losses) == 2 for losses in trained)
    assert scored == [[], [], []]


@pytest.mark.full
@torch_needed
def test_networks_by_length_of_training(tmp_path: Path) -> None:
    answer = invoked("reproduce", "training", "--quick", "--methods", "mlp", "--results", str(tmp_path))
    assert answer.exit_code == 0, answer.stderr
    for epochs in training.QUICK_EPOCHS:
        record = json.loads((tmp_path / "table2-quick" / f"mlp-0-{epochs}-epochs.json").read_text())
        assert record["settings"]["epochs"] == epochs
        assert len(record["figures"]["losses"]) == epochs


def test_without_healthy_joints_there_is_no_disc(kept: Path) -> None:
    table = fleet_tables.table1(["dse"], 1, True, Results(kept), lambda text: None, healthy_joints=0)
    (row,) = table.rows
    assert table.joints == (2, 0)
    assert row.mean["disc"] is None
    four = [row.mean[metric] or 0.0 for metric in ("mon", "corr", "rob", "prog")]
    assert row.mean["global"] == pytest.approx(fmean(four))
    line = next(line for line in fleet_page.fleet_table(table) if line.startswith("DSE "))
    assert line.split()[-4] == "-", "Disc"
    assert not table.paired.best["disc"]
    assert not table.paired.differences["disc"]
