"""One signal in detail: its indicator, its readings, its states, its certificate.

This module owns which signals are shown in detail, and what of the source is read for them.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD
from gam_db.composing import template
from gam_db.composing.pipeline import filled
from gam_db.engines.session import Row, Session
from gam_db.errors import nearest, wrong
from gam_db.findings import by_channel
from gam_db.report.packing import are_new, counts, packed, short, tick, ticks
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource, under
from gam_db.study import Study

#: Readings of a piece, stretches of the envelope, cells of each sort and axes of each, points of growth,
#: new cells that are named.
PIECE, STRETCHES, CELLS, AXES, GROWN, TOP = 1000, 700, 3000, 3, 200, 8

_ENDS = ("value_from", "value_to")


class Reads(Protocol):
    """A reader of the tables of a monitor."""

    @property
    def session(self) -> Session:
        """The open session."""

    def fetch(self, path: str, slots: Mapping[str, template.Slot] | None = None) -> pa.Table:
        """Return the rows of one file of ``sql/`` that reads state tables only."""

    def rows(self, path: str, slots: Mapping[str, template.Slot] | None = None) -> list[Row]:
        """Return the same, each row by the names of its columns."""


def chosen(signals: Sequence[Row], number: int, named: Iterable[str]) -> list[Row]:
    """Return the signals to show in detail: named ones, then the most urgent, spread over machines."""
    by_name = {f"{row['asset']}/{row['channel']}": row for row in signals}
    for name in named:
        if name not in by_name:
            raise wrong("no_such_signal", name=name, hint=nearest(name, by_name))
    first = [by_name[name] for name in dict.fromkeys(named)]
    there = {row["place"] for row in first}
    rest = [row for row in signals if row["place"] not in there]
    machines = {row["asset"] for row in signals}
    share, taken = max(3, number // max(1, len(machines))), dict.fromkeys(machines, 0)
    picked: list[Row] = []
    for row in rest:
        if len(first) + len(picked) >= number:
            break
        if row["bucket_count"] and row["is_above"] is not None and taken[row["asset"]] < share:
            taken[row["asset"]] += 1
            picked.append(row)
    others: dict[str, Row] = {}
    for row in rest:
        if row["is_above"] is None:
            others.setdefault(row["verdict"], row)
    return first + picked + list(others.values())


def read(
    session: Session, source: AnySource, signals: Sequence[Row], courses: Sequence[Any], end: int
) -> tuple[dict[int, Row], dict[int, Row]]:
    """Return the envelope and the two pieces of each signal, by its number, up to an end.

    Courses are the buckets of each signal.
    """
    wanted, pieces_wanted, lengths = [], [], []
    for number, (row, course) in enumerate(zip(signals, courses, strict=True)):
        seen = int(course["first"][0]) if len(course["first"]) else end
        begin = seen if row["learnt_from"] is None else row["learnt_from"]
        lengths.append(max((end - begin + 1) / STRETCHES, 1e-9))
        named = {"number": number, "asset": row["asset"], "channel": row["channel"]}
        wanted.append({**named, "first_tick": begin, "stretch_length": lengths[-1]})
        healthy = row["calibration_end"] if row["calibration_end"] is not None else begin
        ends = ("healthy", healthy, healthy), ("onset", onset_of(row, course, end), FAR_AHEAD)
        for piece, about, last in ends:
            pieces_wanted.append({**named, "piece": piece, "about_tick": about, "last_tick": last})
    narrowed = source
    if source.asset is not None:
        names = sorted({row["asset"] for row in signals})
        condition = template.column(source.asset).isin(*(template.text(name) for name in names))
        narrowed = under(source, condition)
    study = Study(session, narrowed, Parameters.paper(), Calibration(), strict=False)
    try:
        study.load("wanted", pa.Table.from_pylist(wanted))
        study.load("wanted_pieces", pa.Table.from_pylist(pieces_wanted))
        study.steps.add("envelope", filled("report/envelope"))
        slots: dict[str, template.Slot] = {"most": PIECE}
        for slot, of in (("programs", "sampled"), ("carried", "nearby")):
            program = exp.alias_(exp.column("program", table=of), "program")
            slots[slot] = [program] * (study.method.programs is not None)
        study.steps.add("pieces", filled("report/pieces", slots))
        envelopes = _envelopes(study.table("envelope"), wanted, lengths)
        pieces = _pieces(study.table("pieces"), len(wanted))
    finally:
        study.running.forget()
    return envelopes, pieces


def onset_of(row: Row, course: Any, end: int) -> int:
    """Return the instant of the piece: the middle of the window of the onset, or of the highest."""
    hi, last = course["hi"], course["last"]
    half = max(1, row["window_length"] // row["stride"] // 2)
    if row["since_tick"] is not None and len(last):  # the onset is where its window begins
        place = int(np.searchsorted(last, row["since_tick"]))
        return int(last[min(place + half - 1, len(last) - 1)])
    if len(hi) and np.isfinite(hi).any():
        place = int(np.nanargmax(hi))
    else:
        return int(last[-1]) if len(last) else end
    return int(last[max(0, place - half)])


def _envelopes(rows: pa.Table, wanted: Sequence[Row], lengths: Sequence[float]) -> dict[int, Row]:
    number, stretch, low, high = (
        rows[name].to_numpy() for name in ("number", "stretch", "lowest", "highest")
    )
    envelopes = {}
    for row, length in zip(wanted, lengths, strict=True):
        mine = (number == row["number"]) & (stretch >= 0) & (stretch < STRETCHES)
        lowest, highest = np.full(STRETCHES, np.nan), np.full(STRETCHES, np.nan)
        lowest[stretch[mine]], highest[stretch[mine]] = low[mine], high[mine]
        envelopes[row["number"]] = {
            "first": tick(row["first_tick"]),
            "length": length,
            "low": packed(lowest, "f4"),
            "high": packed(highest, "f4"),
        }
    return envelopes


def _pieces(rows: pa.Table, many: int) -> dict[int, Row]:
    rows = rows.sort_by([("number", "ascending"), ("piece", "ascending"), ("time", "ascending")])
    number, piece = rows["number"].to_numpy(), np.array(rows["piece"].to_pylist(), dtype=object)
    time = rows["time"].to_numpy()
    value = rows["value"].to_numpy(zero_copy_only=False).astype(np.float64)
    program = None
    if "program" in rows.column_names:
        program = np.array(rows["program"].to_pylist(), dtype=object)
    pieces: dict[int, Row] = {index: {} for index in range(many)}
    for index, name in itertools.product(pieces, ("healthy", "onset")):
        mine = (number == index) & (piece == name)
        pieces[index][name] = (time[mine], value[mine], None if program is None else program[mine])
    return pieces


def growth(state: Reads, monitor: str, signals: Sequence[Row]) -> dict[tuple[str, str], Row]:
    """Return the number of known states over time, for each of the signals."""
    if not signals:
        return {}
    names = {of: sorted({row[of] for row in signals}) for of in ("asset", "channel")}
    chosen = exp.and_(
        *(exp.column(of).isin(*(template.text(name) for name in listed)) for of, listed in names.items())
    )
    rows = state.fetch("report/growth", {"monitor": template.text(monitor), "chosen": chosen})
    places, nowhere = by_channel(rows), slice(0, 0)
    by_signal = {}
    for row in signals:
        name = (row["asset"], row["channel"])
        mine = places.get(name, nowhere)
        steps = np.arange(mine.start, mine.stop)
        if len(steps) > GROWN:  # a picture has room for no more
            steps = steps[np.unique(np.linspace(0, len(steps) - 1, GROWN).round().astype(np.int64))]
        of = rows.take(pa.array(steps))
        by_signal[name] = {
            "time": ticks(of["last_tick"].to_numpy()),
            "healthy": counts(of["healthy"].to_numpy()),
            "new": counts(of["novel"].to_numpy()),
        }
    return by_signal


def cells(state: Reads, signals: Sequence[Row], raw: bool) -> dict[int, Row]:
    """Return the most visited states by version, on at most three axes, and the floor by grid.

    Values in units of the signals are in it only if raw readings may be.
    """
    if not signals:
        return {}
    chosen = {
        key: exp.column(key).isin(*(exp.Literal.number(row[key]) for row in signals))
        for key in ("version_id", "support_id")
    }
    wanted: dict[str, template.Slot] = {"chosen": chosen["version_id"]}
    rows = state.fetch("report/cells", {**wanted, "most": CELLS, "axes": AXES})
    near = state.rows("report/nearest", {**wanted, "most": TOP})
    away = {(cell["version_id"], cell["visit_rank"]): cell["away"] for cell in near}
    ladder: dict[int, list[tuple[int, float]]] = {}
    for step in state.rows("report/ladder", {"chosen": chosen["support_id"]}):
        ladder.setdefault(step["support_id"], []).append((step["bins"], step["floor"]))
    version, kind = rows["version_id"].to_numpy(), np.array(rows["kind"].to_pylist(), dtype=object)
    by_version: dict[int, Row] = {}
    for row in signals:
        key = row["version_id"]
        version_cells = by_version[key] = {"ladder": ladder.get(row["support_id"], [])}
        for name, of in (("healthy", "healthy"), ("new", "novel")):
            mine = rows.filter(pa.array((version == key) & (kind == of)))
            version_cells[name] = _cells(mine, min(AXES, row["m"]))
        top = mine.slice(0, TOP * min(AXES, row["m"])).to_pylist()
        axes = [
            [axis["place"], axis["code"], *(short(axis[end]) if raw else None for end in _ENDS)]
            for axis in top
        ]
        version_cells["new"]["total"] = top[0]["total"] if top else 0
        version_cells["new"]["top"] = [
            [
                axes[at : at + min(AXES, row["m"])],
                top[at]["visits"],
                away.get((key, top[at]["visit_rank"]), -1),
                tick(top[at]["first_tick"]),
                *(top[at]["program"],) * (row["program_weight"] is not None),
            ]
            for at in range(0, len(top), min(AXES, row["m"]))
        ]
    return by_version


def _cells(rows: pa.Table, axes: int) -> Row:
    """Return cells, axis by axis; their rows come cell by cell."""
    codes = rows["code"].to_numpy().reshape(-1, axes)
    return {
        "axes": [packed(codes[:, axis], "u4") for axis in range(axes)],
        "visits": counts(rows["visits"].to_numpy()[::axes]),
        "all": rows["cells"][0].as_py() if rows.num_rows else 0,
    }


def detail(state: Reads, row: Row, course: Any, raw: tuple[Row, Row] | None) -> Row:
    """Return the content of the page of one signal, except its states and their growth.

    ``raw`` is its envelope and its pieces; None where raw readings are left out.
    """
    learnt = {"support_id": row["support_id"], "channel_id": row["channel_id"]}
    blocks = state.rows("report/blocks", learnt)
    figures: Row = {
        "time": ticks(course["last"]),
        "first": ticks(course["first"]),
        "hi": packed(course["hi"], "f8"),
        "novel": counts(course["novel"]),
        "outside": counts(course["outside"]),
        "learntFrom": tick(row["learnt_from"]),
        "learntTo": tick(row["calibration_end"]),
        "blocks": [[block["block"], block["vectors"], block["novel"]] for block in blocks],
    }
    if raw is None:
        return figures
    figures["envelope"], pieces = raw
    keys = state.fetch("report/healthy_keys", {"support_id": row["support_id"]})["cell_key"].to_numpy()
    numbers = _program_numbers(state, row)
    for name, piece in (("calm", "healthy"), ("onset", "onset")):
        time, value, program = pieces[piece]
        ran = None
        if numbers is not None and program is not None:
            ran = np.array([numbers.get(of, -1) for of in program], np.int64)
        is_new = packed(are_new(time, value, row, keys, ran), "u1")
        figures[name] = {"time": ticks(time), "value": packed(value, "f8"), "new": is_new}
    return figures


def _program_numbers(state: Reads, row: Row) -> dict[str | None, int] | None:
    """Return the numbers of the programs of a signal that are judged; None where states are of none."""
    if row["program_weight"] is None:
        return None
    rows = state.rows("report/program_numbers", {"support_id": row["support_id"]})
    return {of["program"]: of["program_no"] for of in rows}


def summary(row: Mapping[str, Any], raw: bool) -> Row:
    """Return the fields of a signal in the list; its calibrated range only with raw readings."""
    before, novel = row["novel_window_before"], row["novel_in_window"]
    return {
        **{name: row[of] for name, of in _LISTED.items()},
        **{name: tick(row[of]) for name, of in _LISTED_TIMES},
        **{name: row[of] if raw else None for name, of in _LISTED_RANGE},
        "before": None if before is None else before / row["window_length"],
        "outside": None if not novel else short(row["out_of_range_in_window"] / novel),
        "fresh": int(row["is_new"]),
        "rising": int(row["is_rising"]),
    }


#: What the list calls the columns of a signal.
_LISTED = {
    name: name for name in ("verdict", "status", "hi", "floor", "cells", "m", "tau", "bins", "stride")
}
_LISTED |= {"name": "channel", "isAbove": "is_above", "atLeast": "at_least", "by": "judged_by"}
_LISTED |= {"episode": "episode_id", "limit": "hi_limit", "vectors": "calibration_vectors"}
_LISTED |= {"finest": "finest_bins", "needed": "vectors_needed", "window": "window_length"}
_LISTED |= {"version": "version_no", "target": "target_floor"}
_LISTED |= {"label": "label", "far": "is_far_above", "strength": "strength"}
_LISTED |= {"sees": "sees", "unseen": "would_not_see", "blind": "blind_reason"}
_LISTED |= {"vouching": "vouching", "teachers": "taught_by", "machineFloor": "member_floor"}
_LISTED_TIMES = (("since", "since_tick"), ("silent", "silent_for"), ("at", "data_tick"))
_LISTED_RANGE = (("low", "calibrated_lo"), ("high", "calibrated_hi"))
