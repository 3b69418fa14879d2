"""Scoring channels that take turns: the integers of the reference, by rounds or by the steps that sort.

Which of the two it was is asked for in each case, so that no case passes by the other way.
"""

import random
from collections.abc import Callable, Iterator
from typing import Any

import duckdb
import pytest

from as_stored import METHODS, RUNS, compare, monitor, scored, twice_calibrated
from gam_db import study
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.planning import steps
from gam_db.stored.scoring import turning
from gam_db.study import naming, rounds
from gam_db.study import turning as in_turn
from gam_db.study.running import UNSORTED
from small_plant import source
from strategies import Row
from visible import put, rows_of

pytestmark = pytest.mark.thorough

LENGTH, STEP = 200, 2
NAMES = [("b", "x"), ("a", "y"), ("a", "x"), ("c", "x")]  # the order of their turns


def taking_turns(start: int = 0, length: int = LENGTH) -> list[Row]:
    """Channels that repeat a pattern, and later on less so: one row of each per instant."""
    return [
        (*name, STEP * time, float(time % (5 + place) if time % 17 else 40 + time % 9))
        for time in range(start, start + length)
        for place, name in enumerate(NAMES)
    ]


@pytest.fixture
def ways(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether channels were read by rounds, run by run; short ones may be, too, and are cut."""
    found: list[bool] = []
    given = turning.is_given

    def noted(*asked: Any) -> bool:
        found.append(given(*asked))
        return found[-1]

    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(rounds, "GLANCE", 20)
    monkeypatch.setattr(rounds, "PIECE", 50)
    monkeypatch.setattr(turning, "is_given", noted)
    return found


@pytest.fixture(params=[1, 3])
def connection(request: pytest.FixtureRequest) -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect() as connection:
        connection.execute("SET threads = ?", [request.param])
        yield connection


@pytest.mark.parametrize("pool", ["channel", None])
def test_a_support_need_not_have_the_number_of_its_channel(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], pool: str | None
) -> None:
    twice_calibrated(connection, taking_turns(), pool)
    assert ways == [True, True]


@pytest.mark.parametrize("case", METHODS)
def test_channels_that_take_turns_are_scored_by_rounds(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], case: str
) -> None:
    """What runs record is the same as where all is sorted; and later runs go on so."""
    made = scored(connection, taking_turns(), case)
    assert ways == [True]
    with duckdb.connect() as other:
        rows = taking_turns()
        source(other, random.Random(3).sample(rows, len(rows)))
        sorting = monitor(other, METHODS[case])
        sorting.migrate()
        sorting.calibrate()
        sorting.score()
        assert ways == [True, False]
        assert rows_of(connection, RUNS) == rows_of(other, RUNS)
    assert made.check_state().num_rows == 0
    rows = taking_turns()
    for start, length in ((LENGTH, 3), (LENGTH + 3, 40)):
        more = taking_turns(start, length)
        put(connection, more)
        rows = [*rows, *more]
        made.score()
        compare(connection, rows, METHODS[case], taking_turns())
    # With one coordinate a later run begins with a sample that is no vector's context.
    assert ways[2:] == [case != "one coordinate"] * 2
    assert made.check_state().num_rows == 0


def lacking(rows: list[Row]) -> list[Row]:
    """One reading is missing."""
    return [(*row[:3], None) if place == 500 else row for place, row in enumerate(rows)]


def fewer(rows: list[Row]) -> list[Row]:
    """One row is not there."""
    return [*rows[:500], *rows[501:]]


def swapped(rows: list[Row]) -> list[Row]:
    """Two channels have each other's turn once, long after calibration."""
    return [*rows[:500], rows[501], rows[500], *rows[502:]]


def earlier(rows: list[Row]) -> list[Row]:
    """One round lies before the one that it follows."""
    return [*rows[:500], *rows[504:508], *rows[500:504], *rows[508:]]


def twice(rows: list[Row]) -> list[Row]:
    """One round comes again."""
    again = [(*row[:3], -3.0) for row in rows[500:504]]
    return [*rows[:504], *again, *rows[504:]]


def longer(rows: list[Row]) -> list[Row]:
    """One channel goes on for a while."""
    return [*rows, ("b", "x", STEP * LENGTH, 1.0)]


@pytest.mark.parametrize("changed", [lacking, fewer, swapped, earlier, twice, longer])
def test_others_are_left_to_the_steps_that_sort(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], changed: Callable[[list[Row]], list[Row]]
) -> None:
    scored(connection, changed(taking_turns()), "delays")
    assert ways == [False]


def test_rows_that_come_meanwhile_are_noticed(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """One of before the end is there when rows are counted again: then all is copied and sorted."""
    late: Row = ("a", "x", STEP * 150 + 1, 99.0)
    begun = steps.reading_steps

    def meanwhile(*asked: Any) -> Any:
        put(connection, [late])
        monkeypatch.setattr(turning, "reading_steps", begun)
        return begun(*asked)

    monkeypatch.setattr(turning, "reading_steps", meanwhile)
    source(connection, taking_turns())
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    made.score()
    assert ways == [False]
    compare(connection, [*taking_turns(), late], METHODS["delays"], taking_turns())


def test_rows_that_come_late_are_read_again(
    connection: duckdb.DuckDBPyConnection, ways: list[bool]
) -> None:
    """Within the lookback they are found by their sum, and what they change is sorted."""
    made = scored(connection, taking_turns(), "delays")
    late: Row = ("a", "x", STEP * LENGTH - 5, 99.0)
    put(connection, [late, *taking_turns(LENGTH, 30)])
    made.score()
    rows = [*taking_turns(), late, *taking_turns(LENGTH, 30)]
    compare(connection, rows, METHODS["delays"], taking_turns())
    assert ways[0]
    assert made.check_state().num_rows == 0


@pytest.mark.parametrize(("limit", "at_most"), [(None, 1), (2 * LENGTH, 2), (2 * LENGTH, 1)])
def test_what_is_calibrated_in_many_groups_is_sorted(
    connection: duckdb.DuckDBPyConnection,
    ways: list[bool],
    limit: int | None,
    at_most: int,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each group would read the rows of all; and the numbers are the same."""
    monkeypatch.setattr(in_turn, "TURNED_FROM", 1)
    monkeypatch.setattr(study, "PARTS_IN_TURN", at_most)
    heard: list[str] = []
    source(connection, taking_turns())
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate(limit=limit, on_step=heard.append)
    parts = 1 if limit is None else 2
    assert heard.count("writing") == parts
    assert ("timeline" in heard) is (parts > at_most)
    made.score()
    compare(connection, taking_turns(), METHODS["delays"])


@pytest.mark.parametrize(("changed", "is_whole"), [(list, True), (swapped, False), (lacking, False)])
def test_more_than_can_be_sorted_is_scored_whole_if_nothing_is(
    connection: duckdb.DuckDBPyConnection,
    ways: list[bool],
    monkeypatch: pytest.MonkeyPatch,
    changed: Callable[[list[Row]], list[Row]],
    is_whole: bool,
) -> None:
    """Else channel by channel, as many as can be; there each is read by its name, and in order so."""
    heard: list[str] = []
    rows = changed(taking_turns())
    source(connection, rows)
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    monkeypatch.setattr(DuckSession, "rows_at_once", lambda _: LENGTH)
    made.score(on_step=heard.append)
    assert ways[0] is is_whole
    assert heard.count("writing") == (1 if is_whole else len(NAMES))
    compare(connection, rows, METHODS["delays"])


def test_far_more_is_scored_in_groups(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """So many times what can be sorted is one transaction, and no more."""
    heard: list[str] = []
    source(connection, taking_turns())
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    monkeypatch.setattr(DuckSession, "rows_at_once", lambda _: LENGTH // UNSORTED)
    made.score(on_step=heard.append)
    assert heard.count("writing") == len(NAMES)
    compare(connection, taking_turns(), METHODS["delays"])
