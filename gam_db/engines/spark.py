"""Spark 3.5 and later, in ANSI mode."""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, table_as
from gam_db.engines.storage import Definition, with_notes


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds; a timestamp without zone is read as UTC by a session in UTC."""
    if kind.is_counter:
        return counter(column)
    return called("UNIX_MICROS", exp.cast(column, "TIMESTAMPTZ"))


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds."""
    return micros if kind.is_counter else called("TIMESTAMP_MICROS", micros)


def create_table(table: exp.Table, query: exp.Query) -> exp.Create:
    """Return CREATE TABLE ... USING PARQUET AS; without a format Spark may ask for Hive."""
    create = table_as(table, query)
    create.set("properties", exp.Properties(expressions=[_parquet()]))
    return create


def define(definition: Definition) -> list[exp.Expr]:
    """Return a Parquet table with comments inside."""
    return with_notes(definition, [_parquet()])


def _parquet() -> exp.Expr:
    return exp.FileFormatProperty(this=exp.var("PARQUET"))


ENGINE = Engine(
    name="spark",
    title="Spark",
    dialect="spark",
    oldest="3.5",
    extra="spark",
    transactions=False,
    limits="A run is seen once its commit row is there; a second writer is detected, not prevented.",
    micros_of=micros_of,
    instant_of=instant_of,
    create_table=create_table,
    define=define,
)
