"""Checking the state against the source: is what was scored still what one run over everything gives?

This module owns the comparison. It writes nothing. It covers what lies outside the contract: rows later
than the lookback, corrected and deleted ones, and rows of calibration that came or went. What the next
run will read anyway is left out.
"""

from collections.abc import Sequence
from itertools import groupby
from typing import Any

import pyarrow as pa

from gam_db.clock import LONG_AGO
from gam_db.running import Listener, Running, unheard
from gam_db.source import AnySource
from gam_db.stored.planning import Row, assets_of, portions, whole_pools
from gam_db.stored.reading import Reader, cohort_of, plan_rows, searched_plan_rows
from gam_db.stored.state import State, kind_of
from gam_db.stored.steps import (
    comparing_steps,
    reading_steps,
    relearning_steps,
    setting_of,
)


def check_state(
    state: State,
    source: AnySource,
    name: str,
    lookback: int,
    limit: int | None = None,
    on_step: Listener = unheard,
) -> pa.Table:
    """Compare the stored buckets and the frozen calibration of a monitor with its source.

    The whole source is read, a group of channels at a time.

    Args:
        state: the state tables.
        source: where the telemetry lies.
        name: of the monitor.
        lookback: buckets that the next run would write anew are not compared.
        limit: most readings to work on at once; None for what memory allows.
        on_step: called with what is done next.

    Returns:
        One row per difference, ordered: asset, channel, part ("scored" or "calibration"), day (days
        since 1970; NULL for counters and for calibration), samples_then and samples_now (of the day;
        rows of the intervals for calibration), differing (buckets; visited cells for calibration),
        since (integer time of the first bucket that differs: score from there on to repair; NULL for
        calibration).

    Raises:
        UserError: there is no such monitor, or the source cannot be used.
    """
    monitor = state.monitor(name)
    reader = Reader(state.session, source, kind_of(monitor), name)
    monitor_id = monitor["monitor_id"]
    settled = {row["version_id"]: row for row in plan_rows(state, monitor_id, lookback)}
    rows = searched_plan_rows(state, monitor_id, None)
    names = {row["channel_id"]: (row["asset"], row["channel"]) for row in rows}
    check = _Check(state, reader, on_step)
    readings, most = check.readings(), limit or state.session.rows_at_once()
    found: list[Row] = []
    for group in portions(rows, readings, most):
        found += check.scored(group, [settled[row["version_id"]] for row in group])
    taught = [row for row in rows if row["calibration_end"] is not None]
    for _, alike in groupby(sorted(taught, key=_setting), key=_setting):
        for group in whole_pools(alike, readings, most):
            found += check.calibration(group)
    made = [
        {**row, **dict(zip(("asset", "channel"), names[row["channel_id"]], strict=True))}
        for row in found
    ]
    made.sort(key=lambda row: (row["asset"], row["channel"], row["part"], row["since"] or LONG_AGO))
    return pa.Table.from_pylist(made, schema=_RESULT)


class _Check:
    def __init__(self, state: State, reader: Reader, on_step: Listener) -> None:
        self.state, self.session, self.reader, self.on_step = state, state.session, reader, on_step

    def readings(self) -> dict[tuple[str, str], int]:
        steps = reading_steps(self.reader.readings())
        rows = self.session.fetch(steps.query("names")).to_pylist()
        return {(row["asset"], row["channel"]): row["readings"] for row in rows}

    def scored(self, group: Sequence[Row], settled: Sequence[Row]) -> list[Row]:
        """Compare the settled buckets of a group of one setting."""
        running = self._running(comparing_steps(setting_of(group[0]), self.reader.kind))
        ends = [row["first_scored"] - 1 for row in settled]
        try:
            running.load(
                "cohort",
                cohort_of(group, read_until=ends, settled=[row["first_bucket"] for row in settled]),
            )
            earliest = min(row["read_from"] for row in group)
            rows = reading_steps(self.reader.readings(assets_of(group), earliest))
            running.put("identified", rows.query("identified", running.placed))
            differences = running.table("compared").to_pylist()
        finally:
            running.forget()
        return [
            {
                **row,
                "part": "scored",
                "day": None if self.reader.kind.is_counter else row["day_no"],
            }
            for row in differences
        ]

    def calibration(self, group: Sequence[Row]) -> list[Row]:
        """Compare what the frozen intervals of pools of one setting teach now with what they taught."""
        running = self._running(relearning_steps(setting_of(group[0]), self.reader.kind))
        ends = [row["calibration_end"] for row in group]
        try:
            cohort = cohort_of(group, read_from=LONG_AGO, read_until=ends, first_bucket=0)
            running.load("cohort", cohort)
            edges = running.table("calibration_range").to_pylist()[0]
            # No sample before an interval decides what is learnt in it.
            healthy = self.reader.readings(assets_of(group), edges["earliest"], edges["latest"])
            rows = reading_steps(healthy)
            running.put("identified", rows.query("identified", running.placed))
            counted = self.session.fetch(rows.query("recount", running.placed)).to_pylist()
            changed = running.table("relearnt").to_pylist()
        finally:
            running.forget()
        cells = {row["support_id"]: row["differing"] for row in changed}
        now = {row["channel_id"]: row["calibration_readings"] for row in counted}
        return [
            {
                "channel_id": row["channel_id"],
                "part": "calibration",
                "day": None,
                "samples_then": row["calibration_readings"],
                "samples_now": now.get(row["channel_id"], 0),
                "differing": cells.get(row["support_id"], 0),
                "since": None,
            }
            for row in group
            if row["support_id"] in cells or now.get(row["channel_id"], 0) != row["calibration_readings"]
        ]

    def _running(self, steps: Any) -> Running:
        return Running(self.session, steps, self.state.tables.placed(), self.on_step)


def _setting(row: Row) -> str:
    return repr(setting_of(row))


_RESULT = pa.schema(
    [
        *((name, pa.string()) for name in ("asset", "channel", "part")),
        *((name, pa.int64()) for name in ("day", "samples_then", "samples_now", "differing", "since")),
    ]
)
