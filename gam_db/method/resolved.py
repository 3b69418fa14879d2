"""The user's settings, resolved to integers and sets; and the list of small steps."""

from dataclasses import dataclass, field

from gam_db.clock import FAR_AHEAD, LONG_AGO, TimeKind, length
from gam_db.errors import ParameterError
from gam_db.settings.calibration import Calibration, Rule, resolve
from gam_db.settings.parameters import OPENABLE, Parameters
from gam_db.settings.source import Programs

#: Steps that are small: a row per channel, interval, bucket or cell. They may be kept on the way.
#: So may ``collapsed``, which has a row per sample of channels with repeated instants only.
SMALL = frozenset(
    (
        *("names", "rules", "declared", "channels", "timeline", "recounted", "series"),
        *("limits", "calibration", "calibrated", "collapsed", "taught_programs", "ran_programs"),
    )
)
SMALL_OF_SET = frozenset(
    (
        *("bounds", "support", "support_bits", "visits", "block_sizes", "cells", "blocks"),
        *("cell_shares", "learning", "levels", "ladder", "spread", "finest", "outlook"),
        *("missing_vectors", "run_up", "visited", "tallied", "buckets"),
        *("programs", "judged_programs"),
        *("taught_before", "picked", "probed", "usual", "probe", "sight"),
        *(
            "member_sizes",
            "members",
            "member_ladder",
            "member_spread",
            "member_finest",
            "vouching",
            "pool_spread",
        ),
        *(f"range_{number}" for number in range(5)),
        *(f"range_counts_{number}" for number in range(1, 5)),
    )
)


@dataclass(frozen=True)
class Method:
    """The user's settings, resolved: the input of every pipeline.

    It is data: two methods are equal, and have one hash, where the same steps follow from them.

    Attributes:
        parameters: with their overrides.
        calibration: with its overrides and pools, as the user gave it.
        kind: how the source tells time.
        requested: the parameters as the user gave them, where calibration has chosen since.
        columns: the settings in which channels of one set may differ: the steps read them as columns. Of
            these the parameters have the largest.
        programs: the column that says which program a machine runs, if the source has one.
        assets: the patterns of the calibration's cases; that of number n has rule n + 1.
        pools: groups of asset patterns.
        settings: the distinct sets of parameters; number 0 is the general one.
        rules: calibration in integers; number 0 is the general one.
        gaps: max_gap of each set, in steps of the clock.

    Raises:
        CalibrationError, ParameterError: calibration or max_gap does not fit the kind of time, or
            calibration is still to choose settings.
    """

    parameters: Parameters
    calibration: Calibration = field(compare=False)  # may hold a dict; what is made of it is compared
    kind: TimeKind
    requested: Parameters | None = field(default=None, compare=False)
    columns: tuple[str, ...] = ()
    programs: Programs | None = None
    assets: tuple[str, ...] = field(init=False)
    pools: tuple[tuple[str, ...], ...] = field(init=False)
    settings: tuple[Parameters, ...] = field(init=False)
    rules: tuple[Rule, ...] = field(init=False)
    gaps: tuple[int | None, ...] = field(init=False)

    def __post_init__(self) -> None:
        if self.parameters.is_open:
            names = {name for variant in self.parameters.variants() for name in variant.open_settings}
            options = " and ".join(f"--{name}" for name in OPENABLE if name in names)
            raise ParameterError(
                f"Calibration chooses {options} from telemetry, which is not read here: give {options}, "
                "or calibrate first, or give --paper."
            )
        settings = tuple(dict.fromkeys(self.parameters.variants()))
        longest = (setting.max_gap for setting in settings)
        gaps = (None if gap is None else length(gap, self.kind, "max_gap") for gap in longest)
        resolved = {
            "assets": tuple(pattern for pattern, _ in self.calibration.cases),
            "pools": self.calibration.pools,
            "settings": settings,
            "rules": tuple(resolve(self.calibration, self.kind)),
            "gaps": tuple(gaps),
        }
        for name, value in resolved.items():
            object.__setattr__(self, name, value)

    def named(self, step: str, number: int) -> str:
        """Return what a step of one set is called."""
        return step if len(self.settings) == 1 else f"{step}_{number}"

    @property
    def is_parted(self) -> bool:
        """Tell whether every channel is scored from the end of its calibration on."""
        return all(rule.score_from is None for rule in self.rules)

    def is_cut(self, earliest: int = LONG_AGO) -> bool:
        """Tell whether other samples than those of calibration may come before scoring begins.

        Earliest is the first instant of the source, where it is known.
        """
        return any(
            rule.score_from is not None
            or (
                tuple(rule.allowed) != ((LONG_AGO, FAR_AHEAD),)
                if rule.declared_end is None
                else len(rule.allowed) != 1 or rule.allowed[0][0] > earliest
            )
            for rule in self.rules
            if rule != Rule()
        )

    def is_unbroken(self, number: int) -> bool:
        """Tell whether every whole vector of one set counts whose samples are there.

        No segment ends, no sample counts as still, and no program is unknown.
        """
        is_moving = self.settings[number].still_after is None
        return self.gaps[number] is None and is_moving and self.programs is None

    @property
    def has_instants(self) -> bool:
        """Tell whether calibration may consist of several single instants."""
        pieces = (rule.allowed for rule in self.rules if len(rule.allowed) > 1)
        return any(start == end for allowed in pieces for start, end in allowed)

    def probed(self) -> set[str]:
        """Return the steps to keep as tables if a probe is wanted.

        Cells are counted from the calibration vectors, and vectors picked, so that none is made twice.
        """
        steps = ("learnt", "changes")
        return {self.named(step, number) for number in range(len(self.settings)) for step in steps}

    def small(self) -> set[str]:
        """Return the names of the steps that may be kept as tables."""
        numbers = range(len(self.settings))
        return set(SMALL) | {self.named(step, n) for step in SMALL_OF_SET for n in numbers}
