"""Running the steps of a pipeline on an engine; small ones become temporary tables.

This module owns when a step becomes a table and when that table goes.
"""

from collections.abc import Callable, Container, Mapping
from pathlib import Path
from typing import Any, Self, TypeAlias, TypeVar

import pyarrow as pa
from sqlglot import exp

from gam_db.composing.pipeline import Pipeline, Slots, Tables, filled, place
from gam_db.composing.plan import Kind, Plan, Statement, insertion
from gam_db.engines.session import Row, Session
from gam_db.errors import InternalError

Listener = Callable[[str], None]

#: Makes the step *readings* for a range of time.
Between: TypeAlias = Callable[[int, int], exp.Query]

#: Of channels that are read as they are stored, so many times the readings are calibrated together that
#: can be sorted at once: the cells of each block are kept, on a fine grid nearly a row for each vector,
#: and what finds no room goes to the disk.
TAUGHT = 2

T = TypeVar("T")

TWICE = "An instant occurs twice."


class RepeatedError(InternalError):
    """Statements expected each instant once, and their rows do not prove it."""


def once_more(
    work: Callable[[], T], collapse: Callable[[], None], again: Callable[[], T] | None = None
) -> T:
    """Do work; where an instant may occur twice, collapse the readings and do it once more.

    This is the only fall-back. Collapsed readings have each instant once, so it is needed once. What is
    done ``again`` may differ: a check goes on where damaged tables let a sample seem to come twice.
    """
    try:
        return work()
    except RepeatedError:
        collapse()
    return work() if again is None else again()


def unheard(_: str) -> None:
    """Ignore a step."""


class Running:
    """Steps at work.

    Args:
        session: an open session; the caller closes it.
        steps: the pipeline.
        tables: tables that stand for steps, or for what steps read from elsewhere.
        on_step: called with the name of each step before it is run.
    """

    def __init__(
        self,
        session: Session,
        steps: Pipeline,
        tables: Mapping[str, exp.Table] | None = None,
        on_step: Listener = unheard,
    ) -> None:
        self.session = session
        self.steps = steps
        self.tables: dict[str, exp.Table] = dict(tables or {})
        self.on_step = on_step
        self._materialized: dict[str, exp.Table] = {}

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.forget()

    def execute(
        self,
        plan: Plan,
        queries: Mapping[str, exp.Query] | None = None,
        target: Callable[[str], exp.Table] | None = None,
    ) -> dict[str, list[Row]]:
        """Execute the statements of a plan, but tables that are there already.

        Args:
            plan: what is executed.
            queries: those of this execution alone, by name, over the tables there are and the plan's
                named queries.
            target: gives the tables that rows are appended to, or deleted from.

        Returns:
            The rows of each answer, by its name.

        Raises:
            GamError: a verify has a row; it is the plan's error.
        """
        self.steps, answers = plan.steps, dict[str, list[Row]]()
        for name, kind, into, failure, is_input in plan.statements:
            is_there = name in self.tables or (is_input and self._is_spared(name, plan))
            if kind is Kind.QUERY or (kind is Kind.TABLE and is_there):
                continue
            if (query := (queries or {}).get(name)) is None:
                query = self.steps.query(name, self.tables)
            else:
                place(query := query.copy(), self.tables)
            if kind is Kind.TABLE:
                self.put(name, query)
            elif kind is Kind.ANSWER:
                answers[name] = self.session.rows(query)
            elif kind is Kind.VERIFY:
                if rows := self.session.rows(query):
                    assert failure is not None
                    raise failure(rows)
            else:
                assert target is not None
                if kind is Kind.APPEND:
                    self.session.execute(insertion(target(into), query))
                else:
                    self.session.delete(target(into), query.named_selects, query)
        return answers

    def _is_spared(self, name: str, plan: Plan) -> bool:
        """Tell whether no step reads an input any more, since an earlier round had no row."""
        if not any(step in self._materialized for step in self.steps.rounds):
            return False
        ends = [statement.name for statement in plan.statements if not statement.is_input]
        return all(step.name != name for step in self.steps.needed(ends, self.tables.keys()))

    def query(self, step: str) -> exp.Query:
        """Return the query of a step; the small steps before it are kept for the next one."""
        self.prepare(step)
        return self.steps.query(step, self.tables)

    def prepare(self, step: str) -> None:
        """Keep the small steps before a step."""
        self.execute(Plan.of(self.steps, [Statement(step, Kind.QUERY)], self.tables))

    def table(self, step: str) -> pa.Table:
        """Return the rows of a step."""
        query = self.query(step)
        self.on_step(step)
        return self.session.fetch(query)

    def rows(self, step: str) -> list[Row]:
        """Return the same, each row by the names of its columns."""
        query = self.query(step)
        self.on_step(step)
        return self.session.rows(query)

    def query_rows(
        self, path: str, slots: Slots | None = None, tables: Tables | None = None
    ) -> list[Row]:
        """Return the rows of a file of ``sql/`` over the steps; it does not become a step."""
        steps, name = self.steps.copied(), path.rpartition("/")[2]
        steps.fill(name, path, slots, tables)
        return self.session.rows(steps.query(name, self.tables))

    def largest(self, step: str, column: str) -> Any:
        """Return the largest value of a column of a step, which is kept."""
        self.keep(step)
        largest = exp.select(exp.Max(this=exp.column(column)).as_("marked"))
        return self.session.rows(largest.from_(self.tables[step].copy()))[0]["marked"]

    def write(self, step: str, path: Path, table: str) -> None:
        """Write the rows of a step as Parquet, or as a table of a DuckDB file."""
        query = self.query(step)
        self.on_step(step)
        self.session.write(query, path, table)

    def keep(self, step: str) -> None:
        """Keep a step as a table, and the small ones that it needs."""
        self.execute(Plan.of(self.steps, [Statement(step)], self.tables))

    def put(self, step: str, query: exp.Query) -> None:
        """Keep the rows of a query as the table of a step."""
        self.on_step(step)
        before = self._materialized.get(step)
        self._materialized[step] = self.tables[step] = self.session.keep(step, query)
        if before is not None:
            self.session.forget(before)
        if later := self.steps.rounds.get(step):
            counted = exp.select(exp.Count(this=exp.Star()).as_("rows")).from_(self.tables[step].copy())
            if not self.session.rows(counted)[0]["rows"]:
                self.tables.update(dict.fromkeys(later, self.tables[step]))

    def make(self, path: str, slots: Slots, step: str | None = None) -> None:
        """Keep the rows of a file of ``sql/`` over the tables there are, as a step, that of its name."""
        query = filled(path, slots)
        place(query, self.tables)
        self.put(step or path.rpartition("/")[2], query)

    def load(self, step: str, rows: pa.Table) -> None:
        """Use an Arrow table as the table of a step, instead of its former table."""
        if step in self._materialized:
            self.session.forget(self._materialized[step])
        self._materialized[step] = self.tables[step] = self.session.load(rows)

    def drop(self, step: str) -> None:
        """Drop the table of a step; on demand the step is made anew."""
        table = self._materialized.pop(step)
        self.session.forget(table)
        for name in [name for name, of in self.tables.items() if of is table]:
            del self.tables[name]

    def release(self, step: str) -> exp.Table:
        """Return the table of a step, which the caller drops; on demand the step is made anew."""
        del self.tables[step]
        return self._materialized.pop(step)

    def materialized(self, but: Container[str] = ()) -> list[str]:
        """Return the kept steps, except some."""
        return [step for step in self._materialized if step not in but]

    def forget(self, but: Container[str] = ()) -> None:
        """Drop the tables that were kept, but those of some steps."""
        for step in self.materialized(but):
            self.drop(step)
