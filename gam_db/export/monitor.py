"""Scheduled runs as SQL: what `gam score` does of a monitor, for the command line of its database.

A run of the script reads what is new, and appends buckets, novel cells, judgements and its record, by
the lists of :mod:`gam_db.stored.scoring`. What a run of Python decides between its statements (which
channels are read, from where on, what is due, the number of the run) is decided by statements of
``sql/stored/monitor``. Episodes get their numbers by the next `gam score`.

This module owns what such a script holds, and in which order.
"""

import textwrap
from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO, SECOND
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, place, union_of
from gam_db.composing.plan import Kind, Plan, insertion
from gam_db.engines.base import DAY, deletion, temporary
from gam_db.engines.session import Session
from gam_db.errors import EngineError, ParameterError, StateError
from gam_db.method.adding import add
from gam_db.method.programs import gathered, identified_slots
from gam_db.reading.ahead import tolerance
from gam_db.reading.preparing import prepared
from gam_db.reading.undated import counting as counting_undated
from gam_db.settings.source import clock_of, is_file, under
from gam_db.stored import lengths
from gam_db.stored.alarms.judging import buckets_of, judging_steps
from gam_db.stored.checking.proving import matching_steps
from gam_db.stored.monitor import Monitor
from gam_db.stored.planning import Row
from gam_db.stored.planning.published import former, former_slots
from gam_db.stored.planning.setting import Setting, shape_of, shared_by
from gam_db.stored.scoring.lists import CHANGED, Shape, counting, hidden_tables, publishing
from gam_db.stored.scoring.publishing import planned_runs
from gam_db.stored.sources import repeat_of
from gam_db.stored.state import kind_of, locking

#: What every calendar time can tell lies between these; and what one in nanoseconds can.
_CALENDAR, _NANOSECONDS = (-62_135_000_000 * SECOND, 253_402_000_000 * SECOND), 9_000_000_000 * SECOND

DAMAGED = (
    "What calibration froze was changed or damaged since; nothing is scored by it. Put the tables back "
    "from a copy of the database, or learn anew by gam calibrate --again"
)

UNLISTED = (
    "A channel was calibrated with settings that this script was not made for. Print it again: "
    "gam compile --form monitor"
)

_AMONG = {
    1: exp.column("part_no", table="part").eq(1),
    2: exp.GT(this=exp.column("part_no", table="part"), expression=exp.Literal.number(1)),
}


class Script:
    """Statements in order, each with its comment; ``placed`` says where tables lie.

    Args:
        session: of the database that the script is for.
        placed: the state tables.
    """

    def __init__(self, session: Session, placed: Mapping[str, exp.Table]) -> None:
        self.engine, self.placed = session.engine, dict(placed)
        self.parts: list[tuple[str, exp.Expr]] = []
        self.verified: list[exp.Table] = []

    def keep(self, name: str, query: exp.Query, comment: str = "", called: str = "") -> None:
        """Make a temporary table of the rows of a query."""
        place(query, self.placed)
        table = self._temporary(called or name)
        self.placed[name] = table
        self._make(table, query, comment)
        if self.engine.analyzes:
            self.say(exp.Analyze(tables=[table.copy()]))

    def step(self, steps: Pipeline, name: str, called: str = "") -> None:
        """Make a temporary table of the rows of a step."""
        query = steps.query(name, self.placed, commented=True)
        self.keep(name, query, steps.steps[name].made.comment, called)

    def verify(self, query: exp.Query, sentence: str, comment: str = "") -> None:
        """End the script with an error where a query has a row."""
        place(query, self.placed)
        steps = Pipeline()
        failure = self.engine.failure(sentence, exp.column("problem_rows", table="counted"))
        add(steps, "stored/monitor/failing", {"failure": failure})
        failing = steps.query("failing").copy()
        (problems,) = (one for one in failing.find_all(exp.Table) if one.name == "problems")
        problems.replace(_without_order(query).subquery("problems"))
        table = self._temporary(f"verified_{len(self.verified) + 1}")
        self.verified.append(table)
        self._make(table, failing, comment or f"Verified: {sentence}.")

    def append(self, steps: Pipeline, name: str, table: str, comment: str = "") -> None:
        """Append the rows of a step to a table of the state."""
        query = steps.query(name, self.placed, commented=True)
        said = comment or steps.steps[name].made.comment
        self.say(insertion(self.placed[f"stored_{table}"].copy(), _tidied(query)), said)

    def say(self, statement: exp.Expr, comment: str = "") -> None:
        """Add a statement."""
        self.parts.append((comment, statement))

    def text(self) -> str:
        """Return the statements as a script."""
        return "\n".join(
            f"{_commented(comment)}{self.engine.text(statement, pretty=True)};\n"
            for comment, statement in self.parts
        )

    def _temporary(self, name: str) -> exp.Table:
        schema = self.engine.temporary
        return exp.Table(this=template.name(f"gam_run_{name}"), db=schema and template.name(schema))

    def _make(self, table: exp.Table, query: exp.Query, comment: str) -> None:
        for step in query.find_all(exp.CTE):
            said = " ".join(" ".join(step.this.comments or []).split())
            step.this.comments = (
                [f" {textwrap.fill(said, _WIDTH, subsequent_indent=' ' * 5)} "] if said else None
            )
        storage = self.engine.storage.temporary
        self.say(temporary(table, _tidied(query), *storage), comment)


def rendered(monitor: Monitor) -> str:
    """Return the script of one scheduled run of a monitor.

    Raises:
        UserError: its database cannot run it, its source cannot be read so, or nothing is calibrated.
    """
    session, state = monitor.session, monitor.state
    if not session.engine.failing:
        raise EngineError(
            f"A run on {session.engine.title} takes Python (gam score): there a script cannot take back "
            "what it wrote where another run was faster."
        )
    row = state.monitor(monitor.name)
    made = _Made(monitor, row)
    if not made.lists:
        raise StateError(f"No channel of the monitor {monitor.name!r} is calibrated (gam calibrate).")
    return made.text()


class _Made:
    """The script of a monitor, by its row."""

    def __init__(self, monitor: Monitor, row: Row) -> None:
        self.monitor, self.monitor_id = monitor, row["monitor_id"]
        session, self.engine = monitor.session, monitor.session.engine
        source = monitor.source
        self.kind = kind_of(row)
        self.lookback = lengths.lookback(monitor.lookback, self.kind, repeat_of(row["source"]))
        self.silent = lengths.park_after(monitor.park_after, self.kind)
        self.tolerance = tolerance(source, self.kind)
        self.earliest, self.latest = _CALENDAR
        if self.kind.is_counter:
            self.earliest, self.latest = LONG_AGO, FAR_AHEAD
        elif self.kind.furthest < FAR_AHEAD:
            self.earliest, self.latest = -_NANOSECONDS, _NANOSECONDS
        if not isinstance(source.relation, (str, tuple, list)) or is_file(source.relation):
            raise ParameterError(
                "The source of this monitor is no table or view of its database, which a script could "
                "read; a run of it takes Python (gam score)."
            )
        self.read = prepared(session, source)
        active = monitor.state.rows("stored/state/active", {"monitor_id": self.monitor_id})
        self.lists = self._listed([version for version in active if version["lo"] is not None])
        self.script = Script(session, monitor.tables.placed())
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
            script.say(statement)
        self._plan()
        self._read_source()
        self._count_calibration()
        self._choose()
        for number, (setting, versions) in enumerate(self.lists, start=1):
            self._count(setting, versions, f"_{number}" if len(self.lists) > 1 else "")
        for statement in self.engine.resting:
            script.say(statement)
        self._publish()
        lines = [line for line in begin if line]
        head = "".join(map(_commented, self.head)) + "".join(f"{line}\n" for line in lines)
        return f"{head}\n{script.text()}"

    def _listed(self, versions: Sequence[Row]) -> list[tuple[Setting, list[Row]]]:
        """Return what channels share that one part of the script is for, each with its channels."""
        read = [
            {**one, "programs": None if one["program_column"] is None else self.read.programs}
            for one in versions
        ]
        groups: dict[str, list[Row]] = {}
        for one in read:
            by_column = self.engine.delays_by_column and one["programs"] is None
            groups.setdefault(repr(shape_of(one, by_column)), []).append(one)
        made = []
        for _, group in sorted(groups.items()):
            lengths_of = {(one["tau"], one["window_length"], one["stride"]) for one in group}
            made.append((shared_by(group, len(lengths_of) > 1), group))
        return made

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

    def _plan(self) -> None:
        """Tell from where on each version is to be read, and which of them are read now."""
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
        script.placed["planned_runs"] = script.placed.pop("newest_runs")
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
        listed = exp.or_(*(self._is_of(setting) for setting, _ in self.lists))
        script.verify(filled("stored/monitor/unlisted", {"listed": listed}), UNLISTED)
        since = template.node_of(LONG_AGO)
        if self.silent is not None:
            since = exp.column("newest") - (lookback + self.silent)
        slots = {"lookback": lookback, "since": since, "day": DAY, "long_ago": LONG_AGO}
        add(steps, "stored/monitor/parted", slots)
        script.step(steps, "parted")

    def _read_source(self) -> None:
        """Read the rows that may matter, each once, and tell what has left the source."""
        script, steps = self.script, self.steps
        if self.silent is not None:
            rows = self._rows(self._edge("stored/monitor/look_from"))
            steps.add("looked_at", rows, "Readings: where parked channels may have sent again.")
            add(steps, "stored/monitor/resumed", tables={"readings": "looked_at"})
            script.step(steps, "resumed")
        else:
            steps.add("resumed", filled("stored/monitor/none_resumed"))
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
        asked, tables = {"long_ago": LONG_AGO}, {"restart": "whole"}
        add(steps, "stored/scoring/plan", asked, "whole_plan", tables)
        add(steps, "stored/monitor/begun", {"long_ago": LONG_AGO})
        script.step(steps, "begun")
        add(steps, "stored/monitor/counted", {"day": DAY})
        script.step(steps, "counted")
        self._count_unplaced()

    def _count_unplaced(self) -> None:
        """Count the rows that belong to no channel or tell no time."""
        script, steps, read = self.script, Pipeline(), self.read
        rows = self._rows(self._edge("stored/monitor/names_from"))
        steps.add("readings_of_names", rows, template.load("source/readings").comment)
        add(steps, "source/names", tables={"readings": "readings_of_names"})
        missing = counting_undated(self.engine, read.rows, read.relation, self.kind, among_all=False)
        steps.add("undated", missing, template.load("source/undated").comment)
        add(steps, "stored/monitor/unplaced_rows", {"monitor_id": self.monitor_id})
        script.step(steps, "unplaced_rows")

    def _count_calibration(self) -> None:
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

    def _choose(self) -> None:
        """Say what is scored, and verify it."""
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
        placed = dict(script.placed)
        script.placed["plan"] = script.placed["counted"]
        script.step(steps, "cohort")
        script.placed["plan"] = placed["plan"]
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
        script.placed["wanted"] = script.placed["verified"]
        script.verify(matching_steps().query("mismatched", script.placed, commented=True), DAMAGED)

    def _count(self, setting: Setting, versions: Sequence[Row], suffix: str) -> None:
        """Count the buckets of the channels of one shape, and what is to be written of them."""
        script = self.script
        shape = Shape(setting, self.kind, None, compared=True, recounted=True)
        plan, of_run = counting(shape), dict(script.placed)
        # Of the steps of the run alone: others of the same name are the list's.
        shared = {name: table for name, table in of_run.items() if name in _SHARED}
        script.placed = dict(self.monitor.tables.placed()) | shared
        queries = {"past_missing": filled("stored/scoring/past_missing")}
        for table, step in former(setting.has_programs).items():
            slots = former_slots(table, exp.true(), exp.true(), setting.has_programs)
            queries[step] = filled(f"stored/scoring/{step}", slots)
        if suffix:
            members = Pipeline()
            add(members, "stored/monitor/members", {"listed": self._is_of(setting)})
            script.step(members, "members", f"cohort{suffix}")
            script.placed["cohort"] = script.placed.pop("members")
        else:
            script.placed["cohort"] = of_run["cohort"]
        script.placed["identified"] = of_run["samples"]
        self._execute(plan, queries, suffix)
        self.scored = getattr(self, "scored", [])
        self.scored.append((shape, versions, suffix, dict(script.placed)))
        script.placed = of_run

    def _execute(self, plan: Plan, queries: Mapping[str, exp.Query], suffix: str) -> None:
        """Add the statements of a plan, but tables that are there already, and what repeats."""
        script = self.script
        for name, kind, into, failure, _ in plan.statements:
            is_there = kind is Kind.TABLE and name in script.placed
            if kind is Kind.ANSWER or is_there or name == "repeated_instants":
                continue
            if name in queries:
                query, comment = queries[name].copy(), template.load(f"stored/scoring/{name}").comment
            else:
                query = plan.steps.query(name, script.placed, commented=True)
                comment = plan.steps.steps[name].made.comment
            if kind is Kind.TABLE:
                script.keep(name, query, comment, f"{name}{suffix}")
            elif kind is Kind.VERIFY:
                assert failure is not None
                script.verify(query, str(failure([])).rstrip("."))
            else:
                script.append(plan.steps, name, into)

    def _publish(self) -> None:
        """Append what was counted, as one transaction, unless somebody else wrote meanwhile."""
        script, tables = self.script, self.monitor.tables
        script.say(_command(self.engine.begins), "Publish, unless somebody else did so since.")
        for statement in locking(tables, self.monitor_id):
            script.say(statement)
        near = planned_runs()
        script.verify(near.query("unplanned", script.placed, commented=True), CHANGED.rstrip("."))
        steps = Pipeline()
        slots = {"now": self.engine.clock(), "monitor_id": self.monitor_id}
        add(steps, "stored/monitor/stamp", slots)
        stamp = steps.query("stamp", script.placed, commented=True)
        assert isinstance(stamp, exp.Select)
        for table in script.verified:
            stamp.join(table.copy(), join_type="cross", copy=False)
        script.keep("stamp", stamp, steps.steps["stamp"].made.comment)
        for shape, versions, suffix, placed in self.scored:
            of_run = script.placed
            script.placed = placed | {"stamp": of_run["stamp"]}
            rows, commit = publishing(shape, True)
            self._append(rows)
            self._judge(versions, suffix)
            self._append(commit)
            script.placed = of_run
        self._clear()
        script.say(_command("COMMIT"))

    def _append(self, plan: Plan) -> None:
        for name, kind, into, _, _ in plan.statements:
            if kind is Kind.APPEND:
                self.script.append(plan.steps, name, into)

    def _judge(self, versions: Sequence[Row], suffix: str) -> None:
        """Append the judgements of what was written."""
        script, of_list = self.script, dict(self.script.placed)
        ratios = sorted({buckets_of(one) for one in versions})
        for buckets in ratios:
            called = suffix + (f"_of_{buckets}" if len(ratios) > 1 else "")
            script.placed["cohort"] = of_list["changed"]
            script.placed["new_buckets"] = of_list["written"]
            if len(ratios) > 1:
                part = Pipeline()
                add(part, "stored/monitor/window_changed", {"buckets": buckets})
                script.placed["cohort"] = of_list["cohort"]
                script.step(part, "window_changed", f"changed{called}")
                script.placed["cohort"] = script.placed["window_changed"]
            steps = Pipeline()
            add(steps, "stored/alarms/judged_until", {"near": exp.true()})
            script.step(steps, "judged_until", f"judged_until{called}")
            judging = judging_steps(buckets, exp.true(), exp.true())
            for name in ("judged_buckets", "judged_windows"):
                script.step(judging, name, f"{name}{called}")
            script.append(judging, "judgement_rows", "judgement")
            script.placed = dict(of_list)

    def _clear(self) -> None:
        """Delete what this run hides, and record what else it saw."""
        script, state = self.script, self.monitor.state
        run_id = filled("stored/monitor/run_id")
        place(run_id, script.placed)
        has_programs = any(setting.has_programs for setting, _ in self.lists)
        for table in hidden_tables(has_programs):
            slots: dict[str, template.Slot] = {
                "run_id": exp.Subquery(this=run_id.copy()),
                "after": LONG_AGO,
                "near": exp.true(),
            }
            appended = {"appended": state.tables.table(table)}
            found = state.query("stored/state/superseded", slots, appended)
            target = state.tables.table(table)
            comment = f"Rows of {target.name} that this run has replaced."
            script.say(deletion(target, found.named_selects, _tidied(found)), comment)
        steps = Pipeline()
        about: dict[str, template.Slot] = {"monitor_id": self.monitor_id}
        add(steps, "stored/monitor/proof_rows", about)
        script.append(steps, "proof_rows", "proof")
        add(steps, "stored/monitor/unplaced_rows", about)
        said = "What it could place nowhere, and that it ran."
        script.append(steps, "unplaced_rows", "unplaced", said)

    def _rows(self, time: exp.Expr, is_after: bool = True, until: exp.Expr | None = None) -> exp.Query:
        """Return the step *readings*, of rows that are not before, or are before, an instant."""
        source = self.read.rows
        column = template.column(source.time)
        ends = [(time, is_after), *([] if until is None else [(until, False)])]
        conditions: list[exp.Expr] = []
        for end, after in ends:
            if clock_of(source) is not None:  # local times: a day further holds them in any zone
                end = exp.paren(end - DAY if after else end + DAY)
            conditions += self.engine.beside(self.kind, column, end, after)
        latest = None
        if self.tolerance is not None:
            latest = exp.Subquery(this=filled("stored/monitor/latest"))
        source = under(source, *conditions)
        return self.engine.readings(source, self.read.relation, self.kind, until=latest)

    def _edge(self, path: str, slots: Mapping[str, template.Slot] | None = None) -> exp.Expr:
        """Return an instant that a file gives, of those that the source can tell, as an expression."""
        ends = {"earliest": self.earliest, "latest": self.latest}
        return exp.Subquery(this=filled(path, {**ends, **(slots or {})}))


#: What the lists of a run read of the steps before them.
_SHARED = ("cohort", "counted", "samples", "timeline", "recount")

#: Signs in a line of a comment.
_WIDTH = 94

_LENGTHS = ("tau", "window_length", "stride")

_READINGS = "Readings of the channels that are read, each row of the source once."


def _command(words: str) -> exp.Expr:
    first, _, more = words.partition(" ")
    return exp.Command(this=first, expression=more)


def _without_order(query: exp.Query) -> exp.Query:
    query.set("order", None)
    return query


def _tidied(tree: exp.Query) -> exp.Query:
    """Leave out conditions that always hold; in place."""
    for both in reversed(list(tree.find_all(exp.And))):
        left, right = both.left, both.right
        if _holds(left) or _holds(right):
            both.replace(right if _holds(left) else left)
    for select in tree.find_all(exp.Select):
        where = select.args.get("where")
        if where is not None and _holds(where.this):
            select.set("where", None)
    return tree


def _holds(condition: exp.Expr) -> bool:
    bare = condition.unnest()
    one = exp.Literal.number(1)
    return bare == exp.true() or bare == exp.EQ(this=one, expression=one.copy())


def _commented(text: str) -> str:
    lines = textwrap.wrap(" ".join(text.split()), _WIDTH)
    return "".join(f"-- {line}\n" for line in lines)
