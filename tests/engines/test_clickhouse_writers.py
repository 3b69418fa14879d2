"""ClickHouse: of two runs that were planned from the same, one stays."""

import pytest

import engines
from test_two_writers import assert_a_run_planned_from_another_is_no_rival, assert_one_stays


@pytest.mark.parametrize("first_to_look", ["smaller", "larger", "larger before the other's row"])
def test_of_two_that_were_planned_from_the_same_one_stays(first_to_look: str) -> None:
    assert_one_stays(engines.session("clickhouse"), first_to_look)


def test_a_run_that_was_planned_from_another_is_no_rival() -> None:
    """It ends while the other one still looks: both count, or its buckets would lie on nothing."""
    assert_a_run_planned_from_another_is_no_rival(engines.session("clickhouse"))
