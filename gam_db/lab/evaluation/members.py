"""Members: the series that are evaluated, and what became of their assets.

This module owns how outcomes and channels are matched. Both are small, a row per channel.
"""

from collections import Counter
from dataclasses import dataclass
from typing import Any

import pyarrow as pa

from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.composing import template
from gam_db.composing.pipeline import filled
from gam_db.engines.session import Session
from gam_db.errors import SourceError, nearest
from gam_db.lab.evaluation.capacity import check_counts, steps
from gam_db.lab.evaluation.table import HealthTable, read_from
from gam_db.reading.preparing import with_times_read
from gam_db.settings.source import Source

FAILED, HEALTHY = "failed", "healthy"

#: Series that should show a trend, series of healthy assets, and all others.
TRENDING, CALM, ASIDE = 0, 1, -1


@dataclass(frozen=True)
class Outcome:
    """What became of an asset: a row of the table of outcomes.

    Attributes:
        asset: its name.
        channel: the channel that failed, or the only one that counts; None for all.
        healthy: whether it was healthy to the end.
        failed_at: when it failed, as an integer; None if that is not known or it did not.
    """

    asset: str
    channel: str | None
    healthy: bool
    failed_at: int | None


@dataclass(frozen=True)
class Member:
    """One series: a channel with its outcome.

    Attributes:
        series_id: number, from 1, in the order of the names.
        asset, channel: names.
        asset_no: number of the asset.
        outcome: "failed", "healthy" or None.
        stratum: among which series of the fleet it counts.
        has_outcome: 1 if an outcome is known.
        ends_at: values later than this are left out.
        steps: in how many steps an indicator that is no count is counted.
        values_per_window: consecutive values that one window spans; 0 if it is not known.
        window: vectors in a window; 0 if the indicator is no count or was always 0.
    """

    series_id: int
    asset: str
    channel: str
    asset_no: int
    outcome: str | None
    stratum: int
    has_outcome: int
    ends_at: int
    steps: int
    values_per_window: int
    window: int


def outcomes_of(session: Session, relation: Any, kind: TimeKind | None) -> list[Outcome]:
    """Read a table of outcomes.

    Args:
        session: an open session.
        relation: a table, a file or an Arrow table with the columns ``asset``, optionally ``channel``
            (NULL: all channels), and at least one of ``failed_at`` (a time like that of the health
            indicators, NULL if it did not fail) and ``healthy`` (true or false; where it is not given,
            what has not failed is healthy).
        kind: how the health indicators tell time; None if they do not.

    Raises:
        SourceError: a column is missing or of the wrong type, or a row contradicts itself or another.
    """
    node = session.relation(relation)
    columns = session.describe(node)
    if "asset" not in columns:
        raise SourceError(f"The outcomes have no column 'asset'{nearest('asset', columns)}")
    if "failed_at" not in columns and "healthy" not in columns:
        raise SourceError("The outcomes need a column 'failed_at', a column 'healthy', or both.")
    if "failed_at" in columns:
        source = Source(relation, None, None, "failed_at", "failed_at")
        node = with_times_read(session, source, columns, node)
    failed = columns.get("failed_at")
    types = session.engine.types
    failed_kind = None if failed is None else types.time_kind(failed)
    healthy = columns.get("healthy", "BOOLEAN")
    if healthy != "BOOLEAN" and not (types.is_numeric(healthy) and types.time_kind(healthy)):
        raise SourceError(f"The column 'healthy' is of type {healthy}; it must be true or false.")
    query = filled(
        "lab/evaluation/outcomes",
        {
            "asset": template.column("asset"),
            "channel": template.column("channel") if "channel" in columns else None,
            "failed_at": (
                None
                if failed_kind is None
                else session.engine.micros_of(failed_kind, template.column("failed_at"))
            ),
            "dated": None if failed is None else template.column("failed_at"),
            "healthy": template.column("healthy") if "healthy" in columns else None,
        },
    )
    read_from(query, "outcomes", node)
    rows: list[dict[str, Any]] = session.fetch(query).to_pylist()
    if any(row["is_dated"] for row in rows):
        _check_times(failed, failed_kind, kind)
    outcomes = [_outcome(row) for row in rows]
    twice = [
        name
        for name, count in Counter((outcome.asset, outcome.channel) for outcome in outcomes).items()
        if count > 1
    ]
    if twice:
        raise SourceError(f"The outcomes name {len(twice)} assets or channels more than once.")
    return outcomes


def members(
    rows: list[dict[str, Any]],
    table: HealthTable,
    outcomes: list[Outcome] | None,
    values_per_window: int | None,
    stride: int = 1,
) -> list[Member]:
    """Return the series, in the order of their names.

    Args:
        rows: the step *candidates*.
        table: where they come from.
        outcomes: what became of the assets; None if it is not known of any.
        values_per_window: said by the user; None to read it off the rows.
        stride: vectors for which one value was taken, of a table with a row per vector.

    Raises:
        SourceError: rows belong nowhere, an order is not unique, a failed channel is not told, or
            sums would not fit in 64 bits.
    """
    check_rows(rows, table)
    rows = sorted(rows, key=lambda row: (row["asset"], row["channel"]))
    numbers = {asset: n for n, asset in enumerate(dict.fromkeys(row["asset"] for row in rows), 1)}
    channels = Counter(row["asset"] for row in rows)
    named = {(outcome.asset, outcome.channel): outcome for outcome in outcomes or ()}
    for asset_outcome in outcomes or ():
        if (
            not asset_outcome.healthy
            and asset_outcome.channel is None
            and channels[asset_outcome.asset] > 1
        ):
            raise SourceError(
                "A failed asset with several channels is judged by the one that failed; name it in the "
                "column 'channel' of the outcomes."
            )
    series = []
    for number, row in enumerate(rows, 1):
        name = (row["asset"], row["channel"])
        outcome = named.get(name) or named.get((row["asset"], None))
        stratum = ASIDE if outcomes is not None else TRENDING
        if outcome is not None:
            stratum = CALM if outcome.healthy else TRENDING
        if table.counts:
            check_counts(row["hi_values"], (row["highest_count"] or 0) - (row["lowest_count"] or 0))
        series.append(
            Member(
                series_id=number,
                asset=row["asset"],
                channel=row["channel"],
                asset_no=numbers[row["asset"]],
                outcome=None if outcome is None else HEALTHY if outcome.healthy else FAILED,
                stratum=stratum,
                has_outcome=int(outcome is not None),
                ends_at=FAR_AHEAD if outcome is None or outcome.failed_at is None else outcome.failed_at,
                steps=1 if table.counts else steps(row["hi_values"]),
                values_per_window=values_per_window or _values_per_window(row, table, stride),
                window=_window(row),
            )
        )
    return series


def unmatched(outcomes: list[Outcome], series: list[Member]) -> int:
    """Return how many outcomes speak of no channel that there is."""
    names: set[tuple[str, str | None]] = {(member.asset, member.channel) for member in series}
    names |= {(member.asset, None) for member in series}
    return sum((outcome.asset, outcome.channel) not in names for outcome in outcomes)


def as_table(series: list[Member]) -> pa.Table:
    """Return the members as the step *members*."""
    integers = (
        "series_id",
        "asset_no",
        "stratum",
        "has_outcome",
        "ends_at",
        "steps",
        "values_per_window",
    )
    columns = {
        name: pa.array([getattr(member, name) for member in series], pa.int64()) for name in integers
    }
    texts = ("asset", "channel", "outcome")
    return pa.table(
        columns
        | {name: pa.array([getattr(member, name) for member in series], pa.string()) for name in texts}
    )


def _check_times(failed: str | None, failed_kind: TimeKind | None, kind: TimeKind | None) -> None:
    if failed_kind is None:
        raise SourceError(
            f"The column 'failed_at' is of type {failed}; it must be a timestamp or an integer counter, "
            "as the time of the health indicators is."
        )
    if kind is None:
        raise SourceError(
            "The outcomes say when assets failed, but the health indicators have no time; add the "
            "column 'last_time', which gam run writes."
        )
    if kind.is_counter != failed_kind.is_counter:
        raise SourceError(
            f"The column 'failed_at' is of type {failed}, but the health indicators tell time by "
            + ("an integer counter." if kind.is_counter else "timestamps.")
        )


def _outcome(row: dict[str, Any]) -> Outcome:
    if row["asset"] is None:
        raise SourceError("The outcomes have a row without asset.")
    healthy = row["healthy"]
    if healthy not in (None, 0, 1):
        raise SourceError("The column 'healthy' of the outcomes must be true or false, or 1 or 0.")
    if healthy == 1 and row["is_dated"]:
        raise SourceError("The outcomes have a row that is healthy and has failed.")
    is_healthy = bool(healthy) if healthy is not None else not row["is_dated"]
    return Outcome(row["asset"], row["channel"], is_healthy, row["failed_at"])


def check_rows(rows: list[dict[str, Any]], table: HealthTable) -> None:
    """Refuse a table of indicators that has no row, rows without a name or time, or places twice."""
    if not rows:
        raise SourceError("The table of health indicators has no row.")
    nameless = sum(row["rows_read"] for row in rows if row["asset"] is None or row["channel"] is None)
    unplaced = sum(row["rows_read"] - min(row["numbered_values"], row["dated_values"]) for row in rows)
    for count, what in ((nameless, "asset or channel"), (unplaced, "time")):
        if count:
            raise SourceError(f"The table of health indicators has {count} rows without {what}.")
    twice = sum(row["places"] < row["rows_read"] for row in rows)
    if twice:
        raise SourceError(
            f"{twice} channels have several values at one place, so their order is not known; is it the "
            "table of one run?"
        )
    if table.counts and any(row["counted_values"] < row["hi_values"] for row in rows):
        raise SourceError(
            "The column 'novel_in_window' is NULL where 'hi' is not; leave it out if it is not the "
            "count that 'hi' is a share of."
        )


def _values_per_window(row: dict[str, Any], table: HealthTable, stride: int) -> int:
    if row["vectors_in_window"] is not None:
        return 0 if row["vectors_in_window"] % stride else int(row["vectors_in_window"]) // stride
    if table.counts and table.buckets and row["first_place"] is not None:
        return int(row["first_place"]) + 1
    return 0


def _window(row: dict[str, Any]) -> int:
    if not row["highest_count"] or not row["highest_hi"]:
        return 0
    window: int = round(row["highest_count"] / row["highest_hi"])
    return window
