"""The columns of Arrow tables, said in few words."""

import pyarrow as pa

COUNT, SHARE, WORD, TRUTH = pa.int64(), pa.float64(), pa.string(), pa.bool_()


def columns(*said: tuple[pa.DataType, str]) -> pa.Schema:
    """Return a schema: types, each with the names of columns that have it, in order."""
    return pa.schema([(name, of) for of, names in said for name in names.split()])


def counts(names: str) -> pa.Schema:
    """Return a schema of integers."""
    return columns((COUNT, names))
