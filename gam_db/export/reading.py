"""What a scheduled run reads of its source, as statements: which channels, and from where on.

This module owns what a run of Python decides before it scores (:mod:`gam_db.stored.planning`).
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO, SECOND, TimeKind
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, union_of
from gam_db.engines.base import DAY, Engine
from gam_db.export.statements import Script
from gam_db.method.adding import add
from gam_db.method.programs import identified_slots
from gam_db.reading.preparing import Prepared
from gam_db.reading.undated import counting as counting_undated
from gam_db.settings.source import clock_of, under
from gam_db.stored.scoring.publishing import planned_runs

#: What every calendar time can tell lies between these; and what one in nanoseconds can.
_CALENDAR, _NANOSECONDS = (-62_135_000_000 * SECOND, 253_402_000_000 * SECOND), 9_000_000_000 * SECOND

UNLISTED = (
    "A channel was calibrated with settings that this script was not made for. Print it again: "
    "gam compile --form monitor"
)

_AMONG = {
    1: exp.column("part_no", table="part").eq(1),
    2: exp.GT(this=exp.column("part_no", table="part"), expression=exp.Literal.number(1)),
}

_READINGS = "Readings of the channels that are read, each row of the source once."


@dataclass
class Reading:
    """The part of a script that reads.

    Attributes:
        script: what it adds to.
        read: the source.
        kind: of its time.
        monitor_id: of the monitor.
        lookback: how late a row may come, in the unit of time.
        silent: after how long a channel is parked, likewise; None for never.
        tolerance: how far a row may be ahead of the clock, in microseconds; None for any.
    """

    script: Script
    read: Prepared
    kind: TimeKind
    monitor_id: int
    lookback: int
    silent: int | None
    tolerance: int | None
    steps: Pipeline = field(default_factory=Pipeline)

    def __post_init__(self) -> None:
        self.earliest, self.latest = _CALENDAR
        if self.kind.is_counter:
            self.earliest, self.latest = LONG_AGO, FAR_AHEAD
        elif self.kind.furthest < FAR_AHEAD:
            self.earliest, self.latest = -_NANOSECONDS, _NANOSECONDS

    @property
    def engine(self) -> Engine:
        """The engine that the script is for."""
        return self.script.engine

    def plan(self, listed: exp.Expr) -> None:
        """Tell from where on each version is to be read, and which of them are read now.

        Listed is the condition on *frozen* that some part of the script is for a version.
        """
        script, lookback = self.script, self.lookback
        latest: exp.Expr | int = FAR_AHEAD
        if self.tolerance is not None:
            latest = self.engine.clock() + template.node_of(self.tolerance)
        slots: dict[str, template.Slot] = {"now": self.engine.clock(), "latest": latest}
        steps = Pipeline()
        add(steps, "stored/monitor/clock", slots)
        script.step(steps, "clock")
        newest = planned_runs()
        script.step(newest, "newest_runs", "planned_runs")
        script.tables["planned_runs"] = script.tables.pop("newest_runs")
        steps = self.steps = Pipeline()
        add(steps, "stored/state/active", {"monitor_id": self.monitor_id})
        script.step(steps, "active")
        add(steps, "stored/scoring/recorded", {"at_least": lookback, "since": 0})
        add(steps, "stored/scoring/last_reads", {"long_ago": LONG_AGO, "since": 0})
        script.step(steps, "recorded")
        script.step(steps, "last_reads")
        add(steps, "stored/monitor/unrecorded", {"long_ago": LONG_AGO})
        of_late = {"active": "unrecorded"}
        add(steps, "stored/state/newest", name="newest_unrecorded", tables=of_late)
        searched = {"lookback": lookback, "repair_from": FAR_AHEAD, "pruned_stay": 1}
        tables = {"newest": "newest_unrecorded"}
        add(steps, "stored/scoring/restart", searched, "searched", tables)
        steps.add("restart", union_of(steps, ["recorded", "searched"]), "Restart: of each version.")
        script.step(steps, "restart")
        add(steps, "stored/scoring/plan", {"long_ago": LONG_AGO})
        script.step(steps, "plan")
        script.verify(filled("stored/monitor/unlisted", {"listed": listed}), UNLISTED)
        since = template.node_of(LONG_AGO)
        if self.silent is not None:
            since = exp.column("newest") - (lookback + self.silent)
        slots = {"lookback": lookback, "since": since, "day": DAY, "long_ago": LONG_AGO}
        add(steps, "stored/monitor/parted", slots)
        script.step(steps, "parted")

    def read_source(self) -> None:
        """Read the rows that may matter, each once, and list the rows that have left the source."""
        script, steps = self.script, self.steps
        if self.silent is not None:
            rows = self._rows(self._edge("stored/monitor/look_from"))
            steps.add("looked_at", rows, "Readings: where parked channels may have sent again.")
            add(steps, "stored/monitor/resumed", tables={"readings": "looked_at"})
            script.step(steps, "resumed")
        else:
            nobody = exp.select("version_id").from_("parted").where(exp.column("part_no") < 0)
            steps.add("resumed", nobody, "Resumed: no channel is parked.")
        add(steps, "stored/monitor/wanted")
        script.step(steps, "wanted")
        for number, among in _AMONG.items():
            rows = self._rows(self._edge("stored/monitor/read_from", {"among": among}))
            comment = template.load("source/readings").comment
            steps.add(f"readings_{number}", rows, comment)
            add(steps, "stored/monitor/part_channels", {"among": among}, f"channels_{number}")
            read = exp.column("time", table="reading") >= exp.column("read_from", table="named")
            identified = identified_slots(read, self.read.programs is not None)
            tables = {"readings": f"readings_{number}", "channels": f"channels_{number}"}
            add(steps, "source/identified", identified, f"identified_{number}", tables)
        steps.add("readings", union_of(steps, ["identified_1", "identified_2"]), _READINGS)
        script.step(steps, "readings")
        add(steps, "stored/monitor/late")
        script.step(steps, "late")
        rows = self._rows(self._edge("stored/monitor/late_from"), is_after=False)
        steps.add("rows_before", rows, "Readings: before those that were read.")
        add(steps, "stored/monitor/older", tables={"readings": "rows_before"})
        add(steps, "stored/monitor/oldest_rows")
        script.step(steps, "oldest_rows")
        add(steps, "stored/monitor/staying")
        add(steps, "stored/state/newest", name="newest_staying", tables={"active": "staying"})
        add(steps, "stored/scoring/whole", tables={"newest": "newest_staying"})
        script.step(steps, "whole")
        slots, tables = {"long_ago": LONG_AGO}, {"restart": "whole"}
        add(steps, "stored/scoring/plan", slots, "whole_plan", tables)
        add(steps, "stored/monitor/begun", {"long_ago": LONG_AGO})
        script.step(steps, "begun")
        add(steps, "stored/monitor/counted", {"day": DAY})
        script.step(steps, "counted")
        self._count_unplaced()

    def _count_unplaced(self) -> None:
        """Count the rows that belong to no channel, tell no time, or are later than now."""
        script, steps, read = self.script, Pipeline(), self.read
        rows = self._rows(self._edge("stored/monitor/names_from"))
        steps.add("readings_of_names", rows, template.load("source/readings").comment)
        add(steps, "source/names", tables={"readings": "readings_of_names"})
        script.step(steps, "names")
        missing = counting_undated(self.engine, read.rows, read.relation, self.kind, among_all=False)
        steps.add("undated", missing, template.load("source/undated").comment)
        about = {"monitor_id": self.monitor_id}
        add(steps, "stored/monitor/unplaced_rows", about)
        script.step(steps, "unplaced_rows")
        add(steps, "stored/monitor/unknown_rows", about)
        script.step(steps, "unknown_rows")
        if self.tolerance is not None:
            latest = exp.Subquery(this=filled("stored/monitor/latest"))
            steps.add("rows_ahead", self._rows(latest, is_counted=False), "Readings: later than now.")
            add(steps, "source/ahead", {"latest": latest}, tables={"readings": "rows_ahead"})
            add(steps, "stored/monitor/ahead_rows", about)
            script.step(steps, "ahead_rows")
        del script.tables["names"]

    def count_calibration(self) -> None:
        """Count the rows of calibration where that is due."""
        script, steps = self.script, Pipeline()
        add(steps, "stored/monitor/recounted")
        script.step(steps, "recounted")
        tables = {"cohort": "recounted"}
        add(steps, "stored/scoring/calibration", tables=tables)
        script.step(steps, "calibration", "recounted_calibration")
        rows = self._rows(
            self._edge("stored/monitor/calibration_from"),
            until=self._edge("stored/monitor/calibration_to"),
        )
        steps.add("calibration_readings", rows, template.load("source/readings").comment)
        identified = identified_slots(exp.true(), self.read.programs is not None)
        tables = {"readings": "calibration_readings", "channels": "recounted"}
        add(steps, "source/identified", identified, tables=tables)
        add(steps, "stored/scoring/recount")
        script.step(steps, "recount")

    def _rows(
        self,
        time: exp.Expr,
        is_after: bool = True,
        until: exp.Expr | None = None,
        is_counted: bool = True,
    ) -> exp.Query:
        """Return the step *readings*, of rows that are not before, or are before, an instant.

        Where they are counted, those that are later than now are left out.
        """
        source = self.read.rows
        column = template.column(source.time)
        ends = [(time, is_after), *([] if until is None else [(until, False)])]
        conditions: list[exp.Expr] = []
        for end, after in ends:
            if clock_of(source) is not None:  # local times: a day further holds them in any zone
                end = exp.paren(end - DAY if after else end + DAY)
            conditions += self.engine.beside(self.kind, column, end, after)
        latest = None
        if self.tolerance is not None and is_counted:
            latest = exp.Subquery(this=filled("stored/monitor/latest"))
        source = under(source, *conditions)
        return self.engine.readings(source, self.read.relation, self.kind, until=latest)

    def _edge(self, path: str, slots: Mapping[str, template.Slot] | None = None) -> exp.Expr:
        """Return an instant that a file gives, of those that the source can tell, as an expression."""
        ends = {"earliest": self.earliest, "latest": self.latest}
        return exp.Subquery(this=filled(path, {**ends, **(slots or {})}))
