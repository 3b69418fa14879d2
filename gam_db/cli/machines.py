"""Machines on a page: a line for each, and which signals are far above without an episode."""

import datetime as dt
from collections.abc import Iterator, Sequence

from gam_db.cli import page
from gam_db.cli.render import WORDS, Section, Table
from gam_db.findings import Row

#: Machines shown unless all are asked for.
_SHOWN = 20


def lines(rows: Sequence[Row], zone: dt.tzinfo, everything: bool) -> Iterator[Section]:
    """Yield a line per machine: since when, how many signals, which of them."""
    shown = [
        {**row, "share_above": f"{row['above']:,} of {row['watched']:,}"}
        | {name: row.get(name) or None for name in ("not_watched", "silent")}
        for row in (rows if everything else rows[:_SHOWN])
    ]
    yield Table("machines", shown, lambda row: "!" if row["above"] else " ", zone)
    yield from page.cut(rows, everything, most=_SHOWN, what=" machines")
    yield ""


def far_above(rows: Sequence[Row]) -> list[str]:
    """Return a line that names the signals far above the limit of their indicator without an episode."""
    far = [row for row in rows if row["is_far_above"] and row["onset"] is None]
    if not far:
        return []
    return [WORDS["remark"]["far_above"].format(names=page.some(list(map(page.name_in(rows), far))))]
