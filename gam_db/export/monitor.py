"""Scheduled runs as SQL: the work of `gam score` on a monitor, for the command line of its database.

A run of the script reads what is new, and appends buckets, novel cells, judgements and its record, by
the lists of :mod:`gam_db.stored.scoring`. What a run of Python decides between its statements (which
channels are read, from where on, what is due, the number of the run) is decided by statements of
``sql/stored/monitor``. Episodes get their numbers by the next `gam score`.

This module owns what such a script holds, and in which order.
"""

from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, place
from gam_db.composing.plan import Kind, Plan
from gam_db.engines.base import DAY, deletion
from gam_db.errors import EngineError, ParameterError, StateError
from gam_db.export.reading import Reading
from gam_db.export.statements import Script, command, commented, tidied
from gam_db.method.adding import add
from gam_db.method.programs import gathered
from gam_db.reading.ahead import tolerance
from gam_db.reading.preparing import prepared
from gam_db.settings.source import is_file
from gam_db.stored import lengths
from gam_db.stored.alarms.judging import buckets_of, judging_steps
from gam_db.stored.checking.proving import matching_steps
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning import Row
from gam_db.stored.planning.published import former, former_slots
from gam_db.stored.planning.reading import Reader
from gam_db.stored.planning.setting import Setting, shape_of, shared_by
from gam_db.stored.scoring.lists import CHANGED, Shape, counting, hidden_tables, publishing
from gam_db.stored.scoring.publishing import planned_runs
from gam_db.stored.sources import repeat_of
from gam_db.stored.state import kind_of, locking

DAMAGED = (
    "What calibration froze was changed or damaged since; nothing is scored by it. Put the tables back "
    "from a copy of the database, or learn anew by gam calibrate --again"
)


def rendered(monitor: Monitor) -> str:
    """Return the script of one scheduled run of a monitor.

    Raises:
        UserError: its database cannot run it, its source cannot be read so, or nothing is calibrated.
    """
    session, state = monitor.session, monitor.state
    if not session.engine.failing:
        raise EngineError(
            f"A run on {session.engine.title} needs Python (gam score): on this engine a script "
            "cannot undo its writes when another run was faster."
        )
    row = state.monitor(monitor.name)
    run = _RunScript(monitor, row)
    if not run.lists:
        raise StateError(f"No channel of the monitor {monitor.name!r} is calibrated (gam calibrate).")
    return run.text()


class _RunScript:
    """The script of a monitor, by its row."""

    def __init__(self, monitor: Monitor, row: Row) -> None:
        self.monitor, self.monitor_id = monitor, row["monitor_id"]
        session, self.engine = monitor.session, monitor.session.engine
        source = monitor.source
        self.kind = kind_of(row)
        self.lookback = lengths.lookback(monitor.lookback, self.kind, repeat_of(row["source"]))
        if not isinstance(source.relation, (str, tuple, list)) or is_file(source.relation):
            raise ParameterError(
                "The source of this monitor is not a table or view of its database, so a script cannot "
                "read it; use Python (gam score)."
            )
        reader = Reader(session, source, self.kind, monitor.name)  # which refuses another kind of time
        self.read = prepared(session, source)
        active = monitor.state.rows("stored/state/active", {"monitor_id": self.monitor_id})
        ranged = [version for version in active if version["lo"] is not None]
        self.lists = self._listed(reader.with_programs(ranged))
        self.script = Script(self.engine, monitor.tables.nodes())
        #: Of each list its shape and channels, what its tables are called by, and its tables.
        self.scored: list[tuple[Shape, Sequence[Row], str, dict[str, exp.Table]]] = []
        silent = lengths.park_after(monitor.park_after, self.kind)
        allowed = tolerance(source, self.kind)
        about = self.read, self.kind, self.monitor_id, self.lookback, silent, allowed
        self.reading = Reading(self.script, *about)
        self.head = [
            f"One run of the monitor {monitor.name} on {self.engine.title}: it scores what came since.",
            "It takes the rights of gam score, and a session of its own. Where it ends with an error,",
            "nothing of it counts: run it again.",
        ]

    def text(self) -> str:
        """Return it."""
        begin = [*self.engine.client, self.engine.beginning().rstrip()]
        script = self.script
        for statement in self.engine.working:
            script.add(statement)
        self.reading.plan(exp.or_(*(self._is_of(setting) for setting, _ in self.lists)))
        self.reading.read_source()
        self.reading.count_calibration()
        self._choose()
        for number, (setting, versions) in enumerate(self.lists, start=1):
            self._count(setting, versions, f"_{number}" if len(self.lists) > 1 else "")
        for statement in self.engine.resting:
            script.add(statement)
        self._publish()
        lines = [line for line in begin if line]
        head = "".join(map(commented, self.head)) + "".join(f"{line}\n" for line in lines)
        return f"{head}\n{script.text()}"

    def _listed(self, versions: Sequence[Row]) -> list[tuple[Setting, list[Row]]]:
        """Return what channels share that one part of the script is for, each with its channels."""
        groups: dict[str, list[Row]] = {}
        for version in versions:
            by_column = self.engine.delays_by_column and version["programs"] is None
            groups.setdefault(repr(shape_of(version, by_column)), []).append(version)
        lists = []
        for _, group in sorted(groups.items()):
            lengths_of = {
                (version["tau"], version["window_length"], version["stride"]) for version in group
            }
            lists.append((shared_by(group, len(lengths_of) > 1), group))
        return lists

    def _is_of(self, setting: Setting) -> exp.Expr:
        """Return the condition on frozen that a part of the script is for a version."""

        def column(name: str) -> exp.Expr:
            return exp.column(name, table="frozen")

        least = setting.tau
        conditions: list[exp.Expr] = [column("m").eq(setting.m), column("bins") <= setting.bins]
        if setting.by_column:
            conditions.append(column("tau") <= least)
        else:
            conditions += [column(name).eq(getattr(setting, name)) for name in _LENGTHS]
        for name, is_there in (
            ("max_gap", setting.max_gap is not None),
            ("score_from", setting.has_start),
            ("program_column", setting.has_programs),
        ):
            nothing: exp.Expr = column(name).is_(exp.null())
            conditions.append(exp.not_(nothing) if is_there else nothing)
        if setting.has_programs:
            conditions.append(column("bins").eq(setting.bins))
        still = column("still_after")
        conditions.append(
            still.is_(exp.null()) if setting.still_after is None else still.eq(setting.still_after)
        )
        return exp.and_(*conditions)

    def _choose(self) -> None:
        """Add the list of scored versions, and verify it."""
        script, steps = self.script, Pipeline()
        add(steps, "stored/monitor/latest_rows")
        slots: dict[str, template.Slot] = {
            "lookback": self.lookback,
            "until": FAR_AHEAD,
            "recounted": exp.column("recounted", table="frozen"),
            "differs": 0,
            "chosen": exp.true(),
        }
        add(steps, "stored/scoring/cohort", slots, tables={"names": "latest_rows"})
        plan = script.tables["plan"]
        script.tables["plan"] = script.tables["counted"]
        script.step(steps, "cohort")
        script.tables["plan"] = plan
        gathering = gathered("reading", self.read.programs)
        add(steps, "stored/monitor/samples", {"gathered": gathering})
        script.step(steps, "samples")
        add(steps, "stored/monitor/timeline")
        script.step(steps, "timeline")
        about = {"monitor_id": self.monitor_id, "day": DAY}
        add(steps, "stored/monitor/proof_due", about)
        script.step(steps, "proof_due")
        add(steps, "stored/monitor/verified")
        script.step(steps, "verified")
        script.tables["wanted"] = script.tables["verified"]
        script.verify(matching_steps().query("mismatched", script.tables, commented=True), DAMAGED)

    def _count(self, setting: Setting, versions: Sequence[Row], suffix: str) -> None:
        """Count the buckets of the channels of one shape, and the rows to write."""
        script = self.script
        shape = Shape(setting, self.kind, None, compared=True, recounted=True)
        plan, of_run = counting(shape), dict(script.tables)
        # Of the steps of the run alone: others of the same name are the list's.
        shared = {name: table for name, table in of_run.items() if name in _SHARED}
        script.tables = dict(self.monitor.tables.nodes()) | shared
        queries = {"past_missing": filled("stored/scoring/past_missing")}
        for table, step in former(setting.has_programs).items():
            slots = former_slots(table, exp.true(), exp.true(), setting.has_programs)
            queries[step] = filled(f"stored/scoring/{step}", slots)
        if suffix:
            members = Pipeline()
            add(members, "stored/monitor/members", {"listed": self._is_of(setting)})
            script.step(members, "members", f"cohort{suffix}")
            script.tables["cohort"] = script.tables.pop("members")
        else:
            script.tables["cohort"] = of_run["cohort"]
        script.tables["identified"] = of_run["samples"]
        self._execute(plan, queries, suffix)
        self.scored.append((shape, versions, suffix, dict(script.tables)))
        script.tables = of_run

    def _execute(self, plan: Plan, queries: Mapping[str, exp.Query], suffix: str) -> None:
        """Add the statements of a plan, but tables that are there already, and what repeats."""
        script = self.script
        for name, kind, into, failure, _ in plan.statements:
            is_there = kind is Kind.TABLE and name in script.tables
            if kind is Kind.ANSWER or is_there or name == "repeated_instants":
                continue
            if name in queries:
                query, comment = queries[name].copy(), template.load(f"stored/scoring/{name}").comment
            else:
                query = plan.steps.query(name, script.tables, commented=True)
                comment = plan.steps.steps[name].definition.comment
            if kind is Kind.TABLE:
                script.keep(name, query, comment, f"{name}{suffix}")
            elif kind is Kind.VERIFY:
                assert failure is not None
                script.verify(query, str(failure([])).rstrip("."))
            else:
                script.append(plan.steps, name, into)

    def _publish(self) -> None:
        """Append the counts, as one transaction, unless another process wrote meanwhile."""
        script, tables = self.script, self.monitor.tables
        script.begin("Publish, unless somebody else did so since.")
        for statement in locking(tables, self.monitor_id):
            script.add(statement)
        near = planned_runs()
        script.verify(near.query("unplanned", script.tables, commented=True), CHANGED.rstrip("."))
        steps = Pipeline()
        slots = {"now": self.engine.clock(), "monitor_id": self.monitor_id}
        add(steps, "stored/monitor/stamp", slots)
        stamp = steps.query("stamp", script.tables, commented=True)
        assert isinstance(stamp, exp.Select)
        for table in script.verified:
            stamp.join(table.copy(), join_type="cross", copy=False)
        script.keep("stamp", stamp, steps.steps["stamp"].definition.comment)
        for shape, versions, suffix, tables_of_list in self.scored:
            of_run = script.tables
            script.tables = tables_of_list | {"stamp": of_run["stamp"]}
            rows, commit = publishing(shape, True)
            self._append(rows)
            self._judge(versions, suffix)
            self._append(commit)
            script.tables = of_run
        self._clear()
        script.add(command("COMMIT"))

    def _append(self, plan: Plan) -> None:
        for name, kind, into, _, _ in plan.statements:
            if kind is Kind.APPEND:
                self.script.append(plan.steps, name, into)

    def _judge(self, versions: Sequence[Row], suffix: str) -> None:
        """Append the judgements of the new buckets."""
        script, of_list = self.script, dict(self.script.tables)
        ratios = sorted({buckets_of(version) for version in versions})
        for buckets in ratios:
            called = suffix + (f"_of_{buckets}" if len(ratios) > 1 else "")
            script.tables["cohort"] = of_list["changed"]
            script.tables["new_buckets"] = of_list["written"]
            if len(ratios) > 1:
                part = Pipeline()
                add(part, "stored/monitor/window_changed", {"buckets": buckets})
                script.tables["cohort"] = of_list["cohort"]
                script.step(part, "window_changed", f"changed{called}")
                script.tables["cohort"] = script.tables["window_changed"]
            steps = Pipeline()
            add(steps, "stored/alarms/judged_until", {"near": exp.true()})
            script.step(steps, "judged_until", f"judged_until{called}")
            judging = judging_steps(buckets, exp.true(), exp.true())
            for name in ("judged_buckets", "judged_windows"):
                script.step(judging, name, f"{name}{called}")
            script.append(judging, "judgement_rows", "judgement")
            script.tables = dict(of_list)

    def _clear(self) -> None:
        """Delete what this run hides, and record what else it saw."""
        script, state = self.script, self.monitor.state
        run_id = filled("stored/monitor/run_id")
        place(run_id, script.tables)
        has_programs = any(setting.has_programs for setting, _ in self.lists)
        for table in hidden_tables(has_programs):
            slots: dict[str, template.Slot] = {
                "run_id": exp.Subquery(this=run_id.copy()),
                "after": LONG_AGO,
                "near": exp.true(),
            }
            appended = {"appended": state.tables.table(table)}
            hidden = state.query("stored/state/superseded", slots, appended)
            target = state.tables.table(table)
            comment = f"Rows of {target.name} that this run has replaced."
            script.add(deletion(target, hidden.named_selects, tidied(hidden)), comment)
        steps = Pipeline()
        about: dict[str, template.Slot] = {"monitor_id": self.monitor_id}
        add(steps, "stored/monitor/proof_rows", about)
        script.append(steps, "proof_rows", "proof")
        add(steps, "stored/monitor/unplaced_rows", about)
        comment = "What it could place nowhere, and that it ran."
        script.append(steps, "unplaced_rows", "unplaced", comment)
        for name in ("unknown_rows", "ahead_rows"):
            if name in script.tables:
                add(steps, f"stored/monitor/{name}", about)
                script.append(steps, name, "left_out")
        before = {"monitor": template.text(self.monitor.name)}
        expired = state.query("stored/pruning/expired_left_out", before)
        comment = "Of what runs left out only the newest counts."
        left_out = state.tables.table("left_out")
        script.add(deletion(left_out, expired.named_selects, expired), comment)


#: What the lists of a run read of the steps before them.
_SHARED = ("cohort", "counted", "samples", "timeline", "recount")

_LENGTHS = ("tau", "window_length", "stride")
