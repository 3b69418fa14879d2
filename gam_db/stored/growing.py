"""Sources that are said to grow only: what was read within the lookback is counted, not read again.

Why that is enough, and what it does not find, is said in docs/decisions.md.
"""

from collections.abc import Mapping, Sequence

from gam_db.columns import counts, table_of
from gam_db.stored.planning import Row, by
from gam_db.stored.reading import Reader, cohort_of
from gam_db.stored.state import State
from gam_db.stored.steps import unmoved_steps

_RANGES = counts("channel_id run_id read_from read_to rows_read")


def read_ranges(state: State, lookback: int) -> dict[int, list[Row]]:
    """Return what runs have read of each version within ``lookback`` of the newest time, newest first.

    Versions are missing of which not all of that time is known.
    """
    found = by("version_id", state.rows("stored/last_ranges", {"lookback": lookback}))
    known = {}
    for version_id, ranges in found.items():
        needed: list[Row] = []
        for row in sorted(ranges, key=lambda row: -row["run_id"]):
            if needed and row["read_to"] < needed[-1]["read_from"]:
                break
            needed.append(row)
            if row["begins"] or row["read_from"] <= row["newest_time"] - lookback:
                known[version_id] = needed
                break
    return known


def unmoved(
    state: State,
    reader: Reader,
    read: Mapping[int, Sequence[Row]],
    rows: Sequence[Row],
    assets: Sequence[str] | None,
) -> set[int]:
    """Return the channels in which none of the rows that were read has come late, or gone.

    Args:
        state: the state tables.
        reader: of the source.
        read: what :func:`read_ranges` returns.
        rows: the channels to look at, as planned.
        assets: those of the channels, where not all are read.
    """
    ranges = [
        {**one, "channel_id": row["channel_id"]}
        for row in rows
        for one in read.get(row["version_id"], ())
    ]
    if not ranges:
        return set()
    ends = [min(row["read_from"] for row in ranges), max(row["read_to"] for row in ranges)]
    steps = unmoved_steps(reader.readings(assets, *ends))
    cohort = cohort_of(rows, read_until=0, planned_from=0)
    session, table = state.session, table_of(ranges, _RANGES)
    with session.lent(cohort) as members, session.lent(table) as lent:
        found = session.rows(steps.query("unmoved", {"cohort": members, "ranges": lent}))
    return {row["channel_id"] for row in found}
