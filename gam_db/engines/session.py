"""What the rest of gam-db asks of an engine at work.

A session lies on one connection. DuckDB has a session of its own; other engines share one
(:mod:`gam_db.engines.warehouse`) on a small driver each. Trees go in, Arrow tables come out.
"""

import contextlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

import pyarrow as pa
from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.errors import SourceError
from gam_db.form import Form

#: What is said of a connection that refuses to write.
READ_ONLY = "The database is open for reading only; it cannot be changed."
OPEN = "The connection has a transaction open; commit it or roll it back first."
FULL = "The database cannot be written; is its disk full? What was there before is as it was."
CONFLICT = (
    "Another connection changed the same tables at the same time; what was to be written here was not. "
    "Run it again."
)


def unwritable(path: Path, error: BaseException) -> SourceError:
    """Return why a target of results cannot be written, in the user's words."""
    said = str(error)
    if "No space left" in said:
        return SourceError(f"{path} cannot be written: its disk is full.")
    if "Disk quota" in said or "File too large" in said:
        return SourceError(
            f"{path} cannot be written: you may not write so much there (a quota or ulimit)."
        )
    if "Permission denied" in said or "Read-only" in said:
        return SourceError(f"{path} cannot be written: you may only read there.")
    return SourceError(f"{path} cannot be written; is its folder there, and may you write there?")


@runtime_checkable
class Session(Protocol):
    """An engine at work: describes relations, keeps steps as tables, runs trees.

    Attributes:
        engine: how trees become its text.
        transactions: whether :meth:`transaction` can undo what was executed inside.
    """

    engine: Engine
    transactions: bool

    def __enter__(self) -> "Session": ...

    def __exit__(self, *_: object) -> None: ...

    def close(self) -> None:
        """Drop what was made on the way; close the connection if it is ours."""

    def relation(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a relation: a table, files, or an Arrow table.

        Args:
            relation: see :class:`gam_db.Source`.
            form: how text files are written.

        Raises:
            SourceError: there is no such relation, or the engine cannot read it.
        """

    def lent(self, table: pa.Table) -> contextlib.AbstractContextManager[exp.Table]:
        """Let an Arrow table be read for a while."""

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their types, in order."""

    def relations(self, schema: str | None = None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema (None: the current one) with their columns, in order.

        Names of tables and views are folded to lower case.
        """

    def check_condition(self, relation: exp.Expr, condition: exp.Expr, shown: str) -> None:
        """Try a user's condition on no row.

        Raises:
            SourceError: the engine refuses it; the message shows it as the user wrote it.
        """

    def execute(self, statement: exp.Expr) -> None:
        """Run a statement that changes the database.

        Raises:
            EngineError: the database cannot be written.
        """

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query.

        Raises:
            EngineError: the database cannot be written.
        """

    def transaction(self) -> contextlib.AbstractContextManager[None]:
        """Do all that is executed inside as one, where the engine can; else one after another.

        Raises:
            EngineError: a transaction is open already, or the end of this one was refused.
        """

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Run a query and return its rows as an Arrow table."""

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Run a query into a temporary table and return the node that reads it."""

    def load(self, rows: pa.Table) -> exp.Table:
        """Return the node that reads an Arrow table of ours, until it is forgotten."""

    def forget(self, kept: exp.Table) -> None:
        """Drop a table made by :meth:`keep`, or let go of one given to :meth:`load`."""

    def write(self, query: exp.Query, path: Path, table: str) -> None:
        """Write the rows of a query as Parquet, or as a table of a DuckDB file.

        Raises:
            SourceError: the target cannot be written.
        """

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once within the memory of the engine."""

    def progress(self) -> float:
        """Return how far the running statement is, in percent; negative if it is not known."""


def arrow_table(relation: Any) -> pa.Table:
    """Return an object that holds a table as an Arrow table.

    That is one with ``__arrow_c_stream__`` (Arrow, pandas, polars, DuckDB), a frame that has yet to be
    collected (polars), or a table that runs elsewhere (Ibis).

    Raises:
        SourceError: it is none of these, or its columns cannot be told apart.
    """
    if type(relation).__module__.partition(".")[0] == "polars" and hasattr(relation, "collect"):
        relation = relation.collect()
    elif not hasattr(relation, "__arrow_c_stream__") and hasattr(relation, "to_pyarrow"):
        relation = relation.to_pyarrow()
    if not isinstance(relation, (pa.Table, pa.RecordBatch)) and not hasattr(
        relation, "__arrow_c_stream__"
    ):
        raise SourceError(
            f"relation is a {type(relation).__name__}; it takes the name of a table, the path of a "
            "Parquet or CSV file, an Arrow table or a data frame."
        )
    table = relation if isinstance(relation, pa.Table) else pa.table(relation)
    check_columns(table)
    return table


def check_columns(table: pa.Table) -> None:
    """Refuse an Arrow table whose columns DuckDB cannot tell apart.

    Raises:
        SourceError: it has no columns, or names that differ by case only.
    """
    if not table.column_names:
        raise SourceError("The Arrow table has no columns.")
    seen: dict[str, str] = {}
    for name in table.column_names:
        twin = seen.get(name.casefold())
        if twin is not None:
            raise SourceError(
                f"The Arrow table has the columns {twin!r} and {name!r}, which DuckDB cannot tell "
                "apart; rename one of them."
            )
        seen[name.casefold()] = name
