"""Printing: the steps of a script as tables and views, each with a comment.

This module owns which step becomes a table, which a view, and which is spelled out by its only reader.
"""

import re
from collections.abc import Callable, Collection, Container, Iterable, Iterator, Mapping

from sqlglot import exp

from gam_db.composing.brief import shortened
from gam_db.composing.layout import commented, laid_out
from gam_db.composing.pipeline import Pipeline, selected_from
from gam_db.composing.selects import direct_columns, sources_of, step_of
from gam_db.composing.tidy import inlined, tidied
from gam_db.engines.base import Engine
from gam_db.method.parts import RESULTS

#: Steps that are views over the live source. All others that two steps read are tables.
VIEWS = (
    *("samples", "history", "codes", "breaking_codes", "moving_codes", "vectors", "novelty"),
    *("health_indicator", "health"),
)
OBJECTS = (
    *("samples", "history", "codes", "breaking_codes", "moving_codes", "vectors", "novelty"),
    *("channels", "bounds", "visits", "support", "blocks", "support_summary"),
)


#: What ends a sentence of a comment; the first one is printed, without the pages that it names.
SENTENCE = re.compile(r"(?<=[.?])\s+(?=[A-Z])")
PAGES = re.compile(r"\s*\([^()]*\bsections? [^()]*\)|, method section \d")

OF_SIGNAL = "One signal."

#: In which order the exact form gives its rows.
ORDER = ("asset", "channel", "time")


class Script:
    """A script of an engine.

    Args:
        steps: of :func:`gam_db.method.printed.printed_pipeline`.
        engine: that it is for.
        parts: what the script has.
    """

    def __init__(self, steps: Pipeline, engine: Engine, parts: Collection[str]) -> None:
        self.steps, self.engine = steps, engine
        read = steps.steps["readings"].query.find_all(exp.Table)
        #: Names of tables of the user's, which no step of a WITH list may bear.
        self.taken = {table.name.lower() for table in read}
        self.results = [name for name, part in RESULTS.items() if part in parts]
        #: Without the certificate nothing judges: the view is the indicator alone.
        self.names = {} if self.results else {"health_indicator": "health"}
        self.results = self.results or ["health_indicator"]

    def exact(self) -> str:
        """Return the query of the health indicator, a row per scored vector."""
        queries = self._tidied(["health_indicator"])
        query = self._composed("health_indicator", queries, {}, commented=True)
        query.set("order", in_order())
        return f"{self._text(query)};\n"

    def view(self, named: Callable[[str], exp.Table]) -> str:
        """Return the statements of the view form, whose tables are named so."""
        return "\n".join(self._statements(named))

    def _tidied(self, results: Collection[str]) -> dict[str, exp.Query]:
        queries = {name: step.query for name, step in self.steps.steps.items()}
        tidy_steps = tidied(queries, results)
        readers = [reader for reader in tidy_steps.values() if reads(reader, "readings")]
        if len(readers) == 1:
            inlined(readers[0], "readings", tidy_steps.pop("readings"))
        objects = self._objects(tidy_steps) if self.results == results else list(tidy_steps)
        inline_single(tidy_steps, objects)
        columns = dict(tidy_steps)
        return {name: shortened(query, self.engine.brief, columns) for name, query in tidy_steps.items()}

    def _statements(self, named: Callable[[str], exp.Table]) -> Iterator[str]:
        """Give the statements of the view form, in one transaction where that undoes them."""
        engine, queries = self.engine, self._tidied(self.results)
        self.engine = engine.unordered()
        objects = self._objects(queries)
        passing = self._passing(objects, queries)
        is_new = engine.swaps == "rename"
        tables = {name: named(f"{'new_' * is_new}{self.names.get(name, name)}") for name in objects}
        if is_new and engine.temporary is not None:
            tables |= {name: exp.to_table(f"{engine.temporary}.{name}") for name in passing}
        if engine.swaps:
            yield "BEGIN;"
        if engine.swaps not in ("rename", "replace"):
            yield from self._dropped(objects, named, reversed(objects))
        for name in objects:
            query = self._composed(name, queries, tables)
            if self._kind(name) == "VIEW":
                statement = exp.Create(this=tables[name].copy(), kind="VIEW", expression=query)
            else:
                statement = engine.create_table(tables[name], query)
            statement.set("replace", engine.swaps == "replace")
            yield f"\n{self._comment(name)}\n{self._text(statement)};"
        yield ""
        yield from self._dropped(passing, tables.__getitem__, passing, exists=False)
        if is_new:
            lasting = [name for name in objects if name not in passing]
            function = exp.Drop(tables=[named("health_of")], kind="FUNCTION", exists=True)
            yield f"{engine.text(function)};"
            yield from self._dropped(lasting, named, reversed(lasting))
            for name in lasting:
                renamed = exp.AlterRename(this=exp.to_table(named(name).name))
                swap = exp.Alter(this=tables[name].copy(), kind=self._kind(name), actions=[renamed])
                yield f"{engine.text(swap)};"
        if engine.of_signal is not None:
            yield f"\n-- {OF_SIGNAL}"
            yield f"{self._text(engine.of_signal(named('health_of'), named('health')))};"
        if engine.swaps:
            yield "COMMIT;"
        yield ""

    def _dropped(
        self,
        names: Collection[str],
        named: Callable[[str], exp.Table],
        order: Iterable[str],
        exists: bool = True,
    ) -> Iterator[str]:
        """Give the statements that drop tables and views, views first."""
        ordered = list(order)
        for kind in ("VIEW", "TABLE"):
            tables = [named(name) for name in ordered if self._kind(name) == kind and name in names]
            if self.engine.drops_several:
                if tables:
                    drop = exp.Drop(tables=tables, kind=kind, exists=exists)
                    yield f"{self._text(drop)};"
                continue
            for table in tables:
                yield f"{self.engine.text(exp.Drop(tables=[table], kind=kind, exists=exists))};"

    def _passing(self, objects: list[str], queries: dict[str, exp.Query]) -> list[str]:
        """Return the tables that only the script itself reads."""
        views = [name for name in objects if self._kind(name) == "VIEW"]
        read = {
            step
            for view in views
            for table in self._composed(
                view, queries, {name: exp.to_table(name) for name in objects}
            ).find_all(exp.Table)
            if (step := step_of(table, objects)) is not None
        }
        tables = [name for name in objects if self._kind(name) == "TABLE"]
        return [name for name in tables if name not in read and name not in self.results]

    def _objects(self, queries: Mapping[str, exp.Query]) -> list[str]:
        """Return the steps that are tables or views: the others have one reader among these."""
        return owners_of(
            queries, lambda name, owners: name in self.results or _stem(name) in OBJECTS or owners > 1
        )

    def _kind(self, name: str) -> str:
        return "VIEW" if _stem(name) in VIEWS else "TABLE"

    def _composed(
        self,
        name: str,
        queries: Mapping[str, exp.Query],
        tables: Mapping[str, exp.Table],
        commented: bool = False,
    ) -> exp.Query:
        comments = (
            {step: of.definition.comment for step, of in self.steps.steps.items()} if commented else {}
        )
        return composed(name, queries, tables, self.taken, comments)

    def _text(self, tree: exp.Expr) -> str:
        return laid_out(self.engine.text(tree), self.engine.dialect)

    def _comment(self, name: str) -> str:
        first, *_ = SENTENCE.split(self.steps.steps[name].definition.comment, 1)
        return "\n".join(commented(PAGES.sub("", first)))


def in_order() -> exp.Order:
    """Return the order of the rows of the exact form."""
    return exp.Order(expressions=[exp.Ordered(this=exp.column(name)) for name in ORDER])


def composed(
    name: str,
    queries: Mapping[str, exp.Query],
    tables: Mapping[str, exp.Table],
    taken: Collection[str] = (),
    comments: Mapping[str, str] | None = None,
) -> exp.Query:
    """Return the query of a step over the tables there are; others it needs are its WITH list.

    Args:
        name: of the step.
        queries: tidied, by name, each after those that it reads.
        tables: the steps that are tables, views or models.
        taken: names that no step of the list may bear.
        comments: of steps in the list, by name.
    """
    needed = spelled_out(name, queries, tables)
    query = queries[name].copy()
    tables_by_step = {step: table for step, table in tables.items() if step != name}
    tables_by_step |= {step: exp.to_table(f"gam_step_{step}") for step in needed if step in taken}
    _place(query, tables_by_step)
    entries = []
    for step in needed:
        body = queries[step].copy()
        _place(body, tables_by_step)
        if comments:
            body.comments = [comments[step]]
        alias = tables_by_step[step].name if step in tables_by_step else step
        entries.append(exp.CTE(this=body, alias=exp.TableAlias(this=exp.to_identifier(alias))))
    if isinstance(query, exp.SetOperation) and (entries or not tables):
        query = selected_from(query)
    if entries:
        query.set("with_", exp.With(expressions=entries))
    return query


def spelled_out(name: str, queries: Mapping[str, exp.Query], tables: Collection[str]) -> list[str]:
    """Return the steps that a step needs and that are no tables, in order."""
    needed: set[str] = set()
    pending = [name]
    while pending:
        inputs = read_by(queries[pending.pop()], queries) - needed - set(tables)
        needed |= inputs
        pending += inputs
    return [step for step in queries if step in needed]


def inline_single(queries: dict[str, exp.Query], objects: Collection[str]) -> None:
    """Inline a step that is not an object into its only reader, if that reads nothing else."""
    inputs = {name: read_by(query, queries) for name, query in queries.items()}
    for name in [name for name in queries if name not in objects]:
        readers = [reader for reader in queries if name in inputs[reader]]
        if len(readers) == 1 and _is_all_it_reads(queries[readers[0]], name):
            inlined(queries[readers[0]], name, queries.pop(name))
            inputs[readers[0]] = inputs.pop(name)


def owners_of(queries: Mapping[str, exp.Query], is_object: Callable[[str, int], bool]) -> list[str]:
    """Return the steps that are objects of their own, in order.

    Whether a step is one follows from its name and from how many objects read it, itself or through
    steps that are none.
    """
    readers: dict[str, set[str]] = {name: set() for name in queries}
    objects: list[str] = []
    for name in reversed(list(queries)):
        if is_object(name, len(readers[name])):
            objects.append(name)
            readers[name] = {name}
        for step in read_by(queries[name], queries):
            readers[step] |= readers[name]
    return objects[::-1]


def _place(query: exp.Query, tables_by_step: dict[str, exp.Table]) -> None:
    """Let a query read tables; one of which no column is named by it keeps its own name."""
    for select in query.find_all(exp.Select):
        named = {column.table for column in direct_columns(select)}
        steps = [step_of(source, tables_by_step) for source, _ in sources_of(select)]
        for source, _ in sources_of(select):
            if (step := step_of(source, tables_by_step)) is not None:
                target = tables_by_step[step].copy()
                if source.alias_or_name in named or steps.count(step) > 1:
                    target.set("alias", exp.TableAlias(this=exp.to_identifier(source.alias_or_name)))
                source.replace(target)


def _is_all_it_reads(reader: exp.Query, name: str) -> bool:
    """Tell whether a query reads only a step, once."""
    tables = list(reader.find_all(exp.Table))
    is_whole = isinstance(reader, exp.Select) and not reader.args.get("joins")
    return is_whole and len(tables) == 1 and step_of(tables[0], (name,)) is not None


def reads(query: exp.Expr, name: str) -> bool:
    """Tell whether a query reads a step."""
    return any(step_of(table, (name,)) for table in query.find_all(exp.Table))


def read_by(query: exp.Expr, steps: Container[str]) -> set[str]:
    """Return the steps that a query reads."""
    return {name for table in query.find_all(exp.Table) if (name := step_of(table, steps)) is not None}


def _stem(step: str) -> str:
    """Return a step's name without the numbers of its round and its set."""
    stem, _, number = step.rpartition("_")
    return _stem(stem) if number.isdigit() else step
