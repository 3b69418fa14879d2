"""A study: one source, one method, one session; runs the steps and returns tables.

This module owns the order of work: read the names of the source, resolve the settings, make the steps.
"""

import contextlib
import dataclasses
from collections.abc import Collection, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.engines.connecting import borrowed
from gam_db.engines.session import Row, Session
from gam_db.errors import wrong
from gam_db.method import Method
from gam_db.method.adding import OfSet, add
from gam_db.method.bits import Bits
from gam_db.method.census import Slicing
from gam_db.method.delays import Ways
from gam_db.method.programs import check_programs
from gam_db.reading import ahead, look
from gam_db.reading.guess import sourced
from gam_db.reading.preparing import prepared
from gam_db.reading.undated import Undated, undated
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource, is_file, paths_of
from gam_db.study import census
from gam_db.study.automatic import Siblings, choose
from gam_db.study.census import Census
from gam_db.study.naming import seems_ordered
from gam_db.study.running import TAUGHT, Listener, Running, once_more, unheard
from gam_db.study.steps import filled, opened, ranged
from gam_db.study.streaming import Streams


class Study:
    """A source under one method.

    Args:
        session: an open session; the caller closes it.
        source: where the telemetry lies.
        parameters, calibration: the method.
        on_step: called with the name of each step before it is run.
        strict: refuse a source with rows that belong nowhere; else the step *names* counts them, and
            they are left out of all that follows.
        short_cuts: read channels that are stored in order of time in that order
            (:mod:`gam_db.study.streaming`), and expect each instant once (:mod:`gam_db.study.census`);
            not for who changes what the steps read.
        on_trust: of the two, take the second as well; not for who asks for calibration alone, which
            proves nothing of what comes after it.
        targets: the last steps that will be asked for, where that is known: what serves no other is made
            so that it costs least. Others may be asked for, at a price.

    Raises:
        UserError: anything of the source, the parameters or the calibration that cannot be used.
    """

    def __init__(
        self,
        session: Session,
        source: AnySource,
        parameters: Parameters,
        calibration: Calibration,
        on_step: Listener = unheard,
        strict: bool = True,
        short_cuts: bool = False,
        on_trust: bool = True,
        targets: Collection[str] = (),
    ) -> None:
        self.session, self._named = session, source.relation
        self._is_lent = not isinstance(source.relation, (str, Path, tuple, list))
        read = prepared(session, source)
        self.relation, self.columns, self.source = read.stored, read.columns, read.source
        if read.programs is not None:
            short_cuts = False  # which program ran is told by the steps that look first
        open_parameters = None
        #: Channels that share settings which calibration chose.
        self.siblings: list[Siblings] = []
        if parameters.is_open:
            listening = (on_step, strict, short_cuts, on_trust)
            # Settings are chosen over all programs (both sides, section 5).
            whole = source if read.programs is None else dataclasses.replace(self.source, program=None)
            rough = Study(session, whole, parameters.finest(), calibration, *listening, ("bounds",))
            open_parameters = parameters
            parameters, self.siblings = rough.chosen(open_parameters)
            rough.forget()
        self.method = Method(parameters, calibration, read.kind, open_parameters, programs=read.programs)
        unread = dataclasses.replace(read.rows, relation=None)  # the node counts
        self.clock = ahead.Clock.read(session, self.source, read.kind)
        #: Channels with rows that are later than now, which are left out; see :func:`ahead.rows_ahead`.
        self.ahead: list[Row] = []
        latest = self.clock.latest
        asking = self.method, unread, read.relation, session.engine
        until: int | None = None
        self._inputs = (*asking, until)
        self._on_step, self._steps_wanted = on_step, frozenset(targets)
        scores = not targets or Ways(targets=self._steps_wanted).scores  # else no vector would prove it
        self._has_census = short_cuts and on_trust and scores and census.serves(self.method)
        self._form: Streams | Census | None = None
        self._is_checked = False
        self._begin(short_cuts)
        names = self._names()
        ends = () if self.clock.now is None else names["latest"].drop_null().to_pylist()
        if any(end > latest for end in ends):
            readings = self.running.tables.get("readings")
            rows = self._readings(latest + 1, FAR_AHEAD) if readings is None else readings
            self.ahead = ahead.rows_ahead(session, rows, latest)
            self.running.forget()
            self._inputs = (*asking, latest)
            self._begin(short_cuts)
            names = self._names()
            if not names.num_rows:
                sentences = ahead.ahead_sentences(self.ahead, len(self.ahead), self.clock)
                raise wrong("all_ahead", said=" ".join(sentences))
        if strict:
            look.check_rows(names, source, self.undated, session.engine)
        else:
            look.check_clock(names)
        self._choose(names)

    def _begin(self, may_stream: bool, is_collapsed: bool = False) -> None:
        """Ask for the names of a source, in the way in which its rows are best read."""
        if not is_collapsed:
            self.running = Running(self.session, self._opening(), on_step=self._on_step)
        is_even = all(map(self.method.is_unbroken, range(len(self.method.settings))))
        self._slicing: Slicing | None = None
        self._ways = Ways(targets=self._steps_wanted, by_windows=not is_even, is_collapsed=is_collapsed)
        self._is_streamed = may_stream and seems_ordered(self.method, self.running, self._ways.scores)
        if self._has_census and not self._is_streamed:
            self._slicing, self._ways = census.begun(self.running, self._ways, self._opening)
        self.running.keep("names")

    def _names(self) -> pa.Table:
        """Return the rows of the step *names*."""
        return self.session.fetch(self.steps.query("names", self.running.tables))

    def _choose(self, names: pa.Table) -> None:
        """Choose the form in which the steps are made: streams, the census, or those that look first."""
        # Supports are kept as bits where those of so many channels have room.
        grids = (setting.radix**setting.m for setting in self.method.settings)
        self._bits = bits = None if self.method.programs else self.session.engine.bits
        if bits is not None and not all(bits.serve(cells, names.num_rows) for cells in grids):
            self._bits = bits = None
        ways = self._ways
        if not any(names["missing_readings"].to_pylist()):
            ways = dataclasses.replace(ways, has_missing=False)
        if any(setting.still_after is not None for setting in self.method.settings):
            has_room = sum(names["readings"].to_pylist()) <= self.session.rows_at_once()
            # A channel without a healthy range has no vectors that could be kept.
            ways = dataclasses.replace(ways, has_room=has_room and not ways.is_collapsed)
        ends = (names[edge].drop_null().to_pylist() for edge in ("earliest", "latest"))
        if census.are_odd([end for edges in ends for end in edges]):
            self._is_streamed, self._slicing = False, None
        self.running.steps = self._steps(bits, self._slicing, ways)
        self._form = None
        if self._is_streamed and bits is not None:
            self._form = Streams(
                self.method, self.running, ways.scores, ways.has_blocks, ways.has_missing
            )
        elif self._slicing is not None:
            filled = partial(self._steps, bits, self._slicing)
            self._form = Census(self.method, self.running, names, ways, filled, self._readings)

    @property
    def steps(self) -> Pipeline:
        """The steps of the study."""
        return self.running.steps

    @property
    def is_ordered(self) -> bool:
        """Tell whether channels are to be read as they are stored."""
        return isinstance(self._form, Streams)

    @property
    def taught_at_once(self) -> int:
        """Return how many times the readings that can be sorted at once are best calibrated together.

        What calibration makes of vectors has to have room, sorted or not.
        """
        return TAUGHT if self.is_ordered else 1

    @property
    def form(self) -> str:
        """What the steps were made by, as far as they were: ``streams``, ``census`` or ``windows``."""
        if isinstance(self._form, Streams) and self._form.has_begun:
            return "streams"
        return "census" if isinstance(self._form, Census) and self._form.is_proven else "windows"

    @property
    def is_collapsed(self) -> bool:
        """Tell whether an instant occurred twice, so that the steps run over collapsed readings."""
        return self._ways.is_collapsed

    def table(self, step: str) -> pa.Table:
        """Return the rows of a step; the small steps before it are kept for the next call."""
        self.prepare(step)
        return self.running.table(step)

    def rows(self, step: str) -> list[Row]:
        """Return the same, each row by the names of its columns."""
        self.prepare(step)
        return self.running.rows(step)

    def query(self, step: str) -> exp.Query:
        """Return the query of a step, likewise; it must not be changed."""
        self.prepare(step)
        return self.running.query(step)

    def load(self, step: str, rows: pa.Table) -> None:
        """Add an Arrow table as a small step that later ones can read."""
        columns = [template.column(name) for name in rows.column_names]
        self.steps.add(step, exp.select(*columns).from_(self.session.relation(rows)))
        self.steps.small |= {step}

    def write(self, step: str, path: Path, table: str) -> None:
        """Write the rows of a step as Parquet, or as a table of a DuckDB file."""
        self.prepare(step)
        self.running.write(step, path, table)

    def instant_of(self, time: exp.Expr) -> exp.Expr:
        """Return integer time as the source has it."""
        return self.session.engine.instant_of(self.method.kind, time)

    def undated(self) -> Undated:
        """Return which rows of the source tell no time, or two."""
        method, source, relation, _, _ = self._inputs
        return undated(self.session, source, relation, method.kind)

    def chosen(self, parameters: Parameters) -> tuple[Parameters, list[Siblings]]:
        """Return what calibration chooses of open settings, of which these are the finest grids."""
        sets = [OfSet(self.steps, self.method, number) for number in range(len(self.method.settings))]
        return choose(self.running, sets, parameters)

    def invalid(self) -> dict[tuple[str, str], int]:
        """Return for how many rows of each channel the condition on readings does not hold."""
        method, source, relation, engine, until = self._inputs
        if source.valid_when is None:
            return {}
        steps = Pipeline()
        steps.add("readings", engine.readings(source, relation, method.kind, validity=True, until=until))
        add(steps, "source/validity")
        return {name_of(row): row["invalid"] for row in self.session.rows(steps.query("validity"))}

    def readings_of(self, source: AnySource) -> exp.Query:
        """Return the readings of a source like the study's, of the same relation."""
        method, _, relation, engine, until = self._inputs
        return engine.readings(source, relation, method.kind, until=until)

    def forget(self) -> None:
        """Drop the tables that were kept, and let go of an Arrow table: the session stays open."""
        self.running.forget()
        if self._is_lent and isinstance(self.relation, exp.Table):
            self.session.forget(self.relation)

    def _opening(self, slicing: Slicing | None = None, ways: Ways | None = None) -> Pipeline:
        """Return the first steps."""
        steps = opened(*self._inputs, slicing, ways).copied()
        return self._with_file(steps)

    def _steps(
        self, bits: Bits | None, slicing: Slicing | None = None, ways: Ways | None = None
    ) -> Pipeline:
        """Return steps of the study's own; text is parsed once, not once per step."""
        steps = filled(*self._inputs, bits is not None, slicing, ways).copied()
        if "probes" in self._steps_wanted:
            steps.small |= self.method.probed()
        return self._with_file(steps)

    def _with_file(self, steps: Pipeline) -> Pipeline:
        """Let the rows of a text file be kept, which are not to be parsed twice."""
        if is_file(self._named) and not paths_of(self._named)[0].lower().endswith((".parquet", ".pq")):
            steps.small |= {"readings"}
        return steps

    def begin_anew(self) -> None:
        """Forget the results for channels: the step *names* has other channels now."""
        self.running.forget(but=("names", "readings"))
        if isinstance(self._form, Streams):
            self._form.begin_anew()

    def prepare(self, step: str) -> None:
        """Let the form prove what a step needs."""
        self._check_programs()
        once_more(partial(self._prove, step), self._collapse)

    def _prove(self, step: str) -> None:
        if isinstance(self._form, Census) and not self._form.serves(step):
            self._look_first()
        if self._form is not None:
            self._form.prepare(step)

    def _check_programs(self) -> None:
        """Refuse more programs than keys have room for; without programs, do nothing."""
        if self.method.programs is None or self._is_checked:
            return
        self._is_checked = True
        self.running.keep("taught_programs")
        held = {row["support_id"]: row["settings_no"] for row in self.running.rows("channels")}
        taught = self.running.rows("taught_programs")
        for row in sorted(taught, key=lambda row: row["program_no"], reverse=True):
            check_programs(self.method.settings[held[row["support_id"]]], row["program_no"] + 1)

    def _collapse(self) -> None:
        """Collapse the readings by instant, and make the census from them."""
        if not self._has_census:
            self._look_first()
            return
        running = self.running
        running.forget(but=("readings",))
        running.steps = self._opening()
        collapsed = running.steps.copied()
        add(collapsed, "source/collapsed_readings")
        running.put("readings", collapsed.query("collapsed_readings", running.tables))
        self._begin(may_stream=False, is_collapsed=True)
        self._choose(self._names())

    def _look_first(self) -> None:
        """Choose the steps that look at all times first: they serve all, and collapse by themselves."""
        self.running.forget(but=() if self.is_collapsed else ("names", "readings", "channels"))
        self._ways = dataclasses.replace(self._ways, is_collapsed=False)
        if self._has_census:  # else the steps at work are these, with what the caller has added
            self.running.steps = self._steps(self._bits)
        self._form = None

    def _readings(self, earliest: int, latest: int) -> exp.Query:
        """Return the step *readings* for a range of time, with bounds that an index can serve."""
        method, source, relation, engine, until = self._inputs
        if "readings" in self.running.tables:  # of a text file, which is not to be parsed again
            within = engine.in_range(TimeKind.COUNTER, exp.column("time"), earliest, latest)
            return union_of(self.steps, ["readings"]).where(*within, copy=False)
        return ranged(source, relation, engine, method.kind, earliest, latest, until)


@contextlib.contextmanager
def studied(
    source: Any,
    parameters: Parameters | None,
    calibration: Calibration | None,
    engine: Any,
    short_cuts: bool = False,
    targets: Collection[str] = (),
) -> Iterator[Study]:
    """Yield a study of a source; guess the columns if only a relation is given.

    The method is the default one for None; for the engine see
    :func:`gam_db.engines.connecting.borrowed`, for all else :class:`Study`.
    """
    with borrowed(engine) as session:
        method = (parameters or Parameters(), calibration or Calibration())
        study = Study(session, sourced(source, session), *method, short_cuts=short_cuts, targets=targets)
        try:
            yield study
        finally:
            if session is engine:  # it stays open, and nobody asks this study again
                study.forget()
