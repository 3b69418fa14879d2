"""The rows that a run appends, and those already stored: buckets, novel cells, programs, its record.

This module owns the steps of these rows and the order in which a run appends them; it runs nothing.
"""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import add

#: What is appended where states are of no program; the rows of *run* are the commit.
_PUBLISHED = ("bucket_rows", "novel_rows", "run_rows")

#: From which bucket on a run writes, with its columns.
_CHANGED = ("channel_id", "version_id", "first_bucket", "differs")


def add_published(steps: Pipeline, has_programs: bool, is_compared: bool) -> None:
    """Add the rows that a run appends, over the steps that count.

    Where they are compared with what is stored, those before the first bucket that differs are not
    written; else all that a run has made is.
    """
    if has_programs:
        add(steps, "stored/scoring/unknown_programs")
    if not is_compared:
        columns = [exp.column(name) for name in _CHANGED]
        steps.add("changed", exp.select(*columns).from_("cohort"), "Changed: all that is made.")
        steps.add("written", union_of(steps, ["new_buckets"]), "Written: all that is made.")
    else:
        add(steps, "stored/scoring/changed", name="changed_buckets" if has_programs else None)
        if has_programs:
            add(steps, "stored/scoring/program_changed", name="changed")
        add(steps, "stored/scoring/written")
        steps.small |= {"changed", "written"}
    for name in ("new_counts", "scored"):
        add(steps, f"stored/scoring/{name}")
    renamed = {"bucket_rows": "plain_bucket_rows"} if has_programs else {}
    for part in _PUBLISHED:
        add(steps, f"stored/scoring/{part}", name=renamed.get(part))
    if has_programs:
        add(steps, "stored/scoring/program_bucket_rows", name="bucket_rows")
        add(steps, "stored/scoring/unknown_program_rows")


def published(has_programs: bool) -> tuple[str, ...]:
    """Return the steps that a run appends, in order; the last one commits it."""
    *before, last = _PUBLISHED
    return (*before, *["unknown_program_rows"] * has_programs, last)


def former(has_programs: bool) -> dict[str, str]:
    """Return the steps of the stored rows that a run makes anew, by table."""
    steps = {"bucket": "former_buckets", "novel": "former_novel"}
    return steps | ({"unknown_program": "former_programs"} if has_programs else {})


def former_slots(
    table: str, near: exp.Expr, within: exp.Expr, has_programs: bool
) -> dict[str, template.Slot]:
    """Return the slots of such a step: conditions on *bucket*, and on single rows of it."""
    if table != "bucket":
        return {"near": near}
    programs = [exp.column("unknown_program")] * has_programs
    return {"near": near, "within": within, "programs": programs}
