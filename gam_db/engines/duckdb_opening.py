"""Opening a DuckDB database, and what a connection must be like to be used."""

import contextlib
import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import duckdb
import sqlglot

from gam_db.engines.duckdb_journal import journal_of, put_back
from gam_db.engines.refusals import refused
from gam_db.errors import EngineError


def opened(target: Any, writable: bool) -> duckdb.DuckDBPyConnection:
    """Open a database file, or one in memory for None.

    Raises:
        EngineError: it is not there, is no DuckDB file, is damaged, is in use, or may not be written.
    """
    if target is None:
        return _with_our_checkpoints(duckdb.connect())
    path = Path(str(target).removeprefix("duckdb:///"))
    if not path.exists() and not (writable and path.parent.is_dir()):
        raise EngineError(f"There is no database file {path}.")
    put_back(path)
    try:
        return _with_our_checkpoints(duckdb.connect(str(path), read_only=not writable))
    except duckdb.Error as error:
        journal, target = journal_of(path.resolve()), path if path.exists() else path.parent
        may_write = os.access(target, os.W_OK, effective_ids=os.access in os.supports_effective_ids)
        raise refused(
            *("duckdb_opening", f"{error}{' journal' * journal.exists()}"),
            *(["unwritable"] if writable and not may_write else []),
            path=path,
            journal=journal.name,
        ) from error


def _with_our_checkpoints(connection: duckdb.DuckDBPyConnection) -> duckdb.DuckDBPyConnection:
    """Keep DuckDB from checkpoints of its own accord, which have no journal."""
    connection.execute("SET checkpoint_threshold = '1000 TB'")
    connection.execute("PRAGMA disable_checkpoint_on_shutdown")
    return connection


#: What DuckDB writes beside a database file.
_BESIDE = ("", ".wal", ".wal.checkpoint", ".wal.recovery")


def shut(connection: duckdb.DuckDBPyConnection, sources: Iterable[str], results: Iterable[Path]) -> None:
    """Let a connection of our own open no other files for as long as it lasts, beside its own database.

    But for sources (patterns among them), what views name, and results, which may be attached.
    It stays as it is where a source is remote, as what reads that is loaded when it is needed, and where
    the database is open on another connection of the process, which shares the setting.
    """
    query = (
        "SELECT current_setting('enable_external_access') AND count = 1 FROM duckdb_connection_count()"
    )
    if connection.execute(query).fetchall() != [(True,)]:
        return
    patterns = {*sources, *_named_in_views(connection)}
    if any("://" in one for one in patterns):
        return
    allowed = patterns | {f"{path}{end}" for path in results for end in _BESIDE}
    for pattern in patterns:
        with contextlib.suppress(duckdb.IOException):  # a text in a view that is no pattern
            allowed.update(*connection.execute("SELECT file FROM glob(?)", [pattern]).fetchall())
    connection.execute("SET allowed_paths = ?", [sorted(allowed)])
    connection.execute("SET enable_external_access = false")


def _named_in_views(connection: duckdb.DuckDBPyConnection) -> set[str]:
    """Return all in the definitions of views that may be the path of a file."""
    views = connection.execute("SELECT sql FROM duckdb_views() WHERE NOT internal").fetchall()
    tokens = [token for (text,) in views for token in sqlglot.tokenize(text, read="duckdb")]
    quoted = (sqlglot.TokenType.STRING, sqlglot.TokenType.IDENTIFIER)
    texts = {one.text for one in tokens if one.token_type in quoted and {".", "/"} & {*one.text}}
    return {text for text in texts if not text.endswith(("/", "."))}


@contextlib.contextmanager
def without_checkpoint(connection: duckdb.DuckDBPyConnection) -> Iterator[None]:
    """Let a file be detached as it is."""
    query = "SELECT current_setting('checkpoint_on_detach')"
    before = connection.execute(query).fetchall()[0][0]
    connection.execute("SET checkpoint_on_detach = 'DISABLED'")
    try:
        yield
    finally:
        connection.execute("SET checkpoint_on_detach = ?", [before])


@contextlib.contextmanager
def written(path: Path) -> Iterator[None]:
    """Say in the user's words why a file of results cannot be written."""
    try:
        yield
    except (OSError, duckdb.IOException, duckdb.FatalException, duckdb.TransactionException) as error:
        raise refused("results", str(error), path=path) from error


def check_settings(connection: duckdb.DuckDBPyConnection) -> None:
    """Refuse a connection that is closed, or that compares or orders otherwise than the method."""
    try:
        found = connection.execute(
            "SELECT current_setting('default_order'), current_setting('default_collation')"
        ).fetchall()
    except duckdb.Error as error:
        raise EngineError(
            "The DuckDB connection cannot be used; is it closed, in a transaction that has failed, or "
            "still giving out the rows of a query?"
        ) from error
    order, collation = found[0]
    if str(order).upper().startswith("DESC"):
        raise EngineError(
            "The DuckDB connection has default_order = DESC, which would turn time around; RESET "
            "default_order, or give another connection."
        )
    if str(collation):
        raise EngineError(
            f"The DuckDB connection has default_collation = {collation}, under which different names "
            "can be equal; RESET default_collation, or give another connection."
        )
