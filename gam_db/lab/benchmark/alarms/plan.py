"""Which simulated fleets are judged, and under which parameters."""

from dataclasses import dataclass, replace

from gam_db.lab.simulate.fleet import SAMPLES, Fleet
from gam_db.lab.simulate.roles import role_of
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters

ROBOTS = 21
"""Of a fleet; after them come the controls, to which something happens that is no wear."""

RATES = (1.0, 0.5, 0.2)
"""Asked for, per 1,000 judgements."""

DRIFTS = (0.5, 3.0, 12.0)
"""In how many windows a drift forgets where it was."""

RIVALS = ("forest", "gmm")


@dataclass(frozen=True)
class Plan:
    """What is measured.

    Attributes:
        seeds: of the fleets that the promise and wear are measured on.
        everything: drift, shifts and other estimators as well.
        robots: of each fleet, from the first; controls are left out.
        joints: of each healthy robot, from the first.
        samples: of a joint, at 5 Hz.
        window: W, in vectors.
        bins: B.
        sample: calibration vectors that other estimators are fitted on at most.
        is_quick: so little that the figures say nothing.
    """

    seeds: tuple[int, ...]
    everything: bool = False
    robots: int = ROBOTS
    joints: int = 3
    samples: int = SAMPLES
    window: int = 2500
    bins: int = 64
    sample: int = 10_000
    is_quick: bool = False

    @classmethod
    def quick(cls, seeds: tuple[int, ...]) -> "Plan":
        """Return a plan of all there is on little data."""
        small = cls(seeds, True, robots=8, joints=4, samples=12_000, window=100, bins=16, sample=500)
        return replace(small, is_quick=True)

    @property
    def parameters(self) -> Parameters:
        """The method's, the same for all channels."""
        return Parameters.paper(bins=self.bins, window=self.window, still_after=25)

    @property
    def shift(self) -> int:
        """Samples of a shift with one product: two windows."""
        return 2 * self.window

    def fleet(self, seed: int) -> Fleet:
        """Return the fleet of a seed."""
        return Fleet(seed, self.samples)

    @property
    def rivalled(self) -> tuple[int, ...]:
        """Seeds of the fleets that other estimators score; a forest takes minutes for each."""
        return self.seeds[:2]

    @property
    def extra(self) -> tuple[int, ...]:
        """Seeds of the fleets of drift and of shifts: half of them all."""
        return self.seeds[: (len(self.seeds) + 1) // 2]

    @property
    def runs(self) -> int:
        """How many fleets are read."""
        return len(self.seeds) + (1 + len(DRIFTS)) * len(self.extra) * self.everything


CALIBRATION = Calibration(fraction=0.2)

#: Where calibration has 45 blocks, as it takes to tell drift.
LONG_CALIBRATION = Calibration(fraction=0.4)


def is_watched(fleet: Fleet, robot: int, joint: int, plan: Plan, wearing: bool) -> bool:
    """Tell whether a joint is one of the channels: some of healthy robots, and those that wear."""
    role = role_of(fleet.seed, robot)
    if role.kind == "failed":
        return wearing and role.joint == joint
    return role.kind == "healthy" and joint <= plan.joints and joint not in (role.silent, role.constant)
