"""Streamed queries: of one channel in stored order, and of many channels in one statement.

This module owns the queries of ``sql/streams``. Each is composed and written once, and called for every
channel as a macro of DuckDB; names, instants and ranges reach it as the literals of the call.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.bits import Bits
from gam_db.method.probe import probed_delays
from gam_db.method.scoring import visited_slots
from gam_db.method.slots import block_no, coordinates, novel_before
from gam_db.method.vectors import (
    Stream,
    counted_slots,
    is_outside,
    movement,
    stream_codes,
    stream_slots,
)
from gam_db.settings.parameters import Parameters
from gam_db.study.running import Running

#: What is read off visits that are there: step -> the file that makes it.
_OF_VISITS = {
    "support": "support/support",
    "missing_vectors": "certificate/missing_vectors",
    "cells": "certificate/cells",
    "first_visits": "streams/first_visits",
}

#: The slots of one channel.
ChannelSlots = Mapping[str, int | float | exp.Expr | None]


def channel_slots(
    row: Row, **slots: int | float | exp.Expr | None
) -> dict[str, int | float | exp.Expr | None]:
    """Return the slots of one channel: its number, its names, and others."""
    names = {name: template.text(row[name]) for name in ("asset", "channel")}
    return {"channel_id": row["channel_id"], **names, **slots}


def range_of(bounds: Row) -> dict[str, float]:
    """Return the calibrated range of a row of *bounds*."""
    return {name: bounds[f"calibrated_{name}"] for name in ("lo", "hi")}


def of_each(
    running: Running,
    step: str,
    make: Callable[[ChannelSlots], exp.Query],
    channels: Sequence[ChannelSlots],
    tables: Mapping[str, str] | None = None,
    labels: Sequence[str] = (),
) -> exp.Query:
    """Return the rows of a query over each of some channels.

    It is made of the slots of a channel, of which all have the same ones, over the steps at work;
    ``labels`` become the first columns, and tables are those of :meth:`Pipeline.add`. The session, of
    an engine with macros, keeps this one until another is made for the step.
    """
    free_names = _free_names(running.steps, channels[0])
    steps = running.steps.copied()
    steps.add(
        "of_channel", make({slot: exp.column(name) for slot, name in free_names.items()}), tables=tables
    )
    query = steps.query("of_channel", running.tables)
    macro = running.session.define(step, query, list(free_names.values()))
    columns = [exp.column(name) for name in query.named_selects]
    calls = []
    for slots in channels:
        arguments = [template.node_of(slots[slot]) for slot in free_names]
        called = exp.Table(this=exp.Anonymous(this=macro, expressions=arguments))
        calls.append(
            exp.select(*(_label(label, slots[label]) for label in labels), *columns).from_(called)
        )
    return stacked(calls, running.session.threads())


def of_channel(file: str, channel: ChannelSlots, **slots: template.Slot) -> exp.Query:
    """Return a file of ``sql/streams`` that speaks of one channel, with those of its slots it has."""
    file_slots = template.load(f"streams/{file}").slots
    return filled(
        f"streams/{file}", {**{name: channel[name] for name in channel.keys() & file_slots}, **slots}
    )


def visits(channel: ChannelSlots, setting: Parameters, has_blocks: bool, stream: Stream) -> exp.Query:
    """Return the cells of the calibration of one channel, in blocks or not.

    Its own slots are those of the channel, and ``lo``, ``hi``, ``time_from``, ``time_to``; with blocks
    also ``support_id``, and ``vectors``, how many calibration has.
    """
    slots = counted_slots(setting, stream)
    if has_blocks:
        slots["block_no"] = block_no(setting, template.node_of(channel["vectors"]))
        return of_vectors("visits", channel, setting, stream, **slots)
    del slots["number"]
    learnable = of_vectors("learnable", channel, setting, stream, **slots)
    return _over(filled("census/taught"), "learnable", learnable)


def taught(channel: ChannelSlots, setting: Parameters, stream: Stream) -> exp.Query:
    """Return how many vectors the calibration of one channel teaches."""
    counted = counted_slots(setting, stream)["counted"]
    return of_vectors("taught", channel, setting, stream, counted=counted)


def probed(channel: ChannelSlots, setting: Parameters, stream: Stream) -> exp.Query:
    """Return the picked vectors of the calibration of one channel: the step *probed*.

    Its own slots are those of :func:`visits` with blocks, and ``taught``, how many vectors its support
    has, and ``before``, how many of them are those of members before it.
    """
    delays = probed_delays(setting)
    slots = counted_slots(setting, stream)
    slots |= {
        "block_no": block_no(setting, template.node_of(channel["vectors"])),
        "picked": template.fill("probe/is_picked"),
        "samples": [exp.column(f"x_{delay}") for delay in delays],
    }
    return _over(
        of_channel("probed", channel, **slots),
        "streamed",
        _vectors(channel, setting, False, stream, delays),
    )


def of_vectors(
    file: str, channel: ChannelSlots, setting: Parameters, stream: Stream, **slots: template.Slot
) -> exp.Query:
    """Return a file of ``sql/streams`` that speaks of the vectors of one channel."""
    return _over(
        of_channel(file, channel, **slots), "streamed", _vectors(channel, setting, False, stream)
    )


def scored(
    channel: ChannelSlots,
    setting: Parameters,
    bits: Bits,
    stream: Stream,
    ends: Mapping[str, str] | None = None,
) -> exp.Query:
    """Return the scored vectors of one channel, grouped: the step *visited*.

    Its own slots are those of the channel, and ``lo``, ``hi``, ``time_from``, ``time_to``,
    ``support_id``, ``first_scored``. The step *support_bits* holds its support; for ``ends`` see
    :func:`gam_db.method.scoring.add_buckets`.
    """
    grouped = visited_slots(setting, ends, trusting=True) | {"outside": is_outside(setting)}
    vectors = _scored_vectors(channel, setting, bits, stream, list(ends or ()))
    return _over(filled("health/visited", grouped), "scored_vectors", vectors)


def window_counts(channel: ChannelSlots, setting: Parameters, bits: Bits, stream: Stream) -> exp.Query:
    """Return the same vectors with their running counts: the step *window_counts*.

    Arguments as for :func:`scored`; the slots have ``context_rows``, too.
    """
    vectors = _scored_vectors(channel, setting, bits, stream, ["position"])
    running = of_channel("running", channel, outside=is_outside(setting), span=setting.span)
    before = novel_before(setting, "streams/delayed")
    counts = filled("health/window_counts", {"window": setting.window, "novel_before": before})
    return _over(counts, "numbered", _over(running, "scored_vectors", vectors))


def still_since(channel: ChannelSlots, setting: Parameters, stream: Stream) -> exp.Query:
    """Return since when one channel stands still at its end: the step *stillness*.

    Arguments as for :func:`scored`.
    """
    stillness = of_channel("stillness", channel, long_ago=LONG_AGO)
    return _over(stillness, "moving_codes", _codes(channel, setting, stream))


def _scored_vectors(
    channel: ChannelSlots, setting: Parameters, bits: Bits, stream: Stream, carried: Sequence[str]
) -> exp.Query:
    """Return the scored vectors of one channel, which carry some of their columns."""
    slots: dict[str, template.Slot] = {
        **counted_slots(setting, stream),
        "is_held": bits.held(exp.column("bits"), exp.column("cell_key")),
        "carried": [*coordinates(setting), *map(exp.column, carried)],
    }
    # Where every vector counts, samples of the run-up have numbers that are none.
    slots["counted"] = exp.true()
    if not stream.is_even:
        first = template.fill("streams/scored", {"first_scored": channel["first_scored"]})
        slots["counted"] = exp.and_(template.fill("streams/counts"), first)
    vectors = _vectors(channel, setting, "context_time" in carried, stream)
    return _over(of_channel("scored_vectors", channel, **slots), "streamed", vectors)


def _vectors(
    channel: ChannelSlots,
    setting: Parameters,
    has_context: bool,
    stream: Stream,
    delays: tuple[int, ...] = (),
) -> exp.Query:
    """Return the vectors of one channel (Eq. 1), with samples so many before the newest one."""
    slots = stream_slots(setting, has_context, stream, delays)
    codes = _codes(channel, setting, stream, has_values=bool(delays))
    return _over(of_channel("vectors", channel, **slots), "codes", codes)


def _codes(
    channel: ChannelSlots, setting: Parameters, stream: Stream, has_values: bool = False
) -> exp.Query:
    """Return the codes of one channel; where samples may stand still, with which ones do."""
    values = [exp.column("value")] * has_values
    codes = of_channel("codes", channel, **stream_codes(setting, stream, has_values))
    if setting.still_after is not None:
        breaking = None if stream.gap is None else exp.column("breaking")
        slots = movement(setting.still_after, values, breaking, rows=1)
        codes = _over(filled("embedding/moving_codes", slots), "codes", codes)
    return codes


def read_off_visits(
    method: Method, number: int, lacks: bool = False
) -> Iterator[tuple[str, exp.Query, Mapping[str, str]]]:
    """Give the steps of one set that are read off visits which are there, and what each reads.

    Where samples may be missing, *missing_vectors* is not among them.
    """
    reads = {step: method.named(step, number) for step in ("bounds", "visits", "block_sizes", "cells")}
    reads |= dict.fromkeys(("learnable", "vectors"), reads["visits"])
    besides = {name: template.fill(f"streams/{name}") for name in ("second_place", "opening_visits")}
    of_cells: dict[str, template.Slot] = {
        "gathered": [exp.alias_(node, name) for name, node in besides.items()],
        "carried": [exp.column(name, table="seen") for name in besides],
    }
    for step, file in _OF_VISITS.items():
        if lacks and step == "missing_vectors":
            continue
        slots = of_cells if step == "cells" else None
        yield method.named(step, number), filled(file, slots), reads


def are_whole(running: Running, visits: str, expected: Mapping[int, int]) -> bool:
    """Tell whether the step of visits is that of vectors as stored, and none is marked.

    Expected are the vectors of each channel that has one.
    """
    rows = running.query_rows("streams/visited_vectors", tables={"visits": visits})
    vectors = {row["channel_id"]: row["vectors"] for row in rows}
    return vectors == expected and not any(row["doubled"] for row in rows)


def _free_names(steps: Pipeline, slots: Iterable[str]) -> dict[str, str]:
    """Return the parameters of some slots: names that no column of the user's has."""
    taken = {
        identifier.name.lower() for identifier in steps.steps["readings"].query.find_all(exp.Identifier)
    }
    prefix = "asked_"
    while any(name.startswith(prefix) for name in taken):
        prefix += "_"
    return {slot: f"{prefix}{slot}" for slot in slots}


def _label(name: str, value: int | float | exp.Expr | None) -> exp.Expr:
    return exp.alias_(
        exp.cast(template.node_of(value), "INT" if isinstance(value, int) else "TEXT"), name
    )


def _over(query: exp.Query, name: str, rows: exp.Query) -> exp.Query:
    """Let a query read the rows of another one where it has a name for them."""
    (read,) = (table for table in query.find_all(exp.Table) if table.name == name)
    read.replace(rows.subquery(read.alias_or_name, copy=False))
    return query


def stacked(queries: Sequence[exp.Query], threads: int) -> exp.Query:
    """Return the rows of several queries, which DuckDB works on side by side if it has several threads.

    It does so with entries of a WITH list that it is to keep, each a copy. The parts of a UNION it takes
    one after another, wherever one of them alone has rows for all threads.
    """
    first, *others = queries
    if not others:
        return first
    if threads == 1:
        return exp.union(*queries, distinct=False, copy=False)
    names = [exp.to_identifier(f"gam_part_{number}") for number in range(len(queries))]
    parts = [
        exp.CTE(this=query, alias=exp.TableAlias(this=name), materialized=True)
        for name, query in zip(names, queries, strict=True)
    ]
    columns = [exp.column(name) for name in first.named_selects]
    rows = [exp.select(*columns).from_(exp.Table(this=name.copy())) for name in names]
    union = exp.union(*rows, distinct=False, copy=False)
    union.set("with_", exp.With(expressions=parts))
    return union
