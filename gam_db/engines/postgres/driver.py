"""PostgreSQL at work: a driver on a psycopg connection.

Rows come in by COPY and go out in PostgreSQL's binary form. ADBC would be faster at both, but it has a
connection of its own, which sees neither our temporary tables nor our transaction.
"""

import contextlib
import dataclasses
import io
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from urllib.parse import urlsplit

import pyarrow as pa
import pyarrow.csv
from sqlglot import exp

from gam_db import data
from gam_db.composing import template
from gam_db.engines.base import temporary, with_columns
from gam_db.engines.driver import DbapiDriver, by_table
from gam_db.engines.postgres import ENGINE, PATH, ROOM
from gam_db.engines.postgres.refusals import of_connecting, of_statement
from gam_db.engines.postgres.types import ARROW, travelling
from gam_db.engines.refusals import refused
from gam_db.errors import EngineError, UserError, wrong
from gam_db.extras import needed

_AT_WORK = data.table("gam_db.engines.postgres", "postgres.toml")
_QUERIES = _AT_WORK["queries"]

_SCHEMA = re.compile(r'CREATE SCHEMA IF NOT EXISTS "([^"]+)"')

#: Seconds to wait for a server, where neither the address nor the environment says.
_PATIENCE = 15

#: Rows that are Python objects at a time, on their way to Arrow.
_FETCHED = 50_000

#: What one reading takes while it is sorted, in bytes.
_PER_READING = 100

#: Readings at once, at least: PostgreSQL sorts on its disk what does not fit into work_mem.
_AT_LEAST = 4_000_000


def connected(target: Any, writable: bool) -> "PostgresDriver":
    """Open a URL, completed by libpq's environment (PGHOST, PGPASSWORD, ~/.pgpass, ...).

    An open psycopg connection stays open and is set as before in the end. Steps are kept in temporary
    tables, writable or not.

    Raises:
        EngineError: psycopg is not installed, the server cannot be reached or does not let the user in,
            it is older than PostgreSQL 14, or the connection cannot be used.
    """
    try:
        psycopg = needed("psycopg", "postgres")
    except UserError as error:
        raise EngineError(str(error)) from error
    if not isinstance(target, str):
        return PostgresDriver(psycopg, target, owned=False)
    _check_address(target)
    wanted = {"fallback_application_name": "gam-db", "client_encoding": "UTF8"}
    try:
        options = psycopg.conninfo.conninfo_to_dict(target)
        if "connect_timeout" not in options and "PGCONNECT_TIMEOUT" not in os.environ:
            wanted["connect_timeout"] = str(_PATIENCE)
        connection = psycopg.connect(target, autocommit=True, **wanted)
    except psycopg.Error as error:
        # Not chained: what libpq says can hold parts of a password that it took for something else.
        raise of_connecting(str(error), _place(psycopg, target)) from None
    try:
        return PostgresDriver(psycopg, connection, owned=True)
    except EngineError:
        connection.close()
        raise


class PostgresDriver(DbapiDriver):
    """A psycopg connection; see :class:`gam_db.engines.driver.Driver`.

    What search_path says is read once: which schema tables are in that name none. A connection of ours
    then keeps to :data:`gam_db.engines.postgres.PATH`, a lent one while a statement of ours runs.
    """

    no_files = (
        "PostgreSQL does not read the file {path}; load it into a table (\\copy), or leave the database "
        "out: DuckDB reads files."
    )

    def __init__(self, psycopg: Any, connection: Any, owned: bool) -> None:
        super().__init__(connection, owned)
        self._psycopg = psycopg
        self.errors: tuple[type[Exception], ...] = (psycopg.Error,)
        self._transaction: Any = None
        self._statement = ""
        self._settings: dict[str, str] = {}
        self._path = ""
        self._home: str | None = None
        self._runs_conditions = False
        self._check()
        try:
            if owned:
                self._pin(locally=False)
            else:
                self._run("SELECT 1")  # every statement of ours pins the path, and asks for it
            self.engine = dataclasses.replace(ENGINE, home=self._home)
            self._settings = self._set(_AT_WORK["settings"])
        except psycopg.Error as error:
            raise self.problem(error) or refused("postgres", "25P02") from error

    def execute(self, statement: str) -> None:
        """Run one statement; a schema that is there is not made, which would take a right of its own."""
        self._statement = statement
        schema = _SCHEMA.fullmatch(statement)
        if schema and self._run("SELECT 1 FROM pg_namespace WHERE nspname = %s", (schema[1],)):
            return
        with self._safely(), self._cursor() as cursor:
            cursor.execute(statement, prepare=False)

    def fetch(self, query: str) -> pa.Table:
        self._statement = query
        with self._planned(_AT_WORK["planned"]), self._safely(), self._cursor(binary=True) as cursor:
            cursor.execute(query, prepare=False)
            names = [column.name for column in cursor.description]
            kinds = [ARROW.get(column.type_code) for column in cursor.description]
            chunks = []
            while rows := cursor.fetchmany(_FETCHED):
                arrays = map(pa.array, zip(*rows, strict=True), kinds)
                chunks.append(pa.Table.from_arrays(list(arrays), names=names))
        if not chunks:
            schema = [(name, kind or pa.string()) for name, kind in zip(names, kinds, strict=True)]
            return pa.schema(schema).empty_table()
        return pa.concat_tables(chunks, promote_options="permissive")

    def begin(self) -> None:
        """Begin a transaction.

        Each statement sees what others have committed by then, whatever the server's default: who waited
        for a row finds out what became of it.
        """
        self._transaction = self._connection.transaction()
        self._transaction.__enter__()
        self.execute("SET TRANSACTION ISOLATION LEVEL READ COMMITTED")
        if not self._owned:
            self._pin(locally=True)

    def commit(self) -> None:
        transaction, self._transaction = self._transaction, None
        transaction.__exit__(None, None, None)

    def rollback(self) -> None:
        if self._transaction is not None:
            transaction, self._transaction = self._transaction, None
            undone = self._psycopg.Rollback(transaction)
            transaction.__exit__(self._psycopg.Rollback, undone, None)

    def in_transaction(self) -> bool:
        status = self._psycopg.pq.TransactionStatus
        return self._connection.info.transaction_status in (status.INTRANS, status.INERROR)

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        settings = _AT_WORK["planned_alone"] | {"work_mem": f"{max(self._memory(), ROOM)}kB"}
        if self._is_long(query):
            settings |= _AT_WORK["planned_long"]
        with self._planned(settings):
            super().keep(table, query)
        self._count(table)

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        sent, types = travelling(rows)
        kinds = {name: exp.DataType.build(of, dialect=ENGINE.dialect) for name, of in types.items()}
        self.execute(self.engine.text(temporary(with_columns(table, kinds))))
        written = io.BytesIO()
        pyarrow.csv.write_csv(sent, written, pyarrow.csv.WriteOptions(include_header=False))
        sql = self._psycopg.sql
        target_name = sql.Identifier(*(part.name for part in table.parts))
        copy = sql.SQL("COPY {} FROM STDIN (FORMAT CSV)").format(target_name)
        with self._safely(), self._cursor() as cursor, cursor.copy(copy) as target:
            target.write(written.getbuffer())
        self._count(table)

    def tables(self) -> list[tuple[str, ...]]:
        return self._run(_QUERIES["tables"])

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node of a table with its schema, as the user's search_path has it.

        Raises:
            EngineError: it lies in a schema that the user may not use.
            SourceError: it lies in a schema that is not searched.
        """
        if not isinstance(table, exp.Table) or table.db:
            return table
        name = exp.Table(this=table.this.copy()).sql(dialect=self.engine.dialect)
        with self._safely(), self._connection.transaction():
            self._searching(self._path)
            ((number,),) = self._run_pinned(_QUERIES["number"], (name,))
            self._searching(PATH)
        schemas = self._run(_QUERIES["schema"], (number,))
        if not schemas:
            for (schema,) in self._run(_QUERIES["closed"], (table.name,)):
                raise wrong("postgres_usage", schema=schema)
            raise wrong("postgres_not_searched", name=table.name)
        return exp.Table(this=table.this.copy(), db=template.name(schemas[0][0]))

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        return dict(self._run(_QUERIES["columns"], (self.engine.text(relation),)))

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, names of tables in lower case.

        Raises:
            EngineError: none is named, and the user's search_path names none that is there.
        """
        if (schema := schema or self.engine.home) is None:
            raise wrong("postgres_no_schema")
        return by_table(self._run(_QUERIES["relations"], (schema,)))

    def expect_conditions(self) -> None:
        """Set the path, and how times are read, again after each statement.

        A condition may call set_config.
        """
        self._runs_conditions = True

    @contextlib.contextmanager
    def only_reading(self) -> Iterator[None]:
        """Let statements change nothing for a while, also in a transaction."""
        with self._connection.transaction(force_rollback=True):
            self._run_pinned(_QUERIES["only_read"], None)
            yield

    def rows_at_once(self) -> int:
        return max(self._memory() * 1024 // _PER_READING, _AT_LEAST)

    def problem(self, error: Exception) -> UserError | None:
        return of_statement(error, self._statement, self._connection.closed)

    def close(self) -> None:
        if not self._owned:
            with contextlib.suppress(self._psycopg.Error):
                self._set(self._settings)
        super().close()

    def _check(self) -> None:
        """Refuse a connection that is closed, busy, or of an unsupported PostgreSQL."""
        if not isinstance(self._connection, self._psycopg.Connection):
            raise wrong("postgres_connection", kind=type(self._connection).__name__)
        if self._connection.closed:
            raise EngineError("The connection to PostgreSQL is closed.")
        status = self._psycopg.pq.TransactionStatus
        if self._connection.info.transaction_status in (status.INERROR, status.ACTIVE):
            raise refused("postgres", "25P02")
        version = str(self._connection.info.server_version // 10_000)
        if ENGINE.is_too_old(version):
            raise wrong("postgres_too_old", version=version, oldest=ENGINE.oldest)

    def _memory(self) -> int:
        """Return the work_mem of the connection, in kB."""
        ((memory,),) = self._run(_QUERIES["memory"])
        return int(memory)

    def _is_long(self, query: exp.Query) -> bool:
        """Tell whether a server that translates queries to machine code would translate this one."""
        if self._settings["jit"] == "off":
            return False
        self._statement = self.engine.text(query)
        sql = self._psycopg.sql
        ((plan,),) = self._run(sql.SQL(_QUERIES["plan"]).format(sql.SQL(self._statement)))
        ((least,),) = self._run(_QUERIES["translated_from"])
        return bool(0 <= least <= plan[0]["Plan"]["Total Cost"])

    def _set(self, settings: Mapping[str, str]) -> dict[str, str]:
        """Change settings of the connection; return what they were."""
        before = {}
        for name, value in settings.items():
            ((before[name], _),) = self._run(_QUERIES["setting"], (name, name, value))
        return before

    @contextlib.contextmanager
    def _safely(self) -> Iterator[None]:
        """Leave the user's transaction, or its absence, and search_path as they are.

        Inside one, a statement that is refused would end it: hence a savepoint. A connection without
        autocommit begins one with every first statement: hence a transaction that ends with ours. What
        is set for a transaction goes with it, but stays when a savepoint is released.
        """
        if self._owned or self._transaction is not None:
            yield
            self._pin_again(PATH, locally=not self._owned)
            return
        status = self._psycopg.pq.TransactionStatus
        idle = self._connection.info.transaction_status == status.IDLE
        with self._connection.transaction():
            self._pin(locally=True)
            yield
            if not idle:
                self._searching(self._path)
            self._pin_again(self._path, locally=False)

    def _pin(self, locally: bool) -> None:
        """Set the search_path to PostgreSQL's own schema; remember the former one."""
        self._path, self._home = self._searching(PATH, locally)

    def _pin_again(self, path: str, locally: bool) -> None:
        """Set what a condition of the user's may have set otherwise, by set_config."""
        if self._runs_conditions:
            self._run_pinned(_QUERIES["pin_again"], (path, locally))

    def _searching(self, path: str, locally: bool = True) -> tuple[str, str | None]:
        """Look names up on a path; return the one before, and its current schema."""
        ((before, schema, _),) = self._run_pinned(_QUERIES["pin"], (path, locally))
        return before, schema

    @contextlib.contextmanager
    def _planned(self, settings: Mapping[str, str]) -> Iterator[None]:
        """Let statements be planned otherwise."""
        before = self._set(settings)
        try:
            yield
        finally:
            # In a transaction that has failed it cannot be said, and is undone with the rest.
            with contextlib.suppress(self._psycopg.Error):
                self._set(before)

    def _cursor(self, binary: bool = False) -> Any:
        # A factory of the user's would make something else than tuples of the rows.
        return self._connection.cursor(binary=binary, row_factory=self._psycopg.rows.tuple_row)

    def _run(self, query: Any, values: Sequence[Any] = ()) -> list[tuple[Any, ...]]:
        """Return the rows of a query of gam-db, a text or one that psycopg composed."""
        with self._safely():
            return self._run_pinned(query, values or None)

    def _run_pinned(self, query: Any, values: Sequence[Any] | None) -> list[tuple[Any, ...]]:
        """Return the same where the path is pinned, or is being pinned."""
        with self._cursor() as cursor:
            return list(cursor.execute(query, values, prepare=False).fetchall())

    def _count(self, table: exp.Table) -> None:
        """Collect statistics of a new table for the planner."""
        self.execute(self.engine.text(exp.Analyze(tables=[table.copy()])))


def _check_address(address: str) -> None:
    """Refuse an address with a sign in its password by which libpq would cut it up otherwise."""
    parts = urlsplit(address)
    people = parts.netloc.count("@")
    if people > 1 or "@" in parts.path + parts.fragment or ("@" in parts.query and not people):
        raise wrong("postgres_signs_in_address")


def _place(psycopg: Any, address: str) -> str:
    """Return the server that an address means; empty if it means none."""
    try:
        options = psycopg.conninfo.conninfo_to_dict(address)
    except psycopg.Error:
        return ""
    host = options.get("host") or os.environ.get("PGHOST") or "the local socket"
    port = options.get("port") or os.environ.get("PGPORT") or "5432"
    return f"{host}, port {port}" if port.isdecimal() else host
