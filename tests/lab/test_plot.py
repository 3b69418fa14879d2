"""Figures of Plotly: their figures are the views', and those of what ``gam run`` wrote."""

from collections.abc import Callable
from pathlib import Path

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from typer.testing import CliRunner

import gam_db
from gam_db import plot
from gam_db.cli import app
from gam_db.errors import UserError
from test_report import shared, telemetry

pytest.importorskip("plotly", reason="pip install plotly")


def test_figures_are_those_of_the_views() -> None:
    monitor = shared("duckdb")
    health = [
        row for row in monitor.health().to_pylist() if (row["asset"], row["channel"]) == ("A", "x")
    ]
    drawn = plot.signal(monitor, "A", "x")
    assert list(drawn.data[0].x) == [row["last_tick"] for row in health]
    assert list(drawn.data[0].y) == [row["hi"] for row in health]
    limit = {row["channel"]: row["hi_limit"] for row in monitor.status().to_pylist()}["x"]
    assert drawn.layout.shapes[0].y0 == drawn.layout.shapes[0].y1 == limit
    fleet = plot.fleet(monitor)
    above = {
        (row["asset"], row["last_tick"]) for row in health if row["hi"] is not None and row["hi"] > limit
    }
    (heat,) = fleet.data
    assert list(heat.y) == ["A", "B"]
    assert above
    first = next(tick for tick, count in zip(heat.x, heat.z[0], strict=True) if count)
    assert first <= min(tick for _, tick in above) < first + heat.x[1] - heat.x[0]
    assert max(count for count in heat.z[0] if count is not None) == 2
    with pytest.raises(UserError, match=r"no signal 'A / w'"):
        plot.signal(monitor, "A", "w")


@pytest.mark.parametrize("out", ["r.parquet", "r.duckdb"])
def test_files_of_gam_run_are_drawn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, out: str) -> None:
    monkeypatch.chdir(tmp_path)
    with duckdb.connect() as connection:
        connection.execute("CREATE TABLE t (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)")
        rows = [("<b>", *rest) for asset, *rest in telemetry() if asset == "A"]
        connection.executemany("INSERT INTO t VALUES (?, ?, ?, ?)", rows)
        connection.execute("COPY t TO 't.parquet'")
    words = ["--m", "2", "--bins", "4", "--window", "20", "--calibrate", "0/199", "-q", "--out", out]
    assert CliRunner().invoke(app, ["run", "t.parquet", *words]).exit_code in (0, 2)
    drawn, fleet = plot.signal(out, "<b>", "x"), plot.fleet(Path(out))
    assert max(one for one in drawn.data[0].y if one is not None) > 0.5
    assert drawn.layout.title.text == "&lt;b&gt; · x"
    assert list(fleet.data[0].y) == ["&lt;b&gt;"]
    assert max(one for one in fleet.data[0].z[0] if one is not None) == 2


def test_a_file_that_is_none_is_named(tmp_path: Path) -> None:
    with pytest.raises(UserError, match=r"nothing\.parquet does not exist, or is not a result"):
        plot.fleet(tmp_path / "nothing.parquet")


def table_of(**columns: list[object]) -> pa.Table:
    return pa.table({"asset": ["A", "A", "B"], "channel": ["x", "x", "y"], **columns})


def test_what_health_indicator_returns_is_drawn() -> None:
    """A signal goes above its limit in the last quarter, as it is counted in the table itself."""
    values = np.sin(np.arange(2000) / 7)
    values[1500:] += 1
    method = gam_db.Parameters(m=2, tau=1, bins=8, window=50), gam_db.Calibration(intervals=[(0, 799)])
    health, support = (call(values, *method) for call in (gam_db.health_indicator, gam_db.support))
    alone, drawn = plot.signal(health), plot.signal(health, channel="value", support=support)
    for figure in (alone, drawn):
        assert list(figure.data[0].x) == health["time"].to_pylist() == list(range(800, 2000))
        assert list(figure.data[0].y) == health["hi"].to_pylist()
        assert figure.layout.title.text == "asset · value"
    (limit,) = support["hi_limit"].to_pylist()
    assert not alone.layout.shapes
    assert drawn.layout.shapes[0].y0 == limit
    (heat,) = plot.fleet(health, support).data
    above = [row["time"] for row in health.to_pylist() if row["hi"] is not None and row["hi"] > limit]
    first = next(tick for tick, count in zip(heat.x, heat.z[0], strict=True) if count)
    assert first <= above[0] < first + heat.x[1] - heat.x[0]
    buckets = plot.signal(gam_db.health_at_buckets(values, *method), "asset", "value")
    assert list(buckets.data[0].x)[-1] == 1999


def test_a_table_that_cannot_be_drawn_is_said() -> None:
    health = table_of(time=[1, 2, 1], hi=[None, 0.5, 0.1])
    assert list(plot.signal(health, "B").data[0].y) == [0.1]
    cases: list[tuple[Callable[[], object], str]] = [
        (lambda: plot.signal(health), r"2 signals match, such as A / x, B / y; choose one"),
        (lambda: plot.signal(health, "A", "z"), r"no signal 'A / z'; did you mean 'A / x'\?"),
        (
            lambda: plot.signal(health.drop_columns("hi")),
            "has no column 'hi'; pass the table that health_indicator",
        ),
        (lambda: plot.fleet(health), r"has no limits; also pass support=gam_db\.support"),
        (lambda: plot.fleet("x.parquet", health), "support is for a table"),
        (
            lambda: plot.fleet([1]),
            ("results is a list; pass a monitor, the table that health_indicator returns"),
        ),
    ]
    for call, message in cases:
        with pytest.raises(UserError, match=message):
            call()
