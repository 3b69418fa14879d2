"""Streams: channels that are stored in order of time are read in that order, and nothing is sorted.

This module owns when that is done for a study, and what proves that it was right: the marks that the
vectors themselves carry, and the count of the calibration samples. Where it is known that the study
scores, and calibration is a share of each channel, its vectors and the scored ones hold every row. Else
there are rows in none of them, and the order of all is proven when names are counted
(:mod:`gam_db.study.naming`).
What does not hold costs time, never a number: a study that goes on sorts.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.columns import COUNT, SHARE, columns, name_of, table_of
from gam_db.composing.pipeline import Step, filled
from gam_db.engines.session import Row
from gam_db.method import Method
from gam_db.method.bits import Bits
from gam_db.method.vectors import Stream
from gam_db.study import naming, streamed
from gam_db.study.narrowing import narrow
from gam_db.study.running import RepeatedError, Running
from gam_db.study.streamed import ChannelSlots, channel_slots, of_channel, of_each, range_of

#: The steps that streams give: the cells of calibration, block by block, and supports, then the scored
#: vectors, grouped, and one by one; since when channels stand still; or, where no vectors are asked for,
#: from where on they would be read.
LEARNING, SCORING, SINGLE = ("visits", "support"), ("visited",), ("window_counts",)
PROBING, ENDING, RUN_UP = ("probed",), ("stillness",), ("run_up",)

Make = Callable[[ChannelSlots], exp.Query]


class Streams:
    """The streams of a study whose source :func:`gam_db.study.naming.seems_ordered`.

    Args:
        method, running: of the study.
        scores: whether it is known that it scores.
        has_blocks: whether blocks of calibration may be asked for; if not, its cells alone are made.
        lacks: whether a sample is missing.
    """

    def __init__(
        self, method: Method, running: Running, scores: bool, has_blocks: bool, lacks: bool
    ) -> None:
        self.method, self.running, self.has_blocks = method, running, has_blocks
        self._streams = [
            Stream(lacks or setting.still_after is not None, gap)
            for setting, gap in zip(method.settings, method.gaps, strict=True)
        ]
        self.is_proven = not naming.vectors_prove(method, scores)
        self._sorting: dict[str, Step] = {}
        self._done: set[tuple[str, ...]] = set()
        self._reached: dict[int, dict[str, int]] = {}
        self._taught: dict[int, tuple[Stream, list[ChannelSlots]]] = {}

    @property
    def has_begun(self) -> bool:
        """Whether a step was computed."""
        return bool(self._done)

    def begin_anew(self) -> None:
        """Go on with other channels, whose steps are not there yet."""
        self._restore()  # what was given speaks of the channels before
        self._done.clear()
        self._reached = {}
        self._taught = {}

    def prepare(self, step: str) -> None:
        """Give the steps before one what streams make of them, if it needs them.

        Raises:
            RepeatedError: they are not what they should be; the steps at work are those that sort.
        """
        steps, method = self.running.steps, self.method
        giving = (
            *((LEARNING, self._learn), (PROBING, self._probe), (SCORING, self._score)),
            *((SINGLE, self._count_on), (ENDING, self._stand), (RUN_UP, self._reach_back)),
        )
        for part, give in giving:
            needed = {needed_step.name for needed_step in steps.needed([step], self.running.tables)}
            outputs = {
                method.named(name, number) for name in part for number in range(len(method.settings))
            }
            # What calibration gives is proven of all rows only when the scored ones are made, too.
            is_proof = part == SCORING and LEARNING in self._done and not self.is_proven
            is_due = part not in self._done and (is_proof or bool(needed & outputs))
            if is_due and (part == LEARNING or LEARNING in self._done):
                self._done.add(part)
                if not give():
                    self._restore()
                    raise RepeatedError("Rows are not in order, or no vector shows that they are.")

    def _learn(self) -> bool:
        """Give figures and the vectors of calibration; tell whether they are as they should be."""
        method, running = self.method, self.running
        channels = running.rows("channels")
        quotas = {
            row["channel_id"]: 0 if rule.fraction is None else int(rule.fraction * row["readings"])
            for row in channels
            if (rule := method.rules[row["calibration_no"]])
        }
        if not self.is_proven and not all(quotas.values()):
            return False  # a channel that teaches nothing is not scored, and no vector proves its order
        names = running.session.rows(running.query("names"))
        earliest = {name_of(row): row["earliest"] for row in names}
        series = []
        for row in channels:
            quota = quotas[row["channel_id"]]
            before = max(quota - self._reach(row), 0)
            first = earliest[name_of(row)]
            figures = {"samples": row["readings"], "first_time": first}
            series.append(channel_slots(row, before=before, sample_count=quota - before, **figures))
        self._give("series", partial(of_channel, "series"), series, "channel_id")
        self._replace("timeline", filled("census/trusted_timeline"), {"cohort": "channels"})
        reached = {row["channel_id"]: row["read_from"] for row in running.rows("series")}
        pieces = {row["channel_id"]: row for row in running.rows("calibration")}
        calibrated = [
            channel_slots(row, **_times(pieces[id_]), read_from=reached[id_])
            for row in channels
            if (id_ := row["channel_id"]) in pieces
        ]
        if not calibrated:
            return False
        value = self._streams[0].value
        self._give(
            "calibrated", partial(of_channel, "calibrated", value=value), calibrated, "channel_id"
        )
        seen = {row["channel_id"]: row for row in running.rows("calibrated")}
        for row in channels:
            quota, counts = quotas[row["channel_id"]], seen.get(row["channel_id"], _UNSEEN)
            context = min(self._reach(row), quota)
            if quota and (counts["calibration_samples"], counts["context_samples"]) != (quota, context):
                return False
        self._reached = {
            id_: {"read_from": time, "context_rows": seen[id_]["context_samples"]}
            for id_, time in reached.items()
            if time is not None
        }
        has_learnt = False
        for number in range(len(method.settings)):
            narrow(method, running, number, pieces, self._give)
        ranged = [self._bounds(number) for number in range(len(method.settings))]
        if not self.is_proven and sum(map(len, ranged)) < len(channels):
            return False  # nor is one whose calibration has no sample but missing ones
        for number, (setting, bounds) in enumerate(zip(method.settings, ranged, strict=True)):
            members = [row for row in channels if row["channel_id"] in bounds.keys() & seen.keys()]
            if not members:
                continue
            exact = [channel_slots(row, **range_of(bounds[row["channel_id"]])) for row in members]
            make = partial(of_channel, "exact")
            named = self.method.named("bounds", number)
            if not all(row["is_exact"] for row in self._rows_of_each(make, exact, bounds=named)):
                return False
            parts = {
                id_: channel_slots(row, **range_of(bounds[id_]), **_times(pieces[id_]))
                for row in members
                for id_ in (row["channel_id"],)
            }
            expected = {id_: max(seen[id_]["calibration_samples"] - setting.span, 0) for id_ in parts}
            drops = any(bounds[id_]["dropped_below"] + bounds[id_]["dropped_above"] for id_ in parts)
            stream = self._streams[number]._replace(drops=drops)
            if self.has_blocks:
                if not stream.is_even:
                    expected = self._counted(list(parts.values()), number, stream)
                # Without a vector there may be marked samples all the same, and a block for them.
                for row in members:
                    id_ = row["channel_id"]
                    parts[id_] |= {"support_id": row["support_id"], "vectors": max(expected[id_], 1)}
            if not self._teach(list(parts.values()), number, expected, stream):
                return False
            self._taught[number] = stream, list(parts.values())
            has_learnt = True
        return has_learnt

    def _probe(self) -> bool:
        """Compute the vectors that probe supports, if streams also give their blocks."""
        if not self.has_blocks:
            return True
        for number, (stream, cells) in self._taught.items():
            rows = self.running.rows(self.method.named("taught_before", number))
            counts = {row["channel_id"]: row for row in rows}
            parts = [
                {**part, "taught": counts[id_]["vectors"], "before": counts[id_]["vectors_before"]}
                for part in cells
                if (id_ := part["channel_id"]) in counts
            ]
            sizes, probed = (self.method.named(step, number) for step in ("block_sizes", *PROBING))
            make = partial(streamed.probed, setting=self.method.settings[number], stream=stream)
            if parts:
                self._give(probed, make, parts, block_sizes=sizes)
        return True

    def _counted(self, parts: Sequence[ChannelSlots], number: int, stream: Stream) -> dict[int, int]:
        """Return how many vectors the calibration of each channel of one set teaches."""
        make = partial(streamed.taught, setting=self.method.settings[number], stream=stream)
        rows = self._rows_of_each(make, parts)
        return {row["channel_id"]: row["vectors"] for row in rows}

    def _teach(
        self, cells: Sequence[ChannelSlots], number: int, expected: Mapping[int, int], stream: Stream
    ) -> bool:
        """Give the cells of calibration of one set; tell whether they are those of vectors in order."""
        visits, support, bounds = (
            self.method.named(step, number) for step in ("visits", "support", "bounds")
        )
        setting = self.method.settings[number]
        make = partial(streamed.visits, setting=setting, has_blocks=self.has_blocks, stream=stream)
        if not self.has_blocks:
            taught = self.method.named("taught", number)
            query = self._of_each(taught, make, cells)
            self.running.steps.put(Step.of(taught, query, "", {}))
            self._replace(support, filled("support/support"), {"learnable": taught, "bounds": bounds})
            return not self.running.largest(taught, "doubled")
        self._give(visits, make, cells, "channel_id", "support_id")
        # What is missing is so in any range.
        stands = setting.still_after is not None
        read = {"lo": 0.0, "hi": 0.0, "time_from": LONG_AGO, "time_to": FAR_AHEAD}
        mine = (row for row in self.running.rows("channels") if row["settings_no"] == number)
        lacking = [channel_slots(row, **read) for row in mine if row["missing_readings"] or stands]
        for replacement in streamed.read_off_visits(self.method, number, bool(lacking)):
            self._replace(*replacement)
        if lacking:
            missing = self.method.named("missing_vectors", number)
            make_missing = partial(
                streamed.of_vectors, "missing_vectors", setting=setting, stream=stream
            )
            self._replace(missing, self._of_each(missing, make_missing, lacking, "channel_id"))
        wanted = {id_: vectors for id_, vectors in expected.items() if vectors}
        return streamed.are_whole(self.running, visits, wanted)

    def _score(self) -> bool:
        """Compute the grouped scored vectors; tell whether their marks prove them right."""
        for number, setting in enumerate(self.method.settings):
            held, visited = (self.method.named(step, number) for step in ("support_bits", "visited"))
            self.running.keep(held)
            if not (parts := self._scored(number)):
                continue
            make = partial(
                streamed.scored, setting=setting, bits=self._bits, stream=self._streams[number]
            )
            self._give(visited, make, parts, support_bits=held)
            if self.running.largest(visited, "doubled"):
                return False
        return True

    def _count_on(self) -> bool:
        """Give the running counts of single vectors, where there is but calibration before them."""
        begun = [row["earliest"] for row in self.running.rows("names") if row["earliest"] is not None]
        if self.method.is_cut(min(begun)):
            return True
        for number, setting in enumerate(self.method.settings):
            held, counts = (self.method.named(step, number) for step in ("support_bits", *SINGLE))
            if parts := self._scored(number):
                stream = self._streams[number]
                make = partial(streamed.window_counts, setting=setting, bits=self._bits, stream=stream)
                self._replace(counts, self._of_each(counts, make, parts, support_bits=held))
        return True

    def _stand(self) -> bool:
        """Give since when channels stand still."""
        for number, setting in enumerate(self.method.settings):
            (stillness,) = (self.method.named(step, number) for step in ENDING)
            if setting.still_after is not None and (parts := self._scored(number)):
                stream = self._streams[number]
                make = partial(streamed.still_since, setting=setting, stream=stream)
                self._replace(stillness, self._of_each(stillness, make, parts))
        return True

    @property
    def _bits(self) -> Bits:
        """The form in which supports are stored."""
        bits = self.running.session.engine.bits
        assert bits is not None
        return bits

    def _scored(self, number: int) -> list[ChannelSlots]:
        """Return the slots of the channels of one set that are scored."""
        bounds = self._bounds(number)
        members = {row["channel_id"]: row for row in self.running.rows("channels")}
        return [
            channel_slots(
                members[id_],
                **range_of(bounds[id_]),
                support_id=members[id_]["support_id"],
                time_from=row["read_from"],
                time_to=FAR_AHEAD,
                first_scored=bounds[id_]["first_scored"],
                context_rows=row["context_rows"],
            )
            for row in self._run_up([members[id_] for id_ in members if id_ in bounds], number, bounds)
            for id_ in (row["channel_id"],)
        ]

    def _reach_back(self) -> bool:
        """Give the run-up of all channels."""
        channels = self.running.rows("channels")
        for number in range(len(self.method.settings)):
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds]
            run_up = table_of(self._run_up(members, number, bounds), _RUN_UP)
            self.running.load(self.method.named("run_up", number), run_up)
        return True

    def _run_up(self, members: Sequence[Row], number: int, bounds: Mapping[int, Row]) -> list[Row]:
        """Return the run-up of some channels: from calibration, else by a query."""
        span = self.method.settings[number].reach
        learnt = self._reached if span else {}
        reached = dict(learnt)
        unknown = [row for row in members if row["channel_id"] not in learnt]
        if unknown:
            slots = [
                channel_slots(row, first_scored=bounds[row["channel_id"]]["first_scored"])
                for row in unknown
            ]
            for row in self._rows_of_each(partial(of_channel, "run_up", span=span), slots):
                first = bounds[row["channel_id"]]["first_scored"]
                read_from = first if row["earliest"] is None else row["earliest"]
                begin = {"read_from": read_from, "context_rows": row["context_rows"]}
                reached[row["channel_id"]] = begin
        return [
            {
                "channel_id": id_,
                **range_of(bounds[id_]),
                **reached[id_],
                "complete": int(row["missing_readings"] == 0),
            }
            for row in members
            for id_ in (row["channel_id"],)
        ]

    def _bounds(self, number: int) -> dict[int, Row]:
        """Return the bounds of the channels of a set that have a range."""
        rows = self.running.rows(self.method.named("bounds", number))
        return {row["channel_id"]: row for row in rows if row["calibrated_lo"] is not None}

    def _reach(self, row: Row) -> int:
        """Return how many samples of calibration the first scored vector of a channel reaches, or 1."""
        return max(self.method.settings[row["settings_no"]].reach, 1)

    def _of_each(
        self, step: str, make: Make, channels: Sequence[ChannelSlots], *labels: str, **tables: str
    ) -> exp.Query:
        """Return the queries for each of some channels."""
        return of_each(self.running, step, make, channels, tables, labels)

    def _rows_of_each(self, make: Make, channels: Sequence[ChannelSlots], **tables: str) -> list[Row]:
        """Ask it."""
        query = self._of_each("asked", make, channels, "channel_id", **tables)
        return self.running.session.rows(query)

    def _give(
        self, step: str, make: Make, channels: Sequence[ChannelSlots], *labels: str, **tables: str
    ) -> None:
        """Keep the results of a query over some channels as a step, instead of its former table."""
        self._replace(step, self._of_each(step, make, channels, *labels, **tables))
        self.running.forget(but=self.running.tables.keys() - {step})
        self.running.keep(step)

    def _replace(self, step: str, query: exp.Query, tables: Mapping[str, str] | None = None) -> None:
        self._sorting.setdefault(step, self.running.steps.replace(step, query, tables))

    def _restore(self) -> None:
        """Let the steps be those that sort."""
        for step in self._sorting.values():
            self.running.steps.put(step)
        self._sorting.clear()


_UNSEEN = {"calibration_samples": 0, "context_samples": 0}

_RUN_UP = columns((COUNT, "channel_id"), (SHARE, "lo hi"), (COUNT, "read_from context_rows complete"))


def _times(piece: Row) -> dict[str, int]:
    return {name: piece[name] for name in ("time_from", "time_to")}
