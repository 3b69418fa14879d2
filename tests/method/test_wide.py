"""Wide sources of many columns, which some engines turn into rows by themselves."""

import pyarrow as pa
import pyarrow.compute as pc
import pytest

import comparisons
import engines
import gam_db
import harness
from gam_db.clock import TimeKind
from gam_db.settings import source
from harness import Row

#: Names that end a text or a name, that are wildcards, or names of ours.
NAMES = ["x", "it's", 'a "b"', "50 %", "c d", "column_1", "asset", "ß"]
LENGTH = 40


def value(number: int, time: int) -> float | None:
    if (number + time) % 17 == 0:
        return None
    return float((time * (number + 1)) % (5 + number) - 0.5)


def table(names: list[str]) -> tuple[pa.Table, list[Row]]:
    """A wide table of two machines, and its rows as a long one has them."""
    times = [(asset, time) for time in range(LENGTH) for asset in ("m 1", "m'2")]
    columns = {
        name: [value(number + len(asset), time) for asset, time in times]
        for number, name in enumerate(names)
    }
    wide = pa.table({"machine": [one for one, _ in times], "t": [one for _, one in times], **columns})
    rows = [
        (asset, name, time, columns[name][place])
        for place, (asset, time) in enumerate(times)
        for name in names
        if time > 2
    ]
    return wide, rows


@pytest.mark.parametrize("asset", ["machine", None])
def test_many_columns_are_read_as_few_are(engine: str, asset: str | None) -> None:
    names = [*NAMES, *(f"c{number}" for number in range(source.UNPIVOTED_FROM - len(NAMES)))]
    wide, rows = table(names)
    if asset is None:
        wide = wide.filter(pc.equal(wide["machine"], "m 1"))
        rows = [("asset", *row[1:]) for row in rows if row[0] == "m 1"]
    method = gam_db.Parameters(m=2, bins=4, window=6), gam_db.Calibration(fraction=0.5)
    session = engines.session(engine)
    with session.lent(wide.select(["t", *names] if asset is None else wide.column_names)) as lent:
        asked = gam_db.WideSource(lent.name, asset=asset, time="t", channels=names, where="t > 2")
        is_one_select = "UNPIVOT" in session.engine.text(
            session.engine.readings(asked, lent, TimeKind.COUNTER)
        )
        found = gam_db.health_at_buckets(asked, *method, session).to_pylist()
        told = gam_db.support(asked, *method, session).to_pylist()
    assert is_one_select == session.engine.unpivots
    harness.assert_same(harness.by_reference("health_at_buckets", rows, *method), found)
    harness.assert_same(harness.by_reference("support", rows, *method), told)
    comparisons.compared(engine, "wide", rows, *method)


def test_a_union_has_no_more_branches_than_an_engine_takes(
    engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unions of unions give the same; the last of them may have one branch alone."""
    monkeypatch.setattr(source, "MOST_BRANCHES", 3)
    names = NAMES[:7]
    wide, rows = table(names)
    method = gam_db.Parameters(m=2, bins=4, window=6), gam_db.Calibration(fraction=0.5)
    session = engines.session(engine)
    with session.lent(wide) as lent:
        asked = gam_db.WideSource(lent.name, asset="machine", time="t", channels=names, where="t > 2")
        found = gam_db.health_at_buckets(asked, *method, session).to_pylist()
    harness.assert_same(harness.by_reference("health_at_buckets", rows, *method), found)
    comparisons.compared(engine, "wide", rows, *method)


def test_sqlite_reads_a_source_of_more_columns_than_a_union_has_branches() -> None:
    names = [f"c{number}" for number in range(501)]
    wide, _ = table(names)
    method = gam_db.Parameters(m=2, bins=4, window=6), gam_db.Calibration(fraction=0.5)
    answers = []
    for engine in ("sqlite", "duckdb"):
        session = engines.session(engine)
        with session.lent(wide) as lent:
            asked = gam_db.WideSource(lent.name, asset="machine", time="t", channels=names)
            answers.append(gam_db.support(asked, *method, session).to_pylist())
    harness.assert_same(*answers)
    assert len(answers[0]) == 1002
