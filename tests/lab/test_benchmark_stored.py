"""``gam benchmark stored|incremental|memory`` at a tiny size: form, figures and scans, never speed."""

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import duckdb
import pytest
from typer.testing import CliRunner

import speed_page
from gam_db.cli import app
from gam_db.engines.clickhouse.driver import folder
from gam_db.errors import ConfigurationError, InternalError
from gam_db.lab.benchmark import stored_run, workload
from gam_db.lab.benchmark.cli_stored import benchmarks
from gam_db.lab.benchmark.engines import EMBEDDED
from gam_db.lab.benchmark.incremental import AIM, GAINS, RATIOS, SIDES
from gam_db.lab.benchmark.stored_run import FIRST, HOUR, SILENT, StoredJob

pytestmark = pytest.mark.thorough

CHANNELS = 2
ROWS = (20_000, 100_000)  # the larger fills more than one row group


def invoked(*words: str) -> Any:
    return CliRunner().invoke(benchmarks, words)


@pytest.fixture(scope="module")
def figures() -> dict[str, Any]:
    """What ``gam benchmark incremental --json`` prints at a tiny size."""
    sizes = ",".join(map(str, ROWS))
    answer = invoked(
        *("incremental", "--rows", sizes, "--channels", str(CHANNELS), "--repeat", "1"),
        *("--threads", "1", "--json"),
    )
    assert answer.exit_code == 0, answer.stderr
    read: dict[str, Any] = json.loads(answer.stdout)
    return read


def test_an_hour_is_read_and_no_more(figures: dict[str, Any]) -> None:
    sides = figures["sides"]
    assert tuple(sides) == SIDES
    lookback = figures["workload"]["lookback_ticks"]
    stride = figures["workload"]["stride"]
    for name, side in sides.items():
        if name == "script":
            again = side["new_buckets"] - sides["large"]["new_buckets"]
            assert 0 < again <= CHANNELS * (lookback // stride + 1), "gam-db leaves those as they are"
            continue
        new = HOUR * CHANNELS
        assert new < side["rows_in_range"] <= new + (CHANNELS + 1) * (lookback + 3 * stride)
        assert side["new_buckets"] >= new // stride - CHANNELS
        assert (side["channels"], side["parked"], side["queries"]) == {
            "parked": (CHANNELS, 1, 1),
            "quiet": (CHANNELS + 1, 0, 2),
        }.get(name, (CHANNELS, 0, 1))
        for scan in side["scans"]:
            assert any(">=" in text for text in scan["filters"])
            assert scan["rows_found"] <= scan["rows_scanned"]
    assert sides["large"]["rows_in_range"] == sides["small"]["rows_in_range"]


def test_the_page_shows_an_hour(figures: dict[str, Any]) -> None:
    lines = speed_page.hour(figures)
    assert lines[0] == "| side | seconds | rows in range | rows scanned |"
    assert [line.split()[1] for line in lines[2 : 2 + len(SIDES)]] == list(SIDES)
    ratio = figures["gains"]["script_over_large"]
    assert lines[-1] == f"| script over large | {ratio:.2f} | at least 1.0 |"


def test_ratios_are_quotients_of_the_least_processor_seconds(figures: dict[str, Any]) -> None:
    seconds = {side: one["processor_seconds"]["min"] for side, one in figures["sides"].items()}
    assert figures["aim"] == AIM
    for name, (above, below) in RATIOS.items():
        assert figures["ratios"][name] == pytest.approx(seconds[above] / seconds[below], abs=1e-3)
    for name, (above, below, aim) in GAINS.items():
        assert figures["gains"][name] == pytest.approx(seconds[above] / seconds[below], abs=1e-3)
        assert figures["gain_aims"][name] == aim


def test_the_telemetry_takes_turns_and_falls_silent(tmp_path: Path) -> None:
    source = tmp_path / "telemetry.duckdb"
    job = StoredJob("telemetry", str(source), channels=7, history=400, long_silent=100, short_silent=300)
    stored_run.done(job)
    with duckdb.connect(str(source), read_only=True) as connection:
        rows = connection.sql(
            "SELECT asset, COUNT(*), COUNT(DISTINCT (channel, t)), COUNT(DISTINCT channel), MIN(t), "
            "COUNT(DISTINCT value) FROM readings GROUP BY asset ORDER BY asset"
        ).fetchall()
        (unsorted,) = connection.sql(
            "SELECT COUNT(*) FROM (SELECT t < LAG(t) OVER () AS back FROM readings) WHERE back"
        ).fetchall()
    ticks = 400 + HOUR
    assert [row[:4] for row in rows] == [
        ("robot_0001", 6 * ticks, 6 * ticks, 6),
        ("robot_0002", ticks, ticks, 1),
        (SILENT[0], 100, 100, 1),
        (SILENT[1], 300, 300, 1),
    ]
    assert {row[4] for row in rows} == {FIRST}
    assert all(row[5] > 50 for row in rows)
    assert unsorted == (0,)


def test_stored_and_exact_hold_the_same_integers(tmp_path: Path) -> None:
    answer = invoked(
        *("stored", "--channels", "2", "--samples", "7000", "--repeat", "1", "--threads", "1"),
        *("--order", "time", "--json"),
    )
    assert answer.exit_code == 0, answer.stderr
    figures = json.loads(answer.stdout)
    (case,) = figures["cases"]
    (row,) = speed_page.stored(figures)[2:]
    assert row.startswith("| by time | 1 | ")
    assert case["integers_equal"]
    assert case["buckets"] == 2 * (7000 * 4 // 5 // 100)
    seconds = {name: one["median"] for name, one in case["seconds"].items()}
    assert seconds["calibrate"] + seconds["score"] < seconds["stored"]
    processor = {name: one["min"] for name, one in case["processor_seconds"].items()}
    for name, side in (("stored_over_exact", "exact"), ("stored_over_exact_whole", "exact_whole")):
        assert case[name] == pytest.approx(processor["stored"] / processor[side], abs=1e-3)
    assert {"identified", "visited", "writing"} <= case["score_steps"].keys()
    assert {"visits", "writing"} <= case["calibrate_steps"].keys()


def test_one_wrong_bucket_is_found(tmp_path: Path) -> None:
    job = StoredJob("compare", str(tmp_path / "source.duckdb"), str(tmp_path / "state.duckdb"), 1)
    workload.store(Path(job.source), "time", 1, 2_000)
    stored_run.done(replace(job, task="from_nothing"))
    stored_run.done(job)
    with duckdb.connect(job.state) as connection:
        connection.execute("UPDATE gam_state_bucket SET novel = novel + 1 WHERE bucket_no = 3")
    with pytest.raises(InternalError, match="disagree in the column novel"):
        stored_run.done(job)
    with pytest.raises(InternalError, match="no task 'nothing'"):
        stored_run.done(replace(job, task="nothing"))


def test_little_memory_for_people() -> None:
    answer = invoked("memory", "--rows", "20000", "--channels", "2", "--memory-limit", "300MB")
    assert answer.exit_code == 0, answer.stderr
    for words in ("20,000 rows of 2 channels", "memory_limit 300MB", "rows/s", "peak memory"):
        assert words in answer.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("incremental", "--rows", "1000000"), "two different numbers"),
        (("incremental", "--rows", "9,8"), "two numbers in order"),
        (("incremental", "--rows", "a,b"), "positive integers"),
        (("memory", "--rows", "9"), "at least"),
        (("stored", "--order", "chanel"), "did you mean 'channel'"),
        (("--only", "floor"), "does not know 'floor'"),
    ],
)
def test_options_are_checked(options: tuple[str, ...], words: str) -> None:
    answer = invoked(*options)
    assert isinstance(answer.exception, ConfigurationError)
    assert words in str(answer.exception)


def test_throughput_is_what_is_measured_without_a_word() -> None:
    listed = CliRunner().invoke(app, ["benchmark", "--help"])
    for command in ("throughput", "stored", "incremental", "memory"):
        assert command in listed.stdout
    for words in (["benchmark", "-h"], ["benchmark", "throughput", "--help"]):
        assert CliRunner().invoke(app, words).exit_code == 0


def test_engines_are_compared_on_equal_integers() -> None:
    words = ("engines", "duckdb", "sqlite", "--channels", "2", "--samples", "12000", "--repeat", "1")
    answer = invoked(*words, "--json")
    assert answer.exit_code == 0, answer.stderr
    figures = json.loads(answer.stdout)
    first, second = figures["cases"]
    head, _, *rows = speed_page.engines(figures)
    assert head == "| engine | gam | extract | floor | gam / floor | extract / gam |"
    assert [row.split()[1] for row in rows[:2]] == ["duckdb", "sqlite"]
    assert (first["engine"], second["engine"]) == ("duckdb", "sqlite")
    assert first["sums"] == second["sums"]
    assert first["sums"]["novel"] > 0
    seconds = {program: spread["min"] for program, spread in first["processor_seconds"].items()}
    assert first["gam_over_floor"] == pytest.approx(seconds["gam"] / seconds["floor"], abs=1e-3)
    assert first["extract_over_gam"] == pytest.approx(seconds["extract"] / seconds["gam"], abs=1e-3)


def test_a_password_is_kept_from_the_list_of_processes() -> None:
    answer = invoked("engines", "postgresql://me:secret@nowhere/db")
    assert isinstance(answer.exception, ConfigurationError)
    assert "PGPASSWORD" in str(answer.exception)
    assert "secret" not in str(answer.exception)


def test_the_folder_of_clickhouse_is_the_one_that_is_given(tmp_path: Path) -> None:
    """An address with one slash less would mean a folder below the current one."""
    address = EMBEDDED["clickhouse"].format(folder=tmp_path)
    assert folder(address, writable=True)["path"] == str(tmp_path / "chdb")
