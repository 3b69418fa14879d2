"""Random sources: every form gives the integers of the NumPy reference."""

from collections.abc import Callable

import pytest
from hypothesis import given, settings

import harness
import scripts
from strategies import Case, cases


@given(case=cases())
def test_exact_form_equals_the_reference(case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    found = harness.all_by_duckdb(*arguments)
    for question in harness.QUESTIONS:
        expected = harness.by_reference(question, *arguments)
        harness.assert_same(expected, found[question], question)


@pytest.mark.parametrize("run", [scripts.on_duckdb, scripts.on_sqlite])
@settings(max_examples=settings().max_examples // 4)
@given(case=cases())
def test_scripts_equal_the_reference(run: Callable[..., dict[str, harness.Answer]], case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    found = run(*arguments)
    expected = {question: harness.by_reference(question, *arguments) for question in scripts.RELATIONS}
    expected["exact"] = expected["health_indicator"]
    for question, answer in expected.items():
        harness.assert_same(answer, found[question], question)
