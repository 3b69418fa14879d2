"""How rows of ClickHouse go into Arrow tables and back."""

from collections.abc import Callable

import pyarrow as pa

from gam_db.errors import SourceError

_INT64 = pa.int64()


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
