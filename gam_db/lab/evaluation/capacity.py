"""Capacity: how fine a series of K values can be counted, so that no integer sum leaves 64 bits.

This module owns the bounds of the sums in ``sql/evaluation``. With levels about their mean, at most R
from it, and places about the middle, at most K / 2 + 1 from it:

* the running sums of level * place^2 and the moments of a window stay below K^3 R / 4,
* the sums of squared levels stay below K (R + 1)^2 / 4; of the 101 points of a life, below 101 R^2,
* the sums of rank deviations stay below K^3 / 3, and K below 2^22, from which keys of values are made.
"""

from gam_db.errors import SourceError

POINTS = 101
"""Points at which failed lives are compared."""

FINEST = 2**28
"""Steps of an indicator that is no count; 101 times its square is within 63 bits."""

_COARSEST = 2**10
_MOST_VALUES = 3_000_000


def largest_range(k: int) -> int:
    """Return the largest difference of two levels that a series of so many values may have."""
    return min(FINEST, 2**65 // (k + 1) ** 3, _root(2**64 // (k + 1)))


def steps(k: int) -> int:
    """Return in how many steps, a power of two, an indicator that is no count is counted.

    Raises:
        SourceError: there are too many values.
    """
    count = 1 << (largest_range(k).bit_length() - 1) if k <= _MOST_VALUES else 0
    if count < _COARSEST:
        raise SourceError(_too_long(k))
    return count


def check_counts(k: int, spread: int) -> None:
    """Refuse counts whose sums would not fit.

    Args:
        k: values of the series.
        spread: highest less lowest count.

    Raises:
        SourceError: they would not.
    """
    if k > _MOST_VALUES or spread > largest_range(k):
        raise SourceError(_too_long(k))


def _too_long(k: int) -> str:
    return (
        f"A channel has {k:,} values, too many for exact sums in 64 bits; evaluate the indicator at "
        "bucket ends (gam run --every stride, gam_db.health_at_buckets), or at every tenth value."
    )


def _root(number: int) -> int:
    return int(number**0.5)
