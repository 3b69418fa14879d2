"""Scoring a group of channels of one setting, from its rows to what is committed, in four stages.

This module owns the stages: counting calibration anew where that is due, the vectors, the rows that are
to be published, and their publication. Rows are appended first and one row per version in
``gam_state_run`` last: that is the commit. Where an engine has transactions, all of it is one, and rows
that are now hidden go in the same. It counts only if nobody else wrote meanwhile
(:mod:`gam_db.stored.scoring.publishing`).
"""

from collections.abc import Mapping, Sequence

import pyarrow as pa

from gam_db.columns import counts, name_of, table_of
from gam_db.composing import template
from gam_db.errors import ConflictError
from gam_db.method.bits import Bits
from gam_db.stored.alarms.episodes import follow
from gam_db.stored.alarms.judging import buckets_of, judge
from gam_db.stored.planning import Cohort, Row, assets_of, is_due
from gam_db.stored.planning.published import WRITTEN, former, former_slots, published
from gam_db.stored.planning.reading import Reader, cohort_of, make_vectors, near
from gam_db.stored.planning.steps import (
    reading_steps,
    scoring_steps,
    shared_by,
)
from gam_db.stored.scoring.publishing import GONE, NOTHING, Snapshots, publication, withdraw
from gam_db.stored.scoring.report import Wanted
from gam_db.stored.state import State, now
from gam_db.study.running import Listener, Running

#: Supports are kept as bits where they take no more of them than so many times the rows to be scored.
BITS_OF_A_ROW = 512

#: What judgements are made of: what a run writes.
_JUDGED = {"cohort": "changed", "new_buckets": "written", "stamp": "stamp"}


class Groups:
    """The groups of channels of one run, whose state, reader of the source and time of begin are given.

    Attributes:
        planned: what was known of each version before the run was planned.
        latest: the newest time that the look has found of each channel, by its names.
        is_thorough: whether all is followed anew.
        channels: what is told of each channel that was scored.
    """

    def __init__(
        self,
        state: State,
        reader: Reader,
        monitor: Row,
        wanted: Wanted,
        started: int,
        on_step: Listener,
    ) -> None:
        self.state, self.session, self.reader, self.monitor = state, state.session, reader, monitor
        self.wanted, self.started, self.on_step = wanted, started, on_step
        self.planned: Snapshots = {}
        self.latest: dict[tuple[str, str], int | None] = {}
        self.is_thorough = wanted.everything
        self.channels: list[Row] = []

    def score(self, group: list[Row], cohort: Cohort, read: int) -> None:
        """Score channels of one shape, in four stages, of which so many rows are read."""
        setting = shared_by(group)
        # Of what lies within the lookback hardly anything has changed; only that is written anew.
        compared = not self.wanted.is_anew and any(row["restarts"] for row in group)
        steps = scoring_steps(setting, self.reader.kind, self._bits(group, read), compared)
        with Running(self.session, steps, self.state.tables.placed(), self.on_step) as running:
            # A part of a cohort is found by name, or each part would read the rows of all.
            assets = cohort.assets if len(group) == len(cohort.channels) else assets_of(group)
            self._recount(running, group, assets)
            since = min(row["read_from"] for row in group)
            rows = reading_steps(self.reader.readings(assets, since))
            running.put("identified", rows.query("identified", running.placed))
            make_vectors(running, setting.programs)
            self._count(running, group, compared)
            self._publish(running, group)

    def _bits(self, group: Sequence[Row], read: int) -> Bits | None:
        """Return how the engine keeps supports as bits; None where they take much beside the rows."""
        bits, setting = self.session.engine.bits, shared_by(group)
        cells, supports = setting.radix**setting.m, len({row["support_id"] for row in group})
        is_little = cells * supports <= BITS_OF_A_ROW * read
        is_plain = is_little and not setting.has_programs
        return bits if bits is not None and is_plain and bits.serve(cells, supports) else None

    def _recount(self, running: Running, group: Sequence[Row], assets: Sequence[str] | None) -> None:
        """First stage: count the rows of calibration of the channels for which it is due."""
        running.load("cohort", self._cohort(group))
        due = any(self._is_due(row) for row in group)
        edges = running.rows("calibration_range")[0] if due else {}
        if edges.get("earliest") is None:
            running.load("recount", table_of([], _NO_RECOUNT))
            return
        healthy = self.reader.readings(assets, edges["earliest"], edges["latest"])
        counting = reading_steps(healthy, is_ranged=False)
        running.put("recount", counting.query("recount", running.placed))

    def _count(self, running: Running, group: Sequence[Row], compared: bool) -> None:
        """Third stage: make the rows that are to be published, on from the buckets that stay."""
        buckets = buckets_of(group[0])
        past: dict[str, template.Slot] = {"buckets": buckets, "near": near(group, buckets)}
        running.make("stored/scoring/past_buckets", past)
        self._check_past(group, running)
        running.keep("new_buckets")
        has_programs = shared_by(group).has_programs
        for table, step in former(has_programs).items() if compared else ():
            slots = former_slots(table, near(group), near(group), has_programs)
            running.make(f"stored/scoring/{step}", slots)
        if not compared:
            running.placed |= {step: running.placed[made] for step, made in WRITTEN.items()}
        for part in published(has_programs):
            running.prepare(part)

    def _publish(self, running: Running, group: Sequence[Row]) -> None:
        """Last stage: append the rows, and commit them unless the state has changed meanwhile."""
        made = {row["channel_id"]: row for row in running.rows("new_counts")}
        seen = {row["channel_id"]: row for row in running.rows("seen")}
        self.on_step("writing")
        run_id = self.state.next_run()
        stamp = {
            "run_id": run_id,
            "started": self.started,
            "committed": now(),
            "deletes_hidden": int(self.session.transactions),
        }
        running.load("stamp", table_of([stamp], _STAMP))
        after = min(row["first_scored"] for row in group) - 1
        monitor_id = self.monitor["monitor_id"]
        judged: dict[int, int] = {}
        parts = published(shared_by(group).has_programs)
        with publication(self.state, monitor_id, group, self.planned, run_id) as compare_again:
            for part in parts:
                if part == parts[-1]:
                    given = {name: running.placed[step] for name, step in _JUDGED.items()}
                    judged = judge(self.state, group, given)
                    compare_again()
                self.state.append(part.removesuffix("_rows"), running.query(part))
            if self.session.transactions:  # else `gam prune` does it now and then
                for table in (*(part.removesuffix("_rows") for part in parts[:-1]), "judgement"):
                    self.state.delete_hidden(table, run_id, after, near(group))
                follow(self.state, monitor_id, group, judged)
        if not self.session.transactions:
            self._follow(group, judged, run_id)
        self._note(group, made, seen)

    def _follow(self, group: Sequence[Row], judged: Mapping[int, int], run_id: int) -> None:
        """Follow what is committed already; what a run was killed before is made up for once a day."""
        try:
            if self.is_thorough:
                judged = dict.fromkeys(judged, 0)
            follow(self.state, self.monitor["monitor_id"], group, judged)
        except BaseException:
            withdraw(self.state, run_id)
            raise

    def _check_past(self, group: Sequence[Row], running: Running) -> None:
        """Refuse to sum a window of which buckets went since the run was planned."""
        counts = running.rows("past_counts")
        there = {row["channel_id"]: row["past_buckets"] for row in counts}
        for row in group:
            wanted = min(row["first_bucket"], buckets_of(row))
            if there.get(row["channel_id"], 0) != wanted:
                raise ConflictError(GONE)

    def _cohort(self, group: Sequence[Row]) -> pa.Table:
        due = [int(self._is_due(row)) for row in group]
        planned = [self.planned.get(row["version_id"], NOTHING).newest_run for row in group]
        until = [self._until(row) for row in group]
        anew = int(self.wanted.is_anew)
        return cohort_of(group, read_until=until, recounted=due, planned_from=planned, differs=anew)

    def _until(self, row: Row) -> int:
        """Return the last instant of a channel that is read: the newest one that the look has found.

        So a row that comes while the run is at work is no further behind what was read than the lookback
        allows, and the next run reads it.
        """
        latest = self.latest.get(name_of(row))
        if latest is None:
            return int(row["read_from"]) - 1
        return latest if self.wanted.until is None else min(latest, self.wanted.until)

    def _is_due(self, row: Row) -> bool:
        """Tell whether the rows of a channel's calibration are to be counted anew.

        That records a look as well: so they are where the last one was while the clock stood ahead.
        """
        is_ahead = row["looked_at"] > self.started
        return self.wanted.everything or is_ahead or is_due(row["counted_at"], self.started)

    def _note(self, group: Sequence[Row], made: Mapping[int, Row], seen: Mapping[int, Row]) -> None:
        for row in group:
            ranged = seen.get(row["channel_id"])
            self.channels.append(
                {
                    **{key: row[key] for key in ("asset", "channel", "first_bucket", "read_from")},
                    "buckets": made.get(row["channel_id"], {}).get("new_buckets", 0),
                    "read_to": None if ranged is None else ranged["read_to"],
                    "rows_read": 0 if ranged is None else ranged["rows_read"],
                    "context_rows": 0 if ranged is None else ranged["context_rows"],
                    "context_expected": row["context_expected"],
                }
            )


_NO_RECOUNT = counts("channel_id calibration_readings")
_STAMP = counts("run_id started committed deletes_hidden")
