"""Trino and Athena."""

from gam_db.engines.base import Engine

ENGINE = Engine.named("trino")
