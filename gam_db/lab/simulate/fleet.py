"""A fleet: the readings of any robot of it, and the truth about them."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.errors import ParameterError
from gam_db.lab.simulate.dirt import Rows, dirtied
from gam_db.lab.simulate.joint import (
    HERTZ,
    Levels,
    drawn_levels,
    drawn_noise,
    drawn_scale,
    drifting,
    followed,
    measured,
    reporting,
    sampled,
    twin_offset,
    wandering,
)
from gam_db.lab.simulate.program import Program, Timeline, drawn_program, drawn_timeline
from gam_db.lab.simulate.roles import GROUP, JOINTS, Role, role_of
from gam_db.lab.simulate.seeds import WHOLE_ROBOT, Purpose, stream
from gam_db.lab.simulate.wear import grown, shown

SAMPLES = 300_000
FEWEST_SAMPLES = 2_000
MOST_PRODUCTS = 20
FIRST_TIME = 1_704_067_200_000_000
"""Microseconds: 1 January 2024, UTC."""

READINGS = pa.schema(
    {
        "asset": pa.string(),
        "channel": pa.string(),
        "time": pa.timestamp("us", "UTC"),
        "value": pa.float64(),
    }
)
TRUTH = pa.schema(
    {
        "asset": pa.string(),
        "channel": pa.string(),
        "kind": pa.string(),
        "program": pa.string(),
        "event": pa.string(),
        "growth": pa.string(),
        "amplitude": pa.float64(),
        "onset": pa.timestamp("us", "UTC"),
        "failed_at": pa.timestamp("us", "UTC"),
        "null_rows": pa.int64(),
        "nan_rows": pa.int64(),
        "repeated_rows": pa.int64(),
        "late_rows": pa.int64(),
    }
)

_LIFE = (0.7, 1.0)  # of a robot that fails, as a share of the others'
_ONSET = (0.4, 0.7)  # of its life
_REPROGRAMMED_AT = 0.6
_CHANGED_AT = (0.5, 0.7)  # re-zeroed, new payload
_SILENT_FROM = (0.5, 0.8)
_AMPLITUDE = (0.02, 0.08)  # of the joint's range, at the failure
_REZEROED_BY = (0.03, 0.08)  # of the joint's range
_PAYLOAD = (1.05, 1.2)  # gain
_WANDERING = 0.6  # standard deviations of a level
_SHIFTS = 30  # of a recording, where a fleet makes several products


@dataclass(frozen=True)
class Joint:
    """One joint of one robot.

    Attributes:
        readings: asset, channel, time, value; in the order of arrival.
        truth: one row of the truth table (see TRUTH).
    """

    readings: pa.Table
    truth: dict[str, Any]


@dataclass(frozen=True)
class Fleet:
    """A simulated fleet.

    Robots are numbered from 1. Every two dozen have five that fail, sixteen healthy ones and three
    controls: reprogrammed, re-zeroed, and with a new payload. Any robot is the same whether it is made
    alone or with the others, and whatever their number.

    Args:
        seed: of everything; not negative.
        samples: instants per joint at 5 Hz, at least 2,000; robots that fail end earlier, and while a
            robot is switched off there are no rows.
        wander: samples in which a drift of 0.6 standard deviations of a level forgets where it was; 0
            for no such drift.
        shift: samples of a shift; in every other one a robot makes another product. 0 for one product,
            or, with several products, a thirtieth of the samples.
        products: how many products a robot makes, each by a program of its own. The product of a shift
            is drawn: each one half as often as the one before. The readings then say in a column
            *product* which one it is. 1 for no such column.

    Raises:
        ParameterError: seed, samples or products are out of range.
    """

    seed: int = 0
    samples: int = SAMPLES
    wander: float = 0.0
    shift: int = 0
    products: int = 1

    def __post_init__(self) -> None:
        if self.seed < 0:
            raise ParameterError(f"seed is {self.seed}; it takes 0 or more.")
        if self.samples < FEWEST_SAMPLES:
            raise ParameterError(f"samples is {self.samples}; a fleet takes at least {FEWEST_SAMPLES}.")
        if not 1 <= self.products <= MOST_PRODUCTS:
            raise ParameterError(f"products is {self.products}; it takes 1 to {MOST_PRODUCTS}.")

    @property
    def shift_length(self) -> int:
        """How many samples a shift has; all of them where there is one product."""
        return self.shift or self.samples // (_SHIFTS if self.products > 1 else 1)

    @property
    def schema(self) -> pa.Schema:
        """The columns of the readings."""
        return READINGS if self.products == 1 else READINGS.append(pa.field("product", pa.string()))

    def robot(self, number: int) -> Iterator[Joint]:
        """Yield the joints of a robot, one after another.

        Raises:
            ParameterError: number is below 1.
        """
        robot = self._robot(number)
        for joint in range(1, JOINTS + 1):
            yield robot.joint(joint)

    def joint(self, number: int, joint: int) -> Joint:
        """Return one joint of a robot, the same as among the others.

        Raises:
            ParameterError: number is below 1.
        """
        return self._robot(number).joint(joint)

    def _robot(self, number: int) -> "_Robot":
        if number < 1:
            raise ParameterError(f"Robot {number} is asked for; robots are numbered from 1.")
        return _Robot(self, number, role_of(self.seed, number))


class _Robot:
    """What the joints of a robot share: its role, its life, its programs and what it does when."""

    def __init__(self, fleet: Fleet, number: int, role: Role) -> None:
        self._fleet, self._number, self._role = fleet, number, role
        self.name = f"robot_{number:02d}"
        events = stream(fleet.seed, number, WHOLE_ROBOT, Purpose.EVENT)
        failed = role.kind == "failed"
        life = fleet.samples / HERTZ
        self._seconds = life * float(events.uniform(*_LIFE)) if failed else life
        self._onset = self._seconds * {
            "failed": float(events.uniform(*_ONSET)),
            "reprogrammed": _REPROGRAMMED_AT,
        }.get(role.kind, float(events.uniform(*_CHANGED_AT)))
        self._gain = float(events.uniform(*_PAYLOAD))
        self._repeats, self._late = events.integers(1, JOINTS + 1, 2)
        self._programs, self._timeline = self._worked()
        self._others: list[tuple[Program, Timeline]] = []
        self._products = np.zeros(1, np.int64)  # number of the product of each shift
        has_products = fleet.products > 1
        if fleet.shift or has_products:
            shifts = stream(fleet.seed, number, WHOLE_ROBOT, Purpose.SHIFTS)
            for _ in range(max(1, fleet.products - 1)):
                program = drawn_program(shifts)
                other = drawn_timeline(program, shifts, self._seconds + 1, stops=False)
                self._others.append((program, other))
            self._products = np.arange(fleet.samples // fleet.shift_length + 2) % 2
            if has_products:
                shares = 0.5 ** np.arange(fleet.products)
                drawn = shifts.choice(fleet.products, len(self._products), p=shares / shares.sum())
                self._products = drawn

    def joint(self, joint: int) -> Joint:
        """Return a joint: its readings and the truth about them."""
        seed, number, role = self._fleet.seed, self._number, self._role
        parts = self._levels(joint)
        levels = reduce(Levels.then, parts)
        scale_stream = stream(seed, number, joint, Purpose.SCALE)
        noise = drawn_noise(levels, scale_stream)
        shared = stream(seed, role.program, joint, Purpose.SCALE)
        scale = drawn_scale(noise, shared)
        seconds = np.arange(int(self._seconds * HERTZ)) / HERTZ + scale.clock
        moves, states = sampled(self._timeline, seconds)
        times = FIRST_TIME + np.round(seconds * 1e6).astype(np.int64)
        products = self._product_at(times)
        ways = [moves, *(sampled(timeline, seconds)[0] for _, timeline in self._others)]
        firsts = np.cumsum([0, *(len(part.places) for part in parts[:-1])])
        moves = np.choose(products, [way + first for way, first in zip(ways, firsts, strict=True)])

        signal = stream(seed, number, joint, Purpose.SIGNAL)
        heights = followed(levels, moves, signal) + (
            0.0 if number == role.program else twin_offset(scale_stream)
        )
        heights += noise[levels.places[moves]] * signal.standard_normal(len(moves))
        heights += drifting(scale, seconds)
        if self._fleet.wander:
            chance = stream(seed, number, joint, Purpose.WANDER)
            wide = _WANDERING * float(np.median(noise))
            heights += wandering(wide, self._fleet.wander, len(heights), chance)
        event = stream(seed, number, joint, Purpose.EVENT)
        truth = self._happened(joint, event)
        onset = self._onset
        if truth["event"] == "silent":
            onset = self._seconds * float(event.uniform(*_SILENT_FROM))

        def worn(fault: str, size: NDArray[np.float64]) -> NDArray[np.float64]:
            """Return how the fault shows: where products are told apart, in the moves of each one."""
            if self._fleet.products == 1:
                return shown(fault, size, moves, levels.places, event)
            each = zip(ways, parts, strict=True)
            return np.choose(
                products, [shown(fault, size, way, part.places, event) for way, part in each]
            )

        height = float(np.ptp(levels.heights))
        heights = self._changed(heights, truth, seconds - onset, height, worn, event)

        values = measured(scale, heights, states)
        if truth["event"] == "constant":
            values = np.full_like(values, values[0])
        is_reported = reporting(states)
        if truth["event"] == "silent":
            is_reported &= seconds < onset
        dirt = stream(seed, number, joint, Purpose.DIRT)
        rows = dirtied(
            times[is_reported], values[is_reported], dirt, joint == self._repeats, joint == self._late
        )
        if truth["event"] not in (None, "constant"):
            truth["onset"] = FIRST_TIME + int(onset * 1e6)
        if truth["event"] == role.fault and role.fault is not None:
            truth["failed_at"] = int(times[-1])
        readings = _readings(self.name, f"joint_{joint}", rows)
        if self._fleet.products > 1:
            names = pa.array([f"product_{n}" for n in range(1, self._fleet.products + 1)])
            column = names.take(pa.array(self._product_at(rows.times)))
            readings = readings.append_column(self._fleet.schema.field("product"), column)
        return Joint(readings, truth | _dirt_of(rows))

    def _product_at(self, times: NDArray[np.int64]) -> NDArray[np.int64]:
        """Return the number of the product that is made at each time, in microseconds."""
        shifts = (times - FIRST_TIME) * HERTZ // (self._fleet.shift_length * 1_000_000)
        return np.asarray(self._products[shifts])

    def _worked(self) -> tuple[list[Program], Timeline]:
        """Return the programs of the robot, one after another, and what it did when."""
        seed, number = self._fleet.seed, self._number
        random = stream(seed, self._role.program, WHOLE_ROBOT, Purpose.PROGRAM)
        first = drawn_program(random)
        doing = stream(seed, number, WHOLE_ROBOT, Purpose.TIMELINE)
        # One second more, since the clocks of the joints lag by less than that.
        timeline = drawn_timeline(first, doing, self._seconds + 1)
        if self._role.kind != "reprogrammed":
            return [first], timeline
        second = drawn_program(random)
        after = drawn_timeline(second, doing, self._seconds - self._onset + 1)
        return [first, second], timeline.before(self._onset).then(after, first.moves)

    def _levels(self, joint: int) -> list[Levels]:
        """Return the levels that a joint visits for each product."""
        random = stream(self._fleet.seed, self._role.program, joint, Purpose.LEVELS)
        first = reduce(Levels.then, [drawn_levels(program, random) for program in self._programs])
        return [first, *(drawn_levels(program, random) for program, _ in self._others)]

    def _happened(self, joint: int, random: np.random.Generator) -> dict[str, Any]:
        """Return the row of the truth table, still without onset, failure and dirt."""
        role = self._role
        event, amplitude = None, None
        if role.silent == joint or role.constant == joint:
            event = "silent" if role.silent == joint else "constant"
        elif role.kind == "failed" and role.joint == joint:
            event, amplitude = role.fault, float(random.uniform(*_AMPLITUDE))
        elif role.kind == "rezeroed" and role.joint == joint:
            event, amplitude = role.kind, float(random.uniform(*_REZEROED_BY))
        elif role.kind in ("reprogrammed", "payload"):
            event, amplitude = role.kind, self._gain - 1 if role.kind == "payload" else None
        return {
            "asset": self.name,
            "channel": f"joint_{joint}",
            "kind": role.kind,
            "program": f"program_{role.program:02d}",
            "event": event,
            "growth": role.growth if event is not None and event == role.fault else None,
            "amplitude": amplitude,
            "onset": None,
            "failed_at": None,
        }

    def _changed(
        self,
        heights: NDArray[np.float64],
        truth: dict[str, Any],
        since: NDArray[np.float64],
        full_range: float,
        worn: Callable[[str, NDArray[np.float64]], NDArray[np.float64]],
        random: np.random.Generator,
    ) -> NDArray[np.float64]:
        """Return the heights with what happened to the joint, ``since`` seconds after its onset."""
        event = truth["event"]
        if event == "payload":
            return np.asarray(np.where(since < 0, heights, self._gain * heights))
        if event == "rezeroed":
            return np.asarray(np.where(since < 0, heights, heights + truth["amplitude"] * full_range))
        if event is None or truth["growth"] is None:
            return heights
        size = grown(truth["growth"], since / (self._seconds - self._onset), random)
        return np.asarray(heights + truth["amplitude"] * full_range * worn(event, size))


def _readings(asset: str, channel: str, rows: Rows) -> pa.Table:
    count = len(rows.times)
    return pa.table(
        [
            pa.array([asset]).take(pa.array(np.zeros(count, np.int64))),
            pa.array([channel]).take(pa.array(np.zeros(count, np.int64))),
            pa.array(rows.times).cast(pa.timestamp("us", "UTC")),
            # Not from_pandas: NaN and NULL are both sent, and both are to be met.
            pa.array(rows.values, mask=rows.null),
        ],
        schema=READINGS,
    )


def _dirt_of(rows: Rows) -> dict[str, int]:
    return {
        "null_rows": int(rows.null.sum()),
        "nan_rows": int(np.isnan(rows.values).sum()),
        "repeated_rows": rows.repeated,
        "late_rows": rows.late,
    }


def robots_of(robots: int) -> range:
    """Return the numbers of the first robots of a fleet.

    Raises:
        ParameterError: there is none.
    """
    if robots < 1:
        raise ParameterError(f"robots is {robots}; a fleet has at least 1, by default {GROUP}.")
    return range(1, robots + 1)
