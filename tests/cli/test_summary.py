"""``gam_db.summary`` is what ``gam run`` prints, and has its rows."""

import json
import math
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import gam_db
from gam_db import Alarms, Calibration, Parameters, UserError, WideSource
from gam_db.cli import app

ROWS = 2000
WORDS = ["--m", "2", "--tau", "1", "--bins", "8", "--window", "50", "--calibrate", "0/799"]
METHOD = Parameters(m=2, tau=1, bins=8, window=50), Calibration(intervals=[(0, 799)])


def telemetry() -> pa.Table:
    """Two signals: one leaves its cycle at row 1,500, the other never moves."""
    wave = [math.sin(row / 7) + (1 if row >= 1500 else 0) for row in range(ROWS)]
    return pa.table({"machine": ["A"] * ROWS, "time": range(ROWS), "x": wave, "still": [1.0] * ROWS})


@pytest.fixture
def path(tmp_path: Path) -> str:
    parquet.write_table(telemetry(), tmp_path / "x.parquet")
    return str(tmp_path / "x.parquet")


def printed(*words: str) -> tuple[str, int]:
    done = CliRunner().invoke(app, ["run", *words, "--no-out"], env={"COLUMNS": "100"})
    return done.stdout, done.exit_code


def test_a_summary_is_what_gam_run_prints(path: str) -> None:
    summary = gam_db.summary(path, *METHOD)
    assert isinstance(summary, gam_db.Summary)
    for everything, words in ((False, []), (True, ["--all", "--time-zone", "Europe/Berlin"])):
        page, code = printed(path, *WORDS, *words)
        zone = "Europe/Berlin" if everything else "UTC"
        assert summary.text(everything, zone, width=100).splitlines() == page.splitlines()
        assert code == 2
    assert "! x " in str(summary)
    assert repr(summary) == str(summary)
    assert summary.needs_attention
    assert not summary.lacks_data


def test_a_summary_has_the_rows_of_gam_run(path: str) -> None:
    rate = "5 per 1000 judgements"
    summary = gam_db.summary(path, *METHOD, alarms=Alarms(rate=rate))
    page, _ = printed(path, *WORDS, "--rate", rate, "--json")
    figures = json.loads(page)
    assert json.loads(as_json(summary.figures())) == {name: figures[name] for name in summary.figures()}
    x, still = summary.channels
    assert (x["channel"], x["needs_attention"], x["status"]) == (
        "x",
        True,
        figures["channels"][0]["status"],
    )
    assert (still["channel"], still["verdict"], still["status"]) == ("still", "constant", "not assessed")
    assert len(x["course"]) == 24, "of 1,200 scored vectors, a point for each stride of 50"


def as_json(value: Any) -> str:
    from gam_db.cli.render import plain

    return json.dumps(plain(value))


def test_a_summary_of_what_python_holds() -> None:
    """A frame is called by what it is: none of its rows is shown."""
    summary = gam_db.summary(telemetry(), *METHOD)
    first, *_ = str(summary).splitlines()
    assert first == "Table: 2 channels of 1 asset, 4,000 samples"
    wide = gam_db.summary(WideSource(telemetry(), asset="machine"), *METHOD)
    assert str(wide).partition("method: ")[2] == str(summary).partition("method: ")[2] != ""
    of_array = gam_db.summary(np.asarray(telemetry()["x"]), *METHOD)
    assert str(of_array).startswith("ndarray: 1 channel of 1 asset, 2,000 samples")
    assert of_array.channels[0]["hi"] == summary.channels[0]["hi"]


def test_a_summary_of_a_table_leaves_a_connection_as_it_was() -> None:
    connection = duckdb.connect()
    connection.register("rows_of_x", telemetry())
    connection.execute("CREATE TABLE telemetry AS SELECT * FROM rows_of_x")
    with gam_db.connect(connection) as session:
        before = session.relations()
        summary = gam_db.summary("telemetry", *METHOD, engine=session)
        assert str(summary).startswith("telemetry: 2 channels of 1 asset, 4,000 samples")
        assert session.relations() == before


def test_rows_later_than_now_are_said() -> None:
    ahead = telemetry().set_column(1, "time", pa.array([4_000_000_000] * ROWS, pa.timestamp("s")))
    past = telemetry().set_column(1, "time", pa.array(range(ROWS), pa.timestamp("s")))
    both = pa.concat_tables([past, ahead.slice(0, 1)])
    (x, still), summary = gam_db.summary(past, METHOD[0]).channels, gam_db.summary(both, METHOD[0])
    assert {row["ahead_rows"] for row in summary.ahead} == {1}
    assert summary.lacks_data
    assert "2 rows are later than now and left out until then" in " ".join(str(summary).split())
    assert [row["hi"] for row in summary.channels] == [x["hi"], still["hi"]]


def test_a_summary_refuses_what_it_cannot_read(path: str) -> None:
    with pytest.raises(UserError, match="rate is 'often'"):
        gam_db.summary(path, *METHOD, alarms=Alarms(rate="often"))
    with pytest.raises(UserError, match="There is no time zone 'Mars'"):
        gam_db.summary(path, *METHOD).text(time_zone="Mars")
