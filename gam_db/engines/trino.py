"""Trino and Athena."""

from gam_db.engines.base import Engine
from gam_db.engines.storage import merged

ENGINE = Engine.named("trino", fill=merged)
