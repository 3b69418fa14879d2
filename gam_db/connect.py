"""Connecting to the database that holds the state.

This module owns what the address of a database looks like.
"""

from pathlib import Path

import duckdb

from gam_db.engines.duckdb_session import Session
from gam_db.errors import EngineError

_IN_MEMORY = ("duckdb://", "duckdb:///:memory:", ":memory:")
_FILE = "duckdb:///"


def connect(
    target: str | Path | duckdb.DuckDBPyConnection | None = None, threads: int | None = None
) -> Session:
    """Open a database for reading and writing; use it in a ``with`` statement, or close it.

    Args:
        target: ``duckdb:///plant.duckdb`` or the path of a DuckDB file, which is made if it is not
            there; None or ``duckdb://`` for a database in memory; or an open DuckDB connection, which
            stays open.
        threads: processor threads; None leaves DuckDB's own choice.

    Raises:
        EngineError: the address is of another engine, or the database cannot be opened.
    """
    if target is None or isinstance(target, duckdb.DuckDBPyConnection):
        return Session(target, threads, writable=True)
    if not isinstance(target, (str, Path)) or not str(target):
        raise EngineError(
            f"The database is {target!r}; it takes the path of a DuckDB file, duckdb:///PATH, or an "
            "open DuckDB connection."
        )
    address = str(target)
    if address in _IN_MEMORY:
        return Session(None, threads, writable=True)
    scheme, separator, _ = address.partition("://")
    if separator and scheme != "duckdb":
        raise EngineError(
            f"{scheme}:// cannot be opened: gam-db works in DuckDB only so far (duckdb:///PATH). For "
            "another engine `gam compile` and `gam migrate --sql` print the SQL to run there."
        )
    if separator and not address.startswith(_FILE):
        raise EngineError(f"{address} names a server; a DuckDB file is duckdb:///PATH, three slashes.")
    return Session(address.removeprefix(_FILE), threads, writable=True)
