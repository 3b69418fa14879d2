"""What is looked at of programs: those that a column names, and the columns that look as if they did."""

import datetime as dt
import json
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from sqlglot import exp
from typer.testing import CliRunner

import engines
from gam_db import Source, WideSource
from gam_db.checking import look_at, notes, propose
from gam_db.checking.look import Look
from gam_db.checking.program_notes import totals
from gam_db.checking.programs import Candidate
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from looks import HALF, SHORT, wave

LENGTH, RUN = 400, 50
#: What each machine runs: eight runs of 50 readings; the first four are calibration.
RUNS = {"a": "pqprpqpr", "b": "pqprpqsr"}
FIRST = dt.datetime(2026, 3, 12)


def plant(**more: Any) -> pa.Table:
    """Two machines of two signals, with what they run, and more columns."""
    rows: dict[str, list[Any]] = {name: [] for name in ("asset", "channel", "time", "value", "product")}
    for asset, runs in RUNS.items():
        for channel in "xy":
            rows["asset"] += [asset] * LENGTH
            rows["channel"] += [channel] * LENGTH
            rows["time"] += range(LENGTH)
            rows["value"] += list(wave(LENGTH))
            rows["product"] += [program for program in runs for _ in range(RUN)]
    return pa.table(rows | more)


def looked(rows: Any, session: Session | None = None, **said: Any) -> Look:
    source = rows if isinstance(rows, WideSource) else Source(rows, **said)
    if session is not None:
        return look_at(session, source, SHORT, HALF)
    with DuckSession() as own:
        return look_at(own, source, SHORT, HALF)


def texts(look: Look) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for note in notes(look, propose(look)):
        found.setdefault(note.subject, []).append(note.text)
    return found


@pytest.fixture
def stored(engine: str) -> tuple[exp.Table, Session]:
    """The plant as a table of an engine."""
    session = engines.session(engine)
    table = exp.to_table(engines.fresh_name("telemetry"))
    with session.lent(plant()) as lent:
        session.execute(session.engine.create_table(table, exp.select("*").from_(lent)))
    return table, session


# (readings, runs; of calibration: readings, runs, days; later ones, whether calibration holds it)
OF_A = {"p": (200, 4, 100, 2, 1, 100, 1), "q": (100, 2, 50, 1, 1, 50, 1), "r": (100, 2, 50, 1, 1, 50, 1)}
OF_B = OF_A | {"p": (150, 3, 100, 2, 1, 50, 1), "s": (50, 1, 0, 0, 0, 50, 0)}


def test_what_each_channel_runs_is_counted(stored: tuple[exp.Table, Session]) -> None:
    table, session = stored
    look = looked(table.name, session, program="product")
    found = [tuple(row.values()) for row in look.programs]
    of = {"a": OF_A, "b": OF_B}
    assert found == [
        (asset, channel, program, *counts)
        for asset, programs in of.items()
        for channel in "xy"
        for program, counts in programs.items()
    ]
    assert look.candidates == ()
    said = texts(look)
    (lacking,) = (note for note in notes(look, propose(look)) if note.subject == "program_lacking")
    assert lacking.channels == (("b", "x"), ("b", "y"))
    assert "no reading of program s, which has 50 later readings" in lacking.text
    assert not {"program_column", "program_unnamed", "programs_lacking"} & said.keys()


def test_a_column_that_looks_like_a_program_is_named(stored: tuple[exp.Table, Session]) -> None:
    table, session = stored
    look = looked(table.name, session)
    assert look.candidates == (Candidate("product", 4, RUN),)
    assert look.programs == ()
    (text,) = texts(look)["program_column"]
    assert text.endswith("--program product")
    assert "4 values, in runs of 50 readings" in text


def test_a_text_of_no_number_is_not_refused(stored: tuple[exp.Table, Session]) -> None:
    """No engine is asked to read a name as a number; neither does one take it for 0."""
    table, session = stored
    assert looked(table.name, session).number_texts == ()


PLACES = np.tile(np.arange(LENGTH), 4)
MACHINES = np.repeat(np.arange(4), LENGTH)


@pytest.mark.parametrize(
    ("column", "usual"),
    [
        (PLACES // 25 % 2, 25),  # runs of a window
        (PLACES // 24 % 2, None),  # and of one reading less
        ((PLACES % 50 >= 20) * 1, None),  # as many of 20 readings as of 30: the lower median
        (PLACES // RUN % 2 * 1.0, None),  # not whole
        (PLACES // RUN % 2 > 0, None),  # true and false
        (PLACES // 200, None),  # does not return
        (np.zeros(4 * LENGTH, int), None),  # one value
        (MACHINES, None),  # another one for each channel
        (PLACES // 4 % 50, None),
        (PLACES * 4 + MACHINES, None),  # too many values
        (np.where(PLACES < 200, PLACES // RUN % 2, PLACES), None),  # too many later on
    ],
)
def test_what_looks_like_a_program_and_what_does_not(column: Any, usual: int | None) -> None:
    look = looked(plant(product=pa.nulls(4 * LENGTH), batch=column))
    found = [(one.column, one.usual_run) for one in look.candidates]
    assert found == ([] if usual is None else [("batch", usual)])


def test_fifty_values_are_programs_and_fifty_one_are_not() -> None:
    count = 51 * 2 * 25
    for programs, is_program in ((50, True), (51, False)):
        batch = [str(place // 25 % programs) for place in range(count)]
        rows = pa.table(
            {
                "asset": ["a"] * count,
                "channel": ["x"] * count,
                "time": range(count),
                "value": wave(count),
                "batch": batch,
            }
        )
        assert bool(looked(rows).candidates) == is_program


def test_a_column_that_a_condition_reads_is_no_program() -> None:
    state = pa.array((PLACES // RUN % 2).tolist())
    rows = plant(product=pa.nulls(4 * LENGTH), state=state)
    assert [one.column for one in looked(rows).candidates] == ["state"]
    assert looked(rows, valid_when="state = 0").candidates == ()
    assert looked(rows, where="STATE < 5").candidates == ()


def test_columns_of_a_wide_table() -> None:
    """A number that says what runs would be read as a signal of the machine."""
    of_a = [program for program in RUNS["a"] for _ in range(RUN)]
    rows = pa.table(
        {
            "asset": ["a"] * LENGTH,
            "time": range(LENGTH),
            "force": wave(LENGTH),
            "heat": wave(LENGTH, 7),
            "recipe": [ord(program) for program in of_a],
            "product": of_a,
        }
    )
    found = looked(WideSource(rows)).candidates
    assert found == (Candidate("product", 3, RUN), Candidate("recipe", 3, RUN))
    look = looked(WideSource(rows, program="recipe"))
    names = ("channel", "program", "readings", "runs")
    assert [tuple(row[name] for name in names) for row in look.programs] == [
        (channel, str(ord(program)), readings, runs)
        for channel in ("force", "heat")
        for program, readings, runs in (("p", 200, 4), ("q", 100, 2), ("r", 100, 2))
    ]


def test_a_switch_of_a_wide_table_is_no_program() -> None:
    switch = np.arange(LENGTH) // RUN % 2
    rows = pa.table({"time": range(LENGTH), "force": wave(LENGTH), "switch": switch, "state": switch})
    wide = WideSource(rows, ["force", "switch"], asset=None)
    assert looked(wide).candidates == (Candidate("state", 2, RUN),)


def test_without_such_columns_nothing_more_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    monkeypatch.setattr("gam_db.checking.programs.read_from", lambda *_: asked.append("first"))
    monkeypatch.setattr("gam_db.checking.programs._usual_run", lambda *_: asked.append("runs"))
    rows = plant(quality=wave(4 * LENGTH)).drop_columns(["product"])
    assert looked(rows).candidates == ()
    assert asked == []


def test_days_and_lines_of_programs() -> None:
    """Runs of 50 hours: p is of calibration on hours 0 to 49 and 100 to 149, so on six days."""
    times = [FIRST + dt.timedelta(hours=place) for place in range(LENGTH)] * 4
    look = looked(plant(time=times), program="product")
    days = {row["program"]: row["calibration_days"] for row in look.programs if row["asset"] == "b"}
    assert days == {"p": 6, "q": 3, "r": 3, "s": 0}
    assert [total.line(is_counter=False) for total in totals(look)] == [
        "p: 44 % of the readings in 7 runs; calibration: 2 runs on 6 days each",
        "q: 25 % of the readings in 4 runs; calibration: 1 run on 3 days each",
        "r: 25 % of the readings in 4 runs; calibration: 1 run on 3 days each",
        "s: 6.2 % of the readings in 1 run; calibration: 0 runs on 0 days each",
    ]
    assert totals(look)[0].line(is_counter=True).endswith("calibration: 2 runs each")


def test_readings_that_name_no_program() -> None:
    product = [None if place < 8 else "p" for place in PLACES]
    look = looked(plant(product=product), program="product")
    (text,) = texts(look)["program_unnamed"]
    assert text.startswith("2 % of the readings name no program (product is NULL)")
    assert {row["readings"] for row in look.programs} == {LENGTH - 8}


def test_of_many_programs_that_calibration_lacks_ten_are_named() -> None:
    product = ["p" if place < 200 else f"q{place // 10}" for place in PLACES]
    said = texts(looked(plant(product=product), program="product"))
    assert len(said["program_lacking"]) == 10
    assert said["programs_lacking"] == [
        "calibration contains no reading of 10 further programs, which run later: their readings "
        "are not judged"
    ]


def test_check_prints_programs(tmp_path: Path) -> None:
    path = tmp_path / "plant.parquet"
    parquet.write_table(plant(), path)
    words = ["check", str(path), "--calibration-fraction", "0.5", "--window", "25"]
    told = json.loads(CliRunner().invoke(app, [*words, "--json"]).stdout)
    assert told["programs"] == []
    assert told["program_columns"] == [{"column": "product", "programs": 4, "usual_run": RUN}]
    answer = CliRunner().invoke(app, [*words, "--program", "product"])
    assert "programs (product): 4" in answer.stdout
    assert "  p: 44 % of the readings in 7 runs; calibration: 2 runs each" in answer.stdout
    told = json.loads(CliRunner().invoke(app, [*words, "--program", "product", "--json"]).stdout)
    assert len(told["programs"]) == 14
    assert told["programs"][0]["calibration_runs"] == 2


def test_run_lists_programs_that_calibration_lacks(tmp_path: Path) -> None:
    path = tmp_path / "plant.parquet"
    times = [FIRST + dt.timedelta(hours=place) for place in range(LENGTH)] * 4
    parquet.write_table(plant(time=times), path)
    paper = ["--m", "1", "--tau", "1", "--bins", "4", "--window", "25", "--least-vectors", "60"]
    words = [
        "run",
        str(path),
        "--no-out",
        "--program",
        "product",
        "--calibration-fraction",
        "0.5",
        *paper,
    ]
    answer = CliRunner().invoke(app, words)
    lines = " ".join(answer.stdout.split())
    assert "program s was never calibrated on b (x, y): 50 readings since 2026-03-24 12:00 UTC" in lines
    assert "program q is calibrated too little on a (x, y): 50 readings since 2026-03-22 10:00" in lines
    assert "program p " not in lines
    assert "nothing needs attention" not in lines
    told = json.loads(CliRunner().invoke(app, [*words, "--json"]).stdout)
    counts = [
        (row["asset"], row["program"], row["verdict"], row["readings"]) for row in told["programs"]
    ]
    assert counts[:3] == [
        ("a", "p", "ready", 100),
        ("a", "q", "needs_data", 50),
        ("a", "r", "needs_data", 50),
    ]
    assert ("b", "s", "unknown", 50) in counts
    assert answer.exit_code == 4
    without = json.loads(CliRunner().invoke(app, [*words[:3], *words[5:], "--json"]).stdout)
    assert "programs" not in without
