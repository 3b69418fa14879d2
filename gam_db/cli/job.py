"""What a command works with: what was asked of a source, or a named monitor; how pages tell it."""

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from gam_db.checking.look import exact_columns
from gam_db.checking.words import number_of
from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.cli.page import some
from gam_db.cli.progress import working
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.reading.guess import Guess, folder_or_table, guess
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.setting import settings_of
from gam_db.settings.source import Source, shown_relation
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema import migrations
from gam_db.stored.sources import source_of
from gam_db.stored.state import State
from gam_db.study import Study
from gam_db.study.running import Listener


@dataclass(frozen=True)
class Job:
    """What was asked: of a source in the user's words, by which settings file, if any.

    ``exact`` names the columns of readings that are integers or decimals, not doubles.
    """

    name: str
    guess: Guess
    parameters: Parameters
    calibration: Calibration
    file: str | None = None
    exact: tuple[str, ...] = ()

    def study(self, session: Session, on_step: Listener, short_cuts: bool = True) -> Study:
        """Return what does it; without short cuts for who asks for single vectors of calibration."""
        arguments = (self.guess.source, self.parameters, self.calibration)
        return Study(session, *arguments, on_step=on_step, short_cuts=short_cuts)

    @property
    def settings(self) -> str:
        """Where settings came from, as the end of a heading."""
        return f"; settings from {self.file}" if self.file else ""

    def lines(self) -> list[str]:
        """Return which columns are read, which of them were guessed, and by what method."""
        values = {name: getattr(self.parameters, name) for name in settings_of(Parameters)}
        method = [f"{name}={value}" for name, value in values.items() if value is not None]
        if self.parameters.overrides:
            method.append(f"{len(self.parameters.overrides)} overrides")
        healthy = healthy_part(self.calibration)
        return [self.columns_line(), f"method: {' '.join(method)}; calibration: {healthy}"]

    def columns_line(self) -> str:
        """Return which columns are read, and which of them were guessed."""
        source, guessed = self.guess.source, self.guess.guessed
        shown = {role: name for role, name in source.columns.items() if not role.startswith("channel ")}
        line = "columns: " + " ".join(f"{role}={printable(name)}" for role, name in shown.items())
        if not isinstance(source, Source):
            line += f"; wide table, signals: {some(list(map(printable, source.value_columns)), 8)}"
        if guessed:
            roles = [role for role in guessed if role != "layout"]
            line += f"; guessed: {'all' if len(roles) == len(shown) else ', '.join(roles)}"
        if written := [
            f"{name}={value!r}" for name, value in source.written.items() if name != "program"
        ]:
            line += f"; written with {' '.join(written)}"
        if "layout" in guessed:
            line += f"; taken as {guessed['layout']}"
        if self.guess.unused:
            line += f"; not used: {some(list(map(printable, self.guess.unused)), 8)}"
        return line

    def figures(self) -> dict[str, Any]:
        """Return the same for --json."""
        source = self.guess.source
        is_long = isinstance(source, Source)
        of = ("channel", "value") if is_long else ("channels",)
        overrides = [
            {"asset": override.asset, "channel": override.channel, **override.changes()}
            for override in self.parameters.overrides
        ]
        return {
            "source": {
                "name": self.name,
                "layout": "long" if is_long else "wide",
                "columns": {role: getattr(source, role) for role in ("asset", "time", *of)},
                "guessed": self.guess.guessed,
                "where": source.where,
                "written": source.written,
            },
            "settings_file": self.file,
            "parameters": {**vars(self.parameters), "overrides": overrides},
            "calibration": self.calibration,
        }


def job_of(session: Session, settings: Settings, relation: Any, name: str | None = None) -> Job:
    """Return what is to be done with a source, its columns guessed where they were not named.

    Raises:
        UserError: the source, a parameter or the calibration cannot be used.
    """
    parameters, calibration = settings.method()
    columns = session.describe(session.relation(relation, settings.source))
    guessed = guess(relation, columns, settings.source, session)
    file = None if settings.file is None else str(settings.file)
    if settings.is_of_another:
        file = f"{file}, but for [source], which is of another"
    exact = exact_columns(session, guessed.source, columns)
    return Job(name or shown_relation(relation), guessed, parameters, calibration, file, exact)


@contextlib.contextmanager
def reading(settings: Settings, common: options.Common) -> Iterator[tuple[Session, Job, Listener]]:
    """Open a source that is only read; yields the session, what is to be done, what is told the step."""
    relation = options.named_relation(settings)
    session = connect(settings.source.database, common.threads, writable=False)
    with working(session, common.quiet) as on_step:
        yield session, job_of(session, settings, relation), on_step


def healthy_part(calibration: Calibration) -> str:
    """Return what is calibration, in words."""
    if calibration.fraction is not None:
        healthy = f"the first {100 * calibration.fraction:.4g} % of each channel"
    elif calibration.duration is not None:
        healthy = f"the first {calibration.duration} of each channel"
    else:
        healthy = number_of(len(calibration.intervals or ()), "interval")
    if patterns := [printable(pattern) for pattern in calibration.overrides]:
        healthy += f", but for {some(patterns)}"
    if calibration.pool is not None:
        rules = dict(calibration.cases)
        teachers = [printable(name) for name, rule in rules.items() if rule is not None]
        is_named = any(
            rules.get(pattern, calibration) is None for group in calibration.pools for pattern in group
        )
        healthy += ", pooled" + (f", taught by {some(teachers)} only" if is_named and teachers else "")
    return healthy


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
    monitor_row = state.monitor(settings.monitor.name)
    relation = folder_or_table(relation, session)
    source = source_of(monitor_row, channels_of(state, monitor_row), relation)
    # What is ahead is a question of each run, not of the monitor.
    source = replace(source, clock_tolerance=settings.source.clock_tolerance)
    return Monitor(
        session, source, alarm_settings=settings.alarms, **vars(settings.monitor)
    ), monitor_row


def channels_of(state: State, monitor_row: Row) -> list[str]:
    """Return the names of a monitor's channels, as often as there are assets with such."""
    channels = state.fetch("stored/state/monitor_channels", {"monitor_id": monitor_row["monitor_id"]})
    return [str(name) for name in channels["channel"].to_pylist()]
