"""DuckDB at work: a driver on a connection."""

import contextlib
import os
import re
from collections.abc import Sequence
from functools import cache, lru_cache
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
from sqlglot import exp

from gam_db import data
from gam_db.engines.base import temporary
from gam_db.engines.driver import Driver
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.encoding import Copies, looks_wide, not_utf8
from gam_db.engines.duckdb.files import (
    late_word,
    matching,
    no_table,
    unalike,
    without_results,
    wrong_line,
)
from gam_db.engines.duckdb.journal import Journal, journal_of, put_back
from gam_db.engines.duckdb.reading import (
    csv_reader,
    is_csv_reader,
    is_text_file,
    parquet_reader,
    paths_read,
)
from gam_db.engines.duckdb.several import (
    Columns,
    Differing,
    columns_of_parquet,
    csv_files,
    parquet_files,
)
from gam_db.engines.refusals import UNWRITTEN, first_line, refusal, refused
from gam_db.errors import EngineError, SourceError, UserError, wrong
from gam_db.settings.form import Form
from gam_db.settings.source import paths_of, shown_relation

#: The log goes into the file when it has grown beyond so many bytes, and when the file is closed.
LARGE_LOG = 2**24

_UNITS = {"bytes": 1, "KiB": 2**10, "MiB": 2**20, "GiB": 2**30, "TiB": 2**40}

_FILE = re.compile(r'file "([^"]+)"')

#: What one reading takes while it is scored, in bytes: kept once, sorted in a window, joined.
_PER_READING = 100

_AT_WORK = data.table("gam_db.engines.duckdb", "duckdb.toml")
_QUERIES = _AT_WORK["queries"]


class DuckDriver(Driver):
    """A connection to DuckDB; arguments and errors are those of its session."""

    engine = ENGINE
    errors = (duckdb.Error,)
    begins_reading = "BEGIN TRANSACTION READ ONLY"

    def __init__(self, target: Any, threads: int | None, writable: bool) -> None:
        ENGINE.check_version(duckdb.__version__)
        self.owned = not isinstance(target, duckdb.DuckDBPyConnection)
        if self.owned:
            self.connection = _opened(target, writable)
            for statement in _AT_WORK["settings"].values():
                self.connection.execute(statement)
            self._journal = Journal(self.connection) if writable and target is not None else None
        else:
            self.connection, self._journal = target, None
            _check_settings(target)
        if threads is not None:
            self.connection.execute("SET threads = ?", [threads])
        self.sources: list[str] = []  # paths of the files that were read
        self.copies = Copies()
        self._readers: list[exp.Expr] = []
        self._differing: dict[exp.Expr, list[Differing]] = {}  # by the node that reads the files
        self._registered: set[str] = set()

    def execute(self, statement: str) -> None:
        """Run one statement; raise the reason if the database cannot be written."""
        try:
            self.connection.execute(parsed(statement))
        except duckdb.Error as error:
            # Of a commit that the disk had no room for, DuckDB says that the transaction failed.
            user_error = refusal("duckdb_writing", type(error).__name__, str(error))
            if self.problem(error) is not None or user_error is None:
                raise
            raise user_error from error

    def fetch(self, query: str) -> pa.Table:
        return self.connection.sql(parsed(query)).to_arrow_table()

    def rows(self, query: str) -> list[dict[str, Any]]:
        # Not by way of Arrow: a relation is bound when it is made, and again when its rows are read.
        # (Of instants with a zone DuckDB makes Python's by pytz only; nothing that is read so has any.)
        cursor = self.connection.execute(parsed(query))
        names = [column[0] for column in cursor.description]
        return [dict(zip(names, row, strict=True)) for row in cursor.fetchall()]

    def begin(self) -> None:
        self.execute("BEGIN")

    def commit(self) -> None:
        """End it, and write a log that has grown large into the file."""
        self.execute("COMMIT")
        self.checkpoint(LARGE_LOG)

    def rollback(self) -> None:
        """Roll back; after some errors DuckDB has already done so, and raises an error."""
        self.connection.execute("ROLLBACK")

    def in_transaction(self) -> bool:
        """Tell whether a transaction is open: only then two statements have the same number.

        It is not tried by beginning one: that fails, and takes the user's transaction with it.
        """
        try:
            first, second = (
                self.connection.execute(parsed("SELECT txid_current()")).fetchall() for _ in range(2)
            )
        except duckdb.TransactionException:  # one that has failed already
            return True
        return first == second

    def checkpoint(self, above: int = 0) -> None:
        """Write the log into the file if it is ours, and the log larger than so many bytes."""
        if self._journal is not None:
            try:
                self._journal.checkpoint(above)
            except (duckdb.TransactionException, OSError):
                pass  # another connection is at work, or there is no room: it stays in the log
            except duckdb.Error as error:
                raise self.problem(error) or EngineError(UNWRITTEN) from error

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.connection.execute(parsed(self.engine.text(temporary(table, query))))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        """Make an Arrow table readable without a copy, or refuse types that DuckDB lacks."""
        try:
            self.connection.register(table.name, rows)
        except duckdb.Error as error:
            types = ", ".join(sorted({str(field.type) for field in rows.schema}))
            raise wrong("duckdb_arrow", types=types) from error
        self._registered.add(table.name)

    def drop(self, table: exp.Table) -> None:
        """Drop a table made by :meth:`keep`, or let go of one given to :meth:`ingest`."""
        if table.name in self._registered:
            self._registered.remove(table.name)
            self.connection.unregister(table.name)
        else:
            super().drop(table)

    def tables(self) -> list[tuple[str, ...]]:
        return self.catalogue_rows("tables")

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node as it is, but for a view of what cannot be read."""
        try:
            self.describe(table)
        except duckdb.Error as error:
            shown = ".".join(part.name for part in table.parts)  # type: ignore[attr-defined]
            raise wrong("duckdb_unreadable_table", shown=shown, first_line=first_line(error)) from error
        return table

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        everything = exp.Describe(this=exp.select("*").from_(relation))
        rows = self.connection.execute(parsed(self.engine.text(everything))).fetchall()
        types = {str(row[0]): str(row[1]) for row in rows}
        return types | {column.name: column.shown for column in self._differing.get(relation, [])}

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema, unless DuckDB takes its name for a database's."""
        databases = {name.casefold() for (name,) in self.catalogue_rows("databases")}
        if schema is not None and schema.casefold() in databases:
            raise wrong("duckdb_schema_like_database", schema=schema)
        return {
            name.casefold(): tuple(columns) for name, columns in self.catalogue_rows("relations", schema)
        }

    def file(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads files, written in a form, which all have the same columns."""
        paths = paths_of(relation)
        sources = without_results(self.connection, paths)
        self.sources += sources
        texts = [path for path in sources if is_text_file(path)]
        if 0 < len(texts) < len(sources):
            other = next(path for path in sources if path not in texts)
            raise SourceError(f"{texts[0]} is CSV, and {other} is Parquet; give files of one type.")
        files = matching(self.connection, sources)
        if texts:
            form = form or Form()
            if form.encoding is not None:
                files = [self.copies.of(file, form.encoding) for file in files]
            try:
                node = csv_files(self.connection, files, form, self._columns_of_text)
            except SourceError as error:
                raise self.copies.original(error) from error
            self._readers.append(node)
        else:
            node = self._parquet(sources, files)
        self._columns(node, shown_relation(paths))
        return node

    def by_pattern(self, node: exp.Expr) -> exp.Expr:
        """Return a node that reads several CSV files with their patterns; any other as it is."""
        if isinstance(node, exp.Table) and is_csv_reader(node) and len(paths_read(node)) > 1:
            return csv_reader(self.sources, node.this.expressions[1:])
        return node

    def _parquet(self, sources: Sequence[str], files: Sequence[str]) -> exp.Expr:
        """Return the node that reads Parquet files."""
        if len(files) > 1:
            try:
                by_file = columns_of_parquet(self.connection, files)
            except duckdb.Error:  # which of them cannot be read?
                by_file = {file: {**self._columns(parquet_reader([file]), file)} for file in files}
            node, differing = parquet_files(self.connection, sources, by_file)
            self._differing |= {node: differing} if differing else {}
            return node
        return parquet_reader(sources)

    def _columns_of_text(self, node: exp.Expr, path: str) -> Columns | None:
        """Return the columns of a CSV file; None if it has no row."""
        columns = self._columns(node, path)
        if any("\0" in name for name in columns):
            raise not_utf8(path)
        if {*columns.values()} == {"VARCHAR"}:
            first = exp.select(exp.Literal.number(1)).from_(node.copy()).limit(1)
            if not self.connection.execute(self.engine.text(first)).fetchall():
                return None
        return columns

    def _columns(self, node: exp.Expr, path: str) -> Columns:
        """Return the columns of files, which are shown as a path, and their types."""
        try:
            return self.describe(node)
        except duckdb.IOException as error:
            raise wrong("file_unreadable", path=path) from error
        except duckdb.Error as error:
            if is_csv_reader(node) and looks_wide(path):
                raise not_utf8(path) from error
            raise self.problem(error) or no_table(path, str(error)) from error

    def rows_at_once(self) -> int:
        ((memory,),) = self.catalogue_rows("memory")
        amount, _, unit = str(memory).partition(" ")
        return max(int(float(amount) * _UNITS.get(unit, 2**20)) // _PER_READING, 100_000)

    def threads(self) -> int:
        return int(self.catalogue_rows("threads")[0][0])

    def problem(self, error: Exception) -> UserError | None:
        if isinstance(error, duckdb.PermissionException) and self.owned:
            return wrong("duckdb_other_file", said=first_line(error).partition(" - ")[0])
        if isinstance(error, duckdb.ConversionException) and (
            misfit := late_word(self.connection, error, self._readers)
        ):
            return self.copies.original(misfit)
        what = (type(error).__name__, str(error))
        if (user_error := refusal(self.engine.name, *what, place=_place(str(error)))) is not None:
            return user_error
        if isinstance(error, duckdb.Error) and (differing := unalike(error)):
            return differing
        if "CSV Error" in first_line(error) and not isinstance(error, duckdb.IOException):
            return self.copies.original(wrong_line(str(error)))
        return None

    def close(self) -> None:
        """Close the connection if it is ours, with its log written into the file."""
        self.copies.close()
        if not self.owned:
            return
        others = False
        if self._journal is not None:
            with contextlib.suppress(EngineError):  # what was committed is in the log
                self.checkpoint()
            with contextlib.suppress(duckdb.Error):  # it is closed already
                others = self.catalogue_rows("is_shared")[0][0]
        self.connection.close()
        if self._journal is not None:
            self._journal.close(others)

    def catalogue_rows(self, query: str, *values: Any) -> list[tuple[Any, ...]]:
        """Return the rows of a query on the catalogue."""
        return self.connection.execute(parsed(_QUERIES[query]), values).fetchall()


@lru_cache(1000)
def parsed(text: str) -> Any:
    """Return a statement as DuckDB parses it by default, without the user's settings.

    Parsing is a fifth of what a statement costs that works on few rows, and a run executes the same ones
    for each group of channels; a statement takes about 20 times the memory of its text.

    Raises:
        duckdb.Error: it is no statement.
    """
    (statement,) = _parser().extract_statements(text)
    return statement


@cache
def _parser() -> duckdb.DuckDBPyConnection:
    return duckdb.connect(config={"threads": 1})


def _place(message: str) -> str:
    """Return the file that an error of DuckDB names, if it names one."""
    match = _FILE.search(message)
    return match[1] if match else "the DuckDB file, or of its temporary files,"


def _opened(target: Any, writable: bool) -> duckdb.DuckDBPyConnection:
    """Open a database file, or one in memory for None."""
    if target is None:
        return duckdb.connect()
    path = Path(str(target).removeprefix("duckdb:///"))
    if not path.exists() and not (writable and path.parent.is_dir()):
        raise EngineError(f"There is no database file {path}.")
    put_back(path)
    try:
        return duckdb.connect(str(path), read_only=not writable)
    except duckdb.Error as error:
        journal, target = journal_of(path.resolve()), path if path.exists() else path.parent
        may_write = os.access(target, os.W_OK, effective_ids=os.access in os.supports_effective_ids)
        raise refused(
            *("duckdb_opening", f"{error}{' journal' * journal.exists()}"),
            *(["unwritable"] if writable and not may_write else []),
            path=path,
            journal=journal.name,
        ) from error


def _check_settings(connection: duckdb.DuckDBPyConnection) -> None:
    """Refuse a connection that is closed, or that compares or orders otherwise than the method."""
    try:
        ((order, collation),) = connection.execute(_QUERIES["order"]).fetchall()
    except duckdb.Error as error:
        raise wrong("duckdb_connection") from error
    if str(order).upper().startswith("DESC"):
        raise wrong("duckdb_descending")
    if str(collation):
        raise wrong("duckdb_collation", collation=collation)
