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
from gam_db.cli.config import Settings, load
from gam_db.settings.parameters import pattern_matches
from gam_db.settings.patterns import grouped

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
    said = "147: an eighth of calibration, so that it has 8 blocks; 300 need a longer calibration"
    assert said in lines, "of 1,200 samples"
    taken = next(line for line in lines.splitlines() if line.strip().startswith("take"))
    assert [word for word in taken.split() if word.startswith("--")] == [
        "--m",
        "--tau",
        "--bins",
        "--window",
    ]
    assert "--window 147" in taken
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


def met(settings: Settings, channel: str) -> dict[str, object]:
    """What the first override that names a channel says."""
    return next(one.changes() for one in settings.overrides if pattern_matches(one.channel, channel))


def test_what_is_written_says_what_was_chosen() -> None:
    """Read back, every channel has what the page says; what the file says beside stays as it was."""
    Path("gam.toml").write_text(
        '# kept\n[source]\ntime = "time"\n\n[[override]]\nchannel = "st*"\nmax_gap = 7\nbins = 9\n\n'
        "[calibration]\nfraction = 0.9\n"
    )
    result = gam(
        "select", "recording.parquet", "--window", "200", *QUICK, "--write", "gam.toml", "--json"
    )
    assert result.exit_code == 0, result.output
    cycle = json.loads(result.output)["choices"][0]
    text = Path("gam.toml").read_text()
    settings = load(Path("gam.toml"))
    assert "# kept" in text
    assert settings.calibration == {"fraction": 0.9}
    assert "# 1 channel. tau: first minimum of mutual information." in text
    assert "window: at most an eighth of calibration" in " ".join(text.replace("#", " ").split())
    assert met(settings, "cycle") == {
        "m": cycle["recommended_m"],
        "tau": cycle["tau"],
        "bins": cycle["recommended_bins"],
        "window": 147,
    }
    assert met(settings, "still") == {"max_gap": 7}
    again = gam("select", "recording.parquet", "--window", "200", *QUICK, "--write", "gam.toml")
    assert again.exit_code == 0, again.output
    assert "written: gam.toml; read it, then: gam run\n" in again.output
    assert "gam.toml has another calibration than the one used here" in again.output
    assert Path("gam.toml").read_text() == text


def test_a_file_that_is_not_there_is_begun_and_one_of_another_form_is_left() -> None:
    words = ("select", "recording.parquet", "--window", "200", *QUICK, "--write")
    assert gam(*words, "new.toml").exit_code == 0
    settings = load(Path("new.toml"))
    assert settings.parameters == {"bins": 20, "window": 200}
    assert settings.calibration == {"fraction": 1}
    assert len(settings.overrides) == 1
    shown = gam(*words, "new.toml").output
    assert "then: gam run --config new.toml" in shown
    assert "another calibration" not in shown
    Path("odd.toml").write_text("override = [{ bins = 7 }]\n")
    refused = gam(*words, "odd.toml")
    assert refused.exit_code == 1
    assert "in a form that gam-db cannot replace" in refused.output
    assert Path("odd.toml").read_text() == "override = [{ bins = 7 }]\n"
    assert "the folder nowhere is not there" in gam(*words, "nowhere/gam.toml").output


def test_the_calibration_of_one_machine_is_written_down() -> None:
    words = ("--calibrate", "0/800", "--calibrate", "r*=0/900", "--calibrate", "r*=950/999")
    chosen = gam("select", "recording.parquet", *QUICK[:4], *words, "--write", "new.toml")
    assert chosen.exit_code == 0, chosen.output
    assert gam("init", "recording.parquet", *words).exit_code in (0, 2)
    for file in ("new.toml", "gam.toml"):
        calibration = load(Path(file)).method()[1]
        assert calibration.intervals == (("0", "800"),)
        (rule,) = calibration.overrides.values()
        assert rule is not None
        assert gam("run", "--config", file, "recording.parquet", "--no-out").exit_code in (0, 2)
        assert rule.intervals == (("0", "900"), ("950", "999"))
    Path("other.toml").write_text(
        '[calibration]\nfraction = 0.9\n[calibration.overrides."a*"]\nduration = 900\n'
        "exclude = [[3, 5]]\n[calibration.overrides]\nb = false\n"
    )
    copied = ("--config", "other.toml", "--write", "copy.toml")
    assert gam("select", "recording.parquet", *QUICK[:4], *copied).exit_code == 0
    assert load(Path("copy.toml")).method()[1] == load(Path("other.toml")).method()[1]


def test_init_writes_what_is_chosen() -> None:
    result = gam("init", "recording.parquet", "--select")
    assert result.exit_code == 0, result.output
    taken = json.loads(gam("select", "--json").output)["choices"][0]
    of_cycle = met(load(Path("gam.toml")), "cycle")
    assert of_cycle["m"] == taken["recommended_m"]
    assert of_cycle["bins"] == taken["recommended_bins"]
    assert gam("run", "--window", "100").exit_code in (0, 2)


def test_a_pool_is_given_one_choice() -> None:
    random = np.random.default_rng(1)
    clock = np.arange(900)
    parts = [np.sin(clock / speed) + random.normal(0, 0.02, 900) for speed in (5, 9, 14)]
    table = {
        "asset": np.repeat(["a", "b", "c"], 900),
        "time": np.tile(clock, 3),
        "x": np.concatenate(parts),
    }
    parquet.write_table(pa.table(table), "pool.parquet")
    Path("gam.toml").write_text('[calibration]\npool = "channel"\n')
    result = gam("select", "pool.parquet", *QUICK, "--write", "gam.toml", "--json")
    assert result.exit_code == 0, result.output
    taus = sorted(row["tau"] for row in json.loads(result.output)["choices"])
    (override,) = load(Path("gam.toml")).overrides
    assert len(set(taus)) > 1
    assert override.changes()["tau"] == taus[1]


@pytest.mark.parametrize(
    ("said", "patterns"),
    [
        ({"a x": 1, "b x": 1}, 1),
        ({"a x": 1, "b x": 1, "a y": 2, "b y": 2, "a z": 1, "b z": 1}, 2),
        ({"a x": 1, "a y": 1, "b x": 2, "b y": 2, "c x": 1, "c y": 3}, 3),
        ({"a* x": 1, "ab x": 2, "ac x": 2}, 3),
    ],
)
def test_few_patterns_say_the_same(said: dict[str, int], patterns: int) -> None:
    names = {tuple(name.split()): of for name, of in said.items()}
    rules = grouped({(asset, channel): of for (asset, channel), of in names.items()})
    assert len(rules) == patterns
    for name, wanted in names.items():
        assert next(of for rule, of in rules if all(map(pattern_matches, rule, name))) == wanted
