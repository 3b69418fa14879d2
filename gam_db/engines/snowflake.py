"""Snowflake."""

from gam_db.engines.base import Engine
from gam_db.engines.storage import Storage, clustered

ENGINE = Engine.named("snowflake", storage=Storage("inside", properties=clustered))
