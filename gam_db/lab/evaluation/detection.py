"""Detection: how well raised values of the indicator agree with labelled events.

This module owns the public call :func:`detection`, and how labels, alarms and limits are read. Its rates
are those that the literature on anomaly detection uses: F1, false-alarm rate and missed-alarm rate of
values, and the lead of each event.
"""

import math
import numbers
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import clock
from gam_db.arguments import public
from gam_db.clock import TimeKind
from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.composing.pipeline import filled
from gam_db.engines.connecting import borrowed
from gam_db.engines.session import Session
from gam_db.errors import nearest, wrong
from gam_db.findings import Row
from gam_db.lab.evaluation.members import check_rows
from gam_db.lab.evaluation.steps import detection_steps, looking_steps
from gam_db.lab.evaluation.table import HealthTable, health_table, is_empty, read_from
from gam_db.reading.preparing import with_times_read
from gam_db.settings.source import Source, is_file

#: Ends of time, beyond which no margin reaches.
_FIRST, _LAST = -(2**63), 2**63 - 1

_INTERVALS = pa.schema(
    [("label_no", pa.int64()), ("asset", pa.string()), ("channel", pa.string())]
    + [(name, pa.int64()) for name in ("starts_at", "ends_at", "left_out_from", "left_out_until")]
)
_LIMITS = pa.schema([("asset", pa.string()), ("channel", pa.string()), ("hi_limit", pa.float64())])

_LEADS = pa.schema(
    [(name, pa.string()) for name in ("asset", "channel", "event")]
    + [(name, pa.int64()) for name in ("starts_at", "ends_at", "has_values", "lead_time")]
)

#: Columns for the ends of an interval, the first that tells time as the indicators do: those of a table
#: of labels, of :func:`gam_db.episodes` and of the view gam_alarm.
_ENDS = {"start": ("start", "first_time", "first_tick"), "finish": ("end", "last_time", "last_tick")}

#: Steps that are kept on the way, in order.
_TABLE_STEPS = ("raised", "timeline", "label_leads")


@public
@dataclass(frozen=True)
class Detection:
    """How well raised values agree with labelled events.

    Attributes:
        rates: a row per channel, per machine (channel NULL: it is raised while a channel is) and for all
            machines (asset NULL too): asset, channel, counted (values), left_out (values in a margin),
            raised, labelled, hits (both), f1, f1_chance (what as many raised values at a random place in
            time would give), false_alarm_rate, missed_alarm_rate (NULL where they would be 0 / 0),
            labels (that hold a value), labels_raised, lead_time (of the middle label that was raised, in
            microseconds or steps of the counter; negative: a delay).
        labels: a row per label and channel, or machine: asset, channel, event, starts_at, ends_at (times
            as lead_time, since 1970; 2^63 - 1: no end), has_values (0 where no value lies in it),
            lead_time (NULL where it was not raised).
        unmatched: labels that name no asset or channel of the indicators; they count nowhere.
        alarms_unmatched: alarms that name none.
        without_limit: channels that have no limit, and so are never raised.
        unit: of leads and times, "microseconds" or "steps".
    """

    rates: pa.Table
    labels: pa.Table
    unmatched: int
    alarms_unmatched: int
    without_limit: int
    unit: str


@public
def detection(
    health: Any,
    labels: Any,
    engine: Any = None,
    *,
    events: Sequence[str] = (),
    limit: float | None = None,
    limits: Any = None,
    alarms: Any = None,
    before: Any = 0,
    after: Any = 0,
    threads: int | None = None,
) -> Detection:
    """Compare raised values of health indicators with labelled events.

    A value is raised where its indicator is above the limit of its channel, or where its time lies in an
    alarm. It is labelled where its time lies in a label. The lead of a label is its start less the start
    of the run of raised values that reaches it, or less the first raised value inside it.

    Args:
        health: as for :func:`gam_db.evaluate`; it must tell time.
        labels: a relation with the columns asset, start, end (NULL: no end), and optionally channel
            (NULL: all channels) and event. Both ends belong to the label; a date is its first instant.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.
        events: the events that count; none: all labels.
        limit: a limit for all channels.
        limits: a relation with the columns asset, channel and hi_limit, such as the support table that
            gam run writes. Default: the column hi_limit of ``health``, else the support file beside it.
        alarms: a relation like ``labels``, the view gam_alarm, or what :func:`gam_db.episodes` returns:
            values are raised in these intervals instead. An open episode has no end, and a withdrawn
            one does not count; an episode counts from the start of the judgement that opened it.
        before: a length of time before a label in which values count neither way.
        after: the same after a label.
        threads: processor threads; None leaves DuckDB's own choice.

    Raises:
        UserError: see its subclasses; the message says what to mend.
    """
    with borrowed(engine, threads) as session:
        return detected(session, health, labels, events, limit, limits, alarms, before, after)


def detected(
    session: Session,
    health: Any,
    labels: Any,
    events: Sequence[str] = (),
    limit: float | None = None,
    limits: Any = None,
    alarms: Any = None,
    before: Any = 0,
    after: Any = 0,
) -> Detection:
    """Compare in an open session; see :func:`detection`."""
    if sum(source is not None for source in (limit, limits, alarms)) > 1:
        raise wrong("raised_by_one")
    if limit is not None:
        limit = _finite(limit)
    nodes = {
        what: session.relation(relation)
        for what, relation in (("labels", labels), ("alarms", alarms))
        if relation is not None
    }
    table = health_table(session, health)
    if table.kind is None:
        raise wrong("detection_without_time")
    kind = table.kind
    indicator = session.keep("indicator", table.indicator)
    candidates = session.rows(
        looking_steps(table.indicator).query("candidates", {"indicator": indicator})
    )
    check_rows(candidates, table)
    if not any(row["hi_values"] for row in candidates):
        raise wrong("no_value_yet")
    channels = {name_of(row) for row in candidates}
    series = channels | {(asset, None) for asset, _ in channels}
    chosen = _chosen(_intervals(session, labels, nodes["labels"], kind, "labels"), events)
    labelled = [row for row in chosen if _matches(row, series)]
    if not labelled:
        raise wrong("no_label_matches", labels=len(chosen))
    margins = clock.length(before, kind, "before"), clock.length(after, kind, "after")

    without_limit = alarms_unmatched = 0
    tables = {"indicator": indicator, "labels": session.load(_labels(labelled, *margins))}
    if alarms is None:
        limit_rows = _limits(session, health, table, limit, limits)
        tables["channel_limits"] = session.load(pa.Table.from_pylist(limit_rows, _LIMITS))
        watched = {name_of(row) for row in (*limit_rows, *candidates) if row["hi_limit"] is not None}
        without_limit = 0 if limit is not None else len(channels - watched)
    else:
        rows = _intervals(session, alarms, nodes["alarms"], kind, "alarms")
        alarms_unmatched = sum(not _matches(row, series) for row in rows)
        tables["alarms"] = session.load(_labels(rows, 0, 0))
    steps = detection_steps(limit, by_alarms=alarms is not None)
    for step in _TABLE_STEPS:
        tables[step] = session.keep(step, steps.query(step, tables))
    leads = session.rows(exp.select("*").from_(tables["label_leads"].copy()))
    return Detection(
        session.fetch(steps.query("detection", tables)),
        _leads(leads, labelled),
        len(chosen) - len(labelled),
        alarms_unmatched,
        without_limit,
        "steps" if kind.is_counter else "microseconds",
    )


def _finite(limit: object) -> float:
    """Return a limit as a number.

    Raises:
        ParameterError: it is none.
    """
    if isinstance(limit, numbers.Real) and not isinstance(limit, bool) and math.isfinite(limit):
        return float(limit)
    raise wrong("limit_of_all", limit=limit)


def _intervals(session: Session, relation: Any, node: exp.Expr, kind: TimeKind, what: str) -> list[Row]:
    """Return the rows of a table of labels or alarms.

    Raises:
        SourceError: a column is missing or of the wrong type, or a row has no asset or start.
    """
    columns = {name.lower(): (name, of) for name, of in session.describe(node).items()}
    if "asset" not in columns:
        raise wrong("no_column_of_intervals", what=what, name="asset", hint=nearest("asset", columns))
    # A misspelled optional column would let each label be of the whole machine.
    if "channel" not in columns and "did you mean" in (hint := nearest("channel", columns)):
        raise wrong("no_column_of_intervals", what=what, name="channel", hint=hint)
    words = {columns[name][0]: "VARCHAR" for name in ("asset", "channel", "event") if name in columns}
    node = session.engine.retyped(node, words)  # a name is read as it is written
    types = session.describe(node)
    slots: dict[str, template.Slot] = {
        name: template.column(columns[name][0]) if name in columns else None
        for name in ("asset", "channel", "event", "status", "is_open")
    }
    rows: list[Row] = []
    for slot, names in _ENDS.items():
        time = _time_column(session, node, types, columns, names, kind)
        if time is None:
            wanted = "an integer counter" if kind.is_counter else "a timestamp"
            of = columns.get(names[0], ("", "missing"))[1]
            raise wrong("time_of_intervals", what=what, name=names[0], type=of, wanted=wanted)
        name, time_kind = time
        # The words of a text file are read as times a column at a time; its rows keep their order.
        read = (
            node
            if time_kind is None
            else with_times_read(session, Source(relation, None, None, name, name), types, node)
        )
        value = None if time_kind is None else session.engine.micros_of(time_kind, template.column(name))
        query = filled("lab/evaluation/intervals", {**slots, "start": None, "finish": None, slot: value})
        read_from(query, "intervals", read)
        ends = session.rows(query)
        key = "starts_at" if slot == "start" else "ends_at"
        rows = [{**row, key: end[key]} for row, end in zip(rows or ends, ends, strict=True)]
    rows = [row for row in rows if row["is_withdrawn"] == 0]
    incomplete = sum(row["asset"] is None or row["starts_at"] is None for row in rows)
    if incomplete:
        raise wrong("incomplete_intervals", what=what, rows=incomplete)
    open_ended = [
        {**row, "ends_at": _LAST if row["ends_at"] is None or row["is_open"] else row["ends_at"]}
        for row in rows
    ]
    backwards = sum(row["ends_at"] < row["starts_at"] for row in open_ended)
    if backwards:
        raise wrong("backward_intervals", what=what, rows=backwards)
    return open_ended


def _time_column(
    session: Session,
    node: exp.Expr,
    types: Mapping[str, str],
    columns: Mapping[str, tuple[str, str]],
    names: Sequence[str],
    kind: TimeKind,
) -> tuple[str, TimeKind | None] | None:
    """Return the first of these columns that tells time as the indicators do, and how.

    A column of ends may have no value at all; nothing tells its type then.
    """
    there = [columns[name][0] for name in names if name in columns]
    for name in there:
        time_kind = session.engine.types.time_kind(types[name])
        if time_kind is not None and time_kind.is_counter == kind.is_counter:
            return name, time_kind
    if names == _ENDS["finish"] and there and all(is_empty(session, node, name) for name in there):
        return there[0], None
    return None


def _chosen(labels: list[Row], events: Sequence[str]) -> list[Row]:
    """Return the labels of the events that count."""
    if not labels:
        raise wrong("no_labels")
    if isinstance(events, str):
        events = [events]
    names = sorted({row["event"] for row in labels if row["event"] is not None})
    for event in events:
        if str(event) not in names:
            raise wrong("no_such_event", event=event, events=", ".join(names[:10]) or "none")
    return [row for row in labels if not events or row["event"] in map(str, events)]


def _matches(label: Row, series: set[tuple[str, str | None]]) -> bool:
    """Tell whether a label names a channel or, with channel NULL, a machine of the indicators."""
    return name_of(label) in series


def _labels(rows: Sequence[Row], before: int, after: int) -> pa.Table:
    """Return intervals as the steps read them, each with its number and its margins."""
    numbered = [
        {
            **row,
            "label_no": number,
            "left_out_from": max(_FIRST, row["starts_at"] - before),
            "left_out_until": min(_LAST, row["ends_at"] + after),
        }
        for number, row in enumerate(rows)
    ]
    return pa.Table.from_pylist(numbered, _INTERVALS)


def _limits(
    session: Session, health: Any, table: HealthTable, limit: float | None, limits: Any
) -> list[Row]:
    """Return the limits of channels: those given, or those of the support file beside the indicators."""
    if limit is not None or (limits is None and table.limited):
        return []
    relation = limits if limits is not None else _support_beside(health)
    if relation is None:
        raise wrong("no_limits")
    node = session.relation(relation)
    columns = session.describe(node)
    for name in ("asset", "channel", "hi_limit"):
        if name not in columns:
            raise wrong("no_column_of_limits", name=name, hint=nearest(name, columns))
    node = session.engine.retyped(node, {"asset": "VARCHAR", "channel": "VARCHAR"})
    if not session.engine.types.is_numeric(columns["hi_limit"]):
        raise wrong("limit_is_no_number", type=columns["hi_limit"])
    slots: dict[str, template.Slot] = {
        name: template.column(name) if name in columns else None
        for name in ("asset", "channel", "hi_limit", "limit_reason")
    }
    query = filled("lab/evaluation/limits", slots)
    read_from(query, "limits", node)
    rows = session.rows(query)
    if len({(row["asset"], row["channel"]) for row in rows}) < len(rows):
        raise wrong("limits_twice")
    return rows


def _support_beside(health: Any) -> str | None:
    """Return the support file that gam run wrote beside a file of indicators."""
    if not isinstance(health, (str, Path)) or not is_file(str(health)):
        return None
    path = Path(health)
    beside = path.with_name(f"{path.stem.removesuffix('.health')}.support{path.suffix}")
    return str(beside) if beside.is_file() else None


def _leads(leads: Sequence[Row], labels: Sequence[Row]) -> pa.Table:
    """Return the leads with the labels that they are of, in order of machine, channel and start."""
    rows = [
        {
            "asset": row["asset"],
            "channel": row["channel"],
            **{name: labels[row["label_no"]][name] for name in ("event", "starts_at", "ends_at")},
            "has_values": row["has_values"],
            "lead_time": row["lead_time"],
        }
        for row in leads
    ]
    rows.sort(key=lambda row: (row["asset"], row["channel"] or "", row["starts_at"], row["ends_at"]))
    return pa.Table.from_pylist(rows, _LEADS)
