"""Checksums of what calibration froze, and the rows that a new table is given of an older state.

What is summed, and how, stands in ``sql/stored/calibrating/checksum_rows.sql``.
"""

from functools import cache

from sqlglot import exp

from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add

#: The ends of a range, and what the tables called them when checksums came.
ENDS = {"calibrated_lo": "lo", "calibrated_hi": "hi"}

#: What versions have had since: nothing, where it is not there yet.
LATER = ("still_after", "least_vectors")


@cache
def matching_steps() -> Pipeline:
    """Return the steps up to *mismatched*, over the state tables and *wanted* (version_id)."""
    steps = _summing(Pipeline(small=frozenset({"frozen", "wanted"})))  # read several times: planned once
    add(steps, "stored/calibrating/mismatched")
    return steps


@cache
def first_rows(table: str) -> exp.Query | None:
    """Return what a new table is given of an older state: rows that it lacks; None for none."""
    steps = Pipeline()
    if table == "horizon":
        add(steps, "stored/calibrating/first_horizons")
        return steps.query("first_horizons")
    if table == "checksum":
        add(steps, "stored/calibrating/missing_checksums", name="wanted")
        query = _summing(steps).query("checksum_rows").copy()
        for name in query.find_all(exp.Identifier):
            name.set("this", ENDS.get(name.name, name.name))
        for column in list(query.find_all(exp.Column)):
            if column.table == "made" and column.name in LATER:
                column.replace(exp.cast(exp.null(), "BIGINT"))
        return query
    return None


def _summing(steps: Pipeline) -> Pipeline:
    for name in ("frozen", "checksum_rows"):
        add(steps, f"stored/calibrating/{name}")
    return steps
