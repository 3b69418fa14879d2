"""gam calibrate and gam score: from a source to the stored health indicator, and what is said of it."""

import hashlib
import json
import math
import os
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from numpy.typing import NDArray
from pyarrow import parquet
from rich.cells import cell_len
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app
from gam_db.stored.schema import migration_files

SMALL = ("--m", "2", "--window", "50", "--stride", "10", "--bins", "10")
HEALTHY = ("--calibrate", "0/599")
STATE = ("--database", "plant.duckdb")
SECRET = 987654.25
SOURCE = gam_db.Source("plant.parquet", "machine", "signal", "ts", "reading")

Series = dict[tuple[str, str], NDArray[np.float64]]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return tmp_path


def gam(*words: str) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, [*words])


def said(result: Result) -> str:
    """What a command prints, on one line."""
    return " ".join(result.stdout.split())


def figures(*words: str) -> dict[str, Any]:
    """What --json prints."""
    result = gam(*words, "--json")
    assert result.exit_code in (0, 2, 4), result.output
    found: dict[str, Any] = json.loads(result.stdout)
    assert found["exit_code"] == result.exit_code
    return found


def healthy(samples: int) -> NDArray[np.float64]:
    """A cycle that repeats exactly: calibration sees every state again and again."""
    return np.sin(np.arange(samples) % 25 / 25 * 2 * math.pi)


def worn(samples: int) -> NDArray[np.float64]:
    """The same, beyond anything calibration saw from sample 900 on."""
    return healthy(samples) + np.where(np.arange(samples) < 900, 0.0, SECRET)


def saved(samples: int, more: Series | None = None, drop: range = range(0)) -> str:
    """A file with a healthy and a worn channel, a row per reading; some times can be left out."""
    series = {("R1", "j1"): healthy(samples), ("R1", "j2"): worn(samples), **(more or {})}
    kept = np.array([time for time in range(samples) if time not in drop])
    parts = [
        pa.table(
            {
                "machine": [asset] * len(kept),
                "signal": [channel] * len(kept),
                "ts": kept,
                "reading": pa.array(values[kept], pa.float64(), from_pandas=True),
            }
        )
        for (asset, channel), values in series.items()
    ]
    parquet.write_table(pa.concat_tables(parts), "plant.parquet")
    return "plant.parquet"


def calibrated(samples: int = 800, **more: Any) -> None:
    """A plant whose two channels have a version each."""
    result = gam("calibrate", saved(samples, **more), *STATE, *SMALL, *HEALTHY)
    assert result.exit_code == 0, result.output


def buckets() -> list[tuple[Any, ...]]:
    """What readers see of the health indicator."""
    with duckdb.connect("plant.duckdb", read_only=True) as connection:
        return connection.execute(
            "SELECT asset, channel, bucket, last_tick, novel, novel_in_window FROM gam_health "
            "ORDER BY ALL"
        ).fetchall()


def of_one_run(tau: int = 1) -> list[tuple[Any, ...]]:
    """Names, times and novel vectors of the buckets of one run over all of the file, without a state."""
    parameters = gam_db.Parameters(m=2, tau=tau, window=50, stride=10, bins=10)
    calibration = gam_db.Calibration(intervals=[(0, 599)])
    table = gam_db.health_at_buckets(SOURCE, parameters, calibration)
    names = ("asset", "channel", "last_time", "novel")
    return sorted(tuple(row[name] for name in names) for row in table.to_pylist())


def stored() -> list[tuple[Any, ...]]:
    """The same of the state."""
    return [(asset, channel, time, novel) for asset, channel, _, time, novel, _ in buckets()]


def test_the_whole_path_from_a_file_to_an_alarm() -> None:
    made = gam("calibrate", saved(800), *STATE, *SMALL, *HEALTHY)
    assert (made.exit_code, made.stderr) == (0, "")
    assert "state tables gam_* were created in plant.duckdb" in said(made)
    assert "plant.duckdb, monitor default, from plant.parquet: 2 new versions of 1 asset" in said(made)
    line = next(line for line in made.stdout.splitlines() if line.startswith("  j1"))
    assert line.split()[:8] == ["j1", "1", "first", "calibration", "ready", "1", "%", "0.000"]
    first = gam("score", *STATE)
    assert (first.exit_code, first.stderr) == (0, "")
    assert "read 2 channels" in said(first)
    assert "channels: 2 ok" in said(first)
    saved(1200)
    second = gam("score", *STATE)
    assert second.exit_code == 2
    assert "channels: 1 with a proving episode, 1 ok" in said(second)
    hi = {(asset, channel, time): count for asset, channel, _, time, _, count in buckets()}
    assert hi["R1", "j1", 1199] == 0
    assert hi["R1", "j2", 1199] == 50
    assert stored() == of_one_run()


def test_a_second_run_reads_only_what_is_new() -> None:
    calibrated(5000)
    assert figures("score", *STATE)["totals"]["rows"] > 8000
    saved(5010)
    found = figures("score", *STATE)
    assert found["totals"]["rows"] < 100
    assert found["totals"]["buckets"] == 2


def test_calibrate_leaves_versions_with_the_same_settings_alone() -> None:
    calibrated()
    same = gam("calibrate", *STATE, *SMALL, *HEALTHY)
    assert same.exit_code == 0
    assert "nothing to do: every channel has a version with these settings" in said(same)
    other = figures("calibrate", *STATE, *SMALL, *HEALTHY, "--bins", "8")
    assert [(row["version_no"], row["reason"]) for row in other["new_versions"]] == [
        (2, "other settings"),
        (2, "other settings"),
    ]
    again = figures("calibrate", *STATE, *SMALL, *HEALTHY, "--bins", "8", "--again")
    assert {(row["version_no"], row["reason"]) for row in again["new_versions"]} == {(3, "asked for")}


def test_a_folder_of_files_is_calibrated_and_scored() -> None:
    """From any folder, as a path that says that it is one."""
    Path("days").mkdir()
    Path(saved(1000)).rename("days/one.parquet")
    assert gam("calibrate", "days", *STATE, *SMALL, *HEALTHY).exit_code == 0
    assert figures("score", *STATE)["totals"]["channels"] == 2
    assert figures("score", "days", *STATE, "--full")["totals"]["channels"] == 2
    assert figures("check", "days", *STATE, "--state")["differences"] == []


def test_a_calibration_that_is_not_good_enough_asks_for_attention() -> None:
    noise = np.random.default_rng(0).standard_normal(1000)
    short = np.exp(np.arange(1000) / 100)  # never where it was
    gone = np.full(1000, np.nan)
    source = saved(1000, {("R2", "fine"): noise, ("R2", "short"): short, ("R2", "gone"): gone})
    asked = ("calibrate", source, *STATE, *SMALL, *HEALTHY, "--bins", "60", "--again")
    brief = said(gam(*asked))
    assert "with further remarks: --all" in brief
    assert "grid too fine for its calibration" not in brief
    result = gam(*asked, "--all")
    assert result.exit_code == 2
    lines = result.stdout.splitlines()
    first = next(number for number, line in enumerate(lines) if line.startswith("? R2 fine"))
    assert "too_fine" in lines[first]
    assert "- R2 fine: grid too fine for its calibration" in said(result)
    assert "bins would pass" in said(result)
    assert "calibration too short" in said(result)
    assert "no usable sample in calibration" in said(result)
    assert "grid too fine: " in said(result)
    assert "nothing needs attention" not in said(result)
    assert all(cell_len(line) <= 80 for line in lines)


def test_a_recording_without_any_calibration_asks_for_attention() -> None:
    result = gam("calibrate", saved(800), *STATE, *SMALL, "--calibrate", "5000/6000")
    assert result.exit_code == 4
    assert "no_data: choose a healthy part that holds data" in said(result)
    scored = gam("score", *STATE)
    assert scored.exit_code == 4
    assert "0 of 2 channels watched" in said(scored)
    assert "nothing is watched: none of 2 channels" in said(scored)
    found = figures("score", *STATE)["data_problems"]
    assert [row["kind"] for row in found] == ["unwatched", "no_data", "no_data"]


def test_one_row_of_1970_does_not_end_with_0() -> None:
    """It takes all of the calibration, so nothing is watched; of one channel among others likewise."""
    times = [0, *range(1_767_225_600, 1_767_225_600 + 1000)]
    table = pa.table({"time": pa.array(times).cast(pa.timestamp("s")), "value": healthy(1001)})
    parquet.write_table(table, "one.parquet")
    asked = (*SMALL, "--calibration-duration", "100 s")
    for words in (("run", "one.parquet", "--no-out"), ("calibrate", "one.parquet", *STATE)):
        result = gam(*words, *asked)
        assert result.exit_code == 4, result.output
        assert "nothing needs attention" not in result.stdout
    assert [gam(command, *STATE).exit_code for command in ("score", "status")] == [4, 4]
    saved(800)
    odd = parquet.read_table("plant.parquet")
    bad = pa.table(
        {"machine": ["R1"], "signal": ["j1"], "ts": [-9_000_000], "reading": [0.0]}, odd.schema
    )
    parquet.write_table(pa.concat_tables([odd, bad]), "plant.parquet")
    result = gam("run", "plant.parquet", "--no-out", *SMALL, "--calibration-duration", "599")
    assert result.exit_code == 4, result.output
    assert "nothing needs attention" not in result.stdout


def test_a_dry_run_tells_the_ranges_and_writes_nothing() -> None:
    calibrated()
    before = hashlib.sha256(Path("plant.duckdb").read_bytes()).hexdigest()
    result = gam("score", *STATE, "--dry-run")
    assert result.exit_code == 0
    assert ["599", "2", "402"] in [line.split() for line in result.stdout.splitlines()]
    assert "would read 2 channels, 402 rows; wrote nothing" in said(result)
    found = figures("score", *STATE, "--dry-run")
    assert found["ranges"] == [{"earliest": 599, "channels": 2, "rows": 402}]
    assert (found["dry_run"], found["status"], found["channels"]) == (True, [], [])
    assert hashlib.sha256(Path("plant.duckdb").read_bytes()).hexdigest() == before


def test_rows_that_came_too_late_are_told_with_what_mends_them() -> None:
    source = saved(1000, drop=range(977, 978))
    gam("calibrate", source, *STATE, *SMALL, *HEALTHY, "--tau", "5")
    assert "later than lookback" not in said(gam("score", *STATE))
    saved(1200)
    result = gam("score", *STATE)
    assert "late: R1 j1: at least 1 row arrived later than lookback" in said(result)
    found = figures("score", *STATE)["data_problems"]
    assert [(row["kind"], row["channel"]) for row in found] == [("late", "j1"), ("late", "j2")]
    since = str(found[0]["since"])
    assert f"gam score --from {since} to score them" in said(result)
    mended = gam("score", *STATE, "--from", since)
    assert "later than lookback" not in said(mended)
    assert stored() == of_one_run(tau=5)


def test_rows_that_belong_to_no_channel_are_told() -> None:
    calibrated()
    fleet = {("R9", f"x{number}"): healthy(900) for number in range(7)}
    source = saved(900, fleet)
    rows = parquet.read_table(source)
    odd = pa.table(
        {"machine": [None, "R1"], "signal": ["j1", "j1"], "ts": [850, None], "reading": [0.0, 0.0]},
        schema=rows.schema,
    )
    parquet.write_table(pa.concat_tables([rows, odd]), source)
    result = gam("score", *STATE)
    assert all(f"unknown: R9 x{number}: " in said(result) for number in range(7))
    dry = said(gam("score", *STATE, "--dry-run"))
    assert "of 7 channels without calibration: R9 x0, R9 x1, R9 x2, R9 x3, R9 x4 and 2 more" in dry
    assert "1 row without asset or channel, left out" in said(result)
    assert "1 row without a time, left out" in said(result)
    assert {row["channel"] for row in figures("score", *STATE)["not_calibrated"]} == {
        f"x{number}" for number in range(7)
    }


def test_settings_that_changed_since_calibration_are_told() -> None:
    text = (
        "[source]\nrelation = 'plant.parquet'\ndatabase = 'plant.duckdb'\n"
        "[parameters]\nm = 2\nwindow = 50\nstride = 10\nbins = 10\n"
        "[calibration]\nintervals = [[0, 599]]\n"
    )
    Path("gam.toml").write_text(text)
    saved(800)
    assert gam("calibrate").exit_code == 0
    assert "other settings" not in said(gam("score"))
    Path("gam.toml").write_text(text + "[[override]]\nchannel = 'j2'\nbins = 12\n")
    result = gam("score")
    assert "gam.toml differs from the settings by which 1 channel learned: R1 j2" in said(result)
    assert figures("score")["other_settings"] == [{"asset": "R1", "channel": "j2"}]
    assert [row["channel"] for row in figures("calibrate")["new_versions"]] == ["j2"]
    assert "other settings" not in said(gam("score"))


def test_the_source_of_a_monitor_is_remembered_whatever_the_folder(tmp_path: Path) -> None:
    saved(800)
    columns = ("--asset", "machine", "--channel", "signal", "--where", "signal = 'j1'")
    assert gam("calibrate", "plant.parquet", *STATE, *SMALL, *HEALTHY, *columns).exit_code == 0
    (tmp_path / "elsewhere").mkdir()
    os.chdir(tmp_path / "elsewhere")
    there = ("--database", "../plant.duckdb")
    assert figures("score", *there)["totals"]["channels"] == 1
    assert len(figures("calibrate", *there, *SMALL, *HEALTHY, "--again")["new_versions"]) == 1
    os.chdir(tmp_path)
    other = gam("calibrate", "plant.parquet", *STATE, *SMALL, *HEALTHY, "--where", "signal = 'j2'")
    assert other.exit_code == 1
    assert "watches another source: its condition is" in other.stderr
    Path("plant.parquet").rename("moved.parquet")
    assert gam("score", "moved.parquet", *STATE).exit_code == 0


def test_a_wide_table_of_the_database_is_a_source() -> None:
    times = pa.array(np.arange(900) * 1_000_000).cast(pa.timestamp("us"))
    plant = pa.table({"ts": times, "a": healthy(900), "b": worn(900)})
    with duckdb.connect("plant.duckdb") as connection:
        connection.register("arrow", plant)
        connection.execute("CREATE TABLE telemetry AS SELECT * FROM arrow")
    made = figures("calibrate", "telemetry", *STATE, *SMALL, "--wide", "--no-asset", "--channel", "a")
    assert [row["channel"] for row in made["new_versions"]] == ["a"]
    assert made["source"]["columns"]["channels"] == ["a"]
    found = figures("score", *STATE, "--lookback", "5 min", "--park-after", "none")
    assert found["channels"][0]["read_to"] == "1970-01-01T00:14:59"
    assert figures("calibrate", *STATE, *SMALL)["new_versions"] == []


def test_a_monitor_in_a_schema_and_a_copy_of_it() -> None:
    place = (*STATE, "--schema", "north", "--prefix", "x_", "--name", "hall 4")
    assert gam("calibrate", saved(800), *place, *SMALL, *HEALTHY).exit_code == 0
    assert gam("score", *place, "--copy", "copy.duckdb", "--quiet").stdout == ""
    with duckdb.connect("copy.duckdb", read_only=True) as connection:
        rows = connection.execute("SELECT DISTINCT monitor FROM north.x_health").fetchall()
    assert rows == [("hall 4",)]


@pytest.mark.migrates
def test_a_state_of_an_older_gam_db_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    known = migration_files.files()
    with monkeypatch.context() as older:
        older.setattr("gam_db.stored.schema.migrations.files", lambda: known[:-1])
        assert gam("migrate", *STATE).exit_code == 0
    for words in (("calibrate", saved(800), *STATE), ("score", *STATE)):
        result = gam(*words)
        assert result.exit_code == 1
        assert "run `gam migrate`" in result.stderr


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("calibrate", "none.parquet"), "none.parquet cannot be read"),
        (("calibrate", "plants"), "There is no table"),
        (("calibrate", "plant.parquet", "--value", "readings"), "did you mean 'reading'?"),
        (("calibrate", "plant.parquet", "--bins", "0"), "bins is 0"),
        (("calibrate", "plant.parquet", "--name", "new", "--calibrate", "monday/friday"), "monday"),
        (("score", "--name", "defualt"), "(`gam calibrate` makes it); did you mean 'default'?"),
        (("score", "--from", "900"), "the newest stored bucket ends at 799"),
        (("score", "--from", "700", "--to", "650"), "that is after its end, 650"),
        (("score", "--from", "monday"), "--from is 'monday'"),
        (("score", "--lookback", "1 h"), "lookback is '1 h', but the source counts time"),
        (("score", "--channel", "nothing*"), "No channel of the monitor 'default' matches"),
        (("score", "--copy", "plant.duckdb"), "plant.duckdb is open in this session"),
        (("score", "--dry-run", "--copy", "copy.duckdb"), "--dry-run writes nothing"),
        (("score", "other.parquet"), "other.parquet cannot be read"),
        (("score", "--prefix", "x_"), "There are no state tables x_* in this database"),
    ],
)
def test_what_the_user_can_mend_is_told_in_a_line(
    words: tuple[str, ...], says: str, a_scored_plant: None
) -> None:
    result = gam(*words, *STATE)
    assert result.exit_code == 1, result.output
    assert says in result.stderr
    assert len(result.stderr.splitlines()) == 1
    assert "Traceback" not in result.stderr
    assert str(SECRET)[:6] not in result.output
    assert result.stdout == ""
    assert sorted(os.listdir()) == ["plant.duckdb", "plant.parquet"]


@pytest.fixture(scope="module")
def scored_plant(tmp_path_factory: pytest.TempPathFactory) -> tuple[bytes, bytes]:
    """The files of a plant that was scored once."""
    here = Path.cwd()
    os.chdir(tmp_path_factory.mktemp("plant"))
    try:
        calibrated(1000)
        saved(800)
        assert gam("score", *STATE).exit_code == 0
        return Path("plant.parquet").read_bytes(), Path("plant.duckdb").read_bytes()
    finally:
        os.chdir(here)


@pytest.fixture
def a_scored_plant(folder: Path, scored_plant: tuple[bytes, bytes]) -> None:
    for name, content in zip(("plant.parquet", "plant.duckdb"), scored_plant, strict=True):
        (folder / name).write_bytes(content)


def test_a_database_that_is_not_there_is_not_made_to_be_read() -> None:
    for words in (("score",), ("calibrate", "telemetry"), ("calibrate",)):
        result = gam(*words, *STATE)
        assert result.exit_code == 1
        assert "There is no database file plant.duckdb" in result.stderr
    assert os.listdir() == []


def test_a_calibration_that_cannot_begin_leaves_no_database_file() -> None:
    source = saved(800)
    for words in (("none.parquet",), (source, "--value", "readings"), (source, "--bins", "0")):
        result = gam("calibrate", *words, *STATE)
        assert result.exit_code == 1, result.output
        assert os.listdir() == [source]


def test_a_calibration_that_fails_leaves_a_database_file_that_was_there_or_has_tables(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with duckdb.connect("plant.duckdb"):
        pass
    assert gam("calibrate", "none.parquet", *STATE).exit_code == 1
    assert os.listdir() == ["plant.duckdb"]
    os.remove("plant.duckdb")

    def refused(*_: Any, **__: Any) -> None:
        raise gam_db.errors.SourceError("Something went wrong.")

    monkeypatch.setattr("gam_db.cli.calibrate.Monitor.calibrate", refused)
    result = gam("calibrate", saved(800), *STATE, "--schema", "north")
    assert "Something went wrong." in result.stderr
    assert sorted(os.listdir()) == ["plant.duckdb", "plant.parquet"]


def test_tables_of_the_state_are_not_meant_by_the_name_of_a_source(a_scored_plant: None) -> None:
    result = gam("calibrate", "telemetry", *STATE)
    assert "There is no table or view 'telemetry' in the database (files end" in result.stderr
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute("CREATE TABLE hall AS SELECT 1 AS time")
    assert "; there is 'hall'." in gam("calibrate", "telemetry", *STATE).stderr


def test_a_monitor_tells_its_status_and_its_health() -> None:
    saved(1200)
    parameters = gam_db.Parameters(m=2, window=50, stride=10, bins=10)
    calibration = gam_db.Calibration(intervals=[(0, 599)])
    with gam_db.Monitor("plant.duckdb", SOURCE, parameters, calibration) as monitor:
        assert monitor.check()["samples"].to_pylist() == [1200, 1200]
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        assert monitor.status()["status"].to_pylist() == ["proving", "ok"]
        found = monitor.health(asset="R*", channel="j?")
        rows = found.select(["asset", "channel", "bucket"]).to_pylist()
        assert rows == sorted(rows, key=lambda row: tuple(row.values()))
        assert found["hi"].to_pylist()[-1] == 1.0
        assert monitor.health(channel="j1").num_rows == found.num_rows // 2
        assert monitor.health(asset="r1").num_rows == 0
    assert len(buckets()) == found.num_rows  # the file is closed, so it can be opened again
    with gam_db.connect("plant.duckdb") as session:
        monitor = gam_db.Monitor(session, SOURCE, name="none")
        with monitor, pytest.raises(gam_db.UserError, match="no monitor 'none'"):
            monitor.health()
        assert session.relations()  # a session that was given stays open


def test_calibrate_says_what_labels_left_out() -> None:
    source = saved(1000)
    assert "left out" not in said(gam("calibrate", source, *SMALL, *HEALTHY, *STATE))
    gam("score", *STATE)
    assert gam("label", "R1", "100", "149", "maintenance", *STATE).exit_code == 0
    told = said(gam("calibrate", source, *SMALL, *HEALTHY, *STATE, "--again"))
    assert "left out of calibration, as true_fault or maintenance: 2 intervals of R1" in told


@pytest.mark.parametrize("order", ["results first", "state first"])
@pytest.mark.parametrize("inside", [False, True], ids=["a file", "a table of the same file"])
def test_results_and_a_monitor_live_in_one_file(order: str, inside: bool) -> None:
    """No table of one is taken for one of the other, however often each is written."""
    source, database = saved(1500), STATE
    if inside:
        with duckdb.connect("plant.duckdb") as connection:
            connection.execute(f"CREATE TABLE telemetry AS FROM '{source}'")
        source = "telemetry"
    ran = ("run", source, *(STATE if inside else ()), *SMALL, *HEALTHY, "--out", "plant.duckdb")
    learnt = ("calibrate", source, *database, *SMALL, *HEALTHY)
    for command in (ran, learnt) if order == "results first" else (learnt, ran):
        assert gam(*command, "--quiet").exit_code in (0, 2)
    figures("score", *STATE)
    shown = figures("status", *STATE)["channels"]
    assert [row["hi"] is None for row in shown] == [False, False]
    written = figures(*ran)["written"]
    assert written == [
        f"plant.duckdb (table gam_{name})"
        for name in ("health_indicator", "support_summary", "certificate")
    ]
    assert figures("status", *STATE)["channels"] == shown
    assert gam("check", "--state", *STATE).exit_code == 0
    with duckdb.connect("plant.duckdb") as connection:
        (count,) = connection.execute("SELECT COUNT(*) FROM gam_health_indicator").fetchall()
    with duckdb.connect() as connection:
        alone = figures("run", saved(1500), *SMALL, *HEALTHY)
        (expected,) = connection.execute(f"SELECT COUNT(*) FROM '{alone['written'][0]}'").fetchall()
    assert count == expected
    assert gam("drop", *STATE, "--yes").exit_code == 0
    with duckdb.connect("plant.duckdb") as connection:
        left = {name for (name,) in connection.execute("SHOW TABLES").fetchall()}
    assert left - {"telemetry"} == {"gam_health_indicator", "gam_support_summary", "gam_certificate"}


def test_results_never_replace_what_is_read() -> None:
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute(f"CREATE TABLE gam_certificate AS FROM '{saved(900)}'")
    refused = gam("run", "gam_certificate", *STATE, *SMALL, "--out", "plant.duckdb")
    assert refused.exit_code == 1
    assert "would be overwritten while it is read" in refused.output
