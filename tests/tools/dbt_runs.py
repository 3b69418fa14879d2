"""The real dbt, in an environment of its own: where it is, the warehouses it builds in, and its runs.

``GAM_DBT`` is the path of a dbt executable whose environment holds dbt-duckdb and dbt-postgres; they pin
versions that our own environment should not be bound to.
"""

import importlib
import json
import os
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

import duckdb
import pyarrow as pa

import postgres_server

ROWS = Sequence[tuple[Any, ...]]

_TABLE = "CREATE TABLE telemetry (asset VARCHAR, channel VARCHAR, ts TIMESTAMP, value DOUBLE PRECISION)"


class Warehouse(Protocol):
    """What a package is built in."""

    @property
    def profile(self) -> dict[str, Any]:
        """What dbt is told of it."""

    def arrive(self, rows: ROWS) -> None:
        """Let rows arrive in the table telemetry."""

    def rows(self, query: str) -> list[tuple[Any, ...]]:
        """The rows of a query."""


@dataclass(frozen=True)
class InDuckDB:
    """A DuckDB file."""

    path: Path

    @property
    def profile(self) -> dict[str, Any]:
        """What dbt is told of it."""
        return {"type": "duckdb", "path": str(self.path), "threads": 1}

    def arrive(self, rows: ROWS) -> None:
        """Let rows arrive."""
        with duckdb.connect(str(self.path)) as connection:
            connection.execute(_TABLE.replace("TABLE", "TABLE IF NOT EXISTS"))
            connection.register("arriving", arrow(rows))
            connection.execute("INSERT INTO telemetry SELECT * FROM arriving")

    def rows(self, query: str) -> list[tuple[Any, ...]]:
        """The rows of a query."""
        with duckdb.connect(str(self.path), read_only=True) as connection:
            return connection.sql(query).fetchall()


def arrow(rows: ROWS) -> pa.Table:
    """Rows as an Arrow table: DuckDB takes a thousand times longer over single ones."""
    types = (pa.string(), pa.string(), pa.timestamp("us"), pa.float64())
    columns = zip(*rows, strict=True)
    arrays = [pa.array(column, kind) for column, kind in zip(columns, types, strict=True)]
    return pa.table(arrays, names=["asset", "channel", "ts", "value"])


class InPostgres:
    """A schema of its own on the throw-away server."""

    schema = "gam_dbt"

    def __init__(self) -> None:
        self.psycopg = importlib.import_module("psycopg")
        self.server = postgres_server.server()
        with self._connection() as connection:
            connection.execute(f"DROP SCHEMA IF EXISTS {self.schema} CASCADE")
            connection.execute(f"CREATE SCHEMA {self.schema}")
            connection.execute(_TABLE)

    def _connection(self) -> Any:
        return self.psycopg.connect(self.server.url, options=f"-c search_path={self.schema}")

    @property
    def profile(self) -> dict[str, Any]:
        """What dbt is told of it."""
        server = self.server
        place = {"host": server.host, "port": server.port, "dbname": server.database}
        who = {"user": server.user, "password": "trusted", "schema": self.schema}
        return {"type": "postgres", **place, **who, "threads": 1}

    def arrive(self, rows: ROWS) -> None:
        """Let rows arrive."""
        with (
            self._connection() as connection,
            connection.cursor() as cursor,
            cursor.copy("COPY telemetry FROM STDIN") as copy,
        ):
            for row in rows:
                copy.write_row(row)

    def rows(self, query: str) -> list[tuple[Any, ...]]:
        """The rows of a query."""
        with self._connection() as connection:
            return list(connection.execute(query).fetchall())


def executable() -> str:
    """The dbt to run."""
    found = os.environ.get("GAM_DBT")
    assert found, "set GAM_DBT to a dbt executable with dbt-duckdb and dbt-postgres"
    return found


def run(folder: Path, warehouse: Warehouse, *words: str) -> str:
    """Run dbt in a package, and return what it printed; its warnings are errors, as ours are."""
    example = (folder / "profiles.example.yml").read_text()
    profile = {"gam": {"target": "test", "outputs": {"test": warehouse.profile}}}
    as_is = isinstance(warehouse, InDuckDB)  # where the example's plant.duckdb lies
    (folder / "profiles.yml").write_text(example if as_is else json.dumps(profile))
    done = subprocess.run(
        [executable(), "--no-use-colors", *words],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "DBT_SEND_ANONYMOUS_USAGE_STATS": "false", "DBT_WARN_ERROR": "true"},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return str(done.stdout)
