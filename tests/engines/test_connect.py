"""The address of a database: what is opened, and what is refused with a reason."""

from pathlib import Path

import duckdb
import pytest

import gam_db
from gam_db.address import has_password, shown
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.errors import EngineError


def on(session: Session) -> duckdb.DuckDBPyConnection:
    """The connection of a DuckDB session."""
    assert isinstance(session, DuckSession)
    return session.connection


@pytest.mark.parametrize("shape", ["{0}", "duckdb:///{0}", "path"])
def test_a_file_is_made_and_written(tmp_path: Path, shape: str) -> None:
    path = tmp_path / "plant.duckdb"
    with gam_db.connect(path if shape == "path" else shape.format(path), threads=1) as session:
        on(session).execute("CREATE TABLE t (a INTEGER)")
        assert on(session).execute("SELECT current_setting('threads')").fetchone() == (1,)
    with gam_db.connect(path) as session:
        assert session.relations() == {"t": ("a",)}


def test_three_slashes_are_a_relative_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with gam_db.connect("duckdb:///plant.duckdb"):
        pass
    assert [file.name for file in tmp_path.iterdir()] == ["plant.duckdb"]


@pytest.mark.parametrize("target", [None, "duckdb://", ":memory:", "duckdb:///:memory:"])
def test_a_database_in_memory(target: str | None) -> None:
    with gam_db.connect(target) as session:
        on(session).execute("CREATE TABLE t (a INTEGER)")
        found = on(session).execute("SELECT path FROM duckdb_databases() WHERE NOT internal")
        assert found.fetchall() == [(None,)]


def test_an_open_connection_stays_open() -> None:
    with duckdb.connect() as mine:
        with gam_db.connect(mine) as session:
            assert on(session) is mine
        assert mine.execute("SELECT 1").fetchall() == [(1,)]


@pytest.mark.parametrize(
    ("target", "message"),
    [
        ("oracle://u:secret@host/db", r"^gam-db does not support addresses with oracle://"),
        ("duckdb://server/plant", "three slashes"),
        ("", "path of a DuckDB file"),
        (7, "is a int; it takes the path of a DuckDB file"),
        ("/nowhere/at/all.duckdb", "no database file"),
    ],
)
def test_another_address_is_refused(target: object, message: str) -> None:
    with pytest.raises(EngineError, match=message) as caught:
        gam_db.connect(target)
    assert "secret" not in str(caught.value)


@pytest.mark.parametrize(
    ("address", "without"),
    [
        ("plant.duckdb", "plant.duckdb"),
        ("postgresql://me@host/db", "postgresql://me@host/db"),
        ("postgresql://me:secret@host:5432/db", "postgresql://me@host:5432/db"),
        ("postgresql://me:se/cr@et@host/db", "postgresql://me@host/db"),
        ("postgresql://host/db?password=secret&sslmode=require", "postgresql://host/db?sslmode=require"),
        ("postgresql://host/db?user=me&password=secret", "postgresql://host/db?user=me"),
        ("clickhouse://me:secret@[::1]:8123/db", "clickhouse://me@[::1]:8123/db"),
    ],
)
def test_no_password_is_shown(address: str, without: str) -> None:
    assert shown(address) == without
    assert has_password(address) == (address != without)
