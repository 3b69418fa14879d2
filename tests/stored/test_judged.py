"""One judgement in every form: status, limit, and why there is none, of a fleet with each of them."""

import dataclasses
import json
import random
from pathlib import Path
from typing import Any

import duckdb
import pytest
from pyarrow import parquet
from sqlglot import exp
from typer.testing import CliRunner

import engines
import gam_db
import harness
import scripts
from dbt_builder import Builder
from gam_db.cli import app
from gam_db.composing import template
from gam_db.composing.pipeline import filled
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ParameterError
from gam_db.export import Package
from gam_db.findings import findings
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.migration_files import definitions
from gam_db.study import Study, naming
from sets import amounts
from visible import visible

pytestmark = pytest.mark.thorough

PARAMETERS = gam_db.Parameters(
    m=2,
    tau=1,
    bins=8,
    window=20,
    stride=5,
    overrides=[gam_db.Override(asset="above", window=40)],  # its calibration is shorter than 8 windows
)
CALIBRATION = gam_db.Calibration(intervals=[(0, 199)])

#: asset -> verdict, status, limit, why there is none, urgency, judged by; each verdict and status of the
#: forms without episodes is there
INDICATED = {
    "raised": ("ready", "high", 0.05, None, 4, "indicator"),
    "late": ("ready", "high", 0.05, None, 4, "indicator"),
    "above": ("ready", "high", 0.05, None, 4, "indicator"),
    "fine": ("too_fine", "setup", None, "grid too fine for its calibration", 3, None),
    "short": ("needs_data", "setup", None, "calibration too short", 3, None),
    "waiting": ("ready", "waiting", 0.05, None, 2, "indicator"),
    "ok": ("ready", "ok", 0.05, None, 1, "indicator"),
    "constant": ("constant", "not assessed", None, "constant in calibration", 0, None),
    "no data": ("no_data", "not assessed", None, "no calibration", 0, None),
}

#: The same where there are episodes: of windows of 20, calibration gives a limit of judgements.
EXPECTED = INDICATED | {
    "raised": ("ready", "proving", 0.05, None, 6, "episode"),
    "late": ("ready", "open", 0.05, None, 5, "episode"),
    "waiting": ("ready", "waiting", 0.05, None, 2, "episode"),
    "ok": ("ready", "ok", 0.05, None, 1, "episode"),
}

#: What is said of those two once people said what they are.
DECIDED = EXPECTED | {
    "raised": ("ready", "setup", 0.05, "unrepresentative", 3, None),
    "late": ("ready", "open", 0.05, None, 2, "episode"),
}

JUDGED = (
    "asset, verdict, status, hi_limit, limit_reason, urgency, judged_by, needs_attention, is_above, hi"
)


def fleet() -> list[Any]:
    """A channel for each; whatever has a verdict but ready shows nothing but novel states at the end."""
    chance = random.Random(1)
    noise = [chance.random() for _ in range(200)]
    values: dict[str, dict[int, float]] = {
        "ok": {time: time % 5 for time in range(400)},
        "raised": {time: time % 5 if time < 300 else time % 7 * 3 for time in range(400)},
        "above": {time: time % 5 if time < 300 else time % 7 * 3 for time in range(400)},
        "late": {time: time % 5 if time < 460 else time % 7 * 3 for time in range(560)},
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
        if "urgency" in row:
            assert bool(row["needs_attention"]) == (row["urgency"] > 2)
            judged = {"proving": 1, "open": 1, "high": 1, "ok": 0}
            assert row["is_above"] == judged.get(row["status"])
        columns = ("verdict", "status", "hi_limit", "limit_reason", "urgency", "judged_by")
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
        asset: (said[0], unscored.get(said[1], said[1]), *said[2:4]) for asset, said in INDICATED.items()
    }
    monitor.score()
    stored = visible(monitor, f"SELECT {JUDGED} FROM gam_fleet")
    assert told(stored) == EXPECTED
    assert {row["asset"]: row["hi"] for row in stored} == {row["asset"]: row["hi"] for row in exact}
    assert [row["asset"] for row in stored if row["hi"] == 1.0 and row["is_above"] is None]
    above = visible(monitor, "SELECT asset FROM gam_fleet WHERE hi > hi_limit")
    assert status_of(monitor) == without_urgency(EXPECTED)
    status = monitor.status().to_pylist()
    assert [row["asset"] for row in status][:3] == ["raised", "late", "above"]
    named = {row["asset"] for row in status if any("above its limit" in one for one in row["remarks"])}
    assert {row["asset"] for row in above} == named == {"raised", "late", "above"}
    onsets = {row["asset"]: row["since_tick"] for row in visible(monitor, SINCE)}
    assert {row["asset"]: row["onset"] for row in status} == onsets
    alarms = visible(monitor, "SELECT asset, since_tick FROM gam_alarm ORDER BY asset")
    assert [(row["asset"], row["since_tick"]) for row in alarms] == [
        (asset, onsets[asset]) for asset in ("above", "late", "raised")
    ]
    listed = {(row["asset"], row["status"]) for row in monitor.alarms().to_pylist()}
    assert listed == {("late", "open"), ("raised", "proving"), ("above", "high")}
    assert sum(row["reason"] is None for row in monitor.limits().to_pylist()) == 4
    machines = visible(monitor, "SELECT asset, judged, above, not_judged, together FROM gam_machine")
    assert {row.pop("asset"): tuple(row.values()) for row in machines} == {
        asset: {"ok": (1, 0, 0, 0)}.get(said[1], (0, 0, 1, 0)) if said[4] < 4 else (1, 1, 0, 1)
        for asset, said in EXPECTED.items()
    }
    episodes = {row["asset"]: row["episode"] for row in status}
    monitor.label("acknowledged", episodes["late"])
    monitor.label("false_alarm", episodes["raised"])
    assert told(visible(monitor, f"SELECT {JUDGED} FROM gam_fleet")) == DECIDED
    assert status_of(monitor) == without_urgency(DECIDED)


#: What a run and a monitor say of a channel alike.
ALIKE = ("status", "needs_attention", "judged_by", "limit_reason", "hi", "hi_limit", "asking", "onset")


#: What each machine is, by what it is judged, why by nothing, and how many episodes ask.
OF_PLANT = {
    "calm": ("ok", "episode", None, 0),
    "late": ("open", "episode", None, 1),
    "over": ("blind", "episode", None, 0),
    "twice": ("proving", "episode", None, 2),
    "drifting": ("setup", None, "unrepresentative", 0),
    "new": ("ok", "indicator", None, 0),
    "jolted": ("blind", "episode", None, 0),
    "stuck": ("not assessed", None, "constant in calibration", 0),
}


def plant(chance: random.Random, machines: list[str], window: int) -> list[Any]:
    """Machines that fail at some times, drift, are new, are jolted for the last window, or are stuck."""
    faults = {"late": [(460, 500)], "over": [(448, 470)], "twice": [(230, 260), (330, 360)]}
    always = {"stuck": (0.0, 0), "jolted": (99.0, 500 - window)}
    rows = []
    for asset in machines:
        held, since = always.get(asset, (0.0, 500))
        for time in range(190 if asset == "new" else 0, 500):
            failed = any(first <= time < last for first, last in faults.get(asset, []))
            value = chance.choice([0.0, 1.0, 2.0]) + (asset == "drifting") * (time // 12)
            if chance.random() < (0.8 if failed else 0.05) and asset != "new":
                value = float(chance.randint(3, 40))
            rows.append((asset, "x", time, held if time >= since else value))
    return rows


@amounts("plants", 1, 40)
@pytest.mark.parametrize("machines", [1, len(OF_PLANT)])
def test_a_run_says_what_a_monitor_does(
    machines: int, plants: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for seed in range(plants):
        state = f"plant{seed}.duckdb"
        window = (4, 10)[seed % 2]
        rows = plant(random.Random(seed), list(OF_PLANT)[:machines], window)
        parquet.write_table(harness.arrow(rows), "plant.parquet")
        method = ["--m=1", "--bins=40", f"--window={window}", "--stride=2"]
        method += ["--calibrate=0/219", "--target-floor=0.9", "--rate=5 per 1000 judgements"]
        code, run = said("run", "plant.parquet", *method, "--no-out")
        said("calibrate", "plant.parquet", *method, "--database", state)
        scored, _ = said("score", "--database", state)
        left, status = said("status", "--database", state)
        assert code == scored == left == (0 if machines == 1 else 2)
        ours, theirs = (
            {row["asset"]: {name: row[name] for name in ALIKE} for row in figures["channels"]}
            for figures in (run, status)
        )
        assert ours == theirs
        said_of = ("status", "judged_by", "limit_reason", "asking")
        told = {name: tuple(row[one] for one in said_of) for name, row in ours.items()}
        if plants == 1:
            assert told == dict(list(OF_PLANT.items())[:machines])
        assert run["judged_by_episode"] == status["judged_by_episode"]
        shown = CliRunner().invoke(app, ["status", "--database", state]).stdout.split("\n")
        assert ("judged by episodes (gam limits)" in shown) == (machines == 1)


def test_a_run_says_the_same_whatever_short_cuts_it_takes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 5)
    monkeypatch.setattr(naming, "EVERY", 8)
    by_channel = plant(random.Random(0), [name for name in OF_PLANT if name != "new"], 4)
    by_time = sorted(by_channel, key=lambda row: row[2])
    parameters = gam_db.Parameters(m=1, bins=40, window=4, stride=2, target_floor=0.9)
    calibration = gam_db.Calibration(intervals=[(0, 219)])
    told = []
    for rows, form in ((by_time, "windows"), (by_time, "census"), (by_channel, "streams")):
        with DuckSession() as session:
            source = gam_db.Source(harness.arrow(rows))
            study = Study(session, source, parameters, calibration, short_cuts=form != "windows")
            found = findings(study, gam_db.Alarms("5 per 1000 judgements"))
            assert study.form == form
            told.append([{**row, "course": row["course"].tolist()} for row in found])
    assert str(told[0]) == str(told[1]) == str(told[2])
    assert {row["status"] for row in told[0]} >= {"proving", "open", "setup"}


def test_a_rate_in_days_of_a_counter_is_refused_before_all_is_read() -> None:
    with DuckSession() as session:
        source = gam_db.Source(harness.arrow(plant(random.Random(0), ["calm"], 4)))
        study = Study(session, source, gam_db.Parameters(), CALIBRATION)
        read: list[str] = []
        study.running.on_step = read.append
        with pytest.raises(
            ParameterError, match=("counts time in integers; give the rate per judgements")
        ):
            findings(study, gam_db.Alarms("1 per month"))
        assert not read


def said(*words: str) -> tuple[int, dict[str, Any]]:
    result = CliRunner().invoke(app, [*words, "--json"])
    return result.exit_code, json.loads(result.stdout)


SINCE = "SELECT asset, since_tick FROM gam_fleet"


def status_of(monitor: Monitor) -> dict[str, tuple[Any, ...]]:
    return told(monitor.status().to_pylist())


def without_urgency(said: dict[str, tuple[Any, ...]]) -> dict[str, tuple[Any, ...]]:
    return {asset: (*one[:4], one[5]) for asset, one in said.items()}


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
            parameters=dataclasses.replace(PARAMETERS, overrides=[]),  # a package has one set
            calibration=CALIBRATION,
            prefix="built_",
        )
        builder = Builder(package.files(), connection)
        builder.build()
        built = builder.rows(f"SELECT {JUDGED} FROM built_fleet")
    assert told(built) == INDICATED
    Path("gam.toml").write_text('[[override]]\nasset = "above"\nwindow = 40\n')
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
    assert told(said("status")) == without_urgency(EXPECTED)
    files = "SELECT asset, verdict, hi_limit, limit_reason FROM 'found.support.parquet'"
    found = {asset: tuple(words) for asset, *words in duckdb.execute(files).fetchall()}
    assert found == {asset: (one[0], *one[2:4]) for asset, one in EXPECTED.items()}
    above = """
        SELECT DISTINCT asset
        FROM 'found.parquet' AS scored JOIN 'found.support.parquet' AS learnt USING (asset, channel)
        WHERE hi > hi_limit
    """
    assert set(duckdb.execute(above).fetchall()) == {("raised",), ("late",), ("above",)}


def test_the_view_of_the_state_judges_by_the_same_file() -> None:
    """A migration is a copy of what held when it came: the newest must be that of sql/judgement."""
    view = definitions()["fleet"].create.expression
    (judged,) = (one for one in view.find_all(exp.Subquery) if one.alias == "judged")
    (assessed,) = (one for one in judged.find_all(exp.Subquery) if one.alias == "assessed")
    rows = {column.alias: column.this for column in assessed.this.selects if column.alias != "assessed"}
    floors = {name: exp.column(name) for name in ("floor", "floor_max", "target_floor")}
    limit = template.fill("judgement/limit", floors)
    limit = template.fill("judgement/hi_limit", {"verdict": exp.column("verdict"), "limit": limit})
    certified = definitions()["certified"].create.expression
    assert [one.this for one in certified.find_all(exp.Alias) if one.alias == "hi_limit"] == [limit]
    assert rows["hi_limit"] == exp.column("hi_limit", table="learnt")
    for name in ("onset", "health"):
        columns = definitions()[name].create.expression.find_all(exp.Alias)
        assert rows["hi_limit"] in [one.this for one in columns if one.alias == "hi_limit"], name
    verdict = exp.column("verdict", table="learnt")
    assert rows["limit_reason"] == template.fill("judgement/limit_reason", {"verdict": verdict})
    columns = [exp.column(name) for name in rows]
    known = {name: exp.column(name) for name in ("hi", "has_limit", "raised", "label", "sure", "asks")}
    expected = filled("judgement/judged", {"columns": columns, **known})
    (table,) = expected.find_all(exp.Table)
    table.replace(assessed.copy())
    assert judged.this == expected
    standing = filled("judgement/standing", {"columns": [exp.column("asset", table="judged")]})
    ours, theirs = ({one.alias: one.this for one in query.selects} for query in (standing, view))
    assert {name: ours[name] for name in ("status", "is_above")} == {
        name: theirs[name] for name in ("status", "is_above")
    }


def test_the_view_of_machines_ranks_by_the_same_file() -> None:
    """The same, by monitor."""
    view = definitions()["machine"].create.expression
    (ranked,) = (one for one in view.find_all(exp.Subquery) if one.alias == "ranked")
    made = ranked.this.copy()
    for column in [one for one in made.find_all(exp.Column) if one.name == "monitor"]:
        (column.parent if isinstance(column.parent, exp.Alias) else column).pop()
    for window in made.find_all(exp.Window):
        if not window.args.get("partition_by"):
            window.set("partition_by", None)
    (table,) = made.find_all(exp.Table)
    table.set("this", exp.to_identifier("signals"))
    expected = filled("judgement/machines")
    assert made.sql() == expected.sql()
