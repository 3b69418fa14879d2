"""Why an episode was raised, once more in NumPy: bands and cells as the views must show them.

Written from section 5 of the specification of alarms. It takes samples, support and blocks from
:mod:`reference`, and shares nothing with the SQL.
"""

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np

import reference
from reference import Answer, Channel, Integers, Pool, Row


def band(code: int, bins: int) -> int:
    """The band of a code: -1 below, then twentieths of the range, the number of them above."""
    if code == 1:
        return -1
    return min(20, bins) if code == bins + 2 else (code - 2) * min(20, bins) // bins


def place_of(number: int, pool: Pool) -> tuple[str, float | None, float | None]:
    """Where a band lies: the bins that belong to it, from the edge of the first to that of the last."""
    bins, lo, hi = pool.settings.bins, pool.lo, pool.hi
    assert lo is not None
    assert hi is not None
    if number == -1:
        return "below", None, lo
    if number == min(20, bins):
        return "above", hi, None
    own = [one for one in range(bins) if band(one + 2, bins) == number]
    first, last = own[0], own[-1] + 1
    ends = [lo + (hi - lo) * edge / bins for edge in (first, last)]
    return "within", ends[0], hi if last == bins else ends[1]


def vectors(channel: Channel, found: list[list[int]], m: int) -> Integers:
    """The codes of vectors, one line each, the newest coordinate first."""
    return np.array([[channel.codes[i] for i in one] for one in found], np.int64).reshape(-1, m)


def healthy_bands(channel: Channel, pool: Pool, g: int) -> tuple[Counter[int], Counter[int]]:
    """By band the vectors of calibration, and those whose cell only blocks near theirs know."""
    start = sum(len(one.learnt) for one in pool.members[: pool.members.index(channel)])
    own = range(start, start + len(channel.learnt))
    # pool.grid has bins, codes are two more; in calibration all lie in range.
    cells, blocks = reference.cells_of(pool).tolist(), pool.blocks.tolist()
    seen: dict[int, set[int]] = {}
    for cell, block in zip(cells, blocks, strict=True):
        seen.setdefault(cell, set()).add(block)
    visits: Counter[int] = Counter()
    novel: Counter[int] = Counter()
    mine = {blocks[i] for i in own}
    codes = vectors(channel, channel.learnt, pool.settings.m)
    for i, code in zip(own, codes[:, 0].tolist(), strict=True):
        number = band(code, pool.settings.bins)
        visits[number] += 1
        novel[number] += all(abs(b - blocks[i]) <= g and b in mine for b in seen[cells[i]])
    return visits, novel


def bands(channel: Channel, pool: Pool, g: int, episode: dict[str, Any]) -> Answer:
    """The excess of each band that the first five judgements of an episode visited."""
    window, bins = pool.settings.window, pool.settings.bins
    first = episode["first_judgement"]
    end = min(first + 5, episode["last_judgement"] + 1)
    counted: Counter[int] = Counter()
    novel: Counter[int] = Counter()
    for vector in channel.scored[first * window : end * window]:
        number = band(channel.codes[vector[0]], bins)
        counted[number] += 1
        novel[number] += reference.cell_key(channel, vector) not in pool.keys
    taught, unlike = healthy_bands(channel, pool, g)
    answer: Answer = []
    for number in sorted(counted):
        where, low, high = place_of(number, pool)
        expected = Fraction(counted[number] * unlike[number], taught[number] or 1)
        answer.append(
            {
                **{"band": number, "place": where, "value_from": low, "value_to": high},
                **{"novel": novel[number], "visits": counted[number]},
                **{"calibration_novel": unlike[number], "calibration_visits": taught[number]},
                "excess": float(novel[number] - expected),
            }
        )
    return answer


def cells(channel: Channel, pool: Pool, episode: dict[str, Any]) -> Answer:
    """The ten commonest novel cells of an episode, beside the healthy cell that is nearest."""
    window, m = pool.settings.window, pool.settings.m
    inside = channel.scored[
        episode["first_judgement"] * window : (episode["last_judgement"] + 1) * window
    ]
    found: dict[int, list[list[int]]] = {}
    for vector in inside:
        key = reference.cell_key(channel, vector)
        if key not in pool.keys:
            found.setdefault(key, []).append(vector)
    keys = sorted(pool.keys)
    radix = pool.settings.bins + 3
    healthy = np.array([[key // radix**k % radix for k in range(m)] for key in keys], np.int64)
    answer: Answer = []
    commonest = sorted(found, key=lambda key: (-len(found[key]), key))[:10]
    for rank, key in enumerate(commonest, start=1):
        codes = vectors(channel, found[key][:1], m)[0]
        away = np.abs(healthy - codes).max(axis=1)
        nearest = int(away.argmin())  # of equal ones the first, so the smallest key
        times = [channel.times[vector[0]] for vector in found[key]]
        for axis in range(m):
            answer.append(
                {
                    **{"cell_rank": rank, "cell_key": key, "visits": len(times)},
                    **{"first_tick": min(times), "last_tick": max(times), "axis": axis},
                    **{"nearest_key": keys[nearest], "steps": int(away[nearest])},
                    "displacement": int(codes[axis] - healthy[nearest][axis]),
                }
            )
    return answer


def explained(
    rows: Iterable[Row], parameters: Any, calibration: Any, limits: Answer, episodes: Answer
) -> tuple[Answer, Answer]:
    """Bands and cells of all episodes (asset, channel, first_judgement, last_judgement)."""
    pairs = {
        (channel.asset, channel.name): (channel, pool)
        for channel, pool in reference.channels(rows, parameters, calibration)
    }
    widths = {(row["asset"], row["channel"]): row.get("g", 1) for row in limits}
    in_bands: Answer = []
    in_cells: Answer = []
    for episode in episodes:
        key = (episode["asset"], episode["channel"])
        name = {"asset": key[0], "channel": key[1], "first_judgement": episode["first_judgement"]}
        in_bands += [name | row for row in bands(*pairs[key], widths[key], episode)]
        in_cells += [name | row for row in cells(*pairs[key], episode)]
    return in_bands, in_cells
