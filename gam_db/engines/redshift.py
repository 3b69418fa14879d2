"""Redshift: PostgreSQL's older relative, with DATEDIFF."""

from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.engines.postgres import INSTANT
from gam_db.engines.storage import Addition, Definition, added_with_statements, with_statements


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
    # EXTRACT(EPOCH) is whole seconds there.
    micros="own.DATEDIFF(MICROSECOND, CAST('1970-01-01 00:00:00' AS TIMESTAMP), :time)",
    instant=INSTANT,
    define=define,
    extend=extend,
)
