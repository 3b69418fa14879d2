"""Snowflake."""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called
from gam_db.engines.storage import Definition, added_with_notes, clustered, with_notes


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds."""
    return called("DATE_PART", exp.var("EPOCH_MICROSECOND"), column)


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds, without a zone unless the source has one."""
    zoned = kind is TimeKind.TIMESTAMP_WITH_ZONE
    name = "TO_TIMESTAMP_LTZ" if zoned else "TO_TIMESTAMP_NTZ"
    return called(name, micros, exp.Literal.number(6))


def define(definition: Definition) -> list[exp.Expr]:
    """Return a table clustered by its key, with comments inside."""
    return with_notes(definition, [clustered(definition)])


ENGINE = Engine(
    name="snowflake",
    title="Snowflake",
    dialect="snowflake",
    limits="gam-db does not connect to it; it prints the SQL. No statement was run.",
    micros=micros_of,
    instant=instant_of,
    define=define,
    extend=added_with_notes,
)
