"""ClickHouse from afar and in a folder: addresses, sessions, and what is said when it cannot be used.

A server is stood in for by :mod:`clickhouse_server`, which answers over HTTP with chdb behind it.
"""

import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from urllib.parse import quote

import clickhouse_connect
import pyarrow as pa
import pytest
import sqlglot
from sqlglot import exp

import engines
import gam_db
import harness
import small_plant
from clickhouse_server import PASSWORD, USER, Server
from gam_db.engines.clickhouse.driver import folder
from gam_db.errors import EngineError, UserError
from gam_db.stored.monitor import Monitor
from scripts import arrive
from small_plant import FIRST, LENGTH, readings
from visible import BUCKETS, NOVEL, visible


@pytest.fixture
def server() -> Iterator[Server]:
    with Server() as started:
        yield started


def address(server: Server, password: str = PASSWORD, query: str = "") -> str:
    return f"clickhouse://{USER}:{quote(password, safe='')}@{server.place}/default{query}"


def test_a_server_is_asked_over_http(server: Server, monkeypatch: pytest.MonkeyPatch) -> None:
    rows = readings(0, FIRST)
    monkeypatch.setenv("CLICKHOUSE_USER", USER)
    monkeypatch.setenv("CLICKHOUSE_PASSWORD", PASSWORD)
    with gam_db.connect(f"clickhouse://{server.place}") as session:
        table = engines.fresh_name("telemetry")
        with session.lent(harness.arrow(rows)) as lent:
            columns = exp.select("asset", "channel", "time", "value").from_(lent)
            session.execute(session.engine.create_table(exp.to_table(table), columns))
        monitor = Monitor(
            session,
            gam_db.Source(table),
            gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5),
            gam_db.Calibration(fraction=0.7),
            prefix=engines.fresh_name("state"),
            lookback=small_plant.LOOKBACK,
        )
        monitor.migrate()
        monitor.calibrate()
        arrive(session, exp.to_table(table), readings(FIRST, LENGTH))
        monitor.score()
        monitor.prune()
        assert [visible(monitor, BUCKETS), visible(monitor, NOVEL)] == small_plant.whole()


def test_a_client_without_a_session_is_given_one(server: Server) -> None:
    host, _, port = server.place.partition(":")
    client = clickhouse_connect.get_client(
        host=host, port=int(port), username=USER, password=PASSWORD, autogenerate_session_id=False
    )
    with gam_db.connect(client) as session, session.lent(pa.table({"a": [1, 2]})) as lent:
        assert session.fetch(exp.select("a").from_(lent)).num_rows == 2
    assert client.get_client_setting("session_id") is None
    assert client.command("SELECT 1") == 1
    client.close()


def test_servers_behind_a_load_balancer_are_told_apart() -> None:
    refused = pytest.raises(EngineError, match="each session_id to the same server")
    with Server(replicas=2) as server, gam_db.connect(address(server)) as session, refused:
        session.load(pa.table({"a": [1]}))


def test_a_line_that_is_lost(server: Server) -> None:
    with gam_db.connect(address(server)) as session:
        server.is_lost = True
        with pytest.raises(EngineError, match="was lost or refused") as refused:
            session.fetch(sqlglot.parse_one("SELECT 1 AS a"))
        assert PASSWORD not in str(refused.value)


@pytest.mark.parametrize(
    ("refusal", "said"),
    [
        (
            "Code: 497. DB::Exception: plant: Not enough privileges. To execute this query, it's "
            "necessary to have the grant CREATE TEMPORARY TABLE ON *.*. (ACCESS_DENIED)",
            r"GRANT CREATE TEMPORARY TABLE ON \*\.\* TO the user",
        ),
        (
            "Code: 243. DB::Exception: Cannot reserve 1.00 MiB (NOT_ENOUGH_SPACE)",
            "disk of ClickHouse is full",
        ),
        (
            "Code: 1001. DB::Exception: write: No space left on device (STD_EXCEPTION)",
            "disk of ClickHouse is full",
        ),
        ("Code: 241. DB::Exception: Memory limit exceeded (MEMORY_LIMIT_EXCEEDED)", "max_memory_usage"),
        ("Code: 159. DB::Exception: Timeout exceeded (TIMEOUT_EXCEEDED)", "TIMEOUT_EXCEEDED"),
        ("Code: 164. DB::Exception: Cannot execute query in readonly mode (READONLY)", "readonly = 0"),
        (
            ("Code: 81. DB::Exception: Database nowhere does not exist (UNKNOWN_DATABASE)"),
            "does not exist; create it",
        ),
    ],
)
def test_what_a_user_can_do(server: Server, refusal: str, said: str) -> None:
    with gam_db.connect(address(server)) as session:
        server.refusal = refusal
        with pytest.raises(EngineError, match=said):
            session.fetch(sqlglot.parse_one("SELECT 1 AS a"))
        server.refusal = None


@pytest.mark.parametrize(
    ("target", "said"),
    [
        ("clickhouse://plant:wrong-word@{0}/default", "refuses the user or the password"),
        ("clickhouse://127.0.0.1:9/default", "lost or refused"),
        ("clickhouse://127.0.0.1:port/default", "the port is not a number"),
        ("clickhouse://{0}/default?passwort=1", "parameter 'passwort'"),
        ("chdb://plant", "three slashes"),
        ("chdb:///no/such/folder/here", "There is no folder"),
    ],
)
def test_addresses_that_lead_nowhere(server: Server, target: str, said: str) -> None:
    with pytest.raises(EngineError, match=said) as refused:
        gam_db.connect(target.format(server.place))
    assert "wrong-word" not in str(refused.value)


def test_a_server_that_is_too_old() -> None:
    with (
        Server(version="24.8.1.1") as server,
        pytest.raises(EngineError, match=r"24\.8\.1\.1, which is too"),
    ):
        gam_db.connect(address(server))


def test_an_open_connection_of_another_kind() -> None:
    with pytest.raises(EngineError, match="accepts the client"):
        gam_db.connect(clickhouse_connect.driver.exceptions.Error())


def test_a_folder_begins_here_or_at_the_root(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert folder("chdb:///plant", writable=True)["path"] == "plant"
    assert folder(f"chdb:///{tmp_path / 'chdb'}", writable=True)["path"] == str(tmp_path / "chdb")
    with pytest.raises(EngineError, match=str(tmp_path / "plant")):
        folder("chdb:///plant", writable=False)


def test_a_folder_is_open_in_one_process_only(tmp_path: Path) -> None:
    """Two processes of their own: the one of the tests may have another folder open."""
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "file").touch()
    script = tmp_path / "open.py"
    script.write_text(
        "import subprocess, sys, gam_db\n"
        "from gam_db.errors import EngineError\n"
        "try:\n"
        "    with gam_db.connect(sys.argv[1]) as session:\n"
        "        if len(sys.argv) > 2:\n"
        "            sys.exit(subprocess.call([sys.executable, sys.argv[0], sys.argv[2]]))\n"
        "except EngineError as error:\n"
        "    sys.exit(str(error))\n"
    )
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}

    def said(*targets: str) -> str:
        command = [sys.executable, str(script), *targets]
        return subprocess.run(command, env=environment, capture_output=True, text=True).stderr

    plant = f"chdb:///{tmp_path / 'plant'}"
    assert said(plant) == ""
    assert "is open in another process" in said(plant, plant)
    assert "is not a folder of chdb" in said(f"chdb:///{tmp_path / 'other'}")


@pytest.mark.parametrize("library", ["clickhouse_connect", "chdb"])
def test_a_library_that_is_not_installed(monkeypatch: pytest.MonkeyPatch, library: str) -> None:
    monkeypatch.setitem(sys.modules, library, None)
    with pytest.raises(UserError, match=rf'This needs {library}: pip install "gam-db\[clickhouse\]"'):
        gam_db.connect("chdb://")
