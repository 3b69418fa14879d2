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
        before: what is set for each transaction in which a query of ours runs; empty for nothing.
    """

    package: str
    strategy: str = "delete+insert"
    config: Mapping[str, Any] = field(default_factory=dict)
    before: str = ""

    @property
    def view(self) -> dict[str, Any]:
        """What the models that are views must say besides."""
        return {"pre_hook": self.before} if self.before else {}


_PATH = f"SET LOCAL search_path TO {PATH}"


ADAPTERS = {
    "duckdb": Adapter("dbt-duckdb"),
    # Its planner expects few rows of any WITH entry and joins two of them by nested loops: 4,408 buckets
    # then take 44 s instead of 4 s, twice as many four times that.
    "postgres": Adapter(
        "dbt-postgres", config={"pre_hook": [_PATH, "SET LOCAL enable_nestloop = off"]}, before=_PATH
    ),
    "clickhouse": Adapter("dbt-clickhouse"),
    "spark": Adapter("dbt-spark", "merge", {"file_format": "delta"}),
    "databricks": Adapter("dbt-databricks", "merge"),
    "bigquery": Adapter("dbt-bigquery", "merge"),
    "snowflake": Adapter("dbt-snowflake"),
    "redshift": Adapter("dbt-redshift"),
    "trino": Adapter("dbt-trino"),
}


def adapter_of(engine: str) -> Adapter:
    """Return the adapter that serves an engine.

    Raises:
        EngineError: none does.
    """
    if engine not in ADAPTERS:
        raise EngineError(f"dbt has no adapter for {engine}; take one of {', '.join(ADAPTERS)}.")
    return ADAPTERS[engine]
