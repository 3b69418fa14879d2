"""Channels read as they are stored: the integers of the reference, or the steps that sort.

Which of the two it was is asked for in each case, so that no case passes by the other way.
"""

import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sqlglot import exp

import comparisons
import gam_db
import harness
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method.bits import Bits
from gam_db.study import Study, naming
from gam_db.study.running import Running
from harness import Answer, Row

pytestmark = pytest.mark.thorough

LENGTH = 240

#: Steps that may be all that is asked for.
HEALTH = ("bucket_health", "novel_cells")

#: name -> keyword arguments of Parameters and of Calibration that streams serve
SERVED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "delays": ({"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.4}),
    "one coordinate": ({"m": 1, "bins": 5, "window": 12, "stride": 4}, {"fraction": 0.25}),
    "a duration": ({"m": 2, "bins": 3, "window": 10, "stride": 10}, {"duration": 90}),
    "an interval": ({"m": 2, "tau": 3, "bins": 4, "window": 9}, {"intervals": [(20, 99)]}),
    "short calibration": ({"m": 4, "tau": 4, "bins": 3, "window": 6}, {"fraction": 0.02}),
    "no calibration": ({"m": 2, "bins": 3, "window": 6}, {"intervals": [(900, 950)]}),
    "a pool": ({"m": 2, "bins": 4, "window": 8, "stride": 4}, {"fraction": 0.3, "pool": "channel"}),
    "a pool of which one has no calibration": (
        {"m": 2, "bins": 4, "window": 8, "stride": 4},
        {"fraction": 0.3, "pool": "channel", "overrides": {"b": None}},
    ),
    "two sets": (
        {"m": 3, "bins": 4, "window": 8, "stride": 2, "overrides": [{"asset": "b", "m": 1, "bins": 6}]},
        {"fraction": 0.3, "overrides": {"c": {"duration": 60}}},
    ),
}

#: name -> the same, of a kind that they leave to the steps that sort
UNSERVED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "what may stand still before calibration": (
        {"m": 2, "bins": 4, "window": 8, "still_after": 5},
        {"intervals": [(20, 99)]},
    ),
    "a given start": ({"m": 2, "bins": 4, "window": 8}, {"fraction": 0.3, "score_from": 50}),
    "exclusions": ({"m": 2, "bins": 4, "window": 8}, {"fraction": 0.3, "exclude": [(9, 30)]}),
    "too many cells": ({"m": 3, "bins": 900, "window": 8}, {"fraction": 0.3}),
}


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let streams serve short channels, too."""
    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 100)
    monkeypatch.setattr(naming, "EVERY", 8)


@pytest.fixture
def connection() -> Iterator[duckdb.DuckDBPyConnection]:
    with duckdb.connect() as connection:
        yield connection


def rows(assets: str = "abc") -> list[Row]:
    """Channels that repeat a pattern, and later on less so; one of them never moves."""
    return [
        (asset, channel, 2 * time, 0.0 if asset + channel == "cy" else value(number, time))
        for number, asset in enumerate(assets)
        for channel in "xy"
        for time in range(LENGTH)
    ]


def value(number: int, time: int) -> float:
    return float(time % (5 + number) if time < 150 or time % 7 else time % 11) - 0.25


def stored(connection: duckdb.DuckDBPyConnection, table: list[Row]) -> None:
    """Store rows in their order."""
    connection.register("arriving", harness.arrow(table))
    connection.execute("CREATE TABLE telemetry AS SELECT * FROM arriving")
    connection.unregister("arriving")


def answers(
    connection: duckdb.DuckDBPyConnection,
    parameters: Any,
    calibration: Any,
    relation: Any = "telemetry",
    asked: Sequence[str] = (),
) -> tuple[dict[str, Answer], bool]:
    """Return what a study answers, and whether by streams; what is asked for is what it was told."""
    with DuckSession(connection) as session:
        source = gam_db.Source(relation)
        study = Study(session, source, parameters, calibration, short_cuts=True, targets=asked)
        for step in asked:
            study.table(step)
        is_short = study.form in ("streams", "census")
        assert ("taught" in "".join(study.running.tables)) == bool(asked and is_short)
        found = {question: study.table(step).to_pylist() for question, step in harness.STEPS.items()}
        novel = study.table("novel_cells").num_rows
        if study.form == "streams":
            sorts = "samples" in {step.name for step in study.steps.needed(["health_indicator"])}
            may_sort = calibration.intervals is not None or len(study.method.settings) > 1
            assert not sorts or may_sort, "samples before calibration, or a set without a channel"
        study.forget()
        assert macros(connection) > 0 or study.form != "streams"
    assert macros(connection) == 0
    assert novel or not any(row["novel"] for row in found["health_at_buckets"])
    return found, study.form == "streams"


def macros(connection: duckdb.DuckDBPyConnection) -> int:
    """Return how many of ours the user's connection has."""
    ours = "SELECT function_name FROM duckdb_functions() WHERE function_name LIKE 'gam!_%' ESCAPE '!'"
    return len(connection.execute(ours).fetchall())


def agrees(found: dict[str, Answer], table: list[Row], parameters: Any, calibration: Any) -> None:
    expected = harness.all_by_reference(table, parameters, calibration)
    for question in harness.STEPS:
        harness.assert_same(expected[question], found[question], question)
    comparisons.compared("duckdb", "streams", table, parameters, calibration)


@pytest.mark.parametrize("asked", [(), HEALTH], ids=["all", "health alone"])
@pytest.mark.parametrize("case", SERVED)
def test_streams_give_the_integers_of_the_reference(
    connection: duckdb.DuckDBPyConnection, case: str, asked: Sequence[str]
) -> None:
    """Where health alone is asked for, no row per vector of calibration is kept."""
    method = harness.made(*SERVED[case])
    stored(connection, rows())
    found, is_streamed = answers(connection, *method, asked=asked)
    assert is_streamed == (case != "no calibration")
    agrees(found, rows(), *method)


@pytest.mark.parametrize("threads", [1, 2])
def test_channels_are_worked_on_side_by_side(
    connection: duckdb.DuckDBPyConnection, threads: int
) -> None:
    """DuckDB does so with entries of a WITH list that it keeps, a copy for nothing on one thread."""
    stored(connection, rows())
    connection.execute("SET threads = ?", [threads])
    with DuckSession(connection) as session:
        method = harness.made(*SERVED["delays"])
        study = Study(session, gam_db.Source("telemetry"), *method, short_cuts=True)
        study.table("novel_cells")
        for step in ("visits", "visited"):
            query = study.steps.steps[step].query
            entries = list(query.find_all(exp.CTE))
            assert [entry.args["materialized"] for entry in entries] == [True] * 6 * (threads > 1)
            assert len(list(query.find_all(exp.Union))) == 5
        agrees(
            {name: study.table(step).to_pylist() for name, step in harness.STEPS.items()},
            rows(),
            *method,
        )
        study.forget()


def test_streams_load_no_pandas(tmp_path: Path) -> None:
    """Where it is installed, pyarrow loads it to look at a list: a tenth of the seconds of a run."""
    pytest.importorskip("pandas")
    path = tmp_path / "telemetry.parquet"
    with duckdb.connect() as connection:
        stored(connection, rows())
        connection.table("telemetry").write_parquet(str(path))
    asked = f"""
import sys
from pathlib import Path
import gam_db
from gam_db.study import naming
from gam_db.engines.duckdb.session import DuckSession
from gam_db.study import Study
naming.STREAMED_FROM, naming.GLANCE, naming.EVERY = 2, 100, 8
with DuckSession() as session:
    method = gam_db.Parameters(m=3, bins=4, window=20, stride=5), gam_db.Calibration(fraction=0.4)
    study = Study(session, gam_db.Source({str(path)!r}), *method, short_cuts=True)
    study.write("novel_cells", Path({str(tmp_path / "cells.parquet")!r}), "novel_cells")
    print(study.form == "streams", "pandas" in sys.modules)
"""
    done = subprocess.run([sys.executable, "-c", asked], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["True", "False"]


@pytest.mark.parametrize("asked", [(), HEALTH], ids=["all", "health alone"])
@pytest.mark.parametrize("late", ["b", "a"])
def test_members_of_a_pool_may_have_no_sample_in_its_interval(
    connection: duckdb.DuckDBPyConnection, late: str, asked: Sequence[str]
) -> None:
    """The others give them a range and a support."""
    table = [(*row[:2], row[2] + 1000 * (row[0] == late), row[3]) for row in rows()]
    stored(connection, table)
    calibration = {"intervals": [(0, 99)], "pool": "channel"}
    method = harness.made({"m": 2, "bins": 4, "window": 8, "stride": 4}, calibration)
    found, by_streams = answers(connection, *method, asked=asked)
    assert by_streams
    agrees(found, table, *method)


@pytest.mark.parametrize("first", ["timeline", "calibrated", "series", "bounds", "run_up", "visits"])
def test_single_steps_may_be_asked_for_before_the_others(
    connection: duckdb.DuckDBPyConnection, first: str
) -> None:
    table, method = rows(), harness.made(*SERVED["delays"])
    stored(connection, table)
    with DuckSession(connection) as session:
        study = Study(session, gam_db.Source("telemetry"), *method, short_cuts=True)
        study.table(first)
        found = {question: study.table(step).to_pylist() for question, step in harness.STEPS.items()}
        assert study.form == "streams"
        study.forget()
    agrees(found, table, *method)


@pytest.mark.parametrize("case", UNSERVED)
def test_what_streams_do_not_serve_is_sorted(connection: duckdb.DuckDBPyConnection, case: str) -> None:
    method = harness.made(*UNSERVED[case])
    stored(connection, rows())
    found, is_streamed = answers(connection, *method)
    assert not is_streamed
    agrees(found, rows(), *method)


def test_supports_that_have_no_room_as_bits_are_looked_up_cell_by_cell(
    connection: duckdb.DuckDBPyConnection, monkeypatch: pytest.MonkeyPatch
) -> None:
    method = harness.made(*SERVED["delays"])
    stored(connection, rows())
    steps: dict[bool, list[str]] = {}
    for has_room in (True, False):
        monkeypatch.setattr(Bits, "serve", lambda bits, cells, supports=1, yes=has_room: yes)
        with DuckSession(connection) as session:
            study = Study(session, gam_db.Source("telemetry"), *method)
            agrees(
                {name: study.table(step).to_pylist() for name, step in harness.STEPS.items()},
                rows(),
                *method,
            )
            steps[has_room] = list(study.running.tables)
            study.forget()
    assert "support_bits" in steps[True]
    assert "support_bits" not in steps[False]


def swapped(table: list[Row]) -> list[Row]:
    return [*table[:1000], table[1001], table[1000], *table[1002:]]


def doubled(table: list[Row]) -> list[Row]:
    return [*table[:1000], table[999], *table[1000:]]


def in_two_pieces(table: list[Row]) -> list[Row]:
    return [*table[50:], *table[:50]]


def by_time(table: list[Row]) -> list[Row]:
    return sorted(table, key=lambda row: row[2])


def begun_by_one(table: list[Row]) -> list[Row]:
    """By time, and the first rows are of one channel: each would be looked for among all rows."""
    return [row for row in by_time(table) if row[:2] == ("a", "x") or row[2] >= LENGTH]


def too_short(table: list[Row]) -> list[Row]:
    """One more channel, which teaches nothing: no vector shows that its instant occurs twice."""
    return [*table, ("z", "x", 0, 1.0), ("z", "x", 0, 1.0)]


def unknown(table: list[Row]) -> list[Row]:
    """One more channel whose rows are not in order, and whose calibration has missing samples alone."""
    return [*table, *(("z", "x", time, None if time < 9 else 1.0) for time in (*range(8), 9, 8, 10, 11))]


#: What breaks the order of a source.
DIRT: tuple[Callable[[list[Row]], list[Row]], ...] = (
    *(swapped, doubled, in_two_pieces, by_time),
    *(begun_by_one, too_short, unknown),
)


@pytest.mark.parametrize("asked", [(), HEALTH], ids=["all", "health alone"])
@pytest.mark.parametrize("dirt", DIRT)
def test_a_source_that_is_not_in_order_is_sorted(
    connection: duckdb.DuckDBPyConnection,
    dirt: Callable[[list[Row]], list[Row]],
    asked: Sequence[str],
) -> None:
    table, method = dirt(rows()), harness.made(*SERVED["delays"])
    stored(connection, table)
    found, is_streamed = answers(connection, *method, asked=asked)
    assert not is_streamed
    agrees(found, table, *method)


#: name -> what is added to parameters that streams serve, where samples are missing and machines pause
UNEVEN: dict[str, dict[str, Any]] = {
    "no end": {},
    "segments that end": {"max_gap": 3},
    "a reach of many samples": {"max_gap": 3, "tau": 9},
    "what stands still": {"still_after": 4},
    "what stands still in segments": {"still_after": 3, "max_gap": 3},
}


def uneven(table: list[Row]) -> list[Row]:
    """Samples are missing here and there, or no number; one asset has them all; two pause at times.

    Two stand still at times, also where calibration ends.
    """
    odd: list[float | None] = [None, float("nan"), float("inf"), -1.5e300]
    found = []
    for place, (asset, channel, time, value) in enumerate(table):
        is_missing = asset != "c" and (place % 29 in (0, 1) or place % 97 == 5)
        later = 0 if asset == "b" else 6 * (time // 64) + 9 * (time > 2 * LENGTH - 3)
        stands = time // 20 % 5 == 4 or time > 2 * LENGTH - 30
        value = 2.75 if asset != "a" and stands else value
        found.append((asset, channel, time + later, odd[place % 4] if is_missing else value))
    return found


@pytest.mark.parametrize(
    ("case", "more", "asked"),
    [
        *(("delays", more, asked) for more in UNEVEN for asked in ((), HEALTH)),
        *((case, "segments that end", ()) for case in ("one coordinate", "an interval", "a pool")),
        *((case, "what stands still", ()) for case in ("one coordinate", "a duration", "a pool")),
        ("two sets", "segments that end", HEALTH),
        ("two sets", "what stands still in segments", HEALTH),
        ("one coordinate", "what stands still in segments", ()),
        ("two sets", "no end", ()),
    ],
)
def test_what_does_not_count_is_left_out_of_streams(
    connection: duckdb.DuckDBPyConnection, case: str, more: str, asked: Sequence[str]
) -> None:
    parameters, calibration = SERVED[case]
    table, method = uneven(rows()), harness.made(parameters | UNEVEN[more], calibration)
    stored(connection, table)
    found, is_streamed = answers(connection, *method, asked=asked)
    assert is_streamed
    agrees(found, table, *method)
    by_streams, by_looking = (standing(connection, method, short_cuts) for short_cuts in (True, False))
    assert by_streams == by_looking
    assert bool(by_streams) == ("still" in more)


def test_rows_without_a_time_are_in_no_vector(connection: duckdb.DuckDBPyConnection) -> None:
    """Where they are left out, and a name has no other."""
    table, method = rows(), harness.made(*SERVED["delays"])
    stored(connection, table)
    connection.execute("INSERT INTO telemetry VALUES ('d', 'x', NULL, 1.0)")
    with DuckSession(connection) as session:
        given = session, gam_db.Source("telemetry"), *method
        study = Study(*given, strict=False, short_cuts=True, targets=["health_indicator"])
        found = study.table("health_indicator").to_pylist()
        assert study.form == "streams"
        study.forget()
    harness.assert_same(harness.by_reference("health_indicator", table, *method), found)


def standing(connection: duckdb.DuckDBPyConnection, method: tuple[Any, Any], short_cuts: bool) -> Any:
    """Return the channels that stand still at their end, and since when."""
    with DuckSession(connection) as session:
        study = Study(session, gam_db.Source("telemetry"), *method, short_cuts=short_cuts)
        study.table("bucket_health")
        rows = study.table("stillness").to_pylist()
        study.forget()
    assert (study.form == "streams") == short_cuts
    return sorted((one["channel_id"], one["still_since"]) for one in rows if one["still_since"])


@pytest.mark.parametrize(
    ("number", "asked"), [(3, HEALTH), (95, ()), (96, HEALTH), (300, ()), (-1, HEALTH)]
)
def test_what_does_not_count_is_in_order_as_well(
    connection: duckdb.DuckDBPyConnection, number: int, asked: Sequence[str]
) -> None:
    """A missing sample has its instant twice."""
    parameters, calibration = SERVED["delays"]
    table, method = uneven(rows()), harness.made(parameters | {"max_gap": 3}, calibration)
    place = number % len(table)
    table = [*table[:place], (*table[place][:3], None), *table[place:]]
    stored(connection, table)
    found, is_streamed = answers(connection, *method, asked=asked)
    assert not is_streamed
    agrees(found, table, *method)


@pytest.mark.parametrize(
    "asked", [(), HEALTH, ("health_indicator",)], ids=["all", "health alone", "single vectors"]
)
@pytest.mark.parametrize("dirt", [swapped, doubled, in_two_pieces, by_time])
def test_the_vectors_themselves_show_a_wrong_proof(
    connection: duckdb.DuckDBPyConnection,
    dirt: Callable[[list[Row]], list[Row]],
    asked: Sequence[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Where the glance and the proof are passed over, what is computed says so itself."""

    def grouped(running: Running, is_proven: bool) -> pa.Table:
        names = running.session.fetch(running.steps.query("names", running.tables))
        return names.append_column("in_order", pa.array([1] * names.num_rows))

    monkeypatch.setattr(naming, "counted", grouped)
    table, method = dirt(rows()), harness.made(*SERVED["delays"])
    stored(connection, table)
    found, is_streamed = answers(connection, *method, asked=asked)
    assert is_streamed == (dirt is by_time)  # by time, each channel alone is in order all the same
    agrees(found, table, *method)


@pytest.mark.parametrize("asked", [(), HEALTH], ids=["all", "health alone"])
def test_an_instant_that_occurs_twice_is_found_where_calibration_has_no_vector(
    connection: duckdb.DuckDBPyConnection, asked: Sequence[str]
) -> None:
    """Its mark is of a sample that comes before any vector, and so before any block."""
    table = [(*row[:2], 2 if row[2] == 4 else row[2], row[3]) for row in rows()]
    method = harness.made(*SERVED["short calibration"])
    stored(connection, table)
    found, is_streamed = answers(connection, *method, asked=asked)
    assert not is_streamed
    agrees(found, table, *method)


@pytest.mark.parametrize("asked", [(), HEALTH, ("bucket_health", "certificate")])
@pytest.mark.parametrize("question", harness.STEPS)
def test_an_instant_that_occurs_twice_after_calibration_changes_what_calibration_is(
    connection: duckdb.DuckDBPyConnection, question: str, asked: Sequence[str]
) -> None:
    """It makes the channel shorter by one sample, and so its share. Nothing else is asked for before."""
    table = [(*row[:2], 402 if row[2] == 404 else row[2], row[3]) for row in rows()]
    method = harness.made({"m": 2, "bins": 3, "window": 6}, {"fraction": 0.25})
    stored(connection, table)
    with DuckSession(connection) as session:
        source = gam_db.Source("telemetry")
        study = Study(session, source, *method, short_cuts=True, targets=asked)
        found = study.table(harness.STEPS[question]).to_pylist()
        study.forget()
    harness.assert_same(harness.all_by_reference(table, *method)[question], found, question)


def test_visits_that_are_not_those_of_the_counted_samples_are_made_anew(
    connection: duckdb.DuckDBPyConnection,
) -> None:
    """Here somebody takes a row away between two statements."""
    stored(connection, rows())

    def on_step(step: str) -> None:
        if step == "visits":
            connection.execute("DELETE FROM telemetry WHERE asset = 'b' AND channel = 'y' AND time = 40")

    with DuckSession(connection) as session:
        method = harness.made(*SERVED["delays"])
        source = gam_db.Source("telemetry")
        study = Study(session, source, *method, on_step=on_step, short_cuts=True)
        study.table("novel_cells")
        assert study.form != "streams"
        study.forget()


@pytest.mark.parametrize("form", ["file", "files", "view with a join", "view", "no order kept"])
def test_any_relation_gives_the_same(
    connection: duckdb.DuckDBPyConnection, form: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whether its rows come in order or not; of a file and a plain view they do."""
    monkeypatch.setattr(naming, "GLANCE", 10)
    many = 40  # of the rows that follow from one; several vectors and threads
    table = [
        (*row[:2], row[2] + many_of * 1000, row[3]) for row in rows("ab") for many_of in range(many)
    ]
    table.sort(key=lambda row: (row[0], row[1], row[2]))
    method = harness.made(*SERVED["delays"])
    stored(connection, table)
    relation: Any = "shown"
    if form in ("file", "files"):
        for number, asset in enumerate("ba" if form == "files" else ["%"]):
            query = f"SELECT * FROM telemetry WHERE asset LIKE '{asset}'"
            connection.sql(query).write_parquet(str(tmp_path / f"{number}.parquet"))
        relation = str(tmp_path / "*.parquet")
    elif form == "view with a join":
        connection.execute("CREATE TABLE known AS SELECT DISTINCT asset FROM telemetry")
        connection.execute("CREATE VIEW shown AS SELECT * FROM telemetry JOIN known USING (asset)")
    else:
        connection.execute("CREATE VIEW shown AS SELECT * FROM telemetry WHERE value > -9")
    if form == "no order kept":
        connection.execute("SET preserve_insertion_order = false")
    found, is_streamed = answers(connection, *method, relation)
    assert is_streamed or form not in ("file", "view")
    agrees(found, table, *method)


@settings(max_examples=max(1, settings().max_examples // 5))
@given(st.data())
def test_random_sources_give_the_same_as_the_steps_that_sort(data: st.DataObject) -> None:
    served = data.draw(st.sampled_from([case for case in SERVED if case != "no calibration"]))
    parameters, calibration = SERVED[served]
    more = data.draw(st.sampled_from([{}, {"max_gap": 1}, {"max_gap": 2}, {"still_after": 2}]))
    method = harness.made(parameters | more, calibration)
    lengths = data.draw(st.lists(st.integers(30, 60), min_size=1, max_size=4))
    values = st.sampled_from([*map(float, range(-3, 7)), *[None] * data.draw(st.integers(0, 2))])
    pauses = data.draw(st.integers(0, 2))
    table: list[Row] = [
        (f"{number:02}", "x", time + pauses * (time > 40), data.draw(values) if time % 5 else 1.5)
        for number, length in enumerate(lengths)
        for time in range(length)
    ]
    with duckdb.connect() as connection, pytest.MonkeyPatch.context() as patched:
        patched.setattr(naming, "GLANCE", 5)
        stored(connection, table)
        found, is_streamed = answers(connection, *method)
        assert is_streamed or served in ("an interval", "short calibration")
        agrees(found, table, *method)


def test_nothing_is_collapsed_where_calibration_alone_is_asked_for(
    connection: duckdb.DuckDBPyConnection,
) -> None:
    """Streams that find no calibration leave it to the windows, which see every reading."""
    stored(connection, rows())
    method = harness.made(*SERVED["no calibration"])
    with DuckSession(connection) as session:
        study = Study(
            session, gam_db.Source("telemetry"), *method, short_cuts=True, targets=["support_summary"]
        )
        assert study.is_ordered
        assert {row["verdict"] for row in study.rows("support_summary")} == {"no_data"}
        assert (study.form, study.is_collapsed) == ("windows", False)
        study.forget()
