"""Repeating: channels of a trusting study in which an instant occurs twice are collapsed and done again.

This module owns which ones they are, and how their rows take the place of those that were made on trust.
A channel says nothing of another one, but by the range and the support of a pool: whole pools are done
again. All others stay as they are proven.
"""

from collections.abc import Collection, Iterable, Sequence

from sqlglot import exp

from gam_db.columns import COUNT, WORD, columns, counts, name_of, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.census import OPENING
from gam_db.method.delays import IN_ORDER, Ways
from gam_db.study.running import Running

#: What steps are called that were made on trust, and those of channels that are done again.
_PROVEN, _AGAIN = "proven_", "again_"

#: Steps that speak of the source and of what is asked: they stay as they are.
_COMMON = frozenset(("readings", "names", "rules", "declared", "channels", *OPENING))

#: Where the rows of both are put together, of all sets and of each, and what that is called of channels
#: that are done again; all else follows from these.
_WHOLE = ("series", "calibrated", "stillness")
_OF_SET = {
    "run_up": "run_up",
    "support": "support",
    "visits": "visits",
    "missing_vectors": "missing_vectors",
    "visited": "visited",
    "tallied": "visited",
    "window_counts": "window_counts",
}

#: What is told of the times of channels; quota_time is found after a collapse where there are repeats.
TIMELINE = counts("channel_id repeats first_time quota_time")

_STAYING = counts("channel_id support_id")
_CHANNELS = columns(
    (COUNT, "channel_id support_id readings missing_readings settings_no calibration_no"),
    (WORD, "asset channel"),
)


def found_before(running: Running, ways: Ways) -> set[int]:
    """Return the channels that show it where samples are kept in order, before there are vectors."""
    step = IN_ORDER.get(ways.delays or "")
    if step is None:
        return set()
    named = {name_of(row): row["channel_id"] for row in running.rows("channels")}
    found = (name_of(row) for row in _marked(running, step, "asset", "channel"))
    return {named[name] for name in found if name in named}


def found_by(running: Running, steps: Iterable[str]) -> set[int]:
    """Return the channels that show it in steps with a mark; these are kept."""
    return {row["channel_id"] for step in steps for row in _marked(running, step, "channel_id")}


def members_of(channels: Collection[Row], found: Collection[int]) -> list[Row]:
    """Return the channels that have a support in common with one that was found."""
    supports = {row["support_id"] for row in channels if row["channel_id"] in found}
    return [row for row in channels if row["support_id"] in supports]


def do_again(running: Running, method: Method, careful: Pipeline, repeating: Sequence[Row]) -> None:
    """Let what is proven hold of all channels but some, whose steps are those that collapse.

    What was kept by the steps that trust stays; the ``careful`` ones look first. The repeating channels
    are whole pools.
    """
    trusting = running.steps
    proven, again = trusting.prefixed(_PROVEN, _COMMON), careful.prefixed(_AGAIN, _COMMON - {"channels"})
    common = {name: step for name, step in trusting.steps.items() if name in _COMMON}
    steps = Pipeline(
        {**common, **proven.steps, **again.steps}, trusting.small | proven.small | again.small
    )
    # All of them are collapsed, once, and nobody looks at their times.
    steps.replace(f"{_AGAIN}samples", union_of(steps, [f"{_AGAIN}collapsed"]))
    parted = {name: name for name in _WHOLE} | {
        method.named(name, number): method.named(of, number)
        for name, of in _OF_SET.items()
        for number in range(len(method.settings))
    }
    for name, step in trusting.steps.items():
        if name not in _COMMON:
            steps.put(step)
        if name in parted:
            steps.replace(name, _parted(steps, f"{_PROVEN}{name}", f"{_AGAIN}{parted[name]}"))
    steps.small -= parted.keys()
    running.steps = steps
    running.rename({step: f"{_PROVEN}{step}" for step in running.kept(_COMMON)})
    members = {row["channel_id"] for row in repeating}
    staying = [row for row in running.rows("channels") if row["channel_id"] not in members]
    earliest = {name_of(row): row["earliest"] for row in running.rows("names")}
    timeline = [{**row, "repeats": 1, "first_time": earliest[name_of(row)]} for row in repeating]
    running.load("staying", table_of(staying, _STAYING))
    running.load(f"{_AGAIN}channels", table_of(repeating, _CHANNELS))
    running.load(f"{_AGAIN}timeline", table_of(timeline, TIMELINE))


def _parted(steps: Pipeline, proven: str, again: str) -> exp.Query:
    """Return the rows of two steps, of each channel or support those of one."""
    names = steps.steps[again].query.named_selects
    whose = exp.column("channel_id" if "channel_id" in names else "support_id")
    rows, others = (union_of(steps, [step], names) for step in (proven, again))
    kept = rows.where(template.fill("census/proven", {"whose": whose}), copy=False)
    return exp.union(kept, others, distinct=False)


def _marked(running: Running, step: str, *names: str) -> list[Row]:
    running.keep(step)
    asked = {"names": [exp.column(name) for name in names]}
    return running.asked("census/repeated_instants", asked, {"marked": step})
