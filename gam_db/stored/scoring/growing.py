"""What was read within the lookback is added up again, not read again, where it comes to the same.

Why that is enough is said in docs/decisions.md.
"""

from collections import Counter
from collections.abc import Mapping, Sequence

from gam_db.clock import LONG_AGO
from gam_db.columns import COUNT, SHARE, columns, table_of
from gam_db.composing import template
from gam_db.stored.planning import Row, by
from gam_db.stored.planning.reading import Reader, cohort_of, recent_run
from gam_db.stored.planning.steps import unmoved_steps
from gam_db.stored.state import State

_RANGES = columns((COUNT, "channel_id run_id summed_from read_to read_sum bins"), (SHARE, "lo hi"))


def read_ranges(state: State, lookback: int, rows: Sequence[Row]) -> dict[int, list[Row]]:
    """Return what runs have summed of each version within ``lookback`` of the newest time, newest first.

    Versions are missing of which not all of that time is known; runs of late are enough if they tell
    all that are in the plan. The lookback is in the unit of time.
    """
    summed = {
        row["version_id"] for row in rows if row["still_after"] is None and row["read_until"] != LONG_AGO
    }
    known = _ranges(state, lookback, recent_run())
    return known if summed <= known.keys() else _ranges(state, lookback, 0)


def _ranges(state: State, lookback: int, since: int) -> dict[int, list[Row]]:
    """Return them of the runs from one on."""
    slots: dict[str, template.Slot] = {"lookback": lookback, "since": since}
    found = by("version_id", state.rows("stored/scoring/last_ranges", slots))
    known = {}
    for version_id, ranges in found.items():
        needed: list[Row] = []
        for row in sorted(ranges, key=lambda row: -row["run_id"]):
            # What the newest run read may be known in part only, or not at all: it may have kept no sum.
            if row["read_to"] + 1 < needed[-1]["summed_from"] if needed else not row["is_newest"]:
                break
            needed.append(row)
            if row["begins"] or row["summed_from"] <= row["newest_time"] - lookback:
                known[version_id] = needed
                break
    return known


def unmoved(
    state: State,
    reader: Reader,
    read: Mapping[int, Sequence[Row]],
    rows: Sequence[Row],
    assets: Sequence[str] | None,
    counted: bool,
) -> set[int]:
    """Return the channels in which nothing of what was read came late, went or changed.

    What is ``read`` is said by :func:`read_ranges`. The rows are the channels to look at, as planned,
    with their assets where not all are read; what was read is only ``counted``, or added up.
    """
    ranges = [{**row, **one} for row in rows for one in read.get(row["version_id"], ())]
    if not ranges:
        return set()
    ends = [min(row["summed_from"] for row in ranges), max(row["read_to"] for row in ranges)]
    steps = unmoved_steps(reader.readings(assets, *ends), counted)
    cohort = cohort_of(rows, read_until=0, planned_from=0)
    session, table = state.session, table_of(ranges, _RANGES)
    with session.lent(cohort) as members, session.lent(table) as lent:
        found = session.rows(steps.query("unmoved", {"cohort": members, "ranges": lent}))
    asked = Counter(row["channel_id"] for row in ranges)
    return {row["channel_id"] for row in found if row["alike"] == asked[row["channel_id"]]}
