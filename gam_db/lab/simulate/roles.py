"""Roles: what becomes of each robot of a fleet. They repeat, drawn anew, every two dozen robots."""

from dataclasses import dataclass

import numpy as np

from gam_db.lab.simulate.seeds import Purpose, stream

JOINTS = 6
GROUP = 24
"""Robots of one pattern: 21 that stand for the paper's, and three controls."""

REPROGRAMMED, REZEROED, PAYLOAD = 22, 23, 24
"""Places of the controls: a change without any fault."""

FAULTS = ("friction", "backlash", "transients")
GROWTHS = ("linear", "exponential", "steps")

_FAILURES = 5
_TWINS = 4


@dataclass(frozen=True)
class Role:
    """What becomes of one robot.

    Attributes:
        kind: healthy, failed, reprogrammed, rezeroed or payload.
        program: number of the robot whose program it runs; twins share one.
        joint: the joint that fails or is re-zeroed, if any.
        fault, growth: of a failed robot: one of FAULTS, one of GROWTHS.
        silent, constant: a joint that stops reporting, one that never moves, if any.
    """

    kind: str
    program: int
    joint: int | None = None
    fault: str | None = None
    growth: str | None = None
    silent: int | None = None
    constant: int | None = None


def role_of(seed: int, robot: int) -> Role:
    """Return the role of a robot (counted from 1) in the fleet of a seed.

    Of every four of the first twenty robots of a group one fails, so that small fleets have failures.
    """
    group, place = (robot - 1) // GROUP, (robot - 1) % GROUP + 1
    random = stream(seed, 0, group, Purpose.ROLES)
    failing = 4 * np.arange(_FAILURES) + random.integers(1, 5, _FAILURES)
    faults, growths = (_each_at_least_once(random, names) for names in (FAULTS, GROWTHS))
    twins = np.sort(random.choice(21, _TWINS, replace=False)) + 1
    sound = np.setdiff1d(np.arange(1, 22), failing)
    silent, constant = random.choice(sound, 2, replace=False)
    joints = random.integers(1, JOINTS + 1, GROUP + 1)

    first_twin = group * GROUP + int(twins[0])
    program = first_twin if place in twins else robot
    joint = int(joints[place])
    if place in failing:
        number = int(np.flatnonzero(failing == place)[0])
        return Role("failed", program, joint, faults[number], growths[number])
    if place == REZEROED:
        return Role("rezeroed", program, joint)
    if place in (REPROGRAMMED, PAYLOAD):
        return Role("reprogrammed" if place == REPROGRAMMED else "payload", program)
    return Role(
        "healthy",
        program,
        silent=joint if place == silent else None,
        constant=joint if place == constant else None,
    )


def _each_at_least_once(random: np.random.Generator, names: tuple[str, ...]) -> list[str]:
    drawn = [*names, *random.choice(names, _FAILURES - len(names))]
    return [str(name) for name in random.permutation(drawn)]
