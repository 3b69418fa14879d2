"""Parameters of the method, and overrides for some assets or channels.

This module owns the bounds of parameters. It contains no SQL and reads no source.
"""

import dataclasses
import math
import numbers
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, ClassVar, TypeAlias

from gam_db.arguments import public
from gam_db.clock import Length, TimeKind, length, looks_like_calendar
from gam_db.errors import ConfigurationError, ParameterError, nearest, wrong
from gam_db.settings.setting import (
    COUNT,
    LENGTH,
    SHARE,
    Kind,
    Setting,
    check,
    choice_of,
    declared,
    number,
    setting,
    settings_of,
)

LARGEST_BINS = 2**31
LONGEST_STRIDE = 100
"""Most vectors of a bucket by default."""

LARGEST_KEY = 2**63 - 1

LEAST_VECTORS = 400
"""Least vectors of calibration for a meaningful floor: docs/decisions.md has the figures."""

ROBUST, MIN_MAX = RANGES = ("robust", "min_max")
"""The values of the calibrated range: all but a few far from the rest, or all (the paper)."""

AUTO = "auto"
RUNGS = (128, 64, 32, 16, 8)
"""Grids to choose from where bins is "auto". Each is half of the one before, and for powers of two a
grid of so many bins equals that rung of the ladder bit by bit; fewer tell little but high from low."""


@dataclass(frozen=True, init=False)
class Override:
    """Other parameters for the channels that a pattern names.

    In a pattern ``*`` stands for any text and ``?`` for one character; all other characters stand
    for themselves. The first override that matches a channel is the one that applies.

    Args:
        asset, channel: patterns; both must match.
        changes: parameters by name, as in :class:`Parameters`; what is not given stays as it is.

    Raises:
        ParameterError: there is no such parameter.
    """

    asset: str
    channel: str
    changed: tuple[tuple[str, Any], ...]

    def __init__(self, asset: str = "*", channel: str = "*", **changes: Any) -> None:
        settings = settings_of(Parameters)
        for name in changes:
            if name not in settings:
                raise ParameterError(f"There is no parameter {name!r}{nearest(name, settings)}")
        object.__setattr__(self, "asset", asset)
        object.__setattr__(self, "channel", channel)
        object.__setattr__(self, "changed", tuple(sorted(changes.items())))

    def changes(self) -> dict[str, Any]:
        """Return the parameters that this override changes."""
        return dict(self.changed)

    def names(self, asset: str, channel: str) -> bool:
        """Tell whether its patterns name a channel."""
        return pattern_matches(self.asset, asset) and pattern_matches(self.channel, channel)


def _count_or_auto(of: Setting, name: str, value: Any) -> Any:
    if isinstance(value, str) and value != AUTO:
        raise ParameterError(f"{name} is {value!r}; it takes an integer, or {AUTO!r}.")
    return value if value == AUTO else COUNT.checked(of, name, value)


def _read_count_or_auto(option: str, text: str) -> Any:
    count = number(text)
    if isinstance(count, int) or count == AUTO:
        return count
    raise ConfigurationError(f"{option} is {text!r}; it takes an integer, or {AUTO!r}.")


_COUNT_OR_AUTO = Kind(_count_or_auto, str, _read_count_or_auto, "INTEGER|auto")

#: Settings that calibration may choose.
OPENABLE = ("tau", "bins", "window")

Open: TypeAlias = Any
"""An integer, or "auto": see :attr:`Parameters.is_open`."""


def _positive(of: Setting, name: str, gap: Any) -> Any:
    LENGTH.checked(of, name, gap)
    if isinstance(gap, numbers.Real):
        is_positive = float(gap) > 0
    else:
        kind = TimeKind.TIMESTAMP if looks_like_calendar(gap) else TimeKind.COUNTER
        is_positive = length(gap, kind, name) > 0
    if not is_positive:
        raise ParameterError(f"{name} is {gap!r}; it must be positive, or None.")
    return gap


@public
@declared
@dataclass(frozen=True)
class Parameters:
    """The parameters of Discrete Support Estimation (method, sections 1 and 3).

    (bins + 3)^m must fit in 63 bits. Where the source has timestamps, ``max_gap`` may be a timedelta,
    too; None (the paper) means no limit.

    Attributes:
        overrides: other parameters for some assets or channels; the first that matches applies.

    Raises:
        ParameterError: a value is out of its range.
    """

    m: int = setting(3, COUNT)
    tau: Open = setting(AUTO, _COUNT_OR_AUTO, more=f"{AUTO!r}: calibration chooses one")
    bins: Open = setting(
        AUTO,
        _COUNT_OR_AUTO,
        more=f"{AUTO!r}: calibration chooses one of {', '.join(map(str, RUNGS))} for each channel or "
        "pool, and freezes it with the version",
        most=LARGEST_BINS,
    )
    window: Open = setting(AUTO, _COUNT_OR_AUTO, more=f"{AUTO!r}: a twentieth of calibration")
    stride: int | None = setting(None, COUNT)
    max_gap: Length | None = setting(None, dataclasses.replace(LENGTH, checked=_positive))
    still_after: int | None = setting(None, COUNT, least=2)
    range: str = setting(ROBUST, choice_of(*RANGES))
    target_floor: float = setting(0.05, SHARE)
    least_vectors: int = setting(LEAST_VECTORS, COUNT)
    overrides: Sequence[Override] = ()

    PAPER: ClassVar[Mapping[str, Any]] = MappingProxyType(
        {"m": 3, "tau": 1, "bins": 100, "window": 5000, "stride": None, "range": MIN_MAX}
    )
    """The settings of the paper."""

    def __post_init__(self) -> None:
        check(self)
        tau, window = (1 if count == AUTO else count for count in (self.tau, self.window))
        if (self.m - 1) * tau >= 2**31 or window >= 2**31:
            raise ParameterError("(m - 1) * tau and window must stay below 2^31 samples.")
        if self.m > 63 or self.radix**self.m > LARGEST_KEY:
            fitting = max(m for m in range(1, 64) if self.radix**m <= LARGEST_KEY)
            raise wrong("too_many_cells", grid=self.grid, m=self.m, fitting=fitting)
        if self.window != AUTO:
            object.__setattr__(self, "stride", self.bucket_length)
            if self.window % self.bucket_length:
                raise wrong("stride_divides", stride=self.stride, window=self.window)
        if not isinstance(self.overrides, Iterable):
            raise wrong("overrides_of_parameters", kind=type(self.overrides).__name__)
        object.__setattr__(self, "overrides", tuple(self.overrides))
        for override in self.overrides:
            if not isinstance(override, Override):
                raise wrong("override_of_parameters", kind=type(override).__name__)
            for role in ("asset", "channel"):
                if not isinstance(getattr(override, role), str):
                    raise wrong("pattern_of_override", role=role, pattern=getattr(override, role))
            self.changed_by(override)

    @property
    def radix(self) -> int:
        """R = bins + 3, the codes a sample can have (method, section 3)."""
        return self.grid + 3

    @property
    def grid(self) -> int:
        """The bins; if calibration chooses them, the finest grid for which cell keys have room."""
        if self.bins != AUTO:
            bins: int = self.bins
            return bins
        return next((rung for rung in RUNGS if (rung + 3) ** min(self.m, 64) <= LARGEST_KEY), RUNGS[-1])

    @property
    def is_open(self) -> bool:
        """Whether calibration chooses some settings of some channels."""
        return any(setting.open_settings for setting in self.variants())

    @property
    def open_settings(self) -> tuple[str, ...]:
        """The settings that calibration chooses, without those of overrides."""
        return tuple(name for name in OPENABLE if getattr(self, name) == AUTO)

    @property
    def span(self) -> int:
        """(m - 1) * tau, the samples between the oldest and the newest of a vector."""
        span: int = (self.m - 1) * self.tau
        return span

    @property
    def reach(self) -> int:
        """How many samples before a vector's newest one decide its cell: its own, and stillness."""
        return self.span + (0 if self.still_after is None else self.still_after - 1)

    @property
    def bucket_length(self) -> int:
        """The stride, resolved."""
        return math.gcd(self.window, LONGEST_STRIDE) if self.stride is None else self.stride

    def changed_by(self, override: Override) -> "Parameters":
        """Return these parameters with one override applied and the others removed.

        Raises:
            ParameterError: the result is out of range; the message names the override.
        """
        changes = override.changes()
        if "window" in changes and "stride" not in changes:
            changes["stride"] = None
        try:
            return dataclasses.replace(self, overrides=(), **changes)
        except ParameterError as error:
            raise ParameterError(
                f"In the override for {override.asset!r} / {override.channel!r}: {error.options}"
            ) from error

    def of(self, asset: str, channel: str) -> "Parameters":
        """Return the parameters of one channel."""
        for override in self.overrides:
            if override.names(asset, channel):
                return self.changed_by(override)
        return dataclasses.replace(self, overrides=())

    def finest(self, window: int | None = None) -> "Parameters":
        """Return the same with numbers where settings are open: the finest grids, tau 1, some window."""
        usual = {} if window is None else {"window": window}
        general, *others = (
            variant.closed(**(usual if variant.window == AUTO and variant.stride is None else {}))
            for variant in self.variants()
        )
        overrides = [
            Override(override.asset, override.channel, **{**override.changes(), **of.numbers()})
            for override, of in zip(self.overrides, others, strict=True)
        ]
        return dataclasses.replace(general, overrides=overrides)

    def closed(self, **chosen: int) -> "Parameters":
        """Return the same with the chosen settings, else as in :meth:`finest`; without overrides."""
        usual = {"tau": 1, "bins": self.grid, "window": self.stride or LONGEST_STRIDE}
        changes: dict[str, Any] = {name: usual[name] for name in self.open_settings}
        return dataclasses.replace(self, overrides=(), **{**changes, **chosen})

    def numbers(self) -> dict[str, Any]:
        """Return the settings that calibration may choose, and the stride that belongs to them."""
        return {name: getattr(self, name) for name in (*OPENABLE, "stride")}

    @classmethod
    def paper(cls, **changes: Any) -> "Parameters":
        """Return the parameters of the paper, but for some."""
        return cls(**{**cls.PAPER, **changes})

    def variants(self) -> "list[Parameters]":
        """Return the sets of parameters: the general one, then one per override."""
        general = dataclasses.replace(self, overrides=())
        return [general, *(self.changed_by(override) for override in self.overrides)]


def pattern_matches(pattern: str, name: str) -> bool:
    """Tell whether a pattern (``*`` any text, ``?`` one character, else literal) names ``name``."""
    parts = (".*" if sign == "*" else "." if sign == "?" else re.escape(sign) for sign in pattern)
    return re.fullmatch("".join(parts), name, re.DOTALL) is not None
