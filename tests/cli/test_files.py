"""Files as plants have them, through the command line: what is asked, and the first line."""

import math
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a wide terminal."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "300")
    return tmp_path


def gam(*words: str | Path) -> Result:
    return CliRunner().invoke(app, [str(word) for word in words])


def first_line(result: Result) -> str:
    return (result.stdout or result.stderr).splitlines()[0]


def waves(*paths: str) -> None:
    for number, path in enumerate(paths):
        wave(path, 300 * number)


def wave(path: str, start: int = 0, rows: int = 300) -> None:
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    times = range(start, start + rows)
    columns = {
        "time": pa.array(times, pa.int64()),
        "value": pa.array([math.sin(time) for time in times], pa.float64()),
    }
    parquet.write_table(pa.table(columns), path)


def lines(path: str, *head: str, row: Callable[[int], str], rows: int = 300) -> None:
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text("\n".join([*head, *(row(number) for number in range(rows))]) + "\n")


def german(number: int) -> str:
    return f"{1 + number // 24:02d}.12.2025 {number % 24:02d}:00;1.{number % 7:03d},5"


def english(number: int) -> str:
    return f'12/{1 + number // 24:02d}/2025 {number % 24:02d}:00,"{number % 7},000.5"'


def each(*makers: Callable[[], object]) -> Callable[[], object]:
    return lambda: [make() for make in makers]


def tables(*paths: str) -> None:
    for path in paths:
        lines(path, "t,x", row=lambda n: f"{n},{n % 7}")


MANY = "1 channel of 1 asset, 300 samples"
GERMAN = ("--decimal", ",", "--thousands", ".", "--time-format", "%d.%m.%Y %H:%M")
ENGLISH = ("--thousands", ",", "--time-format", "%m/%d/%Y %H:%M")

#: What is made, what is asked, and the first line of the answer.
FILES: dict[str, tuple[Callable[[], object], tuple[str, ...], str]] = {
    "german, nothing said": (
        lambda: lines("de.csv", "Zeit;Wert", row=german),
        ("de.csv",),
        "gam: The value column 'Wert' is of type VARCHAR; readings must be numbers: 300 of 300 "
        "values do "
        "not fit, the first is '1.000,5', 43 times; --thousands . --decimal , would read them, or "
        "cast it in a view.",
    ),
    "german, numbers said": (
        lambda: lines("de.csv", "Zeit;Wert", row=german),
        ("de.csv", *GERMAN[:4]),
        "gam: Each value of the time column 'Zeit' must be a time in ISO 8601: 300 of 300 values do not "
        "fit, the first is '01.12.2025 00:00'; --time-format '%d.%m.%Y %H:%M' would read them.",
    ),
    "german": (
        lambda: lines("de.csv", "Zeit;Wert", row=german),
        ("de.csv", *GERMAN),
        f"de.csv: {MANY}",
    ),
    "english": (
        lambda: lines("us.csv", "time,value", row=english),
        ("us.csv", *ENGLISH),
        f"us.csv: {MANY}",
    ),
    "units, states of a sensor and lines above": (
        lambda: lines(
            "u.csv",
            "Station 7",
            "",
            "t,x",
            row=lambda n: f"{n},{'Bad' if n % 9 == 8 else f'{n % 7}.5 A'}",
        ),
        ("u.csv", "--skip-rows", "2", "--unit", "A", "--null", "Bad"),
        f"u.csv: {MANY}",
    ),
    "a word too many": (
        lambda: lines("u.csv", "t,x", row=lambda n: f"{n},{'Bad' if n == 250 else n % 7}"),
        ("u.csv", "--value", "x"),
        "gam: The value column 'x' is of type VARCHAR; readings must be numbers: 1 of 300 values do not "
        "fit, the first is 'Bad'; --null Bad would read them, or cast it in a view.",
    ),
    "booleans": (
        lambda: lines("b.csv", "t,valve", row=lambda n: f"{n},{'true' if n % 7 else 'false'}"),
        ("b.csv",),
        f"b.csv: {MANY}",
    ),
    "tabs": (
        lambda: lines("t.csv", "t|x", row=lambda n: f"{n}|{n % 7}"),
        ("t.csv", "--delimiter", "|"),
        f"t.csv: {MANY}",
    ),
    "a folder": (
        lambda: waves("in/a.parquet", "in/b.parquet"),
        ("in",),
        "in/: 1 channel of 1 asset, 600 samples",
    ),
    "a folder of CSV": (
        lambda: lines("in/x/a.csv", "t,x", row=lambda n: f"{n},{n % 7}"),
        ("in/",),
        f"in/: {MANY}",
    ),
    "hive partitions": (
        lambda: waves("in/machine=A/p.parquet", "in/machine=B/p.parquet"),
        ("in/**/*.parquet", "--asset", "machine"),
        "in/**/*.parquet: 2 channels of 2 assets, 600 samples",
    ),
    "several files": (
        lambda: waves("a/x.parquet", "b/x.parquet"),
        ("a/x.parquet", "b/x.parquet"),
        "a/x.parquet and 1 more: 1 channel of 1 asset, 600 samples",
    ),
    "several hive partitions": (
        lambda: waves("in/machine=A/p.parquet", "in/machine=B/p.parquet"),
        ("in/machine=A/p.parquet", "in/machine=B/p.parquet", "--asset", "machine"),
        "in/machine=A/p.parquet and 1 more: 2 channels of 2 assets, 600 samples",
    ),
    "several kinds": (
        each(lambda: waves("a.parquet"), lambda: tables("b.csv")),
        ("a.parquet", "b.csv"),
        "gam: b.csv is CSV, and a.parquet is Parquet; give files of one type.",
    ),
    "several, one of which is not there": (
        lambda: waves("a.parquet"),
        ("a.parquet", "b.parquet"),
        "gam: b.parquet cannot be read; is it there, and is it a file of that kind?",
    ),
    "several, one of which is empty": (
        each(lambda: tables("a.csv"), Path("b.csv").touch),
        ("a.csv", "b.csv"),
        f"a.csv and 1 more: {MANY}",
    ),
    "several of different columns": (
        each(lambda: tables("a.csv"), lambda: lines("b.csv", "t,x,y", row=lambda n: f"{n},{n},{n}")),
        ("a.csv", "b.csv"),
        "gam: b.csv has the columns t, x, y, and a.csv has the columns t, x; all files of a "
        "source must have "
        "the same columns.",
    ),
    "a pattern of different columns, CSV": (
        each(lambda: tables("a.csv"), lambda: lines("b.csv", "time,y", row=lambda n: f"{n},{n}")),
        ("*.csv",),
        "gam: b.csv has the columns time, y, and a.csv has the columns t, x; all files of a "
        "source must have "
        "the same columns.",
    ),
    "a pattern of different columns, Parquet": (
        each(lambda: waves("a.parquet"), lambda: parquet.write_table(pa.table({"t": [1]}), "b.parquet")),
        ("*.parquet",),
        "gam: b.parquet has the columns t, and a.parquet has the columns time, value; all files "
        "of a source must have the same columns.",
    ),
    "a pattern whose later files have more columns, CSV": (
        each(lambda: tables("a.csv"), lambda: lines("b.csv", "t,x,y", row=lambda n: f"{n},{n},{n}")),
        ("*.csv",),
        "gam: b.csv has the columns t, x, y, and a.csv has the columns t, x; all files of a "
        "source must have "
        "the same columns.",
    ),
    "a folder whose later files have more columns, Parquet": (
        each(
            lambda: waves("in/machine=A/p.parquet"),
            lambda: Path("in/machine=B").mkdir(),
            lambda: parquet.write_table(
                pa.table({"time": [1], "value": [1.0], "y": [2.0]}), "in/machine=B/p.parquet"
            ),
        ),
        ("in",),
        "gam: in/machine=B/p.parquet has the columns time, value, y, and in/machine=A/p.parquet has the "
        "columns time, value; all files of a source must have the same columns.",
    ),
    "several, one of which is no file": (
        lambda: waves("a.parquet"),
        ("a.parquet", "telemetry"),
        "gam: 'telemetry' is not a Parquet or CSV file (.parquet, .pq, .csv, .tsv, .csv.gz, .tsv.gz, "
        ".csv.zst); several SOURCE must all be files or folders, and a table must be the only SOURCE.",
    ),
    "an empty folder": (
        lambda: Path("in").mkdir(),
        ("in",),
        "gam: The folder in/ does not exist, or contains no Parquet or CSV file.",
    ),
    "a table of Delta Lake": (
        lambda: Path("in/_delta_log").mkdir(parents=True),
        ("in",),
        "gam: in/ is a table of Delta Lake, whose files also contain rows that are no longer in the "
        "table; pass it from Python as an Arrow table, by "
        "deltalake.DeltaTable(PATH).to_pyarrow_table().",
    ),
    "an empty file": (
        Path("e.csv").touch,
        ("e.csv",),
        "gam: e.csv has no rows; it is empty, or has only a header.",
    ),
    "a header without rows": (
        lambda: lines("h.csv", "time;value", row=str, rows=0),
        ("h.csv",),
        "gam: h.csv has no rows; it is empty, or has only a header.",
    ),
    "a Parquet file without rows": (
        lambda: wave("h.parquet", rows=0),
        ("h.parquet",),
        "gam: The source has no row (after where, if there is one).",
    ),
}


@pytest.mark.parametrize("name", FILES)
def test_a_file_is_read_or_the_options_are_named(name: str) -> None:
    make, words, expected = FILES[name]
    make()
    assert first_line(gam("run", *words, "--no-out", "--window", "20")) == expected


def test_a_missing_extension_is_named(monkeypatch: pytest.MonkeyPatch, folder: Path) -> None:
    """Where DuckDB may not fetch it, and its folder is empty."""
    monkeypatch.setenv("HOME", str(folder))
    for path, extension in (
        ("s3://plant/x.parquet", "httpfs"),
        ("https://127.0.0.1:9/x.parquet", "httpfs"),
    ):
        said = first_line(gam("run", path, "--no-out"))
        assert said.startswith(f"gam: {path} ")
        assert (
            f"DuckDB's extension {extension}, which is not installed" in said or "cannot be read" in said
        )


def test_a_wildcard_reads_no_results() -> None:
    wave("part-1.parquet")
    wave("part-2.parquet", 300)
    for _ in range(2):
        assert (
            first_line(gam("run", "part-*.parquet"))
            == "part-*.parquet: 1 channel of 1 asset, 600 samples"
        )
    assert Path("part-.health.parquet").exists()
    assert first_line(gam("run", ".", "--no-out")) == "./: 1 channel of 1 asset, 600 samples"
    said = first_line(gam("run", "part-.*.parquet", "--no-out"))
    assert said == (
        "gam: part-.*.parquet matches only results of gam-db; name the source that they were made from."
    )


def test_what_a_shell_makes_of_a_wildcard_reads_no_results() -> None:
    """The second time the shell names our results, too."""
    wave("part-1.parquet")
    wave("part-2.parquet", 300)
    for _ in range(2):
        named = sorted(map(str, Path().glob("part-*.parquet")))
        assert gam("run", *named).exit_code in (0, 2)
        learnt = parquet.read_table("part-.support.parquet")
        assert learnt["samples"].to_pylist() == [600]
    wave("part-3.parquet", 600)
    result = gam("run", "part-2.parquet", "part-3.parquet")
    assert result.exit_code == 1
    assert "part-.health.parquet contains the results of" in result.stderr
    assert (
        "matches only results"
        in gam("run", "part-.health.parquet", "part-.support.parquet", "--no-out").stderr
    )


def test_a_monitor_and_a_settings_file_keep_several_files(folder: Path) -> None:
    wave("a.parquet")
    wave("b,& c.parquet", 300)
    named = ("a.parquet", "b,& c.parquet")
    assert gam("init", *named, "--out", "gam.toml").exit_code in (0, 2)
    assert 'relation = ["a.parquet", "b,& c.parquet"]' in Path("gam.toml").read_text()
    result = gam("calibrate", "--window", "20", "--database", "m.duckdb")
    assert "a pattern in quotes ('part-*.parquet') or a folder" in " ".join(result.stdout.split())
    Path("gam.toml").unlink()
    result = gam("score", "--database", "m.duckdb")
    assert f"{folder}/a.parquet and 1 more" in " ".join(result.stdout.split())
    assert "read 1 channel" in result.stdout
    assert "newest data 599" in gam("status", "--database", "m.duckdb").stdout
    assert gam("score", *named, "--database", "m.duckdb").exit_code in (0, 2)
    assert "watches another source" in gam("calibrate", "a.parquet", "--database", "m.duckdb").stderr


def test_results_of_another_source_of_the_name_are_not_written_over() -> None:
    wave("a/x.parquet")
    wave("b/x.parquet", 7)
    assert gam("run", "a/x.parquet").exit_code in (0, 2)
    before = Path("x.health.parquet").read_bytes()
    result = gam("run", "b/x.parquet")
    assert result.exit_code == 1
    assert "x.health.parquet contains the results of" in result.stderr
    assert Path("x.health.parquet").read_bytes() == before
    assert gam("run", "a/x.parquet").exit_code in (0, 2)
    assert gam("run", "b/x.parquet", "--out", "x.health.parquet").exit_code in (0, 2)
    assert Path("x.health.parquet").read_bytes() != before


def test_a_list_of_files_in_python() -> None:
    wave("one.parquet")
    wave("two.parquet", 300)
    table = gam_db.support(gam_db.Source(["one.parquet", Path("two.parquet")], None, None))
    assert table["samples"].to_pylist() == [600]


def test_a_monitor_scores_a_german_file_by_what_it_keeps() -> None:
    lines("de.csv", "Zeit;Wert", row=german)
    gam("calibrate", "de.csv", *GERMAN, "--window", "20", "--database", "m.duckdb")
    result = gam("score", "--database", "m.duckdb")
    assert result.exit_code == 4, "nothing has come of late"
    assert "read 1 channel" in result.stdout


def test_a_settings_file_keeps_how_a_source_is_written() -> None:
    lines("de.csv", "Zeit;Wert", row=german)
    assert gam("init", "de.csv", *GERMAN, "--null", "Bad").exit_code in (0, 2)
    assert first_line(gam("run", "--no-out")).startswith(f"de.csv: {MANY}")


def test_a_counter_of_milliseconds_is_said_to_be_one() -> None:
    lines("e.csv", "t,x", row=lambda n: f"{1_767_225_600_000 + n},{n % 7}")
    said = "time looks like milliseconds since 1970"
    assert said in gam("run", "e.csv", "--no-out").stdout
    assert said in gam("check", "e.csv").stdout
    assert said not in gam("run", "e.csv", "--no-out", "--time-unit", "ms").stdout


@pytest.mark.parametrize("kind", [pa.uint64(), pa.decimal128(20, 0)], ids=str)
def test_integers_that_a_double_cannot_tell_apart_are_warned_of(kind: pa.DataType) -> None:
    times = range(300)
    large = pa.array([2**53 + 2 * (time % 50) for time in times], kind)
    parquet.write_table(pa.table({"time": times, "value": large}), "large.parquet")
    parquet.write_table(
        pa.table({"time": times, "value": [float(one.as_py()) for one in large]}), "double.parquet"
    )
    for command in (("check",), ("run", "--no-out")):
        assert "beyond 2^53" in gam(*command, "large.parquet").stdout
        assert "beyond 2^53" not in gam(*command, "double.parquet").stdout


def test_what_a_file_says_of_a_source_is_not_said_of_another() -> None:
    lines("de.csv", "Zeit;Wert", row=german)
    assert gam("init", "de.csv", *GERMAN).exit_code in (0, 2)
    wave("other.parquet")
    result = gam("run", "other.parquet", "--no-out")
    assert first_line(result) == (
        f"other.parquet: {MANY}; settings from gam.toml, but for [source], which is of another"
    )
    assert first_line(gam("run", "./de.csv", "--no-out")) == f"./de.csv: {MANY}; settings from gam.toml"


def test_a_machine_may_have_a_calibration_of_its_own() -> None:
    waves("in/machine=A/p.parquet", "in/machine=B/p.parquet")
    said = ("--asset", "machine", "--window", "20", "--m", "2", "--out", "out.parquet")
    result = gam(
        "run", "in", *said, "--calibrate", "0/99", "--calibrate", "B=300/349", "--calibrate", "B=351/359"
    )
    assert result.exit_code in (0, 2), result.output
    assert "calibration: 1 interval, but for B" in " ".join(result.stdout.split())
    learnt = parquet.read_table("out.support.parquet").to_pylist()
    assert [(row["asset"], row["calibration_samples"]) for row in learnt] == [("A", 100), ("B", 59)]
    assert "--calibrate is '5'; write FROM/TO" in gam("run", "in", "--calibrate", "A=5").stderr


def test_results_are_written_though_nobody_reads_the_page(tmp_path: Path) -> None:
    """As in ``gam run plant.csv | head``."""
    rows = "".join(f"{i},{i % 44}\n" for i in range(4000))
    (tmp_path / "plant.csv").write_text(f"time,value\n{rows}")
    command = [sys.executable, "-c", "from gam_db.cli import main; main()", "run", "plant.csv"]
    with subprocess.Popen(
        command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE
    ) as process:
        assert process.stdout is not None
        process.stdout.close()
        _, errors = process.communicate()
    assert b"Traceback" not in errors
    for what in ("health", "support", "certificate"):
        assert (tmp_path / f"plant.{what}.parquet").is_file()
