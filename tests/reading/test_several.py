"""Several files that are one source: all is read whatever their names and order, or a file is named."""

import datetime as dt
import gzip
import itertools
from collections.abc import Callable, Sequence
from decimal import Decimal
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
from pyarrow import parquet

import gam_db
from as_read import micros, read
from gam_db import Source
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import SourceError

DAY = dt.datetime(2026, 3, 1)


def lines(times: Sequence[Any], values: Sequence[Any], header: str = "ts,value", sign: str = ",") -> str:
    rows = (f"{time}{sign}{value}" for time, value in zip(times, values, strict=True))
    return "\n".join([header, *rows]) + "\n"


def day(number: int, way: str = "%Y-%m-%dT%H:%M:%S") -> list[str]:
    return [(DAY + dt.timedelta(days=number, minutes=place)).strftime(way) for place in range(10)]


def expected(days: int, values: Callable[[int], float] = float) -> list[tuple[int, float]]:
    return [
        (micros(DAY + dt.timedelta(days=number, minutes=place)), values(place))
        for number in range(days)
        for place in range(10)
    ]


def rows(relation: Any, **said: Any) -> list[tuple[Any, Any]]:
    return sorted(read(relation, time="ts", **said))


def test_a_folder_of_csv_is_read_in_every_way(tmp_path: Path) -> None:
    """One file a day; below folders, too, packed or not, columns in another order, some without rows."""
    folder = tmp_path / "export"
    (folder / "sub" / "old").mkdir(parents=True)
    (folder / "1.csv").write_text(lines(day(0), range(10)))
    (folder / "2.CSV").write_text(lines(range(10), day(1), "value,ts"))
    (folder / "3.csv").write_text("ts,value\n")
    (folder / "4.csv").touch()
    with gzip.open(folder / "sub" / "5.csv.gz", "wt") as file:
        file.write(lines(day(2), range(10)))
    (folder / "sub" / "old" / "6.csv").write_text(lines(day(3), [f"{place}.0" for place in range(10)]))
    for relation in (folder, f"{folder}/"):
        assert rows(relation) == expected(4)
    assert rows(str(folder / "*.csv")) == expected(1)
    assert rows([folder / "1.csv", folder / "sub" / "5.csv.gz", folder / "4.csv"]) == [
        *expected(1),
        *expected(3)[-10:],
    ]
    small = gam_db.Parameters(m=1, tau=1, bins=4, window=5)
    whole = gam_db.health_indicator(Source(folder, None, None, "ts"), small)
    assert whole.num_rows == 32
    assert gam_db.health_indicator(str(folder) + "/", small) == whole
    assert gam_db.health_indicator(str(folder), small) == whole


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (
            lines(day(1), range(10), "ts,reading"),
            "b.csv has the columns ts, reading, and .*a.csv has .* value",
        ),
        (lines(day(1), ["1,2"] * 10, "ts,value,more"), "b.csv has the columns ts, value, more, and "),
        (lines(day(1), range(10), "ts;value", ";"), "b.csv has the columns ts;value, and "),
        (
            lines(day(1), range(10), "Export of line 3\nts,value"),
            "b.csv has another format than .*a.csv",
        ),
    ],
)
def test_a_file_of_other_columns_is_named(text: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(lines(day(0), range(10)))
    (tmp_path / "b.csv").write_text(text)
    with pytest.raises(SourceError, match=message):
        rows(tmp_path)


def test_of_many_columns_those_that_differ_are_named(tmp_path: Path) -> None:
    names = [f"signal_{number}" for number in range(40)]
    for file, these in (("a", names), ("b", [*names[:20], "other", *names[21:]])):
        (tmp_path / f"{file}.csv").write_text(f"ts,{','.join(these)}\n1,{','.join(['2'] * 40)}\n")
    with pytest.raises(
        SourceError, match=r"b.csv has 41 columns, among them other, and .*among them signal_20;"
    ):
        read(tmp_path, time="ts", value="signal_1")


@pytest.mark.parametrize("order", list(itertools.permutations("abc")))
def test_day_and_month_are_told_by_all_files(order: tuple[str, ...], tmp_path: Path) -> None:
    """1 to 3 March may be January to March; what a later file holds decides, wherever it stands."""
    way = "%d/%m/%Y %H:%M:%S"
    for number, name in enumerate(order):
        (tmp_path / f"{name}.csv").write_text(lines(day(number, way), range(10)))
    with pytest.raises(
        SourceError, match=r"'%d/%m/%Y %H:%M:%S' or .*'%m/%d/%Y %H:%M:%S' would .* choose one"
    ):
        rows(tmp_path)
    assert rows(tmp_path, time_format=way) == expected(3)
    (tmp_path / f"{order[0]}.csv").write_text(lines(day(12, way), range(10)))
    assert rows(tmp_path)[-1] == (micros(DAY + dt.timedelta(days=12, minutes=9)), 9.0)


def test_types_that_csv_files_seem_to_have_change_nothing(tmp_path: Path) -> None:
    """Integers, fractions, no value at all, and a word, each in a file of its own."""
    kinds: list[list[Any]] = [list(range(10)), [place + 0.5 for place in range(10)], [""] * 10]
    for number, order in enumerate(itertools.permutations(range(3))):
        folder = tmp_path / str(number)
        folder.mkdir()
        for name, place in zip("abc", order, strict=True):
            (folder / f"{name}.csv").write_text(lines(day(place), kinds[place]))
        assert rows(folder) == [
            *expected(1),
            *expected(2, lambda place: place + 0.5)[-10:],
            *((time, None) for time, _ in expected(3)[-10:]),
        ]
        (folder / "d.csv").write_text(lines(day(4), ["Bad"] * 10))
        with pytest.raises(SourceError, match=r"the first is '.*', .*null='Bad'"):
            rows(folder)


def test_files_of_two_kinds_are_no_source(tmp_path: Path) -> None:
    (tmp_path / "a.csv").write_text(lines(day(0), range(10)))
    parquet.write_table(pa.table({"ts": [1], "value": [1.0]}), tmp_path / "b.parquet")
    with pytest.raises(
        SourceError, match=r"\.csv is CSV, and .*\.parquet is Parquet; give files of one type"
    ):
        rows(tmp_path)


TIMES = [DAY + dt.timedelta(minutes=place) for place in range(10)]


def written(folder: Path, *columns: tuple[pa.Array, pa.Array]) -> list[Path]:
    """A folder for each order of the files' names; a file has ten rows."""
    folders = []
    for number, names in enumerate(itertools.permutations("abc"[: len(columns)])):
        made = folder / str(number)
        made.mkdir(parents=True)
        for name, (times, values) in zip(names, columns, strict=True):
            parquet.write_table(pa.table({"ts": times, "value": values}), made / f"{name}.parquet")
        folders.append(made)
    return folders


def times(number: int, of: pa.DataType = pa.timestamp("us")) -> pa.Array:  # noqa: B008
    return pa.array([time + dt.timedelta(days=number) for time in TIMES], of)


TENTH, EIGHTH = Decimal("0.1"), Decimal("0.125")
HALVES = [place + 0.5 for place in range(10)]


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (pa.array(range(10), pa.int64()), pa.array(HALVES)),
        (pa.array(range(10), pa.int8()), pa.array(HALVES, pa.float32())),
        (pa.array([2**24 + 1] * 10, pa.int64()), pa.array(HALVES, pa.float32())),
        (pa.array(range(10), pa.int32()), pa.array([2**53] * 10, pa.int64())),
        (pa.array([2**63 + 2**11] * 10, pa.uint64()), pa.array([-1] * 10, pa.int64())),
        (pa.array([TENTH] * 10, pa.decimal128(10, 1)), pa.array([0.123456789] * 10)),
        (pa.array([TENTH] * 10, pa.decimal128(4, 1)), pa.array([EIGHTH] * 10, pa.decimal128(9, 3))),
        (pa.array([TENTH] * 10, pa.decimal128(38, 1)), pa.array(range(10), pa.int64())),
        (pa.nulls(10), pa.array(HALVES)),
    ],
)  # fmt: skip
def test_numbers_of_several_types_are_what_each_file_says(
    one: pa.Array, other: pa.Array, tmp_path: Path
) -> None:
    wanted = [
        None if value is None else float(value) for value in [*one.to_pylist(), *other.to_pylist()]
    ]
    for folder in written(tmp_path, (times(0), one), (times(1), other)):
        assert [value for _, value in rows(folder)] == wanted


@pytest.mark.parametrize(
    "kinds",
    [
        (pa.timestamp("ms"), pa.timestamp("us")),
        (pa.timestamp("us"), pa.timestamp("ns")),
        (pa.timestamp("ns"), pa.timestamp("ms"), pa.timestamp("us")),
        (pa.timestamp("ms", "UTC"), pa.timestamp("ns", "Europe/Berlin")),
    ],
)
def test_times_of_several_types_are_what_each_file_says(
    kinds: tuple[pa.DataType, ...], tmp_path: Path
) -> None:
    columns = [(times(number, of), pa.array(map(float, range(10)))) for number, of in enumerate(kinds)]
    for folder in written(tmp_path, *columns):
        assert rows(folder) == expected(len(kinds))


def test_days_among_times_are_their_midnights(tmp_path: Path) -> None:
    days = pa.array([DAY.date() + dt.timedelta(days=5 + place) for place in range(10)])
    for folder in written(tmp_path, (times(0), pa.array(range(10))), (days, pa.array(range(10)))):
        found = rows(folder)
        assert found[:10] == expected(1)
        assert found[-1] == (micros(DAY + dt.timedelta(days=14)), 9.0)


@pytest.mark.parametrize(
    ("one", "other", "said"),
    [
        ({"value": pa.array(range(10))}, {"value": pa.array(["5"] * 10)}, "BIGINT in .* and VARCHAR"),
        ({"value": pa.array([True] * 10)}, {"value": pa.array(range(10))}, "BIGINT in .* and BOOLEAN"),
        ({"value": pa.array([2**53 + 1] * 10)}, {"value": pa.array(HALVES)}, "BIGINT in .* and DOUBLE"),
        ({"ts": times(0, pa.timestamp("us", "UTC"))}, {}, "TIMESTAMP WITH TIME ZONE in "),
        ({"ts": pa.array(range(10))}, {}, "BIGINT in .* and TIMESTAMP in"),
        ({"ts": pa.array([str(time) for time in TIMES])}, {}, "TIMESTAMP in .* and VARCHAR in"),
    ],
)  # fmt: skip
def test_types_that_no_type_holds_are_named_with_their_files(
    one: dict[str, pa.Array], other: dict[str, pa.Array], said: str, tmp_path: Path
) -> None:
    usual = {"ts": times(1), "value": pa.array(range(10))}
    first, second = ({**usual, **these} for these in (one, other))
    said_of_both = set()
    for folder in written(tmp_path, (first["ts"], first["value"]), (second["ts"], second["value"])):
        with pytest.raises(SourceError, match=f"column '(ts|value)' is of type .*{said}") as caught:
            rows(folder)
        assert "a.parquet" in str(caught.value)
        assert "b.parquet" in str(caught.value)
        said_of_both.add(str(caught.value).replace(str(folder), ""))
    assert len({said.replace("a.parquet", "").replace("b.parquet", "") for said in said_of_both}) == 1


def test_a_script_follows_a_folder_of_csv(tmp_path: Path) -> None:
    """The words are read as gam run reads them, and files that come later are read, too."""
    (tmp_path / "a.csv").write_text(lines(day(0, "%d.%m.%Y %H:%M"), range(10)))
    (tmp_path / "b.csv").write_text(lines(day(14, "%d.%m.%Y %H:%M"), range(10)))
    said: dict[str, Any] = {"time_format": "%d.%m.%Y %H:%M"}
    source = Source(f"{tmp_path}/", None, None, "ts", **said)
    small = gam_db.Parameters(m=1, tau=1, bins=4, window=5)
    text = gam_db.render("exact", "duckdb", source, small)
    (tmp_path / "c.csv").write_text(lines(day(15, "%d.%m.%Y %H:%M"), range(10)))
    with DuckSession() as session:
        found = session.connection.sql(text.rstrip(";\n")).to_arrow_table()
    wanted = gam_db.health_indicator(source, small)
    assert found.to_pylist() == wanted.to_pylist()
    assert found.num_rows == 24
