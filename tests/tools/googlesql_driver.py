"""A driver on GoogleSQL's reference implementation: the stored form at work in BigQuery's own words.

BigQuery has transactions; here their statements run one by one, and nothing is undone.
"""

from collections.abc import Sequence

import pyarrow as pa
from sqlglot import exp

from gam_db.engines import engine_named
from gam_db.engines.base import deletion, table_as
from gam_db.errors import SourceError, UserError
from googlesql import GoogleSqlError, Plant, Table

ARROW = {"INT64": pa.int64(), "FLOAT64": pa.float64(), "STRING": pa.string(), "BOOL": pa.bool_()}
ARROW["TIMESTAMP"] = pa.timestamp("us", "UTC")
NAMES = {str(kind): name for name, kind in ARROW.items()}


class GoogleSqlDriver:
    """The tables of a plant, as a driver; see :class:`gam_db.engines.warehouse.Driver`."""

    engine = engine_named("bigquery")
    transactions = True
    errors: tuple[type[Exception], ...] = (GoogleSqlError,)

    def __init__(self, plant: Plant) -> None:
        self.plant = plant

    def execute(self, statement: str) -> None:
        self.plant.execute(statement)

    def fetch(self, query: str) -> pa.Table:
        return arrow(self.plant.run(query))

    def begin(self) -> None:
        """Leave the plant as it is."""

    commit = rollback = close = begin

    def in_transaction(self) -> bool:
        return False

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.plant.execute(self.engine.text(table_as(table, query)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        columns = {field.name: NAMES[str(field.type)] for field in rows.schema}
        cells = [column.to_pylist() for column in rows.columns]
        self.plant.tables[table.name] = Table(columns, list(zip(*cells, strict=True)))

    def drop(self, table: exp.Table) -> None:
        self.plant.execute(self.engine.text(exp.Drop(tables=[table], kind="TABLE")))

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        self.plant.execute(self.engine.text(deletion(table, keys, found)))

    def located(self, table: exp.Expr) -> exp.Expr:
        """Return the node as it is."""
        return table

    def tables(self) -> list[tuple[str, ...]]:
        return [(name,) for name in self.plant.relations()]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        probe = exp.select(exp.Star()).from_(relation.copy()).limit(0)
        return dict(self.plant.run(self.engine.text(probe)).columns)

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        assert schema is None
        return {name: tuple(columns) for name, columns in self.plant.relations().items()}

    def file(self, path: str) -> exp.Expr:
        raise SourceError(f"{path}: there are no files.")

    def rows_at_once(self) -> int:
        return 1_000_000

    def problem(self, error: Exception) -> UserError | None:
        return None


def arrow(table: Table) -> pa.Table:
    """Return the rows of a table as Arrow."""
    kinds = {name: ARROW[kind] for name, kind in table.columns.items()}
    cells = zip(*table.rows, strict=True) if table.rows else [()] * len(kinds)
    made = [pa.array(list(one), kind) for one, kind in zip(cells, kinds.values(), strict=True)]
    return pa.table(dict(zip(kinds, made, strict=True)))
