"""What can go wrong, and whose it is.

The command line exits with 1 where the user can mend it (UserError), with 75 where only the moment was
wrong (RunAgainError), and with 3 where it is our fault (InternalError).

A message says what is wrong, where, and what to do; long ones are in ``errors.toml``. Values of the
telemetry never appear in one, but for the first word that cannot be read as the number or time that it
should be.
"""

import difflib
import errno
import re
from collections.abc import Iterable

from gam_db import data


class GamError(Exception):
    """Base of all errors that gam-db raises; ``code`` is a word for machines, which stays."""

    code = "error"

    def __init_subclass__(cls, code: str | None = None) -> None:
        cls.code = code or cls.code


class UserError(GamError, code="user"):
    """Something the user can mend.

    As a text it speaks of arguments in Python; ``options`` is the same for the command line.
    """

    @property
    def options(self) -> str:
        """The message in the words of the command line."""
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
    """The calibration is not good enough to judge by; what is fitted by it says little."""


class SourceError(UserError, code="source"):
    """The relation, a column of it, or its rows are not usable."""


class ConfigurationError(UserError, code="configuration"):
    """A key of gam.toml or an option of the command line is not usable."""


class EngineError(UserError, code="engine"):
    """An unknown engine, or one that cannot do what is asked."""


class RunAgainError(EngineError, code="again"):
    """Only the moment was wrong: nothing was lost, and running again is all there is to do."""


class ConflictError(RunAgainError, code="conflict"):
    """Another writer was faster."""


class LockedError(RunAgainError, code="locked"):
    """Another process has the file open."""


class LostConnectionError(RunAgainError, code="connection"):
    """The server went away, has no room, or is not there yet."""


class FullError(RunAgainError, code="full"):
    """A disk, or what may be written there, is full; what was there before is as it was."""


class StateError(UserError, code="state"):
    """The state tables are missing, were changed, or are of another gam-db."""


class InternalError(GamError, code="fault"):
    """A fault of gam-db itself."""


class TemplateError(InternalError):
    """A file in sql/ breaks a rule, or its slots were not filled."""


class StatementError(InternalError):
    """A statement that gam-db made was refused by the engine.

    The statement is kept in ``statement``, for those who ask; it is not poured into the message.
    """

    def __init__(self, message: str, statement: str = "") -> None:
        super().__init__(message)
        self.statement = statement


def wrong(key: str, /, **words: object) -> UserError:
    """Return the error of a key of ``errors.toml``, with words filled in."""
    for name, sentences in data.table("gam_db", "errors.toml").items():
        if key in sentences:
            error: UserError = globals()[name](sentences[key].format(**words))
            return error
    raise InternalError(f"There is no error {key!r} in errors.toml.")


#: What the system says where a disk, a quota, or a limit on the size of files leaves no room.
NO_ROOM = frozenset({errno.ENOSPC, errno.EDQUOT, errno.EFBIG})


def unwritable(path: object, error: OSError, otherwise: type[UserError] | None = None) -> UserError:
    """Return why a file or folder cannot be written, as another error where there is room for it."""
    if error.errno in NO_ROOM:
        return FullError(
            f"{path} cannot be written: its disk is full, or a quota is reached. No file is half "
            "written. Make room, and run it again."
        )
    return (otherwise or ConfigurationError)(f"{path} cannot be written: {error.strerror}.")


#: Options that are called otherwise in Python, where dashes alone do not make the difference.
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
    """Return a message with arguments of Python in the place of options of the command line.

    Commands, which stand in backticks, stay as they are.
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
    """Return a text with nothing in it that a terminal would obey: such signs are spelt, ESC as x1b."""
    return "".join(
        sign if sign.isprintable() else sign.encode("unicode_escape").decode("ascii") for sign in text
    )


def nearest(word: str, names: Iterable[str], most: int = 12) -> str:
    """Return the end of a sentence, its stop included, that says what ``word`` was meant to be.

    Where no known word is near, the first ``most`` of them are named.
    """
    choices = list(names)
    folded = {choice.casefold(): choice for choice in reversed(choices)}
    if close := difflib.get_close_matches(word.casefold(), folded, n=1, cutoff=0.5):
        return f"; did you mean {folded[close[0]]!r}?"
    if not choices:
        return "."
    shown = ", ".join(repr(choice) for choice in choices[:most])
    return f"; there is {shown}" + (", and others." if len(choices) > most else ".")
