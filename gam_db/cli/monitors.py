"""The monitor that a command works with: found by its name, read from its tables, named on its page."""

import contextlib
from collections.abc import Iterator

from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.engines.session import Session
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.reading.guess import folder_or_table
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.sources import source_of
from gam_db.stored.state import State


def place(settings: Settings) -> Row:
    """Return which monitor a page is of, for --json."""
    return {"database": settings.source.shown_database, "monitor": settings.monitor.name}


def heading(settings: Settings) -> str:
    """Return the same for people."""
    return printable(f"{settings.source.shown_database}, monitor {settings.monitor.name}")


@contextlib.contextmanager
def state_of(settings: Settings, writable: bool = False) -> Iterator[State]:
    """Open the tables of a state; refuse those of another gam-db."""
    with options.opened(settings, writable=writable) as session:
        migrations.require(session, settings.monitor.tables)
        yield State(session, settings.monitor.tables)


def watched(
    session: Session, settings: Settings, relation: str | tuple[str, ...] | None
) -> tuple[Monitor, Row]:
    """Return the monitor that is meant, to read a relation where one is named, and its row."""
    migrations.require(session, settings.monitor.tables)
    state = State(session, settings.monitor.tables)
    known = state.monitor(settings.monitor.name)
    relation = folder_or_table(relation, session)
    source = source_of(known, channels_of(state, known), relation)
    return Monitor(session, source, asked=settings.alarms, **vars(settings.monitor)), known


def channels_of(state: State, known: Row) -> list[str]:
    """Return the names of a monitor's channels, as often as there are assets with such."""
    channels = state.fetch("stored/state/known_channels", {"monitor_id": known["monitor_id"]})
    return [str(name) for name in channels["channel"].to_pylist()]
