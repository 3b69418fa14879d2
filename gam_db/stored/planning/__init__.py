"""Planning a run: which channels it reads, from which instant on, and which of them together.

This module owns the range of rows to read. Channels are read in three cohorts at most
(``sql/stored/scoring/cohorts.sql``), each with its lower bound as a literal in its query; so one silent
channel does not make every run a scan of everything. A channel that would have to be read from further
back than ``park_after`` is parked: a run asks only for values later than those that it has read, and
reads the channel if there are any, on request, or once a day.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from gam_db.clock import LONG_AGO
from gam_db.columns import name_of
from gam_db.stored.planning.setting import Setting, shape_of
from gam_db.stored.planning.steps import DAY

Row = dict[str, Any]

#: With at most so many assets, a cohort's query names them.
_FEW = 64

#: Numbers of cohorts: what is read from far back, and what is not read now.
FAR_BACK, PARKED = 2, 3


@dataclass(frozen=True)
class Cohort:
    """Channels that are read together.

    Attributes:
        channels: rows of the plan.
        earliest: nothing older is read; LONG_AGO where all is.
        everyone: whether it holds the channels of today, and so shows which rows belong to none.
    """

    channels: tuple[Row, ...]
    earliest: int
    everyone: bool

    @property
    def assets(self) -> list[str] | None:
        """The assets to select by name; None if they are too many, or all are wanted."""
        return None if self.everyone else assets_of(self.channels)


def assets_of(channels: Iterable[Row]) -> list[str] | None:
    """Return the assets of some channels, in order; None where they are too many for a query."""
    names = sorted({row["asset"] for row in channels})
    return None if len(names) > _FEW else names


def cohorts(rows: Sequence[Row]) -> list[Cohort]:
    """Return what a run reads, of the rows of its plan with the columns of ``cohorts.sql``.

    The first cohort holds the channels of today; it has none where all are parked.
    """
    groups = by("cohort", sorted(rows, key=lambda row: row["cohort"]))
    if len(groups) == 1 and PARKED in groups:
        return [Cohort((), rows[0]["today_from"], True)]
    return [
        Cohort(tuple(group), min(row["read_from"] for row in group), place == 0)
        for place, group in enumerate(group for number, group in groups.items() if number != PARKED)
    ]


def is_due(last: int, now: int) -> bool:
    """Tell whether a daily task is due; a time after now comes from a clock that was ahead."""
    return not 0 <= now - last < DAY


def unread(rows: Iterable[Row]) -> Cohort | None:
    """Return the parked channels, where to look for values that were not read; None without any.

    That is what came after all that was read; of a channel that still sends rows, whatever is new enough
    not to be parked: if there is a value, it is only slow.
    """
    parked = tuple(row for row in rows if row["cohort"] == PARKED)
    return Cohort(parked, min(row["look_from"] for row in parked), False) if parked else None


def resumed(rows: Iterable[Row], names: Iterable[Row]) -> list[Row]:
    """Return the rows of a plan, where parked channels with values that were not read are read.

    Names are what the look at the parked ones has shown.
    """
    latest = {name_of(row): row["latest"] for row in names if row["readings"] > row["missing_readings"]}
    return [
        {**row, "cohort": FAR_BACK}
        if row["cohort"] == PARKED and latest.get(name_of(row), LONG_AGO) >= row["look_from"]
        else row
        for row in rows
    ]


def portions(
    channels: Sequence[Row],
    readings: Mapping[tuple[str, str], int],
    limit: int,
    alike: Callable[[Row], Setting] = shape_of,
) -> Iterator[list[Row]]:
    """Cut a cohort into groups of channels that one query serves, whose readings stay below the limit.

    Channels of one query are ``alike``. A channel with more readings is a group of its own.
    """
    ordered = sorted(channels, key=lambda row: (repr(alike(row)), row["channel_id"]))
    for _, group in groupby(ordered, key=alike):
        yield from _below(limit, ([row] for row in group), readings)


def whole_pools(
    channels: Iterable[Row], readings: Mapping[tuple[str, str], int], limit: int
) -> Iterator[list[Row]]:
    """Put whole pools (a channel alone is one) together as long as their readings stay below the limit.

    The members of a pool share a support_id; a pool with more readings is a group of its own.
    """
    return _below(limit, by("support_id", channels).values(), readings)


def rows_of(channels: Iterable[Row], readings: Mapping[tuple[str, str], int]) -> int:
    """Return the number of readings of some channels."""
    return sum(readings.get(name_of(row), 0) for row in channels)


def by(column: str, rows: Iterable[Row]) -> dict[Any, list[Row]]:
    """Return rows by the value of a column, in the order of the first of each."""
    groups: dict[Any, list[Row]] = {}
    for row in rows:
        groups.setdefault(row[column], []).append(row)
    return groups


def _below(
    limit: int, units: Iterable[Sequence[Row]], readings: Mapping[tuple[str, str], int]
) -> Iterator[list[Row]]:
    """Group whole units as long as their readings stay below the limit."""
    group: list[Row] = []
    total = 0
    for unit in units:
        count = rows_of(unit, readings)
        if group and total + count > limit:
            yield group
            group, total = [], 0
        group += unit
        total += count
    if group:
        yield group
