"""Scripts: a whole form as SQL that a warehouse team runs with no Python at all.

Two forms (method, section 4): *exact*, one query from the source to the health indicator, and *view*,
tables for what calibration found and a plain view over the live source. This module owns what such a
script holds and in which order; it needs no connection and no driver.
"""

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial

import pyarrow as pa
from sqlglot import exp

from gam_db.arguments import public
from gam_db.clock import TimeKind, looks_like_calendar
from gam_db.composing import template
from gam_db.composing.brief import shortened
from gam_db.composing.layout import commented, laid_out
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.tidy import tidied
from gam_db.engines import engine_named
from gam_db.engines.base import Engine
from gam_db.errors import EngineError, ParameterError, SourceError, nearest, wrong
from gam_db.export.printing import OF_SIGNAL, Script, composed, in_order
from gam_db.method import Method, pipeline
from gam_db.method.parts import LEFT_OUT, PARTS, RESULTS, parts_of
from gam_db.method.printed import printed_pipeline, rename
from gam_db.reading.ahead import latest_live
from gam_db.reading.preparing import prepared
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.setting import settings_of
from gam_db.settings.source import (
    AnySource,
    Programs,
    WideSource,
    declared_kind,
    is_file,
    shown_relation,
    table_names,
)

FORMS = ("exact", "view")

#: Tables of the view form that only its own script needs: small steps that several statements read. As
#: steps of a query they would be spelled out, and on some engines planned, once for each reader.
_PASSING = (
    *("timeline", "series", "limits", "calibrated", "range_counts", "range", "visits"),
    "taught_programs",
    *("missing_vectors", "block_sizes", "cells", "blocks", "ladder", "spread"),
    *("probed", "usual", "probe", "sight", "limited"),
)
_LASTING = ("channels", "calibration", "bounds", "support", "programs")
#: Comments on the views, besides what they compute.
_ABOUT = ("The health indicator over the live source, against what calibration found once.\n", "")
_RESULTS = ("support_summary", "certificate", "probes")


@public
def render(
    form: str,
    engine: str,
    source: AnySource,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    prefix: str = "gam_live_",
    schema: str | None = None,
    without: Collection[str] | None = None,
) -> str:
    """Return the complete SQL script of a form for an engine.

    Args:
        form: "exact", one query, a row per scored vector; or "view", tables <prefix>channels,
            <prefix>bounds, <prefix>support, <prefix>support_summary, <prefix>certificate and
            <prefix>probes, the view <prefix>health over the live source, and the views that lead to it
            (docs/script.md). DuckDB and PostgreSQL also get the function <prefix>health_of(asset,
            channel). Where the source names a program, also the table <prefix>programs and the view
            <prefix>program_summary. The script takes the place of what bears these names: the tables of
            a monitor, which begin with gam_ unless a prefix is given, are others.
        engine: its name, see ``gam_db.engines.NAMES``.
        source: where the telemetry lies. Without ``time_kind`` the time column is taken for what a file
            shows or the given instants mean, else for an integer counter, and the script says so.
        parameters: of the method; default :class:`Parameters`.
        calibration: the healthy part; default the first fifth of each channel.
        prefix: of the names of the view form.
        schema: where they lie; None for the current one, on PostgreSQL for ``public``: its script looks
            no name up on the path, so that nobody else's function or operator runs.
        without: what is left out of the view form: "certificate" (with it all that judges), "curve" (how
            much calibration is needed) or "probe" (what would be seen). Default: nothing; where the
            range is that of all samples, as in the paper, the curve and the probe.

    Raises:
        UserError: the form or engine is unknown, or the source cannot be read there.
    """
    if unknown := set(without or ()) - set(PARTS):
        part = min(unknown)
        raise ParameterError(f"There is no part {part!r}{nearest(part, PARTS)}")
    if form not in FORMS:
        raise ParameterError(f"There is no form {form!r}{nearest(form, FORMS)}")
    parameters, calibration = parameters or Parameters(), calibration or Calibration()
    chosen = engine_named(engine)
    if schema is not None and not chosen.schemas:
        raise EngineError(f"{engine} has no schemas; leave schema out and give another prefix.")
    source, kind, is_sure, relation, is_whole = _looked_at(source, parameters, calibration, chosen)
    programs = None if source.program is None else Programs(source.program, is_whole is True)
    method = Method(parameters, calibration, kind, programs=programs)
    head = [
        _described(parameters),
        f"Time: {kind.value}"
        + ("." if is_sure else ", assumed; say time_kind='timestamp' if it is not."),
    ]
    if programs is not None and is_whole is None:
        head.append(f"Programs are numbered by their texts, though {programs.column} may hold numbers.")
    begin = chosen.beginning()
    if (
        chosen.guard is not None
        and not (kind.is_counter and is_sure)
        and not kind.has_zone
        and isinstance(relation, exp.Table)
    ):
        begin += f"{chosen.text(chosen.guard(relation, source.time, kind))};\n"

    def place(name: str) -> exp.Table:
        table = exp.to_table(f"{prefix}{name}")
        if schema is not None:
            table.set("db", template.name(schema))
        return table

    rows = chosen.readings(source, relation, kind, until=latest_live(source, chosen, kind))
    if "names" in chosen.brief:
        rename(rows)
    parts, instant = parts_of(parameters, without), partial(chosen.instant_of, kind)
    if not method.pools and method.programs is None:
        steps = printed_pipeline(method, rows, instant, parts, "frames" in chosen.brief)
        script = Script(steps, chosen, parts)
        body = script.exact() if form == "exact" else script.view(place)
        return f"{_commented(head)}\n{begin}\n{body}"
    statements = _Statements(pipeline(method, rows, instant), chosen, parts)
    if form == "exact":
        return f"{_commented(head)}\n{begin}\n{statements.exact()}"
    body = "\n".join(
        f"{_commented(comment.splitlines())}\n{statements.text(statement)};\n"
        for comment, statement in statements.view(place)
    )
    return f"{_commented(head)}\n{begin}\n{body}"


class _Statements:
    """The statements of a script where channels share supports or machines run programs.

    Args:
        steps: of :func:`gam_db.method.pipeline`.
        engine: that the script is for.
        parts: what the script has.
    """

    def __init__(self, steps: Pipeline, engine: Engine, parts: Collection[str]) -> None:
        self.steps, self.engine = steps, engine
        self.results = [name for name in _RESULTS if RESULTS[name] in parts]
        self.absent = {
            column for part, columns in LEFT_OUT.items() if part not in parts for column in columns
        }
        for name, part in (("outlook", "curve"), ("sight", "probe")):
            for step in [step for step in steps.steps if _table_of(step) == name and part not in parts]:
                steps.replace(step, exp.select(exp.alias_(exp.null(), "support_id")).where(exp.false()))

    def exact(self) -> str:
        """Return the query of the health indicator, a row per scored vector."""
        query = self._composed("health_indicator", self._tidied(["health_indicator"]), {})
        query.set("order", in_order())
        return f"{self.text(query)};\n"

    def view(self, place: Callable[[str], exp.Table]) -> Iterator[tuple[str, exp.Expr]]:
        """Give the statements of the view form in order, each with its comment."""
        steps, engine = self.steps, self.engine
        views = ["health_indicator", *["program_summary"] * ("program_summary" in steps.steps)]
        lasting = [name for name in steps.steps if _table_of(name) in _LASTING]
        queries = self._tidied([*lasting, *self.results, *views])
        names = [name for name in queries if _table_of(name) in (*_PASSING, *_LASTING)]
        tables: dict[str, exp.Table] = {}
        yield "Begin anew: a view goes before the tables it reads.", _drop("VIEW", place("health"))
        if len(views) > 1:
            yield "So does what machines ran since.", _drop("VIEW", place("program_summary"))
        for name in (*names, *self.results):
            table = place(name)
            query = self._composed(name, queries, tables)
            yield f"{name}: {engine.name} keeps this step as a table.", _drop("TABLE", table)
            yield steps.steps[name].definition.comment, engine.create_table(table, query)
            tables[name] = table
        live = {name: table for name, table in tables.items() if name in lasting}
        for name, called, about in zip(views, ("health", "program_summary"), _ABOUT, strict=False):
            view = self._composed(name, queries, live)
            comment = f"{about}{steps.steps[name].definition.comment}"
            yield comment, exp.Create(this=place(called), kind="VIEW", expression=view)
        if engine.of_signal is not None and engine.swaps == "replace":
            yield OF_SIGNAL, engine.of_signal(place("health_of"), place("health"))
        for name in names:
            if name not in lasting:
                yield f"{name} is no longer needed.", _drop("TABLE", place(name))

    def text(self, tree: exp.Expr) -> str:
        """Return a statement as it is printed."""
        return laid_out(self.engine.text(tree), self.engine.dialect)

    def _tidied(self, results: Sequence[str]) -> dict[str, exp.Query]:
        queries = {name: step.query.copy() for name, step in self.steps.steps.items()}
        for name, query in queries.items():
            query.set("order", None)
            if name in self.results and isinstance(query, exp.Select):
                held = [part for part in query.expressions if part.alias_or_name not in self.absent]
                query.set("expressions", held)
        tidy_steps = tidied(queries, results, by_name=False, keys={"channels": "channel_id"})
        columns = dict(tidy_steps)
        brief = self.engine.brief
        return {
            name: shortened(query, brief, columns, filled=False) for name, query in tidy_steps.items()
        }

    def _composed(
        self, name: str, queries: Mapping[str, exp.Query], tables: Mapping[str, exp.Table]
    ) -> exp.Query:
        comments = {step: of.definition.comment for step, of in self.steps.steps.items()}
        read = self.steps.steps["readings"].query.find_all(exp.Table)
        # Where an alias goes before a column, a step must not be called as a column is.
        is_apart = "names" in self.engine.brief
        taken = {table.name.lower() for table in read} if is_apart else set(self.steps.steps)
        return composed(name, queries, tables, taken, comments)


def _table_of(step: str) -> str:
    """Return a step's name without the numbers of its round and its set."""
    stem, _, number = step.rpartition("_")
    return _table_of(stem) if number.isdigit() else step


def _drop(kind: str, table: exp.Table) -> exp.Drop:
    return exp.Drop(tables=[table.copy()], kind=kind, exists=True)


def _looked_at(
    source: AnySource, parameters: Parameters, calibration: Calibration, engine: Engine
) -> tuple[AnySource, TimeKind, bool, exp.Expr, bool | None]:
    """Return what a script knows of its source.

    Returns:
        The source with its channels named, its kind of time, whether that is sure, the node, and whether
        its programs are whole numbers, None where nothing tells.
    """
    declared, relation = declared_kind(source), source.relation
    if is_file(relation):
        if not engine.reads_files:
            raise wrong("engine_reads_no_files", name=engine.name, relation=shown_relation(relation))
        if source.encoding is not None:
            raise wrong("script_reads_no_words", names="encoding")
        from gam_db.engines.duckdb.session import DuckSession

        with DuckSession() as session:
            read = prepared(session, source)
            program = source.program
            is_whole = program is not None and session.engine.types.is_whole(read.columns[program])
            return read.rows, read.kind, True, session.following(read.relation), is_whole
    if source.of_words:
        raise wrong("script_reads_no_words", names=", ".join(source.of_words))
    if isinstance(source, WideSource) and source.channels is None:
        raise SourceError("A script of a wide table needs the names of its channels: channels=[...].")
    if isinstance(source.relation, pa.Table):
        raise SourceError("A script needs a table that the engine holds, not an Arrow table.")
    if not isinstance(relation, (str, tuple, list)):
        raise wrong("script_of_a_frame")
    node = table_names(relation)[0]
    if declared is not None:
        return source, declared, True, node, None
    calendar = tells_calendar(parameters, calibration)
    return source, TimeKind.TIMESTAMP if calendar else TimeKind.COUNTER, calendar, node, None


def tells_calendar(parameters: Parameters, calibration: Calibration) -> bool:
    """Tell whether a setting can only mean a calendar, as the time column then does."""
    pairs = (*(calibration.intervals or ()), *calibration.exclude)
    times = [calibration.duration, calibration.score_from, *(end for pair in pairs for end in pair)]
    times += [variant.max_gap for variant in parameters.variants()]
    return any(value is not None and looks_like_calendar(value) for value in times)


def _described(parameters: Parameters) -> str:
    shown = [
        f"{name}\xa0=\xa0{value}"
        for name in settings_of(Parameters)
        if (value := getattr(parameters, name)) is not None and name != "stride"
    ]
    others = f"; {len(parameters.overrides)} overrides" if parameters.overrides else ""
    return f"{', '.join(shown)}{others}."


def _commented(lines: list[str]) -> str:
    texts = (of for text in lines for of in text.splitlines() or [""])
    return "\n".join(line for of in texts for line in commented(of) or ["--"])
