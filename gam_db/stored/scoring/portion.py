"""Scoring channels of one shape: the lists of a run, executed over the rows that it has read.

A run appends its rows first and one row per version to ``gam_state_run`` last: that is the commit. If an
engine has transactions, all this is one, and deletes rows that are now hidden. The commit counts only if
no other process wrote meanwhile (:mod:`gam_db.stored.scoring.publishing`).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from sqlglot import exp

from gam_db.clock import FAR_AHEAD
from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.composing.pipeline import filled, place
from gam_db.composing.plan import Plan
from gam_db.method.bits import Bits
from gam_db.stored.alarms.episodes import follow, with_pending
from gam_db.stored.alarms.judging import buckets_of, judge
from gam_db.stored.checking.proving import verify
from gam_db.stored.planning import Cohort, Row, assets_of, is_due
from gam_db.stored.planning.published import former, former_slots
from gam_db.stored.planning.reading import Reader, among, execute, identified, near
from gam_db.stored.planning.setting import Setting, shape_of, shared_by
from gam_db.stored.planning.steps import past_slots, reading_steps
from gam_db.stored.scoring.lists import Shape, counting, hidden_tables, publishing
from gam_db.stored.scoring.publishing import look_again, unplanned, withdraw
from gam_db.stored.scoring.report import Wanted
from gam_db.stored.state import State, now
from gam_db.study.running import Listener, Running

#: Supports are kept as bits where they take no more of them than so many times the rows to be scored.
BITS_OF_A_ROW = 512

#: What judgements are made of: what a run writes.
_JUDGED = {"cohort": "changed", "new_buckets": "written"}


@dataclass
class Scoring:
    """How the portions of one run are scored.

    Attributes:
        state, reader, monitor, wanted, on_step: of the run.
        started: when it began, in microseconds.
        tables: those of the run: *plan*, *names* and *planned_runs*.
        planned: how many rows *plan* has.
        is_thorough: whether all episodes are followed anew.
        channels: what is told of each channel that was scored.
    """

    state: State
    reader: Reader
    monitor: Row
    wanted: Wanted
    on_step: Listener
    started: int
    tables: dict[str, exp.Table] = field(default_factory=dict)
    planned: int = 0
    is_thorough: bool = False
    channels: list[Row] = field(default_factory=list)

    def score(self, group: list[Row], cohort: Cohort, read: int) -> None:
        """Score channels of one shape, all or a part of a cohort, of which so many rows are read."""
        by_column = self.takes_columns(group[0])
        setting, due = shared_by(group, by_column), any(self._is_due(row) for row in group)
        # Of what lies within the lookback hardly anything has changed; only that is written anew.
        compared = not self.wanted.is_anew and any(row["restarts"] for row in group)
        shape = Shape(setting, self.reader.kind, self._bits(group, read), compared, due)
        tables = {**self.state.tables.nodes(), **self.tables}
        plan = counting(shape)
        with Running(self.state.session, plan.steps, tables, self.on_step) as running:
            # A part of a cohort is found by name, or each part would read the rows of all.
            assets = cohort.assets if len(group) == len(cohort.channels) else assets_of(group)
            queries = self._queries(running, group, shape, assets)
            scored = execute(running, plan, queries, setting.programs)["scored"]
            lists = publishing(shape, self.state.session.transactions)
            self._publish(running, group, scored, *lists)

    def takes_columns(self, row: Row) -> bool:
        """Tell whether tau, window and stride of a channel are read as columns."""
        return self.state.session.engine.delays_by_column and row["programs"] is None

    def shape(self, row: Row) -> Setting:
        """Return what channels must share to be scored together."""
        return shape_of(row, self.takes_columns(row))

    def _bits(self, group: Sequence[Row], read: int) -> Bits | None:
        """Return how the engine keeps supports as bits; None where they take much beside the rows."""
        bits, setting = self.state.session.engine.bits, shared_by(group)
        cells, supports = setting.radix**setting.m, len({row["support_id"] for row in group})
        is_little = cells * supports <= BITS_OF_A_ROW * read
        is_plain = is_little and not setting.has_programs
        return bits if bits is not None and is_plain and bits.serve(cells, supports) else None

    def _queries(
        self, running: Running, group: list[Row], shape: Shape, assets: Sequence[str] | None
    ) -> dict[str, exp.Query]:
        """Keep the cohort, and return the queries that differ from run to run."""
        buckets, condition = max(map(buckets_of, group)), near(group)
        running.put("cohort", self._cohort(group, shape.recounted))
        verify(self.state, running.tables["cohort"], group)
        since = min(row["read_from"] for row in group)
        queries: dict[str, exp.Query] = {}
        if shape.recounted:  # of other readings than those that are scored
            queries["recount"] = self._recount(running, assets)
        queries |= {
            "identified": identified(running, self.reader.readings(assets, since)),
            "past_buckets": filled(
                "stored/scoring/past_buckets", past_slots(shape.setting, near(group, buckets))
            ),
            "past_missing": filled("stored/scoring/past_missing"),
        }
        programs = shape.setting.has_programs
        for table, step in former(programs).items() if shape.compared else ():
            slots = former_slots(table, condition, condition, programs)
            queries[step] = filled(f"stored/scoring/{step}", slots)
        return queries

    def _cohort(self, group: Sequence[Row], recounted: bool) -> exp.Query:
        """Return the query of the channels of a group, among those of the plan."""
        wanted = self.wanted
        slots: dict[str, template.Slot] = {
            "lookback": wanted.lookback,
            "until": FAR_AHEAD if wanted.until is None else wanted.until,
            "recounted": int(recounted),
            "differs": int(wanted.is_anew),
            "chosen": among(group, self.planned),
        }
        query = filled("stored/scoring/cohort", slots)
        place(query, self.tables)
        return query

    def _recount(self, running: Running, assets: Sequence[str] | None) -> exp.Query:
        """Return the query that counts the rows of calibration anew."""
        (edges,) = running.rows("calibration_range")
        if edges["earliest"] is None:
            return filled("stored/scoring/no_recount")
        healthy = self.reader.readings(assets, edges["earliest"], edges["latest"])
        return reading_steps(healthy, is_ranged=False).query("recount", running.tables)

    def _is_due(self, row: Row) -> bool:
        """Tell whether the rows of a channel's calibration are to be counted anew.

        That records a look as well: so they are where the last one was while the clock stood ahead.
        """
        is_ahead = row["looked_at"] > self.started
        return self.wanted.everything or is_ahead or is_due(row["counted_at"], self.started)

    def _publish(
        self, running: Running, group: list[Row], scored: list[Row], rows: Plan, commit: Plan
    ) -> None:
        """Append the rows, and commit them unless the state has changed meanwhile."""
        self.on_step("writing")
        state, transactions = self.state, self.state.session.transactions
        run_id = state.next_run()
        stamp = {"run_id": run_id, "started": self.started, "committed": now()}
        deletes = {"deletes_hidden": int(transactions)}
        running.put("stamp", filled("stored/scoring/stamp", stamp | deletes))
        queries = {"unplanned": unplanned(state, group, scored)}
        after = min(row["first_scored"] for row in group) - 1
        for table in hidden_tables(shared_by(group).has_programs):
            queries[f"hidden_{table}"] = state.hidden(table, run_id, after, near(group))
        tables = {name: running.tables.get(step, running.tables[name]) for name, step in _JUDGED.items()}
        with state.session.transaction():
            state.lock(self.monitor["monitor_id"])
            running.execute(rows, queries, state.tables.table)
            judged = judge(state, group, tables | {"stamp": running.tables["stamp"]})
            judged = with_pending(state, group, judged, min(row["planned_from"] for row in scored))
            running.execute(commit, queries, state.tables.table)
            if transactions:
                follow(state, self.monitor["monitor_id"], group, judged)
        if not transactions:
            look_again(running, state, group, run_id)
            self._follow(group, judged, run_id)
        columns = [name for name in scored[0] if name != "planned_from"]
        by_name = sorted(scored, key=name_of)
        self.channels += [{name: row[name] for name in columns} for row in by_name]

    def _follow(self, group: Sequence[Row], judged: Mapping[int, int], run_id: int) -> None:
        """Follow committed runs; once a day, catch up on what a killed run did not do."""
        try:
            if self.is_thorough:
                judged = dict.fromkeys(judged, 0)
            follow(self.state, self.monitor["monitor_id"], group, judged)
        except BaseException:
            withdraw(self.state, run_id)
            raise
