"""Late rows: a run writes from the first bucket on that is no longer as it is stored, and no other."""

from collections.abc import Iterator

import duckdb
import pytest

import small_plant
from gam_db.stored.monitor import Monitor
from small_plant import FIRST, LENGTH, readings, seen, source
from visible import put, rows_of

LOOKBACK = 60

#: The visible buckets without the runs that wrote them.
UNSIGNED = "SELECT * EXCLUDE (run_id) FROM gam_state_visible_bucket ORDER BY version_id, bucket_no"

pytestmark = pytest.mark.thorough


def monitor(connection: duckdb.DuckDBPyConnection) -> Monitor:
    made = small_plant.monitor(connection)
    made.lookback = LOOKBACK
    return made


@pytest.fixture
def plant() -> Iterator[duckdb.DuckDBPyConnection]:
    """A monitor that has scored all rows but the last few."""
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        monitor(connection).migrate()
        monitor(connection).calibrate()
        put(connection, readings(FIRST, LENGTH - 20))
        monitor(connection).score()
        yield connection


def last_run(connection: duckdb.DuckDBPyConnection, asset: str) -> tuple[int, int, list[int], int]:
    """Return from where on the last run of an asset wrote and made, its buckets, and the last of all."""
    run_id, first, made = connection.execute(
        "SELECT run_id, from_bucket, made_from FROM gam_state_run "
        "JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id) "
        "WHERE asset = ? ORDER BY run_id DESC LIMIT 1",
        [asset],
    ).fetchall()[0]
    numbers = connection.execute(
        "SELECT bucket_no, run_id FROM gam_state_visible_bucket "
        "JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id) "
        "WHERE asset = ? ORDER BY bucket_no",
        [asset],
    ).fetchall()
    return first, made, [number for number, by in numbers if by == run_id], numbers[-1][0]


def finished(connection: duckdb.DuckDBPyConnection) -> None:
    """Compare with the reference before the last rows come; after them with one run over all, too."""
    small_plant.as_by_reference(connection)
    assert monitor(connection).check_state().num_rows == 0
    (end,) = connection.execute("SELECT MAX(time) + 1 FROM telemetry").fetchall()[0]
    put(connection, readings(end, LENGTH))
    monitor(connection).score()
    small_plant.as_by_reference(connection)
    assert monitor(connection).check_state().num_rows == 0
    before = seen(connection)
    monitor(connection).score(full=True)
    assert seen(connection) == before


def changed(connection: duckdb.DuckDBPyConnection, asset: str, back: int, to: str) -> int:
    """Correct a reading, so many samples before the last one, and score; return its time."""
    (end,) = connection.execute("SELECT MAX(time) FROM telemetry WHERE asset = ?", [asset]).fetchall()[0]
    connection.execute(
        f"UPDATE telemetry SET value = {to} WHERE asset = ? AND time = ?", [asset, end - back]
    )
    assert monitor(connection).score().channels
    return int(end - back)


def test_buckets_before_the_first_that_changed_stay_as_they_were(
    plant: duckdb.DuckDBPyConnection,
) -> None:
    time = changed(plant, "b", 22, "1e6")
    first, made, written, last = last_run(plant, "b")
    (expected,) = plant.execute(
        "SELECT MIN(bucket_no) FROM gam_state_visible_bucket JOIN gam_state_version USING (version_id) "
        "JOIN gam_state_channel USING (channel_id) WHERE asset = 'b' AND last_time >= ?",
        [time],
    ).fetchall()[0]
    assert made < first == expected
    assert written == list(range(first, last + 1))
    finished(plant)


def test_a_run_that_finds_everything_as_it_was_hides_nothing(plant: duckdb.DuckDBPyConnection) -> None:
    """The same row again is read within the lookback; its instant is one sample still."""
    before, runs = rows_of(plant, "FROM gam_state_visible_bucket"), rows_of(plant, "FROM gam_state_run")
    plant.execute(
        "INSERT INTO telemetry FROM telemetry "
        "WHERE asset = 'b' AND time = (SELECT MAX(time) - 22 FROM telemetry WHERE asset = 'b')"
    )
    assert monitor(plant).score().channels
    assert rows_of(plant, "FROM gam_state_visible_bucket") == before
    assert rows_of(plant, "FROM gam_state_run") == runs, "there is nothing to record"
    put(plant, readings(LENGTH - 20, LENGTH - 10))
    (run,) = (row for row in monitor(plant).score().channels if row["asset"] == "b")
    assert run["rows_read"] < 3 * LOOKBACK
    finished(plant)


def test_another_cell_is_another_bucket(plant: duckdb.DuckDBPyConnection) -> None:
    """What was novel is novel still, as often and at the same time, in another cell."""
    changed(plant, "b", 22, "1e6")
    before, buckets = last_run(plant, "b")[0], rows_of(plant, UNSIGNED)
    changed(plant, "b", 22, "-1e6")
    first, _, written, last = last_run(plant, "b")
    assert rows_of(plant, UNSIGNED) == buckets
    assert (first, written) == (before, list(range(before, last + 1)))
    finished(plant)


def test_rows_that_go_take_their_buckets_along(plant: duckdb.DuckDBPyConnection) -> None:
    last = last_run(plant, "b")[3]
    plant.execute(
        "DELETE FROM telemetry WHERE asset = 'b' "
        "AND time > (SELECT MAX(time) - 12 FROM telemetry WHERE asset = 'b')"
    )
    monitor(plant).score()
    first, _, written, left = last_run(plant, "b")
    assert (written, first) == ([], left + 1)
    assert left < last
    finished(plant)


def test_who_asks_for_all_of_it_gets_all_of_it_written(plant: duckdb.DuckDBPyConnection) -> None:
    monitor(plant).score(full=True)
    first, made, written, last = last_run(plant, "b")
    assert (first, made, written) == (0, 0, list(range(last + 1)))


@pytest.mark.parametrize("end", range(201, 204))
def test_what_changes_after_the_look_and_before_the_reading_is_found(end: int) -> None:
    """It is among the samples that a run begins with, and not in the buckets that stay."""
    with duckdb.connect() as connection:
        source(connection, readings(0, FIRST))
        mine = small_plant.monitor(connection)
        mine.lookback = 6
        mine.migrate()
        mine.calibrate()
        put(connection, readings(FIRST, end))
        mine.score()
        ((last,),) = connection.execute("SELECT MAX(last_time) FROM gam_state_visible_bucket").fetchall()
        put(connection, readings(end, end + 2))
        told: list[str] = []

        def come(step: str) -> None:
            if told and told[-1] == "reading the source":
                connection.execute("UPDATE telemetry SET value = 77 WHERE time = ?", [last])
            told.append(step)

        mine.score(on_step=come)
        assert "reading the source" in told
        mine.score()
        put(connection, readings(end + 2, end + 4))
        mine.score()
        small_plant.as_by_reference(connection)
