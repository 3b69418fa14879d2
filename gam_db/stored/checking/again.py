"""Making again: the rows that calibration and scoring would write now, and how the stored rows differ.

The steps, and the rows that they end with, are those of a calibration and of a run. Here they become
temporary tables of the session, so neither the state nor the source is written. What is stored is
compared with them both ways, in all columns that they have.
"""

from collections.abc import Mapping, Sequence, Set
from typing import NamedTuple

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import SHARE, counts, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.method.programs import JUDGED
from gam_db.stored.alarms.judging import buckets_of
from gam_db.stored.planning import Row, assets_of
from gam_db.stored.planning.published import former, former_slots
from gam_db.stored.planning.reading import Reader, cohort_of, identified, listed, make_vectors, near
from gam_db.stored.planning.setting import setting_of, shared_by
from gam_db.stored.planning.steps import LEARNT, OF_SUPPORT, learning_steps, past_slots, scoring_steps
from gam_db.stored.schema.migration_files import columns_of
from gam_db.stored.state import State
from gam_db.study.running import Listener, Running

#: Tables that states of before have not for all that was learnt: none of their rows is missing where
#: none is there; an extent and its blocks came together.
_LATER = {"ladder": "ladder", "band": "band", "buffered": "extent", "extent": "buffered"}


def compared(
    running: Running, table: str, computed: str, stored: str, among: exp.Expr | None = None
) -> list[Row]:
    """Compare rows of a state table with those made again; both are steps, or tables that stand for one.

    Among is a condition on those that are stored. The run that wrote a row counts only where the rows
    made again name it as it is stored, as judgements do.

    Returns:
        Rows with owner_id, stored, only_stored, only_recomputed, differing (the larger of the two),
        samples_then, samples_now and since, where they differ.
    """
    running.prepare(computed)
    schema = columns_of(table)
    left_out = {"run_id"} if table in ("bucket", "novel", "unknown_program") else set()
    names = [name for name in running.steps.steps[computed].query.named_selects if name not in left_out]
    shares = [name for name in names if schema.field(name).type == SHARE]
    unlike = [
        condition
        for name in shares
        for column in [exp.column(name)]
        for condition in (
            exp.NEQ(this=exp.Min(this=column.copy()), expression=exp.Max(this=column.copy())),
            exp.EQ(this=exp.Count(this=column.copy()), expression=exp.Literal.number(1)),
        )
    ]
    owner = "support_id" if table in OF_SUPPORT else "version_id"
    slots: dict[str, template.Slot] = {
        "owner": exp.column(owner),
        "among": among or exp.true(),
        "columns": [exp.column(name) for name in names if name not in shares],
        "shares": [exp.column(name) for name in shares],
        "unlike": exp.or_(*unlike) if unlike else exp.false(),
        "since": exp.column("first_time") if "first_time" in names else exp.cast(exp.null(), "BIGINT"),
        "samples": exp.column("samples") if "samples" in names else exp.Literal.number(0),
    }
    steps = {"recomputed_rows": computed}
    if stored in running.steps.steps:
        steps["state_rows"] = stored
    else:
        running.tables["state_rows"] = running.tables[stored]
    rows = running.query_rows("stored/checking/compared", slots, steps)
    return [{**row, "differing": max(row["only_stored"], row["only_recomputed"])} for row in rows]


class Scored(NamedTuple):
    """What scoring again gives.

    Attributes:
        buckets, novel, programs: rows of :func:`compared`.
        reread: of each channel (by its number) what its last run would read now: rows_then, rows_now and
            ends_now, whether there still is a row where it ended.
        late: versions of which rows came or went where their last run has read.
    """

    buckets: list[Row]
    novel: list[Row]
    programs: list[Row]
    reread: Mapping[int, Row]
    late: Set[int]


class Again:
    """What a state would hold if it were made now of the rows that its source holds.

    Args:
        state: the state tables; they are only read.
        reader: of the source.
        on_step: called with what is done next.
    """

    def __init__(self, state: State, reader: Reader, on_step: Listener) -> None:
        self.state, self.session, self.reader, self.on_step = state, state.session, reader, on_step

    def learnt(self, group: Sequence[Row]) -> tuple[dict[str, list[Row]], dict[int, Row]]:
        """Compare a new calibration of the stored intervals of pools of one setting with the stored one.

        Returns:
            By table the rows of :func:`compared`; and by version calibration_readings, how many rows its
            intervals hold now, and taught_from, the first time that they teach (no row: nothing).
        """
        # Blocks are numbered in the order of names. A channel may be of two pools, one of them retired.
        group = sorted(group, key=lambda row: (row["asset"].encode(), row["channel"].encode()))
        first = {row["support_id"]: number for number, row in reversed(list(enumerate(group, start=1)))}
        members = [
            {**row, "channel_id": number, "support_id": first[row["support_id"]]}
            for number, row in enumerate(group, start=1)
        ]
        setting, version = setting_of(group[0]), [row["version_id"] for row in group]
        has_pools = len(first) < len(group)
        learning = (
            group[0]["target_floor"],
            group[0]["least_vectors"] or 1,
            bool(group[0]["is_robust"]),
        )
        ends = [LONG_AGO if (end := row["calibration_end"]) is None else end for row in group]
        steps = learning_steps(setting, self.reader.kind, *learning, has_pools)
        with self._running(steps) as running:
            cohort = cohort_of(members, read_from=LONG_AGO, read_until=ends, first_bucket=0)
            running.load("cohort", cohort)
            running.tables["limits"] = running.tables["cohort"]
            numbering = [
                {
                    "channel_id": number,
                    "stored_channel_id": row["channel_id"],
                    "version_id": row["version_id"],
                    "stored_support_id": row["support_id"],
                }
                for number, row in enumerate(group, start=1)
            ]
            running.load("numbering", table_of(numbering, _NUMBERING))
            edges = running.rows("calibration_range")[0]
            # No sample before an interval decides what is learnt in it, unless by standing still.
            earliest = edges["earliest"] if setting.still_after is None else LONG_AGO
            self._read(running, self.reader.readings(assets_of(group), earliest, edges["latest"]))
            counted = {version[row["channel_id"] - 1]: dict(row) for row in running.rows("recount")}
            for row in running.rows("blocks"):
                recount = counted.setdefault(version[row["channel_id"] - 1], {})
                recount["taught_from"] = min(
                    row["first_time"], recount.get("taught_from", row["first_time"])
                )
            parts = (part for part in LEARNT if f"{part}_rows" in running.steps.steps)
            differing = {part: self._part(running, part, group) for part in parts}
        for part, twin in _LATER.items():
            never = {row["owner_id"] for row in differing[twin] if not row["stored"]}
            rows = differing[part]
            differing[part] = [row for row in rows if row["stored"] or row["owner_id"] not in never]
        return differing, counted

    def scored(self, group: Sequence[Row]) -> Scored:
        """Compare the buckets, and the novel cells, of channels of one setting.

        The rows of a group are those of a plan, which says where computing begins and by which number,
        with: first_kept and first_novel, the first bucket and novel cells that pruning left; until, how
        far the source is read; until_late, how far where rows came since the last run; next_bucket, from
        which on its successor writes anew, until_settled, where the one before ends, and is_ended,
        whether it is stored; is_gone, whether rows have gone from the source.
        """
        begin = {
            "oldest_bucket": [max(row["first_bucket"], row["first_kept"]) for row in group],
            "novel_from": [max(row["first_bucket"], row["first_novel"]) for row in group],
        }
        until = [row["until"] for row in group]
        steps = scoring_steps(shared_by(group), self.reader.kind, compared=True).copied()
        add(steps, "stored/checking/reread")
        with self._running(steps) as running:
            running.load("cohort", cohort_of(group, read_until=until, **begin))
            earliest = min(row["read_from"] for row in group)
            self._read(running, self.reader.readings(assets_of(group), earliest))
            again = {row["channel_id"]: row for row in running.rows("reread")}
            late = {
                row["version_id"]
                for row in group
                if not row["is_gone"]
                and (read := again.get(row["channel_id"])) is not None
                and read["rows_now"] != read["rows_then"]
            }
            until = [row["until_late" if row["version_id"] in late else "until"] for row in group]
            if late:
                self._cut(running, cohort_of(group, read_until=until, **begin))
            last = self._count(running, group)
            # A late row may end a bucket sooner that is not settled: it is the next run's all the same.
            sooner = {
                row["version_id"]
                for row in group
                if row["version_id"] in late
                and row["is_ended"]
                and last.get(row["channel_id"]) == row["next_bucket"]
            }
            if sooner:
                until = [
                    row["until_settled"] if row["version_id"] in sooner else end
                    for row, end in zip(group, until, strict=True)
                ]
                running.forget(but=("cohort", "identified"))
                self._cut(running, cohort_of(group, read_until=until, **begin))
                last = self._count(running, group)
            settled = [
                max(last.get(row["channel_id"], -1) + 1, row["next_bucket"])
                if row["version_id"] in late
                else FAR_AHEAD
                for row in group
            ]
            running.load("cohort", cohort_of(group, read_until=until, settled=settled, **begin))
            running.load("stamp", table_of([{"run_id": 0}], counts("run_id")))
            differences = {"unknown_program": list[Row]()}
            programs = shared_by(group).has_programs
            for table, step in former(programs).items():
                column = "novel_from" if table == "novel" else "oldest_bucket"
                firsts = zip(group, begin[column], strict=True)
                running.load(
                    "changed", table_of([{**row, "first_bucket": n} for row, n in firsts], _CHANGED)
                )
                if table == "unknown_program":
                    recorded = [
                        {"version_id": row["version_id"], "run_id": 0, "from_bucket": first}
                        for row, first in zip(group, begin[column], strict=True)
                    ]
                    running.load("run_rows", table_of(recorded, _RECORDED))
                slots = former_slots(table, _stored_buckets(column), exp.true(), programs)
                running.make(f"stored/scoring/{step}", slots)
                differences[table] = compared(running, table, f"{table}_rows", step)
        return Scored(
            differences["bucket"], differences["novel"], differences["unknown_program"], again, late
        )

    def _cut(self, running: Running, cohort: pa.Table) -> None:
        """Limit the readings of each channel to the end that a cohort sets."""
        running.load("cohort", cohort)
        running.put("identified", _cut(running))

    def _count(self, running: Running, group: Sequence[Row]) -> dict[int, int]:
        """Make the buckets of some channels, and return the last one of each."""
        make_vectors(running, setting_of(group[0]).programs)
        past = near(group, buckets_of(group[0]))
        running.make("stored/scoring/past_buckets", past_slots(setting_of(group[0]), past))
        running.keep("new_buckets")
        buckets = self.session.rows(_last_buckets(running))
        return {row["channel_id"]: row["last_bucket"] for row in buckets}

    def _part(self, running: Running, part: str, group: Sequence[Row]) -> list[Row]:
        owner = "support_id" if part in OF_SUPPORT else "version_id"
        among = listed(exp.column(owner), {row[owner] for row in group})
        if isinstance(among, exp.Between):  # of many only a range is said, and others may lie in it
            keys = table_of([{owner: row[owner]} for row in group], counts(owner))
            with self.session.lent(keys) as lent:
                among = exp.In(this=exp.column(owner), query=exp.select(owner).from_(lent).subquery())
                return compared(running, part, f"{part}_rows", f"stored_{part}", among)
        return compared(running, part, f"{part}_rows", f"stored_{part}", among)

    def _read(self, running: Running, readings: exp.Query) -> None:
        running.put("identified", identified(running, readings))

    def _running(self, steps: Pipeline) -> Running:
        return Running(self.session, steps, self.state.tables.nodes(), self.on_step)


def _cut(running: Running) -> exp.Query:
    """Return the readings of each channel up to where its cohort ends."""
    names = ("channel_id", "time", "value", *["program"] * (JUDGED in running.steps.steps))
    columns = [exp.column(name, table="reading").as_(name) for name in names]
    same = exp.column("channel_id", table="member").eq(exp.column("channel_id", table="reading"))
    until = exp.column("time", table="reading") <= exp.column("read_until", table="member")
    reading, member = (running.tables[step].copy() for step in ("identified", "cohort"))
    rows = exp.select(*columns).from_(exp.alias_(reading, "reading", table=True))
    return rows.join(exp.alias_(member, "member", table=True), on=same).where(until)


def _last_buckets(running: Running) -> exp.Query:
    """Return the last new bucket of each channel."""
    last = exp.Max(this=exp.column("bucket_no")).as_("last_bucket")
    rows = exp.select(exp.column("channel_id"), last).from_(running.tables["new_buckets"].copy())
    return rows.group_by(exp.column("channel_id"))


def _stored_buckets(column: str) -> exp.Expr:
    """Return the condition on *bucket* for the stored rows to compare."""
    number = exp.column("bucket_no", table="bucket")
    first, end = (exp.column(name, table="member") for name in (column, "settled"))
    return exp.and_(number >= first, number.copy() < end)


_NUMBERING = counts("channel_id stored_channel_id version_id stored_support_id")
_CHANGED = counts("channel_id version_id first_bucket")
_RECORDED = counts("version_id run_id from_bucket")
