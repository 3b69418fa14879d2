"""Units: what the columns of a result are counted in, kept in the schema of the Arrow table."""

import pyarrow as pa

from gam_db.clock import TimeKind
from gam_db.version import __version__

_SHARE, _VECTORS, _SAMPLES = "share, 0 to 1", "vectors", "samples"
_VALUES, _TICKS, _TIME = "of the source's values", "ticks", "time"

#: unit -> the columns that are in it; ticks and time are said by how the source tells time.
_COLUMNS = {
    _SHARE: "hi floor floor_sd floor_max good_turing healthy_hi learned_floor hi_limit",
    _VECTORS: "novel_in_window vectors_in_window novel out_of_range calibration_vectors missing_vectors "
    "vectors vectors_needed learned_vectors window",
    _SAMPLES: "samples calibration_samples missing longest_still cycle_length "
    "still_after calibration_still longest_run",
    "cells": "cells learned_cells",
    "rows": "readings without_time repeated",
    "instants": "conflicts",
    _VALUES: "calibrated_lo calibrated_hi lowest highest quantum calibration_lowest calibration_highest",
    _TICKS: "first_tick last_tick typical_step short_step long_step longest_step shortest_pause "
    "longest_pause",
    _TIME: "time first_time last_time onset_time",
    "thousandths of the root of a count": "root reference height cap centre spread evidence",
    "per judgement": "rate stated_rate",
    "judgements": "judgement onset first_judgement last_judgement last_zero",
}
_UNIT_OF = {column: unit for unit, columns in _COLUMNS.items() for column in columns.split()}


def with_units(table: pa.Table, kind: TimeKind) -> pa.Table:
    """Return a result with units and the way of telling time in its schema.

    The metadata of the schema hold ``gam_db`` (the version) and ``time`` (UTC or counter), those of a
    column its ``unit``.
    """
    ticks = "steps of the source's counter" if kind.is_counter else "microseconds since 1970 (UTC)"
    said = {_TICKS: ticks, _TIME: ticks if kind.is_counter else "UTC"}
    fields = []
    for field in table.schema:
        unit = _UNIT_OF.get(field.name)
        fields.append(field if unit is None else field.with_metadata({"unit": said.get(unit, unit)}))
    of_all = {"gam_db": __version__, "time": "counter" if kind.is_counter else "UTC"}
    return pa.Table.from_arrays(table.columns, schema=pa.schema(fields, of_all))
