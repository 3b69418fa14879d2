"""Limits of a monitor: the frozen limits of the judgements of its channels (alarms, section 3).

This module owns when limits are computed, and from what. :mod:`gam_db.alarms` chooses them.
"""

from collections.abc import Callable, Sequence
from functools import partial

from sqlglot import exp

from gam_db.alarms import LIMIT, Alarms, Row, chosen_limits
from gam_db.columns import COUNT, WORD, columns, name_of
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.method.alarms import add_spreads
from gam_db.method.judgement import limit_slots
from gam_db.method.source import by_override
from gam_db.settings.parameters import Parameters
from gam_db.stored.state import State, kind_of, now
from gam_db.study.running import Running

#: What is NULL where there is no limit.
CHOSEN = ("centre", "spread", "reference", "height", "cap", "quarters", "basis", "rate", "stated_rate")


def _finds(name: str, of: Parameters) -> int:
    """Return 1 where calibration chooses a setting, else 0."""
    return int(name in of.open_settings)


def learnt(
    state: State,
    monitor_id: int,
    families: Sequence[str] = (),
    is_heeding: bool = False,
    parameters: Parameters | None = None,
    versions: exp.Table | None = None,
) -> Running:
    """Return the steps *limit_channels* and *learnt_limits*, over the active versions of a monitor.

    Where it ``is_heeding``, one with a false alarm right after calibration gets no limit any more.
    Delays and bins that calibration chooses make no family. Versions stands for the table of
    all versions, with some that are not written yet.
    """
    steps = Pipeline(small=frozenset({"active", "limit_channels", "buffered"}))
    add(steps, "stored/state/active", {"monitor_id": monitor_id})
    slots = limit_slots(exp.column("target_floor", table="learnt"))
    for name in ("tau", "bins"):
        finds = by_override(parameters or Parameters(), partial(_finds, name))
        for column in finds.find_all(exp.Column):
            column.set("table", exp.to_identifier("member"))
        slots[f"finds_{name}"] = finds
    slots["heeding"] = int(is_heeding)
    add(steps, "stored/alarms/limit_channels", slots)
    add(steps, "stored/alarms/calibration_buffered", name="buffered")
    add_spreads(steps, families, "limit_channels")
    tables = {} if versions is None else {"stored_version": versions}
    return Running(state.session, steps, {**state.tables.nodes(), **tables})


def make(
    state: State,
    name: str,
    alarms: Alarms,
    parameters: Parameters,
    cause: str = "calibrated",
    wanted: Callable[[Row], bool] = lambda row: row["limit_no"] == 0,
    versions: exp.Table | None = None,
) -> list[Row]:
    """Make limits, from all active versions, and keep those of the wanted ones, with their cause.

    Wanted is asked of a channel's row (asset, channel, limit_no: 0 for none yet); others keep theirs.
    Parameters and versions are as in :func:`learnt`.

    Returns:
        One row per channel that got one, ordered, as :func:`gam_db.limits` returns them.

    Raises:
        ParameterError: a rate in days is asked for, and the source counts time in integers.
    """
    monitor = state.monitor(name)
    kind = kind_of(monitor)
    rate = alarms.rate_for(kind)
    about = (alarms.family, True, parameters, versions)
    with learnt(state, monitor["monitor_id"], *about) as work:
        channels = {row["channel_id"]: row for row in work.rows("limit_channels")}
        chosen = {channel for channel, row in channels.items() if wanted(row)}
        if not chosen:
            return []
        rows = [row for row in chosen_limits(work, alarms, kind) if row["channel_id"] in chosen]
    families = sorted({row["family"] for row in rows})
    for row in rows:
        row["family"] = families.index(row["family"])
    rows.sort(key=name_of)
    shared, limit_rows = {"created": now(), "cause": cause, "asked": rate}, []
    for row in rows:
        before = channels[row["channel_id"]]
        begin = before["judgements"] if before["limit_no"] else 0
        numbers = {"limit_no": before["limit_no"] + 1, "from_judgement": begin}
        limit_rows.append({**row, "version_id": before["version_id"], **numbers, **shared})
    state.append_rows("limit", limit_rows)
    return rows


#: What is shown of limits: the newest ones, by the names of their channels.
SHOWN = columns(
    (WORD, "asset channel"),
    (COUNT, "limit_no from_judgement"),
    (WORD, "cause asked"),
    *LIMIT,
)
