"""How a channel is sampled: regularly, in bursts, or whenever something happens."""

from gam_db.checking.look import Row

IRREGULAR = 3
"""The step that 95 % are no longer than, in steps that 5 % are no longer than, above which sampling is
irregular."""
REGULAR_WITHIN = 1.5
"""Steps that differ by no more than this factor are about the same."""
_STILL_ON_CHANGE = 0.01


def is_irregular(row: Row) -> bool:
    """Tell whether a channel is not sampled regularly, bursts with pauses between them left aside."""
    if row["typical_step"] is None or row["long_step"] <= IRREGULAR * row["short_step"]:
        return False
    in_bursts = row["long_step"] > row["longest_step"]
    return not (in_bursts and row["longest_step"] <= REGULAR_WITHIN * row["short_step"])


def is_on_change(row: Row) -> bool:
    """Tell whether a channel seems to be written only when its value changes (a deadband)."""
    compared = row["rises"] + row["falls"] + row["stills"]
    return is_irregular(row) and compared > 0 and row["stills"] <= _STILL_ON_CHANGE * compared
