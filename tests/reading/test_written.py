"""Numbers and times as plants write them: read to the bit, or refused with what would read them."""

import datetime as dt
import math
import random
import re
import sqlite3
from collections.abc import Callable
from decimal import Decimal
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from pyarrow import parquet

import gam_db
from gam_db import Source, WideSource
from gam_db.clock import TimeKind
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import SourceError
from gam_db.reading.preparing import prepared
from gam_db.stored.sources import described, source_of

#: A locale: decimal sign, sign between thousands, between columns, format of times, words of no value.
LOCALES: dict[str, tuple[str, str, str, str | None, tuple[str, ...]]] = {
    "de": (",", ".", ";", "%d.%m.%Y %H:%M:%S", ("----", "Störung")),
    "fr": (",", "\u202f", ";", "%d/%m/%Y %H:%M:%S", ("s.o.",)),
    "ch": (".", "'", ";", "%d.%m.%y %H:%M:%S", ("k.A.", "n/v")),
    "us": (".", ",", ",", "%m/%d/%Y %I:%M:%S %p", ("N/A", "Bad")),
    "se": (",", "\u00a0", "\t", "%Y-%m-%d %H:%M:%S", ("saknas",)),
    "iso": (".", "", ",", None, ("null",)),
}
START = dt.datetime(2026, 1, 27, 23, 59, 50)


def written(value: float, digits: int, decimal: str, thousands: str) -> str:
    """A number as its locale writes it."""
    text = f"{value:,.{digits}f}" if thousands else f"{value:.{digits}f}"
    return text.translate({ord(","): thousands, ord("."): decimal})


def read(source: gam_db.Source | WideSource, engine: Any = None) -> list[tuple[Any, ...]]:
    """What the method reads of a source: time as an integer, and the value."""
    with DuckSession(engine) as session:
        found = prepared(session, source)
        rows = session.engine.readings(found.rows, found.relation, found.kind)
        table = session.fetch(rows).to_pylist()
    return [(row["time"], row["reading"]) for row in table]


def micros(time: dt.datetime) -> int:
    return (time - dt.datetime(1970, 1, 1)) // dt.timedelta(microseconds=1)


@pytest.mark.thorough
@pytest.mark.parametrize("language", LOCALES)
def test_tables_drawn_at_random_are_read_as_they_were_written(language: str, tmp_path: Path) -> None:
    """Forty tables in each of six locales: every number equal, and missing what is missing, no more."""
    decimal, thousands, delimiter, time_format, nulls = LOCALES[language]
    draw = random.Random(language)
    said: dict[str, Any] = {"decimal": decimal, "null": nulls, "time_format": time_format}
    said["thousands"] = " " if thousands in ("\u202f", "\u00a0") else thousands or None
    for number in range(40):
        unit = draw.choice([None, None, "A", "°C", "m/s²"])
        digits, scale = draw.randint(0, 6), 10.0 ** draw.randint(-2, 7)
        lines = [delimiter.join(("Zeit", "Wert"))]
        expected: list[tuple[int, float | None]] = []
        for row in range(draw.randint(3, 60)):
            time = START + dt.timedelta(seconds=row * draw.randint(1, 90_000))
            value = round(draw.gauss(0, scale), digits)
            if draw.random() < 0.2:
                word = draw.choice([*nulls, ""])
                expected.append((micros(time), None))
            else:
                word = written(value, digits, decimal, thousands)
                word += f" {unit}" if unit and draw.random() < 0.9 else ""
                expected.append((micros(time), float(f"{value:.{digits}f}")))
            word = f'"{word}"' if delimiter in word else word
            shown = time.strftime(time_format) if time_format else time.isoformat()
            lines.append(delimiter.join((shown, word)))
        path = tmp_path / f"{number}.csv"
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        source = Source(path, None, None, "Zeit", "Wert", unit=unit, delimiter=delimiter, **said)
        assert read(source) == expected, (language, number)
        columns = [line.split(delimiter, 1) for line in lines[1:]]
        kept = pa.table(
            {"Zeit": [one for one, _ in columns], "Wert": [two.strip('"') or None for _, two in columns]}
        )
        parquet.write_table(kept, tmp_path / "same.parquet")
        again = Source(tmp_path / "same.parquet", None, None, "Zeit", "Wert", unit=unit, **said)
        assert read(again) == expected, (language, number, "as text in Parquet")


def table(words: list[Any], times: list[Any] | None = None) -> pa.Table:
    return pa.table({"time": times or list(range(len(words))), "value": words})


def one(words: list[Any], times: list[Any] | None = None, **said: Any) -> Source:
    return Source(table(words, times), None, None, **said)


@pytest.mark.parametrize(
    ("source", "message"),
    [
        (
            one(["1,5", "2", "1,5"]),
            "2 of 3 values do not fit, the first is '1,5', 2 times; --decimal , would",
        ),
        (one(["1.234,5", "-"]), "--thousands . --decimal , --null - would"),
        (one(["1,234.5"]), "--thousands , --decimal . would"),
        (one(["1 234,5"]), "--thousands ' ' --decimal , would"),
        (one(["1.2 A", "1.3 A"]), "--unit A would"),
        (one(["1.5", "N/A", "Bad"]), "2 of 3 .*'N/A'; --null N/A --null Bad would"),
        (one(["1.5", "2.5"]), "all its values are, so --decimal . reads them"),
        (
            one(["open", "shut", "open"]),
            "only words, 'open', 'shut': .* give a view with a number for each",
        ),
        (
            one(["1.5", "N/A"], decimal="."),
            "1 of 2 values do not fit, the first is 'N/A'; --null N/A would",
        ),
        (one(["1.2 A", "1.2 mA"], unit="A"), "1 of 2 .*'1.2 mA'; --unit mA would"),
        (one(["1.500", "1.5"], thousands="."), "1 of 2 .* the first is '1.5'"),
        (
            one([1.0, 2.0], ["31.12.2024 10:00", "1.1.2025 10:00"]),
            "--time-format '%d.%m.%Y %H:%M' would",
        ),
        (
            one([1.0], ["01/02/2026"]),
            "'%d/%m/%Y' or --time-format '%m/%d/%Y' would read them: choose one",
        ),
        (
            one([1.0, 2.0], ["2026-01-01", "?"]),
            "1 of 2 values do not fit, the first is '\\?'; give --time-f",
        ),
        (one([1.0], [1.5]), "Give --time-unit"),
        (one([1.0], ["2026-01-01"], time_unit="s"), "time_unit applies only to numbers"),
        (one([1.0], [True]), "it must be a timestamp or an integer counter"),
    ],
)
def test_a_word_that_does_not_fit_is_named(source: Source, message: str) -> None:
    with pytest.raises(SourceError) as caught:
        gam_db.support(source)
    assert re.search(message, caught.value.options)
    assert "--" not in str(caught.value)


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"decimal": ";"}, "decimal is ';'"),
        ({"null": 5}, "null is 5; it takes a list of texts"),
        ({"skip_rows": 0}, "skip_rows is 0; it must be at least 1"),
        ({"time_unit": "min"}, "time_unit is 'min'"),
    ],
)
def test_what_is_said_of_writing_is_checked(said: dict[str, Any], message: str) -> None:
    with pytest.raises(SourceError, match=message):
        Source("t", **said)


ROUND = [-1, 0, 1, 1_767_225_600]


@pytest.mark.parametrize(
    ("times", "said", "expected"),
    [
        (["2026-01-01T00:00:00+01:00", "2026-01-01 00:00Z", "2026-01-01"], {}, None),
        (ROUND, {"time_unit": "s"}, [time * 10**6 for time in ROUND]),
        (ROUND, {"time_unit": "ms"}, [time * 10**3 for time in ROUND]),
        (ROUND, {"time_unit": "us"}, ROUND),
        ([-1001, -1000, -1, 0, 999, 1000], {"time_unit": "ns"}, [-2, -1, -1, 0, 0, 1]),
        (
            [0.1, -0.5, 1767225600.1, math.nan],
            {"time_unit": "s"},
            [100_000, -500_000, 1767225600100000, None],
        ),
        ([0.25, 1.5e9], {"time_unit": "ms"}, [250, 1_500_000_000_000]),
        ([2500.0], {"time_unit": "ns"}, [3]),
        (
            [-(10**18) - 1, 10**18 + 1_999_999_999],
            {"time_unit": "ns"},
            [-(10**15) - 1, 10**15 + 1_999_999],
        ),
        ([Decimal("0.1000009"), Decimal("-0.0000001")], {"time_unit": "s"}, [100_000, -1]),
        ([Decimal("1500.9"), Decimal("-0.5")], {"time_unit": "ns"}, [1, -1]),
    ],
)
def test_times_that_are_texts_or_numbers(
    times: list[Any], said: dict[str, Any], expected: list[int | None] | None
) -> None:
    if expected is None:
        midnight = micros(dt.datetime(2026, 1, 1))
        expected = [midnight - 3_600_000_000, midnight, midnight]
    found = read(one([1.0] * len(times), times, **said))
    assert [time for time, _ in found] == expected


def test_a_zone_is_heeded_wherever_the_connection_is() -> None:
    connection = duckdb.connect()
    connection.execute("SET TimeZone = 'America/New_York'")
    found = read(one([1.0, 2.0], ["2026-01-01T10:00:00+01:00", "2026-01-01T10:00:00"]), connection)
    nine = micros(dt.datetime(2026, 1, 1, 9))
    assert [time for time, _ in found] == [nine, nine + 3_600_000_000]


def test_true_and_false_are_one_and_zero() -> None:
    assert read(one([True, None, False])) == [(0, 1.0), (1, None), (2, 0.0)]
    wide = pa.table({"asset": ["a"] * 2, "time": [0, 1], "valve": [True, False]})
    assert read(WideSource(wide)) == [(0, 1.0), (1, 0.0)]


def test_a_number_may_mean_a_missing_value() -> None:
    assert read(one([-999.0, 2.5], null=["-999", "Bad"])) == [(0, None), (1, 2.5)]


def test_where_is_applied_before_words_are_read() -> None:
    assert read(one(["1,5", "off"], decimal=",", where="value <> 'off'")) == [(0, 1.5)]


def late(path: Path, *lines: str) -> Path:
    """A file whose first 25,000 rows hold integers."""
    rows = [f"{number},{number % 7}" for number in range(25_000)]
    path.write_text("\n".join(["time,value", *rows, *lines]) + "\n")
    return path


def test_a_word_far_down_a_file_is_named(tmp_path: Path) -> None:
    path = late(tmp_path / "late.csv", "25001,N/A", "25002,N/A")
    with pytest.raises(
        SourceError, match=r"Line 25002 .* 'N/A' in .* 'value', 2 times in all.*null='N/A'"
    ):
        gam_db.support(Source(path, None, None))
    assert read(Source(path, None, None, null=["N/A"]))[-2:] == [(25001, None), (25002, None)]


def test_fractions_may_come_late(tmp_path: Path) -> None:
    assert read(Source(late(tmp_path / "late.csv", "25001,0.5"), None, None))[-1] == (25001, 0.5)


def test_a_day_is_not_taken_for_a_month(tmp_path: Path) -> None:
    path = tmp_path / "days.csv"
    path.write_text("time,value\n01/02/2026 10:00:00,1\n03/02/2026 10:00:00,2\n")
    with pytest.raises(SourceError, match=r"'%d/%m/%Y %H:%M:%S' or .*'%m/%d.* choose one"):
        gam_db.support(Source(path, None, None))
    months = read(Source(path, None, None, time_format="%m/%d/%Y %H:%M:%S"))
    assert months[0][0] == micros(dt.datetime(2026, 1, 2, 10))
    path.write_text("time,value\n01/02/2026 10:00:00,1\n13/02/2026 10:00:00,2\n")
    assert read(Source(path, None, None))[0][0] == micros(dt.datetime(2026, 2, 1, 10))


def test_what_stands_above_the_header_is_skipped(tmp_path: Path) -> None:
    path = tmp_path / "head.csv"
    path.write_text("Station 7;;\nexported;by;hand\ntime;value\n1;2,5\n2;3,5\n")
    source = Source(path, None, None, skip_rows=2, delimiter=";", decimal=",")
    assert read(source) == [(1, 2.5), (2, 3.5)]


def test_a_monitor_keeps_how_its_source_is_written() -> None:
    said: dict[str, Any] = {
        "decimal": ",",
        "null": ("N/A", "#&="),
        "skip_rows": 2,
        "time_format": "%d.%m.%Y",
    }
    source = Source("a#b.csv", None, None, "ts", "v", **said)
    row = {"name": "m", **described(source)}
    assert source_of(row, []) == source
    plain = Source("a#decimal.csv", None, None)
    assert source_of({"name": "m", **described(plain)}, []) == plain


def test_the_kind_of_time_is_that_of_what_is_read() -> None:
    with DuckSession() as session:
        assert prepared(session, one([1.0], [1], time_unit="s")).kind is TimeKind.TIMESTAMP
        assert prepared(session, one([1.0], [1])).kind is TimeKind.COUNTER


def test_all_forms_read_the_same(tmp_path: Path) -> None:
    """The stored form reads a German file as the exact form does."""
    draw = random.Random(7)
    lines = ["ts;wert"]
    for row in range(400):
        time = START + dt.timedelta(minutes=row)
        lines.append(f"{time:%d.%m.%Y %H:%M};{written(draw.gauss(0, 2000), 2, ',', '.')}")
    path = tmp_path / "de.csv"
    path.write_text("\n".join(lines))
    said: dict[str, Any] = {"decimal": ",", "thousands": ".", "time_format": "%d.%m.%Y %H:%M"}
    source = Source(str(path), None, None, "ts", "wert", **said)
    parameters = gam_db.Parameters(m=2, tau=1, bins=5, window=20)
    with gam_db.connect(str(tmp_path / "state.duckdb")) as session:
        with gam_db.Monitor(session, source, parameters) as monitor:
            monitor.migrate()
            monitor.calibrate()
            monitor.score()
        rows = session.connection.execute(  # type: ignore[attr-defined]
            "SELECT novel, hi FROM gam_health ORDER BY last_time"
        ).fetchall()
    exact = gam_db.health_at_buckets(source, parameters)
    assert rows == list(zip(exact["novel"].to_pylist(), exact["hi"].to_pylist(), strict=True))
    assert len(rows) == 16


def refusal(call: Callable[[], object]) -> str:
    with pytest.raises(gam_db.UserError) as caught:
        call()
    return str(caught.value)


def test_other_engines_and_scripts_say_that_they_read_columns_as_they_are(tmp_path: Path) -> None:
    source = Source("t", time_kind="counter", decimal=",")
    assert "cast them in a view" in refusal(lambda: gam_db.render("exact", "sqlite", source))
    address = f"sqlite:///{tmp_path / 't.db'}"
    gam_db.connect(address).close()
    assert "cast them in a view" in refusal(lambda: gam_db.support(source, engine=address))


@pytest.mark.parametrize(("unit", "first"), [("s", 1_767_225_600), ("ms", 1_767_225_600_123)])
def test_another_engine_reads_booleans_and_numbers_since_1970_the_same(unit: str, first: int) -> None:
    rows = [(first + number, number % 3 == 0) for number in range(200)]
    connection = sqlite3.connect(":memory:")
    connection.execute("CREATE TABLE telemetry (time INTEGER, value BOOLEAN)")
    connection.executemany("INSERT INTO telemetry VALUES (?, ?)", rows)
    connection.commit()
    small = gam_db.Parameters(m=2, bins=4, window=10)
    held = table([value for _, value in rows], [time for time, _ in rows])
    wanted = gam_db.health_indicator(Source(held, None, None, time_unit=unit), small).to_pylist()
    found = gam_db.health_indicator(
        Source("telemetry", None, None, time_unit=unit), small, None, connection
    )
    assert len(wanted) == 160
    assert found.to_pylist() == wanted
    connection.close()
