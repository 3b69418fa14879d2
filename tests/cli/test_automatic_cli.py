"""What calibration chooses, at the command line: which, why, and frozen as numbers."""

import json
import random
import tomllib
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

from gam_db import Parameters
from gam_db.cli import app

OPEN = ("--tau", "auto", "--bins", "auto", "--window", "auto", "--calibration-fraction", "0.5")


def gam(*words: str) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, words)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a source: two machines whose signal repeats every 44 samples; one drifts."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    lines = ["asset,channel,time,value"]
    for asset, rise in (("a", 0), ("b", 1)):
        for i in range(3000):
            lines.append(f"{asset},x,{i},{10 * abs(i % 44 - 22) + 7919 * i % 17 + rise * (i // 400)}")
    Path("plant.csv").write_text("\n".join(lines) + "\n")
    return tmp_path


def test_a_run_says_what_was_chosen() -> None:
    """As the NumPy reference chooses: tests/method/test_automatic.py."""
    said = gam("run", "plant.csv", *OPEN, "--no-out")
    words = " ".join(said.stdout.split())
    assert "chosen for x (2): tau 2, the smallest that is as good as the best: score 1,000" in words
    assert "of 1,000, tau 1 911; window 75, a twentieth of calibration" in words
    assert "chosen bins: 128 for 1, 16 for 1" in words
    (chosen,) = json.loads(gam("run", "plant.csv", *OPEN, "--no-out", "--json").stdout)["chosen"]
    assert (chosen["tau"], chosen["window"], chosen["scores"]["1"]) == (2, 75, 911)


def test_a_run_says_where_the_dimension_is_less() -> None:
    noise = random.Random(1)
    lines = ["time,value", *(f"{i},{noise.gauss():.4f}" for i in range(2050))]
    Path("short.csv").write_text("\n".join(lines) + "\n")
    words = " ".join(gam("run", "short.csv", *OPEN[:6], "--no-out").stdout.split())
    assert "m 2 for 1, because calibration is too short for m 3" in words
    (chosen,) = json.loads(gam("run", "short.csv", *OPEN[:6], "--no-out", "--json").stdout)["chosen"]
    assert chosen["lower"] == {"2": 1}


def test_a_version_is_frozen_with_numbers_and_the_words_are_no_other_setting() -> None:
    said = gam("calibrate", "plant.csv", "--database", "state.duckdb", *OPEN)
    assert "chosen for x (2): tau 2" in said.stdout
    again = gam("calibrate", "plant.csv", "--database", "state.duckdb", *OPEN)
    assert "nothing to do" in again.stdout
    shown = json.loads(gam("status", "--database", "state.duckdb", "--json").stdout)["channels"]
    assert [(row["asset"], row["bins"]) for row in sorted(shown, key=lambda row: row["asset"])] == [
        ("a", 128),
        ("b", 16),
    ]


def test_select_shows_the_score_of_each_delay() -> None:
    said = " ".join(gam("select", "plant.csv", "--calibration-fraction", "0.5").stdout.split())
    assert "score by delay: 1: " in said
    assert "2 siblings take tau" in said


def test_init_writes_numbers_which_run_takes() -> None:
    gam("init", "plant.csv", *OPEN)
    text = Path("gam.toml").read_text()
    written = tomllib.loads(text)
    assert {name: written["parameters"][name] for name in ("m", "tau", "window")} == {
        "m": 3,
        "tau": 2,
        "window": 75,
    }
    assert "score 1,000 of 1,000, tau 1 911" in text
    assert {written["parameters"]["bins"], *(one["bins"] for one in written["override"])} == {128, 16}
    assert "chosen bins" not in gam("run", "--no-out").stdout


def test_the_paper_is_one_word_and_an_option_beside_it_wins() -> None:
    taken = json.loads(gam("run", "plant.csv", "--paper", "--window", "60", "--no-out", "--json").stdout)
    found = {name: taken["parameters"][name] for name in ("m", "tau", "bins", "window", "range")}
    assert found == {"m": 3, "tau": 1, "bins": 100, "window": 60, "range": "min_max"}
    assert Parameters.paper(tau=4) == Parameters(m=3, tau=4, bins=100, window=5000, range="min_max")


def test_a_script_that_reads_nothing_takes_numbers() -> None:
    said = gam("compile", "plant.csv", "--tau", "auto", "--bins", "auto")
    assert said.exit_code == 1
    words = " ".join(said.stderr.split())
    assert "Calibration chooses --tau and --bins from telemetry" in words
    assert "give --tau and --bins, or calibrate first, or give --paper." in words
