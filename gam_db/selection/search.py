"""What a selection looks for, and how far it looks.

This module owns the options of a selection and their ranges. It knows no SQL and no source.
"""

from dataclasses import dataclass

from gam_db.arguments import public
from gam_db.errors import ParameterError
from gam_db.settings.setting import COUNT, check, choice_of, declared, setting

#: The rules for tau, in the order in which they are tried.
TAU_RULES = ("first_minimum", "acf_1e", "acf_zero")

LARGEST_LAG = 10_000
LARGEST_DIMENSION = 12
MOST_REFERENCES = 2**14
"""Beyond this a sum of Cao's ratios would not fit in 64 bits."""


@public
@declared
@dataclass(frozen=True)
class Search:
    """Settings of the search for parameters (method, section 8).

    Raises:
        ParameterError: a value is out of its range.
    """

    tau: int | None = setting(None, COUNT, most=LARGEST_LAG)
    tau_by: str = setting(TAU_RULES[0], choice_of(*TAU_RULES))
    tau_max: int = setting(100, COUNT, most=LARGEST_LAG)
    m_max: int = setting(6, COUNT, least=2, most=LARGEST_DIMENSION)
    theiler: int | None = setting(None, COUNT, least=0, most=2**31)
    references: int = setting(2000, COUNT, most=MOST_REFERENCES)
    seed: int = setting(0, COUNT, least=0, most=2**31 - 1)
    ami_bins: int = setting(16, COUNT, least=2, most=128)

    def __post_init__(self) -> None:
        check(self)
        if self.ami_bins & (self.ami_bins - 1):
            raise ParameterError(f"ami_bins is {self.ami_bins}; it takes a power of two.")
