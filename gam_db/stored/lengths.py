"""Lengths of time that scoring, status and pruning share, and their defaults.

This module owns the defaults. A counter has no hours, so it has no defaults.
"""

from typing import Literal

from gam_db.clock import Length, TimeKind, length
from gam_db.errors import ParameterError

LOOKBACK = "1 h"
PARK_AFTER = "1 d"


def lookback(setting: Length | None, kind: TimeKind, repeat: int = 0) -> int:
    """Return how far back a run looks, in microseconds or steps.

    Args:
        setting: how late a row may come; by default an hour, or no step.
        kind: how time is told.
        repeat: how far apart the instants of one local time may be: which of two readings is the first
            is known when the second is there.

    Raises:
        ParameterError: it is no length of time of that kind.
    """
    if setting is None:
        return 0 if kind.is_counter else length(LOOKBACK, kind, "lookback") + repeat
    return length(setting, kind, "lookback") + repeat


def park_after(setting: Length | Literal[False] | None, kind: TimeKind) -> int | None:
    """Return after how long a channel is silent; by default a day, or never. None is never.

    Raises:
        ParameterError: it is no length of time of that kind.
    """
    if setting is None:
        return None if kind.is_counter else length(PARK_AFTER, kind, "park_after")
    if setting is False:
        return None
    if setting is True:
        raise ParameterError("park_after is True; give a length of time, or False for never.")
    return length(setting, kind, "park_after")
