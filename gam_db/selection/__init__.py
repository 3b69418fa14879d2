"""Choosing tau, m, B and W from the healthy part of each channel (method, section 8).

This folder owns the way from samples to curves, choices and what the calibration at hand affords. The
mathematics is in ``sql/selection``; here its steps are put in order and run.
"""

from gam_db.selection.channels import Studied, select, selected_by_all
from gam_db.selection.search import TAU_RULES, Search
from gam_db.selection.select import Selection, alone, selected

__all__ = [
    "TAU_RULES",
    "Search",
    "Selection",
    "Studied",
    "alone",
    "select",
    "selected",
    "selected_by_all",
]
