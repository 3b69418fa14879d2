"""The user's own connection: a right answer or a remedy."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest
import sqlglot

from gam_db import Calibration, Source
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import EngineError
from odd import DAY, LENGTH, USUAL, USUAL_ROWS, database, expected, health, refused, support, table


@pytest.fixture
def mine() -> Iterator[duckdb.DuckDBPyConnection]:
    connection = database(
        USUAL,
        "CREATE TEMP TABLE passing AS SELECT * FROM t",
        "CREATE VIEW seen AS SELECT * FROM t WHERE time >= 0",
    )
    yield connection
    connection.close()


def everything(connection: duckdb.DuckDBPyConnection) -> list[Any]:
    """All that a connection holds: tables, views, macros, attached databases, settings, rows."""
    looks = [
        "SELECT table_catalog, table_schema, table_name, table_type FROM information_schema.tables",
        "SELECT function_name FROM duckdb_functions() WHERE NOT internal",
        "SELECT database_name FROM duckdb_databases()",
        "SELECT name, value FROM duckdb_settings()",
        "SELECT * FROM t",
        "SELECT * FROM passing",
    ]
    return [sorted(connection.execute(look).fetchall(), key=str) for look in looks]


def test_a_connection_is_left_as_it_was(mine: duckdb.DuckDBPyConnection) -> None:
    before = everything(mine)
    for relation in ("t", "passing", "seen", table()):
        assert support(Source(relation), engine=mine)[0]["samples"] == 10
    assert everything(mine) == before
    refused("no column", lambda: support(Source("t", value="valeu"), engine=mine))
    refused("without", lambda: support(Source(table(asset=pa.nulls(LENGTH, pa.string()))), engine=mine))
    refused("not found", lambda: support(Source("t", where="tme > 1"), engine=mine))
    refused("no table", lambda: support(Source("none.t"), engine=mine))
    assert everything(mine) == before


def test_an_open_transaction_survives(mine: duckdb.DuckDBPyConnection) -> None:
    """A statement that fails would undo it without a word; a name is looked up, not tried."""
    mine.execute("BEGIN")
    mine.execute("INSERT INTO t VALUES ('a', 'x', 10, 1)")
    assert support(Source("t"), engine=mine)[0]["samples"] == 11
    refused("no table", lambda: support(Source("no.such"), engine=mine))
    refused("no column", lambda: support(Source("t", value="valeu"), engine=mine))
    mine.execute("COMMIT")
    assert mine.execute("SELECT COUNT(*) FROM t").fetchall() == [(11,)]


@pytest.mark.parametrize(
    ("kind", "zone"),
    [
        ("TIMESTAMP", "Asia/Kathmandu"),
        ("TIMESTAMPTZ", "America/New_York"),
        ("TIMESTAMP_NS", "America/New_York"),
        ("DATE", "Asia/Kathmandu"),
    ],
)
def test_another_time_zone_gives_the_same_integers(kind: str, zone: str) -> None:
    """Timestamps without zone are UTC, and days do not begin elsewhere."""
    connection = database(
        "SET TimeZone = 'UTC'",
        "CREATE TABLE t AS SELECT 'a' AS asset, 'x' AS channel, "
        f"(TIMESTAMP '2026-03-28 12:00:00' + i * INTERVAL 12 HOUR)::{kind} AS time, "
        "(i * 7 % 5)::DOUBLE AS value FROM range(10) AS r(i)",
    )
    rule = Calibration(intervals=[("2026-03-28", "2026-03-31T01:00:00+02:00")])
    as_utc = health(Source("t"), calibration=rule, engine=connection)
    connection.execute(f"SET TimeZone = '{zone}'")
    assert health(Source("t"), calibration=rule, engine=connection) == as_utc
    noon = 1774699200 * 10**6  # 2026-03-28T12:00:00 UTC
    step = DAY if kind == "DATE" else DAY // 2
    assert as_utc
    assert all(row["time"] > noon and row["time"] % step == 0 for row in as_utc)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("SET default_order = 'DESC'", "default_order = DESC, which would reverse the order of time"),
        ("SET default_collation = 'NOCASE'", "default_collation = NOCASE, under which different names"),
    ],
)
def test_settings_that_would_change_results_are_refused(
    mine: duckdb.DuckDBPyConnection, setting: str, message: str
) -> None:
    mine.execute(setting)
    refused(message, lambda: support(Source("t"), engine=mine), EngineError)


def test_settings_that_must_not_matter(mine: duckdb.DuckDBPyConnection) -> None:
    mine.execute("SET default_null_order = 'NULLS FIRST'")
    mine.execute("SET integer_division = true")
    mine.execute("SET ieee_floating_point_ops = false")
    mine.execute("SET python_enable_replacements = false")
    mine.execute("SET preserve_insertion_order = false")
    assert health(Source("t"), engine=mine) == expected(USUAL_ROWS)


def test_a_statement_is_read_the_same_on_every_connection(mine: duckdb.DuckDBPyConnection) -> None:
    """A setting of a connection changes neither its own statements nor those of the next one."""
    share = sqlglot.parse_one("SELECT 7 / 2 AS share", dialect="duckdb")
    mine.execute("SET integer_division = true")
    assert DuckSession(mine).rows(share) == [{"share": 3.5}]
    with duckdb.connect() as other:
        assert DuckSession(other).rows(share) == [{"share": 3.5}]


def test_engines_that_are_none(tmp_path: Path) -> None:
    closed = duckdb.connect()
    closed.close()
    (tmp_path / "text.duckdb").write_text("no database")
    for engine, message in (
        (closed, "connection cannot be used; is it closed"),
        (tmp_path / "none.duckdb", "no database file .*none.duckdb"),
        (tmp_path / "text.duckdb", "cannot be opened as a DuckDB file"),
    ):
        refused(
            message,
            lambda engine=engine: support(Source("t"), engine=engine),  # type: ignore[misc]
            EngineError,
        )


def test_a_database_file_is_only_read(tmp_path: Path) -> None:
    path = tmp_path / "plant.duckdb"
    with duckdb.connect(str(path)) as connection:
        connection.execute(USUAL)
    before = path.read_bytes()
    assert health(Source("t"), engine=path) == expected(USUAL_ROWS)
    assert health(Source("t"), engine=str(path)) == expected(USUAL_ROWS)
    assert path.read_bytes() == before
