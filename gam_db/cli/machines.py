"""Machines on a page: a line for each, and which signals are far above without an episode.

This module owns what is told of a machine. What is above, and how machines are ranked, is said by
``sql/judgement/``.
"""

import datetime as dt
from collections.abc import Sequence

from gam_db.cli import page
from gam_db.errors import printable
from gam_db.findings import Row

#: Machines shown unless all are asked for.
_SHOWN = 20


def show(out: page.Out, rows: Sequence[Row], zone: dt.tzinfo, everything: bool) -> None:
    """Print a line per machine: since when, how many signals, which of them."""
    shown = rows if everything else rows[:_SHOWN]
    columns: dict[str, page.Cell] = {
        "machine": lambda row: printable(row["asset"]),
        "above": lambda row: f"{row['above']:,} of {row['watched']:,}",
        **page.when("since", "since", shown, zone),
        "first": lambda row: _named(row["first_channel"]),
        "strongest": lambda row: _named(row["strongest_channel"]),
        "times its limit": lambda row: None if row["strength"] is None else f"{row['strength']:.1f}",
    }
    for name in ("not_watched", "silent"):
        if any(row.get(name) for row in shown):
            columns[name.replace("_", " ")] = name
            shown = [row | {name: row[name] or None} for row in shown]
    spare = ("times its limit", "strongest", "silent")
    page.table(
        out, shown, columns, lambda row: "!" if row["above"] else " ", ("first", "strongest"), spare
    )
    page.cut(out, rows, everything, most=_SHOWN, what=" machines")
    out.print()


def _named(name: str | None) -> str:
    return "-" if name is None else printable(name)


def far_above(rows: Sequence[Row]) -> list[str]:
    """Return a line that names the signals far above the limit of their indicator without an episode."""
    far = [row for row in rows if row["is_far_above"] and row["onset"] is None]
    if not far:
        return []
    return [
        page.WORDS["remark"]["far_above"].format(names=page.some(list(map(page.name_in(rows), far))))
    ]
