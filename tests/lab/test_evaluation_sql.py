"""The steps of an evaluation pass the lint, and give the same on SQLite."""

import itertools
import sqlite3
from typing import Any

import numpy as np
import pyarrow as pa
import pytest
from sqlglot import exp

import gam_db
import sql_lint
from gam_db.composing.pipeline import Pipeline
from gam_db.engines import engine_named
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.evaluation import sampling
from gam_db.lab.evaluation.members import Member, as_table
from gam_db.lab.evaluation.steps import chance_steps, detection_steps, evaluation_steps
from sql_lint import Kind

#: Rob is an exponential and shares its column with all that is averaged. It is rounded into units far
#: finer than the last figures that are told, and no integer but these units follows from it; the
#: amplitude that is compared holds none. A metric called corr is a text, not a name.
EXEMPT = {
    ("scaled", "rough_decisions"),
    ("part_means", "rough_decisions"),
    ("fleet_metrics", "rough_decisions"),
    ("metric_values", "reserved_names"),
}

COUNTS = dict.fromkeys(("series_id", "steps", "place", "novel_in_window"), Kind.INTEGER)
GIVEN: dict[str, dict[str, Kind]] = {
    "indicator": {
        **dict.fromkeys(("asset", "channel"), Kind.OTHER),
        **dict.fromkeys(("place", "time", "novel_in_window", "vectors_in_window"), Kind.INTEGER),
        **dict.fromkeys(("hi", "hi_limit"), Kind.DOUBLE),
    },
    "members": {
        **dict.fromkeys(("asset", "channel", "outcome"), Kind.OTHER),
        **dict.fromkeys(("series_id", "asset_no", "stratum", "has_outcome"), Kind.INTEGER),
        **dict.fromkeys(("ends_at", "steps", "values_per_window"), Kind.INTEGER),
    },
    "drawings": dict.fromkeys(("drawing", "stratum", "asset_no", "weight"), Kind.INTEGER),
    "life_shares": dict.fromkeys(("point_no", "last_point"), Kind.INTEGER),
    "chance": {
        "series_id": Kind.INTEGER,
        **{f"{name}_chance{of}": Kind.DOUBLE for name in ("mon", "corr", "rob") for of in ("", "_sd")},
        "chance_reason": Kind.OTHER,
    },
}
SURROGATES: dict[str, dict[str, Kind]] = {
    "selected": {**COUNTS, "hi": Kind.DOUBLE},
    "surrogates": dict.fromkeys(("series_id", "stands_for"), Kind.INTEGER),
}
INTERVAL = {
    **dict.fromkeys(("asset", "channel"), Kind.OTHER),
    **dict.fromkeys(("label_no", "starts_at", "ends_at"), Kind.INTEGER),
    **dict.fromkeys(("left_out_from", "left_out_until"), Kind.INTEGER),
}
EVENTS: dict[str, dict[str, Kind]] = {
    "indicator": GIVEN["indicator"],
    "labels": INTERVAL,
    "alarms": INTERVAL,
    "channel_limits": {
        **dict.fromkeys(("asset", "channel"), Kind.OTHER),
        "hi_limit": Kind.DOUBLE,
    },
}

OTHER = gam_db.Conventions(monotonicity="sign", amplitude="ends", ddof=1)


@pytest.mark.parametrize(
    ("steps", "given"),
    [
        (evaluation_steps(gam_db.Conventions(), counts=True, units=2**40, reasons=True), GIVEN),
        (evaluation_steps(OTHER, counts=False, units=2**52, reasons=False), GIVEN),
        (chance_steps(gam_db.Conventions(), units=2**52), SURROGATES),
        (detection_steps(None, by_alarms=False), EVENTS),
        (detection_steps(None, by_alarms=True), EVENTS),
    ],
)
def test_filled_steps_break_no_rule(steps: Pipeline, given: dict[str, dict[str, Kind]]) -> None:
    known: dict[str, sql_lint.Columns] = dict(given)
    found = set()
    for step in steps.steps.values():
        checked = sql_lint.kinds(step.query, known)
        known[step.name] = checked.columns
        for finding in sql_lint.findings(checked, filled=True):
            if (step.name, finding.rule) not in EXEMPT:
                found.add(f"{step.name} {finding}")
    assert not found


def on_duckdb(steps: Pipeline, target: str, given: dict[str, pa.Table]) -> list[tuple[Any, ...]]:
    with DuckSession() as session:
        placed = {
            name: session.keep(name, session_rows(session, table)) for name, table in given.items()
        }
        return [tuple(row.values()) for row in session.fetch(steps.query(target, placed)).to_pylist()]


def session_rows(session: DuckSession, table: pa.Table) -> Any:
    return exp.select(*table.column_names).from_(session.relation(table))


def on_sqlite(steps: Pipeline, target: str, given: dict[str, pa.Table]) -> list[tuple[Any, ...]]:
    connection = sqlite3.connect(":memory:")
    try:
        for name, table in given.items():
            connection.execute(f"CREATE TABLE {name} ({', '.join(table.column_names)})")
            marks = ", ".join("?" * table.num_columns)
            rows = [tuple(row.values()) for row in table.to_pylist()]
            connection.executemany(f"INSERT INTO {name} VALUES ({marks})", rows)
        return connection.execute(engine_named("sqlite").text(steps.query(target))).fetchall()
    finally:
        connection.close()


@pytest.mark.parametrize("counts", [True, False])
@pytest.mark.parametrize("target", ["channel_summary", "fleet_summary"])
def test_sqlite_gives_the_same(target: str, counts: bool) -> None:
    generator = np.random.default_rng(4)
    parts, members = [], []
    for number, k in enumerate((1, 2, 7, 60, 230, 100), 1):
        level = np.cumsum(generator.integers(-1, 3, k))
        names = {"asset": [f"r{number}"] * k, "channel": ["x"] * k}
        clock = {"place": np.arange(k), "time": np.arange(k)}
        unknown = {"vectors_in_window": pa.nulls(k, pa.int64())}
        hi = {"hi": level / 7, "novel_in_window": level}
        parts.append(pa.table(names | clock | hi | unknown))
        fate = ("failed", 0) if number > 3 else ("healthy", 1)
        members.append(Member(number, f"r{number}", "x", number, *fate, 1, 200, 2**20, 3, 70))
    conventions = gam_db.Conventions(samples=50)
    given = {
        "indicator": pa.concat_tables(parts),
        "members": as_table(members),
        "drawings": sampling.drawings(members, conventions),
        "life_shares": pa.table({"point_no": range(101), "last_point": [100] * 101}),
        "chance": pa.table({name: pa.array([], pa.float64()) for name in GIVEN["chance"]}),
    }
    steps = evaluation_steps(conventions, counts, units=2**55, reasons=True)
    expected, found = (run(steps, target, given) for run in (on_duckdb, on_sqlite))
    assert len(expected) == len(found) > 0
    for left, right in zip(itertools.chain(*expected), itertools.chain(*found), strict=True):
        # All sums are of integers; only exponentials may differ in their last bit.
        assert left == (pytest.approx(right, rel=1e-15) if isinstance(right, float) else right)


@pytest.mark.parametrize("by_alarms", [False, True])
def test_sqlite_compares_labels_alike(by_alarms: bool) -> None:
    generator = np.random.default_rng(7)
    times = range(60)
    names = list(itertools.product("ab", "xy", times))
    interval = {
        "label_no": range(4),
        "asset": ["a", "a", "b", "c"],
        "channel": pa.array([None, "x", "y", None], pa.string()),
        "starts_at": [20, 25, -5, 0],
        "ends_at": [30, 40, 3, 9],
        "left_out_from": [15, 20, -10, -5],
        "left_out_until": [32, 42, 5, 11],
    }
    given = {
        "indicator": pa.table(
            {
                **dict(
                    zip(("asset", "channel", "time"), map(list, zip(*names, strict=True)), strict=True)
                ),
                "hi": generator.random(len(names)),
                "hi_limit": pa.nulls(len(names), pa.float64()),
            }
        ),
        "labels": pa.table(interval),
        "alarms": pa.table({**interval, "starts_at": [10, 22, 0, 1], "ends_at": [22, 50, 9, 2]}),
        "channel_limits": pa.table(
            {"asset": ["a", "a", "b"], "channel": ["x", "y", "x"], "hi_limit": [0.5, None, 0.9]}
        ),
    }
    steps = detection_steps(None, by_alarms)
    expected, found = (run(steps, "detection", given) for run in (on_duckdb, on_sqlite))
    assert len(found) == 7
    assert found == expected
