"""The files of a package that are no models: project, source, schema, and what to read first.

This module owns the words that dbt users know; it makes no SQL.
"""

from collections.abc import Sequence
from typing import Any

from gam_db import data, template
from gam_db.export import dictionary, yaml_text
from gam_db.export.adapters import BUILT
from gam_db.export.models import CALIBRATED, SOURCE, TABLE, Model, Modelled
from gam_db.version import __version__

#: The test that no two rows share their keys, which dbt itself has not.
UNIQUE = "gam_unique_combination"

REQUIRED = [">=1.10.5", "<2.0.0"]
_HOUR = 3_600_000_000


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
    target = {"type": of.adapter.package.removeprefix("dbt-"), **of.adapter.profile, "threads": 1}
    said = {project_name(of.prefix): {"target": "plant", "outputs": {"plant": target}}}
    return (
        "# Copy this to profiles.yml and say where your warehouse is; schema, or dataset, is where the\n"
        f"# models go.\n{yaml_text.text(said)}"
    )


def sources(
    of: Modelled, table: str, schema: str | None, database: str | None, silent_after: int | None
) -> str:
    """Return the file that says where the telemetry lies.

    Args:
        of: what the models are made from.
        table: its name in the warehouse.
        schema: where it is; None for that of the target.
        database: where that is; None for that of the target.
        silent_after: microseconds after which no new row is worth a warning; None for a counter.
    """
    roles = {
        "asset": dictionary.meaning("channel", "asset"),
        "channel": dictionary.meaning("channel", "channel"),
        "time": dictionary.meaning("monitor", "time_column"),
        "value": dictionary.meaning("monitor", "value_column").partition(";")[0],
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
        if column in model.keys or dictionary.is_always_there(model.name, column):
            tests.append("not_null")
        if model.keys == (column,):
            tests.append("unique")
        if column in model.values:
            tests.append({"accepted_values": {"arguments": {"values": list(model.values[column])}}})
        said = {"name": column, "description": dictionary.meaning(model.name, column)}
        columns.append({**said, **({"data_tests": tests} if tests else {})})
    whole = {UNIQUE: {"arguments": {"columns": list(model.keys)}}}
    return {
        "name": f"{of.prefix}{model.name}",
        "description": dictionary.about(model.about),
        **({"data_tests": [whole]} if len(model.keys) > 1 else {}),
        "columns": columns,
    }


def readme(of: Modelled, table: str) -> str:
    """Return what somebody who opens the package should know first."""
    built = (
        "tested by really building it with this adapter"
        if of.engine.name in BUILT
        else "rendered for this engine, never yet built on it"
    )
    return data.text("gam_db.export", "readme.txt").format(
        name=project_name(of.prefix),
        prefix=of.prefix,
        version=__version__,
        engine=of.engine.name,
        adapter=of.adapter.package,
        built=built,
        stride=of.setting.stride,
        window=of.setting.window_length,
        taught=", ".join(f"{of.prefix}{model}" for model in CALIBRATED),
        lookback=of.lookback,
        unit="steps of the counter" if of.kind.is_counter else "microseconds",
        table=table,
    )
