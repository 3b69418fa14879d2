"""Tidying: remove what the settings of a script make needless from its steps.

Steps are written for all settings. This module takes out of them, on their trees, what some settings
leave without effect: columns that nobody reads, constants, joins to a single row or to none, cases that
cannot be, steps that only rename. The rows stay the same. Channels may be called by their names.
"""

from collections import defaultdict
from collections.abc import Collection, Mapping

from sqlglot import exp

from gam_db.composing.folding import folded, is_constant, without_null_tests
from gam_db.composing.joining import drop_empty, drop_rows, join_once, see_through
from gam_db.composing.selects import direct_columns, query_of, selects_of, sources_of, step_of
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
                see_through(select, tidied_steps, results)
                join_once(select, keys or {})
        for _ in range(1 if by_name else 3):  # what is folded within decides what is around it
            for select in selects_of(query):
                if not by_name:
                    drop_empty(select, tidied_steps)
                _inline(select, constants)
            query = folded(query, is_typed=by_name)
        tidied_steps[name] = query
        for select in selects_of(query):
            drop_rows(select, tidied_steps)
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


def _qualify(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Qualify each column by its source, if there are several."""
    sources = [source for source, _ in sources_of(select)]
    if len(sources) < 2:
        return
    for column in direct_columns(select):
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
    """Replace columns by the constants that a select reads from them."""
    constant_columns: dict[int, Mapping[str, exp.Expr]] = {}
    for source, is_there in sources_of(select):
        if is_there and (step := step_of(source, constants)):
            constant_columns[id(source)] = constants[step]
        elif is_there and isinstance(source, exp.Subquery):
            constant_columns[id(source)] = _constants(source.this)
    for column in list(direct_columns(select)):
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
    for column in list(direct_columns(select)):
        part = parts.get(column.name)
        if part is None:
            return
    for column in list(direct_columns(select)):
        column_read = parts[column.name].copy()
        if single and isinstance(column_read, exp.Column) and not column_read.table:
            column_read.set("table", exp.to_identifier(first.this.alias_or_name))
        if column.parent is select and column.arg_key == "expressions":
            column_read = exp.alias_(column_read, column.name)  # some engines keep its table in its name
        column.replace(column_read)
    if single:
        for column in direct_columns(inner):
            if not column.table:
                column.set("table", exp.to_identifier(first.this.alias_or_name))
    select.set("from_", first)
    select.set("joins", inner.args.get("joins"))
    where = inner.args.get("where")
    if where is not None:
        condition = select.args.get("where")
        both = where.this if condition is None else exp.and_(where.this, condition.this)
        select.set("where", exp.Where(this=without_null_tests(both)))


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
    for column in list(direct_columns(select)):
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
    for column in direct_columns(query):
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
        columns = list(direct_columns(select))
        for column in columns:
            if column.name not in other:
                column.set("table", None)
        if isinstance(sources[0], exp.Table) and not any(column.table for column in columns):
            sources[0].set("alias", None)
    for part in list(select.expressions):
        named = part.this if isinstance(part, exp.Alias) else None
        if isinstance(named, exp.Column) and named.name == part.alias and not named.table:
            part.replace(named)
