"""Scoring what is new: the restart rule at work, group by group (state.md).

This module owns the steps of a run and its publication. Rows are appended first and one row per version
in ``gam_run`` last: that is the commit. Where an engine has transactions, all of it is one, and rows
that are now hidden go in the same. It counts only if nobody else wrote meanwhile
(:mod:`gam_db.stored.scoring.publishing`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import LONG_AGO, shown_instant
from gam_db.columns import counts, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.errors import ConflictError, ParameterError, SourceError
from gam_db.method.bits import Bits
from gam_db.reading import look
from gam_db.settings.source import AnySource
from gam_db.stored.alarms.episodes import follow
from gam_db.stored.alarms.explaining import explain
from gam_db.stored.alarms.judging import judge
from gam_db.stored.checking.proving import verify, verify_daily
from gam_db.stored.planning import Cohort, Row, assets_of, is_due, others, planned, portions, resumed
from gam_db.stored.planning.reading import (
    Reader,
    cohort_of,
    last_times,
    near,
    plan_rows,
    searched_plan_rows,
)
from gam_db.stored.planning.steps import (
    PUBLISHED,
    can_trust,
    method_of,
    reading_steps,
    scoring_steps,
    setting_of,
)
from gam_db.stored.scoring import turning
from gam_db.stored.scoring.growing import read_ranges, unmoved
from gam_db.stored.scoring.ordered import is_given
from gam_db.stored.scoring.publishing import GONE, NOTHING, Snapshots, publication, snapshots, withdraw
from gam_db.stored.scoring.report import Report, Wanted
from gam_db.stored.scoring.unplaced import keep_unplaced, note_unknown, undated
from gam_db.stored.state import State, kind_of, now
from gam_db.study.naming import counted
from gam_db.study.running import UNSORTED, Listener, Running, unheard

#: With fewer rows, looking for repeated instants first is cheaper than scoring some channels twice.
TRUSTED_FROM = 200_000

#: Supports are kept as bits where they take no more of them than so many times the rows to be scored.
BITS_OF_A_ROW = 512

#: Steps of a run that its judgements are made of.
_JUDGED = ("cohort", "stamp", "new_buckets")


def score(
    state: State,
    source: AnySource,
    name: str,
    wanted: Wanted,
    dry_run: bool = False,
    on_step: Listener = unheard,
) -> Report:
    """Bring the stored buckets of a monitor up to date.

    Args:
        state: the state tables, in a session that can write.
        source: where the telemetry lies.
        name: of the monitor.
        wanted: what is asked.
        dry_run: look at the source and write nothing.
        on_step: called with what is done next.

    Raises:
        UserError: there is no such monitor, or the source cannot be used; groups of channels that were
            scored before stay scored.
        ConflictError: another process changed what is stored meanwhile; likewise.
    """
    run = _Run(state, source, name, wanted, on_step)
    return run.go(dry_run)


class _Run:
    def __init__(
        self, state: State, source: AnySource, name: str, wanted: Wanted, on_step: Listener
    ) -> None:
        self.state, self.session, self.wanted, self.on_step = state, state.session, wanted, on_step
        self.monitor = state.monitor(name)
        self.reader = Reader(state.session, source, kind_of(self.monitor), name)
        self.started = now()
        self.planned: Snapshots = {}
        self.sums, self.ranges = False, dict[int, list[Row]]()
        self.latest: dict[tuple[str, str], int | None] = {}
        self.is_thorough = wanted.everything
        self.report = Report()

    def go(self, dry_run: bool) -> Report:
        wanted = self.wanted
        known = {(row["asset"], row["channel"]) for row in self._known()}
        if known and not any(wanted.chosen(*channel) for channel in known):
            raise ParameterError(
                f"No channel of the monitor {self.monitor['name']!r} matches the patterns of asset and "
                "channel; * stands for any text, ? for one character."
            )
        if not dry_run:
            self.is_thorough |= verify_daily(self.state, self.monitor)
        rows = self._plan()
        everything = wanted.everything or wanted.full or wanted.repair_from is not None
        plan = planned(rows, wanted.lookback, wanted.park_after, self.started, everything)
        parked = list(plan.parked)
        cohorts = list(plan.cohorts)
        while cohorts:
            cohort = cohorts.pop(0)
            names = self._look(cohort)
            if cohort.everyone:
                note_unknown(self.report, names, known)
                back = resumed(parked, names, wanted.lookback)
                cohorts += back
                again = {row["version_id"] for group in back for row in group.channels}
                parked = [row for row in parked if row["version_id"] not in again]
            cohort, moved = self._apart(cohort)
            cohorts += moved
            counts = {(row["asset"], row["channel"]): row["readings"] for row in names}
            self.latest |= {(row["asset"], row["channel"]): row["latest"] for row in names}
            members = [(row["asset"], row["channel"]) for row in cohort.channels]
            if members:
                self.report.ranges.append(
                    {
                        "earliest": cohort.earliest,
                        "channels": len(members),
                        "rows": sum(counts.get(member, 0) for member in members),
                    }
                )
            if dry_run:
                continue
            self._verify(cohort)
            limit = wanted.limit or self.session.rows_at_once()
            whole = [] if wanted.limit else portions(cohort.channels, counts, UNSORTED * limit)
            scored = {
                row["version_id"]
                for group in whole
                for row in self._score_whole(group, cohort, counts, limit)
            }
            rest = [row for row in cohort.channels if row["version_id"] not in scored]
            for group in portions(rest, counts, limit):
                read = _rows(group, counts)
                trusts = read >= TRUSTED_FROM and can_trust(setting_of(group[0]), self.reader.kind)
                left = self._score(group, cohort, read, True) if trusts else group
                self._score(left, cohort, read, False)
        self.report.parked = len(parked)
        self.report.undated = undated(self.session, self.reader)
        if not dry_run:
            keep_unplaced(self.state, self.monitor["monitor_id"], self.started, self.report)
            most = wanted.limit or self.session.rows_at_once()
            explain(self.state, self.reader, self.monitor["monitor_id"], rows, most)
        return self.report

    def _plan(self) -> list[Row]:
        monitor_id = self.monitor["monitor_id"]
        # Before the plan: what changes between the two is noticed then.
        self.planned = snapshots(self.state)
        lookback = None if self.wanted.full else self.wanted.lookback
        begin, until = self.wanted.repair_from, self.wanted.until
        self.sums = bool(lookback) and begin is None
        rows = [] if lookback is None else plan_rows(self.state, monitor_id, 0)
        if until is not None and any(row["first_scored"] > until for row in rows):
            # What lies after the end does not stay.
            begin = until + 1 if begin is None else min(begin, until + 1)
        if lookback is None or begin is not None:
            self.sums = False
            rows = searched_plan_rows(self.state, monitor_id, lookback, begin)
        if self.sums:
            self.ranges = read_ranges(self.state, self.wanted.lookback)
        # What is settled is so for a run that adds up what it does not read again.
        chosen = [
            {**row, "lookback": 0, "late_by": self.wanted.lookback}
            for row in rows
            if self.wanted.chosen(row["asset"], row["channel"])
        ]
        if self.wanted.repair_from is not None:
            ends = last_times(self.state, monitor_id)
            stored = [ends[row["version_id"]] for row in chosen if row["version_id"] in ends]
            self._check_begin(self.wanted.repair_from, max(stored, default=None))
        return chosen

    def _check_begin(self, begin: int, newest: int | None) -> None:
        """Refuse to score anew from an instant on where nothing is stored."""
        kind, end = self.reader.kind, self.wanted.until
        refused = f"Scoring anew cannot begin at {shown_instant(begin, kind)}"
        if end is not None and begin > end:
            raise ParameterError(f"{refused}: that is after its end, {shown_instant(end, kind)}.")
        if newest is None:
            raise ParameterError(f"{refused}: nothing of these channels is scored yet; leave it out.")
        if begin > newest:
            raise ParameterError(
                f"{refused}: the newest stored bucket ends at {shown_instant(newest, kind)}; leave "
                "it out to score what is new."
            )

    def _known(self) -> list[Row]:
        slots: dict[str, template.Slot] = {"monitor_id": self.monitor["monitor_id"]}
        return self.state.rows("stored/state/known_channels", slots)

    def _look(self, cohort: Cohort) -> list[Row]:
        self.on_step("looking at the source")
        steps = reading_steps(self.reader.readings(cohort.assets, cohort.earliest))
        is_first = cohort.channels and all(row["read_until"] == LONG_AGO for row in cohort.channels)
        # All of a source is read, which may be stored channel by channel.
        found = counted(self.session, steps) if is_first and self.session.engine.bits else None
        rows = self.session.rows(steps.query("names")) if found is None else found.to_pylist()
        if not rows and self.reader.is_empty():
            raise SourceError(look.NO_ROW)
        return rows

    def _apart(self, cohort: Cohort) -> tuple[Cohort, list[Cohort]]:
        """Take out the channels that are to be read again as far as rows may come late."""
        asked = [
            row
            for row in cohort.channels
            if self.sums and row["lookback"] < row["late_by"] and row["read_until"] != LONG_AGO
        ]
        if any(row["version_id"] in self.ranges for row in asked):
            self.on_step("adding up what was read")
        counted = self.wanted.append_only
        same = unmoved(self.state, self.reader, self.ranges, asked, cohort.assets, counted)
        moved = {row["version_id"] for row in asked if row["channel_id"] not in same}
        if not moved:
            return cohort, []
        self.report.moved += len(moved) if counted else 0
        lookback = self.wanted.lookback
        usual = plan_rows(self.state, self.monitor["monitor_id"], lookback, moved)
        again = [{**row, "lookback": lookback, "late_by": lookback} for row in usual]
        left = tuple(row for row in cohort.channels if row["version_id"] not in moved)
        return replace(cohort, channels=left), others(again, lookback)

    def _verify(self, cohort: Cohort) -> None:
        """Refuse to score by versions that are no longer what calibration froze."""
        with self.session.lent(cohort_of(cohort.channels, read_until=0, planned_from=0)) as wanted:
            verify(self.state, wanted, cohort.channels)

    def _bits(self, group: Sequence[Row], read: int) -> Bits | None:
        """Return how the engine keeps supports as bits; None where they take much beside the rows."""
        bits, setting = self.session.engine.bits, setting_of(group[0])
        cells, supports = setting.radix**setting.m, len({row["support_id"] for row in group})
        is_little = cells * supports <= BITS_OF_A_ROW * read
        return bits if bits is not None and is_little and bits.serve(cells, supports) else None

    def _score_whole(
        self, group: list[Row], cohort: Cohort, counts: dict[tuple[str, str], int], limit: int
    ) -> list[Row]:
        """Score channels with more readings than can be sorted at once, if nothing needs sorting.

        Returns:
            Those that were scored.
        """
        read = _rows(group, counts)
        if read <= limit or not can_trust(setting_of(group[0]), self.reader.kind):
            return []
        left = {row["version_id"] for row in self._score(group, cohort, read, True, as_stored=True)}
        return [row for row in group if row["version_id"] not in left]

    def _score(
        self,
        group: list[Row],
        cohort: Cohort,
        read: int,
        trusting: bool,
        as_stored: bool = False,
    ) -> list[Row]:
        """Score channels of one setting, in four stages; return those that did not deserve trust.

        Where nothing may be sorted, as they are stored, that can be all of them.
        """
        if not group:
            return []
        setting = setting_of(group[0])
        bits = self._bits(group, read)
        steps = scoring_steps(setting, self.reader.kind, trusting, bits, self.wanted.append_only)
        with Running(self.session, steps, self.state.tables.placed(), self.on_step) as running:
            # A part of a cohort is found by name, or each part would read the rows of all.
            assets = cohort.assets if len(group) == len(cohort.channels) else assets_of(group)
            self._recount(running, group, assets)
            if not (trusting and bits and self._in_order(running, group, assets, bits)):
                if as_stored:
                    return group
                since = min(row["read_from"] for row in group)
                rows = reading_steps(self.reader.readings(assets, since))
                running.put("identified", rows.query("identified", running.placed))
            repeating = self._repeating(running, group) if trusting else []
            left_out = {row["channel_id"] for row in repeating}
            group = [row for row in group if row["channel_id"] not in left_out]
            if group:
                self._count(running, group)
                self._publish(running, group)
        return repeating

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

    def _in_order(
        self, running: Running, group: Sequence[Row], assets: Sequence[str] | None, bits: Bits
    ) -> bool:
        """Give the vectors of channels as they are stored, if they are in order or take turns."""
        asked = [{**row, "read_until": self._until(row)} for row in group]
        method = method_of(setting_of(group[0]), self.reader.kind)
        told = running, self.reader, assets, asked
        return is_given(*told, method.settings[0], bits) or turning.is_given(*told, method, bits)

    def _repeating(self, running: Running, group: Sequence[Row]) -> list[Row]:
        """Second stage: return the channels that did not deserve trust, and leave them out."""
        running.keep("visited")
        found = {row["channel_id"] for row in running.rows("repeated_instants")}
        rest = [row for row in group if row["channel_id"] not in found]
        if found and rest:
            running.load("cohort", self._cohort(rest))
        return [row for row in group if row["channel_id"] in found]

    def _count(self, running: Running, group: Sequence[Row]) -> None:
        """Third stage: make the rows that are to be published, on from the buckets that stay."""
        running.put("past_buckets", self._past(group, running))
        self._check_past(group, running)
        for part in PUBLISHED:
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
        with publication(self.state, monitor_id, group, self.planned, run_id) as compare_again:
            for part in PUBLISHED:
                if part == PUBLISHED[-1]:
                    given = {name: running.placed[name] for name in _JUDGED}
                    judged = judge(self.state, group, given)
                    compare_again()
                self.state.append(part.removesuffix("_rows"), running.query(part))
            if self.session.transactions:  # else `gam compact` does it now and then
                for table in ("bucket", "novel", "judgement"):
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

    def _past(self, group: Sequence[Row], running: Running) -> exp.Query:
        """Return the query of the buckets that stay and are needed for the new ones' windows."""
        setting = setting_of(group[0])
        buckets = setting.window_length // setting.stride
        past = filled("stored/scoring/past_buckets", {"buckets": buckets, "near": near(group, buckets)})
        place(past, running.placed)
        return past

    def _check_past(self, group: Sequence[Row], running: Running) -> None:
        """Refuse to sum a window of which buckets went since the run was planned."""
        counts = running.rows("past_counts")
        there = {row["channel_id"]: row["past_buckets"] for row in counts}
        for row in group:
            wanted = min(row["first_bucket"], row["window_length"] // row["stride"])
            if there.get(row["channel_id"], 0) != wanted:
                raise ConflictError(GONE)

    def _cohort(self, group: Sequence[Row]) -> pa.Table:
        due = [int(self._is_due(row)) for row in group]
        planned = [self.planned.get(row["version_id"], NOTHING).newest_run for row in group]
        until = [self._until(row) for row in group]
        return cohort_of(group, read_until=until, recounted=due, planned_from=planned)

    def _until(self, row: Row) -> int:
        """Return the last instant of a channel that is read: the newest one that the look has found.

        What was read before is added up after that look. So whatever comes later must be no further
        behind than the lookback allows from there, which is how far the next run adds up.
        """
        latest = self.latest.get((row["asset"], row["channel"]))
        if latest is None:
            return int(row["read_from"]) - 1
        return latest if self.wanted.until is None else min(latest, self.wanted.until)

    def _is_due(self, row: Row) -> bool:
        """Tell whether the rows of a channel's calibration are to be counted anew."""
        return self.wanted.everything or is_due(row["counted_at"], self.started)

    def _note(self, group: Sequence[Row], made: Mapping[int, Row], seen: Mapping[int, Row]) -> None:
        for row in group:
            ranged = seen.get(row["channel_id"])
            self.report.channels.append(
                {
                    **{key: row[key] for key in ("asset", "channel", "first_bucket", "read_from")},
                    "buckets": made.get(row["channel_id"], {}).get("new_buckets", 0),
                    "read_to": None if ranged is None else ranged["read_to"],
                    "rows_read": 0 if ranged is None else ranged["rows_read"],
                    "context_rows": 0 if ranged is None else ranged["context_rows"],
                    "context_expected": row["context_expected"],
                }
            )


def _rows(group: Sequence[Row], counts: Mapping[tuple[str, str], int]) -> int:
    """Return how many readings of some channels the look has found."""
    return sum(counts.get((row["asset"], row["channel"]), 0) for row in group)


_NO_RECOUNT = counts("channel_id calibration_readings")
_STAMP = counts("run_id started committed deletes_hidden")
