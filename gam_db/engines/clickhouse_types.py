"""What ClickHouse's column types mean to the method, and how its rows go into Arrow tables and back."""

import re
from collections.abc import Callable

import pyarrow as pa

from gam_db.clock import TimeKind
from gam_db.errors import SourceError

_WRAPPED = re.compile(r"(?:Nullable|LowCardinality)\((.*)\)")
_INTEGER = re.compile(r"U?Int(?:8|16|32|64|128|256)")
_NUMBER = re.compile(r"Float32|Float64|BFloat16|Decimal\(.*\)")
_NAME = re.compile(r"String|FixedString\([0-9]+\)|Enum(?:8|16)\(.*\)|UUID", re.DOTALL)
_INSTANT = re.compile(r"DateTime(?:64\((?P<digits>[0-9])(?P<zone64>,.*)?\)|(?P<zone>\(.*\))?)")

_INT64 = pa.int64()


def plain(type_name: str) -> str:
    """Return a type without Nullable and LowCardinality around it."""
    wrapped = _WRAPPED.fullmatch(type_name)
    return plain(wrapped[1]) if wrapped else type_name


def time_kind(type_name: str) -> TimeKind | None:
    """Return how a column of this type tells time; None if it does not.

    Every DateTime is an instant of its own, whatever zone it is shown in; a zone in its type is taken
    for one that the source has.
    """
    name = plain(type_name)
    if _INTEGER.fullmatch(name):
        return TimeKind.COUNTER
    if name in ("Date", "Date32"):
        return TimeKind.TIMESTAMP
    found = _INSTANT.fullmatch(name)
    if found is None:
        return None
    zoned = bool(found["zone"] or found["zone64"])
    if int(found["digits"] or 0) > 6:
        return TimeKind.NANOSECONDS_WITH_ZONE if zoned else TimeKind.NANOSECONDS
    return TimeKind.TIMESTAMP_WITH_ZONE if zoned else TimeKind.TIMESTAMP


def is_numeric(type_name: str) -> bool:
    """Tell whether a column of this type holds numbers (Bool does not)."""
    name = plain(type_name)
    return bool(_INTEGER.fullmatch(name) or _NUMBER.fullmatch(name))


def is_name(type_name: str) -> bool:
    """Tell whether a column of this type can name an asset or a channel."""
    name = plain(type_name)
    return bool(_INTEGER.fullmatch(name) or _NAME.fullmatch(name))


def is_text(type_name: str) -> bool:
    """Tell whether a column of this type holds text."""
    return plain(type_name) == "String"


def column_type(arrow: pa.DataType) -> str:
    """Return the type of a column that holds what an Arrow column does, NULL included.

    Raises:
        SourceError: no column of ClickHouse does.
    """
    for is_of, name in _COLUMN_TYPES:
        if is_of(arrow):
            return f"Nullable({name(arrow)})"
    raise SourceError(
        f"ClickHouse cannot read the Arrow table; it holds a column of the type {arrow}. Cast it, or "
        "leave it out."
    )


def insertable(rows: pa.Table) -> pa.Table:
    """Return an Arrow table without dictionaries and views, which go in as other types."""
    fields = []
    for field in rows.schema:
        held = field.type
        held = held.value_type if pa.types.is_dictionary(held) else held
        held = pa.string() if _is_text(held) else pa.float64() if pa.types.is_float16(held) else held
        fields.append(pa.field(field.name, held))
    return rows.cast(pa.schema(fields))


def fetched(rows: pa.Table) -> pa.Table:
    """Return rows with integers as int64, numbers as float64, names as string; all can be NULL.

    Cause: ClickHouse counts in UInt64, takes the smallest type for a literal, and has columns that
    cannot be NULL. Symptom: one and the same query gives rows of other types than other engines do.
    """
    return rows.cast(pa.schema([pa.field(field.name, _usual(field.type)) for field in rows.schema]))


def _usual(arrow: pa.DataType) -> pa.DataType:
    if pa.types.is_integer(arrow):
        return _INT64
    if pa.types.is_floating(arrow):
        return pa.float64()
    if pa.types.is_dictionary(arrow):
        return _usual(arrow.value_type)
    if _is_text(arrow):
        return pa.string()
    if pa.types.is_timestamp(arrow) and arrow.tz is not None:
        return pa.timestamp(arrow.unit, "UTC")
    return arrow


def _is_text(arrow: pa.DataType) -> bool:
    return bool(
        pa.types.is_string(arrow) or pa.types.is_large_string(arrow) or pa.types.is_string_view(arrow)
    )


def _instant(arrow: pa.TimestampType) -> str:
    digits = {"s": 0, "ms": 3, "us": 6, "ns": 9}[arrow.unit]
    return f"DateTime64({digits})" if arrow.tz is None else f"DateTime64({digits}, 'UTC')"


_COLUMN_TYPES: tuple[tuple[Callable[[pa.DataType], bool], Callable[[pa.DataType], str]], ...] = (
    (pa.types.is_boolean, lambda held: "Bool"),
    (pa.types.is_signed_integer, lambda held: f"Int{held.bit_width}"),
    (pa.types.is_unsigned_integer, lambda held: f"UInt{held.bit_width}"),
    (pa.types.is_floating, lambda held: f"Float{max(held.bit_width, 32)}"),
    (pa.types.is_decimal, lambda held: f"Decimal({held.precision}, {held.scale})"),
    (pa.types.is_timestamp, _instant),
    (pa.types.is_date, lambda held: "Date32"),
    (_is_text, lambda held: "String"),
    (pa.types.is_null, lambda held: "UInt8"),
)
