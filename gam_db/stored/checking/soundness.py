"""The steps of a check that read the state alone: what must hold between its tables."""

from functools import cache

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.method.alarms import add_rejudged


@cache
def soundness_steps(monitor_id: int, is_whole: bool) -> Pipeline:
    """Return the steps that tell what does not hold between the state tables, without the source.

    The last are *checked*, *inconsistent_versions*, *inconsistent_buckets*, *inconsistent_novel*,
    *inconsistent_runs* and *orphans*.

    Args:
        monitor_id: of the monitor; *orphans* is about all.
        is_whole: whether a run is there as a whole or not at all.
    """
    steps = Pipeline(small=frozenset({"checked"}))
    add(steps, "stored/checking/checked", {"monitor_id": monitor_id})
    for name in ("inconsistent_versions", "inconsistent_buckets", "inconsistent_novel"):
        add(steps, f"stored/checking/{name}")
    add(steps, "stored/checking/inconsistent_runs", {"nothing": FAR_AHEAD, "long_ago": LONG_AGO})
    add(steps, "stored/checking/orphans", {"whole": int(is_whole)})
    return steps


@cache
def judging_steps(buckets: int) -> Pipeline:
    """Return the steps that judge the versions of *judged_until* anew, each as a channel of its own.

    The last are *inconsistent_judgements*, *judged_edges* and *raised_again*.

    Args:
        buckets: of a window.
    """
    steps = Pipeline(
        small=frozenset(
            {"rejudged_buckets", "kept_judgements", "rejudged_windows", "judged_again", "merged"}
        )
    )
    slots: dict[str, template.Slot] = {"buckets": buckets}
    add(steps, "stored/alarms/limit_spans")
    for name in ("rejudged_buckets", "kept_judgements"):
        add(steps, f"stored/checking/{name}")
    add(steps, "alarms/judged_windows", slots, tables={"bucket_counts": "rejudged_buckets"})
    add(steps, "stored/checking/rejudged_windows", slots)
    add_rejudged(steps)
    for name in ("judged_again", "inconsistent_judgements", "judged_edges"):
        add(steps, f"stored/checking/{name}")
    add(steps, "alarms/merged")
    add(steps, "stored/checking/raised_again")
    return steps
