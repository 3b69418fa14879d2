"""Databricks: Spark's SQL over Delta tables, its default format."""

from gam_db.engines.base import Engine
from gam_db.engines.spark import ENGINE as SPARK
from gam_db.engines.storage import Storage, clustered

ENGINE = Engine.named(
    "databricks",
    micros=SPARK.micros,
    instant=SPARK.instant,
    storage=Storage("inside", properties=clustered),
)
