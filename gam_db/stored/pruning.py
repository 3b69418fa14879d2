"""Pruning: delete old and hidden rows of the state, so that no channel grows without bound.

This module owns how long rows stay. Rows that a restart needs stay at any age, so that pruning does not
change the results of later runs.
"""

import contextlib
from collections.abc import Mapping
from functools import reduce

import pyarrow as pa
import pyarrow.compute as pc
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, Length, length
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import EngineError, ParameterError
from gam_db.stored import lengths
from gam_db.stored.planning.steps import DAY
from gam_db.stored.schema import migrations
from gam_db.stored.sources import repeat_of
from gam_db.stored.state import State, first_run_at, kind_of, now

NOVEL_ROWS = 100_000
"""Rows of novel cells that a version keeps where nothing is said: those of 100,000 vectors if each is
novel and in a cell of its own, of ten million if one in a hundred is."""

COUNTED = ("bucket_rows", "novel_rows", "run_rows", "support_rows")
"""The columns of sizes that count rows."""


#: The files of the steps that find what goes, in order; all are read before anything is deleted.
_FILES = (
    *("pruning/pruned_versions", "scoring/recorded", "pruning/bucket_ages", "pruning/horizons"),
    *("pruning/staying_buckets", "pruning/staying_novel", "pruning/staying_judgements"),
    *("pruning/expired_runs", "pruning/expired_band_visits", "pruning/expired_versions"),
    *("pruning/expired_supports", "pruning/expired_unplaced", "pruning/new_horizons"),
    *("pruning/expired_horizons", "pruning/expired_left_out", "pruning/staying_unknown_programs"),
)

#: State tables whose rows a later run writes again -> what their steps are called by: of each those that
#: stay are a step, and those that are not among them expire.
_REWRITTEN = {
    **{"bucket": "buckets", "novel": "novel", "judgement": "judgements"},
    "unknown_program": "unknown_programs",
}

#: Steps that have a row per bucket, which are not kept.
_LARGE = frozenset({"bucket_ages", *(f"staying_{called}" for called in _REWRITTEN.values())})

#: How long it stays known how many rows runs could give to no channel, in microseconds: a year.
_UNPLACED = 365 * DAY

#: What is deleted: the state table, and the step that lists the keys of its rows. Versions come last: as
#: long as one is there, what is left of it is found again, should the work be cut short on an engine
#: without transactions.
_EXPIRED = {
    **{table: f"expired_{table}s" for table in ("bucket", "judgement", "run", "horizon", "band_visit")},
    **{"novel": "expired_novel", "unplaced": "expired_unplaced"},
    "unknown_program": "expired_unknown_programs",
    "left_out": "expired_left_out",
    "move": "expired_band_visits",
    **dict.fromkeys(
        ("calibration", "buffered", "band", "extent", "limit", "checksum"), "expired_versions"
    ),
    **dict.fromkeys(("support", "block", "ladder", "probe", "program", "bounds"), "expired_supports"),
    "version": "expired_versions",
}


class _UndoneError(Exception):
    """Ends a dry run, and undoes it."""


def prune(
    state: State,
    monitor: str = "default",
    keep: Length | None = None,
    keep_novel: Length | None = None,
    keep_versions: int | None = None,
    lookback: Length | None = None,
    dry_run: bool = False,
) -> pa.Table:
    """Delete old and hidden rows, and return the row counts before and after.

    It is one transaction where there are any; else what is cut short is mended by the next call.

    Rows go that are hidden by a later run, or left by one that never finished (where there are
    transactions, scoring does so itself; without them, rows of a run without end are taken for those of
    one at work until a day has passed); buckets and novel cells
    beyond their age; versions beyond their number, with what only they had learnt; records of runs of
    which nothing else is left. Of an active version stay the buckets that ``lookback`` reaches and a
    window of buckets before them.

    A row of the result is one channel, the largest first: ``asset``, ``channel``, ``versions``,
    ``bucket_rows``, ``novel_rows``, ``run_rows`` and ``support_rows`` before, and each again as
    ``..._after``. A support that a pool shares counts for each of its channels.

    Args:
        state: the state tables, in a session that can write, also for a dry run.
        monitor: its name; other monitors are left alone.
        keep: age behind the newest bucket of its channel up to which buckets of the health indicator
            stay; None for ever.
        keep_novel: the same of novel cells; None for as many of the newest buckets as hold
            :data:`NOVEL_ROWS` rows of them together. They never outlast their buckets.
        keep_versions: retired versions of each channel that stay; None for all.
        lookback: how late rows may come, as in scoring: the buckets that it reaches stay. Default one
            hour, for counters 0.
        dry_run: undo it all; the result is the same.

    Raises:
        StateError: there is no state of this gam-db.
        ConfigurationError: there is no such monitor.
        ParameterError: a length of time or a number is none.
        EngineError: the database cannot be written, a transaction is open, or there is none to undo.
    """
    migrations.require(state.session, state.tables)
    if dry_run and not state.session.transactions:
        raise EngineError(
            f"{state.session.engine.title} has no transactions to undo; leave out the dry run."
        )
    monitor_row = state.monitor(monitor)
    kind = kind_of(monitor_row)
    slots: dict[str, template.Slot] = {  # in integers; 2^62 is for ever
        role: FAR_AHEAD if age is None else length(age, kind, role)
        for role, age in (("keep", keep), ("keep_novel", keep_novel))
    }
    slots["lookback"] = lengths.lookback(lookback, kind, repeat_of(monitor_row["source"]))
    slots["novel_rows"] = NOVEL_ROWS if keep_novel is None else FAR_AHEAD
    versions = FAR_AHEAD if keep_versions is None else keep_versions
    if isinstance(versions, bool) or not isinstance(versions, int) or versions < 0:
        raise ParameterError(f"keep_versions is {versions!r}; it is a number of versions, 0 or more.")
    return _deleted(state, monitor, {**slots, "keep_versions": versions}, dry_run)


def _deleted(state: State, monitor: str, limits: Mapping[str, template.Slot], dry_run: bool) -> pa.Table:
    session, tables = state.session, state.tables
    monitor_id = state.monitor(monitor)["monitor_id"]
    # A run that is seen without its end, where there are transactions, was cut short; else it may go on
    # for a day. What seems to begin later than that did so while a clock stood ahead, and counts as cut
    # short, unless finished runs did so, too: then run ids go on from theirs.
    begun = (FAR_AHEAD, FAR_AHEAD)
    if not session.transactions:
        latest = max(first_run_at(now() + DAY), state.last_numbers()["run"] + first_run_at(1))
        begun = (first_run_at(now() - DAY), latest)
    slots = {
        "monitor": template.text(monitor),
        "unfinished_from": begun[0],
        "unfinished_to": begun[1],
        "unplaced_from": now() - _UNPLACED,
        "at_least": 0,  # whatever the next run's lookback, it may rely on what the last one recorded
        "since": 0,
        **limits,
    }
    steps = Pipeline()
    for file in _FILES:
        steps.add(file.rpartition("/")[2], _query(state, f"stored/{file}", slots))
    for table, called in _REWRITTEN.items():
        expired = _query(
            state, "stored/pruning/expired_rows", slots, {"written_rows": tables.table(table)}
        )
        steps.add(f"expired_{called}", expired, tables={"staying_rows": f"staying_{called}"})
    steps.small = frozenset(steps.steps) - _LARGE
    sizes = state.query("stored/pruning/state_sizes", {"monitor": slots["monitor"]})
    with contextlib.suppress(_UndoneError), session.transaction():
        state.lock(monitor_id)  # a run that publishes now is there as a whole, or not yet
        before = session.fetch(sizes)
        step_tables: dict[str, exp.Table] = {}
        for step in steps.steps:
            if step in steps.small:
                step_tables[step] = session.keep(step, steps.query(step, step_tables))
        # Recorded first: what is cut short then is too much kept, and not a loss.
        state.append("horizon", steps.query("new_horizons", step_tables))
        for table, step in _EXPIRED.items():
            expired_rows = steps.query(step, step_tables)
            session.delete(tables.table(table), expired_rows.named_selects, expired_rows)
        after = session.fetch(sizes)
        for step_table in step_tables.values():
            session.forget(step_table)
        if dry_run:
            raise _UndoneError
    # Both have a row per channel, in the same order.
    rows = before
    for column in ("versions", *COUNTED):
        rows = rows.append_column(f"{column}_after", after[column])
    sizes = reduce(pc.add, (before[column] for column in COUNTED))
    return rows.take(pc.sort_indices(pc.negate(sizes)))


def _query(
    state: State,
    path: str,
    slots: Mapping[str, template.Slot],
    tables: Mapping[str, exp.Table] | None = None,
) -> exp.Query:
    """Return a file of ``sql/`` with those of the slots that it has."""
    file_slots = {slot: slots[slot] for slot in template.load(path).slots}
    return state.query(path, file_slots, tables)
