"""What a selection looks for, and how far it looks.

This module owns the options of a selection and their ranges. It knows no SQL and no source.
"""

from dataclasses import dataclass

from gam_db.errors import ParameterError
from gam_db.settings.setting import COUNT, check, declared, one_of, setting

#: The rules for tau, in the order in which they are tried.
TAU_RULES = ("first_minimum", "acf_1e", "acf_zero")

LARGEST_LAG = 10_000
LARGEST_DIMENSION = 12
MOST_REFERENCES = 2**14
"""Beyond this a sum of Cao's ratios would not fit in 64 bits."""


@declared
@dataclass(frozen=True)
class Search:
    """How parameters are looked for (method, section 8).

    Raises:
        ParameterError: a value is out of its range.
    """

    tau: int | None = setting(
        *(None, COUNT, "take this delay, in samples"), usual="chosen", most=LARGEST_LAG
    )
    tau_by: str = setting(
        *(TAU_RULES[0], one_of(*TAU_RULES), "first rule to try for the delay"),
        more="the later ones follow",
    )
    tau_max: int = setting(
        *(100, COUNT, "largest delay looked at, in samples"),
        more="never beyond a tenth of them",
        most=LARGEST_LAG,
    )
    m_max: int = setting(
        6, COUNT, "largest embedding dimension looked at", least=2, most=LARGEST_DIMENSION
    )
    theiler: int | None = setting(
        *(None, COUNT, "samples within which vectors are no neighbours"),
        usual="the larger of (d - 1) tau and the first lag with an autocorrelation below 1/e",
        least=0,
        most=2**31,
    )
    references: int = setting(
        *(2000, COUNT, "vectors whose neighbours are looked for, in each channel and dimension"),
        most=MOST_REFERENCES,
    )
    seed: int = setting(0, COUNT, "of their sample", usual="0", least=0, most=2**31 - 1)
    ami_bins: int = setting(
        *(16, COUNT, "equal bins of mutual information, a power of two"), least=2, most=128
    )

    def __post_init__(self) -> None:
        check(self)
        if self.ami_bins & (self.ami_bins - 1):
            raise ParameterError(f"ami_bins is {self.ami_bins}; it takes a power of two.")
