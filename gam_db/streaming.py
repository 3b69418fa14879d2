"""Streams: channels that are stored in order of time are read in that order, and nothing is sorted.

This module owns when that is done for a study, and what proves that it was right: a glance at the first
rows, the proof in the step *ordered*, the marks that the vectors themselves carry, and the count of the
calibration samples. What does not hold costs time, never a number: the study goes on with the steps that
sort.
"""

from collections.abc import Iterable, Mapping
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db import template
from gam_db.bits import Bits
from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import counts
from gam_db.method import Method
from gam_db.method.scoring import visited_slots
from gam_db.method.vectors import stream_slots
from gam_db.pipeline import Step, filled
from gam_db.running import Running

#: Rows that are glanced at to guess whether channels lie one after another.
GLANCE = 10_000

#: Readings of a channel, on the average, from which on a part of a statement for each is worth its time.
STREAMED_FROM = 50_000

#: Channels of one statement.
MOST_CHANNELS = 256

#: The steps that streams give: the vectors of calibration, and the scored ones, grouped.
LEARNING, SCORING = "learnable", "visited"

Row = dict[str, Any]
Slots = dict[str, template.Slot]


def seems_ordered(method: Method, running: Running) -> bool:
    """Tell whether the first rows are of two channels at most, where the engine keeps their order.

    If so, *names* will prove it of all of them.
    """
    bits = running.session.engine.bits
    if bits is None or not _is_plain(method, bits):
        return False
    if running.session.fetch(running.query("glance")).num_rows > 2:
        return False
    running.keep("ordered")
    running.put("names", exp.select("*").from_(running.placed["ordered"].copy()))
    return True


def _is_plain(method: Method, bits: Bits) -> bool:
    """Tell whether no segment ends, and calibration is one interval: what streams serve."""
    whole = ((LONG_AGO, FAR_AHEAD),)
    has_bits = all(
        method.is_short(number) and bits.serve(setting.radix**setting.m)
        for number, setting in enumerate(method.settings)
    )
    return has_bits and all(
        len(rule.allowed) <= 1 and (rule.fraction is None or tuple(rule.allowed) == whole)
        for rule in method.rules
    )


class Streams:
    """The streams of a study whose *names* are those of the step *ordered*.

    Args:
        method: of the study.
        running: its steps at work.
    """

    def __init__(self, method: Method, running: Running) -> None:
        self.method, self.running = method, running
        self.holds = True
        self._sorting: dict[str, Step] = {}
        self._done: set[str] = set()

    @property
    def holds_so_far(self) -> bool:
        """Tell whether a step was given, and nothing spoke against it."""
        return self.holds and bool(self._done)

    def serve(self) -> bool:
        """Tell whether all channels are in order, none lacks a sample, and they are long enough."""
        names = self.running.rows("ordered")
        return (
            0 < len(names) <= MOST_CHANNELS
            and sum(row["readings"] for row in names) >= STREAMED_FROM * len(names)
            and all(row["in_order"] and not row["missing_readings"] for row in names)
        )

    def prepare(self, step: str) -> None:
        """Give the steps before one what streams make of them, if it needs them."""
        steps, method = self.running.steps, self.method
        for part, give in ((LEARNING, self._learn), (SCORING, self._score)):
            needed = {one.name for one in steps.needed([step], self.running.placed)}
            own = {method.named(part, number) for number in range(len(method.settings))}
            if self.holds and part not in self._done and needed & own:
                self._done.add(part)
                self.holds = give()
                if not self.holds:
                    self._give_up()

    def _learn(self) -> bool:
        """Give the timeline and the vectors of calibration; tell whether they are as they should be."""
        method, running = self.method, self.running
        channels = self._channels()
        quotas = {
            row["channel_id"]: int(rule.fraction * row["readings"])
            for row in channels
            if (rule := method.rules[row["calibration_no"]]).fraction is not None
        }
        reached = self._each(
            "quota",
            {
                row["channel_id"]: {**_names(row), "before": quotas[row["channel_id"]] - 1}
                for row in channels
                if quotas.get(row["channel_id"])
            },
        )
        names = self.running.session.rows(running.query("names"))
        earliest = {(row["asset"], row["channel"]): row["earliest"] for row in names}
        timeline = [
            {
                "channel_id": row["channel_id"],
                "repeats": 0,
                "first_time": earliest[row["asset"], row["channel"]],
                "quota_time": reached.get(row["channel_id"], {}).get("quota_time"),
            }
            for row in channels
        ]
        running.load("timeline", pa.Table.from_pylist(timeline, schema=_TIMELINE))
        pieces = {row["channel_id"]: row for row in running.rows("calibration")}
        for number in range(len(method.settings)):
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds.keys() & pieces.keys()]
            exact = self._each(
                "exact",
                {row["channel_id"]: _range(bounds[row["channel_id"]]) for row in members},
                number,
            )
            counted = {id_: row["calibration_samples"] for id_, row in bounds.items()}
            if any(quotas.get(id_, samples) != samples for id_, samples in counted.items()):
                return False
            if not all(row["is_exact"] for row in exact.values()):
                return False
            if not members:
                continue
            learnable = []
            for row in members:
                piece = pieces[row["channel_id"]]
                vectors = self._vectors(row, number, bounds, piece["time_from"], piece["time_to"])
                slots: Slots = {"channel_id": row["channel_id"]}
                learnable.append(_over("streams/learnable", slots, "streamed", vectors))
            step = method.named("learnable", number)
            self._replace(step, _stacked(learnable))
            running.keep(step)
            running.load(method.named("missing_vectors", number), _MISSING.empty_table())
            if running.largest(step, "out_of_order"):
                return False
        return bool(self._sorting)

    def _score(self) -> bool:
        """Give the scored vectors, grouped; tell whether they are what they should be."""
        method, running, bits = self.method, self.running, self.running.session.engine.bits
        assert bits is not None
        channels = self._channels()
        for number, setting in enumerate(method.settings):
            held, visited = (method.named(step, number) for step in ("support_bits", "visited"))
            running.keep(held)
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds]
            if not members:
                continue
            first = {row["channel_id"]: bounds[row["channel_id"]]["first_scored"] for row in members}
            starts = self._each(
                "run_up",
                {
                    row["channel_id"]: {
                        **_names(row),
                        "first_scored": first[row["channel_id"]],
                        "span": setting.span,
                    }
                    for row in members
                },
            )
            scored = []
            for row in members:
                start = starts[row["channel_id"]]["read_from"]
                read_from = first[row["channel_id"]] if start is None else start
                slots: Slots = {
                    **{name: row[name] for name in ("channel_id", "support_id")},
                    "before": setting.span,
                    "is_held": bits.held(exp.column("bits"), exp.column("cell_key")),
                }
                vectors = self._vectors(row, number, bounds, read_from, FAR_AHEAD)
                placed = _over("streams/placed", slots, "streamed", vectors)
                grouped = visited_slots(setting, trusting=True)
                scored.append(_over("health/visited", grouped, "placed", placed))
            self._replace(visited, _stacked(scored), {"support_bits": held})
            running.keep(visited)
            if running.largest(visited, "doubled"):
                return False
        return True

    def _channels(self) -> list[Row]:
        return self.running.rows("channels")

    def _bounds(self, number: int) -> dict[int, Row]:
        """Return the bounds of the channels of a set that have a range."""
        rows = self.running.rows(self.method.named("bounds", number))
        return {row["channel_id"]: row for row in rows if row["calibrated_lo"] is not None}

    def _vectors(
        self, row: Row, number: int, bounds: Mapping[int, Row], time_from: int, time_to: int
    ) -> exp.Query:
        """Return the vectors of one channel over what is read of it."""
        slots = stream_slots(self.method.settings[number])
        read: Slots = {"time_from": time_from, "time_to": time_to}
        said = {**_names(row), **_range(bounds[row["channel_id"]]), **read, **slots}
        return filled("streams/vectors", said)

    def _each(self, file: str, slots: Mapping[int, Slots], number: int = 0) -> dict[int, Row]:
        """Ask the same of each channel, in one statement; return the answers by channel."""
        if not slots:
            return {}
        asked = [filled(f"streams/{file}", {**more, "channel_id": id_}) for id_, more in slots.items()]
        steps = self.running.steps.copied()
        steps.add("asked", _stacked(asked), tables={"bounds": self.method.named("bounds", number)})
        query = steps.query("asked", self.running.placed)
        rows = self.running.session.rows(query)
        return {row["channel_id"]: row for row in rows}

    def _replace(self, step: str, query: exp.Query, tables: Mapping[str, str] | None = None) -> None:
        self._sorting.setdefault(step, self.running.steps.replace(step, query, tables))

    def _give_up(self) -> None:
        """Let the study begin anew with the steps that sort."""
        for step in self._sorting.values():
            self.running.steps.put(step)
        self.running.forget(but=("names", "ordered", "readings", "channels"))


def _over(path: str, slots: Slots, name: str, rows: exp.Query) -> exp.Query:
    """Return a file of ``sql/`` that reads the rows of a query where it has a name for them."""
    query = filled(path, slots)
    (read,) = (table for table in query.find_all(exp.Table) if table.name == name)
    read.replace(rows.subquery(name))
    return query


def _names(row: Row) -> Slots:
    return {name: template.text(row[name]) for name in ("asset", "channel")}


def _range(bounds: Row) -> Slots:
    return {name: bounds[f"calibrated_{name}"] for name in ("lo", "hi")}


def _stacked(queries: Iterable[exp.Query]) -> exp.Query:
    first, *others = queries
    return exp.union(first, *others, distinct=False, copy=False) if others else first


_TIMELINE = counts("channel_id repeats first_time quota_time")
_MISSING = counts("channel_id missing_vectors")
