"""The files of a package that are no models: project, source, schema, and what to read first.

This module owns the words that dbt users know; it makes no SQL. What a column means is said in the words
of the migrations, what a model holds in those of the files of ``sql/``: nothing is said twice.
"""

from collections.abc import Sequence
from typing import Any

from sqlglot import exp

from gam_db import data, template
from gam_db.export import yaml_text
from gam_db.export.models import CALIBRATED, SOURCE, TABLE, Model, Modelled
from gam_db.stored.migration_files import definitions
from gam_db.version import __version__

#: The test that no two rows share their keys, which dbt itself has not.
UNIQUE = "gam_unique_combination"

REQUIRED = [">=1.10.5", "<2.0.0"]
_HOUR = 3_600_000_000

#: Columns that a package has and the state tables have not.
_OWN = {
    "calibration_no": "Which rule of calibration applies: 0 the general one, 1, 2, ... the overrides"
}

#: Where a column is looked for that the table of the same name has not.
_ELSEWHERE = ("channel", "version", "fleet", "health")


def mark(prefix: str) -> str:
    """Return the line by which a folder is known as a package of ours."""
    return f"# Written by gam export dbt, prefix {prefix}. Change gam.toml and write it again."


def project_name(prefix: str) -> str:
    """Return what the package is called in dbt."""
    return prefix.strip("_").lower() or "gam"


def project(of: Modelled) -> str:
    """Return dbt_project.yml."""
    name = project_name(of.prefix)
    said = {
        "name": name,
        "version": __version__,
        "config-version": 2,
        "profile": name,
        "require-dbt-version": REQUIRED,
        "model-paths": ["models"],
        "test-paths": ["tests"],
    }
    return f"{mark(of.prefix)}\n{yaml_text.text(said)}"


def profiles(of: Modelled) -> str:
    """Return profiles.example.yml, to be filled in as profiles.yml."""
    target = {"type": of.adapter["package"].removeprefix("dbt-"), **of.adapter["profile"], "threads": 1}
    said = {project_name(of.prefix): {"target": "plant", "outputs": {"plant": target}}}
    return (
        "# Copy this to profiles.yml and say where your warehouse is; schema, or dataset, is where the\n"
        f"# models go.\n{yaml_text.text(said)}"
    )


def sources(
    of: Modelled, table: str, schema: str | None, database: str | None, silent_after: int | None
) -> str:
    """Return the file that says where the telemetry lies; after how many microseconds it is silent."""
    roles = {
        "asset": _meaning("channel", "asset"),
        "channel": _meaning("channel", "channel"),
        "time": _meaning("monitor", "time_column"),
        "value": _meaning("monitor", "value_column").partition(";")[0],
    }
    columns = [
        {"name": column, "description": roles.get(role, roles["value"])}
        for role, column in of.source.columns.items()
    ]
    described: dict[str, Any] = {"name": TABLE, "identifier": table}
    described["description"] = "The telemetry that the models read."
    if silent_after is not None:
        hours = max(1, silent_after // _HOUR)
        described["config"] = {
            "loaded_at_field": of.engine.text(template.column(of.source.time)),
            "freshness": {"warn_after": {"count": hours, "period": "hour"}},
        }
    place = {"database": database} if database else {}
    place["schema"] = schema or "{{ target.schema }}"
    described["columns"] = columns
    return yaml_text.text({"version": 2, "sources": [{"name": SOURCE, **place, "tables": [described]}]})


def schema(of: Modelled, models: Sequence[Model]) -> str:
    """Return the descriptions and the tests of models."""
    return yaml_text.text({"version": 2, "models": [_described(of, model) for model in models]})


def _described(of: Modelled, model: Model) -> dict[str, Any]:
    columns = []
    for column in model.columns:
        tests: list[Any] = []
        if column in model.keys or _is_always_there(model.name, column):
            tests.append("not_null")
        if model.keys == (column,):
            tests.append("unique")
        if column in model.values:
            tests.append({"accepted_values": {"arguments": {"values": list(model.values[column])}}})
        said = {"name": column, "description": _meaning(model.name, column)}
        columns.append({**said, **({"data_tests": tests} if tests else {})})
    _, _, about = " ".join(template.load(model.about).comment.split()).partition(": ")
    whole = {UNIQUE: {"arguments": {"columns": list(model.keys)}}}
    return {
        "name": f"{of.prefix}{model.name}",
        "description": f"{about[:1].upper()}{about[1:]}",
        **({"data_tests": [whole]} if len(model.keys) > 1 else {}),
        "columns": columns,
    }


def _meaning(table: str, column: str) -> str:
    """Return what a column means."""
    if column in _OWN:
        return _OWN[column]
    for name in (table, *_ELSEWHERE):
        columns = definitions()[name].columns
        if column in columns:
            return columns[column].name
    raise KeyError(column)


def _is_always_there(table: str, column: str) -> bool:
    """Tell whether a column of a table is never NULL; nothing is said of views but of their names."""
    for name in (table, "channel", "version"):
        definition = definitions()[name]
        if column in definition.columns and not definition.is_view:
            (found,) = (one for one in definition.create.this.expressions if one.name == column)
            return found.find(exp.NotNullColumnConstraint) is not None
    return False


def readme(of: Modelled, table: str) -> str:
    """Return what somebody who opens the package should know first."""
    built = (
        "tested by really building it with this adapter"
        if "built" in of.adapter
        else "rendered for this engine, never yet built on it"
    )
    return data.text("gam_db.export", "readme.txt").format(
        name=project_name(of.prefix),
        prefix=of.prefix,
        version=__version__,
        engine=of.engine.name,
        adapter=of.adapter["package"],
        built=built,
        stride=of.setting.stride,
        window=of.setting.window_length,
        taught=", ".join(f"{of.prefix}{model}" for model in CALIBRATED),
        lookback=of.lookback,
        unit="steps of the counter" if of.kind.is_counter else "microseconds",
        table=table,
    )
