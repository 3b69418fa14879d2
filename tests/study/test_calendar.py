"""Calendar time on the steps that large sources take: the integers of a counter of microseconds.

Each kind of time is asked for by its own expressions and bounds, on each engine, whichever body serves.
"""

import datetime as dt
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
import strategies
from calendar_cases import Calendar
from gam_db.engines.session import Session
from gam_db.study import Study, naming
from harness import Row

pytestmark = pytest.mark.thorough

METHOD = harness.made({"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5}, {"fraction": 0.4})

Method = tuple[Any, Any]

#: Of what the times of a source are.
KINDS = {
    "microseconds": pa.timestamp("us"),
    "with a zone": pa.timestamp("us", "UTC"),
    "nanoseconds": pa.timestamp("ns"),
    "nanoseconds with a zone": pa.timestamp("ns", "UTC"),
}

#: engine -> the kinds that it tells apart; a column of any other is lent to it as one of these.
APART: dict[str, tuple[str, ...]] = {
    "duckdb": tuple(KINDS),
    "sqlite": ("microseconds",),
    "postgres": ("microseconds", "with a zone"),
    "mariadb": ("microseconds",),
    "clickhouse": tuple(KINDS),
    "spark": ("microseconds",),
}

#: When a source begins: in our days, and so that it passes an instant at which a formula changes.
BEGINS = {
    "in our days": dt.datetime(2026, 11, 26, 12),
    "across 1900": dt.datetime(1899, 12, 31, 23, 59),
    "across 1970": dt.datetime(1969, 12, 31, 23, 59),
    "across 2040": dt.datetime(2039, 12, 31, 23, 59),
}


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Take short sources for large ones."""
    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 100)
    monkeypatch.setattr(naming, "EVERY", 8)


def rows(begin: dt.datetime, by_time: bool) -> list[Row]:
    """Channels of a sample in 0.7 s less 5 microseconds, that repeat a pattern, and later on less so."""
    table: list[Row] = [
        (asset, "x", time, float(time % (5 + number) if time < 100 else time % 11))
        for number, asset in enumerate("abc")
        for time in range(200)
    ]
    table = Calendar(begin, 699_995).rows(table)
    return sorted(table, key=lambda row: row[2]) if by_time else table


def source(rows: list[Row], kind: pa.DataType) -> pa.Table:
    """Return rows as a source whose times are of a kind."""
    table = harness.arrow(rows)
    return table.set_column(2, "time", table["time"].cast(pa.timestamp("us")).cast(kind))


def counted(answer: pa.Table) -> list[dict[str, Any]]:
    """Return an answer with its instants as microseconds."""
    for number, column in enumerate(answer.schema):
        if pa.types.is_timestamp(column.type):
            micros = answer.column(number).cast(pa.timestamp("us", column.type.tz)).cast(pa.int64())
            answer = answer.set_column(number, column.name, micros)
    found: list[dict[str, Any]] = answer.to_pylist()
    return found


def agrees(engine: str, told: list[Row], kind: str, counting: Method, method: Method) -> None:
    """Compare what is answered on trust, or in stored order, with the reference of a counter."""
    session = engines.session(engine)
    with session.lent(source(told, KINDS[kind])) as lent:
        study = Study(
            session,
            gam_db.Source(lent.name, clock_tolerance=False),
            *method,
            short_cuts=True,
            targets=["bucket_health"],
        )
        for question in ("health_at_buckets", "support"):
            expected = harness.by_reference(question, told, *counting)
            found = counted(study.table(harness.STEPS[question]))
            harness.assert_same(expected, found, f"{question}, {kind}")
            assert study.form in ("census", "streams")
        study.forget()
    comparisons.compared(engine, "calendar", told, *method)


@pytest.mark.parametrize("by_time", [False, True], ids=["by channel", "by time"])
@pytest.mark.parametrize("begin", BEGINS)
def test_it_gives_the_integers_of_a_counter(engine: str, begin: str, by_time: bool) -> None:
    for kind in APART[engine]:
        agrees(engine, rows(BEGINS[begin], by_time), kind, METHOD, METHOD)


def test_what_is_not_told_apart_is_one_column(engine: str) -> None:
    session, told = engines.session(engine), rows(BEGINS["in our days"], by_time=True)
    found = {}
    for kind, of_arrow in KINDS.items():
        with session.lent(source(told, of_arrow)) as lent:
            study = Study(session, gam_db.Source(lent.name, clock_tolerance=False), *METHOD)
            time = session.fetch(exp.select("time").from_(lent)).column("time")
            found[kind] = study.method.kind, time.type, time.cast(pa.int64())[0].as_py()
            study.forget()
    assert set(found.values()) == {found[kind] for kind in APART[engine]}
    assert len(set(found.values())) == len(APART[engine])


def test_calibration_may_reach_beyond_what_a_column_can_tell(engine: str) -> None:
    """Nanoseconds in 64 bits end in 1677 and 2262."""
    calendar = Calendar(BEGINS["in our days"], 1)
    told = rows(calendar.begin, by_time=True)
    said = {"m": 2, "bins": 4, "window": 20}, {"intervals": [(-(2**54), 70_000_000)]}  # 571 years before
    methods = harness.made(*calendar.in_micros(*said)), harness.made(*calendar.in_words(*said))
    for kind in APART[engine]:
        agrees(engine, told, kind, *methods)


def test_random_cases_give_the_integers_of_a_counter(engine: str) -> None:
    @settings(max_examples=engines.examples(engine))
    @given(
        case=strategies.cases(),
        kind=st.sampled_from(list(KINDS)),
        calendar=st.builds(
            Calendar,
            st.sampled_from(list(BEGINS.values())),
            st.sampled_from([1, 999_983, 3_600_000_000]),
        ),
    )
    def agreeing(case: strategies.Case, kind: str, calendar: Calendar) -> None:
        given_rows, *said = case
        told = calendar.rows(given_rows)
        expected = harness.all_by_reference(told, *harness.made(*calendar.in_micros(*said)))
        method = harness.made(*calendar.in_words(*said))
        found = answers(engines.session(engine), source(told, KINDS[kind]), method)
        for question in harness.STEPS:
            harness.assert_same(expected[question], found[question], question)
        comparisons.compared(engine, "calendar", told, *method)

    agreeing()


def answers(session: Session, telemetry: pa.Table, method: Method) -> dict[str, list[dict[str, Any]]]:
    """Return what a study of calendar time answers, instants as microseconds."""
    with session.lent(telemetry) as lent:
        study = Study(session, gam_db.Source(lent.name, clock_tolerance=False), *method, short_cuts=True)
        found = {question: counted(study.table(step)) for question, step in harness.STEPS.items()}
        study.forget()
    return found
