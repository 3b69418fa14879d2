"""What the types of columns mean to the method: how time is told, what holds numbers, what can name.

sqlglot reads the names that engines give their types; an engine says what is read otherwise.
"""

import re
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


@dataclass(frozen=True)
class Types:
    """The types of an engine: its dialect of sqlglot, and names that this takes for other ones."""

    dialect: str
    others: tuple[tuple[str, str], ...] = ()

    def time_kind(self, type_name: str) -> TimeKind | None:
        """Return how a column of this type tells time; None if it does not."""
        kind = self._read(type_name)
        if kind is None or kind.this not in {*_INTEGERS, *_INSTANTS}:
            return None
        if kind.this in _INTEGERS:
            return TimeKind.COUNTER
        # What is in brackets behind a type: its digits, a zone.
        said = [str(one.this.this) for one in kind.expressions if isinstance(one, exp.DataTypeParam)]
        digits = next((int(one) for one in said if one.isdecimal()), 0)
        zoned = kind.this in _ZONED or any(not one.isdecimal() for one in said)
        return _KINDS[kind.this is _Type.TIMESTAMP_NS or digits > 6, zoned]

    def is_numeric(self, type_name: str) -> bool:
        """Tell whether a column of this type holds numbers (truth is none)."""
        return self._is_among(_NUMBERS, type_name)

    def is_truth(self, type_name: str) -> bool:
        """Tell whether a column of this type holds true and false."""
        return self._is_among({_Type.BOOLEAN}, type_name)

    def is_whole(self, type_name: str) -> bool:
        """Tell whether a column of this type holds integers."""
        return self._is_among(_INTEGERS, type_name)

    def is_binary_float(self, type_name: str) -> bool:
        """Tell whether a column of this type holds numbers that are rounded to so many bits."""
        return self._is_among({_Type.FLOAT, _Type.DOUBLE}, type_name)

    def is_name(self, type_name: str) -> bool:
        """Tell whether a column of this type can name an asset or a channel."""
        return self._is_among(_NAMES, type_name)

    def is_text(self, type_name: str) -> bool:
        """Tell whether a column of this type holds text."""
        return self._is_among(_TEXTS, type_name)

    def _is_among(self, types: set[exp.DType], type_name: str) -> bool:
        kind = self._read(type_name)
        return kind is not None and kind.this in types

    def _read(self, type_name: str) -> exp.DataType | None:
        """Return a type as a node, without what may stand around it; None if nobody knows it."""
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
