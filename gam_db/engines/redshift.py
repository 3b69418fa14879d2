"""Redshift: PostgreSQL's older relative, with DATEDIFF."""

from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.engines.postgres import INSTANT
from gam_db.engines.storage import Definition, Storage


def _sorted(definition: Definition) -> list[exp.Expr]:
    """Return that a table is sorted by its key."""
    return [exp.SortKeyProperty(this=[column.this for column in definition.key], compound=True)]


ENGINE = Engine(
    name="redshift",
    title="Redshift",
    dialect="redshift",
    limits="gam-db does not connect to it; it prints the SQL. Sort keys and DATEDIFF were not seen "
    "at work.",
    # EXTRACT(EPOCH) is whole seconds there.
    micros="own.DATEDIFF(MICROSECOND, CAST('1970-01-01 00:00:00' AS TIMESTAMP), :time)",
    instant=INSTANT,
    storage=Storage(properties=_sorted, adds_twice=False),
)
