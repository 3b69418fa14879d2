"""MariaDB at work, by PyMySQL."""

import contextlib
import datetime as dt
import getpass
import math
import os
from collections.abc import Sequence
from typing import Any
from urllib.parse import unquote, urlsplit

import pyarrow as pa
from sqlglot import exp

from gam_db import data
from gam_db.address import shown
from gam_db.engines.driver import DbapiDriver, by_table
from gam_db.engines.frames import check_columns
from gam_db.engines.mariadb import COLLATION, ENGINE
from gam_db.engines.refusals import OPEN, refused
from gam_db.errors import EngineError, wrong
from gam_db.extras import needed

PORT = 3306

#: Seconds to wait for a server.
PATIENCE = 15

_AT_WORK = data.table("gam_db.engines.mariadb", "mariadb.toml")
_SETTINGS, _QUERIES = _AT_WORK["settings"], _AT_WORK["queries"]


def connected(target: Any, writable: bool) -> "MariaDriver":
    """Open ``mariadb://USER@HOST:3306/DATABASE``, or take an open connection of PyMySQL.

    The password is best left to the environment (MYSQL_PWD).

    Raises:
        EngineError: PyMySQL is not installed, the server cannot be reached, refuses the user, or is no
            MariaDB 10.11 or later.
    """
    pymysql = needed("pymysql", "mariadb")
    if not isinstance(target, str):
        return MariaDriver(pymysql, target, owned=False)
    address, place = urlsplit(target), shown(target)
    if address.query or address.fragment:
        raise wrong("mariadb_options", place=place)
    try:
        connection = pymysql.connect(
            host=address.hostname or "127.0.0.1",
            port=address.port or PORT,
            user=unquote(address.username or "") or getpass.getuser(),
            password=unquote(address.password or "") or os.environ.get("MYSQL_PWD", ""),
            database=unquote(address.path.lstrip("/")) or None,
            charset="utf8mb4",
            autocommit=True,
            connect_timeout=PATIENCE,
        )
    except ValueError:
        raise EngineError(f"{place} cannot be read: a port is a number, and %40 stands for @.") from None
    except pymysql.err.OperationalError as error:
        raise refused("mariadb_connecting", str(error.args[0]), place=place) from None
    return MariaDriver(pymysql, connection, owned=True)


class MariaDriver(DbapiDriver):
    """A connection of PyMySQL."""

    engine = ENGINE
    no_files = "MariaDB does not read the file {path}; load it into a table and name that."
    place = "%s"
    begins_reading = "START TRANSACTION READ ONLY"

    def __init__(self, pymysql: Any, connection: Any, owned: bool) -> None:
        super().__init__(connection, owned)
        self.errors = (pymysql.err.Error,)
        self._lent: set[str] = set()
        self._types = pymysql.constants.FIELD_TYPE
        ((version,),) = self._run("SELECT VERSION()")
        if "MariaDB" not in version or ENGINE.is_too_old(version):
            raise EngineError(f"The server is {version}; gam-db needs MariaDB {ENGINE.oldest} or later.")
        if self.in_transaction():
            raise EngineError(OPEN)
        self._before = self._run(_QUERIES["settings"])[0]
        self._charset = connection.charset
        self._run(_QUERIES["set"], tuple(_SETTINGS.values()))
        connection.set_character_set("utf8mb4", COLLATION)

    def in_transaction(self) -> bool:
        return bool(self._run("SELECT @@in_transaction")[0][0])

    def array(self, described: Sequence[Any], column: Sequence[Any]) -> pa.Array:
        types, kind = self._types, described[1]
        if kind in (types.DOUBLE, types.FLOAT):
            return pa.array(column, pa.float64())
        if kind in (types.TINY, types.SHORT, types.LONG, types.LONGLONG, types.INT24):
            return pa.array(column, pa.int64())
        if kind in (types.DATETIME, types.TIMESTAMP):
            return pa.array(column, pa.timestamp("us"))
        texts = (types.VAR_STRING, types.STRING, types.BLOB, types.LONG_BLOB, types.MEDIUM_BLOB)
        return pa.array(column, pa.string()) if kind in texts else pa.array(column)

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        check_columns(rows)
        super().ingest(table, rows)
        self._lent.add(table.name)

    def drop(self, table: exp.Table) -> None:
        """Drop a temporary table; without TEMPORARY the server would commit the open transaction."""
        dropped = exp.Drop(tables=[table.copy()], kind="TABLE", temporary=True, exists=True)
        self.execute(self.engine.text(dropped))
        self._lent.discard(table.name)

    def close(self) -> None:
        if not self._owned:
            with contextlib.suppress(*self.errors):
                self._run(_QUERIES["set"], self._before)
                self._connection.set_character_set(self._charset)
        super().close()

    def type_of(self, arrow: pa.DataType) -> exp.DataType:
        if pa.types.is_timestamp(arrow) or pa.types.is_date(arrow):
            return exp.DataType.build("DATETIME(6)", dialect="mysql")
        return super().type_of(arrow)

    def plain(self, value: Any) -> Any:
        """Return a value as the server takes it: what is not finite is no double here, and missing."""
        if isinstance(value, float):
            return value if math.isfinite(value) else None
        is_zoned = isinstance(value, dt.datetime) and value.tzinfo is not None
        return value.astimezone(dt.UTC).replace(tzinfo=None) if is_zoned else value

    def tables(self) -> list[tuple[str, ...]]:
        """Return the tables and views of all databases, and temporary ones, which no list has."""
        return [*self._run(_QUERIES["tables"]), *((name,) for name in self._lent)]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        rows = self._run(self.engine.text(exp.Describe(this=relation.find(exp.Table))))
        return {name: str(declared) for name, declared, *_ in rows}

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        return by_table(self._run(_QUERIES["relations"], (schema,)))
