"""Pipelines: named SELECT steps, composed into one query or kept as tables on the way.

This module owns how steps refer to one another. It knows neither what they compute nor any engine.
"""

from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import Any, TypeAlias, cast

from sqlglot import exp

from gam_db.composing import template
from gam_db.errors import InternalError

Slots: TypeAlias = Mapping[str, template.Slot]
Tables: TypeAlias = Mapping[str, str]


@dataclass(frozen=True, eq=False)
class Definition:
    """The ingredients of a step; a step that is filled again in the same way has equal ones.

    Attributes:
        query: the filled tree; tables that carry the name of a step are read from that step.
        comment: what it computes, for whoever reads the query.
        reads: the steps it reads.
        tables: all names that a table may be placed for: the steps it reads, and what is no step.
    """

    query: exp.Query
    comment: str
    reads: frozenset[str]
    tables: frozenset[str]


class Step:
    """One named SELECT, made on demand: most questions need few steps of a method."""

    def __init__(self, name: str, make: Callable[[], Definition]) -> None:
        self.name, self._make = name, make

    @classmethod
    def of(cls, name: str, query: exp.Query, comment: str, inputs: Mapping[str, str]) -> "Step":
        """Return a step of a tree that reads its inputs by their own names, in a copy.

        The inputs are the steps, by what the tree calls them.
        """
        definition = _adopted(query, comment, tuple(sorted(inputs.items())))
        return cls(name, lambda: definition)

    @cached_property
    def definition(self) -> Definition:
        """Its ingredients."""
        return self._make()

    @property
    def query(self) -> exp.Query:
        """Its tree."""
        return self.definition.query


#: A step of a query: its name, what it is made of, and whether it is small.
Entry: TypeAlias = tuple[str, Definition, bool]


@dataclass
class Pipeline:
    """Steps in the order in which they were added; a step reads only what was added before it.

    Attributes:
        steps: by name.
        small: names of steps with few rows, which may be kept as tables on the way. All others are to
            flow through: an engine that keeps one because two steps read it loses more than it gains.
        rounds: steps, with those of the same columns that have no row where the step itself has none.
    """

    steps: dict[str, Step] = field(default_factory=dict)
    small: frozenset[str] = frozenset()
    rounds: dict[str, Sequence[str]] = field(default_factory=dict)

    def add(
        self, name: str, query: exp.Query, comment: str = "", tables: Mapping[str, str] | None = None
    ) -> None:
        """Add a step; its tree must not be changed from now on.

        Where the tree calls its inputs otherwise, ``tables`` says so: the name in the tree -> the step.
        """
        self._put(Step.of(name, query, comment, _inputs(_names(query), tables or {}, self.steps)))

    def fill(
        self,
        name: str,
        path: str,
        slots: Slots | Callable[[], Slots] | None = None,
        tables: Tables | Callable[[], Tables] | None = None,
    ) -> None:
        """Add a step from a file of ``sql/``, which is read and filled on demand.

        What was filled lately in the same way is not filled again: copies of trees are most of what a
        method costs that is asked for few rows. The path is ``folder/file``; slots and tables may be
        what gives them.
        """
        step_names = frozenset(self.steps)
        # Whoever gave them may go on with them before the step is made.
        held = slots if callable(slots) else dict(slots or {})
        renamed = tables if callable(tables) else dict(tables or {})

        def make() -> Definition:
            loaded = template.load(path)
            filled_slots = held() if callable(held) else held
            inputs = _inputs(loaded.tables, renamed() if callable(renamed) else renamed, step_names)
            return _filled(path, _hashable(filled_slots), tuple(sorted(inputs.items())))

        self._put(Step(name, make))

    def replace(self, name: str, query: exp.Query, tables: Mapping[str, str] | None = None) -> Step:
        """Let another tree be the one of a step, in its place in the order; return the step before."""
        before = self.steps[name]
        inputs = _inputs(_names(query), tables or {}, self.steps)
        self.put(Step.of(name, query, before.definition.comment, inputs))
        return before

    def put(self, step: Step) -> None:
        """Let a step be the one of its name."""
        self.steps[step.name] = step

    def _put(self, step: Step) -> None:
        if step.name in self.steps:
            raise InternalError(f"The step {step.name} is there twice.")
        self.steps[step.name] = step

    def copied(self) -> "Pipeline":
        """Return a pipeline of the same steps, to which others can be added."""
        return Pipeline(dict(self.steps), self.small, dict(self.rounds))

    def needed(self, targets: Iterable[str], existing: Iterable[str] = ()) -> list[Step]:
        """Return the steps that the targets need, in order, without what is given and its inputs."""
        excluded = set(existing)
        wanted = set(targets)
        pending = list(wanted - excluded)
        while pending:
            for read in self.steps[pending.pop()].definition.reads:
                if read not in excluded and read not in wanted:
                    wanted.add(read)
                    pending.append(read)
        return [step for step in self.steps.values() if step.name in wanted - excluded]

    def query(
        self, target: str, tables: Mapping[str, exp.Table] | None = None, commented: bool = False
    ) -> exp.Query:
        """Return one query for a step: the steps that it needs become its WITH list.

        Args:
            target: the step whose rows are wanted.
            tables: steps that exist as tables already.
            commented: put each step's comment before it.

        Returns:
            The tree; asked again in the same circumstances, the same one, so it must not be changed. One
            with comments is the caller's own.
        """
        tables, last = tables or {}, self.steps[target].definition
        steps = [step for step in self.needed([target], tables) if step.name != target]
        inputs = tuple((step.name, step.definition, step.name in self.small) for step in steps)
        read = {target}.union(last.tables, *(step.definition.tables for step in steps)) & tables.keys()
        parts = target, last, inputs, tuple((name, tables[name]) for name in sorted(read))
        return _composed(*parts, True) if commented else _composed_once(*parts)


def _composed(
    target: str,
    last: Definition,
    inputs: Sequence[Entry],
    places: Sequence[tuple[str, exp.Table]],
    commented: bool = False,
) -> exp.Query:
    """Return one query for a step; places are the steps that it reads and that are tables already."""
    tables = dict(places)
    if target in tables:
        query: exp.Query = _columns_of(target, last.query.named_selects)
        place(query, tables)
        return query
    query = last.query.copy()
    tables |= {name: _entry(name) for name, _, _ in inputs}
    place(query, tables)
    if not inputs:
        return query
    if isinstance(query, exp.SetOperation):
        query = selected_from(query)
    listed = []
    for name, step, is_small in inputs:
        body = step.query.copy()
        place(body, tables)
        entry = exp.CTE(this=body, alias=exp.TableAlias(this=_entry(name).this))
        if not is_small:
            entry.set("materialized", False)
        if commented and step.comment:
            body.comments = [f" {step.comment} "]
        listed.append(entry)
    query.set("with_", exp.With(expressions=listed))
    return query


#: A query takes about half a megabyte.
_composed_once = lru_cache(maxsize=256)(_composed)


@lru_cache(maxsize=4000)
def _filled(
    path: str, slots: tuple[tuple[str, Any, str], ...], inputs: tuple[tuple[str, str], ...]
) -> Definition:
    """Return a step that is a file of ``sql/``, with the steps that it reads by their names in it."""
    query = filled(path, {name: value for name, value, _ in slots})
    return _definition(query, template.load(path).comment, dict(inputs))


@lru_cache(maxsize=128)
def _adopted(query: exp.Query, comment: str, inputs: tuple[tuple[str, str], ...]) -> Definition:
    return _definition(query.copy(), comment, dict(inputs))


def _definition(query: exp.Query, comment: str, inputs: Mapping[str, str]) -> Definition:
    read_as(query, inputs)
    return Definition(query, comment, frozenset(inputs.values()), _names(query))


def _inputs(names: Iterable[str], tables: Tables, steps: Container[str]) -> dict[str, str]:
    """Return the steps that a query reads, by the names that it has for them."""
    steps_by_name = {name: tables.get(name, name) for name in names}
    return {name: step for name, step in steps_by_name.items() if step in steps}


def place(query: exp.Expr, tables: Mapping[str, exp.Table]) -> None:
    """Replace steps in a tree by their tables, in place."""
    for table in _plain_tables(query):
        if table.name in tables:
            target = tables[table.name].copy()
            target.set("alias", table.args.get("alias") or exp.TableAlias(this=table.this.copy()))
            table.replace(target)


def union_of(
    pipeline: Pipeline, parts: Sequence[str], columns: Sequence[str] | None = None
) -> exp.Query:
    """Return the union of the rows of several steps: the given columns, else all of the first."""
    columns = columns or pipeline.steps[parts[0]].query.named_selects
    selects = [_columns_of(part, columns) for part in parts]
    return selects[0] if len(selects) == 1 else exp.union(*selects, distinct=False)


def _columns_of(step: str, columns: Sequence[str]) -> exp.Select:
    named = exp.select(*(exp.column(exp.to_identifier(name)) for name in columns))
    return named.from_(exp.Table(this=exp.to_identifier(step)))


def filled(name: str, slots: Mapping[str, template.Slot] | None = None) -> exp.Query:
    """Return a filled template that is a query."""
    return cast(exp.Query, template.fill(name, slots))


def read_as(query: exp.Expr, inputs: Mapping[str, str]) -> None:
    """Replace other names of steps in a tree by their names, in place."""
    for table in _plain_tables(query):
        step = inputs.get(table.name)
        if step is not None:
            if step != table.name and not table.args.get("alias"):
                table.set("alias", exp.TableAlias(this=table.this.copy()))
            table.set("this", exp.to_identifier(step))


def _hashable(slots: Mapping[str, template.Slot]) -> tuple[tuple[str, Any, str], ...]:
    """Return slots with how numbers are written: 1 is not 1.0, and 0.0 not -0.0."""
    plain = sorted((name, tuple(of) if isinstance(of, Sequence) else of) for name, of in slots.items())
    return tuple((name, of, "" if isinstance(of, (exp.Expr, tuple)) else repr(of)) for name, of in plain)


def _entry(step: str) -> exp.Table:
    """Return how a query names a step in its WITH list.

    The name is ours alone: some engines take the user's relation for a step of the same name, even for
    one that stands further down the list.
    """
    return exp.Table(this=exp.to_identifier(f"gam_step_{step}"))


def selected_from(union: exp.Query) -> exp.Query:
    """Wrap a union, since not every engine takes a WITH list before one."""
    columns = [exp.column(exp.to_identifier(name), table="rows_of") for name in union.named_selects]
    rows = union.subquery("rows_of", copy=False)
    return exp.select(*(column.as_(column.name) for column in columns)).from_(rows, copy=False)


def _names(query: exp.Expr) -> frozenset[str]:
    return frozenset(table.name for table in _plain_tables(query))


def _plain_tables(query: exp.Expr) -> list[exp.Table]:
    return [
        table
        for table in query.find_all(exp.Table)
        if isinstance(table.this, exp.Identifier) and not table.this.quoted and not table.db
    ]
