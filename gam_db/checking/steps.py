"""The steps of the look: in which order they come, and how far the dear ones go.

This module owns the bounds of the work. The formulas are in ``sql/check``.
"""

from collections.abc import Sequence

from sqlglot import exp

from gam_db import template
from gam_db.method import Method
from gam_db.method.adding import add, add_stacked
from gam_db.pipeline import Pipeline, filled
from gam_db.source import TimeNode

SUMMARY = "check_summary"

PAUSE = 5
"""A step in time longer than this many typical ones is a pause."""

SCALES = (1, 4, 16, 64, 256)
"""Samples of a block, on each scale on which a cycle is looked for."""
LONGEST_LAG = 80
"""Blocks; a cycle of up to ``LONGEST_LAG * SCALES[-1]`` samples is seen."""
_SHORTEST_LAG = 4
_SHORTEST_LAG_OF_BLOCKS = 20
"""Below it the scale before is finer."""
_BLOCKS = 2 * LONGEST_LAG
LONGEST_SAMPLE = 4 * _BLOCKS * SCALES[-1]
"""Samples of a channel in which a cycle is looked for, from its first on."""
VALUES_LOOKED_AT = LONGEST_SAMPLE // 8
"""Samples of a channel in which distinct values are counted."""

LEAST_STILL = 25
"""Equal samples in a row at least from which on a signal is proposed to count as still."""
STILL_LASTING = 5_000_000
"""Microseconds that these last at least."""

_SMALL = frozenset(
    (
        *("step_counts", "pauses", "movements", "longest_stills"),
        *("quanta", "block_sums", "correlations", "cycles", "stood"),
    )
)


def add_look(steps: Pipeline, method: Method, instant_of: TimeNode) -> None:
    """Add the steps of the look to those of a method, over the same samples.

    Args:
        steps: of the method; *check_summary* is the last step that is added.
        method: what the user asks for.
        instant_of: turns integer time into what the source has.
    """
    add(steps, "check/ordered_samples")
    add(steps, "check/step_counts", {"longest_sample": LONGEST_SAMPLE})
    add(steps, "check/step_ranks")
    add(steps, "check/typical_steps")
    add(steps, "check/pauses", {"pause": PAUSE})
    add(steps, "check/movements")
    add(steps, "check/longest_stills")
    stands: dict[str, template.Slot] = {
        "still_after": _by_setting([setting.still_after for setting in method.settings]),
        "max_gap": _by_setting(method.gaps),
        "least": LEAST_STILL,
        "lasting": 0 if method.kind.is_counter else STILL_LASTING,
    }
    add(steps, "check/stood", stands)
    add(steps, "check/head_samples", {"longest_sample": LONGEST_SAMPLE})
    add(steps, "check/distinct_values", {"looked_at": VALUES_LOOKED_AT // 4})
    add(steps, "check/quanta")
    rungs = [
        filled(
            "check/scales",
            {"scale": scale, "shortest": _SHORTEST_LAG if scale == 1 else _SHORTEST_LAG_OF_BLOCKS},
        )
        for scale in SCALES
    ]
    add_stacked(steps, "scales", "check/scales", rungs)
    add(steps, "check/block_sums", {"blocks": _BLOCKS})
    add(steps, "check/lag_sums", {"longest_lag": LONGEST_LAG})
    add(steps, "check/correlations")
    add(steps, "check/peaks")
    add(steps, "check/cycles")
    edges = {name: instant_of(exp.column(name, table="known")) for name in ("first_time", "last_time")}
    add(steps, "check/check_summary", edges)
    steps.small |= _SMALL


def _by_setting(figures: Sequence[int | None]) -> exp.Expr:
    """Return the figure of a channel by the number of its settings."""
    number = exp.column("settings_no", table="known")
    others = enumerate(figures[1:], start=1)
    return template.case(((number.eq(place), figure) for place, figure in others), figures[0])
