"""The steps of a check that read the state alone: what must hold between its tables."""

from functools import cache

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.method.alarms import root_of


@cache
def soundness_steps(monitor_id: int, is_whole: bool) -> Pipeline:
    """Return the steps that find inconsistencies between the state tables, without the source.

    The last are *checked*, *oldest_buckets*, *orphans*, and what is *inconsistent* of versions, buckets,
    novel cells, judgements and runs.

    Args:
        monitor_id: of the monitor; *orphans* is about all.
        is_whole: whether a run is there as a whole or not at all.
    """
    steps = Pipeline(small=frozenset({"checked"}))
    add(steps, "stored/checking/checked", {"monitor_id": monitor_id})
    for name in (
        "inconsistent_versions",
        "inconsistent_buckets",
        "inconsistent_novel",
        "oldest_buckets",
    ):
        add(steps, f"stored/checking/{name}")
    add(steps, "stored/checking/inconsistent_judgements", {"root": root_of("novel", "judgement")})
    add(steps, "stored/checking/inconsistent_runs", {"nothing": FAR_AHEAD, "long_ago": LONG_AGO})
    add(steps, "stored/checking/orphans", {"whole": int(is_whole)})
    return steps
