"""Sessions: the interface of engines to the rest of gam-db. Trees go in, Arrow tables come out.

A session uses one connection, through a small driver (:mod:`gam_db.engines.driver`). That of DuckDB does
more (:mod:`gam_db.engines.duckdb.session`): it reads files and Arrow tables where they lie.
"""

import contextlib
import functools
import itertools
import threading
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Self, TypeVar

import pyarrow as pa
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import REFUSES
from gam_db.engines.driver import Driver
from gam_db.engines.frames import arrow_table
from gam_db.engines.functions import macro
from gam_db.engines.refusals import CONFLICT as CONFLICT
from gam_db.engines.refusals import OPEN, first_line
from gam_db.errors import EngineError, LostConnectionError, SourceError, StatementError, nearest, wrong
from gam_db.settings.form import Form
from gam_db.settings.source import is_file, is_spreadsheet, table_names

T = TypeVar("T")
Row = dict[str, Any]


#: Numbers of the sessions that have tables, or had some that they could not drop. Temporary tables are
#: seen by one connection only, so the sessions of this process are to be told apart and no others; and a
#: number that comes again brings the same names, and with them texts that need not be written again.
_NUMBERS: set[int] = set()
_TAKING = threading.Lock()


class Session:
    """A session of an engine: describes relations, keeps steps as tables, runs trees.

    Args:
        driver: the connection.
        writer: opens the session that writes results as files; None for one that does so itself.
    """

    def __init__(self, driver: Driver, writer: "Callable[[], Session] | None" = None) -> None:
        self.driver, self._writer = driver, writer
        self.engine = driver.engine
        self.transactions = driver.engine.transactions
        self._number: int | None = None
        self._tables: dict[str, exp.Table] = {}
        self._defined: dict[str, exp.Expr] = {}  # by name: how it is dropped
        #: Each finds values that are not whole, and raises the error on them.
        self.suspects: list[Callable[[], None]] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Drop temporary tables; close the connection if the session opened it."""
        with contextlib.suppress(*self.driver.errors):
            for table in list(self._tables.values()):
                self.driver.drop(table)
            for dropped in self._defined.values():
                self.driver.execute(self.engine.text(dropped))
            self._give_back()
        self._number = None
        self._tables.clear()
        self._defined.clear()
        self.driver.close()

    def relation(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a table, a file where the engine reads files, or an Arrow table.

        A form says how text files are written; an engine that reads no texts takes columns as they are.

        Raises:
            SourceError: there is no such relation, or the engine cannot read it.
        """
        unheeded = form is not None and self.engine.texts is None and form
        if unheeded and set(unheeded.of_words) - {"time_unit", *self.engine.heeds}:
            raise wrong("engine_reads_no_texts", title=self.engine.title)
        if not isinstance(relation, (str, Path, tuple, list)):
            return self.load(arrow_table(relation))
        if isinstance(relation, (tuple, list)):
            others = (type(part).__name__ for part in relation if not isinstance(part, (str, Path)))
            if other := next(others, None):
                raise wrong("list_of_values", kind=other)
        if isinstance(relation, Path) and is_spreadsheet(relation):
            raise wrong("spreadsheet", relation=relation)
        if is_file(relation):
            return self._answer(lambda: self.driver.file(relation, form))
        shown = relation if isinstance(relation, str) else ".".join(map(str, relation))  # type: ignore[arg-type]
        tables = self._answer(self.driver.tables)
        for node in table_names(relation):  # type: ignore[arg-type]
            if self._is_among(node, tables):
                return self._answer(functools.partial(self.driver.located, node))
        if is_spreadsheet(relation):
            raise wrong("spreadsheet", relation=relation)
        raise SourceError(
            self._unknown(shown, nearest(shown, _of_others({name[-1] for name in tables})))
        )

    @contextlib.contextmanager
    def lent(self, table: pa.Table) -> Iterator[exp.Table]:
        """Make an Arrow table readable inside the block."""
        node = self.load(table)
        try:
            yield node
        finally:
            self.forget(node)

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their types, in order."""
        return self._answer(lambda: self.driver.describe(relation))

    def relations(self, schema: str | None = None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema (None: the current one) with their columns, in order.

        Names of tables and views are folded to lower case.
        """
        return self._answer(lambda: self.driver.relations(schema))

    def check_condition(
        self, relation: exp.Expr, condition: exp.Expr, shown: str, called: str = "where"
    ) -> None:
        """Try a user's condition on no row, in a read-only mode; ``called`` names it in messages.

        Raises:
            SourceError: the engine refuses it; the message shows it as the user wrote it.
        """
        self.driver.expect_conditions()
        probe = exp.select(exp.Literal.number(1).as_("tried")).from_(relation.copy()).where(condition)
        try:
            with self.driver.only_reading():
                self.fetch(probe.limit(0))
        except (StatementError, EngineError) as error:
            reason = first_line(error.__cause__) + self.engine.condition_note
            if isinstance(error, EngineError) and "read-only" not in reason:  # it is not the condition
                raise
            raise wrong(
                "where_refused", called=called, shown=shown, title=self.engine.title, said=reason
            ) from error

    def execute(self, statement: exp.Expr) -> None:
        """Run a statement that changes the database.

        Raises:
            EngineError: the database cannot be written.
        """
        text = self.engine.text(statement)
        self._answer(lambda: self.driver.execute(text), text)

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query.

        Raises:
            EngineError: the database cannot be written.
        """
        self._answer(lambda: self.driver.delete(table, keys, key_rows))

    @contextlib.contextmanager
    def transaction(self) -> Iterator[None]:
        """Execute the statements inside as one transaction, if the engine can; else one after another.

        Raises:
            EngineError: a transaction is open already, or the end of this one was refused.
        """
        if not self.transactions:
            yield
            return
        if self._answer(self.driver.in_transaction):
            raise EngineError(OPEN)
        self._answer(self.driver.begin)
        try:
            yield
            try:
                self._answer(self.driver.commit)
            except LostConnectionError as error:
                raise wrong("commit_unknown", title=self.engine.title) from error
        except BaseException:
            with contextlib.suppress(*self.driver.errors):
                self.driver.rollback()
            raise

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Run a query and return its rows as an Arrow table."""
        text = self.engine.text(query)
        return self._answer(lambda: self.driver.fetch(text), text)

    def rows(self, query: exp.Expr) -> list[Row]:
        """Run a query and return its rows, each by the names of its columns."""
        text = self.engine.text(query)
        return self._answer(lambda: self.driver.rows(text), text)

    def now(self) -> int:
        """Return this instant by the clock of the database, in microseconds since 1970 (UTC)."""
        (row,) = self.rows(exp.select(exp.alias_(self.engine.clock(), "now")))
        return int(row["now"])

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Run a query into a temporary table and return the node that reads it."""
        table = self._new(step)
        self._answer(lambda: self.driver.keep(table, query), step)
        self._tables[table.name] = table
        return table.copy()

    def load(self, rows: pa.Table) -> exp.Table:
        """Return the node that reads an Arrow table of gam-db, until it is forgotten."""
        table = self._new("arrow")
        self._tables[table.name] = table  # also where it is filled in part only: its name is taken then
        self._answer(lambda: self.driver.ingest(table, rows), "arrow")
        return table.copy()

    def forget(self, table: exp.Table) -> None:
        """Drop a table made by :meth:`keep`, or release one loaded by :meth:`load`.

        In a failed transaction this is impossible, and closing does it: the first error is reported.
        """
        with contextlib.suppress(*self.driver.errors):
            self.driver.drop(table)
            del self._tables[table.name]
            if not self._tables and not self._defined:  # many a session is never closed
                self._give_back()

    def define(self, step: str, query: exp.Query, parameters: Sequence[str]) -> str:
        """Define a query as a function of rows, and return its name; for engines with macros (DuckDB).

        It stands for the query that was defined of that step before.

        Args:
            step: what it is.
            query: its tree, where each parameter is a column without a table.
            parameters: their names, in the order in which they are said in a call.
        """
        name = self._numbered(step)
        called = exp.Table(this=exp.to_identifier(name))
        self.execute(macro(called, parameters, query, exp.TemporaryProperty()))
        self._defined[name] = exp.Drop(tables=[called.copy()], kind="MACRO TABLE", exists=True)
        return name

    def write(self, query: exp.Query, path: Path, table: str) -> None:
        """Write the rows of a query as Parquet, or as a table of a DuckDB file.

        Raises:
            SourceError: the target cannot be written.
        """
        assert self._writer is not None
        with self._writer() as writer, writer.lent(self.fetch(query)) as rows:
            writer.write(exp.select("*").from_(rows), path, table)

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once within the memory of the engine."""
        return self.driver.rows_at_once()

    def threads(self) -> int:
        """Return how many parts of a statement the engine works on at once, 1 if it is not known."""
        return self.driver.threads()

    def progress(self) -> float:
        """Return how far the running statement is, in percent; negative if it is not known."""
        return -1.0

    def _is_among(self, node: exp.Expr, tables: Sequence[tuple[str, ...]]) -> bool:
        """Tell whether the last parts of some known name are those of a node."""
        parts = tuple(part.name for part in node.parts)  # type: ignore[attr-defined]
        return any(parts == name[-len(parts) :] for name in tables)

    def _unknown(self, shown: str, hint: str) -> str:
        where = f"in this {self.engine.title} database"
        return f"There is no table or view {shown!r} that can be read {where}{hint}"

    def _numbered(self, step: str) -> str:
        """Return a name that no other session of this process has."""
        if self._number is None:
            with _TAKING:
                self._number = next(number for number in itertools.count() if number not in _NUMBERS)
                _NUMBERS.add(self._number)
        return f"gam_{self._number}_{step}"

    def _give_back(self) -> None:
        """Let other sessions have the number."""
        if self._number is not None:
            _NUMBERS.discard(self._number)
            self._number = None

    def _new(self, step: str) -> exp.Table:
        # A name that is free again comes again, and with it the texts that hold it.
        prefix = self._numbered(step)
        names = (f"{prefix}_{number}" for number in itertools.count())
        name = next(name for name in names if name not in self._tables)
        schema = self.engine.temporary
        return exp.Table(this=template.name(name), db=schema and template.name(schema))

    def _answer(self, question: Callable[[], T], statement: str = "") -> T:
        try:
            return question()
        except self.driver.errors as error:
            if REFUSES in str(error):
                for look in self.suspects:
                    look()
            if (problem := self.driver.problem(error)) is not None:
                raise problem from error
            raise StatementError(
                f"{self.engine.title} refused a statement: {first_line(error)}", statement
            ) from error


def _of_others(names: set[str]) -> list[str]:
    """Return names without those of state tables, which are no sources."""
    record = "state_migration"
    of_runs = [name.removesuffix(record) for name in names if name.endswith(record)]
    ours = tuple(prefix for prefix in of_runs if prefix and f"{prefix}state_finished_run" in names)
    return sorted(name for name in names if not name.startswith(ours))
