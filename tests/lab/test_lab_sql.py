"""The laboratory's SQL passes the lint, as files and as whole queries, and is used."""

from pathlib import Path

import pyarrow as pa
import pytest
from sqlglot import exp

import gam_db
import sql_lint
from gam_db.composing import template
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.baselines.baseline import add_forecast_points
from gam_db.lab.estimators import ESTIMATORS, add_estimator
from gam_db.lab.estimators.points import add_points
from gam_db.settings.source import Source
from gam_db.study import Study
from harness import arrow
from sql_lint import Kind
from test_sql_lint import EXEMPT, FOLDER, LAB, PARAMETERS, check_head, loading

#: ``gam benchmark`` runs these on DuckDB only; they are no part of the method.
APART = "benchmark"
FILES = sorted(path for path in (FOLDER / LAB).rglob("*.sql") if path.parent.name != APART)
NAMES = [str(path.relative_to(FOLDER).with_suffix("").as_posix()) for path in FILES]

#: The score of these is a real number with EXP or LN in it; its last bits decide nothing but the last of
#: its own 2^-20 (and, for ocsvm, of its 2^-61). Step -> estimators.
ROUGH_SCORES = {"scores": ("ocsvm",), "score_units": ("gmm", "forest")}

#: Not an estimator: what a neural forecast reads.
FORECAST = "forecast"


def test_there_are_files() -> None:
    assert len(FILES) > 40


@pytest.mark.parametrize("name", NAMES)
def test_a_file_breaks_no_rule(name: str) -> None:
    assert [str(found) for found in sql_lint.lint(template.load(name).tree)] == []


@pytest.mark.parametrize("path", FILES, ids=NAMES)
def test_a_file_says_what_it_is(path: Path) -> None:
    check_head(path)


def estimated(name: str, rows: int) -> tuple[list[tuple[str, exp.Query]], dict[str, sql_lint.Columns]]:
    """The filled steps of an estimator, which is fitted, and the tables that they read."""
    values = [float(time * time % 7) for time in range(rows)]
    series = arrow([("a", "x", time, value) for time, value in enumerate(values)])
    kinds = {"BIGINT": Kind.INTEGER, "DOUBLE": Kind.DOUBLE, "VARCHAR": Kind.OTHER}
    with DuckSession() as session:
        study = Study(session, Source(series), PARAMETERS[0], gam_db.Calibration(fraction=0.8))
        if name == FORECAST:
            add_points(study.steps, study.method, 0)
            add_forecast_points(study, 0)
        else:
            add_estimator(study, name)
        queries = [(step.name, step.query) for step in study.steps.steps.values()]
        read: dict[str, sql_lint.Columns] = {
            table.name: {
                column: kinds[type_name] for column, type_name in session.describe(table).items()
            }
            for _, query in queries
            for table in query.find_all(exp.Table)
            if "arrow" in table.name
        }
    return queries, read


@pytest.mark.parametrize("name", [*ESTIMATORS, FORECAST])
def test_estimators_break_no_rule(name: str) -> None:
    queries, tables = estimated(name, rows=30)
    found = set()
    for step, query in queries:
        checked = sql_lint.kinds(query, tables)
        tables[step] = checked.columns
        found |= {(step, finding.rule) for finding in sql_lint.findings(checked, filled=True)}
    rough = {(step, "rough_decisions") for step, names in ROUGH_SCORES.items() if name in names}
    assert found == EXEMPT | rough


def test_every_file_is_used() -> None:
    with loading() as loaded:
        for name in [*ESTIMATORS, FORECAST]:
            estimated(name, rows=30)
        estimated("gmm", rows=3)
        values = pa.table(
            {"asset": ["a", "a"], "channel": ["c", "c"], "index": [0, 1], "hi": [0.0, 1.0]}
        )
        counts = values.append_column("novel_in_window", pa.array([0, 1]))
        vectors = counts.rename_columns(["asset", "channel", "time", "hi", "novel_in_window"])
        vectors = vectors.append_column("vectors_in_window", pa.array([2, 2]))
        outcomes = pa.table({"asset": ["a"], "failed_at": [1]})
        sign = gam_db.Conventions(monotonicity="sign", amplitude="ends", samples=1)
        gam_db.evaluate(values, outcomes, conventions=gam_db.Conventions(values_per_window=1))
        gam_db.evaluate(counts, outcomes, conventions=sign)
        gam_db.evaluate(vectors, outcomes, conventions=gam_db.Conventions(stride=None))
        timed = values.rename_columns(["asset", "channel", "time", "hi"])
        labels = pa.table({"asset": ["a"], "start": [0], "end": [1]})
        limits = pa.table({"asset": ["a"], "channel": ["c"], "hi_limit": [0.5]})
        gam_db.detection(timed, labels, limits=limits)
        gam_db.detection(timed, labels, alarms=labels)
    assert set(NAMES) - loaded == set()
    assert {name for name in loaded if name.startswith(f"{LAB}/") and name not in NAMES} == set()
