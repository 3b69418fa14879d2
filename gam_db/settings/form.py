"""Form: how numbers and times are written in a source, and the options for words that do not fit.

This module owns these options, and finds those that would read some words. It reads nothing.
"""

import datetime as dt
import itertools
import re
import shlex
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from gam_db.clock import SINCE_1970, zone
from gam_db.errors import ConfigurationError, ParameterError, printable
from gam_db.settings.setting import (
    COUNT,
    TEXT,
    Kind,
    Setting,
    choice_of,
    declared,
    setting,
    settings_of,
    texts,
)

#: Signs that are all meant by a space between thousands.
SPACES = " \u00a0\u202f"
#: Words of one column that a proposal is made from.
LOOKED_AT = 1000

_NUMBER = re.compile(
    rf"\s*[+-]?([0-9][0-9.,'{SPACES}]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?\s*([^0-9\s]\S*)?\s*"
)
_DAYS = [f"%d{sign}%m{sign}%Y" for sign in "./-"] + [f"%m{sign}%d{sign}%Y" for sign in "/-"]
_DAYS += [f"%d{sign}%m{sign}%y" for sign in "./-"] + [f"%m{sign}%d{sign}%y" for sign in "/-"]
_DAYS += [f"%y{sign}%m{sign}%d" for sign in "./-"] + ["%Y/%m/%d", "%Y.%m.%d", "%Y%m%d", "%Y-%m-%d"]
_DAYS += ["%d-%b-%Y", "%d-%b-%y", "%d %b %Y"]
_HOURS = ["", " %H:%M", " %H:%M:%S", " %H:%M:%S.%f", " %H:%M:%S,%f", " %H.%M.%S", " %H%M%S", "T%H%M%S"]
_HOURS += [f"{sign}%I:%M{rest}" for sign in " T" for rest in (" %p", "%p", ":%S %p", ":%S%p")]


def _words(_: Setting, name: str, value: Any) -> tuple[str, ...]:
    words = (value,) if isinstance(value, str) else value
    if not texts(words):
        raise ParameterError(f"{name} is {value!r}; it takes a list of texts.")
    return tuple(words)


def _encoding(_: Setting | None, name: str, value: Any) -> str:
    try:
        b"a".decode(value, "ignore")
    except (LookupError, TypeError, ValueError):
        raise ParameterError(
            f"{name} is {value!r}; it takes the name of an encoding, such as cp1252, latin-1 or utf-16."
        ) from None
    return str(value)


_ENCODING = Kind(_encoding, read=lambda option, text: _encoding(None, option, text))
_WORDS = Kind(_words, option=list[str], read=lambda _, words: tuple(words))


def _zone(_: Setting, name: str, value: Any) -> str:
    try:
        zone(value)
    except (ConfigurationError, TypeError, AttributeError):
        raise ParameterError(f"{name} is {value!r}; it takes a name such as Europe/Berlin.") from None
    return str(value)


_ZONE = Kind(_zone)

#: Settings of rows, not of how words are written.
_OF_ROWS = ("source_time_zone", "valid_when", "program")


@declared
@dataclass(frozen=True, kw_only=True)
class Form:
    """How numbers and times are written in a source, which readings count, and of what program."""

    decimal: str | None = setting(None, choice_of(",", "."))
    thousands: str | None = setting(None, choice_of(".", ",", " ", "'"))
    unit: str | None = setting(None, TEXT)
    null: Sequence[str] | None = setting(None, _WORDS)
    delimiter: str | None = setting(None, TEXT)
    skip_rows: int | None = setting(None, COUNT)
    encoding: str | None = setting(None, _ENCODING)
    time_format: str | None = setting(None, TEXT)
    time_unit: str | None = setting(None, choice_of(*SINCE_1970))
    source_time_zone: str | None = setting(None, _ZONE)
    valid_when: str | None = setting(None, TEXT)
    program: str | None = setting(None, TEXT)

    @property
    def written(self) -> dict[str, Any]:
        """The settings of the form that are set, by name."""
        settings = {name: getattr(self, name) for name in settings_of(Form)}
        return {name: value for name, value in settings.items() if value}

    @property
    def of_words(self) -> tuple[str, ...]:
        """The names of the settings that only readers of text support, not the SQL of every engine."""
        return tuple(name for name in self.written if name not in _OF_ROWS)

    @property
    def reads_words(self) -> bool:
        """Whether a setting says how numbers are written as text."""
        return bool(self.decimal or self.thousands or self.unit or self.null)


def number_pattern(form: Form) -> str:
    """Return the regular expression of a word that holds a number; its first group is the number.

    Thousands must be where they belong: 1.5 is none in a file with points between thousands.
    """
    mark = re.escape(form.decimal or ("," if form.thousands == "." else "."))
    between = f"[{SPACES}]" if form.thousands == " " else re.escape(form.thousands or "")
    whole = rf"[0-9]{{1,3}}(?:{between}[0-9]{{3}})+|[0-9]+" if form.thousands else "[0-9]+"
    number = rf"(?:(?:{whole})(?:{mark}[0-9]*)?|{mark}[0-9]+)(?:[eE][+-]?[0-9]+)?"
    unit = rf"(?:[{SPACES}]*{re.escape(form.unit)})?" if form.unit else ""
    return rf"^\s*([+-]?(?:{number}|(?i:nan|inf|infinity))){unit}\s*$"


def options_for_null(word: str) -> str:
    """Return the option by which a word means a missing value."""
    return f"--null {shlex.quote(word)}"


def options_for_numbers(words: Iterable[str]) -> str:
    """Return the options that would read some words as numbers, the other words being missing."""
    marks: set[tuple[str, str]] = set()
    units, nulls = dict[str, None](), dict[str, None]()
    for word in words:
        match = _NUMBER.fullmatch(word)
        if match is None:
            nulls[word] = None
            continue
        marks |= _marks(match[1].strip(SPACES))
        if match[2]:
            units[match[2]] = None
    options = dict(sorted(marks, reverse=True))
    if options.get("thousands") == options.get("decimal"):
        options.pop("thousands", None)
    if units:
        options["unit"] = next(iter(units))
    pairs = [*options.items(), *(("null", word) for word in itertools.islice(nulls, 8))]
    return " ".join(f"--{name} {shlex.quote(value)}" for name, value in pairs)


def _marks(number: str) -> set[tuple[str, str]]:
    """Return what the signs in a number can only mean; one comma is taken as decimal."""
    signs = [sign for sign in number if not sign.isdigit()]
    spaced = {("thousands", " " if sign in SPACES else sign) for sign in signs if sign not in ".,"}
    points = [sign for sign in signs if sign in ".,"]
    if len({*points}) == 2:
        return spaced | {("decimal", points[-1]), ("thousands", points[0])}
    if len(points) > 1:
        return spaced | {("thousands", points[0])}
    return spaced | {("decimal", sign) for sign in points if sign == "," or spaced}


def formats_for_times(words: Sequence[str]) -> list[str]:
    """Return the ways of writing a time by which all of some words can be read."""
    ways = (day + hour for day in _DAYS for hour in _HOURS)
    return [way for way in ways if words and all(_fits(word.strip(), way) for word in words)]


def _fits(word: str, way: str) -> bool:
    try:
        dt.datetime.strptime(word, way)
    except ValueError:
        return False
    return True


def shortened(word: str) -> str:
    """Return a word of a source as a message may show it."""
    return repr(printable(word if len(word) <= 40 else f"{word[:37]}..."))
