"""Dirt: missing, repeated and late rows, as they come out of a plant."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

_EVERY = 50_000  # samples from one run of missing ones to the next, on average
_NULLS = (1, 20)  # samples of a run
_REPEATED = (20, 200)  # rows of the block that was sent twice
_LATE = (100, 3000)  # rows of the block that came late


@dataclass(frozen=True)
class Rows:
    """The rows of a joint, in the order in which they arrive.

    Attributes:
        times: microseconds.
        values: readings; NaN where the controller said so.
        null: True where there is no reading.
        late, repeated: how many rows came late, and a second time.
    """

    times: NDArray[np.int64]
    values: NDArray[np.float64]
    null: NDArray[np.bool_]
    late: int = 0
    repeated: int = 0


def dirtied(
    times: NDArray[np.int64],
    values: NDArray[np.float64],
    random: np.random.Generator,
    repeats: bool,
    late: bool,
) -> Rows:
    """Return the rows of a joint with what is wrong in them.

    Every joint has runs of NULL and single NaN; rows that are sent twice, and a block that arrives
    after newer ones, occur where asked for.
    """
    rows = len(times)
    values, null = values.copy(), np.zeros(rows, bool)
    for _ in range(1 + rows // _EVERY):
        start, length = random.integers(rows), random.integers(_NULLS[0], _NULLS[1] + 1)
        null[start : start + length] = True
        values[random.integers(rows)] = np.nan
    values[null] = 0.0
    order = np.arange(rows)
    sent_twice = moved = 0
    if repeats:
        sent_twice = min(int(random.integers(*_REPEATED)), rows // 10)
        begin = int(random.integers(rows - sent_twice))
        block = order[begin : begin + sent_twice]
        order = np.concatenate([order[: begin + sent_twice], block, order[begin + sent_twice :]])
    if late:
        moved = min(int(random.integers(*_LATE)), rows // 10)
        begin = int(random.integers(rows // 2))
        arrival = int(random.integers(begin + 2 * moved, begin + rows // 2))
        block = order[begin : begin + moved]
        after = order[begin + moved : arrival]
        order = np.concatenate([order[:begin], after, block, order[arrival:]])
    return Rows(times[order], values[order], null[order], moved, sent_twice)
