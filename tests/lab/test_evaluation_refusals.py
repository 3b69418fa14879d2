"""What cannot be evaluated is refused in one sentence."""

import datetime as dt
from typing import Any

import pyarrow as pa
import pytest

import gam_db
from gam_db.errors import ParameterError, SourceError

QUICK = gam_db.Conventions(surrogates=0, samples=0)
VALUES = pa.table({"asset": ["a"] * 3, "channel": ["x"] * 3, "index": [0, 1, 2], "hi": [0.1, 0.2, 0.3]})


def changed(column: str, values: Any) -> pa.Table:
    return VALUES.set_column(VALUES.column_names.index(column), column, pa.array(values))


@pytest.mark.parametrize(
    ("table", "says"),
    [
        (VALUES.drop_columns("hi"), "no column 'hi'"),
        (VALUES.drop_columns("index"), "no column that orders"),
        (changed("hi", ["a", "b", "c"]), "'hi' is of type VARCHAR"),
        (changed("index", [0.5, 1.5, 2.5]), "'index' is of type DOUBLE"),
        (changed("index", [0, 1, 1]), "1 channels have several values at one place"),
        (changed("index", [0, None, 1]), "1 rows without time"),
        (changed("asset", ["a", None, None]), "2 rows without asset or channel"),
        (VALUES.slice(0, 0), "has no row"),
        (VALUES.append_column("novel_in_window", pa.array([1, None, 2])), "'novel_in_window' is NULL"),
        (VALUES.append_column("novel_in_window", pa.array([0, 1, 2**40])), "too many for exact sums"),
    ],
)
def test_a_table_that_cannot_be_evaluated_is_refused(table: pa.Table, says: str) -> None:
    with pytest.raises(SourceError, match=says):
        gam_db.evaluate(table, conventions=QUICK)


@pytest.mark.parametrize(
    ("columns", "says"),
    [
        ({"failed_at": [1]}, "no column 'asset'"),
        ({"asset": ["a"]}, "need a column 'failed_at'"),
        ({"asset": ["a"], "failed_at": ["soon"]}, "must be a timestamp or an integer"),
        ({"asset": ["a"], "failed_at": [dt.datetime(2026, 1, 1)]}, "tell time by an integer counter"),
        ({"asset": ["a"], "failed_at": [1], "healthy": [True]}, "healthy and has failed"),
        ({"asset": ["a"], "healthy": [7]}, "true or false, or 1 or 0"),
        ({"asset": ["a"], "healthy": ["no"]}, "'healthy' is of type VARCHAR"),
        ({"asset": [None, "a"], "healthy": [True, True]}, "without asset"),
        ({"asset": ["a", "a"], "healthy": [True, True]}, "more than once"),
        ({"asset": ["z"], "healthy": [True]}, "no asset or channel of the health"),
        ({"asset": ["b"], "healthy": [False]}, "name it in the column 'channel'"),
    ],
)
def test_outcomes_that_cannot_be_used_are_refused(columns: dict[str, Any], says: str) -> None:
    both = VALUES.set_column(0, "asset", pa.array(["b"] * 3))
    other = both.set_column(1, "channel", pa.array(["y"] * 3))
    with pytest.raises(SourceError, match=says):
        gam_db.evaluate(pa.concat_tables([VALUES, both, other]), pa.table(columns), conventions=QUICK)


def test_a_time_of_failure_needs_a_time_to_compare_with() -> None:
    table = VALUES.rename_columns(["asset", "channel", "bucket", "hi"])
    told = pa.table({"asset": ["a"], "failed_at": [1]})
    with pytest.raises(SourceError, match="have no time"):
        gam_db.evaluate(table, told, conventions=QUICK)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        ({"monotonicity": "ranks"}, "did you mean 'rank'"),
        ({"amplitude": "last"}, "'range' or 'ends'"),
        ({"ddof": 2}, "ddof is 2"),
        ({"confidence": 95}, "confidence is 95"),
        ({"samples": -1}, "samples is -1"),
    ],
)
def test_conventions_out_of_range_are_refused(arguments: dict[str, Any], says: str) -> None:
    with pytest.raises(ParameterError, match=says):
        gam_db.Conventions(**arguments)
