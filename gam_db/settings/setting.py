"""Each setting is declared once: a field of a dataclass with its default, range, unit and words.

This module owns the form of declarations, and the check of values. The option of the command line, the
key of gam.toml, the keyword in Python and the line of docs/gam.toml all follow from the field. Its words
are in ``settings.toml``.
"""

import dataclasses
import numbers
import operator
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal, SupportsIndex, TypeVar, cast

from gam_db import data
from gam_db.clock import looks_like_calendar
from gam_db.errors import ParameterError, UserError, nearest, wrong

_KEY = "setting"
#: Class -> field -> what :class:`Setting` has of it; of *off* the words.
_WORDS = data.table("gam_db.settings", "settings.toml")
_Class = TypeVar("_Class")


@dataclass(frozen=True)
class Kind:
    """What a setting takes."""

    #: From setting, name and value to the value as it is kept; raises ParameterError.
    checked: Callable[["Setting", str, Any], Any]
    option: Any = str  # type of the option on the command line; bool for one that takes no value
    #: From the option's name and value to the value of the setting.
    read: Callable[[str, Any], Any] = lambda _, text: text
    metavar: str | None = None  # stands for the value in help
    how: str = ""  # how an option is written, in help; ``{example!r}`` stands for the setting's example
    none: bool = False  # that there is none is said by an option of its own, --no-NAME


@dataclass(frozen=True)
class Setting:
    """The declaration of a setting, besides the type of its field."""

    default: Any  # what counts where nothing is said
    takes: Kind  # the values it takes
    what: str = ""  # what it is, and its unit
    option: str = ""  # name of its option, where it is not that of the field
    metavar: str | None = None  # stands for the value in help, where it is not that of its kind
    more: str = ""  # what else the option's help says
    #: Value and words of "there is none": false in gam.toml, 'none' or --no-NAME as an option.
    off: tuple[Any, str] | None = None
    usual: str = ""  # the default in words, where the value does not say it
    example: Any = None  # value in docs/gam.toml, by default the default
    note: str = ""  # what else is said there
    aside: bool = False  # the example is a comment there, since it goes with others
    least: float | None = None  # least, most: bounds of a number, or of the length of a text
    most: float | None = None

    @property
    def help(self) -> str:
        """The help of the option."""
        parts = [self.what + self.takes.how.format(example=self.example)]
        parts += [self.more] if self.more else []
        usual = self.usual
        if self.off is not None and self.takes.option is str and not self.takes.none:
            is_default = self.off[0] is self.default and not usual
            parts.append(f"'none' for {self.off[1]}{' (the default)' * is_default}")
        if not usual and self.default and self.default is not True:
            usual = repr(self.default)
        words = "; ".join(parts) + (f" (default {usual})" if usual else "")
        return f"{words[0].upper()}{words[1:]}."

    def checked(self, name: str, value: Any) -> Any:
        """Return a value as the setting stores it; raise a ParameterError for an unacceptable one."""
        if value is self.default or (self.off is not None and value is self.off[0]):
            return value
        return self.takes.checked(self, name, value)

    def of_toml(self, name: str, value: Any) -> Any:
        """Return the same of a value in gam.toml, where false means that there is none."""
        if value is False and self.off is not None:
            return self.off[0]
        return self.takes.checked(self, name, value)

    def of_option(self, option: str, value: Any) -> Any:
        """Return the value of the text of an option, unchecked; 'none' means no value."""
        if value == "none" and self.off is not None:
            return self.off[0]
        return self.takes.read(option, value)


def setting(default: Any, takes: Kind, what: str = "", **more: Any) -> Any:
    """Return a field of a dataclass that can be set: what :class:`Setting` has and the table has not."""
    return dataclasses.field(default=default, metadata={_KEY: Setting(default, takes, what, **more)})


@cache
def settings_of(of: type) -> Mapping[str, Setting]:
    """Return the settings of a dataclass by name; those that it shares with others come last."""
    fields = sorted(dataclasses.fields(of), key=lambda field: field.kw_only is True)
    words: dict[str, Mapping[str, Any]] = {}
    for owner in reversed(of.__mro__):
        words |= _WORDS.get(owner.__name__, {})
    settings = {field.name: field.metadata[_KEY] for field in fields if _KEY in field.metadata}
    return {name: _worded(unworded, **words.get(name, {})) for name, unworded in settings.items()}


def _worded(unworded: Setting, off: str | None = None, **words: Any) -> Setting:
    """Return a setting with the words of the table."""
    if off is not None:
        words["off"] = (False if unworded.takes.none else None, off)
    return dataclasses.replace(unworded, **words)


def declared(of: type[_Class]) -> type[_Class]:
    """Add the texts of its settings to the docstring of a dataclass."""
    lines = (f"    {name}: {worded.help}" for name, worded in settings_of(cast(Any, of)).items())
    of.__doc__ = "\n    ".join([(of.__doc__ or "").rstrip(), "", "Settings:", *lines]) + "\n    "
    return of


def check(of: Any, refusal: type[UserError] = ParameterError) -> None:
    """Check each setting of a dataclass, and keep it in its usual form.

    Raises:
        UserError: one is out of its range; of the type that is given.
    """
    try:
        for name, worded in settings_of(of.__class__).items():
            object.__setattr__(of, name, worded.checked(name, getattr(of, name)))
    except ParameterError as error:
        raise refusal(error.options) from error


def number(text: str) -> int | float | str:
    """A plain number has no unit; anything else is left to the clock, which knows the units."""
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text


def texts(value: object) -> bool:
    """Tell whether a value is a list of texts."""
    return isinstance(value, (list, tuple)) and all(isinstance(text, str) for text in value)


def choice_of(*values: str) -> Kind:
    """Return the kind of a setting that takes one of some words."""

    def checked(_: Setting, name: str, value: Any) -> Any:
        if value not in values:
            raise ParameterError(f"{name} is {value!r}{nearest(str(value), values)}")
        return value

    return Kind(checked, Literal[values])


def _count(of: Setting, name: str, value: Any) -> int:
    try:
        if isinstance(value, bool):
            raise TypeError
        whole = operator.index(cast(SupportsIndex, value))
    except TypeError:
        raise ParameterError(f"{name} is {value!r}; it must be an integer.") from None
    least = 1 if of.least is None else of.least
    if whole < least:
        raise ParameterError(f"{name} is {whole}; it must be at least {least}.")
    if of.most is not None and whole > of.most:
        raise ParameterError(f"{name} is {whole}; it must not exceed {of.most:,}.")
    return whole


def _share(of: Setting, name: str, value: Any) -> Any:
    is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
    if not is_number or not 0 <= value <= 1 or value == of.least:
        bounds = "0 to 1" if of.least is None else f"above {of.least} and at most 1"
        raise wrong("share", name=name, value=value, bounds=bounds, said=of.example or of.default)
    return value


def _length(of: Setting, name: str, value: Any) -> Any:
    is_number = isinstance(value, numbers.Real) and not isinstance(value, bool)
    if not (is_number or isinstance(value, str) or looks_like_calendar(value)):
        raise wrong("length", name=name, value=value, example=of.example)
    return value


def _text(of: Setting, name: str, value: Any) -> Any:
    if not isinstance(value, str) or len(value) < (1 if of.least is None else of.least):
        raise ParameterError(f"{name} is {value!r}; it takes a text.")
    return value


def _flag(_: Setting, name: str, value: Any) -> bool:
    if not isinstance(value, bool):
        raise ParameterError(f"{name} is {value!r}; it is true or false.")
    return value


def _names(_: Setting, name: str, value: Any) -> tuple[str, ...]:
    if not texts(value):
        raise ParameterError(f"{name} is {value!r}; it takes a list of column names.")
    return tuple(cast(Iterable[str], value))


def _text_or_texts(of: Setting, name: str, value: Any) -> Any:
    return tuple(value) if value and texts(value) else _text(of, name, value)


FLAG = Kind(_flag, bool)
COUNT = Kind(_count, int)
SHARE = Kind(_share, float)
LENGTH = Kind(
    _length,
    read=lambda _, text: number(text),
    metavar="LENGTH",
    how=": seconds, a text such as {example!r}, or steps of a counter",
)
TEXT = Kind(_text)
TEXT_OR_TEXTS = Kind(_text_or_texts)
COLUMN = Kind(_text, none=True)
COLUMNS = Kind(_names)
INSTANT = Kind(lambda _, __, value: value, metavar="TIME")
