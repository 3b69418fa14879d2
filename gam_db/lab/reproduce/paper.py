"""What the paper prints, and what it leaves open.

Source: *Geometric Attractor Monitoring: A Robust and Frugal Framework for Multi-modal Industrial Robotic
Cycles* (Bonsergent-Brachet, Read, Abboud), the table of the synthetic Langevin system.
"""

from collections.abc import Mapping
from typing import NamedTuple


class Printed(NamedTuple):
    """A row of the paper's table."""

    mon: float
    corr: float
    rob: float
    global_score: float


TABLE2: Mapping[str, Printed] = {
    "forest": Printed(0.996, 0.995, 0.982, 0.991),
    "dse": Printed(0.998, 0.983, 0.989, 0.990),
    "gmm": Printed(0.998, 0.984, 0.986, 0.989),
    "centroid": Printed(0.991, 0.991, 0.973, 0.985),
    "vae_latent": Printed(0.990, 0.989, 0.969, 0.983),
    "ae": Printed(0.986, 0.986, 0.963, 0.978),
    "ocsvm": Printed(0.965, 0.966, 0.939, 0.957),
    "mlp": Printed(0.789, 0.794, 0.932, 0.838),
    "vae_rec": Printed(0.724, 0.740, 0.896, 0.787),
    "lstm_ae": Printed(0.716, 0.746, 0.897, 0.786),
    "lstm": Printed(0.593, 0.627, 0.858, 0.693),
}
"""The Langevin system, best first."""
