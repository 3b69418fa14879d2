"""Plans: which statements there are, and in which order."""

import pytest
from sqlglot import parse_one

from gam_db.composing.pipeline import Pipeline
from gam_db.composing.plan import Kind, Plan, Statement
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConflictError, InternalError
from gam_db.study.running import Running


def steps() -> Pipeline:
    """Numbers, their squares (small), the large ones of these, and their sum."""
    made = Pipeline(small=frozenset({"squares"}))
    for name, query in (
        ("numbers", "SELECT 1 AS n UNION ALL SELECT 2 AS n"),
        ("squares", "SELECT n * n AS n FROM numbers"),
        ("large", "SELECT n FROM squares WHERE n > 3"),
        ("total", "SELECT SUM(n) AS n FROM squares"),
    ):
        made.add(name, parse_one(query, dialect="duckdb"))  # type: ignore[arg-type]
    return made


def test_small_named_queries_become_tables_before_they_are_read() -> None:
    verify = Statement("large", Kind.VERIFY, failure=lambda _: ConflictError("large"))
    plan = Plan.of(steps(), [Statement("total", Kind.ANSWER), verify])
    listed = [(statement.name, statement.kind, statement.is_input) for statement in plan.statements]
    assert listed == [
        ("squares", Kind.TABLE, True),
        ("total", Kind.ANSWER, False),
        ("large", Kind.VERIFY, False),
    ]
    given = Plan.of(steps(), [Statement("total", Kind.ANSWER)], {"squares"})
    assert [statement.name for statement in given.statements] == ["total"]


def test_nothing_is_appended_before_every_verify() -> None:
    append = Statement("total", Kind.APPEND, "run")
    verify = Statement("large", Kind.VERIFY, failure=lambda _: ConflictError("large"))
    assert len(Plan.of(steps(), [verify, append]).statements) == 3
    with pytest.raises(InternalError, match="verifies before it appends"):
        Plan.of(steps(), [append, verify])


def test_the_loop_answers_and_stops_at_a_row_of_a_verify() -> None:
    with DuckSession() as session, Running(session, Pipeline()) as running:
        answer = Statement("total", Kind.ANSWER)
        assert running.execute(Plan.of(steps(), [answer])) == {"total": [{"n": 5}]}
        failing = Statement("large", Kind.VERIFY, failure=lambda rows: ConflictError(str(rows[0]["n"])))
        with pytest.raises(ConflictError, match="4"):
            running.execute(Plan.of(steps(), [failing, answer]))
        # A query of one execution stands for the named one.
        none = parse_one("SELECT n FROM squares WHERE n > 9", dialect="duckdb")
        answers = running.execute(Plan.of(steps(), [failing, answer]), {"large": none})  # type: ignore[dict-item]
        assert answers == {"total": [{"n": 5}]}
        assert running.materialized() == ["squares"]
