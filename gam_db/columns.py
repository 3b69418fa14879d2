"""The columns of Arrow tables, said in few words; and tables of rows, made without pandas."""

from collections.abc import Mapping, Sequence
from itertools import accumulate
from operator import itemgetter
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

COUNT, SHARE, WORD, TRUTH = pa.int64(), pa.float64(), pa.string(), pa.bool_()

#: The name of the channel that a row speaks of.
name_of = itemgetter("asset", "channel")


def columns(*typed_names: tuple[pa.DataType, str]) -> pa.Schema:
    """Return a schema: types, each with the names of columns that have it, in order."""
    return pa.schema([(name, of) for of, names in typed_names for name in names.split()])


def counts(names: str) -> pa.Schema:
    """Return a schema of integers."""
    return columns((COUNT, names))


def table_of(rows: Sequence[Mapping[str, Any]], schema: pa.Schema) -> pa.Table:
    """Return rows as a table: of each row what the schema has columns for, and NULL for what it lacks.

    Arrow's own calls load pandas wherever it is installed, which takes as long as scoring many rows.

    Args:
        rows: values by the names of their columns.
        schema: integers, doubles, texts and truths.
    """
    arrays = [_array([row.get(field.name) for row in rows], field.type) for field in schema]
    return pa.Table.from_arrays(arrays, schema=schema)


_NUMBERS = {COUNT: np.int64, SHARE: np.float64}


def _array(values: Sequence[Any], of: pa.DataType) -> pa.Array:
    valid = _bits(np.fromiter((value is not None for value in values), bool, len(values)))
    if of == WORD:
        texts = [b"" if value is None else value.encode() for value in values]
        ends = np.fromiter(accumulate(map(len, texts), initial=0), np.int32, len(texts) + 1)
        held = [pa.py_buffer(ends), pa.py_buffer(b"".join(texts))]
    elif of == TRUTH:
        held = [_bits(np.fromiter(map(bool, values), bool, len(values)))]
    else:
        numbers = (0 if value is None else value for value in values)
        held = [pa.py_buffer(np.fromiter(numbers, _NUMBERS[of], len(values)))]
    return pa.Array.from_buffers(of, len(values), [valid, *held])


def _bits(truths: NDArray[np.bool_]) -> pa.Buffer:
    return pa.py_buffer(np.packbits(truths, bitorder="little"))
