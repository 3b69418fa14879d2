"""Programs: the cycle of moves that a robot repeats, and the stretches of time that come of it."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

WORKING, STANDING, SWITCHED_OFF = 0, 1, 2
"""State of a stretch: moving or waiting; stopped with constant rows; stopped without rows."""

_MOVES = (5, 9)
_MOVE_SECONDS = (1.0, 8.0)
_JITTER = 0.05  # of a move's duration, per cycle
_IDLE_SECONDS = (0.4, 4.0)  # shortest, mean beyond it
_RARE_EVERY = (200, 1000)  # cycles
_RARE_FIRST = (20, 100)  # cycles; it belongs to health, so it is there from the beginning
_STOPS = (4, 6)
_STOP_SECONDS = (120.0, 7200.0)


@dataclass(frozen=True)
class Program:
    """A cycle of moves.

    Attributes:
        durations: seconds of each regular move; the rare move and the wait follow as further moves.
        rare_every: cycles from one rare move to the next, on average.
        rare_first: the cycle of the first one.
        rare_seconds: its duration.
    """

    durations: NDArray[np.float64]
    rare_every: int
    rare_first: int
    rare_seconds: float

    @property
    def moves(self) -> int:
        """How many moves there are, the rare one and the wait among them."""
        return len(self.durations) + 2


@dataclass(frozen=True)
class Timeline:
    """What a robot does when.

    Attributes:
        ends: seconds at which each stretch ends, ascending.
        moves: number of the move of each stretch.
        states: WORKING, STANDING or SWITCHED_OFF.
    """

    ends: NDArray[np.float64]
    moves: NDArray[np.int64]
    states: NDArray[np.int64]

    def before(self, seconds: float) -> "Timeline":
        """Return the part before an instant."""
        count = int(np.searchsorted(self.ends, seconds)) + 1
        ends = np.minimum(self.ends[:count], seconds)
        return Timeline(ends, self.moves[:count], self.states[:count])

    def then(self, other: "Timeline", moves: int) -> "Timeline":
        """Return this timeline and another one after it, whose moves are numbered from ``moves`` on."""
        return Timeline(
            np.concatenate([self.ends, self.ends[-1] + other.ends]),
            np.concatenate([self.moves, moves + other.moves]),
            np.concatenate([self.states, other.states]),
        )


def drawn_program(random: np.random.Generator) -> Program:
    """Draw a program: 5 to 9 moves of 1 to 8 s, and one that occurs once in 200 to 1000 cycles."""
    moves = int(random.integers(_MOVES[0], _MOVES[1] + 1))
    return Program(
        durations=random.uniform(*_MOVE_SECONDS, moves),
        rare_every=int(random.integers(_RARE_EVERY[0], _RARE_EVERY[1] + 1)),
        rare_first=int(random.integers(_RARE_FIRST[0], _RARE_FIRST[1] + 1)),
        rare_seconds=float(random.uniform(*_MOVE_SECONDS)),
    )


def drawn_timeline(
    program: Program, random: np.random.Generator, seconds: float, stops: bool = True
) -> Timeline:
    """Draw what a robot that repeats a program does for at least the given time.

    Durations vary by 5 % per cycle, waits of random length shift the phase, and a few stops of minutes
    to hours (at most an eighth of the time) interrupt it, unless there are to be none: in turn with
    constant rows and without rows.
    """
    moves = len(program.durations)
    cycles = math.ceil(seconds / ((1 - _JITTER) * program.durations.sum())) + 1
    # A row per cycle: its moves, the rare move, the wait, a stop; what does not occur takes no time.
    lasting = np.zeros((cycles, moves + 3))
    lasting[:, :moves] = program.durations * random.uniform(1 - _JITTER, 1 + _JITTER, (cycles, moves))
    gaps = random.uniform(0.8, 1.2, 2 + cycles // _RARE_EVERY[0]) * program.rare_every
    rare = program.rare_first + np.concatenate([[0], np.cumsum(gaps)]).astype(np.int64)
    lasting[rare[rare < cycles], moves] = program.rare_seconds
    lasting[:, moves + 1] = _IDLE_SECONDS[0] + random.exponential(_IDLE_SECONDS[1], cycles)

    run = max(1, int(seconds / (program.durations.sum() + sum(_IDLE_SECONDS))))
    count = min(run, int(random.integers(_STOPS[0], _STOPS[1] + 1))) if stops else 0
    stopped = np.sort(random.choice(run, count, replace=False))
    shortest, longest = min(_STOP_SECONDS[0], seconds / 40), min(_STOP_SECONDS[1], seconds / 8)
    lasting[stopped, moves + 2] = np.exp(random.uniform(math.log(shortest), math.log(longest), count))

    states = np.full(lasting.shape, WORKING)
    states[stopped, moves + 2] = np.where(
        (np.arange(count) + random.integers(2)) % 2, STANDING, SWITCHED_OFF
    )
    # A robot that is stopped stands as it does while it waits.
    numbers = np.tile([*range(moves + 2), moves + 1], (cycles, 1))
    occurs = lasting.ravel() > 0
    return Timeline(np.cumsum(lasting.ravel())[occurs], numbers.ravel()[occurs], states.ravel()[occurs])
