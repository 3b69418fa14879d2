"""A source that is said to grow only: what was read is counted, and read again where that differs.

That any history ends in the tables of one full run, late rows included, is shown with the others
(test_incremental, test_stored_on_engines, test_mixed_histories): half of them say so of their source.
"""

from collections.abc import Iterator
from typing import Any

import duckdb
import pytest

import gam_db
import small_plant
from gam_db.stored import scoring
from gam_db.stored.monitor import Monitor
from gam_db.stored.scoring.growing import unmoved
from gam_db.stored.scoring.report import Report
from small_plant import FIRST, LENGTH, readings, seen, source
from strategies import Row
from visible import BUCKETS, put, rows_of

LOOKBACK, STRIDE, CONTEXT = 40, 5, 3

pytestmark = pytest.mark.thorough

#: Rows of each channel that come from run to run.
STEP = 20


def monitor(connection: Any, append_only: bool = True) -> Monitor:
    made = small_plant.monitor(connection)
    made.lookback, made.append_only = LOOKBACK, append_only
    return made


@pytest.fixture
def plant() -> Iterator[duckdb.DuckDBPyConnection]:
    """A monitor that was scored twice since it was calibrated."""
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        monitor(connection).calibrate()
        for start in (FIRST, FIRST + STEP):
            put(connection, readings(start, start + STEP))
            monitor(connection).score()
        yield connection


def grown(connection: duckdb.DuckDBPyConnection, append_only: bool = True) -> Report:
    """Let a step of rows come, and score."""
    (end,) = connection.execute("SELECT MAX(time) + 1 FROM telemetry").fetchall()[0]
    put(connection, readings(end, end + STEP))
    return monitor(connection, append_only).score()


def finished(connection: duckdb.DuckDBPyConnection) -> None:
    """Let all rows come, and compare with one run over everything."""
    (end,) = connection.execute("SELECT MAX(time) + 1 FROM telemetry").fetchall()[0]
    put(connection, readings(end, LENGTH))
    monitor(connection).score()
    assert seen(connection) == small_plant.whole()
    small_plant.as_by_reference(connection)
    assert monitor(connection).check_state().num_rows == 0


def test_what_was_read_is_not_read_again(plant: duckdb.DuckDBPyConnection) -> None:
    run = grown(plant)
    assert run.moved == 0
    assert {row["rows_read"] > STEP + STRIDE + CONTEXT + 1 for row in run.channels} == {False}
    whole = grown(plant, append_only=False)
    assert {row["rows_read"] > LOOKBACK for row in whole.channels} == {True}, "other sums than counts"
    finished(plant)


def test_a_channel_with_a_late_row_is_read_as_others_are(plant: duckdb.DuckDBPyConnection) -> None:
    (end,) = plant.execute("SELECT MAX(time) FROM telemetry").fetchall()[0]
    late = f"asset = 'b' AND time = {end + 5}"
    grown(plant)
    plant.execute(f"CREATE TABLE kept AS FROM telemetry WHERE {late}")
    plant.execute(f"DELETE FROM telemetry WHERE {late}")
    gone = grown(plant)
    plant.execute("INSERT INTO telemetry FROM kept")
    back = monitor(plant).score()
    for run in (gone, back):
        assert run.moved == 1
        assert {row["asset"] for row in run.channels if row["rows_read"] > LOOKBACK} == {"b"}
    assert grown(plant).moved == 0
    finished(plant)


def test_a_wrong_declaration_is_found_by_a_check(plant: duckdb.DuckDBPyConnection) -> None:
    """A row went while another came: the count says nothing."""
    grown(plant)
    (end,) = plant.execute("SELECT MAX(time) FROM telemetry").fetchall()[0]
    plant.execute(f"UPDATE telemetry SET value = 77 WHERE asset = 'c' AND time = {end - 15}")
    assert grown(plant).moved == 0
    grown(plant)
    found = monitor(plant).check_state().to_pylist()
    assert {(row["asset"], row["part"]) for row in found} == {("c", "scored")}
    monitor(plant).score(since=found[0]["since"])
    assert monitor(plant).check_state().num_rows == 0
    grown(plant)
    assert monitor(plant).check_state().num_rows == 0


@pytest.mark.parametrize(
    "lost",
    [
        "DELETE FROM gam_run WHERE version_id = 2 AND read_to < {end}",
        "UPDATE gam_run SET summed_from = read_to WHERE version_id = 2 AND read_to = {end}",
        "UPDATE gam_run SET read_sum = read_sum + 1 WHERE version_id = 2 AND read_to = {end}",
        "UPDATE gam_run SET read_sum = NULL WHERE version_id = 2",
    ],
)
def test_where_it_is_not_known_what_was_read_all_is_read(
    plant: duckdb.DuckDBPyConnection, lost: str
) -> None:
    """Records went, leave a hole, or say something else."""
    grown(plant)
    (end,) = plant.execute("SELECT MAX(time) FROM telemetry").fetchall()[0]
    if "DELETE" in lost:  # of runs of which no row is left
        plant.execute(
            "UPDATE gam_bucket SET run_id = (SELECT MAX(run_id) FROM gam_run WHERE version_id = 2) "
            "WHERE version_id = 2"
        )
        plant.execute("UPDATE gam_run SET from_bucket = 0 WHERE version_id = 2")
    plant.execute(lost.format(end=end))
    assert grown(plant).moved == 1


def test_a_lookback_that_grew_is_known_since_the_beginning(plant: duckdb.DuckDBPyConnection) -> None:
    grown(plant)
    longer = monitor(plant)
    longer.lookback = 2 * LOOKBACK
    assert longer.score().moved == 0
    finished(plant)


def test_what_was_all_read_needs_nothing_before_it(plant: duckdb.DuckDBPyConnection) -> None:
    longer = monitor(plant)
    longer.lookback = 2 * LENGTH
    longer.score(full=True)
    put(plant, readings(FIRST + 2 * STEP, LENGTH))
    run = longer.score()
    assert run.moved == 0
    assert {row["rows_read"] < LENGTH - FIRST for row in run.channels} == {True}
    finished(plant)


def test_so_it_is_without_a_word_and_a_changed_value_is_seen(plant: duckdb.DuckDBPyConnection) -> None:
    """The sum is of times and codes: another value of the same bin changes nothing."""
    monitor(plant, append_only=False).score(full=True)
    run = grown(plant, append_only=False)
    assert {row["rows_read"] > STEP + STRIDE + CONTEXT + 1 for row in run.channels} == {False}
    (end,) = plant.execute("SELECT MAX(time) FROM telemetry").fetchall()[0]
    plant.execute(f"UPDATE telemetry SET value = 77 WHERE asset = 'c' AND time = {end - 15}")
    run = grown(plant, append_only=False)
    assert run.moved == 0, "that late rows come is no news"
    assert {row["asset"] for row in run.channels if row["rows_read"] > LOOKBACK} == {"c"}
    grown(plant, append_only=False)
    plant.execute(f"UPDATE telemetry SET value = 78 WHERE asset = 'c' AND time = {end - 15}")
    run = grown(plant, append_only=False)
    assert {row["rows_read"] > STEP + STRIDE + CONTEXT + 1 for row in run.channels} == {False}
    assert monitor(plant, append_only=False).check_state().num_rows == 0


def test_a_row_that_comes_while_a_run_is_at_work_is_not_lost(
    plant: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It comes after what was read was added up, with rows that are as new as it may be late."""
    (end,) = plant.execute("SELECT MAX(time) + 1 FROM telemetry").fetchall()[0]
    first = readings(end, end + 2 * STEP)
    late = [row for row in first if row[0] == "b" and row[2] == end + 5]
    put(plant, [row for row in first if row not in late and row[2] < end + STEP])
    monitor(plant, append_only=False).score(full=True)
    put(plant, [row for row in first if row[2] >= end + STEP])

    def meanwhile(*asked: Any) -> Any:
        found = unmoved(*asked)
        put(plant, [*late, *readings(end + 2 * STEP, end + 4 * STEP)])
        monkeypatch.undo()
        return found

    monkeypatch.setattr(scoring, "unmoved", meanwhile)
    run = monitor(plant, append_only=False).score()
    assert {row["read_to"] for row in run.channels} == {end + 2 * STEP - 1}
    monitor(plant, append_only=False).score()
    assert monitor(plant, append_only=False).check_state().num_rows == 0
    finished(plant)


@pytest.mark.parametrize("between", [{"full": True}, {"since": 50}, {"until": 69}, {}])
def test_what_a_run_without_a_sum_read_is_read_again(between: dict[str, Any]) -> None:
    """A run that is not told that the source grows keeps none where samples stand still."""
    rows: list[Row] = [("a", "x", time, float(time % 3)) for time in range(70)]
    method = (
        gam_db.Parameters(m=1, bins=4, window=4, stride=2, still_after=5),
        gam_db.Calibration(fraction=0.5),
    )
    with duckdb.connect() as connection:

        def grows(append_only: bool) -> gam_db.Monitor:
            asked = gam_db.Source("telemetry"), *method
            return gam_db.Monitor(connection, *asked, lookback=20, append_only=append_only)

        source(connection, rows[:60])
        grows(True).migrate()
        grows(True).calibrate()
        grows(True).score()
        put(connection, [row for row in rows[60:] if row[2] != 62])
        grows(False).score(**between)
        put(connection, [rows[62]])
        grows(True).score()
        stored = rows_of(connection, BUCKETS)
        grows(True).score(full=True)
        assert rows_of(connection, BUCKETS) == stored
