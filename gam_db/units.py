"""Units: what the columns of a result are counted in, kept in the schema of the Arrow table."""

import pyarrow as pa

from gam_db import data
from gam_db.clock import TimeKind
from gam_db.version import __version__

_TICKS, _TIME = "ticks", "time"

_UNIT_OF = {
    column: unit
    for unit, columns in data.table("gam_db", "units.toml").items()
    for column in columns.split()
}


def time_type(kind: TimeKind) -> pa.DataType:
    """Return the type of instants as the source tells them."""
    return pa.int64() if kind.is_counter else pa.timestamp("us", "UTC" if kind.has_zone else None)


def with_units(table: pa.Table, kind: TimeKind) -> pa.Table:
    """Return a result with units and the way of telling time in its schema.

    The metadata of the schema hold ``gam_db`` (the version) and ``time`` (UTC or counter), those of a
    column its ``unit``.
    """
    ticks = "steps of the source's counter" if kind.is_counter else "microseconds since 1970 (UTC)"
    unit_names = {_TICKS: ticks, _TIME: ticks if kind.is_counter else "UTC"}
    fields = []
    for field in table.schema:
        unit = _UNIT_OF.get(field.name)
        fields.append(
            field if unit is None else field.with_metadata({"unit": unit_names.get(unit, unit)})
        )
    of_all = {"gam_db": __version__, "time": "counter" if kind.is_counter else "UTC"}
    return pa.Table.from_arrays(table.columns, schema=pa.schema(fields, of_all))
