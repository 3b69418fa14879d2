"""PostgreSQL 14 and later."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import SECOND, TimeKind
from gam_db.engines.base import Engine, called, counter


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds, exact since EXTRACT is numeric; NULL for infinite times."""
    if kind.is_counter:
        return counter(column)
    epoch = exp.Extract(this=exp.var("EPOCH"), expression=column)
    micros = exp.cast(exp.Mul(this=epoch, expression=exp.Literal.number(SECOND)), "BIGINT")
    return exp.Case(ifs=[exp.If(this=called("ISFINITE", column.copy()), true=micros)])


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds, exact below 2^53 microseconds from 1970."""
    if kind.is_counter:
        return micros
    zoned = kind is TimeKind.TIMESTAMP_WITH_ZONE
    epoch = exp.cast(
        template.text("1970-01-01 00:00:00+00" if zoned else "1970-01-01 00:00:00"),
        "TIMESTAMPTZ" if zoned else "TIMESTAMP",
    )
    step = exp.Interval(this=template.text("1 microsecond"))
    return exp.Add(this=epoch, expression=exp.Mul(this=micros, expression=step))


ENGINE = Engine(
    name="postgres",
    dialect="postgres",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
    flow_hint=True,
)
