"""A small source to make odd, and what a refusal must look like; for the tests of this folder."""

import decimal
from collections.abc import Callable, Sequence
from typing import Any

import duckdb
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

import gam_db
import harness
from gam_db import Calibration, Parameters, Source, UserError, WideSource
from gam_db.errors import SourceError
from harness import Row

SEVEN = decimal.Decimal("7.5")
DAY = 86_400 * 10**6
MICROS = [-DAY - 1, -DAY, -1000, -1, 0, 1, 999_999, 1_000_000, DAY, 400 * DAY]
SMALL = Parameters(m=2, tau=1, bins=4, window=2)
HALF = Calibration(0.5)
SECRET = 8675309.25  # a reading that no message may show
LENGTH = 10
VALUES = [0.0, 1.0, 2.0, 0.0, 1.0, 2.0, 1.0, 1.0, 5.0, 0.0]
ROWS: list[Row] = [("a", "x", t, v) for t, v in enumerate(VALUES)]


def columns(**changed: Any) -> dict[str, Any]:
    """The columns of ROWS, some changed or added; None leaves one out."""
    usual: dict[str, Any] = {
        "asset": ["a"] * LENGTH,
        "channel": ["x"] * LENGTH,
        "time": list(range(LENGTH)),
        "value": VALUES,
    }
    return {name: column for name, column in (usual | changed).items() if column is not None}


def table(**changed: Any) -> pa.Table:
    return pa.table(columns(**changed))


def secret() -> list[float]:
    return [*VALUES[1:], SECRET]


def database(*statements: str) -> duckdb.DuckDBPyConnection:
    connection = duckdb.connect()
    for statement in statements:
        connection.execute(statement)
    return connection


USUAL = (
    "CREATE TABLE t AS SELECT 'a' AS asset, 'x' AS channel, i AS time, "
    "(i * 7 % 5)::DOUBLE AS value FROM range(10) AS r(i)"
)
USUAL_ROWS: list[Row] = [("a", "x", i, float(i * 7 % 5)) for i in range(10)]


def health(
    source: Source | WideSource,
    parameters: Parameters = SMALL,
    calibration: Calibration = HALF,
    engine: Any = None,
) -> harness.Answer:
    """The health indicator as rows, with time as an integer."""
    found = gam_db.health_indicator(source, parameters, calibration, engine)
    micros = found.column("time").cast(pa.int64())
    return found.set_column(found.column_names.index("time"), "time", micros).to_pylist()  # type: ignore[no-any-return]


def support(
    source: Source | WideSource, calibration: Calibration = HALF, engine: Any = None
) -> harness.Answer:
    return gam_db.support(source, SMALL, calibration, engine).to_pylist()  # type: ignore[no-any-return]


def expected(
    rows: Sequence[Row], parameters: Parameters = SMALL, calibration: Calibration = HALF
) -> harness.Answer:
    return harness.by_reference("health_indicator", list(rows), parameters, calibration)


def refused(message: str, call: Callable[[], object], error: type[UserError] = SourceError) -> str:
    """Check that a call is refused in one paragraph which holds ``message`` and no reading."""
    with pytest.raises(error, match=message) as caught:
        call()
    said = str(caught.value)
    assert "\n" not in said
    assert said.endswith((".", "?", "!"))  # the last is DuckDB's own
    assert 15 < len(said) < 700
    assert "8675309" not in said
    return said


def timed(times: Any) -> Source:
    return Source(table(time=times))


def agreed(rows: list[Row], parameters: Parameters, calibration: Calibration = HALF) -> None:
    """Compare every answer with the reference."""
    for question, answer in harness.all_by_engine("duckdb", rows, parameters, calibration).items():
        by_reference = harness.by_reference(question, rows, parameters, calibration)
        harness.assert_same(by_reference, answer, question)
