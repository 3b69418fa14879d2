"""The method once more, in plain loops: what every SQL engine must reproduce, integer for integer.

Written from the equations of the paper and from the specification of the method ("section n" is
the latter's), not from the package: it shares no code with it and imports nothing of it, so that
a misreading would have to be made twice to go unseen. Clarity goes before speed.

A row of the source is (asset, channel, time, value), time being an integer; where a column says which
program a machine runs, it comes fifth, a text or a whole number (both sides, section 5). Parameters and
calibration are read by attribute only, hence ``Any``: whatever has the attributes will do.
"""

import math
import re
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

import probe_reference

Row = tuple[str, str, int, float | None]
ProgramRow = tuple[str, str, int, float | None, Any]
Rows = Iterable[Row] | Iterable[ProgramRow]
Answer = list[dict[str, Any]]
Integers = NDArray[np.int64]

#: Where bins are to be found, the finest of these that passes is taken, the last if none does.
RUNGS = (128, 64, 32, 16, 8)


@dataclass(frozen=True)
class Settings:
    """The parameters of one channel after overrides, ``stride`` resolved (section 3).

    ``open``: which of tau, bins and window are to be chosen; until they are, tau is 1, and bins the
    finest for which keys have room.
    """

    m: int
    tau: int
    bins: int
    window: int
    stride: int
    max_gap: int | None
    still_after: int | None
    target_floor: float
    least_vectors: int = 1
    range: str = "robust"
    open: tuple[str, ...] = ()
    asked_stride: int | None = None


@dataclass
class Channel:
    """One signal in order of time. A vector is the positions of its m samples, newest first."""

    asset: str
    name: str
    settings: Settings
    times: list[int]
    values: list[float | None]
    conflicts: int
    healthy: list[bool]  # is this sample a calibration sample?
    end: int | None  # of the calibration; None where the channel has none of its own
    score_from: int | None
    learnt: list[list[int]] = field(default_factory=list)
    scored: list[list[int]] = field(default_factory=list)
    missing_vectors: int = 0
    codes: list[int] = field(default_factory=list)
    programs: list[Any] | None = None  # of each sample; None where no column says which
    numbers: list[int | None] = field(default_factory=list)  # of the programs; None where it has none


@dataclass
class Pool:
    """Channels sharing one support (one that stands alone is a pool of one), with that support.

    ``grid`` has the bins of each calibration vector, one line per vector in pool order, and
    ``blocks`` the number of the vector's block, counted over the whole pool. ``ran`` has the number of
    each vector's program, which is its place in ``programs``; where no column says which program runs,
    all have number 0.
    """

    members: list[Channel]
    settings: Settings
    lo: float | None = None
    hi: float | None = None
    dropped: list[float] = field(default_factory=list)
    keys: set[int] = field(default_factory=set)
    grid: Integers = field(default_factory=lambda: np.zeros((0, 1), np.int64))
    blocks: Integers = field(default_factory=lambda: np.zeros(0, np.int64))
    ran: Integers = field(default_factory=lambda: np.zeros(0, np.int64))
    programs: list[Any] = field(default_factory=list)


#: Every channel of a source with its pool.
Pairs = list[tuple[Channel, Pool]]


def glob(pattern: str, text: str) -> bool:
    """Match with ``*`` and ``?`` as the only wildcards (fnmatch would also read ``[ ]``)."""
    wild = {"*": ".*", "?": "."}
    return re.fullmatch("".join(wild.get(c, re.escape(c)) for c in pattern), text, re.S) is not None


def settings_of(parameters: Any, asset: str, name: str) -> Settings:
    """Section 3: a channel's parameters; the first override that matches applies, alone."""
    fields = [key for key in Settings.__dataclass_fields__ if key not in ("open", "asked_stride")]
    values = {key: getattr(parameters, key) for key in fields}
    for override in parameters.overrides:
        if glob(override.asset, asset) and glob(override.channel, name):
            if "window" in override.changes():
                values["stride"] = None
            values.update(override.changes())
            break
    are_open = tuple(key for key in ("tau", "bins", "window") if values[key] == "auto")
    room = [bins for bins in RUNGS if (bins + 3) ** values["m"] < 2**63]
    usual = {"tau": 1, "bins": room[0] if room else 0, "window": values["stride"] or 100}
    asked_stride = values["stride"] if "window" in are_open else None
    values |= {key: usual[key] for key in are_open}
    if values["stride"] is None:
        values["stride"] = math.gcd(values["window"], 100)
    return Settings(**values, open=are_open, asked_stride=asked_stride)


def collapse(found: Iterable[tuple[int, float | None]]) -> tuple[list[int], list[Any], int]:
    """Section 2: one sample per instant, the smallest non-missing value; count the conflicts."""
    instants: dict[int, list[float]] = {}
    for time, value in found:
        values = instants.setdefault(time, [])  # a missing value still makes the instant
        if value is not None and -1e300 <= value <= 1e300:  # False for NaN as well
            values.append(float(value))
    times = sorted(instants)
    smallest = [min(instants[t], default=None) for t in times]
    return times, smallest, sum(len(set(values)) > 1 for values in instants.values())


def collapse_programs(found: Iterable[tuple[int, float | None, Any]]) -> tuple[list[Any], int]:
    """Both sides, section 5: one program per instant, the least that is told; count all conflicts.

    Two programs of one instant are a conflict as two values are; an instant with both is one.
    """
    values: dict[int, set[float]] = {}
    programs: dict[int, set[Any]] = {}
    for time, value, program in found:
        of_time, ran = values.setdefault(time, set()), programs.setdefault(time, set())
        if value is not None and -1e300 <= value <= 1e300:
            of_time.add(float(value))
        if program is not None:
            ran.add(program)
    times = sorted(values)
    least = [min(programs[t], key=program_order, default=None) for t in times]
    return least, sum(len(values[t]) > 1 or len(programs[t]) > 1 for t in times)


def program_order(program: Any) -> Any:
    """Both sides, section 5: whole numbers by size, texts by their bytes."""
    return program.encode() if isinstance(program, str) else program


def rule_of(calibration: Any, asset: str) -> Any:
    """Section 4: the rule of a machine, or None for a machine that teaches nothing.

    Its own rule, if it has one; else the general one. That does not teach a machine of a pool in which
    others are named as healthy: by a rule of their own that is not empty, or as a reference.
    """
    rules = list(calibration.overrides.items())
    own = [rule for pattern, rule in rules if glob(pattern, asset)]
    if own:
        return own[0]
    references = calibration.reference
    references = [references] if isinstance(references, str) else list(references)
    if any(glob(pattern, asset) for pattern in references):
        return calibration
    pool = next((g for g in groups_of(calibration) if any(glob(p, asset) for p in g)), [])
    healthy = [p for p, rule in rules if rule is not None and list(rule.intervals or [()]) != []]
    named = any(meet(p, member) for p in healthy + references for member in pool)
    return None if named else calibration


def groups_of(calibration: Any) -> list[list[str]]:
    """Section 4: the groups of patterns that make a pool each."""
    groups = calibration.pool or []
    return [["*"]] if groups == "channel" else [[g] if isinstance(g, str) else list(g) for g in groups]


@cache
def meet(one: str, other: str) -> bool:
    """Is there a name of both patterns? By the first sign of each; a star ends, or takes one more."""
    if not one or not other:
        return set(one + other) <= {"*"}
    if one[0] == "*":
        return meet(one[1:], other) or meet(one, other[1:])
    if other[0] == "*":
        return meet(other, one)
    return (one[0] == other[0] or "?" in (one[0], other[0])) and meet(one[1:], other[1:])


def calibrated(
    calibration: Any, asset: str, times: list[int]
) -> tuple[list[bool], int | None, int | None]:
    """Section 4: which samples are calibration, when it ends, from when to score."""
    own = rule_of(calibration, asset)
    if own is None:
        return [False] * len(times), None, None
    if own.fraction is not None:
        first = math.floor(own.fraction * len(times))
        declared = [(times[0], times[first - 1])] if first > 0 else []
    elif own.duration is not None:
        declared = [(times[0], times[0] + own.duration)]
    else:
        declared = list(own.intervals)
    healthy = [
        any(a <= t <= b for a, b in declared) and not any(a <= t <= b for a, b in own.exclude)
        for t in times
    ]
    # The largest declared end, even where no sample lies there or an exclusion covers it.
    return healthy, max((b for _, b in declared), default=None), own.score_from


def segments(channel: Channel) -> list[int]:
    """Section 1: the number of the segment of each sample."""
    found, gap = [0], channel.settings.max_gap
    for before, time in pairwise(channel.times):
        found.append(found[-1] + (gap is not None and time - before > gap))
    return found


def usable(channel: Channel, segments: list[int]) -> list[bool]:
    """Alarms, section 1: which samples a vector may contain: those there are that do not stand still.

    Still is what ends still_after equal values in a row, none missing, all in one segment.
    """
    run, answer = 0, []
    for i, value in enumerate(channel.values):
        goes_on = i > 0 and segments[i] == segments[i - 1] and value == channel.values[i - 1]
        run = 0 if value is None else run + 1 if goes_on else 1
        after = channel.settings.still_after
        answer.append(value is not None and (after is None or run < after))
    return answer


def embed(channel: Channel) -> None:
    """Eq. 1 and section 4: find the delay vectors, and tell those to learn from those to score."""
    s, times, numbers = channel.settings, channel.times, segments(channel)
    known = usable(channel, numbers)
    span = (s.m - 1) * s.tau
    for newest in range(span, len(times)):
        oldest = newest - span
        vector = [newest - k * s.tau for k in range(s.m)]
        due = channel.end is None or times[newest] > channel.end
        if channel.score_from is not None:
            due = times[newest] >= channel.score_from
        if numbers[oldest] != numbers[newest]:
            continue
        if not all(known[i] for i in vector):
            channel.missing_vectors += 1
        # The samples between the delays count too: none may come from outside calibration.
        elif all(channel.healthy[oldest : newest + 1]):
            channel.learnt.append(vector)
        elif due:
            channel.scored.append(vector)


def code(x: float | None, lo: float, hi: float, bins: int) -> int:
    """Phi for one sample, section 3: 0 missing, 1 below, 2 + bin, bins + 2 above."""
    if x is None:
        return 0
    if x < lo or x > hi:
        return 1 if x < lo else bins + 2
    return 2 + (min(math.floor((x - lo) / (hi - lo) * bins), bins - 1) if lo < hi else 0)


def cell_key(channel: Channel, vector: list[int]) -> int:
    """Phi for one vector, section 3: sum over k of code(x(t - k tau)) * (bins + 3)^k.

    The number of the program of its newest sample is the highest digit.
    """
    radix, number = channel.settings.bins + 3, 0
    if channel.programs is not None:
        number = channel.numbers[vector[0]] or 0
    return sum(code * radix**k for k, code in enumerate([*(channel.codes[i] for i in vector), number]))


def block_numbers(n: int, window: int) -> list[int]:
    """Section 5: blocks of ``window`` vectors, the rest to the last; 8 equal ones if fewer."""
    if n // window >= 8:
        return [min(i // window, n // window - 1) for i in range(n)]
    eighths = [8 * i // n for i in range(n)]
    order = sorted(set(eighths))  # with n < 8 some blocks would be empty: number the others anew
    return [order.index(eighth) for eighth in eighths]


def without_strays(values: list[float]) -> tuple[list[float], list[float]]:
    """Both sides, section 1: what is kept of calibration values, in order, and what is dropped."""
    kept, dropped = sorted(values), list[float]()
    allowed = max(3, len(kept) // 1000)
    for _ in range(4):
        lo, hi = kept[0], kept[-1]
        if lo == hi:
            break
        pieces = [min(127, math.floor((x - lo) / (hi - lo) * 128)) for x in kept]
        # The first piece whose cumulated count exceeds what is allowed holds that sample.
        first, last = pieces[allowed : allowed + 1], pieces[::-1][allowed : allowed + 1]
        if not first or first[0] > last[0]:
            break
        width, held = last[0] - first[0] + 1, sorted(set(pieces))
        gaps = [(a, b) for a, b in pairwise(held) if b - a - 1 >= width]
        bottom = max((b for _, b in gaps if b <= first[0]), default=0)
        top = min((a for a, _ in gaps if a >= last[0]), default=127)
        inside = [x for x, piece in zip(kept, pieces, strict=True) if bottom <= piece <= top]
        beyond = [x for x, piece in zip(kept, pieces, strict=True) if not bottom <= piece <= top]
        if not 0 < len(beyond) <= allowed or inside[0] == inside[-1]:
            break
        kept, dropped, allowed = inside, dropped + beyond, allowed - len(beyond)
    return kept, dropped


def learn(pool: Pool) -> None:
    """Eq. 3: bounds over all members, codes, and the set of cells that calibration visited."""
    number_programs(pool)
    usable: list[float] = []
    for c in pool.members:
        pairs = zip(c.values, c.healthy, strict=True)
        usable += [x for x, healthy in pairs if healthy and x is not None]
    if not usable:
        return
    if pool.settings.range == "robust":
        usable, pool.dropped = without_strays(usable)
    pool.lo, pool.hi = lo, hi = min(usable), max(usable)
    grid: list[list[int]] = []
    blocks: list[int] = []
    ran: list[int] = []
    for c in pool.members:
        c.codes = [code(x, lo, hi, pool.settings.bins) for x in c.values]
        # What was dropped is taught to nobody, though it is of calibration and not scored either.
        top = pool.settings.bins + 2
        c.learnt = [v for v in c.learnt if all(c.codes[i] not in (1, top) for i in v)]
        c.learnt = [v for v in c.learnt if c.numbers[v[0]] is not None]
        pool.keys |= {cell_key(c, vector) for vector in c.learnt}
        grid += [[c.codes[i] - 2 for i in vector] for vector in c.learnt]
        ran += [c.numbers[vector[0]] or 0 for vector in c.learnt]
        start = blocks[-1] + 1 if blocks else 0
        blocks += [start + b for b in block_numbers(len(c.learnt), pool.settings.window)]
    if grid:
        pool.grid, pool.blocks = np.array(grid, np.int64), np.array(blocks, np.int64)
        pool.ran = np.array(ran, np.int64)
    for c in pool.members:
        judge_programs(c, pool)


def judge_programs(channel: Channel, pool: Pool) -> None:
    """Both sides, section 5: number a channel's samples; vectors of some programs are not scored."""
    number_samples(channel, pool)
    if channel.programs is not None:
        judged = {row["number"] for row in learnt_programs(pool) if row["verdict"] == "ready"}
        channel.scored = [v for v in channel.scored if channel.numbers[v[0]] in judged]


def number_programs(pool: Pool) -> None:
    """Both sides, section 5: number the programs of calibration, and the samples by them."""
    held = {
        program
        for c in pool.members
        for program, healthy in zip(c.programs or [], c.healthy, strict=False)
        if healthy and program is not None
    }
    pool.programs = sorted(held, key=program_order)
    for c in pool.members:
        number_samples(c, pool)


def number_samples(channel: Channel, pool: Pool) -> None:
    """Give each sample the number of its program; where no column says which runs, all have 0."""
    channel.numbers = [0] * len(channel.times)
    if channel.programs is not None:
        numbers = {program: number for number, program in enumerate(pool.programs)}
        channel.numbers = [numbers.get(program) for program in channel.programs]


def learnt_programs(pool: Pool) -> Answer:
    """Both sides, section 5: what calibration says of each of its programs, by number."""
    vectors = Counter(pool.ran.tolist())
    alone = Counter[int]()
    if len(pool.blocks):
        cells = cells_of(pool)
        blocks: dict[int, set[int]] = {}
        for cell, block in zip(cells.tolist(), pool.blocks.tolist(), strict=True):
            blocks.setdefault(cell, set()).add(block)
        for cell, number in zip(cells.tolist(), pool.ran.tolist(), strict=True):
            alone[number] += len(blocks[cell]) == 1
    answer = []
    for number, program in enumerate(pool.programs):
        n, share = vectors[number], pool.settings.target_floor
        enough = n >= max(pool.settings.least_vectors, 1) and alone[number] / n <= share
        row = {"number": number, "program": program, "vectors": n, "unvouched": alone[number]}
        answer.append(row | {"verdict": "ready" if enough else "needs_data"})
    return answer


def channels(rows: Rows, parameters: Any, calibration: Any) -> Pairs:
    """Sections 2 to 4: every channel of the source with its pool, by asset and name."""
    pairs, pools = opened(rows, parameters, calibration)
    settle(pools)
    return pairs


def opened(rows: Rows, parameters: Any, calibration: Any) -> tuple[Pairs, list[Pool]]:
    """The same before settings are chosen, and the pools."""
    found: dict[tuple[str, str], list[tuple[int, float | None]]] = {}
    told: dict[tuple[str, str], list[tuple[int, float | None, Any]]] = {}
    for asset, name, time, value, *program in rows:
        found.setdefault((asset, name), []).append((time, value))
        for one in program:
            told.setdefault((asset, name), []).append((time, value, one))
    groups = groups_of(calibration)
    pools: dict[tuple[object, ...], Pool] = {}
    pairs = []
    for asset, name in sorted(found):
        settings = settings_of(parameters, asset, name)
        times, values, conflicts = collapse(found[asset, name])
        own = calibrated(calibration, asset, times)
        channel = Channel(asset, name, settings, times, values, conflicts, *own)
        if told:
            channel.programs, channel.conflicts = collapse_programs(told[asset, name])
        embed(channel)
        numbers = [g for g, group in enumerate(groups) if any(glob(p, asset) for p in group)]
        key = (numbers[0], name, settings) if numbers else ("alone", asset, name)
        pool = pools.setdefault(key, Pool([], settings))
        pool.members.append(channel)
        pairs.append((channel, pool))
    for pool in pools.values():
        learn(pool)
    return pairs, list(pools.values())


def settle(pools: list[Pool]) -> None:
    """Give pools with open settings those that calibration chooses, and let them learn anew."""
    if not any(pool.settings.open for pool in pools):
        return
    import automatic_reference  # it is built on this module

    for place, settings in automatic_reference.choose(pools).items():
        pool = pools[place]
        pool.settings, pool.keys, pool.dropped = settings, set(), []
        pool.grid, pool.blocks = np.zeros((0, 1), np.int64), np.zeros(0, np.int64)
        pool.ran = np.zeros(0, np.int64)
        for channel in pool.members:
            channel.settings, channel.learnt, channel.scored = settings, [], []
            channel.missing_vectors = 0
            embed(channel)
        learn(pool)


def health(channel: Channel, pool: Pool) -> Iterator[dict[str, Any]]:
    """Eq. 4, a = 1 where the cell is not in the support, and Eq. 2, its mean over the window."""
    bins, window, novel = pool.settings.bins, pool.settings.window, []
    for vector in channel.scored if pool.lo is not None else []:
        key = cell_key(channel, vector)
        novel.append(int(key not in pool.keys))
        recent = novel[-window:]
        yield {
            "asset": channel.asset,
            "channel": channel.name,
            "time": channel.times[vector[0]],
            "cell_key": key,
            "novel": novel[-1],
            "out_of_range": int(any(channel.codes[i] in (1, bins + 2) for i in vector)),
            "straddling": int(any(channel.healthy[i] for i in vector)),
            "novel_in_window": sum(recent),
            "vectors_in_window": len(recent),
            "hi": sum(recent) / window if len(recent) == window else None,
        }


def health_indicator(rows: Rows, parameters: Any, calibration: Any) -> Answer:
    """Eq. 2: the share of novel vectors among the last W scored ones, at every scored vector."""
    return _singles(channels(rows, parameters, calibration))


def _singles(pairs: Pairs) -> Answer:
    return [row for pair in pairs for row in health(*pair)]


def buckets(rows: Rows, parameters: Any, calibration: Any) -> Answer:
    """Section 4, stored form: Eq. 2 after every ``stride`` scored vectors; full buckets only."""
    return _buckets(channels(rows, parameters, calibration))


def _buckets(pairs: Pairs) -> Answer:
    answer = []
    for channel, pool in pairs:
        stride, per_window = pool.settings.stride, pool.settings.window // pool.settings.stride
        scored, novel = list(health(channel, pool)), []
        for bucket in range(len(scored) // stride):
            inside = scored[bucket * stride : (bucket + 1) * stride]
            novel.append(sum(row["novel"] for row in inside))
            recent = sum(novel[-per_window:]) if len(novel) >= per_window else None
            row = {
                "asset": channel.asset,
                "channel": channel.name,
                "bucket": bucket,
                "first_time": inside[0]["time"],
                "last_time": inside[-1]["time"],
                "novel": novel[-1],
                "out_of_range": sum(row["out_of_range"] for row in inside),
                "novel_in_window": recent,
                "hi": None if recent is None else recent / pool.settings.window,
            }
            answer.append(row)
    return answer


def numbered(grid: Integers) -> Integers:
    """The cell of each calibration vector, as a number from 0: equal bins, equal number."""
    return np.unique(grid, axis=0, return_inverse=True)[1].reshape(-1)


def cells_of(pool: Pool, divisor: int = 1) -> Integers:
    """The cell of each calibration vector, on a grid so many times coarser; one cell, one program."""
    return numbered(np.column_stack([pool.grid // divisor, pool.ran]))


def left_out(cells: Integers, blocks: Integers) -> tuple[Integers, Integers]:
    """Section 5: per block its vectors, and those of them in cells that no other block visited."""
    first, last = np.full(cells.max() + 1, len(cells)), np.full(cells.max() + 1, -1)
    np.minimum.at(first, cells, blocks)
    np.maximum.at(last, cells, blocks)
    vectors = np.bincount(blocks)
    return vectors, np.bincount(blocks[(first == last)[cells]], minlength=len(vectors))


def floor_of(cells: Integers, blocks: Integers) -> float:
    """Section 5: the mean, over the blocks, of the healthy HI each would have had if left out."""
    vectors, novel = left_out(cells, blocks)
    return math.fsum(novel / vectors) / len(vectors)


def finest_bins(pool: Pool, floor: float) -> int | None:
    """Section 5: the finest grid of the halving ladder whose floor is at most the target."""
    if len(pool.blocks) < pool.settings.least_vectors:
        return None
    target, divisor, bins = pool.settings.target_floor, 1, pool.settings.bins
    while floor > target:
        divisor *= 2
        bins = math.ceil(pool.settings.bins / divisor)
        if bins < 2:
            return None
        floor = floor_of(cells_of(pool, divisor), pool.blocks)
    return bins


def vectors_needed(pool: Pool, floor: float) -> int | None:
    """Section 5: calibration still wanted, by a power law through half of the blocks and all."""
    settings = pool.settings
    target, window, least = settings.target_floor, settings.window, settings.least_vectors
    n, count = len(pool.blocks), int(pool.blocks[-1]) + 1
    if n < least:  # at least what it takes to be judged
        enough = replace(settings, least_vectors=1)
        further = vectors_needed(replace(pool, settings=enough), floor)
        return max(further or 0, window * math.ceil((least - n) / window))
    if floor <= target:
        return 0
    if count < 4 or target <= 0:
        return None
    half = pool.blocks < count // 2
    floor_half = floor_of(cells_of(pool)[half], pool.blocks[half])
    b = math.log(floor_half / floor) / math.log(n / int(half.sum())) if floor_half > 0 else 0.0
    if b <= 0:
        return None  # more calibration has not helped so far
    exponent = math.log(floor / target) / b
    if exponent > 700 or n * math.exp(exponent) > 1000 * n:  # exp overflows beyond 709
        return None
    # In whole windows; the last bit of exp must not add one where the figure is whole already.
    return window * math.ceil((n * math.exp(exponent) - n) / window - 2**-20)


def judgement(pool: Pool) -> dict[str, Any]:
    """Section 5: what the calibration of a pool says about itself, and the verdict."""
    names = "floor floor_sd floor_max good_turing cells_per_vector finest_bins vectors_needed"
    if len(pool.blocks) == 0:
        return {"verdict": "no_data", "blocks": 0} | dict.fromkeys(names.split())
    cells = cells_of(pool)
    vectors, novel = left_out(cells, pool.blocks)
    visits, floor = np.bincount(cells), floor_of(cells, pool.blocks)
    finest = finest_bins(pool, floor)
    verdict = "needs_data" if finest is None else "too_fine"
    if floor <= pool.settings.target_floor and finest is not None:
        verdict = "ready"
    return {
        "verdict": "constant" if pool.lo == pool.hi else verdict,
        "blocks": len(vectors),
        "floor": floor,
        "floor_sd": float(np.std(novel / vectors, ddof=1)) if len(vectors) > 1 else None,
        "floor_max": float(np.max(novel / vectors)),
        "good_turing": int(np.sum(visits == 1)) / len(cells),
        "cells_per_vector": len(visits) / len(cells),
        "finest_bins": finest,
        "vectors_needed": vectors_needed(pool, floor),
    }


def of_machines(pool: Pool) -> dict[str, Any]:
    """Both sides, section 6: the certificate that leaves out one machine after another."""
    teachers = [member for member in pool.members if member.learnt]
    owners = np.repeat(np.arange(len(teachers)), [len(member.learnt) for member in teachers])
    said = judgement(replace(pool, blocks=owners))
    said |= {"blocks": judgement(pool)["blocks"], "vouched_by": len(teachers)}
    if said["verdict"] != "ready":
        said["vectors_needed"] = None
    if len(teachers) == 1:
        nothing = dict.fromkeys(("floor", "floor_sd", "floor_max", "finest_bins", "vectors_needed"))
        said |= nothing
        if said["verdict"] != "constant":
            said["verdict"] = "not_vouched"
    return said


def taught_by(pool: Pool) -> str:
    """Both sides, section 6: the machines that taught a pool, the first two of more than three."""
    *first, last = [member.asset for member in pool.members if member.learnt]
    if len(first) > 2:
        first, last = first[:2], f"{len(first) - 1} more"
    return f"{', '.join(first)} and {last}" if first else last


def certified(channel: Channel, pool: Pool) -> dict[str, Any]:
    """Section 5 and both sides, sections 3 and 6: the verdict with what the indicator would show."""
    said = standard = judgement(pool) | {"vouched_by": None}
    whose: dict[str, Any] = {"taught_by": None, "member_floor": None}
    if pool.keys and len(pool.members) > 1:
        others = of_machines(pool)
        whose = {"taught_by": taught_by(pool), "member_floor": others["floor"]}
        if not all(member.learnt for member in pool.members):
            standard = said if others["vouched_by"] == 1 else others
            said = said if channel.learnt else others
    return said | whose | probe_reference.sight(pool, said["verdict"], standard)


NO_LIMIT = {
    "no_data": "no calibration",
    "constant": "constant in calibration",
    "too_fine": "grid too fine for its calibration",
    "needs_data": "calibration too short",
    "not_vouched": "only one machine of its pool taught",
}


def limit(said: dict[str, Any], target_floor: float) -> dict[str, Any]:
    """The health indicator above which a channel is high, or why there is none."""
    reason = NO_LIMIT.get(said["verdict"])
    highest = None if reason else max(2 * said["floor"], said["floor_max"], target_floor)
    return {"hi_limit": highest, "limit_reason": reason}


def support(rows: Rows, parameters: Any, calibration: Any) -> Answer:
    """Eq. 3 and section 5: per channel the bounds, the counts and the verdict of its pool."""
    return _support(channels(rows, parameters, calibration))


def dropped(pool: Pool) -> dict[str, Any]:
    """Both sides, section 1: how many calibration values were left out, and the farthest of them."""
    middle = 0.0 if pool.lo is None else pool.lo
    below, above = [x for x in pool.dropped if x < middle], [x for x in pool.dropped if x > middle]
    return {
        "dropped_below": len(below),
        "dropped_above": len(above),
        "lowest_dropped": min(below, default=None),
        "highest_dropped": max(above, default=None),
    }


def _support(pairs: Pairs) -> Answer:
    return [
        {
            "asset": channel.asset,
            "channel": channel.name,
            "calibrated_lo": pool.lo,
            "calibrated_hi": pool.hi,
            **dropped(pool),
            "samples": len(channel.times),
            "calibration_samples": sum(channel.healthy),
            "calibration_vectors": len(channel.learnt),
            "cells": len(pool.keys),
            "missing_vectors": channel.missing_vectors,
            "conflicts": channel.conflicts,
        }
        | (said := certified(channel, pool))
        | limit(said, pool.settings.target_floor)
        for channel, pool in pairs
    ]


def programs(rows: Rows, parameters: Any, calibration: Any) -> Answer:
    """Both sides, section 5: what each channel ran, in calibration and since."""
    return _programs(channels(rows, parameters, calibration))


def _programs(pairs: Pairs) -> Answer:
    answer = []
    for channel, pool in pairs:
        since: dict[Any, list[int]] = {}
        for time, value, program in zip(
            channel.times, channel.values, channel.programs or [], strict=True
        ):
            first = channel.score_from
            is_due = channel.end is None or time > channel.end if first is None else time >= first
            if is_due and value is not None:
                since.setdefault(program, []).append(time)
        learnt = learnt_programs(pool)
        rest = [one for one in since if one not in pool.programs]
        rest.sort(key=lambda one: (one is None, b"" if one is None else program_order(one)))
        nothing = {"verdict": "unknown", "vectors": 0, "unvouched": 0}
        for row in [*learnt, *({"program": program} | nothing for program in rest)]:
            program, n, times = row["program"], row["vectors"], since.get(row["program"], [])
            answer.append(
                {
                    "asset": channel.asset,
                    "channel": channel.name,
                    "program": None if program is None else str(program),
                    "verdict": row["verdict"],
                    "vectors": n,
                    "unvouched": row["unvouched"],
                    "floor": row["unvouched"] / n if n else None,
                    "readings": len(times),
                    "first_time": min(times, default=None),
                    "last_time": max(times, default=None),
                }
            )
    return answer


def certificate(rows: Rows, parameters: Any, calibration: Any) -> Answer:
    """Section 5: per block its two integers, and the learning curve up to and with it."""
    return _certificate(channels(rows, parameters, calibration))


def _certificate(pairs: Pairs) -> Answer:
    answer: Answer = []
    for channel, pool in pairs:
        if not channel.learnt:
            continue
        cells = cells_of(pool)
        vectors, novel = left_out(cells, pool.blocks)
        start = sum(len(c.learnt) for c in pool.members[: pool.members.index(channel)])
        own = pool.blocks[start : start + len(channel.learnt)]
        for block in np.unique(own):
            inside = np.flatnonzero(own == block)
            known = pool.blocks <= block
            row = {
                "asset": channel.asset,
                "channel": channel.name,
                "block": int(block - own[0]),
                "vectors": int(vectors[block]),
                "novel": int(novel[block]),
                "first_time": channel.times[channel.learnt[inside[0]][0]],
                "last_time": channel.times[channel.learnt[inside[-1]][0]],
                "healthy_hi": int(novel[block]) / int(vectors[block]),
                "learned_vectors": int(known.sum()),
                "learned_cells": len(set(cells[known].tolist())),
                "learned_floor": floor_of(cells[known], pool.blocks[known]),
            }
            answer.append(row)
    return answer


def answers(rows: Rows, parameters: Any, calibration: Any) -> dict[str, Answer]:
    """All four, of channels that are counted once."""
    pairs = channels(rows, parameters, calibration)
    return {
        "health_indicator": _singles(pairs),
        "health_at_buckets": _buckets(pairs),
        "support": _support(pairs),
        "certificate": _certificate(pairs),
    }
