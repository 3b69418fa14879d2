"""Supports as bits: one value for each support, for a cheap test whether it has a cell.

This module owns what an engine must say to have them; :mod:`gam_db.method.scoring` uses it.
"""

from collections.abc import Callable
from dataclasses import dataclass

from sqlglot import exp


@dataclass(frozen=True)
class Bits:
    """How an engine keeps a set of numbers as one value.

    Attributes:
        gathered: an aggregate of a column of integers from 0 on, below a bound.
        held: 1 if such a value holds a number, else 0; NULL where there is no such value.
        most: bits of one value at most.
        room: bytes of all values together at most.
    """

    gathered: Callable[[exp.Expr, int], exp.Expr]
    held: Callable[[exp.Expr, exp.Expr], exp.Expr]
    most: int = 2**25
    room: int = 2**28

    def serve(self, cells: int, supports: int = 1) -> bool:
        """Tell whether grids of so many cells are small enough, for so many supports."""
        return cells <= self.most and cells * supports <= 8 * self.room
