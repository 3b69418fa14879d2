"""Evaluation of health indicators by the paper's metrics (method, section 9).

This folder owns the way from a table of health indicators, and a table of what became of the assets, to
the metrics of each channel and of the fleet; and from a table of labelled events to rates of detection.
The formulas are in ``sql/lab/evaluation``.
"""

from gam_db.lab.evaluation.conventions import Conventions
from gam_db.lab.evaluation.run import Evaluation, evaluate

__all__ = ["Conventions", "Evaluation", "evaluate"]
