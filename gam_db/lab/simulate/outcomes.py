"""Outcomes: what became of simulated robots, in the form that ``gam evaluate --outcomes`` takes."""

from collections.abc import Iterable, Mapping
from typing import Any

import pyarrow as pa

OUTCOMES = pa.schema(
    {
        "asset": pa.string(),
        "channel": pa.string(),
        "failed_at": pa.timestamp("us", "UTC"),
        "healthy": pa.bool_(),
    }
)


def outcomes_of(truths: Iterable[Mapping[str, Any]]) -> pa.Table:
    """Return the outcomes that the truth about some joints says.

    A robot that failed has a row for the joint that did, a healthy one a row without channel: each of
    its joints counts. Robots that were changed without any fault have no row, so they count neither way.

    Args:
        truths: rows of the truth table.
    """
    rows: dict[str, dict[str, Any]] = {}
    for truth in truths:
        failed = truth["failed_at"] is not None
        if failed or truth["kind"] == "healthy":
            rows[truth["asset"]] = {
                "asset": truth["asset"],
                "channel": truth["channel"] if failed else None,
                "failed_at": truth["failed_at"],
                "healthy": not failed,
            }
    return pa.Table.from_pylist(list(rows.values()), schema=OUTCOMES)
