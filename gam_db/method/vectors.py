"""Codes and delay vectors (Eq. 1; Phi, method section 3), and conditions on earlier samples."""

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from sqlglot import exp

from gam_db.clock import LONG_AGO
from gam_db.composing import template
from gam_db.method.adding import OfSet
from gam_db.method.programs import TAUGHT, coded, keyed, numbers
from gam_db.method.slots import all_present, cell_key, code_in, coordinates, outside, place_in
from gam_db.settings.parameters import Parameters


def add_vectors(
    set_steps: OfSet,
    prefix: str,
    marks: Collection[str] = (),
    carried: Sequence[str] = (),
    columns: Sequence[exp.Expr] = (),
    special_slots: Mapping[str, template.Slot] | None = None,
    has_keys: bool = True,
) -> None:
    """Add the vectors of one set (Eq. 1) over the codes of the same prefix.

    Those of a set with ``still_after`` have :func:`compared` columns. What may be asked of a vector:

    * ``doubled``: 1 marks each sample that shows that an instant occurs twice, be it the newest one of a
      vector or not.
    * ``calibration_vector``, of codes that say which samples are ``calibrating``: 1 where all are.
    * ``straddling``, likewise: 1 where a coordinate is.
    * ``oldest_time``: of its samples.
    * ``still_so_far``: how many samples stood still, up to it.

    Args:
        set_steps: the steps of the set.
        prefix: of the steps.
        marks: of these.
        carried: columns of the codes that travel with the vectors.
        columns: what else is told of a vector, by its own columns.
        special_slots: slots otherwise than usual, where it is known that all coordinates are there, or
            that keys are small.
        has_keys: whether cells matter; else it does not matter which program ran.
    """
    setting = set_steps.setting
    is_marked = "calibration_vector" in marks
    delays, span = delays_of(set_steps), span_of(set_steps)
    read = [name for name in ("radix", "tau") if name in set_steps.method.columns]
    inner = [*read, *(column.name for column in numbers(set_steps) if has_keys)]
    codes, over, whole = add_last_codes(
        set_steps, prefix, [*carried, *inner, *["calibrating"] * is_marked]
    )
    delayed: list[exp.Expr] = [exp.column(name) for name in carried]
    vector_columns = [*delayed, *columns]
    delayed += [exp.column(name) for name in inner]
    if is_marked:
        over["oldest_time"] = _before("time", span)
        over["last_uncalibrated"] = _newest(exp.column("calibrating").eq(0), setting.span)
        taught = _flag(template.fill("embedding/in_calibration"))
        vector_columns.append(exp.alias_(taught, "calibration_vector"))
    if "straddling" in marks:
        touched = [exp.column(f"calibrating_{k}") for k in range(setting.m)]
        over |= {of.name: _before("calibrating", delays[k]) for k, of in enumerate(touched) if k}
        delayed.append(exp.alias_(exp.column("calibrating"), touched[0].name))
        touching = exp.or_(
            *(template.fill("embedding/straddling", {"calibrating": of}) for of in touched)
        )
        vector_columns.append(exp.alias_(_flag(touching), "straddling"))
    if "oldest_time" in marks:
        over["oldest_time"] = _before("time", span)
        vector_columns.append(exp.column("oldest_time"))
    if "still_so_far" in marks:
        over["still_so_far"] = template.fill("embedding/still_so_far")
        vector_columns.append(exp.column("still_so_far"))
    if "doubled" in marks:
        # Where the next vector begins with the sample before this one, its time is known already.
        is_next = span == 2 and setting.still_after is None
        previous = exp.column("context_time" if is_next else "previous_time")
        if not is_next:
            over[previous.name] = _before("time", 1)
        doubled = template.fill("embedding/doubled", {"previous_time": previous})
        vector_columns.append(exp.alias_(_flag(doubled), "doubled"))
        whole = exp.or_(whole, doubled)
    coordinates = {f"code_{k}": _before("code", delays[k]) for k in range(1, setting.m)}
    slots: dict[str, template.Slot] = {
        "delayed": [*_named(coordinates), *delayed, *_named(over)],
        "context": _context(setting, span),
        "carried": vector_columns,
        "whole": whole,
        **(keyed(set_steps) if has_keys else {}),
        **(special_slots or {}),
    }
    set_steps.add("embedding/vectors", slots, f"{prefix}vectors", {"codes": codes})


def delays_of(set_steps: OfSet) -> list[int | exp.Expr]:
    """Return the delays of the coordinates of a vector, in samples; of a column where tau is one."""
    setting = set_steps.setting
    if "tau" not in set_steps.method.columns:
        return [k * setting.tau for k in range(setting.m)]
    tau = exp.column("tau")
    delays: list[int | exp.Expr] = [0, tau]
    for k in range(2, setting.m):
        times = exp.Mul(this=exp.Literal.number(k), expression=exp.cast(tau.copy(), "BIGINT"))
        delays.append(exp.cast(times, "INT"))
    return delays[: setting.m]


def span_of(set_steps: OfSet, table: str | None = None) -> int | exp.Expr:
    """Return (m - 1) tau, likewise; the column is that of a table."""
    span = delays_of(set_steps)[-1]
    if isinstance(span, exp.Expr):
        span = span.copy()
        for column in span.find_all(exp.Column):
            column.set("table", table and exp.to_identifier(table))
    return span


def compared(setting: Parameters) -> list[exp.Expr]:
    """Return the columns of codes that show which samples stand still."""
    return [] if setting.still_after is None else [exp.column("value")]


def varying(set_steps: OfSet) -> list[exp.Expr]:
    """Return what codes carry besides: settings in which channels differ, all but bins, and programs."""
    read = (name for name in set_steps.method.columns if name in ("radix", "max_gap", "tau"))
    return [*map(exp.column, read), *numbers(set_steps)]


def add_earlier(set_steps: OfSet, prefix: str, samples: str, delays: Sequence[int]) -> None:
    """Add *probed* of one set: its picked vectors with the values so many samples before their newest.

    Each is one of calibration, in the segment of the newest one, and counts as usual.
    """
    until = exp.column("time", table="sampled") <= exp.column("calibration_end", table="scale")
    slots, tables = coded(set_steps, TAUGHT)
    slots |= {"read": until, "carried": [exp.column("value"), *numbers(set_steps)]}
    set_steps.add("support/marked_codes", slots, f"{prefix}codes", {"samples": samples} | tables)
    ran = [column.name for column in numbers(set_steps)]
    codes, _, _ = add_last_codes(set_steps, prefix, ["calibrating", "value", *ran])
    has_gap = set_steps.method.gaps[set_steps.number] is not None
    over, values = _earlier(exp.column("calibration_value"), delays, has_gap)
    if has_gap and delays:
        over["segment_from"] = _newest(exp.column("breaking").eq(1), max(delays) - 1)
    program_columns = [exp.alias_(exp.column(name, table="delay_vector"), name) for name in ran]
    probed: dict[str, template.Slot] = {
        "sample_columns": [*[exp.column("breaking")] * (has_gap and bool(delays)), *numbers(set_steps)],
        "delayed": [*_named(over), *numbers(set_steps)],
        "reached": [*values, *program_columns],
    }
    set_steps.add("probe/probed", probed, tables={"codes": codes})


def _earlier(
    value: exp.Expr, delays: Sequence[int], has_gap: bool, rows: int | None = None
) -> tuple[dict[str, exp.Expr], list[exp.Expr]]:
    """Return columns with the values so many samples before, and each where it is in the segment."""
    path = "embedding/delayed" if rows is None else "streams/delayed"
    over, values = dict[str, exp.Expr](), []
    for delay in delays:
        slots: dict[str, template.Slot] = {"column": value, "delay": delay * (rows or 1)}
        over[f"value_{delay}"] = template.fill(path, slots)
        reached = template.fill("embedding/whole", {"span": delay})
        if has_gap:
            over[f"time_{delay}"] = _before("time", delay, rows)
            begun = exp.column(f"time_{delay}") >= exp.column("segment_from")
            reached = exp.and_(reached, begun)
        there = exp.Case(ifs=[exp.If(this=reached, true=exp.column(f"value_{delay}"))])
        values.append(exp.alias_(there, f"x_{delay}"))
    return over, values


class Stream(NamedTuple):
    """Properties of channels that are read in stored order.

    Attributes:
        lacks: whether samples may be missing, or count as such since they stand still.
        gap: the longest step inside a segment; None where no segment ends.
        drops: whether vectors with a coordinate outside the calibrated range count for nothing.
    """

    lacks: bool = False
    gap: int | None = None
    drops: bool = False

    @property
    def is_even(self) -> bool:
        """Tell whether every sample from the first whole vector on ends one that counts."""
        return not self.lacks and self.gap is None and not self.drops

    @property
    def value(self) -> exp.Expr:
        """The value of a sample."""
        reading = exp.column("reading", table="reading")
        return template.fill("streams/sound") if self.lacks else reading


@lru_cache
def stream_codes(
    setting: Parameters, stream: Stream, has_values: bool = False
) -> dict[str, template.Slot]:
    """Return the slots of streams/codes.sql that follow from the parameters alone; see stream_slots."""
    carried = [*compared(setting)] or [exp.column("value")] * has_values
    if stream.gap is not None:
        carried.append(exp.alias_(_breaking(stream.gap, rows=1), "breaking"))
    return {
        "value": stream.value,
        "place": place_in(setting.grid),
        "code": code_in(setting.grid, exp.column("place")),
        "carried": carried,
    }


def movement(
    still_after: int, carried: Sequence[exp.Expr], breaking: exp.Expr | None, rows: int | None = None
) -> dict[str, template.Slot]:
    """Return the slots of embedding/moving_codes.sql, along the ``rows`` as stored if there are any.

    Where segments may end, ``breaking`` tells whether one begins with a sample.
    """
    begins = {} if breaking is None else {"breaking": breaking}
    return {
        "sample_columns": [*carried, *_named(begins)],
        "begins": exp.false() if breaking is None else breaking.eq(1),
        "previous_value": _before("value", 1, rows),
        "moved_at": _newest(exp.column("moving").eq(1), max(still_after - 2, 0), rows),
        "held_from": _before("time", still_after - 1, rows),
        "carried": [*carried, *map(exp.column, begins)],
    }


@lru_cache
def stream_slots(
    setting: Parameters, has_context: bool, stream: Stream, delays: tuple[int, ...] = ()
) -> dict[str, template.Slot]:
    """Return the slots of streams/vectors.sql that follow from the parameters alone.

    Where a later run must know from where on it reads, that instant travels with each vector; for a
    probe so do the values so many samples before. Every channel has the same ones, so nobody may change
    them.
    """
    columns = coordinates(setting)
    over = {f"code_{k}": _before("code", k * setting.tau, rows=1) for k in range(1, setting.m)}
    if has_context:
        over["context_time"] = _before("time", max(setting.span - 1, 0), rows=1)
        columns.append(exp.column("context_time"))
    whole = template.fill("embedding/whole", {"span": setting.span})
    if stream.gap is not None:
        segment_columns, whole = _in_segment(setting, setting.span, rows=1)
        over |= segment_columns
    if delays:
        value = template.fill("streams/calibration_value")
        earlier, values = _earlier(value, delays[1:], stream.gap is not None, rows=1)
        over |= {"x_0": value, **earlier}
        columns += [exp.column("x_0"), *values]
    return {
        "is_present": all_present(setting) if stream.lacks else exp.true(),
        "whole": whole,
        "cell_key": cell_key(setting, "streams/cell_term"),
        "coordinates": columns,
        "delayed": _named(over),
    }


def counted_slots(setting: Parameters, stream: Stream) -> dict[str, template.Slot]:
    """Return which samples end a vector that counts, and the number of that vector among them."""
    slots = {"span": setting.span}
    if stream.is_even:
        counted = template.fill("embedding/whole", slots)
        return {"counted": counted, "number": template.fill("streams/number", slots)}
    counted = template.fill("streams/counts")
    if stream.drops:
        counted = exp.and_(counted, exp.not_(exp.paren(outside(setting))))
    return {"counted": counted, "number": template.fill("streams/counted_number")}


def small_key(setting: Parameters) -> exp.Expr:
    """Return the key of a vector's cell, in the cheapest form for supports that are bits."""
    return exp.cast(cell_key(setting, "streams/cell_term"), "BIGINT")


def is_outside(setting: Parameters) -> exp.Expr:
    """Return 1 if one of these codes lies outside the calibrated range, else 0."""
    return _flag(outside(setting))


def _context(setting: Parameters, span: int | exp.Expr) -> exp.Expr:
    """Return the time from where on the next vector is decided, of a span in samples."""
    delay = _reach(setting, span)
    if setting.still_after is None:
        return _before("time", delay)
    return template.fill("embedding/context", {"delay": delay, "long_ago": LONG_AGO})


def _flag(condition: exp.Expr) -> exp.Expr:
    """Return 1 where a condition holds, else 0."""
    return template.case([(condition.copy(), 1)], 0)


def _before(column: str, delay: int | exp.Expr, rows: int | None = None) -> exp.Expr:
    """Return the value of a column that many samples before: so many ``rows`` as stored for each."""
    if rows is None:
        return template.fill("embedding/delayed", {"column": exp.column(column), "delay": delay})
    assert isinstance(delay, int)
    return template.fill("streams/delayed", {"column": exp.column(column), "delay": delay * rows})


def _reach(setting: Parameters, span: int | exp.Expr) -> int | exp.Expr:
    """Return how many samples before a vector's newest one the next vector is decided, at least none."""
    after = setting.reach - setting.span - 1  # where samples stand still, more than those of the vector
    if isinstance(span, int):
        return max(span + after, 0)
    return span + after  # a vector of several coordinates reaches one sample back at least


def add_last_codes(
    set_steps: OfSet, prefix: str, carried: Sequence[str]
) -> tuple[str, dict[str, exp.Expr], exp.Expr]:
    """Add the codes of one set by segment, if segments end, and by stillness, if samples may be still.

    Returns:
        What the last step is called, the columns over its order that tell whether all samples of a
        vector are in one segment, and the condition that they are, and as many as it takes.
    """
    setting, codes = set_steps.setting, f"{prefix}codes"
    span = span_of(set_steps)
    segment_columns, whole = dict[str, exp.Expr](), template.fill("embedding/whole", {"span": span})
    columns: list[exp.Expr] = [exp.column(name) for name in carried]
    breaking, gap = None, set_steps.method.gaps[set_steps.number]
    if gap is not None:
        breaking = _breaking(exp.column("max_gap") if "max_gap" in set_steps.method.columns else gap)
        segment_columns, whole = _in_segment(setting, span)
    if setting.still_after is not None:
        before, codes = codes, f"{prefix}moving_codes"
        slots = movement(setting.still_after, [exp.column("channel_id"), *columns], breaking)
        set_steps.add("embedding/moving_codes", slots, codes, {"codes": before})
    elif breaking is not None:
        before, codes = codes, f"{prefix}breaking_codes"
        slots = {"breaking": breaking, "carried": columns}
        set_steps.add("embedding/breaking_codes", slots, codes, {"codes": before})
    return codes, segment_columns, whole


def _breaking(gap: int | exp.Expr, rows: int | None = None) -> exp.Expr:
    """Return 1 where a segment begins with a sample, since the step to it is longer than a gap."""
    slots: dict[str, template.Slot] = {"previous_time": _before("time", 1, rows), "max_gap": gap}
    return template.fill("embedding/breaking", slots)


def _in_segment(
    setting: Parameters, span: int | exp.Expr, rows: int | None = None
) -> tuple[dict[str, exp.Expr], exp.Expr]:
    """Return the columns that show whether the samples of a vector are in one segment, and a condition.

    The newest sample that begins one is looked for as far back as the largest span reaches: one before
    the vector decides nothing.
    """
    if not setting.span:
        return {}, template.fill("embedding/whole", {"span": 0})
    newest = _newest(exp.column("breaking").eq(1), setting.span - 1, rows)
    over = {"oldest_time": _before("time", span, rows), "segment_from": newest}
    return over, template.fill("embedding/in_segment", {"span": span})


def _newest(is_such: exp.Expr, before: int, rows: int | None = None) -> exp.Expr:
    """Return the time of the newest sample of a kind, as far as it is among each one and some before.

    Where it is told along the ``rows`` as stored, it may be farther back.
    """
    slots: dict[str, template.Slot] = {"is_such": is_such, "long_ago": LONG_AGO}
    if rows is not None:
        return template.fill("streams/newest", slots)
    return template.fill("embedding/newest", {**slots, "rows": before})


def _named(columns: Mapping[str, exp.Expr]) -> list[exp.Expr]:
    """Return expressions under their names."""
    return [exp.alias_(of, name) for name, of in columns.items()]
