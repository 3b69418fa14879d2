"""What a selection looks for, and how far it looks.

This module owns the options of a selection and their ranges. It knows no SQL and no source.
"""

import operator
from dataclasses import dataclass

from gam_db.errors import ParameterError, nearest

#: The rules for tau, in the order in which they are tried.
TAU_RULES = ("first_minimum", "acf_1e", "acf_zero")

LARGEST_LAG = 10_000
LARGEST_DIMENSION = 12
MOST_REFERENCES = 2**14
"""Beyond this a sum of Cao's ratios would not fit in 64 bits."""


@dataclass(frozen=True)
class Search:
    """How parameters are looked for (method, section 8).

    Attributes:
        tau: a delay that is given, in samples; None chooses one.
        tau_by: the first rule to try: "first_minimum", "acf_1e" or "acf_zero"; the later ones follow.
        tau_max: the largest lag of mutual information, in samples; never beyond a tenth of them.
        m_max: the largest embedding dimension looked at, at least 2.
        theiler: samples within which vectors are no neighbours; None takes the larger of (d - 1) tau
            and the first lag with an autocorrelation below 1/e.
        references: vectors whose neighbours are looked for, in each channel and dimension.
        seed: of their sample, 0 to 2^31 - 1.
        ami_bins: equal bins of mutual information, a power of two up to 128.

    Raises:
        ParameterError: a value is out of its range.
    """

    tau: int | None = None
    tau_by: str = "first_minimum"
    tau_max: int = 100
    m_max: int = 6
    theiler: int | None = None
    references: int = 2000
    seed: int = 0
    ami_bins: int = 16

    def __post_init__(self) -> None:
        if self.tau_by not in TAU_RULES:
            raise ParameterError(f"tau_by is {self.tau_by!r}{nearest(str(self.tau_by), TAU_RULES)}")
        for name, least, most in (
            ("tau", 1, LARGEST_LAG),
            ("tau_max", 1, LARGEST_LAG),
            ("m_max", 2, LARGEST_DIMENSION),
            ("theiler", 0, 2**31),
            ("references", 1, MOST_REFERENCES),
            ("seed", 0, 2**31 - 1),
            ("ami_bins", 2, 128),
        ):
            value = getattr(self, name)
            if value is None and name in ("tau", "theiler"):
                continue
            try:
                whole = None if isinstance(value, bool) else operator.index(value)
            except TypeError:
                whole = None
            if whole is None or not least <= whole <= most:
                raise ParameterError(f"{name} is {value!r}; it takes an integer, {least} to {most}.")
            object.__setattr__(self, name, whole)
        if self.ami_bins & (self.ami_bins - 1):
            raise ParameterError(f"ami_bins is {self.ami_bins}; it takes a power of two.")
