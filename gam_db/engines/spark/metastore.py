"""Tables in the metastore of the user's own session: Parquet, or Delta or Iceberg where it has them."""

import secrets
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sqlglot
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.engines.spark.tables import Rewriting, same_keys

#: In how many schemas tables are looked for, beside the current one.
_SCHEMAS = 50


def format_of(session: Any) -> str:
    """Return the format of new tables: that of the current catalogue, by its settings."""
    catalogue = session.catalog.currentCatalog()
    said = session.conf.get(f"spark.sql.catalog.{catalogue}", "").lower()
    return next((name for name in ("delta", "iceberg") if name in said), "parquet")


class MetastoreTables(Rewriting):
    """Tables and views of the metastore, in a form: ``parquet``, ``delta`` or ``iceberg``."""

    def __init__(self, session: Any, run: Callable[[str], Any], engine: Engine, form: str) -> None:
        super().__init__(session, run, engine)
        self._form = form

    def execute(self, text: str) -> None:
        """Run a statement that changes something."""
        tree = sqlglot.parse_one(text, dialect="spark") if text.startswith("INSERT OVERWRITE") else None
        if tree is None:
            self._run(text)
        else:
            columns = [column.name for column in tree.this.expressions]
            self._exchange(tree.this.this, columns, tree.expression)

    def delete(self, table: exp.Table, keys: Sequence[str], found: exp.Query) -> None:
        """Delete rows by their keys: Delta and Iceberg do, a Parquet table is pointed to other files."""
        if self._form != "parquet":
            self._do(_merge(table, keys, found))
            return
        columns = self._columns(table)
        rows = self.staying(table, columns, keys, found)
        if rows is not None:
            self._exchange(table, columns, rows)

    def _exchange(self, table: exp.Table, columns: Sequence[str], rows: exp.Query) -> None:
        """Write what a Parquet table is to have to other files, and point it to them."""
        before = self._place(table)
        after = f"{before.rstrip('/')}-{secrets.token_hex(4)}"
        self.write_beside(table, columns, rows, after)
        moved = exp.AlterSet(location=template.text(after))
        self._do(exp.Alter(this=table.copy(), kind="TABLE", actions=[moved]))
        self._remove(before)

    def names(self) -> list[tuple[str, ...]]:
        """Return what can be read: of the current catalogue, by schema, and views of the session."""
        catalogue = self._session.catalog.currentCatalog()
        schemas = [row[0] for row in self._run("SHOW SCHEMAS").collect()]
        current = self._session.catalog.currentDatabase()
        found: list[tuple[str, ...]] = []
        for schema in [current, *(one for one in schemas[:_SCHEMAS] if one != current)]:
            shown = template.name(schema).sql(dialect="spark")
            rows = self._session.catalog.listTables(shown)
            found += [(row.name,) if row.isTemporary else (catalogue, schema, row.name) for row in rows]
        return found

    def relations(self, schema: str | None) -> Mapping[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, as they are now."""
        name = schema or self._session.catalog.currentDatabase()
        shown = template.name(name).sql(dialect="spark")
        found: dict[str, tuple[str, ...]] = {}
        if schema is not None and not self._session.catalog.databaseExists(schema):
            return found
        for row in self._session.catalog.listTables(shown):
            if not row.isTemporary:
                table = exp.Table(this=template.name(row.name), db=template.name(name))
                self._do(exp.Refresh(this=table.copy(), kind="TABLE"))
                found[row.name.casefold()] = self._columns(table)
        return found

    def _place(self, table: exp.Table) -> str:
        asked = exp.Describe(this=table.copy(), style="EXTENDED", kind="TABLE")
        rows = self._do(asked).collect()
        return next(str(row[1]) for row in reversed(rows) if row[0] == "Location")

    def _remove(self, place: str) -> None:
        context = self._session.sparkContext
        path = context._jvm.org.apache.hadoop.fs.Path(place)
        path.getFileSystem(context._jsc.hadoopConfiguration()).delete(path, True)


def _merge(table: exp.Table, keys: Sequence[str], found: exp.Query) -> exp.Merge:
    """Return what deletes by keys where DELETE takes no query: Delta's does not."""
    gone = exp.select(*(exp.column(template.name(key)) for key in keys)).distinct()
    matched = exp.When(matched=True, then=exp.var("DELETE"))
    return exp.Merge(
        this=table.copy().as_("staying"),
        using=gone.from_(found.subquery("found")).subquery("gone"),
        on=same_keys(keys),
        whens=exp.Whens(expressions=[matched]),
    )
