"""What can go wrong, and whose it is.

    GamError
    ├── UserError               something the user can mend; the command line exits with 1
    │   ├── ParameterError      a parameter of the method is out of its range
    │   ├── CalibrationError    the calibration is contradictory or cannot be resolved
    │   ├── SourceError         the relation, a column of it, or its rows are not usable
    │   ├── ConfigurationError  gam.toml or an option of the command line
    │   ├── EngineError         an unknown engine, or one that cannot do what is asked
    │   │   └── ConflictError   another writer was faster; running again is all there is to do
    │   └── StateError          the state tables are missing, changed, or of another gam-db
    └── InternalError           our fault; the command line exits with 3
        ├── TemplateError       a file in sql/ breaks a rule, or its slots were not filled
        └── StatementError      a statement that we made failed; carries it as ``statement``

A message says what is wrong, where, and what to do. Values of the telemetry never appear in one.
"""

import difflib
from collections.abc import Iterable


class GamError(Exception):
    """Base of all errors that gam-db raises."""


class UserError(GamError):
    """Something the user can mend."""


class ParameterError(UserError):
    """A parameter of the method is out of its range."""


class CalibrationError(UserError):
    """The calibration is contradictory or cannot be resolved."""


class SourceError(UserError):
    """The relation, a column of it, or its rows are not usable."""


class ConfigurationError(UserError):
    """A key of gam.toml or an option of the command line is not usable."""


class EngineError(UserError):
    """An unknown engine, or one that cannot do what is asked."""


class ConflictError(EngineError):
    """Another writer was faster: nothing was lost, and running again is all there is to do."""

    code = "conflict"


class StateError(UserError):
    """The state tables are missing, were changed, or are of another gam-db."""


class InternalError(GamError):
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


def nearest(word: str, known: Iterable[str]) -> str:
    """Return the end of a sentence that suggests what ``word`` was meant to be."""
    choices = list(known)
    folded = {choice.casefold(): choice for choice in reversed(choices)}
    close = difflib.get_close_matches(word.casefold(), folded, n=1, cutoff=0.5)
    if close:
        return f"; did you mean {folded[close[0]]!r}?"
    if not choices:
        return ""
    shown = ", ".join(repr(choice) for choice in choices[:12])
    return f"; there is {shown}" + (", ..." if len(choices) > 12 else "")
