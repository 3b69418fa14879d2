"""DuckDB at work: a session on a connection."""

import contextlib
import itertools
import secrets
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.engines.base import deletion
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb_files import late_word, metadata, no_table, without_results
from gam_db.engines.duckdb_journal import Journal
from gam_db.engines.duckdb_opening import (
    attached,
    check_settings,
    is_among,
    opened,
    rows_at_once,
    shut,
)
from gam_db.engines.duckdb_reading import file_reader, is_csv_reader
from gam_db.engines.session import CONFLICT, FULL, OPEN, READ_ONLY, arrow_table, unwritable
from gam_db.errors import ConflictError, EngineError, SourceError, StatementError, nearest
from gam_db.form import Form
from gam_db.source import is_file, paths_of, table_names

OLDEST = (2, 0)

#: The log goes into the file when it has grown beyond so many bytes, and when the file is closed.
LARGE_LOG = 2**24


class DuckSession:
    """DuckDB at work: describes relations, keeps temporary tables, runs trees.

    Args:
        target: None for a database in memory, the path of a database file, or an open connection,
            which stays open and keeps nothing of ours.
        threads: processor threads; None leaves DuckDB's own choice.
        writable: open a database file for writing, and make it if it is not there; else it is only read.
        files: what it may open, beside its database and its sources, once a condition of a user's was
            tried; an open connection keeps its settings, and may open all that it could.

    Raises:
        EngineError: the file cannot be opened, this DuckDB is too old, or the connection is closed or
            set to compare or order in a way that would change results.
    """

    engine = ENGINE
    transactions = True

    def __init__(
        self,
        target: Any = None,
        threads: int | None = None,
        writable: bool = False,
        files: Sequence[str | Path] = (),
    ) -> None:
        if tuple(int(part) for part in duckdb.__version__.split(".")[:2]) < OLDEST:
            raise EngineError(
                f"DuckDB {duckdb.__version__} is too old; gam-db needs "
                f"{'.'.join(map(str, OLDEST))} or later."
            )
        self.owned = not isinstance(target, duckdb.DuckDBPyConnection)
        if self.owned:
            self.connection = opened(target, writable)
            self._journal = Journal(self.connection) if writable and target is not None else None
            self.connection.execute("SET TimeZone = 'UTC'")
            # Progress is counted, for whoever asks, but not painted: standard output is the caller's.
            self.connection.execute("SET enable_progress_bar = true")
            self.connection.execute("SET enable_progress_bar_print = false")
        else:
            self.connection, self._journal = target, None
            check_settings(target)
        if threads is not None:
            self.connection.execute("SET threads = ?", [threads])
        self._mark = f"gam_{secrets.token_hex(4)}"
        self._sources: list[str] = []
        self._results = [beside for path in map(Path, files) for beside in (path, self.unfinished(path))]
        self._made: list[str] = []
        self._registered: list[str] = []

    def __enter__(self) -> "DuckSession":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Drop what was made on the way; close the connection if it is ours."""
        if self.owned:
            self._close()
            return
        with contextlib.suppress(duckdb.Error):
            for made in self._made:
                self._run(exp.Drop(tables=[_temporary(made)], kind="TABLE", exists=True))
            for registered in self._registered:
                self.connection.unregister(registered)

    def _close(self) -> None:
        others = False
        if self._journal is not None:
            with contextlib.suppress(EngineError):  # what was committed is in the log
                self.checkpoint()
            with contextlib.suppress(duckdb.Error):  # it is closed already
                count = "SELECT count > 1 FROM duckdb_connection_count()"
                others = self.connection.execute(count).fetchall()[0][0]
        self.connection.close()
        if self._journal is not None:
            self._journal.close(others)

    def relation(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a relation: a table, files, or a registered Arrow table.

        Raises:
            SourceError: there is no such table or file, or the object cannot be read as a table.
        """
        if not isinstance(relation, (str, Path, tuple, list)):
            return self._register(relation)
        if is_file(relation):
            return self._files(paths_of(relation), form)
        shown = relation if isinstance(relation, str) else ".".join(map(str, relation))  # type: ignore[arg-type]
        known = self._known_tables()
        for node in table_names(relation):  # type: ignore[arg-type]
            if not is_among(node, known):
                continue
            try:
                self.describe(node)
            except duckdb.Error as error:
                raise SourceError(
                    f"The table or view {shown!r} is there, but DuckDB cannot read it: "
                    f"{str(error).partition(chr(10))[0]}"
                ) from error
            return node
        raise SourceError(
            f"There is no table or view {shown!r} in the database"
            + (" in memory" if self.owned and not self.files() else "")
            + nearest(shown, sorted({name for _, _, name in known}))
            + ". A file must end in .parquet, .csv or .tsv."
        )

    @contextlib.contextmanager
    def lent(self, table: pa.Table) -> Iterator[exp.Table]:
        """Register an Arrow table for a while; its memory is free again afterwards."""
        node = self._register(table)
        name = self._registered[-1]
        try:
            yield node
        finally:
            self.connection.unregister(name)
            self._registered.remove(name)

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their types, in order."""
        everything = exp.select("*").from_(relation)
        rows = self._run(exp.Describe(this=everything)).fetchall()
        return {str(row[0]): str(row[1]) for row in rows}

    def relations(self, schema: str | None = None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema (None: the current one) with their columns, in order.

        Names are folded to lower case: DuckDB does not tell them apart by it.

        Raises:
            EngineError: the schema is called like a database, and DuckDB cannot tell which is meant.
        """
        databases = self.connection.execute("SELECT database_name FROM duckdb_databases()").fetchall()
        if schema is not None and schema.casefold() in {name.casefold() for (name,) in databases}:
            raise EngineError(
                f"The schema {schema!r} is called like a database, and DuckDB cannot tell them apart; "
                "give another name."
            )
        rows = self.connection.execute(
            "SELECT table_name, list(column_name ORDER BY ordinal_position) "
            "FROM information_schema.columns WHERE table_catalog = current_database() "
            "AND lower(table_schema) = lower(coalesce(?, current_schema())) GROUP BY table_name",
            [schema],
        )
        return {name.casefold(): tuple(columns) for name, columns in rows.fetchall()}

    def files(self) -> frozenset[Path]:
        """Return the database files that are open here, by their full paths."""
        rows = self.connection.execute("SELECT path FROM duckdb_databases() WHERE NOT internal")
        return frozenset(Path(path).resolve() for (path,) in rows.fetchall() if path is not None)

    def check_condition(self, relation: exp.Expr, condition: exp.Expr, shown: str) -> None:
        """Try a user's condition on no row.

        Raises:
            SourceError: DuckDB refuses it; the message shows it as the user wrote it.
        """
        if self.owned:
            shut(self.connection, self._sources, self._results)
        probe = exp.select(exp.Literal.number(1)).from_(relation.copy()).where(condition).limit(0)
        try:
            self._run(probe)
        except (duckdb.Error, StatementError) as error:
            cause = error.__cause__ if isinstance(error, StatementError) else error
            raise SourceError(
                f"where is {shown!r}, which DuckDB refuses: {str(cause).partition(chr(10))[0]}"
            ) from error

    def execute(self, statement: exp.Expr) -> None:
        """Run a statement that changes the database.

        Raises:
            EngineError: the database cannot be written: it is only read, its disk is full, or another
                connection changed the same rows.
        """
        try:
            self._run(statement)
        except duckdb.IOException as error:
            raise EngineError(FULL) from error
        except StatementError as error:
            # Of a commit that the disk had no room for, DuckDB says that the transaction failed.
            if "Could not write file" in str(error.__cause__):
                raise EngineError(FULL) from error
            if isinstance(error.__cause__, duckdb.TransactionException):
                raise ConflictError(CONFLICT) from error
            if "read-only" in str(error.__cause__):
                raise EngineError(READ_ONLY) from error
            raise

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query; errors as above."""
        self.execute(deletion(table, keys, found))

    @contextlib.contextmanager
    def transaction(self) -> Iterator[None]:
        """Do all that is executed inside as one: either everything is there afterwards, or nothing.

        Raises:
            EngineError: a transaction is open already, or the end of this one was refused.
        """
        if self._in_transaction():
            raise EngineError(OPEN)
        self.execute(exp.Transaction())
        try:
            yield
            self.execute(exp.Commit())
        except BaseException:
            with contextlib.suppress(duckdb.Error, StatementError):
                self._run(exp.Rollback())  # after some errors DuckDB has rolled back already
            raise
        self.checkpoint(LARGE_LOG)

    def checkpoint(self, above: int = 0) -> None:
        """Write the log of the file into it, if it is ours and its log larger than so many bytes.

        Raises:
            EngineError: the disk is full; what was committed stays in the log.
        """
        if self._journal is not None:
            try:
                self._journal.checkpoint(above)
            except (duckdb.TransactionException, OSError):
                pass  # another connection is at work, or there is no room: it stays in the log
            except duckdb.Error as error:
                raise EngineError(FULL) from error

    def _in_transaction(self) -> bool:
        """Tell whether a transaction is open: only then two statements have the same number.

        It is not tried by beginning one: that fails, and takes the user's transaction with it.
        """
        try:
            first, second = (
                self.connection.execute("SELECT txid_current()").fetchall() for _ in range(2)
            )
        except duckdb.TransactionException:  # one that has failed already
            return True
        return first == second

    def load(self, rows: pa.Table) -> exp.Table:
        """Return the node that reads an Arrow table of ours, until the session is closed."""
        return self._register(rows)

    def forget(self, kept: exp.Table) -> None:
        """Drop a table made by :meth:`keep`, or let go of one given to :meth:`load`."""
        if kept.name in self._registered:
            self._registered.remove(kept.name)
            self.connection.unregister(kept.name)
        else:
            self._made.remove(kept.name)
            self._run(exp.Drop(tables=[kept.copy()], kind="TABLE"))

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Run a query and return its rows as an Arrow table."""
        return self._run(query, lambda text: self.connection.sql(text).to_arrow_table())

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Run a query into a temporary table and return the node that reads it."""
        made = self._free_name(step)
        create = exp.Create(
            this=_temporary(made),
            kind="TABLE",
            expression=query,
            properties=exp.Properties(expressions=[exp.TemporaryProperty()]),
        )
        self._run(create)
        self._made.append(made)
        return _temporary(made)

    def write(self, query: exp.Query, path: Path, table: str) -> None:
        """Write the rows of a query as Parquet, or as a table of a DuckDB file.

        The rows go to a file beside the target first, or are written in one transaction: what was
        there before stays as it was until everything is written.

        Raises:
            SourceError: the target cannot be written.
        """
        if path.suffix in (".duckdb", ".db"):
            self._write_table(query, path, table)
            return
        unfinished = self.unfinished(path)
        copy = exp.Copy(
            this=exp.Subquery(this=query),
            kind=False,
            files=[template.text(str(unfinished))],
            params=[
                exp.CopyParameter(this=exp.var("FORMAT"), expression=exp.var("PARQUET")),
                exp.CopyParameter(this=exp.var("COMPRESSION"), expression=exp.var("ZSTD")),
                exp.CopyParameter(this=exp.var("KV_METADATA"), expression=metadata(self._sources)),
            ],
        )
        try:
            self._run(copy)
            unfinished.replace(path)
        except (duckdb.IOException, OSError) as error:
            raise unwritable(path, error) from error
        finally:
            unfinished.unlink(missing_ok=True)

    def unfinished(self, path: Path) -> Path:
        """Return where this session writes what becomes a file when all of it is there."""
        return path.with_name(f".{path.name}.{self._mark}")

    def attached(self, path: Path) -> contextlib.AbstractContextManager[exp.Identifier]:
        """Open another DuckDB file for writing beside this one, and give its catalogue.

        Raises:
            SourceError: it cannot be opened.
        """
        return attached(self._run, self.connection, f"{self._mark}_target", path)

    def _write_table(self, query: exp.Query, path: Path, table: str) -> None:
        with self.attached(path) as catalog:
            if (catalog.name, "main", "gam_migration") in self._known_tables():
                raise SourceError(f"{path} holds the state of a monitor; write results to another file.")
            target = exp.Table(this=template.name(table), db=template.name("main"), catalog=catalog)
            self._run(exp.Create(this=target, kind="TABLE", replace=True, expression=query))

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once within the memory limit."""
        return rows_at_once(self.connection)

    def progress(self) -> float:
        """Return how far the running statement is, in percent; negative if it is not known."""
        return float(self.connection.query_progress())

    def interrupt(self) -> None:
        """Ask the running statement to stop."""
        self.connection.interrupt()

    def _run(self, tree: exp.Expr, how: Callable[[str], Any] | None = None) -> Any:
        statement = self.engine.text(tree)
        try:
            return (how or self.connection.execute)(statement)
        except (duckdb.IOException, duckdb.CatalogException, duckdb.BinderException):
            raise
        except duckdb.PermissionException as error:
            if not self.owned:
                raise _refusal(error, statement) from error
            raise SourceError(
                f"{_first(error).partition(' - ')[0]}: once where was given, a connection of gam-db's "
                "own opens the source and the results, and no other file."
            ) from error
        except duckdb.InterruptException as error:
            raise EngineError("The statement was stopped before its end.") from error
        except duckdb.OutOfMemoryException as error:
            raise EngineError(
                "DuckDB ran out of memory; give it more (SET memory_limit), a folder to spill to "
                "(SET temp_directory), or score fewer channels at a time."
            ) from error
        except duckdb.ConversionException as error:
            said = late_word(self.connection, error, tree)
            if said:
                raise SourceError(said) from error
            raise SourceError(
                "A value of the source cannot be read as what its column must be (a counter needs 64 "
                "bits; where= may ask for it, too); look at the file, or cast the column in a view."
            ) from error
        except duckdb.Error as error:
            first = _first(error)
            if "CSV Error" in first:
                raise SourceError(
                    f"Line {first.rpartition(' ')[2]} of the CSV file does not fit its columns; mend "
                    "it, or read the file into a table with options of your own."
                ) from error
            raise _refusal(error, statement) from error

    def _register(self, relation: Any) -> exp.Table:
        table = arrow_table(relation)
        name = self._free_name("arrow")
        try:
            self.connection.register(name, table)
        except duckdb.Error as error:
            types = ", ".join(sorted({str(field.type) for field in table.schema}))
            raise SourceError(
                f"DuckDB cannot read the Arrow table; it holds columns of the types {types}. Cast the "
                "odd one, or leave it out."
            ) from error
        self._registered.append(name)
        return exp.Table(this=template.name(name))

    def _files(self, paths: Sequence[str], form: Form | None) -> exp.Expr:
        path = paths[0] if len(paths) == 1 else f"{paths[0]} and {len(paths) - 1} more"
        found = [file for one in paths for file in without_results(self.connection, one)]
        node = file_reader(found, form)
        self._sources += found
        try:
            columns = self.describe(node)
            if is_csv_reader(node) and set(columns.values()) == {"VARCHAR"}:
                first = exp.select(exp.Literal.number(1)).from_(node.copy()).limit(1)
                if not self._run(first).fetchall():
                    raise SourceError(f"{path} has no rows; it is empty, or there is a header only.")
        except (duckdb.Error, StatementError) as error:
            if isinstance(error, duckdb.IOException):
                raise SourceError(
                    f"{path} cannot be read; is it there, and is it a file of that kind?"
                ) from error
            raise SourceError(no_table(path, str(error.__cause__ or error))) from error
        return node

    def _free_name(self, word: str) -> str:
        """Return a name of ours: one that is free again, if any, so that texts come again, too."""
        names = (f"{self._mark}_{word}_{number}" for number in itertools.count())
        return next(name for name in names if name not in self._made and name not in self._registered)

    def _known_tables(self) -> list[tuple[str, str, str]]:
        # Looked up, not tried: a statement that fails would undo the user's open transaction, and
        # DuckDB would take the name for one of our Python variables.
        return self.connection.execute(
            "SELECT table_catalog, table_schema, table_name FROM information_schema.tables"
        ).fetchall()


def _refusal(error: duckdb.Error, statement: str) -> StatementError:
    return StatementError(f"DuckDB refused a statement: {_first(error)}", statement)


def _first(error: BaseException) -> str:
    return str(error).partition("\n")[0]


def _temporary(name: str) -> exp.Table:
    return exp.Table(this=template.name(name))
