"""``gam benchmark`` at a tiny size: its form, its integers and its arithmetic, never its speed."""

import hashlib
import json
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pytest
import typer
from typer.testing import CliRunner

import speed_page
from gam_db.errors import ConfigurationError, InternalError
from gam_db.lab.benchmark import alone, equal, extract, inside, workload
from gam_db.lab.benchmark.cli import benchmark
from gam_db.lab.benchmark.measure import RATIOS, Plan, measure
from gam_db.lab.benchmark.program_run import PROGRAMS

pytestmark = pytest.mark.thorough

# Enough for a full window of 5,000 scored vectors, and a last bucket that is not full.
CHANNELS, SAMPLES = 2, 8_050


def invoked(*options: str) -> Any:
    app = typer.Typer()
    app.command()(benchmark)
    return CliRunner().invoke(app, options)


@pytest.fixture(scope="module")
def figures() -> dict[str, Any]:
    """What ``--json --explain`` prints at a tiny size."""
    answer = invoked(
        *("--channels", str(CHANNELS), "--samples", str(SAMPLES), "--repeat", "1", "--threads", "1"),
        *("--explain", "--json"),
    )
    assert answer.exit_code == 0, answer.stderr
    read: dict[str, Any] = json.loads(answer.stdout)
    assert tempfile.gettempdir() not in answer.stdout
    return read


def test_the_page_has_a_row_for_each_case(figures: dict[str, Any]) -> None:
    lines = speed_page.throughput(figures)
    assert [line.split(" | ")[:2] for line in lines[2:]] == [["| by channel", "1"], ["| by time", "1"]]
    assert f"{figures['cases'][0]['extract_over_sql']:.2f} (" in lines[2]
    assert "| visited | " in "\n".join(speed_page.steps(figures))


def test_tables_of_the_page_are_replaced_between_their_marks() -> None:
    page = speed_page.PAGE.read_text(encoding="utf-8")
    for table in speed_page.TABLES:
        page = speed_page.written(page, table, [f"| {table} |"])
        assert f"<!-- {table} -->\n\n| {table} |\n\n<!-- end of {table} -->" in page
    with pytest.raises(ValueError, match="marks of nothing"):
        speed_page.written(page, "nothing", [])


def test_every_case_has_every_figure(figures: dict[str, Any]) -> None:
    assert [case["case"] for case in figures["cases"]] == ["channel-1", "time-1"]
    assert figures["workload"]["rows"] == CHANNELS * SAMPLES
    assert set(figures["versions"]) == {"gam_db", "duckdb", "numpy", "python"}
    assert figures["cores"] >= 1
    for case in figures["cases"]:
        for of in ("processor_seconds", "seconds", "peak_memory"):
            assert list(case[of]) == list(PROGRAMS)
            for spread in case[of].values():
                assert 0 < spread["min"] <= spread["median"] <= spread["max"]
                assert len(spread["runs"]) == figures["repeat"]
        assert {"bucket_health", "novel_cells"} <= case["steps"].keys()
        assert "WINDOW" in {operator["operator"] for operator in case["operators"]}


@pytest.mark.parametrize(
    ("ending", "figure", "key"), [("", "processor_seconds", "min"), ("_by_clock", "seconds", "median")]
)
def test_ratios_are_quotients_of_printed_figures(
    figures: dict[str, Any], ending: str, figure: str, key: str
) -> None:
    for case in figures["cases"]:
        for name, (above, below) in RATIOS.items():
            quotient = case[figure][above][key] / case[figure][below][key]
            assert case[name + ending] == pytest.approx(quotient, abs=1e-3)


@pytest.mark.parametrize(
    ("task", "begun"),
    [("gam", "begin_process"), ("from_nothing", "begin_process"), ("extract", "hide_pandas")]
    + [(floor, "hide_pandas") for floor in ("floor", *PROGRAMS) if floor.startswith("floor")],
)
def test_only_our_side_begins_as_a_command_does(
    task: str, begun: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A script that is measured beside it has Python's own collector."""
    called: list[str] = []
    for name in ("begin_process", "hide_pandas"):
        monkeypatch.setattr(alone, name, lambda name=name: called.append(name))
    monkeypatch.setattr(sys, "argv", ["run", json.dumps({"task": task})])
    alone.answer(lambda job: {"done": json.loads(job)["task"]})
    assert (called, json.loads(capsys.readouterr().out)) == ([begun], {"done": task})


def test_processes_that_were_started_count() -> None:
    """Those at work still and those that have ended; a child that idles adds next to nothing."""
    burn = "import time; end = time.process_time() + 0.3\nwhile time.process_time() < end: pass"
    ended = alone.measured(lambda: {"code": subprocess.run([sys.executable, "-c", burn]).returncode})
    assert 0.3 <= ended["processor_seconds"] < 3
    if not Path("/proc/self/stat").exists():
        return
    with subprocess.Popen(
        [sys.executable, "-u", "-c", f"{burn}\nprint('done'); input()"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    ) as child:
        assert child.stdout is not None
        alive = alone.measured(lambda: {"said": child.stdout and child.stdout.readline()})
        child.communicate("\n")
    assert alive["said"] == "done\n"
    assert 0.2 <= alive["processor_seconds"] < 3


#: The sides that gam-db is measured against, as they were before it was made faster.
SIDES = {
    "gam_db/lab/benchmark/extract.py": "8e69cc659af3c1f4",
    "gam_db/lab/benchmark/floor.py": "ad7d3d07ac0ea734",
    "gam_db/lab/benchmark/workload.py": "00b62801b5434424",
    "sql/lab/benchmark/extract_lengths.sql": "2719fa9985316da0",
    "sql/lab/benchmark/extract_readings.sql": "14e19b8ce866446d",
    "sql/lab/benchmark/floor_on_ids.sql": "368c620194daa8e1",
    "sql/lab/benchmark/floor_on_names.sql": "7d0d240c7103c186",
    "sql/lab/benchmark/readings.sql": "e5bd9dad1427900f",
    "sql/lab/benchmark/readings_by_id.sql": "e89fd8797b052b01",
    "sql/lab/benchmark/telemetry.sql": "9b16fb0968b20b60",
}


@pytest.mark.parametrize("name", SIDES)
def test_what_is_measured_against_stays_what_it_was(name: str) -> None:
    text = (Path(__file__).parents[2] / name).read_bytes()
    assert hashlib.sha256(text).hexdigest()[:16] == SIDES[name]


def test_integers_are_equal_and_the_same_in_both_orders(figures: dict[str, Any]) -> None:
    first, second = figures["cases"]
    assert first["integers_equal"]
    assert first["rows"] == second["rows"]
    assert first["rows"]["bucket_health"] == CHANNELS * (SAMPLES * 4 // 5 // 100)
    assert 0 < first["novel_share"] < 1
    assert first["novel_share"] == second["novel_share"]


def test_both_orders_hold_the_same_rows_named_and_by_id(tmp_path: Path) -> None:
    rows = {}
    for order in workload.ORDERS:
        path = tmp_path / f"{order}.duckdb"
        workload.store(path, order, 3, 50)
        with duckdb.connect(str(path)) as connection:
            named = connection.sql("SELECT asset, channel, t, value FROM readings").fetchall()
            by_id = connection.sql("SELECT channel_id, t, value FROM readings_by_id").fetchall()
        assert [(*workload.names_of(number), *rest) for number, *rest in by_id] == named
        rows[order] = named
    assert rows["channel"] != rows["time"]
    assert rows["channel"] == sorted(rows["time"])
    assert [(t, asset, channel) for asset, channel, t, _ in rows["time"]] == sorted(
        (t, asset, channel) for asset, channel, t, _ in rows["time"]
    )


def test_the_script_shares_the_parameters() -> None:
    parameters = inside.PARAMETERS
    assert (parameters.m, parameters.tau) == (3, 1)
    assert (parameters.bins, parameters.window) == (extract.BINS, extract.WINDOW)
    assert parameters.bucket_length == extract.STRIDE
    assert inside.CALIBRATION.fraction == extract.CALIBRATION


def test_one_wrong_integer_is_found(tmp_path: Path) -> None:
    source, first, second = (tmp_path / f"{name}.duckdb" for name in ("source", "first", "second"))
    workload.store(source, "time", 2, 1_000)
    extract.run(source, first, 1)
    extract.run(source, second, 1)
    equal.compare(first, second)
    with duckdb.connect(str(second)) as connection:
        connection.execute("UPDATE bucket_health SET novel = novel + 1 WHERE bucket = 3")
    with pytest.raises(InternalError, match="disagree in the column novel of bucket_health"):
        equal.compare(first, second)
    with duckdb.connect(str(second)) as connection:
        connection.execute("DELETE FROM bucket_health WHERE bucket = 3")
    with pytest.raises(InternalError, match="disagree: bucket_health has"):
        equal.compare(first, second)


def test_the_script_stands_a_channel_without_novelty() -> None:
    times, nothing = np.arange(10), np.zeros(10, bool)
    cells = extract._novel_cells(times, nothing, np.zeros(10, np.int32))
    assert {name: len(column) for name, column in cells.items()} == dict.fromkeys(cells, 0)


def test_only_some_programs() -> None:
    plan = Plan(2, 1_000, 2, (1,), ("time",), ("floor_on_ids", "gam"))
    seen: list[str] = []
    (case,) = measure(plan, seen.append)["cases"]
    assert len(seen) == plan.runs
    turns = [run.rpartition(": ")[2].partition(",")[0] for run in seen[1:]]
    assert turns == ["floor_on_ids", "gam"] * 2
    assert case["sql_over_floor"] is not None
    assert case["extract_over_sql"] is None
    assert "rows" not in case


def test_the_report_for_people() -> None:
    size = ("--channels", "1", "--samples", "1000", "--repeat", "1", "--threads", "1")
    answer = invoked(*size, "--order", "channel")
    assert answer.exit_code == 0, answer.stderr
    for words in ("stored by channel, 1 thread", "extract_over_sql", "integers", "engine floor, names"):
        assert words in answer.stdout


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (("--order", "chanel"), "did you mean 'channel'"),
        (("--only", "floor"), "does not know 'floor'"),
        (("--threads", "0"), "positive integers"),
        (("--threads", ","), "--threads is empty"),
    ],
)
def test_options_are_checked(options: tuple[str, ...], words: str) -> None:
    answer = invoked(*options)
    assert isinstance(answer.exception, ConfigurationError)
    assert words in answer.exception.options
