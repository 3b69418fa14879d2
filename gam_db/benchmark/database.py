"""Database files of the benchmark: how all programs open one and run a template on it."""

from pathlib import Path

import duckdb

from gam_db import template
from gam_db.engines.duckdb import ENGINE


def opened(path: Path, threads: int, read_only: bool = False) -> duckdb.DuckDBPyConnection:
    """Open a DuckDB file; the caller closes it."""
    return duckdb.connect(str(path), read_only=read_only, config={"threads": threads})


def statement(name: str) -> str:
    """Return ``sql/benchmark/<name>.sql`` as DuckDB reads it."""
    return ENGINE.text(template.fill(f"benchmark/{name}"))
