"""ClickHouse 24.5 and later (conditions beside the equality of a join)."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, escape_by_backslash, table_as

_UTC = "UTC"
_PLAN_STEPS = 1_000_000


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds of a Date, DateTime or DateTime64."""
    if kind.is_counter:
        return counter(column)
    precise = called("toDateTime64", column, exp.Literal.number(6), template.text(_UTC))
    return called("toUnixTimestamp64Micro", precise)


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the DateTime64(6) of epoch microseconds."""
    if kind.is_counter:
        return micros
    return called("fromUnixTimestamp64Micro", micros, template.text(_UTC))


def create_table(table: exp.Table, query: exp.Query) -> exp.Create:
    """Return CREATE TABLE ... AS with an engine; a small table needs no order."""
    create = table_as(table, query)
    unordered = exp.Order(expressions=[exp.Ordered(this=called("tuple"))])
    merge_tree = exp.EngineProperty(this=exp.to_identifier("MergeTree"))
    create.set("properties", exp.Properties(expressions=[merge_tree, unordered]))
    return create


def allow_long_plans(tree: exp.Expr) -> exp.Expr:
    """Lift the limit on the length of a plan.

    Cause: a WITH entry is planned anew wherever it is read, so the plan of a whole form is long.
    Symptom: error 572, too many optimizations applied to query plan, in the exact form as soon as
    there are two sets of parameters.
    """
    query = tree.expression if isinstance(tree, exp.Create) else tree
    if isinstance(query, exp.Select):
        limit = exp.var("query_plan_max_optimizations_to_apply")
        query.set("settings", [exp.EQ(this=limit, expression=exp.Literal.number(_PLAN_STEPS))])
    return tree


ENGINE = Engine(
    name="clickhouse",
    dialect="clickhouse",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
    rewrites=(escape_by_backslash, allow_long_plans),
    create_table=create_table,
)
