"""First runs of a monitor: the integers of the reference, however rows lie."""

from collections.abc import Callable, Iterator
from typing import Any

import duckdb
import pytest
from sqlglot import exp

import frozen
import gam_db
import harness
from as_stored import METHODS, RUNS, compare, monitor, scored, twice_calibrated
from gam_db.engines.duckdb.driver import DuckDriver
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.monitor import Monitor
from gam_db.study import naming
from gam_db.study.running import TAUGHT
from small_plant import source
from strategies import Row
from visible import BUCKETS, NOVEL, put, rows_of

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


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Short channels are calibrated in stored order, too."""
    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 20)
    monkeypatch.setattr(naming, "EVERY", 8)


@pytest.fixture
def connection() -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect() as connection:
        yield connection


@pytest.mark.parametrize("pool", ["channel", None])
def test_a_support_need_not_have_the_number_of_its_channel(
    connection: duckdb.DuckDBPyConnection, pool: str | None
) -> None:
    twice_calibrated(connection, by_channel(), pool)


@pytest.mark.parametrize("case", METHODS)
def test_rows_in_any_order_are_scored_alike(connection: duckdb.DuckDBPyConnection, case: str) -> None:
    """What runs record is the same as well; and a later run goes on from there."""
    made = scored(connection, by_channel(), case)
    with duckdb.connect() as other:
        source(other, by_time(by_channel()))
        sorting = monitor(other, METHODS[case])
        sorting.migrate()
        sorting.calibrate()
        sorting.score()
        assert rows_of(connection, RUNS) == rows_of(other, RUNS)
    assert made.check_state().num_rows == 0
    more: list[Row] = [
        (asset, "x", time, float(time % 7)) for asset in "abc" for time in range(700, 760)
    ]
    put(connection, more)
    made.score()
    compare(connection, [*by_channel(), *more], METHODS[case], by_channel())
    assert made.check_state().num_rows == 0


def test_calibration_in_stored_order_sorts_nothing(
    connection: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It neither puts the readings in order nor asks for all of their instants."""
    sorting: set[str] = set()
    ask = DuckDriver.keep

    def noted(driver: DuckDriver, table: exp.Table, query: exp.Query) -> None:
        read = {one.name for one in query.find_all(exp.Table)}
        if "telemetry" in read and any(one.args.get("order") for one in query.find_all(exp.Window)):
            sorting.add(table.name)
        ask(driver, table, query)

    monkeypatch.setattr(DuckDriver, "keep", noted)
    source(connection, by_channel())
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    assert sorting == set()
    with duckdb.connect() as other:
        source(other, by_time(by_channel()))
        shuffled = monitor(other, METHODS["delays"])
        shuffled.migrate()
        shuffled.calibrate()
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
    connection: duckdb.DuckDBPyConnection, more: dict[str, Any]
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
    assert found[0] == found[1]


def by_time(rows: list[Row]) -> list[Row]:
    return sorted(rows, key=lambda row: row[2])


def twice(rows: list[Row]) -> list[Row]:
    """An instant of one channel occurs twice, long after calibration."""
    place = rows.index(next(row for row in rows if row[:3] == ("b", "x", 450)))
    return [*rows[:place], ("b", "x", 450, -3.0), *rows[place:]]


def swapped(rows: list[Row]) -> list[Row]:
    """Two readings of one channel do not lie in order of time."""
    place = rows.index(next(row for row in rows if row[:3] == ("b", "x", 450)))
    return [*rows[:place], rows[place + 1], rows[place], *rows[place + 2 :]]


@pytest.mark.parametrize("changed", [twice, swapped])
def test_the_steps_run_once_more_where_an_instant_occurs_twice(
    connection: duckdb.DuckDBPyConnection, changed: Callable[[list[Row]], list[Row]]
) -> None:
    heard: list[str] = []
    source(connection, changed(by_channel()))
    made = monitor(connection, METHODS["delays"])
    made.migrate()
    made.calibrate()
    made.score(on_step=heard.append)
    assert heard.count("visited") == 1 + (changed is twice)
    compare(connection, changed(by_channel()), METHODS["delays"])
    assert made.check_state().num_rows == 0


@pytest.mark.parametrize("gap", [None, 5])
def test_channels_of_different_grids_are_scored_by_one_query(
    connection: duckdb.DuckDBPyConnection, gap: int | None
) -> None:
    """Bins and the longest gap are columns; where segments may end is a query of its own."""
    overrides = [{"asset": "b", "bins": 7}, {"asset": "c", "bins": 40, "max_gap": gap}]
    method = METHODS["delays"] | {"overrides": overrides}
    heard: list[str] = []
    rows = uneven(by_channel())
    source(connection, rows)
    made = monitor(connection, method)
    made.migrate()
    made.calibrate()
    made.score(on_step=heard.append)
    assert heard.count("visited") == (1 if gap is None else 2)
    compare(connection, rows, method)
    assert made.check_state().num_rows == 0


@pytest.mark.parametrize("gap", [None, 5])
def test_channels_of_different_delays_and_windows_are_scored_by_one_list(
    connection: duckdb.DuckDBPyConnection, gap: int | None
) -> None:
    """Delay, window and stride are columns of the cohort, where segments end, too; so is what judges."""
    overrides = [
        {"asset": "b", "tau": 5, "window": 12, "stride": 3},
        {"asset": "c", "tau": 1, "window": 20, "stride": 20, "bins": 7},
    ]
    method = METHODS["delays"] | {"overrides": overrides, "max_gap": gap}
    heard: list[str] = []
    rows = uneven(by_channel())
    first = [row for row in rows if row[2] < 300]
    source(connection, first)
    made = monitor(connection, method)
    made.migrate()
    made.calibrate()
    made.score(on_step=heard.append)
    assert heard.count("visited") == 1
    put(connection, [row for row in rows if row[2] >= 300])
    made.score()
    compare(connection, rows, method, first)
    assert made.check_state().num_rows == 0


def test_as_far_back_as_the_largest_delay_calibration_is_looked_for(
    connection: duckdb.DuckDBPyConnection,
) -> None:
    """From a start on, vectors of calibration are not scored; those that reach over a hole in it are."""
    rules = {"intervals": [(0, 150)], "exclude": [(70, 80), (101, 103)], "score_from": 40}
    overrides = [{"asset": "b", "tau": 5, "window": 12, "stride": 3}, {"asset": "c", "tau": 9}]
    asked = harness.made(METHODS["delays"] | {"overrides": overrides}, rules)
    rows = by_channel()
    source(connection, rows)
    made = Monitor(connection, gam_db.Source("telemetry"), *asked, lookback=12)
    made.migrate()
    made.calibrate()
    made.score()
    expected = frozen.buckets(rows, rows, *asked), frozen.novel_cells(rows, rows, *asked)
    harness.assert_same(expected[0], rows_of(connection, BUCKETS), "buckets")
    harness.assert_same(expected[1], rows_of(connection, NOVEL), "novel cells")


#: Grids of the same channels that differ from one another.
DIFFERENT: dict[str, Any] = {
    **METHODS["delays"],
    "overrides": [{"asset": "b", "m": 1}, {"asset": "c", "bins": 6}],
}


@pytest.mark.parametrize("method", [METHODS["delays"], DIFFERENT], ids=["one grid", "different grids"])
@pytest.mark.parametrize(("room", "expected"), [(len(by_channel()), 1), (LENGTH, 3)])
def test_more_is_calibrated_in_groups(
    connection: duckdb.DuckDBPyConnection,
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
