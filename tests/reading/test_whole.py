"""A conversion takes a value whole, or names it: times, counts and numbers in files and text columns."""

import datetime as dt
import sqlite3
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from pyarrow import parquet

import gam_db
from as_read import micros, read
from gam_db import Source
from gam_db.errors import SourceError

ROWS = 30_000  # more than a reader of text files looks at before it decides
START = dt.datetime(2026, 3, 3)
ISO = "%Y-%m-%d %H:%M:%S"

#: How the words of a column reach the method, each to the relation and the engine.
Reader = Callable[[Path, Sequence[str], Sequence[Any]], tuple[Any, Any]]


def as_csv(folder: Path, times: Sequence[str], values: Sequence[Any]) -> tuple[Any, Any]:
    path = folder / "words.csv"
    lines = (f'"{time}","{value}"' for time, value in zip(times, values, strict=True))
    path.write_text("\n".join(["time,value", *lines]) + "\n")
    return path, None


def as_parquet(folder: Path, times: Sequence[str], values: Sequence[Any]) -> tuple[Any, Any]:
    path = folder / "words.parquet"
    parquet.write_table(pa.table({"time": times, "value": values}), path)
    return path, None


def as_arrow(_: Path, times: Sequence[str], values: Sequence[Any]) -> tuple[Any, Any]:
    return pa.table({"time": times, "value": values}), None


def as_table(_: Path, times: Sequence[str], values: Sequence[Any]) -> tuple[Any, Any]:
    connection = duckdb.connect()
    words = pa.table({"time": times, "value": values})  # noqa: F841 (DuckDB reads it by its name)
    connection.execute("CREATE TABLE words AS FROM words")
    return "words", connection


READERS: dict[str, Reader] = {"csv": as_csv, "parquet": as_parquet, "arrow": as_arrow, "table": as_table}


def series(way: str, count: int = 100) -> list[str]:
    return [(START + dt.timedelta(minutes=20 * place)).strftime(way) for place in range(count)]


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize(
    ("way", "proposed"),
    [
        ("%Y-%m-%d %I:%M:%S %p", "'%Y-%m-%d %I:%M:%S %p' would"),
        ("%Y-%m-%d %I:%M %p", "'%Y-%m-%d %I:%M %p' would"),
        ("%d.%m.%y %H:%M:%S", "'%d.%m.%y %H:%M:%S' or time_format='%y.%m.%d %H:%M:%S' would"),
        ("%d/%m/%y %H:%M:%S", "'%d/%m/%y %H:%M:%S' or .*'%y/%m/%d %H:%M:%S' would .* choose one"),
        ("%d/%m/%y %H:%M", "'%d/%m/%y %H:%M' or .*'%y/%m/%d %H:%M' would .* choose one"),
        ("%d-%b-%Y %H:%M", "'%d-%b-%Y %H:%M' would"),
    ],
)
def test_a_time_is_read_whole_or_its_format_is_proposed(
    reader: str, way: str, proposed: str, tmp_path: Path
) -> None:
    """28 days, day first; once the option is given all is read as it was written."""
    times = series(way, 2000)
    relation, engine = READERS[reader](tmp_path, times, [float(place) for place in range(2000)])
    with pytest.raises(SourceError, match=f"2,000 of 2,000 values do not fit, .*{proposed}"):
        read(relation, engine)
    found = read(relation, engine, time_format=way)
    assert found == [
        (micros(START + dt.timedelta(minutes=20 * place)), float(place)) for place in range(2000)
    ]


ODD = ["12:00:00 PM", "2026-03-03 12:00:00 PM", "2026-03-03 extra", "2026-03-03 12:00:00 extra"]
ODD += ["03.03.26", "03/03/26 12:00", "26-03-03 12:00:00", "2026-02-30", "2026-03-03 12:00:00,5", "now"]
ODD += ["2026-03-03 12:00:00 CET", "2026-03-03T12", "infinity", "epoch", "2026-03-03 12:00:00+1", "0x10"]


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("word", ODD)
def test_a_time_that_fits_only_in_part_is_named(reader: str, word: str, tmp_path: Path) -> None:
    times = [*series(ISO), word, word]
    relation, engine = READERS[reader](tmp_path, times, [1.0] * len(times))
    with pytest.raises(SourceError, match="2 of 102 values do not fit, the first is '") as caught:
        read(relation, engine)
    assert f"'{word}', 2 times" in str(caught.value)


@pytest.mark.parametrize("word", ["2026-03-03 12:00:00 PM", "26/03/03 12:00:00", "03/03/26 12:00"])
def test_a_time_far_down_a_file_is_read_whole_or_named(word: str, tmp_path: Path) -> None:
    relation, _ = as_csv(tmp_path, [*series(ISO, ROWS), word], [1] * (ROWS + 1))
    with pytest.raises(SourceError, match=f"1 of 30,001 values do not fit, the first is '{word}'"):
        read(relation)
    with pytest.raises(
        SourceError, match="1 of 73 values"
    ):  # a condition on times does not leave it out
        read(relation, where="time < TIMESTAMP '2026-03-04'")


def test_an_offset_far_down_a_file_is_heeded(tmp_path: Path) -> None:
    times = [
        *series(ISO, ROWS),
        "2026-06-01 12:00:00+02:00",
        "2026-06-01T12:00:00Z",
        "2026-06-01 12:00 UTC",
    ]
    relation, _ = as_csv(tmp_path, times, [1] * len(times))
    ten, noon = (micros(dt.datetime(2026, 6, 1, hour)) for hour in (10, 12))
    assert [time for time, _ in read(relation)[-3:]] == [ten, noon, noon]


@pytest.mark.parametrize("word", ["1.5", "0x10", "1e5", "7 of 9", "5%", "TRUE"])
def test_a_count_that_is_none_is_named(word: str, tmp_path: Path) -> None:
    relation, _ = as_csv(tmp_path, [*map(str, range(ROWS)), word], [1] * (ROWS + 1))
    with pytest.raises(SourceError, match=f"a counter, must be an integer: 1 of 30,001 .* '{word}'"):
        read(relation)


NUMBERS = ["1.5abc", "0x10", "5%", "TRUE", "1,5", "1 5", "5F", "five"]


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("word", NUMBERS)
def test_a_number_that_fits_only_in_part_is_named(reader: str, word: str, tmp_path: Path) -> None:
    times = series(ISO)
    relation, engine = READERS[reader](tmp_path, times, [*(f"{place}.5" for place in range(99)), word])
    with pytest.raises(SourceError, match=f"1 of 100 values do not fit, the first is '{word}'"):
        read(relation, engine)
    if word != "1,5":  # which DuckDB takes for two columns then
        assert read(relation, engine, null=[word])[-1][1] is None


@pytest.mark.parametrize("word", NUMBERS)
def test_a_number_far_down_a_file_that_fits_only_in_part_is_named(word: str, tmp_path: Path) -> None:
    relation, _ = as_csv(tmp_path, series(ISO, ROWS + 1), [*range(ROWS), word])
    with pytest.raises(SourceError, match=f"Line 30002 of the CSV file .* holds '{word}' in the column"):
        read(relation)


@pytest.mark.parametrize(("word", "number"), [("1e5", 1e5), (" 5 ", 5.0), ("+.5", 0.5), ("7.", 7.0)])
def test_a_number_in_another_form_is_read(word: str, number: float, tmp_path: Path) -> None:
    for make in READERS.values():
        relation, engine = make(tmp_path, series(ISO, 2), ["1.5", word])
        assert read(relation, engine, decimal=".")[-1][1] == number


def test_names_of_a_text_file_are_read_as_they_are_written(tmp_path: Path) -> None:
    """007 and 7 are two machines."""
    path = tmp_path / "names.csv"
    path.write_text("asset,channel,time,value\n007,01,1,5\n7,1,1,6\n")
    small = gam_db.Parameters(m=1, tau=1, bins=2, window=1)
    found = gam_db.support(Source(path), small, gam_db.Calibration(1.0))
    assert found.select(["asset", "channel"]).to_pylist() == [
        {"asset": "007", "channel": "01"},
        {"asset": "7", "channel": "1"},
    ]


@pytest.fixture
def connection() -> Iterator[sqlite3.Connection]:
    with sqlite3.connect(":memory:", isolation_level=None) as opened:
        yield opened
    opened.close()


def stored(
    connection: sqlite3.Connection, time: str, value: str, rows: Sequence[tuple[Any, Any]]
) -> None:
    connection.execute("DROP TABLE IF EXISTS readings")
    connection.execute(f"CREATE TABLE readings (time {time}, value {value})")
    connection.executemany("INSERT INTO readings VALUES (?, ?)", rows)


SMALL = gam_db.Parameters(m=1, tau=1, bins=4, window=5)


@pytest.mark.parametrize(
    ("time", "value", "row", "said"),
    [
        (
            "INTEGER",
            "REAL",
            (50, "Bad"),
            "1 of 51 .* 'value', declared REAL, are not numbers.*null='Bad'",
        ),
        ("INTEGER", "REAL", (50, "1.5abc"), "not numbers: the first is '1.5abc'"),
        ("INTEGER", "INTEGER", (50, "1,5"), "declared INTEGER, are not numbers: the first is '1,5'"),
        ("INTEGER", "REAL", (50, "0x10"), "not numbers: the first is '0x10'"),
        ("INTEGER", "NUMERIC", (50, "5%"), "not numbers: the first is '5%'"),
        ("INTEGER", "REAL", (50, ""), "not numbers: the first is ''"),
        ("INTEGER", "REAL", (50, b"5"), "not numbers"),
        ("INTEGER", "BOOLEAN", (50, "TRUE"), "are not 0 or 1: the first is 'TRUE'"),
        (
            "INTEGER",
            "REAL",
            (1.5, 1.0),
            "'time', declared INTEGER, are not integers: the first is '1.5'",
        ),
        ("INTEGER", "REAL", ("7 of 9", 1.0), "are not integers: the first is '7 of 9'"),
    ],
)
def test_sqlite_keeps_any_text_and_each_is_named(
    connection: sqlite3.Connection, time: str, value: str, row: tuple[Any, Any], said: str
) -> None:
    whole = [(place, place % 2 if value == "BOOLEAN" else place % 7) for place in range(50)]
    stored(connection, time, value, [*whole, row])
    for call in (gam_db.support, gam_db.health_indicator, gam_db.check):
        with pytest.raises(SourceError, match=said):
            call(Source("readings", None, None), SMALL, engine=connection)


@pytest.mark.parametrize(
    "word", [*ODD, "2460000.5", 1772496000, "2026-03-03 12:00:00.5.5", "2026-03-03 12:00:0099"]
)
def test_sqlite_reads_a_time_whole_or_names_it(connection: sqlite3.Connection, word: Any) -> None:
    rows = [(time, place) for place, time in enumerate(series(ISO, 50))]
    stored(connection, "TEXT", "REAL", [*rows, (word, 1.0)])
    with pytest.raises(
        SourceError, match=r"1 of 51 .* are not times in ISO 8601: the first is '"
    ) as caught:
        gam_db.support(Source("readings", None, None), SMALL, engine=connection)
    assert repr(str(word)) in str(caught.value)


def test_sqlite_counts_a_text_as_missing_where_that_is_asked_for(connection: sqlite3.Connection) -> None:
    """As missing, and no more: the same as with NULL in its place."""
    rows = [
        (time, "Bad" if place in (7, 40) else place % 5) for place, time in enumerate(series(ISO, 60))
    ]
    stored(connection, "TEXT", "REAL", rows)
    source = Source("readings", None, None, null=["Bad", "-999"])
    found = gam_db.health_indicator(source, SMALL, engine=connection).to_pylist()
    stored(
        connection, "TEXT", "REAL", [(time, None if value == "Bad" else value) for time, value in rows]
    )
    expected = gam_db.health_indicator(Source("readings", None, None), SMALL, engine=connection)
    assert found == expected.to_pylist()
    assert len(found) == 47  # of 60 - 12 the one that is missing after calibration is none


def test_a_bad_word_that_comes_to_a_monitor_is_named(tmp_path: Path) -> None:
    address = f"sqlite:///{tmp_path / 'plant.db'}"
    with sqlite3.connect(tmp_path / "plant.db") as made:
        stored(made, "TEXT", "REAL", [(time, place % 5) for place, time in enumerate(series(ISO, 60))])
    source = Source("readings", None, None)
    with gam_db.connect(address) as engine, gam_db.Monitor(engine, source, SMALL) as monitor:
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
    with sqlite3.connect(tmp_path / "plant.db") as later:
        later.execute("INSERT INTO readings VALUES ('2026-03-05 00:00:00', 'Bad')")
    with (
        gam_db.connect(address) as engine,
        gam_db.Monitor(engine, source, SMALL) as monitor,
        pytest.raises(SourceError, match=r"1 of 61 values .* the first is 'Bad', 1 times"),
    ):
        monitor.score()
