"""Plans: the statements of a job in their order, made before any of them runs.

This module owns what kinds of statements there are. A plan reads its named queries from a pipeline; it
knows neither what they compute nor how an engine runs them.
"""

from collections.abc import Callable, Container, Iterable, Sequence
from enum import Enum
from typing import Any, NamedTuple, TypeAlias

from sqlglot import exp

from gam_db.composing.pipeline import Pipeline
from gam_db.errors import GamError, InternalError

#: Makes the error that the rows of a verify stand for.
Failure: TypeAlias = Callable[[Sequence[dict[str, Any]]], GamError]


class Kind(Enum):
    """What becomes of the rows of a statement."""

    QUERY = "query"  # they are read by the caller's own query; nothing is executed
    TABLE = "table"  # a temporary table, which later statements read
    VERIFY = "verify"  # there must be none
    ANSWER = "answer"  # they go to the caller
    APPEND = "append"  # to a table of the state
    DELETE = "delete"  # they name rows of such a table that go


class Statement(NamedTuple):
    """One statement of a plan.

    Attributes:
        name: the named query whose rows it takes; a caller may give another query for one execution.
        kind: what becomes of them.
        target: of an append or a delete, the table of the state.
        failure: of a verify.
        is_input: whether it is a table only for a later statement that reads it.
    """

    name: str
    kind: Kind = Kind.TABLE
    target: str = ""
    failure: Failure | None = None
    is_input: bool = False


class Plan(NamedTuple):
    """Statements, in order.

    Attributes:
        steps: the named queries.
        statements: what is executed.
    """

    steps: Pipeline
    statements: tuple[Statement, ...]

    @classmethod
    def of(
        cls, steps: Pipeline, statements: Iterable[Statement], existing: Container[str] = ()
    ) -> "Plan":
        """Return a plan in which small named queries become tables before a statement reads them.

        Args:
            steps: the named queries.
            statements: in order; one that is a table may be a query of the caller.
            existing: names that are tables before the plan begins.

        Raises:
            InternalError: a verify comes after an append.
        """
        ordered: list[Statement] = []
        tables: set[str] = set()
        for statement in statements:
            if statement.name in steps.steps:
                held = [name for name in steps.steps if name in tables or name in existing]
                for step in steps.needed([statement.name], held):
                    if step.name in steps.small and step.name != statement.name:
                        ordered.append(Statement(step.name, is_input=True))
                        tables.add(step.name)
            if statement.kind is Kind.TABLE:
                tables.add(statement.name)
            ordered.append(statement)
        kinds = [statement.kind for statement in ordered]
        if Kind.APPEND in kinds and Kind.VERIFY in kinds[kinds.index(Kind.APPEND) :]:
            raise InternalError("A plan verifies before it appends.")
        return cls(steps, tuple(ordered))


def insertion(table: exp.Table, rows: exp.Query) -> exp.Insert:
    """Return the statement that appends rows to a table; columns go by name."""
    names = [exp.to_identifier(name) for name in rows.named_selects]
    return exp.Insert(this=exp.Schema(this=table, expressions=names), expression=rows)
