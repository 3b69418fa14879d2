"""Checking the state: is what is stored what one run over everything gives, and does it hold together?

This module owns the comparison. It writes nothing. Three things are looked at: the checksums of what
calibration froze; what must hold between the tables, whatever the source; and the source itself, over
which every bucket, every novel cell and all that calibration taught is computed again. What the next run
will read anyway is left out, unless no row came since the last one.

Retired versions are held to their checksums and to what must hold between the tables, not to the source:
it may have changed since, which is why they were retired.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

import pyarrow as pa

from gam_db import data
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import COUNT, WORD, columns, counts, name_of, table_of
from gam_db.settings.source import AnySource
from gam_db.stored.checking.consistency import inconsistencies
from gam_db.stored.checking.proving import STATE, Proof, mismatched
from gam_db.stored.checking.soundness import soundness_steps
from gam_db.stored.planning import Row, assets_of, portions, whole_pools
from gam_db.stored.planning.reading import Reader, cohort_of, plan_rows, searched_plan_rows
from gam_db.stored.planning.steps import comparing_steps, reading_steps, relearning_steps, setting_of
from gam_db.stored.state import State, kind_of, now
from gam_db.study.running import Listener, Running, unheard

#: Parts of the state, in the order in which they are told.
PARTS = (
    *("frozen", "versions", "tables", "buckets", "novel cells", "runs"),
    *("limits", "judgements", "episodes", "labels"),
    *("scored", "calibration", "certificate"),
)

#: What is said of what does not hold.
_WORDS = data.table("gam_db.stored.checking", "checks.toml")


@dataclass(frozen=True)
class Checked:
    """What a check found.

    Attributes:
        differences: one row each; see :func:`check_state`.
        proof: what was looked at, to be recorded.
    """

    differences: pa.Table
    proof: Proof


def check_state(
    state: State,
    source: AnySource,
    name: str,
    lookback: int,
    limit: int | None = None,
    on_step: Listener = unheard,
) -> Checked:
    """Compare all that is computed in the tables of a monitor with its source, and with one another.

    The whole source is read, a group of channels at a time (at most ``limit`` readings; None for what
    memory allows). Buckets that the next run would write anew, since rows may come as late as
    ``lookback``, are compared only where no row came since.

    Returns:
        One row per difference, ordered: asset, channel (NULL for rows that belong to none), version (its
        number within the channel), part (of :data:`PARTS`), what (in words; NULL where the part says
        it), day (days since 1970; only of "scored", and not of counters), samples_then and samples_now
        (of the day; rows of the intervals for "calibration"; else NULL), differing (buckets, cells or
        rows), since (integer time of the first bucket that differs: score from there on to repair; NULL
        where that repairs nothing).

    Raises:
        UserError: there is no such monitor, or the source cannot be used.
    """
    monitor = state.monitor(name)
    reader = Reader(state.session, source, kind_of(monitor), name)
    check = _Check(state, reader, on_step)
    monitor_id, began = monitor["monitor_id"], now()
    buckets = check.soundness(monitor_id)
    for one in inconsistencies(state, monitor_id, reader.kind, check.versions):
        key = one.version_id if one.version_id in check.versions else None
        check.note(key, one.part, what=one.what, differing=one.differing, since=one.since)
    usable = {key: row for key, row in check.versions.items() if key not in check.unusable}
    active = {key for key, row in usable.items() if row["is_active"]}
    settled = {row["version_id"]: row for row in plan_rows(state, monitor_id, lookback)}
    rows = [row for row in searched_plan_rows(state, monitor_id, None) if row["version_id"] in active]
    readings, most = check.readings(), limit or state.session.rows_at_once()
    for group in portions(rows, readings, most):
        check.scored(group, [settled[row["version_id"]] for row in group])
    for _, alike in groupby(sorted(_taught(usable.values()), key=_learning), key=_learning):
        for group in whole_pools(alike, readings, most):
            check.calibration(group)
    made = sorted(check.found, key=_place)
    versions = check.versions.values()
    channels = len({row["channel_id"] for row in versions})
    proof = Proof(STATE, began, channels, len(versions), buckets, len(made))
    return Checked(table_of(made, _RESULT), proof)


class _Check:
    def __init__(self, state: State, reader: Reader, on_step: Listener) -> None:
        self.state, self.session, self.reader, self.on_step = state, state.session, reader, on_step
        self.versions: dict[int, Row] = {}
        self.unusable: set[int] = set()
        self.found: list[Row] = []

    def note(self, version_id: int | None, part: str, **said: Any) -> None:
        """Note a difference of a version, or of none."""
        row = {} if version_id is None else self.versions[version_id]
        named = {"asset": row.get("asset"), "channel": row.get("channel")}
        self.found.append({**named, "version": row.get("version_no"), "part": part, **said})

    def soundness(self, monitor_id: int) -> int:
        """Look at what must hold whatever the source; return how many buckets there are."""
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
            for step, said in _WORDS["held"].items():
                ((part, held),) = said.items()
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
                self.note(None, "tables", what=what, differing=row["found"])
        return buckets

    def readings(self) -> dict[tuple[str, str], int]:
        steps = reading_steps(self.reader.readings())
        rows = self.session.rows(steps.query("names"))
        return {name_of(row): row["readings"] for row in rows}

    def scored(self, group: Sequence[Row], settled: Sequence[Row]) -> None:
        """Compare the buckets of a group of one setting: the settled ones, and all if no row came."""
        known = [self.versions[row["version_id"]] for row in group]
        ends = [
            row["first_scored"] - 1 if version["read_to"] is None else version["read_to"]
            for row, version in zip(settled, known, strict=True)
        ]
        novel_from = [row["first_novel"] for row in known]
        versions = {row["channel_id"]: row["version_id"] for row in group}
        with self._running(comparing_steps(setting_of(group[0]), self.reader.kind)) as running:
            running.load("cohort", cohort_of(group, read_until=ends))
            earliest = min(row["read_from"] for row in group)
            rows = reading_steps(self.reader.readings(assets_of(group), earliest))
            running.put("identified", rows.query("identified", running.placed))
            again = {row["channel_id"]: row for row in running.rows("reread")}
            reread = [again.get(row["channel_id"]) for row in group]
            # Where no row came since the last run, its last buckets can be compared, too.
            same = [row is not None and row["rows_now"] == row["rows_then"] for row in reread]
            until = [
                end if is_same else row["first_scored"] - 1
                for row, end, is_same in zip(settled, ends, same, strict=True)
            ]
            first = [
                FAR_AHEAD if is_same else row["first_bucket"]
                for row, is_same in zip(settled, same, strict=True)
            ]
            cohort = cohort_of(group, read_until=until, settled=first, novel_from=novel_from)
            running.load("cohort", cohort)
            differences = running.rows("compared")
            cells = running.rows("compared_novel")
        for row in differences:
            day = None if self.reader.kind.is_counter else row["day_no"]
            said = {name: row[name] for name in _COUNTED}
            self.note(versions[row["channel_id"]], "scored", day=day, since=row["since"], **said)
        told = {row["channel_id"] for row in differences}
        for row in cells:
            if row["channel_id"] not in told:  # else it follows from the buckets
                what = "novel cells that the source does not give"
                said = {name: row[name] for name in ("differing", "since")}
                self.note(versions[row["channel_id"]], "novel cells", what=what, **said)
        for key, row in again.items():
            if not row["ends_now"] and key not in told:
                what = "the last run ended at an instant at which the source has no row"
                self.note(versions[key], "runs", what=what, differing=1)

    def calibration(self, group: Sequence[Row]) -> None:
        """Compare what the frozen intervals of pools of one setting teach now with what they taught."""
        # Blocks are numbered in the order of names. A channel may be of two pools, one of them retired.
        group = sorted(group, key=lambda row: (row["asset"].encode(), row["channel"].encode()))
        group = [{**row, "channel_id": number} for number, row in enumerate(group, start=1)]
        setting = setting_of(group[0])
        ends = [row["calibration_end"] for row in group]
        with self._running(relearning_steps(setting, self.reader.kind, *_asked(group[0]))) as running:
            cohort = cohort_of(group, read_from=LONG_AGO, read_until=ends, first_bucket=0)
            running.load("cohort", cohort)
            edges = running.rows("calibration_range")[0]
            # No sample before an interval decides what is learnt in it, unless by standing still.
            earliest = edges["earliest"] if setting.still_after is None else LONG_AGO
            healthy = self.reader.readings(assets_of(group), earliest, edges["latest"])
            rows = reading_steps(healthy)
            running.put("identified", rows.query("identified", running.placed))
            counted = self.session.rows(rows.query("recount", running.placed))
            changed = running.rows("relearnt")
            otherwise = [*running.rows("certified"), *running.rows("certified_extents")]
        cells = {row["support_id"]: row["differing"] for row in changed}
        now_read = {row["channel_id"]: row["calibration_readings"] for row in counted}
        came = set(cells)
        for row in group:
            then, found = row["calibration_readings"], now_read.get(row["channel_id"], 0)
            if found != then:
                came.add(row["support_id"])
            elif row["is_active"] and row["counted_readings"] not in (None, found):
                what = "the last run that counted rows of calibration found another number"
                self.note(row["version_id"], "runs", what=what, differing=1)
            if row["is_active"] and (found != then or row["support_id"] in cells):
                said = {"samples_then": then, "samples_now": found}
                differing = cells.get(row["support_id"], 0)
                self.note(row["version_id"], "calibration", **said, differing=differing)
        support_of = {row["version_id"]: row["support_id"] for row in group}
        member = {support: version for version, support in reversed(support_of.items())}
        for row in otherwise:
            version = row.get("version_id", member.get(row.get("support_id")))
            if support_of[version] not in came:  # else it follows from that
                what = f"{_WORDS['certificate'][row['part']]} are not what calibration gives"
                self.note(version, "certificate", what=what, differing=row["differing"])

    def _running(self, steps: Any) -> Running:
        return Running(self.session, steps, self.state.tables.placed(), self.on_step)


def _taught(versions: Iterable[Row]) -> list[Row]:
    """Return the versions that have calibration, of the supports that a channel is scored by now."""
    rows = [row for row in versions if row["calibration_end"] is not None and row["lo"] is not None]
    used = {row["support_id"] for row in rows if row["is_active"]}
    return [row for row in rows if row["support_id"] in used]


def _learning(row: Row) -> str:
    return repr((setting_of(row), _asked(row)))


def _asked(row: Row) -> tuple[float, int]:
    return row["target_floor"], row["least_vectors"] or 1


def _place(row: Row) -> tuple[Any, ...]:
    since = row.get("since")
    named = (row["asset"] or "", row["channel"] or "", row["version"] or 0)
    return (*named, PARTS.index(row["part"]), LONG_AGO if since is None else since)


_COUNTED = ("samples_then", "samples_now", "differing")

_RESULT = columns(
    (WORD, "asset channel"),
    (COUNT, "version"),
    (WORD, "part what"),
    (COUNT, "day samples_then samples_now differing since"),
)
_CHECKED = columns(
    (COUNT, "version_id channel_id support_id parent_id version_no window_length stride still_after"),
    (COUNT, "context_rows run_up_from is_active first_bucket first_novel"),
    (WORD, "status reason"),
)
