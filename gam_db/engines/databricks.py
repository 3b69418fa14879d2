"""Databricks: Spark's SQL over Delta tables, its default format."""

from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.engines.spark import INSTANT, MICROS, extend
from gam_db.engines.storage import Definition, clustered, merged, with_notes


def define(definition: Definition) -> list[exp.Expr]:
    """Return a Delta table clustered by its key, with comments inside."""
    return with_notes(definition, [clustered(definition)])


ENGINE = Engine(
    name="databricks",
    title="Databricks",
    dialect="databricks",
    transactions=False,
    limits="gam-db does not connect to it; it prints the SQL. Delta tables were not seen at work.",
    micros=MICROS,
    instant=INSTANT,
    define=define,
    extend=extend,
    fill=merged,
)
