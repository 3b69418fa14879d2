"""Rows that are later than now: they are left out, counted and named.

A clock that runs ahead must not decide anything: no newest time, no share of calibration. This module
owns the latest instant that counts, and the sentences about rows after it. A counter has no clock.
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, UNITS, TimeKind, length, shown_instant
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.base import Engine
from gam_db.engines.session import Row, Session
from gam_db.errors import printable
from gam_db.method.adding import add
from gam_db.settings.source import AnySource

#: How far a row may be ahead of the database's clock, where the source does not say.
TOLERANCE = "5 min"

#: Channels that a sentence names.
_NAMED = 3

_HALF_HOUR = UNITS["min"] * 30
#: Zones are at most so many half hours ahead of UTC.
_MOST_HALF_HOURS = 28
#: The newest row of a live channel is at most so old.
_DELAY = UNITS["min"] * 10


def tolerance(source: AnySource, kind: TimeKind) -> int | None:
    """Return by how many microseconds a row may be ahead of now; None if it may be by any time.

    Raises:
        ParameterError: it is not a length of time.
    """
    if kind.is_counter or source.clock_tolerance is False:
        return None
    value = TOLERANCE if source.clock_tolerance is None else source.clock_tolerance
    return length(value, kind, "clock_tolerance")


@dataclass(frozen=True)
class Clock:
    """The clock of a database, as it was read once.

    Attributes:
        now: in microseconds since 1970 (UTC); None where rows may be later than that.
        latest: the latest instant of a row that counts, likewise; FAR_AHEAD for no limit.
    """

    now: int | None
    latest: int

    @classmethod
    def read(cls, session: Session, source: AnySource, kind: TimeKind) -> "Clock":
        """Read the clock of a session, for a source that has times of a kind."""
        allowed = tolerance(source, kind)
        if allowed is None:
            return cls(None, FAR_AHEAD)
        now = session.now()
        return cls(now, now + allowed)


def latest_live(source: AnySource, engine: Engine, kind: TimeKind) -> exp.Expr | None:
    """Return the latest instant that counts when a query is run, in microseconds; None for no limit."""
    allowed = tolerance(source, kind)
    return None if allowed is None else engine.clock() + template.node_of(allowed)


def rows_ahead(session: Session, readings: exp.Query | exp.Table, latest: int) -> list[Row]:
    """Return asset, channel, ahead_rows and ahead_to of each channel with rows later than an instant.

    Args:
        session: of the source.
        readings: the step *readings*, at least from that instant on, or the table that keeps it.
        latest: the instant, in microseconds.
    """
    steps, tables = Pipeline(), {}
    if isinstance(readings, exp.Table):
        tables["readings"] = readings
    else:
        steps.add("readings", readings)
    add(steps, "source/ahead", {"latest": latest})
    return session.rows(steps.query("ahead", tables))


def zone_hours(rows: Sequence[Row], channels: int, clock: Clock) -> float | None:
    """Return by how many hours most channels are equally ahead, as local times are; else None.

    Args:
        rows: as :func:`rows_ahead` returns them.
        channels: how many channels the source has.
        clock: as it was read.
    """
    leads = Counter[int]()
    for row in rows if clock.now is not None else ():
        lead = row["ahead_to"] - clock.now
        half_hours = -(-lead // _HALF_HOUR)
        if half_hours <= _MOST_HALF_HOURS and half_hours * _HALF_HOUR - lead <= _DELAY:
            leads[half_hours] += 1
    half_hours, channels_alike = max(leads.items(), key=lambda lead: lead[1], default=(0, 0))
    return half_hours / 2 if 2 * channels_alike > channels else None


def ahead_sentences(rows: Sequence[Row], channels: int, clock: Clock) -> list[str]:
    """Return the sentences for users about rows that are later than now; empty for none.

    Arguments as for :func:`zone_hours`.
    """
    if not rows:
        return []
    furthest = sorted(rows, key=lambda row: -row["ahead_to"])
    each = [
        f"{printable(str(row['asset']))} {printable(str(row['channel']))}: {row['ahead_rows']:,}, "
        f"the latest {shown_instant(row['ahead_to'], TimeKind.TIMESTAMP)} UTC"
        for row in furthest[:_NAMED]
    ]
    more = f"; and {len(rows) - _NAMED:,} more channels" if len(rows) > _NAMED else ""
    total = sum(row["ahead_rows"] for row in rows)
    sentences = [
        f"{total:,} row{'s are' if total > 1 else ' is'} later than now and left out until then "
        f"({'; '.join(each)}{more}). Correct the clock, or delete the row{'s' * (total > 1)}."
    ]
    if (hours := zone_hours(rows, channels, clock)) is not None:
        sentences.append(
            f"Most channels are {hours:g} h ahead of now, so their times look local: "
            "--source-time-zone NAME (such as Europe/Berlin) reads them."
        )
    return sentences
