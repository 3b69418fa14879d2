"""The census at work: a study expects each instant of a channel once, and proves it on the way.

This module owns when that serves a source (:mod:`gam_db.method.census` has the steps), and the proof:
each vector of calibration and each scored one is marked where it has the instant of the sample before
it, and between them they hold every sample.
"""

from collections.abc import Callable, Collection
from dataclasses import replace

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD
from gam_db.columns import name_of
from gam_db.composing.pipeline import Pipeline
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.census import EDGES, SCORED, TAUGHT, UNCUT, Slicing, serves, slices_for
from gam_db.method.delays import IN_ORDER, PROOFS, Ways
from gam_db.study.running import TWICE, Between, RepeatedError, Running

__all__ = ["Census", "are_odd", "begun", "serves"]

#: Rows at the beginning of a source by which its channels are guessed.
GLANCED = 100_000


def begun(
    running: Running, ways: Ways, opening: Callable[[Slicing | None, Ways], Pipeline]
) -> tuple[Slicing | None, Ways]:
    """Begin with the steps of the census, unless times are odd.

    The opening steps are at work; ``opening`` gives them for how times are cut, and other ways.

    Returns:
        How the times of the source are cut, None where the census does not serve; and what is done in
        the way of the engine and of this source.
    """
    engine = running.session.engine
    ways = replace(ways, by_sets=engine.by_sets)
    if not ways.by_windows and engine.delays is not None and _has_room(running):
        ways = replace(ways, delays=engine.delays)
        running.steps = opening(UNCUT, ways)
        return UNCUT, ways
    running.keep("extent")
    (extent,) = running.rows("extent")
    edges = extent["earliest"], extent["latest"]
    if are_odd(edges):
        return None, ways
    slicing = Slicing.of(*edges, slices_for(extent["readings"], _channels(running, extent["readings"])))
    running.steps = opening(slicing, ways)
    return slicing, ways


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


def are_odd(edges: Collection[int | None]) -> bool:
    """Tell whether a source has no first and last time, or one beyond all instants."""
    return not edges or any(edge is None or abs(edge) >= FAR_AHEAD for edge in edges)


class Census:
    """The census of a study whose *names* are counted.

    Args:
        method, running, names: of the study; the method is one that is served.
        ways: what is done in the way of the engine and of this source.
        filled: gives the steps for other ways.
        between: gives the step *readings*.
    """

    def __init__(
        self,
        method: Method,
        running: Running,
        names: pa.Table,
        ways: Ways,
        filled: Callable[[Ways], Pipeline],
        between: Between,
    ) -> None:
        self.method, self.running, self._ways, self._filled = method, running, ways, filled
        self._between, self.is_proven = between, False
        self._sets = range(len(method.settings))
        if method.is_cut(min(names["earliest"].drop_null().to_pylist())):
            self._ways = replace(ways, is_cut=True)
            running.steps = filled(self._ways)

    def serves(self, step: str) -> bool:
        """Tell whether there is such a step, and no sample of calibration is scored for it."""
        return step in self.running.steps.steps and (not self._needs_proof(step) or self._are_apart())

    def prepare(self, step: str) -> None:
        """Prove what a step needs, which is one that is served.

        Raises:
            RepeatedError: an instant occurs twice, or no vector could show it.
        """
        if self._needs_proof(step):
            self._prove()
            self.is_proven = True

    def _needs_proof(self, step: str) -> bool:
        """Tell whether a step needs a proof that is not there yet."""
        if self.is_proven:
            return False
        needed = {step.name for step in self.running.steps.needed([step])}
        # What buckets are counted from is kept; single vectors have the same proof.
        proving = (self._ways.counted, "numbered")
        return "series" in needed or any(
            {self._step(of, number) for number in self._sets} <= needed for of in proving
        )

    def _are_apart(self) -> bool:
        """Tell whether calibration ends before scoring begins, by the data; no rule requires it."""
        if self.method.is_parted:
            return True
        self._bound_edges()
        ends = ((row["calibration_end"], row["first_scored"]) for row in self._step_rows("limits"))
        return all(taught is None or taught < scored for taught, scored in ends)

    def _prove(self) -> None:
        """Make all vectors, and look whether every sample is in one and none is marked."""
        running, ways = self.running, self._ways
        step = IN_ORDER.get(ways.delays or "")
        if step is not None and self._repeats_in_order(step):
            raise RepeatedError(TWICE)
        self._bound_edges()
        limits = [{**row, "unscored_end": row["first_scored"] - 1} for row in self._step_rows("limits")]
        self._bound(TAUGHT, limits, "calibration_from", "unscored_end")
        for number in self._sets:
            bounds, *marked = (
                self._step(step, number) for step in ("bounds", *PROOFS[ways.delays], ways.taught)
            )
            running.keep(bounds)
            # A channel without a healthy range has no vector that could show anything.
            is_open = bool(running.table(bounds)["calibrated_lo"].null_count)
            if (is_open and not ways.is_collapsed) or self._is_marked(marked):
                raise RepeatedError("An instant occurs twice, or no vector could show it.")
        if ways.by_sets and self._has_large_support():
            running.steps = self._filled(replace(ways, by_sets=False))
        for number in self._sets:
            run_up, final, scored = (
                self._step(step, number) for step in ("run_up", ways.counted, SCORED)
            )
            self._bound(scored, self._step_rows(run_up), "read_from")
            if self._is_marked([final]):
                raise RepeatedError(TWICE)

    def _repeats_in_order(self, step: str) -> bool:
        """Tell whether samples in stored order show repeated instants, before there are vectors."""
        names = {name_of(row) for row in self.running.rows("channels")}
        return any(name_of(row) in names for row in self._marked(step, "asset", "channel"))

    def _is_marked(self, steps: Collection[str]) -> bool:
        """Tell whether some kept steps have a row with a mark."""
        return any(self._marked(step, "channel_id") for step in steps)

    def _marked(self, step: str, *names: str) -> list[Row]:
        self.running.keep(step)
        columns = {"names": [exp.column(name) for name in names]}
        return self.running.query_rows("census/repeated_instants", columns, {"marked": step})

    def _step(self, step: str, number: int) -> str:
        """Return what a step is called, which may be one of a set."""
        set_step = self.method.named(step, number)
        return set_step if set_step in self.running.steps.steps else step

    def _has_large_support(self) -> bool:
        """Tell whether a support has more cells than the engine looks up as a set."""
        session = self.running.session
        if session.engine.most_in_set is None:
            return False
        most = session.rows(session.engine.most_in_set)[0]["most"]
        for number in self._sets:
            self.running.keep(support := self.method.named("support", number))
            cells = exp.select(exp.Count(this=exp.Star()).as_("cells"))
            counted = session.rows(cells.from_(self.running.tables[support].copy()))
            if counted[0]["cells"] > most:
                return True
        return False

    def _step_rows(self, step: str) -> list[Row]:
        """Keep a step, and return its rows."""
        self.running.keep(step)
        return self.running.rows(step)

    def _bound_edges(self) -> None:
        """Let the readings of the edges be those between their first and their last instant."""
        if EDGES not in self.running.steps.steps:
            return
        self.running.keep("edges")
        (edge,) = self.running.query_rows("census/edge_range")
        if edge["first_time"] is not None:
            self.running.steps.replace(EDGES, self._between(edge["first_time"], edge["last_time"]))

    def _bound(self, rows: str, limits: Collection[Row], low: str, high: str | None = None) -> None:
        """Let a step of readings be bounded by the least and the greatest time of some rows."""
        if rows not in self.running.steps.steps or not limits:
            return
        latest = FAR_AHEAD if high is None else max(row[high] for row in limits)
        edges = min(row[low] for row in limits), latest
        self.running.steps.replace(rows, self._between(*edges))
