"""``gam export dbt``: a dbt package, written from the same files of ``sql/`` as everything else.

This module owns what a package holds and how it is written to a folder. The models are made in
:mod:`gam_db.export.models`.
"""

from dataclasses import dataclass
from pathlib import Path

from sqlglot import exp

from gam_db import template
from gam_db.calibration import Calibration
from gam_db.clock import Length, TimeKind
from gam_db.engines import engine_named
from gam_db.engines.base import Engine
from gam_db.errors import ConfigurationError, EngineError, SourceError
from gam_db.export import documents, jinja
from gam_db.export.models import ADAPTERS, Model, Modelled, checks, models
from gam_db.method import Method
from gam_db.parameters import Parameters
from gam_db.source import AnySource, WideSource, declared_kind, is_file, table_names
from gam_db.stored import lengths
from gam_db.stored.tables import StateTables

PROJECT = "dbt_project.yml"


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

    def files(self) -> dict[str, str]:
        """Return the text of each file by its path in the package."""
        catalog, schema, table = self._place()
        engine = engine_named(self.engine)
        if (adapter := ADAPTERS.get(self.engine)) is None:
            raise EngineError(
                f"dbt has no adapter for {self.engine}; take one of {', '.join(ADAPTERS)}."
            )
        kind = declared_kind(self.source) or TimeKind.COUNTER
        method = Method(self.parameters, self.calibration, kind)
        prefix = StateTables("any", self.prefix).prefix
        lookback = lengths.lookback(self.lookback, kind)
        of = Modelled(self.source, method, engine, adapter, prefix, lookback)
        silent = None if kind.is_counter else lengths.park_after(self.silent_after, kind)
        made = models(of)
        files = {
            PROJECT: documents.project(of),
            "profiles.example.yml": documents.profiles(of),
            "README.md": documents.readme(of, table),
            "models/sources.yml": documents.sources(of, table, schema, catalog, silent),
            f"tests/generic/{documents.UNIQUE}.sql": _unique(engine),
        }
        for folder in dict.fromkeys(model.folder for model in made):
            inside = [model for model in made if model.folder == folder]
            files[f"{folder}/schema.yml"] = documents.schema(of, inside)
        for model in made:
            files[f"{model.folder}/{prefix}{model.name}.sql"] = _text(model, engine)
        for test in checks(of):
            files[f"{test.folder}/{prefix}{test.name}.sql"] = _text(
                test, engine, adapter.get("before", "")
            )
        return files

    def _place(self) -> tuple[str | None, str | None, str]:
        """Return catalogue, schema and name of the source table."""
        relation = self.source.relation
        if is_file(relation) or not isinstance(relation, (str, tuple, list)):
            raise SourceError(
                "A dbt source is a table of the warehouse; load the file into one and name that."
            )
        if isinstance(self.source, WideSource) and self.source.channels is None:
            raise SourceError("A dbt package of a wide table needs its channels named: channels=[...].")
        node = table_names(relation)[0]
        parts = [part.name for part in node.parts]  # type: ignore[attr-defined]
        catalog, schema, table = [None] * (3 - len(parts)) + parts
        if schema and self.schema and schema != self.schema:
            raise ConfigurationError(
                f"The source lies in the schema {schema!r}, and --schema says {self.schema!r}; give one."
            )
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
            (folder / path).write_text(text, encoding="utf-8")
    except OSError as error:
        raise ConfigurationError(f"{folder} cannot be written: {error.strerror}.") from error
    return [folder / path for path in files]


def _check_folder(folder: Path, prefix: str) -> None:
    if not folder.exists() or (folder.is_dir() and not any(folder.iterdir())):
        return
    project = folder / PROJECT
    begin = project.read_text(encoding="utf-8") if project.is_file() else ""
    if not begin.startswith(documents.mark(prefix)):
        raise ConfigurationError(
            f"{folder} holds something else than a dbt package with the prefix {prefix!r} that gam "
            "wrote; name an empty folder."
        )


def _text(model: Model, engine: Engine, before: str = "") -> str:
    """Return the file of a model, or of a test with what is run before it."""
    for tree in (model.query, model.later):
        if tree is not None:
            jinja.check_is_free(tree)
    about = "\n".join(f"-- {line}" for line in template.load(model.about).comment.splitlines())
    first = engine.text(model.query, pretty=True)
    if model.later is None:
        body = first
    else:
        body = jinja.in_two_forms(engine.text(model.later, pretty=True), first)
    head = [jinja.config(model.config)] if model.config else []
    head += [jinja.run(before)] if before else []
    return "\n\n".join([*head, about, body]) + "\n"


def _unique(engine: Engine) -> str:
    """Return the generic test that no two rows have the same values in the given columns."""
    columns = exp.var("{{ columns | join(', ') }}")
    repeated = exp.GT(this=exp.Count(this=exp.Star()), expression=exp.Literal.number(1))
    query = exp.select(columns).from_(exp.Table(this=exp.var("{{ model }}")))
    text = engine.text(query.group_by(columns.copy()).having(repeated), pretty=True)
    return f"{{% test {documents.UNIQUE}(model, columns) %}}\n\n{text}\n\n{{% endtest %}}\n"
