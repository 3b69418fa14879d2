"""The census: the integers of the reference, also where an instant occurs twice, and in which form.

Which form it was is asked for in each case, so that no case passes by the other way.
"""

import dataclasses
import random
from collections.abc import Callable, Iterable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sqlglot import exp

import comparisons
import engines
import gam_db
import gathering
import harness
import strategies
from gam_db.engines.session import Session
from gam_db.method import census
from gam_db.method.delays import SET_STEPS, STORED
from gam_db.study import Study
from gam_db.study import census as at_work
from harness import Answer, Row

pytestmark = pytest.mark.thorough

LENGTH = 160

#: name -> keyword arguments of Parameters and of Calibration that are served
SERVED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "delays": ({"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.4}),
    "one coordinate": ({"m": 1, "bins": 5, "window": 12, "stride": 4}, {"duration": 90}),
    "keys that fill a number": ({"m": 9, "bins": 100, "window": 12}, {"fraction": 0.4}),
    "an interval": ({"m": 2, "tau": 3, "bins": 4, "window": 9}, {"intervals": [(-5, 99)]}),
    "an end between samples": ({"m": 2, "bins": 4, "window": 9}, {"intervals": [(0, 100)]}),
    "a reach of many slices": ({"m": 4, "tau": 9, "bins": 3, "window": 6}, {"fraction": 0.5}),
    "short calibration": ({"m": 4, "tau": 4, "bins": 3, "window": 6}, {"fraction": 0.02}),
    "all of it": ({"m": 2, "bins": 3, "window": 6}, {"fraction": 1.0}),
    "two sets and a pool of which one has no calibration": (
        {
            "m": 3,
            "bins": 4,
            "window": 8,
            "stride": 2,
            "overrides": [{"channel": "y", "m": 1, "bins": 6}],
        },
        {"fraction": 0.3, "pool": "channel", "overrides": {"b": None, "c": {"duration": 60}}},
    ),
}

#: name -> the same, where samples that are none of calibration come before scoring begins
CUT: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "a late start": ({"m": 3, "tau": 2, "bins": 4, "window": 8}, {"duration": 60, "score_from": 201}),
    "exclusions": (
        {"m": 3, "tau": 3, "bins": 4, "window": 8},
        {"fraction": 0.3, "exclude": [(9, 30), (41, 41), (60, 61)]},
    ),
    "an exclusion of the end": (
        {"m": 2, "bins": 4, "window": 8},
        {"fraction": 0.4, "exclude": [(80, 400)]},
    ),
    "late intervals": (
        {"m": 2, "tau": 3, "bins": 4, "window": 9},
        {"intervals": [(31, 60), (61, 90), (120, 121), (150, 170)]},
    ),
    "a late interval": ({"m": 2, "bins": 4, "window": 8}, {"intervals": [(40, 99)]}),
    "sets, a pool, rules and starts": (
        {
            "m": 3,
            "bins": 4,
            "window": 8,
            "stride": 2,
            "overrides": [{"channel": "y", "m": 1, "bins": 6}],
        },
        {
            "fraction": 0.3,
            "pool": "channel",
            "overrides": {
                "b": {"duration": 70, "exclude": [(20, 33), (90, 110)]},
                "c": {"intervals": [(5, 60), (80, 99)], "score_from": 140},
            },
        },
    ),
}

#: name -> the same, of a kind that is left to the steps that look
UNSERVED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "a start within calibration": (
        {"m": 2, "bins": 4, "window": 8},
        {"fraction": 0.3, "score_from": 50},
    ),
    "a start before all": (
        {"m": 1, "bins": 4, "window": 8},
        {"intervals": [(20, 90)], "score_from": -7},
    ),
}


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cut short sources into as many slices as long ones."""
    monkeypatch.setattr(census, "IN_SLICE", 1)


def rows() -> list[Row]:
    """Channels by time that repeat a pattern, and later on less so; some samples of one are missing."""
    return [
        (asset, channel, 2 * time + number, sample(asset + channel, number, time))
        for time in range(LENGTH)
        for number, asset in enumerate("abc")
        for channel in "xy"
    ]


def sample(name: str, number: int, time: int) -> float | None:
    if name == "cy":
        return 0.0  # never moves
    if name == "ax" and time % 23 in (5, 6):
        return None
    return float(time % (5 + number) if time < 100 or time % 7 else time % 11) - 0.25


def doubled(table: list[Row], number: int) -> list[Row]:
    """The same with a second reading of an instant."""
    asset, channel, time, _ = table[number]
    return [*table, (asset, channel, time, 7.5)]


def by_time(table: list[Row]) -> list[Row]:
    """The first readings of all instants by time, and after them the others."""
    known = set[tuple[str, str, int]]()
    first, others = list[Row](), list[Row]()
    for row in table:
        (others if row[:3] in known else first).append(row)
        known.add(row[:3])
    return [*sorted(first, key=lambda row: row[2]), *others]


def by_channel(table: list[Row]) -> list[Row]:
    return sorted(table, key=lambda row: row[:3])


def study_of(session: Session, name: str, method: tuple[Any, Any]) -> Study:
    return Study(session, gam_db.Source(name), *method, short_cuts=True)


def answers(
    session: Session,
    table: list[Row],
    method: tuple[Any, Any],
    look: Callable[[Study], None] = lambda study: None,
) -> tuple[dict[str, Answer], bool]:
    """Return what a study answers of buckets, support and certificate, and whether on trust.

    Whoever wants to look at the study is given it once it has answered of buckets.
    """
    with session.lent(harness.arrow(table)) as lent:
        study = study_of(session, lent.name, method)
        found = {"health_at_buckets": study.table("bucket_health").to_pylist()}
        look(study)
        for name in ("support", "certificate"):
            found[name] = study.table(harness.STEPS[name]).to_pylist()
        novel = study.table("novel_cells").num_rows
        is_trusting = study.form == "census"
        found["health_indicator"] = study.table("health_indicator").to_pylist()
        assert (study.form == "census") == (is_trusting and not is_cut(table, method[1])), (
            "single vectors"
        )
        study.forget()
    assert novel or not any(row["novel"] for row in found["health_at_buckets"])
    return found, is_trusting


def is_cut(table: list[Row], calibration: gam_db.Calibration) -> bool:
    """Whether samples that are none of calibration may come before scoring: not served one by one."""
    rules = [calibration, *(rule for rule in calibration.overrides.values() if rule is not None)]
    earliest: Any = min(row[2] for row in table)
    return any(
        rule.exclude
        or rule.score_from is not None
        or (rule.intervals and (len(rule.intervals) > 1 or rule.intervals[0][0] > earliest))
        for rule in rules
    )


def agrees(engine: str, found: dict[str, Answer], table: list[Row], method: tuple[Any, Any]) -> None:
    expected = harness.all_by_reference(table, *method)
    for question in harness.STEPS:
        harness.assert_same(expected[question], found[question], question)
    comparisons.compared(engine, "trusting", table, *method)


def each_is_found(
    engine: str,
    numbers: Iterable[int],
    said: tuple[dict[str, Any], dict[str, Any]],
    stored: Callable[[list[Row]], list[Row]] = by_time,
) -> bool:
    """Compare sources that are one, each with a second reading of one row; return whether on trust."""
    tables = {f"row {number}": doubled(rows(), number) for number in numbers}
    source = gathering.Gathered({name: (table, *said) for name, table in tables.items()})
    method = source.parameters, source.calibration
    found, is_trusting = answers(engines.session(engine), stored(source.rows), method)
    gathering.each(
        tables,
        lambda name: agrees(engine, source.answers(found, name), tables[name], harness.made(*said)),
    )
    return is_trusting


@pytest.mark.parametrize("case", [*SERVED, *CUT])
def test_the_census_gives_the_integers_of_the_reference(engine: str, case: str) -> None:
    method = harness.made(*(SERVED | CUT)[case])
    found, is_trusting = answers(engines.session(engine), rows(), method)
    assert is_trusting
    agrees(engine, found, rows(), method)


def test_an_instant_that_occurs_twice_is_found(engine: str) -> None:
    """The first of all, in calibration, and the last; of a channel with and without missing samples."""
    assert each_is_found(engine, (0, 30, -1), SERVED["delays"])


@pytest.mark.parametrize("number", [0, -1])
def test_one_instant_that_occurs_twice_is_found(number: int) -> None:
    """Of a source that has no other."""
    method = harness.made(*SERVED["delays"])
    table = doubled(rows(), number)
    found, is_trusting = answers(engines.session("duckdb"), table, method)
    assert is_trusting
    agrees("duckdb", found, table, method)


#: What comes again: nothing; the first row of all; one of calibration, of a channel that never moves.
AGAIN: dict[str, list[Row]] = {"none": [], "the first": rows()[:1], "one like all others": rows()[65:66]}


@pytest.mark.parametrize("again", AGAIN)
def test_health_alone_has_the_same_proof(engine: str, again: str) -> None:
    """No row per vector of calibration is kept for it; what else is asked for is answered, too."""
    method = harness.made(*SERVED["delays"])
    table = [*rows(), *AGAIN[again]]
    session, expected = engines.session(engine), harness.all_by_reference(table, *method)
    with session.lent(harness.arrow(table)) as lent:
        study = Study(
            session, gam_db.Source(lent.name), *method, short_cuts=True, targets=["bucket_health"]
        )
        for question in ("health_at_buckets", "support", "certificate"):
            found = study.table(harness.STEPS[question]).to_pylist()
            harness.assert_same(expected[question], found, question)
            assert study.form == "census", question
        study.forget()


def test_wherever_an_instant_occurs_twice_it_is_found() -> None:
    assert each_is_found("duckdb", range(0, 6 * LENGTH, 41), SERVED["a reach of many slices"])


@pytest.mark.parametrize("case", CUT)
def test_what_is_not_of_calibration_is_proven_as_well(case: str) -> None:
    """Also what lies within an exclusion, before a declared interval, or before scoring begins."""
    assert each_is_found("duckdb", range(5, 6 * LENGTH, 193), CUT[case])


@pytest.mark.parametrize("case", UNSERVED)
def test_what_the_census_does_not_serve_is_looked_at(case: str) -> None:
    method = harness.made(*UNSERVED[case])
    found, is_trusting = answers(engines.session("duckdb"), rows(), method)
    assert not is_trusting
    agrees("duckdb", found, rows(), method)


def test_a_channel_without_calibration_has_no_vector_as_proof(engine: str) -> None:
    """The steps run over collapsed readings then, though no instant occurs twice."""
    method = harness.made({"m": 2, "bins": 4, "window": 8}, {"overrides": {"b": None}})
    for table in (rows(), doubled(rows(), 8)):
        session = engines.session(engine)
        with session.lent(harness.arrow(table)) as lent:
            study = study_of(session, lent.name, method)
            study.table("bucket_health")
            assert (study.form, study.is_collapsed) == ("census", True)
            study.forget()
        found, _ = answers(session, table, method)
        agrees(engine, found, table, method)


def test_the_certificate_alone_is_proven_by_the_scored_vectors() -> None:
    """Of three readings of an instant, two would be counted."""
    method = harness.made(*SERVED["delays"])
    table = doubled(rows(), -1)
    session = engines.session("duckdb")
    with session.lent(harness.arrow(table)) as lent:
        study = study_of(session, lent.name, method)
        assert study.table("channels").num_rows == 6
        found = study.table("support_summary").to_pylist()
        assert (study.form, study.is_collapsed) == ("census", True)
        study.forget()
    harness.assert_same(harness.by_reference("support", table, *method), found)


@pytest.mark.parametrize("case", ["delays", "two sets and a pool of which one has no calibration"])
@pytest.mark.parametrize("again", AGAIN)
def test_single_vectors_have_the_same_proof(engine: str, again: str, case: str) -> None:
    """Also where nothing else is asked for."""
    method = harness.made(*SERVED[case])
    table = [*rows(), *AGAIN[again]]
    session = engines.session(engine)
    with session.lent(harness.arrow(table)) as lent:
        asked = gam_db.Source(lent.name), *method
        study = Study(session, *asked, short_cuts=True, targets=["health_indicator"])
        found = study.table("health_indicator").to_pylist()
        assert (study.form, study.is_collapsed) == ("census", again != "none")
        study.forget()
    harness.assert_same(harness.by_reference("health_indicator", table, *method), found)


def test_slices_reach_from_the_first_instant_to_the_last() -> None:
    """Their number and width change no integer, but what an edge costs."""
    session = engines.session("duckdb")
    with session.lent(harness.arrow(rows())) as table:
        study = study_of(session, table.name, harness.made(*SERVED["delays"]))
        slices = session.fetch(study.running.query("slices"))["slice_no"].to_pylist()
        study.forget()
    assert {*slices} == {*range(max(slices) + 1)}
    assert census.SLICES - 4 < max(slices) < census.SLICES  # a width is rounded up


def test_one_row_of_long_ago(engine: str) -> None:
    """All others lie in one slice then, which is read sample by sample."""
    method = harness.made({"m": 3, "tau": 2, "bins": 4, "window": 20}, {"fraction": 0.4})
    table = [*rows(), ("c", "y", -(10**9), 1.5), ("a", "x", 10**9, 1.5)]
    found, is_trusting = answers(engines.session(engine), table, method)
    assert is_trusting
    agrees(engine, found, table, method)


def cut_into(table: list[Row], glanced_at: int) -> int:
    """Return into how many slices a source is cut of which so many rows are glanced at."""
    session = engines.session("duckdb")
    with pytest.MonkeyPatch.context() as patched, session.lent(harness.arrow(table)) as lent:
        patched.setattr(at_work, "GLANCED", glanced_at)
        study = study_of(session, lent.name, harness.made(*SERVED["delays"]))
        slices = study.running.table("slices")["slice_no"].to_pylist()
        study.forget()
    return len({*slices})


@pytest.mark.parametrize("order", ["by time", "by channel"])
@pytest.mark.parametrize("glanced_at", [5 * LENGTH // 2, 6 * LENGTH])
def test_slices_are_fewer_where_channels_are_many(
    monkeypatch: pytest.MonkeyPatch, order: str, glanced_at: int
) -> None:
    """However rows lie, and be all of them glanced at or some."""
    table = rows() if order == "by time" else by_channel(rows())
    assert len(table) == 6 * LENGTH
    monkeypatch.setattr(census, "IN_SLICE", LENGTH // 10)
    assert 8 <= cut_into(table, glanced_at) <= 10
    monkeypatch.setattr(census, "MOST_ROWS", 6 * 4)
    assert 3 <= cut_into(table, glanced_at) <= 4
    monkeypatch.setattr(census, "MOST_ROWS", 5)
    assert cut_into(table, glanced_at) == 1


def test_what_has_no_room_is_not_held(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Then vectors are made by windows."""
    method, session = harness.made(*SERVED["delays"]), engines.session(engine)
    monkeypatch.setattr(type(session), "rows_at_once", lambda _: len(rows()) - 1)
    with session.lent(harness.arrow(rows())) as lent:
        study = study_of(session, lent.name, method)
        assert "stored" not in study.running.tables
        study.forget()
    found, is_trusting = answers(session, rows(), method)
    assert is_trusting
    agrees(engine, found, rows(), method)


@pytest.mark.parametrize("asked", ["support_summary", "certificate"])
def test_what_proves_nothing_is_not_begun(engine: str, asked: str) -> None:
    session, method = engines.session(engine), harness.made(*SERVED["delays"])
    with session.lent(harness.arrow(rows())) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True, targets=[asked])
        assert "slices" not in study.running.tables
        study.forget()


def apart(table: list[Row]) -> list[Row]:
    """The first reading of each instant."""
    first = {row[:3]: row for row in reversed(table)}
    return [first[row[:3]] for row in dict.fromkeys((*row[:3], None) for row in table)]


@settings(max_examples=max(1, settings().max_examples // 8))
@given(st.data())
def test_random_sources_give_the_integers_of_the_reference(data: st.DataObject) -> None:
    table, parameters, calibration = data.draw(strategies.cases())
    if data.draw(st.booleans()):
        table = apart(table)
    method = harness.made(parameters, calibration)
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(census, "IN_SLICE", 1)
        patched.setattr(census, "SLICES", data.draw(st.sampled_from([1, 3, 32])))
        found, _ = answers(engines.session("duckdb"), table, method)
    agrees("duckdb", found, table, method)


#: Ways in which the rows of a source may lie.
ORDERS: dict[str, Callable[[list[Row]], list[Row]]] = {
    "by channel": by_channel,
    "backwards": lambda table: sorted(table, key=lambda row: row[:3], reverse=True),
    "one after its time": lambda table: [*(by := by_channel(table))[1:], by[0]],
    "shuffled": lambda table: random.Random(3).sample(table, len(table)),
}


def whole(table: list[Row]) -> list[Row]:
    """The same without the missing samples."""
    return [(*row[:3], 1.0 if row[3] is None else row[3]) for row in table]


@pytest.mark.parametrize("order", ORDERS)
def test_however_rows_lie_the_body_of_the_engine_serves(engine: str, order: str) -> None:
    """With a channel that lacks samples, and without: then nothing is made for such."""
    method = harness.made(*SERVED["two sets and a pool of which one has no calibration"])
    session = engines.session(engine)
    for source in (rows(), whole(rows())):
        table = ORDERS[order](source)
        found, is_trusting = answers(session, table, method)
        assert is_trusting
        agrees(engine, found, table, method)


def test_what_the_body_of_the_engine_keeps(engine: str) -> None:
    """Nothing is made for channels that lack samples where none does."""
    method = harness.made(*SERVED["two sets and a pool of which one has no calibration"])
    session = engines.session(engine)
    with session.lent(harness.arrow(whole(rows()))) as lent:
        study = study_of(session, lent.name, method)
        study.table("bucket_health")
        body = session.engine.delays
        assert {study.method.named(step, 0) for step in SET_STEPS.get(body or "", ())} <= set(
            study.running.tables
        )
        assert set(STORED.get(body or "", ())) <= set(study.running.tables)
        assert "incomplete_vectors_0" not in study.steps.steps
        study.forget()


@pytest.mark.parametrize("place", [0, 100, 200, 321, -1])
def test_rows_without_a_time_are_counted_where_they_lie(engine: str, place: int) -> None:
    """Two of the first channel, wherever they are stored, beside one without a value."""
    table: list[Any] = by_channel(rows())
    table[place:place] = [("a", "x", None, 3.0), ("a", "x", None, None)]
    method = harness.made(*SERVED["delays"])
    session = engines.session(engine)
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, strict=False, short_cuts=True)
        found = {(row["asset"], row["channel"]): row for row in study.rows("names")}
        assert study.steps.steps.get("slices"), "the census counts them"
        study.forget()
    ours = [row for row in table if row[:2] == ("a", "x")]
    times = [time for _, _, time, _ in ours if time is not None]
    assert found["a", "x"] == {
        "asset": "a",
        "channel": "x",
        "readings": len(times),
        "without_time": 2,
        "missing_readings": sum(value is None for *_, value in ours),
        "earliest": min(times),
        "latest": max(times),
    }
    assert len(found) == 6
    assert not any(row["without_time"] for name, row in found.items() if name != ("a", "x"))


@pytest.mark.parametrize("stored", [by_time, by_channel])
def test_each_body_finds_what_occurs_twice(
    engine: str, stored: Callable[[list[Row]], list[Row]]
) -> None:
    """Also among the samples before the first vector, and before the first scored one."""
    numbers, said = range(1, 6 * LENGTH, 173), SERVED["a reach of many slices"]
    assert each_is_found(engine, numbers, said, stored)


@pytest.mark.parametrize("order", ["by channel", "shuffled"])
def test_numbers_are_as_wide_as_they_may_be(engine: str, order: str) -> None:
    """Beyond that they are missing, however rows lie."""
    wide = {30: 9.5e299, 50: -9.5e299, 70: 1.5e300, 90: -1.5e300}
    method = harness.made(*SERVED["delays"])
    table = ORDERS[order](
        [(*row[:3], wide.get(number % 101, row[3])) for number, row in enumerate(rows())]
    )
    found, _ = answers(engines.session(engine), table, method)
    agrees(engine, found, table, method)


def test_a_support_too_large_for_a_set_is_joined(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(at_work.Census, "_has_large_support", lambda _: True)
    method = harness.made(*SERVED["delays"])
    session = engines.session(engine)

    def look(study: Study) -> None:
        assert study.steps.steps["complete_novelty"].query.find(exp.In) is None

    found, is_trusting = answers(session, rows(), method, look)
    assert is_trusting
    agrees(engine, found, rows(), method)


def test_a_large_support_is_told_by_the_engine(engine: str, monkeypatch: pytest.MonkeyPatch) -> None:
    session = engines.session(engine)
    most = exp.select(exp.alias_(exp.Literal.number(1), "most"))
    known = dataclasses.replace(session.engine, most_in_set=most)
    monkeypatch.setattr(session, "engine", known)
    with session.lent(harness.arrow(rows())) as lent:
        study = study_of(session, lent.name, harness.made(*SERVED["delays"]))
        study.table("bucket_health")
        assert study.form == "census"
        assert study.steps.steps["complete_novelty"].query.find(exp.In) is None
        study.forget()


@pytest.mark.parametrize(("name", "time"), [("ax", 1), ("bx", 100), ("cy", 2 * LENGTH)])
def test_rows_that_came_after_the_count_are_not_read(name: str, time: int) -> None:
    """Readings that are lined up are those that were counted."""
    session, method = engines.session("sqlite"), harness.made(*SERVED["delays"])
    with session.lent(harness.arrow(rows())) as lent:
        study = study_of(session, lent.name, method)
        late = harness.arrow([(*name, 2 * time + 1, 1.0)])
        with session.lent(late) as more:
            session.execute(exp.insert(exp.select("*").from_(more), lent))
        found = study.table("bucket_health").to_pylist()
        assert study.form == "census"
        study.forget()
    harness.assert_same(harness.by_reference("health_at_buckets", rows(), *method), found)
