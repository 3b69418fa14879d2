"""Databricks: Spark's SQL over Delta tables, its default format."""

from gam_db.engines.base import Engine
from gam_db.engines.spark import instant_of, micros_of

ENGINE = Engine(
    name="databricks",
    dialect="databricks",
    evidence="rendered",
    micros_of=micros_of,
    instant_of=instant_of,
)
