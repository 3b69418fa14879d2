"""The public calls in an open session: they equal the reference, and nothing is made twice."""

import functools
from collections import Counter
from typing import Any

import duckdb
import pytest
from sqlglot import exp

import engines
import gam_db
import harness
import scripts
from gam_db.clock import TimeKind
from gam_db.composing import pipeline, template
from gam_db.composing.pipeline import Pipeline
from gam_db.engines import base
from gam_db.engines.base import Engine
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method import Method
from gam_db.study import Study
from gam_db.study.steps import filled

ROWS: list[harness.Row] = [
    (asset, "x", time, float(time % 5 if time % 17 else time % 3))
    for asset in "ab"
    for time in range(60)
]
PARAMETERS = gam_db.Parameters(m=2, bins=4, window=6, overrides=[gam_db.Override("b*", bins=3)])
CALIBRATION = gam_db.Calibration(fraction=0.5, overrides={"a*": gam_db.Calibration(duration=20)})


@pytest.fixture
def made(monkeypatch: pytest.MonkeyPatch) -> Counter[str]:
    """Count what is made: trees that are filled, queries that are composed, texts that are written."""
    counts: Counter[str] = Counter()
    monkeypatch.setattr(base, "_TEXTS", {})  # of other tests nothing
    pipeline._filled.cache_clear()

    def counted(owner: Any, name: str) -> None:
        plain = getattr(owner, name)

        def counting(*arguments: Any, **named: Any) -> Any:
            counts[name] += 1
            return plain(*arguments, **named)

        monkeypatch.setattr(owner, name, counting)

    counted(template, "fill_template")
    counted(pipeline, "_composed")
    monkeypatch.setattr(pipeline, "_composed_once", functools.lru_cache(pipeline._composed))
    counted(Engine, "_written")
    return counts


def answers(session: Any, source: Any, parameters: gam_db.Parameters) -> dict[str, harness.Answer]:
    asked = (source, parameters, CALIBRATION, session)
    return {name: call(*asked).to_pylist() for name, (_, call) in harness.QUESTIONS.items()}


@pytest.mark.parametrize("kind", ["table", "arrow"])
def test_asking_again_composes_nothing(kind: str, engine: str, made: Counter[str]) -> None:
    session = engines.session(engine)
    table = scripts.telemetry(session, ROWS)
    source = gam_db.Source(table.name if kind == "table" else harness.arrow(ROWS))
    before = session.relations()
    filled.cache_clear()
    first = answers(session, source, PARAMETERS)
    for name, answer in harness.all_by_reference(ROWS, PARAMETERS, CALIBRATION).items():
        harness.assert_same(answer, first[name], name)
    assert set(made) == {"fill_template", "_composed", "_written"}
    made.clear()
    assert answers(session, source, PARAMETERS) == first
    assert not made
    other = answers(session, source, gam_db.Parameters(m=1, bins=4, window=6))
    assert set(made) == {"fill_template", "_composed", "_written"}
    assert other["health_indicator"] != first["health_indicator"]
    assert session.relations() == before  # what was kept on the way is gone
    scripts.clear(session, table.name, f"{table.name}none_")


def test_a_session_left_open_costs_the_next_one_nothing(made: Counter[str]) -> None:
    """It holds no number while it holds no table, so the next one's tables have the same names."""
    source = gam_db.Source("telemetry")
    with duckdb.connect() as connection, duckdb.connect() as other:
        for one in (connection, other):
            one.register("arriving", harness.arrow(ROWS))
            one.execute("CREATE TABLE telemetry AS SELECT * FROM arriving")
        first = answers(DuckSession(connection), source, PARAMETERS)
        assert made
        made.clear()
        assert answers(DuckSession(other), source, PARAMETERS) == first
        assert not made


def test_what_is_added_to_one_study_is_not_in_the_next() -> None:
    session = engines.session("duckdb")
    with session.lent(harness.arrow(ROWS)) as table:
        asked = (session, gam_db.Source(table.name), PARAMETERS, CALIBRATION)
        for column in ("settings_no", "calibration_no"):
            one = Study(*asked)
            one.steps.add("added", exp.select(column).from_("channels"))
            assert one.table("added").column_names == [column]
            one.forget()
        assert "added" not in Study(*asked).steps.steps


def test_a_query_reads_the_table_that_is_placed_now() -> None:
    """Also where what is placed is no step, as the rows that a run brings with it."""
    steps = Pipeline()
    steps.add("counted", exp.select("a").from_("stamp"))
    steps.add("shown", exp.select("a").from_("counted"))
    for name in ("one", "another"):
        query = steps.query("shown", {"stamp": exp.to_table(name)})
        assert name in {table.name for table in query.find_all(exp.Table)}


def test_a_method_is_data() -> None:
    """Equal where the same steps follow, whatever the user's objects are; else not."""

    def method(**changed: Any) -> Method:
        rules = {"b?": None, "c": gam_db.Calibration(fraction=0.3)} | changed
        return Method(PARAMETERS, gam_db.Calibration(overrides=rules), TimeKind.COUNTER)

    assert method() == method()
    assert len({method(), method(), method(d=None), method(c=None)}) == 3
    with_pool = gam_db.Calibration(pool="channel")
    assert Method(PARAMETERS, with_pool, TimeKind.COUNTER) != Method(
        PARAMETERS, gam_db.Calibration(), TimeKind.COUNTER
    )
