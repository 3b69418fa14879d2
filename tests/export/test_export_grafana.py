"""``gam export grafana``: every query of the dashboard and the alert rule runs as Grafana sends it.

No Grafana is there to open it. Macros and variables are expanded here as its documentation says: those
of the two data sources, and the format ``sqlstring`` of a variable.
"""

import datetime as dt
import json
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
import yaml
from sqlglot import exp
from typer.testing import CliRunner

import engines
import gam_db
from gam_db.cli import app
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError
from gam_db.export import grafana
from gam_db.stored.schema.tables import StateTables

pytestmark = pytest.mark.thorough

PARAMETERS = gam_db.Parameters(m=2, tau=1, bins=5, window=20, stride=5)
CALIBRATION = gam_db.Calibration(intervals=[("2026-03-01", "2026-03-01T03:19:00")])
START, STEP = dt.datetime(2026, 3, 1), dt.timedelta(minutes=1)
EVER = (START, START + dt.timedelta(days=9))
NEVER = (START - dt.timedelta(days=9), START - dt.timedelta(days=8))

#: Names that would end a text, begin a comment, or mean a variable or a macro.
HOSTILE = (
    *(
        "a'b",
        "back\\",
        "\\'; DROP TABLE t --",
        'a"b',
        "$asset",
        "${asset}",
        "$__timeFilter(x)",
        "a, b",
        "",
    ),
    "calm",
)
SOURCES = ("postgres", "clickhouse")
JUDGED = ("proving", "open", "high", "ok")


@pytest.fixture(scope="module", params=SOURCES)
def plant(request: pytest.FixtureRequest) -> gam_db.Monitor:
    """A monitor of machines with hostile names; all but one leave health, ``short`` is not judged."""
    if request.param not in engines.chosen(request.config.getoption("--engines")):
        pytest.skip(f"--engines {request.param} was not asked for")
    session = engines.session(request.param)
    rows: list[Any] = [
        (asset, channel, START + i * STEP, float(i % 5 + (9 if i > 300 and asset != "calm" else 0)))
        for asset in HOSTILE
        for channel in ("it's", "y\\")
        for i in range(400)
    ]
    rows += [("calm", "short", START + i * STEP, 1.0) for i in range(205)]
    names = ("asset", "channel", "time", "value")
    table = exp.to_table(engines.fresh_name("telemetry"))
    columns: dict[str, Any] = {name: [row[at] for row in rows] for at, name in enumerate(names)}
    columns["time"] = pa.array(columns["time"], pa.timestamp("us"))
    with session.lent(pa.table(columns)) as lent:
        session.execute(session.engine.create_table(table, exp.select(*names).from_(lent)))
    source = gam_db.Source(table.name)
    prefix = engines.fresh_name("grafana") + "_"
    monitor = gam_db.Monitor(session, source, PARAMETERS, CALIBRATION, prefix=prefix)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    return monitor


def engine_of(monitor: gam_db.Monitor) -> str:
    return monitor.session.engine.name


def sqlstring(values: Sequence[str]) -> str:
    """A variable in the format ``sqlstring``: quoted, quotes doubled, commas between."""
    return ",".join("'" + value.replace("'", "''") + "'" for value in values)


def expanded(sql: str, engine: str, span: tuple[dt.datetime, dt.datetime], **chosen: Any) -> str:
    """A query as it is sent: macros of the data source, then variables."""
    begin, end = span
    if engine == "postgres":
        between = f"BETWEEN '{begin.isoformat()}Z' AND '{end.isoformat()}Z'"
        sql = sql.replace("$__timeFilter(last_time)", f"last_time {between}")
        group = "floor(extract(epoch from last_time)/1800)*1800"
        sql = sql.replace("$__timeGroup(last_time, $__interval)", group)
    else:
        first, last = (int(one.replace(tzinfo=dt.UTC).timestamp()) for one in span)
        between = f"last_time >= toDateTime({first}) AND last_time <= toDateTime({last})"
        sql = sql.replace("$__timeFilter(last_time)", between)
        stretch = "toStartOfInterval(toDateTime(last_time), INTERVAL 1800 second)"
        sql = sql.replace("$__timeInterval(last_time)", stretch)
    assert "$__" not in sql
    return re.sub(r"\$\{(asset|channel):sqlstring\}", lambda found: sqlstring(chosen[found[1]]), sql)


def rows_of(monitor: gam_db.Monitor, sql: str) -> list[dict[str, Any]]:
    assert isinstance(monitor.session, Session)
    found: list[dict[str, Any]] = monitor.session.driver.fetch(sql).to_pylist()
    return found


def test_every_query_runs_and_says_what_the_views_say(plant: gam_db.Monitor, tmp_path: Path) -> None:
    engine = engine_of(plant)
    grafana.write(engine, tmp_path, plant.state.tables)
    made = json.loads((tmp_path / grafana.DASHBOARD).read_text())
    assert "__inputs" not in made
    panels = {panel["type"]: panel for panel in made["panels"] if panel["title"] != "Machines now"}
    assert set(panels) == {"stat", "state-timeline", "timeseries", "table"}
    (ranked,) = (panel["targets"][0]["rawSql"] for panel in made["panels"] if panel["id"] == 5)
    assert len({panel["id"] for panel in made["panels"]}) == 5
    taken: set[tuple[int, int]] = set()
    for panel in made["panels"]:
        place = panel["gridPos"]
        assert place["x"] + place["w"] <= 24
        cells = {
            (x, y)
            for x in range(place["x"], place["x"] + place["w"])
            for y in range(place["y"], place["y"] + place["h"])
        }
        assert not cells & taken
        taken |= cells
        assert panel["datasource"] == {"type": grafana.SOURCES[engine]["plugin"], "uid": "${source}"}
    variables = {one["name"]: one for one in made["templating"]["list"]}
    assert variables["source"]["type"] == "datasource"
    assert all(
        variables[name]["multi"] and variables[name]["includeAll"] for name in ("asset", "channel")
    )

    assets = rows_of(plant, expanded(variables["asset"]["query"], engine, EVER))
    assert {row["__text"] for row in assets} == set(HOSTILE)
    assert list(assets[0]) == ["__value", "__text"]
    value = {row["__text"]: row["__value"] for row in assets}
    fleet = plant.status().to_pylist()
    limit = {(row["asset"], row["channel"]): row["hi_limit"] for row in fleet}
    health = [
        {**row, "hi_limit": limit[row["asset"], row["channel"]]}
        for row in plant.health().to_pylist()
        if row["hi"] is not None
    ]
    sql = {kind: panel["targets"][0]["rawSql"] for kind, panel in panels.items()}
    for names in (["a'b"], ["back\\"], ["\\'; DROP TABLE t --", "$asset", "a, b"], list(HOSTILE)):
        chosen = {"asset": [value[name] for name in names]}
        channels = rows_of(plant, expanded(variables["channel"]["query"], engine, EVER, **chosen))
        mine = [row for row in fleet if row["asset"] in names]
        assert {row["__text"] for row in channels} == {row["channel"] for row in mine}
        chosen["channel"] = [row["__value"] for row in channels if row["__text"] != "it's"]
        (counts,) = rows_of(plant, expanded(sql["stat"], engine, EVER, **chosen))
        assert counts == {
            "machines": len(names),
            "machines_above": len({row["asset"] for row in mine if row["onset"] is not None}),
            "signals": len(mine),
            "signals_above": sum(row["onset"] is not None for row in mine),
            "signals_not_judged": sum(row["status"] not in JUDGED for row in mine),
        }
        machines = rows_of(plant, expanded(ranked, engine, EVER, **chosen))
        assert {row["asset"]: row["above"] for row in machines} == {
            name: sum(row["asset"] == name and row["onset"] is not None for row in mine)
            for name in names
        }
        table = rows_of(plant, expanded(sql["table"], engine, EVER, **chosen))
        shown = [row for row in mine if row["channel"] != "it's"]
        assert {(row["asset"], row["channel"]): (row["status"], row["hi"]) for row in table} == {
            (row["asset"], row["channel"]): (row["status"], row["hi"]) for row in shown
        }
        rank = ["proving", "open", "high", "setup", "waiting", "ok", "not assessed"]
        order = [rank.index(row["status"]) for row in table]
        assert order == sorted(order)

        drawn = rows_of(plant, expanded(sql["timeseries"], engine, EVER, **chosen))
        assert list(drawn[0]) == ["time", "metric", "value"]
        assert [row["time"] for row in drawn] == sorted(row["time"] for row in drawn)
        expected = [row for row in health if row["asset"] in names and row["channel"] != "it's"]
        own = {f"{row['asset']} {row['channel']}" for row in expected}
        assert sorted(row["value"] for row in drawn if row["metric"] in own) == sorted(
            row["hi"] for row in expected
        )
        limits = [row["value"] for row in drawn if row["metric"] not in own]
        assert len(limits) == sum(row["hi_limit"] is not None for row in expected)
        over = rows_of(plant, expanded(sql["state-timeline"], engine, EVER, **chosen))
        assert list(over[0]) == ["time", "metric", "value"]
        assert [row["time"] for row in over] == sorted(row["time"] for row in over)
        above: dict[Any, set[str]] = {}
        for row in health:
            if row["asset"] in names and row["hi_limit"] is not None:
                key = (row["last_tick"] // 1_800_000_000, row["asset"])
                high = {row["channel"]} if row["hi"] > row["hi_limit"] else set()
                above.setdefault(key, set()).update(high)
        assert {(seconds(row["time"]) // 1800, row["metric"]): row["value"] for row in over} == {
            key: float(len(found)) for key, found in above.items()
        }
        for kind in ("timeseries", "state-timeline"):
            assert rows_of(plant, expanded(sql[kind], engine, NEVER, **chosen)) == []


def seconds(time: Any) -> int:
    """A time of a chart in seconds since 1970: a number, or a timestamp of UTC."""
    if isinstance(time, dt.datetime):
        return int(time.replace(tzinfo=dt.UTC).timestamp())
    return int(time)


def test_the_alert_rule_asks_for_what_is_above(plant: gam_db.Monitor, tmp_path: Path) -> None:
    engine = engine_of(plant)
    grafana.write(engine, tmp_path, plant.state.tables, uid="plant-db")
    made = yaml.safe_load((tmp_path / grafana.ALERT).read_text())
    ((rule,),) = [group["rules"] for group in made["groups"]]
    query, threshold = rule["data"]
    assert rule["condition"] == threshold["refId"] == "B"
    assert threshold["model"]["expression"] == query["refId"]
    assert (query["datasourceUid"], threshold["datasourceUid"]) == ("plant-db", "__expr__")
    assert threshold["model"]["conditions"] == [{"evaluator": {"type": "gt", "params": [0]}}]
    rows = rows_of(plant, query["model"]["rawSql"])
    fleet = [row for row in plant.status().to_pylist() if row["status"] in JUDGED]
    assert {(row["asset"], row["channel"]): row["value"] for row in rows} == {
        (row["asset"], row["channel"]): float(row["onset"] is not None) for row in fleet
    }
    assert {row["value"] for row in rows} == {0.0, 1.0}


@pytest.mark.parametrize("engine", SOURCES)
def test_the_command_writes_both_files_and_no_credentials(engine: str, tmp_path: Path) -> None:
    words = ["export", "grafana", str(tmp_path / "new"), "--engine", engine, "--schema", "plant"]
    done = CliRunner().invoke(app, words)
    assert done.exit_code == 0, done.output
    texts = [(tmp_path / "new" / name).read_text() for name in (grafana.DASHBOARD, grafana.ALERT)]
    assert all(text.count("plant") >= 1 and "password" not in text.lower() for text in texts)
    CliRunner().invoke(app, words)
    assert texts == [
        (tmp_path / "new" / name).read_text() for name in (grafana.DASHBOARD, grafana.ALERT)
    ]


def test_what_grafana_cannot_hold_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ConfigurationError, match=r"engine is 'duckdb'.*postgres, clickhouse"):
        grafana.write("duckdb", tmp_path, StateTables())
    with pytest.raises(ConfigurationError, match="would read as a variable"):
        grafana.write("postgres", tmp_path, StateTables("$plant"))
    (tmp_path / "file").write_text("")
    with pytest.raises(ConfigurationError, match="cannot be written"):
        grafana.write("postgres", tmp_path / "file", StateTables())
