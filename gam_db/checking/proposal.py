"""What to set: max_gap, the window and still_after, each with its reason.

Only what follows from the look is proposed. The embedding and the grid do not: the certificate judges
them.
"""

import math
import statistics
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gam_db.checking.look import PAUSE, Look, Row, is_irregular
from gam_db.checking.words import percent, roundest, setting, spoken
from gam_db.clock import TimeKind

CYCLES = 5
"""A window holds at least so many cycles; the paper asks for several complete ones."""
BLOCKS = 8
"""Calibration is at least so many windows long, or the certificate has to take shorter blocks."""
_SHORTEST_WINDOW = 10
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
    window: int  # W, in vectors
    window_reason: str
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
    if (one := proposed(rows)) is not None:
        return one, {}
    names = dict.fromkeys(row["channel"] for row in rows)
    own = {name: proposed([row for row in rows if row["channel"] == name]) for name in names}
    return None, {name: one for name, one in own.items() if one is not None}


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
    """Return a length that tells the pauses of these channels from their steps, if there is one.

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


def _open_window(usual: int, healthy: int, cycle: int) -> tuple[int, str]:
    """Return the window where none was given: whole cycles if there are any, else the usual one."""
    if not cycle:
        return usual, f"a twentieth of the calibration, {healthy:,} samples"
    window = min(max(CYCLES * cycle, healthy // 40), healthy // 16)
    whole = math.ceil(window / cycle) * cycle
    window = whole if whole <= healthy // BLOCKS else max(window, 1)
    reason = f"{window / cycle:.1f} cycles of about {cycle:,} samples"
    if healthy < BLOCKS * cycle:
        reason += f"; calibration has {healthy // cycle} of at least {BLOCKS} cycles"
    return window, reason


def _window(look: Look) -> tuple[int, str]:
    said = look.method.parameters.window
    is_open = look.method.asked is not None and "window" in look.method.asked.open_settings
    as_said = "the default" if is_open else "as it is set"
    moving = [row for row in look.channels if row["rises"] or row["falls"]]
    if not moving:
        return said, as_said
    healthy = int(statistics.median_low(row["calibration_samples"] for row in moving))
    cycles = [row["cycle_length"] for row in moving if row["cycle_length"] is not None]
    cycle = statistics.median_high(cycles) if cycles else 0
    if is_open:
        return _open_window(said, healthy, cycle)
    room = healthy // BLOCKS
    window, reason = said, as_said
    if _SHORTEST_WINDOW <= room < said:
        unit = 10 ** max(len(str(room)) - 2, 1)
        window = room // unit * unit  # two digits and zeros
        reason = f"an eighth of the calibration, {healthy:,} samples, so that it has {BLOCKS} blocks"
    if cycle * CYCLES > window:
        window = 100 * math.ceil(cycle * CYCLES / 100)
        reason = f"{CYCLES} cycles of about {cycle:,} samples"
        if window > room:
            reason += f"; calibrate on {BLOCKS * window:,} samples or more, for {BLOCKS} blocks"
    return window, reason
