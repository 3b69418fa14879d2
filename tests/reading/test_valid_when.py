"""A condition under which readings count: any other one is a missing sample, in every form."""

import json
from pathlib import Path

import duckdb
import pyarrow as pa
import pytest
from typer.testing import CliRunner

import comparisons
import dbt_builder
import engines
import frozen
import gam_db
import harness
import reference
import scripts
from gam_db.cli import app
from gam_db.errors import ConfigurationError, SourceError
from gam_db.export import Package
from gam_db.stored.monitor import Monitor
from harness import Row
from visible import BUCKETS, NOVEL, visible

METHOD = harness.made(
    {"m": 2, "tau": 2, "bins": 4, "window": 20, "stride": 5, "range": "min_max"}, {"fraction": 0.4}
)
CONDITION = "value > 1 OR asset = 'b'"


def readings(start: int, end: int) -> list[Row]:
    return [
        (asset, "x", time, None if time % 41 == 3 else float((time * time) % 7))
        for asset in "ab"
        for time in range(start, end)
    ]


def as_missing(rows: list[Row]) -> list[Row]:
    """Return rows by hand as the condition leaves them."""
    return [
        (asset, channel, time, value if value is not None and (value > 1 or asset == "b") else None)
        for asset, channel, time, value in rows
    ]


def test_what_is_not_valid_is_missing_in_the_exact_form_and_in_scripts(engine: str) -> None:
    session, rows = engines.session(engine), readings(0, 200)
    meant = reference.health_indicator(as_missing(rows), *METHOD)
    table, prefix = scripts.telemetry(session, rows), engines.fresh_name("script")
    source = gam_db.Source(table.name, valid_when=CONDITION)
    found = gam_db.health_indicator(source, *METHOD, session).to_pylist()
    harness.assert_same(meant, found, "exact")
    comparisons.compared(engine, "exact", as_missing(rows), *METHOD)
    script = gam_db.render("exact", engine, source, *METHOD)
    harness.assert_same(meant, scripts.fetched(session, script), "script")
    scripts.run(session, gam_db.render("view", engine, source, *METHOD, prefix))
    answers = scripts.answered(session, prefix)
    scripts.check_judged(answers)
    harness.assert_same(meant, answers["health_indicator"], "view")
    scripts.clear(session, table.name, prefix)


def test_what_is_not_valid_is_missing_in_a_monitor(engine: str) -> None:
    session, first, final = engines.session(engine), readings(0, 120), readings(0, 260)
    table = scripts.telemetry(session, first)
    prefix = engines.fresh_name("state")
    monitor = Monitor(session, gam_db.Source(table.name, valid_when=CONDITION), *METHOD, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    scripts.arrive(session, table, readings(120, 260))
    report = monitor.score()
    asked = as_missing(first), as_missing(final), *METHOD
    harness.assert_same(frozen.buckets(*asked), visible(monitor, BUCKETS), "buckets")
    harness.assert_same(frozen.novel_cells(*asked), visible(monitor, NOVEL), "novel cells")
    invalid = sum(asset == "a" and not (value or 0) > 1 for asset, _, _, value in final)
    assert 0 < report.invalid <= invalid
    assert report.held <= len(final)
    if engine != "spark":  # of a hundred jobs; its check is in the full set
        assert not monitor.check_state().num_rows
    comparisons.compared(engine, "stored", as_missing(final), *METHOD, as_missing(first))


def table(quality: list[int | None]) -> pa.Table:
    count = len(quality)
    values = [float(time % 7) for time in range(count)]
    return pa.table({"t": range(count), "current": values, "torque": values, "quality": quality})


def test_false_and_null_are_missing_and_a_wide_row_is_so_as_a_whole() -> None:
    quality = [(0, 192, 64, None)[time % 4] for time in range(400)]
    wide = gam_db.WideSource(
        table(quality), ["current", "torque"], None, "t", valid_when="quality IN (0, 192)"
    )
    rows: list[Row] = [
        ("asset", channel, time, float(time % 7) if time % 4 < 2 else None)
        for channel in ("current", "torque")
        for time in range(400)
    ]
    found = gam_db.health_indicator(wide, *METHOD).to_pylist()
    harness.assert_same(reference.health_indicator(rows, *METHOD), found)


def test_many_columns_are_valid_by_the_same_condition() -> None:
    columns = {f"c{number}": [float(time % 5) for time in range(300)] for number in range(60)}
    wide = pa.table({"t": range(300), "quality": [time % 3 for time in range(300)], **columns})
    source = gam_db.WideSource(wide, list(columns), None, "t", valid_when="quality > 0")
    rows: list[Row] = [
        ("asset", name, time, float(time % 5) if time % 3 else None)
        for name in columns
        for time in range(300)
    ]
    harness.assert_same(reference.support(rows, *METHOD), gam_db.support(source, *METHOD).to_pylist())


def test_words_are_read_before_they_are_held_to_the_condition(tmp_path: Path) -> None:
    path = tmp_path / "export.csv"
    path.write_text("t;v\n" + "".join(f"{time};{time % 7},5\n" for time in range(200)))
    source = gam_db.Source(str(path), None, None, "t", "v", decimal=",", valid_when="v > 2.5")
    rows: list[Row] = [
        ("asset", "v", time, time % 7 + 0.5 if time % 7 + 0.5 > 2.5 else None) for time in range(200)
    ]
    harness.assert_same(reference.support(rows, *METHOD), gam_db.support(source, *METHOD).to_pylist())


@pytest.mark.parametrize("condition", ["quality = :one", "no_such = 1", "SUM(quality) > 1", "quality >"])
def test_what_is_no_condition_on_the_source_is_refused(condition: str) -> None:
    source = gam_db.Source(table([1] * 99), None, None, "t", "current", valid_when=condition)
    with pytest.raises(SourceError, match=r"^valid_when is "):
        gam_db.support(source)


def test_a_dbt_package_holds_readings_to_the_condition() -> None:
    calibration = gam_db.Calibration(intervals=[(0, 100)])
    with duckdb.connect() as connection:
        connection.register("arrived", harness.arrow(readings(0, 260)))
        connection.execute("CREATE TABLE telemetry AS SELECT asset, channel, time, value FROM arrived")
        package = Package(gam_db.Source("telemetry", valid_when=CONDITION), METHOD[0], calibration)
        builder = dbt_builder.Builder(package.files(), connection)
        builder.build()
        found = builder.rows(
            "SELECT asset, SUM(novel) AS novel FROM gam_health GROUP BY asset ORDER BY asset"
        )
    rows = as_missing(readings(0, 260))
    expected = frozen.buckets(rows, rows, METHOD[0], calibration)
    assert [row["novel"] for row in found] == [
        sum(row["novel"] for row in expected if row["asset"] == asset) for asset in "ab"
    ]
    plain = Package(gam_db.Source("telemetry"), METHOD[0], calibration).files()
    hashed = [files["models/staging/gam_channel.sql"] for files in (plain, package.files())]
    assert hashed[0] != hashed[1]


def test_the_share_is_in_check_status_and_json(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with duckdb.connect("plant.duckdb") as connection:
        connection.register("held", table([64 if time % 4 == 0 else 192 for time in range(2000)]))
        connection.execute("CREATE TABLE r AS FROM held")
    named = [
        "--no-asset",
        "--no-channel",
        "--time",
        "t",
        "--value",
        "current",
        "--database",
        "plant.duckdb",
    ]
    said = ["--valid-when", "quality IN (0, 192)"]
    checked = gam("check", "r", *named, *said)
    assert "25 % of the rows do not meet quality IN (0, 192) (--valid-when)" in flat(checked)
    gam("calibrate", "r", *named, *said, "--window", "50", "--bins", "8")
    gam("score", "--database", "plant.duckdb")
    status = gam("status", "--database", "plant.duckdb")
    # Of 2,000 rows a run reads those after calibration, and the two before that a vector needs.
    assert "of the newest run do not meet valid_when and count as missing" in flat(status)
    held = json.loads(gam("status", "--database", "plant.duckdb", "--json"))["valid_when"]
    assert held["invalid"] * 4 == pytest.approx(held["held"], abs=4)
    gam("report", "--database", "plant.duckdb", "--out", "page.html")
    assert f'"validity":{{"held":{held["held"]},"invalid":{held["invalid"]}}}' in Path(
        "page.html"
    ).read_text().replace(" ", "")
    other = CliRunner().invoke(app, ["calibrate", "r", *named, "--valid-when", "quality = 1"])
    assert isinstance(other.exception, (SystemExit, ConfigurationError))
    assert "watches another source" in flat(other.output)


def gam(*words: str) -> str:
    result = CliRunner().invoke(app, list(words))
    assert result.exit_code in (0, 2), result.output
    return result.output


def flat(text: str) -> str:
    return " ".join(text.split())


def test_a_condition_that_asks_other_tables_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("a.csv").write_text("t,v\n1,2\n")
    result = CliRunner().invoke(app, ["check", "a.csv", "--valid-when", "v IN (SELECT 1)"])
    assert "valid_when is 'v IN (SELECT 1)'; it reads other tables" in flat(result.output)


def test_what_is_not_used_adds_nothing() -> None:
    plain = gam_db.render("view", "duckdb", gam_db.Source("t", time_kind="counter"))
    assert 'CAST("value" AS DOUBLE) AS reading' in plain
