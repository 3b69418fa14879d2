"""Where Spark keeps tables: in a folder with a catalogue of its own, or in the metastore of a session.

This module owns how tables and views are made, dropped and rewritten; the driver asks it before every
statement.
"""

import dataclasses
import os
import secrets
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import sqlglot
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.engines.refusals import CONFLICT
from gam_db.engines.spark.folder import Entry, Folder
from gam_db.engines.spark.opening import scratch
from gam_db.errors import ConflictError, EngineError

#: In how many schemas tables are looked for, beside the current one.
_SCHEMAS = 50


def format_of(session: Any) -> str:
    """Return the format of new tables: that of the current catalogue, by its settings.

    Databricks, which alone has a function CURRENT_VERSION, need not tell its settings: there it is
    Delta.
    """
    if session.catalog.functionExists("current_version"):
        return "delta"
    implementation = session.conf.get(
        f"spark.sql.catalog.{session.catalog.currentCatalog()}", ""
    ).lower()
    return next((name for name in ("delta", "iceberg") if name in implementation), "parquet")


class Rewriting:
    """What tables have in common, wherever a session of Spark keeps them."""

    def __init__(self, session: Any, run: Callable[[str], Any], engine: Engine) -> None:
        self._session, self._run, self._engine = session, run, engine

    def ready(self, text: str) -> None:
        """Let the session know, as they are now, the tables that a statement may name."""

    def close(self) -> None:
        """Remove from the session what does not belong to the user."""

    def _do(self, tree: exp.Expr) -> Any:
        return self._run(self._engine.text(tree))

    def _columns(self, table: exp.Table) -> tuple[str, ...]:
        return tuple(self._session.table(table.sql(dialect="spark")).columns)

    def staying(
        self, table: exp.Table, columns: Sequence[str], keys: Sequence[str], key_rows: exp.Query
    ) -> exp.Query | None:
        """Return the rows of a table that stay; None if none are to go, whose keys are found."""
        same = same_keys(keys)
        rows = exp.select(*(exp.column(template.name(name), table="staying") for name in columns))
        rows = rows.from_(table.copy().as_("staying"))
        doomed = key_rows.subquery("gone")
        any_row = rows.join(doomed.copy(), on=same.copy(), join_type="left semi").limit(1)
        if self._do(any_row).isEmpty():
            return None
        return rows.join(doomed, on=same, join_type="left anti")

    def write_beside(
        self, table: exp.Table, columns: Sequence[str], rows: exp.Query, place: str
    ) -> None:
        """Write rows that a table is to have to a folder that is not there yet."""
        beside = table.copy()
        beside.set("this", template.name(f"{table.name}_{secrets.token_hex(4)}"))
        parts = [exp.LikeProperty(this=table.copy()), exp.LocationProperty(this=template.text(place))]
        properties = exp.Properties(expressions=parts)
        self._do(exp.Create(this=beside, kind="TABLE", properties=properties))
        names = [template.name(name) for name in columns]
        self._do(exp.Insert(this=exp.Schema(this=beside.copy(), expressions=names), expression=rows))
        self._do(exp.Drop(tables=[beside.copy()], kind="TABLE"))


def same_keys(keys: Sequence[str]) -> exp.Expr:
    """Return the condition that a row of *staying* has the keys of one of *gone*."""
    staying, gone = (
        [exp.column(template.name(key), table=of) for key in keys] for of in ("staying", "gone")
    )
    return exp.and_(*map(exp.Column.eq, staying, gone))


class FolderTables(Rewriting):
    """Tables in a folder.

    They are known to the session when a statement names them, and again if they changed.
    """

    def __init__(self, session: Any, run: Callable[[str], Any], engine: Engine, folder: Folder) -> None:
        super().__init__(session, run, engine)
        self._folder = folder
        self._registered: dict[str, tuple[Entry, int]] = {}
        self._schemas: set[str] = set()
        self._database = f"gam_{secrets.token_hex(6)}"
        self._make_schema(self._database)
        session.catalog.setCurrentDatabase(self._database)

    def ready(self, text: str) -> None:
        """Let the session know, as they are now, the tables that a statement may name."""
        entries = self._folder.entries()
        for key in [key for key in self._registered if key not in entries]:
            self._forget(key)
        self._tell_named(text, entries, set())

    def execute(self, text: str) -> None:
        """Run a statement that changes something, and keep what it makes."""
        tree = sqlglot.parse_one(text, dialect="spark")
        if isinstance(tree, exp.Create) and str(tree.kind) in ("SCHEMA", "DATABASE"):
            self._make_schema(tree.this.db or tree.this.name)
        elif isinstance(tree, exp.Create) and str(tree.kind) == "TABLE":
            self._create_table(tree)
        elif isinstance(tree, exp.Create) and str(tree.kind) == "VIEW":
            self.ready(text)
            self._create_view(tree, text)
        elif isinstance(tree, exp.Drop):
            self.ready(text)
            self._drop(tree, text)
        else:
            self.ready(text)
            self._run(text)
            self._note(tree)

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        """Write the rows that stay to another folder, and let the table be that."""
        self.ready(f"{table.name} {self._engine.text(key_rows)}")
        self._exchange(table, lambda columns: self.staying(table, columns, keys, key_rows))

    def _exchange(self, table: exp.Table, rows_of: Callable[[Sequence[str]], exp.Query | None]) -> None:
        """Write what a table is to have, if it is to change, to another folder, and let it be that."""
        entry = self._folder.entries()[_key(table)]
        before = _files(self._folder.place(entry))
        if (rows := rows_of(entry.columns)) is None:
            return
        data = self._folder.new_data(entry.schema, entry.name)
        self.write_beside(table, entry.columns, rows, str(self._folder.path / data))
        if self._folder.entries().get(entry.key) != entry or _files(self._folder.place(entry)) != before:
            self._folder.sweep(entry.schema, entry.name, [entry.data or ""])
            raise ConflictError(CONFLICT)
        self._folder.put(dataclasses.replace(entry, data=data))
        self.ready(table.name)
        self._folder.sweep(entry.schema, entry.name, [data])

    def names(self) -> list[tuple[str, ...]]:
        """Return what can be read: (schema, name) or (name,)."""
        return [
            (*filter(None, (entry.schema, entry.name)),) for entry in self._folder.entries().values()
        ]

    def relations(self, schema: str | None) -> Mapping[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, names in lower case."""
        return {
            entry.name.casefold(): entry.columns
            for entry in self._folder.entries().values()
            if (entry.schema or "").casefold() == (schema or "").casefold()
        }

    def close(self) -> None:
        """Let the session forget them."""
        for key in list(self._registered):
            self._forget(key)
        for schema in self._schemas:
            gone = exp.Table(db=template.name(schema))
            self._do(exp.Drop(tables=[gone], kind="SCHEMA", exists=True, cascade=True))

    def _tell_named(self, text: str, entries: Mapping[str, Entry], visited: set[str]) -> None:
        """Let Spark know what a statement names, and before a view all that it reads."""
        folded = text.casefold()
        for key, entry in entries.items():
            if key not in visited and entry.name.casefold() in folded:
                visited.add(key)
                if entry.data is None:
                    self._tell_named(entry.statement, entries, visited)
                self._tell(key, entry)

    def _tell(self, key: str, entry: Entry) -> None:
        registered = self._registered.get(key)
        changed = _changed(self._folder.place(entry)) if entry.data else 0
        if registered and registered[0] == entry:
            if registered[1] != changed:
                self._do(exp.Refresh(this=_table(entry.name, entry.schema), kind="TABLE"))
                self._registered[key] = entry, changed
            return
        if registered:
            self._forget(key)
        if entry.schema is not None:
            self._make_schema(entry.schema)
        self._run(entry.statement if entry.data is None else self._create_statement(entry))
        self._registered[key] = entry, changed

    def _forget(self, key: str) -> None:
        entry, _ = self._registered.pop(key)
        kind = "VIEW" if entry.data is None else "TABLE"
        self._do(exp.Drop(tables=[_table(entry.name, entry.schema)], kind=kind, exists=True))

    def _note(self, tree: exp.Expr) -> None:
        """Remember how a table is after rows of ours were written: Spark has looked at it again."""
        target = tree.find(exp.Table)
        key = _key(target) if target is not None else ""
        if key in self._registered:
            entry, _ = self._registered[key]
            self._registered[key] = entry, _changed(self._folder.place(entry)) if entry.data else 0

    def _create_table(self, tree: exp.Create) -> None:
        target = tree.find(exp.Table)
        assert target is not None
        if _key(target) in self._folder.entries():
            if tree.args.get("exists"):
                return
            raise EngineError(f"There is a table or view {target.name!r} already.")
        if (schema := target.db or None) is not None:
            self._make_schema(schema)
        columns = tuple(column.name for column in tree.find_all(exp.ColumnDef))
        data, text = self._folder.new_data(schema, target.name), tree.sql(dialect="spark")
        entry = Entry(schema, target.name, text, columns, data)
        if tree.expression is None:
            self._folder.put(entry)
            return
        self.ready(text)
        self._run(self._create_statement(entry))
        tree.set("expression", None)
        columns = self._columns(_table(target.name, schema))
        stored = dataclasses.replace(entry, columns=columns, statement=tree.sql(dialect="spark"))
        self._folder.put(stored)
        self._registered[stored.key] = stored, _changed(self._folder.place(stored))

    def _create_view(self, tree: exp.Create, text: str) -> None:
        target = tree.find(exp.Table)
        assert target is not None
        self._run(text)
        columns = self._columns(_table(target.name, target.db or None))
        entry = Entry(target.db or None, target.name, text, columns, None)
        self._folder.put(entry)
        self._registered[entry.key] = entry, 0

    def _drop(self, tree: exp.Drop, text: str) -> None:
        target = tree.this if tree.this is not None else tree.args["tables"][0]
        if (entry := self._folder.entries().get(_key(target))) is None:
            self._run(text)
            return
        self._folder.drop(entry)
        self._forget(entry.key)

    def _make_schema(self, schema: str) -> None:
        """Make a schema known to Spark; its own place is never used, and is removed with it."""
        place = scratch() / f"{self._database}_{len(self._schemas)}"
        where = exp.Properties(expressions=[exp.LocationProperty(this=template.text(str(place)))])
        database = exp.Table(db=template.name(schema))
        self._do(exp.Create(this=database, kind="SCHEMA", exists=True, properties=where))
        self._schemas.add(schema)

    def _create_statement(self, entry: Entry) -> str:
        """Return the statement that makes a table known, with the place of its rows."""
        create = sqlglot.parse_one(entry.statement, dialect="spark")
        properties = create.args.get("properties") or exp.Properties(expressions=[])
        place = template.text(str(self._folder.place(entry)))
        properties.append("expressions", exp.LocationProperty(this=place))
        create.set("properties", properties)
        return create.sql(dialect="spark")


class MetastoreTables(Rewriting):
    """Tables and views of the metastore, in a form: ``parquet``, ``delta`` or ``iceberg``."""

    def __init__(self, session: Any, run: Callable[[str], Any], engine: Engine, form: str) -> None:
        super().__init__(session, run, engine)
        self._form = form

    def execute(self, text: str) -> None:
        """Run a statement that changes something."""
        self._run(text)

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        """Delete rows by their keys: Delta and Iceberg do, a Parquet table is pointed to other files."""
        if self._form != "parquet":
            gone = exp.select(*(exp.column(template.name(key)) for key in keys)).distinct()
            merge = exp.Merge(  # Delta's DELETE takes no query
                this=table.copy().as_("staying"),
                using=gone.from_(key_rows.subquery("found")).subquery("gone"),
                on=same_keys(keys),
                whens=exp.Whens(expressions=[exp.When(matched=True, then=exp.var("DELETE"))]),
            )
            self._do(merge)
            return
        columns = self._columns(table)
        if (rows := self.staying(table, columns, keys, key_rows)) is not None:
            self._exchange(table, columns, rows)

    def _exchange(self, table: exp.Table, columns: Sequence[str], rows: exp.Query) -> None:
        """Write what a Parquet table is to have to other files, and point it to them."""
        describe = exp.Describe(this=table.copy(), style="EXTENDED", kind="TABLE")
        rows_of = reversed(self._do(describe).collect())
        before = next(str(row[1]) for row in rows_of if row[0] == "Location")
        after = f"{before.rstrip('/')}-{secrets.token_hex(4)}"
        self.write_beside(table, columns, rows, after)
        self._move(table, after)
        self._remove(table, before)

    def _move(self, table: exp.Table, place: str) -> None:
        """Point a table to other files."""
        moved = exp.AlterSet(location=template.text(place))
        self._do(exp.Alter(this=table.copy(), kind="TABLE", actions=[moved]))

    def _remove(self, table: exp.Table, place: str) -> None:
        """Remove the files that a table had, by SQL alone: they are those of a table that is dropped.

        Its name is the same every time: a process that was killed on the way left it, and what it was
        made in, an empty folder, serves again.
        """
        gone = table.copy()
        gone.set("this", template.name(f"{table.name}_replaced"))
        dropped = exp.Drop(tables=[gone.copy()], kind="TABLE", exists=True)
        self._do(dropped)
        alike = exp.Properties(expressions=[exp.LikeProperty(this=table.copy())])
        self._do(exp.Create(this=gone.copy(), kind="TABLE", properties=alike))
        self._move(gone, place)
        self._do(dropped)

    def names(self) -> list[tuple[str, ...]]:
        """Return what can be read: of the current catalogue, by schema, and views of the session."""
        catalogue = self._session.catalog.currentCatalog()
        schemas = [row[0] for row in self._run("SHOW SCHEMAS").collect()]
        current = self._session.catalog.currentDatabase()
        names: list[tuple[str, ...]] = []
        for schema in [current, *(name for name in schemas[:_SCHEMAS] if name != current)]:
            rows = self._session.catalog.listTables(template.name(schema).sql(dialect="spark"))
            names += [(row.name,) if row.isTemporary else (catalogue, schema, row.name) for row in rows]
        return names

    def relations(self, schema: str | None) -> Mapping[str, tuple[str, ...]]:
        """Return the tables and views of a schema with their columns, as they are now."""
        name = schema or self._session.catalog.currentDatabase()
        shown = template.name(name).sql(dialect="spark")
        columns: dict[str, tuple[str, ...]] = {}
        if schema is not None and not self._session.catalog.databaseExists(schema):
            return columns
        for row in self._session.catalog.listTables(shown):
            if not row.isTemporary:
                table = exp.Table(this=template.name(row.name), db=template.name(name))
                self._do(exp.Refresh(this=table.copy(), kind="TABLE"))
                columns[row.name.casefold()] = self._columns(table)
        return columns


def _key(table: exp.Table) -> str:
    return (f"{table.db}.{table.name}" if table.db else table.name).casefold()


def _changed(folder: Path) -> int:
    try:
        return folder.stat().st_mtime_ns
    except FileNotFoundError:
        return 0


def _files(folder: Path) -> frozenset[str]:
    with os.scandir(folder) as files:
        return frozenset(file.name for file in files if file.name.endswith(".parquet"))


def _table(name: str, schema: str | None) -> exp.Table:
    return exp.Table(this=template.name(name), db=None if schema is None else template.name(schema))
