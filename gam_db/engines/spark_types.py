"""What Spark's types mean: how time is told, what holds numbers, what can name a channel."""

from gam_db.clock import TimeKind

_KINDS = {
    "timestamp": TimeKind.TIMESTAMP_WITH_ZONE,
    "timestamp_ltz": TimeKind.TIMESTAMP_WITH_ZONE,
    "timestamp_ntz": TimeKind.TIMESTAMP,
    "date": TimeKind.TIMESTAMP,
}
_INTEGERS = ("tinyint", "smallint", "int", "bigint")


def time_kind(type_name: str) -> TimeKind | None:
    """Return how a column of this type tells time; None if it does not."""
    return TimeKind.COUNTER if type_name in _INTEGERS else _KINDS.get(type_name)


def is_numeric(type_name: str) -> bool:
    """Tell whether a column of this type holds numbers."""
    return type_name in (*_INTEGERS, "float", "double") or _plain(type_name) == "decimal"


def is_name(type_name: str) -> bool:
    """Tell whether a column of this type can name an asset or a channel."""
    return type_name in _INTEGERS or is_text(type_name)


def is_text(type_name: str) -> bool:
    """Tell whether a column of this type holds text."""
    return _plain(type_name) in ("string", "varchar", "char")


def _plain(type_name: str) -> str:
    """Return decimal for decimal(10,2), string for string collate UTF8_LCASE."""
    return type_name.partition("(")[0].partition(" ")[0]
