"""Databricks: Spark's SQL over Delta tables, its default format."""

from gam_db.engines.base import Engine
from gam_db.engines.spark import INSTANT, MICROS
from gam_db.engines.storage import Storage, clustered, merged

ENGINE = Engine(
    name="databricks",
    title="Databricks",
    dialect="databricks",
    transactions=False,
    limits="gam-db does not connect to it; it prints the SQL. Delta tables were not seen at work.",
    micros=MICROS,
    instant=INSTANT,
    storage=Storage("inside", properties=clustered, adds_twice=False),
    fill=merged,
)
