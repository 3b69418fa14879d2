"""Scoring channels as they are stored: the integers of the reference, or the steps that sort.

Which of the two it was is asked for in each case, so that no case passes by the other way.
"""

from collections.abc import Callable, Iterator
from typing import Any

import duckdb
import pytest
from sqlglot import exp

from as_stored import METHODS, RUNS, compare, monitor, scored, twice_calibrated
from gam_db.engines.duckdb.driver import DuckDriver
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method.vectors import Stream
from gam_db.stored.scoring import groups, ordered
from gam_db.study import naming
from gam_db.study.running import TAUGHT
from small_plant import source
from strategies import Row
from visible import put, rows_of

pytestmark = pytest.mark.thorough

LENGTH = 200


def channel(asset: str, number: int, step: int = 2) -> list[Row]:
    """A channel that repeats a pattern, and later on less so."""
    return [
        (asset, "x", step * time, float(time % (5 + number) if time % 17 else 40 + time % 9))
        for time in range(LENGTH)
    ]


def by_channel() -> list[Row]:
    return [*channel("a", 0), *channel("b", 1, 3), *channel("c", 2)]


@pytest.fixture
def ways(monkeypatch: pytest.MonkeyPatch) -> list[bool]:
    """Whether channels were read as they are stored, run by run; short ones may be, too."""
    found: list[bool] = []

    def noted(*asked: Any) -> bool:
        found.append(ordered.is_given(*asked))
        return found[-1]

    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 20)
    monkeypatch.setattr(naming, "EVERY", 8)
    monkeypatch.setattr(groups, "is_given", noted)
    return found


@pytest.fixture
def connection() -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect() as connection:
        yield connection


@pytest.mark.parametrize("pool", ["channel", None])
def test_a_support_need_not_have_the_number_of_its_channel(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], pool: str | None
) -> None:
    twice_calibrated(connection, by_channel(), pool)
    assert ways == [True, True]


@pytest.mark.parametrize("case", METHODS)
def test_channels_in_order_are_scored_as_they_are_stored(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], case: str
) -> None:
    """What runs record is the same as well; and a later run goes on from there."""
    made = scored(connection, by_channel(), case)
    assert ways == [True]
    with duckdb.connect() as other:
        source(other, sorted(by_channel(), key=lambda row: row[2]))
        sorting = monitor(other, METHODS[case])
        sorting.migrate()
        sorting.calibrate()
        sorting.score()
        assert ways == [True, False]
        assert rows_of(connection, RUNS) == rows_of(other, RUNS)
    assert made.check_state().num_rows == 0
    more: list[Row] = [
        (asset, "x", time, float(time % 7)) for asset in "abc" for time in range(700, 760)
    ]
    put(connection, more)
    made.score()
    compare(connection, [*by_channel(), *more], METHODS[case], by_channel())
    assert made.check_state().num_rows == 0


def test_nothing_of_what_is_stored_in_order_is_sorted(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither calibration nor a run puts the readings in order, or asks for all of their instants."""
    sorting: set[str] = set()
    ask = DuckDriver.keep

    def noted(driver: DuckDriver, table: exp.Table, query: exp.Query) -> None:
        read = {one.name for one in query.find_all(exp.Table)}
        if "telemetry" in read and any(one.args.get("order") for one in query.find_all(exp.Window)):
            sorting.add(table.name)
        ask(driver, table, query)

    monkeypatch.setattr(DuckDriver, "keep", noted)
    scored(connection, by_channel(), "delays")
    assert (ways, sorting) == ([True], set())
    with duckdb.connect() as other:
        source(other, sorted(by_channel(), key=lambda row: row[2]))
        turning = monitor(other, METHODS["delays"])
        turning.migrate()
        turning.calibrate()
    assert any(name.endswith("timeline_0") for name in sorting)


def uneven(rows: list[Row]) -> list[Row]:
    """Samples are missing here and there, one channel has all; two pause now and then."""
    return [
        (
            asset,
            name,
            time + (0 if asset == "b" else 8 * (time // 90)),
            None if asset != "c" and place % 23 in (0, 1, 7) else value,
        )
        for place, (asset, name, time, value) in enumerate(rows)
    ]


@pytest.mark.parametrize("more", [{}, {"max_gap": 4}, {"max_gap": 4, "tau": 9}], ids=str)
def test_what_does_not_count_is_left_out(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], more: dict[str, Any]
) -> None:
    """And so it is by the run after that, which goes on from there."""
    rows, method = uneven(by_channel()), METHODS["delays"] | more
    first = [row for row in rows if row[2] < 260]
    with duckdb.connect() as other:
        found = []
        for one, order in ((connection, list), (other, by_time)):
            source(one, order(first))
            made = monitor(one, method)
            made.migrate()
            made.calibrate()
            made.score()
            one.execute("DELETE FROM telemetry")
            put(one, order(rows))
            made.score()
            compare(one, rows, method, first)
            assert made.check_state().num_rows == 0
            found.append(rows_of(one, RUNS))
    assert ways == [True, True, False, False]
    assert found[0] == found[1]


def by_time(rows: list[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row[2])


def test_others_are_left_to_the_steps_that_sort(
    connection: duckdb.DuckDBPyConnection, ways: list[bool]
) -> None:
    scored(connection, by_time(by_channel()), "delays")
    assert ways == [False]


def twice(rows: list[Row]) -> list[Row]:
    """An instant of one channel occurs twice, long after calibration."""
    place = rows.index(next(row for row in rows if row[:3] == ("b", "x", 450)))
    return [*rows[:place], ("b", "x", 450, -3.0), *rows[place:]]


def swapped(rows: list[Row]) -> list[Row]:
    """Two readings of one channel do not lie in order of time."""
    place = rows.index(next(row for row in rows if row[:3] == ("b", "x", 450)))
    return [*rows[:place], rows[place + 1], rows[place], *rows[place + 2 :]]


@pytest.mark.parametrize("changed", [twice, swapped])
def test_a_channel_out_of_order_alone_is_done_again(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], changed: Callable[[list[Row]], list[Row]]
) -> None:
    heard: list[str] = []
    source(connection, changed(by_channel()))
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    made.score(on_step=heard.append)
    assert ways == [True]
    assert heard.count("visited") == 2
    compare(connection, changed(by_channel()), METHODS["delays"])


def test_rows_that_come_meanwhile_are_noticed(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """One of before the end is there when channels are counted again: then all is copied and sorted."""
    late: Row = ("a", "x", 301, 99.0)
    begun = Stream

    def meanwhile(*asked: Any) -> Any:
        put(connection, [late])
        monkeypatch.setattr(ordered, "Stream", begun)
        return begun(*asked)

    monkeypatch.setattr(ordered, "Stream", meanwhile)
    source(connection, by_channel())
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    made.score()
    assert ways == [False]
    compare(connection, [*by_channel(), late], METHODS["delays"], by_channel())


#: Grids of the same channels that differ from one another.
DIFFERENT: dict[str, Any] = {
    **METHODS["delays"],
    "overrides": [{"asset": "b", "m": 1}, {"asset": "c", "bins": 6}],
}


@pytest.mark.parametrize("method", [METHODS["delays"], DIFFERENT], ids=["one grid", "different grids"])
@pytest.mark.parametrize(("room", "expected"), [(len(by_channel()), 1), (LENGTH, 3)])
def test_more_is_calibrated_in_groups(
    connection: duckdb.DuckDBPyConnection,
    ways: list[bool],
    monkeypatch: pytest.MonkeyPatch,
    room: int,
    expected: int,
    method: dict[str, Any],
) -> None:
    """So many times what can be sorted is taught together, and no more; no group knows of another."""
    heard: list[str] = []
    source(connection, by_channel())
    made = monitor(connection, method)
    made.migrate()
    monkeypatch.setattr(DuckSession, "rows_at_once", lambda _: -(-room // TAUGHT))
    made.calibrate(on_step=heard.append)
    assert heard.count("writing") == expected
    assert "learnable" not in heard  # nothing is sorted
    made.score()
    compare(connection, by_channel(), method)
    assert made.check_state().num_rows == 0


def test_what_deserves_no_trust_is_scored_in_smaller_groups(
    connection: duckdb.DuckDBPyConnection, ways: list[bool], monkeypatch: pytest.MonkeyPatch
) -> None:
    """All channels have an instant twice, and what was found of them together is done again by each."""
    heard: list[str] = []
    rows = by_time([*by_channel(), *(channel(asset, 0)[-1] for asset in "ac"), channel("b", 1, 3)[-1]])
    source(connection, rows)
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    monkeypatch.setattr(DuckSession, "rows_at_once", lambda _: len(rows))
    made.score(on_step=heard.append)
    assert heard.count("writing") == 3
    compare(connection, rows, METHODS["delays"])
