"""Random cases with programs: a column says of each row of a case what the machine runs."""

import random
from typing import Any

from hypothesis import strategies as st

from harness import ProgramRow
from strategies import Arguments, Case, cases

#: Names that a locale, or case that is not heeded, would put in another order or make one another.
TEXTS = ["B", "a", "ä", "b", "A", "10", "9"]
#: Numbers whose size is not the order of their texts.
NUMBERS = [9, 10, 100, -3, 2]

ProgramCase = tuple[list[ProgramRow], Arguments, Arguments]


@st.composite
def program_cases(draw: st.DrawFn, most: int = 5) -> ProgramCase:
    """A case whose machines run programs in turns, some of which calibration may not see."""
    case = draw(cases(most))
    return with_programs(case, random.Random(draw(st.integers(0, 2**32 - 1))))


def with_programs(case: Case, chance: random.Random) -> ProgramCase:
    """Return a case with a program for each row, in bins for which keys have room."""
    rows, parameters, calibration = case
    usual: list[Any] = chance.sample(chance.choice([TEXTS, NUMBERS]), chance.randint(1, 4))
    late = "late" if isinstance(usual[0], str) else 12
    turn, rare = chance.choice([7, 20, 60]), chance.choice([0.0, 0.03])
    found: list[ProgramRow] = []
    for asset, channel, time, value in rows:
        number = (time // turn + len(asset)) % len(usual)
        program = late if time > 45 and number == 0 else usual[number]
        if chance.random() < rare:  # nothing is told, or another program, at times of the same instant
            program = chance.choice([None, *usual])
        found.append((asset, channel, time, value, program))
    overrides = [_roomy(one) for one in parameters["overrides"]]
    return found, {**_roomy(parameters), "overrides": overrides}, calibration


def _roomy(fields: Arguments) -> Arguments:
    return {**fields, "bins": min(fields["bins"], 20_000)} if "bins" in fields else fields
