"""Snowflake's text on two relatives, fakesnow and Databend: the integers of the specification.

What a relative has not is taken out in :mod:`snowflake_relatives`, which names it; Snowflake's own text is
what is printed. Neither relative shows its real types, its collations, its limits and its locks.
"""

from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given, settings

import harness
import scripts
from gam_db.engines.session import Session
from snowflake_relatives import RELATIVES, SnowflakeDriver, version
from strategies import Case, cases
from test_spec import GROUPS, compare_all

#: What this file runs, and how its version is found; see test_engines.py.
RUNS = {"snowflake": version}


def answered(name: str, *asked: Any) -> dict[str, harness.Answer]:
    """Answer by the scripts on a relative: the view form, and under ``exact`` the exact one."""
    return scripts.answered_by(Session(SnowflakeDriver(name)), *asked)


@pytest.mark.parametrize("name", RELATIVES)
@pytest.mark.parametrize("group", GROUPS)
def test_cases_by_script(group: str, name: str) -> None:
    asked = [
        replace(case, expected=[one for one in case.expected if one[0] in scripts.RELATIONS])
        for case in GROUPS[group]
    ]
    compare_all(asked, lambda *asked: answered(name, *asked))


@pytest.mark.full
@pytest.mark.parametrize("name", RELATIVES)
@settings(max_examples=max(3, settings().max_examples // 30))
@given(case=cases())
def test_random_sources_give_the_integers_of_the_reference(name: str, case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    found = answered(name, *arguments)
    for question in scripts.RELATIONS:
        expected = harness.by_reference(question, *arguments)
        harness.assert_same(expected, found[question], question)
        if question == "health_indicator":
            harness.assert_same(expected, found["exact"], "exact")
