"""How Arrow tables go into ClickHouse."""

from collections.abc import Callable

import pyarrow as pa

from gam_db.engines.driver import is_text
from gam_db.errors import SourceError


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
        held = pa.string() if is_text(held) else pa.float64() if pa.types.is_float16(held) else held
        fields.append(pa.field(field.name, held))
    return rows.cast(pa.schema(fields))


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
    (is_text, lambda held: "String"),
    (pa.types.is_null, lambda held: "UInt8"),
)
