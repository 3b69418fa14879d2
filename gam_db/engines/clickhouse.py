"""ClickHouse 24.5 and later (conditions beside the equality of a join)."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, escape_by_backslash, table_as

_UTC = "UTC"


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


ENGINE = Engine(
    name="clickhouse",
    dialect="clickhouse",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
    rewrites=(escape_by_backslash,),
    create_table=create_table,
)
