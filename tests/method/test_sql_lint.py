"""The lint catches what it is for, and the package's SQL passes it, as files and as whole queries."""

import contextlib
import datetime as dt
import re
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from decimal import Decimal
from pathlib import Path

import pyarrow as pa
import pytest
import sqlglot
from sqlglot import exp

import engines
import gam_db
import sql_lint
from gam_db.alarms.figures import figures
from gam_db.checking.look import add_look
from gam_db.checking.programs import add_programs, add_usual_run
from gam_db.clock import TimeKind
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.session import DuckSession
from gam_db.export import Package, grafana
from gam_db.export.monitor import rendered as run_of
from gam_db.method import Method, opening_pipeline, pipeline, trusting_pipeline
from gam_db.method.adding import add
from gam_db.method.alarms import add_backtested, add_judgements, add_learnt_limits, add_replay
from gam_db.method.automatic import DELAYS, scoring
from gam_db.method.census import Slicing
from gam_db.method.delays import SET_STEPS, STORED, Ways
from gam_db.method.judgement import add_judged, add_standing
from gam_db.selection.budget import add_budget, add_results
from gam_db.selection.lags import add_delays, add_samples
from gam_db.selection.neighbours import add_dimensions, add_embedding
from gam_db.selection.search import Search
from gam_db.settings.parameters import RUNGS
from gam_db.settings.source import Programs, Source, WideSource, readings
from gam_db.stored.alarms import labels as alarms
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning.setting import Setting
from gam_db.stored.planning.steps import scoring_steps
from gam_db.stored.schema.migration_files import definitions
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.scoring.publishing import withdraw
from gam_db.stored.status import machines
from gam_db.study import Study, naming
from harness import arrow
from sql_lint import Kind
from strategies import Row

#: Columns that the examples below speak of.
KNOWN = {
    "t": {
        "a": Kind.INTEGER,
        "b": Kind.INTEGER,
        "small": Kind.NARROW,
        "x": Kind.DOUBLE,
        "y": Kind.DOUBLE,
    },
    "u": {"a": Kind.INTEGER, "b": Kind.INTEGER},
}

RUNNING = "ROWS BETWEEN UNBOUNDED PRECEDING AND CURRENT ROW"
FOUND = "LEFT JOIN (SELECT a, b, 1 AS hit FROM u) AS s ON s.a = t.a"

#: rule -> (forms that it must catch, forms for the same end that pass the whole lint)
EXAMPLES: dict[Callable[..., object], tuple[list[str], list[str]]] = {
    sql_lint.averages: (
        ["SELECT AVG(a) AS m FROM t", "SELECT AVG(a) OVER (PARTITION BY b) AS m FROM t"],
        ["SELECT CAST(SUM(a) AS DOUBLE) / CAST(COUNT(*) AS DOUBLE) AS m FROM t"],
    ),
    sql_lint.statistics: (
        [
            "SELECT STDDEV(a) AS s FROM t",
            "SELECT VAR_POP(a) AS s FROM t",
            "SELECT CORR(a, b) AS s FROM t",
            "SELECT MEDIAN(a) AS s FROM t",
            "SELECT QUANTILE_CONT(a, 5) AS s FROM t",
        ],
        ["SELECT SQRT(CAST(CAST(SUM(a * a) AS BIGINT) AS DOUBLE)) AS s FROM t"],
    ),
    sql_lint.logarithms: (
        ["SELECT LOG(x) AS l FROM t", "SELECT LOG10(x) AS l FROM t", "SELECT LOG2(x) AS l FROM t"],
        ["SELECT LN(x) AS l FROM t"],
    ),
    sql_lint.roundings: (
        ["SELECT ROUND(x) AS r FROM t", "SELECT ROUND(x, 2) AS r FROM t", "SELECT TRUNC(x) AS r FROM t"],
        ["SELECT FLOOR(x + CAST(5e-1 AS DOUBLE)) AS r FROM t"],
    ),
    sql_lint.extremes_of_arguments: (
        ["SELECT LEAST(a, b) AS l FROM t", "SELECT GREATEST(a, 0) AS l FROM t"],
        ["SELECT CASE WHEN a < b THEN a ELSE b END AS l FROM t"],
    ),
    sql_lint.tests_of_nan: (
        [
            "SELECT a FROM t WHERE ISNAN(x)",
            "SELECT a FROM t WHERE ISINF(x)",
            "SELECT a FROM t WHERE ISFINITE(x)",
        ],
        ["SELECT a FROM t WHERE x BETWEEN CAST(-1e300 AS DOUBLE) AND CAST(1e300 AS DOUBLE)"],
    ),
    sql_lint.sums_of_doubles: (
        [
            "SELECT SUM(x) AS s FROM t",
            f"SELECT SUM(x) OVER (ORDER BY a {RUNNING}) AS s FROM t",
            "SELECT SUM(CAST(a AS DOUBLE)) AS s FROM t",
            "SELECT SUM(FLOOR(x)) AS s FROM t",
            "SELECT SUM(CASE WHEN a = 1 THEN x ELSE 0 END) AS s FROM t",
            "SELECT SUM(q.z) AS s FROM (SELECT x * y AS z FROM t) AS q",
        ],
        [
            "SELECT SUM(a) AS s FROM t",
            "SELECT SUM(CAST(FLOOR(x * CAST(1024 AS DOUBLE)) AS BIGINT)) AS s FROM t",
            "SELECT SUM(q.z) AS s FROM (SELECT a * b AS z FROM t) AS q",
        ],
    ),
    sql_lint.casts_of_fractions: (
        [
            "SELECT CAST(x AS BIGINT) AS i FROM t",
            "SELECT CAST(x * CAST(2 AS DOUBLE) AS INTEGER) AS i FROM t",
            "SELECT CAST(CASE WHEN a = 1 THEN 1 ELSE x END AS BIGINT) AS i FROM t",
            "SELECT TRY_CAST(x AS SMALLINT) AS i FROM t",
        ],
        [
            "SELECT CAST(FLOOR(x) AS BIGINT) AS i FROM t",
            "SELECT CAST(2 + FLOOR(x) AS BIGINT) AS i FROM t",
            "SELECT CAST(a + b AS SMALLINT) AS i FROM t",
        ],
    ),
    sql_lint.divisions_of_integers: (
        [
            "SELECT a / b AS d FROM t",
            "SELECT CAST(a AS DOUBLE) / b AS d FROM t",
            "SELECT a / CAST(b AS DOUBLE) AS d FROM t",
            "SELECT x / 2 AS d FROM t",
            "SELECT SUM(a) / CAST(COUNT(*) AS DOUBLE) AS d FROM t",
        ],
        [
            "SELECT CAST(a AS DOUBLE) / CAST(b AS DOUBLE) AS d FROM t",
            "SELECT x / NULLIF(y, CAST(0 AS DOUBLE)) AS d FROM t",
        ],
    ),
    sql_lint.divisions_by_constants: (
        [
            "SELECT x / CAST(3 AS DOUBLE) AS d FROM t",
            "SELECT x / NULLIF(CAST(10 AS DOUBLE), CAST(0 AS DOUBLE)) AS d FROM t",
            "SELECT FLOOR(x / CAST(10 AS DOUBLE)) AS d FROM t",
            "SELECT x / CAST(5e-2 AS DOUBLE) AS d FROM t",
            "SELECT x / CAST(:window AS DOUBLE) AS d FROM t",
            "SELECT x / CAST(10 AS DOUBLE) + CAST(5e-1 AS DOUBLE) AS d FROM t",
        ],
        [
            "SELECT x / y AS d FROM t",
            "SELECT x / CAST(4 AS DOUBLE) AS d FROM t",
            "SELECT x / CAST(-25e-2 AS DOUBLE) AS d FROM t",
            "SELECT FLOOR((CAST(a AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(10 AS DOUBLE)) AS d FROM t",
            "SELECT FLOOR(x / CAST(:weight AS DOUBLE) + CAST(5e-1 AS DOUBLE)) AS d FROM t",
        ],
    ),
    sql_lint.whole_divisions: (
        ["SELECT a // b AS d FROM t"],
        ["SELECT a % b AS d FROM t"],
    ),
    sql_lint.decimals: (
        [
            "SELECT a FROM t WHERE x > 0.5",
            "SELECT x + 1e-1 AS d FROM t",
            "SELECT CAST(0.5 AS DECIMAL(3, 1)) AS d FROM t",
            "SELECT CAST(x + 0.5 AS DOUBLE) AS d FROM t",
        ],
        ["SELECT x + CAST(-5e-1 AS DOUBLE) AS d FROM t", "SELECT a + 5 AS d, '0.5' AS word FROM t"],
    ),
    sql_lint.narrow_products: (
        [
            "SELECT small * 10609 AS p FROM t",
            "SELECT CAST(a AS INTEGER) * b AS p FROM t",
            "SELECT q.l * 7 AS p FROM (SELECT LAG(small, 1) OVER (ORDER BY a) AS l FROM t) AS q",
        ],
        [
            "SELECT CAST(small AS BIGINT) * CAST(10609 AS BIGINT) AS p FROM t",
            "SELECT small + 7 AS p FROM t",
        ],
    ),
    sql_lint.doubles_as_text: (
        ["SELECT CAST(x AS VARCHAR) AS w FROM t", "SELECT CAST(x / y AS TEXT) AS w FROM t"],
        ["SELECT CAST(a AS VARCHAR) AS w FROM t"],
    ),
    sql_lint.rough_decisions: (
        [
            "SELECT a FROM t WHERE LN(x) > y",
            "SELECT FLOOR(EXP(x) * y) AS f FROM t",
            "SELECT CASE WHEN y BETWEEN x AND LN(x) / y THEN 1 ELSE 0 END AS c FROM t",
            "SELECT q.l FROM (SELECT a, LN(x) AS l FROM t) AS q GROUP BY q.l",
        ],
        ["SELECT CASE WHEN x > y THEN LN(x) END AS l FROM t", "SELECT a FROM t WHERE SQRT(x) > y"],
    ),
    sql_lint.uncast_counts: (
        [
            "SELECT COUNT(*) AS n FROM t",
            "SELECT COUNT(a) OVER (PARTITION BY b) AS n FROM t",
            "SELECT ROW_NUMBER() OVER (ORDER BY a) AS n FROM t",
            "SELECT RANK() OVER (ORDER BY a) - 1 AS n FROM t",
            "SELECT CASE WHEN COUNT(*) = 1 THEN 1 ELSE 0 END AS n FROM t",
        ],
        [
            "SELECT CAST(COUNT(*) AS BIGINT) AS n FROM t",
            "SELECT CAST(ROW_NUMBER() OVER (ORDER BY a) AS BIGINT) - 1 AS n FROM t",
            "SELECT b FROM t GROUP BY b HAVING COUNT(*) = 5",
        ],
    ),
    sql_lint.implicit_frames: (
        [
            "SELECT SUM(a) OVER (PARTITION BY b ORDER BY a) AS s FROM t",
            "SELECT MAX(a) OVER (ORDER BY b) AS s FROM t",
            "SELECT SUM(a) OVER (ORDER BY b RANGE UNBOUNDED PRECEDING) AS s FROM t",
            "SELECT SUM(a) OVER (ORDER BY b GROUPS UNBOUNDED PRECEDING) AS s FROM t",
        ],
        [
            f"SELECT SUM(a) OVER (ORDER BY b {RUNNING}) AS s FROM t",
            "SELECT SUM(a) OVER (PARTITION BY b) AS s FROM t",
            "SELECT LAG(a, 1) OVER (ORDER BY b) AS s FROM t",
        ],
    ),
    sql_lint.moving_frames: (
        [
            "SELECT SUM(a) OVER (ORDER BY b ROWS BETWEEN 4 PRECEDING AND CURRENT ROW) AS s FROM t",
            "SELECT SUM(a) OVER (ORDER BY b ROWS BETWEEN 1 PRECEDING AND 1 FOLLOWING) AS s FROM t",
        ],
        [f"SELECT MIN(a) OVER (ORDER BY b {RUNNING}) AS s FROM t"],
    ),
    sql_lint.odd_lags: (
        [
            "SELECT LAG(a) OVER (ORDER BY b) AS l FROM t",
            "SELECT LAG(a, 1, 0) OVER (ORDER BY b) AS l FROM t",
            "SELECT LAG(a, 1 IGNORE NULLS) OVER (ORDER BY b) AS l FROM t",
            "SELECT LEAD(a, 1) OVER (ORDER BY b) AS l FROM t",
        ],
        ["SELECT LAG(a, 1) OVER (ORDER BY b) AS l FROM t"],
    ),
    sql_lint.lagged_nulls: (
        [
            "SELECT l FROM (SELECT LAG(a, 1) OVER (ORDER BY b) AS l FROM t) AS q WHERE q.l IS NULL",
            "SELECT l FROM (SELECT LAG(a, 1) OVER (ORDER BY b) AS l FROM t) AS q WHERE NOT l IS NULL",
            "SELECT COALESCE(l, 0) AS m FROM (SELECT LAG(a, 1) OVER (ORDER BY b) AS l FROM t) AS q",
            "SELECT COALESCE(LAG(a, 1) OVER (ORDER BY b), 0) AS m FROM t",
        ],
        [
            "SELECT l FROM (SELECT LAG(a, 1) OVER (ORDER BY b) AS l, "
            "CAST(ROW_NUMBER() OVER (ORDER BY b) AS BIGINT) AS n FROM t) AS q WHERE n > 1",
            "SELECT a FROM t WHERE b IS NOT NULL",
        ],
    ),
    sql_lint.named_windows: (
        ["SELECT SUM(a) OVER w AS s FROM t WINDOW w AS (PARTITION BY b)"],
        ["SELECT SUM(a) OVER (PARTITION BY b) AS s FROM t"],
    ),
    sql_lint.anti_joins: (
        [
            "SELECT a FROM t WHERE EXISTS (SELECT 1 AS one FROM u WHERE u.a = t.a)",
            "SELECT a FROM t WHERE NOT EXISTS (SELECT 1 AS one FROM u WHERE u.a = t.a)",
            "SELECT a FROM t WHERE a NOT IN (SELECT a FROM u)",
            "SELECT a FROM t WHERE NOT (a IN (1, 2))",
            "SELECT t.a AS a FROM t ANTI JOIN u ON u.a = t.a",
            "SELECT t.a AS a FROM t SEMI JOIN u ON u.a = t.a",
        ],
        [
            f"SELECT t.a AS a FROM t {FOUND} WHERE CASE WHEN s.hit = 1 THEN 0 ELSE 1 END = 1",
            "SELECT a FROM t WHERE a IN (1, 2)",
        ],
    ),
    sql_lint.missing_matches: (
        [
            f"SELECT t.a AS a FROM t {FOUND} WHERE s.a IS NULL",
            "SELECT t.a AS a FROM t LEFT JOIN u ON u.a = t.a",
            f"SELECT s.b AS b FROM t {FOUND}",
            f"SELECT COALESCE(s.b, 0) AS b FROM t {FOUND}",
            f"SELECT CASE WHEN s.hit IS NULL THEN 1 ELSE 0 END AS n FROM t {FOUND}",
            f"SELECT CASE WHEN s.hit = 1 THEN 0 ELSE s.b END AS n FROM t {FOUND}",
            f"SELECT CASE WHEN s.hit = 1 OR s.b = 2 THEN 0 ELSE 1 END AS n FROM t {FOUND}",
            "SELECT t.a AS a FROM t RIGHT JOIN u ON u.a = t.a",
            "SELECT t.a AS a FROM t FULL JOIN u ON u.a = t.a",
        ],
        [
            f"SELECT CASE WHEN s.hit = 1 THEN s.b ELSE 0 END AS b FROM t {FOUND}",
            "SELECT MAX(CASE WHEN s.hit = 1 AND s.b > 2 THEN t.a END) AS b FROM t "
            f"{FOUND} AND s.b > t.b",
            "SELECT s.b AS b FROM t JOIN u AS s ON s.a = t.a WHERE s.b IS NULL",
        ],
    ),
    sql_lint.loose_joins: (
        [
            "SELECT t.a AS a FROM t JOIN u ON u.a > t.a",
            "SELECT t.a AS a FROM t JOIN u ON u.a = t.a + 1",
            "SELECT t.a AS a FROM t JOIN u ON u.a = t.a AND u.b = t.b + 1",
            "SELECT t.a AS a FROM t JOIN u ON u.a = 1",
            "SELECT t.a AS a FROM t JOIN u ON u.a = t.a OR u.b = t.b",
            "SELECT t.a AS a FROM t, u",
            "SELECT t.a AS a FROM t CROSS JOIN u AS v JOIN u ON u.a = t.a + v.b",
        ],
        [
            "SELECT t.a AS a FROM t JOIN u ON u.a = t.a AND u.b BETWEEN t.a AND t.b",
            "SELECT t.a AS a FROM t CROSS JOIN u",
            "SELECT q.a AS a FROM (SELECT a, a + 1 AS c FROM t) AS q JOIN u ON u.a = q.c",
        ],
    ),
    sql_lint.joins_by_using: (
        ["SELECT t.b AS b FROM t JOIN u USING (a)", "SELECT t.b AS b FROM t NATURAL JOIN u"],
        ["SELECT t.b AS b FROM t JOIN u ON u.a = t.a"],
    ),
    sql_lint.unnamed_columns: (
        [
            "SELECT t.a FROM t JOIN u ON u.a = t.a",
            "SELECT t.a FROM t",
            "SELECT a + b FROM t",
            "SELECT q.a AS a FROM (SELECT t.a FROM t JOIN u ON u.a = t.a) AS q",
        ],
        ["SELECT t.a AS a, b FROM t", "SELECT a, :list FROM t"],
    ),
    sql_lint.shadowed_columns: (
        [
            "SELECT MIN(a) AS a FROM t",
            "SELECT MIN(a) AS a, MAX(a) AS b FROM t",
            "SELECT a * 10 AS a, a + 1 AS c FROM t",
            "SELECT t.b AS a FROM t WHERE a > 1",
            "SELECT b, CAST(COUNT(*) AS BIGINT) AS a FROM t WHERE a = 1 GROUP BY b",
        ],
        [
            "SELECT MIN(a) AS least_a FROM t",
            "SELECT MIN(t.a) AS a, MAX(t.a) AS most FROM t",
            "SELECT t.a AS a, a + 1 AS c FROM t",
            "SELECT MIN(q.b) AS a FROM (SELECT a, b FROM t) AS q",
        ],
    ),
    sql_lint.reserved_names: (
        [
            "SELECT a AS corr FROM t",
            "SELECT a AS hash FROM t",
            "SELECT a AS percent FROM t",
            'SELECT a AS "at" FROM t',
            'SELECT "order".a AS a FROM t AS "order"',
        ],
        ["SELECT a AS correlated FROM t"],
    ),
    sql_lint.stars: (
        ["SELECT * FROM t", "SELECT t.* FROM t", "SELECT a FROM (SELECT * FROM t) AS q"],
        ["SELECT CAST(COUNT(*) AS BIGINT) AS n FROM t"],
    ),
    sql_lint.filters: (
        ["SELECT SUM(a) FILTER (WHERE b = 1) AS s FROM t"],
        ["SELECT SUM(CASE WHEN b = 1 THEN a ELSE 0 END) AS s FROM t"],
    ),
    sql_lint.value_lists: (
        ["SELECT v.a AS a FROM (VALUES (1), (2)) AS v(a)"],
        ["SELECT 1 AS a UNION ALL SELECT 2 AS a"],
    ),
    sql_lint.generators: (
        [
            "SELECT g.i AS i FROM generate_series(1, 3) AS g(i)",
            "SELECT g.i AS i FROM range(3) AS g(i)",
            "SELECT UNNEST([1, 2]) AS i",
            "SELECT q.b AS b FROM t, LATERAL (SELECT t.a AS b) AS q",
        ],
        ["SELECT a FROM t"],
    ),
    sql_lint.recursions: (
        ["WITH RECURSIVE r AS (SELECT 1 AS i UNION ALL SELECT i + 1 AS i FROM r) SELECT i FROM r"],
        ["WITH r AS (SELECT 1 AS i) SELECT i FROM r"],
    ),
    sql_lint.qualifies: (
        ["SELECT a FROM t QUALIFY CAST(ROW_NUMBER() OVER (ORDER BY a) AS BIGINT) = 1"],
        [
            "SELECT a FROM (SELECT a, CAST(ROW_NUMBER() OVER (ORDER BY a) AS BIGINT) AS n FROM t) AS q "
            "WHERE n = 1"
        ],
    ),
    sql_lint.groups_by_all: (
        [
            "SELECT b, CAST(SUM(a) AS BIGINT) AS s FROM t GROUP BY ALL",
            "SELECT a FROM t ORDER BY ALL",
        ],
        ["SELECT b, CAST(SUM(a) AS BIGINT) AS s FROM t GROUP BY b ORDER BY b"],
    ),
    sql_lint.inner_orders: (
        ["SELECT a FROM (SELECT a FROM t ORDER BY a) AS q"],
        ["SELECT a FROM t ORDER BY a", "SELECT LAG(a, 1) OVER (ORDER BY b) AS l FROM t"],
    ),
    sql_lint.wide_results: (
        ["SELECT b, SUM(a) AS s FROM t GROUP BY b ORDER BY b"],
        [
            "SELECT b, CAST(SUM(a) AS BIGINT) AS s FROM t GROUP BY b ORDER BY b",
            "SELECT b, SUM(a) AS s FROM t GROUP BY b",  # a step, not a result
        ],
    ),
}
FORMS = [
    (rule.__name__, number, sql)
    for rule, forms in EXAMPLES.items()
    for number in (0, 1)
    for sql in forms[number]
]


def parsed(sql: str) -> exp.Expr:
    return sqlglot.parse_one(sql, dialect="duckdb")


@pytest.mark.parametrize(("rule", "sql"), [(rule, sql) for rule, safe, sql in FORMS if not safe])
def test_an_unsafe_form_is_caught(rule: str, sql: str) -> None:
    assert rule in {finding.rule for finding in sql_lint.lint(parsed(sql), KNOWN)}


@pytest.mark.parametrize(("rule", "sql"), [(rule, sql) for rule, safe, sql in FORMS if safe])
def test_the_safe_form_passes_every_rule(rule: str, sql: str) -> None:
    assert sql_lint.lint(parsed(sql), KNOWN) == []


def test_every_rule_has_examples_and_says_why() -> None:
    assert set(EXAMPLES) == set(sql_lint.RULES)
    for rule in (*sql_lint.RULES, sql_lint.untyped):
        assert rule.__doc__ is not None
        assert rule is sql_lint.untyped or {"Cause:", "Symptom:"} <= set(rule.__doc__.split()), rule
    assert all(unsafe and safe for unsafe, safe in EXAMPLES.values())


def test_kinds_follow_columns_through_subqueries_and_unions() -> None:
    found = sql_lint.kinds(
        parsed(
            "SELECT q.i AS i, q.d AS d, q.n AS n, SUM(q.i) AS s, MIN(q.d) AS m, LN(q.d) AS l, "
            "CASE WHEN q.i = 1 THEN NULL ELSE FLOOR(q.d) END AS w, unheard.of AS o FROM ("
            "SELECT a AS i, x AS d, small AS n FROM t UNION ALL SELECT 1 AS i, y AS d, small AS n FROM t"
            ") AS q GROUP BY q.i, q.d, q.n"
        ),
        KNOWN,
    )
    assert found.columns == {
        "i": Kind.INTEGER,
        "d": Kind.DOUBLE,
        "n": Kind.NARROW,
        "s": Kind.WIDE,
        "m": Kind.DOUBLE,
        "l": Kind.ROUGH,
        "w": Kind.WHOLE,
        "o": Kind.UNKNOWN,
    }


def test_what_cannot_be_known_is_named_in_a_filled_query() -> None:
    sql = parsed("SELECT SUM(strange) AS s FROM elsewhere")
    assert not sql_lint.lint(sql)
    assert {finding.rule for finding in sql_lint.lint(sql, filled=True)} == {"untyped"}


# The package's own SQL

FOLDER = template.sql_folder()
#: Those of the laboratory are looked at by its own tests.
LAB = "lab"
FILES = sorted(path for path in FOLDER.rglob("*.sql") if path.relative_to(FOLDER).parts[0] != LAB)
NAMES = [str(path.relative_to(FOLDER).with_suffix("").as_posix()) for path in FILES]

#: A forecast is rough by nature: how many vectors are still needed is carried on by a power law. It is
#: rounded with room for the last bits, and nothing but this figure follows from it.
EXEMPT = {
    ("outlook", "rough_decisions"),
    ("verdicts", "rough_decisions"),
}

#: A script's engines take frames of so many rows lightly, and its quotients need no last bit.
EXEMPT_IN_SCRIPTS = {
    ("all_healthy", "moving_frames"),
    ("framed_counts", "moving_frames"),
    ("floors", "divisions_of_integers"),
    ("floors", "uncast_counts"),
    ("needed", "divisions_by_constants"),
}

#: The minimum of evidence is over 50 judgements by definition.
EXEMPT_IN_ALARMS = {
    ("evidence", "moving_frames"),
    ("evidence_replay", "moving_frames"),
}

#: A selection rounds terms of mutual information, which are rough, to units of 2^-24 so that they can be
#: summed as integers; and it prints the same forecast.
EXEMPT_IN_SELECTION = {
    ("information", "rough_decisions"),
    ("outlook", "rough_decisions"),
    ("verdicts", "rough_decisions"),
}

PARAMETERS = [
    gam_db.Parameters(),
    gam_db.Parameters(m=1, bins=2**31, window=7, max_gap=3),
    gam_db.Parameters(tau=2, still_after=25),
    gam_db.Parameters(
        m=4,
        tau=5,
        bins=50_000,
        max_gap=2,
        overrides=[
            gam_db.Override(asset="a*", m=2),
            gam_db.Override(channel="?", max_gap=None, bins=3, window=300),
        ],
    ),
    gam_db.Parameters(tau=2, still_after=25),
]
CALIBRATIONS = [
    gam_db.Calibration(),
    gam_db.Calibration(duration=9, exclude=[(3, 4)], score_from=5, pool="channel"),
    gam_db.Calibration(
        intervals=[(1, 5), (9, 12)],
        overrides={"b": None, "c?": gam_db.Calibration(intervals=[])},
        pool=[["a*"], ["b"]],
    ),
    gam_db.Calibration(intervals=[]),
]
TELEMETRY = {
    "telemetry": {
        "asset": Kind.OTHER,
        "channel": Kind.OTHER,
        "time": Kind.INTEGER,
        "value": Kind.DOUBLE,
        "torque": Kind.NARROW,
        "recipe": Kind.OTHER,
        "product": Kind.OTHER,
    }
}


def filled_steps(made: Pipeline) -> list[tuple[str, exp.Query]]:
    """Return the steps of a pipeline, which are filled when they are asked for."""
    return [(step.name, step.query) for step in made.steps.values()]


def steps(
    parameters: gam_db.Parameters, calibration: gam_db.Calibration, source: Source | WideSource
) -> list[tuple[str, exp.Query]]:
    """The filled steps of the method, in order, over a source that counts time."""
    programs = None if source.program is None else Programs(source.program, is_whole=True)
    method = Method(parameters, calibration, TimeKind.COUNTER, programs=programs)
    rows = readings(source, exp.to_table("telemetry"), lambda node: node)
    made = pipeline(method, rows, lambda node: node)
    add_look(made, method, lambda node: node)
    return filled_steps(made)


SOURCES: list[Source | WideSource] = [
    Source("telemetry"),
    WideSource("telemetry", channels=["value", "torque"], asset=None),
    Source("telemetry", program="recipe"),
]
PIPELINES: list[tuple[gam_db.Parameters, gam_db.Calibration, Source | WideSource]] = [
    (PARAMETERS[0], CALIBRATIONS[0], SOURCES[0]),
    (PARAMETERS[0], CALIBRATIONS[1], SOURCES[1]),
    (PARAMETERS[1], CALIBRATIONS[2], SOURCES[0]),
    (PARAMETERS[1], CALIBRATIONS[3], SOURCES[0]),
    (PARAMETERS[2], CALIBRATIONS[2], SOURCES[0]),
    (PARAMETERS[3], CALIBRATIONS[1], SOURCES[0]),
    (PARAMETERS[3], CALIBRATIONS[2], SOURCES[2]),
]


def trusting_steps(source: Source | WideSource, is_cut: bool = False) -> list[tuple[str, exp.Query]]:
    """The same of the census, which expects each instant once."""
    return trusting_in(Ways(targets=frozenset(["bucket_health"]), is_cut=is_cut), source)


def trusting_in(
    ways: Ways, source: Source | WideSource = SOURCES[0], parameters: gam_db.Parameters = PARAMETERS[0]
) -> list[tuple[str, exp.Query]]:
    """Likewise, with what engines do in ways of their own."""
    method = Method(parameters, CALIBRATIONS[0], TimeKind.COUNTER)
    rows = readings(source, exp.to_table("telemetry"), lambda node: node)
    return filled_steps(
        trusting_pipeline(method, rows, lambda node: node, Slicing.of(-7, 900), ways=ways)
    )


def look_steps(source: Source | WideSource) -> list[tuple[str, exp.Query]]:
    """The filled steps of the method and of a look on top."""
    method = Method(PARAMETERS[0], CALIBRATIONS[0], TimeKind.COUNTER)
    rows = readings(source, exp.to_table("telemetry"), lambda node: node)
    made = pipeline(method, rows, lambda node: node)
    add_look(made, method, lambda node: node)
    return filled_steps(made)


def test_there_are_files() -> None:
    assert len(FILES) > 40


@pytest.mark.parametrize("name", [name for name in NAMES if template.load(name).dialect is None])
def test_a_file_breaks_no_rule(name: str) -> None:
    findings = sql_lint.lint(template.load(name).tree)
    step = name.rpartition("/")[2]
    exempt = EXEMPT | EXEMPT_IN_SELECTION | EXEMPT_IN_ALARMS | EXEMPT_IN_SCRIPTS
    assert [str(found) for found in findings if (step, found.rule) not in exempt] == []


def program_steps(source: Source | WideSource) -> list[tuple[str, exp.Query]]:
    """The filled steps of a look at a source that names programs, and at a column that may do so."""
    method = Method(PARAMETERS[0], CALIBRATIONS[0], TimeKind.COUNTER, programs=Programs("product"))
    rows = readings(replace(source, program="product"), exp.to_table("telemetry"), lambda node: node)
    made = pipeline(method, rows, lambda node: node)
    add_programs(made)
    told = Pipeline()
    told.add("readings", rows)
    add_usual_run(told)
    return [*filled_steps(made), *filled_steps(told)]


def selection_steps() -> list[tuple[str, exp.Query]]:
    """The filled steps of the method and of a selection on top, with every round of its searches."""
    method = Method(PARAMETERS[0], CALIBRATIONS[0], TimeKind.COUNTER)
    rows = readings(SOURCES[0], exp.to_table("telemetry"), lambda node: node)
    made = pipeline(method, rows, lambda node: node)
    search = Search(m_max=4, theiler=3)
    add_samples(made, search, 9)
    add_delays(made, search, samples=1300)
    add_embedding(made, search, bins=100)
    add_dimensions(made, search, usable=5000, waiting=lambda _: (4, 3))
    add_budget(made, method, search)
    add_results(made, method)
    return filled_steps(made)


def alarm_steps(number: int) -> list[tuple[str, exp.Query]]:
    """The filled steps of the method and of alarms on top, over literal rows of members and limits."""
    parameters, calibration, source = PIPELINES[number]
    method = Method(parameters, calibration, TimeKind.COUNTER)
    rows = readings(source, exp.to_table("telemetry"), lambda node: node)
    made = pipeline(method, rows, lambda node: node)
    add_learnt_limits(made, method, ["x", "y*"])
    for name, columns in (
        ("members", ("channel_id", "family_no", "g")),
        ("heights", ("quarters",)),
        ("frozen_limits", ("channel_id", "blocks", "reference", "height", "cap")),
    ):
        one = exp.cast(exp.Literal.number(1), "BIGINT")
        made.add(name, exp.select(*(exp.alias_(one.copy(), column) for column in columns)))
    add_replay(made)
    add_judgements(made, method, lambda node: node)
    add_backtested(made, [(0, 5), (7, 9)])
    words = (
        exp.alias_(exp.cast(template.text("x"), "VARCHAR"), column)
        for column in ("asset", "channel", "reason")
    )
    made.add("limit_reasons", exp.select(*words))
    add(made, "judgement/raised")
    add_judged(made, "raised")
    add_standing(made)
    add(made, "judgement/machines", name="ranked_machines", tables={"signals": "standing"})
    return filled_steps(made)


def found_in(made: list[tuple[str, exp.Query]]) -> set[tuple[str, str, str]]:
    """What breaks a rule in the filled steps of a pipeline: the step, the rule, the place."""
    known: dict[str, sql_lint.Columns] = dict(TELEMETRY)
    found = set()
    for name, query in made:
        checked = sql_lint.kinds(query, known)
        known[name] = checked.columns
        for finding in sql_lint.findings(checked, filled=True):
            found.add((re.sub(r"_\d+$", "", name), finding.rule, finding.sql))
    return found


@pytest.mark.parametrize("number", range(len(PIPELINES)))
def test_filled_queries_break_no_rule(number: int) -> None:
    """As the files, with slots filled and every kind known: what Python puts in is checked, too."""
    found = found_in(steps(*PIPELINES[number]))
    for is_cut in (False, True):
        found |= found_in(trusting_steps(PIPELINES[number][2], is_cut))
    found |= found_in(look_steps(PIPELINES[number][2]))
    found |= found_in(program_steps(PIPELINES[number][2]))
    assert {place for place in found if place[:2] not in EXEMPT} == set()
    assert {place[:2] for place in found} == EXEMPT, "an exemption that nothing needs any more goes"


@pytest.mark.parametrize("number", [0, 4, 5])
def test_filled_queries_of_alarms_break_no_rule(number: int) -> None:
    """With one set of parameters and with several."""
    found = found_in(alarm_steps(number))
    exempt = EXEMPT | EXEMPT_IN_ALARMS
    assert {place for place in found if place[:2] not in exempt} == set()


def watch_once() -> None:
    """Take every path of the stored form once, over a few rows."""
    rows: list[Row] = [("a", "x", time, float(time % 3)) for time in range(40)]
    with DuckSession() as session:
        for gap in (None, 5):
            parameters = gam_db.Parameters(m=2, window=4, max_gap=gap)
            source = gam_db.Source(arrow(rows))
            monitor = Monitor(session, source, parameters, name=f"gap {gap}")
            monitor.migrate()
            monitor.calibrate()
            monitor.score()
            monitor.lookback = 5
            monitor.score()
            assert monitor.health().num_rows > 0
            assert monitor.check_state().num_rows == 0
            assert monitor.status()["scored"].to_pylist() == [32]
            assert machines(monitor.state, monitor.name, monitor.status())["channels"].to_pylist() == [1]
            with tempfile.TemporaryDirectory() as folder:
                monitor.report(Path(folder) / "page.html")
            monitor.prune()
        withdraw(monitor.state, 0)
        template.load("stored/scoring/rivals")  # where there are no transactions
        running = arrow([(*row, "ab"[row[2] // 2 % 2]) for row in rows])
        named = gam_db.Source(running, program="program")
        parameters = gam_db.Parameters(m=2, bins=2, window=4, target_floor=0.6)
        monitor = Monitor(session, named, parameters, name="programs")
        monitor.calibrate()
        monitor.score()
        monitor.lookback = 5
        monitor.score()
        assert monitor.check_state().num_rows == 0
        with tempfile.TemporaryDirectory() as folder:
            monitor.report(Path(folder) / "page.html")


def alarm_once() -> None:
    """Take every path of the stored form of alarms once: a fault that begins, and ends."""
    values = [float(time % 2) for time in range(32)] + [9.0] * 12 + [0.0] * 24
    rows: list[Row] = [("a", "x", time, value) for time, value in enumerate(values)]
    parameters = gam_db.Parameters(m=1, bins=2, window=4, stride=2)
    calibration = gam_db.Calibration(intervals=[(0, 31)])
    with DuckSession() as session:
        asked = parameters, calibration, gam_db.Alarms("1 per 1000 judgements")
        monitor = Monitor(session, gam_db.Source(arrow(rows)), *asked)
        monitor.migrate()
        monitor.calibrate()
        for until in (43, None):
            monitor.score(until=until)
        (episode,) = alarms.alarms(monitor.state, "default").to_pylist()
        row = {**episode, "episode_id": 1}
        assert len(alarms.judgements(monitor.state, row)) == 5
        assert len(alarms.bands(monitor.state, "default", row)) == 1
        assert len(alarms.cells(monitor.state, "default", row)) == 1
        counted = figures(monitor.state.rows, "default")
        assert [row["reread_novel"] for row in counted.values()] == [4]
        assert monitor.label("false_alarm", 1) == [1]
        assert alarms.events(monitor.state, "default").num_rows == 3
        assert monitor.limits()["reason"].to_pylist() == ["unrepresentative"]


def test_filled_queries_of_a_selection_break_no_rule() -> None:
    found = found_in(selection_steps())
    exempt = EXEMPT | EXEMPT_IN_SELECTION
    assert {place for place in found if place[:2] not in exempt} == set()
    assert {place[:2] for place in found} == exempt, "an exemption that nothing needs any more goes"


def test_filled_queries_of_a_choice_break_no_rule() -> None:
    columns = {
        "taught_samples": ("channel_id", "code", "piece", "place", "samples"),
        "learners": (
            *("channel_id", "unit_id", "learner_id", "support_id", "delay_no", "window_length"),
            *("is_cut", "thinning"),
        ),
    }
    doubles = {"taught_samples": ("value",), "learners": ("calibrated_lo", "calibrated_hi")}
    given = []
    for name, counts in columns.items():
        kinds = [(one, "BIGINT") for one in counts] + [(one, "DOUBLE") for one in doubles[name]]
        told = exp.select(*(exp.cast(exp.null(), kind).as_(one) for one, kind in kinds))
        given.append((name, told))
    setting = gam_db.Parameters(bins=128)
    made = scoring(setting, RUNGS, DELAYS, 1)
    assert found_in([*given, *filled_steps(made)]) == set()


#: What reads the state only; each may read those before it.
OF_STATE = (
    *("status_rows", "course", "pruned_versions", "bucket_ages", "horizons"),
    *("staying_buckets", "staying_novel", "staying_judgements"),
    *("expired_runs", "expired_versions", "expired_supports"),
    *("expired_unplaced", "new_horizons", "expired_horizons", "last_proofs", "state_sizes"),
    *("validity", "machine_rows"),
)


def test_views_and_queries_of_the_state_break_no_rule() -> None:
    """With the kinds that the migrations give to the columns; an instant counts as the integer it is."""
    known: dict[str, sql_lint.Columns] = {}
    queries: list[tuple[str, exp.Expr]] = []
    for name, definition in definitions().items():
        made = definition.create
        if made.kind == "VIEW":
            queries.append((f"stored_{name}", made.expression.copy()))
        else:
            known[f"stored_{name}"] = {
                column.name: sql_lint.CASTS[column.kind.this] for column in made.this.expressions
            }
    for name in OF_STATE:
        (file,) = (FOLDER / "stored").rglob(f"{name}.sql")
        path = file.relative_to(FOLDER).with_suffix("").as_posix()
        slots: dict[str, template.Slot] = dict.fromkeys(template.load(path).slots, 5)
        if "monitor" in slots:
            slots["monitor"] = template.text("default")
        queries.append((name, template.fill(path, slots)))
    for _, query in queries:
        for instant in list(query.find_all(exp.UnixToTime)):
            instant.replace(instant.this)
        for clock in list(query.find_all(exp.CurrentTimestamp)):
            assert clock.parent is not None
            clock.parent.replace(exp.Literal.number(0))
    for _ in range(2):  # a view that was made anew may read one that came later
        found = []
        for name, query in queries:
            checked = sql_lint.kinds(query, known)
            known[name] = checked.columns
            found += [f"{name}: {finding}" for finding in sql_lint.findings(checked, filled=True)]
    assert found == []


@contextlib.contextmanager
def loading() -> Iterator[set[str]]:
    """Give the names of the files of ``sql/`` that are loaded inside, as if nothing was made before."""
    loaded: set[str] = set()
    load = template.load

    def recording(name: str) -> template.Template:
        loaded.add(name)
        return load(name)

    for name, module in list(sys.modules.items()):
        for made in vars(module).values() if name.startswith("gam_db") else ():
            if hasattr(made, "cache_clear"):
                made.cache_clear()
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(template, "load", recording)
        yield loaded


#: What may be all that is asked for.
HEALTH = ("bucket_health",)


def choose_once() -> None:
    """Let calibration choose, of a channel in segments."""
    table = pa.table({"time": range(900), "value": [float(i % 7) for i in range(900)]})
    with DuckSession() as session, session.lent(table) as lent:
        parameters = gam_db.Parameters(tau="auto", bins="auto", window="auto", max_gap=3)
        Study(session, Source(lent.name, None, None), parameters, CALIBRATIONS[0]).forget()


def stream_once() -> None:
    """Read a channel in the order in which it is stored."""
    table = pa.table({"time": range(naming.STREAMED_FROM), "value": [1.5] * naming.STREAMED_FROM})
    with DuckSession() as session, session.lent(table) as lent:
        source = Source(lent.name, None, None)
        told = ((CALIBRATIONS[0], ()), (CALIBRATIONS[0], HEALTH), (gam_db.Calibration(duration=9), ()))
        for calibration, asked in told:
            given = source, gam_db.Parameters(), calibration
            study = Study(session, *given, short_cuts=True, targets=asked)
            study.table("bucket_health")
            study.query("health_indicator")
            assert study.form == "streams"
            study.forget()
        monitor = Monitor(session, source, gam_db.Parameters(), CALIBRATIONS[0])
        monitor.migrate()
        monitor.calibrate()
        monitor.score()
    values = [None, *table["value"].to_pylist()[1:]]
    with DuckSession() as session, session.lent(table.set_column(1, "value", [values])) as lent:
        uneven = gam_db.Parameters(tau=9, max_gap=5, still_after=25)
        study = Study(session, Source(lent.name, None, None), uneven, CALIBRATIONS[0], short_cuts=True)
        study.table("support_summary")
        study.table("bucket_health")
        study.query("stillness")
        assert study.form == "streams"
        study.forget()


def print_once() -> None:
    """Print a run of a monitor whose channels differ, with channels that are parked and without."""
    overrides = gam_db.Override(asset="b", m=1), gam_db.Override(asset="b", window=8, stride=2)
    for override, park, kind in zip(overrides, (None, 5), (pa.int64(), pa.timestamp("us")), strict=True):
        columns = {"asset": [*"ab"] * 20, "value": [0.5, 0.5, 1.5, 1.5] * 10}
        table = pa.table({"time": pa.array(range(40), kind), **columns})
        with DuckSession() as session, session.lent(table) as lent:
            query = exp.select("*").from_(lent)
            session.execute(session.engine.create_table(exp.to_table("telemetry"), query))
            given = gam_db.Parameters(window=4, stride=2, overrides=[override]), CALIBRATIONS[0]
            source = Source("telemetry", channel=None)
            monitor = Monitor(session, source, *given, park_after=park)
            monitor.migrate()
            monitor.calibrate()
            run_of(monitor)


def repeat_once() -> None:
    """Run the steps once more, since an instant occurs twice: of a source and of a monitor."""
    table = pa.table({"time": [1, 2, 2, 1, 2, 3, 4], "asset": [*"aaabbbb"], "value": [2.5] * 7})
    given = gam_db.Parameters(), gam_db.Calibration(fraction=0.5)
    for engine in ("duckdb", "sqlite"):
        session = engines.session(engine)
        with session.lent(table) as lent:
            study = Study(session, Source(lent.name, channel=None), *given, short_cuts=True)
            study.table("bucket_health")
            assert (study.form, study.is_collapsed) == ("census", True)
            study.forget()
    with DuckSession() as session, session.lent(table) as lent:
        monitor = Monitor(session, Source(lent.name, channel=None), *given)
        monitor.migrate()
        monitor.calibrate()
        monitor.score()


def test_every_file_is_used() -> None:
    """A file that no form loads would be checked, shipped and read for nothing."""
    with loading() as loaded:
        for arguments in PIPELINES:
            steps(*arguments)
        for body in (None, *STORED):
            filled_steps(opening_pipeline(exp.select("*"), Slicing.of(0, 9), Ways(body)))
        for body in (None, *SET_STEPS):
            for is_cut in (False, True):
                trusting_in(Ways(body, True, targets=frozenset(["bucket_health"]), is_cut=is_cut))
        trusting_in(Ways(has_room=True), parameters=PARAMETERS[2])
        ENGINE.readings(
            WideSource("telemetry", channels=["value"] * 99), exp.to_table("t"), TimeKind.COUNTER
        )
        selection_steps()
        choose_once()
        alarm_steps(0)
        source = Source("telemetry", time_kind="counter")
        for form, engine in (("exact", "sqlite"), ("view", "duckdb")):
            gam_db.render(form, engine, source, gam_db.Parameters(), CALIBRATIONS[1])
        for without in (["curve"], ["certificate"]):
            gam_db.render("view", "duckdb", source, gam_db.Parameters.paper(), without=without)
        pooled = gam_db.Calibration(fraction=0.5, pool="channel")
        gam_db.render("view", "duckdb", source, gam_db.Parameters(), pooled)
        rendered(ENGINE, StateTables())
        setting = Setting(3, 1, 100, 5000, 100, None, False)
        filled_steps(scoring_steps(setting, TimeKind.COUNTER))
        still = Setting(3, 1, 100, 5000, 100, None, False, 25)
        filled_steps(scoring_steps(still, TimeKind.COUNTER))
        watch_once()
        alarm_once()
        stream_once()
        print_once()
        repeat_once()
        gam_db.check(gam_db.Source(pa.table({"time": [1], "value": [2.5], "more": ["3"]}), None, None))
        gam_db.check(gam_db.Source(pa.table({"time": ["2026-01-01"], "value": [2.5]}), None, None))
        with pytest.raises(gam_db.UserError):
            gam_db.check(gam_db.Source(pa.table({"time": ["noon"], "value": [2.5]}), None, None))
        for times, unit in (([1], "s"), ([1], "ns"), ([1.5], "s"), ([Decimal("1.5")], "s")):
            held = pa.table({"time": times, "value": [True]})
            gam_db.check(gam_db.Source(held, None, None, time_unit=unit))
        autumn = pa.table({"time": [dt.datetime(2025, 10, 26, 2, 30)] * 2, "value": [1.0, 2.0]})
        template.load("census/size")  # ClickHouse alone asks whether a source has room
        gam_db.render("view", "mariadb", gam_db.Source("telemetry", time_kind="timestamp"))
        local = gam_db.Source(autumn, None, None, valid_when="value > 1")
        gam_db.check(replace(local, source_time_zone="Europe/Berlin"))
        ran = autumn.append_column("program", pa.array(["a", "b"]))
        named = gam_db.Source(ran, None, None, program="program", source_time_zone="Europe/Berlin")
        gam_db.support(named, PARAMETERS[0])
        shifts = pa.table(
            {"time": range(400), "value": [1.5] * 400, "recipe": [n // 50 % 2 for n in range(400)]}
        )
        for program in (None, "recipe"):
            gam_db.check(
                gam_db.Source(shifts, None, None, program=program), gam_db.Parameters(window=10)
            )
        for pool in (None, "channel"):
            calibration = gam_db.Calibration(intervals=[(0, 9)], pool=pool)
            for program in (None, "product"):
                Package(replace(source, program=program), gam_db.Parameters(), calibration).files()
        grafana.queries("postgres", StateTables(), "default")
    assert set(NAMES) - loaded == set()
    assert {name for name in loaded if name not in NAMES} == set()


@pytest.mark.parametrize("path", FILES, ids=NAMES)
def test_a_file_says_what_it_is(path: Path) -> None:
    check_head(path)


def check_head(path: Path) -> None:
    """Its opening comment names it, what it reads and each slot, and nothing that is not there."""
    text = path.read_text(encoding="utf-8")
    comment = []
    for line in text.splitlines():
        if not line.startswith("--"):
            break
        comment.append(line.removeprefix("--").strip())
    found = template.load(str(path.relative_to(FOLDER).with_suffix("").as_posix()))
    assert list(sql_lint.form(found)) == []
    title = comment[0].partition(":")[0].lower().replace("-", " ") if comment else ""
    assert set(path.stem.split("_")) <= set(re.findall(r"[a-z]+", title)), "the title"
    said = " ".join(comment)
    tables = {table.name for table in found.tree.find_all(exp.Table)}
    reads = re.search(r"Reads: +([a-z_, ]+)", "\n".join(comment).replace(",\n", ", "))
    named = set(re.findall(r"[a-z_]+", reads[1].split(", the ")[0])) if reads else set()
    assert named == tables, "what it reads"
    slots = set(re.findall(r"(?<!\w):([a-z_]+)", said.partition("Slots:")[2]))
    assert slots == found.slots, "its slots"
    assert "--" not in text.partition("\n" + text.splitlines()[len(comment)])[2], "comments inside"
