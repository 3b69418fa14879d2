"""What the indicator would show if a machine changed, in plain loops (both sides, section 2).

Built on :mod:`reference`, which finds the calibration vectors; it shares no code with the package.
"""

from __future__ import annotations

from typing import Any

import reference

SHIFTS = [sign * part for part in (1, 2, 5, 10, 20, 50) for sign in (1, -1)]
SPEEDS = [(3, 2), (2, 1), (2, 3)]


def is_picked(number: int, vectors: int) -> bool:
    """Tell whether the vector of a number is one of those by which a support is probed."""
    return (number * 1640531527) % 2**32 < 2**32 // (vectors // 1000 + 1)


def usual(values: list[float]) -> tuple[float, float, float]:
    """Return q05, q50 and q95 of some values."""
    ordered, n = sorted(values), len(values)
    return ordered[(n + 19) // 20 - 1], ordered[(n + 1) // 2 - 1], ordered[n - n // 20 - 1]


def shifted(x: float, percent: int, width: float) -> float:
    """Return a sample moved by so many hundredths of a width; one below 1e-290 moves nothing."""
    return x + percent / 100.0 * width if width > 1e-290 else x


def stroked(x: float, tenths: int, middle: float) -> float:
    """Return a sample so many tenths as far from the middle; one within 1e-290 of it stays."""
    return x if -1e-290 <= x - middle <= 1e-290 else middle + tenths / 10.0 * (x - middle)


def readable(channel: reference.Channel) -> tuple[list[int], list[bool]]:
    """Return the segment of each sample, and which samples a vector may contain."""
    numbers = reference.segments(channel)
    return numbers, reference.usable(channel, numbers)


def found_at(
    channel: reference.Channel,
    newest: int,
    delays: list[int],
    segments: tuple[list[int], list[bool]],
) -> list[float] | None:
    """Return the values that a vector needs, the newest first; None where one cannot be had.

    Segments are those of :func:`readable`, made once for all vectors of a channel.
    """
    numbers, known = segments
    values: list[float] = []
    for delay in delays:
        place = newest - delay
        if place < 0 or not (
            channel.healthy[place] and known[place] and numbers[place] == numbers[newest]
        ):
            return None
        value = channel.values[place]
        assert value is not None
        values.append(value)
    return values


def picked_of(pool: reference.Pool) -> list[tuple[int, reference.Channel, int]]:
    """Return the vectors by which a support is probed: block in the pool, channel, newest sample.

    A changed vector is of the program of its newest sample.
    """
    every = [(member, vector[0]) for member in pool.members for vector in member.learnt]
    return [
        (int(pool.blocks[number]), member, newest)
        for number, (member, newest) in enumerate(every)
        if is_picked(number, len(every))
    ]


def probe(pool: reference.Pool) -> list[dict[str, Any]]:
    """Return the 19 changes of a support with their two integers, in order; none without a vector."""
    settings, lo, hi = pool.settings, pool.lo, pool.hi
    picked = picked_of(pool)
    if not picked or lo is None or hi is None:
        return []
    newest_values = [member.values[newest] or 0.0 for _, member, newest in picked]
    q05, q50, q95 = usual(newest_values)
    width = q95 - q05 or hi - lo
    blocks = pool.blocks
    visited: dict[tuple[int | None, ...], set[int]] = {}
    for vector, block, ran in zip(pool.grid.tolist(), blocks.tolist(), pool.ran.tolist(), strict=True):
        visited.setdefault((*vector, ran), set()).add(block)
    tau, m = settings.tau, settings.m
    plain = [k * tau for k in range(m)]
    asked: list[tuple[str, list[int], Any]] = []
    for p in SHIFTS:
        asked.append((f"shift {p:+d} %", plain, lambda x, p=p: shifted(x, p, width)))
    for p in (5, 8, 12):
        asked.append((f"stroke {p / 10:g}", plain, lambda x, p=p: stroked(x, p, q50)))
    asked.append(("frozen", [0] * m, lambda x: x))
    for p, q in SPEEDS:
        asked.append(
            (f"speed {p}/{q}", [(2 * k * p * tau + q) // (2 * q) for k in range(m)], lambda x: x)
        )
    answer = []
    segments = {id(member): readable(member) for member in pool.members}
    for number, (name, delays, change) in enumerate(asked, start=1):
        row: dict[str, Any] = {"change_no": number, "change_name": name, "vectors": None, "novel": None}
        answer.append(row)
        if name.startswith("speed") and len(set(delays)) < m:
            continue
        row |= {"vectors": 0, "novel": 0}
        for block, member, newest in picked:
            values = found_at(member, newest, delays, segments[id(member)])
            if values is None:
                continue
            codes = [reference.code(change(x), lo, hi, settings.bins) - 2 for x in values]
            row["vectors"] += 1
            cell = (*codes, member.numbers[newest])
            row["novel"] += not (visited.get(cell, set()) - {block})
    return answer


def probes(rows: reference.Rows, parameters: Any, calibration: Any) -> list[dict[str, Any]]:
    """Return what is asked of each channel, which is asked of its support."""
    answer = []
    for channel, pool in reference.channels(rows, parameters, calibration):
        for row in probe(pool):
            own = {name: row[name] for name in ("change_name", "vectors", "novel")}
            answer.append({"asset": channel.asset, "channel": channel.name, **own})
    return answer


def sight(pool: reference.Pool, verdict: str, standard: dict[str, Any]) -> dict[str, Any]:
    """Return which changes would be seen (section 3), and the verdict where none of the shifts is.

    The verdict is that of the certificate; the standard is the one whose floors give the limit.
    """
    names = "usual_low usual_middle usual_high sees sees_half_stroke sees_frozen sees_faster sees_slower"
    answer: dict[str, Any] = dict.fromkeys([*names.split(), "would_not_see", "blind_reason"])
    rows = {row["change_name"]: row for row in probe(pool)}
    if not rows or pool.lo is None or pool.hi is None:
        return answer
    low, middle, high = usual([member.values[newest] or 0.0 for _, member, newest in picked_of(pool)])
    answer |= {"usual_low": low, "usual_middle": middle, "usual_high": high}
    limit = max(2 * standard["floor"], standard["floor_max"], pool.settings.target_floor)
    seen = {
        name: int(row["novel"] > limit * row["vectors"]) if row["vectors"] else None
        for name, row in rows.items()
    }
    rungs = [p for p in (1, 2, 5, 10, 20, 50) if seen[f"shift +{p} %"] and seen[f"shift -{p} %"]]
    answer["sees"] = min(rungs, default=None)
    for column, name in (
        ("sees_half_stroke", "stroke 0.5"),
        ("sees_frozen", "frozen"),
        ("sees_faster", "speed 3/2"),
        ("sees_slower", "speed 2/3"),
    ):
        answer[column] = seen[name]
    words = [
        *["a frozen sensor"] * (seen["frozen"] == 0),
        *["half a stroke"] * (seen["stroke 0.5"] == 0),
        *["another speed"] * (0 in (seen["speed 3/2"], seen["speed 2/3"])),
    ]
    answer["would_not_see"] = ", ".join(words) or None
    if verdict == "ready" and not rungs:
        width = high - low or pool.hi - pool.lo
        reason = "blocks" if limit > 0.3 else "cells" if len(pool.keys) < 8 else "delay"
        reason = "range" if pool.hi - pool.lo > 60 * width else reason
        answer |= {"verdict": "blind", "blind_reason": reason}
    return answer
