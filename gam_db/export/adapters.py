"""dbt's adapters: which one serves an engine, and how it replaces rows of an incremental model.

This module owns a small table, ``adapters.toml``; what the SQL of an engine looks like is in
:mod:`gam_db.engines`.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from gam_db import data
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


ADAPTERS = {
    engine: Adapter(**said) for engine, said in data.table("gam_db.export", "adapters.toml").items()
}


def adapter_of(engine: str) -> Adapter:
    """Return the adapter that serves an engine.

    Raises:
        EngineError: none does.
    """
    if engine not in ADAPTERS:
        raise EngineError(f"dbt has no adapter for {engine}; take one of {', '.join(ADAPTERS)}.")
    return ADAPTERS[engine]
