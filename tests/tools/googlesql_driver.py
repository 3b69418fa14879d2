"""A driver on GoogleSQL's reference implementation: the stored form at work in BigQuery's own words.

BigQuery has transactions; here their statements run one by one, and nothing is undone.
"""

import pyarrow as pa
from sqlglot import exp

from gam_db.engines import engine_named
from gam_db.engines.base import table_as
from gam_db.engines.driver import Driver
from gam_db.errors import UserError
from googlesql import GoogleSqlError, Plant, Table

ARROW = {"INT64": pa.int64(), "FLOAT64": pa.float64(), "STRING": pa.string(), "BOOL": pa.bool_()}
ARROW["TIMESTAMP"] = pa.timestamp("us", "UTC")
NAMES = {str(kind): name for name, kind in ARROW.items()}


class GoogleSqlDriver(Driver):
    """The tables of a plant, as a driver; see :class:`gam_db.engines.driver.Driver`."""

    engine = engine_named("bigquery")
    errors: tuple[type[Exception], ...] = (GoogleSqlError,)
    most_rows = 1_000_000

    def __init__(self, plant: Plant) -> None:
        self.plant = plant

    def execute(self, statement: str) -> None:
        self.plant.execute(statement)

    def fetch(self, query: str) -> pa.Table:
        return arrow(self.plant.run(query))

    def close(self) -> None:
        """Leave the plant as it is."""

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.plant.execute(self.engine.text(table_as(table, query)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        columns = {field.name: NAMES[str(field.type)] for field in rows.schema}
        cells = [column.to_pylist() for column in rows.columns]
        self.plant.tables[table.name] = Table(columns, list(zip(*cells, strict=True)))

    def drop(self, table: exp.Table) -> None:
        self.plant.execute(self.engine.text(exp.Drop(tables=[table], kind="TABLE")))

    def tables(self) -> list[tuple[str, ...]]:
        return [(name,) for name in self.plant.relations()]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        probe = exp.select(exp.Star()).from_(relation.copy()).limit(0)
        return dict(self.plant.run(self.engine.text(probe)).columns)

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        assert schema is None
        return {name: tuple(columns) for name, columns in self.plant.relations().items()}

    def problem(self, error: Exception) -> UserError | None:
        return None


def arrow(table: Table) -> pa.Table:
    """Return the rows of a table as Arrow."""
    kinds = {name: ARROW[kind] for name, kind in table.columns.items()}
    cells = zip(*table.rows, strict=True) if table.rows else [()] * len(kinds)
    made = [pa.array(list(one), kind) for one, kind in zip(cells, kinds.values(), strict=True)]
    return pa.table(dict(zip(kinds, made, strict=True)))
