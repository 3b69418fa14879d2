"""A machine that makes products: what each command says of them, from a file to the page."""

import json
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner, Result

from gam_db.cli import app

STATE = ("--database", "plant.duckdb")
SETTINGS: tuple[str, ...] = ("--m", "2", "--tau", "1", "--bins", "8", "--window", "40", "--stride", "10")
SETTINGS += ("--least-vectors", "400")
HEALTHY = ("--calibrate", "0/2399")
SHIFT = 200

#: What is made shift by shift: twelve of calibration, in which c is made once and d never; then health;
#: then a fault.
SHIFTS = "abababacabab" + "ab" * 15 + "dc" + "ababab"
NEW, RARE, FAULT = (SHIFT * place for place in (42, 43, 44))


def made(shifts: str = SHIFTS) -> pa.Table:
    """A press whose force follows the product; in the end product a is made with the force of b."""
    time = np.arange(len(shifts) * SHIFT)
    product = np.array(list(shifts)).repeat(SHIFT)
    levels = {"a": 1.0, "b": 2.0, "c": 3.0, "d": 2.5}
    force = np.array([levels[of] for of in product]) + (time % 10) / 100
    wrong = (time >= FAULT) & (product == "a")
    force[wrong] += 1.0
    columns = {"asset": ["press"] * len(time), "channel": ["force"] * len(time)}
    return pa.table({**columns, "time": time, "value": force, "product": product})


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, that holds the rows of the press."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    parquet.write_table(made(), "press.parquet")
    return tmp_path


def gam(*words: str) -> Result:
    return CliRunner().invoke(app, [*words])


def text(result: Result) -> str:
    return " ".join(result.stdout.split())


def monitored(*options: str) -> Result:
    """Calibrate on the press, and score all that came since."""
    gam("migrate", *STATE)
    calibrated = gam("calibrate", "press.parquet", *STATE, *HEALTHY, *SETTINGS, *options)
    assert calibrated.exit_code in (0, 2), calibrated.output
    return gam("score", *STATE)


def test_a_state_that_is_right_for_another_product_is_novel() -> None:
    program = ("--program", "product")
    monitored(*program)
    with duckdb.connect("plant.duckdb", read_only=True) as reader:
        query = f"SELECT SUM(novel) FROM gam_health WHERE last_tick >= {FAULT}"
        assert reader.execute(query).fetchall()[0][0] > 300
        # a, b and c; calibration holds enough of all that are made twice or more.
        programs = dict(reader.execute("SELECT program, verdict FROM gam_program").fetchall())
        assert programs == {"a": "ready", "b": "ready", "c": "needs_data"}
        cells = reader.execute("SELECT DISTINCT kind, program FROM gam_cell").fetchall()
        assert {*cells} == {("healthy", "a"), ("healthy", "b"), ("healthy", "c"), ("novel", "a")}
        found = reader.execute(
            "SELECT program, verdict, readings, first_tick, last_tick FROM gam_unjudged_program"
        )
        assert sorted(found.fetchall()) == [
            ("c", "needs_data", SHIFT, RARE, RARE + SHIFT - 1),
            ("d", "unknown", SHIFT, NEW, NEW + SHIFT - 1),
        ]


def test_without_the_column_it_is_not() -> None:
    monitored()
    with duckdb.connect("plant.duckdb", read_only=True) as reader:
        assert reader.execute("SELECT COUNT(*) FROM gam_program").fetchall() == [(0,)]
        query = f"SELECT SUM(novel) FROM gam_health WHERE last_tick >= {FAULT}"
        assert reader.execute(query).fetchall()[0][0] < 50


def test_status_lists_programs_that_are_not_judged() -> None:
    monitored("--program", "product")
    status = gam("status", *STATE)
    assert "program: d was never calibrated on press: 200 readings since 8,400 are not judged" in text(
        status
    )
    assert "program: c is too little in calibration on press: 200 readings since 8,600" in text(status)
    problems: list[dict[str, Any]] = json.loads(gam("status", *STATE, "--json").stdout)["data_problems"]
    counted = [
        (row["asset"], row["channel"], row["count"]) for row in problems if row["kind"] == "program"
    ]
    assert counted == [("press", None, SHIFT)] * 2


def test_an_alarm_and_the_page_name_the_program() -> None:
    # A product that is made once in calibration makes it no fair sample: nothing would be judged.
    parquet.write_table(made(SHIFTS.replace("c", "a", 1)), "press.parquet")
    monitored("--program", "product")
    explained = gam("alarm", "1", *STATE)
    assert explained.exit_code == 0, explained.output
    assert "program" in explained.stdout
    cells = json.loads(gam("alarm", "1", *STATE, "--json").stdout)["cells"]
    assert {cell["program"] for cell in cells} == {"a"}
    page = gam("report", *STATE, "--out", "press.html")
    assert page.exit_code == 0, page.output


def test_a_run_on_a_source_without_the_column_is_refused() -> None:
    monitored("--program", "product")
    with duckdb.connect() as connection:
        connection.execute("COPY (SELECT * EXCLUDE product FROM 'press.parquet') TO 'other.parquet'")
    refused = gam("score", "other.parquet", *STATE)
    assert refused.exit_code == 1
    assert "'product'" in refused.stderr
    assert "Traceback" not in refused.stderr


def test_a_program_is_text_or_a_whole_number() -> None:
    refused = gam("run", "press.parquet", "--program", "value")
    assert refused.exit_code == 1
    assert (
        "The program column 'value' is of type DOUBLE; it must be text or an integer" in refused.stderr
    )


def test_a_run_lists_programs_that_are_not_judged_whatever_the_times() -> None:
    for zone in (None, "UTC"):
        rows = made()
        seconds = pa.array(1_700_000_000 + rows["time"].to_numpy()).cast(pa.timestamp("s", zone))
        parquet.write_table(rows.set_column(2, "time", seconds), "press.parquet")
        span = ("--calibrate", "2023-11-14T22:13:20Z/2023-11-14T22:53:19Z")
        ran = gam("run", "press.parquet", *span, *SETTINGS, "--program", "product")
        assert (
            "program d was never calibrated on press (force): 200 readings since 2023-11-15 00:33 UTC"
            in (text(ran))
        )
        assert ran.exit_code in (2, 4), ran.output


def test_an_estimator_that_knows_no_programs_says_so() -> None:
    refused = gam("run", "press.parquet", "--program", "product", "--estimator", "centroid")
    assert refused.exit_code == 1
    assert "'centroid' does not support programs" in refused.stderr
