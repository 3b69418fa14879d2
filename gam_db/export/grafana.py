"""``gam export grafana``: a dashboard over the views, and an alert rule, as files that Grafana reads.

This module owns what Grafana's data sources want; what is asked stands in ``sql/export/grafana_*.sql``,
and the JSON is made by Grafana's own library.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sqlglot import exp

from gam_db import data
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.engines import engine_named
from gam_db.errors import ConfigurationError, wrong
from gam_db.export import yaml_text
from gam_db.extras import needed
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
        UserError: there is no such data source, Grafana's library is not installed, or the files cannot
            be written.
    """
    if engine not in SOURCES:
        raise wrong("grafana_no_source", engine=engine, names=", ".join(SOURCES))
    if "$" in f"{tables.schema or ''}{monitor}":
        raise wrong("grafana_variable")
    asked = queries(engine, tables, monitor)
    made = {DASHBOARD: dashboard(engine, asked), ALERT: alert(engine, asked["alert"], uid)}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in made.items():
            (folder / name).write_text(text, encoding="utf-8")
    except OSError as error:
        raise ConfigurationError(f"{folder} cannot be written: {error.strerror}.") from error
    return [folder / name for name in made]


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
        slots[f"{role}_value"] = said = exp.column(role)
        if source["escapes"]:  # Grafana doubles the quotes of a value, and leaves its backslashes
            doubled = (exp.Literal.string("\\"), exp.Literal.string("\\\\"))
            slots[f"{role}_value"] = exp.Anonymous(this="replaceAll", expressions=[said, *doubled])
    found: dict[str, str] = {}
    for name in ("assets", "channels", "counts", "machines", "indicator", "signals", "alert"):
        path = f"export/grafana_{name}"
        wanted = template.load(path).slots
        tree = filled(path, {slot: value for slot, value in slots.items() if slot in wanted})
        place(tree, tables.placed())
        found[name] = writer.text(tree, pretty=True)
    return found


def dashboard(engine: str, asked: Mapping[str, str]) -> str:
    """Return the dashboard as classic JSON, made by Grafana's own library."""
    source, builders = SOURCES[engine], needed("grafana_foundation_sdk.builders.dashboard", "grafana")
    models = needed("grafana_foundation_sdk.models.dashboard", "grafana")
    origin = models.DataSourceRef(type_val=source["plugin"], uid="${source}")

    def panel(kind: str, query: str, title: str, about: str, wide: int, high: int) -> Any:
        made = needed(f"grafana_foundation_sdk.builders.{kind}", "grafana").Panel()
        says = source["series" if kind in ("statetimeline", "timeseries") else "rows"]
        made.title(title).description(about).datasource(origin).span(wide).height(high)
        return made.with_target(_Target({"refId": "A", "rawSql": asked[query], **says}))

    def variable(name: str, label: str, query: str) -> Any:
        made = builders.QueryVariable(name).label(label).datasource(origin).query(asked[query])
        all_of_them = models.VariableOption(text="All", value="$__all")
        return made.multi(True).include_all(True).refresh(2).current(all_of_them)

    steps = [models.Threshold(value=None, color="green"), models.Threshold(value=1, color="orange")]
    above = builders.ThresholdsConfig().mode(models.ThresholdsMode.ABSOLUTE).steps(steps)
    coloured = builders.FieldColor().mode(models.FieldColorModeId.THRESHOLDS)
    about = "signals whose health indicator was above hi_limit, whatever their episodes said"
    over = panel("statetimeline", "machines", "Machines over time", about, 24, 9)
    panels = (
        panel("stat", "counts", "Now", "above: by episodes, or hi_limit where there are none", 24, 4),
        over.min(0).thresholds(above).color_scheme(coloured),
        panel("timeseries", "indicator", "Health indicator", "with its limit", 14, 10).min(0).max(1),
        panel("table", "signals", "Signals", "the most urgent first", 10, 10),
    )
    plan = builders.Dashboard("Health of the fleet").uid("gam-db-fleet").tags(["gam-db"])
    plan.timezone("browser").time("now-30d", "now").refresh("5m")
    plan.with_variable(builders.DatasourceVariable("source").label("Data source").type(source["plugin"]))
    plan.with_variable(variable("asset", "Machine", "assets"))
    plan.with_variable(variable("channel", "Signal", "channels"))
    for number, one in enumerate(panels, start=1):
        plan.with_panel(one.id(number))
    encoder = needed("grafana_foundation_sdk.cog.encoder", "grafana").JSONEncoder
    made = json.loads(encoder().encode(plan.build()))
    for one in made["panels"]:
        one["options"] = one["options"] or {}
    return json.dumps(made, sort_keys=True, indent=1) + "\n"


@dataclass(frozen=True)
class _Target:
    """A query as Grafana's library takes one, which has no type for those of SQL data sources."""

    said: Mapping[str, Any]

    def build(self) -> "_Target":
        return self

    def to_json(self) -> dict[str, Any]:
        return dict(self.said)


def alert(engine: str, sql: str, uid: str) -> str:
    """Return the alert rule as YAML of Grafana's provisioning: one alert per signal that is above."""
    said = json.loads(data.text("gam_db.export", "alert.json"))
    asked, _ = said["groups"][0]["rules"][0]["data"]
    asked["datasourceUid"] = uid
    asked["model"] |= {"rawSql": sql, **SOURCES[engine]["rows"]}
    return yaml_text.text(said)
