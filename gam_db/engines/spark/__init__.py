"""Spark 3.5 and later, in ANSI mode, over Parquet; over Delta or Iceberg where a session has them.

The session must be set to UTC: only then a timestamp without zone is read as UTC.
"""

import dataclasses

from sqlglot import exp

from gam_db.engines.base import Engine, called, table_as
from gam_db.engines.storage import Definition, Storage, clustered
from gam_db.engines.types import Types

#: Groups of channels, by hash, that the large tables are stored in: a look at one machine opens the
#: files of one group, in which rows are ordered. Every run writes a file for each, so they are few.
GROUPS = 4

#: What the large tables are ordered by within a version or support.
_LARGE = ("bucket_no", "cell_key")


def create_table(table: exp.Table, query: exp.Query) -> exp.Create:
    """Return CREATE TABLE ... USING PARQUET AS; without a format Spark may ask for Hive."""
    return table_as(table, query, _format("PARQUET"))


def _stored(form: str) -> Storage:
    """Return the storage of tables of a form: large ones in groups of channels, which are no column."""

    def properties(definition: Definition) -> list[exp.Expr]:
        key, groups = definition.key, exp.Literal.number(GROUPS)
        if not is_large([column.name for column in key]):
            return [_format(form)]
        if form == "DELTA":
            return [_format(form), *clustered(definition)]
        if form == "ICEBERG":
            by_hash = exp.Schema(expressions=[called("BUCKET", groups, key[0])])
            return [_format(form), exp.PartitionedByProperty(this=by_hash)]
        ordered = [exp.Ordered(this=column.copy()) for column in key]
        buckets = exp.ClusteredByProperty(expressions=key[:1], sorted_by=ordered, buckets=groups)
        return [_format(form), buckets]

    return Storage("inside", properties=properties)


def is_large(columns: list[str]) -> bool:
    """Tell by its columns whether a table grows with the data, not with the number of channels."""
    return any(name in columns for name in _LARGE)


def rebalanced(tree: exp.Expr) -> exp.Expr:
    """Let the rows that are written be put together first.

    Cause: every task of the last stage writes files of its own, one per group of channels. Symptom:
    hundreds of small files after a run, and a run's record in several files, whose appearance is not one
    step.
    """
    if not isinstance(tree, exp.Insert) or not isinstance(tree.expression, exp.Select):
        return tree
    names = [column.name for column in tree.this.expressions]
    hint = called("REBALANCE", exp.column(names[0])) if is_large(names) else exp.var("REBALANCE")
    tree.expression.set("hint", exp.Hint(expressions=[hint]))
    return tree


def _format(name: str) -> exp.Expr:
    return exp.FileFormatProperty(this=exp.var(name))


ENGINE = Engine.named(
    "spark",
    types=Types("spark"),
    create_table=create_table,
    storage=_stored("PARQUET"),
    rewrites=(rebalanced,),
)

#: The same over another format of tables.
OVER = {"parquet": ENGINE} | {
    form: dataclasses.replace(ENGINE, storage=_stored(form.upper())) for form in ("delta", "iceberg")
}
