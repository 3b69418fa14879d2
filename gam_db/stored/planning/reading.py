"""Reading the source for the stored form: in the range of a cohort, and no further.

This module owns the conditions on the source's own columns, and the table that tells the steps of a run
which channels are read from where on.
"""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO, TimeKind
from gam_db.columns import COUNT, SHARE, WORD, columns, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.composing.plan import Kind, Plan, Statement
from gam_db.engines.session import Session
from gam_db.errors import wrong
from gam_db.method.programs import gathered
from gam_db.reading.ahead import Clock
from gam_db.reading.preparing import prepared
from gam_db.reading.undated import Undated, undated
from gam_db.settings.source import AnySource, Programs, parsed_condition, under
from gam_db.stored.planning import Row
from gam_db.stored.planning.steps import DAY, plan_steps, reading_steps, searched_plan_steps
from gam_db.stored.state import State, first_run_at, now
from gam_db.study.running import TWICE, RepeatedError, Running, once_more

#: Keys that a condition lists; of more it says in which range they are.
_LISTED = 1000

#: Tables that stay where a list is executed once more.
_STAYING = ("cohort", "recount", "identified")

#: How far back lie the runs that are looked at first, in microseconds: there are more with the years.
RECENT = 31 * DAY


class Reader:
    """The source of a monitor, checked.

    Args:
        session: an open session.
        source: where the telemetry lies.
        expected: how the source of the monitor tells time.
        name: of the monitor, for messages.

    Raises:
        SourceError: there is no such relation, a column is missing or of another type, or time is told
            otherwise than when the monitor was made.
    """

    def __init__(self, session: Session, source: AnySource, expected: TimeKind, name: str) -> None:
        self._session, self._engine, self._name = session, session.engine, name
        read = prepared(session, source)
        self._source, self._relation, self.kind = read.rows, read.relation, read.kind
        self.programs = read.programs
        self.clock = Clock.read(session, source, read.kind)
        if self.kind is not expected:
            meant = expected.value
            raise wrong("kind_of_monitor_differs", kind=self.kind.value, monitor=name, meant=meant)

    def readings(
        self, assets: Sequence[str] | None = None, earliest: int = LONG_AGO, latest: int = FAR_AHEAD
    ) -> exp.Query:
        """Return the step *readings*, with literal bounds where there are any; no assets are all."""
        latest = min(latest, self.clock.latest)
        return self._engine.readings(self._of(assets), self._relation, self.kind, earliest, latest)

    def ahead(self) -> exp.Query:
        """Return the readings that are later than now; the bound serves where the engine can use it."""
        first = min(self.clock.latest, FAR_AHEAD - 1) + 1
        return self._engine.readings(self._source, self._relation, self.kind, first)

    def validity(self, earliest: int = LONG_AGO) -> exp.Query:
        """Return the same from an instant on, the reading being 1 or 0: whether it is valid."""
        arguments = self._source, self._relation, self.kind
        return self._engine.readings(*arguments, earliest, validity=True)

    @property
    def has_validity(self) -> bool:
        """Tell whether there is a condition under which readings count."""
        return self._source.valid_when is not None

    def _of(self, assets: Sequence[str] | None) -> AnySource:
        """Return the source with the rows of some assets; None are all."""
        if assets is not None and self._source.asset is not None:
            named = exp.cast(template.column(self._source.asset), "VARCHAR")
            texts = [template.text(asset) for asset in assets]
            return under(self._source, exp.In(this=named, expressions=texts))
        return self._source

    def with_programs(self, versions: Iterable[Row]) -> list[Row]:
        """Return versions, each with ``programs``: the column of this source, where states are of these.

        Raises:
            SourceError: the source names no such column, and one of them has.
        """
        rows = list(versions)
        columns = {row["program_column"] for row in rows} - {None}
        if columns and self.programs is None:
            raise wrong("program_of_monitor", monitor=self._name, column=min(columns))
        return [
            {**row, "programs": None if row["program_column"] is None else self.programs} for row in rows
        ]

    def is_empty(self) -> bool:
        """Tell whether the source has no rows at all, new or old."""
        condition = parsed_condition(self._source.where)
        probe = exp.select(exp.Literal.number(1)).from_(self._relation.copy()).where(condition).limit(1)
        return not self._session.rows(probe)

    def raw(self, asset: str, channel: str, earliest: int, latest: int) -> str:
        """Return the SQL that shows the rows of a channel in a range of integer time, in order."""
        source = self._source
        conditions: list[exp.Expr] = []
        names = {source.asset: asset, getattr(source, "channel", None): channel}
        for name in (name for name in names if name is not None):
            column = exp.cast(template.column(name), "VARCHAR")
            conditions.append(exp.EQ(this=column, expression=template.text(names[name])))
        time = template.column(source.time)
        conditions += self._engine.near(source, self.kind, earliest, latest)
        if source.where is not None:
            conditions.insert(0, exp.paren(parsed_condition(source.where)))
        rows = exp.select("*").from_(self._relation.copy()).where(*conditions)
        return self._engine.text(rows.order_by(time.copy()), pretty=True)

    def undated(self) -> Undated:
        """Return how many rows of the source tell no time, and why."""
        return undated(self._session, self._source, self._relation, self.kind, among_all=False)


def plan_rows(running: Running, monitor_id: int, lookback: int) -> list[Row]:
    """Keep *plan*, from where on each version must be read, as its last run that read anything recorded.

    That is a run of late, or all of them are looked at. Where it allowed for rows less late than
    ``lookback``, buckets have to be looked at, and are.
    """
    rows = _planned(running, plan_steps(monitor_id, lookback, recent_run()))
    if not all(row["restarts"] for row in rows):
        rows = _planned(running, plan_steps(monitor_id, lookback))
    if any(row["read_until"] != LONG_AGO and not row["restarts"] for row in rows):
        rows = searched_plan_rows(running, monitor_id, lookback)
    return rows


def recent_run() -> int:
    """Return the id of the first recent run; a plan reads older runs only if these are not enough."""
    return first_run_at(now() - RECENT)


def searched_plan_rows(
    running: Running, monitor_id: int, lookback: int | None, repair_from: int | None = None
) -> list[Row]:
    """Keep the same, by a look at all buckets; see :func:`.steps.searched_plan_steps`."""
    return _planned(running, searched_plan_steps(monitor_id, lookback, repair_from))


def _planned(running: Running, steps: Pipeline) -> list[Row]:
    running.steps = steps
    if "plan" in running.tables:
        running.drop("plan")
    running.put("plan", steps.query("plan", running.tables))
    return running.rows("plan")


def last_times(state: State, monitor_id: int) -> dict[int, int]:
    """Return the end of the stored buckets of each version that has one."""
    steps = searched_plan_steps(monitor_id, None, None)
    rows = state.session.rows(steps.query("newest", state.tables.nodes()))
    return {row["version_id"]: row["newest_time"] for row in rows}


def near(rows: Sequence[Row], buckets_before: int = 0) -> exp.Expr:
    """Return a condition on *bucket*, in literals, that holds for all that a run touches of a group.

    A join alone would do; but not every engine finds its rows by an index then. So many buckets before
    the first new one of each channel are touched, too.
    """
    first = min(row["first_bucket"] for row in rows) - buckets_before
    number = exp.column("bucket_no", table="bucket")
    version = exp.column("version_id", table="bucket")
    among = listed(version, (row["version_id"] for row in rows))
    return exp.and_(among, exp.GTE(this=number, expression=template.node_of(max(first, 0))))


def listed(column: exp.Expr, ids: Iterable[int]) -> exp.Expr:
    """Return the condition that a column is one of some keys; of many, that it is in their range."""
    keys = sorted(ids)
    if len(keys) > _LISTED:
        ends = [exp.Literal.number(key) for key in (keys[0], keys[-1])]
        return exp.Between(this=column, low=ends[0], high=ends[1])
    return exp.In(this=column, expressions=[exp.Literal.number(key) for key in keys])


def among(rows: Sequence[Row], planned: int) -> exp.Expr:
    """Return the condition on *frozen* that it is one of some rows of the plan, which has so many."""
    if len(rows) in (0, planned):
        return exp.true()
    versions = [exp.Literal.number(row["version_id"]) for row in rows]
    return exp.In(this=exp.column("version_id", table="frozen"), expressions=versions)


def identified(running: Running, rows: exp.Query) -> exp.Query:
    """Return the query of the readings of a cohort, which is a table; rows are the step *readings*."""
    steps = reading_steps(rows)
    if running.session.engine.reads_first:
        running.put("readings", rows)
    return steps.query("identified", running.tables)


def vector_statements(steps: Pipeline) -> list[Statement]:
    """Return the statements that make the scored vectors, and verify that no instant occurs twice."""
    if "repeated_instants" not in steps.steps:
        return [Statement("visited")]
    verify = Statement("repeated_instants", Kind.VERIFY, failure=lambda _: RepeatedError(TWICE))
    return [Statement("visited"), verify]


def make_vectors(running: Running, programs: Programs | None) -> None:
    """Keep *visited*, the scored vectors in groups, of the steps of a run."""
    plan = Plan.of(running.steps, vector_statements(running.steps), running.tables)
    unverified = tuple(statement for statement in plan.statements if statement.kind is not Kind.VERIFY)
    execute(running, plan, {}, programs, Plan(plan.steps, unverified))


def execute(
    running: Running,
    plan: Plan,
    queries: Mapping[str, exp.Query],
    programs: Programs | None,
    again: Plan | None = None,
) -> dict[str, list[Row]]:
    """Execute a list with such statements; where an instant occurs twice, *identified* is collapsed.

    Then the list is executed again, or another one.
    """

    def collapse() -> None:
        running.forget(but=_STAYING)
        running.make("stored/scoring/repeats", {}, "timeline")
        slots: dict[str, template.Slot] = {"gathered": gathered("reading", programs)}
        running.make("stored/scoring/collapsed", slots, "identified")

    repeated = partial(running.execute, again or plan, queries)
    return once_more(partial(running.execute, plan, queries), collapse, repeated)


def cohort_of(rows: Sequence[Row], **columns: Any) -> pa.Table:
    """Return the step *cohort*: the channels of a group, by their rows of the plan.

    What differs from the plan (read_until, recounted, settled) is one value for all, or one for each.
    """
    channels = []
    for number, row in enumerate(rows):
        row_columns = {
            name: value[number] if isinstance(value, list) else value for name, value in columns.items()
        }
        length, stride = row.get("window_length"), row.get("stride")
        buckets = None if length is None or stride is None else length // stride
        usual = {"buckets": buckets, "recounted": 0, "settled": 0, "novel_from": 0, "differs": 0}
        last_read = row.get("read_until", LONG_AGO)
        channels.append(
            {
                "lookback": 0,
                "bins": None,
                "max_gap": None,
                **row,
                **usual,
                "last_read": last_read,
                **row_columns,
            }
        )
    return table_of(channels, _COHORT)


_COHORT = columns(
    (COUNT, "channel_id version_id support_id first_bucket first_scored read_from read_until"),
    (COUNT, "context_expected calibration_end oldest_bucket recounted settled planned_from novel_from"),
    (COUNT, "lookback last_read differs bins max_gap tau stride buckets"),
    (WORD, "asset channel"),
    (SHARE, "lo hi"),
)

#: Columns of *plan* that *cohort* reads.
PLAN = columns(
    (COUNT, "channel_id version_id support_id tau bins window_length stride max_gap calibration_end"),
    (COUNT, "first_bucket first_scored read_from read_until context_expected oldest_bucket"),
    (WORD, "asset channel"),
    (SHARE, "lo hi"),
)
