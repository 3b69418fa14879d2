"""Names that are counted channel by channel are those of one grouping, or there are none."""

from collections.abc import Iterator, Sequence
from typing import Any

import duckdb
import pytest

from gam_db.clock import TimeKind
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.session import DuckSession
from gam_db.method import opening_pipeline
from gam_db.settings.source import Source
from gam_db.study import naming, streamed
from gam_db.study.running import Running
from harness import Row

pytestmark = pytest.mark.thorough

NAMES = ("asset", "channel", "readings", "without_time", "missing_readings", "earliest", "latest")


@pytest.fixture
def session(monkeypatch: pytest.MonkeyPatch) -> Iterator[DuckSession]:
    """An engine where short channels are counted one by one, and one of four rows is looked at."""
    monkeypatch.setattr(naming, "STREAMED_FROM", 2)
    monkeypatch.setattr(naming, "GLANCE", 6)
    monkeypatch.setattr(naming, "EVERY", 4)
    with duckdb.connect() as connection, DuckSession(connection) as session:
        yield session


def steps(session: DuckSession, table: Sequence[Row], columns: str = "") -> Pipeline:
    """Store rows and return the steps that count their names."""
    ask: Any = session.connection.execute
    ask("CREATE TABLE telemetry (asset TEXT, channel TEXT, time BIGINT, value DOUBLE)")
    for row in table:
        ask("INSERT INTO telemetry VALUES (?, ?, ?, ?)", row)
    if columns:
        ask(f"ALTER TABLE telemetry ADD COLUMN {columns}")
    relation = session.relation("telemetry")
    where = f'"{columns.split()[0]}" IS NULL' if columns else None
    source = Source("telemetry", where=where)
    return opening_pipeline(ENGINE.readings(source, relation, TimeKind.COUNTER))


def channels(*lengths: int) -> list[Row]:
    """Channels one after another; one has a missing reading, and an instant that occurs twice."""
    rows: list[Row] = [
        (f"a{number // 2}", "xy"[number % 2], time, float(time))
        for number, length in enumerate(lengths)
        for time in range(length)
    ]
    rows[5] = (*rows[5][:3], None)
    rows[8] = (*rows[8][:2], 7, 1.0)
    return rows


def grouped(session: DuckSession, made: Pipeline) -> list[Row]:
    """Return the names as one grouping counts them."""
    return sorted(tuple(row.values()) for row in session.rows(made.query("names")))


@pytest.mark.parametrize("columns", ["", "asked_lo DOUBLE", "ASKED_channel INT"])
def test_channels_are_counted_one_by_one(session: DuckSession, columns: str) -> None:
    """A column of the user's may be called as we call what is asked of each."""
    made = steps(session, channels(12, 12, 20), columns)
    found = naming.counted(Running(session, made), is_proven=True)
    assert found is not None
    assert sorted(tuple(row[one] for one in NAMES) for row in found.to_pylist()) == grouped(
        session, made
    )
    assert {(row["asset"], row["channel"]): row["in_order"] for row in found.to_pylist()} == {
        **{("a0", "x"): 0, ("a0", "y"): 1, ("a1", "x"): 1}
    }


@pytest.mark.parametrize("is_proven", [False, True])
def test_a_name_that_no_row_looked_at_has_is_found(session: DuckSession, is_proven: bool) -> None:
    made = steps(session, [*channels(12, 12, 20), ("b", "x", 0, 1.0)])
    found = naming.counted(Running(session, made), is_proven=is_proven)
    assert found is not None
    assert ("in_order" in found.column_names) == is_proven
    assert sorted(tuple(row[one] for one in NAMES) for row in found.to_pylist()) == grouped(
        session, made
    )


@pytest.mark.parametrize("is_proven", [False, True])
def test_a_row_without_a_name_is_counted_or_all_are_left(session: DuckSession, is_proven: bool) -> None:
    made = steps(session, [*channels(12, 12, 20), (None, "x", 0, 1.0)])  # type: ignore[list-item]
    found = naming.counted(Running(session, made), is_proven=is_proven)
    assert (found is None) == is_proven
    if found is not None:
        assert {row["asset"]: row["readings"] for row in found.to_pylist()}[None] == 1


@pytest.mark.parametrize("is_proven", [False, True])
def test_a_missing_name_is_not_taken_for_an_empty_one(session: DuckSession, is_proven: bool) -> None:
    """As many rows have either: counted twice, the empty name would make up for the missing one."""
    table: list[Any] = [(asset, "x", time, 1.0) for asset in ("", None) for time in range(12)]
    assert naming.counted(Running(session, steps(session, table)), is_proven=is_proven) is None


def test_rows_that_come_meanwhile_are_not_lost(
    session: DuckSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are counted by the grouping that follows; or it is said that they cannot be counted so."""
    made = steps(session, channels(12, 12, 20))
    number = iter(range(99))

    def later(*arguments: Any, **named: Any) -> Any:
        row = ("a0", "x", 100 + next(number), 2.0)
        session.connection.execute("INSERT INTO telemetry VALUES (?, ?, ?, ?)", row)
        return streamed.of_each(*arguments, **named)

    monkeypatch.setattr(naming, "of_each", later)
    found = naming.counted(Running(session, made))
    assert found is not None
    assert sum(found["readings"].to_pylist()) == 45
    assert naming.counted(Running(session, made), is_proven=True) is None


def test_what_seems_to_lie_otherwise_is_left(session: DuckSession) -> None:
    table = channels(12, 12, 20)
    by_time = sorted(table, key=lambda row: row[2])
    made = steps(session, by_time)
    assert naming.counted(Running(session, made)) is None
    session.connection.execute("DROP TABLE telemetry")
    in_pieces = [*table[8:], *table[:8]]
    made = steps(session, in_pieces)
    assert naming.counted(Running(session, made)) is None
    session.connection.execute("DROP TABLE telemetry")
    made = steps(session, [("a", "x", 0, 1.0)])
    assert naming.counted(Running(session, made)) is None
