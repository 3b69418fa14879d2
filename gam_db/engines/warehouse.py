"""A session on any engine but DuckDB: trees become text, and a small driver runs it.

This module owns what all of them do alike; a driver owns what its client library wants.
"""

import contextlib
import functools
import itertools
import secrets
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Protocol, TypeVar

import duckdb
import pyarrow as pa
import pyarrow.parquet as pq
from sqlglot import exp

from gam_db import template
from gam_db.engines.base import Engine
from gam_db.engines.duckdb_session import DuckSession
from gam_db.engines.session import OPEN, arrow_table, unwritable
from gam_db.errors import (
    EngineError,
    LostConnectionError,
    SourceError,
    StatementError,
    UserError,
    nearest,
)
from gam_db.form import Form
from gam_db.source import is_file, table_names

T = TypeVar("T")


class Driver(Protocol):
    """A connection to an engine, as its client library has it.

    Attributes:
        engine: how trees become its text.
        transactions: whether begin, commit and rollback mean something.
        errors: what the client library raises when the engine refuses something.
    """

    engine: Engine
    transactions: bool
    errors: tuple[type[Exception], ...]

    def execute(self, statement: str) -> None:
        """Run one statement."""

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query; columns keep their names, integers are int64, doubles float64."""

    def begin(self) -> None:
        """Begin a transaction."""

    def commit(self) -> None:
        """End it."""

    def rollback(self) -> None:
        """Undo it."""

    def in_transaction(self) -> bool:
        """Tell whether a transaction is open that is not ours."""

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        """Make a temporary table of the rows of a query, and let the planner know its size."""

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        """Make a temporary table of the rows of an Arrow table."""

    def drop(self, table: exp.Table) -> None:
        """Drop a table made by :meth:`keep` or :meth:`ingest`."""

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query, as one step."""

    def tables(self) -> list[tuple[str, ...]]:
        """Return what can be read, tables and views: (catalogue, schema, name) as far as there are."""

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node of a table by all the names that it takes to read no other one.

        Raises:
            SourceError: it is not where it is looked for.
        """

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and the engine's names of their types."""

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, names of tables in lower case."""

    def file(self, path: str) -> exp.Expr:
        """Return the node that reads a file.

        Raises:
            SourceError: the engine reads none.
        """

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once."""

    def problem(self, error: Exception) -> UserError | None:
        """Return what the user can do about an error; None if it is none of the user's."""

    def close(self) -> None:
        """Close the connection if it is ours."""


class WarehouseSession:
    """A session on a driver; see :class:`gam_db.engines.session.Session`.

    Args:
        driver: an open connection.
    """

    def __init__(self, driver: Driver) -> None:
        self.driver = driver
        self.engine = driver.engine
        self.transactions = driver.transactions
        self._mark = f"gam_{secrets.token_hex(4)}"
        self._made: dict[str, exp.Table] = {}

    def __enter__(self) -> "WarehouseSession":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Drop what was made on the way; close the connection if it is ours."""
        with contextlib.suppress(*self.driver.errors):
            for made in list(self._made.values()):
                self.driver.drop(made)
        self._made.clear()
        self.driver.close()

    def relation(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a relation.

        That is a table, a file where the engine reads files, or an Arrow table, which is copied into a
        temporary one. Columns are read as they are, but for times by their unit.

        Raises:
            SourceError: there is no such relation, or the engine cannot read it.
        """
        if form is not None and (
            form.reads_words or form.delimiter or form.skip_rows or form.time_format
        ):
            raise SourceError(
                "How numbers and times are written is said of files that DuckDB reads; "
                f"{self.engine.title} reads columns as they are: cast them in a view."
            )
        if not isinstance(relation, (str, Path, tuple, list)):
            return self.load(arrow_table(relation))
        if is_file(relation):
            return self._asked(lambda: self.driver.file(str(relation)))
        shown = relation if isinstance(relation, str) else ".".join(map(str, relation))  # type: ignore[arg-type]
        known = self._asked(self.driver.tables)
        for node in table_names(relation):  # type: ignore[arg-type]
            parts = tuple(part.name for part in node.parts)  # type: ignore[attr-defined]
            if any(parts == name[-len(parts) :] for name in known):
                return self._asked(functools.partial(self.driver.located, node))
        hint = nearest(shown, sorted({name[-1] for name in known})) or "."
        raise SourceError(
            f"There is no table or view {shown!r} that can be read in this {self.engine.title} database"
            f"{hint}"
        )

    @contextlib.contextmanager
    def lent(self, table: pa.Table) -> Iterator[exp.Table]:
        """Let an Arrow table be read for a while."""
        node = self.load(table)
        try:
            yield node
        finally:
            self.forget(node)

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their types, in order."""
        return self._asked(lambda: self.driver.describe(relation))

    def relations(self, schema: str | None = None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema (None: the current one) with their columns."""
        return self._asked(lambda: self.driver.relations(schema))

    def check_condition(self, relation: exp.Expr, condition: exp.Expr, shown: str) -> None:
        """Try a user's condition on no row.

        Raises:
            SourceError: the engine refuses it; the message shows it as the user wrote it.
        """
        probe = exp.select(exp.Literal.number(1).as_("tried")).from_(relation.copy()).where(condition)
        try:
            self.fetch(probe.limit(0))
        except StatementError as error:
            raise SourceError(
                f"where is {shown!r}, which {self.engine.title} refuses: {_first_line(error.__cause__)}"
                + self.engine.condition_note
            ) from error

    def execute(self, statement: exp.Expr) -> None:
        """Run a statement that changes the database.

        Raises:
            EngineError: the database cannot be written.
        """
        text = self.engine.text(statement)
        self._asked(lambda: self.driver.execute(text), text)

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query.

        Raises:
            EngineError: the database cannot be written.
        """
        self._asked(lambda: self.driver.delete(table, keys, found))

    def _commit(self) -> None:
        try:
            self._asked(self.driver.commit)
        except LostConnectionError as error:
            raise LostConnectionError(
                f"The connection to {self.engine.title} was lost while the work was being committed: "
                "whether it counts is not known. Run it again: what counts already is not done twice."
            ) from error

    @contextlib.contextmanager
    def transaction(self) -> Iterator[None]:
        """Do all that is executed inside as one, where the engine can; else one after another.

        Raises:
            EngineError: a transaction is open already, or the end of this one was refused.
        """
        if not self.transactions:
            yield
            return
        if self._asked(self.driver.in_transaction):
            raise EngineError(OPEN)
        self._asked(self.driver.begin)
        try:
            yield
            self._commit()
        except BaseException:
            with contextlib.suppress(*self.driver.errors):
                self.driver.rollback()
            raise

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Run a query and return its rows as an Arrow table."""
        text = self.engine.text(query)
        return self._asked(lambda: self.driver.fetch(text), text)

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Run a query into a temporary table and return the node that reads it."""
        table = self._new(step)
        self._asked(lambda: self.driver.keep(table, query), step)
        self._made[table.name] = table
        return table.copy()

    def load(self, rows: pa.Table) -> exp.Table:
        """Return the node that reads an Arrow table of ours, until it is forgotten."""
        table = self._new("arrow")
        self._made[table.name] = table  # also where it is filled in part only: its name is not free then
        self._asked(lambda: self.driver.ingest(table, rows), "arrow")
        return table.copy()

    def forget(self, kept: exp.Table) -> None:
        """Drop a table made by :meth:`keep` or :meth:`load`."""
        table = self._made.pop(kept.name)
        self._asked(lambda: self.driver.drop(table))

    def write(self, query: exp.Query, path: Path, table: str) -> None:
        """Write the rows of a query as Parquet, or as a table of a DuckDB file.

        Raises:
            SourceError: the target cannot be written.
        """
        rows = self.fetch(query)
        try:
            if path.suffix in (".duckdb", ".db"):
                _write_table(rows, path, table)
            else:
                _write_parquet(rows, path)
        except (OSError, duckdb.Error) as error:
            raise unwritable(path, error) from error

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once within the memory of the engine."""
        return self.driver.rows_at_once()

    def progress(self) -> float:
        """Return how far the running statement is: not known."""
        return -1.0

    def _new(self, step: str) -> exp.Table:
        # A name that is free again comes again, and with it the texts that hold it.
        names = (f"{self._mark}_{step}_{number}" for number in itertools.count())
        name = next(name for name in names if name not in self._made)
        schema = self.engine.temporary
        return exp.Table(this=template.name(name), db=schema and template.name(schema))

    def _asked(self, question: Callable[[], T], statement: str = "") -> T:
        try:
            return question()
        except self.driver.errors as error:
            problem = self.driver.problem(error)
            if problem is not None:
                raise problem from error
            raise StatementError(
                f"{self.engine.title} refused a statement: {_first_line(error)}", statement
            ) from error


def _write_parquet(rows: pa.Table, path: Path) -> None:
    """Write beside the target and rename: what was there stays until all is written."""
    unfinished = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    try:
        pq.write_table(rows, unfinished, compression="zstd")
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)


def _write_table(rows: pa.Table, path: Path, table: str) -> None:
    target = exp.Table(this=template.name(table), db=template.name("main"))
    with DuckSession(path, writable=True) as session, session.lent(rows) as lent:
        query = exp.select("*").from_(lent)
        session.execute(exp.Create(this=target, kind="TABLE", replace=True, expression=query))


def _first_line(error: BaseException | None) -> str:
    return str(error).strip().partition("\n")[0]
