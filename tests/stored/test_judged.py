"""One judgement in every form: status, limit, and why there is none, of a fleet with each of them."""

import json
import random
from pathlib import Path
from typing import Any

import duckdb
import pytest
from sqlglot import exp
from typer.testing import CliRunner

import engines
import gam_db
import harness
import scripts
from dbt_builder import Builder
from gam_db import template
from gam_db.cli import app
from gam_db.export import Package
from gam_db.findings import findings
from gam_db.pipeline import filled
from gam_db.stored.migration_files import definitions
from gam_db.stored.monitor import Monitor
from gam_db.study import Study
from visible import visible

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=8, window=20, stride=5)
CALIBRATION = gam_db.Calibration(intervals=[(0, 199)])

#: asset -> verdict, status, limit, why there is none, urgency; each verdict and status is there
EXPECTED = {
    "high": ("ready", "high", 0.05, None, 4),
    "fine": ("too_fine", "setup", None, "grid too fine for its calibration", 3),
    "short": ("needs_data", "setup", None, "calibration too short", 3),
    "waiting": ("ready", "waiting", 0.05, None, 2),
    "ok": ("ready", "ok", 0.05, None, 1),
    "constant": ("constant", "not assessed", None, "constant in calibration", 0),
    "no data": ("no_data", "not assessed", None, "no calibration", 0),
}

JUDGED = "asset, verdict, status, hi_limit, limit_reason, urgency, needs_attention, hi"


def fleet() -> list[Any]:
    """A channel for each; whatever has a verdict but ready shows nothing but novel states at the end."""
    chance = random.Random(1)
    noise = [chance.random() for _ in range(200)]
    values: dict[str, dict[int, float]] = {
        "ok": {time: time % 5 for time in range(400)},
        "high": {time: time % 5 if time < 300 else time % 7 * 3 for time in range(400)},
        "waiting": {time: time % 5 for time in range(210)},
        "constant": {time: 0 if time < 250 else time % 3 for time in range(400)},
        "no data": {time: time % 5 for time in range(300, 400)},
        "fine": {time: noise[time % 200] + (2 if time >= 300 else 0) for time in range(400)},
        "short": {time: 8.0 * (time in (196, 199)) if time < 200 else 9 for time in range(195, 400)},
    }
    return [
        (asset, "x", time, float(value))
        for asset, said in values.items()
        for time, value in said.items()
    ]


def told(rows: Any) -> dict[str, tuple[Any, ...]]:
    """What is said of each asset; the two words for attention must agree with one another."""
    found = {}
    for row in rows:
        assert bool(row["needs_attention"]) == (row["status"] in ("high", "setup"))
        columns = ("verdict", "status", "hi_limit", "limit_reason", "urgency")
        found[row["asset"]] = tuple(row[name] for name in columns if name in row)
    return found


def test_every_form_says_the_same_of_every_channel(engine: str) -> None:
    session = engines.session(engine)
    table = scripts.telemetry(session, fleet())
    source, prefix = gam_db.Source(table.name), engines.fresh_name("state")
    exact = findings(Study(session, source, PARAMETERS, CALIBRATION))
    assert told(exact) == EXPECTED
    monitor = Monitor(session, source, PARAMETERS, CALIBRATION, prefix=prefix)
    monitor.migrate()
    new = monitor.calibrate().to_pylist()
    unscored = {"high": "waiting", "ok": "waiting"}
    assert told(new) == {
        asset: (said[0], unscored.get(said[1], said[1]), *said[2:4]) for asset, said in EXPECTED.items()
    }
    monitor.score()
    stored = visible(monitor, f"SELECT {JUDGED} FROM gam_fleet")
    assert told(stored) == EXPECTED
    assert {row["asset"]: row["hi"] for row in stored} == {row["asset"]: row["hi"] for row in exact}
    assert [row["asset"] for row in stored if row["hi"] == 1.0 and row["status"] != "high"]
    above = visible(monitor, "SELECT asset FROM gam_fleet WHERE hi > hi_limit")
    status = monitor.status().to_pylist()
    assert told(status) == {asset: said[:4] for asset, said in EXPECTED.items()}
    assert [row["asset"] for row in status] == [row["asset"] for row in exact]
    named = [row["asset"] for row in status if any("above its limit" in one for one in row["remarks"])]
    assert [row["asset"] for row in above] == named == ["high"]


def test_so_do_the_commands_the_files_and_a_dbt_package(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with duckdb.connect("plant.duckdb") as connection:
        connection.register("rows", harness.arrow(fleet()))
        connection.execute("CREATE TABLE telemetry AS SELECT * FROM rows")
        connection.unregister("rows")
        package = Package(
            source=gam_db.Source("telemetry", time_kind="counter"),
            parameters=PARAMETERS,
            calibration=CALIBRATION,
            prefix="built_",
        )
        builder = Builder(package.files(), connection)
        builder.build()
        built = builder.rows(f"SELECT {JUDGED} FROM built_fleet")
    assert told(built) == EXPECTED
    method = ["--m=2", "--bins=8", "--window=20", "--stride=5", "--calibrate=0/199"]
    where = ["--database", "plant.duckdb"]

    def said(*words: str) -> list[dict[str, Any]]:
        result = CliRunner().invoke(app, [*words, *where, "--json"])
        assert result.exit_code == 2, result.output
        figures = json.loads(result.stdout)
        assert figures["needs_attention"]
        rows: list[dict[str, Any]] = figures.get("channels", [])
        return rows

    assert told(said("run", "telemetry", *method, "--out", "found.parquet")) == EXPECTED
    said("calibrate", "telemetry", *method)
    said("score")
    assert told(said("status")) == {asset: one[:4] for asset, one in EXPECTED.items()}
    files = "SELECT asset, verdict, hi_limit, limit_reason FROM 'found.support.parquet'"
    found = {asset: tuple(words) for asset, *words in duckdb.execute(files).fetchall()}
    assert found == {asset: (one[0], *one[2:4]) for asset, one in EXPECTED.items()}
    above = """
        SELECT DISTINCT asset
        FROM 'found.parquet' AS scored JOIN 'found.support.parquet' AS learnt USING (asset, channel)
        WHERE hi > hi_limit
    """
    assert duckdb.execute(above).fetchall() == [("high",)]


def test_the_view_of_the_state_judges_by_the_same_file() -> None:
    """A migration is a copy of what held when it came: the newest must be that of sql/judgement."""
    view = definitions()["fleet"].create.expression
    (judged,) = (one for one in view.find_all(exp.Subquery) if one.alias == "judged")
    (assessed,) = (one for one in judged.find_all(exp.Subquery) if one.alias == "assessed")
    rows = {column.alias: column.this for column in assessed.this.selects if column.alias != "assessed"}
    learnt = {name: exp.column(name, table="learnt") for name in ("verdict", "floor", "floor_max")}
    target = exp.column("target_floor", table="version")
    limit = template.fill("judgement/hi_limit", {**learnt, "target_floor": target})
    assert rows["hi_limit"] == limit
    for name in ("onset", "health"):
        columns = definitions()[name].create.expression.find_all(exp.Alias)
        copies = [one.this for one in columns if one.alias == "hi_limit"]
        assert copies == [limit], name
    assert rows["limit_reason"] == template.fill(
        "judgement/limit_reason", {"verdict": learnt["verdict"]}
    )
    columns = [exp.column(name) for name in rows]
    expected = filled("judgement/judged", {"columns": columns, "hi": exp.column("hi")})
    (table,) = expected.find_all(exp.Table)
    table.replace(assessed.copy())
    assert judged.this == expected
