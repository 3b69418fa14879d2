"""BigQuery."""

from sqlglot import exp

from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter, escape_by_backslash
from gam_db.engines.storage import Definition, clustered, with_notes


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds of a TIMESTAMP, DATETIME (UTC) or DATE."""
    if kind.is_counter:
        return counter(column)
    return called("UNIX_MICROS", exp.cast(column, "TIMESTAMPTZ"))


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the TIMESTAMP of epoch microseconds."""
    return micros if kind.is_counter else called("TIMESTAMP_MICROS", micros)


def define(definition: Definition) -> list[exp.Expr]:
    """Return a table clustered by its key, with comments as OPTIONS."""
    return with_notes(
        definition,
        [clustered(definition)],
        column_note=lambda said: exp.Properties(expressions=[_described(said)]),
        note=_described,
    )


def _described(said: exp.Expr) -> exp.Expr:
    return exp.Property(this=exp.var("description"), value=said)


ENGINE = Engine(
    name="bigquery",
    title="BigQuery",
    dialect="bigquery",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
    define=define,
    rewrites=(escape_by_backslash,),
)
