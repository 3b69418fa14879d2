"""``gam run --estimator``: what is written and printed for the framework's other estimators."""

import json
from pathlib import Path

import duckdb
import pytest
from pyarrow import parquet

import gam_db
from gam_db.lab.estimators import estimator_named
from gam_db.lab.reproduce.methods import chosen
from test_cli import SMALL, gam, healthy, saved, worn

NAMES = ("centroid", "gmm", "forest", "ocsvm")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")


def plant() -> Path:
    """A healthy channel, a worn one, and one with too little to learn from."""
    return saved({("R1", "j1"): healthy(), ("R1", "j2"): worn(), ("R2", "j1"): healthy(2)})


@pytest.mark.parametrize("name", NAMES)
def test_every_channel_is_printed_and_the_scores_are_written(name: str) -> None:
    source = plant()
    result = gam("run", source, *SMALL, "--estimator", name)
    assert result.exit_code == 0, result.output
    expected = gam_db.scores(
        gam_db.Source(str(source)),
        gam_db.Parameters(m=2, window=50, stride=10, bins=10),
        gam_db.Calibration(fraction=0.5),
        estimator=name,
    )
    assert parquet.read_table(f"plant.{name}.parquet").to_pylist() == expected.to_pylist()
    lines = result.stdout.splitlines()
    shown = [line.split() for line in lines if line.startswith(("  R1", "  R2"))]
    assert [line[:2] for line in shown] == [["R1", "j1"], ["R1", "j2"], ["R2", "j1"]]
    last = {row["channel"]: row["hi"] for row in expected.to_pylist() if row["asset"] == "R1"}
    assert [line[2] for line in shown] == [f"{last['j1']:.6g}", f"{last['j2']:.6g}", "-"]
    assert last["j2"] > last["j1"]
    assert any(line.startswith("-: less than a window") for line in lines)


def test_json_and_a_table_per_stride() -> None:
    words = ("--estimator", "centroid", "--out", "r.duckdb", "--every", "stride", "--json")
    result = gam("run", plant(), *SMALL, *words)
    said = json.loads(result.stdout)
    assert (said["estimator"], said["exit_code"], said["parameters"]["m"]) == ("centroid", 0, 2)
    assert said["written"] == ["r.duckdb (table gam_health_at_buckets_centroid)"]
    with duckdb.connect("r.duckdb") as connection:
        found = connection.execute(
            "SELECT asset, channel, max(last_time), max_by(hi, bucket) "
            "FROM gam_health_at_buckets_centroid GROUP BY ALL ORDER BY ALL"
        ).fetchall()
    now = [(one["asset"], one["channel"], one["hi"]) for one in said["channels"]]
    # 600 vectors are scored: the last bucket ends with the last of them.
    assert [(asset, channel, hi) for asset, channel, _, hi in found] == now[:2]
    assert [one["scored_vectors"] for one in said["channels"]] == [600, 600, 0]
    assert now[2] == ("R2", "j1", None)


def test_an_unknown_estimator_is_refused_before_any_work() -> None:
    result = gam("run", "nothing.parquet", "--estimator", "centrod")
    assert result.exit_code == 1
    assert "did you mean 'centroid'" in result.stderr


@pytest.mark.parametrize(
    ("said", "ours"),
    [
        ("isolation_forest", "forest"),
        ("IForest", "forest"),
        ("one-class-svm", "ocsvm"),
        ("GMM", "gmm"),
        ("gaussian_mixture", "gmm"),
    ],
)
def test_other_usual_names_of_estimators_are_understood(said: str, ours: str) -> None:
    assert estimator_named(said).name == ours
    assert chosen(f"dse, {said}", []) == ["dse", ours]


def test_a_run_by_another_name_is_one_by_ours() -> None:
    result = gam("run", plant(), *SMALL, "--estimator", "Isolation_Forest")
    assert result.exit_code == 0, result.output
    assert "by forest" in result.stdout
    assert Path("plant.forest.parquet").exists()
