"""Guessing columns: small tables of names and types, and what is made of them."""

import pyarrow as pa
import pytest

from gam_db import Source, WideSource
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import SourceError
from gam_db.reading.guess import Guess, SourceSettings, guess

STAMP, WHOLE, REAL, TEXT = "TIMESTAMP", "BIGINT", "DOUBLE", "VARCHAR"


def guessed(columns: dict[str, str], said: SourceSettings | None = None) -> Guess:
    """The guess for a table of these columns."""
    with DuckSession() as session:
        return guess("r", columns, said or SourceSettings(), session)


@pytest.mark.parametrize(
    ("columns", "expected"),
    [
        ({"asset": TEXT, "channel": TEXT, "time": WHOLE, "value": REAL}, Source("r")),
        (
            {"Machine_ID": WHOLE, "Sensor Name": TEXT, "TS": STAMP, "Reading": REAL},
            Source("r", "Machine_ID", "Sensor Name", "TS", "Reading"),
        ),
        # one machine, one signal: the commonest newcomer
        ({"t": WHOLE, "x": REAL}, Source("r", None, None, "t", "x")),
        ({"Zeitpunkt": STAMP, "Strom": REAL}, Source("r", None, None, "Zeitpunkt", "Strom")),
        # strong names before weak ones, and a calendar before a counter
        (
            {"machine": TEXT, "unit": TEXT, "tag": TEXT, "time": STAMP, "step": WHOLE, "value": REAL},
            Source("r", "machine", "tag", "time", "value"),
        ),
        ({"index": WHOLE, "gemessen": STAMP, "value": REAL}, Source("r", None, None, "gemessen")),
        # other numbers beside a column called value
        ({"time": STAMP, "value": REAL, "quality": WHOLE}, Source("r", None, None)),
        # several numbers, no name of a signal
        (
            {"robot": TEXT, "ts": STAMP, "current": REAL, "torque": REAL},
            WideSource("r", ("current", "torque"), "robot", "ts"),
        ),
        ({"time": WHOLE, "x": REAL, "y": REAL}, WideSource("r", ("x", "y"), None, "time")),
        # with a signal's name, x is a reading
        (
            {"joint": WHOLE, "time": WHOLE, "x": REAL, "error": REAL},
            Source("r", None, "joint", "time", "x"),
        ),
    ],
)
def test_what_is_guessed(columns: dict[str, str], expected: Source | WideSource) -> None:
    assert guessed(columns).source == expected


@pytest.mark.parametrize(
    ("columns", "asks_for"),
    [
        ({"time": STAMP, "timestamp": STAMP, "value": REAL}, "--time"),
        ({"begin": STAMP, "end": STAMP, "value": REAL}, "--time"),
        ({"when_it_was": TEXT, "value": REAL}, "--time"),
        ({"time": STAMP, "machine": TEXT, "robot": TEXT, "value": REAL}, "--asset"),
        ({"time": STAMP, "sensor": TEXT, "tag": TEXT, "machine": TEXT, "value": REAL}, "--channel"),
        # text that nobody explained could name machines: leaving it out would mix them
        ({"time": STAMP, "wo": TEXT, "value": REAL}, "--asset"),
        ({"time": STAMP, "wo": TEXT, "a": REAL, "b": REAL}, "--asset"),
        ({"time": STAMP, "machine": TEXT, "sensor": TEXT, "a": REAL, "b": REAL}, "--value"),
        ({"time": STAMP, "machine": TEXT, "sensor": TEXT}, "--value"),
        ({"time": STAMP, "machine": TEXT}, "--value"),
    ],
)
def test_what_cannot_be_told_is_asked_for(columns: dict[str, str], asks_for: str) -> None:
    """The message names the option, and lists the columns with their types."""
    with pytest.raises(SourceError) as caught:
        guessed(columns)
    assert f"give {asks_for} COLUMN" in caught.value.options
    for name, type_name in columns.items():
        assert f"{name} ({type_name})" in str(caught.value)


def test_what_is_said_is_not_guessed() -> None:
    said = SourceSettings(asset=False, channel="b", time="d", where="e > 0", time_kind="counter")
    found = guessed({"asset": TEXT, "b": TEXT, "time": STAMP, "d": WHOLE, "e": REAL}, said)
    assert found.source == Source("r", None, "b", "d", "e", "e > 0", "counter")
    assert found.guessed == {"value": "e"}
    assert found.unused == ("asset", "time")


def test_no_column_is_used_twice() -> None:
    """The time is called value here; what is left is the reading."""
    found = guessed({"value": STAMP, "other": REAL}, SourceSettings(time="value"))
    assert found.source == Source("r", None, None, "value", "other")


def test_a_wide_table_can_be_said() -> None:
    said = SourceSettings(layout="wide", channels=("b", "value"))
    found = guessed({"time": STAMP, "value": REAL, "b": REAL, "c": REAL}, said)
    assert found.source == WideSource("r", ("b", "value"), None, "time")
    assert found.unused == ("c",)
    found = guessed({"time": STAMP, "value": REAL}, SourceSettings(layout="wide"))
    assert found.source == WideSource("r", ("value",), None, "time")


@pytest.mark.parametrize(
    "said",
    [
        SourceSettings(asset="machin"),
        SourceSettings(time="machin"),
        SourceSettings(channels=("machin",)),
    ],
)
def test_a_mistyped_column_is_suggested(said: SourceSettings) -> None:
    with pytest.raises(SourceError, match=r"'machin' .* did you mean 'machine'"):
        guessed({"machine": TEXT, "time": STAMP, "value": REAL}, said)


def test_guessing_takes_the_types_of_the_session() -> None:
    """What DuckDB says of a real table is understood."""
    table = pa.table({"robot": pa.array(["a"]).dictionary_encode(), "tick": [1], "level": [0.5]})
    with DuckSession() as session:
        columns = session.describe(session.relation(table))
        found = guess(table, columns, SourceSettings(), session)
    assert found.source == Source(table, "robot", None, "tick", "level")
