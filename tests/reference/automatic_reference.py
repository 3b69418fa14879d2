"""Which delay, window and bins calibration chooses, in plain loops (both sides, section 4).

Built on :mod:`reference`; it shares no code with the package.
"""

import math
from collections import Counter
from dataclasses import replace
from typing import Any

import probe_reference
import reference
from reference import RUNGS, Channel, Pool, Settings

DELAYS = [1, 2, 3, 5, 8, 13, 21, 34, 55]

#: Delay -> bins -> score, of the grids that pass.
Scores = dict[int, dict[int, int]]


def rungs(settings: Settings) -> list[int]:
    """Return the grids to choose from."""
    if "bins" not in settings.open:
        return [settings.bins]
    return [bins for bins in RUNGS if bins <= settings.bins]


def looked_at(channel: Channel, is_cut: bool) -> list[tuple[int, object]]:
    """Return the places of the calibration samples that are looked at, each with its piece."""
    numbers = reference.segments(channel)
    places, pieces, parts = [], [], 0
    for place, healthy in enumerate(channel.healthy):
        parts += not healthy
        if healthy:
            places.append(place)
            pieces.append((numbers[place], parts))
    n = len(places)
    if not is_cut or n <= 20_000:
        return list(zip(places, pieces, strict=True))
    found: list[tuple[int, object]] = []
    for i in range(4):
        start = (n - 5000) * i // 3
        found += [(places[j], (i, pieces[j])) for j in range(start, start + 5000)]
    return found


def scores(
    members: list[Channel],
    pool: Pool,
    m: int,
    delays: list[int],
    window: int,
    is_cut: bool,
    thinning: int,
) -> Scores:
    """Return the scores of what passes, of a support that some members of a pool fill."""
    settings, found = pool.settings, Scores()
    usual = 1 if "tau" in settings.open else settings.tau
    least = len(_vectors(members, pool, m, usual, is_cut, window)[0])
    for delay in delays:
        vectors, blocks = _vectors(members, pool, m, delay, is_cut, window)
        if len(vectors) < settings.least_vectors or 10 * len(vectors) < 9 * least:
            continue
        for bins in rungs(settings):
            score = _score(members, pool, delay, bins, vectors, blocks, is_cut, thinning)
            if score is not None:
                found.setdefault(delay, {})[bins] = score
    return found


def _vectors(
    members: list[Channel], pool: Pool, m: int, delay: int, is_cut: bool, window: int
) -> tuple[list[tuple[Channel, list[int]]], list[int]]:
    """Return the vectors of a delay, as places of samples, newest first, and the blocks they are in."""
    found: list[tuple[Channel, list[int]]] = []
    blocks: list[int] = []
    for member in members:
        known = reference.usable(member, reference.segments(member))
        seen, own = looked_at(member, is_cut), []
        for i in range((m - 1) * delay, len(seen)):
            if seen[i - (m - 1) * delay][1] == seen[i][1]:
                vector = [seen[i - k * delay][0] for k in range(m)]
                inside = (pool.lo <= (member.values[at] or 0.0) <= pool.hi for at in vector)  # type: ignore[operator]
                if all(known[at] for at in vector) and all(inside):
                    own.append(vector)
        start = blocks[-1] + 1 if blocks else 0
        blocks += [start + block for block in reference.block_numbers(len(own), window)] if own else []
        found += [(member, vector) for vector in own]
    return found, blocks


def _score(
    members: list[Channel],
    pool: Pool,
    delay: int,
    bins: int,
    vectors: list[tuple[Channel, list[int]]],
    blocks: list[int],
    is_cut: bool,
    thinning: int,
) -> int | None:
    """Return the score of a delay and a grid; None where it does not pass."""
    lo, hi, target = pool.lo, pool.hi, pool.settings.target_floor
    assert lo is not None
    assert hi is not None

    codes: dict[float, int] = {}  # each sample is in several vectors

    def cell(values: list[float]) -> tuple[int, ...]:
        for x in values:
            if x not in codes:
                codes[x] = reference.code(x, lo, hi, bins)
        return tuple([codes[x] for x in values])

    held = [[member.values[at] or 0.0 for at in vector] for member, vector in vectors]
    cells = [cell(values) for values in held]
    visited: dict[tuple[int, ...], set[int]] = {}
    for place, block in zip(cells, blocks, strict=True):
        visited.setdefault(place, set()).add(block)
    parts = blocks
    if 1 < sum(any(member.healthy) for member in members) < len(members):
        parts = [members.index(member) for member, _ in vectors]
    seen: dict[tuple[int, ...], set[int]] = {}
    for place, part in zip(cells, parts, strict=True):
        seen.setdefault(place, set()).add(part)
    sizes = Counter(parts)
    alone = Counter(b for place, b in zip(cells, parts, strict=True) if len(seen[place]) == 1)
    shares = [alone[part] / size for part, size in sizes.items()]
    # Sums of whole units, as in the certificate: then the mean is the same on every machine.
    units = float(2**62 // len(shares))
    floor = sum(math.floor(share * units + 0.5) for share in shares) / (units * len(shares))
    if floor - target > 2**-40 or max(shares) > 0.9:
        return None
    limit = max(2 * floor, max(shares), target)
    places = [
        {place: (i, piece) for i, (place, piece) in enumerate(looked_at(member, is_cut))}
        for member in members
    ]
    orders = [looked_at(member, is_cut) for member in members]
    usable = [reference.usable(member, reference.segments(member)) for member in members]
    numbers = [id(member) for member in members]
    picked = [i for i in range(len(vectors)) if probe_reference.is_picked(i, len(vectors) * thinning)]
    q05, q50, q95 = probe_reference.usual([held[i][0] for i in picked])
    width = q95 - q05 or hi - lo
    m = len(held[0])
    plain = [k * delay for k in range(m)]
    changes: list[tuple[list[int], Any]] = []
    changes += [(plain, lambda x, p=p: probe_reference.shifted(x, p, width)) for p in (5, -5, 10, -10)]
    changes += [(plain, lambda x, p=p: probe_reference.stroked(x, p, q50)) for p in (5, 8, 12)]
    changes += [([0] * m, lambda x: x)]
    for p, q in ((3, 2), (2, 1), (2, 3)):
        delays = [(2 * k * p * delay + q) // (2 * q) for k in range(m)]
        if len(set(delays)) == m:
            changes.append((delays, lambda x: x))
    points = []
    for delays, change in changes:
        asked = novel = 0
        for i in picked:
            member, vector = vectors[i]
            which = numbers.index(id(member))
            newest, piece = places[which][vector[0]]
            values = []
            for one in delays:
                if newest < one or orders[which][newest - one][1] != piece:
                    break
                at = orders[which][newest - one][0]
                if not usable[which][at]:
                    break
                values.append(member.values[at] or 0.0)
            if len(values) < m:
                continue
            asked += 1
            novel += not (visited.get(cell([change(x) for x in values]), set()) - {blocks[i]})
        if asked:
            share = 500.0 * novel / (asked * limit) if asked * limit else math.inf
            points.append(0 if not novel else min(1000, math.floor(min(share, 1000))))
    return sum(points) // len(points) if points else 0


def siblings(pools: list[Pool]) -> list[list[tuple[int, Channel]]]:
    """Return channels with open settings that share delay and window, and the places of pools."""
    families: dict[tuple[Settings, str], list[tuple[int, Channel]]] = {}
    for place, pool in enumerate(pools):
        if pool.settings.open:
            for member in pool.members:
                families.setdefault((pool.settings, member.name), []).append((place, member))
    joined: dict[object, list[tuple[int, Channel]]] = {}
    for (settings, name), members in families.items():
        joined.setdefault((settings, name if len(members) > 1 else None), []).extend(members)
    return list(joined.values())


def choose(pools: list[Pool]) -> dict[int, Settings]:
    """Return the settings of open pools by their places; they have bounds on the finest grid."""
    answer: dict[int, Settings] = {}
    rough: dict[Settings, list[tuple[int, int, int, int]]] = {}
    for family in siblings(pools):
        for place, tau, window, thinning in _shared(family, pools):
            rough.setdefault(pools[place].settings, []).append((place, tau, window, thinning))
    for settings, of in rough.items():
        found: dict[int, Settings] = {}
        unsettled = []
        for place, tau, window, thinning in of:
            pool = pools[place]
            if not varies(pool):
                unsettled.append((place, tau, window, True))
                continue
            chosen = _of_pool(pool, tau, window, thinning)
            if chosen is None:
                unsettled.append((place, tau, window, False))
            else:
                found[place] = _settled(settings, chosen[0], chosen[1], chosen[2], window)
        usual = Counter(one.bins for one in found.values())
        commonest = max(usual, key=lambda bins: (usual[bins], bins), default=rungs(settings)[-1])
        for place, tau, window, is_still in unsettled:
            bins = commonest if is_still else rungs(settings)[-1]
            found[place] = _settled(settings, settings.m, tau, bins, window)
        answer |= found
    return answer


def varies(pool: Pool) -> bool:
    """Tell whether calibration has values that differ."""
    return pool.lo is not None and pool.hi is not None and pool.lo < pool.hi


def _settled(settings: Settings, m: int, tau: int, bins: int, window: int) -> Settings:
    stride = settings.stride if settings.asked_stride is not None else math.gcd(window, 100)
    return replace(settings, m=m, tau=tau, bins=bins, window=window, stride=stride, open=())


def _lower_median(counts: list[int]) -> int:
    return sorted(counts)[(len(counts) - 1) // 2] if counts else 0


def _shared(family: list[tuple[int, Channel]], pools: list[Pool]) -> list[tuple[int, int, int, int]]:
    """Return each pool of siblings with their delay and its window."""
    settings = pools[family[0][0]].settings
    windows, tau = windows_of(family, pools), settings.tau
    if "tau" in settings.open:
        sums, looked = compared(family, pools)
        most = max(sums.values(), default=0)
        passing = [delay for delay in sorted(sums) if sums[delay] >= most - 50 * looked]
        tau = passing[0] if passing else 1
    return [(place, tau, window, thinned(family)) for place, window in windows.items()]


def thinned(family: list[tuple[int, Channel]]) -> int:
    """Return one in how many vectors is picked of those that a probe picks."""
    return 1 if len(family) <= 2 else 2 if len(family) <= 4 else 4 if len(family) <= 8 else 8


def windows_of(family: list[tuple[int, Channel]], pools: list[Pool]) -> dict[int, int]:
    """Return the window of each pool of siblings."""
    settings = pools[family[0][0]].settings
    taught = [sum(member.healthy) for _, member in family if any(member.healthy)]
    shared = settings.window
    if "window" in settings.open:
        shared = _lower_median(taught) // 20
        shared = max(20, shared - shared % 100 if shared >= 200 else shared)
    windows: dict[int, int] = {}
    for place in dict.fromkeys(place for place, _ in family):
        own = [sum(member.healthy) for member in pools[place].members if any(member.healthy)]
        window = shared
        if "window" in settings.open and own:
            while window > 1 and _lower_median(own) < 8 * window:
                window //= 2
            if (stride := settings.asked_stride) is not None:
                window = max(stride, window // stride * stride)
        windows[place] = window
    return windows


def compared(family: list[tuple[int, Channel]], pools: list[Pool]) -> tuple[dict[int, int], int]:
    """Return the sum of scores for each delay, and of how many siblings it is."""
    settings, windows = pools[family[0][0]].settings, windows_of(family, pools)
    seen = [(place, one) for place, one in family if any(one.healthy) and varies(pools[place])]
    seen.sort(key=lambda pair: (pair[1].asset.encode(), pair[1].name.encode()))
    if len(seen) > 16:
        seen = [seen[i * len(seen) // 16] for i in range(16)]
    sums: dict[int, int] = {}
    for place, member in seen:
        window = max(1, min(windows[place], min(sum(member.healthy), 20_000) // 16))
        delays = DELAYS if settings.m > 1 else [1]
        for delay, of in scores(
            [member], pools[place], settings.m, delays, window, True, thinned(family)
        ).items():
            sums[delay] = sums.get(delay, 0) + max(of.values())
    return sums, len(seen)


def _of_pool(pool: Pool, tau: int, window: int, thinning: int) -> tuple[int, int, int] | None:
    """Return m, tau and bins of a pool; None where nothing passes."""
    settings = pool.settings
    is_open = "tau" in settings.open
    if "tau" not in settings.open and "bins" not in settings.open:
        return settings.m, settings.tau, settings.bins
    for delay in [tau, *reversed([one for one in DELAYS if one < tau])] if is_open else [tau]:
        passing = scores(pool.members, pool, settings.m, [delay], window, False, thinning).get(delay)
        if passing:
            most = max(passing.values())
            return settings.m, delay, max(b for b, score in passing.items() if score >= most - 50)
    for m in (2, 1) if settings.m == 3 and is_open else ():
        passing = scores(pool.members, pool, m, [1], window, False, thinning).get(1)
        if passing:
            return m, 1, max(passing)
    return None
