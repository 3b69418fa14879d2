"""Errors, by who can correct them.

The command line exits with 1 if the user can correct the error (UserError), with 75 if running again
may help (RunAgainError), and with 3 for a fault of gam-db (InternalError).

A message says what is wrong, where, and what to do; long messages are in ``errors.toml``. Messages
contain no values of the telemetry, except the first word that cannot be read as a number or time.
"""

import difflib
import errno
import re
from collections.abc import Iterable

from gam_db import data


class GamError(Exception):
    """Base of all errors that gam-db raises; ``code`` is a stable word for programs."""

    code = "error"

    def __init_subclass__(cls, code: str | None = None) -> None:
        cls.code = code or cls.code


class UserError(GamError, code="user"):
    """An error that the user can correct.

    As a text it names arguments in Python; ``options`` is the same with options of the command line.
    """

    @property
    def options(self) -> str:
        """The message with options of the command line."""
        return super().__str__()

    def __str__(self) -> str:
        return _in_python(self.options)


class ArgumentError(UserError, TypeError, code="argument"):
    """An argument of a public call is misspelt, missing, or of another type."""


class ParameterError(UserError, code="parameter"):
    """A parameter of the method is out of its range."""


class CalibrationError(UserError, code="calibration"):
    """The calibration is contradictory or cannot be resolved."""


class CalibrationWarning(UserWarning):
    """The calibration is not good enough to judge by; a model fitted with it has little value."""


class SourceError(UserError, code="source"):
    """The relation, a column of it, or its rows are not usable."""


class ConfigurationError(UserError, code="configuration"):
    """A key of gam.toml or an option of the command line is not usable."""


class EngineError(UserError, code="engine"):
    """An unknown engine, or one that cannot do the work."""


class RunAgainError(EngineError, code="again"):
    """A temporary error: nothing was lost, and running again may succeed."""


class ConflictError(RunAgainError, code="conflict"):
    """Another writer was faster."""


class LockedError(RunAgainError, code="locked"):
    """Another process has the file open."""


class LostConnectionError(RunAgainError, code="connection"):
    """The connection to the server was lost or refused."""


class FullError(RunAgainError, code="full"):
    """A disk or a quota is full; what was there before is unchanged."""


class StateError(UserError, code="state"):
    """The state tables are missing, were changed, or belong to another version of gam-db."""


class InternalError(GamError, code="fault"):
    """A fault of gam-db itself."""


class TemplateError(InternalError):
    """A file in sql/ breaks a rule, or lacks a value for a slot."""


class StatementError(InternalError):
    """The engine refused a statement of gam-db.

    ``statement`` holds the statement; the message does not.
    """

    def __init__(self, message: str, statement: str = "") -> None:
        super().__init__(message)
        self.statement = statement


def wrong(key: str, /, **words: object) -> UserError:
    """Return the error of a key of ``errors.toml``, with its slots filled."""
    for name, sentences in data.table("gam_db", "errors.toml").items():
        if key in sentences:
            error: UserError = globals()[name](sentences[key].format(**words))
            return error
    raise InternalError(f"There is no error {key!r} in errors.toml.")


#: Error numbers of the system for a full disk, a quota, or a limit on the size of files.
NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})


def unwritable(path: object, error: OSError, otherwise: type[UserError] | None = None) -> UserError:
    """Return the error on a file that cannot be written: FullError, or ``otherwise``."""
    if error.errno in NO_ROOM:
        return FullError(
            f"{path} cannot be written: its disk is full, or a quota is reached. No file is half "
            "written. Make room, and run it again."
        )
    return (otherwise or ConfigurationError)(f"{path} cannot be written: {error.strerror}.")


#: Options that have another name in Python, apart from dashes.
_ARGUMENTS = {
    "calibrate": "intervals",
    "calibration_duration": "duration",
    "calibration_fraction": "fraction",
    "no_asset": "asset=None",
    "no_channel": "channel=None",
    "wide": "gam_db.WideSource",
    "paper": "gam_db.Parameters.paper()",
}
_OPTION = re.compile(
    r"--([a-z][a-z-]*)(?: ('[^']*'|none\b|[.,:;](?=[ .]|$)|\S+(?= would )|cp\d+|utf-\d+(?:-[bl]e)?"
    r"|[A-Z0-9][^\s;,)]*?(?=[;,.)]?(?:\s|$))))?"
)
_PLACEHOLDER = re.compile(r"[A-Z]{2,}(/[A-Z]{2,})?")


def _in_python(text: str) -> str:
    """Return a message with arguments of Python instead of options of the command line.

    Commands in backticks do not change.
    """
    parts = text.split("`")
    return "`".join(
        part if place % 2 else _OPTION.sub(_argument, part) for place, part in enumerate(parts)
    )


def _argument(option: re.Match[str]) -> str:
    name, value = option[1].replace("-", "_"), option[2]
    name = _ARGUMENTS.get(name, name)
    if value is None:
        return name
    if value == "none":
        return f"{name}={'False' if name == 'clock_tolerance' else 'None'}"
    is_literal = value.startswith("'") or _PLACEHOLDER.fullmatch(value)
    return f"{name}={value if is_literal else repr(value)}"


def printable(text: str) -> str:
    """Return a text without control characters of a terminal: they are spelt, ESC as x1b."""
    return "".join(
        sign if sign.isprintable() else sign.encode("unicode_escape").decode("ascii") for sign in text
    )


def nearest(word: str, names: Iterable[str], most: int = 12) -> str:
    """Return the end of a sentence, with its full stop, that suggests the name nearest to ``word``.

    If no name is near, it lists the first ``most`` names.
    """
    choices = list(names)
    folded = {choice.casefold(): choice for choice in reversed(choices)}
    if close := difflib.get_close_matches(word.casefold(), folded, n=1, cutoff=0.5):
        return f"; did you mean {folded[close[0]]!r}?"
    if not choices:
        return "."
    shown = ", ".join(repr(choice) for choice in choices[:most])
    return f"; there is {shown}" + (", and others." if len(choices) > most else ".")
