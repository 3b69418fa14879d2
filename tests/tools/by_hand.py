"""One step of ``sql/`` over rows that are written by hand, in DuckDB: what a file says by itself."""

from collections.abc import Mapping
from typing import Any

import duckdb
import pyarrow as pa
from sqlglot import exp

from gam_db.composing.pipeline import filled
from gam_db.composing.template import Slot, text


def rows(columns: str, *values: tuple[Any, ...]) -> pa.Table:
    """Return a table of these columns, by their names; one that holds only None is of integers."""
    names = columns.split()
    arrays = [pa.array([row[place] for row in values]) for place in range(len(names))]
    arrays = [one.cast(pa.int64()) if pa.types.is_null(one.type) else one for one in arrays]
    return pa.table(dict(zip(names, arrays, strict=True)))


def fetched(query: exp.Query, **tables: pa.Table) -> list[tuple[Any, ...]]:
    """Return the rows of a query over tables, by their names; sorted if it does not sort them itself."""
    with duckdb.connect() as connection:
        for name, table in tables.items():
            connection.register(name, table)
        found = connection.execute(query.sql("duckdb")).fetchall()
    if query.args.get("order") is None:
        found.sort(key=lambda row: [(one is None, one) for one in row])
    return found


def step(
    path: str, slots: Mapping[str, Slot | str] | None = None, **tables: pa.Table
) -> list[tuple[Any, ...]]:
    """Return the rows of a file of ``sql/`` over what it reads, likewise; a slot may hold a text."""
    said = {name: text(one) if isinstance(one, str) else one for name, one in (slots or {}).items()}
    return fetched(filled(path, said), **tables)
