"""Promise and wear: how often calm channels open, and how early a joint that wears is seen."""

import statistics
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from gam_db.alarms.backtesting import figures
from gam_db.lab.benchmark.alarms.tables import Judged, Name, Row, name_of

EARLY = 0.6
"""Share of worn life before which half of the joints that are seen should be."""


def promise(judged: Judged, calm: set[Name]) -> Row:
    """Return what is stated and what calm channels showed.

    Channels of which no rate can be stated are counted apart, those without a limit by reason.

    Returns:
        What :func:`gam_db.backtest` does, of the channels with a stated rate; kept (is neither lower
        bound above what is stated; None without such a channel), unstated (channels, judgements and
        episodes of basis none), heights (in quarters of a spread -> channels), calm (channels).
    """
    rows = [row for row in judged.limits if name_of(row) in calm]
    stated = {name_of(row) for row in rows if row["stated_rate"] is not None}
    calm_rows = [row for row in judged.counted if name_of(row) in calm]
    rated, rest = (
        [row for row in calm_rows if (name_of(row) in stated) == has] for has in (True, False)
    )
    promised: Row = {"asked": judged.rate, "stated": None}
    if rated:
        promised = figures(judged.rate, rows, rated)
    promised.pop("by_channel", None)
    lowest = max(promised.get("lower", 0.0), promised.get("resampled_lower", 0.0))
    heights = Counter(row["quarters"] for row in rows if row["quarters"] is not None)
    return {
        **promised,
        "kept": lowest <= promised["stated"] if rated else None,
        "calm": len(rows),
        "unstated": counted(rest),
        "withheld": dict(Counter(row["reason"] for row in rows if row["reason"] is not None)),
        "heights": {str(quarters): count for quarters, count in sorted(heights.items())},
    }


def counted(rows: Sequence[Row]) -> Row:
    """Return how many channels, judgements and episodes rows of *backtested* hold."""
    sums = {name: sum(row[name] for row in rows) for name in ("judgements", "episodes")}
    return {"channels": len(rows), **sums}


def wear(
    judged: Judged, wearing: Mapping[Name, Mapping[str, Any]], ends: Mapping[tuple[Name, int], int]
) -> Row:
    """Return which joints that wear were seen, and when.

    A joint is seen if an episode opens in a judgement that ends after its onset. One without a limit,
    one that was never judged, and one whose only episode opened before its onset is not.

    Args:
        judged: what the product says.
        wearing: the joints.
        ends: channel and number of a judgement -> when it ends.
    """
    opened: dict[Name, list[int]] = {name: [] for name in wearing}
    for row in judged.episodes:
        if name_of(row) in opened:
            opened[name_of(row)].append(ends[name_of(row), row["first_judgement"]])
    reasons = {name_of(row): row["reason"] or row["basis"] for row in judged.limits}
    return {"asked": judged.rate, **shares(opened, wearing, reasons)}


def shares(
    opened: Mapping[Name, Iterable[int]],
    wearing: Mapping[Name, Mapping[str, Any]],
    reasons: Mapping[Name, str] | None = None,
) -> Row:
    """Return the share of worn life that each joint had used when it was seen first; see :func:`wear`.

    Returns:
        joints, seen, median (of those seen), early (seen before 0.6), by_kind (fault -> joints, seen,
        median), unseen (basis or reason of the limit -> joints).
    """
    used: dict[Name, float] = {}
    for name, truth in wearing.items():
        onset, failed = truth["onset"], truth["failed_at"]
        after = [time for time in opened.get(name, ()) if time > onset]
        if after:
            used[name] = min((min(after) - onset) / (failed - onset), 1.0)
    kinds: dict[str, list[Name]] = {}
    for name, truth in wearing.items():
        kinds.setdefault(truth["event"], []).append(name)
    unseen = Counter((reasons or {}).get(name, "judged") for name in wearing if name not in used)
    return {
        **_summary(list(wearing), used),
        "early": sum(share < EARLY for share in used.values()),
        "by_kind": {kind: _summary(names, used) for kind, names in sorted(kinds.items())},
        "unseen": dict(unseen),
    }


def _summary(names: Sequence[Name], used: Mapping[Name, float]) -> Row:
    seen = [used[name] for name in names if name in used]
    median = statistics.median(seen) if seen else None
    return {"joints": len(names), "seen": len(seen), "median": median}
