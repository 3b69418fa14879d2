"""``gam export grafana``: a dashboard over the views, and an alert rule, as files for Grafana.

This module owns what Grafana's data sources want; what is asked stands in ``sql/export/grafana_*.sql``,
what is shown in ``dashboard.json`` and ``alert.json``, where a query is called by its name.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from sqlglot import exp

from gam_db import data
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.engines import engine_named
from gam_db.errors import unwritable, wrong
from gam_db.export import yaml_text
from gam_db.stored.schema.tables import StateTables

DASHBOARD, ALERT = "gam-dashboard.json", "gam-alert.yaml"


#: What Grafana's data sources want of a query, by engine; see the file.
SOURCES: Mapping[str, Mapping[str, Any]] = data.table("gam_db.export", "grafana.toml")


def write(
    engine: str, folder: Path, tables: StateTables, monitor: str = "default", uid: str = "gam-db"
) -> list[Path]:
    """Write the dashboard and the alert rule to a folder; return their paths.

    ``uid`` is that of Grafana's data source, which an alert rule must name.

    Raises:
        UserError: there is no such data source, or the files cannot be written.
    """
    if engine not in SOURCES:
        raise wrong("grafana_no_source", engine=engine, names=", ".join(SOURCES))
    if "$" in f"{tables.schema or ''}{monitor}":
        raise wrong("grafana_variable")
    queries_by_name = queries(engine, tables, monitor)
    files = {
        DASHBOARD: dashboard(engine, queries_by_name),
        ALERT: alert(engine, queries_by_name["alert"], uid),
    }
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in files.items():
            data.put(folder / name, text.encode())
    except OSError as error:
        raise unwritable(folder, error) from error
    return [folder / name for name in files]


def queries(engine: str, tables: StateTables, monitor: str) -> dict[str, str]:
    """Return the SQL of every variable, panel and rule, with Grafana's macros and variables in it."""
    source, writer = SOURCES[engine], engine_named(engine)
    slots: dict[str, template.Slot] = {
        "monitor": template.text(monitor),
        "assets": exp.var("${asset:sqlstring}"),
        "channels": exp.var("${channel:sqlstring}"),
        "stretch": exp.var(source["stretch"]),
        "shown": exp.var("$__timeFilter(last_time)"),
    }
    for role in ("asset", "channel"):
        slots[f"{role}_value"] = role_column = exp.column(role)
        if source["escapes"]:  # Grafana doubles the quotes of a value, and leaves its backslashes
            doubled = (exp.Literal.string("\\"), exp.Literal.string("\\\\"))
            slots[f"{role}_value"] = exp.Anonymous(
                this="replaceAll", expressions=[role_column, *doubled]
            )
    texts: dict[str, str] = {}
    for name in ("assets", "channels", "counts", "machines", "ranked", "indicator", "signals", "alert"):
        path = f"export/grafana_{name}"
        wanted = template.load(path).slots
        tree = filled(path, {slot: value for slot, value in slots.items() if slot in wanted})
        place(tree, tables.nodes())
        texts[name] = writer.text(tree, pretty=True)
    return texts


def dashboard(engine: str, queries_by_name: Mapping[str, str]) -> str:
    """Return the dashboard as classic JSON: the one beside this file, for a data source."""
    source, board = SOURCES[engine], json.loads(data.text("gam_db.export", "dashboard.json"))
    origin, *variables = board["templating"]["list"]
    origin["query"] = source["plugin"]
    for part in (*variables, *board["panels"]):
        part["datasource"]["type"] = source["plugin"]
    for variable in variables:
        variable["query"] = queries_by_name[variable["query"]]
    for panel in board["panels"]:
        (target,) = panel["targets"]
        says = source["series" if panel["type"] in ("state-timeline", "timeseries") else "rows"]
        target |= {"rawSql": queries_by_name[target["rawSql"]], **says}
    return json.dumps(board, sort_keys=True, indent=1) + "\n"


def alert(engine: str, sql: str, uid: str) -> str:
    """Return the alert rule as YAML of Grafana's provisioning: one alert per signal that is above."""
    rules = json.loads(data.text("gam_db.export", "alert.json"))
    query, _ = rules["groups"][0]["rules"][0]["data"]
    query["datasourceUid"] = uid
    query["model"] |= {"rawSql": sql, **SOURCES[engine]["rows"]}
    return yaml_text.text(rules)
