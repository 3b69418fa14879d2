"""Episodes of a monitor: numbers that never change, and a row for each change (alarms, section 4).

This module assigns the numbers to recomputed episodes, and withdraws or merges the others. It follows
the stored judgements: without changes it writes nothing.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.columns import counts, table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import add
from gam_db.stored.alarms.judging import buckets_of
from gam_db.stored.planning import Row, by
from gam_db.stored.planning.reading import listed, near
from gam_db.stored.state import State, now
from gam_db.study.running import Running

#: States in which a number may be that of an episode again.
LIVE = ("open", "ended")

#: What is known of an episode beside its status.
_COMPARED = (
    *("version_id", "onset", "first_judgement", "last_judgement"),
    *("onset_time", "first_time", "last_time", "evidence", "height", "is_proving"),
)


#: Those that stay where the judgements of its begin were pruned.
_BEGIN = ("onset", "first_judgement", "onset_time", "first_time", "height", "is_proving")

#: Judgements before the first new one that an episode may go on from.
_NEAR = 10

#: What a change of status is called.
_WHAT = {("ended", "open"): "reopened", ("open", "ended"): "ended"}


class Log:
    """New rows of the history of a monitor's episodes, after the newest one of each."""

    def __init__(self, monitor_id: int, records: Sequence[Row]) -> None:
        self.rows: list[Row] = []
        self._seq = max((row["seq"] for row in records), default=0)
        self._last = max((row["episode_id"] for row in records), default=0)
        self._shared = {"monitor_id": monitor_id, "noticed_at": now(), "merged_into": None}

    def add(self, what: str, row: Row, **changes: object) -> None:
        """Note a change."""
        self._seq += 1
        self.rows.append({**row, **self._shared, **changes, "seq": self._seq, "what": what})

    def opened(self, row: Row) -> None:
        """Log an episode under a new number."""
        self._last += 1
        self.add("opened", row, episode_id=self._last, status="open")
        if row["status"] == "ended":
            self.add("ended", row, episode_id=self._last)

    def keep(self, state: State) -> None:
        """Append the rows."""
        state.append_rows("episode", self.rows)


def records_of(state: State, monitor_id: int) -> list[Row]:
    """Return the newest row of each episode of a monitor."""
    return state.rows("stored/alarms/episode_records", {"monitor_id": monitor_id})


def follow(state: State, monitor_id: int, group: Sequence[Row], judged: Mapping[int, int]) -> None:
    """Let the episodes of some channels be those of their stored judgements.

    Looked at again are the judgements from the tenth before the first one written anew (``judged``, of
    each version that has, or had, a limit), and those of the episodes that reach them or are open.
    """
    changes(state, monitor_id, group, judged).keep(state)


def with_pending(
    state: State, group: Sequence[Row], judged: Mapping[int, int], newest_run: int
) -> dict[int, int]:
    """Return the judgements to follow, with those that a script has appended since.

    No version's newest run is older than ``newest_run``.
    """
    if not pending(state, group, newest_run):
        return dict(judged)
    length = {row["version_id"]: buckets_of(row) for row in group}
    since = {
        row["version_id"]: row["from_bucket"] // length[row["version_id"]]
        for row in pending(state, group, 0)
    }
    return {version: min(first, since.get(version, first)) for version, first in judged.items()}


def pending(state: State, group: Sequence[Row], since: int) -> list[Row]:
    """Return the versions of which a script appended judgements after the newest run of gam score.

    Runs before ``since`` are not looked at.
    """
    among = listed(exp.column("version_id", table="run"), (row["version_id"] for row in group))
    near: exp.Expr = exp.column("run_id", table="run") >= since
    return state.rows("stored/alarms/pending_runs", {"among": among, "near": near})


def changes(state: State, monitor_id: int, group: Sequence[Row], judged: Mapping[int, int]) -> Log:
    """Return what :func:`follow` would append."""
    records = records_of(state, monitor_id)
    live = by("channel_id", (row for row in records if row["status"] in LIVE))
    episodes, ranges = _judged_episodes(state, group, live, judged)
    log = Log(monitor_id, records)
    for row in sorted(group, key=lambda row: row["channel_id"]):
        channel = row["channel_id"]
        if channel in episodes or channel in live:
            judged_range = ranges.get(channel, {"version_id": row["version_id"]})
            _match(log, episodes.get(channel, []), live.get(channel, []), judged_range)
    return log


def _judged_episodes(
    state: State, group: Sequence[Row], live: Mapping[int, list[Row]], judged: Mapping[int, int]
) -> tuple[dict[int, list[Row]], dict[int, Row]]:
    """Return the episodes of the judgements that are examined, and the judgements, by channel."""
    followed = [
        {**row, "since_judgement": _since(row, live, judged[row["version_id"]])}
        for row in group
        if row["version_id"] in judged
    ]
    if not followed:
        return {}, {}
    # Apart: for the sake of one long episode, the judgements of all channels are not read.
    parts: tuple[list[Row], list[Row]] = [], []
    for row in followed:
        parts[row["since_judgement"] < max(judged[row["version_id"]] - _NEAR, 1)].append(row)
    close = exp.or_(*(_from(rows, "since_judgement") for rows in parts if rows))
    steps = Pipeline(small=frozenset({"merged"}))
    add(steps, "stored/alarms/open_judgements", {"near": close}, name="opened")
    add(steps, "alarms/merged")
    add(steps, "stored/alarms/judged_ranges", {"near": close})
    with Running(state.session, steps, state.tables.nodes()) as running:
        running.load("followed", table_of(followed, _FOLLOWED))
        running.keep("merged")
        onsets = running.rows("merged")
        if not onsets and not any(live.get(row["channel_id"]) for row in followed):
            return {}, {}
        ranges = {row["channel_id"]: row for row in running.rows("judged_ranges")}
        if not onsets:
            return {}, ranges
        version = {row["channel_id"]: row for row in followed}
        begun = [{**version[row["channel_id"]], "onset": row["onset"]} for row in onsets]
        add(steps, "stored/alarms/raised_episodes", {"near": _from(begun, "onset")})
        return by("channel_id", running.rows("raised_episodes")), ranges


def _since(row: Row, live: Mapping[int, list[Row]], first: int) -> int:
    """Return the first judgement of a channel to examine, for its first new judgement."""
    since = max(first - _NEAR, 0)
    episodes = [
        episode
        for episode in live.get(row["channel_id"], ())
        if episode["version_id"] == row["version_id"]
    ]
    for episode in sorted(episodes, key=lambda episode: -int(episode["last_judgement"])):
        if episode["status"] == "open" or episode["last_judgement"] >= since:
            since = min(since, episode["onset"])
    return since


def _from(rows: Sequence[Row], judgement: str) -> exp.Expr:
    """Return a condition on *bucket* that holds for the judgements from a column of rows on."""
    return near([{**row, "first_bucket": row[judgement] * buckets_of(row)} for row in rows])


def _match(log: Log, episodes: list[Row], live: list[Row], judged: Mapping[str, Any]) -> None:
    """Assign numbers to the episodes of a channel, and log what became of its former ones (live)."""
    version, first = judged["version_id"], judged.get("first_judgement") or 0
    begin, newest = judged.get("first_scored"), judged.get("last_time")
    free = [
        row
        for row in sorted(live, key=lambda row: row["episode_id"])
        if (
            row["last_judgement"] >= first
            if row["version_id"] == version
            else begin is not None and row["last_time"] >= begin
        )
    ]
    taken: set[int] = set()
    for row in sorted(episodes, key=lambda row: row["first_judgement"]):
        goes_on = judged.get("is_judged") == 1 and row["last_judgement"] == judged["last_judgement"]
        row["status"] = "open" if goes_on else "ended"
        row["onset_time"] = row["first_time"] if row["onset_time"] is None else row["onset_time"]
        meets = [
            episode
            for episode in free
            if episode["episode_id"] not in taken
            and episode["first_time"] <= row["last_time"]
            and row["first_time"] <= episode["last_time"]
        ]
        taken |= {episode["episode_id"] for episode in meets}
        if not meets:
            log.opened(row)
            continue
        mine = meets[0]
        if mine["version_id"] == version and mine["onset"] < first:  # its begin was pruned
            row |= {name: mine[name] for name in _BEGIN}
            row["evidence"] = max(row["evidence"], mine["evidence"])
        if any(row[name] != mine[name] for name in ("status", *_COMPARED)):
            what = _WHAT.get((mine["status"], row["status"]), "changed")
            log.add(what, row, episode_id=mine["episode_id"])
        for episode in meets[1:]:
            log.add("merged", episode, status="merged", merged_into=mine["episode_id"])
    for row in (row for row in live if row["episode_id"] not in taken):
        if row["version_id"] == version:
            if row in free:
                log.add("withdrawn", row, status="withdrawn")
        elif begin is None or row["last_time"] < begin or (newest or LONG_AGO) >= row["last_time"]:
            if row["status"] == "open":
                log.add("recalibrated", row, status="recalibrated")
            elif row in free:
                log.add("withdrawn", row, status="withdrawn")


_FOLLOWED = counts("channel_id version_id since_judgement")
