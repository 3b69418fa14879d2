"""All notes on a source, what must be fixed first."""

from collections.abc import Sequence

from gam_db.checking.amounts import amounts
from gam_db.checking.look import Look
from gam_db.checking.note import Note
from gam_db.checking.proposal import Proposal
from gam_db.checking.times import times
from gam_db.checking.values import values

__all__ = ["Note", "must_be_fixed", "notes"]


def notes(look: Look, proposal: Proposal) -> list[Note]:
    """Return what is to be known of a source, what must be fixed first, and else in a fixed order."""
    found = [*times(look, proposal), *amounts(look, proposal), *values(look)]
    return sorted(found, key=lambda note: not note.must)


def must_be_fixed(found: Sequence[Note]) -> bool:
    """Tell whether a source cannot be used as it is."""
    return any(note.must for note in found)
