"""Planning a run: which channels are read, from where on, and which of them together.

This module owns what is read at all. Channels that have to be read from about the same instant on form
a cohort, whose lower bound stands as a literal in its query; so one silent channel does not make every
run a scan of everything. A channel that would have to be read from further back than ``park_after`` is
parked: a run asks only for values later than those that it has read, and reads the channel if there are
any, on request, or once a day.
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
        """The assets to be asked for by name; None where they are too many, or all are wanted."""
        return None if self.everyone else assets_of(self.channels)


@dataclass(frozen=True)
class Plan:
    """What is to be read now, and what only if values of it are found.

    Attributes:
        cohorts: to be read; the first holds the channels of today.
        parked: rows of the plan that are not read now.
        since: a channel with a value from this instant on is not silent.
    """

    cohorts: tuple[Cohort, ...]
    parked: tuple[Row, ...]
    since: int


def assets_of(channels: Iterable[Row]) -> list[str] | None:
    """Return the assets of some channels, in order; None where they are too many for a query."""
    names = sorted({row["asset"] for row in channels})
    return None if len(names) > _FEW else names


def planned(
    rows: Sequence[Row],
    lookback: int,
    park_after: int | None,
    started: int,
    latest: int,
    everything: bool,
) -> Plan:
    """Return the plan of a run, of the rows of ``sql/stored/scoring/plan.sql``.

    Args:
        rows: of that file.
        lookback: how late a row may come, in the unit of time.
        park_after: how far back a channel is read without a special reason, likewise; None parks none.
        started: when the run began, in microseconds.
        latest: the latest instant that counts; the newest data of a fleet is never later.
        everything: no channel is parked.
    """
    fresh = [row for row in rows if row["looked_at"] == LONG_AGO]
    known = [row for row in rows if row["looked_at"] != LONG_AGO]
    newest = min(max((row["read_until"] for row in known), default=LONG_AGO), latest)
    since = LONG_AGO if park_after is None else newest - lookback - park_after
    active, due, parked = [], [], []
    for row in known:
        if row["read_from"] >= since:
            active.append(row)
        elif everything or is_due(row["looked_at"], started):
            due.append(row)
        else:
            parked.append(row)
    groups = [*alike(active, newest, lookback), *alike(due, newest, lookback)]
    if fresh:
        groups.append(fresh)
    if not groups and parked:
        return Plan((Cohort((), newest - lookback, True),), tuple(parked), since)
    cohorts = tuple(_cohort(group, number == 0) for number, group in enumerate(groups))
    return Plan(cohorts, tuple(parked), since)


def is_due(last: int, now: int) -> bool:
    """Tell whether what is done once a day is due; a time after now is of a clock that stood ahead."""
    return not 0 <= now - last < DAY


def unread(plan: Plan, lookback: int) -> list[Cohort]:
    """Return cohorts of parked channels, each with where to look for values that were not read.

    That is what came after all that was read; of a channel that still sends rows, whatever is new enough
    not to be parked: if there is a value, it is only slow.
    """
    looks = (min(row["read_until"] + 1, plan.since) for row in plan.parked)
    looked = zip(plan.parked, looks, strict=True)
    return others([{**row, "read_from": max(look, row["read_from"])} for row, look in looked], lookback)


def resumed(cohorts: Iterable[Cohort], names: Iterable[Row], plan: Plan, lookback: int) -> list[Cohort]:
    """Return the cohorts of parked channels that have values in the range where they were looked for.

    Args:
        cohorts: of :func:`unread`.
        names: what the look at them found.
        plan: of the run.
        lookback: in the unit of time.
    """
    latest = {name_of(row): row["latest"] for row in names if row["readings"] > row["missing_readings"]}
    looks = {name_of(row): row["read_from"] for cohort in cohorts for row in cohort.channels}
    back = [row for row in plan.parked if latest.get(name := name_of(row), LONG_AGO) >= looks[name]]
    return others(back, lookback)


def others(rows: Sequence[Row], lookback: int) -> list[Cohort]:
    """Return the cohorts of channels that come in besides those of the plan."""
    newest = max((row["read_from"] for row in rows), default=LONG_AGO)
    return [_cohort(group, False) for group in alike(rows, newest, lookback)]


def alike(rows: Sequence[Row], newest: int, lookback: int) -> list[list[Row]]:
    """Cut channels into cohorts, the most recent first, none of which doubles the time to be read."""
    groups: list[list[Row]] = []
    first_age = 0
    for row in sorted(rows, key=lambda row: -row["read_from"]):
        age = newest - row["read_from"]
        if not groups or age > 2 * first_age + lookback:
            groups.append([])
            first_age = age
        groups[-1].append(row)
    return groups


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
    """Return how many readings of some channels were found."""
    return sum(readings.get(name_of(row), 0) for row in channels)


def by(column: str, rows: Iterable[Row]) -> dict[Any, list[Row]]:
    """Return rows by the value of a column, in the order of the first of each."""
    found: dict[Any, list[Row]] = {}
    for row in rows:
        found.setdefault(row[column], []).append(row)
    return found


def _below(
    limit: int, units: Iterable[Sequence[Row]], readings: Mapping[tuple[str, str], int]
) -> Iterator[list[Row]]:
    """Put units together, none of which is cut, as long as their readings stay below the limit."""
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


def _cohort(rows: Sequence[Row], everyone: bool) -> Cohort:
    return Cohort(tuple(rows), min(row["read_from"] for row in rows), everyone)
