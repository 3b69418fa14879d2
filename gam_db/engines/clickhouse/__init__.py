"""ClickHouse 24.12 and later (conditions beside the equality of a join), as an engine.

What runs it, on a server or in this process, is in driver.py.
"""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, formula, table_as, temporary
from gam_db.engines.rewrites import escape_by_backslash
from gam_db.engines.storage import Definition, Storage
from gam_db.engines.types import Types

#: Rows of a channel that lie beside one another, and groups of versions.
_BUCKETS_OF_A_PART, _GROUPS = 2**20, 8
_ROWS_OF_A_MARK = 512


#: Floored, as the method says. Cause: a DateTime64 that becomes coarser is cut towards zero. Symptom:
#: nanoseconds before 1970 are a microsecond late.
_OF_NANOSECONDS = (
    "own.intDiv(own.toUnixTimestamp64Nano(own.toDateTime64(:time, 9, 'UTC')), 1000)"
    " - (own.modulo(own.toUnixTimestamp64Nano(own.toDateTime64(:time, 9, 'UTC')), 1000) < 0)"
)


def create_table(table: exp.Table, query: exp.Query) -> exp.Create:
    """Return CREATE TABLE ... AS with an engine; a small table needs no order."""
    return table_as(table, query, *_merge_tree(called("tuple")))


def temporary_table(table: exp.Expr, query: exp.Query | None = None) -> exp.Create:
    """Return a temporary table in memory.

    Cause: a table on disk is written, merged and read again. Symptom: keeping twelve million rows takes
    twice as long, and a window over them too.
    """
    return temporary(table, query, exp.EngineProperty(this=exp.to_identifier("Memory")))


def _stored(definition: Definition) -> list[exp.Expr]:
    """Return a MergeTree ordered by its key.

    Buckets are cut by stretches of a channel's life, since a month of the clock would be none for a
    source that counts time, and by groups of channels. A restart wants a window of one, not 8192 rows.
    """
    properties = _merge_tree(exp.Tuple(expressions=definition.key))
    if {"version_id", "bucket_no"} <= definition.columns.keys():
        parts = "(own.intDiv(bucket_no, :length), own.modulo(version_id, :groups))"
        cut = formula(parts, length=_BUCKETS_OF_A_PART, groups=_GROUPS)
        marks = formula("index_granularity = :rows", rows=_ROWS_OF_A_MARK)
        properties += [exp.PartitionedByProperty(this=cut), exp.SettingsProperty(expressions=[marks])]
    return properties


def _null_by_type(column: exp.ColumnDef) -> None:
    """Write by the type whether a column can be NULL; ``Nullable(Int64) NOT NULL`` is refused."""
    present = [rule for rule in column.constraints if isinstance(rule.kind, exp.NotNullColumnConstraint)]
    for rule in present:
        rule.pop()
    column.args["kind"].set("nullable", not present)


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
        query.set("settings", [formula("query_plan_max_optimizations_to_apply = 1000000")])
    return tree


ENGINE = Engine.named(
    "clickhouse",
    types=Types("clickhouse", (("BFloat16", "Float32"),)),
    micros={
        TimeKind.TIMESTAMP: "own.toUnixTimestamp64Micro(own.toDateTime64(:time, 6, 'UTC'))",
        TimeKind.NANOSECONDS: _OF_NANOSECONDS,
        TimeKind.NANOSECONDS_WITH_ZONE: _OF_NANOSECONDS,
    },
    rewrites=(escape_by_backslash, allow_long_plans),
    create_table=create_table,
    storage=Storage("inside", view_comments=False, properties=_stored, column=_null_by_type),
)
