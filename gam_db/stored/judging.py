"""Judging what a run scored: judgements are published with its buckets (alarms, section 4).

This module owns from which judgement on a run judges anew, and by which steps.
"""

from collections.abc import Mapping, Sequence

import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add
from gam_db.method.alarms import add_kept_judgements
from gam_db.pipeline import Pipeline, filled, place
from gam_db.running import Running
from gam_db.stored.planning import Row
from gam_db.stored.reading import near
from gam_db.stored.state import State

#: Judgements before the first new one that its evidence may hang on.
_BEFORE = 50


def judge(state: State, group: Sequence[Row], given: Mapping[str, exp.Table]) -> None:
    """Append the judgements of a run that is not committed yet.

    Args:
        state: the state tables, in a session that can write.
        group: rows of the plan, of one setting.
        given: the tables of *cohort*, *stamp* and *new_buckets* of the run.
    """
    buckets = group[0]["window_length"] // group[0]["stride"]
    placed = {**state.tables.placed(), **given}
    until = _until(state, placed, near(group, buckets))
    rows = until.to_pylist()
    if any(row["first_judgement"] == 0 and row["first_bucket"] >= buckets for row in rows):
        until = _until(state, placed, near([{**row, "first_bucket": 0} for row in group]))
        rows = until.to_pylist()
    if not rows:
        return
    first = min(row["first_judgement"] for row in rows)
    steps = Pipeline(small=frozenset({"judged_buckets", "judged_windows"}))

    def since(judgement: int) -> exp.Expr:
        return near([{**row, "first_bucket": judgement * buckets} for row in rows])

    add(steps, "stored/judged_buckets", {"buckets": buckets, "near": since(first)})
    add(steps, "stored/limit_spans")
    add_kept_judgements(steps, buckets, since(first - _BEFORE))
    add(steps, "stored/judgement_rows")
    running = Running(state.session, steps, placed)
    try:
        running.load("judged_until", until)
        state.append("judgement", running.query("judgement_rows"))
    finally:
        running.forget()


def _until(state: State, placed: Mapping[str, exp.Table], close: exp.Expr) -> pa.Table:
    slots: dict[str, template.Slot] = {"near": close}
    query = filled("stored/judged_until", slots)
    place(query, placed)
    return state.session.fetch(query)
