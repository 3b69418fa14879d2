"""``gam check`` and ``gam init``: what is printed, what is written, and the exit codes."""

import json
import tomllib
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner, Result

import tiny
from gam_db.cli import app, config, toml_text
from gam_db.errors import ConfigurationError
from gam_db.reading.guess import SourceSettings

SIGNAL = np.sin(np.arange(4000) * 2 * np.pi / 20) + 1e-3 * np.sin(np.arange(4000) * 0.7)
ODD = (
    "a \"b\" 'c'",
    "tab\tand\nnew line",
    "käse 測試 🤖",
    "back\\slash",
    "x = 1 # no",
    "\x7f\x01",
    "] [",
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a terminal of 100 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")
    return tmp_path


def gam(*words: str | Path) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words])


def saved(path: str = "plant.parquet", **changed: Any) -> Path:
    """A file with a pause and a missing value, some columns changed or added; None leaves one out."""
    values = SIGNAL.copy()
    values[17] = np.nan
    times = (1_770_000_000 + np.arange(len(values))) * 1_000_000
    times[500:] += 90_000_000
    usual = {
        "asset": ["R1"] * len(values),
        "channel": ["j1"] * len(values),
        "ts": times.astype("datetime64[us]"),
        "value": values,
    }
    columns = {name: column for name, column in (usual | changed).items() if column is not None}
    Path(path).parent.mkdir(exist_ok=True)
    parquet.write_table(pa.table(columns), path)
    return Path(path)


def flat(result: Result) -> str:
    return " ".join(result.stdout.split())


# gam check


def test_what_check_prints() -> None:
    result = gam("check", saved())
    assert result.exit_code == 2, result.output  # the window of 5,000 is longer than the recording
    lines = result.stdout.splitlines()
    assert lines[0].startswith("plant.parquet: 1 channel of 1 asset, 4,000 samples, time from 2026-02-")
    assert "columns: asset=asset channel=channel time=ts value=value; guessed: all" in lines
    heading = next(line for line in lines if "least" in line and "most" in line)
    row = next(line for line in lines if line.startswith("! j1 "))
    assert lines.index(next(line for line in lines if "suggested settings" in line)) < lines.index(
        heading
    )
    assert len(row) <= len(heading) <= 100
    assert " ".join(row.split()) == "! j1 4,000 1 s 1 0.025 % -1.001 1.001 3,999 - 20"
    said = flat(result)
    assert "! j1: too few samples for a window outside calibration (4,000 in all, 800 in" in said
    assert "- j1: 1 pause of 91 s (usual step 1 s)" in said
    assert "1 point marked ! must be fixed" in said
    assert 'suggested settings: max_gap = "5 s"; window = 99 (an eighth of the calibration' in said


def test_check_with_what_is_proposed_is_content() -> None:
    result = gam("check", saved(), "--window", "99", "--max-gap", "5 s")
    assert result.exit_code == 0, result.output
    assert "nothing must be fixed" in result.stdout
    assert "suggested settings" not in result.stdout
    assert "max_gap sees to it" in flat(result)
    assert gam("check", "plant.parquet", "--window", "99", "--quiet").stdout == ""


def test_check_counts_rows_that_run_refuses() -> None:
    source = saved(asset=["R1"] * 3990 + [None] * 10)
    result = gam("check", source, "--window", "100")
    assert result.exit_code == 2
    assert "! rows without an asset, channel or time: 10 without asset" in flat(result)
    assert "--where 'asset IS NOT NULL'" in flat(result)
    assert gam("run", source, "--window", "100", "--no-out").exit_code == 1
    mended = gam("check", source, "--window", "100", "--where", '"asset" IS NOT NULL')
    assert mended.exit_code == 0


def test_check_as_json() -> None:
    result = gam("check", saved(), "--json", "--window", "100", "--calibration-fraction", "0.25")
    said = json.loads(result.stdout)
    assert result.exit_code == said["exit_code"] == 0
    (channel,) = said["channels"]
    assert (channel["samples"], channel["missing"], channel["pauses"]) == (4000, 1, 1)
    assert (channel["typical_step"], channel["cycle_length"]) == (1_000_000, 20)
    subjects = {note["subject"]: note["must_be_fixed"] for note in said["notes"]}
    assert subjects == {"pauses": False, "missing": False}
    assert said["notes"][0]["channels"] == [["R1", "j1"]]
    assert said["proposal"] == {
        "max_gap": "5 s",
        "max_gap_by_channel": {},
        "window": 100,
        "window_by_channel": {},
        "still_after": None,
        "still_after_by_channel": {},
    }
    assert said["rows_without"] == {"asset": 0, "channel": 0, "time": 0}


@pytest.mark.parametrize(
    ("columns", "message"),
    [
        ({"value": ["1.5"] * 4000}, "readings must be numbers"),
        ({"ts": None}, "time"),
        ({"value": None}, "No numeric column"),
    ],
)
def test_check_of_unusable_columns(columns: dict[str, Any], message: str) -> None:
    result = gam("check", saved(**columns))
    assert result.exit_code == 1
    assert message in result.stderr


def test_check_of_an_empty_file() -> None:
    parquet.write_table(parquet.read_table(saved()).slice(0, 0), "empty.parquet")
    result = gam("check", "empty.parquet")
    assert result.exit_code == 2
    assert "! no row has a name, a time" in flat(result)


def test_names_of_a_source_do_nothing_to_the_terminal() -> None:
    result = gam("check", saved(channel=["\x1b[31mred\x07 [bold]"] * 4000), "--window", "100")
    assert "\x1b" not in result.stdout
    assert "\x07" not in result.stdout
    assert "[31mred" in result.stdout
    assert "[bold]" in result.stdout


def test_a_narrow_terminal_loses_what_says_least(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    lines = gam("check", saved(), "--window", "100").stdout.splitlines()
    assert max(map(len, lines)) <= 60
    heading = next(line for line in lines if line.startswith("  channel"))
    assert " ".join(heading.split()) == "channel samples step pauses missing least cycle"


def test_many_channels_are_cut_unless_all_are_asked_for() -> None:
    names = np.array([f"c{i:02}" for i in range(50)]).repeat(80)
    saved(channel=names)
    some, everything = gam("check", "plant.parquet"), gam("check", "plant.parquet", "--all")
    assert "and 10 more; --all" in some.stdout
    assert sum(line.startswith("! c") for line in everything.stdout.splitlines()) >= 50


# gam init


def test_what_init_writes_is_what_run_takes() -> None:
    result = gam("init", saved())
    assert result.exit_code == 0, result.output
    assert "written: gam.toml" in result.stdout
    text = Path("gam.toml").read_text(encoding="utf-8")
    assert max(map(len, text.splitlines())) <= 100
    assert "Note: j1: 1 sample" in text
    settings = config.load()
    columns = ("asset", "channel", "ts", "value")
    assert settings.source == SourceSettings("plant.parquet", None, *columns)
    assert settings.parameters["max_gap"] == "5 s"
    assert settings.parameters["window"] == 99
    assert settings.calibration == {"fraction": 0.2}
    ran = gam("run", "--no-out", "--json")
    assert ran.exit_code in (0, 2), ran.output
    (channel,) = json.loads(ran.stdout)["channels"]
    assert (channel["window"], channel["samples"]) == (99, 4000)
    assert channel["blocks"] == 8
    assert gam("check").exit_code == 0


def test_init_never_overwrites_unless_told_to() -> None:
    Path("gam.toml").write_text("mine = ", encoding="utf-8")
    result = gam("init", saved())
    assert result.exit_code == 1
    assert "gam.toml already exists; --force replaces it" in result.stderr
    assert Path("gam.toml").read_text(encoding="utf-8") == "mine = "
    assert gam("init", "plant.parquet", "--force", "--quiet").exit_code == 0
    assert config.load().source.relation == "plant.parquet"
    assert sorted(path.name for path in Path().iterdir()) == ["gam.toml", "plant.parquet"]


def test_init_refuses_a_folder_that_is_not_there() -> None:
    result = gam("init", saved(), "--out", "nowhere/gam.toml")
    assert result.exit_code == 1
    assert "the folder nowhere is not there" in result.stderr


def test_init_says_what_must_be_fixed() -> None:
    result = gam("init", saved(asset=["R1"] * 3990 + [None] * 10))
    assert result.exit_code == 2
    assert "fix 1 problem first" in result.stdout
    assert ("# MUST BE FIXED: rows without an asset, channel or time: 10 without asset") in Path(
        "gam.toml"
    ).read_text()


def test_options_given_to_init_are_kept() -> None:
    given = ["--window", "60", "--stride", "20", "--bins", "7", "--max-gap", "none"]
    where = """value <> 3 AND asset = 'R1' -- "odd\""""
    given += ["--target-floor", "0.1"]
    day = "2026-02-02"
    calibrate = ["--calibrate", f"{day}/{day}T03:20", "--exclude", f"{day}/{day}T02:41"]
    result = gam("init", saved(), *given, *calibrate, "--pool", "R*,S*", "--where", where)
    assert result.exit_code == 0, result.output
    settings = config.load()
    parameters, calibration = settings.method()
    assert (parameters.window, parameters.stride, parameters.bins) == (60, 20, 7)
    assert (parameters.max_gap, parameters.target_floor) == (None, 0.1)
    assert calibration.intervals == (("2026-02-02", "2026-02-02T03:20"),)
    assert calibration.pool == (("R*", "S*"),)
    assert settings.source.where == where
    assert "as given" in Path("gam.toml").read_text()
    assert gam("run", "--no-out").exit_code in (0, 2)


@pytest.mark.parametrize("name", ODD)
def test_odd_names_come_back_as_they_were(name: str) -> None:
    columns = {"value": None, "ts": None, "channel": None, name: SIGNAL, "t": np.arange(4000)}
    named = ("--asset", "asset", "--channel", name, "--time", "t")
    result = gam("init", saved(**columns), "--wide", *named)
    assert result.exit_code == 0, result.output
    settings = config.load()
    assert settings.source.channels == (name,)
    ran = gam("run", "--no-out", "--json")
    assert ran.exit_code in (0, 2), ran.output
    assert json.loads(ran.stdout)["channels"][0]["channel"] == name


def test_channels_with_gaps_of_their_own_get_overrides() -> None:
    parts = []
    for name, step in (('fast "1"', 1), ("slow\n2", 50)):
        times = np.arange(2000) * step
        times[1000:] += 20 * step
        parts.append(pa.table({"channel": [name] * 2000, "t": times, "value": SIGNAL[:2000]}))
    parquet.write_table(pa.concat_tables(parts), "two.parquet")
    assert gam("init", "two.parquet").exit_code == 0
    parameters, _ = config.load().method()
    assert parameters.max_gap is None
    assert [(one.channel, *one.changes().values()) for one in parameters.overrides] == [
        ('fast "1"', 5),
        ("slow\n2", 200),
    ]
    assert gam("run", "--no-out").exit_code in (0, 2)


def test_what_stands_still_is_proposed_and_written() -> None:
    values = SIGNAL.copy()
    values[100:140] = 4.5
    parquet.write_table(pa.table({"t": np.arange(4000), "value": values}), "one.parquet")
    assert "still_after = 25 (2 % of calibration at most stood still" in flat(
        gam("check", "one.parquet")
    )
    assert gam("init", "one.parquet").exit_code == 0
    parameters, _ = config.load().method()
    assert parameters.still_after == 25
    assert "suggested settings" not in flat(gam("check"))
    values[100:600] = 4.5
    parquet.write_table(
        pa.table({"channel": ["x"] * 4000, "t": np.arange(4000), "value": values}), "x.parquet"
    )
    assert gam("init", "x.parquet", "--out", "x.toml").exit_code == 0
    assert tomllib.loads(Path("x.toml").read_text())["parameters"]["still_after"] is False


def test_a_file_in_another_folder_and_a_table_of_a_database() -> None:
    saved("data/plant.parquet")
    Path("settings").mkdir()
    assert gam("init", "data/plant.parquet", "--out", "settings/one.toml").exit_code == 0
    assert 'relation = "../data/plant.parquet"' in Path("settings/one.toml").read_text()
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute("""CREATE TABLE "my ""table" AS SELECT * FROM 'data/plant.parquet'""")
    told = gam("init", 'my "table', "--database", "plant.duckdb", "--out", "settings/two.toml")
    assert told.exit_code == 0, told.output
    for file in ("one", "two"):
        ran = gam("run", "--config", f"settings/{file}.toml", "--no-out", "--json")
        assert json.loads(ran.stdout)["channels"][0]["samples"] == 4000


def test_values_as_toml() -> None:
    for of in (*ODD, "", True, False, 3, -0.1, 1e300, ["a", ["b", 1]]):
        assert tomllib.loads(f"x = {toml_text.value(of)}")["x"] == of
    with pytest.raises(ConfigurationError, match="cannot be written"):
        toml_text.value("\udc80")
    assert toml_text.comment("a\nb\x07 " * 30)[0].startswith("# a")
    assert all(line.startswith("# ") for line in toml_text.comment("a\nb = 1\n[c]\n" * 30))


# Recordings


def looked(recordings: Path, dataset: str, *words: str) -> dict[str, Any]:
    result = gam("check", recordings / dataset / "series.parquet", "--json", *words)
    said = json.loads(result.stdout)
    assert result.exit_code == 0, [note for note in said["notes"] if note["must_be_fixed"]]
    said["notes"] = {note["subject"]: note for note in said["notes"]}
    said["channels"] = {(row["asset"], row["channel"]): row for row in said["channels"]}
    return said  # type: ignore[no-any-return]


def test_the_cobot(recordings: Path) -> None:
    """About 1 Hz, 7,409 instants, one pause of 5.2 h and two of 9 s and 31 s, 1,018 missing values."""
    said = looked(recordings, "ur3_cobot")
    rows = said["channels"].values()
    assert {row["samples"] for row in rows} == {7409}
    assert {row["typical_step"] for row in rows} == {1_005_000}
    assert {row["pauses"] for row in rows} == {3}
    assert sum(row["missing"] for row in rows) == 1018
    assert said["proposal"]["max_gap"] == "5 s"
    assert said["notes"]["counter"]["channels"] == [["ur3", "cycle"]]


def test_the_hydraulic_rig(recordings: Path) -> None:
    """Two channels at 10 Hz among eight at 1 Hz, cycles of 60 s, no pause."""
    said = looked(recordings, "hydraulic_rig")
    rows = said["channels"]
    assert {channel for (_, channel), row in rows.items() if row["typical_step"] == 1} == {"FS1", "FS2"}
    assert {row["typical_step"] for row in rows.values()} == {1, 10}
    assert rows["rig", "FS1"]["cycle_length"] == pytest.approx(600, rel=0.02)
    cycles = {row["cycle_length"] for (_, name), row in rows.items() if name != "FS1"}
    assert cycles == {None, 60}
    assert {"rates"} <= set(said["notes"])
    assert said["proposal"]["max_gap"] is None


@pytest.mark.thorough
def test_the_plant(recordings: Path) -> None:
    """A break in C13, four empty instants in C14, channels that do not move in calibration."""
    said = looked(recordings, "production_plant")
    assert len(said["channels"]) == 125
    assert {asset for asset, _ in said["notes"]["pauses"]["channels"]} == {"C13"}
    assert {asset for asset, _ in said["notes"]["missing"]["channels"]} == {"C14"}
    assert {row["missing"] for (asset, _), row in said["channels"].items() if asset == "C14"} == {4}
    asleep = {tuple(name) for name in said["notes"]["constant_in_calibration"]["channels"]}
    expected = {(asset, channel) for asset in ("C8", "C9", "C13") for channel in ("L_3", "L_6")}
    assert asleep == expected | {("C14", "L_3")}


@pytest.mark.thorough
def test_the_bearings_and_the_actuators(recordings: Path) -> None:
    """Snapshots of 2,560 samples; cycles of 3,000 samples with a jump of 7,001 between them."""
    said = looked(recordings, "femto_bearings")
    for row in said["channels"].values():
        assert row["pauses"] == row["samples"] / 2560 - 1
    assert 1 <= said["proposal"]["max_gap"] < 509_441
    said = looked(recordings, "hydraulic_actuators")
    for (_, name), row in said["channels"].items():
        assert (row["typical_step"], row["shortest_pause"], row["longest_pause"]) == (1, 7001, 7001)
        assert row["pauses"] == row["samples"] / 3000 - 1
        if name == "Temp_1":
            assert row["cycle_length"] == pytest.approx(3000, rel=0.02)
    assert "few_cycles" in said["notes"]


def series(**lengths: int) -> str:
    """Write channels of so many samples without a cycle, and return the file."""
    noise = np.random.default_rng(0).random(2000).tolist()
    rows = [
        {"asset": "R1", "channel": name, "time": time, "value": noise[time]}
        for name, count in lengths.items()
        for time in range(count)
    ]
    parquet.write_table(pa.Table.from_pylist(rows), "lengths.parquet")
    return "lengths.parquet"


WHOLE_OF_IT = ("--m", "2", "--tau", "1", "--bins", "4", "--calibration-fraction", "0.5")


@pytest.mark.parametrize(("samples", "window"), [(162, 10), (160, None), (1618, 40), (60, None)])
def test_init_leaves_eight_blocks_or_says_that_calibration_is_too_short(
    samples: int, window: int | None
) -> None:
    """81 samples of calibration are 80 vectors, 8 windows of 10; one less is too short for any."""
    with tiny.as_delivered():
        done = gam("init", series(x=samples), *WHOLE_OF_IT)
        written = config.load().parameters
    if window is None:
        assert written["window"] == "auto"
        words = "calibration is too short for any: 8 windows of 10 vectors take 81 samples, and it has"
        assert f"no window: {words} {samples // 2}; calibrate longer" in flat(done)
        assert words in " ".join(Path("gam.toml").read_text().replace("#", " ").split())
    else:
        assert written["window"] == window
        assert "no window" not in done.stdout
        assert samples // 2 - 1 >= 8 * window
    (channel,) = json.loads(gam("run", "--no-out", "--json").stdout)["channels"]
    assert channel["calibration_vectors"] == samples // 2 - 1
    assert window in (None, channel["window"])


def test_init_gives_a_shorter_channel_a_window_of_its_own() -> None:
    with tiny.as_delivered():
        done = gam("init", series(a=2000, b=2000, c=300, d=40, e=2000), *WHOLE_OF_IT)
        assert done.exit_code in (0, 2), done.output
        parameters = config.load().method()[0]
    windows = {name: parameters.of("R1", name).window for name in "abcde"}
    assert windows == {"a": 50, "b": 50, "c": 18, "d": 50, "e": 50}, "149 vectors: 8 windows of 18"
    said = " ".join(Path("gam.toml").read_text().replace("#", " ").split())
    assert "calibration of 1 channel is too short for any window" in said
