"""The course of an indicator as a line of blocks, one per stretch of it."""

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from rich.console import Console, ConsoleOptions, RenderResult
from rich.text import Text

BLOCKS = "▁▂▃▄▅▆▇█"
PLAIN_BLOCKS = "_.,-=+*#"
"""The same scale, for a terminal that has no block characters."""
_POINTS = 64
"""Points of a course at most, as the state keeps them."""


class Course:
    """The indicator so far, oldest first, as a cell of a table; see :func:`sparkline`."""

    least, most = 12, 48

    def __init__(self, points: Sequence[float | None] | NDArray[np.float64]) -> None:
        self.points = np.array(points, np.float64)

    def __rich_console__(self, _: Console, options: ConsoleOptions) -> RenderResult:
        blocks = PLAIN_BLOCKS if options.ascii_only else BLOCKS
        yield Text(sparkline(self.points, min(options.max_width, self.most), blocks))


def sparkline(course: NDArray[np.float64], width: int, blocks: str = BLOCKS) -> str:
    """Return a course as one character per stretch of it, on the fixed scale 0 to 1; NaN is a gap."""
    return "".join(
        " " if math.isnan(point) else blocks[min(int(point * len(blocks)), len(blocks) - 1)]
        for point in thinned(course, width)
    )


def thinned(course: NDArray[np.float64], points: int = _POINTS) -> list[float]:
    """Return a course in at most so many points, the highest of each stretch: no peak is lost."""
    if not len(course):
        return []
    stretches = np.array_split(course, min(points, len(course)))
    return [float(np.fmax.reduce(stretch)) for stretch in stretches]
