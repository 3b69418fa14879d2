"""Random sources: the SQL gives the integers of the NumPy reference, form by form."""

from hypothesis import given

import harness
from strategies import Case, cases


@given(case=cases())
def test_exact_form_equals_the_reference(case: Case) -> None:
    rows, parameters, calibration = case
    arguments = (rows, *harness.made(parameters, calibration))
    found = harness.all_by_duckdb(*arguments)
    for question in harness.QUESTIONS:
        expected = harness.by_reference(question, *arguments)
        harness.assert_same(expected, found[question], question)
