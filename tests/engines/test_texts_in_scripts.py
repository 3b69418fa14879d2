"""A script meets a text where a number or time must be: it fails, and never counts a part of it."""

from typing import Any

import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db import Source

# Of the robust range one exact query is large, and takes ClickHouse minutes to plan.
SMALL = gam_db.Parameters(m=1, tau=1, bins=4, window=2, range="min_max")
WORDS = ["1.5abc", "1,5", "5%", "TRUE", "0x1G", "Bad"]
TIMES = ["12:00:00 PM", "2026-03-03 12:00:00 extra", "03.03.26", "7 of 9"]


def table(engine: str, time: list[Any], value: list[Any], of: dict[str, str]) -> tuple[Any, str]:
    """A table of an engine with columns of some types, as somebody else made it."""
    session, name = engines.session(engine), engines.fresh_name("words")
    rows = []
    for at, reading in zip(time, value, strict=True):
        nodes = {"time": at, "value": reading}
        typed = [exp.cast(exp.convert(node), of[column]).as_(column) for column, node in nodes.items()]
        rows.append(exp.select(*typed))
    made = session.engine.create_table(exp.to_table(name), exp.union(*rows, distinct=False))
    session.execute(made)
    return session, name


def dropped(session: Any, name: str) -> None:
    session.execute(exp.Drop(tables=[exp.to_table(name)], kind="TABLE", exists=True))


@pytest.mark.parametrize("word", WORDS)
def test_a_text_is_no_number(engine: str, word: str) -> None:
    texts = [str(place % 5) for place in range(9)]
    session, name = table(
        engine, list(range(10)), [*texts, word], {"time": "BIGINT", "value": "VARCHAR"}
    )
    try:
        source = Source(name, None, None, time_kind="counter")
        with pytest.raises(session.driver.errors):
            scripts.fetched(session, gam_db.render("exact", session.engine.name, source, SMALL))
    finally:
        dropped(session, name)


@pytest.mark.parametrize("kind", ["counter", "timestamp"])
@pytest.mark.parametrize("word", TIMES)
def test_a_text_is_no_time(engine: str, word: str, kind: str) -> None:
    texts = [f"2026-03-03 10:00:0{place}" for place in range(9)]
    types = {"time": "VARCHAR", "value": "DOUBLE"}
    session, name = table(engine, [*texts, word], [place % 5 for place in range(10)], types)
    try:
        source = Source(name, None, None, time_kind=kind)
        with pytest.raises(session.driver.errors):
            scripts.fetched(session, gam_db.render("exact", session.engine.name, source, SMALL))
    finally:
        dropped(session, name)
