"""One writer, enforced: a run counts only if what it was planned from is still there.

A run remembers the newest finished run of each version when it is planned, and compares in its
publication. Where an engine has transactions that is one, and one writer of a monitor at a time is
inside. Else the run compares before its last row and looks again after it: of two that knew nothing of
one another at least one sees the other, and withdraws itself by a second row. The one with the smaller
id waits a moment for the other to do so; then one of them stays. Either way no run stays beside another
that it did not know.
"""

import contextlib
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import NamedTuple, TypeAlias

from sqlglot import exp

from gam_db.composing import template
from gam_db.errors import ConflictError
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import listed
from gam_db.stored.state import State

CHANGED = (
    "Another process scored, calibrated or pruned the same channels while this run was at work, so its "
    "result does not count; what the other one wrote does. Run it again."
)

GONE = (
    "Buckets of the last window before the first new one are not there: another process pruned them "
    "while this run was at work, or somebody deleted them. Run it again; if it stays so, score anew "
    "(--full)."
)

#: Seconds that the smaller of two runs waits for the other one to withdraw, and between two looks.
_PATIENCE, _PAUSE = 2.0, 0.05


class Snapshot(NamedTuple):
    """What is there of a version: its newest finished run (0: none), and how many rows its runs have."""

    newest_run: int
    run_rows: int


NOTHING = Snapshot(0, 0)

#: Active versions with what is there of them.
Snapshots: TypeAlias = Mapping[int, Snapshot]


def snapshots(
    state: State, among: exp.Expr | None = None, near: exp.Expr | None = None
) -> dict[int, Snapshot]:
    """Return what is there of the active versions, ``among`` which a condition on *version* chooses.

    Near is a condition on *run* that holds for all runs that may matter.
    """
    slots: dict[str, template.Slot] = {"among": among or exp.true(), "near": near or exp.true()}
    rows = state.rows("stored/scoring/newest_runs", slots)
    return {row["version_id"]: Snapshot(row["newest_run"], row["run_rows"]) for row in rows}


@contextlib.contextmanager
def publication(
    state: State, monitor_id: int, group: Sequence[Row], planned: Snapshots, run_id: int
) -> Iterator[Callable[[], None]]:
    """Do all inside as one run that counts, or not at all.

    Yields:
        What is to be called before the rows that commit the run are appended.

    Raises:
        ConflictError: something else is there by now; nothing of this run counts.
    """
    with state.session.transaction():
        state.lock(monitor_id)
        _compare(state, group, planned)
        yield lambda: None if state.session.transactions else _compare(state, group, planned)
        if not state.session.transactions:
            _look_again(state, group, planned, run_id)


def _compare(state: State, group: Sequence[Row], planned: Snapshots) -> None:
    """Refuse to go on where another snapshot was planned from."""
    known = {row["version_id"]: planned.get(row["version_id"], NOTHING) for row in group}
    oldest = min(snapshot.newest_run for snapshot in known.values())
    near = _versions(group)
    if state.session.transactions:  # run ids grow from commit to commit: an index finds the newest ones
        near = exp.and_(near, exp.column("run_id", table="run") >= template.node_of(oldest))
    found = snapshots(state, _channels(group), near)
    for version_id, snapshot in known.items():
        there = found.get(version_id)
        if there is None or there.newest_run != snapshot.newest_run:
            raise ConflictError(CHANGED)
        if there.run_rows != snapshot.run_rows and not state.session.transactions:
            raise ConflictError(CHANGED)


def _look_again(state: State, group: Sequence[Row], planned: Snapshots, run_id: int) -> None:
    """Withdraw a run if another one is there that it did not know."""
    others = exp.and_(_versions(group), exp.column("run_id", table="run").neq(template.node_of(run_id)))
    deadline = time.monotonic() + _PATIENCE
    while True:
        found = snapshots(state, _channels(group), others)
        unknown = [
            found.get(row["version_id"], NOTHING).newest_run
            for row in group
            if row["version_id"] not in found
            or found[row["version_id"]].newest_run != planned.get(row["version_id"], NOTHING).newest_run
        ]
        if not unknown:
            return
        if min(unknown) < run_id or time.monotonic() >= deadline:
            break
        time.sleep(_PAUSE)
    withdraw(state, run_id)
    raise ConflictError(CHANGED)


def withdraw(state: State, run_id: int) -> None:
    """Append what lets a run, of all versions that it has recorded so far, count no more."""
    state.append("run", state.query("stored/state/withdrawal", {"run_id": run_id}))


def _versions(group: Sequence[Row]) -> exp.Expr:
    return listed(exp.column("version_id", table="run"), (row["version_id"] for row in group))


def _channels(group: Sequence[Row]) -> exp.Expr:
    return listed(exp.column("channel_id", table="version"), (row["channel_id"] for row in group))
