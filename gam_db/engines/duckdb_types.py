"""What DuckDB's column types mean to the method, and which columns of an Arrow table it can hold."""

import pyarrow as pa

from gam_db.clock import TimeKind
from gam_db.errors import SourceError

_KINDS = {
    "TIMESTAMP": TimeKind.TIMESTAMP,
    "TIMESTAMP_S": TimeKind.TIMESTAMP,
    "TIMESTAMP_MS": TimeKind.TIMESTAMP,
    "DATE": TimeKind.TIMESTAMP,
    "TIMESTAMP_NS": TimeKind.NANOSECONDS,
    "TIMESTAMP WITH TIME ZONE": TimeKind.TIMESTAMP_WITH_ZONE,
    "TIMESTAMPTZ_NS": TimeKind.NANOSECONDS_WITH_ZONE,
}
_INTEGERS = {f"{sign}{size}INT" for sign in ("", "U") for size in ("TINY", "SMALL", "BIG", "HUGE")}
_INTEGERS |= {"INTEGER", "UINTEGER"}


def time_kind(type_name: str) -> TimeKind | None:
    """Return how a column of this type tells time; None if it does not."""
    return TimeKind.COUNTER if type_name in _INTEGERS else _KINDS.get(type_name)


def is_numeric(type_name: str) -> bool:
    """Tell whether a column of this type holds numbers (BOOLEAN does not)."""
    plain = _without_size(type_name)
    return plain in _INTEGERS or plain in ("DOUBLE", "FLOAT", "DECIMAL")


def is_name(type_name: str) -> bool:
    """Tell whether a column of this type can name an asset or a channel."""
    plain = _without_size(type_name)
    return plain in _INTEGERS or plain in ("VARCHAR", "ENUM", "UUID")


def is_text(type_name: str) -> bool:
    """Tell whether a column of this type holds text."""
    return type_name == "VARCHAR"


def check_columns(table: pa.Table) -> None:
    """Refuse an Arrow table whose columns DuckDB cannot tell apart.

    Raises:
        SourceError: it has no columns, or names that differ by case only.
    """
    if not table.column_names:
        raise SourceError("The Arrow table has no columns.")
    seen: dict[str, str] = {}
    for name in table.column_names:
        twin = seen.get(name.casefold())
        if twin is not None:
            raise SourceError(
                f"The Arrow table has the columns {twin!r} and {name!r}, which DuckDB cannot tell "
                "apart; rename one of them."
            )
        seen[name.casefold()] = name


def _without_size(type_name: str) -> str:
    """Return DECIMAL for DECIMAL(10,2), but DECIMAL(10,2)[] as it is."""
    return type_name.partition("(")[0] if type_name.endswith(")") else type_name
