"""``gam export dbt``: a dbt package, written from the same files of ``sql/`` as everything else.

This module owns what a package holds besides its models (:mod:`gam_db.export.models`), and how it is
written to a folder. What a column means is said in the words of the migrations, what a model holds in
those of the files of ``sql/``.
"""

from collections.abc import Collection
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sqlglot import exp

from gam_db import data
from gam_db.clock import Length, TimeKind
from gam_db.composing import template
from gam_db.engines import engine_named
from gam_db.engines.base import Engine
from gam_db.errors import SourceError, unwritable, wrong
from gam_db.export import yaml_text
from gam_db.export.modelling import Model, models
from gam_db.export.models import ADAPTERS, SOURCE, TABLE, Modelled
from gam_db.method import Method
from gam_db.method.parts import parts_of
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import (
    AnySource,
    Programs,
    WideSource,
    check_zone,
    declared_kind,
    is_file,
    repeat_of,
    table_names,
)
from gam_db.stored import lengths
from gam_db.stored.schema.migration_files import definitions
from gam_db.stored.schema.tables import StateTables
from gam_db.version import __version__

PROJECT = "dbt_project.yml"

#: The test that no two rows share their keys, which dbt itself has not.
UNIQUE = "gam_unique_combination"

REQUIRED = [">=1.10.5", "<2.0.0"]
_HOUR = 3_600_000_000

#: Columns that a package has and the state tables have not.
_PACKAGE_COLUMNS = {
    "calibration_no": "Which rule of calibration applies: 0 the general one, 1, 2, ... the overrides"
}

#: Where a column is looked for that the table of the same name has not.
_ELSEWHERE = ("channel", "version", "fleet", "health")


@dataclass(frozen=True)
class Package:
    """A dbt package for one source.

    Attributes:
        source: the table with the telemetry; a name with dots says where it is. Its ``time_kind`` says
            how it tells time; an integer counter if it is None.
        parameters: one set for all channels.
        calibration: closed intervals; overrides and pools are taken as well.
        engine: name of the engine that dbt runs on.
        schema: of the source table; None for that of the name, else that of dbt's target.
        prefix: begins the names of the models: letters, digits and underscores.
        lookback: how far behind the newest bucket of its channel a row may come; None for an hour, or no
            step of a counter.
        silent_after: after how long without a row dbt warns (source freshness); None for a day. A
            counter has no such warning.
        without: "curve" (how much calibration is needed) or "probe" (what would be seen). Default:
            nothing; where the range is that of all samples, as in the paper, both.

    Raises:
        UserError: any of it cannot be used.
    """

    source: AnySource
    parameters: Parameters
    calibration: Calibration
    engine: str = "duckdb"
    schema: str | None = None
    prefix: str = "gam_"
    lookback: Length | None = None
    silent_after: Length | None = None
    without: Collection[str] | None = None

    def files(self) -> dict[str, str]:
        """Return the text of each file by its path in the package."""
        if unknown := set(self.without or ()) - {"curve", "probe"}:
            raise wrong("dbt_without", part=min(unknown))
        catalog, place, table = self._place()
        engine = engine_named(self.engine)
        if (adapter := ADAPTERS.get(self.engine)) is None:
            raise wrong("dbt_no_adapter", engine=self.engine, names=", ".join(ADAPTERS))
        kind = declared_kind(self.source) or TimeKind.COUNTER
        programs = None if self.source.program is None else Programs(self.source.program)
        method = Method(self.parameters, self.calibration, kind, programs=programs)
        prefix = StateTables("any", self.prefix).prefix
        check_zone(self.source, kind)
        lookback = lengths.lookback(self.lookback, kind, repeat_of(self.source))
        parts = parts_of(self.parameters, self.without)
        of = Modelled(self.source, method, engine, adapter, prefix, lookback, parts)
        silent = None if kind.is_counter else lengths.park_after(self.silent_after, kind)
        files = {
            PROJECT: project(of),
            "profiles.example.yml": profiles(of),
            "README.md": readme(of, table),
            "models/sources.yml": sources(of, table, place, catalog, silent),
            f"tests/generic/{UNIQUE}.sql": _unique(engine),
        }
        by_folder: dict[str, list[dict[str, Any]]] = {}
        for model in models(of):
            files[f"{model.folder}/{prefix}{model.name}.sql"] = model.text
            if model.folder != "tests":
                by_folder.setdefault(model.folder, []).append(_described(of, model))
        for folder, described in by_folder.items():
            files[f"{folder}/schema.yml"] = yaml_text.text({"version": 2, "models": described})
        return files

    def _place(self) -> tuple[str | None, str | None, str]:
        """Return catalogue, schema and name of the source table."""
        relation = self.source.relation
        if self.source.of_words:
            raise wrong("script_reads_no_words", names=", ".join(self.source.of_words))
        if is_file(relation) or not isinstance(relation, (str, tuple, list)):
            raise wrong("dbt_no_table")
        if isinstance(self.source, WideSource) and self.source.channels is None:
            raise SourceError(
                "A dbt package of a wide table needs the names of its channels: channels=[...]."
            )
        parts = [part.name for part in table_names(relation)[0].parts]  # type: ignore[attr-defined]
        catalog, schema, table = [None] * (3 - len(parts)) + parts
        if schema and self.schema and schema != self.schema:
            raise wrong("dbt_two_schemas", schema=schema, said=self.schema)
        return catalog, schema or self.schema, table


def write(package: Package, folder: Path) -> list[Path]:
    """Write a package to a folder, and return the files that were written.

    The folder is an empty one, one that is made, or that of the same package: its files are replaced,
    and files that are not of the package stay.

    Raises:
        UserError: the package cannot be made, or the folder holds something else, or cannot be written.
    """
    files = package.files()
    try:
        _check_folder(folder, package.prefix)
        for path, text in files.items():
            (folder / path).parent.mkdir(parents=True, exist_ok=True)
            data.put(folder / path, text.encode())
    except OSError as error:
        raise unwritable(folder, error) from error
    return [folder / path for path in files]


def _check_folder(folder: Path, prefix: str) -> None:
    project = folder / PROJECT
    begin = project.read_text(encoding="utf-8") if project.is_file() else ""
    is_free = not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))
    if not (is_free or begin.startswith(mark(prefix))):
        raise wrong("dbt_folder_of_another", folder=folder, prefix=prefix)


def _unique(engine: Engine) -> str:
    """Return the generic test that no two rows have the same values in the given columns."""
    columns = exp.var("{{ columns | join(', ') }}")
    repeated = exp.GT(this=exp.Count(this=exp.Star()), expression=exp.Literal.number(1))
    query = exp.select(columns).from_(exp.Table(this=exp.var("{{ model }}")))
    text = engine.text(query.group_by(columns.copy()).having(repeated), pretty=True)
    return f"{{% test {UNIQUE}(model, columns) %}}\n\n{text}\n\n{{% endtest %}}\n"


def mark(prefix: str) -> str:
    """Return the line that marks a folder as a package of gam-db."""
    return f"# Written by gam export dbt, prefix {prefix}. Change gam.toml and write it again."


def project_name(prefix: str) -> str:
    """Return what the package is called in dbt."""
    return prefix.strip("_").lower() or "gam"


def project(of: Modelled) -> str:
    """Return dbt_project.yml."""
    name = project_name(of.prefix)
    config = {
        "name": name,
        "version": __version__,
        "config-version": 2,
        "profile": name,
        "require-dbt-version": REQUIRED,
        "model-paths": ["models"],
        "test-paths": ["tests"],
    }
    return f"{mark(of.prefix)}\n{yaml_text.text(config)}"


def profiles(of: Modelled) -> str:
    """Return profiles.example.yml, to be filled in as profiles.yml."""
    target = {"type": of.adapter["package"].removeprefix("dbt-"), **of.adapter["profile"], "threads": 1}
    config = {project_name(of.prefix): {"target": "plant", "outputs": {"plant": target}}}
    return (
        "# Copy this to profiles.yml and say where your warehouse is; schema, or dataset, is where the\n"
        f"# models go.\n{yaml_text.text(config)}"
    )


def sources(
    of: Modelled, table: str, schema: str | None, database: str | None, silent_after: int | None
) -> str:
    """Return the file of the source of the telemetry, with the microseconds until it is silent."""
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


def _described(of: Modelled, model: Model) -> dict[str, Any]:
    _, _, about = " ".join(model.comment.split()).partition(": ")
    described: dict[str, Any] = {
        "name": f"{of.prefix}{model.name}",
        "description": f"{about[:1].upper()}{about[1:]}",
    }
    if not model.keys:
        return described
    if len(model.keys) > 1:
        described["data_tests"] = [{UNIQUE: {"arguments": {"columns": list(model.keys)}}}]
    columns = []
    for column in model.columns:
        tests: list[Any] = []
        if column in model.keys or _is_always_there(model.name, column):
            tests.append("not_null")
        if model.keys == (column,):
            tests.append("unique")
        if column in model.values:
            tests.append({"accepted_values": {"arguments": {"values": list(model.values[column])}}})
        meaning = {"name": column, "description": _meaning(model.name, column)}
        columns.append({**meaning, **({"data_tests": tests} if tests else {})})
    return {**described, "columns": columns}


def _meaning(table: str, column: str) -> str:
    if column in _PACKAGE_COLUMNS:
        return _PACKAGE_COLUMNS[column]
    for name in (table, *_ELSEWHERE):
        columns = definitions()[name].columns
        if column in columns:
            return columns[column].name
    raise KeyError(column)


def _is_always_there(table: str, column: str) -> bool:
    """Tell whether a column of a table is never NULL; of views only the names are."""
    for name in (table, "channel", "version"):
        definition = definitions()[name]
        if column in definition.columns and not definition.is_view:
            (column_node,) = (node for node in definition.create.this.expressions if node.name == column)
            return column_node.find(exp.NotNullColumnConstraint) is not None
    return False


#: What the readme says besides where states are of programs.
_OF_PROGRAMS = (
    ", `{prefix}programs_are_judged`\n  of programs that calibration holds too little of, or nothing"
)


#: What it says where the probe is left out.
_UNPROBED = """

The models do not ask what would be seen: a channel that is `ready` may not show a change. Export with
`--without nothing` to have `gam_probe` and the verdict `blind`."""


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
        taught=", ".join(f"{of.prefix}{model}" for model in of.calibrated),
        lookback=of.lookback,
        unit="steps of the counter" if of.method.kind.is_counter else "microseconds",
        table=table,
        unprobed="" if "probe" in of.parts else _UNPROBED,
        programs=_OF_PROGRAMS.format(prefix=of.prefix) if of.setting.has_programs else "",
    )
