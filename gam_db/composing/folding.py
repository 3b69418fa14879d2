"""Folding: a query without what its constants decide.

A condition that always holds, a case that cannot be and a sum of two numbers are put in fewer words, on
the tree; the rows stay the same.
"""

from collections.abc import Callable, Mapping

from sqlglot import exp

_COMPARED: Mapping[type[exp.Expr], Callable[[int, int], bool]] = {
    exp.EQ: lambda a, b: a == b,
    exp.NEQ: lambda a, b: a != b,
    exp.LT: lambda a, b: a < b,
    exp.LTE: lambda a, b: a <= b,
    exp.GT: lambda a, b: a > b,
    exp.GTE: lambda a, b: a >= b,
}


def is_constant(node: exp.Expr) -> bool:
    """Tell whether a node has one value, whatever the row."""
    if isinstance(node, (exp.Cast, exp.Neg, exp.Paren)):
        return is_constant(node.this)
    return isinstance(node, (exp.Literal, exp.Null, exp.Boolean))


def folded(query: exp.Query, is_typed: bool = True) -> exp.Query:
    """Return a query without conditions and cases that constants decide.

    Args:
        query: is changed.
        is_typed: whether a column that is always NULL keeps its type. If not, what is compared with NULL
            is decided, too.
    """
    for node in reversed(list(query.walk())):
        folded_node = _fold(node)
        if is_typed and isinstance(folded_node, exp.Null) and _is_column_of_cases(node):
            continue
        if folded_node is node and not is_typed:
            folded_node = _fold_null(node)
        if node is not query and folded_node is not node:
            node.replace(folded_node)
    for select in query.find_all(exp.Select):
        where = select.args.get("where")
        if where is not None:
            where.set("this", without_null_tests(where.this))
        if where is not None and where.this == exp.true():
            select.set("where", None)
    return query


def without_null_tests(condition: exp.Expr) -> exp.Expr:
    """Return a condition without a test for NULL of a column that another test already covers."""
    parts: list[exp.Expr] = []
    pending = [condition]
    while pending:
        part = pending.pop(0).unnest()
        if isinstance(part, exp.And):
            pending[:0] = [part.this, part.expression]
        else:
            parts.append(part)
    compared = {
        part.this.sql() for part in parts if isinstance(part, (exp.LTE, exp.GTE, exp.EQ, exp.Between))
    }
    remaining = [
        part
        for part in parts
        if not (
            isinstance(part, exp.Not)
            and isinstance(part.this, exp.Is)
            and part.this.this.sql() in compared
        )
    ]
    return condition if len(remaining) == len(parts) else exp.and_(*remaining, copy=False)


def _fold(node: exp.Expr) -> exp.Expr:
    # To sqlglot AND and OR are functions, too.
    if isinstance(node, exp.Paren) and isinstance(node.this, _WHOLE):
        inner: exp.Expr = node.this
        return node if isinstance(inner, exp.Connector) and not _is_apart(node) else inner
    if (
        isinstance(node, exp.Paren)
        and isinstance(node.this, exp.Predicate)
        and _is_condition(node.parent)
    ):
        return node.this
    if isinstance(node, exp.Paren) and type(node.parent) in _COMPARED and isinstance(node.this, _ADDED):
        return node.this
    if isinstance(node, (exp.Add, exp.Mul)):
        return _counted(node)
    if isinstance(node, exp.Is) and isinstance(node.expression, exp.Null) and is_constant(node.this):
        return exp.Boolean(this=bool(node.this.find(exp.Null)))
    if isinstance(node, exp.Not) and isinstance(node.this, exp.Boolean):
        return exp.Boolean(this=not node.this.this)
    if compared := _COMPARED.get(type(node)):
        left, right = _integer(node.this), _integer(node.expression)
        if left is not None and right is not None:
            return exp.Boolean(this=compared(left, right))
    if isinstance(node, (exp.And, exp.Or)):
        neutral = exp.Boolean(this=isinstance(node, exp.And))
        sides = [side for side in (node.this, node.expression) if side != neutral]
        if any(isinstance(side, exp.Boolean) for side in sides):
            return exp.Boolean(this=not neutral.this)
        return neutral if not sides else sides[0] if len(sides) == 1 else node
    if isinstance(node, exp.Case) and node.this is None:
        return _fold_case(node)
    return node


def _is_column_of_cases(node: exp.Expr) -> bool:
    """Tell whether a node is a column made of cases, which give it its type."""
    return isinstance(node, exp.Case) and isinstance(node.parent, exp.Alias) and bool(node.args["ifs"])


def _fold_null(node: exp.Expr) -> exp.Expr:
    """Return the part that NULL decides."""
    if isinstance(node, (exp.Min, exp.Max)) and isinstance(node.this, exp.Null):
        return exp.Null()
    if type(node) not in _COMPARED or not _decides(node):
        return node
    nothing = any(is_constant(side) and side.find(exp.Null) for side in node.iter_expressions())
    return exp.false() if nothing else node


#: What comes before a comparison.
_ADDED = (exp.Add, exp.Sub, exp.Mul, exp.Div)


def _counted(node: exp.Add | exp.Mul) -> exp.Expr:
    """Return the number that two small whole numbers make."""
    left, right = _integer(node.this), _integer(node.expression)
    most = 2**15 if isinstance(node, exp.Mul) or (left or 0) < 2**31 else 2**62
    if left is None or right is None or not 0 <= left < most or not 0 <= right < 2**15:
        return node
    return exp.Literal.number(left + right if isinstance(node, exp.Add) else left * right)


#: What needs no brackets.
_WHOLE = (exp.Boolean, exp.Null, exp.Literal, exp.Column, exp.Paren, exp.Func)


def _is_condition(node: exp.Expr | None) -> bool:
    """Tell whether the expression in a node is a condition by itself."""
    return isinstance(node, (exp.And, exp.Or, exp.Where, exp.If, exp.Join))


def _is_apart(brackets: exp.Paren) -> bool:
    """Tell whether conditions in brackets are the same without them."""
    if isinstance(brackets.parent, exp.Connector):
        return isinstance(brackets.this, (exp.And, type(brackets.parent)))
    return isinstance(brackets.parent, (exp.If, exp.Where, exp.Join, exp.Paren))


def _decides(node: exp.Expr) -> bool:
    """Tell whether NULL counts as false in a node: nothing negates it, and it is a condition."""
    parent = node.parent
    while isinstance(parent, (exp.And, exp.Or, exp.Paren)):
        parent = parent.parent
    return isinstance(parent, (exp.If, exp.Where, exp.Join))


def _fold_case(node: exp.Case) -> exp.Expr:
    cases = [case for case in node.args["ifs"] if case.this != exp.false()]
    last = next((place for place, case in enumerate(cases) if case.this == exp.true()), None)
    default = node.args.get("default")
    if last is not None:
        default, cases = cases[last].args["true"], cases[:last]
    if not cases:
        return default or exp.Null()
    node.set("ifs", cases)
    node.set("default", None if isinstance(default, exp.Null) else default)
    return node


def _integer(node: exp.Expr) -> int | None:
    if isinstance(node, exp.Cast) and node.to.is_type("INT", "BIGINT", "SMALLINT"):
        return _integer(node.this)
    if isinstance(node, exp.Neg):
        number = _integer(node.this)
        return None if number is None else -number
    is_number = isinstance(node, exp.Literal) and not node.is_string and node.name.isdigit()
    return int(node.name) if is_number else None
