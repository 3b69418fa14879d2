"""``gam select``: what a user sees, as lines and as JSON, and the exit codes."""

import json
import math
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner, Result

from gam_db.cli import app

QUICK = ("--m-max", "3", "--references", "50", "--calibration-fraction", "1", "--bins", "20")


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, with a cycle and a channel that stands still."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    cycle = np.sin(np.arange(1200) * 2 * math.pi / 60) + np.random.default_rng(0).normal(0, 0.02, 1200)
    table = pa.table({"time": np.arange(1200), "cycle": cycle, "still": np.ones(1200)})
    parquet.write_table(table, "recording.parquet")
    return tmp_path


def gam(*words: str) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, list(words))


def test_a_report_says_what_to_take() -> None:
    result = gam("select", "recording.parquet", "--window", "200", *QUICK)
    assert result.exit_code == 0, result.output
    lines = result.output
    assert "chosen from the first 100 % of each channel" in lines
    assert "first minimum of mutual information" in lines
    assert "200 holds 3.3 cycles of 60 samples, which is short" in lines
    taken = next(line for line in lines.splitlines() if line.strip().startswith("take"))
    assert [word for word in taken.split() if word.startswith("--")] == [
        "--m",
        "--tau",
        "--bins",
        "--window",
    ]
    assert "--window 300" in taken
    assert "constant: did not move in 1,200 samples" in lines


def test_json_holds_choices_and_curves() -> None:
    result = gam("select", "recording.parquet", "--json", *QUICK)
    assert result.exit_code == 0, result.output
    found = json.loads(result.output)
    assert found["search"]["m_max"] == 3
    assert found["asked"]["bins"] == 20
    cycle, still = found["choices"]
    assert (cycle["channel"], cycle["tau_rule"]) == ("cycle", "first_minimum")
    assert (still["channel"], still["verdict"], still["tau"]) == ("still", "constant", None)
    assert [row["m"] for row in found["budget"] if row["channel"] == "cycle"] == [1, 2, 3]
    lags = [row["delay"] for row in found["lags"] if row["channel"] == "cycle"]
    assert lags == list(range(101))


def test_what_the_user_can_mend_ends_with_1() -> None:
    for words in (("--m-max", "1"), ("--time", "tiem"), ("--tau-by", "luck")):
        assert gam("select", "recording.parquet", *words).exit_code == 1, words
