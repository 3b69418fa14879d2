"""Sources whose channels take turns as rows are stored: the reference's integers, by rounds or sorted.

Which of the two it was is asked for in each case, so that no case passes by the other way.
"""

import random
from collections.abc import Callable, Sequence
from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sqlglot import exp

import comparisons
import engines
import gam_db
import harness
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from gam_db.settings.source import UNPIVOTED_FROM
from gam_db.study import Study, rounds, streamed, turning
from harness import Row

pytestmark = pytest.mark.thorough

LENGTH = 240
NAMES = [("b", "x"), ("a", "y"), ("a", "x"), ("c", "x"), ("b", "y")]  # the order of their turns

#: name -> keyword arguments of Parameters and of Calibration that are served
SERVED: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "delays": ({"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.4}),
    "one before": ({"m": 2, "tau": 1, "bins": 4, "window": 9, "stride": 3}, {"fraction": 0.3}),
    "one coordinate": ({"m": 1, "bins": 5, "window": 12, "stride": 4}, {"duration": 900}),
    "keys that fill a number": ({"m": 9, "bins": 100, "window": 12}, {"fraction": 0.4}),
    "an interval": ({"m": 2, "tau": 3, "bins": 4, "window": 9}, {"intervals": [(-5, 995)]}),
    "short calibration": ({"m": 4, "tau": 4, "bins": 3, "window": 6}, {"fraction": 0.02}),
    "all of it": ({"m": 2, "bins": 3, "window": 6}, {"fraction": 1.0}),
    "pools": ({"m": 3, "bins": 4, "window": 8, "stride": 2}, {"fraction": 0.3, "pool": "channel"}),
    "two sets": (
        {
            "m": 3,
            "bins": 4,
            "window": 8,
            "stride": 2,
            "overrides": [{"channel": "y", "m": 1, "bins": 6}],
        },
        {"fraction": 0.3},
    ),
}


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Turn short sources, too, and cut them into small pieces."""
    monkeypatch.setattr(turning, "TURNED_FROM", 1)
    monkeypatch.setattr(rounds, "PIECE", 100)
    monkeypatch.setattr(rounds, "MOST_PASSES", 4)


def taking_turns(missing: Sequence[int] = (), apart: int = 0) -> list[Row]:
    """One row of each channel per round, which is healthy to begin with.

    Args:
        missing: at which instants the first channel of all lacks a sample.
        apart: how much later than the channel before each one has its turn.
    """
    return [
        (*name, 10 * time + apart * place, sample(place, time) if place or time not in missing else None)
        for time in range(LENGTH)
        for place, name in enumerate(NAMES)
    ]


def sample(place: int, time: int) -> float:
    if place == 3:
        return 0.0  # never moves
    return float(time % (5 + place) if time < 120 or time % 7 else time % 11) - 0.25


def answers(
    session: Session, table: list[Row], method: tuple[Any, Any], asked: Sequence[str] = ()
) -> tuple[dict[str, Any], bool, bool]:
    """Return what a study answers, whether on trust, and whether by rounds."""
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True, asked=asked)
        questions = ("health_at_buckets", "support", "certificate")
        found = {name: study.table(harness.STEPS[name]).to_pylist() for name in questions}
        is_trusting = study.is_trusting
        by_rounds = study.method.named("rounds", 0) in study.running.placed
        found["health_indicator"] = study.table("health_indicator").to_pylist()
        study.forget()
    return found, is_trusting, by_rounds


def agrees(found: dict[str, Any], table: list[Row], method: tuple[Any, Any]) -> None:
    expected = harness.all_by_reference(table, *method)
    for question in harness.STEPS:
        harness.assert_same(expected[question], found[question], question)
    comparisons.compared("duckdb", "rounds", table, *method)


@pytest.mark.parametrize("asked", [(), ("bucket_health", "novel_cells")])
@pytest.mark.parametrize("missing", [(), (3, 4, 130, LENGTH - 1)])
@pytest.mark.parametrize("apart", [0, 1])
@pytest.mark.parametrize("case", SERVED)
def test_rounds_give_the_integers_of_the_reference(
    case: str, apart: int, missing: Sequence[int], asked: Sequence[str]
) -> None:
    """Whether or not the channels of a round have one instant, and samples are missing."""
    method = harness.made(*SERVED[case])
    table = taking_turns(missing, apart)
    found, is_trusting, by_rounds = answers(engines.session("duckdb"), table, method, asked)
    assert is_trusting
    # A round begins with the first turn of a set, and with what follows its calibration.
    assert by_rounds is not (apart == 1 and case in ("two sets", "one coordinate"))
    agrees(found, table, method)


@pytest.fixture
def parts(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """How many pieces each step was cut into."""
    seen: list[int] = []

    def noted(queries: Sequence[exp.Query], threads: int) -> exp.Query:
        seen.append(len(queries))
        return streamed.stacked(queries, threads)

    monkeypatch.setattr(rounds, "stacked", noted)
    return seen


@pytest.mark.parametrize("threads", [1, 2, 3, 5])
@pytest.mark.parametrize("case", SERVED)
def test_pieces_side_by_side_are_one(case: str, threads: int, parts: list[int]) -> None:
    """Also where a piece has no full bucket, or there are fewer buckets than threads."""
    method = harness.made(*SERVED[case])
    table = taking_turns()
    with DuckSession(threads=threads) as session:
        found, is_trusting, by_rounds = answers(session, table, method)
    assert is_trusting
    assert by_rounds
    assert bool(parts) is (threads > 1)
    assert all(2 <= number <= threads for number in parts)
    agrees(found, table, method)


def spread(table: list[Row], number: int) -> list[Row]:
    """The channels of one round have an instant each."""
    places = range(5 * number, 5 * number + 5)
    return [
        (*row[:2], row[2] + place % 5, row[3]) if place in places else row
        for place, row in enumerate(table)
    ]


@pytest.mark.parametrize("shift", [0, 1])
@pytest.mark.parametrize("case", ["delays", "one before", "one coordinate"])
def test_a_round_that_may_be_cut_is_found(case: str, shift: int, parts: list[int]) -> None:
    """Wherever it is: rounds are not cut by the time of their first channel."""
    method = harness.made(*SERVED[case])
    with DuckSession(threads=4) as session:
        for number in range(85 + shift, LENGTH + shift, 5):
            table = spread(taking_turns(), number)
            found, is_trusting, by_rounds = answers(session, table, method)
            assert is_trusting
            assert not by_rounds
            agrees(found, table, method)
    assert parts


@pytest.mark.parametrize(("apart", "missing"), [(1, ()), (0, (3, 130))])
def test_what_cannot_be_cut_is_whole(apart: int, missing: Sequence[int], parts: list[int]) -> None:
    """Turns at instants of their own end within a round; what lacks samples is numbered from one end."""
    method = harness.made(*SERVED["delays"])
    table = taking_turns(missing, apart)
    with DuckSession(threads=3) as session:
        found, is_trusting, by_rounds = answers(session, table, method, ("bucket_health",))
    assert is_trusting
    assert by_rounds
    assert parts == ([] if apart else [3])  # calibration is cut all the same
    agrees(found, table, method)


def proven(
    session: Session, table: list[Row], method: tuple[Any, Any]
) -> tuple[dict[str, Any], bool, bool]:
    """Return what a study answers that takes nothing on trust, and whether all rows are in turn, twice.

    That is before it is asked for what calibration teaches, and after.
    """
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True, on_trust=False)
        before = study.is_ordered
        questions = ("support", "certificate", "health_at_buckets", "health_indicator")
        found = {name: study.table(harness.STEPS[name]).to_pylist() for name in questions}
        after = study.is_ordered
        study.forget()
    return found, before, after


@pytest.mark.parametrize("missing", [(), (130,)])
@pytest.mark.parametrize("apart", [0, 1])
@pytest.mark.parametrize("case", SERVED)
def test_calibration_alone_is_proven_by_all_rows(case: str, apart: int, missing: Sequence[int]) -> None:
    method = harness.made(*SERVED[case])
    table = taking_turns(missing, apart)
    found, before, after = proven(engines.session("duckdb"), table, method)
    assert before is (case != "two sets" and not missing)
    assert after is before
    agrees(found, table, method)


def test_groups_of_channels_are_calibrated_one_after_another() -> None:
    """Others have their turns in the same rounds."""
    method = harness.made(*SERVED["delays"])
    table = taking_turns()
    session = engines.session("duckdb")
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True, on_trust=False)
        names = study.running.placed["names"]
        found = []
        for asset in "abc":
            study.begin_anew()
            own = exp.select("*").from_(names.copy()).where(exp.column("asset").eq(asset))
            study.running.placed["names"] = session.keep("wanted_names", own)
            found += study.table("support_summary").to_pylist()
            assert study.is_ordered
            session.forget(study.running.placed["names"])
        study.running.placed["names"] = names
        study.forget()
    harness.assert_same(harness.by_reference("support", table, *method), found)


def swapped(table: list[Row], one: int, other: int) -> list[Row]:
    table[one], table[other] = table[other], table[one]
    return table


def without(table: list[Row], *places: int) -> list[Row]:
    return [row for place, row in enumerate(table) if place not in places]


def renamed(table: list[Row], start: int) -> list[Row]:
    """From a row on, two channels have each other's turns."""
    other = {0: 1, 1: 0}
    return [
        table[place // 5 * 5 + other.get(place % 5, place % 5)] if place >= start else table[place]
        for place in range(len(table))
    ]


END = 5 * LENGTH - 1

#: Ways in which rows may lie otherwise than their first ones say; all channels have as many.
NEARLY: dict[str, Callable[[list[Row]], list[Row]]] = {
    "two of calibration turned round": lambda table: swapped(table, 211, 212),
    "two late ones turned round": lambda table: swapped(table, 900, 903),
    "the last two turned round": lambda table: swapped(table, END - 1, END),
    "one instant before another": lambda table: swapped(table, 700, 705),
    "other turns from the middle on": lambda table: renamed(table, 600),
    "one of each channel less": lambda table: without(table, 500, 601, 702, 803, 904),
    "the first row last": lambda table: [*table[1:], table[0]],
    "a round earlier than the one before": lambda table: [
        *table[:800],
        *table[805:810],
        *table[800:805],
        *table[810:],
    ],
    "one channel after another": lambda table: sorted(table, key=lambda row: row[:2]),
    "two by two": lambda table: sorted(table, key=lambda row: (row[0], row[2])),
    "shuffled": lambda table: random.Random(3).sample(table, len(table)),
}


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize("order", NEARLY)
def test_what_is_not_in_rounds_is_sorted(
    order: str, threads: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rounds, "GLANCE", 6)
    method = harness.made(*SERVED["delays"])
    table = NEARLY[order](taking_turns())
    with DuckSession(threads=threads) as session:
        found, is_trusting, by_rounds = answers(session, table, method)
    assert is_trusting
    assert not by_rounds
    agrees(found, table, method)


@pytest.mark.parametrize("order", NEARLY)
def test_calibration_alone_is_sorted_where_a_row_is_not_in_turn(
    order: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(rounds, "GLANCE", 6)
    method = harness.made(*SERVED["delays"])
    table = NEARLY[order](taking_turns())
    found, before, _ = proven(engines.session("duckdb"), table, method)
    assert not before
    agrees(found, table, method)


@pytest.mark.parametrize("row", [1, 6, 8])
def test_what_the_first_rows_show_is_not_tried(row: int) -> None:
    """Vectors are made once; names may differ by asset or by channel alone."""
    method, heard = harness.made(*SERVED["delays"]), list[str]()
    table = swapped(taking_turns(), row, row + 1)
    session = engines.session("duckdb")
    with session.lent(harness.arrow(table)) as lent:
        asked = gam_db.Source(lent.name), *method
        study = Study(session, *asked, on_step=heard.append, short_cuts=True)
        study.table("bucket_health")
        assert study.is_trusting
        study.forget()
    assert heard.count("learnable") == 1


@pytest.mark.parametrize("place", [2, 300, 1100])
def test_an_instant_that_occurs_twice_in_turn_is_found(place: int) -> None:
    """All channels have as many rows all the same: one of each comes again."""
    table = taking_turns()
    again = [(*row[:3], 7.5) for row in table[place // 5 * 5 : place // 5 * 5 + 5]]
    table[place // 5 * 5 : place // 5 * 5] = again
    method = harness.made(*SERVED["delays"])
    found, is_trusting, by_rounds = answers(engines.session("duckdb"), table, method)
    assert not is_trusting
    assert not by_rounds
    agrees(found, table, method)


def test_rows_that_come_in_any_order_are_sorted() -> None:
    """Where the session does not keep their order, the rows themselves show it."""
    table = taking_turns() * 1
    method = harness.made(*SERVED["delays"])
    with DuckSession(threads=3) as session:
        session.connection.execute("SET preserve_insertion_order = false")
        found, is_trusting, _ = answers(session, table, method)
    assert is_trusting
    agrees(found, table, method)


EDITS = st.lists(
    st.tuples(st.sampled_from(["swap", "drop", "again", "lack", "late"]), st.integers(0, END - 1)),
    max_size=6,
)


@settings(max_examples=max(1, settings().max_examples // 4))
@given(EDITS, st.sampled_from(list(SERVED)), st.integers(1, 4), st.integers(0, 2))
def test_whatever_is_changed_the_integers_are_those_of_the_reference(
    edits: list[tuple[str, int]], case: str, threads: int, apart: int
) -> None:
    table = taking_turns(apart=apart)
    for what, place in edits:
        place %= len(table) - 1
        row = table[place]
        if what == "swap":
            table = swapped(table, place, place + 1)
        elif what == "drop":
            table = without(table, place)
        elif what == "again":
            table.insert(place, (*row[:3], 7.5))
        elif what == "lack":
            table[place] = (*row[:3], None)
        else:
            table[place] = (*row[:2], row[2] + 5, row[3])
    method = harness.made(*SERVED[case])
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(rounds, "PIECE", 100)
        patched.setattr(rounds, "GLANCE", 6)
        with DuckSession(threads=threads) as session:
            found, _, _ = answers(session, table, method)
    agrees(found, table, method)


def test_far_turns_are_sorted(monkeypatch: pytest.MonkeyPatch) -> None:
    """DuckDB looks back no further than a vector of its own without putting rows in order."""
    monkeypatch.setattr(rounds, "FARTHEST", 5 * 4)
    method = harness.made(*SERVED["delays"])  # the oldest of a vector is four rounds back
    found, is_trusting, by_rounds = answers(engines.session("duckdb"), taking_turns(), method)
    assert is_trusting
    assert not by_rounds
    agrees(found, taking_turns(), method)


def test_as_far_as_it_looks_back_nothing_is_sorted() -> None:
    """What DuckDB's plan says of the farthest row; beyond it, windows are another operator."""
    with DuckSession() as session:
        plans = [
            str(session.connection.sql(f"SELECT LAG(i, {rows}) OVER () FROM range(9) AS t(i)").explain())
            for rows in (rounds.FARTHEST - 1, rounds.FARTHEST)
        ]
    assert ["Streaming Window" in plan for plan in plans] == [True, False]


def test_a_wide_table_is_in_rounds() -> None:
    """Its rows become one of each column, in their order; so many columns are unpivoted."""
    names = [f"c{number * 7 % UNPIVOTED_FROM}" for number in range(UNPIVOTED_FROM)]
    table: list[Row] = [
        ("asset", name, time, sample(place % 5, time))
        for time in range(LENGTH)
        for place, name in enumerate(names)
    ]
    columns = {name: [row[3] for row in table if row[1] == name] for name in names}
    wide = pa.table({"t": range(LENGTH), **columns})
    method = harness.made(*SERVED["delays"])
    with DuckSession(threads=2) as session, session.lent(wide) as lent:
        source = gam_db.WideSource(lent.name, asset=None, time="t", channels=names)
        study = Study(session, source, *method, short_cuts=True)
        found = study.table("bucket_health").to_pylist()
        assert study.is_trusting
        assert "rounds" in study.running.placed
        study.forget()
    harness.assert_same(harness.by_reference("health_at_buckets", table, *method), found)
