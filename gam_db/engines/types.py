"""The meaning of column types for the method: kinds of time, numbers, and names.

sqlglot reads the names of types; an engine declares those with another meaning.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass

from sqlglot import exp
from sqlglot.errors import SqlglotError

from gam_db.clock import TimeKind

_Type = exp.DataType.Type
_INTEGERS = {*exp.DataType.SIGNED_INTEGER_TYPES, *exp.DataType.UNSIGNED_INTEGER_TYPES} - {_Type.BIT}
_NUMBERS = {*_INTEGERS, _Type.FLOAT, _Type.DOUBLE, _Type.DECIMAL}
_TEXTS = {_Type.TEXT, _Type.VARCHAR, _Type.CHAR, _Type.NAME}
_TEXTS |= {_Type.TINYTEXT, _Type.MEDIUMTEXT, _Type.LONGTEXT}
_NAMES = {*_INTEGERS, *_TEXTS, _Type.UUID, _Type.FIXEDSTRING, _Type.ENUM, _Type.ENUM8, _Type.ENUM16}
_ZONED = {_Type.TIMESTAMPTZ, _Type.TIMESTAMPLTZ}
_INSTANTS = {*_ZONED, _Type.TIMESTAMP, _Type.TIMESTAMPNTZ, _Type.TIMESTAMP_S, _Type.TIMESTAMP_MS}
_INSTANTS |= {_Type.TIMESTAMP_NS, _Type.DATE, _Type.DATE32, _Type.DATETIME, _Type.DATETIME64}

#: (finer than microseconds, with a zone) -> the kind of time
_KINDS = {
    (False, False): TimeKind.TIMESTAMP,
    (False, True): TimeKind.TIMESTAMP_WITH_ZONE,
    (True, False): TimeKind.NANOSECONDS,
    (True, True): TimeKind.NANOSECONDS_WITH_ZONE,
}


class Several(str):
    """What takes the place of a type where the files of a source have several; no column holds such."""


def _among(kinds: set[exp.DType]) -> Callable[["Types", str], bool]:
    """Return the method that tells whether a column of a type holds one of some kinds."""
    return lambda types, named: (kind := types._read(named)) is not None and kind.this in kinds


@dataclass(frozen=True)
class Types:
    """The types of an engine: its dialect of sqlglot, and names that this takes for other ones."""

    dialect: str
    others: tuple[tuple[str, str], ...] = ()

    def time_kind(self, type_name: str) -> TimeKind | None:
        """Return the kind of time of a column of this type; None if it is not a time."""
        kind = self._read(type_name)
        if kind is None or kind.this not in {*_INTEGERS, *_INSTANTS}:
            return None
        if kind.this in _INTEGERS:
            return TimeKind.COUNTER
        # What is in brackets behind a type: its digits, a zone.
        parameters = [
            str(parameter.this.this)
            for parameter in kind.expressions
            if isinstance(parameter, exp.DataTypeParam)
        ]
        digits = next((int(parameter) for parameter in parameters if parameter.isdecimal()), 0)
        zoned = kind.this in _ZONED or any(not parameter.isdecimal() for parameter in parameters)
        return _KINDS[kind.this is _Type.TIMESTAMP_NS or digits > 6, zoned]

    is_numeric = _among(_NUMBERS)  # truth is none
    is_truth = _among({_Type.BOOLEAN})
    is_whole = _among(_INTEGERS)
    is_binary_float = _among({_Type.FLOAT, _Type.DOUBLE})  # rounded to so many bits
    is_name = _among(_NAMES)  # of an asset or a channel
    is_text = _among(_TEXTS)

    def _read(self, type_name: str) -> exp.DataType | None:
        """Return a type as a node, without its wrappers; None if it is unknown."""
        if isinstance(type_name, Several):
            return None
        for other, meant in self.others:
            type_name = re.sub(rf"\b{other}\b", meant, type_name, flags=re.IGNORECASE)
        try:
            read: exp.Expr = exp.DataType.build(type_name, dialect=self.dialect)
        except (SqlglotError, AttributeError):  # the latter for an object identifier of PostgreSQL
            return None
        while isinstance(read, exp.DataType) and read.this is _Type.LOWCARDINALITY:
            read = read.expressions[0]
        return read if isinstance(read, exp.DataType) and isinstance(read.this, _Type) else None


#: Of engines that nobody connects to.
USUAL = Types("duckdb")
