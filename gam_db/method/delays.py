"""Delay vectors (Eq. 1) from readings, in the way that is cheapest on an engine: the hook of the census.

One contract: readings in, and for each vector out its channel and support, the time of its newest
sample, its cell (NULL where a sample is missing), whether it is out of range, the place of its newest
sample among those that are read, and whether what shows that an instant occurs twice shows in it. The
bodies are folders of ``sql/``; which of them an engine takes is said in :mod:`gam_db.engines`. One
that is not right for a source shows it by ``doubled``, too: that costs time, never a number.

* ``embedding``, by windows: for every engine.
* ``rowids``, by the numbers of rows that are kept in order: SQLite.
* ``arrays``, by arrays that are kept in order: ClickHouse.

What these two keep in order the census is made of, too.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from sqlglot import exp

from gam_db.clock import FAR_AHEAD
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled
from gam_db.method.adding import OfSet, add
from gam_db.method.vectors import add_vectors, compared, small_key

#: What is kept before vectors are made of it, body by body.
SET_STEPS = {"rowids": ("coded", "runs"), "arrays": ()}

#: What is kept of the samples of the source before they are cut, body by body: its *slices*, its
#: *edge_samples* and its codes are read off it.
STORED = {"rowids": ("spoken", "lined", "pieces"), "arrays": ("stored",)}

#: The step that shows by its column ``doubled`` of which names an instant occurs twice, body by body.
IN_ORDER = {"rowids": "pieces", "arrays": "stored"}

#: The steps with a column ``doubled`` that prove a body right for a channel where it is 0 everywhere,
#: as it must be in what supports and buckets are made of (:attr:`Ways.taught`, :attr:`Ways.counted`).
PROOFS = {None: (), "rowids": ("runs",), "arrays": ()}

#: What is made of scored vectors and of the support alone.
_HEALTH = frozenset(("health_indicator", "bucket_health", "novel_cells"))

#: The vectors that are made, by their prefix: of calibration, and the scored ones of channels without
#: and with missing samples.
CALIBRATION, COMPLETE, INCOMPLETE = "calibration_", "complete_", "incomplete_"


@dataclass(frozen=True)
class Ways:
    """How a source is worked on where engines differ, and sources.

    Attributes:
        delays: the body of the delays; None for windows.
        by_sets: whether a cell is looked up in the support as a set, instead of by a join.
        has_missing: whether a channel lacks a sample; if none does, nothing is made for such.
        targets: the last steps that will be asked for, where that is known; others may be, at a price.
        is_cut: whether samples that are none of calibration may come before scoring begins; vectors of
            calibration are then made by windows.
        by_windows: whether segments may end or samples stand still; vectors are then made by windows.
        has_room: whether vectors, and what is told of each sample, may be kept where several steps read
            them.
        is_collapsed: whether the readings are a table that has each instant once.
    """

    delays: str | None = None
    by_sets: bool = False
    has_missing: bool = True
    targets: frozenset[str] = frozenset()
    is_cut: bool = False
    by_windows: bool = False
    has_room: bool = False
    is_collapsed: bool = False

    @property
    def scores(self) -> bool:
        """Tell whether results of the scored vectors are certain to be wanted."""
        return bool(self.targets & _HEALTH)

    @property
    def has_blocks(self) -> bool:
        """Tell whether a certificate, which needs blocks of calibration, may be wanted."""
        return not self.targets or not self.targets <= _HEALTH

    @property
    def taught(self) -> str:
        """The step from which supports are made: vectors, or cells if no certificate is wanted."""
        return "learnable" if self.has_blocks else "taught"

    @property
    def counted(self) -> str:
        """The step from which buckets are counted: by novel cell if these are wanted, too."""
        return "visited" if "novel_cells" in self.targets else "tallied"


def add_stored(steps: Pipeline, ways: Ways) -> None:
    """Add what a body keeps of the samples of a source, and their counts by slice."""
    body = ways.delays or ""
    for name in (*STORED[body], "slices"):
        add(steps, f"{body}/{name}")


def add_delays(set_steps: OfSet, prefix: str, ways: Ways, rows: str, has_bits: bool) -> None:
    """Add the step *vectors* of a prefix, for one set.

    The set has *scale*, and what the body keeps for it (:data:`SET_STEPS`). Rows is the step that holds
    the readings of the vectors, for windows. Where supports are kept as bits, keys are small.
    """
    # Of a channel without a missing sample every coordinate is there.
    special_slots: dict[str, template.Slot] = {"is_present": exp.true()} if prefix == COMPLETE else {}
    marked = ways.is_cut and prefix == CALIBRATION
    body = ways.delays
    if body is not None and not marked:
        query = _BODIES[body](set_steps, prefix, special_slots)
        tables = {name: set_steps.named(name) for name in ("scale", *SET_STEPS[body])}
        set_steps.steps.add(set_steps.named(f"{prefix}vectors"), query, "", tables)
        return
    file = "census/marked_codes" if marked else "census/codes"
    slots: dict[str, template.Slot] = {"read": _read(prefix), "carried": compared(set_steps.setting)}
    set_steps.add(file, slots, f"{prefix}codes", {"readings": rows})
    if has_bits:
        special_slots["cell_key"] = small_key(set_steps.setting)
    marks = ["doubled", *["calibration_vector"] * marked]
    if set_steps.method.pools:
        add_vectors(set_steps, prefix, marks, ("support_id",), special_slots=special_slots)
        return
    # Without pools each channel has its own support, whose number is the channel's and not sorted along.
    support_id = exp.alias_(exp.column("channel_id"), "support_id")
    add_vectors(set_steps, prefix, marks, columns=[support_id], special_slots=special_slots)


def _by_row(set_steps: OfSet, prefix: str, special_slots: Mapping[str, template.Slot]) -> exp.Query:
    """Return the vectors of a prefix by the numbers of rows."""
    setting = set_steps.setting
    is_taught = prefix == CALIBRATION
    first, last = ("first_row", "taught_row") if is_taught else ("start_row", "last_row")
    tables = {k: f"delayed_{k}" for k in range(1, setting.m)}
    slots: dict[str, template.Slot] = {
        **special_slots,
        "first_row": exp.column(first, table="run"),
        "last_row": exp.column(last, table="run"),
        "delayed": [exp.alias_(exp.column("code", table=of), f"code_{k}") for k, of in tables.items()],
        "read": exp.true() if is_taught else _is_complete(prefix, "run"),
    }
    query = filled("rowids/vectors", set_steps.slots("rowids/vectors", slots))
    (joined,) = (select for select in query.find_all(exp.Select) if select.args.get("joins"))
    for k, table in tables.items():
        row = exp.column("rowid", table=table)
        where = template.fill("rowids/delayed", {"row": row, "delay": k * setting.tau})
        joined.join(exp.to_table("coded"), on=where, join_type="cross", join_alias=table, copy=False)
    return query


def _in_arrays(set_steps: OfSet, prefix: str, special_slots: Mapping[str, template.Slot]) -> exp.Query:
    """Return the vectors of a prefix by arrays."""
    setting = set_steps.setting
    is_taught = prefix == CALIBRATION
    delayed: list[exp.Expr] = []
    for k in range(setting.m):
        place = {"place": setting.span - k * setting.tau + 1}
        delayed.append(exp.alias_(template.fill("arrays/delayed", place), f"code_{k}"))
    slots: dict[str, template.Slot] = {
        **special_slots,
        "time_from": exp.column("taught_from" if is_taught else "read_from"),
        "time_to": exp.column("taught_to") if is_taught else FAR_AHEAD,
        "delayed": delayed,
        "read": exp.true() if is_taught else _is_complete(prefix),
    }
    return filled("arrays/vectors", set_steps.slots("arrays/vectors", slots))


def _read(prefix: str) -> exp.Expr:
    """Return the step of readings for the vectors of a prefix."""
    time = exp.column("time", table="reading")
    first, last, begin = (
        exp.column(name, table="scale") for name in ("taught_from", "taught_to", "read_from")
    )
    if prefix == CALIBRATION:
        return exp.Between(this=time, low=first, high=last)
    return exp.and_(time >= begin, _is_complete(prefix, "scale"))


def _is_complete(prefix: str, table: str | None = None) -> exp.Expr:
    """Return the condition of a prefix: that a channel has missing samples, or none."""
    return exp.column("complete", table=table).eq(int(prefix == COMPLETE))


_Body = Callable[[OfSet, str, Mapping[str, template.Slot]], exp.Query]
_BODIES: dict[str, _Body] = {"rowids": _by_row, "arrays": _in_arrays}
