"""A monitor: one source watched for years, its tables kept up to date.

This module owns the public calls of the stored form.
"""

import contextlib
import datetime as dt
import html
from dataclasses import InitVar, dataclass
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.alarms import Alarms
from gam_db.arguments import public_methods
from gam_db.checking import look_at
from gam_db.clock import Instant, Length, TimeKind, instant, zone
from gam_db.columns import table_of
from gam_db.composing import template
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import EngineError, UserError
from gam_db.method.source import named_like
from gam_db.report import Lacking, Wishes, write
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters, pattern_matches
from gam_db.settings.source import AnySource, repeat_of
from gam_db.stored import lengths
from gam_db.stored.alarms import labels as stored_alarms
from gam_db.stored.alarms import limits
from gam_db.stored.calibrating import calibrate, without
from gam_db.stored.checking import Checked, check_state
from gam_db.stored.checking.proving import keep
from gam_db.stored.pruning import prune
from gam_db.stored.schema import migrations
from gam_db.stored.scoring import Run
from gam_db.stored.scoring.report import Report, Wanted
from gam_db.stored.settings import MonitorSettings
from gam_db.stored.state import State, kind_of
from gam_db.stored.status import as_html, assessed, status
from gam_db.study import Study
from gam_db.study.automatic import Siblings
from gam_db.study.running import Listener, unheard


@public_methods
@dataclass(eq=False, repr=False)
class Monitor(MonitorSettings):
    """The stored form of one source: calibrated once, scored again and again (state.md).

    The contract: as long as no row arrives more than ``lookback`` behind the newest one of its channel
    that was read before, the stored buckets equal those of one run over everything, whatever the order
    of batches, replays and crashes. Each run reads ``lookback`` again and writes what differs. A row
    that is later than now is left out until its time comes.

    Its other keywords are those of :class:`MonitorSettings`.

    Args:
        engine: what :func:`gam_db.connect` returns, or what it takes. The state tables lie there.
        source: where the telemetry lies: a table of that database, a file, or an Arrow table.
        parameters: of the method; default :class:`Parameters`. They count when a version is made.
        calibration: the healthy part; default the first fifth of each channel. It counts likewise.
        alarm_settings: the rate of false alarms, and families; default :class:`Alarms`. It counts when
            limits are made.

    Raises:
        UserError: the database cannot be opened, or a keyword cannot be used.
    """

    engine: InitVar[Any]
    source: AnySource
    parameters: Parameters = None  # type: ignore[assignment]
    calibration: Calibration = None  # type: ignore[assignment]
    alarm_settings: Alarms = None  # type: ignore[assignment]

    def __post_init__(self, engine: Any) -> None:
        super().__post_init__()
        self._is_ours = not isinstance(engine, Session)
        self.session = engine if isinstance(engine, Session) else connect(engine)
        self.parameters = self.parameters or Parameters()
        self.calibration = self.calibration or Calibration()
        self.alarm_settings = self.alarm_settings or Alarms()
        self.state = State(self.session, self.tables)
        #: What the last calibration chose for channels that share it.
        self.siblings: list[Siblings] = []

    def __enter__(self) -> "Monitor":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    @property
    def _required(self) -> State:
        """The state, once it is known that its tables are those of this gam-db."""
        migrations.require(self.session, self.state.tables)
        return self.state

    def close(self) -> None:
        """Close the database if this monitor opened it; a session of the caller stays open."""
        if self._is_ours:
            self.session.close()

    def check(self, on_step: Listener = unheard) -> pa.Table:
        """Check the source before calibration; this needs no state.

        Args:
            on_step: called with the name of each step before it is run.

        Returns:
            One row per (asset, channel) pair; see :func:`gam_db.check`.

        Raises:
            UserError: the source, a parameter or the calibration cannot be used at all.
        """
        return look_at(self.session, self.source, self.parameters, self.calibration, on_step).table

    def migrate(self) -> list[str]:
        """Create or change the state tables; return the names of the applied migrations."""
        return [step.name for step in migrations.migrate(self.session, self.state.tables)]

    def calibrate(
        self, again: bool = False, limit: int | None = None, on_step: Listener = unheard
    ) -> pa.Table:
        """Calibrate the channels and freeze the result; see :func:`gam_db.stored.calibrating.calibrate`.

        It leaves out intervals that are labelled true_fault or maintenance.

        Args:
            again: make a new version of every channel, even with the same settings.
            limit: most readings to work on at once; None for what memory allows.
            on_step: called with the name of each step before it is run.

        Returns:
            One row per new version, with its verdict; none where every channel has one already.

        Raises:
            UserError: the source or the calibration cannot be used; nothing is half written.
        """
        healthy = without(self.calibration, stored_alarms.left_out(self._required, self.name))
        settings = self.parameters, healthy, on_step
        study = Study(self.session, self.source, *settings, short_cuts=True, on_trust=False)
        self.siblings = study.siblings
        try:
            self.alarm_settings.rate_for(study.method.kind)
            return calibrate(
                self.state, study, self.name, self.alarm_settings, again, limit, self.calibration
            )
        finally:
            study.running.forget()

    def score(
        self,
        *,
        since: Instant | None = None,
        until: Instant | None = None,
        full: bool = False,
        confirm: bool = False,
        everything: bool = False,
        asset: str = "*",
        channel: str = "*",
        dry_run: bool = False,
        limit: int | None = None,
        on_step: Listener = unheard,
    ) -> Report:
        """Bring the stored buckets up to date; read only new rows.

        Args:
            since: score anew from this instant on, to repair buckets that lack late rows.
            until: read no newer rows; later buckets are hidden until the next run without it.
            full: score everything anew.
            confirm: do either even if that loses buckets whose rows are gone from the source.
            everything: check parked channels and count calibration anew now, not only once a day.
            asset: pattern of the assets to score (``*`` any text, ``?`` one character).
            channel: pattern of the channels to score.
            dry_run: return what would be read; write nothing.
            limit: most readings to work on at once; None for what memory allows.
            on_step: called with what is done next.

        Returns:
            The rows read and written; see :class:`gam_db.stored.scoring.report.Report`.

        Raises:
            UserError: there is no such monitor, or the source cannot be used. Channels that were scored
                before the error stay scored; no other channel is half written.
        """
        kind = kind_of(self._required.monitor(self.name))
        wanted = Wanted(
            lookback=lengths.lookback(self.lookback, kind, repeat_of(self.source)),
            park_after=lengths.park_after(self.park_after, kind),
            repair_from=None if since is None else instant(since, kind, "since"),
            until=None if until is None else instant(until, kind, "until"),
            full=full,
            confirmed=confirm,
            everything=everything,
            chosen=lambda asset_name, channel_name: (
                pattern_matches(asset, asset_name) and pattern_matches(channel, channel_name)
            ),
            limit=limit,
        )
        return Run(self.state, self.source, self.name, wanted, on_step).go(dry_run)

    def check_state(self, limit: int | None = None, on_step: Listener = unheard) -> pa.Table:
        """Compare the stored tables with the source, and with one another.

        The state records the check, if the session can write.

        Args:
            limit: most readings to work on at once; None for what memory allows.
            on_step: called with what is done next.

        Returns:
            One row per difference: rows that came too late, were corrected, or went, and damage or
            changes of the tables; none if the state equals one run over the whole source. See
            :func:`gam_db.stored.checking.check_state` for the columns.

        Raises:
            UserError: there is no such monitor, or the source cannot be used.
        """
        checked = self.checked_state(limit, on_step)
        with contextlib.suppress(EngineError):
            keep(self.state, self.state.monitor(self.name)["monitor_id"], checked.proof)
        return checked.differences

    def checked_state(self, limit: int | None = None, on_step: Listener = unheard) -> Checked:
        """Return the result of :meth:`check_state` and the record of the check; write nothing."""
        kind = kind_of(self._required.monitor(self.name))
        lookback = lengths.lookback(self.lookback, kind, repeat_of(self.source))
        return check_state(self.state, self.source, self.name, lookback, limit, on_step)

    def status(self) -> pa.Table:
        """Return the stored status of each channel, the most urgent first; read no source.

        Returns:
            One row per channel; see :func:`gam_db.stored.status.status` for the columns.

        Raises:
            UserError: there is no such monitor, or no state.
        """
        return status(self.state, self.name, self.park_after)

    def data_problems(self) -> pa.Table:
        """Return the problems of the data, apart from machines that need attention.

        It reads only what runs stored, not the source. No row means that no problem of the data is
        known.

        Returns:
            One row per problem; see :func:`gam_db.stored.problems.data_problems` for the columns.

        Raises:
            UserError: there is no such monitor, or no state.
        """
        return assessed(self.state, self.name, self.park_after).problems

    def alarms(self) -> pa.Table:
        """Return the episodes, those that need attention first; read no source.

        Returns:
            One row per episode; see :func:`gam_db.stored.alarms.alarms` for the columns.

        Raises:
            UserError: there is no such monitor, or no state.
        """
        return stored_alarms.alarms(self._required, self.name)

    def label(
        self,
        kind: str,
        episode: int | None = None,
        *,
        asset: str | None = None,
        span: tuple[Instant, Instant] | None = None,
        note: str | None = None,
        until: dt.datetime | None = None,
        instead: bool = False,
    ) -> list[int]:
        """Store a label on an episode, or on an asset from one instant to another.

        Args:
            kind: true_fault, false_alarm, maintenance, new_program, acknowledged or snoozed.
            episode: its number; without it, give asset and span.
            asset: the machine.
            span: first and last instant.
            note: a remark.
            until: when an acknowledgement, or a snooze, ends; with a time zone, else UTC.
            instead: replace an earlier decision that contradicts this one.

        Returns:
            The numbers of the labelled episodes.

        Raises:
            UserError: there is no such episode or asset, or an earlier label contradicts it.
        """
        about = (self._required, self.name, kind, episode, asset, span)
        return stored_alarms.label(*about, note, until, instead)

    def limits(self, again: bool = False, reason: str = "asked for") -> pa.Table:
        """Return the current limit of each channel, or why it has none; compute new ones on request.

        Args:
            again: compute new limits of all channels, for later judgements.
            reason: the reason that is stored with them.

        Returns:
            One row per channel, as of :func:`gam_db.limits`, with limit_no, from_judgement, cause and
            asked of the newest limit.

        Raises:
            UserError: there is no such monitor, or no state.
        """
        self._required.monitor(self.name)
        if again:
            with self.session.transaction():
                limits.make(
                    self.state, self.name, self.alarm_settings, self.parameters, reason, lambda _: True
                )
        return table_of(stored_alarms.limits(self.state, self.name), limits.SHOWN)

    def _repr_html_(self) -> str:
        """Return the status as a table for a notebook, or why there is none; all names are escaped."""
        try:
            return as_html(self.status())
        except UserError as error:
            return f"<p>{html.escape(str(error))}</p>"

    def prune(
        self,
        keep: Length | None = None,
        keep_novel: Length | None = None,
        keep_versions: int | None = None,
        dry_run: bool = False,
    ) -> pa.Table:
        """Delete old and hidden rows; return the row counts of each channel before and after.

        Args:
            keep: instead of the monitor's own; see :func:`gam_db.stored.pruning.prune`.
            keep_novel: the same.
            keep_versions: retired versions of each channel that stay; None for all.
            dry_run: undo it all; the result is the same.

        Raises:
            UserError: there is no such monitor, a length is wrong, or the database cannot be written.
        """
        age = self.keep if keep is None else keep
        novel_age = self.keep_novel if keep_novel is None else keep_novel
        return prune(self.state, self.name, age, novel_age, keep_versions, self.lookback, dry_run)

    def health(self, asset: str = "*", channel: str = "*") -> pa.Table:
        """Return the stored health indicator; read no source.

        Args:
            asset: pattern of the assets (``*`` any text, ``?`` one character).
            channel: pattern of the channels.

        Returns:
            One row per full bucket of the active versions, ordered: asset, channel, version_no, bucket,
            first_time and last_time (UTC; NULL where the source counts time), first_tick and last_tick
            (microseconds since 1970, or the counter), samples, novel, out_of_range, novel_in_window
            (NULL until the window is full), window_length, hi (a share).

        Raises:
            UserError: there is no such monitor, or no state.
        """
        self._required.monitor(self.name)
        conditions = (named_like("asset", asset), named_like("channel", channel))
        chosen = exp.and_(exp.true(), *filter(None, conditions))
        slots = {"monitor": template.text(self.name), "chosen": chosen}
        return self.state.fetch("stored/state/health_rows", slots)

    def report(
        self, path: str | Path, wishes: Wishes | None = None, on_step: Listener = unheard
    ) -> dict[str, Any]:
        """Write the page of the monitor: one self-contained HTML file.

        It reads the state, and the raw readings of the signals in detail where the source can be read.

        Args:
            path: of the file; replaced.
            wishes: title, signals in detail, time zone; see :class:`gam_db.report.Wishes`.
            on_step: called with what is done next.

        Returns:
            Figures of it; see :func:`gam_db.report.write`.

        Raises:
            UserError: there is no such monitor, nothing is calibrated, or the file cannot be written.
        """
        kind = kind_of(self._required.monitor(self.name))
        wishes = wishes or Wishes()
        now = None if wishes.made is None else instant(wishes.made, TimeKind.TIMESTAMP, "made")
        seen = assessed(self.state, self.name, self.park_after, now, zone(wishes.time_zone))
        seen = seen.of_assets(wishes.asset)
        lacking = Lacking(seen.watched, seen.problems.to_pylist())
        return write(self.state, self.source, kind, self.name, path, wishes, on_step, lacking)
