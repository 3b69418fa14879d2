"""Spark Connect, on a server from the wheel: a session of the user, or the address of the server."""

import os
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
import sqlglot

import connect_server
import engines
import gam_db
import harness
from gam_db.address import has_password, shown, without_passwords
from gam_db.engines.session import Session
from gam_db.engines.spark import remote
from gam_db.engines.spark.driver import ConnectDriver
from gam_db.engines.spark.opening import quiet
from gam_db.errors import EngineError, SourceError, StatementError

ROOT = Path(__file__).parents[2]

#: Rooms of the tests that open Spark.
ROOMS = (
    *("alarms", "checking", "cli", "engines", "export"),
    *("method", "reading", "report", "stored", "study"),
)

#: What needs a session in this process: its folder, its files, its plans, how it is killed.
OF_CLASSIC = ("test_relatives.py", *(path.name for path in Path(__file__).parent.glob("test_spark*.py")))

PARAMETERS = gam_db.Parameters(m=2, tau=3, bins=4, window=20, stride=5)
CALIBRATION = gam_db.Calibration(intervals=[(0, 120)])
ZONE = "spark.sql.session.timeZone"


@pytest.fixture
def theirs() -> Iterator[Any]:
    """A session of a user, whose clocks show New York's time."""
    with quiet():
        from pyspark.sql.connect.session import SparkSession

        session = SparkSession.builder.remote(connect_server.server()).create()
    session.conf.set(ZONE, "America/New_York")
    session.conf.set("spark.sql.ansi.enabled", "false")
    yield session
    session.stop()


def readings(start: int, end: int) -> pa.Table:
    """Two channels that repeat a pattern, and later on less so."""
    return harness.arrow(
        [
            (asset, "x", time, float(time % (5 + number) if time % (37 - time // 10) else time % 11))
            for number, asset in enumerate("ab")
            for time in range(start, end)
        ]
    )


def passes(*words: str) -> None:
    """Run tests of Spark on the server, in a process of their own; what fails is shown."""
    around = {**os.environ, engines.WAY: "connect"}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-p",
        "no:xdist",
        "-q",
        "--engines",
        "spark",
        "-o",
        "addopts=",
    ]
    told = subprocess.run([*command, *words], cwd=ROOT, env=around, capture_output=True, text=True)
    assert told.returncode == 0, told.stdout[-5000:]


# The same tests


def test_a_fleet_of_the_specification() -> None:
    passes("tests/method/test_spec.py::test_cases", "-k", "spark-9")


@pytest.mark.full
@pytest.mark.parametrize("room", ROOMS)
def test_the_full_set(room: str) -> None:
    left_out = (f"--ignore=tests/engines/{name}" for name in OF_CLASSIC)
    passes(f"tests/{room}", "-k", "spark", *left_out)


# The user's session


def test_it_gets_back_its_settings_when_the_last_of_ours_is_closed(theirs: Any) -> None:
    theirs.createDataFrame(readings(0, 300)).createOrReplaceTempView("telemetry")
    first, second = gam_db.connect(theirs), gam_db.connect(theirs)
    first.close()
    assert theirs.conf.get(ZONE) == "UTC"
    counted = sqlglot.exp.select("COUNT(*) AS rows").from_(second.relation("telemetry"))
    assert second.fetch(counted).to_pylist() == [{"rows": 600}]
    second.close()
    assert theirs.conf.get(ZONE) == "America/New_York"
    assert theirs.conf.get("spark.sql.ansi.enabled") == "false"
    assert [row.name for row in theirs.catalog.listTables()] == ["telemetry"]


@pytest.mark.full
def test_a_state_is_kept_in_its_metastore(theirs: Any) -> None:
    schema = "plant_of_connect"
    theirs.sql(f"CREATE SCHEMA {schema}")
    theirs.sql(f"USE {schema}")
    theirs.createDataFrame(readings(0, 300)).createOrReplaceTempView("telemetry")
    with gam_db.connect(theirs) as session:
        monitor = gam_db.Monitor(session, gam_db.Source("telemetry"), PARAMETERS, CALIBRATION)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
        monitor.score(full=True)
        found = monitor.health().to_pylist()
        place = _files(theirs, "gam_state_bucket")
        assert place
        monitor.prune()
        assert monitor.health().to_pylist() == found
        assert not any(Path(file).exists() for file in place)
        assert all(Path(file).exists() for file in _files(theirs, "gam_state_bucket"))
    with gam_db.connect() as duck:
        once = gam_db.Monitor(duck, gam_db.Source(readings(0, 300)), PARAMETERS, CALIBRATION)
        once.migrate()
        once.calibrate()
        once.score()
        assert once.health().to_pylist() == found
    names = {row.name for row in theirs.catalog.listTables()}
    assert not [name for name in names if name.startswith("gam_step") or name.endswith("_replaced")]


def _files(session: Any, table: str) -> list[str]:
    return [file.removeprefix("file:") for file in session.table(table).inputFiles()]


@pytest.mark.parametrize("why", ["another session is the active one", "the session has no checkpoints"])
def test_steps_are_tables_where_no_checkpoint_can_be_read(
    why: str, theirs: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The text of the second error is what Databricks says on serverless computing; it did not run."""
    from pyspark.errors import PySparkException
    from pyspark.sql.connect.dataframe import DataFrame

    def refused(*_: object) -> None:
        raise PySparkException("[NOT_SUPPORTED_WITH_SERVERLESS] PERSIST TABLE is not supported.")

    monkeypatch.setattr("gam_db.engines.spark.driver._SMALL", 0)
    monkeypatch.setattr("gam_db.engines.spark.driver._FEW", 0)
    monkeypatch.setattr(remote, "keeps_checkpoints", lambda _: why.startswith("the session"))
    monkeypatch.setattr(DataFrame, "localCheckpoint", refused)
    with gam_db.connect(theirs) as session:
        assert isinstance(session, Session)
        kept = session.keep("odd", sqlglot.parse_one("SELECT 7 AS n", into=sqlglot.exp.Select))
        names = [row.name for row in theirs.catalog.listTables()]
        assert [name for name in names if name.startswith("gam_step_")]
        assert session.fetch(sqlglot.exp.select("n").from_(kept)).to_pylist() == [{"n": 7}]
    assert not [row for row in theirs.catalog.listTables() if row.name.startswith("gam_step_")]


def test_steps_are_computed_once(theirs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gam_db.engines.spark.driver._SMALL", 0)
    monkeypatch.setattr("gam_db.engines.spark.driver._FEW", 0)
    with gam_db.connect(connect_server.server()) as session:
        assert isinstance(session, Session)
        assert isinstance(session.driver, ConnectDriver)
        kept = session.keep("random", sqlglot.parse_one("SELECT RAND() AS n", into=sqlglot.exp.Select))
        query = sqlglot.exp.select("n").from_(kept)
        assert session.fetch(query) == session.fetch(query)


def test_a_setting_that_is_needed_and_refused(theirs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from pyspark.errors import PySparkException
    from pyspark.sql.connect.conf import RuntimeConf

    def refused(_: object, name: str, said: str) -> None:
        raise PySparkException(f"[CONFIG_NOT_AVAILABLE] Configuration {name} is not available.")

    monkeypatch.setattr(RuntimeConf, "set", refused)
    with pytest.raises(EngineError, match=r"does not let spark.sql.session.timeZone be UTC"):
        gam_db.connect(theirs)


def test_a_stopped_session_is_refused(theirs: Any) -> None:
    theirs.stop()
    with pytest.raises(EngineError, match="is stopped"):
        gam_db.connect(theirs)


@pytest.mark.parametrize(
    ("condition", "message"),
    [
        ("CAST(asset AS BIGINT) = 7", "cannot be read as the type that its column needs"),
        ("no_such_column > 7", "which Spark refuses"),
    ],
)
def test_what_spark_refuses_is_said_as_of_a_session_in_this_process(
    condition: str, message: str, theirs: Any
) -> None:
    with pytest.raises((SourceError, StatementError), match=message) as caught:
        gam_db.support(gam_db.Source(readings(0, 60), where=condition), PARAMETERS, engine=theirs)
    assert "JVM stacktrace" not in str(caught.value)


# The address


def test_the_address_of_no_server() -> None:
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    with pytest.raises(EngineError, match=f"No Spark Connect server answers at 127.0.0.1:{port} "):
        gam_db.connect(f"sc://127.0.0.1:{port}")


@pytest.mark.parametrize(
    ("rest", "message"),
    [
        ("", "is not an address of a Spark Connect server"),
        ("me@HOST", "is not an address of a Spark Connect server"),
        ("HOST/a/folder", "cannot be opened: .*must be empty"),
        ("HOST/;token=se@cret;odd", "cannot be opened: .*key-value pair"),
        ("HOST/;session_id=7;token=se@cret", "cannot be opened"),
    ],
)
def test_an_address_that_cannot_be_used(rest: str, message: str) -> None:
    address = f"sc://{rest}".replace("HOST", connect_server.server().removeprefix("sc://"))
    with pytest.raises(EngineError, match=message) as caught:
        gam_db.connect(address)
    assert "cret" not in str(caught.value)


def test_the_token_is_not_shown() -> None:
    address = "sc://host:443/;use_ssl=true;token=dapi@7:x;x-databricks-cluster-id=1"
    assert shown(address) == "sc://host:443/;use_ssl=true;x-databricks-cluster-id=1"
    assert has_password(address)
    assert "dapi" not in without_passwords(f"no {address} here")
    assert not has_password("sc://host:443/;use_ssl=true")
