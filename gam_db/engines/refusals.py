"""What engines refuse, and what the user can do about it: the table ``refusals.csv``, a row per answer.

Of the rows of an engine the first counts that has a sign of the error: what the engine calls it, or says
of it (``*`` any text, ``?`` one character). Words in braces are filled in.
"""

import csv
from fnmatch import fnmatchcase

from gam_db import data, errors
from gam_db.errors import UserError

READ_ONLY = "The database is open for reading only; it cannot be changed."
OPEN = "The connection has a transaction open; commit it or roll it back first."
UNWRITTEN = "The database cannot be written; is its disk full? What was there before is as it was."
FULL = "What was there before is as it was; make room, and run it again."
CONFLICT = (
    "Another connection changed the same tables at the same time; what was to be written here was not. "
    "Run it again."
)

_TABLE = list(csv.DictReader(data.text("gam_db.engines", "refusals.csv").splitlines()))

#: What several engines say.
_SHARED = {"conflict": CONFLICT, "full": FULL, "unwritten": UNWRITTEN, "read_only": READ_ONLY}


def refusal(of: str, *traits: str, **words: object) -> UserError | None:
    """Return what the user can do about an error; None if it is none of the user's.

    It is looked up by the name in the first column of the table and by what is known of the error (its
    name or number, what is said of it); words fill the braces of sentences.
    """
    for row in _TABLE:
        signs = row["signs"].split("|")
        if row["of"] == of and any(fnmatchcase(trait, sign) for trait in traits for sign in signs):
            error: UserError = getattr(errors, row["error"])(row["said"].format(**_SHARED, **words))
            return error
    return None


def refused(of: str, *traits: str, **words: object) -> UserError:
    """Return the same of what is always the user's: the table has an answer to any error."""
    error = refusal(of, *traits, **words)
    assert error is not None, of
    return error


def first_line(error: BaseException | None) -> str:
    """Return the first line of what an engine says of an error."""
    return str(error).strip().partition("\n")[0]
