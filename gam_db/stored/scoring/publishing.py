"""One writer, enforced: a run counts only if the state that it was planned from is unchanged.

A run remembers the newest finished run of each version when it is planned, and compares in its
publication. Where an engine has transactions that is one, and one writer of a monitor at a time is
inside. Else the run compares before its last row and looks for rivals after it: of two that were planned
from the same run at least one sees the other, and withdraws itself by a second row. The one with the
smaller id waits a moment for the other to do so; then one of them stays. A run that was planned from a
committed one knows it, and is no rival.
"""

import time

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import ConflictError
from gam_db.method.adding import add
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import listed
from gam_db.stored.scoring.lists import CHANGED
from gam_db.stored.state import State
from gam_db.study.running import Running

#: Seconds that the smaller of two runs waits for the other one to withdraw, and between two looks.
_PATIENCE, _PAUSE = 2.0, 0.05


def planned_runs(
    among: exp.Expr | None = None, near: exp.Expr | None = None, rows_differ: exp.Expr | None = None
) -> Pipeline:
    """Return the steps *newest_runs* and *unplanned*.

    Among is a condition on *version*; near is one on *run* that holds for all runs that may matter.
    """
    steps = Pipeline()
    slots: dict[str, template.Slot] = {"among": among or exp.true(), "near": near or exp.true()}
    add(steps, "stored/scoring/newest_runs", slots)
    add(steps, "stored/scoring/unplanned", {"rows_differ": rows_differ or exp.false()})
    return steps


def unplanned(state: State, group: list[Row], planned: list[Row]) -> exp.Query:
    """Return the query of versions of which something else is there than was planned from.

    The rows that were planned from have planned_from.
    """
    versions = listed(exp.column("version_id", table="run"), (row["version_id"] for row in group))
    if state.session.transactions:  # run ids grow from commit to commit: an index finds the newest ones
        oldest = template.node_of(min(row["planned_from"] for row in planned))
        near = exp.and_(versions, exp.column("run_id", table="run") >= oldest)
        return planned_runs(_channels(group), near).query("unplanned")
    rows = exp.column("run_rows", table="there").neq(exp.column("planned_rows", table="member"))
    return planned_runs(_channels(group), versions, rows).query("unplanned")


def look_again(running: Running, state: State, group: list[Row], run_id: int) -> None:
    """Withdraw a run that is committed if it has rivals.

    Raises:
        ConflictError: it has.
    """
    versions = listed(exp.column("version_id", table="run"), (row["version_id"] for row in group))
    slots: dict[str, template.Slot] = {"run_id": run_id, "near": versions, "among": _channels(group)}
    query = state.query("stored/scoring/rivals", slots, {"cohort": running.tables["cohort"]})
    deadline = time.monotonic() + _PATIENCE
    while rows := state.session.rows(query):
        if min(row["rival"] for row in rows) < run_id or time.monotonic() >= deadline:
            withdraw(state, run_id)
            raise ConflictError(CHANGED)
        time.sleep(_PAUSE)


def withdraw(state: State, run_id: int) -> None:
    """Append the rows that withdraw a run, for all versions that it has recorded so far."""
    state.append("run", state.query("stored/state/withdrawal", {"run_id": run_id}))


def _channels(group: list[Row]) -> exp.Expr:
    return listed(exp.column("channel_id", table="version"), (row["channel_id"] for row in group))
