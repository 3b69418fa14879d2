"""Spark: of two runs that were planned from the same, one stays."""

import pytest

import engines
from test_two_writers import assert_one_stays


@pytest.mark.full
@pytest.mark.parametrize("first_to_look", ["larger"])
def test_of_two_that_were_planned_from_the_same_one_stays(first_to_look: str) -> None:
    assert_one_stays(engines.session("spark"), first_to_look)
