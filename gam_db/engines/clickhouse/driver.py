"""ClickHouse at work: a server over HTTP, or chdb inside this process, by clickhouse-connect.

Steps are kept as temporary tables of a session, which the server drops with it, also that of a process
that was killed. There are no transactions: rows are appended, and a run is visible by its last row.
"""

import contextlib
import importlib
import os
import re
import secrets
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl, unquote, urlsplit

import pyarrow as pa
from sqlglot import exp

from gam_db import data
from gam_db.address import shown
from gam_db.composing import template
from gam_db.engines.base import deletion, with_columns
from gam_db.engines.clickhouse import ENGINE, create_table, temporary_table
from gam_db.engines.driver import Driver, by_table, is_text, usual
from gam_db.engines.refusals import first_line, refusal
from gam_db.errors import EngineError, UserError, nearest, wrong
from gam_db.extras import needed

EXTRA = "clickhouse"

_FOLDER = "chdb:///"
_PARAMETERS = ("ca_cert", "client_cert", "client_cert_key", "verify", "connect_timeout")

#: Seconds that a statement may take.
_PATIENCE = 86_400

#: What lies in a folder of chdb.
_OF_CHDB = {"metadata", "store", "tmp"}

#: What the temporary tables of a session begin with.
MARK = "gam_"

_GRANT = re.compile(r"the grant (.+?)(?:\. \(ACCESS_DENIED\)|\.?$)", re.MULTILINE)

#: Seconds that a session may wait for its next statement.
_IDLE = 3_600

_AT_WORK = data.table("gam_db.engines.clickhouse", "clickhouse.toml")
_SETTINGS, _QUERIES = _AT_WORK["settings"], _AT_WORK["queries"]

#: What a reading takes while it is scored, in bytes: the kept steps, a sort, and the sides of joins.
_PER_READING = 200

#: Keys of rows to be deleted lie in a table of this name and the time (seconds) when it was made; one
#: that is so old was left by a process that was killed.
_DOOMED = f"{MARK}doomed_"
_STALE = 86_400


def connected(target: Any, writable: bool) -> "ClickHouseDriver":
    """Connect to a server, open a folder of chdb, or take an open client, which stays open.

    Addresses are clickhouse://user@host:8123/database, clickhouses:// with TLS, chdb:///folder (which
    is made where it is to be written) and chdb:// (in memory).

    Raises:
        EngineError: there is no such server, database or folder, the user is refused, the folder is open
            in another process, or the server is too old.
        UserError: clickhouse-connect or chdb is not installed.
    """
    package = needed("clickhouse_connect", EXTRA)
    if not isinstance(target, str):
        if not isinstance(target, package.driver.client.Client):
            raise wrong("clickhouse_connection", kind=type(target).__name__)
        return ClickHouseDriver(target, "this ClickHouse connection", owned=False)
    address = shown(target)
    wanted = folder(target, writable) if target.startswith("chdb:") else server(target)
    try:
        return ClickHouseDriver(package.get_client(**wanted), address, owned=True)
    except package.driver.exceptions.ClickHouseError as error:
        reason = "locked" if is_locked(wanted.get("path")) else str(error)
        raise (
            refusal("clickhouse_connecting", reason, address=address)
            or problem(error, address)
            or EngineError(f"{address} cannot be opened: {first_line(error)}")
        ) from error


class ClickHouseDriver(Driver):
    """A client of clickhouse-connect, and what messages call it: its address without password.

    Raises:
        EngineError: the server is too old, or a setting that changes results is fixed by its profile.
    """

    engine = ENGINE
    no_files = (
        "{path} is a file, and ClickHouse reads tables here; make a view over its table function "
        "file(), or insert it into a table."
    )

    def __init__(self, client: Any, address: str, owned: bool) -> None:
        self._client, self._address, self._owned = client, address, owned
        exceptions = needed("clickhouse_connect.driver.exceptions", EXTRA)
        self.errors: tuple[type[Exception], ...] = (exceptions.ClickHouseError, OSError, pa.ArrowInvalid)
        version = str(client.server_version)
        if ENGINE.is_too_old(version):
            raise wrong("clickhouse_too_old", address=address, version=version, oldest=ENGINE.oldest)
        # Requests without a session would each have temporary tables of their own.
        self._settings: dict[str, str] = {"session_timeout": str(_IDLE)}
        if client.get_client_setting("session_id") is None:
            self._settings["session_id"] = f"{MARK}{secrets.token_hex(8)}"
        self._settings |= self._differing()
        if owned:
            for name, value in self._settings.items():
                client.set_client_setting(name, value)
            self._settings = {}
        self._database = self._scalar("SELECT currentDatabase()")

    def _differing(self) -> dict[str, str]:
        """Return the settings that are not as they must be, of those that the server knows."""
        ((names, values, fixed_here),) = self._rows(_QUERIES["settings"])
        current = dict(zip(names, zip(values, fixed_here, strict=True), strict=True))
        differing = {
            name: value
            for name, value in _SETTINGS.items()
            if name in current and current[name][0] != value
        }
        if fixed := sorted(name for name in differing if current[name][1]):
            raise wrong("clickhouse_fixed_settings", names=", ".join(fixed[:3]))
        return differing

    def execute(self, statement: str) -> None:
        self._client.command(statement, settings=self._settings)

    def fetch(self, query: str) -> pa.Table:
        try:
            return usual(self._client.query_arrow(query, settings=self._settings))
        except Exception:
            # chdb puts what a refused query had written by then before the next answer, which is no
            # Arrow any more; the one after that is right again.
            with contextlib.suppress(Exception):
                self._client.query_arrow("SELECT 1")
            raise

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        try:
            self.execute(self.engine.text(temporary_table(table, query)))
        except BaseException:
            # The table is made before its rows; a client that stays open would keep it.
            with contextlib.suppress(*self.errors):
                self.drop(table)
            raise

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        """Make a temporary table of an Arrow table, or refuse types that ClickHouse has not."""
        rows = _insertable(rows)
        types = {
            field.name: exp.DataType.build(_column_type(field.type), dialect=ENGINE.dialect)
            for field in rows.schema
        }
        self.execute(self.engine.text(temporary_table(with_columns(table, types))))
        name = self.engine.text(table)
        if rows.num_rows:
            self._client.insert_arrow(name, rows, settings=self._settings)
        # A request that was cut off is sent again by the client, and its rows may be there twice.
        count = exp.select(exp.Count(this=exp.Star())).from_(table.copy())
        if self._scalar(self.engine.text(count)) != rows.num_rows:
            raise ConnectionError("rows were sent twice")

    def drop(self, table: exp.Table) -> None:
        drop = exp.Drop(tables=[table.copy()], kind="TABLE", temporary=True, exists=True)
        self.execute(self.engine.text(drop))

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        """Delete the rows of a table whose keys are among the rows of a query, as one step.

        The server deletes in the background, where no temporary table and no current database is known.
        So the keys lie in a table beside the other, and all names are in full.
        """
        database = template.name(table.db or self._database)
        self._sweep(database.name)
        name = f"{_DOOMED}{int(time.time())}_{secrets.token_hex(8)}"
        doomed = exp.Table(this=template.name(name), db=database)
        target = exp.Table(this=table.this.copy(), db=database.copy())
        try:
            self.execute(self.engine.text(create_table(doomed, key_rows)))
            columns = [template.column(key) for key in keys]
            listed = exp.select(*columns).from_(doomed.copy())
            if self.fetch(self.engine.text(listed.limit(1))).num_rows:
                self.execute(self.engine.text(deletion(target, keys, listed)))
        finally:
            self._remove(database.name, doomed.name)

    def _sweep(self, database: str) -> None:
        """Drop the keys that a killed process left behind."""
        stale = int(time.time()) - _STALE
        for (name,) in self._rows(_QUERIES["stale"], database=database, mark=_DOOMED, stale=stale):
            self._remove(database, name)

    def _remove(self, database: str, name: str) -> None:
        """Drop a table of keys, and a deletion that still reads it, which would never end."""
        with contextlib.suppress(*self.errors):
            names = {"database": database, "name": name}
            if self._scalar(_QUERIES["deleting"], **names):
                self._client.command(_QUERIES["stop"], parameters=names, settings=self._settings)
            left = exp.Table(this=template.name(name), db=template.name(database))
            self.execute(self.engine.text(exp.Drop(tables=[left], kind="TABLE", exists=True)))

    def tables(self) -> list[tuple[str, ...]]:
        """Return what can be read: (database, name), and the name of a temporary table."""
        rows = self._rows(_QUERIES["tables"])
        return [(database, name) if database else (name,) for database, name in rows]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        """Return columns and their types; of another database only if the name contains it."""
        try:
            described = exp.Describe(this=relation.copy(), kind="TABLE")
            rows = self.fetch(self.engine.text(described)).to_pylist()
        except self.errors as error:
            if getattr(error, "code", None) != 60:
                raise
            raise wrong(
                "clickhouse_no_table", text=self.engine.text(relation), database=self._database
            ) from error
        return {row["name"]: row["type"] for row in rows if row["default_type"] != "EPHEMERAL"}

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        return by_table(self._rows(_QUERIES["relations"], database=schema or self._database))

    def rows_at_once(self) -> int:
        """Return how many readings can be worked on at once within half of the memory allowed."""
        allowed = self._rows(_QUERIES["memory"])
        with contextlib.suppress(*self.errors):
            allowed += self._rows(_QUERIES["memory_of_server"])
        limit = min((row[0] for row in allowed if row[0] > 0), default=2**32)
        return max(limit // 2 // _PER_READING, 100_000)

    def problem(self, error: Exception) -> UserError | None:
        return problem(error, self._address)

    def close(self) -> None:
        if self._owned:
            self._client.close()

    def _rows(self, query: str, **parameters: Any) -> list[tuple[Any, ...]]:
        """Return the rows of a query on the catalogue."""
        rows = self._client.query_arrow(query, parameters=parameters or None, settings=self._settings)
        return list(zip(*(column.to_pylist() for column in rows.columns), strict=True))

    def _scalar(self, query: str, **parameters: Any) -> Any:
        return self._rows(query, **parameters)[0][0]


def folder(address: str, writable: bool) -> dict[str, Any]:
    """Return what opens chdb:///FOLDER or chdb:// (in memory).

    Raises:
        EngineError: it is no such address, or no folder of chdb.
        UserError: chdb is not installed.
    """
    needed("chdb", EXTRA)
    if address == "chdb://":
        return {"interface": "chdb"}
    if not address.startswith(_FOLDER):
        raise wrong("chdb_names_a_server", address=address)
    path = Path(address.removeprefix(_FOLDER))
    if not path.is_dir() and not (writable and not path.exists() and path.parent.is_dir()):
        raise EngineError(f"There is no folder {path.absolute()}.")
    there = {entry.name for entry in path.iterdir()} if path.is_dir() else set()
    if there and not there & _OF_CHDB:
        raise EngineError(f"{path} is not a folder of chdb; give an empty or a new folder.")
    return {"interface": "chdb", "path": str(path)}


def is_locked(folder: str | None) -> bool:
    """Tell whether another process holds a folder of chdb; the error itself does not tell."""
    if folder is None:
        return False
    fcntl = importlib.import_module("fcntl")  # chdb runs only where it is there
    with contextlib.suppress(FileNotFoundError), (Path(folder) / "status").open() as status:
        try:
            fcntl.flock(status, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return True
    return False


def server(address: str) -> dict[str, Any]:
    """Return what opens clickhouse://user@host:8123/database, or clickhouses:// with TLS.

    Raises:
        EngineError: a part of the address is none.
    """
    parts = urlsplit(address)
    parameters = dict(parse_qsl(parts.query))
    for name in parameters:
        if name not in _PARAMETERS:
            raise wrong("clickhouse_parameter", name=name, hint=nearest(name, _PARAMETERS))
    try:
        port = parts.port
    except ValueError:
        raise EngineError(f"{shown(address)}: the port is not a number.") from None
    secure = parts.scheme == "clickhouses"
    return {
        "interface": "https" if secure else "http",
        "host": parts.hostname or "localhost",
        "port": port or (8443 if secure else 8123),
        "username": unquote(parts.username or os.environ.get("CLICKHOUSE_USER") or "default"),
        "password": unquote(parts.password or "") or os.environ.get("CLICKHOUSE_PASSWORD", ""),
        "database": unquote(parts.path.strip("/")) or None,
        "send_receive_timeout": _PATIENCE,
        "query_retries": 0,
        **parameters,
    }


def problem(error: Exception, address: str) -> UserError | None:
    """Return what the user can do about an error; None if it is none of the user's.

    It is one of clickhouse-connect or of the transport below; the address has no password.
    """
    code, message = getattr(error, "code", None), str(error)
    if code is None and (
        isinstance(error, OSError) or type(error).__name__ in ("OperationalError", "StreamFailureError")
    ):
        code = "transport"
    grant = _GRANT.search(message)
    return refusal(
        *("clickhouse", str(code), f"{code} {message}"),
        address=address,
        grant=grant[1] if grant else "SELECT, INSERT, CREATE TABLE, ALTER DELETE, DROP",
        name=getattr(error, "name", None) or code,
    )


def _column_type(arrow: pa.DataType) -> str:
    """Return the type of a column that holds what an Arrow column does, NULL included."""
    for is_of, name in _COLUMN_TYPES:
        if is_of(arrow):
            return f"Nullable({name(arrow)})"
    raise wrong("clickhouse_arrow", arrow=arrow)


def _insertable(rows: pa.Table) -> pa.Table:
    """Return an Arrow table without dictionaries and views, which go in as other types."""
    fields = []
    for field in rows.schema:
        held = field.type
        held = held.value_type if pa.types.is_dictionary(held) else held
        held = pa.string() if is_text(held) else pa.float64() if pa.types.is_float16(held) else held
        fields.append(pa.field(field.name, held))
    return rows.cast(pa.schema(fields))


def _instant(arrow: pa.TimestampType) -> str:
    digits = {"s": 0, "ms": 3, "us": 6, "ns": 9}[arrow.unit]
    return f"DateTime64({digits})" if arrow.tz is None else f"DateTime64({digits}, 'UTC')"


_COLUMN_TYPES: tuple[tuple[Callable[[pa.DataType], bool], Callable[[pa.DataType], str]], ...] = (
    (pa.types.is_boolean, lambda held: "Bool"),
    (pa.types.is_signed_integer, lambda held: f"Int{held.bit_width}"),
    (pa.types.is_unsigned_integer, lambda held: f"UInt{held.bit_width}"),
    (pa.types.is_floating, lambda held: f"Float{max(held.bit_width, 32)}"),
    (pa.types.is_decimal, lambda held: f"Decimal({held.precision}, {held.scale})"),
    (pa.types.is_timestamp, _instant),
    (pa.types.is_date, lambda held: "Date32"),
    (is_text, lambda held: "String"),
    (pa.types.is_null, lambda held: "UInt8"),
)
