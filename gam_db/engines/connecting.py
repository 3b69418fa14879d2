"""Connecting to the database that holds the telemetry and the state.

This module owns which driver an address or an open connection belongs to.
"""

import contextlib
import importlib
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from gam_db import data
from gam_db.address import check
from gam_db.arguments import public
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import EngineError, nearest, wrong

_IN_MEMORY = ("duckdb://", "duckdb:///:memory:", ":memory:")
_FILE = "duckdb:///"

#: Scheme of an address, package of an open connection -> the engine; its ``driver.connected`` opens it.
_SCHEMES, _PACKAGES = data.table("gam_db.engines", "connecting.toml").values()


@public
def connect(
    target: Any = None,
    threads: int | None = None,
    writable: bool = True,
    files: Sequence[str | Path] = (),
) -> Session:
    """Open a database; use it in a ``with`` statement, or close it.

    Args:
        target: an address, or an open connection, which stays open. Addresses are the path of a DuckDB
            file or ``duckdb:///plant.duckdb`` (None or ``duckdb://``: in memory), ``sqlite:///plant.db``,
            ``postgresql://user@host:5432/plant``, ``mariadb://user@host:3306/plant``,
            ``clickhouse://user@host:8123/plant`` (``clickhouses`` with TLS), ``chdb:///folder``
            (ClickHouse inside this process), ``spark:///folder`` (Spark inside this process, tables as
            Parquet in the folder), ``sc://host:15002`` (Spark Connect). Passwords and tokens are best
            left to the environment, in the words of each engine (PGPASSWORD, MYSQL_PWD,
            CLICKHOUSE_PASSWORD, SPARK_CONNECT_AUTHENTICATE_TOKEN). Open connections are those of duckdb,
            sqlite3, psycopg, pymysql and clickhouse_connect, and a SparkSession.
        threads: processor threads of DuckDB; None leaves its own choice.
        writable: open files for writing, and make them if they are not there; else they are only read.
        files: results to be written. Once a source with ``where`` is read, DuckDB opens these, its
            database and the sources read until then, and no other file; an open connection keeps its
            settings.

    Raises:
        EngineError: there is no such engine, its driver is not installed (the message names the
            extra), or the database cannot be opened.
    """
    if isinstance(target, Session):
        raise EngineError("This session is already open; use it without connect().")
    if type(target).__module__.startswith("sqlalchemy."):  # an engine or its URL
        target = getattr(target, "url", target).render_as_string(hide_password=False)
    address = str(target) if isinstance(target, (str, Path)) else None
    if address is None:
        package = type(target).__module__.partition(".")[0].lstrip("_")
        if target is None or package == "duckdb":
            return DuckSession(target, threads, writable, files)
        if package not in _PACKAGES:
            raise wrong("no_database", what=f"a {type(target).__name__}")
        return _opened(_PACKAGES[package], target, writable)
    check(address)
    if address in _IN_MEMORY:
        return DuckSession(None, threads, writable, files)
    scheme, separator, rest = address.partition("://")
    if "+" in scheme:  # as SQLAlchemy writes it: postgresql+psycopg
        scheme = scheme.partition("+")[0]
        address = f"{scheme}://{rest}"
    if not separator or address.startswith(_FILE):
        if not address:
            raise wrong("no_database", what="empty")
        return DuckSession(address.removeprefix(_FILE), threads, writable, files)
    if scheme == "duckdb":
        raise EngineError(
            f"{address} names a server; for a DuckDB file write duckdb:///PATH, with three slashes."
        )
    if scheme not in _SCHEMES:
        raise wrong("no_such_database", scheme=scheme, hint=nearest(scheme, _SCHEMES))
    return _opened(_SCHEMES[scheme], address, writable)


def engine_of(address: str | None) -> str:
    """Return the name of the engine of an address; DuckDB where there is none, or a path."""
    scheme, separator, _ = (address or "").partition("://")
    return _SCHEMES.get(scheme.partition("+")[0], "duckdb") if separator else "duckdb"


@contextlib.contextmanager
def borrowed(engine: Any, threads: int | None = None) -> Iterator[Session]:
    """Yield a session for reading: the caller's, which stays open, or one that is closed afterwards.

    It is opened, and errors are raised, as by :func:`connect`.
    """
    if isinstance(engine, Session):
        yield engine
        return
    with connect(engine, threads, writable=False) as session:
        yield session


def _opened(engine: str, target: Any, writable: bool) -> Session:
    driver = importlib.import_module(f"gam_db.engines.{engine}.driver").connected(target, writable)
    return Session(driver, writer=DuckSession)
