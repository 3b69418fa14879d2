"""Parameters of the method, and overrides for some assets or channels.

This module owns what a parameter may be. It knows no SQL and no source.
"""

import dataclasses
import math
import numbers
import operator
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import SupportsIndex, cast

from gam_db.clock import Length, TimeKind, length, looks_like_calendar
from gam_db.errors import ParameterError

LARGEST_BINS = 2**31
LONGEST_STRIDE = 100
"""Vectors of a bucket at most, where nothing is asked for."""

LARGEST_KEY = 2**63 - 1


class _Keep:
    """The value of an override that leaves a parameter as it is."""

    def __repr__(self) -> str:
        return "KEEP"


KEEP = _Keep()


@dataclass(frozen=True)
class Override:
    """Other parameters for the channels that a pattern names.

    In a pattern ``*`` stands for any text and ``?`` for one character; everything else is meant as
    written. The first override that matches a channel is the one that applies.

    Attributes:
        asset, channel: patterns; both must match.
        m, tau, bins, window, stride, max_gap, target_floor: as in :class:`Parameters`; what is not
            given stays as it is.
    """

    asset: str = "*"
    channel: str = "*"
    m: int | _Keep = KEEP
    tau: int | _Keep = KEEP
    bins: int | _Keep = KEEP
    window: int | _Keep = KEEP
    stride: int | None | _Keep = KEEP
    max_gap: Length | None | _Keep = KEEP
    target_floor: float | _Keep = KEEP

    def changes(self) -> dict[str, object]:
        """Return the parameters that this override changes."""
        given = {
            field.name: getattr(self, field.name)
            for field in dataclasses.fields(self)
            if field.name not in ("asset", "channel")
        }
        return {name: value for name, value in given.items() if not isinstance(value, _Keep)}


@dataclass(frozen=True)
class Parameters:
    """The parameters of Discrete Support Estimation (method, sections 1 and 3).

    Attributes:
        m: embedding dimension, at least 1.
        tau: delay in samples, at least 1.
        bins: bins per axis (the paper's B), 1 to 2^31; (bins + 3)^m must fit in 63 bits.
        window: scored vectors in the moving average (the paper's W), at least 1.
        stride: scored vectors per bucket; divides the window; default gcd(window, 100).
        max_gap: longest step in time inside a segment; counter steps, or seconds, a timedelta or a
            text such as "5 s" where the source has timestamps; None (the paper) means no limit.
        target_floor: the healthy HI that calibration may have to be called ready.
        overrides: other parameters for some assets or channels; the first that matches applies.

    Raises:
        ParameterError: a value is out of its range.
    """

    m: int = 3
    tau: int = 1
    bins: int = 100
    window: int = 5000
    stride: int | None = None
    max_gap: Length | None = None
    target_floor: float = 0.05
    overrides: Sequence[Override] = ()

    def __post_init__(self) -> None:
        for name in ("m", "tau", "bins", "window"):
            object.__setattr__(self, name, _at_least_one(name, getattr(self, name)))
        if self.bins > LARGEST_BINS:
            raise ParameterError(f"bins is {self.bins}; it must not exceed 2^31.")
        if (self.m - 1) * self.tau >= 2**31 or self.window >= 2**31:
            raise ParameterError("(m - 1) * tau and window must stay below 2^31 samples.")
        if self.m > 63 or self.radix**self.m > LARGEST_KEY:
            fitting = max(m for m in range(1, 64) if self.radix**m <= LARGEST_KEY)
            raise ParameterError(
                f"bins = {self.bins} with m = {self.m} needs (bins + 3)^m cell keys, more than 63 "
                f"bits hold; take m <= {fitting}, or fewer bins."
            )
        if self.stride is None:
            object.__setattr__(self, "stride", math.gcd(self.window, LONGEST_STRIDE))
        else:
            object.__setattr__(self, "stride", _at_least_one("stride", self.stride))
            if self.window % self.bucket_length:
                raise ParameterError(
                    f"stride is {self.stride}, which does not divide window = {self.window}."
                )
        if isinstance(self.target_floor, bool) or not isinstance(self.target_floor, (int, float)):
            raise ParameterError(f"target_floor is {self.target_floor!r}; give a share, e.g. 0.05.")
        if not 0 <= self.target_floor <= 1:
            raise ParameterError(f"target_floor is {self.target_floor}; it is a share, 0 to 1.")
        if self.max_gap is not None:
            _check_gap(self.max_gap)
        if not isinstance(self.overrides, Iterable):
            raise ParameterError(
                f"overrides is a {type(self.overrides).__name__}; it takes a list of gam_db.Override."
            )
        object.__setattr__(self, "overrides", tuple(self.overrides))
        for override in self.overrides:
            if not isinstance(override, Override):
                raise ParameterError(
                    f"overrides holds a {type(override).__name__}; it takes gam_db.Override."
                )
            for role in ("asset", "channel"):
                if not isinstance(getattr(override, role), str):
                    raise ParameterError(
                        f"The {role} of an override is {getattr(override, role)!r}; it takes a pattern, "
                        "as text."
                    )
            self.changed_by(override)

    @property
    def radix(self) -> int:
        """R = bins + 3, the codes a sample can have (method, section 3)."""
        return self.bins + 3

    @property
    def span(self) -> int:
        """(m - 1) * tau, the samples between the oldest and the newest of a vector."""
        return (self.m - 1) * self.tau

    @property
    def bucket_length(self) -> int:
        """The stride, resolved."""
        return math.gcd(self.window, LONGEST_STRIDE) if self.stride is None else self.stride

    def changed_by(self, override: Override) -> "Parameters":
        """Return these parameters with one override applied and none left.

        Raises:
            ParameterError: the result is out of range; the message names the override.
        """
        changes = override.changes()
        if "window" in changes and "stride" not in changes:
            changes["stride"] = None
        try:
            return dataclasses.replace(self, overrides=(), **changes)  # type: ignore[arg-type]
        except ParameterError as error:
            raise ParameterError(
                f"In the override for {override.asset!r} / {override.channel!r}: {error}"
            ) from error

    def variants(self) -> "list[Parameters]":
        """Return the sets of parameters: the general one, then one per override."""
        general = dataclasses.replace(self, overrides=())
        return [general, *(self.changed_by(override) for override in self.overrides)]


def pattern_matches(pattern: str, name: str) -> bool:
    """Tell whether a pattern (``*`` any text, ``?`` one character, else literal) names ``name``."""
    parts = (".*" if sign == "*" else "." if sign == "?" else re.escape(sign) for sign in pattern)
    return re.fullmatch("".join(parts), name, re.DOTALL) is not None


def _check_gap(gap: object) -> None:
    if isinstance(gap, numbers.Real) and not isinstance(gap, bool):
        positive = float(gap) > 0
    elif isinstance(gap, str) or looks_like_calendar(gap):
        kind = TimeKind.TIMESTAMP if looks_like_calendar(gap) else TimeKind.COUNTER
        positive = length(gap, kind, "max_gap") > 0
    else:
        raise ParameterError(f"max_gap is {gap!r}; give a number, a timedelta or a text such as '5 s'.")
    if not positive:
        raise ParameterError(f"max_gap is {gap!r}; it must be positive, or None.")


def _at_least_one(name: str, value: object) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        whole = operator.index(cast(SupportsIndex, value))
    except TypeError:
        raise ParameterError(f"{name} is {value!r}; it must be an integer.") from None
    if whole < 1:
        raise ParameterError(f"{name} is {whole}; it must be at least 1.")
    return whole
