"""What Python holds as Arrow tables: frames, streams, and single signals as arrays or series.

This module owns which objects those are, and what time is in a single signal.
"""

from typing import Any

import numpy as np
import pyarrow as pa

from gam_db.errors import SourceError, wrong

#: The columns of a single signal, but that readings are called like a series that has a name.
TIME, VALUE = "time", "value"
_OTHER_TIME = "instant"
"""The name of the time of a series that is itself called time."""

_NUMBERS = "biuf"
"""Kinds of NumPy's types whose values are numbers, or true and false."""


def arrow_table(relation: Any) -> pa.Table:
    """Return an object that holds a table, or a single signal, as an Arrow table.

    That is one with ``__arrow_c_stream__`` (Arrow, pandas, polars, DuckDB), a frame that has yet to be
    collected (polars), a table that runs elsewhere (Ibis), or what :func:`signal_table` takes.

    Raises:
        SourceError: it is none of these, or its columns cannot be told apart or read.
    """
    if (signal := signal_table(relation)) is not None:
        return signal
    if _is_of(relation, "polars") and hasattr(relation, "collect"):
        relation = relation.collect()
    elif not hasattr(relation, "__arrow_c_stream__") and hasattr(relation, "to_pyarrow"):
        relation = relation.to_pyarrow()
    if not hasattr(relation, "__arrow_c_stream__"):
        raise wrong("no_relation", kind=type(relation).__name__)
    try:
        table = relation if isinstance(relation, pa.Table) else pa.table(relation)
    except pa.ArrowException as error:
        raise wrong("objects_in_a_frame", column=_unreadable_column(relation)) from error
    check_columns(table)
    return table


def check_columns(table: pa.Table) -> None:
    """Refuse an Arrow table whose columns DuckDB cannot tell apart.

    Raises:
        SourceError: it has no columns, or names that differ by case only.
    """
    if not table.column_names:
        raise SourceError("The Arrow table has no columns.")
    seen: dict[str, str] = {}
    for name in table.column_names:
        if (twin := seen.get(name.casefold())) is not None:
            raise wrong("arrow_names_alike", twin=twin, name=name)
        seen[name.casefold()] = name


def signal_table(signal: Any) -> pa.Table | None:
    """Return a single signal as a table of two columns, time and readings; None if it is none.

    A signal is a 1-D array of NumPy or Arrow, or a series of pandas or polars. The index of a pandas
    series tells the time, as a DatetimeIndex or as whole numbers; all others are counted 0, 1, 2, ...
    Readings are called like the series, or ``value``.

    Raises:
        SourceError: it has not one dimension, its readings are no numbers, or its index tells no time.
    """
    if isinstance(signal, np.ndarray):
        return _table(_of_numpy(signal))
    if _is_of(signal, "pandas", "Series"):
        readings = _numbers(signal, signal.dtype)
        return _table(readings, signal.name, _times(signal.index))
    if isinstance(signal, (pa.Array, pa.ChunkedArray)):
        return _table(_numbers(signal, signal.type))
    if _is_of(signal, "polars", "Series"):
        return _table(_numbers(pa.chunked_array(signal), signal.dtype), signal.name)
    return None


def _table(readings: Any, name: Any = None, time: Any = None) -> pa.Table:
    called = VALUE if name is None or name == "" else str(name)
    when = TIME if called.casefold() != TIME else _OTHER_TIME
    return pa.table({when: np.arange(len(readings)) if time is None else time, called: readings})


def _of_numpy(array: np.ndarray[Any, Any]) -> pa.Array:
    if array.ndim != 1:
        raise wrong("dimensions_of_an_array", dimensions=array.ndim)
    if array.dtype.kind not in _NUMBERS:
        raise wrong("readings_of_an_array", kind=array.dtype)
    if array.dtype.kind == "f" and array.dtype != np.float32:
        array = array.astype(np.float64)  # Arrow and DuckDB do not read all floats
    return pa.array(array.astype(array.dtype.newbyteorder("="), copy=False))


def _numbers(values: Any, kind: Any) -> Any:
    """Return readings as Arrow has them; refuse what holds no numbers."""
    try:
        readings = values if isinstance(values, (pa.Array, pa.ChunkedArray)) else pa.array(values)
    except (pa.ArrowException, TypeError, ValueError) as error:
        raise wrong("readings_of_an_array", kind=kind) from error
    of = readings.type
    if pa.types.is_dictionary(of):
        of = of.value_type
    is_number = (
        pa.types.is_integer,
        pa.types.is_floating,
        pa.types.is_decimal,
        pa.types.is_boolean,
        pa.types.is_null,
    )
    if not any(test(of) for test in is_number):
        raise wrong("readings_of_an_array", kind=kind)
    return readings.cast(pa.float64()) if pa.types.is_float16(of) or pa.types.is_null(of) else readings


def _times(index: Any) -> Any:
    """Return the index of a pandas series as a column of time."""
    if _is_of(index, "pandas", "DatetimeIndex"):
        return pa.array(index)
    kind = getattr(index.dtype, "kind", "")
    if kind in "iu":
        return pa.array(index)
    if kind == "f":
        values = index.to_numpy(np.float64, na_value=np.nan)
        if (np.isfinite(values) & (np.abs(values) <= 2**53) & (values == np.floor(values))).all():
            return values.astype(np.int64)
        raise wrong("fractions_in_an_index")
    raise wrong("index_of_a_series", kind=type(index).__name__, of=index.dtype)


def _is_of(instance: Any, package: str, kind: str | None = None) -> bool:
    """Tell whether an object is of a package, and of a class of it, without importing the package."""
    return any(
        of.__module__.partition(".")[0] == package and kind in (None, of.__name__)
        for of in type(instance).__mro__
    )


def _unreadable_column(frame: Any) -> Any:
    """Return the name of the first column of a frame that Arrow cannot read; of others a question."""
    for name in getattr(frame, "columns", ()):
        try:
            pa.array(frame[name])
        except (pa.ArrowException, TypeError, ValueError):
            return name
    return "?"
