"""dbt's adapters: which one serves an engine, and how it replaces rows of an incremental model.

This module owns a small table; what an engine's SQL looks like is in :mod:`gam_db.engines`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from gam_db.engines.postgres import PATH
from gam_db.errors import EngineError

#: What the schema tests and the builds were really run on; the others are only rendered.
BUILT = ("duckdb", "postgres")


@dataclass(frozen=True)
class Adapter:
    """An adapter of dbt.

    Attributes:
        package: what pip installs.
        strategy: incremental strategy that replaces the rows with the same key, and keeps all others.
        config: what the models that are tables must say besides.
        profile: what a profile says of a target, by way of example.
        before: what is set for each transaction in which a query of ours runs; empty for nothing.
    """

    package: str
    profile: Mapping[str, Any]
    strategy: str = "delete+insert"
    config: Mapping[str, Any] = field(default_factory=dict)
    before: str = ""

    @property
    def view(self) -> dict[str, Any]:
        """What the models that are views must say besides."""
        return {"pre_hook": self.before} if self.before else {}


_PATH = f"SET LOCAL search_path TO {PATH}"


_LOGIN = {"host": "localhost", "user": "gam"}
_PLANT = {"dbname": "plant", "schema": "public"}


def _secret(variable: str) -> str:
    return f"{{{{ env_var('{variable}') }}}}"


ADAPTERS = {
    "duckdb": Adapter("dbt-duckdb", {"path": "../plant.duckdb", "schema": "main"}),
    # Its planner expects few rows of any WITH entry and joins two of them by nested loops: 4,408 buckets
    # then take 44 s instead of 4 s, twice as many four times that.
    "postgres": Adapter(
        "dbt-postgres",
        {
            **_LOGIN,
            "port": 5432,
            "password": _secret("PGPASSWORD"),
            **_PLANT,
        },
        config={"pre_hook": [_PATH, "SET LOCAL enable_nestloop = off"]},
        before=_PATH,
    ),
    "clickhouse": Adapter(
        "dbt-clickhouse",
        {**_LOGIN, "port": 8123, "password": _secret("CLICKHOUSE_PASSWORD"), "schema": "plant"},
    ),
    "spark": Adapter(
        "dbt-spark",
        {"method": "thrift", "host": "localhost", "port": 10000, "schema": "plant"},
        "merge",
        {"file_format": "delta"},
    ),
    "databricks": Adapter(
        "dbt-databricks",
        {
            **{"host": "dbc-1.cloud.databricks.com", "http_path": "/sql/1.0/warehouses/1"},
            **{"token": _secret("DATABRICKS_TOKEN"), "catalog": "main", "schema": "plant"},
        },
        "merge",
    ),
    "bigquery": Adapter(
        "dbt-bigquery", {"method": "oauth", "project": "my-project", "dataset": "plant"}, "merge"
    ),
    "snowflake": Adapter(
        "dbt-snowflake",
        {
            **{"account": "my-account", "user": "gam", "password": _secret("SNOWFLAKE_PASSWORD")},
            **{"warehouse": "gam", "database": "plant", "schema": "public"},
        },
    ),
    "redshift": Adapter(
        "dbt-redshift",
        {
            **_LOGIN,
            "port": 5439,
            "password": _secret("PGPASSWORD"),
            **_PLANT,
        },
    ),
    "trino": Adapter(
        "dbt-trino", {**_LOGIN, "method": "none", "port": 8080, "database": "hive", "schema": "plant"}
    ),
}


def adapter_of(engine: str) -> Adapter:
    """Return the adapter that serves an engine.

    Raises:
        EngineError: none does.
    """
    if engine not in ADAPTERS:
        raise EngineError(f"dbt has no adapter for {engine}; take one of {', '.join(ADAPTERS)}.")
    return ADAPTERS[engine]
