"""Scoring new rows by the restart rule (state.md).

This module owns the rows that a run reads, and their portions (:mod:`gam_db.stored.scoring.portion`).
"""

from dataclasses import replace

from gam_db.clock import FAR_AHEAD, LONG_AGO, shown_instant
from gam_db.columns import name_of, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import ParameterError, SourceError
from gam_db.method.adding import add
from gam_db.reading import look
from gam_db.reading.ahead import rows_ahead
from gam_db.settings.source import AnySource
from gam_db.stored.alarms.explaining import explain
from gam_db.stored.checking.proving import verify_daily
from gam_db.stored.planning import PARKED, Cohort, Row, cohorts, portions, resumed, rows_of, unread
from gam_db.stored.planning.gone import staying_rows
from gam_db.stored.planning.reading import (
    PLAN,
    Reader,
    among,
    last_times,
    plan_rows,
    searched_plan_rows,
)
from gam_db.stored.planning.steps import DAY, reading_steps
from gam_db.stored.scoring.portion import Scoring
from gam_db.stored.scoring.publishing import planned_runs
from gam_db.stored.scoring.report import Report, Wanted
from gam_db.stored.state import State, kind_of, now
from gam_db.study.naming import counted
from gam_db.study.running import Listener, Running, unheard

#: Tables of a run that its portions read.
_OF_RUN = ("plan", "names", "planned_runs")


class Run:
    """A run that brings the stored buckets of a monitor up to date; ``report`` holds its result.

    Args:
        state: the state tables, in a session that can write.
        source: where the telemetry lies.
        name: of the monitor.
        wanted: the request.
        on_step: called with what is done next.

    Raises:
        UserError: there is no such monitor, or the source cannot be used.
    """

    def __init__(
        self, state: State, source: AnySource, name: str, wanted: Wanted, on_step: Listener = unheard
    ) -> None:
        self.state, self.session, self.wanted, self.on_step = state, state.session, wanted, on_step
        self.monitor = state.monitor(name)
        self.reader = Reader(state.session, source, kind_of(self.monitor), name)
        self.started = now()
        self.rows: list[Row] = []
        self.running = Running(state.session, Pipeline(), state.tables.nodes(), on_step)
        work = state, self.reader, self.monitor, wanted, on_step
        self.scoring = Scoring(*work, self.started, is_thorough=wanted.everything)
        self.report = Report(clock=self.reader.clock)

    def go(self, dry_run: bool = False) -> Report:
        """Score the wanted channels; a ``dry_run`` reads the source and writes nothing.

        Raises:
            UserError: the source cannot be used; groups of channels that were scored before stay scored.
            ConflictError: another process changed what is stored meanwhile; likewise.
        """
        with self.running:
            return self._go(dry_run)

    def _go(self, dry_run: bool) -> Report:
        wanted, running = self.wanted, self.running
        channels = {name_of(row) for row in self._channel_rows()}
        if channels and not any(wanted.chosen(*channel) for channel in channels):
            raise ParameterError(
                f"No channel of the monitor {self.monitor['name']!r} matches the patterns of asset and "
                "channel; * stands for any text, ? for one character."
            )
        if not dry_run:
            self.scoring.is_thorough |= verify_daily(self.state, self.monitor)
        self.rows = rows = self._plan()
        if (parked := unread(rows)) is not None:
            self.rows = rows = resumed(rows, self._look(parked))
        plan = cohorts(rows)
        if not wanted.confirmed and wanted.is_anew:
            for cohort in plan:
                self._refuse_loss(cohort)
        for cohort in plan:
            names = self._look(cohort)
            if cohort.everyone:
                self.report.note_unknown(names, channels)
            counts = {name_of(row): row["readings"] for row in names}
            if not wanted.confirmed:
                cohort = self._keeping(cohort, names)
            if members := len(cohort.channels):
                row_count = rows_of(cohort.channels, counts)
                ranged = {"earliest": cohort.earliest, "channels": members, "rows": row_count}
                self.report.ranges.append(ranged)
            if dry_run:
                continue
            self.scoring.tables = {name: running.tables[name] for name in _OF_RUN}
            limit = wanted.limit or self.session.rows_at_once()
            for group in portions(cohort.channels, counts, limit, self.scoring.shape):
                self.scoring.score(group, cohort, rows_of(group, counts))
        self.report.channels = self.scoring.channels
        self.report.parked = sum(row["cohort"] == PARKED for row in rows)
        self.report.ahead = rows_ahead(self.session, self.reader.ahead(), self.reader.clock.latest)
        self.report.note_undated(self.reader.undated())
        self._note_validity()
        if not dry_run:
            self.report.keep_unplaced(self.state, self.monitor, self.started)
            most = wanted.limit or self.session.rows_at_once()
            explain(self.state, self.reader, self.monitor["monitor_id"], rows, most)
        return self.report

    def _note_validity(self) -> None:
        """Count the rows read that do not meet the condition on readings."""
        if not self.reader.has_validity or not self.report.ranges:
            return
        steps = Pipeline()
        steps.add("readings", self.reader.validity(min(row["earliest"] for row in self.report.ranges)))
        add(steps, "source/validity")
        rows = self.session.rows(steps.query("validity"))
        self.report.held = sum(row["readings"] for row in rows)
        self.report.invalid = sum(row["invalid"] for row in rows)

    def _plan(self) -> list[Row]:
        monitor_id = self.monitor["monitor_id"]
        # Before the plan: what changes between the two is noticed then.
        running = self.running
        running.put("planned_runs", planned_runs().query("newest_runs", running.tables))
        lookback = None if self.wanted.full else self.wanted.lookback
        begin, until = self.wanted.repair_from, self.wanted.until
        rows = [] if lookback is None else plan_rows(running, monitor_id, lookback)
        if until is not None and any(row["first_scored"] > until for row in rows):
            # What lies after the end does not stay.
            begin = until + 1 if begin is None else min(begin, until + 1)
        if lookback is None or begin is not None:
            rows = searched_plan_rows(running, monitor_id, lookback, begin)
        self.scoring.planned = len(rows)
        allowed = {"lookback": self.wanted.lookback}
        readable = self.reader.with_programs(rows)
        chosen = [{**row, **allowed} for row in readable if self.wanted.chosen(*name_of(row))]
        later = [] if until is None else [row for row in chosen if row["read_from"] > until]
        if self.wanted.repair_from is not None or later:
            ends = last_times(self.state, monitor_id)
            if self.wanted.repair_from is not None:
                stored = [ends[row["version_id"]] for row in chosen if row["version_id"] in ends]
                self._check_begin(self.wanted.repair_from, max(stored, default=None))
            self._check_end([row for row in later if row["version_id"] in ends])
        return self._with_cohorts(chosen)

    def _with_cohorts(self, rows: list[Row]) -> list[Row]:
        """Return rows of *plan* with the columns of ``cohorts.sql``."""
        wanted, after = self.wanted, self.wanted.park_after
        slots: dict[str, template.Slot] = {
            "chosen": among(rows, self.scoring.planned),
            "lookback": wanted.lookback,
            "silence": None if after is None else min(wanted.lookback + after, FAR_AHEAD),
            "latest": self.reader.clock.latest,
            "started": self.started,
            "day": DAY,
            "everything": int(wanted.everything or wanted.is_anew),
            "long_ago": LONG_AGO,
        }
        read = {
            row["version_id"]: row for row in self.running.query_rows("stored/scoring/cohorts", slots)
        }
        return [row | read[row["version_id"]] for row in rows]

    def _check_begin(self, begin: int, newest: int | None) -> None:
        """Refuse to score anew from an instant on without stored buckets."""
        kind, end = self.reader.kind, self.wanted.until
        refused = f"Scoring anew cannot begin at {shown_instant(begin, kind)}"
        if end is not None and begin > end:
            raise ParameterError(f"{refused}: that is after its end, {shown_instant(end, kind)}.")
        if newest is None:
            raise ParameterError(f"{refused}: these channels have no scores yet; leave it out.")
        if begin > newest:
            raise ParameterError(
                f"{refused}: the newest stored bucket ends at {shown_instant(newest, kind)}; leave "
                "it out to score new rows."
            )

    def _check_end(self, later: list[Row]) -> None:
        """Refuse to score up to an instant before all that is read of a channel that was scored."""
        end = self.wanted.until
        if end is None or not later:
            return
        kind, first = self.reader.kind, min(later, key=name_of)
        others = f" (and of {len(later) - 1:,} more)" if len(later) > 1 else ""
        begin = shown_instant(first["read_from"], kind)
        raise ParameterError(
            f"Scoring cannot end at {shown_instant(end, kind)}: it reads the channel {first['asset']} "
            f"{first['channel']}{others} only from {begin} on, so stored buckets before would "
            "stay. Give "
            "a later end, or choose other channels by their names."
        )

    def _channel_rows(self) -> list[Row]:
        slots: dict[str, template.Slot] = {"monitor_id": self.monitor["monitor_id"]}
        return self.state.rows("stored/state/monitor_channels", slots)

    def _look(self, cohort: Cohort) -> list[Row]:
        """Keep *names*, what the source holds by name in the range of a cohort, and return its rows."""
        self.on_step("reading the source")
        running = self.running
        running.steps = reading_steps(self.reader.readings(cohort.assets, cohort.earliest))
        is_first = cohort.channels and all(row["read_until"] == LONG_AGO for row in cohort.channels)
        if "names" in running.tables:
            running.drop("names")
        # All of a source is read, which may be stored channel by channel.
        names = counted(running) if is_first and self.session.engine.bits else None
        if names is None:
            running.keep("names")
        else:
            running.load("names", names)
        rows = running.rows("names")
        if not rows and self.reader.is_empty():
            raise SourceError(look.NO_ROW)
        return rows

    def _keeping(self, cohort: Cohort, names: list[Row]) -> Cohort:
        """Keep stored buckets whose rows have gone from the source, all before its oldest row."""
        other = self._staying(cohort, names)
        if not other:
            return cohort
        self.report.gone |= {name_of(row): row["read_from"] for row in other.values()}
        self.rows = [other.get(row["version_id"], row) for row in self.rows]
        self.running.load("plan", table_of(self.rows, PLAN))
        self.scoring.planned = len(self.rows)
        channels = [other.get(row["version_id"], row) for row in cohort.channels]
        return replace(cohort, channels=tuple(channels))

    def _staying(self, cohort: Cohort, names: list[Row]) -> dict[int, Row]:
        monitor_id = self.monitor["monitor_id"]
        return staying_rows(self.state, self.reader, monitor_id, cohort.channels, names)

    def _refuse_loss(self, cohort: Cohort) -> None:
        """Refuse to score anew what the source no longer holds: it would be lost."""
        other = self._staying(cohort, self._look(cohort))
        lost = [row for row in cohort.channels if _is_lost(row, other.get(row["version_id"]))]
        if not lost:
            return
        first = min(lost, key=name_of)
        count = sum(other[row["version_id"]]["first_bucket"] - row["first_bucket"] for row in lost)
        begin = shown_instant(other[first["version_id"]]["first_scored"], self.reader.kind)
        others = f" (and of {len(lost) - 1:,} more)" if len(lost) > 1 else ""
        raise ParameterError(
            f"Scoring anew from there would remove {count:,} stored buckets whose rows are gone from "
            f"the source: the channel {first['asset']} {first['channel']}{others} can be scored again "
            f"only from {begin} on. Give that instant (--from), or confirm the loss (--confirm)."
        )


def _is_lost(row: Row, other: Row | None) -> bool:
    """Tell whether a version would begin before what can be made again of it."""
    return other is not None and other["first_bucket"] > row["first_bucket"]
