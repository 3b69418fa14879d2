"""The lists of a run: the statements that count, those that publish, and those that clear up.

This module owns which statements a run of one shape executes, and in which order. They are made once;
what differs from run to run comes as tables, or as the queries of one execution.
"""

from functools import cache
from typing import NamedTuple

from gam_db.clock import TimeKind
from gam_db.composing.plan import Kind, Plan, Statement
from gam_db.errors import ConflictError
from gam_db.method.bits import Bits
from gam_db.stored.planning.published import former, published
from gam_db.stored.planning.reading import vector_statements
from gam_db.stored.planning.setting import Setting
from gam_db.stored.planning.steps import scoring_steps

CHANGED = (
    "Another process scored, calibrated or pruned the same channels while this run was at work, so its "
    "result does not count; what the other one wrote does. Run it again."
)

GONE = (
    "Buckets of the last window before the first new one are not there: another process pruned them "
    "while this run was at work, or somebody deleted them. Run it again; if it stays so, score anew "
    "(--full)."
)

#: Tables of the whole run, which its lists read.
_BEFORE = frozenset(("plan", "names", "planned_runs"))


class Shape(NamedTuple):
    """What decides the statements of a run.

    Attributes:
        setting: what its channels share.
        kind: of time.
        bits: how the engine keeps supports as bits; None where it does not.
        compared: whether buckets that are stored just so are not written again.
        recounted: whether the rows of calibration are counted anew.
    """

    setting: Setting
    kind: TimeKind
    bits: Bits | None
    compared: bool
    recounted: bool


@cache
def counting(shape: Shape) -> Plan:
    """Return the statements from the cohort to the rows of a run; the answer is *scored*.

    The caller gives the queries *cohort*, *recount* (if that is due), *identified*, *past_buckets*,
    *past_missing* and, to compare, those of :func:`.published.former`. All else is that of
    :func:`gam_db.stored.planning.steps.scoring_steps`.
    """
    steps, programs = scoring_steps(*shape), shape.setting.has_programs
    tables = ("cohort", *["recount"] * shape.recounted, "identified")
    statements = [
        *map(Statement, tables),
        *vector_statements(steps),
        Statement("past_buckets"),
        Statement("past_missing", Kind.VERIFY, failure=lambda _: ConflictError(GONE)),
        Statement("new_buckets"),
        *(Statement(name) for name in former(programs).values() if shape.compared),
        Statement("scored", Kind.ANSWER),
    ]
    held = [statement.name for statement in statements if statement.kind is Kind.TABLE]
    parts = published(programs)
    needed = (step.name for step in steps.needed(parts, held))
    small = [name for name in needed if name in steps.small]
    return Plan.of(steps, [*statements, *map(Statement, small)], _BEFORE)


@cache
def publishing(shape: Shape, transactions: bool) -> tuple[Plan, Plan]:
    """Return the statements that append the counts, and those that commit them.

    Judgements are appended between the two. The caller gives the queries *unplanned* and, where there
    are transactions, *hidden_bucket* and so on: what the run hides goes with its commit. Else it is
    compared once more before the commit, and `gam prune` clears up.
    """
    steps, programs = counting(shape).steps, shape.setting.has_programs
    *parts, last = published(programs)
    verify = Statement("unplanned", Kind.VERIFY, failure=lambda _: ConflictError(CHANGED))
    appends = [Statement(part, Kind.APPEND, part.removesuffix("_rows")) for part in parts]
    commit = [Statement(last, Kind.APPEND, last.removesuffix("_rows"))]
    if transactions:
        hidden = hidden_tables(programs)
        commit += [Statement(f"hidden_{table}", Kind.DELETE, table) for table in hidden]
    else:
        commit.insert(0, verify)
    tables = frozenset(steps.steps)  # whatever is small is a table by now
    return Plan.of(steps, [verify, *appends], tables), Plan.of(steps, commit, tables)


def hidden_tables(has_programs: bool) -> tuple[str, ...]:
    """Return the tables of which a run hides rows."""
    return (*(part.removesuffix("_rows") for part in published(has_programs)[:-1]), "judgement")
