"""Trust: a study takes it that no instant occurs twice, and finds out on the way whether that was right.

This module owns when that is done (:mod:`gam_db.method.census` has the steps), and what proves it: each
vector of calibration and each scored one is marked where it has the instant of the sample before it,
and between them they hold every sample. Channels with a mark are done again
(:mod:`gam_db.study.repeating`); where they hold half of all readings, the study begins anew with the
steps that look first. So it does for what is asked before there is a proof. Single vectors are theirs as
well: after a proof they go on from what there is. Channels that seem to take turns are tried so first;
one mark, and vectors are sorted.
"""

from collections.abc import Callable, Collection
from dataclasses import replace

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD
from gam_db.columns import table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.census import (
    EDGES,
    OPENING,
    SCORED,
    TAUGHT,
    UNCUT,
    Slicing,
    serves,
    slices_for,
)
from gam_db.method.delays import AS_STORED, PROOFS, Ways
from gam_db.study import repeating, rounds
from gam_db.study.naming import GLANCE
from gam_db.study.narrowing import narrow
from gam_db.study.rounds import Range, Rounds
from gam_db.study.running import Between, Running

__all__ = ["Counts", "Trust", "begun", "serves"]

#: Rows at the beginning of a source by which its channels are guessed.
GLANCED = 100_000


def begun(
    running: Running, ways: Ways, opening: Callable[[Slicing | None, Ways], Pipeline]
) -> tuple[Slicing | None, Ways]:
    """Begin with the steps that trust, unless times are odd or nothing will be scored.

    What is asked first is at work; ``opening`` gives it for how times are cut, and other ways.

    Returns:
        How the times of the source are cut, None where it is not trusted; and what is done in the way of
        the engine and of this source.
    """
    if ways.asked and not ways.scores:
        return None, ways  # nothing of it would be proven
    engine = running.session.engine
    own = replace(ways, by_sets=engine.by_sets)
    by_windows = ways.by_windows or engine.delays is None
    if ways.has_sets and not by_windows and _has_room(running):
        return UNCUT, _kept(running, replace(own, delays=engine.delays), opening)
    running.keep("extent")
    (extent,) = running.rows("extent")
    edges = extent["earliest"], extent["latest"]
    if _are_odd(edges):
        return None, ways
    slicing = Slicing.of(*edges, slices_for(extent["readings"], _channels(running, extent["readings"])))
    running.steps = opening(slicing, own)
    return slicing, own


def _channels(running: Running, readings: int) -> int:
    """Guess how many channels there are, by the first rows: to count them costs a pass by names.

    Half of the rows have the names of all of them where channels take turns and all were seen, or where
    they lie one after another and are long. Else the source goes on as it begins.
    """
    rows = min(readings, GLANCED)
    running.steps.fill("glanced", "census/glanced", {"rows": rows, "half": (rows + 1) // 2})
    (glanced,) = running.rows("glanced")
    names: int = glanced["names"]
    return names if names == glanced["names_of_half"] else names * readings // rows


def _has_room(running: Running) -> bool:
    """Tell whether the samples of the source have room, for a body that holds them."""
    if not running.session.engine.holds_delays:
        return True
    most = running.session.rows_at_once()
    running.steps.fill("size", "census/size", {"most": most + 1})
    (size,) = running.rows("size")
    return bool(size["readings"] <= most)


def _kept(running: Running, ways: Ways, opening: Callable[[Slicing | None, Ways], Pipeline]) -> Ways:
    """Begin with a body that keeps the source in order, and sorts it if need be; return the ways."""
    if ways.delays in AS_STORED:
        running.steps.fill("glance", f"{ways.delays}/glance", {"rows": GLANCE})
        (glanced,) = running.rows("glance")
        ways = replace(ways, as_stored=glanced["misplaced"] == 0)
    running.steps = opening(UNCUT, ways)
    if ways.as_stored and running.largest("pieces", "misplaced"):
        running.forget(but=("readings",))
        ways = replace(ways, as_stored=False)
        running.steps = opening(UNCUT, ways)
    return ways


def _are_odd(edges: Collection[int | None]) -> bool:
    """Tell whether a source has no first and last time, or one beyond all instants."""
    return not edges or any(edge is None or abs(edge) >= FAR_AHEAD for edge in edges)


class Trust:
    """The trust of a study whose *names* are counted.

    Args:
        method, running, names: of the study; the method is one that is served.
        ways: what the engine does in a way of its own.
        made: gives the steps for other ways.
        careful: gives the steps that look first.
        between: gives the step *readings*.
    """

    def __init__(
        self,
        method: Method,
        running: Running,
        names: pa.Table,
        ways: Ways,
        made: Callable[[Ways], Pipeline],
        careful: Callable[[], Pipeline],
        between: Between,
    ) -> None:
        self.method, self.running, self._ways, self._made = method, running, ways, made
        self._careful, self._between = careful, between
        self._sets = range(len(method.settings))
        self.holds, self._is_proven, self._repeating = True, False, set[int]()
        first, last = (names[edge].drop_null().to_pylist() for edge in ("earliest", "latest"))
        if _are_odd([*first, *last]):
            self._give_up()
            return
        if method.is_cut(min(first)):
            self._ways = replace(self._ways, is_cut=True)
            running.steps = made(self._ways)
        self._take_turns(names)

    @property
    def holds_so_far(self) -> bool:
        """Tell whether a step was given, and nothing spoke against it."""
        return self.holds and self._is_proven

    def prepare(self, step: str) -> None:
        """Prove what a step needs, or let the steps that look first serve it."""
        steps = self.running.steps
        if not self.holds or (self._is_proven and step in steps.steps):
            return
        if step in steps.steps:
            needed = {one.name for one in steps.needed([step])}
            # What buckets are counted from is kept; single vectors have the same proof.
            proving = (self._ways.counted, "numbered")
            if any({self._step(of, number) for number in self._sets} <= needed for of in proving):
                self._is_proven = self._proves()
            if self._is_proven or "series" not in needed:
                return
        if self._is_proven:
            self._hand_over()
        else:
            self._give_up()

    def _take_turns(self, names: pa.Table) -> None:
        """Let vectors be made by rounds, if channels seem to take turns as rows are stored."""
        are_alike = len(set(names["readings"].to_pylist())) == 1
        if not are_alike or self._ways.delays is not None or self._ways.by_windows:
            return
        settings, has_missing = self.method.settings, self._ways.has_missing
        if rounds.seem_to_be(self.running, names.num_rows, settings, has_missing):
            self._ways = replace(self._ways, round=names.num_rows)
            self.running.steps = self._made(self._ways)
            self._rounds = Rounds(self.running, self._between)

    def _proves(self) -> bool:
        """Tell whether every sample is in a vector, and do channels again of which one is marked."""
        found = self._found()
        if found != set() and self._ways.round is not None:
            # Rows that are not in turn are marked as well.
            self._ways = replace(self._ways, round=None)
            self.running.forget(but=("names", "readings", *OPENING))
            self.running.steps = self._made(self._ways)
            found = self._found()
        if found:
            self._repeating = found
            members = repeating.members_of(self.running.rows("channels"), found)
            repeating.do_again(self.running, self.method, self._careful(), members)
        return found is not None

    def _found(self) -> set[int] | None:
        """Return the channels with a mark, None where they are too many or a sample is in no vector."""
        running, ways = self.running, self._ways
        found = repeating.found_before(running, ways)
        if self._are_many(found):
            return None
        narrow(running, self._between)
        limits = [{**row, "unscored_end": row["first_scored"] - 1} for row in self._kept_rows("limits")]
        ends = ((row["calibration_end"], row["unscored_end"]) for row in limits)
        if any(taught is not None and taught > unscored for taught, unscored in ends):
            return None  # what is scored holds samples of calibration
        healthy = self._bound(TAUGHT, limits, "calibration_from", "unscored_end")
        for number in self._sets:
            bounds, *marked = (
                self._step(step, number) for step in ("bounds", *PROOFS[ways.delays], ways.taught)
            )
            running.keep(bounds)
            if running.table(bounds)["calibrated_lo"].null_count:
                return None
            if not ways.is_cut:
                self._keep_rounds(ways.taught, number, TAUGHT, healthy)
            found |= repeating.found_by(running, marked)
            if self._are_many(found):
                return None
        if ways.by_sets and self._has_large_support():
            running.steps = self._made(replace(ways, by_sets=False))
        for number in self._sets:
            run_up, final, scored = (
                self._step(step, number) for step in ("run_up", ways.counted, SCORED)
            )
            read = self._bound(scored, self._kept_rows(run_up), "read_from")
            self._keep_rounds(final, number, scored, read)
            found |= repeating.found_by(running, [final])
            if self._are_many(found):
                return None
        return found

    def _are_many(self, found: set[int]) -> bool:
        """Tell whether channels hold half of all readings; one that is taken to be in turn is enough."""
        if self._ways.round is not None or not found:
            return bool(found)
        channels = self.running.rows("channels")
        held = sum(row["readings"] for row in repeating.members_of(channels, found))
        return bool(2 * held > sum(row["readings"] for row in channels))

    def _step(self, step: str, number: int) -> str:
        """Return what a step is called, which may be one of a set."""
        own = self.method.named(step, number)
        return own if own in self.running.steps.steps else step

    def _has_large_support(self) -> bool:
        """Tell whether a support has more cells than the engine looks up as a set."""
        session = self.running.session
        if session.engine.most_in_set is None:
            return False
        most = session.rows(session.engine.most_in_set)[0]["most"]
        for number in self._sets:
            self.running.keep(support := self.method.named("support", number))
            cells = exp.select(exp.Count(this=exp.Star()).as_("cells"))
            counted = session.rows(cells.from_(self.running.placed[support].copy()))
            if counted[0]["cells"] > most:
                return True
        return False

    def _kept_rows(self, step: str) -> list[Row]:
        """Keep a step, and return its rows."""
        self.running.keep(step)
        return self.running.rows(step)

    def _bound(
        self, rows: str, said: Collection[Row], low: str, high: str | None = None
    ) -> tuple[int, int] | None:
        """Let a step of readings be bounded by the least and greatest time that rows say."""
        if rows not in self.running.steps.steps or not said:
            return None
        latest = FAR_AHEAD if high is None else max(row[high] for row in said)
        edges = min(row[low] for row in said), latest
        self.running.steps.replace(rows, self._between(*edges))
        return edges

    def _keep_rounds(self, step: str, number: int, rows: str, edges: tuple[int, int] | None) -> None:
        """Keep a step of vectors that are made by rounds, of the readings between two instants."""
        scale = self._step("scale", number)
        if self._ways.round is None or edges is None:
            return
        self.running.keep(scale)
        counted = ("readings", "samples_before", "context_rows")
        counts = {tuple(row[name] for name in counted) for row in self.running.rows(scale)}
        # Vectors of channels with missing samples are numbered one by one, from the first to the last.
        if len(counts) == 1 and (rows == TAUGHT or not self._ways.has_missing):
            ((readings, taught, context),) = counts
            start, end = (0, taught) if rows == TAUGHT else (taught - context, readings)
            read = Range(rows, *edges, start, end - start)
            named = self._step(step, number), self._step("rounds", number), scale
            self._rounds.keep(*named, self.method.settings[number], read)

    def _hand_over(self) -> None:
        """Let the steps that look first go on with all that is proven: where an instant occurs twice."""
        series = self.running.session.rows(self.running.query("series"))
        for number in self._sets:
            for step in ("bounds", "run_up", "support"):
                self.running.keep(self.method.named(step, number))
        self.holds = False
        self.running.steps = self._careful()
        self.running.forget(but=self.running.steps.steps)
        _load_timeline(self.running, series, self._repeating)

    def _give_up(self) -> None:
        self.holds = False
        self.running.forget(but=("names", "readings"))
        self.running.steps = self._careful()


class Counts:
    """The trust of a study of whole channels alone (of ``gam check``), counted by slices.

    Whoever puts the samples in order sees whether that was right, and has the steps that look first,
    which ``careful`` gives, go on if not.
    """

    def __init__(self, running: Running, careful: Callable[[], Pipeline], between: Between) -> None:
        self.running, self._careful, self._between = running, careful, between
        self._is_bounded = False

    def prepare(self, step: str) -> None:
        """Bound what is read of the edges, before any step that reads them."""
        steps = self.running.steps
        if self._is_bounded or EDGES not in {one.name for one in steps.needed([step])}:
            return
        self._is_bounded = True
        narrow(self.running, self._between)

    def look_first(self, repeated: Collection[int]) -> None:
        """Let the steps that look first go on with what is proven: where an instant occurs twice."""
        self.prepare("series")
        rows = self.running.rows("series")
        self.running.forget(but=("names", "readings"))
        self.running.steps = self._careful()
        _load_timeline(self.running, rows, repeated)


def _load_timeline(running: Running, series: Collection[Row], repeated: Collection[int]) -> None:
    """Let what is known of the times of channels be their timeline: in which an instant occurs twice."""
    timeline = [{**row, "repeats": int(row["channel_id"] in repeated)} for row in series]
    running.load("timeline", table_of(timeline, repeating.TIMELINE))
