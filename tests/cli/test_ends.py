"""How commands end: errors for machines, trying again, limits of time; no sign that a terminal obeys."""

import json
import os
import shlex
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
import sqlglot
from pyarrow import parquet
from sqlglot import exp
from typer.testing import CliRunner

import gam_db
from gam_db.cli import app, config
from gam_db.engines.clickhouse.driver import problem
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.postgres import refusals as postgres_refusals
from gam_db.errors import (
    ConfigurationError,
    ConflictError,
    EngineError,
    GamError,
    LostConnectionError,
    RunAgainError,
)


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


#: The command line in a process of its own.
GAM = (sys.executable, "-c", "from gam_db.cli import main; main()")


def invoked(*words: str) -> Any:
    return CliRunner().invoke(app, words)


def ended(*words: str) -> Any:
    """Run a command as a process of its own, which can be held by a file and has signals."""
    return subprocess.run([*GAM, *words], capture_output=True, text=True)


@pytest.mark.parametrize(
    ("words", "code", "exit_code"),
    [
        (("run", "nowhere.parquet", "--json"), "source", 1),
        (("run", "telemetry", "--json"), "configuration", 1),
        (("run", "nowhere.parquet", "--m", "many", "--json"), "usage", 1),
        (("run", "nowhere.parquet", "--bins", "2", "--m", "90", "--json"), "parameter", 1),
        (("status", "--database", "nowhere.duckdb", "--json"), "engine", 1),
    ],
)
def test_with_json_an_error_is_an_object(words: tuple[str, ...], code: str, exit_code: int) -> None:
    answer = invoked(*words)
    told = json.loads(answer.stdout)
    assert answer.exit_code == told["exit_code"] == exit_code
    assert told["error"]["code"] == code
    assert told["error"]["message"]
    assert told["error"]["message"] in answer.stderr or code == "usage"


def test_every_class_of_error_has_a_code_of_its_own() -> None:
    def all_below(of: type[GamError]) -> list[type[GamError]]:
        return [of, *(found for below in of.__subclasses__() for found in all_below(below))]

    users = all_below(gam_db.errors.UserError)
    assert len({one.code for one in users}) == len(users)


def test_what_passes_by_itself_is_told_to_be_run_again() -> None:
    full = postgres_refusals.of_connecting("FATAL: sorry, too many clients already", "host")
    assert isinstance(full, LostConnectionError)
    wrong = postgres_refusals.of_connecting("password authentication failed", "host")
    assert not isinstance(wrong, RunAgainError)
    assert isinstance(problem(OSError("reset"), "chdb"), LostConnectionError)
    assert issubclass(ConflictError, RunAgainError)
    assert issubclass(RunAgainError, EngineError)


def held(path: Path) -> "subprocess.Popen[str]":
    """Let another process have a DuckDB file open until it is given a line."""
    code = f"import duckdb; c = duckdb.connect({str(path)!r}); print('open', flush=True); input()"
    process = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "open\n"
    return process


def test_a_locked_file_ends_with_75_and_is_tried_again(folder: Path) -> None:
    database = folder / "plant.duckdb"
    duckdb.connect(str(database)).close()
    other = held(database)
    try:
        once = ended("migrate", "--database", str(database), "--json")
        assert once.returncode == 75
        assert json.loads(once.stdout)["error"]["code"] == "locked"
        again = subprocess.Popen(
            [*GAM, "migrate", "--database", str(database), "--retry", "8"],
            stderr=subprocess.PIPE,
            text=True,
        )
        assert again.stderr is not None
        assert again.stderr.readline().endswith("Trying again.\n")
    finally:
        other.communicate("\n")
    again.communicate(timeout=60)
    assert again.returncode == 0


def test_a_limit_of_time_stops_a_command(folder: Path) -> None:
    """The work would take far longer, and leaves nothing behind."""
    rows = 2_000_000
    table = pa.table({"time": range(rows), "value": [float(one % 977) for one in range(rows)]})
    parquet.write_table(table, folder / "long.parquet")
    started = time.monotonic()
    answer = ended("select", "long.parquet", "--timeout", "2.5", "--json")
    assert answer.returncode == 75
    assert json.loads(answer.stdout)["error"]["code"] == "timeout"
    assert "--timeout 2.5" in answer.stderr
    assert "Traceback" not in answer.stderr
    assert time.monotonic() - started < 60
    assert os.listdir(folder) == ["long.parquet"]


def test_a_statement_that_is_stopped_is_no_refusal_to_go_on_from() -> None:
    """``gam select`` asks about every channel alone where one was refused, not where one was stopped."""
    endless = sqlglot.parse_one("SELECT COUNT(*) FROM RANGE(100000000) AS a, RANGE(100000000) AS b")
    with DuckSession() as session:
        stop = threading.Timer(0.3, session.connection.interrupt)
        stop.start()
        with pytest.raises(EngineError, match="was interrupted"):
            session.fetch(endless)
        stop.join()


@pytest.mark.parametrize(
    "words", [("--retry", "many"), ("--timeout", "-1"), ("--timeout",), ("--retry=0",)]
)
def test_numbers_of_retries_and_seconds_are_checked(words: tuple[str, ...]) -> None:
    answer = invoked("demo", *words)
    assert answer.exit_code == 1
    assert "positive number" in answer.stderr


def test_a_connection_lost_at_the_end_says_that_it_is_not_known(monkeypatch: pytest.MonkeyPatch) -> None:
    with gam_db.connect("sqlite://") as session:

        def lost() -> None:
            raise LostConnectionError("gone")

        monkeypatch.setattr(session.driver, "commit", lost)
        with pytest.raises(LostConnectionError, match="is not known"), session.transaction():
            pass


def test_settings_of_another_user_are_not_read_unasked(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "gam.toml").write_text('[source]\nwhere = "x > 0"\n', encoding="utf-8")
    assert config.load().source.where == "x > 0"
    monkeypatch.setattr(os, "getuid", lambda: os.stat(folder).st_uid + 1)
    monkeypatch.setattr(config, "_TRUSTED", frozenset())
    with pytest.raises(ConfigurationError, match="belongs to another user") as caught:
        config.load()
    assert "--config gam.toml" in caught.value.options
    assert config.load(folder / "gam.toml").source.where == "x > 0"


@pytest.mark.parametrize(
    "where",
    [
        "time IN (SELECT time FROM read_csv('other.csv'))",
        "EXISTS (SELECT 1)",
        "value > (SELECT 1 UNION SELECT 2)",
        "value < 9 OR (time, value) IN (FROM 'other.parquet')",
    ],
)
def test_a_condition_that_asks_other_tables_must_be_wanted(folder: Path, where: str) -> None:
    small_recording(folder)
    (folder / "other.csv").write_text("time\n5\n", encoding="utf-8")
    answer = invoked("check", "t.parquet", "--where", where)
    assert answer.exit_code == 1
    assert "--where-any" in answer.stderr
    (folder / "gam.toml").write_text(f'[source]\nwhere = """{where}"""\n', encoding="utf-8")
    assert "--where-any" in invoked("check", "t.parquet").stderr
    assert "--where-any" not in invoked("check", "t.parquet", "--where-any").stderr


def test_a_plain_condition_needs_nothing(folder: Path) -> None:
    small_recording(folder)
    assert invoked(
        "run", "t.parquet", "--window", "40", "--no-out", "--where", "value < 6"
    ).exit_code in (0, 2)


#: Signs that a terminal obeys: ESC, 8-bit CSI, OSC with a bell, and a carriage return.
SIGNS = "a\x1b[31m\x9b2J\x1b]0;title\x07\rb"


@pytest.mark.parametrize("more", [(), ("--json",)])
def test_nothing_that_is_printed_is_obeyed_by_a_terminal(folder: Path, more: tuple[str, ...]) -> None:
    size = 400
    rows = {
        "machine": [SIGNS, "m"] * (size // 2),
        "time": range(size),
        "value": [float(one % 7) for one in range(size)],
    }
    parquet.write_table(pa.table(rows), folder / "t.parquet")
    words = ("--window", "40", "--bins", "5", "--no-out")
    answers = [
        invoked("run", "t.parquet", *words, *more),
        invoked("check", "t.parquet", *more),
        invoked("run", f"{SIGNS}.parquet", *more),
        invoked("run", "t.parquet", "--where", f"machine = '{SIGNS}' AND nothing", *more),
        invoked("run", "t.parquet", "--asset", SIGNS, *more),
        invoked(f"run{SIGNS}", *more),
    ]
    for answer in answers:
        for text in (answer.stdout, answer.stderr):
            obeyed = [sign for sign in text if not sign.isprintable() and sign != "\n"]
            assert obeyed == [], text
    assert answers[0].exit_code in (0, 2)
    assert "x1b" in answers[0].stdout or "u001b" in answers[0].stdout


#: The commands of a monitor, in an order in which each has something to say.
OF_A_MONITOR = (
    *("check telemetry", "init telemetry --out gam.toml --force", "migrate", "calibrate telemetry"),
    *("calibrate telemetry --again", "score telemetry", "score telemetry --dry-run", "status"),
    *(
        "check telemetry --state",
        "backtest telemetry --rate '1 per 1000 judgements' --window 10",
        "select telemetry",
        "prune --keep 800",
    ),
    *("report --out page.html", "drop", "drop --yes"),
)


@pytest.mark.thorough
@pytest.mark.parametrize("more", [(), ("--json",)])
def test_nor_is_what_names_of_a_database_hold(folder: Path, more: tuple[str, ...]) -> None:
    with duckdb.connect(str(folder / "plant.duckdb")) as connection:
        connection.execute(
            "CREATE TABLE telemetry AS SELECT ? || i % 2 AS machine, ? AS signal, i AS time, "
            "CAST(i // 2 % 7 AS DOUBLE) AS value FROM range(1600) AS t(i)",
            [SIGNS, SIGNS],
        )
    for command in OF_A_MONITOR:
        answer = invoked(*shlex.split(command), "--database", "plant.duckdb", *more)
        for text in (answer.stdout, answer.stderr):
            obeyed = [sign for sign in text if not sign.isprintable() and sign != "\n"]
            assert obeyed == [], (command, text)
        refused = command == "drop" or "No such option: --json" in answer.stdout
        assert answer.exit_code in (0, 2) or refused, (command, answer.output)


def wait_until_loaded(process: subprocess.Popen[str], library: str) -> None:
    """Wait until a process has loaded a library, a minute at most."""
    maps = Path(f"/proc/{process.pid}/maps")
    for _ in range(600):
        if library in maps.read_text(encoding="utf-8"):
            return
        time.sleep(0.1)
    raise AssertionError(f"{library} was not loaded")


def test_control_c_is_told_in_one_line(folder: Path) -> None:
    rows = 2_000_000
    table = pa.table({"time": range(rows), "value": [float(one % 977) for one in range(rows)]})
    parquet.write_table(table, folder / "long.parquet")
    process = subprocess.Popen(
        [*GAM, "select", "long.parquet"],
        stderr=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    wait_until_loaded(process, "_duckdb")
    time.sleep(2)
    process.send_signal(signal.SIGINT)
    _, told = process.communicate(timeout=60)
    assert process.returncode == 130
    assert told == "gam: interrupted; no file was left half written.\n"


def small_recording(folder: Path, rows: int = 600) -> None:
    table = pa.table({"time": range(rows), "value": [float(one % 7) for one in range(rows)]})
    parquet.write_table(table, folder / "t.parquet")


@pytest.mark.parametrize("target", ["out.parquet", "out.duckdb"])
def test_a_target_that_may_not_be_written_is_told_before_the_work(
    folder: Path, monkeypatch: pytest.MonkeyPatch, target: str
) -> None:
    small_recording(folder)
    monkeypatch.setattr(os, "access", lambda path, mode: mode != os.W_OK)
    answer = invoked("run", "t.parquet", "--window", "40", "--out", target)
    assert answer.exit_code == 1
    assert answer.stderr == f"gam: --out is {target}; you may not write {target}.\n"


@pytest.mark.parametrize("target", ["out.parquet", "out.duckdb"])
def test_a_full_disk_is_told_as_such(folder: Path, monkeypatch: pytest.MonkeyPatch, target: str) -> None:
    """In DuckDB's own words, where it writes the rows."""
    small_recording(folder)
    run = DuckSession._run

    def without_room(session: DuckSession, tree: exp.Expr, *more: Any) -> Any:
        is_target = isinstance(tree, exp.Copy) or (
            isinstance(tree, exp.Create)
            and any("_target" in table.catalog for table in tree.find_all(exp.Table))
        )
        if is_target:
            raise duckdb.IOException('IO Error: Could not write file "x": No space left on device')
        return run(session, tree, *more)

    monkeypatch.setattr(DuckSession, "_run", without_room)
    answer = invoked("run", "t.parquet", "--window", "40", "--out", target)
    assert answer.exit_code == 75
    assert answer.stderr == f"gam: {target} cannot be written: its disk is full.\n"
