"""BigQuery."""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, escape_by_backslash


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds of a TIMESTAMP, DATETIME (UTC) or DATE."""
    if kind.is_counter:
        return counter(column)
    return called("UNIX_MICROS", exp.cast(column, "TIMESTAMPTZ"))


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the TIMESTAMP of epoch microseconds."""
    return micros if kind.is_counter else called("TIMESTAMP_MICROS", micros)


ENGINE = Engine(
    name="bigquery",
    dialect="bigquery",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
    rewrites=(escape_by_backslash,),
)
