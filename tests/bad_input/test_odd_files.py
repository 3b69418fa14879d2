"""Files: a right answer or a remedy."""

import datetime as dt
from pathlib import Path

import pyarrow.csv
import pyarrow.parquet
import pytest
from sqlglot import exp

import gam_db
from gam_db import Source
from gam_db.settings.form import Form
from odd import ROWS, VALUES, expected, health, refused, support, table


@pytest.fixture
def files(tmp_path: Path) -> Path:
    pyarrow.parquet.write_table(table(), tmp_path / "good.parquet")
    pyarrow.csv.write_csv(table(), tmp_path / "good.csv")
    return tmp_path


def test_files_of_any_name(files: Path) -> None:
    odd = files / 'it\'s "odd"; -- .parquet'
    (files / "good.parquet").rename(odd)
    tabs = files / "good.tsv"
    tabs.write_text((files / "good.csv").read_text().replace(",", "\t"))
    folder = files / "old.csv"
    folder.mkdir()
    inside = folder / "X.PARQUET"
    inside.write_bytes(odd.read_bytes())
    upper = files / "UPPER.CSV"
    upper.write_text((files / "good.csv").read_text())
    for path in (odd, str(odd), str(files / "good.csv"), tabs, inside, upper, str(folder / "*.PARQUET")):
        assert health(Source(path)) == expected(ROWS), path


def test_times_in_a_csv(files: Path) -> None:
    lines = [f"a,x,2026-03-01T06:00:0{i}Z,{v}\n" for i, v in enumerate(VALUES)]
    path = files / "times.csv"
    path.write_text("asset,channel,time,value\n" + "".join(lines))
    start = int(dt.datetime(2026, 3, 1, 6, tzinfo=dt.UTC).timestamp()) * 10**6
    rows = [("a", "x", start + i * 10**6, v) for i, v in enumerate(VALUES)]
    assert health(Source(path)) == expected(rows)


def test_nan_in_a_parquet_file_is_missing(tmp_path: Path) -> None:
    """The file's statistics do not speak of it: no value but NaN is outside of what is usable."""
    values = [0.0, 1.0, float("nan"), *VALUES[3:]]
    path = tmp_path / "nan.parquet"
    pyarrow.parquet.write_table(table(value=values), path)
    rows = [("a", "x", t, value) for t, value in enumerate(values)]
    assert health(Source(path)) == expected(rows)


def test_a_missing_file_is_named() -> None:
    for name in ("none.parquet", "none.csv", "no/such/folder/none.parquet", "none*.parquet"):
        refused("none.* cannot be read; is it there", lambda name=name: support(Source(name)))  # type: ignore[misc]
    refused("none.txt cannot be read", lambda: support(Source(Path("none.txt"))))
    refused("files end in .parquet, .csv or .tsv", lambda: support(Source("none.json")))


@pytest.mark.parametrize("ending", ["xlsx", "XLS", "xlsm", "ods"])
def test_a_spreadsheet_is_to_be_saved_as_csv(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"book.{ending}"
    path.write_bytes(b"PK")
    for relation in (path, str(path)):
        refused(
            f"book.{ending} is a spreadsheet, .* save each sheet as CSV",
            lambda relation=relation: support(Source(relation)),  # type: ignore[misc]
        )
    refused(" is a spreadsheet, .* save each sheet as CSV", lambda: support(Source(tmp_path)))


@pytest.mark.parametrize("content", [b"", b"asset,channel,time,value\n" * 9, bytes(range(256)) * 9])
def test_a_file_that_is_no_parquet(files: Path, content: bytes) -> None:
    (files / "bad.parquet").write_bytes(content)
    refused(
        r"DuckDB cannot read .*bad\.parquet as a table; is the file complete",
        lambda: support(Source(files / "bad.parquet")),
    )


def test_a_parquet_file_that_is_cut_off(files: Path) -> None:
    whole = (files / "good.parquet").read_bytes()
    (files / "cut.parquet").write_bytes(whole[: len(whole) // 2])
    refused(
        ("DuckDB cannot read .*cut.parquet as a table"), lambda: support(Source(files / "cut.parquet"))
    )


MANY = "asset,channel,time,value\n" + "".join(f"a,x,{i},{i % 7}.5\n" for i in range(25_000))


@pytest.mark.parametrize(
    ("line", "message"),
    [
        (
            "a,x,25000,broken\n",
            "Line 25002 of the CSV file .*late.csv holds 'broken' in the column 'value'.*null='broken'",
        ),
        (
            "a,x,25000,1,8675309.25,3\n",
            r"Line 25002 of the CSV file \S*late.csv does not fit its columns",
        ),
        (
            "\udcff\udcfe,x,25000,8675309.25\n",
            "late.csv is not in UTF-8; give its encoding,.* encoding='cp1252'",
        ),
    ],
)
def test_a_csv_file_that_breaks_late(files: Path, line: str, message: str) -> None:
    """Far behind what is read to find out the columns; of the line the one word is shown at most."""
    (files / "late.csv").write_text(MANY + line, errors="surrogateescape")
    refused(message, lambda: support(Source(files / "late.csv")))


def test_of_several_csv_files_the_one_at_fault_is_named(files: Path) -> None:
    """It is not the one that was opened last, and words are counted as it is written."""
    words = "".join(f"a;x;{25_000 + i};{word}\n" for i, word in enumerate(["broken", "n/a", "broken"]))
    (files / "late.csv").write_text(MANY.replace(",", ";") + words)
    (files / "good.csv").write_text(MANY)
    with gam_db.connect(files / "plant.duckdb") as engine:
        late = engine.driver.file(files / "late.csv", Form(null=("n/a",), delimiter=";"))
        engine.driver.file(files / "good.csv")
        refused(
            r"Line 25002 of the CSV file \S*late.csv holds 'broken' in the column 'value', 2 times",
            lambda: engine.fetch(exp.select("value").from_(late)),
        )


def test_text_in_a_csv(files: Path) -> None:
    lines = "".join(f"a,x,{i},{'n/a' if i % 2 else 8675309.25}\n" for i in range(9))
    (files / "text.csv").write_text("asset,channel,time,value\n" + lines)
    refused(
        "value column 'value' is of type VARCHAR.* 4 of 9 .*'n/a', 4 times; null='n/a' would",
        lambda: support(Source(files / "text.csv")),
    )
