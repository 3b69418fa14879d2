"""A study: one source, one method, one session; runs the steps and hands out tables.

This module owns the order of work: look at the source, resolve what was asked, make the steps.
"""

import contextlib
import dataclasses
from collections import Counter
from collections.abc import Collection, Iterator
from functools import lru_cache, partial
from pathlib import Path
from typing import Any

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.columns import name_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.engines.base import Engine
from gam_db.engines.connecting import borrowed
from gam_db.engines.session import Row, Session
from gam_db.errors import wrong
from gam_db.method import Method, opening_pipeline, pipeline, trusting_pipeline
from gam_db.method.adding import add
from gam_db.method.bits import Bits
from gam_db.method.census import Slicing
from gam_db.method.delays import Ways
from gam_db.reading import ahead, look
from gam_db.reading.guess import sourced
from gam_db.reading.preparing import prepared
from gam_db.reading.undated import Undated, undated
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import AUTO, RUNGS, Override, Parameters
from gam_db.settings.patterns import grouped
from gam_db.settings.setting import settings_of
from gam_db.settings.source import AnySource, is_file, paths_of
from gam_db.study import trusting, turning
from gam_db.study.running import PARTS_IN_TURN, TAUGHT, UNSORTED, Listener, Running, unheard
from gam_db.study.streaming import Streams, seems_ordered
from gam_db.study.trusting import Counts, Trust
from gam_db.study.turning import Turns

#: Studies whose filled and composed steps are kept; each has a few thousand nodes of trees.
LATELY = 16

#: Ranges of time that a study asks for.
RANGES = 3


class Study:
    """What is known of a source under one method.

    Args:
        session: an open session; the caller closes it.
        source: where the telemetry lies.
        parameters, calibration: the method.
        on_step: called with the name of each step before it is run.
        strict: refuse a source with rows that belong nowhere; else the step *names* counts them, and
            they are left out of all that follows.
        short_cuts: read channels that are stored in order of time in that order
            (:mod:`gam_db.study.streaming`), and take it on trust that no instant occurs twice
            (:mod:`gam_db.study.trusting`); not for who changes what the steps read.
        on_trust: of the two, take the second as well; not for who asks for calibration alone, which
            proves nothing of what comes after it.
        asked: the last steps that will be asked for, where that is known: what serves no other is made
            so that it costs least. Others may be asked for, at a price.
        counting: take it on trust likewise, for who asks for steps of whole channels alone, and looks
            himself whether it was right (:class:`gam_db.study.trusting.Counts`); no other short cuts.

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
        asked: Collection[str] = (),
        counting: bool = False,
    ) -> None:
        self.session, self._named = session, source.relation
        self._is_lent = not isinstance(source.relation, (str, Path, tuple, list))
        read = prepared(session, source)
        self.relation, self.columns, self.source = read.stored, read.columns, read.source
        said = None
        if parameters.is_open:
            listening = (on_step, strict, short_cuts, on_trust)
            rough = Study(session, source, parameters.finest(), calibration, *listening)
            said, parameters = parameters, _found(parameters, rough)
            rough.forget()
        self.method = Method(parameters, calibration, read.kind, said)
        unread = dataclasses.replace(read.rows, relation=None)  # the node counts
        self.clock = ahead.Clock.read(session, self.source, read.kind)
        #: Channels with rows that are later than now, which are left out; see :func:`ahead.rows_ahead`.
        self.ahead: list[Row] = []
        latest = self.clock.latest
        asking = self.method, unread, read.relation, session.engine
        until: int | None = None
        self._asked = (*asking, until)
        options = short_cuts, on_trust, asked, counting
        slicing, ways, is_streamed, names = self._begin(on_step, *options)
        ends = () if self.clock.now is None else names["latest"].drop_null().to_pylist()
        if any(end > latest for end in ends):
            kept = self.running.placed.get("readings")
            rows = self._readings(latest + 1, FAR_AHEAD) if kept is None else kept
            self.ahead = ahead.rows_ahead(session, rows, latest)
            self.running.forget()
            self._asked = (*asking, latest)
            slicing, ways, is_streamed, names = self._begin(on_step, *options)
            if not names.num_rows:
                sentences = ahead.ahead_sentences(self.ahead, len(self.ahead), self.clock)
                raise wrong("all_ahead", said=" ".join(sentences))
        if strict:
            look.check_rows(names, source, self.undated, session.engine)
        else:
            look.check_clock(names)
        may_trust = short_cuts and on_trust and trusting.serves(self.method)
        # Supports are kept as bits where those of so many channels have room.
        grids = (one.radix**one.m for one in self.method.settings)
        bits = session.engine.bits
        if bits is not None and not all(bits.serve(cells, names.num_rows) for cells in grids):
            bits = None
        if not any(names["missing_readings"].to_pylist()):
            ways = dataclasses.replace(ways, has_missing=False)
        if any(one.still_after is not None for one in self.method.settings):
            has_room = sum(names["readings"].to_pylist()) <= session.rows_at_once()
            ways = dataclasses.replace(ways, has_room=has_room)
        self.running.steps = self._steps(bits, slicing, ways)
        self._short_cut: Streams | Trust | Counts | Turns | None = None
        self._after_all = partial(self._trust_after_all, bits, ways, names) if may_trust else None
        if is_streamed and bits is not None:
            self._short_cut = Streams(
                self.method, self.running, ways.scores, ways.has_blocks, ways.has_missing
            )
        elif slicing is not None and counting:
            self._short_cut = Counts(self.running, partial(self._steps, bits), self._readings)
        elif slicing is not None:
            self._short_cut = self._trust(bits, slicing, ways, names)
        elif short_cuts and sum(names["readings"].to_pylist()) >= turning.TURNED_FROM:
            turns = Turns(self.method, self.running, self._readings)
            self._short_cut = turns if turns.serve(names) else None

    def _begin(
        self,
        on_step: Listener,
        short_cuts: bool,
        on_trust: bool,
        asked: Collection[str],
        counting: bool,
    ) -> tuple[Slicing | None, Ways, bool, pa.Table]:
        """Ask for the names of a source; return how its rows are best read, and the step *names*."""
        session = self.session
        self.running = Running(session, self._opening(), on_step=on_step)
        is_even = all(map(self.method.is_unbroken, range(len(self.method.settings))))
        slicing, ways = None, Ways(asked=frozenset(asked), by_windows=not is_even, has_sets=not counting)
        is_streamed = short_cuts and seems_ordered(self.method, self.running, ways.scores)
        may_trust = short_cuts and on_trust and trusting.serves(self.method)
        if (may_trust and not is_streamed) or counting:
            slicing, ways = trusting.begun(self.running, ways, self._opening)
        self.running.keep("names")
        names = session.fetch(self.steps.query("names", self.running.placed))
        return slicing, ways, is_streamed, names

    @property
    def steps(self) -> Pipeline:
        """The steps of the study."""
        return self.running.steps

    @property
    def is_ordered(self) -> bool:
        """Tell whether channels are to be read as they are stored."""
        return isinstance(self._short_cut, (Streams, Turns)) and self._short_cut.holds

    @property
    def taught_at_once(self) -> int:
        """Return how many times the readings that can be sorted at once are best calibrated together.

        What calibration makes of vectors has to have room, sorted or not; but turns are better read in
        few parts.
        """
        if not self.is_ordered:
            return 1
        return TAUGHT if isinstance(self._short_cut, Streams) else UNSORTED

    def read_in_parts(self, parts: int) -> None:
        """Give up turns if there are many parts: who asks for some channels reads the rows of all."""
        if isinstance(self._short_cut, Turns) and parts > PARTS_IN_TURN:
            self._short_cut = None

    @property
    def is_streamed(self) -> bool:
        """Tell whether vectors were made of channels as they are stored."""
        return isinstance(self._short_cut, Streams) and self._short_cut.holds_so_far

    @property
    def is_trusting(self) -> bool:
        """Tell whether it was taken on trust, and proven since, that no instant occurs twice."""
        return isinstance(self._short_cut, Trust) and self._short_cut.holds_so_far

    def look_first(self, repeating: Collection[int]) -> None:
        """Begin anew with the steps that look first, of a study that counted: instants occur twice.

        Args:
            repeating: the numbers of the channels in which they do.
        """
        if isinstance(self._short_cut, Counts):
            self._short_cut.look_first(repeating)
            self._short_cut = None

    def table(self, step: str) -> pa.Table:
        """Return the rows of a step; the small steps before it are kept for the next call."""
        self._prepare(step)
        return self.running.table(step)

    def rows(self, step: str) -> list[Row]:
        """Return the same, each row by the names of its columns."""
        self._prepare(step)
        return self.running.rows(step)

    def query(self, step: str) -> exp.Query:
        """Return the query of a step, likewise; it must not be changed."""
        self._prepare(step)
        return self.running.query(step)

    def load(self, step: str, rows: pa.Table) -> None:
        """Add an Arrow table as a small step that later ones can read."""
        columns = [template.column(name) for name in rows.column_names]
        self.steps.add(step, exp.select(*columns).from_(self.session.relation(rows)))
        self.steps.small |= {step}

    def write(self, step: str, path: Path, table: str) -> None:
        """Write the rows of a step as Parquet, or as a table of a DuckDB file."""
        self._prepare(step)
        self.running.write(step, path, table)

    def instant_of(self, time: exp.Expr) -> exp.Expr:
        """Return integer time as the source has it."""
        return self.session.engine.instant_of(self.method.kind, time)

    def undated(self) -> Undated:
        """Return which rows of the source tell no time, or two."""
        method, source, relation, _, _ = self._asked
        return undated(self.session, source, relation, method.kind)

    def invalid(self) -> dict[tuple[str, str], int]:
        """Return for how many rows of each channel the condition on readings does not hold."""
        method, source, relation, engine, until = self._asked
        if source.valid_when is None:
            return {}
        steps = Pipeline()
        steps.add("readings", engine.readings(source, relation, method.kind, validity=True, until=until))
        add(steps, "source/validity")
        return {name_of(row): row["invalid"] for row in self.session.rows(steps.query("validity"))}

    def forget(self) -> None:
        """Drop the tables that were kept, and let go of an Arrow table: the session stays open."""
        self.running.forget()
        if self._is_lent and isinstance(self.relation, exp.Table):
            self.session.forget(self.relation)

    def _opening(self, slicing: Slicing | None = None, ways: Ways | None = None) -> Pipeline:
        """Return the steps that are asked first."""
        steps = _opened(*self._asked, slicing, ways).copied()
        return self._with_file(steps)

    def _steps(
        self, bits: Bits | None, slicing: Slicing | None = None, ways: Ways | None = None
    ) -> Pipeline:
        """Return steps of the study's own; text is parsed once, not once per step."""
        steps = _filled(*self._asked, bits is not None, slicing, ways).copied()
        return self._with_file(steps)

    def _with_file(self, steps: Pipeline) -> Pipeline:
        """Let the rows of a text file be kept, which are not to be parsed twice."""
        if is_file(self._named) and not paths_of(self._named)[0].lower().endswith((".parquet", ".pq")):
            steps.small |= {"readings"}
        return steps

    def begin_anew(self) -> None:
        """Forget what was made of channels: others have the step *names* now."""
        self.running.forget(but=("names", "readings"))
        if isinstance(self._short_cut, (Streams, Turns)):
            self._short_cut.begin_anew()

    def _prepare(self, step: str) -> None:
        if self._short_cut is not None:
            self._short_cut.prepare(step)
        has_failed = isinstance(self._short_cut, Streams) and not self._short_cut.holds
        if has_failed and self._after_all is not None:
            self._short_cut = self._after_all()
            self._prepare(step)

    def _trust_after_all(self, bits: Bits | None, ways: Ways, names: pa.Table) -> Trust | None:
        """Take on trust that no instant occurs twice, where channels are not stored in order."""
        self.running.steps = self._opening()
        slicing, ways = trusting.begun(self.running, ways, self._opening)
        self.running.steps = self._steps(bits, slicing, ways)
        return None if slicing is None else self._trust(bits, slicing, ways, names)

    def _trust(self, bits: Bits | None, slicing: Slicing, ways: Ways, names: pa.Table) -> Trust:
        made, careful = partial(self._steps, bits, slicing), partial(self._steps, bits)
        return Trust(self.method, self.running, names, ways, made, careful, self._readings)

    def _readings(self, earliest: int, latest: int) -> exp.Query:
        """Return the step *readings* for a range of time, with bounds that an index can serve."""
        method, source, relation, engine, until = self._asked
        if "readings" in self.running.placed:  # of a text file, which is not to be parsed again
            within = engine.in_range(TimeKind.COUNTER, exp.column("time"), earliest, latest)
            return union_of(self.steps, ["readings"]).where(*within, copy=False)
        return _ranged(source, relation, engine, method.kind, earliest, latest, until).copy()


@contextlib.contextmanager
def studied(
    source: Any,
    parameters: Parameters | None,
    calibration: Calibration | None,
    engine: Any,
    short_cuts: bool = False,
    asked: Collection[str] = (),
) -> Iterator[Study]:
    """Give a study of a source, whose columns are guessed where only a relation is given.

    The method is the default one for None; for the engine see
    :func:`gam_db.engines.connecting.borrowed`, for all else :class:`Study`.
    """
    with borrowed(engine) as session:
        said = (parameters or Parameters(), calibration or Calibration())
        study = Study(session, sourced(source, session), *said, short_cuts=short_cuts, asked=asked)
        try:
            yield study
        finally:
            if session is engine:  # it stays open, and nobody asks this study again
                study.forget()


def _found(asked: Parameters, rough: Study) -> Parameters:
    """Return parameters with the bins that a study under the finest grids finds.

    They have one override per pattern. A channel has the finest grid that its support's certificate
    accepts, the coarsest if none, and the commonest if it has no certificate.
    """
    judged = {row["channel_id"]: row for row in rough.rows("verdicts")}
    rungs, said = {}, {}
    for row in rough.rows("channels"):
        name, verdict = name_of(row), judged[row["channel_id"]]
        said[name] = asked.of(*name)
        if verdict["verdict"] not in ("no_data", "constant"):
            rungs[name] = max(verdict["finest_bins"] or 0, RUNGS[-1])
    usual = max(Counter(rungs.values()).items(), key=lambda one: one[::-1], default=(RUNGS[-1],))[0]
    for name, one in said.items():
        if one.bins == AUTO:
            bins = min(rungs.get(name, usual), one.grid)
            said[name] = dataclasses.replace(one, bins=bins)
    rules, everything = grouped(said), ("*", "*")
    general = next((one for pattern, one in rules if pattern == everything), asked.finest())
    overrides = [
        Override(*pattern, **{key: getattr(one, key) for key in settings_of(Parameters)})
        for pattern, one in rules
        if pattern != everything
    ]
    return dataclasses.replace(general, overrides=overrides)


@lru_cache(maxsize=LATELY)
def _opened(
    method: Method,
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    until: int | None,
    slicing: Slicing | None,
    ways: Ways | None,
) -> Pipeline:
    """Return the steps that are asked first, likewise; arguments as for :func:`_filled`."""
    rows = engine.readings(source, relation, method.kind, until=until)
    return opening_pipeline(rows, slicing, ways)


@lru_cache(maxsize=RANGES * LATELY)
def _ranged(
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    kind: TimeKind,
    earliest: int,
    latest: int,
    until: int | None,
) -> exp.Query:
    """Return the step *readings* for a range of time; arguments as for :func:`_filled`."""
    return engine.readings(source, relation, kind, earliest, latest, until=until)


@lru_cache(maxsize=LATELY)
def _filled(
    method: Method,
    source: AnySource,
    relation: exp.Expr,
    engine: Engine,
    until: int | None,
    has_bits: bool,
    slicing: Slicing | None = None,
    ways: Ways | None = None,
) -> Pipeline:
    """Return the steps of a method, which nobody may add to; asked again, the same ones.

    The relation is the node to read from; that of the source does not matter. Slicing and ways are for
    the steps that trust; without slicing they look first.
    """
    kind, bits = method.kind, engine.bits if has_bits else None
    rows = engine.readings(source, relation, kind, until=until)
    said = method, rows, lambda node: engine.instant_of(kind, node)
    if slicing is not None:
        return trusting_pipeline(*said, slicing, bits, ways)
    return pipeline(*said, bits)
