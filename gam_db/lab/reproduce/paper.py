"""What the paper prints: its three tables, kept in ``paper.csv``, each with the best method first.

Source: *Geometric Attractor Monitoring: A Robust and Frugal Framework for Multi-modal Industrial Robotic
Cycles* (Bonsergent-Brachet, Read, Abboud).
"""

import csv
import functools
from collections.abc import Mapping
from typing import NamedTuple

from gam_db import data


class Printed(NamedTuple):
    """A row of one of the paper's tables; None for what that table does not have."""

    mon: float
    corr: float
    rob: float
    global_score: float
    prog: float | None = None
    disc: float | None = None
    seconds: float | None = None
    mon_sd: float | None = None
    corr_sd: float | None = None
    rob_sd: float | None = None
    seconds_sd: float | None = None


@functools.cache
def printed(table: int) -> Mapping[str, Printed]:
    """Return the rows of a table of the paper (1, 2 or 3), by the name of the method."""
    rows = csv.DictReader(data.text("gam_db.lab.reproduce", "paper.csv").splitlines())
    return {
        row["method"]: Printed(**{name: float(row[name]) for name in Printed._fields if row[name]})
        for row in rows
        if row["table"] == str(table)
    }


TABLE2: Mapping[str, Printed] = printed(2)
"""The Langevin system."""
