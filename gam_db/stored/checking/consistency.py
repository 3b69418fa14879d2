"""Consistency of alarms: limits with calibration, judgements with buckets, episodes with judgements.

This module owns what must hold between the tables of alarms, for any source. It writes nothing.
:mod:`gam_db.stored.checking` compares the counts of calibration with the source.
"""

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate, groupby, pairwise
from operator import or_
from typing import NamedTuple

from sqlglot import exp

from gam_db.alarms import UNREPRESENTATIVE, assess, day_of, high, indicated
from gam_db.alarms.heights import UNSTATED, Height, Rate, by_table
from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.columns import counts, table_of
from gam_db.errors import ParameterError
from gam_db.method.adding import add
from gam_db.method.alarms import FAR, NEAR
from gam_db.stored.alarms.episodes import LIVE, changes, pending
from gam_db.stored.alarms.judging import BEFORE, UNTIL, buckets_of, judging_steps
from gam_db.stored.alarms.labels import DECISIONS, KINDS
from gam_db.stored.alarms.limits import CHOSEN, learnt
from gam_db.stored.checking.again import compared
from gam_db.stored.planning import Row, by
from gam_db.stored.state import State
from gam_db.study.running import Running

_NO_RATE, _DRIFTS, _TABLED = "none", "drifting", "table"
_BASES = ("replay", "extrapolated", _TABLED, _DRIFTS, _NO_RATE)

#: What a change of an episode leaves it as.
_LEAVES = {
    **{"opened": ("open",), "reopened": ("open",), "ended": ("ended",), "changed": ("open", "ended")},
    **{status: (status,) for status in ("merged", "withdrawn", "recalibrated")},
    "labelled": ("open", "ended", "recalibrated"),
}

#: What a run would have made beside what is stored: nothing.
NOTHING_NEW = {
    "new_buckets": counts("channel_id bucket_no first_time last_time novel"),
    "stamp": counts("run_id"),
}


class Inconsistency(NamedTuple):
    """Something that does not hold: of which version (None: of none), where, what, how often."""

    version_id: int | None
    part: str
    what: str
    differing: int = 1
    since: int | None = None


def inconsistencies(
    state: State, monitor_id: int, kind: TimeKind, versions: Mapping[int, Row], oldest: Sequence[Row]
) -> Iterator[Inconsistency]:
    """Give what does not hold between the tables of alarms.

    Versions are rows of the step *checked*, and ``oldest`` those of *oldest_buckets*.
    """
    yield from _limits(state, monitor_id, kind, versions)
    begun = [{**versions[row["version_id"]], **row} for row in oldest]
    for buckets, group in groupby(sorted(begun, key=buckets_of), key=buckets_of):
        yield from _judgements(state, buckets, list(group))
    slots = {"monitor_id": monitor_id}
    history = state.rows("stored/checking/episode_history", slots)
    channels = {
        row["channel_id"]: row["asset"] for row in state.rows("stored/state/monitor_channels", slots)
    }
    yield from _episodes(history, channels, versions)
    active = [row for row in versions.values() if row["is_active"]]
    wrong = by("version_id", _unlike(state, monitor_id, active))
    for row in active:
        if episodes := wrong.get(row["version_id"]):
            since = min(episode["first_time"] for episode in episodes)
            what = "episodes that are not those of the judgements"
            yield Inconsistency(row["version_id"], "episodes", what, len(episodes), since)
    for row in state.rows("stored/checking/inconsistent_bands", slots):
        what = "judgements whose bands are not all of their vectors"
        yield Inconsistency(row["version_id"], "episodes", what, row["differing"])
    yield from _labels(state.rows("stored/alarms/labels", slots), history, channels)


# Limits


def _limits(
    state: State, monitor_id: int, kind: TimeKind, versions: Mapping[int, Row]
) -> Iterator[Inconsistency]:
    """Hold the limits of active versions to what calibration counted."""
    rows = state.rows("stored/checking/recorded_limits", {"monitor_id": monitor_id})
    with learnt(state, monitor_id) as work:
        version_of = {row["channel_id"]: row["version_id"] for row in work.rows("limit_channels")}
        learnt_limits: dict[int, dict[int, Row]] = defaultdict(dict)
        for row in work.rows("learnt_limits"):
            learnt_limits[version_of[row["channel_id"]]][row["g"]] = row
    day = day_of(kind)
    for rows_of in learnt_limits.values():
        assess(rows_of[NEAR], day)
    for version, limit_rows in by("version_id", rows).items():
        if not versions[version]["is_active"]:
            continue
        numbers, begins = ([row[name] for row in limit_rows] for name in ("limit_no", "from_judgement"))
        if numbers != list(range(1, len(limit_rows) + 1)) or begins[0] != 0 or begins != sorted(begins):
            yield Inconsistency(version, "limits", "numbers are missing, or judgements without a limit")
        if version in learnt_limits:
            off = accumulate((row["cause"] == "false_alarm" for row in limit_rows), or_)
            pairs = zip(limit_rows, off, strict=True)
            wrong = sum(not _follows(row, learnt_limits[version], is_off) for row, is_off in pairs)
            if wrong:
                yield Inconsistency(version, "limits", "limits that calibration does not give", wrong)


def _follows(row: Row, learnt_limits: Mapping[int, Row], is_off: bool) -> bool:
    """Tell whether a limit is what calibration gives, as far as it does not hang on other channels."""
    near = learnt_limits[NEAR]
    reason = UNREPRESENTATIVE if is_off else near["reason"]
    wanted = {name: near[name] for name in ("blocks", "judgements_per_day", "order_ratio")}
    wanted["reason"] = reason
    if reason is not None:
        wanted |= dict.fromkeys(CHOSEN)
        if near["hi_limit"] is not None and reason != UNREPRESENTATIVE:
            wanted |= indicated(near["hi_limit"], near["window_length"])
        return row["g"] in learnt_limits and _same(row, wanted)
    basis, quarters, rate = row["basis"], row["quarters"], row["rate"]
    try:
        wanted_rate = Rate.of(row["asked"])
    except ParameterError:
        return False
    if (
        basis not in _BASES
        or row["g"] != (FAR if basis == _DRIFTS else NEAR)
        or (quarters is None or rate is None or not rate > 0)
        or (basis == _NO_RATE and quarters != UNSTATED)
        or (basis == _TABLED and quarters != by_table(rate, row["blocks"]).quarters)
    ):
        return False
    if wanted_rate.days is None:
        wanted["rate"] = wanted_rate.per_judgement(None, 0.0)
    wanted |= {name: learnt_limits[row["g"]][name] for name in ("centre", "spread")}
    wanted |= high({**row, **wanted}, Height(row["quarters"], row["basis"]))
    return _same(row, wanted)


def _same(row: Row, wanted: Row) -> bool:
    return all(
        math.isclose(row[name], value, rel_tol=1e-12)
        if isinstance(value, float) and row[name] is not None
        else row[name] == value
        for name, value in wanted.items()
    )


# Judgements and episodes


def _judgements(state: State, buckets: int, group: Sequence[Row]) -> Iterator[Inconsistency]:
    """Judge the versions with one number of buckets anew from stored rows, each as its own channel."""
    until = []
    for row in group:
        oldest = row["oldest_judgement"] or 0
        # Evidence hangs on judgements before, which pruning may have taken.
        first = max(-(-row["oldest_bucket"] // buckets), oldest + BEFORE if oldest else 0)
        key = row["version_id"]
        judged = {"first_bucket": FAR_AHEAD, "first_judgement": first}
        until.append({"channel_id": key, "version_id": key, **judged})
    steps = judging_steps(buckets, exp.true(), exp.true())
    add(steps, "stored/checking/recorded_judgements")
    with Running(state.session, steps, state.tables.nodes()) as running:
        running.load("judged_until", table_of(until, UNTIL))
        for step, schema in NOTHING_NEW.items():
            running.load(step, table_of([], schema))
        differences = compared(running, "judgement", "judgement_rows", "recorded_judgements")
    active = {row["version_id"] for row in group if row["is_active"]}
    for row in differences:
        since = row["since"] if row["owner_id"] in active else None
        what = "judgements that their buckets and limits do not give"
        yield Inconsistency(row["owner_id"], "judgements", what, row["differing"], since)


def _unlike(state: State, monitor_id: int, active: Sequence[Row]) -> list[Row]:
    """Return what the next run would have to change of the episodes, if it followed all judgements.

    What a script has appended it follows in any case.
    """
    due = {row["version_id"] for row in pending(state, active, 0)} if active else set()
    active = [row for row in active if row["version_id"] not in due]
    judged = dict.fromkeys((row["version_id"] for row in active), 0)
    version_ids = judged.keys()
    unlike: list[Row] = []
    for _, group in groupby(sorted(active, key=buckets_of), key=buckets_of):
        rows = changes(state, monitor_id, list(group), judged).rows
        unlike += [row for row in rows if row["version_id"] in version_ids]
    return unlike


def _episodes(
    history: Sequence[Row], channels: Mapping[int, str], versions: Mapping[int, Row]
) -> Iterator[Inconsistency]:
    """Hold the history of episodes to itself."""
    opened = [row["episode_id"] for row in history if row["what"] == "opened"]
    if [row["seq"] for row in history] != list(range(1, len(history) + 1)):
        yield Inconsistency(None, "episodes", "numbers of changes are missing or there twice")
    if opened != list(range(1, len(opened) + 1)):
        yield Inconsistency(None, "episodes", "numbers of episodes that were not given once, in order")
    of_episode = by("episode_id", history)
    for rows in of_episode.values():
        if not all(_is_change(row, of_episode, channels, versions) for row in rows) or not all(
            before["status"] in LIVE or (row["what"], row["status"]) == ("labelled", before["status"])
            for before, row in pairwise(rows)
        ):
            what = "changes that do not follow from one another"
            yield Inconsistency(rows[-1]["version_id"], "episodes", what)


def _is_change(
    row: Row, changes: Mapping[int, object], channels: Mapping[int, str], versions: Mapping[int, Row]
) -> bool:
    """Tell whether a change of an episode may be one."""
    version = versions.get(row["version_id"])
    return (
        row["status"] in _LEAVES.get(row["what"], ())
        and (row["merged_into"] in changes if row["status"] == "merged" else row["merged_into"] is None)
        and row["merged_into"] != row["episode_id"]
        and row["channel_id"] in channels
        and (version is None or version["channel_id"] == row["channel_id"])
        and 0 <= row["onset"] <= row["first_judgement"] <= row["last_judgement"]
        and row["onset_time"] <= row["first_time"] <= row["last_time"]
        and row["evidence"] >= row["height"] > 0
        and row["is_proving"] in (0, 1)
    )


def _labels(
    labels: Sequence[Row], history: Sequence[Row], channels: Mapping[int, str]
) -> Iterator[Inconsistency]:
    """Hold labels to the episodes that they are about."""
    if [row["label_id"] for row in labels] != list(range(1, len(labels) + 1)):
        yield Inconsistency(None, "labels", "numbers are missing or there twice")
    marked = [row for row in history if row["what"] == "labelled"]
    of_episode = {
        (row["episode_id"], channels.get(row["channel_id"]), row["first_time"], row["last_time"])
        for row in marked
    }
    assets = set(channels.values())
    for row in labels:
        key = (row["episode_id"], row["asset"], row["time_from"], row["time_to"])
        if (
            row["kind"] not in KINDS
            or (row["kind"] in DECISIONS and row["until"] is not None)
            or (row["kind"] == "snoozed" and row["until"] is None)
            or (row["episode_id"] is not None and key not in of_episode)
            or row["asset"] not in assets
            or row["time_from"] > row["time_to"]
        ):
            what = f"label {row['label_id']} is of nothing, or contradicts itself"
            yield Inconsistency(None, "labels", what)
    labelled = {row["episode_id"] for row in labels}
    beside = by("asset", (row for row in labels if row["episode_id"] is None))
    for row in marked:
        if row["episode_id"] not in labelled and not any(
            label["time_from"] <= row["last_time"] and row["first_time"] <= label["time_to"]
            for label in beside.get(channels.get(row["channel_id"], ""), ())
        ):
            what = "an episode was labelled, and no label says how"
            yield Inconsistency(row["version_id"], "labels", what)
