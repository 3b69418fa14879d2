"""Text files in other encodings than UTF-8: said to be that, and read once their encoding is said."""

import codecs
import gzip
from pathlib import Path
from typing import Any

import pytest

import gam_db
from as_read import read
from gam_db import Source
from gam_db.errors import SourceError

ROWS = "".join(f"2026-03-02 00:{minute:02d}:00;{minute}.5 °C\n" for minute in range(60))
TEXT = "Zeit;Kühlwasser [°C]\n" + ROWS
NAMES: dict[str, Any] = {"time": "Zeit", "value": "Kühlwasser [°C]", "unit": "°C"}


@pytest.mark.parametrize(
    ("encoding", "proposed"),
    [
        ("cp1252", "--encoding cp1252"),
        ("latin-1", "--encoding cp1252"),
        ("utf-16", "--encoding utf-16"),
        ("utf-16-le", "--encoding utf-16-le"),
        ("utf-16-be", "--encoding utf-16-be"),
        ("utf-32", "--encoding utf-32"),
    ],
)
@pytest.mark.parametrize("sign", [";", ","])
@pytest.mark.parametrize("ending", ["csv", "csv.gz"])
def test_what_is_not_utf8_is_said_and_read_by_its_option(
    encoding: str, proposed: str, sign: str, ending: str, tmp_path: Path
) -> None:
    path = tmp_path / f"export.{ending}"
    text = TEXT.replace(";", sign).encode(encoding)
    path.write_bytes(gzip.compress(text) if ending.endswith("gz") else text)
    said = proposed.partition(" ")[2]
    with pytest.raises(SourceError, match=f"such as encoding='{said}', or") as caught:
        read(path, **NAMES)
    assert f"export.{ending} is not in UTF-8; give its encoding" in caught.value.options
    assert f"{proposed}, or" in caught.value.options
    found = read(path, encoding=said, **NAMES)
    assert [value for _, value in found] == [minute + 0.5 for minute in range(60)]
    assert read(str(tmp_path) + "/", encoding=said, **NAMES) == found


def test_a_mark_of_utf8_is_no_part_of_the_first_name(tmp_path: Path) -> None:
    path = tmp_path / "marked.csv"
    path.write_bytes(codecs.BOM_UTF8 + TEXT.encode())
    for encoding in (None, "utf-8", "utf-8-sig", "UTF8"):
        assert len(read(path, encoding=encoding, **NAMES)) == 60


def test_a_sign_far_down_is_named_by_its_file(tmp_path: Path) -> None:
    path = tmp_path / "late.csv"
    rows = "".join(f"{place},{place % 7},mill\n" for place in range(30_000))
    path.write_bytes(f"time,value,asset\n{rows}".encode() + b"30000,1,K\xfchlung\n")
    with pytest.raises(
        SourceError, match=(r"late.csv is not in UTF-8; give its encoding,.* " r"encoding='cp1252'")
    ):
        gam_db.support(Source(path, "asset", None))
    assert len(read(path, encoding="cp1252")) == 30_001


def test_the_files_themselves_are_named_not_their_copies(tmp_path: Path) -> None:
    path = tmp_path / "one.csv"
    path.write_bytes(TEXT.encode("cp1252"))
    for encoding in ("utf-16", "ascii"):
        with pytest.raises(SourceError, match=rf"one.csv is not in {encoding} either; give another"):
            read(path, encoding=encoding, **NAMES)
    (tmp_path / "two.csv").write_bytes("Zeit;Öl\n1;2\n".encode("cp1252"))
    with pytest.raises(SourceError, match=r"two.csv has the columns Zeit, Öl, and \S*one.csv has"):
        read(tmp_path, encoding="cp1252", **NAMES)


@pytest.mark.parametrize("encoding", ["klingon", "hex", "base64", 5])
def test_an_encoding_that_there_is_not(encoding: str) -> None:
    with pytest.raises(SourceError, match=f"encoding is {encoding!r}; it takes the name of an encoding"):
        Source("a.csv", encoding=encoding)


def test_a_condition_leaves_the_copy_to_be_read(tmp_path: Path) -> None:
    path = tmp_path / "one.csv"
    path.write_bytes(TEXT.encode("cp1252"))
    assert (
        len(read(path, encoding="cp1252", where="Zeit < TIMESTAMP '2026-03-02 00:10:00'", **NAMES)) == 10
    )
    small = gam_db.Parameters(m=1, tau=1, bins=4, window=5)
    source = Source(path, None, None, encoding="cp1252", where="Zeit IS NOT NULL", **NAMES)
    assert gam_db.health_indicator(source, small).num_rows == 48


def test_lines_that_repeat_the_header_are_said_to_be_that(tmp_path: Path) -> None:
    """The options in the message read the rest, whether the header comes again early or late."""
    for rows in (60, 30_000):
        path = tmp_path / f"joined_{rows}.csv"
        day = "time,current\n" + "".join(f"{place},{place % 7}.5\n" for place in range(rows))
        path.write_text(day * 3)
        with pytest.raises(SourceError, match="2 lines of the file repeat its header") as caught:
            read(path, value="current")
        assert "--null time --null current --where '\"time\" IS NOT NULL'" in caught.value.options
        found = read(path, value="current", null=["time", "current"], where='"time" IS NOT NULL')
        assert len(found) == 3 * rows
