"""Exit codes of the command line, and what each means."""

from enum import IntEnum

from gam_db import data


class Exit(IntEnum):
    """How a command ended."""

    FINE = 0
    USER_ERROR = 1
    ATTENTION = 2
    OUR_FAULT = 3
    DATA = 4
    RUN_AGAIN = 75
    INTERRUPTED = 130


MEANINGS = {code: data.table("gam_db.cli", "words.toml")["exits"][code.name.lower()] for code in Exit}
