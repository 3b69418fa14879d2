"""Joins: those of a step that its settings make needless, taken out on the tree."""

from collections.abc import Collection, Mapping

from sqlglot import exp

from gam_db.composing.folding import is_constant
from gam_db.composing.selects import direct_columns, query_of, sources_of, step_of


def see_through(select: exp.Select, steps: Mapping[str, exp.Query], results: Collection[str]) -> None:
    """Read what a step reads, where it only renames columns of another one."""
    for source, _ in sources_of(select):
        name = step_of(source, steps)
        step = None if name is None or name in results else steps[name]
        if not isinstance(step, exp.Select) or len(sources_of(step)) != 1:
            continue
        first, clauses = step.args["from_"].this, ("where", "group", "distinct", "order")
        columns = {part.alias_or_name: part.unalias() for part in step.expressions}
        is_renaming = step_of(first, steps) is not None and not any(
            step.args.get(key) for key in clauses
        )
        if not is_renaming or not all(
            isinstance(column, exp.Column) or is_constant(column) for column in columns.values()
        ):
            continue
        alias = source.alias_or_name
        for column in list(direct_columns(select)):
            if column.table in ("", alias) and column.name in columns:
                renamed = columns[column.name].copy()
                if isinstance(renamed, exp.Column):
                    renamed = exp.column(renamed.name, table=alias)
                is_listed = column.parent is select and column.arg_key == "expressions"
                column.replace(exp.alias_(renamed, column.name) if is_listed else renamed)
        table = first.copy()
        table.set("alias", exp.TableAlias(this=exp.to_identifier(alias)))
        source.replace(table)


def join_once(select: exp.Select, keys: Mapping[str, str]) -> None:
    """Read a step once that is joined to itself by its key."""
    sources = [source for source, _ in sources_of(select)]
    for join in list(select.args.get("joins") or ()):
        condition, name = join.args.get("on"), step_of(join.this, keys)
        if join.side or name is None or not isinstance(condition, exp.EQ):
            continue
        alias = join.this.alias_or_name
        sides = {side.table: side.name for side in (condition.this, condition.expression)}
        for source in sources:
            other = source.alias_or_name
            is_same = source is not join.this and step_of(source, keys) == name
            if is_same and sides == {alias: keys[name], other: keys[name]}:
                join.pop()
                for column in list(direct_columns(select)):
                    if column.table == alias:
                        column.set("table", exp.to_identifier(other))
                break


def drop_empty(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Drop outer joins to what has no row, or none that fits."""
    for join in list(select.args.get("joins") or ()):
        query = query_of(join.this, steps)
        is_empty = isinstance(query, exp.Select) and _is_empty(query, steps)
        if join.side != "LEFT" or not (is_empty or join.args.get("on") == exp.false()):
            continue
        for column in list(direct_columns(select)):
            if column.table == join.this.alias_or_name:
                column.replace(exp.Literal.number(0) if column.name == "hit" else exp.Null())
        join.pop()


def _is_empty(query: exp.Select, steps: Mapping[str, exp.Query]) -> bool:
    """Tell whether a query reads a step that has no row, or is such a one: it reads nothing.

    A condition that never holds is left alone: what reads the rows would lose the types of its columns.
    """
    where = query.args.get("where")
    if query.args.get("from_") is None and where is not None and where.this == exp.false():
        return True
    first = query_of(sources_of(query)[0][0], steps) if sources_of(query) else None
    return isinstance(first, exp.Select) and _is_empty(first, steps)


def drop_rows(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Drop joins to a step that is a single row of which nothing is read."""
    read = {column.table for column in direct_columns(select)}
    for join in list(select.args.get("joins") or ()):
        name = step_of(join.this, steps)
        step = None if name is None else steps[name]
        is_row = isinstance(step, exp.Select) and step.args.get("from_") is None
        condition = join.args.get("on")
        if is_row and join.this.alias_or_name not in read and condition in (None, exp.true()):
            join.pop()
