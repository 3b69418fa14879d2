"""The steps of the stored form pass the lint once their slots are filled and every kind is known."""

from functools import partial

import pytest
from sqlglot import exp

import sql_lint
from gam_db.clock import TimeKind
from gam_db.composing.pipeline import Pipeline
from gam_db.settings.source import Source, readings
from gam_db.stored.checking.proving import matching_steps
from gam_db.stored.checking.soundness import soundness_steps
from gam_db.stored.planning.reading import cohort_of
from gam_db.stored.planning.setting import Setting
from gam_db.stored.planning.steps import (
    learning_steps,
    plan_steps,
    reading_steps,
    scoring_steps,
    searched_plan_steps,
    whole_plan_steps,
)
from gam_db.stored.schema.migration_files import definitions
from sql_lint import Kind

TYPES = {"BIGINT": Kind.INTEGER, "DOUBLE": Kind.DOUBLE, "VARCHAR": Kind.OTHER, "TEXT": Kind.OTHER}
TEXTS = ("asset", "channel")
SETTINGS = [
    Setting(3, 1, 100, 5000, 100, None, False),
    Setting(1, 2, 2**31, 7, 7, 3, False),
    Setting(4, 5, 50_000, 300, 10, None, True),
    Setting(3, 1, 100, 1, 1, 3, False, by_column=True),
]


def given() -> dict[str, sql_lint.Columns]:
    """The kinds of the state tables, by their migrations, and of what each run puts beside them."""
    known: dict[str, sql_lint.Columns] = {}
    for name, definition in definitions().items():
        made = definition.create
        if isinstance(made.this, exp.Schema):
            known[f"stored_{name}"] = {
                column.name: TYPES[column.args["kind"].sql("duckdb")]
                for column in made.this.expressions
                if isinstance(column, exp.ColumnDef)
            }
        else:
            known[f"stored_{name}"] = sql_lint.kinds(made.expression, known).columns
    cohort = cohort_of([])
    known["cohort"] = {
        field.name: TYPES[{"int64": "BIGINT", "double": "DOUBLE", "string": "VARCHAR"}[str(field.type)]]
        for field in cohort.schema
    }
    buckets = (
        "channel_id version_id bucket_no first_time last_time context_time samples novel out_of_range"
    )
    known["written"] = dict.fromkeys(buckets.split(), Kind.INTEGER)
    known["changed"] = known["cohort"]
    kept = dict.fromkeys(("still", "novel_in_window"), Kind.INTEGER)
    known["former_buckets"] = {**known["written"], **kept}
    cells = "channel_id version_id bucket_no cell_key visits first_time last_time"
    known["former_novel"] = dict.fromkeys(cells.split(), Kind.INTEGER)
    stamp = ("run_id", "started", "committed", "deletes_hidden", "episodes_pending")
    known["stamp"] = dict.fromkeys(stamp, Kind.INTEGER)
    known["limits"] = known["cohort"]
    numbering = ("channel_id", "stored_channel_id", "version_id", "stored_support_id")
    known["numbering"] = dict.fromkeys(numbering, Kind.INTEGER)
    known["oldest_rows"] = dict.fromkeys(("version_id", "oldest_time"), Kind.INTEGER)
    telemetry = {"time": Kind.INTEGER, "value": Kind.DOUBLE}
    known["telemetry"] = telemetry | dict.fromkeys(TEXTS, Kind.OTHER)
    return known


def broken(steps: Pipeline, known: dict[str, sql_lint.Columns]) -> list[str]:
    """What breaks a rule in the steps, in their order."""
    found = []
    for name, step in steps.steps.items():
        checked = sql_lint.kinds(step.query, known)
        known[name] = checked.columns
        found += [f"{name}: {finding}" for finding in sql_lint.findings(checked, filled=True)]
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("setting", SETTINGS)
def test_filled_steps_break_no_rule(setting: Setting) -> None:
    source = Source("telemetry")
    rows = readings(source, exp.to_table("telemetry"), lambda node: node)
    for kind in (TimeKind.COUNTER, TimeKind.TIMESTAMP):
        known = given()
        assert broken(reading_steps(rows), known) == []
        for steps in (scoring_steps, partial(scoring_steps, compared=True)):
            assert broken(steps(setting, kind), dict(known)) == []
        # The last bits of logarithms are allowed for, as in the certificate itself; outlook takes the
        # larger of two figures, so that they decide nothing.
        rough = [
            found.split(":")[:2]
            for found in broken(learning_steps(setting, kind, 0.05, 1, True, True), dict(known))
        ]
        assert rough == [[step, " rough_decisions"] for step in ("outlook", "outlook", "verdicts")]
    assert broken(plan_steps(1, 5), given()) == []
    assert broken(whole_plan_steps(1), given()) == []
    assert broken(soundness_steps(1, True), given()) == []
    wanted = {"wanted": {"version_id": Kind.INTEGER}}
    assert broken(matching_steps(), given() | wanted) == []
    assert broken(searched_plan_steps(1, None, 5), given()) == []


def test_the_check_sees_a_double_that_is_summed() -> None:
    known = given()
    steps = Pipeline()
    query = exp.select(exp.Sum(this=exp.column("lo")).as_("all_lo")).from_("cohort")
    steps.add("wrong", query)
    assert broken(steps, known) != []
