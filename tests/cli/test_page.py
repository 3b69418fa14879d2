"""Pages: tables that fit, remarks that are said once, and figures as JSON; the exit codes."""

import io
import json
import math
import re
from pathlib import Path

import numpy as np
import pyarrow as pa
import pytest
import typer
from rich.cells import cell_len
from rich.console import Console

import gam_db
from gam_db import data
from gam_db.cli import app, exits, options, page
from gam_db.cli.course import Course
from gam_db.cli.exits import MEANINGS, Exit
from gam_db.cli.render import FORMATS, WORDS, Column, Notes, Page, Table, show, write

FOLDER = Path(exits.__file__).parent
LONG = ("a_very_long_name_" * 4 + "1", "a_very_long_name_" * 4 + "2")


def console(width: int = 80, encoding: str = "utf-8") -> Console:
    """A console of some width that keeps what is printed."""
    written = io.TextIOWrapper(io.BytesIO(), encoding=encoding)
    return Console(file=written, width=width, markup=False, highlight=False, emoji=False)


def lines(out: Console) -> list[str]:
    """What was printed, line by line."""
    out.file.seek(0)
    return out.file.read().splitlines()


def columns_of(*names: str, **spare: int) -> list[Column]:
    """Columns that show the values of these names; the last ones go where there is no room."""
    return [Column(name, name, spare=spare.get(name, 0)) for name in (*names, *spare)]


@pytest.mark.parametrize("width", [50, 80, 120, 200])
def test_a_table_fits_and_cuts_no_name(width: int) -> None:
    out = console(width)
    course = [0.5, math.nan, 1.0]
    rows = [
        {"channel": name, "HI": hi, "course": course}
        for name, hi in zip(LONG, ("0.10", "1.00"), strict=True)
    ]
    columns = [*columns_of("channel", "HI"), Column("course", "course", "course")]
    write([Table("x", rows, lambda row: "!" if row["HI"] == "0.10" else " ", columns=columns)], out)
    found = lines(out)
    assert max(map(cell_len, found)) <= width
    assert not any(line.endswith(" ") for line in found)
    for name in LONG:
        assert name in "".join(re.sub(r"^[ !] ", "", line).split("  ")[0].strip() for line in found)


def test_columns_that_say_least_go_first_and_no_others() -> None:
    row = {"channel": "j1", "samples": 1_000_000, "least": "-1.5", "most": "2.5"}
    heads = []
    for width in (80, 30, 24):
        out = console(width)
        columns = columns_of("channel", "samples", least=2, most=1)
        write([Table("x", [row], columns=columns)], out)
        heads.append(lines(out)[0].split())
    assert heads == [["channel", "samples", "least", "most"], ["channel", "samples", "least"], heads[2]]
    assert heads[2] == ["channel", "samples"]


def test_a_course_takes_the_room_that_is_left() -> None:
    longest = []
    for width in (40, 80, 120, 300):
        out = console(width)
        columns = [*columns_of("channel"), Column("course", "course", "course")]
        write([Table("x", [{"channel": "j1", "course": np.ones(500)}], columns=columns)], out)
        longest.append(lines(out)[1].count("█"))
    assert longest[0] < longest[1] <= longest[2] == longest[3] == Course.most


def test_a_page_explains_the_words_that_it_shows_and_no_others() -> None:
    out = console(200)
    write([Table("judgements", [{"judgement_no": 1, "novel": 3}]), "a limit in prose"], out)
    texts = [WORDS["legend"][f"judgements.{word}"] for word in ("novel", "evidence", "threshold")]
    assert " ".join(lines(out)[2:]) == "a limit in prose " + " ".join(texts)
    remarked = console(200)
    write([Notes([("-", "j1: HI above the limit")])], remarked)
    assert lines(remarked) == ["- j1: HI above the limit", *[WORDS["legend"]["limit"]]]
    silent = console()
    write(["prose alone", Table("judgements", [])], silent)
    assert lines(silent) == ["prose alone"]


def test_tables_are_data_that_the_renderer_knows() -> None:
    """Each column has a format, and each word of the legend is one of a page."""
    tables = data.table("gam_db.cli", "tables.toml")
    columns = {name: [Column(**column) for column in table] for name, table in tables.items()}
    assert {column.format for table in columns.values() for column in table} <= set(FORMATS)
    headings = {column.heading.partition(", ")[0] for table in columns.values() for column in table}
    named = {
        f"{name}.{column.heading.partition(', ')[0]}" for name in columns for column in columns[name]
    }
    words = {"limit", "out of range", "incomplete", "proving"}
    assert set(WORDS["legend"]) <= headings | named | words
    shown = [
        table
        for path in FOLDER.parent.glob("**/*.py")
        for table in re.findall(r'Table\(\s*"(\w+)"', path.read_text(encoding="utf-8"))
    ]
    with_columns_of_its_own = ["evaluated", "metrics", "scores"]
    assert sorted(shown) == sorted([*tables, *with_columns_of_its_own])


def test_a_remark_is_said_once_with_its_channels() -> None:
    out = console()
    names = [f"j{number}" for number in range(8)]
    said = [("too short", "odd") if number < 7 else ("odd",) for number in range(8)]
    write(page.remarks(zip(names, said, strict=True), everything=True), out)
    assert lines(out) == ["", "- j0, j1, j2, j3, j4 and 2 more: too short", "- all channels: odd"]
    silent = console()
    write(page.remarks([("j1", ())], everything=False), silent)
    assert lines(silent) == []
    short = console()
    write(page.remarks(zip(names, said, strict=True), everything=False), short)
    assert lines(short) == ["8 channels with further remarks: --all"]
    write(page.remarks([("j1", ("odd",))], everything=False), short)
    assert lines(short)[-1] == "- j1: odd", "of one channel all is said"


def test_figures_are_json_whatever_they_hold(capsys: pytest.CaptureFixture[str]) -> None:
    table = pa.table({"asset": ["ü"], "hi": [math.nan], "time": pa.array([0], pa.timestamp("us"))})
    told = {"rows": table, "of": gam_db.Override("a", m=2)}
    with pytest.raises(typer.Exit) as ended:
        show(Page(told, ["not printed"], urgent=True), options.Common(as_json=True))
    assert ended.value.exit_code == 2
    assert json.loads(capsys.readouterr().out) == {
        "version": gam_db.__version__,
        "rows": [{"asset": "ü", "hi": None, "time": "1970-01-01T00:00:00"}],
        "of": {"asset": "a", "channel": "*", "changed": [["m", 2]]},
        "exit_code": 2,
    }


@pytest.mark.parametrize("failed", [False, True])
@pytest.mark.parametrize("urgent", [False, True])
@pytest.mark.parametrize("lacking", [False, True])
def test_a_machine_comes_before_data_and_a_fault_before_both(
    failed: bool, urgent: bool, lacking: bool
) -> None:
    expected = 3 if failed else 2 if urgent else 4 if lacking else None
    code = None
    try:
        show(Page({}, ["not printed"], urgent, lacking, failed), options.Common(quiet=True))
    except typer.Exit as ended:
        code = ended.exit_code
    assert code == expected


def test_every_exit_code_has_its_meaning_and_stands_in_one_place() -> None:
    assert set(MEANINGS) == set(Exit)
    assert app.info.epilog is not None
    for code, meaning in MEANINGS.items():
        assert f"{code:d} {meaning}" in str(app.info.epilog)
    for path in FOLDER.glob("*.py"):
        ends = re.findall(r"(?:Exit|sys\.exit|tell)\((\d+)", path.read_text(encoding="utf-8"))
        assert ends == [], path.name
