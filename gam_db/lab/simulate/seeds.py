"""Seeds: one stream of random numbers for each purpose of each joint of each robot of a fleet.

So any robot can be made alone, and a change of one part leaves all others as they were.
"""

from enum import IntEnum

import numpy as np

#: The robot itself, in the place of a joint's number.
WHOLE_ROBOT = 0


class Purpose(IntEnum):
    """What a stream of random numbers is for."""

    ROLES = 1
    PROGRAM = 2
    TIMELINE = 3
    LEVELS = 4
    SCALE = 5
    SIGNAL = 6
    EVENT = 7
    DIRT = 8
    WANDER = 9
    SHIFTS = 10


def stream(seed: int, robot: int, joint: int, purpose: Purpose) -> np.random.Generator:
    """Return the random numbers of one purpose of one joint (or of the robot: joint 0)."""
    return np.random.default_rng([seed, robot, joint, int(purpose)])
