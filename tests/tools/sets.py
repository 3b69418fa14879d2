"""How much of a test belongs to the first set, and how much to the full one."""

from typing import Any

import pytest

#: What is slow -> its tests in the first set, by how their addresses below ``tests/`` begin. Slow is an
#: engine (of the argument ``engine``, or in the name of a file) or a fixture. Its others repeat what
#: the first set shows on other engines: they are in the full set alone.
FIRST: dict[str, tuple[str, ...]] = {
    "postgres": (
        "checking/",
        "engines/",
        "export/test_run_sql.py::test_a_history_leaves_what_gam_score_leaves",
        "export/test_run_sql_ends.py::test_a_faster_run",
        "method/test_agreement.py",
        "method/test_probe.py::test_golden_figures",
        "method/test_programs.py::test_cells_of_programs_by_hand",
        "method/test_spec.py::test_cases[",
        "reading/",
        "stored/test_advice.py::test_engines_agree_on_the_figures",
        "stored/test_calibrated_together.py::test_versions_and_limits_come_together[postgres-limit",
        "stored/test_data_problems.py",
        "stored/test_idle_runs.py",
        "stored/test_stored_on_engines.py",
        "stored/test_taught_by.py",
        "stored/test_two_writers.py",
        "stored/test_what_is_read.py",
    ),
    "clickhouse": (
        "engines/test_clickhouse",
        "engines/test_conditions.py",
        "engines/test_engines.py",
        "engines/test_texts_in_scripts.py::test_a_text_is_no_number[clickhouse-1.5abc",
        "engines/test_texts_in_scripts.py::test_a_text_is_no_time[clickhouse-7 of 9-timestamp",
        "engines/test_types.py",
        "method/test_agreement.py",
        "method/test_probe.py::test_golden_figures",
        "method/test_programs.py::test_cells_of_programs_by_hand",
        "method/test_spec.py::test_cases[",
        "reading/test_ahead.py",
        "reading/test_local_time.py::test_both_passes_of_the_autumn_hour_are_read",
        "reading/test_valid_when.py",
        "stored/test_stored_on_engines.py",
        "stored/test_what_is_read.py",
    ),
    "mariadb": (
        "engines/test_conditions.py",
        "engines/test_mariadb.py",
        "engines/test_types.py",
        "export/test_run_sql.py::test_a_history_leaves_what_gam_score_leaves",
        "export/test_run_sql_ends.py::test_a_faster_run",
        "method/test_probe.py::test_golden_figures",
        "method/test_programs.py::test_cells_of_programs_by_hand",
        "method/test_spec.py::test_cases[",
        "stored/test_stored_on_engines.py",
        "stored/test_what_is_read.py",
    ),
    "spark": (
        "engines/test_relatives.py",
        "engines/test_spark.py",
        "engines/test_spark_connect.py",
        "engines/test_types.py",
        "method/test_programs.py::test_cells_of_programs_by_hand",
        "method/test_spec.py::test_cases[spark-30 cases",
        "reading/test_valid_when.py::test_what_is_not_valid_is_missing_in_a_monitor",
    ),
    "chrome": ("report/test_report_page.py::test_every_figure",),
}


def amounts(name: str, first: Any, full: Any) -> pytest.MarkDecorator:
    """Run a test with an amount in the first set, and once more, with a larger one, in the full set."""
    return pytest.mark.parametrize(name, [first, pytest.param(full, marks=pytest.mark.full)])


def names_engines(test: pytest.Item | pytest.Function) -> bool:
    """Tell whether a test names its engines itself; it reads texts then, and opens no session."""
    return any("engine" in mark.args[0] for mark in test.iter_markers("parametrize"))


def is_later(test: pytest.Item) -> bool:
    """Tell whether a test is of something slow, and not of its first set."""
    return any(not test.nodeid.removeprefix("tests/").startswith(FIRST[slow]) for slow in _slow(test))


def _slow(test: pytest.Item) -> set[str]:
    used = {one for one in FIRST if test.path.name[:-3].startswith(f"test_{one}")}
    used |= FIRST.keys() & set(getattr(test, "fixturenames", ()))
    callspec = getattr(test, "callspec", None)
    if callspec and not names_engines(test):
        used |= FIRST.keys() & {callspec.params.get("engine")}
    return used
