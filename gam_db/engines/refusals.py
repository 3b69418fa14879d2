"""Errors of engines and what the user can do about them: the table ``refusals.csv``, a row per answer.

Among the rows of an engine, the first with a sign of the error counts: its name, number or message
(``*`` any text, ``?`` one character). Code fills in the names in braces.
"""

import csv
from fnmatch import fnmatchcase

from gam_db import data, errors
from gam_db.errors import UserError

READ_ONLY = "The database is open for reading only; it cannot be changed."
OPEN = "The connection has a transaction open; commit it or roll it back first."
UNWRITTEN = "The database cannot be written; is its disk full? What was there before is unchanged."
FULL = "What was there before is unchanged. Make room, and run it again."
CONFLICT = (
    "Another connection changed the same tables at the same time, so this one wrote nothing. "
    "Run it again."
)

_TABLE = list(csv.DictReader(data.text("gam_db.engines", "refusals.csv").splitlines()))

#: Texts that several engines share.
_SHARED = {"conflict": CONFLICT, "full": FULL, "unwritten": UNWRITTEN, "read_only": READ_ONLY}


def refusal(of: str, *traits: str, **words: object) -> UserError | None:
    """Return the error that tells a user what to do; None if the user did not cause it.

    ``of`` is the name in the first column of the table; ``traits`` are the name, number and message of
    the error; words fill the braces of sentences.
    """
    for row in _TABLE:
        signs = row["signs"].split("|")
        if row["of"] == of and any(fnmatchcase(trait, sign) for trait in traits for sign in signs):
            error: UserError = getattr(errors, row["error"])(row["said"].format(**_SHARED, **words))
            return error
    return None


def refused(of: str, *traits: str, **words: object) -> UserError:
    """Return the same where the table has an answer to any error."""
    error = refusal(of, *traits, **words)
    assert error is not None, of
    return error


def first_line(error: BaseException | None) -> str:
    """Return the first line of the message of an error."""
    return str(error).strip().partition("\n")[0]
