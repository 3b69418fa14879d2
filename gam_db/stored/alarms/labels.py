"""Alarms for people: the episodes, their labels, and the effects of labels.

The view ``gam_state_labelled_episode`` decides which episode needs attention; this module owns the kinds
of labels.
"""

import datetime as dt
from collections.abc import Sequence

import pyarrow as pa

from gam_db.alarms import UNREPRESENTATIVE
from gam_db.clock import Instant, TimeKind, instant, shown_instant
from gam_db.columns import COUNT, SHARE, TRUTH, WORD, columns
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.errors import ParameterError, UserError, nearest
from gam_db.method.adding import add
from gam_db.stored.alarms.episodes import Log, records_of
from gam_db.stored.alarms.limits import CHOSEN
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import Reader
from gam_db.stored.sources import source_of
from gam_db.stored.state import State, kind_of, now
from gam_db.units import time_type

_AXIS = ("samples_before", "place", "value_from", "value_to", "displacement")

#: What an episode can be, and what puts it aside for a while.
DECISIONS = ("true_fault", "false_alarm", "maintenance", "new_program")
PAUSES = ("acknowledged", "snoozed")
KINDS = (*DECISIONS, *PAUSES)

#: Decisions by which a machine was not as it is when healthy: no later calibration learns from that.
UNHEALTHY = ("true_fault", "maintenance")


def alarms(state: State, name: str) -> pa.Table:
    """Return the episodes of a monitor, those that need attention first.

    Returns:
        One row per episode: episode, asset, channel, status (proving: it opened right after calibration
        and asks for a decision; open; high: it is open, and its indicator opened it, since its
        judgements have no limit; ended, merged, withdrawn, recalibrated), needs_attention (as of the
        newest run), since (when evidence left 0), opened, last_time, sure (highest evidence / height;
        NULL where its indicator opened it), basis, stated_rate (per judgement; NULL where none can be
        stated), asked, signals_open (of the machine), incident (the smallest number of the episodes of
        the machine that opened within two judgements of one another), signals_together (how many they
        are), label, label_until (UTC),
        note, merged_into, onset, first_judgement, last_judgement, evidence, height, seq. Times are as in
        the source.

    Raises:
        ConfigurationError: there is no such monitor.
    """
    time = time_type(kind_of(state.monitor(name)))
    schema = columns(
        (COUNT, "episode"),
        (WORD, "asset channel status"),
        (TRUTH, "needs_attention"),
        (time, "since opened last_time"),
        (SHARE, "sure"),
        (WORD, "basis"),
        (SHARE, "stated_rate"),
        (WORD, "asked"),
        (COUNT, "signals_open incident signals_together"),
        (WORD, "label"),
        (pa.timestamp("us"), "label_until"),
        (WORD, "note"),
        (COUNT, "merged_into onset first_judgement last_judgement"),
        (COUNT, "evidence height seq channel_id version_id"),
    )
    table = state.fetch("stored/alarms/alarm_rows", {"monitor": template.text(name)})
    return table.rename_columns(schema.names).cast(schema)


def judgements(state: State, episode: Row) -> list[Row]:
    """Return the judgements of an episode (a row of :func:`alarms`), from its onset to its last one."""
    ends = {"first": episode["onset"], "last": episode["last_judgement"]}
    return state.rows("stored/alarms/raised_judgements", {"version_id": episode["version_id"], **ends})


def bands(state: State, name: str, episode: Row) -> list[Row]:
    """Return the parts of the range in which an episode (a row of :func:`alarms`) stands out.

    Returns:
        The three most striking, in order, none without excess: place (below, within or above the range
        of calibration), value_from, value_to (in units of the signal, None where there is none), novel
        and visits (vectors of its first five judgements), calibration_novel, calibration_visits, excess
        (novel less what as many visits held in calibration). Nothing before a run counted them.
    """
    return state.rows("stored/alarms/alarm_bands", {**_of(name, episode), "most": 3})


def cells(state: State, name: str, episode: Row) -> list[Row]:
    """Return the ten commonest novel cells of an episode (a row of :func:`alarms`).

    Returns:
        In order: cell_key, visits, first_tick and last_tick (integer time), steps (to the nearest
        healthy cell of the same program: the largest on any axis, in bins), program (None where states
        are of none), and axes, from the newest sample back, each with
        samples_before, place, value_from, value_to and displacement (from that cell, in bins). Nothing
        where the episode is of an older version, or its cells were pruned.
    """
    ranked: dict[int, Row] = {}
    shared = ("cell_key", "visits", "first_tick", "last_tick", "steps", "program")
    for row in state.rows("stored/alarms/alarm_cells", _of(name, episode)):
        cell = ranked.setdefault(row["cell_rank"], {key: row[key] for key in shared} | {"axes": []})
        cell["axes"].append({key: row[key] for key in _AXIS})
    return list(ranked.values())


def raw_rows(state: State, name: str, episode: Row) -> str | None:
    """Return the SQL that shows the rows of the source from an episode's onset to its end.

    None where the source cannot be looked at from here.
    """
    monitor = state.monitor(name)
    kind = kind_of(monitor)
    try:
        source = source_of(monitor, [episode["channel"]])
        reader = Reader(state.session, source, kind, name)
    except UserError:
        return None
    ends = (instant(episode[edge], kind, edge) for edge in ("since", "last_time"))
    return reader.raw(episode["asset"], episode["channel"], *ends)


def _of(name: str, episode: Row) -> dict[str, template.Slot]:
    keys = {"episode_id": episode["episode"], "version_id": episode["version_id"]}
    return {"monitor": template.text(name), **keys}


def events(state: State, name: str, after: int = 0) -> pa.Table:
    """Return the changes of a monitor's episodes after one that is known, in order.

    Returns:
        One row per change: seq, episode_id, what, noticed_at (UTC), asset, channel, status, is_proving,
        basis, incident_id, signals_together, is_message (1 for the changes that an incident is told by:
        its first opening, and the first of others that were noticed together).
    """
    state.monitor(name)
    return state.fetch("stored/alarms/event_rows", {"monitor": template.text(name), "after": after})


def limits(state: State, name: str) -> list[Row]:
    """Return by what each channel of a monitor is judged now, or why it is not."""
    steps = Pipeline()
    add(steps, "stored/state/active", {"monitor_id": state.monitor(name)["monitor_id"]})
    add(steps, "stored/alarms/limit_rows")
    query = steps.query("limit_rows", state.tables.nodes())
    return state.session.rows(query)


def label(
    state: State,
    name: str,
    kind: str,
    episode: int | None = None,
    asset: str | None = None,
    span: tuple[Instant, Instant] | None = None,
    note: str | None = None,
    until: dt.datetime | None = None,
    instead: bool = False,
) -> list[int]:
    """Store a label on an episode, or on a machine in an interval of time; return the labelled episodes.

    Arguments and result are those of :meth:`gam_db.Monitor.label`; ``kind`` is one of :data:`KINDS`.

    Raises:
        ParameterError: there is no such episode or asset, or an earlier label contradicts it.
    """
    monitor = state.monitor(name)
    monitor_id, time = monitor["monitor_id"], kind_of(monitor)
    _check_kind(kind, until)
    ends = None if span is None else _ticks(span, time)
    ends_at = None if until is None else instant(until, TimeKind.TIMESTAMP, "until")
    with state.session.transaction():
        state.lock(monitor_id)
        records = records_of(state, monitor_id)
        channels = state.rows("stored/state/monitor_channels", {"monitor_id": monitor_id})
        assets = {row["channel_id"]: row["asset"] for row in channels}
        if episode is not None:
            about = [_episode(episode, records)]
            asset = assets[about[0]["channel_id"]]
            ends = about[0]["first_time"], about[0]["last_time"]
        elif asset is None or ends is None:
            raise ParameterError("A label needs an episode, or an asset and an interval of time.")
        else:
            if asset not in assets.values():
                near = nearest(asset, sorted(set(assets.values())))
                raise ParameterError(f"There is no asset {asset!r} in the monitor {name!r}{near}")
            about = [
                row
                for row in records
                if row["status"] not in ("merged", "withdrawn")
                and assets[row["channel_id"]] == asset
                and _meet(*ends, row)
            ]
        labels = state.rows("stored/alarms/labels", {"monitor_id": monitor_id})
        if kind in DECISIONS and not instead:
            _check_agrees(kind, about, asset, labels)
        number = 1 + max((row["label_id"] for row in labels), default=0)
        row = {
            **{"monitor_id": monitor_id, "label_id": number, "episode_id": episode, "asset": asset},
            **{"time_from": ends[0], "time_to": ends[1], "kind": kind},
            **{"note": note, "until": ends_at, "created": now()},
        }
        state.append_rows("label", [row])
        log = Log(monitor_id, records)
        off = {
            record["version_id"] for record in about if kind == "false_alarm" and record["is_proving"]
        }
        for record in about:
            log.add("labelled", record)
            if record["version_id"] in off and record["status"] == "open":
                log.add("ended", record, status="ended")
        log.keep(state)
        _switch_off(state, name, off)
    return [record["episode_id"] for record in about]


def left_out(state: State, name: str) -> dict[str, list[tuple[Instant, Instant]]]:
    """Return the closed intervals that labels exclude from calibration, by asset, in source time.

    Only the decision that replaced another one counts. An episode counts from its onset to its current
    end.
    """
    monitor = next((row for row in state.monitors() if row["name"] == name), None)
    if monitor is None:
        return {}
    slots, kind = {"monitor_id": monitor["monitor_id"]}, kind_of(monitor)
    decisions = [row for row in state.rows("stored/alarms/labels", slots) if row["kind"] in DECISIONS]
    episodes = {row["episode_id"]: row for row in records_of(state, slots["monitor_id"])}
    spans: dict[str, list[tuple[Instant, Instant]]] = {}
    for number, row in enumerate(decisions, start=1):
        if row["kind"] in UNHEALTHY and not any(_replaces(later, row) for later in decisions[number:]):
            episode = {"onset_time": row["time_from"], "last_time": row["time_to"]}
            episode = episodes.get(row["episode_id"], episode)
            begin = min(row["time_from"], episode["onset_time"])
            end = max(row["time_to"], episode["last_time"])
            span = shown_instant(begin, kind), shown_instant(end, kind)
            spans.setdefault(row["asset"], []).append(span)
    return spans


def _replaces(later: Row, row: Row) -> bool:
    """Tell whether a later decision is on the same episode, or on the machine over all that time."""
    of_it = row["episode_id"] is not None and later["episode_id"] == row["episode_id"]
    around = later["time_from"] <= row["time_from"] and row["time_to"] <= later["time_to"]
    return bool(of_it or (later["asset"] == row["asset"] and around))


def _check_kind(kind: str, until: dt.datetime | None) -> None:
    if kind not in KINDS:
        raise ParameterError(f"A label is one of {', '.join(KINDS)}, not {kind!r}.")
    if kind == "snoozed" and until is None:
        raise ParameterError("A snooze needs an end; set until.")
    if kind in DECISIONS and until is not None:
        raise ParameterError(f"{kind} has no end; leave out until, or use acknowledged or snoozed.")


def _ticks(span: tuple[Instant, Instant], kind: TimeKind) -> tuple[int, int]:
    start, end = (instant(edge, kind, "label") for edge in span)
    if end < start:
        raise ParameterError(
            f"The label ends at {shown_instant(end, kind)}, before it begins at "
            f"{shown_instant(start, kind)}."
        )
    return start, end


def _episode(number: int, records: Sequence[Row]) -> Row:
    row = next((row for row in records if row["episode_id"] == number), None)
    if row is None:
        newest = max((row["episode_id"] for row in records), default=None)
        last = "there is none yet" if newest is None else f"the newest is {newest}"
        raise ParameterError(f"There is no episode {number}; {last}.")
    if row["status"] == "merged":
        raise ParameterError(
            f"Episode {number} is now a part of episode {row['merged_into']}; label that episode."
        )
    if row["status"] == "withdrawn":
        raise ParameterError(
            f"Episode {number} was withdrawn because of later data, so there is nothing to label."
        )
    return row


def _check_agrees(kind: str, about: Sequence[Row], asset: str, labels: Sequence[Row]) -> None:
    """Refuse a decision that contradicts another one on the same episode or time of the machine."""
    decisions = [row for row in reversed(labels) if row["kind"] in DECISIONS]
    for row in about:
        decision = next((decision for decision in decisions if _is_about(decision, row, asset)), None)
        if decision is not None and decision["kind"] != kind:
            raise ParameterError(
                f"Episode {row['episode_id']} is already labelled {decision['kind']}, which {kind} "
                "contradicts; if that was wrong, add --instead."
            )


def _is_about(label: Row, episode: Row, asset: str) -> bool:
    if label["episode_id"] is not None:
        return bool(label["episode_id"] == episode["episode_id"])
    return bool(label["asset"] == asset and _meet(label["time_from"], label["time_to"], episode))


def _meet(start: int, end: int, episode: Row) -> bool:
    """Tell whether an episode and a time have an instant in common."""
    return bool(episode["first_time"] <= end and start <= episode["last_time"])


def _switch_off(state: State, name: str, versions: set[int]) -> None:
    """Let channels be judged no more until they are calibrated again."""
    rows = []
    for row in limits(state, name) if versions else ():
        if row["version_id"] in versions and row["reason"] is None:
            (begin,) = state.rows("stored/alarms/next_judgement", {"version_id": row["version_id"]})
            why = {"reason": UNREPRESENTATIVE, "cause": "false_alarm", "created": now()}
            numbers = {"limit_no": row["limit_no"] + 1, "from_judgement": begin["next_no"] or 0}
            rows.append({**row, **dict.fromkeys(CHOSEN), **why, **numbers})
    if rows:
        state.append_rows("limit", rows)
