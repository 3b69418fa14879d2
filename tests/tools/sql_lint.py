"""A lint over parsed SQL: only forms that give the same answer on every engine.

Most differences between engines raise no error; they give other numbers. One rule is one function; its
docstring says which engine does what. ``lint`` returns what breaks a rule, ``kinds`` what kind of value
each expression is: an integer may be summed, a double may not.

Kinds follow columns through subqueries, and from step to step if the columns of the tables are given.
What cannot be known (a slot, a column of an unknown table) is UNKNOWN and breaks no rule but
``untyped``, which is for queries whose slots are filled.
"""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from enum import IntEnum
from typing import TypeVar

from sqlglot import exp

from gam_db.composing.template import Template


class Kind(IntEnum):
    """What an expression is; of two operands the larger kind wins."""

    NULL = 0
    OTHER = 1  # text, a condition
    NARROW = 2  # an integer of fewer than 64 bits
    INTEGER = 3
    WIDE = 4  # a sum of integers: 128 bits or a decimal on some engines
    WHOLE = 5  # a double without a fraction, such as FLOOR gives
    DOUBLE = 6
    ROUGH = 7  # a double whose last bits depend on the engine: LN, EXP
    UNKNOWN = 8


Node = TypeVar("Node", bound=exp.Expr)
Columns = Mapping[str, Kind]
Tables = Mapping[str, Columns]

DOUBLES = (Kind.WHOLE, Kind.DOUBLE, Kind.ROUGH)
CASTS = {
    **dict.fromkeys(exp.DataType.INTEGER_TYPES, Kind.NARROW),
    exp.DataType.Type.BIGINT: Kind.INTEGER,
    exp.DataType.Type.DOUBLE: Kind.DOUBLE,
    **dict.fromkeys(exp.DataType.TEXT_TYPES, Kind.OTHER),
}
#: Functions of one engine, which it has put into a slot.
OWN = {"BITSTRING_AGG": Kind.OTHER, "GET_BIT": Kind.NARROW}
_COUNTS = (exp.Count, exp.RowNumber, exp.Rank, exp.DenseRank)
_AGGREGATES = (exp.Sum, exp.Min, exp.Max, exp.Count, exp.Avg)
_COMPARISONS = (exp.EQ, exp.NEQ, exp.LT, exp.LTE, exp.GT, exp.GTE, exp.Between)
_PASSED_ON = (exp.Min, exp.Max, exp.Lag, exp.Lead, exp.Nullif, exp.Paren, exp.Neg, exp.Abs, exp.Window)


@dataclass
class Checked:
    """A query with the kind of each of its expressions, and what its columns turned out to be."""

    tree: exp.Expr
    columns: dict[str, Kind] = field(default_factory=dict)
    _kinds: dict[int, Kind] = field(default_factory=dict)

    def kind(self, node: exp.Expr) -> Kind:
        """The kind of an expression of the tree."""
        return self._kinds.get(id(node), Kind.UNKNOWN)

    def every(self, *types: type[Node]) -> Iterator[Node]:
        """All nodes of some types."""
        return self.tree.find_all(*types)


@dataclass(frozen=True)
class Finding:
    """A place that breaks a rule."""

    rule: str
    sql: str

    def __str__(self) -> str:
        return f"{self.rule}: {self.sql}"


def lint(tree: exp.Expr, tables: Tables | None = None, filled: bool = False) -> list[Finding]:
    """Return what breaks a rule in a parsed template, or in a query whose slots are filled."""
    return findings(kinds(tree, tables or {}), filled)


def findings(checked: Checked, filled: bool = False) -> list[Finding]:
    """Return what breaks a rule in a query whose kinds are known."""
    return [
        Finding(rule.__name__, " ".join(node.sql("duckdb").split()))
        for rule in (*RULES, *((untyped,) if filled else ()))
        for node in rule(checked)
    ]


# Kinds


def kinds(tree: exp.Expr, tables: Tables) -> Checked:
    """Find the kind of every expression; ``tables`` says what the columns of known tables are."""
    checked = Checked(tree)
    if isinstance(tree, exp.Query):
        checked.columns = _query(tree, tables, checked._kinds)
    else:
        _expression(tree, [], checked._kinds)
    return checked


def _query(query: exp.Expr, tables: Tables, found: dict[int, Kind]) -> dict[str, Kind]:
    if isinstance(query, exp.SetOperation):
        left = _query(query.this, tables, found)
        right = _query(query.expression, tables, found)
        both = zip(left.items(), right.values(), strict=False)
        return {name: _joint([kind, other]) for (name, kind), other in both}
    if not isinstance(query, exp.Select):
        return {}
    scope: list[tuple[str, Columns | None]] = []
    joins = query.args.get("joins") or []
    for source in [query.args.get("from_"), *joins]:
        if source is None:
            continue
        relation = source.this
        if isinstance(relation, exp.Subquery):
            scope.append((relation.alias, _query(relation.this, tables, found)))
        else:
            scope.append((relation.alias_or_name, tables.get(relation.name)))
    for join in joins:
        if join.args.get("on") is not None:
            _expression(join.args["on"], scope, found)
    for part in ("where", "group", "having", "order", "qualify"):
        if query.args.get(part) is not None:
            _expression(query.args[part], scope, found)
    columns = {}
    for selected in query.expressions:
        columns[selected.alias_or_name] = _expression(selected, scope, found)
    return columns


def _expression(node: exp.Expr, scope: list[tuple[str, Columns | None]], found: dict[int, Kind]) -> Kind:
    if isinstance(node, exp.Query):
        inner = _query(node, {}, found)
        kind = next(iter(inner.values()), Kind.UNKNOWN)
    else:
        children = list(node.iter_expressions())
        kind = _kind(node, {id(child): _expression(child, scope, found) for child in children}, scope)
    found[id(node)] = kind
    return kind


def _kind(node: exp.Expr, of: Mapping[int, Kind], scope: list[tuple[str, Columns | None]]) -> Kind:
    if isinstance(node, exp.Column):
        return _column(node, scope)
    if isinstance(node, exp.Literal):
        return Kind.OTHER if node.is_string else Kind.INTEGER if node.is_int else Kind.DOUBLE
    if isinstance(node, exp.Null):
        return Kind.NULL
    if isinstance(node, (exp.Cast, exp.TryCast)):
        return CASTS.get(node.to.this, Kind.UNKNOWN)
    if isinstance(node, (exp.Floor, exp.Ceil)):
        return Kind.WHOLE
    if isinstance(node, (exp.Ln, exp.Exp, exp.Pow)):
        return Kind.ROUGH
    if isinstance(node, (*_COUNTS, exp.IntDiv)):
        return Kind.INTEGER
    if isinstance(node, exp.Case):
        values = [branch.args["true"] for branch in node.args["ifs"]]
        return _joint([of_branch(value, of) for value in (*values, node.args.get("default"))])
    if isinstance(node, exp.If):
        return of[id(node.args["true"])]
    if isinstance(node, (exp.Div, exp.Sqrt, exp.Avg)):
        return Kind.ROUGH if Kind.ROUGH in of.values() else Kind.DOUBLE
    if isinstance(node, (exp.Add, exp.Sub, exp.Mul, exp.Mod)):
        return _joint([of[id(node.left)], of[id(node.right)]])
    if isinstance(node, exp.Sum):
        inner = of[id(node.this)]
        return Kind.WIDE if inner in (Kind.NARROW, Kind.INTEGER) else inner
    if isinstance(node, exp.Coalesce):
        return _joint([of[id(node.this)], *(of[id(other)] for other in node.expressions)])
    if isinstance(node, (*_PASSED_ON, exp.Alias)):
        return of[id(node.this)]
    if isinstance(node, exp.Anonymous) and node.name in OWN:
        return OWN[node.name]
    if isinstance(node, (exp.Placeholder, exp.Func)):
        return Kind.OTHER if isinstance(node, exp.Predicate) else Kind.UNKNOWN
    return Kind.OTHER


def of_branch(value: exp.Expr | None, of: Mapping[int, Kind]) -> Kind:
    """The kind of a value of CASE; the branches hang one level below."""
    if value is None:
        return Kind.NULL
    parent = value.parent
    return of[id(parent)] if isinstance(parent, exp.If) else of[id(value)]


def _column(column: exp.Column, scope: list[tuple[str, Columns | None]]) -> Kind:
    for name, columns in scope:
        if columns is not None and column.table in ("", name) and column.name in columns:
            return columns[column.name]
    return Kind.UNKNOWN


def _joint(found: list[Kind]) -> Kind:
    return max(found, default=Kind.NULL)


# Helpers of the rules


def plain(node: exp.Expr | None) -> exp.Expr | None:
    """An expression without the brackets, casts, signs and NULLIF around it."""
    while isinstance(node, (exp.Paren, exp.Cast, exp.Neg, exp.Nullif)):
        node = node.this
    return node


def number(node: exp.Expr | None) -> float | None:
    """The value of a constant, sign aside; None of anything else."""
    bare = plain(node)
    if isinstance(bare, exp.Literal) and not bare.is_string:
        return float(bare.name)
    return None


def conjuncts(condition: exp.Expr | None) -> list[exp.Expr]:
    """The parts of a condition that must all hold."""
    if condition is None:
        return []
    bare = condition.unnest()
    return list(bare.flatten()) if isinstance(bare, exp.And) else [bare]


def own_columns(select: exp.Select) -> Iterator[exp.Column]:
    """The columns that a SELECT itself reads, those of its subqueries left out."""
    for column in select.find_all(exp.Column):
        if column.parent_select is select:
            yield column


def left_joined(select: exp.Select) -> set[str]:
    """The names of what a SELECT joins by LEFT JOIN."""
    joins = select.args.get("joins") or []
    return {join.this.alias_or_name for join in joins if join.side.upper() == "LEFT"}


def selects(checked: Checked) -> Iterator[exp.Select]:
    """All SELECTs of a tree."""
    yield from checked.tree.find_all(exp.Select)


# Functions


def averages(checked: Checked) -> Iterator[exp.Expr]:
    """No AVG.

    Cause: the type of an average follows the engine. Symptom: Flink gives AVG(1, 2) = 1, Redshift's
    window average is an integer, MariaDB keeps four digits. Write SUM / COUNT, both cast to DOUBLE.
    """
    return checked.every(exp.Avg)


def statistics(checked: Checked) -> Iterator[exp.Expr]:
    """No standard deviation, variance, correlation, median, quantile, mode.

    Cause: they are computed in other orders, or missing. Symptom: CORR has three different values on
    eight engines, STDDEV is that of the population on MariaDB, SQLite has none. Use sums of integers.
    """
    return checked.every(
        *(exp.Stddev, exp.StddevPop, exp.StddevSamp, exp.Variance, exp.VariancePop),
        *(exp.Corr, exp.CovarPop, exp.CovarSamp, exp.Median, exp.Mode),
        *(exp.Quantile, exp.ApproxQuantile, exp.PercentileCont, exp.PercentileDisc),
    )


def logarithms(checked: Checked) -> Iterator[exp.Expr]:
    """LN only, no LOG.

    Cause: LOG is not translated. Symptom: base 10 on DuckDB, PostgreSQL and SQLite, base e on
    ClickHouse, Spark, MariaDB and BigQuery; with two arguments their order differs.
    """
    return checked.every(exp.Log)


def roundings(checked: Checked) -> Iterator[exp.Expr]:
    """No ROUND or TRUNC.

    Cause: halves go to the even number or away from zero. Symptom: ROUND(2.5) is 2 or 3. Write
    FLOOR(x + half).
    """
    return checked.every(exp.Round, exp.Trunc)


def extremes_of_arguments(checked: Checked) -> Iterator[exp.Expr]:
    """No LEAST or GREATEST.

    Cause: NULL among the arguments. Symptom: NULL on MariaDB, BigQuery and Flink, ignored elsewhere.
    Write CASE.
    """
    return checked.every(exp.Least, exp.Greatest)


def tests_of_nan(checked: Checked) -> Iterator[exp.Expr]:
    """No ISNAN, ISINF or ISFINITE.

    Cause: the names differ and are passed on as they are; NaN equals NaN on some engines only. Symptom:
    an unknown function, or rows that slip through. Write BETWEEN -1e300 AND 1e300.
    """
    yield from checked.every(exp.IsNan, exp.IsInf)
    for call in checked.every(exp.Anonymous):
        if call.name.upper() in ("ISNAN", "ISINF", "ISFINITE", "IS_NAN", "IS_INF"):
            yield call


# Numbers


def sums_of_doubles(checked: Checked) -> Iterator[exp.Expr]:
    """Sum integers only.

    Cause: engines add in other orders, and some slide a window by subtracting what leaves it. Symptom:
    1e16, 1, 1, 1 summed over two rows ends in 2, 1 or 0, by engine. Cast FLOOR of a scaled value to
    BIGINT and sum that.
    """
    return (node for node in checked.every(exp.Sum) if checked.kind(node.this) in DOUBLES)


def casts_of_fractions(checked: Checked) -> Iterator[exp.Expr]:
    """Cast to an integer only what is whole: an integer, or FLOOR of a double.

    Cause: a cast rounds or cuts off. Symptom: 3.5 becomes 4 on DuckDB, PostgreSQL and MariaDB, 3 on
    ClickHouse, Spark and SQLite.
    """
    for cast in checked.every(exp.Cast, exp.TryCast):
        whole = CASTS.get(cast.args["to"].this) in (Kind.NARROW, Kind.INTEGER)
        if whole and checked.kind(cast.this) in (Kind.DOUBLE, Kind.ROUGH):
            yield cast


def divisions_of_integers(checked: Checked) -> Iterator[exp.Expr]:
    """Divide doubles only, both sides cast.

    Cause: what 7 / 2 is. Symptom: 3.5 on DuckDB, ClickHouse and Spark, 3 on PostgreSQL and SQLite, a
    decimal on MariaDB.
    """
    allowed = (*DOUBLES, Kind.UNKNOWN, Kind.NULL)
    for division in checked.every(exp.Div):
        if not all(checked.kind(side) in allowed for side in (division.this, division.expression)):
            yield division


def divisions_by_constants(checked: Checked) -> Iterator[exp.Expr]:
    """Divide by columns and powers of two; by another constant only where the result is rounded.

    Cause: some engines multiply by the reciprocal of a constant. Symptom: x / 3 is off in the last bit
    in one row of three on Polars. FLOOR((n + half) / constant) and FLOOR(n / constant + half) of whole
    numbers have room for it. A slot is taken for a constant that is no power of two.
    """
    for division in checked.every(exp.Div):
        constant = number(division.expression)
        slot = isinstance(plain(division.expression), exp.Placeholder)
        odd = constant is not None and math.frexp(constant)[0] not in (0.5, 0.0)
        if (slot or odd) and not _rounded(division):
            yield division


def _rounded(division: exp.Expr) -> bool:
    """Tell whether a half is added, before or after a division, inside FLOOR."""
    outer = division.parent
    while isinstance(outer, exp.Paren):
        outer = outer.parent
    if isinstance(outer, exp.Floor):
        return _has_half(division.this)
    if isinstance(outer, exp.Add) and _has_half(outer):
        while isinstance(outer, (exp.Add, exp.Paren)):
            outer = outer.parent
        return isinstance(outer, exp.Floor)
    return False


def _has_half(node: exp.Expr) -> bool:
    sides = node.unnest()
    return isinstance(sides, (exp.Add, exp.Sub)) and 0.5 in map(number, (sides.left, sides.right))


def whole_divisions(checked: Checked) -> Iterator[exp.Expr]:
    """No ``//`` and no DIV.

    Cause: some engines have none, others round it differently below zero or give a decimal. Symptom:
    a syntax error on DataFusion, NUMERIC on PostgreSQL.
    """
    return checked.every(exp.IntDiv)


def decimals(checked: Checked) -> Iterator[exp.Expr]:
    """A number with a fraction or an exponent stands in CAST(... AS DOUBLE).

    Cause: 0.1 is a DECIMAL on some engines, a double on others. Symptom: 0.1 + 0.2 = 0.3 is true on
    DuckDB, PostgreSQL and Spark, false on ClickHouse and SQLite.
    """
    for literal in checked.every(exp.Literal):
        if not literal.is_string and not literal.is_int:
            outer = literal.parent
            while isinstance(outer, (exp.Neg, exp.Paren)):
                outer = outer.parent
            if not (isinstance(outer, exp.Cast) and CASTS.get(outer.to.this) is Kind.DOUBLE):
                yield literal


def narrow_products(checked: Checked) -> Iterator[exp.Expr]:
    """Cast narrow integers to BIGINT before multiplying.

    Cause: the product has the type of its sides. Symptom: SMALLINT * 10609 is an error on DuckDB and
    wraps silently on ClickHouse.
    """
    for product in checked.every(exp.Mul):
        if Kind.NARROW in (checked.kind(product.this), checked.kind(product.expression)):
            yield product


def doubles_as_text(checked: Checked) -> Iterator[exp.Expr]:
    """Never turn a double into text.

    Cause: the digits. Symptom: SQLite prints 15 of them, BigQuery 17.
    """
    for cast in checked.every(exp.Cast, exp.TryCast):
        if cast.args["to"].this in exp.DataType.TEXT_TYPES and checked.kind(cast.this) in DOUBLES:
            yield cast


def rough_decisions(checked: Checked) -> Iterator[exp.Expr]:
    """Decide nothing on LN, EXP or POWER: do not compare, round, join or group by them.

    Cause: their last bit differs. Symptom: an integer that is one larger on another engine.
    """
    for node in checked.every(*_COMPARISONS, exp.Floor, exp.Ceil, exp.Group):
        if any(checked.kind(child) is Kind.ROUGH for child in node.iter_expressions()):
            yield node


# Counts and windows


def uncast_counts(checked: Checked) -> Iterator[exp.Expr]:
    """Cast COUNT, ROW_NUMBER and RANK at once; only HAVING may compare COUNT as it is.

    Cause: they are unsigned on ClickHouse. Symptom: a union with a signed column becomes a Variant, and
    a join with one fails; a difference below zero wraps.
    """
    for count in checked.every(*_COUNTS):
        whole = count.parent if isinstance(count.parent, exp.Window) else count
        outer = whole.parent
        compared = isinstance(outer, _COMPARISONS) and outer.find_ancestor(exp.Having) is not None
        if not (isinstance(outer, exp.Cast) or compared):
            yield whole


def implicit_frames(checked: Checked) -> Iterator[exp.Expr]:
    """An aggregate over an ordered window has its ROWS frame written out; there are no RANGE frames.

    Cause: without a frame it is RANGE, and peers count as one. Symptom: rows of equal time get one sum;
    Polars has no RANGE at all.
    """
    for window in checked.every(exp.Window):
        frame = window.args.get("spec")
        if frame is None:
            if isinstance(window.this, _AGGREGATES) and window.args.get("order") is not None:
                yield window
        elif str(frame.args.get("kind")).upper() != "ROWS":
            yield window


def moving_frames(checked: Checked) -> Iterator[exp.Expr]:
    """A frame begins with the partition: no ``ROWS n PRECEDING``.

    Cause: such frames are computed row by row, or by subtracting what leaves. Symptom: Spark takes
    W times as long; MariaDB refuses anything but a literal. Take the difference of running sums.
    """
    for frame in checked.every(exp.WindowSpec):
        is_newest = isinstance(frame.parent, exp.Window) and isinstance(
            frame.parent.this, exp.IgnoreNulls
        )
        if str(frame.args.get("start")).upper() != "UNBOUNDED" and not is_newest:
            yield frame


def odd_lags(checked: Checked) -> Iterator[exp.Expr]:
    """LAG has two arguments: no default, no IGNORE NULLS; and there is no LEAD.

    Cause: support. Symptom: MariaDB has no third argument and ClickHouse types it; ClickHouse and Flink
    accept IGNORE NULLS and do not heed it.
    """
    for lag in checked.every(exp.Lag, exp.Lead):
        two = lag.args.get("offset") is not None and lag.args.get("default") is None
        if isinstance(lag, exp.Lead) or not two or isinstance(lag.parent, exp.IgnoreNulls):
            yield lag


def lagged_nulls(checked: Checked) -> Iterator[exp.Expr]:
    """Do not ask whether a lagged column is NULL; ask ROW_NUMBER whether there is a row before.

    Cause: what LAG gives at the first row. Symptom: 0 on ClickHouse, so the first rows of a channel get
    a vector made of zeros.
    """
    lagged = {
        alias.alias
        for alias in checked.every(exp.Alias)
        if isinstance(alias.this, exp.Window) and isinstance(alias.this.this, exp.Lag)
    }
    for test in checked.every(exp.Is, exp.Coalesce, exp.Nvl2, exp.NullSafeEQ, exp.NullSafeNEQ):
        columns = test.this.find_all(exp.Column)
        if test.this.find(exp.Lag) or any(column.name in lagged for column in columns):
            yield test


def named_windows(checked: Checked) -> Iterator[exp.Expr]:
    """Write OVER (...) in full.

    Cause: the WINDOW clause. Symptom: the generator fails for BigQuery, T-SQL and MySQL.
    """
    for select in selects(checked):
        yield from select.args.get("windows") or []
    for window in checked.every(exp.Window):
        if isinstance(window.parent, exp.Expr) and window.args.get("alias") is not None:
            yield window


# Joins


def anti_joins(checked: Checked) -> Iterator[exp.Expr]:
    """No EXISTS, NOT IN, ANTI or SEMI join; join to a subquery with ``1 AS hit`` and test it.

    Cause: NULL, and planners. Symptom: NOT IN with a NULL returns 0 rows, but 3 on ClickHouse; Flink
    fails on a correlated NOT EXISTS; DataFusion deletes every row WHERE EXISTS.
    """
    yield from checked.every(exp.Exists)
    yield from (node for node in checked.every(exp.Not) if isinstance(node.this.unnest(), exp.In))
    for join in checked.every(exp.Join):
        if (join.kind or "").upper() in ("ANTI", "SEMI") or (join.side or "").upper() in (
            "ANTI",
            "SEMI",
        ):
            yield join


def missing_matches(checked: Checked) -> Iterator[exp.Expr]:
    """What a LEFT JOIN may not find is read only where its ``hit = 1``.

    Cause: what stands where no row matches. Symptom: NULL everywhere, but 0 or an empty text on
    ClickHouse: with ``IS NULL`` every row looks like a match, and every cell healthy. The joined
    subquery selects ``1 AS hit``, and its columns stand in CASE WHEN name.hit = 1, or beside that test.
    """
    for select in selects(checked):
        for join in select.args.get("joins") or []:
            if (join.side or "").upper() in ("RIGHT", "FULL"):
                yield join
        names = left_joined(select)
        for column in own_columns(select):
            in_join = isinstance(column.find_ancestor(exp.Join, exp.Select), exp.Join)
            if column.table in names and not (in_join or _is_hit(column) or _guarded(column)):
                yield column
        for join in select.args.get("joins") or []:
            if join.this.alias_or_name in names and not _offers_hit(join.this):
                yield join


def _is_hit(column: exp.Column) -> bool:
    test = column.parent
    return column.name == "hit" and isinstance(test, exp.EQ) and number(test.expression) == 1.0


def _guarded(column: exp.Column) -> bool:
    node: exp.Expr = column
    while node.parent is not None and not isinstance(node.parent, exp.Select):
        outer = node.parent
        guards: list[exp.Expr] = []
        if isinstance(outer, exp.If) and node is outer.args.get("true"):
            guards = conjuncts(outer.this)
        elif isinstance(outer, exp.And):
            guards = conjuncts(outer)
        for guard in guards:
            tested = guard.this if isinstance(guard, exp.EQ) else None
            if isinstance(tested, exp.Column) and tested.table == column.table and _is_hit(tested):
                return True
        node = outer
    return False


def _offers_hit(relation: exp.Expr) -> bool:
    query = relation.this if isinstance(relation, exp.Subquery) else None
    if not isinstance(query, exp.Select):
        return False
    return any(item.alias == "hit" and number(item.unalias()) == 1.0 for item in query.expressions)


def loose_joins(checked: Checked) -> Iterator[exp.Expr]:
    """A join is a CROSS JOIN, or has an ON with an equality of two plain columns.

    Cause: planners. Symptom: DataFusion drops ``ON c.i = a.i + l.k`` after a CROSS JOIN and pairs
    everything with everything; a join without an equality is quadratic. Compute the sum in a subquery.
    Other conditions may stand beside the equality.
    """
    for join in checked.every(exp.Join):
        if (join.kind or "").upper() == "CROSS" and join.args.get("on") is None:
            continue
        equalities = [part for part in conjuncts(join.args.get("on")) if isinstance(part, exp.EQ)]
        sides = [(equality.this, equality.expression) for equality in equalities]
        keys = [all(isinstance(side, exp.Column) for side in pair) for pair in sides]
        sums = [any(side.find(exp.Binary) for side in pair) for pair in sides]
        if not any(keys) or any(sums):
            yield join


def joins_by_using(checked: Checked) -> Iterator[exp.Expr]:
    """No USING and no NATURAL JOIN.

    Cause: which of the two columns is meant later. Symptom: an ambiguous name on some engines, another
    value in outer joins on others.
    """
    for join in checked.every(exp.Join):
        if join.args.get("using") or (join.method or "").upper() == "NATURAL":
            yield join


# Names


def unnamed_columns(checked: Checked) -> Iterator[exp.Expr]:
    """A qualified column or an expression has an explicit AS.

    Cause: the name of ``a.x`` outside. Symptom: ClickHouse calls it ``a.x`` after a join, and the outer
    ``x`` is unknown.
    """
    for select in selects(checked):
        for item in select.expressions:
            simple = isinstance(item, exp.Column) and not item.table
            if not (simple or isinstance(item, (exp.Alias, exp.Placeholder, exp.Star))):
                yield item


def shadowed_columns(checked: Checked) -> Iterator[exp.Expr]:
    """No alias with the name of a column that the same SELECT reads without its table's name.

    Cause: ClickHouse puts an alias in the place of the column wherever it is read. Symptom:
    ``MIN(x) AS x, MAX(x) AS y`` is ILLEGAL_AGGREGATION; ``x * 10 AS x, x + 1 AS y`` makes y 10 x + 1
    without a word. (A qualified ``t.x`` is the column: seen on 26.9.)
    """
    for select in selects(checked):
        read = {column.name for column in own_columns(select) if not column.table}
        for item in select.expressions:
            itself = isinstance(item.this, exp.Column) and item.this.name == item.alias
            if isinstance(item, exp.Alias) and item.alias in read and not itself:
                yield item


RESERVED = frozenset(
    (
        *("at", "corr", "hash", "percent", "rule"),  # DuckDB 2, Flink, BigQuery, T-SQL
        *("account", "increment", "issue", "minus", "organization", "sample", "start"),  # Snowflake
        *("before", "delayed", "optimize", "trigger"),  # MariaDB
        *("all", "any", "as", "asc", "both", "by", "case", "cast", "check", "column", "cross"),
        *("current", "default", "desc", "distinct", "else", "end", "except", "exists", "false", "for"),
        *("from", "full", "grant", "group", "groups", "having", "in", "index", "inner", "intersect"),
        *("into", "is", "join", "key", "lag", "last_value", "lateral", "lead", "leading", "left"),
        *("like", "limit", "natural", "new", "not", "null", "of", "offset", "old", "on", "or", "order"),
        *("outer", "over", "overlaps", "partition", "plan", "primary", "proc", "qualify", "range"),
        *("rank", "right", "row", "rows", "select", "set", "some", "system", "table", "tablesample"),
        *("then", "to", "top", "trailing", "true", "union", "unique", "unnest", "user", "using"),
        *("values", "when", "where", "window", "with", "within"),
    )
)


def reserved_names(checked: Checked) -> Iterator[exp.Expr]:
    """No name that some engine keeps for itself.

    Cause: grammars. Symptom: a syntax error on one engine: ``corr`` on Flink, ``at`` on DuckDB 2,
    ``hash`` on BigQuery, ``percent`` on T-SQL.
    """
    for node in checked.every(exp.Alias, exp.TableAlias):
        said = "" if isinstance(node.this, exp.Literal) else node.name
        if RESERVED.intersection((node.alias.lower(), said.lower())):
            yield node


# Statements


def stars(checked: Checked) -> Iterator[exp.Expr]:
    """Name every column; ``*`` stands in COUNT(*) only.

    Cause: what a star means follows the table. Symptom: a hundredfold slowdown where DuckDB changed how
    it plans WITH queries, and columns that appear by themselves.
    """
    return (star for star in checked.every(exp.Star) if not isinstance(star.parent, exp.Count))


def filters(checked: Checked) -> Iterator[exp.Expr]:
    """No FILTER (WHERE ...).

    Cause: support. Symptom: a syntax error on MariaDB, BigQuery, Snowflake. Write CASE inside.
    """
    return checked.every(exp.Filter)


def value_lists(checked: Checked) -> Iterator[exp.Expr]:
    """No VALUES as a table.

    Cause: the names of its columns. Symptom: an error on SQLite, BigQuery, MariaDB. Use UNION ALL.
    """
    return checked.every(exp.Values)


def generators(checked: Checked) -> Iterator[exp.Expr]:
    """No generate_series, RANGE, UNNEST or LATERAL.

    Cause: each engine has its own. Symptom: an unknown function.
    """
    yield from checked.every(exp.GenerateSeries, exp.Explode, exp.Unnest, exp.Lateral)
    for table in checked.every(exp.Table):
        if not isinstance(table.this, exp.Identifier):
            yield table


def recursions(checked: Checked) -> Iterator[exp.Expr]:
    """No WITH RECURSIVE.

    Cause: support. Symptom: missing on Spark, ClickHouse, Polars and others, or limited in depth.
    """
    return (node for node in checked.every(exp.With) if node.args.get("recursive"))


def qualifies(checked: Checked) -> Iterator[exp.Expr]:
    """No QUALIFY.

    Cause: support. Symptom: a syntax error on PostgreSQL, SQLite, MariaDB. Use an outer WHERE.
    """
    return checked.every(exp.Qualify)


def groups_by_all(checked: Checked) -> Iterator[exp.Expr]:
    """No GROUP BY ALL, and no ORDER BY ALL.

    Cause: support. Symptom: an unknown column ``all`` on PostgreSQL, SQLite, BigQuery.
    """
    yield from (node for node in checked.every(exp.Group) if node.args.get("all"))
    for ordered in checked.every(exp.Ordered):
        if ordered.this.name.upper() == "ALL":
            yield ordered


def inner_orders(checked: Checked) -> Iterator[exp.Expr]:
    """ORDER BY stands in windows, at the very end, and where a LIMIT takes the first of the rows.

    Cause: a subquery is a set. Symptom: T-SQL refuses it, other engines drop it.
    """
    for order in checked.every(exp.Order):
        query = order.parent
        if isinstance(query, exp.Query) and query is not checked.tree and not query.args.get("limit"):
            yield order


def wide_results(checked: Checked) -> Iterator[exp.Expr]:
    """A result, which is what has an ORDER BY at its end, casts its sums to BIGINT.

    Cause: SUM of integers is wider. Symptom: 128-bit integers from DuckDB, decimals from PostgreSQL and
    MariaDB, a text through ADBC.
    """
    if isinstance(checked.tree, exp.Select) and checked.tree.args.get("order") is not None:
        yield from (i for i in checked.tree.expressions if checked.kind(i) is Kind.WIDE)


def untyped(checked: Checked) -> Iterator[exp.Expr]:
    """Only for filled queries: nothing that a rule must know the kind of is of unknown kind."""
    for node in checked.every(exp.Sum, exp.Div, exp.Cast, exp.Mul):
        if any(
            checked.kind(child) is Kind.UNKNOWN
            for child in node.iter_expressions()
            if not isinstance(child, exp.DataType)
        ):
            yield node
    if isinstance(checked.tree, exp.Select):
        yield from (i for i in checked.tree.expressions if checked.kind(i) is Kind.UNKNOWN)


Rule = Callable[[Checked], Iterator[exp.Expr]]
RULES: tuple[Rule, ...] = (
    *(averages, statistics, logarithms, roundings, extremes_of_arguments, tests_of_nan),
    *(sums_of_doubles, casts_of_fractions, divisions_of_integers, divisions_by_constants),
    *(whole_divisions, decimals, narrow_products, doubles_as_text, rough_decisions),
    *(uncast_counts, implicit_frames, moving_frames, odd_lags, lagged_nulls, named_windows),
    *(anti_joins, missing_matches, loose_joins, joins_by_using),
    *(unnamed_columns, shadowed_columns, reserved_names),
    *(stars, filters, value_lists, generators, recursions, qualifies, groups_by_all),
    *(inner_orders, wide_results),
)


def form(found: Template) -> Iterator[str]:
    """Yield in what a file of ``sql/`` breaks the form that lets it be filled, and read anywhere."""
    file = f"sql/{found.name}.sql"
    for node in found.tree.walk():
        if isinstance(node, exp.Anonymous) and not found.dialect:
            yield f"{file} uses the unknown function {node.name}."
        if isinstance(node, exp.Star) and not isinstance(node.parent, exp.Count):
            yield f"{file} selects *; name every column."
        if isinstance(node, exp.Select) and node.args.get("windows"):
            yield f"{file} names a window; write OVER (...) in full."
        if isinstance(node, exp.Placeholder) and not node.this:
            yield f"{file} has a parameter (?); slots have names (:name)."
        if isinstance(node, exp.Command):
            yield f"{file} holds a statement that is not a query."
