"""DuckDB: the embedded default. Its description as an engine, and a session on a connection."""

import contextlib
import secrets
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.clock import TimeKind
from gam_db.engines.base import Engine, called, counter
from gam_db.errors import EngineError, SourceError, StatementError
from gam_db.source import is_file, table_names

OLDEST = (1, 4)


def micros_of(kind: TimeKind, column: exp.Expr) -> exp.Expr:
    """Return epoch microseconds, NULL for infinite times.

    DuckDB rounds nanoseconds to microseconds; the method floors them.
    """
    if kind.is_counter:
        return counter(column)
    if kind is TimeKind.NANOSECONDS:
        nanos = called("EPOCH_NS", column)
        thousand = exp.Literal.number(1000)
        rest = exp.paren(exp.Mod(this=nanos, expression=thousand))
        positive = exp.paren(
            exp.Mod(this=exp.paren(exp.Add(this=rest, expression=thousand)), expression=thousand)
        )
        whole = exp.paren(exp.Sub(this=nanos.copy(), expression=positive))
        micros: exp.Expr = exp.IntDiv(this=whole, expression=thousand.copy())
    else:
        micros = called("EPOCH_US", column)
    return exp.Case(ifs=[exp.If(this=called("ISFINITE", column.copy()), true=micros)])


def instant_of(kind: TimeKind, micros: exp.Expr) -> exp.Expr:
    """Return the timestamp of epoch microseconds, with a zone where the source has one."""
    if kind.is_counter:
        return micros
    if kind is TimeKind.TIMESTAMP_WITH_ZONE:
        return called("MAKE_TIMESTAMPTZ", micros)
    return called("MAKE_TIMESTAMP", micros)


ENGINE = Engine(
    name="duckdb",
    dialect="duckdb",
    evidence="executed",
    micros_of=micros_of,
    instant_of=instant_of,
    reads_files=True,
    macros=True,
)


def file_reader(path: str) -> exp.Expr:
    """Return the node that reads a Parquet or CSV file by its path."""
    text_file = any(ending in path.lower() for ending in (".csv", ".tsv"))
    return exp.Table(this=called("READ_CSV" if text_file else "READ_PARQUET", template.text(path)))


_KINDS = {
    "TIMESTAMP": TimeKind.TIMESTAMP,
    "TIMESTAMP_S": TimeKind.TIMESTAMP,
    "TIMESTAMP_MS": TimeKind.TIMESTAMP,
    "DATE": TimeKind.TIMESTAMP,
    "TIMESTAMP_NS": TimeKind.NANOSECONDS,
    "TIMESTAMP WITH TIME ZONE": TimeKind.TIMESTAMP_WITH_ZONE,
}
_INTEGERS = {f"{sign}{size}INT" for sign in ("", "U") for size in ("TINY", "SMALL", "BIG", "HUGE")}
_INTEGERS |= {"INTEGER", "UINTEGER"}


class Session:
    """DuckDB at work: describes relations, keeps temporary tables, runs trees.

    Args:
        target: None for a database in memory, the path of a database file, or an open connection,
            which stays open and keeps nothing of ours.
        threads: processor threads; None leaves DuckDB's own choice.

    Raises:
        EngineError: the file cannot be opened, or this DuckDB is too old.
    """

    engine = ENGINE

    def __init__(self, target: Any = None, threads: int | None = None) -> None:
        if tuple(int(part) for part in duckdb.__version__.split(".")[:2]) < OLDEST:
            raise EngineError(
                f"DuckDB {duckdb.__version__} is too old; gam-db needs "
                f"{'.'.join(map(str, OLDEST))} or later."
            )
        self.owned = not isinstance(target, duckdb.DuckDBPyConnection)
        if self.owned:
            self.connection = _opened(target)
            self.connection.execute("SET TimeZone = 'UTC'")
        else:
            self.connection = target
        if threads is not None:
            self.connection.execute("SET threads = ?", [threads])
        self._mark = f"gam_{secrets.token_hex(4)}"
        self._made: list[str] = []
        self._registered: list[str] = []

    def __enter__(self) -> "Session":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Drop what was made on the way; close the connection if it is ours."""
        if self.owned:
            self.connection.close()
            return
        with contextlib.suppress(duckdb.Error):
            for made in self._made:
                self._run(exp.Drop(tables=[_temporary(made)], kind="TABLE", exists=True))
            for registered in self._registered:
                self.connection.unregister(registered)

    def relation(self, relation: Any) -> exp.Expr:
        """Return the node that reads a relation: a table, a file, or a registered Arrow table.

        Raises:
            SourceError: there is no such table or file, or the object cannot be read as a table.
        """
        if not isinstance(relation, (str, Path, tuple, list)):
            return self._register(relation)
        if is_file(relation):
            return self._file(str(relation))
        names = table_names(relation)  # type: ignore[arg-type]
        for node in names:
            with contextlib.suppress(duckdb.CatalogException, duckdb.BinderException):
                self.describe(node)
                return node
        shown = relation if isinstance(relation, str) else ".".join(map(str, relation))  # type: ignore[arg-type]
        raise SourceError(
            f"There is no table or view {shown!r} in the database"
            + (" in memory" if self.owned and self._in_memory() else "")
            + self._nearest_table(shown)
            + ". A file must end in .parquet, .csv or .tsv."
        )

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return the columns of a relation and their types, in order."""
        everything = exp.select("*").from_(relation)
        rows = self._run(exp.Describe(this=everything)).fetchall()
        return {str(row[0]): str(row[1]) for row in rows}

    @staticmethod
    def time_kind(type_name: str) -> TimeKind | None:
        """Return how a column of this type tells time; None if it does not."""
        return TimeKind.COUNTER if type_name in _INTEGERS else _KINDS.get(type_name)

    @staticmethod
    def is_numeric(type_name: str) -> bool:
        """Tell whether a column of this type holds numbers (BOOLEAN does not)."""
        plain = type_name.partition("(")[0]
        return plain in _INTEGERS or plain in ("DOUBLE", "FLOAT", "DECIMAL")

    @staticmethod
    def is_name(type_name: str) -> bool:
        """Tell whether a column of this type can name an asset or a channel."""
        plain = type_name.partition("(")[0]
        return plain in _INTEGERS or plain in ("VARCHAR", "ENUM", "UUID")

    def fetch(self, query: exp.Expr) -> pa.Table:
        """Run a query and return its rows as an Arrow table."""
        return self._run(query, lambda text: self.connection.sql(text).to_arrow_table())

    def keep(self, step: str, query: exp.Query) -> exp.Table:
        """Run a query into a temporary table and return the node that reads it."""
        made = f"{self._mark}_{step}"
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
        unfinished = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
        copy = exp.Copy(
            this=exp.Subquery(this=query),
            kind=False,
            files=[template.text(str(unfinished))],
            params=[
                exp.CopyParameter(this=exp.var("FORMAT"), expression=exp.var("PARQUET")),
                exp.CopyParameter(this=exp.var("COMPRESSION"), expression=exp.var("ZSTD")),
            ],
        )
        try:
            self._run(copy)
            unfinished.replace(path)
        except (duckdb.IOException, OSError) as error:
            raise SourceError(f"{path} cannot be written; is its folder there?") from error
        finally:
            unfinished.unlink(missing_ok=True)

    def _write_table(self, query: exp.Query, path: Path, table: str) -> None:
        name = f"{self._mark}_target"
        attach = exp.Attach(this=exp.alias_(template.text(str(path)), template.name(name), table=False))
        try:
            self._run(attach)
        except (duckdb.IOException, duckdb.BinderException) as error:
            raise SourceError(f"{path} cannot be opened as a DuckDB file for writing.") from error
        try:
            target = exp.Table(this=template.name(table), db=template.name("main"))
            target.set("catalog", template.name(name))
            self._run(exp.Create(this=target, kind="TABLE", replace=True, expression=query))
        finally:
            self._run(exp.Detach(this=template.name(name)))

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
        except duckdb.OutOfMemoryException as error:
            raise EngineError(
                "DuckDB ran out of memory; give it more (SET memory_limit), a folder to spill to "
                "(SET temp_directory), or score fewer channels at a time."
            ) from error
        except duckdb.ConversionException as error:
            raise SourceError(
                "A value of the source cannot be read as its column's type; look at the file, or "
                "cast the column in a view."
            ) from error
        except duckdb.Error as error:
            first = str(error).partition("\n")[0]
            raise StatementError(f"DuckDB refused a statement: {first}", statement) from error

    def _register(self, relation: Any) -> exp.Expr:
        if not isinstance(relation, (pa.Table, pa.RecordBatch)) and not hasattr(
            relation, "__arrow_c_stream__"
        ):
            raise SourceError(
                f"relation is a {type(relation).__name__}; it takes the name of a table, the path of "
                "a Parquet or CSV file, or an Arrow table."
            )
        table = relation if isinstance(relation, pa.Table) else pa.table(relation)
        name = f"{self._mark}_arrow{len(self._registered)}"
        self.connection.register(name, table)
        self._registered.append(name)
        return exp.Table(this=template.name(name))

    def _file(self, path: str) -> exp.Expr:
        node = file_reader(path)
        try:
            self.describe(node)
        except duckdb.IOException as error:
            raise SourceError(
                f"{path} cannot be read; is it there, and is it a file of that kind?"
            ) from error
        except duckdb.Error as error:
            raise SourceError(f"{path} is no table that DuckDB can make out.") from error
        return node

    def _in_memory(self) -> bool:
        row = self.connection.execute("SELECT path FROM duckdb_databases() WHERE NOT internal")
        return all(path is None for (path,) in row.fetchall())

    def _nearest_table(self, shown: str) -> str:
        from gam_db.errors import nearest

        tables = self.connection.execute(
            "SELECT table_name FROM information_schema.tables ORDER BY table_name"
        ).fetchall()
        return nearest(shown, [name for (name,) in tables])


def _temporary(name: str) -> exp.Table:
    return exp.Table(this=template.name(name))


def _opened(target: Any) -> duckdb.DuckDBPyConnection:
    if target is None:
        return duckdb.connect()
    path = Path(str(target).removeprefix("duckdb:///"))
    if not path.exists():
        raise EngineError(f"There is no database file {path}.")
    try:
        return duckdb.connect(str(path), read_only=True)
    except duckdb.Error as error:
        raise EngineError(
            f"{path} cannot be opened as a DuckDB file; is it one, and does another process hold it?"
        ) from error


@contextlib.contextmanager
def session(target: Any = None) -> Iterator[Session]:
    """Open a session and close it at the end."""
    with Session(target) as opened:
        yield opened
