"""Judgements, limits and episodes once more, in plain loops: what the SQL must reproduce.

Written from the specification of alarms ("section n" is its), not from the package. It takes samples,
support and blocks from :mod:`reference`.
"""

import math
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import numpy as np

import reference
from reference import Answer, Channel, Pool, Row

#: Rates that the table has heights for, and the heights by blocks.
BLOCKS = [8, 12, 16, 24, 48]
TABLE = [
    (1 / 300, [1.5, 1.5, 1.5, 1.5, 1.5]),
    (1 / 1000, [5, 4, 3.5, 3, 2.5]),
    (1 / 5000, [13, 8, 6.5, 5, 4]),
]


def root(count: int) -> int:
    """Section 2: the square root of a count, in thousandths, downwards."""
    return math.isqrt(1_000_000 * count + 375_000)


def buffered(channel: Channel, pool: Pool, g: int) -> tuple[list[int], list[int]]:
    """Section 2: of each block its vectors, and those in cells that only blocks near it know."""
    start = sum(len(c.learnt) for c in pool.members[: pool.members.index(channel)])
    cells, blocks = reference.cells_of(pool).tolist(), pool.blocks.tolist()
    seen: dict[int, list[int]] = {}
    for cell, block in zip(cells, blocks, strict=True):
        seen.setdefault(cell, []).append(block)
    own = range(start, start + len(channel.learnt))
    first, last = blocks[own[0]], blocks[own[-1]]
    vectors, novel = [0] * (last - first + 1), [0] * (last - first + 1)
    for i in own:
        block = blocks[i]
        vectors[block - first] += 1
        low, high = max(block - g, first), min(block + g, last)
        novel[block - first] += all(low <= other <= high for other in seen[cells[i]])
    return vectors, novel


def roots_of(channel: Channel, pool: Pool, g: int) -> list[int]:
    """Section 2: the roots of the blocks of a window or more, brought to a window, half up."""
    if not channel.learnt or len(pool.blocks) == 0:
        return []
    window = pool.settings.window
    pairs = zip(*buffered(channel, pool, g), strict=True)
    return [root((2 * u * window + v) // (2 * v)) for v, u in pairs if v >= window]


def centre_and_spread(roots: list[int]) -> tuple[int, int]:
    """Section 2."""
    n, least = len(roots), min(roots)
    total = sum(x - least for x in roots)
    squares = sum((x - least) ** 2 for x in roots)
    wide = float(n * squares - total * total) * (n + 1) / (n * n * (n - 1))
    return least + total // n, max(500, math.floor(math.sqrt(wide)))


def order_ratio(channel: Channel, pool: Pool) -> int:
    """Section 3: vectors in cells that stay near one block, by those expected in random order."""
    g = 4
    _, novel = buffered(channel, pool, g)
    start = sum(len(c.learnt) for c in pool.members[: pool.members.index(channel)])
    cells, blocks = reference.cells_of(pool).tolist(), pool.blocks.tolist()
    own = range(start, start + len(channel.learnt))
    strangers = {cells[i] for i in range(len(cells)) if i not in own}
    n = len(novel)
    visits: dict[int, int] = {}
    for cell in {cells[i] for i in own} - strangers:
        inside = [blocks[i] for i in own if cells[i] == cell]
        visits[len(set(inside))] = visits.get(len(set(inside)), 0) + len(inside)
    expected = Fraction(0)
    for k in sorted(visits):
        if k <= 2 * g + 1:
            expected += visits[k] * chance(k, n, g)
    return math.floor(1000 * Fraction(sum(novel)) / max(expected, Fraction(1)) + Fraction(1, 2))


def chance(k: int, n: int, g: int) -> Fraction:
    """Section 3: p(k)."""
    total = Fraction(0)
    for b in range(n):
        near, product = min(b, g) + min(n - 1 - b, g), Fraction(1)
        for i in range(k - 1):
            product *= Fraction(near - i, n - 1 - i) if n - 1 - i else 0
        total += product
    return total / n


def judged(roots: list[int], reference_root: int, height: int, cap: int) -> Answer:
    """Section 4: evidence of each judgement, whether it is open, and the last one without evidence."""
    answer: Answer = []
    sums, up, down = [0], -1, -1
    zero: int | None = None
    for j, x in enumerate(roots):
        sums.append(sums[-1] + min(x - reference_root, cap))
        evidence = sums[-1] - min(sums[max(j - 50, -1) + 1 :] + ([0] if j <= 49 else []))
        if evidence >= height and x > reference_root:
            up = j
        if j >= 2 and all(y <= reference_root for y in roots[j - 2 : j + 1]):
            down = j
        if answer and answer[-1]["is_open"]:
            zero = j - 1
        if evidence == 0 or (height == 1 and x <= reference_root):
            zero = j
        answer.append({"evidence": evidence, "is_open": int(up > down), "last_zero": zero})
    return answer


def episodes_of(said: Answer) -> Answer:
    """Section 4: runs of open judgements, those with fewer than 10 between them as one."""
    found: Answer = []
    for j, row in enumerate(said):
        if not row["is_open"]:
            continue
        if found and j - found[-1]["last_judgement"] - 1 < 10:
            found[-1]["last_judgement"] = j
        else:
            onset = 0 if row["last_zero"] is None else row["last_zero"] + 1
            found.append({"onset": onset, "first_judgement": j, "last_judgement": j})
    return found


def replayed(roots: list[int], g: int) -> list[int]:
    """Section 3: each block as it stands when it and those near it are left out."""
    answer = []
    for j, x in enumerate(roots):
        centre, spread = centre_and_spread([y for b, y in enumerate(roots) if abs(b - j) > g])
        answer.append(math.floor(Fraction(1000 * (x - centre), spread)))
    return answer


def height_of(rate: float, rows: list[list[int]]) -> tuple[int, str]:
    """Section 3: the height in quarters, by replay or carried on."""
    n = sum(len(row) for row in rows)
    wanted = n * max(rate, 1 / (10 * n))
    counts = {}
    for h4 in range(4, 81):
        height = 250 * h4
        counts[h4] = sum(len(episodes_of(judged(r, 1000, height, (height + 1) // 2))) for r in rows)
    for h4, x in counts.items():
        if 10 * x + 7 <= 10 * wanted:
            return h4, "replay"
    points = [(h4 / 4, x) for h4, x in counts.items() if x > 0]
    if len(points) >= 3:
        # polyfit squares its weights.
        slope, level = np.polyfit(
            [h for h, _ in points],
            [math.log(x) for _, x in points],
            1,
            w=[math.sqrt(x) for _, x in points],
        )
        if slope < -1e-12:
            h4 = math.ceil(4 * (math.log(wanted) - level) / slope - 1e-9)
            return max(h4, next((h for h, x in counts.items() if x == 0), 80)), "extrapolated"
    return 32, "none"


def table_height(rate: float, n: int) -> int:
    """Section 3: the height by the table, upwards to a quarter."""
    rate = min(max(rate, 1 / 5000), 1 / 300)
    heights = [float(np.interp(n, BLOCKS, row)) for _, row in TABLE]
    at = [-math.log(r) for r, _ in TABLE]
    return math.ceil(4 * float(np.interp(-math.log(rate), at, heights)) - 1e-9)


def limits(
    rows: Iterable[Row], parameters: Any, calibration: Any, per_thousand: float, family: Any
) -> Answer:
    """Sections 2 and 3 for a counter: per channel its limit, or why there is none."""
    answer: Answer = []
    pairs = reference.channels(rows, parameters, calibration)
    general = reference.settings_of(parameters, "\0", "\0")
    for channel, pool in pairs:
        roots = roots_of(channel, pool, 1)
        ratio = order_ratio(channel, pool) if len(roots) >= 18 else None
        learnt = reference.limit(reference.judgement(pool), pool.settings.target_floor)
        reason = learnt["limit_reason"]
        if reason is None and len(roots) < 8:
            reason = "calibration shorter than 8 windows"
        elif reason is None and len(roots) * (max(roots) - min(roots)) > 3_000_000_000:
            reason = "counts of calibration too far apart"
        elif reason is None and ratio is not None and ratio > 1500:
            reason = "unrepresentative"
        named = [i for i, pattern in enumerate(family) if reference.glob(pattern, channel.name)]
        key = (
            ("pattern", named[0])
            if named
            else ("settings", channel.settings == general, channel.settings)
        )
        row = {"asset": channel.asset, "channel": channel.name, "order_ratio": ratio, "reason": reason}
        if reason is not None and reason != "unrepresentative" and learnt["hi_limit"] is not None:
            counts = range(pool.settings.window + 1)
            most = max(n for n in counts if n / pool.settings.window <= learnt["hi_limit"])
            row |= {"reference": root(most), "height": 1, "cap": 1, "basis": "indicator"}
        answer.append(row | {"blocks": len(roots), "key": key})
    for key in {row["key"] for row in answer}:
        members = [
            (row, pair)
            for row, pair in zip(answer, pairs, strict=True)
            if row["key"] == key and row["reason"] is None
        ]
        ratios = [row["order_ratio"] for row, _ in members if row["order_ratio"] is not None]
        drifts = bool(ratios) and Fraction(sum(ratios), len(ratios)) > 1050
        again = []
        for row, pair in members:
            row["g"] = 8 if drifts and row["blocks"] >= 40 else 1
            row["basis"] = None
            if drifts:
                row["basis"] = "drifting" if row["blocks"] >= 40 else "none"
            elif row["order_ratio"] is not None and row["order_ratio"] > 1100:
                row["basis"] = "none"
            if row["basis"] != "none":
                again.append(replayed(roots_of(*pair, row["g"]), row["g"]))
        is_enough = len(again) >= 5 and sum(len(one) for one in again) >= 300
        by_replay = height_of(per_thousand / 1000, again) if is_enough else None
        for row, pair in members:
            centre, spread = centre_and_spread(roots_of(*pair, row["g"]))
            h4, basis = by_replay or (table_height(per_thousand / 1000, row["blocks"]), "table")
            if row["basis"] == "none":
                h4, basis = 32, "none"
            row["basis"] = row["basis"] or basis
            height = (h4 * spread + 3) // 4
            row |= {"centre": centre, "spread": spread, "reference": centre + spread, "quarters": h4}
            row |= {"height": height, "cap": (height + 1) // 2}
    return answer


def judgements(
    rows: list[Row], parameters: Any, calibration: Any, limits: Answer
) -> tuple[Answer, Answer]:
    """Section 2 and 4: the judgements of channels that are judged, and their episodes."""
    answer: Answer = []
    found: Answer = []
    for limit, (channel, pool) in zip(
        limits, reference.channels(rows, parameters, calibration), strict=True
    ):
        if "height" not in limit:
            continue
        window = pool.settings.window
        novel = [row["novel"] for row in reference.health(channel, pool)]
        counts = [sum(novel[i : i + window]) for i in range(0, len(novel) - window + 1, window)]
        said = judged([root(n) for n in counts], limit["reference"], limit["height"], limit["cap"])
        name = {"asset": channel.asset, "channel": channel.name}
        for j, (count, row) in enumerate(zip(counts, said, strict=True)):
            answer.append(name | {"judgement": j, "novel": count, "root": root(count)} | row)
        for number, episode in enumerate(episodes_of(said), start=1):
            is_open = int(episode["last_judgement"] == len(counts) - 1)
            is_proving = int(limit["reason"] is None and episode["first_judgement"] < limit["blocks"])
            found.append(
                name | {"episode": number} | episode | {"is_open": is_open, "is_proving": is_proving}
            )
    return answer, found
