"""Counting: what is said of whole channels is read off a census, where nothing else is asked for.

This module owns what becomes of such a study (of ``gam check``): it takes it on trust that no instant
occurs twice. Whoever puts the samples in order sees whether that was right, and has the steps that look
first go on if not (:meth:`Counts.look_first`).
"""

from collections.abc import Callable, Collection

from gam_db.columns import table_of
from gam_db.composing.pipeline import Pipeline
from gam_db.method.census import EDGES
from gam_db.study.narrowing import narrow
from gam_db.study.repeating import TIMELINE
from gam_db.study.running import Between, Running


class Counts:
    """The trust of a study of whole channels, whose *names* are counted by slices.

    What is ``careful`` gives the steps that look first.
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

    def look_first(self, repeating: Collection[int]) -> None:
        """Let the steps that look first go on with what is proven: where an instant occurs twice."""
        self.prepare("series")
        rows = self.running.rows("series")
        self.running.forget(but=("names", "readings"))
        self.running.steps = self._careful()
        timeline = [{**row, "repeats": int(row["channel_id"] in repeating)} for row in rows]
        self.running.load("timeline", table_of(timeline, TIMELINE))
