"""Rows that leave the source: if it lost all rows before its oldest one, their scores stay stored.

This module decides which rows of a channel have gone, and where scoring then begins: at the first bucket
whose context the source still holds whole, which keeps its number. A hole between existing rows is not
such a loss, but a correction.
"""

from collections.abc import Mapping, Sequence

from gam_db.clock import LONG_AGO
from gam_db.columns import counts, name_of, table_of
from gam_db.stored.planning import Row, assets_of
from gam_db.stored.planning.reading import Reader
from gam_db.stored.planning.steps import reading_steps, whole_plan_steps
from gam_db.stored.state import State
from gam_db.study.running import Running


def whole_plan_rows(state: State, monitor_id: int, oldest: Mapping[int, int]) -> dict[int, Row]:
    """Return the rows of a plan by version, for the oldest time that the source holds of each.

    Where the context is not whole even after the newest bucket, no number of rows is expected. Versions
    are missing that have no bucket, or of which nothing has gone that their first one needs.
    """
    if not oldest:
        return {}
    rows = [{"version_id": key, "oldest_time": time} for key, time in oldest.items()]
    tables = state.tables.nodes()
    with Running(state.session, whole_plan_steps(monitor_id), tables) as running:
        running.load("oldest_rows", table_of(rows, counts("version_id oldest_time")))
        begun = {row["version_id"]: row["begin_time"] for row in running.rows("restart")}
        plans = {row["version_id"]: row for row in running.rows("plan")}
        first = {row["version_id"]: row["run_up_from"] for row in running.rows("active")}
    return {
        key: {**plans[key], **({"context_expected": None} if plans[key]["read_from"] < time else {})}
        for key, time in oldest.items()
        if key in begun and key in plans and time > (first[key] if first[key] > LONG_AGO else begun[key])
    }


def staying_rows(
    state: State, reader: Reader, monitor_id: int, rows: Sequence[Row], names: Sequence[Row]
) -> dict[int, Row]:
    """Return other rows of a plan, by version, for those whose context has gone from the source.

    The source was looked at from where the first row is read on, and *names* is what that gave. Where a
    channel begins later than its row is to be read, it is asked whether it has anything older.
    """
    earliest = {name_of(row): row["earliest"] for row in names if row["readings"]}
    restarting = [row for row in rows if row["restarts"]]
    late = [row for row in restarting if earliest.get(name_of(row), LONG_AGO) > row["read_from"]]
    if not late:
        return {}
    begins = max(row["read_from"] for row in late)
    older: dict[tuple[str, str], int] = {}
    if begins > LONG_AGO:
        steps = reading_steps(reader.readings(assets_of(late), latest=begins - 1))
        looked = state.session.rows(steps.query("names"))
        older = {name_of(row): row["earliest"] for row in looked if row["readings"]}
    oldest = {
        row["version_id"]: earliest[name_of(row)]
        for row in late
        if older.get(name_of(row), row["read_from"]) >= row["read_from"]
    }
    staying = whole_plan_rows(state, monitor_id, oldest)
    return {
        row["version_id"]: {**row, **{name: other[name] for name in _BEGINS}}
        for row in late
        if (other := staying.get(row["version_id"])) is not None
        and other["first_bucket"] >= row["first_bucket"]
    }


#: Columns of a plan that say where a version begins.
_BEGINS = ("first_bucket", "first_scored", "read_from", "context_expected", "oldest_bucket")
