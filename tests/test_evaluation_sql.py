"""The filled steps of an evaluation pass the lint, with every kind known."""

import pytest

import gam_db
import sql_lint
from gam_db.evaluation.steps import chance_steps, evaluation_steps
from gam_db.pipeline import Pipeline
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
        "hi": Kind.DOUBLE,
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

OTHER = gam_db.Conventions(monotonicity="sign", amplitude="ends", ddof=1)


@pytest.mark.parametrize(
    ("steps", "given"),
    [
        (evaluation_steps(gam_db.Conventions(), counts=True, units=2**40, reasons=True), GIVEN),
        (evaluation_steps(OTHER, counts=False, units=2**52, reasons=False), GIVEN),
        (chance_steps(gam_db.Conventions(), units=2**52), SURROGATES),
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
