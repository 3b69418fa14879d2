"""Brevity: shorter forms of a printed query that an engine accepts, with the same rows.

This module owns the forms that not every engine has: outer joins that give NULL, USING, named windows,
literals of doubles. It is told which ones an engine has.
"""

from collections.abc import Collection, Mapping, Sequence

from sqlglot import exp

from gam_db.composing.folding import is_constant
from gam_db.composing.selects import direct_columns, query_of, selects_of, sources_of

#: What an engine may let a query leave out.
FORMS = {
    "names": "a column is called as it was, whatever table it is of, and goes before an alias",
    "nulls": "a row without a partner has NULL in an outer join",
    "using": "a join may name the columns that are equal",
    "frames": "a frame may begin so many rows before at little cost",
    "windows": "windows may be named, and extended by a frame",
    "doubles": "a number with an exponent is a DOUBLE",
    "decimals": "a number beside a DOUBLE is read as one",
    "float8": "DOUBLE PRECISION has a shorter name",
    "typed": "a DOUBLE divided by an integer is a DOUBLE, without a cast",
    "counts": "COUNT and ROW_NUMBER give a BIGINT",
    "least": "LEAST gives the smaller of two numbers",
    "values": "rows of constants may stand in VALUES, whose columns are named",
}


def shortened(
    query: exp.Query,
    allowed: Collection[str],
    steps: Mapping[str, exp.Query] | None = None,
    filled: bool = True,
) -> exp.Query:
    """Return a tidy query in fewer words.

    Args:
        query: is changed.
        allowed: of :data:`FORMS`, what the engine has.
        steps: the queries of the tables that it reads, by name.
        filled: whether a column that has a default is never NULL where an outer join has a partner, as
            in the steps of a script; else only what is counted is taken for such a column.
    """
    steps = steps or {}
    for select in selects_of(query):
        if "names" in allowed:
            _unalias(select)
        if "nulls" in allowed:
            _join_outer(select, filled)
        if "using" in allowed:
            _use(select, steps)
            _unqualify(select, steps)
        if "windows" in allowed:
            _name_windows(select)
    for node in reversed(list(query.walk())):
        shorter = _short(node, allowed)
        if shorter is not node:
            node.replace(shorter)
    if "float8" in allowed:
        for of in list(query.find_all(exp.DataType)):
            if of.is_type("DOUBLE"):
                of.replace(exp.DataType(this=exp.DType.USERDEFINED, kind="float8"))
    if "values" in allowed and isinstance(query, exp.Union):
        return _listed(query)
    return query


def _unalias(select: exp.Select) -> None:
    """Give a column no name that it has."""
    for part in list(select.expressions):
        is_same = isinstance(part, exp.Alias) and isinstance(part.this, exp.Column)
        if is_same and part.this.name == part.alias:
            part.replace(part.this)


def _join_outer(select: exp.Select, filled: bool) -> None:
    """Recognize a row without a partner by NULL, not by a column of its own."""
    for join in select.args.get("joins") or ():
        source, condition = join.this, join.args.get("on")
        if join.side != "LEFT" or not isinstance(source, exp.Subquery) or condition is None:
            continue
        alias, inner = source.alias, source.this
        if not isinstance(inner, exp.Select) or "hit" not in inner.named_selects:
            continue
        keys = [column.name for column in condition.find_all(exp.Column) if column.table == alias]
        for column in list(direct_columns(select)):
            if column.table == alias and column.name == "hit":
                there = exp.not_(exp.column(keys[-1], table=alias).is_(exp.null()))
                comparison = column.parent
                assert comparison is not None  # hit = 1
                comparison.replace(there)
        for case in reversed(list(select.find_all(exp.Case))):
            _uncase(case, alias, None if filled else inner)
        for less in list(select.find_all(exp.LT)):
            _unless(less, alias)
        inner.set("expressions", [part for part in inner.expressions if part.alias_or_name != "hit"])
        first = inner.args["from_"].this
        others = ("joins", "where", "group", "having", "distinct", "order")
        plain = all(isinstance(part, exp.Column) for part in inner.expressions)
        if plain and isinstance(first, exp.Table) and not any(inner.args.get(key) for key in others):
            table = first.copy()
            table.set("alias", exp.TableAlias(this=exp.to_identifier(alias)))
            source.replace(table)


def _uncase(case: exp.Case, alias: str, inner: exp.Select | None) -> None:
    """Let what is read of a partner stand for itself: it is NULL without one.

    A column with a default is never NULL where there is a partner, unless that is to be seen from the
    query of the partner.
    """
    if len(case.args["ifs"]) != 1:
        return
    condition, value = case.args["ifs"][0].this, case.args["ifs"][0].args["true"]
    is_there = isinstance(condition, exp.Not) and isinstance(condition.this, exp.Is)
    if not is_there or not isinstance(condition.this.this, exp.Column):
        return
    if condition.this.this.table != alias:
        return
    default = case.args.get("default")
    if default is None and _is_null_without(value, alias):
        case.replace(value)
    elif (
        default is not None
        and isinstance(value, exp.Column)
        and value.table == alias
        and (inner is None or _is_counted(inner, value.name))
    ):
        case.replace(exp.Coalesce(this=value, expressions=[default]))


def _is_counted(query: exp.Select, name: str) -> bool:
    """Tell whether a column counts rows."""
    column = next((part.unalias() for part in query.expressions if part.alias_or_name == name), None)
    return isinstance(column.this if isinstance(column, exp.Cast) else column, exp.Count)


def _unless(less: exp.LT, alias: str) -> None:
    """Write the test for no partner as such, not as a number below 1."""
    case = less.this
    if isinstance(case, exp.Case) and len(case.args["ifs"]) == 1:
        there = case.args["ifs"][0].this
        is_null = there.this if isinstance(there, exp.Not) else None
        if isinstance(is_null, exp.Is) and is_null.this.table == alias:
            less.replace(is_null)


def _is_null_without(value: exp.Expr, alias: str) -> bool:
    """Tell whether a value is NULL where all columns of a table are."""
    if isinstance(value, exp.Column):
        return value.table == alias
    if isinstance(value, (exp.Cast, exp.Div)):
        return _is_null_without(value.this, alias)
    if isinstance(value, exp.Case) and value.this is None and value.args.get("default") is None:
        conditions = [case.this for case in value.args["ifs"]]
        compared = all(isinstance(of, (exp.EQ, exp.In)) for of in conditions)
        return compared and all(_is_null_without(of.this, alias) for of in conditions)
    return False


def _use(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Name the columns that are equal, as long as each is one column of what is joined so far."""
    joins = select.args.get("joins") or ()
    shared: set[str] = set()
    for place, join in enumerate(joins):
        condition = join.args.get("on")
        if condition is None:
            continue
        names = []
        for part in condition.flatten() if isinstance(condition, exp.And) else [condition]:
            sides = (part.this, part.expression) if isinstance(part, exp.EQ) else ()
            if not all(isinstance(side, exp.Column) for side in sides) or len(sides) < 2:
                return
            if sides[0].name != sides[1].name:
                return
            names.append(sides[0].name)
        before = [source for source, _ in sources_of(select)][: place + 1]
        queries = [query for source in before if (query := query_of(source, steps)) is not None]
        for name in names:
            if sum(name in query.named_selects for query in queries) > 1 and name not in shared:
                return
        query = query_of(join.this, steps)
        shared = {name for name in shared if query is None or name not in query.named_selects}
        shared |= set(names)
        join.set("on", None)
        join.set("using", [exp.to_identifier(name) for name in names])


def _unqualify(select: exp.Select, steps: Mapping[str, exp.Query]) -> None:
    """Name columns without their table where only one has such a column, or all that do are equal."""
    sources = [source for source, _ in sources_of(select)]
    if len(sources) == 1:
        for column in direct_columns(select):
            column.set("table", None)
        if isinstance(sources[0], exp.Table):
            sources[0].set("alias", None)
    if len(sources) < 2:
        return
    columns: list[Sequence[str]] = []
    for source in sources:
        query = query_of(source, steps)
        if query is None:
            return
        columns.append(query.named_selects)
    joins = select.args.get("joins") or ()
    named = [name.name for join in joins for name in join.args.get("using") or ()]
    # A name that all holders but the first are joined by.
    equal = {name for name in named if named.count(name) == sum(name in names for names in columns) - 1}
    if any(join.args.get("on") is not None for join in joins):
        equal = set()
    optional = {join.this.alias_or_name for join in joins if join.side == "LEFT"}
    for column in direct_columns(select):
        holders = sum(column.name in names for names in columns)
        is_equal = column.name in equal and column.table not in optional
        if column.table and (holders == 1 or is_equal):
            column.set("table", None)
    _unalias(select)
    read = {column.table for column in direct_columns(select)}
    tables = [source.name for source in sources if isinstance(source, exp.Table)]
    for source in sources:
        is_named = source.alias_or_name in read or tables.count(source.name) > 1
        if isinstance(source, exp.Table) and not is_named:
            source.set("alias", None)


def _name_windows(select: exp.Select) -> None:
    """Name the window that several columns look through."""
    windows: dict[str, list[exp.Window]] = {}
    for window in select.find_all(exp.Window):
        if window.find_ancestor(exp.Select) is select and window.args.get("order"):
            parts = [*(window.args.get("partition_by") or ()), window.args["order"]]
            windows.setdefault(" ".join(part.sql() for part in parts), []).append(window)
    named = [several for several in windows.values() if len(several) > 1]
    definitions = []
    for number, several in enumerate(named, start=1):
        name = exp.to_identifier("w" if len(named) == 1 else f"w{number}")
        first = several[0]
        definitions.append(
            exp.Window(this=name, partition_by=first.args["partition_by"], order=first.args["order"])
        )
        for window in several:
            spec = window.args.get("spec")
            window.set("partition_by", None)
            window.set("order", None)
            window.set("alias", name.copy())
            if spec is None:
                window.set("over", "OVER")
    if definitions:
        select.set("windows", definitions)


def _is_of_constants(node: exp.Expr) -> bool:
    """Tell whether the other operand of a number is a number, too."""
    parent = node.parent
    if not isinstance(parent, exp.Binary):
        return False
    other = parent.expression if parent.this is node else parent.this
    return is_constant(other)


#: Where a number takes the type of what it stands beside.
_BESIDE = (
    exp.Add,
    exp.Sub,
    exp.Mul,
    exp.Div,
    exp.Between,
    exp.Nullif,
    exp.Predicate,
    exp.Coalesce,
    exp.Case,
)


def _short(node: exp.Expr, allowed: Collection[str]) -> exp.Expr:
    """Return a node in fewer words."""
    is_double = isinstance(node, exp.Cast) and node.to.is_type("DOUBLE")
    is_beside = "decimals" in allowed and isinstance(node.parent, _BESIDE) and not _is_of_constants(node)
    if is_double and ("doubles" in allowed or is_beside):
        value = node.this
        sign, value = ("-", value.this) if isinstance(value, exp.Neg) else ("", value)
        if isinstance(value, exp.Literal) and not value.is_string:
            digits = value.name if "e" in value.name else f"{value.name}e0"
            number = exp.Literal.number(digits)
            return exp.Neg(this=number) if sign else number
    if isinstance(node, exp.Cast) and node.to.is_type("BIGINT") and "counts" in allowed:
        value = node.this
        if isinstance(value, exp.Count) or (
            isinstance(value, exp.Window) and isinstance(value.this, (exp.RowNumber, exp.Count))
        ):
            return value
    if (
        isinstance(node, exp.Div)
        and _is_cast(node.this, "DOUBLE")
        and _is_cast(node.expression, "DOUBLE")
    ):
        node.set("expression", node.expression.this)
    if _is_cast(node, "DOUBLE") and _is_cast(node.this, "BIGINT") and _is_sum(node.this.this):
        return exp.cast(node.this.this, "DOUBLE")
    if isinstance(node, exp.Mod) and node.expression == exp.Literal.number(1):
        return exp.Literal.number(0)
    if isinstance(node, (exp.Sub, exp.Div)):
        nothing = exp.Literal.number("1e0" if isinstance(node, exp.Div) else 0)
        if node.expression == nothing:
            left: exp.Expr = node.this
            return left
    if isinstance(node, exp.Case) and "least" in allowed:
        return _smaller(node)
    if isinstance(node, exp.Or) and not isinstance(node.parent, exp.Or):
        return _among(node)
    if isinstance(node, exp.Div):
        node.set("typed", "typed" in allowed)
    if isinstance(node, exp.Mul) and isinstance(node.expression, exp.Cast):
        factor = node.expression
        if factor.to.is_type("BIGINT") and isinstance(factor.this, exp.Literal):
            return (
                node.this if factor.this.name == "1" else exp.Mul(this=node.this, expression=factor.this)
            )
    return node


def _smaller(node: exp.Case) -> exp.Expr:
    """Return the smaller of two numbers as such."""
    ifs, default = node.args["ifs"], node.args.get("default")
    if node.this is None and len(ifs) == 1 and isinstance(ifs[0].this, exp.LT):
        left, right = ifs[0].this.this, ifs[0].this.expression
        if left == ifs[0].args["true"] and right == default:
            return exp.Least(this=left, expressions=[right])
    return node


def _is_cast(node: exp.Expr, of: str) -> bool:
    return isinstance(node, exp.Cast) and bool(node.to.is_type(of))


def _is_sum(node: exp.Expr) -> bool:
    return isinstance(node, exp.Sum) or (isinstance(node, exp.Window) and isinstance(node.this, exp.Sum))


def _among(node: exp.Or) -> exp.Expr:
    """Return a column that has one of some values as such."""
    by_column: dict[str, list[exp.Expr]] = {}
    for part in node.flatten():
        whole = part.unnest()
        sides = whole.flatten() if isinstance(whole, exp.Or) else [whole]
        for side in sides:
            is_value = isinstance(side, exp.EQ) and isinstance(side.this, exp.Column)
            if is_value and isinstance(side.expression, exp.Literal):
                by_column.setdefault(side.this.sql(), []).append(side)
            else:
                return node
    shorter = []
    for sides in by_column.values():
        values = [side.expression for side in sides]
        shorter.append(sides[0] if len(sides) == 1 else exp.In(this=sides[0].this, expressions=values))
    return exp.or_(*shorter, wrap=False)


def _listed(query: exp.Union) -> exp.Query:
    """Return rows of constants as VALUES."""
    rows: list[exp.Expr] = []
    part: exp.Expr = query
    while isinstance(part, exp.Union):
        rows.insert(0, part.expression)
        part = part.this
    rows.insert(0, part)
    if any(row.args.get("from_") or not isinstance(row, exp.Select) for row in rows):
        return query
    names = query.named_selects
    columns = zip(*([part.unalias() for part in row.expressions] for row in rows), strict=True)
    # A column of nothing but NULL has no other type than the one it is cast to.
    shown = [of if all(part.find(exp.Null) for part in of) else map(_value, of) for of in columns]
    tuples = [exp.Tuple(expressions=list(row)) for row in zip(*shown, strict=True)]
    alias = exp.TableAlias(
        this=exp.to_identifier("listed"), columns=[exp.to_identifier(name) for name in names]
    )
    values = exp.Values(expressions=tuples, alias=alias)
    return exp.select(*(exp.column(name) for name in names)).from_(values)


def _value(node: exp.Expr) -> exp.Expr:
    return node.this if isinstance(node, exp.Cast) and node.to.is_type("INT", "BIGINT") else node
