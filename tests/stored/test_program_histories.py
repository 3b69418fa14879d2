"""States of programs: whatever the batches, what is stored equals one full run."""

import contextlib
from collections.abc import Iterator
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from sqlglot import exp

import engines
import gam_db
import harness
import scripts
from batches import KINDS, history
from gam_db.composing import template
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.tables import TABLES
from state_names import called
from strategies import Row
from test_stored_on_engines import play
from visible import BUCKETS, NOVEL, STILL, CrashError, crashing, rows_of, visible

SOURCE = gam_db.Source("telemetry", program="product")

#: Channels of a history, and histories of each kind beyond the first.
CHANNELS, MORE = 16, 5

UNKNOWN = """
    SELECT asset, channel, bucket_no AS bucket, program, readings, first_time, last_time
    FROM gam_state_visible_program JOIN gam_state_version USING (version_id)
    JOIN gam_state_channel USING (channel_id)
"""
COUNTS = """
    SELECT asset, channel, bucket_no AS bucket, unknown_program
    FROM (SELECT version_id, bucket_no, run_id FROM gam_state_visible_bucket) AS seen
    JOIN gam_state_bucket USING (version_id, bucket_no, run_id)
    JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id)
"""
PROGRAMS = """
    SELECT asset, channel, program, program_no, vectors, unvouched, verdict
    FROM gam_program JOIN gam_state_version USING (support_id) JOIN gam_state_channel USING (channel_id)
"""
CELLS = """
    SELECT asset, channel, kind, cell_key, axis, code, program_no, program, visits
    FROM gam_cell
"""


QUERIES = (BUCKETS, NOVEL, UNKNOWN, COUNTS, PROGRAMS, CELLS, STILL)


def program_of(row: Row) -> str | None:
    """Return what a machine ran at a row: shifts of ten; two rows of one instant may contradict."""
    asset, _, time, value = row
    shift = (time // 10 + len(asset)) % 6
    if value is not None and abs(hash((time, value))) % 11 == 0:
        return "b2"
    return ("a", "b", "a", None, "c", "b")[shift] if time < 45 else ("a", "new", "b")[shift % 3]


def put(connection: duckdb.DuckDBPyConnection, rows: list[Row]) -> None:
    """Let rows arrive."""
    programs = pa.array([program_of(row) for row in rows], pa.string())
    connection.register("arriving", harness.arrow(rows).append_column("product", programs))
    connection.execute("INSERT INTO telemetry SELECT * FROM arriving").fetchall()
    connection.unregister("arriving")


@pytest.fixture(scope="module")
def connection() -> Iterator[duckdb.DuckDBPyConnection]:
    """A database for all histories; each begins from an empty one."""
    with duckdb.connect() as connection:
        connection.execute("SET threads = 1")
        connection.execute(
            "CREATE TABLE telemetry "
            "(asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE, product VARCHAR)"
        )
        with Monitor(connection, SOURCE) as monitor:
            monitor.migrate()
        yield connection


def empty(connection: duckdb.DuckDBPyConnection) -> None:
    """Take back all that a history has left."""
    for table in ("telemetry", *(called(table) for table in TABLES if table != "migration")):
        connection.execute(f"TRUNCATE {table}")


@pytest.mark.parametrize("seed", [0, *(pytest.param(n, marks=pytest.mark.full) for n in range(1, MORE))])
@pytest.mark.parametrize("kind", KINDS)
def test_any_history_ends_in_the_tables_of_one_full_run(
    connection: duckdb.DuckDBPyConnection, kind: str, seed: int
) -> None:
    drawn = history(kind, 1000 + seed, CHANNELS)
    bins = min(drawn.parameters["bins"], 6)
    settings = drawn.parameters | {"bins": bins, "least_vectors": 3, "target_floor": 0.6}
    parameters, calibration = harness.made(settings, drawn.calibration)
    reach: dict[str, Any] = {"lookback": drawn.lookback, "park_after": drawn.park_after}

    empty(connection)
    with Monitor(connection, SOURCE, parameters, calibration, **reach) as monitor:
        put(connection, drawn.first)
        monitor.calibrate(limit=drawn.limit)
        for batch in drawn.batches:
            put(connection, batch.rows)
            for what, number in batch.runs:
                options: dict[str, Any] = {"limit": drawn.limit}
                if what in ("full", "everything"):
                    options[what] = True
                if what == "crash":
                    with contextlib.suppress(CrashError):
                        monitor.score(on_step=crashing(number), **options)
                else:
                    monitor.score(**options)
        # Rows that came into calibration afterwards are told of, and change nothing.
        differences = [row for row in monitor.check_state().to_pylist() if row["part"] != "calibration"]
        found = [in_order(rows_of(connection, query)) for query in QUERIES]
    assert differences == []

    empty(connection)
    with Monitor(connection, SOURCE, parameters, calibration, **reach) as monitor:
        put(connection, drawn.first)
        monitor.calibrate()
        empty_of_rows(connection)
        put(connection, drawn.final)
        monitor.score(full=True)
        expected = [in_order(rows_of(connection, query)) for query in QUERIES]
    for query, left, right in zip(QUERIES, expected, found, strict=True):
        harness.assert_same(left, right, query)
    assert expected[4], "calibration holds no program"


def in_order(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Return rows in an order that all engines have."""
    return sorted(rows, key=lambda row: [(value is not None, value) for value in row.values()])


@pytest.mark.parametrize("kind", ["pauses", *(pytest.param(n, marks=pytest.mark.full) for n in KINDS)])
def test_every_engine_stores_the_same(engine: str, kind: str) -> None:
    answers = [stored_on(name, kind) for name in ("duckdb", engine)]
    for query, left, right in zip(QUERIES, *answers, strict=True):
        harness.assert_same(left, right, query)
    assert answers[0][2], "no program is unknown"
    assert answers[0][4], "calibration holds no program"


def stored_on(engine: str, kind: str) -> list[list[dict[str, Any]]]:
    """Return what an engine stores of a history, of a view that says what machines run."""
    drawn = history(kind, 2007, 4)
    settings = drawn.parameters | {"bins": 4, "least_vectors": 3, "target_floor": 0.6}
    parameters, calibration = harness.made(settings, {"fraction": 0.6})
    session = engines.session(engine)
    table, name = scripts.telemetry(session, drawn.first), engines.fresh_name("programs")
    time = exp.column("time")
    shifts = {"b": time.between(12, 19), "a": time <= 33, "new": time.between(37, 43)}
    program = exp.Case(ifs=[exp.If(this=when, true=template.text(of)) for of, when in shifts.items()])
    program.set("default", exp.case().when(time >= 55, exp.null()).else_("'b'"))
    rows = exp.select("asset", "channel", "time", "value", program.as_("product")).from_(table.copy())
    session.execute(exp.Create(this=exp.to_table(name), kind="VIEW", expression=rows))
    reach: dict[str, Any] = {"lookback": drawn.lookback, "prefix": engines.fresh_name("state")}
    source = gam_db.Source(name, program="product")
    monitor = Monitor(session, source, parameters, calibration, **reach)
    play(session, table, monitor, drawn)
    monitor.prune()
    assert set(monitor.check_state()["part"].to_pylist()) <= {"calibration"}
    return [in_order(visible(monitor, query)) for query in QUERIES]


def empty_of_rows(connection: duckdb.DuckDBPyConnection) -> None:
    """Take back the rows of the source alone."""
    connection.execute("TRUNCATE telemetry")
