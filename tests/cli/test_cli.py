"""The command line: what a user sees, what is written, and the exit codes."""

import json
import math
import os
import platform
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import csv, parquet
from rich.cells import cell_len
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app, installed, options
from gam_db.cli.course import PLAIN_BLOCKS, sparkline
from gam_db.cli.progress import Progress, interruptible
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import StatementError
from gam_db.study import Study

SMALL = ("--m", "2", "--window", "50", "--stride", "10", "--bins", "10", "--calibration-fraction", "0.5")
SAMPLES = 1200


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return tmp_path


def gam(*words: str | Path) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, [str(word) for word in words])


def gam_process(*words: str | Path, **more: Any) -> subprocess.CompletedProcess[str]:
    """Run one command in a process of its own, its output piped."""
    program = [sys.executable, "-c", "from gam_db.cli import main; main()", *map(str, words)]
    environment = {name: value for name, value in os.environ.items() if name != "COLUMNS"}
    environment["PYTHONPATH"] = os.pathsep.join(filter(None, [str(ROOT), environment.get("PYTHONPATH")]))
    return subprocess.run(program, capture_output=True, encoding="utf-8", env=environment, **more)


ROOT = Path(gam_db.__file__).parent.parent


def healthy(samples: int = SAMPLES) -> np.ndarray[Any, np.dtype[np.float64]]:
    """A cycle that repeats exactly: calibration sees every state again and again."""
    return np.sin(np.arange(samples) % 25 / 25 * 2 * math.pi)


def worn(samples: int = SAMPLES) -> np.ndarray[Any, np.dtype[np.float64]]:
    """The same until the last third, which is beyond anything calibration saw."""
    values = healthy(samples)
    values[samples * 2 // 3 :] += 5
    return values


def long_table(series: dict[tuple[str, str], Any]) -> pa.Table:
    """A table with a row per reading, from (asset, channel) -> values."""
    parts = [
        pa.table(
            {
                "asset": pa.array([asset] * len(values)),
                "channel": pa.array([channel] * len(values)),
                "time": np.arange(len(values)),
                "value": pa.array(values, pa.float64(), from_pandas=True),
            }
        )
        for (asset, channel), values in series.items()
    ]
    return pa.concat_tables(parts)


def saved(series: dict[tuple[str, str], Any], name: str = "plant.parquet") -> Path:
    """The same as a file."""
    path = Path(name)
    parquet.write_table(long_table(series), path)
    return path


def figures(*words: str | Path) -> dict[str, Any]:
    """What --json prints."""
    result = gam("run", *words, *SMALL, "--json")
    assert result.exit_code in (0, 2), result.output
    return json.loads(result.stdout)  # type: ignore[no-any-return]


# Exit codes


def test_few_vectors_are_not_ready_unless_that_is_asked_for() -> None:
    """In a process of its own: tests take any calibration."""
    source = saved({("R1", "j1"): healthy(798)})  # 398 vectors of calibration
    for words, verdict, code in (((), "needs_data", 2), (("--least-vectors", "398"), "ready", 0)):
        result = gam_process("run", source, *SMALL, *words, "--no-out")
        assert result.returncode == code, result.stdout
        assert f"verdicts: 1 {verdict}\n" in result.stdout
        advised = "calibration too short; it needs about 50 more vectors" in result.stdout
        assert advised == (not words)
    assert "choose a longer healthy part" in gam_process("run", source, *SMALL, "--no-out").stdout


def test_a_healthy_machine_is_fine() -> None:
    result = gam("run", saved({("R1", "j1"): healthy()}), *SMALL)
    assert result.exit_code == 0, result.output
    assert "nothing needs attention" in result.stdout


def test_a_worn_machine_needs_attention() -> None:
    short = gam("run", saved({("R1", "j1"): healthy(), ("R1", "j2"): worn()}), *SMALL)
    assert "2 channels with further remarks: --all" in short.stdout
    assert "above its limit" not in short.stdout
    assert "Limit: " not in short.stdout
    result = gam("run", "plant.parquet", *SMALL, "--all")
    assert result.exit_code == short.exit_code == 2
    assert "HI, 0 to 1: all that is scored, from 600 to 1,199\n" in result.stdout
    lines = result.stdout.splitlines()
    first = next(number for number, line in enumerate(lines) if line.startswith("! j2"))
    assert "ready" in lines[first]
    assert "1.00" in lines[first]
    assert "█" in lines[first]
    assert "- j2: far above its limit of 0.050, 100 % of the novel vectors out of range" in lines
    assert any(line.startswith("  j1") for line in lines[first:])


@pytest.mark.parametrize("constant", [np.zeros(SAMPLES), np.r_[np.zeros(900), np.ones(300)]])
def test_a_constant_channel_never_raises_an_alarm(constant: Any) -> None:
    result = gam("run", saved({("R1", "j1"): constant}), *SMALL)
    assert result.exit_code == 4, "nothing can be judged"
    assert "constant in calibration" in result.stdout
    assert ("has moved since" in result.stdout) == bool(constant.any())


def test_a_channel_without_calibration_raises_none_beside_others() -> None:
    gone = np.r_[np.full(800, np.nan), healthy(400)]
    source = saved({("R1", "j1"): healthy(), ("R1", "j2"): gone})
    result = gam("run", source, *SMALL, "--all")
    assert result.exit_code == 4
    assert "no usable sample in calibration" in result.stdout
    alone = gam("run", source, *SMALL, "--where", "channel = 'j2'")
    assert alone.exit_code == 4
    assert "choose a healthy part that holds data" in " ".join(alone.stdout.split())


def test_a_grid_that_is_too_fine_needs_attention() -> None:
    noise = np.random.default_rng(0).standard_normal(SAMPLES)
    result = gam("run", saved({("R1", "j1"): noise}), *SMALL, "--bins", "500")
    assert result.exit_code == 2
    assert "? j1" in result.stdout
    assert "grid too fine for its calibration" in result.stdout
    assert "above its limit" not in result.stdout


def test_less_than_a_window_is_said() -> None:
    result = gam("run", saved({("R1", "j1"): healthy()}), *SMALL, "--window", "1000", "--stride", "10")
    assert result.exit_code == 0
    assert "HI not yet available: 600 of 1,000 vectors scored" in result.stdout


def test_missing_and_conflicting_readings_are_said() -> None:
    values = healthy()
    values[[700, 900]] = np.nan
    table = long_table({("R1", "j1"): values})
    other = table.slice(3, 1).set_column(3, "value", pa.array([9.5]))
    parquet.write_table(pa.concat_tables([table, other]), "a.parquet")
    result = gam("run", "a.parquet", *SMALL)
    assert "4 vectors incomplete" in result.stdout
    assert "1 instants with different values" in result.stdout


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("run", "none.parquet"), "none.parquet cannot be read"),
        (("run", "a_table"), "--database FILE.duckdb"),
        (("run", "x.duckdb"), "gam run TABLE --database x.duckdb"),
        (("run", "a_table", "--database", "none.duckdb"), "no database file none.duckdb"),
        (("run",), "Name a SOURCE"),
        (("run", "p.parquet", "--value", "valeu"), "did you mean 'value'"),
        (("run", "p.parquet", "--value", "channel"), "readings must be numbers"),
        (("run", "p.parquet", "--bins", "0"), "bins is 0"),
        (("run", "p.parquet", "--bins", "many"), "--bins"),
        (("run", "p.parquet", "--max-gap", "5 parsecs"), "5 parsecs"),
        (("run", "p.parquet", "--calibrate", "5"), "FROM/TO"),
        (("run", "p.parquet", "--calibrate", "7/5"), "ends ('5') before it begins ('7')"),
        (("run", "p.parquet", "--where", "valeu > 1"), "valeu"),
        (("run", "p.parquet", "--asset", "asset", "--no-asset"), "contradict"),
        (("run", "p.parquet", "--channel", "a", "--channel", "b"), "--wide"),
        (("run", "p.parquet", "--wide", "--value", "value"), "--wide"),
        (("run", "p.parquet", "--config", "none.toml"), "none.toml cannot be read"),
        (("run", "p.parquet", "--out", "out.csv"), "Parquet file"),
        (("run", "p.parquet", "--out", "none/out.parquet"), "folder none is not there"),
        (("run", "p.parquet", "--out", "p.parquet"), "overwritten"),
        (("run", "p.parquet", "--every", "hour"), "--every"),
        (("run", "p.parquet", "--chanel", "channel"), "--channel"),
        (("rum",), "run"),
        (("demo", "--keep", "series.csv"), ".parquet"),
    ],
)
def test_what_the_user_can_mend_is_told_in_a_paragraph(words: tuple[str, ...], says: str) -> None:
    saved({("R1", "j1"): healthy(100)}, "p.parquet")
    result = gam(*words)
    assert result.exit_code == 1
    assert says in result.stderr
    assert "Traceback" not in result.stderr
    assert result.stdout == ""
    assert os.listdir() == ["p.parquet"]


def test_our_faults_are_told_apart(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(*_: object) -> None:
        raise StatementError("DuckDB refused a statement: near lunch", "SELECT lunch")

    monkeypatch.setattr(Study, "table", refused)
    source = saved({("R1", "j1"): healthy(100)})
    brief = gam("run", source)
    assert brief.exit_code == 3
    assert "a fault of gam-db, not yours" in brief.stderr
    assert "near lunch" in brief.stderr
    assert "SELECT lunch" not in brief.stderr
    for words in (("run", source, "--debug"), ("--debug", "run", source)):
        full = gam(*words)
        assert full.exit_code == 3
        assert "Traceback" in full.stderr
        assert "SELECT lunch" in full.stderr


def test_any_other_error_is_our_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setattr(Study, "table", broken)
    result = gam("run", saved({("R1", "j1"): healthy(100)}))
    assert result.exit_code == 3
    assert "ZeroDivisionError: oh" in result.stderr
    assert "Traceback" not in result.stderr


def test_debug_shows_the_traceback_of_a_user_error() -> None:
    result = gam("run", "none.parquet", "--debug")
    assert result.exit_code == 1
    assert "Traceback" in result.stderr


def test_an_interruption_ends_cleanly(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: object) -> None:
        os.kill(os.getpid(), signal.SIGINT)

    monkeypatch.setattr(DuckSession, "write", interrupted)
    result = gam("run", saved({("R1", "j1"): healthy(100)}), *SMALL)
    assert result.exit_code == 130
    assert "interrupted" in result.stderr
    assert "written" not in result.stdout


def test_an_interrupted_statement_is_no_fault() -> None:
    """DuckDB raises an error of its own in the place of KeyboardInterrupt."""

    def statement() -> None:
        try:
            os.kill(os.getpid(), signal.SIGINT)
        except KeyboardInterrupt:
            raise RuntimeError("Query interrupted") from None

    before = signal.getsignal(signal.SIGINT)  # Spark's, where a test before this one has started it
    with pytest.raises(KeyboardInterrupt), interruptible():
        statement()
    with pytest.raises(RuntimeError), interruptible():
        raise RuntimeError("something else")
    assert signal.getsignal(signal.SIGINT) is before


# What is printed


def test_what_was_guessed_is_said() -> None:
    table = long_table({("R1", "j1"): healthy()})
    csv.write_csv(table.rename_columns(["Robot", "joint", "tick", "reading"]), "plant.csv")
    result = gam("run", "plant.csv", *SMALL)
    assert result.exit_code == 0, result.output
    said = " ".join(result.stdout.split())
    assert "asset=Robot channel=joint time=tick value=reading; guessed: all" in said
    named = gam("run", "plant.csv", *SMALL, "--asset", "Robot", "--time", "tick")
    assert "guessed: channel, value" in " ".join(named.stdout.split())


def test_a_wide_table_is_recognised() -> None:
    table = pa.table({"ts": np.arange(SAMPLES), "current": healthy(), "torque": worn()})
    parquet.write_table(table, "wide.parquet")
    result = gam("run", "wide.parquet", *SMALL)
    assert result.exit_code == 2
    said = " ".join(result.stdout.split())
    assert "wide table, signals: current, torque; guessed: all" in said
    assert "no column names the signal" in said
    one = gam("run", "wide.parquet", *SMALL, "--wide", "--channel", "current")
    assert one.exit_code == 0
    assert "signals: current;" in one.stdout
    assert "not used: torque" in one.stdout


def test_ambiguous_columns_are_asked_for() -> None:
    table = pa.table({"ts": [1, 2], "tag": ["a", "a"], "sensor": ["b", "b"], "value": [0.5, 1]})
    parquet.write_table(table, "a.parquet")
    result = gam("run", "a.parquet")
    assert result.exit_code == 1
    assert "'tag' and 'sensor'" in result.stderr
    assert "--channel COLUMN" in result.stderr


def test_many_channels_stay_readable() -> None:
    series = {(f"R{n:02}", "j1"): worn(300) if n == 33 else healthy(300) for n in range(45)}
    source = saved(series)
    result = gam("run", source, *SMALL, "--no-out")
    assert result.exit_code == 2
    rows = [line for line in result.stdout.splitlines() if " j1 " in line and " ready " in line]
    assert len(rows) == options.SHOWN
    assert rows[0].startswith("! R33 j1")
    assert "and 5 more (5 ok); --all" in result.stdout
    assert "verdicts: 45 ready" in result.stdout
    assert "channels: 1 above the limit, 44 ok" in result.stdout
    everything = gam("run", source, *SMALL, "--no-out", "--all").stdout
    assert sum(" j1 " in line and "ready" in line for line in everything.splitlines()) == 45


def test_quiet_prints_nothing() -> None:
    result = gam("run", saved({("R1", "j1"): worn()}), *SMALL, "-q")
    assert result.exit_code == 2
    assert result.output == ""
    assert Path("plant.health.parquet").exists()


def test_names_cannot_talk_to_the_terminal() -> None:
    asset = "[bold]R1\x1b[31m\n\u202e; DROP TABLE x --'\""
    channel = "Geschwindigkeit_der_Achse_" * 8 + "\u6a5f\u68b0"
    result = gam("run", saved({(asset, channel): worn(), (asset, "j2"): healthy()}), *SMALL)
    assert result.exit_code == 2, result.output
    assert "\x1b" not in result.stdout
    assert "\u202e" not in result.stdout
    assert all(cell_len(line) <= 80 for line in result.stdout.splitlines())
    found = json.loads(gam("run", "plant.parquet", *SMALL, "--json").stdout)["channels"]
    assert {(one["asset"], one["channel"]) for one in found} == {(asset, channel), (asset, "j2")}


@pytest.mark.parametrize(
    ("course", "width", "expected"),
    [
        ([0.0, 0.124, 0.126, 0.5, 0.874, 0.876, 1.0], 7, "▁▁▂▅▇██"),
        ([math.nan, math.nan, 0.0, 1.0], 4, "  ▁█"),
        ([math.nan, 0.0, 0.3, 1.0, 0.1, 0.2], 3, "▁█▂"),
        ([], 5, ""),
    ],
)
def test_the_course_has_a_fixed_scale(course: list[float], width: int, expected: str) -> None:
    """The highest of each stretch is shown; what is not there yet is a gap."""
    assert sparkline(np.array(course), width) == expected
    plain = sparkline(np.array(course), width, PLAIN_BLOCKS)
    assert plain.isascii()
    assert len(plain) == len(expected)


# JSON


def test_json_is_what_the_library_returns() -> None:
    source = saved({("R1", "j1"): healthy(), ("R1", "j2"): worn(), ("R2", "j1"): np.zeros(SAMPLES)})
    found = figures(source, "--no-out")
    parameters = gam_db.Parameters(m=2, window=50, stride=10, bins=10)
    calibration = gam_db.Calibration(fraction=0.5)
    whole = gam_db.Source(str(source))
    support = gam_db.support(whole, parameters, calibration).to_pylist()
    buckets = gam_db.health_at_buckets(whole, parameters, calibration).to_pylist()
    assert len(found["channels"]) == 3
    for one in found["channels"]:
        name = (one["asset"], one["channel"])
        (row,) = [row for row in support if (row["asset"], row["channel"]) == name]
        assert {key: one[key] for key in row} == row
        own = [bucket for bucket in buckets if (bucket["asset"], bucket["channel"]) == name]
        assert one["hi"] == own[-1]["hi"]
        assert one["last_time"] == own[-1]["last_time"]
        assert one["scored"] == 10 * len(own)
        assert one["course"][0] is None
        assert max(filter(None, one["course"]), default=0) == max(
            (bucket["hi"] for bucket in own if bucket["hi"]), default=0
        )
    statuses = {(one["asset"], one["channel"]): one["status"] for one in found["channels"]}
    assert statuses == {("R1", "j2"): "proving", ("R1", "j1"): "ok", ("R2", "j1"): "not assessed"}
    assert found["parameters"]["window"] == 50
    assert found["calibration"]["fraction"] == 0.5
    assert found["written"] == []
    assert found["exit_code"] == 2


def test_json_holds_times_and_overrides() -> None:
    rows = long_table({("R1", "j1"): healthy()})
    stamps = pa.array(np.arange(SAMPLES) * 1_000_000, pa.timestamp("us"))
    parquet.write_table(rows.set_column(2, "time", stamps), "plant.parquet")
    Path("gam.toml").write_text(
        "[[override]]\nchannel = 'j*'\nbins = 20\n[calibration]\n"
        "intervals = [[1970-01-01, 1970-01-01T00:10:00]]\n"
    )
    result = gam("run", "plant.parquet", "--m", "2", "--window", "50", "--json", "--no-out")
    assert result.exit_code == 0, result.output
    found = json.loads(result.stdout)
    assert found["settings_file"] == "gam.toml"
    assert found["parameters"]["overrides"] == [{"asset": "*", "channel": "j*", "bins": 20}]
    assert found["calibration"]["intervals"] == [["1970-01-01", "1970-01-01T00:10:00"]]
    assert found["channels"][0]["last_time"].startswith("1970-01-01T00:1")


# What is written


def test_parquet_files_hold_what_the_library_returns() -> None:
    source = saved({("R1", "j1"): healthy(), ("R1", "j2"): worn()}, "press 7.parquet")
    found = figures(source)
    names = [f"press_7.{what}.parquet" for what in ("health", "support", "certificate")]
    assert found["written"] == names
    parameters = gam_db.Parameters(m=2, window=50, stride=10, bins=10)
    asked = (gam_db.Source(str(source)), parameters, gam_db.Calibration(fraction=0.5))
    expected = (
        gam_db.health_indicator(*asked),
        gam_db.support(*asked),
        gam_db.certificate(*asked),
    )
    for name, table in zip(names, expected, strict=True):
        assert parquet.read_table(name).to_pylist() == table.to_pylist()


def test_rows_per_stride_and_a_name_of_ones_own() -> None:
    source = saved({("R1", "j1"): healthy()})
    Path("sub").mkdir()
    found = figures(source, "--out", "sub/mine.parquet", "--every", "stride")
    assert found["written"] == [
        str(Path("sub", name)) for name in ("mine.parquet", "mine.support.parquet")
    ] + [str(Path("sub", "mine.certificate.parquet"))]
    assert parquet.read_table("sub/mine.parquet").column_names[2] == "bucket"


def test_a_duckdb_file_gets_tables_and_keeps_its_own() -> None:
    with duckdb.connect("results.duckdb") as connection:
        connection.execute("CREATE TABLE mine AS SELECT 1 AS x")
    source = saved({("R1", "j1"): healthy()})
    for every, extra in (("vector", set()), ("stride", {"gam_health_at_buckets"})):
        figures(source, "--out", "results.duckdb", "--every", every)
        with duckdb.connect("results.duckdb") as connection:
            tables = {row[0] for row in connection.execute("SHOW TABLES").fetchall()}
            (rows,) = connection.execute("SELECT count(*) FROM gam_support_summary").fetchone() or (
                None,
            )
        assert (
            tables == {"mine", "gam_health_indicator", "gam_support_summary", "gam_certificate"} | extra
        )
        assert rows == 1


def test_no_out_writes_nothing() -> None:
    source = saved({("R1", "j1"): healthy()})
    assert gam("run", source, *SMALL, "--no-out").exit_code == 0
    assert os.listdir() == [source.name]


def test_a_table_of_a_database_with_a_hostile_name() -> None:
    table, machine = 'tele"metry; DROP TABLE x', 'select "a" '
    rows = long_table({("R'1", "j1"): healthy()}).rename_columns([machine, "channel", "time", "value"])
    with duckdb.connect("plant.duckdb") as connection:
        connection.register("rows_of_test", rows)
        quoted = table.replace('"', '""')
        connection.execute(f'CREATE TABLE "{quoted}" AS SELECT * FROM rows_of_test')
    result = gam("run", table, "--database", "plant.duckdb", "--asset", machine, *SMALL)
    assert result.exit_code == 0, result.output
    assert Path("tele_metry_DROP_TABLE_x.health.parquet").exists()
    found = gam("run", "telemetry", "--database", "plant.duckdb")
    assert found.exit_code == 1
    assert "did you mean" in found.stderr
    itself = gam(
        "run", table, "--database", "plant.duckdb", "--asset", machine, *SMALL, "--out", "plant.duckdb"
    )
    assert itself.exit_code == 0, itself.output


# Settings


def test_gam_toml_is_read_and_options_come_first() -> None:
    saved({("R1", "j1"): worn()})
    Path("gam.toml").write_text(
        "[source]\nrelation = 'plant.parquet'\n[parameters]\nm = 2\nbins = 10\nwindow = 50\n"
        "[calibration]\nfraction = 0.5\n"
    )
    result = gam("run", "--no-out")
    assert result.exit_code == 2
    assert "settings from gam.toml" in result.stdout
    assert "m=2 tau=1 bins=10 window=50" in result.stdout
    later = gam("run", "--no-out", "--window", "100", "--calibration-fraction", "1")
    assert "window=100" in later.stdout
    assert "the first 100 % of each channel" in later.stdout


def test_a_mistyped_key_of_gam_toml_is_told() -> None:
    Path("gam.toml").write_text("[parameters]\nwindw = 50\n")
    result = gam("run", saved({("R1", "j1"): healthy(100)}))
    assert result.exit_code == 1
    assert "gam.toml" in result.stderr
    assert "did you mean 'window'" in result.stderr


def test_calibration_by_options() -> None:
    source = saved({("R1", "j1"): healthy(), ("R2", "j1"): worn()})
    said = ("--m", "2", "--window", "50", "--bins", "10", "--no-out", "--json")
    result = gam(
        *("run", source, "--calibrate", "0/99", "--calibrate", "200/499", "--exclude", "10/19"),
        *("--score-from", "600", "--pool", "R1,R2", "--max-gap", "5", *said),
    )
    assert result.exit_code == 2, result.output
    found = json.loads(result.stdout)
    assert found["calibration"]["intervals"] == [["0", "99"], ["200", "499"]]
    assert found["calibration"]["pool"] == [["R1", "R2"]]
    assert found["parameters"]["max_gap"] == 5
    assert {one["calibration_samples"] for one in found["channels"]} == {390}
    lasting = gam("run", source, "--calibration-duration", "399", "--pool", "channel", *said)
    assert {one["calibration_samples"] for one in json.loads(lasting.stdout)["channels"]} == {400}


# Processes and the demo


def test_a_pipe_gets_plain_text() -> None:
    """No colour, no spinner, no line beyond 80 columns, nothing on stderr."""
    source = saved({("R1", "j1"): healthy(), ("R1", "j" * 70): worn()})
    done = gam_process("run", source.resolve(), *SMALL)
    assert done.returncode == 2, done.stderr
    assert done.stderr == ""
    assert "\x1b" not in done.stdout
    assert max(map(cell_len, done.stdout.splitlines())) <= 80
    assert "written: plant.health.parquet" in done.stdout


def test_an_alphabet_without_blocks_is_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    source = saved({("R\u00e9", "j1"): worn()})
    monkeypatch.setenv("PYTHONIOENCODING", "ascii")
    done = gam_process("run", source, *SMALL)
    assert done.returncode == 2, done.stderr
    assert done.stdout.isascii()
    assert "#" in done.stdout


def test_the_demo_runs_anywhere_and_says_what_comes_next() -> None:
    done = gam_process("demo", timeout=30)
    assert done.returncode == 0, done.stderr
    assert os.listdir() == []
    said = " ".join(done.stdout.split())
    assert "! position ready 1 % 0.017 0.88" in said
    assert "not evidence for that result" in said
    assert "gam run recording.parquet" in said


def test_the_demo_keeps_its_series_for_gam_run() -> None:
    result = gam("demo", "--out", "series.parquet")
    assert result.exit_code == 0
    written = Path("series.parquet").read_bytes()
    again = gam("demo", "--keep", "series.parquet")
    assert again.exit_code == 1
    assert "there already" in again.stderr
    assert Path("series.parquet").read_bytes() == written
    (line,) = [line.split() for line in result.stdout.splitlines() if "gam run series.parquet" in line]
    found = gam(*line[1:], "--json")
    (one,) = json.loads(found.stdout)["channels"]
    assert (one["cells"], one["hi"]) == (4172, 0.875)


def test_every_command_has_help() -> None:
    listed = gam("--help")
    assert listed.exit_code == 0
    for command in ("run", "demo", "status"):
        assert command in listed.stdout
        assert gam(command, "--help").exit_code == 0
    assert gam().exit_code == 1


def test_what_is_installed_is_shown_with_the_version(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is not there is named with what installs it; extras for work on gam-db are not named."""
    assert gam("--version").stdout == f"gam-db {gam_db.__version__}\n"
    required = [
        *("duckdb<3,>=2.0", "no-such-thing>=1; extra == 'spark'", "pytest>=8; extra == 'test'"),
        *('no-such-thing[c]>=1; python_version > "3" and extra == "plot"', "no.thing"),
    ]
    monkeypatch.setattr(installed, "requires", lambda _: required)
    for words in (("--version", "--verbose"), ("--verbose", "--version")):
        head, python, place, *libraries = gam(*words).stdout.splitlines()
        assert head == f"gam-db {gam_db.__version__}"
        assert python.startswith(f"Python {platform.python_version()}, SQLite ")
        assert place == f"gam-db is in {Path(gam_db.__file__).parent}"
        assert libraries == [
            f"duckdb {duckdb.__version__}",
            'no-such-thing is not installed: pip install "gam-db[spark]" or pip install "gam-db[plot]"',
            'no.thing is not installed: pip install "gam-db"',
        ]


def test_verbose_goes_with_the_version() -> None:
    found = gam("--verbose", "status")
    assert (found.exit_code, found.stderr) == (1, "gam: --verbose goes with --version.\n")


def test_progress_shows_the_step_only_at_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    with DuckSession() as session:
        monkeypatch.setattr(session, "progress", lambda: 42.0)
        with Progress(session) as progress:
            progress.on_step("bounds")
            assert "learning the healthy states  0 s, 42 %" in str(progress.__rich__())
        assert capsys.readouterr().err == ""
        monkeypatch.setenv("FORCE_COLOR", "1")
        with Progress(session) as progress:
            progress.on_step("bounds")
        assert "learning the healthy states" in capsys.readouterr().err
        with Progress(session, quiet=True) as progress:
            progress.on_step("bounds")
        assert capsys.readouterr().err == ""


def test_a_long_run_says_in_a_log_what_it_does(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """At most a line in each stretch of time, whatever happens in it."""
    monkeypatch.setattr("gam_db.cli.progress.EVERY", 0.2)
    with DuckSession() as session:
        begin = time.monotonic()
        with Progress(session) as progress:
            time.sleep(0.5)
            for step in ("bounds", "visited", "stamp", "bounds"):
                progress.on_step(step)
            time.sleep(0.5)
        lines = capsys.readouterr().err.splitlines()
        assert 3 <= len(lines) <= (time.monotonic() - begin) / 0.2
        assert lines[0].startswith("reading the source  0 s")
        assert lines[-1].startswith("learning the healthy states  0 s")
        with Progress(session, quiet=True) as progress:
            time.sleep(0.2)
        assert capsys.readouterr().err == ""


def test_results_of_a_table_go_into_another_database(tmp_path: Path) -> None:
    """The database that is read is opened for reading only; the other one must not be."""
    source, target = tmp_path / "plant.duckdb", tmp_path / "health.duckdb"
    with duckdb.connect(str(source)) as connection:
        connection.execute(
            "CREATE TABLE t AS SELECT 'a' AS asset, 'c' AS channel, i AS time, i % 3 + 0.5 AS value "
            "FROM range(200) AS r(i)"
        )
    found = CliRunner().invoke(
        app, ["run", "t", "--database", str(source), "--window", "20", "--out", str(target), "--quiet"]
    )
    assert found.exit_code == 0
    with duckdb.connect(str(target)) as connection:
        (rows,) = connection.sql("SELECT count(*) FROM gam_health_indicator").fetchall()
    assert rows == (160,)
