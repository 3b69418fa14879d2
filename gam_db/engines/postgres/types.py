"""How Arrow columns travel to PostgreSQL and back."""

import pyarrow as pa
import pyarrow.compute as pc

from gam_db.engines.driver import is_text
from gam_db.engines.frames import check_columns
from gam_db.errors import wrong

#: the number of a type in PostgreSQL's catalogue -> what its values are in Arrow
ARROW = {
    16: pa.bool_(),
    **dict.fromkeys((20, 21, 23), pa.int64()),
    **dict.fromkeys((700, 701), pa.float64()),
    **dict.fromkeys((18, 19, 25, 1042, 1043), pa.string()),
    1082: pa.date32(),
    1114: pa.timestamp("us"),
    1184: pa.timestamp("us", "UTC"),
}

#: Longer names are cut off by PostgreSQL, with no more than a notice.
_LONGEST_NAME = 63


def travelling(rows: pa.Table) -> tuple[pa.Table, dict[str, str]]:
    """Return an Arrow table in the types that PostgreSQL reads, and PostgreSQL's names of them.

    Times finer than microseconds are floored (method, section 2). A column of a type that has no use
    here arrives as empty ``json``, so that it is refused by its name if it is asked for.

    Raises:
        SourceError: the columns cannot be told apart, or a value does not fit.
    """
    check_columns(rows)
    arrays, types = {}, {}
    for name in rows.column_names:
        if len(name.encode()) > _LONGEST_NAME:
            raise wrong("postgres_long_name", name=name, longest=_LONGEST_NAME)
        try:
            arrays[name], types[name] = _travelling(rows[name])
        except pa.ArrowInvalid as error:
            raise wrong("postgres_arrow", name=name, type=rows[name].type) from error
    return pa.table(arrays), types


def _travelling(column: pa.ChunkedArray) -> tuple[pa.ChunkedArray, str]:
    kind = column.type
    if pa.types.is_dictionary(kind):
        return _travelling(column.cast(kind.value_type))
    if pa.types.is_boolean(kind):
        return column, "boolean"
    if pa.types.is_integer(kind):
        return column.cast(pa.int64()), "bigint"
    if pa.types.is_floating(kind):
        return column.cast(pa.float64()), "double precision"
    if pa.types.is_decimal(kind):
        return column.cast(pa.string()), "numeric"
    if is_text(kind):
        return column.cast(pa.string()), 'text COLLATE "C"'
    if pa.types.is_date(kind):
        return column.cast(pa.date32()), "date"
    if pa.types.is_timestamp(kind):
        zoned = kind.tz is not None
        floored = pc.floor_temporal(column, unit="microsecond") if kind.unit == "ns" else column
        plain = floored.cast(pa.timestamp("us", "UTC" if zoned else None))
        return plain, "timestamp with time zone" if zoned else "timestamp without time zone"
    if pa.types.is_null(kind):
        return column.cast(pa.float64()), "double precision"
    return pa.chunked_array([pa.nulls(len(column), pa.string())]), "json"
