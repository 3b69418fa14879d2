"""The paper's neural baselines, small and on the processor: what the grid is set beside.

They are no part of the product. They see the same delay vectors, learn from the same calibration, and
their errors go through the same moving average, as any estimator's score. PyTorch is needed: it is
imported where a network is made.
"""

from gam_db.lab.baselines.baseline import BASELINES, FULL, QUICK, Effort, Nets, add_baseline

__all__ = ["BASELINES", "FULL", "QUICK", "Effort", "Nets", "add_baseline"]
