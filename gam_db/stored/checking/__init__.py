"""Checks of the state: does it equal one run over the source, and is it consistent?

This module owns the comparison. It writes nothing. It checks the checksums of frozen calibrations; what
must hold between the tables, for any source; and the source itself, over which it makes every
calibration, every bucket and every novel cell again beside the state
(:mod:`gam_db.stored.checking.again`), from the intervals and settings that are stored.

What cannot be made again is checked against the other tables: limits, labels, episodes, records of
runs, retired versions, and everything whose rows have gone from the source.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import pyarrow as pa

from gam_db import data
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import COUNT, WORD, columns, counts, name_of, table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.settings.source import AnySource
from gam_db.stored.checking.again import Again
from gam_db.stored.checking.consistency import inconsistencies
from gam_db.stored.checking.proving import STATE, Proof, mismatched
from gam_db.stored.checking.soundness import soundness_steps
from gam_db.stored.planning import Row, by, portions, whole_pools
from gam_db.stored.planning.gone import whole_plan_rows
from gam_db.stored.planning.reading import Reader, last_times, plan_rows, searched_plan_rows
from gam_db.stored.planning.setting import setting_of
from gam_db.stored.planning.steps import reading_steps
from gam_db.stored.state import State, kind_of, now
from gam_db.study.running import Listener, Running, unheard

#: Parts of the state, in the order in which they are told.
PARTS = (
    "source",
    *("frozen", "versions", "tables", "buckets", "novel cells", "runs"),
    *("limits", "judgements", "episodes", "labels"),
    *("scored", "calibration"),
)

#: Why a part is not compared with the source: its rows have gone, or the next run makes it anew.
GONE, NEXT_RUN = "gone from the source", "left to the next run"

#: The texts of inconsistencies.
_WORDS = data.table("gam_db.stored.checking", "checks.toml")


@dataclass(frozen=True)
class Checked:
    """The result of a check.

    Attributes:
        differences: one row each; see :func:`check_state`.
        uncompared: what was held to the rest of the state alone, one row per version and part of it:
            asset, channel, version, part ("calibration" or "scored"), why (:data:`GONE`,
            :data:`NEXT_RUN`), since and until (integer times: from where on, and up to where; NULL for
            the beginning, and for the end).
        proof: what was looked at, to be recorded.
    """

    differences: pa.Table
    uncompared: pa.Table
    proof: Proof


def check_state(
    state: State,
    source: AnySource,
    name: str,
    lookback: int,
    limit: int | None = None,
    on_step: Listener = unheard,
) -> Checked:
    """Compare all computed tables of a monitor with its source, and with one another.

    The whole source is read, a group of channels at a time (at most ``limit`` readings; None for what
    memory allows). Where rows came since the last run, no later than ``lookback`` allows, the buckets
    that they reach are left to the next run.

    Returns:
        The differences, ordered: asset, channel (NULL for rows that belong to none), version (its number
        within the channel), part (of :data:`PARTS`), what (in words), samples_then and samples_now (of
        the buckets that differ for "scored", rows of the intervals for "calibration"; else NULL),
        differing (buckets, cells or rows), since (integer time of the first bucket that differs: score
        from there on to repair; NULL where that repairs nothing).

    Raises:
        UserError: there is no such monitor, or the source cannot be used.
    """
    monitor = state.monitor(name)
    reader = Reader(state.session, source, kind_of(monitor), name)
    check = _Check(state, reader, lookback, on_step)
    monitor_id, began = monitor["monitor_id"], now()
    buckets, oldest = check.soundness(monitor_id)
    check.versions = {row["version_id"]: row for row in reader.with_programs(check.versions.values())}
    for inconsistency in inconsistencies(state, monitor_id, reader.kind, check.versions, oldest):
        key = inconsistency.version_id if inconsistency.version_id in check.versions else None
        check.note(
            key,
            inconsistency.part,
            what=inconsistency.what,
            differing=inconsistency.differing,
            since=inconsistency.since,
        )
    usable = {key: row for key, row in check.versions.items() if key not in check.unusable}
    check.look()
    active = [row for row in usable.values() if row["is_active"] and row["lo"] is not None]
    if active and not any(check.readings.get(name_of(row)) for row in active):
        what = "the source has no row of any channel, so nothing could be compared with it"
        check.note(None, "source", what=what, differing=len(active))
    most = limit or state.session.rows_at_once()
    for group in portions(check.planned(monitor_id, usable), check.readings, most):
        check.scored(group)
    for _, alike in groupby(sorted(check.taught(usable.values()), key=_learning), key=_learning):
        for group in whole_pools(alike, check.readings, most):
            check.calibration(group)
    differences = sorted(check.differences, key=_place)
    versions = check.versions.values()
    channels = len({row["channel_id"] for row in versions})
    proof = Proof(STATE, began, channels, len(versions), buckets, len(differences))
    uncompared = sorted(check.uncompared, key=lambda row: (*name_of(row), row["version"], row["part"]))
    return Checked(table_of(differences, _RESULT), table_of(uncompared, _UNCOMPARED), proof)


class _Check:
    def __init__(self, state: State, reader: Reader, lookback: int, on_step: Listener) -> None:
        self.state, self.session, self.reader, self.on_step = state, state.session, reader, on_step
        self.again, self.lookback = Again(state, reader, on_step), lookback
        self.versions: dict[int, Row] = {}
        self.unusable: set[int] = set()
        self.differences: list[Row] = []
        self.uncompared: list[Row] = []
        self.readings: dict[tuple[str, str], int] = {}
        self.edges: dict[tuple[str, str], Row] = {}

    def note(self, version_id: int | None, part: str, **figures: Any) -> None:
        """Note a difference of a version, or of none."""
        self.differences.append({**self._named(version_id), "part": part, **figures})

    def leave(
        self, version_id: int, part: str, why: str, since: int | None = None, until: int | None = None
    ) -> None:
        """Log the parts that are not compared with the source."""
        edges = {"why": why, "since": since, "until": until}
        self.uncompared.append({**self._named(version_id), "part": part, **edges})

    def _named(self, version_id: int | None) -> Row:
        row = {} if version_id is None else self.versions[version_id]
        return {
            "asset": row.get("asset"),
            "channel": row.get("channel"),
            "version": row.get("version_no"),
        }

    def soundness(self, monitor_id: int) -> tuple[int, list[Row]]:
        """Look at what must hold whatever the source.

        Returned are how many buckets there are, and the rows of *oldest_buckets*.
        """
        buckets = 0
        with self._running(soundness_steps(monitor_id, self.session.transactions)) as running:
            rows = running.rows("checked")
            running.load("checked", table_of(rows, _CHECKED))
            self.versions = {row["version_id"]: row for row in rows}
            with self.session.lent(table_of(rows, counts("version_id"))) as wanted:
                frozen = mismatched(self.state, wanted)
            for row in frozen:
                self.unusable |= set() if row["is_usable"] else {row["version_id"]}
                what = f"changed since calibration froze it: {row['said']}"
                self.note(row["version_id"], "frozen", what=what, differing=1)
            for step, parts in _WORDS["held"].items():
                ((part, held),) = parts.items()
                for row in running.rows(step):
                    buckets += row.get("buckets", 0)
                    key = row["version_id"]  # where nothing scores any more, scoring mends nothing
                    since = row.get("since") if self.versions[key]["is_active"] else None
                    for column, what in held.items():
                        if row[column]:
                            self.note(key, part, what=what, differing=row[column], since=since)
            for row in running.rows("orphans"):
                table = self.state.tables.shown(row["of_table"])
                what = f"rows of {table} whose {row['lacks']} is not there"
                if row["lacks"] == "another key":
                    what = f"keys or names that are there twice in {table}"
                self.note(None, "tables", what=what, differing=row["orphans"])
            return buckets, running.rows("oldest_buckets")

    def look(self) -> None:
        """Look at the source: how many rows each channel has, and its oldest and newest time."""
        steps = reading_steps(self.reader.readings())
        self.edges = {name_of(row): row for row in self.session.rows(steps.query("names"))}
        self.readings = {name: row["readings"] for name, row in self.edges.items()}

    def planned(self, monitor_id: int, usable: Mapping[int, Row]) -> list[Row]:
        """Return from where on, by which number and up to where the active versions are scored again."""
        active = {key: row for key, row in usable.items() if row["is_active"]}
        oldest = {
            key: self.edges[name_of(row)]["earliest"]
            for key, row in active.items()
            if self.readings.get(name_of(row))
        }
        whole = whole_plan_rows(self.state, monitor_id, oldest)
        with self._running(Pipeline()) as running:
            settled = {row["version_id"]: row for row in plan_rows(running, monitor_id, self.lookback)}
            searched = searched_plan_rows(running, monitor_id, None)
        ends = last_times(self.state, monitor_id)
        newest = max(
            (row["started"] for row in usable.values() if row["started"] is not None), default=None
        )
        planned = []
        for row in self.reader.with_programs(searched):
            key = row["version_id"]
            if key not in active:
                continue
            version, is_gone = active[key], key in whole
            if is_gone:
                (row,) = self.reader.with_programs([whole[key]])
                self.leave(key, "scored", GONE, until=oldest[key])
            elif key not in oldest and row["oldest_bucket"] >= 0 and row["restarts"]:
                self.leave(key, "scored", GONE)
                continue
            following = settled[key]
            if following["first_scored"] is None:  # what a run recorded was spoiled, which is named
                following = row
            until = self._until(version, newest, following["first_scored"] - 1, ends.get(key))
            firsts = {"first_kept": version["first_bucket"], "first_novel": version["first_novel"]}
            until |= {
                "until_settled": following["first_scored"] - 1,
                "next_bucket": following["first_bucket"],
                "is_ended": ends.get(key, LONG_AGO) >= following["first_scored"],
            }
            planned.append({**row, **firsts, **until, "is_gone": is_gone})
        return planned

    def _until(self, version: Row, newest: int | None, settled: int, end: int | None) -> Row:
        """Return up to where a version must be scored by now, the newest run of all having begun then.

        That is what its own last run has read, and what was there for the newest run: by the clock, or,
        of a counter, everything where that run has left the channel out. Where rows came late it is what
        lies before the lookback: of where stored buckets ``end``, if that is near to what was read.
        """
        read_to = version["read_to"]
        if read_to is None:
            read_to = version["first_scored"] - 1
        due = read_to
        if newest is not None and not self.reader.kind.is_counter:
            due = newest - self.lookback
        elif newest is not None and version["started"] != newest:
            due = FAR_AHEAD
        latest = self.edges.get(name_of(version), {}).get("latest")
        is_behind = latest is not None and latest > read_to and due > read_to
        # What is not settled shows how long a bucket is; the one that is not full yet may be as long.
        is_near = end is not None and read_to - end <= max(self.lookback, end - settled)
        reached = end if end is not None and is_near else read_to
        late = due if is_behind else reached - self.lookback - 1
        return {"until": max(read_to, due), "until_late": late}

    def scored(self, group: Sequence[Row]) -> None:
        """Compare the buckets and novel cells of a group of one setting."""
        scored = self.again.scored(group)
        reported = {row["owner_id"] for row in scored.buckets}
        for row in scored.buckets:
            what = (
                f"{row['only_recomputed']:,} buckets that the source gives are not stored, "
                f"{row['only_stored']:,} are stored that it does not give"
            )
            samples = {name: row[name] for name in ("samples_then", "samples_now")}
            difference = {"what": what, "differing": row["differing"], "since": row["since"]}
            self.note(row["owner_id"], "scored", **samples, **difference)
        for rows, part, of in (
            (scored.novel, "novel cells", "novel cells"),
            (scored.programs, "scored", "readings of unknown programs"),
        ):
            for row in rows:
                if row["owner_id"] not in reported:  # else it follows from the buckets
                    difference = {name: row[name] for name in ("differing", "since")}
                    self.note(
                        row["owner_id"], part, what=f"{of} that the source does not give", **difference
                    )
        for row in group:
            key, read = row["version_id"], scored.reread.get(row["channel_id"])
            version = self.versions[key]
            if read is not None and not read["ends_now"] and key not in reported and not row["is_gone"]:
                what = "the last run ended at an instant at which the source has no row"
                self.note(key, "runs", what=what, differing=1)
            latest = self.edges.get(name_of(version), {}).get("latest")
            end = row["until_late" if key in scored.late else "until"]
            if latest is not None and latest > end:
                self.leave(key, "scored", NEXT_RUN, since=end)

    def taught(self, versions: Iterable[Row]) -> list[Row]:
        """Return the versions whose calibration can be learnt again, of supports that are in use.

        The list includes those that taught their pool nothing: their rows are compared as well.
        """
        rows = [row for row in versions if row["lo"] is not None]
        used = {row["support_id"] for row in rows if row["is_active"]}
        learnable: list[Row] = []
        for support, pool in by("support_id", rows).items():
            teachers = [row for row in pool if row["calibration_end"] is not None]
            edges = [self.edges.get(name_of(row), {}).get("earliest") for row in teachers]
            if support not in used or not teachers:
                continue
            if any(
                oldest is None or (row["taught_from"] is not None and oldest > row["taught_from"])
                for row, oldest in zip(teachers, edges, strict=True)
            ):
                for row, oldest in zip(teachers, edges, strict=True):
                    self.leave(row["version_id"], "calibration", GONE, until=oldest)
            else:
                learnable += pool
        return learnable

    def calibration(self, group: Sequence[Row]) -> None:
        """Compare a new calibration of the frozen intervals of pools of one setting."""
        parts, counted = self.again.learnt(group)
        words: dict[int, dict[str, int]] = {}
        for part, rows in parts.items():
            for row in rows:
                words.setdefault(row["owner_id"], {})[_WORDS["calibration"][part]] = row["differing"]
        lost = {
            row["support_id"]
            for row in group
            if row["calibration_end"] is not None
            and _lacks_first(
                row, counted.get(row["version_id"], {}), self.edges[name_of(row)]["earliest"]
            )
        }
        for row in group:
            key, then = row["version_id"], row["calibration_readings"]
            readings = counted.get(key, {}).get("calibration_readings", 0)
            part_counts = {**words.get(row["support_id"], {}), **words.get(key, {})}
            if row["support_id"] in lost:
                if row["calibration_end"] is None:
                    continue
                self.leave(key, "calibration", GONE, until=self.edges[name_of(row)]["earliest"])
            elif readings != then or part_counts:
                what = ", ".join(f"{part} ({count:,})" for part, count in part_counts.items()) or None
                samples = {"samples_then": then, "samples_now": readings}
                self.note(key, "calibration", what=what, differing=sum(part_counts.values()), **samples)
            elif row["is_active"] and row["counted_readings"] not in (None, readings):
                what = "the last run that counted rows of calibration found another number"
                self.note(key, "runs", what=what, differing=1)

    def _running(self, steps: Pipeline) -> Running:
        return Running(self.session, steps, self.state.tables.nodes(), self.on_step)


def _lacks_first(row: Row, read: Row, oldest: int) -> bool:
    """Tell whether the first samples of a calibration have gone, that taught only together with others.

    The source has no older row then; what is ``read`` of the calibration is less, and teaches later.
    """
    then, now_from = row["taught_from"], read.get("taught_from")
    is_later = then is not None and now_from is not None and now_from > then
    is_less = read.get("calibration_readings", 0) < row["calibration_readings"]
    return is_later and is_less and oldest >= row["calibration_from"]


def _learning(row: Row) -> str:
    names = ("target_floor", "least_vectors", "is_robust")
    return repr((setting_of(row), *(row[name] for name in names)))


def _place(row: Row) -> tuple[Any, ...]:
    since = row.get("since")
    named = (row["asset"] or "", row["channel"] or "", row["version"] or 0)
    return (*named, PARTS.index(row["part"]), LONG_AGO if since is None else since)


_RESULT = columns(
    (WORD, "asset channel"),
    (COUNT, "version"),
    (WORD, "part what"),
    (COUNT, "samples_then samples_now differing since"),
)
_UNCOMPARED = columns(
    (WORD, "asset channel"), (COUNT, "version"), (WORD, "part why"), (COUNT, "since until")
)
_CHECKED = columns(
    (COUNT, "version_id channel_id support_id parent_id version_no window_length stride still_after"),
    (COUNT, "context_rows run_up_from is_active first_bucket first_novel"),
    (WORD, "status reason"),
)
