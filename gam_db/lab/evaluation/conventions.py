"""Conventions: which form of a metric is meant, and how chance and spread are sampled.

This module owns their names and ranges. It computes nothing.
"""

from dataclasses import dataclass
from typing import Literal

from gam_db.arguments import public
from gam_db.errors import ParameterError, nearest

Monotonicity = Literal["rank", "sign"]
Amplitude = Literal["range", "ends"]

MONOTONICITIES = ("rank", "sign")
AMPLITUDES = ("range", "ends")

MOST_SAMPLES = 100_000


@public
@dataclass(frozen=True)
class Conventions:
    """What is left open by the names of the metrics (method, section 9).

    Attributes:
        monotonicity: "rank", Spearman's correlation with time, ties averaged (Eq. 5), or "sign", rises
            less falls over their number.
        amplitude: of Eq. 8 and 9: "range", highest less lowest value, or "ends", last less first.
        ddof: 0 or 1, taken from the number of values under every standard deviation.
        surrogates: series of random novelty per channel that the chance level is the mean of; 0 for
            none.
        samples: bootstrap samples of the assets; 0 for none.
        confidence: share of the samples inside an interval.
        seed: of surrogates and samples.
        values_per_window: consecutive values of a series that one window spans; None to read it off
            the table, which tells it of health indicators that are counts.
        stride: of a table that gam run wrote with a row per vector, every so many-th value is taken,
            as it writes them at bucket ends; 1 takes all, None takes its own default, gcd(window,
            100). Other tables are taken as they are.

    Raises:
        ParameterError: one of them is out of its range.
    """

    monotonicity: str = "rank"
    amplitude: str = "range"
    ddof: int = 0
    surrogates: int = 20
    samples: int = 1000
    confidence: float = 0.95
    seed: int = 0
    values_per_window: int | None = None
    stride: int | None = 1

    def __post_init__(self) -> None:
        _check_choice("monotonicity", self.monotonicity, MONOTONICITIES)
        _check_choice("amplitude", self.amplitude, AMPLITUDES)
        _check_whole("ddof", self.ddof, 0, 1)
        _check_whole("surrogates", self.surrogates, 0, MOST_SAMPLES)
        _check_whole("samples", self.samples, 0, MOST_SAMPLES)
        _check_whole("seed", self.seed, 0, 2**63 - 1)
        if self.stride is not None:
            _check_whole("stride", self.stride, 1, 2**31)
        if self.values_per_window is not None:
            _check_whole("values_per_window", self.values_per_window, 1, 2**31)
        if not (isinstance(self.confidence, float) and 0 < self.confidence < 1):
            raise ParameterError(
                f"confidence is {self.confidence!r}; it takes a share between 0 and 1, such as 0.95."
            )


def _check_choice(name: str, value: object, choices: tuple[str, ...]) -> None:
    if value not in choices:
        hint = nearest(value, choices) if isinstance(value, str) else "."
        raise ParameterError(f"{name} is {value!r}; it takes {' or '.join(map(repr, choices))}{hint}")


def _check_whole(name: str, value: object, least: int, most: int) -> None:
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise ParameterError(f"{name} is {value!r}; it takes a whole number from {least} to {most}.")
