"""Rows that belong to no channel or to no instant: a run counts them, and scores nothing of them."""

from collections.abc import Container, Sequence

from gam_db.composing.pipeline import Pipeline
from gam_db.engines.session import Session
from gam_db.method.adding import add
from gam_db.stored.planning import Row
from gam_db.stored.planning.reading import Reader
from gam_db.stored.scoring.report import Report
from gam_db.stored.state import State


def undated(session: Session, reader: Reader) -> int:
    """Return how many rows of the source have no time."""
    steps = Pipeline()
    steps.add("readings", reader.undated())
    add(steps, "stored/scoring/undated")
    return int(session.fetch(steps.query("undated"))["undated"][0].as_py())


def note_unknown(report: Report, names: Sequence[Row], known: Container[tuple[str, str]]) -> None:
    """Report the readings of names that are missing, or of no known channel."""
    for row in names:
        if row["asset"] is None or row["channel"] is None:
            report.nameless += row["readings"] + row["without_time"]
        elif (row["asset"], row["channel"]) not in known and row["readings"]:
            report.unknown_channels[row["asset"], row["channel"]] = row["readings"]


def keep_unplaced(state: State, monitor_id: int, started: int, report: Report) -> None:
    """Append what a run gave to no channel or instant, if there was any."""
    found = {
        "nameless": report.nameless,
        "undated": report.undated,
        "strangers": sum(report.unknown_channels.values()),
        "stranger_channels": len(report.unknown_channels),
    }
    if any(found.values()):
        state.append_rows("unplaced", [{"monitor_id": monitor_id, "started": started, **found}])
