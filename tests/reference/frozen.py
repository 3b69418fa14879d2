"""The reference for the stored form: calibrated on the first rows, scored over the last.

Built on :mod:`reference`: what the first rows taught of each channel (its intervals, and its pool's
range and cells) is kept, and the vectors of the final rows are judged by it.
"""

from collections.abc import Iterator
from typing import Any

import reference
from reference import Channel, Pool, ProgramRow, Row


def channels(
    first: list[Row] | list[ProgramRow],
    final: list[Row] | list[ProgramRow],
    parameters: Any,
    calibration: Any,
) -> Iterator[tuple[Channel, Pool]]:
    """Give every channel of the first rows, holding the final ones, with its frozen pool."""
    rows: dict[tuple[str, str], list[Any]] = {}
    for row in final:
        rows.setdefault(row[:2], []).append(row[2:])
    for learnt, pool in reference.channels(first, parameters, calibration):
        own_rows = rows.get((learnt.asset, learnt.name), [])
        times, values, conflicts = reference.collapse(row[:2] for row in own_rows)
        own = resolved(calibration, learnt)
        healthy = [any(a <= t <= b for a, b in own) for t in times]
        channel = Channel(
            learnt.asset,
            learnt.name,
            learnt.settings,
            times,
            values,
            conflicts,
            healthy,
            learnt.end,
            learnt.score_from,
        )
        reference.embed(channel)
        if learnt.programs is not None:
            channel.programs, channel.conflicts = reference.collapse_programs(own_rows)
        reference.judge_programs(channel, pool)
        if pool.lo is not None and pool.hi is not None:
            channel.codes = [reference.code(x, pool.lo, pool.hi, pool.settings.bins) for x in values]
        yield channel, pool


def resolved(calibration: Any, channel: Channel) -> list[tuple[float, float]]:
    """Return the closed intervals of time that calibration means for a channel, once and for all."""
    own = reference.rule_of(calibration, channel.asset)
    if own is None or channel.end is None:
        return []
    declared = [(channel.times[0], channel.end)] if own.intervals is None else own.intervals
    pieces: list[tuple[float, float]] = [(a, b) for a, b in declared]
    for cut_from, cut_to in own.exclude:
        pieces = [
            part
            for a, b in pieces
            for part in ((a, min(b, cut_from - 1)), (max(a, cut_to + 1), b))
            if part[0] <= part[1]
        ]
    return pieces


def buckets(
    first: list[Row] | list[ProgramRow],
    final: list[Row] | list[ProgramRow],
    parameters: Any,
    calibration: Any,
) -> list[dict[str, Any]]:
    """Return what ``gam_state_bucket`` must show, in order, names in the place of numbers."""
    answer = []
    for channel, pool in channels(first, final, parameters, calibration):
        stride, window = pool.settings.stride, pool.settings.window
        span, after = (pool.settings.m - 1) * pool.settings.tau, pool.settings.still_after
        reach = span - 1 if after is None else span + after - 2
        scored = list(reference.health(channel, pool))
        ends = [scored_from(channel) - 1]
        for bucket in range(len(scored) // stride):
            inside = scored[bucket * stride : (bucket + 1) * stride]
            newest = channel.times.index(inside[-1]["time"])
            recent = [row["novel"] for row in scored[: (bucket + 1) * stride]][-window:]
            row = {
                "asset": channel.asset,
                "channel": channel.name,
                "bucket": bucket,
                "first_time": inside[0]["time"],
                "last_time": inside[-1]["time"],
                "context_time": -(2**62) if reach > newest else channel.times[newest - max(reach, 0)],
                "samples": sum(ends[-1] < t <= inside[-1]["time"] for t in channel.times),
                "novel": sum(row["novel"] for row in inside),
                "out_of_range": sum(row["out_of_range"] for row in inside),
                "novel_in_window": sum(recent) if len(recent) == window else None,
            }
            ends.append(inside[-1]["time"])
            answer.append(row)
    return answer


def scored_from(channel: Channel) -> int:
    """Return the instant from which on a channel is scored."""
    if channel.score_from is not None:
        return channel.score_from
    return -(2**62) if channel.end is None else channel.end + 1


def stands_still(channel: Channel) -> list[bool]:
    """Tell of each sample whether it stands still: it is there, and no vector may contain it."""
    usable = reference.usable(channel, reference.segments(channel))
    return [value is not None and not used for value, used in zip(channel.values, usable, strict=True)]


def still_counts(
    first: list[Row] | list[ProgramRow],
    final: list[Row] | list[ProgramRow],
    parameters: Any,
    calibration: Any,
) -> list[dict[str, Any]]:
    """Return the column ``still`` of ``gam_state_bucket``, in order."""
    stands: dict[tuple[str, str], tuple[int, list[int] | None]] = {
        (channel.asset, channel.name): (
            scored_from(channel) - 1,
            [t for t, still in zip(channel.times, stands_still(channel), strict=True) if still],
        )
        for channel, pool in channels(first, final, parameters, calibration)
        if pool.settings.still_after is not None
    }
    answer: list[dict[str, Any]] = []
    for row in buckets(first, final, parameters, calibration):
        name = {key: row[key] for key in ("asset", "channel", "bucket")}
        end, still = stands.get((row["asset"], row["channel"]), (0, None))
        count = None if still is None else sum(end < t <= row["last_time"] for t in still)
        stands[row["asset"], row["channel"]] = (row["last_time"], still)
        answer.append({**name, "still": count})
    return answer


def still_since(
    first: list[Row] | list[ProgramRow],
    final: list[Row] | list[ProgramRow],
    parameters: Any,
    calibration: Any,
) -> dict[tuple[str, str], int | None]:
    """Return since when each channel stands still, of what is scored; None where it moves."""
    found = {}
    for channel, _ in channels(first, final, parameters, calibration):
        stands = stands_still(channel)
        moved = max((i for i, still in enumerate(stands) if not still), default=-1)
        since = (t for t in channel.times[moved + 1 :] if t >= scored_from(channel))
        found[channel.asset, channel.name] = next(since, None)
    return found


def novel_cells(
    first: list[Row] | list[ProgramRow],
    final: list[Row] | list[ProgramRow],
    parameters: Any,
    calibration: Any,
) -> list[dict[str, Any]]:
    """Return what ``gam_state_novel`` must show, in order, names in the place of numbers."""
    answer = []
    for channel, pool in channels(first, final, parameters, calibration):
        stride = pool.settings.stride
        scored = list(reference.health(channel, pool))
        for bucket in range(len(scored) // stride):
            cells: dict[int, list[int]] = {}
            for row in scored[bucket * stride : (bucket + 1) * stride]:
                if row["novel"]:
                    cells.setdefault(row["cell_key"], []).append(row["time"])
            for key in sorted(cells):
                times = cells[key]
                answer.append(
                    {
                        "asset": channel.asset,
                        "channel": channel.name,
                        "bucket": bucket,
                        "cell_key": key,
                        "visits": len(times),
                        "first_time": min(times),
                        "last_time": max(times),
                    }
                )
    return answer
