"""Turning: the calibration of channels that take turns as rows are stored, where nothing is sorted.

This module owns when that is done for who asks for calibration alone, which proves nothing of the rows
after it: the order of all rows is proven first, as their times are looked at. The vectors carry the
marks of :mod:`gam_db.study.rounds` as well. What does not hold costs time, never a number: the study
goes on with the steps that sort.
"""

from collections.abc import Mapping, Sequence

import pyarrow as pa
from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import name_of, table_of
from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, Step
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.adding import OfSet, add
from gam_db.method.delays import CALIBRATION, Ways, add_delays
from gam_db.method.slots import block_no
from gam_db.study import rounds
from gam_db.study.repeating import TIMELINE
from gam_db.study.running import Between, Running
from gam_db.study.streamed import are_whole, range_of, read_off_visits

#: Readings of a source from which on a look at their order is worth its time.
TURNED_FROM = 100_000


class Turns:
    """The turns of channels, of a study that looks before it trusts; it has the step *names*."""

    def __init__(self, method: Method, running: Running, between: Between) -> None:
        self.method, self.running, self._between = method, running, between
        self.holds, self._has_learnt, self._round = True, False, 0
        self._timeline: dict[tuple[str, str], Row] = {}
        self._sorting: dict[str, Step] = {}

    def serve(self, names: pa.Table) -> bool:
        """Tell whether the method is served, and all rows are proven to be in turn."""
        rows, counted = names.to_pylist(), set(names["readings"].to_pylist())
        lacks = any(row["missing_readings"] or row["without_time"] for row in rows)
        if lacks or len(counted) != 1 or not _is_plain(self.method):
            return False
        running, self._round = self.running, len(rows)
        if not rounds.seem_to_be(running, self._round, self.method.settings):
            return False
        (readings,), fraction = counted, self.method.rules[0].fraction
        steps = self._steps(running.steps.steps["readings"].query)
        quota = 0 if fraction is None else int(fraction * readings)
        add(steps, "rounds/places", {"round": self._round, "rows": self._round})
        add(steps, "rounds/timeline", {"quota": quota})
        channels = running.rows("channels")
        looked = {row["channel_id"]: row for row in self._asked(steps, channels, "timeline")}
        self._timeline = {name_of(row): {**looked[row["channel_id"]], "repeats": 0} for row in channels}
        return all(row["misplaced"] == 0 for row in looked.values())

    def begin_anew(self) -> None:
        """Go on with other channels, whose steps are not there yet."""
        self._has_learnt = False
        for step in self._sorting.values():
            self.running.steps.put(step)
        self._sorting.clear()

    def prepare(self, step: str) -> None:
        """Give the steps before one what turns make of them, if it needs them."""
        running = self.running
        needed = {one.name for one in running.steps.needed([step], running.placed)}
        if self.holds and "timeline" in needed:
            timeline = [
                {**self._timeline[name_of(row)], "channel_id": row["channel_id"]}
                for row in running.rows("channels")
            ]
            running.load("timeline", table_of(timeline, TIMELINE))
        if self.holds and not self._has_learnt and needed & {"visits", "support"}:
            self._has_learnt = True
            self.holds = self._learn()
            if not self.holds:
                self.begin_anew()
                running.forget(but=("names", "readings"))

    def _learn(self) -> bool:
        """Give the visits of calibration; tell whether they are those of vectors in turn."""
        running, setting = self.running, self.method.settings[0]
        ranges, pieces, seen = (
            {row["channel_id"]: row for row in running.rows(step)}
            for step in ("bounds", "calibration", "calibrated")
        )
        channels = [
            {
                **row,
                "taught_from": piece["time_from"],
                "taught_to": piece["time_to"],
                **range_of(ranges[id_]),
            }
            for row in running.rows("channels")
            if (piece := pieces.get(id_ := row["channel_id"])) and id_ in seen
        ]
        samples = {seen[row["channel_id"]]["calibration_samples"] for row in channels}
        if len(channels) != len(ranges) or len(samples) != 1:
            return False
        vectors = max(min(samples) - setting.span, 0)
        edges = min(row["taught_from"] for row in channels), max(row["taught_to"] for row in channels)
        steps = self._steps(self._between(*edges))
        one = OfSet(steps, self.method, 0)
        add_delays(one, CALIBRATION, Ways(round=self._round), "readings", has_bits=False)
        block = block_no(setting, template.node_of(max(vectors, 1)))
        one.add("rounds/visits", {"block_no": block}, tables={"vectors": f"{CALIBRATION}vectors"})
        scale = table_of([{**row, "complete": 1} for row in channels], rounds.SCALE)
        with (
            running.session.lent(scale) as lent,
            Running(running.session, steps, {"scale": lent}) as own,
        ):
            self._replace("visits", own.query("visits"))
            running.keep("visits")
        for made in read_off_visits(self.method, 0):
            self._replace(*made)
        expected = {row["channel_id"]: vectors for row in channels if vectors}
        return are_whole(running, "visits", expected)

    def _asked(self, steps: Pipeline, channels: Sequence[Row], step: str) -> list[Row]:
        """Return the rows of a step that speaks of channels by their places in a round."""
        with (
            self.running.session.lent(table_of(channels, rounds.SCALE)) as lent,
            Running(self.running.session, steps, {"scale": lent}) as own,
        ):
            return own.rows(step)

    def _steps(self, rows: exp.Query) -> Pipeline:
        """Return the steps to *rounds*, over some readings."""
        steps = Pipeline(small=frozenset(("turns", "rounds")))
        steps.add("readings", rows.copy())
        add(steps, "rounds/turns", {"round": self._round})
        add(steps, "rounds/rounds", {"before": 0, "after": 0, "sharp": 0})
        return steps

    def _replace(self, step: str, query: exp.Query, tables: Mapping[str, str] | None = None) -> None:
        self._sorting[step] = self.running.steps.replace(step, query.copy(), tables)


def _is_plain(method: Method) -> bool:
    """Tell whether no segment ends, and calibration is one interval, the same for all channels."""
    (rule, *others), whole = method.rules, ((LONG_AGO, FAR_AHEAD),)
    is_one = rule.fraction is None or tuple(rule.allowed) == whole
    alike = not others and len(method.settings) == 1 and method.is_unbroken(0)
    return alike and is_one and len(rule.allowed) <= 1
