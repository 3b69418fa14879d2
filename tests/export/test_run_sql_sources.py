"""Runs with no Python over other sources: wide, in local time, of one channel, with programs."""

from collections.abc import Callable, Iterator
from typing import Any

import duckdb
import pytest

import gam_db
import harness
import test_program_histories as of_programs
import test_run_sql as runs
from batches import History, history
from gam_db.engines.duckdb.session import DuckSession
from gam_db.export.monitor import rendered
from gam_db.settings.source import AnySource
from gam_db.stored.monitor import Monitor

pytestmark = pytest.mark.full

#: Seconds of each arrival; the first is there at the time of calibration, and the third is late.
ARRIVALS = ((1500, 1700), (1650, 1660), (1700, 2100), (2100, 2101))

#: Clocks go back within it.
AUTUMN = "TIMESTAMP '2025-10-26 01:50:00'"

SOURCES: dict[str, AnySource] = {
    "wide": gam_db.WideSource("plant", ["temp", "flow"], "machine", "at", where="temp > -2"),
    "local time": gam_db.WideSource(
        *("plant", ["temp", "flow"], "machine", "at"),
        source_time_zone="Europe/Berlin",
        valid_when="quality < 4",
    ),
    "one channel": gam_db.Source("plant", None, None, "at", "temp"),
}


def rows(start: int, end: int) -> str:
    return (
        f"SELECT 'm1' AS machine, {AUTUMN} + INTERVAL 1 SECOND * i AS at, sin(i / 7.0) AS temp, "
        f"CAST(i * i % 13 AS DOUBLE) AS flow, i % 5 AS quality FROM range({start}, {end}) AS t(i)"
    )


def alike(play: Callable[[bool], Iterator[runs.Stored]]) -> None:
    for number, (score, script) in enumerate(zip(play(False), play(True), strict=True)):
        runs.assert_same(score, script, f"after batch {number}")


def execute(connection: duckdb.DuckDBPyConnection, script: str) -> None:
    with connection.cursor() as another:
        another.execute(script)


@pytest.mark.parametrize("form", SOURCES)
def test_another_form_of_source(form: str) -> None:
    def play(is_script: bool) -> Iterator[runs.Stored]:
        with duckdb.connect() as connection:
            connection.execute(f"CREATE TABLE plant AS {rows(0, 1500)}")
            method = gam_db.Parameters(m=2, tau=2, bins=6, window=60, stride=10)
            given = SOURCES[form], method, gam_db.Calibration(fraction=0.6)
            monitor = Monitor(DuckSession(connection), *given, lookback="60 s")
            monitor.migrate()
            monitor.calibrate()
            script = rendered(monitor)
            for arrival in ARRIVALS:
                connection.execute(f"INSERT INTO plant {rows(*arrival)}")
                if is_script:
                    execute(connection, script)
                else:
                    monitor.score()
                yield runs.stored(monitor)
            assert runs.stored(monitor)["judgement"]

    alike(play)


@pytest.mark.parametrize(("kind", "seed"), [("short form", 1), ("still samples", 1), ("given start", 2)])
def test_states_of_programs(kind: str, seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    programs = "version_id, bucket_no, run_id, program, readings, first_time, last_time"
    monkeypatch.setitem(runs.TABLES, "unknown_program", programs)
    monkeypatch.setitem(runs.TABLES, "bucket", f"{runs.TABLES['bucket']}, unknown_program")
    told = history(kind, seed, 16)
    told.parameters["bins"] = min(told.parameters["bins"], 6)
    alike(lambda is_script: of_program(told, is_script))


def of_program(told: History, is_script: bool) -> Iterator[runs.Stored]:
    with duckdb.connect() as connection:
        connection.execute(
            "CREATE TABLE telemetry "
            "(asset VARCHAR, channel VARCHAR, time BIGINT, value DOUBLE, product VARCHAR)"
        )
        of_programs.put(connection, told.first)
        reach: dict[str, Any] = {"lookback": told.lookback, "park_after": told.park_after}
        method = harness.made(told.parameters, told.calibration)
        monitor = Monitor(DuckSession(connection), of_programs.SOURCE, *method, **reach)
        monitor.migrate()
        monitor.calibrate()
        script = rendered(monitor)
        for batch in told.batches:
            if batch.rows:
                of_programs.put(connection, batch.rows)
            if is_script and batch is not told.batches[-1]:
                execute(connection, script)
            else:
                monitor.score()
            yield runs.stored(monitor)
