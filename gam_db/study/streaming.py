"""Streams: channels that are stored in order of time are read in that order, and nothing is sorted.

This module owns when that is done for a study, a guess by a glance at some rows, and what proves that it
was right: the marks that the vectors themselves carry, and the count of the calibration samples. Where
it is known that the study scores, and calibration is a share of each channel, its vectors and the scored
ones hold every row. Else there are rows in none of them, and the step *ordered* proves the order of all.
What does not hold costs time, never a number: the study goes on with the steps that sort.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from sqlglot import exp

from gam_db.clock import FAR_AHEAD, LONG_AGO
from gam_db.composing import template
from gam_db.composing.pipeline import Step, filled
from gam_db.method import Method
from gam_db.method.bits import Bits
from gam_db.method.scoring import visited_slots
from gam_db.method.slots import block_no, coordinates
from gam_db.method.vectors import is_outside, stream_slots
from gam_db.settings.parameters import Parameters
from gam_db.study.running import Running

#: Rows that are glanced at to guess whether channels lie one after another.
GLANCE = 10_000

#: Readings of a channel, on the average, from which on a part of a statement for each is worth its time.
STREAMED_FROM = 50_000

#: Channels of one statement.
MOST_CHANNELS = 256

#: The steps that streams give: the cells of calibration, block by block, and supports, then the scored
#: vectors, grouped, or, where none are asked for, from where on they would be read.
LEARNING, SCORING, RUN_UP = ("visits", "support"), ("visited",), ("run_up",)

Row = dict[str, Any]
Slots = dict[str, template.Slot]


def seems_ordered(method: Method, running: Running, scores: bool) -> bool:
    """Tell whether the first rows are of two channels at most, where the engine keeps their order.

    If so, *names* will prove it of all of them, unless the vectors do: where it is known that the study
    ``scores``, and no row is before calibration.
    """
    bits = running.session.engine.bits
    if bits is None or not _is_plain(method, bits):
        return False
    if running.session.fetch(running.query("glance")).num_rows > 2:
        return False
    if not scores or any(rule.fraction is None for rule in method.rules):
        running.keep("ordered")
        running.put("names", exp.select("*").from_(running.placed["ordered"].copy()))
    return True


def _is_plain(method: Method, bits: Bits) -> bool:
    """Tell whether no segment ends, and calibration is one interval: what streams serve."""
    whole = ((LONG_AGO, FAR_AHEAD),)
    has_bits = all(
        method.is_short(number) and bits.serve(setting.radix**setting.m)
        for number, setting in enumerate(method.settings)
    )
    return has_bits and all(
        len(rule.allowed) <= 1 and (rule.fraction is None or tuple(rule.allowed) == whole)
        for rule in method.rules
    )


class Streams:
    """The streams of a study whose source :func:`seems_ordered`.

    Args:
        method: of the study.
        running: its steps at work.
        has_blocks: whether blocks of calibration may be asked for; if not, its cells alone are made.
    """

    def __init__(self, method: Method, running: Running, has_blocks: bool = True) -> None:
        self.method, self.running, self.has_blocks = method, running, has_blocks
        self.holds = True
        self._threads = running.session.threads()
        self._sorting: dict[str, Step] = {}
        self._done: set[tuple[str, ...]] = set()
        self._reached: dict[int, dict[str, int]] = {}

    @property
    def holds_so_far(self) -> bool:
        """Tell whether a step was given, and nothing spoke against it."""
        return self.holds and bool(self._done)

    def serve(self) -> bool:
        """Tell whether no channel lacks a sample, they are long enough, and seem to be in order."""
        names = self.running.rows("names")
        readings = sum(row["readings"] for row in names)
        is_long = 0 < len(names) <= MOST_CHANNELS and readings >= STREAMED_FROM * len(names)
        if not is_long or any(row["missing_readings"] for row in names):
            return False
        if "ordered" in self.running.placed:
            return all(row["in_order"] for row in self.running.rows("ordered"))
        # A source in order of time may begin with what only one or two channels sent.
        steps = self.running.steps.copied()
        steps.fill("halfway", "streams/glance", {"rows": GLANCE, "skip": readings // 2})
        found = self.running.session.rows(steps.query("halfway", self.running.placed))
        return len(found) <= 2

    def begin_anew(self) -> None:
        """Go on with other channels, whose steps are not there yet."""
        self._done.clear()
        self._reached = {}

    def prepare(self, step: str) -> None:
        """Give the steps before one what streams make of them, if it needs them."""
        steps, method = self.running.steps, self.method
        giving = (LEARNING, self._learn), (SCORING, self._score), (RUN_UP, self._reach_back)
        for part, give in giving:
            needed = {one.name for one in steps.needed([step], self.running.placed)}
            own = {method.named(one, number) for one in part for number in range(len(method.settings))}
            # What calibration gives is proven of all rows only when the scored ones are made, too.
            is_proof = (
                part == SCORING and LEARNING in self._done and "ordered" not in self.running.placed
            )
            asked = part not in self._done and (is_proof or bool(needed & own))
            if self.holds and asked and (part == LEARNING or LEARNING in self._done):
                self._done.add(part)
                self.holds = give()
                if not self.holds:
                    self._give_up()

    def _learn(self) -> bool:
        """Give the timeline and the vectors of calibration; tell whether they are as they should be."""
        method, running = self.method, self.running
        channels = running.rows("channels")
        quotas = {
            row["channel_id"]: 0 if rule.fraction is None else int(rule.fraction * row["readings"])
            for row in channels
            if (rule := method.rules[row["calibration_no"]])
        }
        if "ordered" not in running.placed and not all(quotas.values()):
            return False  # a channel that teaches nothing is not scored, and no vector proves its order
        names = running.session.rows(running.query("names"))
        earliest = {(row["asset"], row["channel"]): row["earliest"] for row in names}
        timeline = []
        for row in channels:
            quota = quotas[row["channel_id"]]
            before = max(quota - self._reach(row), 0)
            first = earliest[row["asset"], row["channel"]]
            asked: Slots = {"before": before, "samples": quota - before, "first_time": first}
            timeline.append(of_channel("timeline", row, **asked))
        self._give("timeline", timeline)
        reached = {row["channel_id"]: row["read_from"] for row in running.rows("timeline")}
        pieces = {row["channel_id"]: row for row in running.rows("calibration")}
        calibrated = [
            of_channel("calibrated", row, **_times(pieces[id_]), read_from=reached[id_])
            for row in channels
            if (id_ := row["channel_id"]) in pieces
        ]
        if not calibrated:
            return False
        self._give("calibrated", calibrated)
        seen = {row["channel_id"]: row for row in running.rows("calibrated")}
        for row in channels:
            quota, found = quotas[row["channel_id"]], seen.get(row["channel_id"], _UNSEEN)
            context = min(self._reach(row), quota)
            if quota and (found["calibration_samples"], found["context_samples"]) != (quota, context):
                return False
        self._reached = {
            id_: {"read_from": time, "context_rows": seen[id_]["context_samples"]}
            for id_, time in reached.items()
            if time is not None
        }
        has_learnt = False
        for number, setting in enumerate(method.settings):
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds.keys() & pieces.keys()]
            exact = [of_channel("exact", row, **_range(bounds[row["channel_id"]])) for row in members]
            if not members:
                continue
            if not all(row["is_exact"] for row in self._asked(exact, number)):
                return False
            cells, expected = [], {}
            for row in members:
                piece = pieces[row["channel_id"]]
                times = piece["time_from"], piece["time_to"]
                vectors = _vectors(row, setting, _range(bounds[row["channel_id"]]), *times)
                samples = seen[row["channel_id"]]["calibration_samples"]
                expected[row["channel_id"]] = found = max(samples - setting.span, 0)
                cells.append(self._cells(row, setting, vectors, found))
            if not self._teach(cells, number, expected):
                return False
            has_learnt = True
        return has_learnt

    def _cells(self, row: Row, setting: Parameters, vectors: exp.Query, found: int) -> exp.Query:
        """Return the cells of the calibration of one channel, which has ``found`` vectors."""
        slots: Slots = {"channel_id": row["channel_id"], "span": setting.span}
        if not self.has_blocks:
            learnable = _over("streams/learnable", slots, "streamed", vectors)
            return _over("census/taught", {}, "learnable", learnable)
        # Without a vector there may be marked samples all the same, and a block for them to be in.
        block = block_no(setting, max(found, 1))
        slots |= {"support_id": row["support_id"], "block_no": block}
        return _over("streams/visits", slots, "streamed", vectors)

    def _teach(self, cells: Sequence[exp.Query], number: int, expected: Mapping[int, int]) -> bool:
        """Give the cells of calibration of one set; tell whether they are those of vectors in order."""
        visits, missing, support, bounds = (
            self.method.named(step, number)
            for step in ("visits", "missing_vectors", "support", "bounds")
        )
        if not self.has_blocks:
            taught = self.method.named("taught", number)
            query = stacked(cells, self._threads)
            self.running.steps.put(Step.of(taught, query, "", {"readings": "readings"}))
            self._replace(support, filled("support/support"), {"learnable": taught, "bounds": bounds})
            return not self.running.largest(taught, "doubled")
        self._give(visits, cells)
        self._replace(support, filled("support/support"), {"learnable": visits, "bounds": bounds})
        self._replace(missing, filled("certificate/missing_vectors"), {"vectors": visits})
        steps = self.running.steps.copied()
        steps.add("visited_vectors", filled("streams/visited_vectors"), tables={"visits": visits})
        rows = self.running.session.rows(steps.query("visited_vectors", self.running.placed))
        found = {row["channel_id"]: row["vectors"] for row in rows}
        is_marked = any(row["doubled"] for row in rows)
        return not is_marked and found == {id_: vectors for id_, vectors in expected.items() if vectors}

    def _score(self) -> bool:
        """Give the scored vectors, grouped; tell whether they are what they should be."""
        method, running, bits = self.method, self.running, self.running.session.engine.bits
        assert bits is not None
        channels = running.rows("channels")
        for number, setting in enumerate(method.settings):
            held, visited = (method.named(step, number) for step in ("support_bits", "visited"))
            running.keep(held)
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds]
            if not members:
                continue
            if setting.span:
                starts = {id_: of["read_from"] for id_, of in self._reached.items()}
            else:
                starts = {id_: of["first_scored"] for id_, of in bounds.items()}
            unknown = [row for row in members if row["channel_id"] not in starts]
            looked_for = self._run_up(unknown, number, bounds)
            found = self._asked(looked_for, number) if looked_for else []
            starts |= {row["channel_id"]: row["read_from"] for row in found}
            parts = [
                scored(row, setting, bits, _range(bounds[id_]), starts[id_], FAR_AHEAD)
                for row in members
                for id_ in (row["channel_id"],)
            ]
            self._give(visited, parts, {"support_bits": held})
            if running.largest(visited, "doubled"):
                return False
        return True

    def _reach_back(self) -> bool:
        """Give the run-up of all channels."""
        channels = self.running.rows("channels")
        for number in range(len(self.method.settings)):
            bounds = self._bounds(number)
            members = [row for row in channels if row["channel_id"] in bounds]
            if members:
                self._give(self.method.named("run_up", number), self._run_up(members, number, bounds))
        return True

    def _run_up(self, members: Sequence[Row], number: int, bounds: Mapping[int, Row]) -> list[exp.Query]:
        """Return the run-up of each of some channels: what calibration has found of it, or a look."""
        span = self.method.settings[number].span
        asked = []
        for row in members:
            of, reached = bounds[row["channel_id"]], self._reached.get(row["channel_id"])
            if span and reached:
                asked.append(of_channel("reached", row, **_range(of), **reached))
            else:
                slots = {"first_scored": of["first_scored"], "span": span}
                asked.append(of_channel("run_up", row, **_range(of), **slots))
        return asked

    def _bounds(self, number: int) -> dict[int, Row]:
        """Return the bounds of the channels of a set that have a range."""
        rows = self.running.rows(self.method.named("bounds", number))
        return {row["channel_id"]: row for row in rows if row["calibrated_lo"] is not None}

    def _reach(self, row: Row) -> int:
        """Return how many samples of calibration the first scored vector of a channel reaches, or 1."""
        return max(self.method.settings[row["settings_no"]].span, 1)

    def _asked(self, queries: Sequence[exp.Query], number: int) -> list[Row]:
        """Ask what speaks of a channel each in one statement."""
        steps = self.running.steps.copied()
        steps.add(
            "asked",
            stacked(queries, self._threads),
            tables={"bounds": self.method.named("bounds", number)},
        )
        return self.running.session.rows(steps.query("asked", self.running.placed))

    def _give(
        self, step: str, parts: Sequence[exp.Query], tables: Mapping[str, str] | None = None
    ) -> None:
        """Keep what speaks of a channel each as a step, in the place of what it was."""
        self._replace(step, stacked(parts, self._threads), tables)
        self.running.keep(step)

    def _replace(self, step: str, query: exp.Query, tables: Mapping[str, str] | None = None) -> None:
        self._sorting.setdefault(step, self.running.steps.replace(step, query, tables))

    def _give_up(self) -> None:
        """Let the study begin anew with the steps that sort."""
        for step in self._sorting.values():
            self.running.steps.put(step)
        self.running.forget(but=("names", "ordered", "readings", "channels"))


def of_channel(file: str, row: Row, **slots: template.Slot) -> exp.Query:
    """Return a file of ``sql/streams`` that speaks of one channel."""
    own = {"channel_id": row["channel_id"], **_names(row)}
    asked = template.load(f"streams/{file}").slots
    return filled(f"streams/{file}", {**{name: own[name] for name in own.keys() & asked}, **slots})


def scored(
    row: Row,
    setting: Parameters,
    bits: Bits,
    ends_of_range: Mapping[str, float],
    time_from: int,
    time_to: int,
    ends: Mapping[str, str] | None = None,
) -> exp.Query:
    """Return the scored vectors of one channel, grouped: the step *visited*.

    Args:
        row: the channel, with its support.
        setting: its parameters.
        bits: how its support is kept, in the step *support_bits*.
        ends_of_range: its calibrated ``lo`` and ``hi``.
        time_from: the first instant that is read.
        time_to: the last one.
        ends: see :func:`gam_db.method.scoring.add_buckets`.
    """
    slots: Slots = {
        **{name: row[name] for name in ("channel_id", "support_id")},
        "before": setting.span,
        "is_held": bits.held(exp.column("bits"), exp.column("cell_key")),
        "carried": [*coordinates(setting), *map(exp.column, ends or ())],
    }
    vectors = _vectors(row, setting, ends_of_range, time_from, time_to, bool(ends))
    placed = _over("streams/placed", slots, "streamed", vectors)
    grouped = visited_slots(setting, ends, trusting=True) | {"outside": is_outside(setting)}
    return _over("health/visited", grouped, "placed", placed)


def _vectors(
    row: Row,
    setting: Parameters,
    ends_of_range: Mapping[str, float],
    time_from: int,
    time_to: int,
    has_context: bool = False,
) -> exp.Query:
    """Return the vectors of one channel over what is read of it."""
    read: Slots = {"time_from": time_from, "time_to": time_to}
    return of_channel("vectors", row, **ends_of_range, **read, **stream_slots(setting, has_context))


def _over(path: str, slots: Slots, name: str, rows: exp.Query) -> exp.Query:
    """Return a file of ``sql/`` that reads the rows of a query where it has a name for them."""
    query = filled(path, slots)
    (read,) = (table for table in query.find_all(exp.Table) if table.name == name)
    read.replace(rows.subquery(read.alias_or_name, copy=False))
    return query


def _names(row: Row) -> Slots:
    return {name: template.text(row[name]) for name in ("asset", "channel")}


def _range(bounds: Row) -> dict[str, float]:
    return {name: bounds[f"calibrated_{name}"] for name in ("lo", "hi")}


def _times(piece: Row) -> dict[str, int]:
    return {name: piece[name] for name in ("time_from", "time_to")}


def stacked(queries: Sequence[exp.Query], threads: int) -> exp.Query:
    """Return the rows of several queries, which DuckDB works on side by side if it has several threads.

    It does so with entries of a WITH list that it is to keep, each a copy. The parts of a UNION it takes
    one after another, wherever one of them alone has rows for all threads.
    """
    first, *others = queries
    if not others:
        return first
    if threads == 1:
        return exp.union(*queries, distinct=False, copy=False)
    names = [exp.to_identifier(f"gam_part_{number}") for number in range(len(queries))]
    parts = [
        exp.CTE(this=query, alias=exp.TableAlias(this=name), materialized=True)
        for name, query in zip(names, queries, strict=True)
    ]
    columns = [exp.column(name) for name in first.named_selects]
    rows = [exp.select(*columns).from_(exp.Table(this=name.copy())) for name in names]
    union = exp.union(*rows, distinct=False, copy=False)
    union.set("with_", exp.With(expressions=parts))
    return union


_UNSEEN = {"calibration_samples": 0, "context_samples": 0}
