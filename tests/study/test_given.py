"""What can be given to the public calls, a path or a frame, and what results say of themselves."""

import math
import sqlite3
from collections.abc import Callable
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
import pytest
from pyarrow import csv, parquet

import gam_db
from gam_db import Parameters, Source, UserError
from gam_db.method.census import EDGES, SCORED, TAUGHT
from gam_db.reading.guess import sourced
from gam_db.study import Study

ROWS = 400
TABLE = pa.table(
    {
        "Machine": ["A"] * ROWS,
        "Signal": ["torque"] * ROWS,
        "ts": pa.array(range(ROWS), pa.int64()),
        "Reading": [math.sin(row) for row in range(ROWS)],
    }
)
NAMED = Source(TABLE, "Machine", "Signal", "ts", "Reading")
SMALL = Parameters(m=2, bins=5, window=20)
ASKED = ["bucket_health"]


class Frame:
    """A frame as others have them: rows by ``__arrow_c_stream__``, which can be asked for once."""

    def __init__(self, table: pa.Table) -> None:
        self.stream: Any = table.to_reader()

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        stream, self.stream = self.stream, None
        return stream.__arrow_c_stream__(requested_schema)


class Elsewhere:
    """A table that runs elsewhere, as Ibis has them."""

    def to_pyarrow(self) -> pa.Table:
        return TABLE


class Lazy:
    """A frame that has yet to be collected, as polars has them."""

    __module__ = "polars.lazyframe.frame"

    def collect(self) -> Frame:
        return Frame(TABLE)


GIVEN: dict[str, Callable[[Path], Any]] = {
    "path": lambda folder: folder / "x.parquet",
    "text": lambda folder: str(folder / "x.csv"),
    "list": lambda folder: [folder / "x.parquet"],
    "pattern": lambda folder: str(folder / "*.parquet"),
    "folder": lambda folder: folder / "in",
    "folders": lambda folder: [folder / "in"],
    "Arrow": lambda _: TABLE,
    "reader": lambda _: TABLE.to_reader(),
    "stream": lambda _: Frame(TABLE),
    "pandas": lambda _: TABLE.to_pandas(),
    "relation of DuckDB": lambda _: duckdb.connect().from_arrow(TABLE),
    "lazy frame": lambda _: Lazy(),
    "elsewhere": lambda _: Elsewhere(),
    "source": lambda _: NAMED,
}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    parquet.write_table(TABLE, tmp_path / "x.parquet")
    csv.write_csv(TABLE, tmp_path / "x.csv")
    (tmp_path / "in").mkdir()
    parquet.write_table(TABLE, tmp_path / "in" / "x.parquet")
    return tmp_path


@pytest.mark.parametrize("what", GIVEN)
def test_a_source_may_be_given_by_what_it_reads(what: str, folder: Path) -> None:
    if what == "pandas":
        pytest.importorskip("pandas", reason="it comes with the extra engines")
    given = GIVEN[what]
    expected = gam_db.health_indicator(NAMED, SMALL).to_pylist()
    assert gam_db.health_indicator(given(folder), SMALL).to_pylist() == expected
    assert len(expected) == 320
    assert gam_db.support(given(folder), SMALL)["channel"].to_pylist() == ["torque"]
    assert gam_db.certificate(given(folder), SMALL).num_rows > 1
    assert gam_db.check(given(folder), SMALL)["samples"].to_pylist() == [ROWS]


def test_a_text_file_is_parsed_once(folder: Path) -> None:
    """Ranges of time are read off the rows that are kept of it; of Parquet they are read anew."""
    for what, reads in (("text", {"readings"}), ("path", set())):
        with gam_db.connect() as session:
            source = sourced(GIVEN[what](folder), session)
            study = Study(session, source, SMALL, gam_db.Calibration(), short_cuts=True, targets=ASKED)
            assert study.table("bucket_health").num_rows > 0
            assert study.form == "census"
            for step in (EDGES, TAUGHT, SCORED):
                assert study.steps.steps[step].definition.reads == reads


def test_a_choice_is_made_of_what_is_given(folder: Path) -> None:
    for what in ("path", "stream"):
        found = gam_db.select(GIVEN[what](folder), SMALL, m_max=2, references=50, tau_max=5)
        assert found.choices["channel"].to_pylist() == ["torque"]


def test_a_table_of_a_database_may_be_given_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also where a folder is called like it."""
    (tmp_path / "telemetry").mkdir()
    monkeypatch.chdir(tmp_path)
    connection = duckdb.connect()
    connection.register("seen", TABLE)
    connection.execute("CREATE TABLE telemetry AS SELECT * FROM seen")
    assert gam_db.support("telemetry", SMALL, engine=connection)["samples"].to_pylist() == [ROWS]


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (5, "A int is not a source; a source is"),
        ("nothing.parquet", "cannot be read; is it there"),
        (
            pa.table({"ts": [1], "a": ["x"], "b": ["y"], "v": [1.0]}),
            "may name the machine or the signal",
        ),
    ],
)
def test_what_cannot_be_read_or_guessed_is_said(given: Any, message: str) -> None:
    with pytest.raises(UserError, match=message):
        gam_db.support(given)


def test_results_say_their_units_and_how_time_is_told() -> None:
    health = gam_db.health_indicator(TABLE, SMALL)
    assert health.schema.metadata[b"time"] == b"counter"
    assert health.schema.field("time").metadata == {b"unit": b"steps of the source's counter"}
    assert health.schema.field("hi").metadata == {b"unit": b"share, 0 to 1"}
    micros = gam_db.Source(TABLE, "Machine", "Signal", "ts", "Reading", time_unit="s")
    checked = gam_db.check(micros, SMALL)
    assert checked.schema.metadata[b"time"] == b"UTC"
    assert checked.schema.field("typical_step").metadata[b"unit"] == b"microseconds since 1970 (UTC)"
    assert checked.schema.field("first_time").metadata[b"unit"] == b"UTC"


def test_a_look_gives_sentences_beside_figures() -> None:
    still = TABLE.set_column(3, "Reading", pa.array([1.0] * ROWS))
    (row,) = gam_db.check(still, SMALL).to_pylist()
    assert any(note.startswith("constant: never raises an alarm") for note in row["notes"])
    assert not any("constant" in note for note in gam_db.check(TABLE, SMALL)["notes"][0].as_py())


def test_addresses_of_sqlalchemy_are_understood(tmp_path: Path) -> None:
    sqlite3.connect(tmp_path / "plant.db").close()
    with gam_db.connect(f"sqlite+pysqlite:///{tmp_path / 'plant.db'}") as session:
        assert session.engine.name == "sqlite"
    with pytest.raises(UserError, match="gam-db does not support addresses with oracle://"):
        gam_db.connect("oracle+cx://host/x")


def test_alarms_take_what_a_source_reads(folder: Path) -> None:
    alarms = gam_db.Alarms(rate="5 per 1000 judgements")
    for asked in (gam_db.limits, gam_db.judgements, gam_db.episodes):
        found = asked(folder / "x.parquet", SMALL, alarms=alarms)
        assert found == asked(NAMED, SMALL, alarms=alarms)
        assert found.schema.metadata[b"time"] == b"counter"
    units = gam_db.limits(NAMED, SMALL, alarms=alarms).schema
    assert units.field("height").metadata[b"unit"] == b"thousandths of the root of a count"
    with pytest.raises(UserError, match="no column"):
        gam_db.limits(Source(TABLE, "Machine", "Signal", "ts", "Readin"), SMALL, alarms=alarms)
    with pytest.raises(UserError):
        gam_db.backtest(folder / "none.parquet", SMALL, alarms=alarms)
