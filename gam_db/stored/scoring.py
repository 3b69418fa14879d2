"""Scoring what is new: the restart rule at work, group by group (state.md).

This module owns the steps of a run and its publication. Rows are appended first and one row per version
in ``gam_run`` last: that is the commit. Where an engine has transactions, all of it is one, and rows
that are now hidden go in the same.
"""

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import pyarrow as pa
from sqlglot import exp

from gam_db import look, template
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.errors import SourceError
from gam_db.method.adding import add
from gam_db.pipeline import Pipeline
from gam_db.running import Listener, Running, unheard
from gam_db.source import AnySource, parsed_condition, readings
from gam_db.stored.planning import DAY, Cohort, Row, planned, portions, resumed
from gam_db.stored.state import State, kind_of, now
from gam_db.stored.steps import PUBLISHED, plan_steps, reading_steps, scoring_steps, setting_of


@dataclass(frozen=True)
class Wanted:
    """What is asked of a run.

    Attributes:
        lookback: how far behind the newest bucket late rows are looked for, in the unit of time.
        park_after: see :mod:`gam_db.stored.planning`; None parks no channel.
        repair_from: score anew from this instant on; None for what the lookback asks for.
        until: read nothing newer; None for all there is.
        full: score everything anew.
        everything: look at parked channels, and count calibration anew, without waiting for a day.
        chosen: tells by asset and channel which channels are scored.
        limit: most readings to work on at once; None for what memory allows.
    """

    lookback: int
    park_after: int | None = None
    repair_from: int | None = None
    until: int | None = None
    full: bool = False
    everything: bool = False
    chosen: Callable[[str, str], bool] = lambda asset, channel: True
    limit: int | None = None


@dataclass
class Report:
    """What a run did, or would do.

    Attributes:
        channels: a row per channel that was read: asset, channel, first_bucket, buckets (new or written
            anew), read_from, read_to (integer time), rows_read, context_rows, context_expected.
        parked: channels that were not read.
        strangers: rows of today that belong to no calibrated channel, by (asset, channel).
        nameless: rows of today without asset or channel.
        undated: rows of the source without a time.
        ranges: of each query: earliest instant, channels, rows in the range.
    """

    channels: list[Row] = field(default_factory=list)
    parked: int = 0
    strangers: dict[tuple[str, str], int] = field(default_factory=dict)
    nameless: int = 0
    undated: int = 0
    ranges: list[Row] = field(default_factory=list)


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
    """
    run = _Run(state, source, name, wanted, on_step)
    return run.go(dry_run)


class _Run:
    def __init__(
        self, state: State, source: AnySource, name: str, wanted: Wanted, on_step: Listener
    ) -> None:
        self.state, self.session, self.wanted, self.on_step = state, state.session, wanted, on_step
        self.monitor = state.monitor(name)
        self.relation = self.session.relation(source.relation)
        columns = self.session.describe(self.relation)
        if source.where is not None:
            self.session.check_condition(
                self.relation, parsed_condition(source.where), str(source.where)
            )
        self.source = look.resolved(source, columns, self.session)
        self.kind = look.kind_of(self.source, columns, self.session)
        look.check_kind(self.kind, kind_of(self.monitor), name)
        self.started = now()
        self.report = Report()

    def go(self, dry_run: bool) -> Report:
        wanted = self.wanted
        rows = [row for row in self._plan() if wanted.chosen(row["asset"], row["channel"])]
        everything = wanted.everything or wanted.full or wanted.repair_from is not None
        plan = planned(rows, wanted.lookback, wanted.park_after, self.started, everything)
        known = {(row["asset"], row["channel"]) for row in self._known()}
        parked = list(plan.parked)
        cohorts = list(plan.cohorts)
        while cohorts:
            cohort = cohorts.pop(0)
            names = self._look(cohort)
            if cohort.everyone:
                self._note_strangers(names, known)
                back = resumed(parked, names, wanted.lookback)
                cohorts += back
                again = {row["version_id"] for group in back for row in group.channels}
                parked = [row for row in parked if row["version_id"] not in again]
            counts = {(row["asset"], row["channel"]): row["readings"] for row in names}
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
            limit = wanted.limit or self.session.rows_at_once()
            for group in portions(cohort.channels, counts, limit):
                self._score(group, cohort)
        self.report.parked = len(parked)
        self.report.undated = self._undated()
        return self.report

    def _plan(self) -> list[Row]:
        lookback = None if self.wanted.full else self.wanted.lookback
        steps = plan_steps(self.monitor["monitor_id"], lookback, self.wanted.repair_from)
        query = steps.query("plan", self.state.tables.placed())
        rows: list[Row] = self.session.fetch(query).to_pylist()
        return rows

    def _known(self) -> list[Row]:
        slots: dict[str, template.Slot] = {"monitor_id": self.monitor["monitor_id"]}
        rows: list[Row] = self.state.fetch("stored/known_channels", slots).to_pylist()
        return rows

    def _readings(self, conditions: Sequence[exp.Expr]) -> exp.Query:
        condition = exp.and_(parsed_condition(self.source.where), *conditions)
        source = dataclasses.replace(self.source, where=condition)
        engine = self.session.engine
        return readings(source, self.relation, lambda node: engine.micros_of(self.kind, node))

    def _bounds(self, cohort: Cohort, earliest: int) -> list[exp.Expr]:
        """Return the conditions of a cohort on the source's own columns, with literal bounds."""
        conditions: list[exp.Expr] = []
        if earliest > LONG_AGO:
            instant = self.session.engine.instant_of(self.kind, template.node_of(earliest))
            conditions.append(exp.GTE(this=template.column(self.source.time), expression=instant))
        if cohort.assets is not None and self.source.asset is not None:
            named = exp.cast(template.column(self.source.asset), "VARCHAR")
            texts = [template.text(asset) for asset in cohort.assets]
            conditions.append(exp.In(this=named, expressions=texts))
        return conditions

    def _look(self, cohort: Cohort) -> list[Row]:
        self.on_step("looking at the source")
        steps = Pipeline()
        steps.add("readings", self._readings(self._bounds(cohort, cohort.earliest)))
        add(steps, "source/names")
        rows: list[Row] = self.session.fetch(steps.query("names")).to_pylist()
        if not rows:
            self._refuse_nothing()
        return rows

    def _refuse_nothing(self) -> None:
        """Refuse a source that holds nothing at all; that nothing is new is no error."""
        condition = parsed_condition(self.source.where)
        probe = exp.select(exp.Literal.number(1)).from_(self.relation).where(condition).limit(1)
        if not self.session.fetch(probe).num_rows:
            raise SourceError(look.NO_ROW)

    def _undated(self) -> int:
        steps = Pipeline()
        absent = exp.Is(this=template.column(self.source.time), expression=exp.null())
        steps.add("readings", self._readings([absent]))
        add(steps, "stored/undated")
        return int(self.session.fetch(steps.query("undated"))["undated"][0].as_py())

    def _note_strangers(self, names: Sequence[Row], known: set[tuple[str, str]]) -> None:
        for row in names:
            if row["asset"] is None or row["channel"] is None:
                self.report.nameless += row["readings"] + row["without_time"]
            elif (row["asset"], row["channel"]) not in known and row["readings"]:
                self.report.strangers[row["asset"], row["channel"]] = row["readings"]

    def _score(self, group: Sequence[Row], cohort: Cohort) -> None:
        """Score a group of channels of one setting, and publish it."""
        due = [self.wanted.everything or self.started - row["counted_at"] >= DAY for row in group]
        steps = scoring_steps(setting_of(group[0]), self.kind)
        running = Running(self.session, steps, self.state.tables.placed(), self.on_step)
        earliest = min(row["read_from"] for row in group)
        try:
            running.load("cohort", _control(group, due, self.wanted.until))
            if any(due):
                # Before *identified* is kept, which holds the rows of the range only.
                everything = reading_steps(self._readings([]), is_ranged=False)
                running.put("recount", everything.query("recount", running.placed))
            else:
                running.load("recount", _NO_RECOUNT)
            rows = self._readings(self._bounds(cohort, earliest))
            running.put("identified", reading_steps(rows).query("identified", running.placed))
            for part in PUBLISHED:
                running.prepare(part)
            made = {row["channel_id"]: row for row in running.table("new_counts").to_pylist()}
            seen = {row["channel_id"]: row for row in running.table("seen").to_pylist()}
            self.on_step("writing")
            run_id = self.state.next_run()
            stamp = {"run_id": run_id, "started": self.started, "committed": now()}
            running.load("stamp", pa.Table.from_pylist([stamp]))
            after = min(row["first_scored"] for row in group) - 1
            with self.session.transaction():
                for part in PUBLISHED:
                    self.state.append(part.removesuffix("_rows"), running.query(part))
                for table in ("bucket", "novel"):
                    self.state.delete_hidden(table, run_id, after)
        finally:
            running.forget()
        self._note(group, made, seen)

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


_CONTROL = pa.schema(
    [
        *(
            (name, pa.int64())
            for name in (
                *("channel_id", "version_id", "support_id", "first_bucket", "first_scored"),
                *("read_from", "read_until", "context_expected", "recounted"),
            )
        ),
        *((name, pa.string()) for name in ("asset", "channel")),
        *((name, pa.float64()) for name in ("lo", "hi")),
    ]
)

_NO_RECOUNT = pa.table(
    {name: pa.array([], pa.int64()) for name in ("channel_id", "calibration_readings")}
)


def _control(group: Sequence[Row], recounted: Sequence[bool], until: int | None) -> pa.Table:
    latest = FAR_AHEAD if until is None else until
    rows = [
        {**row, "recounted": int(due), "read_until": latest}
        for row, due in zip(group, recounted, strict=True)
    ]
    return pa.Table.from_pylist(rows, schema=_CONTROL)
