"""Selects: what a SELECT of a step reads and names itself."""

from collections import deque
from collections.abc import Container, Iterator, Mapping

from sqlglot import exp


def selects_of(query: exp.Expr) -> list[exp.Select]:
    """Return the selects of a query, inner ones first."""
    return list(reversed(list(query.find_all(exp.Select))))


def sources_of(select: exp.Select) -> list[tuple[exp.Expr, bool]]:
    """Return what a select reads, and whether a row of it is always there."""
    first = select.args.get("from_")
    sources = [] if first is None else [(first.this, True)]
    joins = select.args.get("joins") or ()
    return sources + [(join.this, join.side != "LEFT") for join in joins]


def direct_columns(select: exp.Select) -> Iterator[exp.Column]:
    """Give the columns that a select names itself, not those of a select in it."""
    pending: deque[exp.Expr] = deque([select])
    while pending:
        node = pending.popleft()
        if isinstance(node, exp.Column):
            yield node
        elif not isinstance(node, exp.Subquery):
            pending.extend(node.iter_expressions())


def query_of(source: exp.Expr, steps: Mapping[str, exp.Query]) -> exp.Query | None:
    """Return the query whose rows a source has; None for a table of the user's."""
    if isinstance(source, exp.Subquery):
        query: exp.Query = source.this
        return query
    step = step_of(source, steps)
    return None if step is None else steps[step]


def step_of(source: exp.Expr, steps: Container[str]) -> str | None:
    """Return the step that a table is, None for a table of the user's, whose name is quoted."""
    if not isinstance(source, exp.Table) or not isinstance(source.this, exp.Identifier):
        return None
    is_step = not source.this.quoted and not source.db and source.name in steps
    return source.name if is_step else None
