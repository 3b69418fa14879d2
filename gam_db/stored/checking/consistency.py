"""Consistency of alarms: limits with calibration, judgements with buckets, episodes with judgements.

This module owns what must hold between the tables of alarms, whatever the source. It writes nothing.
What calibration counted for them is compared with the source by :mod:`gam_db.stored.checking`.
"""

import math
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from itertools import accumulate, groupby, pairwise
from operator import itemgetter, or_
from typing import NamedTuple

from gam_db.alarms import assess, day_of, high
from gam_db.alarms.heights import UNSTATED, Height, Rate, by_table
from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.columns import counts, table_of
from gam_db.errors import ParameterError
from gam_db.method.alarms import FAR, NEAR
from gam_db.stored.alarms.episodes import LIVE
from gam_db.stored.alarms.judging import buckets_of
from gam_db.stored.alarms.limits import CHOSEN, learnt
from gam_db.stored.alarms.told import DECISIONS, KINDS, UNREPRESENTATIVE
from gam_db.stored.checking.soundness import judging_steps
from gam_db.stored.planning import Row, by
from gam_db.stored.state import State
from gam_db.study.running import Running

_NO_RATE, _DRIFTS, _TABLED = "none", "drifting", "table"
_BASES = ("replay", "extrapolated", _TABLED, _DRIFTS, _NO_RATE)

#: What a change of an episode leaves it as.
_LEAVES = {
    **{"opened": ("open",), "reopened": ("open",), "ended": ("ended",), "changed": ("open", "ended")},
    **{one: (one,) for one in ("merged", "withdrawn", "recalibrated")},
    "labelled": ("open", "ended", "recalibrated"),
}

#: Columns of an episode that follow from judgements; the rest only while those of its begin are kept.
_ended = itemgetter("version_id", "last_judgement", "last_time", "status")
_WHOLE = (
    *("onset", "first_judgement", "onset_time", "first_time"),
    *("evidence", "height", "is_proving"),
)


class Inconsistency(NamedTuple):
    """Something that does not hold: of which version (None: of none), where, what, how often."""

    version_id: int | None
    part: str
    what: str
    differing: int = 1
    since: int | None = None


class Judged(NamedTuple):
    """What judging anew gives: the episodes of all versions, and the oldest judgement of each."""

    episodes: list[Row]
    oldest: dict[int, int]


def inconsistencies(
    state: State, monitor_id: int, kind: TimeKind, versions: Mapping[int, Row]
) -> Iterator[Inconsistency]:
    """Give what does not hold between the tables of alarms; versions are rows of the step *checked*."""
    yield from _limits(state, monitor_id, kind, versions)
    judged = Judged([], {})
    by_length = sorted(versions.values(), key=buckets_of)
    for buckets, group in groupby(by_length, key=buckets_of):
        yield from _judgements(state, buckets, list(group), judged)
    slots = {"monitor_id": monitor_id}
    history = state.rows("stored/checking/episode_history", slots)
    channels = {
        row["channel_id"]: row["asset"] for row in state.rows("stored/state/known_channels", slots)
    }
    yield from _episodes(history, judged, channels, versions)
    for row in state.rows("stored/checking/inconsistent_bands", slots):
        what = "judgements whose bands are not all of their vectors"
        yield Inconsistency(row["version_id"], "episodes", what, row["differing"])
    yield from _labels(state.rows("stored/alarms/labels", slots), history, channels)


# Limits


def _limits(
    state: State, monitor_id: int, kind: TimeKind, versions: Mapping[int, Row]
) -> Iterator[Inconsistency]:
    """Hold the limits of active versions to what calibration counted."""
    rows = state.rows("stored/checking/kept_limits", {"monitor_id": monitor_id})
    with learnt(state, monitor_id) as work:
        version_of = {row["channel_id"]: row["version_id"] for row in work.rows("limit_channels")}
        said: dict[int, dict[int, Row]] = defaultdict(dict)
        for row in work.rows("learnt_limits"):
            said[version_of[row["channel_id"]]][row["g"]] = row
    day = day_of(kind)
    for rows_of in said.values():
        assess(rows_of[NEAR], day)
    for version, own in by("version_id", rows).items():
        if not versions[version]["is_active"]:
            continue
        numbers, begins = ([row[name] for row in own] for name in ("limit_no", "from_judgement"))
        if numbers != list(range(1, len(own) + 1)) or begins[0] != 0 or begins != sorted(begins):
            yield Inconsistency(version, "limits", "numbers are missing, or judgements without a limit")
        if version in said:
            off = accumulate((row["cause"] == "false_alarm" for row in own), or_)
            pairs = zip(own, off, strict=True)
            wrong = sum(not _follows(row, said[version], is_off) for row, is_off in pairs)
            if wrong:
                yield Inconsistency(version, "limits", "limits that calibration does not give", wrong)


def _follows(row: Row, said: Mapping[int, Row], is_off: bool) -> bool:
    """Tell whether a limit is what calibration gives, as far as it does not hang on other channels."""
    near = said[NEAR]
    reason = UNREPRESENTATIVE if is_off else near["reason"]
    wanted = {name: near[name] for name in ("blocks", "judgements_per_day", "order_ratio")}
    wanted["reason"] = reason
    if reason is not None:
        return row["g"] in said and _same(row, {**wanted, **dict.fromkeys(CHOSEN)})
    basis, quarters, rate = row["basis"], row["quarters"], row["rate"]
    try:
        asked = Rate.of(row["asked"])
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
    if asked.days is None:
        wanted["rate"] = asked.per_judgement(None, 0.0)
    wanted |= {name: said[row["g"]][name] for name in ("centre", "spread")}
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


def _judgements(
    state: State, buckets: int, group: Sequence[Row], judged: Judged
) -> Iterator[Inconsistency]:
    """Judge the versions of one number of buckets anew, and note what that gives."""
    with Running(state.session, judging_steps(buckets), state.tables.placed()) as running:
        keys = [{"channel_id": row["version_id"], "version_id": row["version_id"]} for row in group]
        running.load("judged_until", table_of(keys, counts("channel_id version_id")))
        found = running.rows("inconsistent_judgements")
        edges = running.rows("judged_edges")
        judged.oldest.update({row["channel_id"]: row["oldest_no"] for row in edges})
        judged.episodes.extend(running.rows("raised_again"))
    active = {row["version_id"] for row in group if row["is_active"]}
    for row in found:
        since = row["since"] if row["version_id"] in active else None
        what = "judgements that their buckets and limits do not give"
        yield Inconsistency(row["version_id"], "judgements", what, row["differing"], since)


def _episodes(
    history: Sequence[Row], judged: Judged, channels: Mapping[int, str], versions: Mapping[int, Row]
) -> Iterator[Inconsistency]:
    """Hold the history of episodes to itself, and the newest of it to the judgements."""
    opened = [row["episode_id"] for row in history if row["what"] == "opened"]
    if [row["seq"] for row in history] != list(range(1, len(history) + 1)):
        yield Inconsistency(None, "episodes", "numbers of changes are missing or there twice")
    if opened != list(range(1, len(opened) + 1)):
        yield Inconsistency(None, "episodes", "numbers of episodes that were not given once, in order")
    changes = by("episode_id", history)
    newest = [rows[-1] for rows in changes.values()]
    for rows in changes.values():
        if not all(_is_change(row, changes, channels, versions) for row in rows) or not all(
            before["status"] in LIVE or (row["what"], row["status"]) == ("labelled", before["status"])
            for before, row in pairwise(rows)
        ):
            what = "changes that do not follow from one another"
            yield Inconsistency(rows[-1]["version_id"], "episodes", what)
    active = {key for key, row in versions.items() if row["is_active"]}
    live = {
        _ended(row): row
        for row in newest
        if row["status"] in LIVE
        and row["version_id"] in active
        and row["last_judgement"] >= judged.oldest.get(row["version_id"], -FAR_AHEAD)
    }
    again = [row for row in judged.episodes if row["version_id"] in active]
    for row in again:
        row["status"] = "open" if row["is_open"] else "ended"
    there = {_ended(row): row for row in again}
    wrong = set(live.keys() ^ there.keys())
    for key in live.keys() & there.keys():
        row = there[key]
        is_whole = judged.oldest[row["version_id"]] <= row["onset"]
        if is_whole and any(live[key][name] != row[name] for name in _WHOLE):
            wrong.add(key)
    begins = {**there, **live}
    for version, ends in groupby(sorted(wrong), key=itemgetter(0)):
        starts = [begins[one]["first_time"] for one in ends]
        what = "episodes that are not those of the judgements"
        yield Inconsistency(version, "episodes", what, len(starts), min(starts))


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
    known = {row["episode_id"] for row in labels}
    beside = by("asset", (row for row in labels if row["episode_id"] is None))
    for row in marked:
        if row["episode_id"] not in known and not any(
            one["time_from"] <= row["last_time"] and row["first_time"] <= one["time_to"]
            for one in beside.get(channels.get(row["channel_id"], ""), ())
        ):
            what = "an episode was labelled, and no label says how"
            yield Inconsistency(row["version_id"], "labels", what)
