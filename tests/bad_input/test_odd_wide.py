"""Wide sources: a right answer or a remedy."""

from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.parquet
import pytest

from gam_db import Source, WideSource
from harness import Row
from odd import LENGTH, ROWS, USUAL, VALUES, database, expected, health, refused, support, table


def test_wide_sources_are_long_ones_with_a_missing_sample_for_a_null() -> None:
    torque = [1.0, None, 3.0, 1.0, 2.0, 3.0, 1.0, None, 2.0, 7.0]
    wide = table(
        channel=None, torque=torque, speed=pa.array([int(v) for v in VALUES]), note=["n"] * LENGTH
    )
    rows: list[Row] = [
        ("a", channel, t, v)
        for channel, column in (("value", VALUES), ("torque", torque), ("speed", VALUES))
        for t, v in enumerate(column)
    ]
    assert health(WideSource(wide, ["value", "torque", "speed"])) == expected(rows)
    assert health(WideSource(wide)) == expected(rows)  # all numeric columns but time
    alone = [("asset", *row[1:]) for row in rows if row[1] == "torque"]
    assert health(WideSource(wide, ["torque"], asset=None)) == expected(alone)


def test_one_machine_and_one_signal() -> None:
    rows = [("asset", "value", t, v) for t, v in enumerate(VALUES)]
    bare = table(asset=None, channel=None)
    assert health(Source(bare, asset=None, channel=None)) == expected(rows)


# where


@pytest.mark.parametrize(
    ("where", "kept"),
    [
        ("time < 6", range(6)),
        ("time < 6 -- and that is all", range(6)),
        ("time < 2 OR time > 4", [0, 1, 5, 6, 7, 8, 9]),
        ("asset LIKE 'a%' AND value BETWEEN 0 AND 1", [0, 1, 3, 4, 6, 7, 9]),
        ("\"value\" <> 5 AND channel IN ('x', 'y')", [0, 1, 2, 3, 4, 5, 6, 7, 9]),
        ("note = 'it''s; --'", [3, 4, 5]),
    ],
)
def test_where_comes_before_everything_else(where: str, kept: list[int]) -> None:
    notes = ["it's; --" if 3 <= i <= 5 else "" for i in range(LENGTH)]
    found = health(Source(table(note=notes), where=where))
    assert found == expected([ROWS[i] for i in kept])


@pytest.mark.parametrize(
    "where",
    [
        "",
        " ",
        "time <",
        "1 = 1; DROP TABLE t",
        "1 = 1) OR (1 = 1",
        "1 = 1 UNION SELECT 1",
        "1 = 1 ORDER BY time",
        "time < 6 LIMIT 3",
        "time < 6 AS early",
        "time < 6, 1",
        "DROP TABLE t",
        "DELETE FROM t",
        "(DELETE FROM t)",
        "time < ?",
        "time < $1",
        "time < :end",
        "*",
        5,
        True,
        b"time < 6",
    ],
)
def test_where_is_one_condition(where: Any) -> None:
    connection = database(USUAL)
    refused(
        "where is .* not a condition in SQL; write the text that follows WHERE",
        lambda: support(Source("t", where=where), engine=connection),
    )
    assert connection.execute("SELECT COUNT(*) FROM t").fetchall() == [(10,)]


@pytest.mark.parametrize(
    ("where", "message"),
    [
        ("tme < 6", 'where is .tme < 6.*column "tme" not found'),
        ("SUM(value) > 1", "where is .*aggregates"),
        ("no_such(value)", "where is .*no_such"),
        ("CAST(asset AS INTEGER) > 3", "where= may also convert it"),
    ],
)
def test_where_that_the_engine_refuses(where: str, message: str) -> None:
    assets = ["8675309.25 of text"] * LENGTH
    refused(message, lambda: support(Source(table(asset=assets), where=where)))
