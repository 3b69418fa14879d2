"""Values and names of other types: a right answer or a remedy."""

import decimal

import numpy as np
import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

from gam_db import Calibration, Source, WideSource
from odd import (
    LENGTH,
    ROWS,
    SEVEN,
    USUAL,
    USUAL_ROWS,
    VALUES,
    database,
    expected,
    health,
    refused,
    support,
    table,
)


def test_values_of_any_numeric_type() -> None:
    kinds = [
        "TINYINT",
        "UBIGINT",
        "HUGEINT",
        "FLOAT",
        "DECIMAL(4, 2)",
        "DECIMAL(18, 9)",
        "DECIMAL(38, 10)",
    ]
    names = [f"v{number}" for number in range(len(kinds))]
    connection = database(USUAL)
    for name, kind in zip(names, kinds, strict=True):
        connection.execute(f"ALTER TABLE t ADD COLUMN {name} {kind}")
        connection.execute(f"UPDATE t SET {name} = value")
    rows = [("a", name, t, v) for name in names for _, _, t, v in USUAL_ROWS]
    assert health(WideSource("t", names), engine=connection) == expected(rows)


def test_values_become_doubles_first() -> None:
    """0.1 as FLOAT is 0.10000000149; beyond 2^53 integers are rounded; a DECIMAL is the nearest one."""
    connection = database(
        "CREATE TABLE t AS SELECT 'a' AS asset, i AS time, (i + 0.1)::FLOAT AS single, "
        "(i + 9007199254740993)::HUGEINT AS huge, (i + 0.1)::DECIMAL(18, 1) AS tenth "
        "FROM range(4) AS r(i)"
    )
    source = WideSource("t", ["single", "huge", "tenth"])
    found = {
        row["channel"]: row["calibrated_lo"] for row in support(source, Calibration(1.0), connection)
    }
    assert found == {"single": float(np.float32(0.1)), "huge": 2.0**53, "tenth": 0.1}


@pytest.mark.parametrize("kind", ["INTEGER", "UBIGINT", "UUID", "VARCHAR"])
def test_names_of_other_types(kind: str) -> None:
    uuid = "00000000-0000-0000-0000-00000000000"
    names = [f"{uuid}{i}" for i in (1, 7)] if kind == "UUID" else ["10", "7"]
    first, second = (f"'{name}'::{kind}" for name in names)
    connection = database(
        f"CREATE TABLE t AS SELECT CASE WHEN i % 2 = 0 THEN {first} ELSE {second} END AS asset, "
        f"{first} AS channel, i AS time, i::DOUBLE AS value FROM range(20) AS r(i)"
    )
    found = support(Source("t"), engine=connection)
    assert [(row["asset"], row["channel"], row["samples"]) for row in found] == [
        (names[0], names[0], 10),
        (names[1], names[0], 10),
    ]


class Stream:
    """What a data frame is to us: an object that gives its rows by ``__arrow_c_stream__``."""

    def __init__(self, rows: pa.Table) -> None:
        self.rows = rows

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self.rows.__arrow_c_stream__(requested_schema)


def test_arrow_containers() -> None:
    rows = table()
    chunked = pa.concat_tables([rows.slice(0, 3), rows.slice(3, 0), rows.slice(3)])
    for relation in (rows, chunked, rows.to_batches()[0], rows.to_reader(), Stream(rows)):
        assert health(Source(relation)) == expected(ROWS), type(relation)


@pytest.mark.parametrize(
    "changed",
    [
        {"asset": pa.array(["a"] * LENGTH).dictionary_encode()},
        {"channel": pa.array(["x"] * LENGTH, pa.large_string())},
        {"asset": pa.array(["a"] * LENGTH).cast(pa.string_view())},
        {"value": pa.array(VALUES, pa.float32())},
        {"value": pa.array([decimal.Decimal(v) for v in VALUES], pa.decimal128(12, 3))},
        {"value": pa.array(VALUES).dictionary_encode()},
        {"value": pa.array([int(v) for v in VALUES], pa.int8())},
        {"time": pa.array(range(LENGTH), pa.uint16())},
    ],
    ids=lambda changed: "-".join(f"{name} as {values.type}" for name, values in changed.items()),
)
def test_arrow_types(changed: dict[str, pa.Array]) -> None:
    assert health(Source(table(**{**changed}))) == expected(ROWS)


@pytest.mark.parametrize(
    ("values", "shown"),
    [
        (pa.array([SEVEN] * LENGTH, pa.decimal256(50, 2)), "decimal256"),
        (pa.array(np.array(VALUES, np.float16)), "halffloat"),
    ],
)
def test_arrow_types_that_duckdb_cannot_read(values: pa.Array, shown: str) -> None:
    refused(f"cannot read the Arrow table.*{shown}", lambda: support(Source(table(value=values))))


def test_names_that_differ_by_case_are_two_machines_where_the_column_takes_them_for_one() -> None:
    kind = "VARCHAR COLLATE NOCASE"
    connection = database(f"CREATE TABLE t (asset {kind}, channel {kind}, time BIGINT, value DOUBLE)")
    rows = [
        (asset, channel, t, value + t * len(channel))
        for asset, channel in (("a", "X"), ("A", "x"), ("A", "xx"))
        for t, value in enumerate(VALUES)
    ]
    connection.executemany("INSERT INTO t VALUES (?, ?, ?, ?)", rows)
    assert health(Source("t"), engine=connection) == expected(rows)
