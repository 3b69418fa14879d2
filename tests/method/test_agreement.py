"""Random sources: every form gives the integers of the NumPy reference, on every engine."""

from hypothesis import given, settings

import comparisons
import engines
import harness
import scripts
from strategies import Case, cases

#: Series of a case: an engine is asked as many statements for twenty as for one.
SERIES = 20

#: What this file runs, and how its version is found; see test_engines.py.
RUNS = engines.VERSIONS


def test_exact_form_equals_the_reference(engine: str) -> None:
    @settings(max_examples=engines.examples(engine))
    @given(case=cases(SERIES))
    def agrees(case: Case) -> None:
        rows, parameters, calibration = case
        arguments = (rows, *harness.made(parameters, calibration))
        found = harness.all_by_engine(engine, *arguments)
        for question in harness.QUESTIONS:
            expected = harness.by_reference(question, *arguments)
            harness.assert_same(expected, found[question], question)

    agrees()


def test_scripts_equal_the_reference(engine: str) -> None:
    @settings(max_examples=max(engines.examples(engine) // 4, 1))
    @given(case=cases(SERIES))
    def agrees(case: Case) -> None:
        rows, parameters, calibration = case
        arguments = (rows, *harness.made(parameters, calibration))
        found = scripts.on(engine, *arguments)
        expected = {
            question: harness.by_reference(question, *arguments) for question in scripts.RELATIONS
        }
        of_exact = (rows, scripts.of_one_query(engine, arguments[1]), arguments[2])
        expected["exact"] = harness.by_reference("health_indicator", *of_exact)
        for question, answer in expected.items():
            harness.assert_same(answer, found[question], question)
        comparisons.compared(engine, "exact", *arguments)

    agrees()
