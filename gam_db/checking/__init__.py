"""The look before calibration: what a source is like, what must be fixed, what to set.

This folder owns ``gam check``: :mod:`~gam_db.checking.steps` the order of the formulas in ``sql/check``,
:mod:`~gam_db.checking.look` running them, :mod:`~gam_db.checking.notes` (with *values*, *times* and
*amounts*) what is said of them in plain words, :mod:`~gam_db.checking.proposal` what to set,
:mod:`~gam_db.checking.answer` the public call. It learns nothing and writes nothing.
"""

from gam_db.checking.answer import check
from gam_db.checking.look import Look, look_at
from gam_db.checking.notes import Note, must_be_fixed, notes
from gam_db.checking.proposal import Proposal, propose

__all__ = ["Look", "Note", "Proposal", "check", "look_at", "must_be_fixed", "notes", "propose"]
