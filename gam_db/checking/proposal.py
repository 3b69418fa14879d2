"""What to set: max_gap, the window and still_after, each with its reason.

Only what follows from the look is proposed. The embedding and the grid do not: the certificate judges
them.
"""

import math
import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gam_db.checking.look import PAUSE, Look, Row, is_irregular
from gam_db.checking.words import number_of, percent, roundest, setting, spoken
from gam_db.clock import TimeKind

CYCLES = 5
"""A window holds at least so many cycles; the paper asks for several complete ones."""
BLOCKS = 8
"""Calibration is at least so many windows long, or the certificate has to take shorter blocks."""
SHORTEST_WINDOW = 10
"""A shorter window is not proposed."""
MOST_STILL = 0.1
"""Share of calibration from which on still samples are not proposed to count as missing."""


@dataclass(frozen=True)
class Proposed:
    """A value as its setting takes it, and why this one, in plain words."""

    value: int | str
    reason: str


@dataclass(frozen=True)
class Proposal:
    """What to set."""

    max_gap: Proposed | None  # None where no channel pauses, or where no one length suits all channels
    gaps: dict[str, Proposed]  # channel -> max_gap, where one length does not suit all
    window: int | None  # W, in vectors; None where calibration is too short for any
    window_reason: str
    windows: dict[str, Proposed]  # channel -> a shorter window, where its calibration is shorter
    still: Proposed | None  # None where none stood still in calibration, or where not all can take it
    stills: dict[str, Proposed]  # channel -> still_after, where not all can


def propose(look: Look) -> Proposal:
    """Return what to set for a source."""
    spaced = [row for row in look.channels if row["typical_step"] is not None]
    gap, gaps = _for_all_or_each(spaced, lambda rows: _gap(rows, look.kind))
    still, stills = _for_all_or_each(look.channels, _still)
    return Proposal(gap, gaps, *_window(look), still, stills)


def _for_all_or_each(
    rows: Sequence[Row], proposed: Callable[[Sequence[Row]], Proposed | None]
) -> tuple[Proposed | None, dict[str, Proposed]]:
    """Return what suits all channels; where there is no such, what suits each name of a channel."""
    if (for_all := proposed(rows)) is not None:
        return for_all, {}
    names = dict.fromkeys(row["channel"] for row in rows)
    by_name = {name: proposed([row for row in rows if row["channel"] == name]) for name in names}
    return None, {name: suggestion for name, suggestion in by_name.items() if suggestion is not None}


def _still(rows: Sequence[Row]) -> Proposed | None:
    """Return from where on these channels stand still, if some did in calibration, and none for long."""
    shares = [row["calibration_still"] / max(row["calibration_samples"], 1) for row in rows]
    if not any(shares) or max(shares) >= MOST_STILL:
        return None
    standing = [row for row in rows if row["calibration_still"]]
    runs = sum(row["still_runs"] for row in standing)
    reason = (
        f"{percent(max(shares))} of calibration at most stood still, in {runs:,} "
        f"run{'s' * (runs != 1)} of at most {max(row['longest_run'] for row in standing):,} samples"
    )
    return Proposed(max(row["still_after"] for row in standing), reason)


def _gap(rows: Sequence[Row], kind: TimeKind) -> Proposed | None:
    """Return a length that separates the pauses of these channels from their steps, if there is one.

    Irregular sampling has no pauses: a length that breaks none of its steps will do.
    """
    pauses = [row["shortest_pause"] for row in rows if row["pauses"] and not is_irregular(row)]
    if not pauses:
        return None
    below = min(pauses)
    least = max(
        (row["longest_pause"] if is_irregular(row) else None) or row["longest_step"] for row in rows
    )
    if least >= below:
        return None
    wanted = PAUSE * max(row["typical_step"] for row in rows)
    length = roundest(least, below, wanted, kind)
    reason = (
        f"between steps of at most {spoken(least, kind)} and pauses of at least {spoken(below, kind)}"
    )
    return Proposed(setting(length, kind), reason)


def room_of(look: Look, row: Row) -> int:
    """Return the longest window of which the calibration of a channel has eight."""
    vectors: int = max(row["calibration_samples"] - look.setting(row).span, 0)
    return vectors // BLOCKS


def _open_window(usual: int, healthy: int, cycle: int, room: int) -> tuple[int, str]:
    """Return the window for no setting: whole cycles if there are any, else the default."""
    if not cycle:
        if usual > room:
            return _eighth(room, healthy)
        return usual, f"a twentieth of the calibration, {healthy:,} samples"
    window = min(max(CYCLES * cycle, healthy // 40), healthy // 16, room)
    whole = math.ceil(window / cycle) * cycle
    window = whole if whole <= room else window
    reason = f"{window / cycle:.1f} cycles of about {cycle:,} samples"
    if healthy < BLOCKS * cycle:
        reason += f"; calibration has {healthy // cycle} of at least {BLOCKS} cycles"
    return window, reason


def _eighth(room: int, healthy: int) -> tuple[int, str]:
    """Return the longest window of which a calibration has eight, in two digits and zeros, and why."""
    unit = 10 ** max(len(str(room)) - 2, 0)
    reason = f"an eighth of the calibration, {healthy:,} samples, so that it has {BLOCKS} blocks"
    return room // unit * unit, reason


def _window(look: Look) -> tuple[int | None, str, dict[str, Proposed]]:
    current = look.method.parameters.window
    is_open = look.method.requested is not None and "window" in look.method.requested.open_settings
    why = "the default" if is_open else "as it is set"
    moving = [row for row in look.channels if row["rises"] or row["falls"]]
    if not moving:
        return current, why, {}
    least = SHORTEST_WINDOW if is_open else min(SHORTEST_WINDOW, current)
    fitting = [row for row in moving if room_of(look, row) >= least]
    if not fitting:
        most = max(row["calibration_samples"] for row in moving)
        needed = BLOCKS * least + max(look.setting(row).span for row in moving)
        reason = f"calibration is too short for any: {BLOCKS} windows of {least} vectors take "
        return None, f"{reason}{needed:,} samples, and it has {most:,}; calibrate longer", {}
    healthy = int(statistics.median_low(row["calibration_samples"] for row in fitting))
    room = statistics.median_low(room_of(look, row) for row in fitting)
    cycles = [row["cycle_length"] for row in fitting if row["cycle_length"] is not None]
    cycle = statistics.median_high(cycles) if cycles else 0
    if is_open:
        window, reason = _open_window(current, healthy, cycle, room)
    else:
        window, reason = _set_window(current, healthy, cycle, room, why)
    return window, *_shorter(look, moving, window, reason)


def _set_window(current: int, healthy: int, cycle: int, room: int, why: str) -> tuple[int, str]:
    """Return the window for a setting: that, unless calibration or cycles need another."""
    window, reason = (current, why) if current <= room else _eighth(room, healthy)
    wanted = 100 * math.ceil(cycle * CYCLES / 100)
    if cycle * CYCLES <= window:
        return window, reason
    if wanted <= room:
        return wanted, f"{CYCLES} cycles of about {cycle:,} samples"
    window, reason = _eighth(room, healthy)
    return window, f"{reason}; {CYCLES} cycles of about {cycle:,} samples take a longer calibration"


def _shorter(
    look: Look, moving: Sequence[Row], window: int, reason: str
) -> tuple[str, dict[str, Proposed]]:
    """Return why this window, and shorter ones for names of channels with a shorter calibration."""
    by_name: dict[str, Proposed] = {}
    if look.method.calibration.pools:  # what a channel lacks its pool may have
        return reason, by_name
    short = [row for row in moving if room_of(look, row) < window]
    none = [row for row in short if room_of(look, row) < SHORTEST_WINDOW]
    if none:
        reason += f"; calibration of {number_of(len(none), 'channel')} is too short for any window"
    for name in dict.fromkeys(row["channel"] for row in short if row not in none):
        briefest = min(
            (row for row in short if row["channel"] == name and row not in none),
            key=lambda row: room_of(look, row),
        )
        by_name[name] = Proposed(*_eighth(room_of(look, briefest), briefest["calibration_samples"]))
    return reason, by_name
