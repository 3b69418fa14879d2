"""Redshift: PostgreSQL's older relative, with DATEDIFF."""

from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called
from gam_db.engines.postgres import instant_of
from gam_db.engines.storage import Addition, Definition, added_with_statements, with_statements


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds; EXTRACT(EPOCH) is whole seconds there."""
    epoch = exp.cast(template.text("1970-01-01 00:00:00"), "TIMESTAMP")
    return called("DATEDIFF", exp.var("MICROSECOND"), epoch, column)


def define(definition: Definition) -> list[exp.Expr]:
    """Return a table sorted by its key."""
    create, *comments = with_statements(definition)
    if not definition.is_view:
        key = exp.SortKeyProperty(this=[column.this for column in definition.key], compound=True)
        create.set("properties", exp.Properties(expressions=[key]))
    return [create, *comments]


def extend(addition: Addition) -> list[exp.Expr]:
    """Return the statements that add columns: Redshift has no IF NOT EXISTS here."""
    return added_with_statements(addition, twice=False)


ENGINE = Engine(
    name="redshift",
    title="Redshift",
    dialect="redshift",
    limits="gam-db does not connect to it; it prints the SQL. Sort keys and DATEDIFF were not seen "
    "at work.",
    micros=micros_of,
    instant=instant_of,
    define=define,
    extend=extend,
)
