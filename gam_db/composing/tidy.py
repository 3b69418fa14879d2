"""Tidying: the steps of a script without what its settings make needless.

Steps are written for all settings. This module takes out of them, on their trees, what some settings
leave without effect: columns that nobody reads, constants, joins to a single row or to none, cases that
cannot be, steps that only rename. The rows stay the same. Channels may be called by their names.
"""

from collections import defaultdict
from collections.abc import Collection, Container, Iterator, Mapping

from sqlglot import exp

from gam_db.composing.folding import folded, is_constant, known_there
from gam_db.errors import InternalError

Queries = dict[str, exp.Query]

#: What numbers a channel, and what it is called.
IDS, NAMES = ("channel_id", "support_id"), ("asset", "channel")


def tidied(
    queries: Mapping[str, exp.Query],
    results: Collection[str],
    by_name: bool = True,
    keys: Mapping[str, str] | None = None,
) -> Queries:
    """Return the steps that the results need, tidied, in their order.

    Args:
        queries: by name; a table called as a step before is that step.
        results: steps all of whose columns are wanted.
        by_name: whether channels are called by their names; else by numbers, as in the queries, and a
            step that only renames columns of another one is that one.
        keys: of steps, the column that no two rows share.
    """
    tidied_steps: Queries = {name: query.copy() for name, query in queries.items()}
    constants: dict[str, dict[str, exp.Expr]] = {}
    for name, query in tidied_steps.items():
        for select in selects_of(query):
            if by_name:
                _name(select)
            _qualify(select, tidied_steps)
            if not by_name:
                _see_through(select, tidied_steps, results)
                _join_once(select, keys or {})
        for _ in range(1 if by_name else 3):  # what is folded within decides what is around it
            for select in selects_of(query):
                _drop_empty(select, tidied_steps)
                _inline(select, constants)
            query = folded(query)
        tidied_steps[name] = query
        for select in selects_of(query):
            _drop_rows(select, tidied_steps)
        # What a result says in its rows is read there.
        constants[name] = _constants(query) if by_name or name not in results else {}
    _keep_needed(tidied_steps, results)
    for query in tidied_steps.values():
        for select in selects_of(query):
            _merge(select)
    _keep_needed(tidied_steps, results)
    for query in tidied_steps.values():
        for select in selects_of(query):
            _shorten(select)
    return tidied_steps


def _keep_needed(tidied_steps: Queries, results: Collection[str]) -> None:
    """Drop steps and columns that no result needs."""
    needed: dict[str, set[str] | None] = dict.fromkeys(results)
    for name in reversed(list(tidied_steps)):
        if name in needed:
            _prune(tidied_steps[name], needed[name], tidied_steps, needed)
        else:
            del tidied_steps[name]


def selects_of(query: exp.Expr) -> list[exp.Select]:
    """Return the selects of a query, inner ones first."""
    return list(reversed(list(query.find_all(exp.Select))))


def sources_of(select: exp.Select) -> list[tuple[exp.Expr, bool]]:
    """Return what a select reads, and whether a row of it is always there."""
    first = select.args.get("from_")
    sources = [] if first is None else [(first.this, True)]
    joins = select.args.get("joins") or ()
    return sources + [(join.this, join.side != "LEFT") for join in joins]


def own_columns(select: exp.Select) -> Iterator[exp.Column]:
    """Give the columns that a select names itself, not those of a select in it."""
    for node in select.walk(prune=lambda node: isinstance(node, exp.Subquery)):
        if isinstance(node, exp.Column):
            yield node


def query_of(source: exp.Expr, steps: Mapping[str, exp.Query]) -> exp.Query | None:
    """Return the query whose rows a source has; None for a table of the user's."""
    if isinstance(source, exp.Subquery):
        query: exp.Query = source.this
        return query
    step = step_of(source, steps)
    return None if step is None else steps[step]


def _qualify(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Say of each column which of several sources it is of."""
    sources = [source for source, _ in sources_of(select)]
    if len(sources) < 2:
        return
    for column in own_columns(select):
        if not column.table:
            for source in sources:
                query = query_of(source, steps)
                if query is not None and column.name in query.named_selects:
                    column.set("table", exp.to_identifier(source.alias_or_name))
                    break


def _source_of(select: exp.Select, column: exp.Column) -> exp.Expr | None:
    sources = [source for source, _ in sources_of(select)]
    if not column.table:
        return sources[0] if len(sources) == 1 else None
    return next((source for source in sources if source.alias_or_name == column.table), None)


def step_of(source: exp.Expr, steps: Container[str]) -> str | None:
    """Return the step that a table is, None for a table of the user's, whose name is quoted."""
    if not isinstance(source, exp.Table) or not isinstance(source.this, exp.Identifier):
        return None
    is_step = not source.this.quoted and not source.db and source.name in steps
    return source.name if is_step else None


def _constants(query: exp.Expr) -> dict[str, exp.Expr]:
    """Return the columns of a query that have one value."""
    if not isinstance(query, exp.Select):
        return {}
    return {
        part.alias: part.this
        for part in query.expressions
        if isinstance(part, exp.Alias) and is_constant(part.this)
    }


def _inline(select: exp.Select, constants: Mapping[str, Mapping[str, exp.Expr]]) -> None:
    """Put the constants that a select reads in the place of their columns."""
    constant_columns: dict[int, Mapping[str, exp.Expr]] = {}
    for source, is_there in sources_of(select):
        if is_there and (step := step_of(source, constants)):
            constant_columns[id(source)] = constants[step]
        elif is_there and isinstance(source, exp.Subquery):
            constant_columns[id(source)] = _constants(source.this)
    for column in list(own_columns(select)):
        value = constant_columns.get(id(_source_of(select, column)), {}).get(column.name)
        if value is None:
            continue
        parent = column.parent
        listed = parent if isinstance(parent, exp.Ordered) else column
        holder, key = listed.parent, listed.arg_key or ""
        if isinstance(holder, (exp.Group, exp.Order)) or key == "partition_by":
            if holder is not None and len(holder.args[key]) > 1:
                listed.pop()
        elif parent is select and column.arg_key == "expressions":
            column.replace(exp.alias_(value.copy(), column.name))
        else:
            column.replace(value.copy())


def inlined(consumer: exp.Query, name: str, query: exp.Query) -> None:
    """Let the only reader of a step read its query, in place."""
    for table in list(consumer.find_all(exp.Table)):
        if step_of(table, (name,)):
            table.replace(
                exp.Subquery(
                    this=query, alias=exp.TableAlias(this=exp.to_identifier(table.alias_or_name))
                )
            )
    for select in selects_of(consumer):
        _merge(select)
        _shorten(select)


def _see_through(select: exp.Select, steps: Mapping[str, exp.Query], results: Collection[str]) -> None:
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
        for column in list(own_columns(select)):
            if column.table in ("", alias) and column.name in columns:
                renamed = columns[column.name].copy()
                if isinstance(renamed, exp.Column):
                    renamed = exp.column(renamed.name, table=alias)
                is_listed = column.parent is select and column.arg_key == "expressions"
                column.replace(exp.alias_(renamed, column.name) if is_listed else renamed)
        table = first.copy()
        table.set("alias", exp.TableAlias(this=exp.to_identifier(alias)))
        source.replace(table)


def _join_once(select: exp.Select, keys: Mapping[str, str]) -> None:
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
                for column in list(own_columns(select)):
                    if column.table == alias:
                        column.set("table", exp.to_identifier(other))
                break


def _drop_empty(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Drop outer joins to what has no row, or none that fits."""
    for join in list(select.args.get("joins") or ()):
        query = query_of(join.this, steps)
        is_empty = isinstance(query, exp.Select) and _is_empty(query, steps)
        if join.side != "LEFT" or not (is_empty or join.args.get("on") == exp.false()):
            continue
        for column in list(own_columns(select)):
            if column.table == join.this.alias_or_name:
                column.replace(exp.Literal.number(0) if column.name == "hit" else exp.Null())
        join.pop()


def _is_empty(query: exp.Select, steps: Mapping[str, exp.Query]) -> bool:
    """Tell whether a query reads a step that has no row, or is such a one."""
    where = query.args.get("where")
    if where is not None and where.this == exp.false():
        return True
    first = query_of(sources_of(query)[0][0], steps) if sources_of(query) else None
    return isinstance(first, exp.Select) and _is_empty(first, steps)


def _drop_rows(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Drop joins to a step that is a single row of which nothing is read."""
    read = {column.table for column in own_columns(select)}
    for join in list(select.args.get("joins") or ()):
        name = step_of(join.this, steps)
        step = None if name is None else steps[name]
        is_row = isinstance(step, exp.Select) and step.args.get("from_") is None
        condition = join.args.get("on")
        if is_row and join.this.alias_or_name not in read and condition in (None, exp.true()):
            join.pop()


def _merge(select: exp.Select) -> None:
    """Let a select read what a select in it reads, if that one only picks columns."""
    sources = sources_of(select)
    if len(sources) != 1 or not isinstance(sources[0][0], exp.Subquery):
        return
    inner = sources[0][0].this
    if not isinstance(inner, exp.Select) or any(
        inner.args.get(key) for key in ("group", "distinct", "having", "order", "limit", "windows")
    ):
        return
    parts = {part.alias_or_name: part.unalias() for part in inner.expressions}
    if not all(isinstance(part, exp.Column) or is_constant(part) for part in parts.values()):
        return
    first = inner.args.get("from_")
    if first is None or first.this.alias_or_name == "":
        return
    single = len(sources_of(inner)) == 1
    for column in list(own_columns(select)):
        part = parts.get(column.name)
        if part is None:
            return
    for column in list(own_columns(select)):
        column_read = parts[column.name].copy()
        if single and isinstance(column_read, exp.Column) and not column_read.table:
            column_read.set("table", exp.to_identifier(first.this.alias_or_name))
        if (
            column.parent is select
            and column.arg_key == "expressions"
            and column_read.alias_or_name != column.name
        ):
            column_read = exp.alias_(column_read, column.name)
        column.replace(column_read)
    if single:
        for column in own_columns(inner):
            if not column.table:
                column.set("table", exp.to_identifier(first.this.alias_or_name))
    select.set("from_", first)
    select.set("joins", inner.args.get("joins"))
    where = inner.args.get("where")
    if where is not None:
        condition = select.args.get("where")
        both = where.this if condition is None else exp.and_(where.this, condition.this)
        select.set("where", exp.Where(this=known_there(both)))


def _name(select: exp.Select) -> None:
    """Call channels by their names where a select has their numbers."""
    parts: dict[str, exp.Expr] = {}
    for part in select.expressions:
        column = part.unalias()
        if part.alias_or_name not in IDS:
            parts.setdefault(part.alias_or_name, part)
        elif isinstance(column, exp.Column):
            for name in NAMES:
                named = exp.column(name, table=column.table or None)
                parts.setdefault(name, exp.alias_(named, name) if column.table else named)
    select.set("expressions", list(parts.values()))
    for column in list(own_columns(select)):
        if column.name not in IDS:
            continue
        parent = column.parent
        if isinstance(parent, exp.EQ):
            other = parent.expression if parent.this is column else parent.this
            if not isinstance(other, exp.Column) or other.name not in IDS:
                raise InternalError(f"A channel's number is no name here: {select.sql()}")
            pairs = [
                exp.column(name, table=parent.this.table or None).eq(
                    exp.column(name, table=parent.expression.table or None)
                )
                for name in NAMES
            ]
            parent.replace(exp.and_(*pairs))
            continue
        listed = parent if isinstance(parent, exp.Ordered) else column
        holder, key = listed.parent, listed.arg_key or ""
        if holder is None or not isinstance(holder.args.get(key), list):
            raise InternalError(f"A channel's number is no name here: {select.sql()}")
        members: list[exp.Expr] = []
        for member in holder.args[key]:
            if member is not listed:
                members.append(member)
                continue
            for name in NAMES:
                node: exp.Expr = exp.column(name, table=column.table or None)
                members.append(exp.Ordered(this=node) if isinstance(parent, exp.Ordered) else node)
        holder.set(key, list({member.sql(): member for member in members}.values()))
    for window in select.find_all(exp.Window):
        order = window.args.get("order")
        if order is not None:
            parted = {part.sql() for part in window.args.get("partition_by") or ()}
            remaining = [part for part in order.expressions if part.this.sql() not in parted]
            order.set("expressions", remaining)


def _prune(
    query: exp.Expr,
    wanted: set[str] | None,
    steps: Mapping[str, exp.Query],
    needed: dict[str, set[str] | None],
) -> None:
    """Drop the columns that are not wanted, and note which ones of other steps are read."""
    if isinstance(query, exp.SetOperation):
        _prune(query.this, wanted, steps, needed)
        _prune(query.expression, wanted, steps, needed)
        return
    assert isinstance(query, exp.Select)
    if wanted is not None and not query.args.get("distinct"):
        remaining = [part for part in query.expressions if part.alias_or_name in wanted]
        query.set("expressions", remaining or query.expressions[:1])
    read: dict[int, set[str]] = defaultdict(set)
    for column in own_columns(query):
        source = _source_of(query, column)
        if source is None:
            raise InternalError(f"Nothing read has {column.sql()}: {query.sql()}")
        read[id(source)].add(column.name)
    sources = [source for source, _ in sources_of(query)]
    for single in query.find_all(exp.Subquery):  # a number beside columns
        if single.parent_select is query and not any(single is source for source in sources):
            _prune(single.this, None, steps, needed)
    for source in sources:
        columns = read[id(source)]
        if isinstance(source, exp.Subquery):
            _prune(source.this, columns, steps, needed)
        elif step := step_of(source, steps):
            before = needed.setdefault(step, set())
            if before is not None:
                before |= columns


def _shorten(select: exp.Select) -> None:
    """Drop names that go without saying."""
    sources = [source for source, _ in sources_of(select)]
    if len(sources) == 1:
        other = {
            part.alias_or_name
            for part in select.expressions
            if not (isinstance(part.unalias(), exp.Column) and part.unalias().name == part.alias_or_name)
        }
        columns = list(own_columns(select))
        for column in columns:
            if column.name not in other:
                column.set("table", None)
        if isinstance(sources[0], exp.Table) and not any(column.table for column in columns):
            sources[0].set("alias", None)
    for part in list(select.expressions):
        named = part.this if isinstance(part, exp.Alias) else None
        if isinstance(named, exp.Column) and named.name == part.alias and not named.table:
            part.replace(named)
