"""GoogleSQL, the dialect of BigQuery, by its reference implementation: analyses with types, runs reads.

The implementation is Google's own, compiled to WebAssembly (package ``zetasql``, which names the Python
layer); this module speaks to it directly, because the package compiles 28 MB anew in every process and
copies byte by byte. wasmtime keeps what it compiled in the user's cache: half a minute once, then a
quarter of a second. Of two processes that begin one waits for the other.
"""

import ctypes
import datetime as dt
import fcntl
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib import resources
from pathlib import Path
from typing import Any

from google.protobuf.empty_pb2 import Empty
from wasmtime import Config, Engine, Func, Linker, Module, SharedMemory, Store, WasiConfig
from zetasql.wasi import get_wasm_path
from zetasql.wasi._pb2.zetasql.local_service import local_service_pb2 as wire
from zetasql.wasi._pb2.zetasql.public import options_pb2, type_pb2

Row = dict[str, Any]

KINDS = {
    "INT64": type_pb2.TYPE_INT64,
    "FLOAT64": type_pb2.TYPE_DOUBLE,
    "STRING": type_pb2.TYPE_STRING,
    "BOOL": type_pb2.TYPE_BOOL,
    "TIMESTAMP": type_pb2.TYPE_TIMESTAMP,
    "DATETIME": type_pb2.TYPE_DATETIME,
    "DATE": type_pb2.TYPE_DATE,
}
NAMES = {kind: name for name, kind in KINDS.items()}

_CELLS = {"INT64": "int64_value", "FLOAT64": "double_value", "STRING": "string_value"}
_SIZE = 4

#: What of the language BigQuery has and our text uses; all else is refused, as it would be there.
_FEATURES = (
    "FEATURE_ANALYTIC_FUNCTIONS",
    "FEATURE_CREATE_TABLE_CLUSTER_BY",
    "FEATURE_CREATE_TABLE_FIELD_ANNOTATIONS",
    "FEATURE_CREATE_TABLE_NOT_NULL",
    "FEATURE_CREATE_VIEW_WITH_COLUMN_LIST",
    "FEATURE_CREATE_VIEWS_WITH_COLUMN_OPTIONS",
    "FEATURE_DML_UPDATE_WITH_JOIN",
    "FEATURE_NUMERIC_TYPE",
    "FEATURE_WITH_ON_SUBQUERY",
    "FEATURE_DISALLOW_GROUP_BY_FLOAT",
)

_STATEMENT = re.compile(
    r"(?P<doing>CREATE|ALTER|DROP|INSERT INTO|DELETE FROM|UPDATE) (?:OR REPLACE )?"
    r"(?:(?P<kind>TABLE|VIEW) )?(?:IF (?:NOT )?EXISTS )?`?(?P<name>\w+)`?(?P<rest>.*)",
    re.DOTALL,
)


class GoogleSqlError(Exception):
    """What the reference implementation says against a statement."""


@dataclass(frozen=True)
class Table:
    """A table: its columns with their types (names of BigQuery), and its rows, in that order."""

    columns: Mapping[str, str]
    rows: Sequence[Sequence[Any]] = ()


class _Service:
    """The functions of the compiled module, called with messages."""

    def __init__(self) -> None:
        config = Config()
        config.cache = True
        config.shared_memory = True
        engine = Engine(config)
        self._store = Store(engine)
        system = WasiConfig()
        # Times need their zones, or the module ends at the first request.
        system.preopen_dir(str(resources.files("tzdata") / "zoneinfo"), "/usr/share/zoneinfo")
        self._store.set_wasi(system)
        linker = Linker(engine)
        linker.define_wasi()
        with Path(get_wasm_path()).open("rb") as compiled:
            fcntl.flock(compiled, fcntl.LOCK_EX)
            module = Module(engine, compiled.read())
        self._exports = linker.instantiate(self._store, module).exports(self._store)
        memory = self._exports["memory"]
        assert isinstance(memory, SharedMemory)
        self._memory = memory
        self._call("_initialize")

    def ask(self, function: str, request: Any, answer: Any) -> Any:
        """Send a request, return the answer."""
        said = request.SerializeToString()
        place, size = self._call("wasm_malloc", len(said)), self._call("wasm_malloc", _SIZE)
        ctypes.memmove(self._address(place), said, len(said))
        found = self._call(f"ZetaSqlLocalService_{function}", place, len(said), size)
        self._call("wasm_free", place)
        if not found:
            length = self._call("wasm_get_last_error_size")
            raise GoogleSqlError(self._read(self._call("wasm_get_last_error"), length).decode())
        length = int.from_bytes(self._read(size, _SIZE), "little")
        message = answer.FromString(self._read(found, length))
        self._call("wasm_free", found)
        self._call("wasm_free", size)
        return message

    def _call(self, name: str, *arguments: int) -> Any:
        function = self._exports[name]
        assert isinstance(function, Func)
        return function(self._store, *arguments)

    def _read(self, place: int, length: int) -> bytes:
        return ctypes.string_at(self._address(place), length)

    def _address(self, place: int) -> int:
        return ctypes.addressof(self._memory.data_ptr().contents) + place


@cache
def _service() -> _Service:
    return _Service()


@cache
def _options() -> Any:
    """Return what statements are analysed with: BigQuery's mode, every kind of statement."""
    options = wire.AnalyzeRequest().options
    language = options.language_options
    language.product_mode = options_pb2.PRODUCT_EXTERNAL
    language.name_resolution_mode = options_pb2.NAME_RESOLUTION_DEFAULT
    for feature in _FEATURES:
        language.enabled_language_features.append(getattr(options_pb2, feature))
    return options


def _catalog(request: Any, tables: Mapping[str, Table]) -> None:
    catalog = request.simple_catalog
    catalog.name = "plant"
    catalog.builtin_function_options.language_options.CopyFrom(_options().language_options)
    for number, (name, table) in enumerate(tables.items(), start=1):
        described = catalog.table.add(name=name, serialization_id=number)
        for column, kind in table.columns.items():
            described.column.add(name=column, is_writable_column=True).type.type_kind = KINDS[kind]


def analyzed(statement: str, tables: Mapping[str, Table]) -> Any:
    """Return the resolved form of a statement: names and types of all of it are known.

    Raises:
        GoogleSqlError: it has none.
    """
    described = {name: tuple(table.columns.items()) for name, table in tables.items()}
    return _analyzed(statement, tuple(described.items()))


@lru_cache(500)
def _analyzed(statement: str, tables: tuple[tuple[str, tuple[tuple[str, str], ...]], ...]) -> Any:
    """What is said of the same columns once more is not analysed once more."""
    request = wire.AnalyzeRequest(sql_statement=statement, options=_options())
    _catalog(request, {name: Table(dict(columns)) for name, columns in tables})
    return _service().ask("Analyze", request, wire.AnalyzeResponse).resolved_statement


def check(statement: str, tables: Mapping[str, Table]) -> None:
    """Analyse a statement, and read nothing of the answer, which may be nested deeper than can be read.

    Raises:
        GoogleSqlError: it cannot be analysed.
    """
    request = wire.AnalyzeRequest(sql_statement=statement, options=_options())
    _catalog(request, {name: Table(table.columns) for name, table in tables.items()})
    _service().ask("Analyze", request, Empty)


def run(query: str, tables: Mapping[str, Table]) -> Table:
    """Return the rows of a query.

    Raises:
        GoogleSqlError: it cannot be analysed, or fails on these rows.
    """
    request = wire.EvaluateQueryRequest(sql=query, options=_options())
    _catalog(request, tables)
    _fill(request, tables)
    answer = _service().ask("EvaluateQuery", request, wire.EvaluateQueryResponse)
    columns = {one.name: NAMES[one.type.type_kind] for one in answer.prepared.columns}
    rows = [[_value(cell) for cell in row.cell] for row in answer.content.table_data.row]
    return Table(columns, rows)


def inserted(statement: str, name: str, tables: Mapping[str, Table]) -> Table:
    """Return a table after a statement that inserts into it.

    Raises:
        GoogleSqlError: it cannot be analysed, or fails on these rows.
    """
    columns = tables[name].columns
    given = re.search(r"\(([^()]*)\)\s+(WITH\b.*)", statement, re.DOTALL)
    if given:  # the service takes such a query here, its reference implementation only by itself
        order = [one.strip(" `\n") for one in given[1].split(",")]
        found = [dict(zip(order, row, strict=True)) for row in run(given[2], tables).rows]
        rows = [[row.get(column) for column in columns] for row in found]
    else:
        rows = [[_value(cell) for cell in row.cell] for row in _modified(statement, tables)]
    return Table(columns, [*tables[name].rows, *rows])


def deleted(statement: str, name: str, tables: Mapping[str, Table]) -> Table:
    """Return a table after a statement that deletes from it.

    Raises:
        GoogleSqlError: it cannot be analysed, or fails on these rows.
    """
    rows = [list(row) for row in tables[name].rows]
    for gone in _modified(statement, tables, name):
        rows.remove([_value(cell) for cell in gone.old_primary_key])
    return Table(tables[name].columns, rows)


def widened(table: Table, statement: str) -> Table:
    """Return a table with the columns that an analysed ALTER TABLE adds; they are NULL in its rows."""
    said = re.findall(r"ADD COLUMN (?:IF NOT EXISTS )?`?(\w+)`? (\w+)", statement)
    assert said, statement[:200]
    new = {column: kind for column, kind in said if column not in table.columns}
    rows = [[*row, *[None] * len(new)] for row in table.rows]
    return Table({**table.columns, **new}, rows)


def _modified(statement: str, tables: Mapping[str, Table], keyed: str | None = None) -> Any:
    """Return the rows that a statement inserts, or the keys of those that it deletes.

    Args:
        statement: INSERT or DELETE.
        tables: what it reads.
        keyed: the table that has a key, its whole row; an insert into such a one ends the module.
    """
    request = wire.EvaluateModifyRequest(sql=statement, options=_options())
    _catalog(request, tables)
    for described in request.simple_catalog.table:
        if described.name == keyed:
            described.primary_key_column_index.extend(range(len(described.column)))
    _fill(request, tables)
    return _service().ask("EvaluateModify", request, wire.EvaluateModifyResponse).content


def _fill(request: Any, tables: Mapping[str, Table]) -> None:
    for name, table in tables.items():
        kinds = list(table.columns.values())
        content = request.table_content[name].table_data
        content.SetInParent()
        for row in table.rows:
            made = content.row.add()
            for value, kind in zip(row, kinds, strict=True):
                cell = made.cell.add()
                if isinstance(value, dt.datetime):
                    cell.timestamp_value.FromDatetime(value)
                elif value is not None:
                    setattr(cell, _CELLS[kind], value)


def _value(cell: Any) -> Any:
    kind = cell.WhichOneof("value")
    if kind == "timestamp_value":
        return cell.timestamp_value.ToDatetime(dt.UTC)
    return None if kind is None else getattr(cell, kind)


def statements(script: str) -> list[str]:
    """Return the statements of a script of ours, each without the comments before it."""
    parts = (re.sub(r"\A(\s*--[^\n]*\n)+", "", part.lstrip()).strip() for part in script.split(";\n"))
    return [part for part in parts if part]


class Plant:
    """Tables that statements of ours work on: each is analysed, then run; an UPDATE is only analysed.

    Attributes:
        tables: by name; views are filled when they are read.
    """

    def __init__(self, tables: Mapping[str, Table]) -> None:
        self.tables = dict(tables)
        self._views: dict[str, str] = {}
        self._columns: dict[str, Mapping[str, str]] = {}
        self._viewed: dict[str, tuple[dict[str, Table], Table]] = {}

    def execute(self, statement: str) -> None:
        """Run a statement that makes, drops or changes a table or view.

        Raises:
            GoogleSqlError: it cannot be analysed, or fails on these rows.
        """
        match = _STATEMENT.match(statement)
        assert match, statement[:200]
        doing, kind, name, rest = match["doing"], match["kind"], match["name"], match["rest"]
        if doing == "INSERT INTO":
            self.tables[name] = inserted(statement, name, self._seen(statement))
            return
        if doing == "DELETE FROM":
            self.tables[name] = deleted(statement, name, self._seen(statement))
            return
        named = set(re.findall(r"\w+", statement))
        known = {one: Table(columns) for one, columns in self.relations().items() if one in named}
        query = re.search(r"(?:\A|\s)AS\s+((?:SELECT|WITH)\b.*)", rest, re.DOTALL)
        if doing == "CREATE" and kind != "VIEW" and query:
            check(statement, known)
            self.tables[name] = run(query[1], self._seen(statement))
            return
        resolved = analyzed(statement, known)
        if doing == "UPDATE":
            return
        if doing == "ALTER":
            self.tables[name] = widened(self.tables[name], statement)
            return
        if doing == "DROP":
            self.tables.pop(name, None)
            self._views.pop(name, None)
            self._columns.pop(name, None)
            return
        if kind == "VIEW":
            assert query
            self._views[name] = query[1]
            view = resolved.resolved_create_statement_node.resolved_create_view_base_node
            columns = view.resolved_create_view_stmt_node.parent.output_column_list
            self._columns[name] = {one.name: NAMES[one.column.type.type_kind] for one in columns}
        elif name not in self.tables:
            create = resolved.resolved_create_statement_node.resolved_create_table_stmt_base_node
            columns = create.resolved_create_table_stmt_node.parent.column_definition_list
            self.tables[name] = Table({one.name: NAMES[one.type.type_kind] for one in columns})

    def run(self, query: str) -> Table:
        """Return the rows of a query.

        Raises:
            GoogleSqlError: it cannot be analysed, or fails on these rows.
        """
        return run(query, self._seen(query))

    def relations(self) -> dict[str, Mapping[str, str]]:
        """Return the columns of all tables and views."""
        return {name: table.columns for name, table in self.tables.items()} | self._columns

    def _seen(self, statement: str) -> dict[str, Table]:
        """Return the tables that a statement names, views among them."""
        named = set(re.findall(r"\w+", statement))
        found = {name: table for name, table in self.tables.items() if name in named}
        return found | {name: self._rows_of(name) for name in self._views.keys() & named}

    def _rows_of(self, view: str) -> Table:
        """Return the rows of a view; those of before where nothing that it reads has changed."""
        query = self._views[view]
        seen = self._seen(query)
        before = self._viewed.get(view)
        if (
            before is None
            or before[0].keys() != seen.keys()
            or any(table is not before[0][name] for name, table in seen.items())
        ):
            self._viewed[view] = seen, run(query, seen)
        return self._viewed[view][1]
