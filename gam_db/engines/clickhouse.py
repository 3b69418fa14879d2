"""ClickHouse 24.5 and later (conditions beside the equality of a join)."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, escape_by_backslash, table_as
from gam_db.engines.storage import Definition, with_notes

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
    create.set("properties", exp.Properties(expressions=_merge_tree(called("tuple"))))
    return create


def define(definition: Definition) -> list[exp.Expr]:
    """Return a MergeTree ordered by its key, with comments inside; a view goes without.

    Cause: a column that is never NULL is said by its type. Symptom: ``Nullable(Int64) NOT NULL`` is
    refused, and a nullable column cannot be part of the key.
    """
    if definition.is_view:
        return [definition.create.copy()]
    (create,) = with_notes(definition, _merge_tree(exp.Tuple(expressions=definition.key)))
    for column in create.find_all(exp.ColumnDef):
        present = [
            rule for rule in column.constraints if isinstance(rule.kind, exp.NotNullColumnConstraint)
        ]
        for rule in present:
            rule.pop()
        column.args["kind"].set("nullable", not present)
    return [create]


def _merge_tree(key: exp.Expr) -> list[exp.Expr]:
    order = exp.Order(expressions=[exp.Ordered(this=key)])
    return [exp.EngineProperty(this=exp.to_identifier("MergeTree")), order]


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
    title="ClickHouse",
    dialect="clickhouse",
    oldest="24.5",
    extra="clickhouse",
    transactions=False,
    limits="A run is seen once its commit row is there; a second writer is detected, not prevented. "
    "Inside this process (chdb) only one process opens a folder.",
    micros_of=micros_of,
    instant_of=instant_of,
    rewrites=(escape_by_backslash, allow_long_plans),
    create_table=create_table,
    define=define,
)
