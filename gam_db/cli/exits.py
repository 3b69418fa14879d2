"""Exit codes of the command line, and what each means."""

from enum import IntEnum


class Exit(IntEnum):
    """How a command ended."""

    FINE = 0
    USER_ERROR = 1
    ATTENTION = 2
    OUR_FAULT = 3
    RUN_AGAIN = 75
    INTERRUPTED = 130


MEANINGS = {
    Exit.FINE: "fine",
    Exit.USER_ERROR: "something for you to mend, told on stderr",
    Exit.ATTENTION: "done, and something needs attention",
    Exit.OUR_FAULT: "our fault",
    Exit.RUN_AGAIN: "only the moment was wrong: run it again",
    Exit.INTERRUPTED: "interrupted",
}
