"""Judging what a run scored: judgements are published with its buckets (alarms, section 4).

This module owns from which judgement on a run judges anew, and by which steps.
"""

from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.columns import counts, table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.plan import Kind, Plan, Statement
from gam_db.method.adding import add
from gam_db.method.alarms import add_stored_judgements
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import near
from gam_db.stored.state import State
from gam_db.study.running import Running

#: Judgements before the first new one that its evidence may hang on.
BEFORE = 50


def judge(state: State, group: Sequence[Row], tables: Mapping[str, exp.Table]) -> dict[int, int]:
    """Append the judgements of a run that is not committed yet.

    Given are its tables *cohort*, *stamp* and *new_buckets*. Returned is the first judgement written
    anew, of each version that has, or had, a limit.
    """
    all_tables, most = {**state.tables.nodes(), **tables}, max(map(buckets_of, group))
    rows = state.rows("stored/alarms/judged_until", {"near": near(group, most)}, tables)
    length = {row["version_id"]: buckets_of(row) for row in group}
    lost = [
        row
        for row in rows
        if row["first_judgement"] == 0 and row["first_bucket"] >= length[row["version_id"]]
    ]
    if lost:  # nothing was judged of late, or ever
        versions = {row["version_id"] for row in lost}
        whole = near([{**row, "first_bucket": 0} for row in lost])
        again = state.rows("stored/alarms/judged_until", {"near": whole}, tables)
        rows = [row for row in rows if row["version_id"] not in versions]
        rows += [row for row in again if row["version_id"] in versions]
    for buckets in sorted({length[row["version_id"]] for row in rows}):
        alike = [row for row in rows if length[row["version_id"]] == buckets]
        first = min(row["first_judgement"] for row in alike)
        since, since_before = (
            near([{**row, "first_bucket": judgement * buckets} for row in alike])
            for judgement in (first, first - BEFORE)
        )
        with Running(state.session, judging_steps(buckets, since, since_before), all_tables) as running:
            running.load("judged_until", table_of(alike, UNTIL))
            appended = Statement("judgement_rows", Kind.APPEND, "judgement")
            plan = Plan.of(running.steps, [appended], running.tables)
            running.execute(plan, target=state.tables.table)
    return {row["version_id"]: row["first_judgement"] for row in rows}


def judging_steps(buckets: int, since: exp.Expr, since_before: exp.Expr) -> Pipeline:
    """Return the steps from *judged_until* and *new_buckets* to *judgement_rows*.

    A window has so many buckets. The conditions on *bucket* hold for what stays: the buckets that are
    judged, and the judgements before them.
    """
    steps = Pipeline(small=frozenset({"judged_buckets", "judged_windows"}))
    add(steps, "stored/alarms/judged_buckets", {"buckets": buckets, "near": since})
    add(steps, "stored/alarms/limit_spans")
    add_stored_judgements(steps, buckets, since_before)
    add(steps, "stored/alarms/judgement_rows")
    return steps


def buckets_of(version: Row) -> int:
    """Return how many buckets a window of a version has."""
    return int(version["window_length"] // version["stride"])


#: Columns of *judged_until*.
UNTIL = counts("channel_id version_id first_bucket first_judgement")
