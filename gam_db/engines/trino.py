"""Trino and Athena."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called
from gam_db.engines.storage import merged


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds, to the millisecond: DATE_DIFF knows no finer unit."""
    epoch = exp.cast(template.text("1970-01-01 00:00:00"), "TIMESTAMP")
    millis = called("DATE_DIFF", template.text("millisecond"), epoch, exp.cast(column, "TIMESTAMP"))
    return exp.Mul(this=millis, expression=exp.Literal.number(1000))


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds."""
    nanos = exp.Mul(this=micros, expression=exp.Literal.number(1000))
    return called("FROM_UNIXTIME_NANOS", nanos)


ENGINE = Engine(
    name="trino",
    title="Trino",
    dialect="trino",
    transactions=False,
    limits="gam-db does not connect to it; it prints the SQL. No statement was run. "
    "Times are exact to the millisecond.",
    micros=micros_of,
    instant=instant_of,
    fill=merged,
)
