"""Database files of the benchmark: how all programs open one and run a template on it."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import duckdb

from gam_db.composing import template
from gam_db.engines.duckdb import ENGINE


def opened(path: Path, threads: int | None = None, read_only: bool = False) -> duckdb.DuckDBPyConnection:
    """Open a DuckDB file; the caller closes it. Without threads DuckDB takes all there are."""
    config: dict[str, Any] = {} if threads is None else {"threads": threads}
    return duckdb.connect(str(path), read_only=read_only, config=config)


def statement(name: str, slots: Mapping[str, template.Slot] | None = None) -> str:
    """Return ``sql/lab/benchmark/<name>.sql`` as DuckDB reads it."""
    return ENGINE.text(template.fill(f"lab/benchmark/{name}", slots))
