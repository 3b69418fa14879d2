"""PostgreSQL 14 and later."""

from collections import Counter
from functools import partial

import sqlglot
from sqlglot import exp

from gam_db import data
from gam_db.composing import template
from gam_db.engines.base import Engine, settings
from gam_db.engines.functions import SIGNAL, signal_rows
from gam_db.engines.rewrites import at_home, compare_by_bytes
from gam_db.engines.storage import Storage
from gam_db.engines.types import Types

#: The collation that compares texts by their bytes.
BYTES = template.name("C")


def keep_small_steps(tree: exp.Expr) -> exp.Expr:
    """Mark WITH entries MATERIALIZED unless they are to flow.

    Cause: an entry read once is put in the place where it is read, and the planner, which knows
    nothing of the rows of a WITH entry, expects one row and joins by nested loops. Symptom: the exact
    form learns the support anew for every scored vector; 100,000 readings take half a minute.
    An entry of a view that is read once is left alone: its reader's condition is to reach the rows.
    """
    is_view = isinstance(tree, exp.Create) and tree.kind == "VIEW"
    read = Counter(table.name for table in tree.find_all(exp.Table)) if is_view else Counter()
    for entry in tree.find_all(exp.CTE):
        if is_view and read[entry.alias] < 2:
            continue
        if entry.args.get("materialized") is None and entry.this.find(exp.Table):
            entry.set("materialized", True)
    return tree


def fence_reads(tree: exp.Expr) -> exp.Expr:
    """Let what a window reads, and a formula that is read twice, be computed before it, once.

    Cause: a subquery or a WITH entry is put in the place where it is read. Symptom: below a window the
    code of a sample is computed once for each delay, and the sort carries the row that it is made of;
    the integer time of a timestamp is computed three times where readings are counted by slices.
    A view is left alone: a fence would keep its reader's condition from the rows.
    """
    if isinstance(tree, exp.Create) and tree.kind == "VIEW":
        return tree
    entries = {entry.alias: entry for entry in tree.find_all(exp.CTE)}
    for select in tree.find_all(exp.Select):
        if (source := select.args.get("from_")) is None:
            continue
        entry = entries.get(source.this.name) if isinstance(source.this, exp.Table) else source.this
        is_materialized = isinstance(entry, exp.CTE) and entry.args.get("materialized")
        read = entry.this if isinstance(entry, (exp.CTE, exp.Subquery)) and not is_materialized else None
        if not isinstance(read, exp.Query) or read.args.get("limit") or read.args.get("offset"):
            continue
        windows = (window for output in select.selects for window in output.find_all(exp.Window))
        if any(window.parent_select is select for window in windows) or _repeats(select, read):
            read.set("offset", exp.Offset(expression=exp.Literal.number(0)))
    return tree


def _repeats(select: exp.Select, read: exp.Query) -> bool:
    """Tell whether a query over all rows of another one names a formula of it more than once."""
    if select.args.get("where") or select.args.get("joins"):
        return False
    named = Counter(column.name for output in select.selects for column in output.find_all(exp.Column))
    return any(named[output.alias] > 1 and _is_formula(output, read) for output in read.selects)


def _is_formula(column: exp.Expr, query: exp.Query) -> bool:
    """Tell whether a column of a query is a CASE there, or in the query whose column it is."""
    source = query.args.get("from_")
    within = source.this.this if source and isinstance(source.this, exp.Subquery) else None
    if isinstance(column.unalias(), exp.Column) and isinstance(within, exp.Select):
        named = column.unalias().name
        return any(_is_formula(output, within) for output in within.selects if output.alias == named)
    return column.find(exp.Case) is not None


def fence_sets(tree: exp.Expr) -> exp.Expr:
    """Let a row be looked up in a set once.

    Cause: a query whose rows are looked up is put in the place where it is read. Symptom: the set is
    made and asked anew for every place that names the answer.
    """
    for among in tree.find_all(exp.In):
        select = among.find_ancestor(exp.Where, exp.Select)
        if isinstance(select, exp.Select) and among.args.get("query") and not select.args.get("offset"):
            select.set("offset", exp.Offset(expression=exp.Literal.number(0)))
    return tree


def _by_bytes(column: exp.ColumnDef) -> None:
    if column.args["kind"].is_type(*exp.DataType.TEXT_TYPES):
        by_bytes = exp.CollateColumnConstraint(this=BYTES.copy())
        column.set("constraints", [exp.ColumnConstraint(kind=by_bytes), *column.constraints])


#: What a step that is kept may take at least, in kB, whatever work_mem says.
ROOM = 65_536

#: How many rows a set (IN) may have in that room: of a larger one every row is compared. A row takes 64
#: bytes where it is looked up by its hash: its few columns, its head, and room for an estimate wrong by
#: half.
_MOST_IN_SET = sqlglot.parse_one(
    """
    SELECT GREATEST(CAST(setting AS BIGINT), 65536) * 16 AS most
    FROM "pg_catalog"."pg_settings" WHERE name = 'work_mem'
    """,
    dialect="postgres",
    into=exp.Select,
)

#: Where names are looked up: nowhere but in PostgreSQL itself, and last among temporary tables. Whoever
#: may create objects in a schema that is searched could else run code as our user, by a function or an
#: operator that fits its arguments better than PostgreSQL's own.
PATH = "pg_catalog, pg_temp"

_AT_WORK = data.table("gam_db.engines.postgres", "postgres.toml")


def of_signal(name: exp.Table, view: exp.Table) -> exp.Create:
    """Return the function that gives the rows of one signal of a view, with the rights of its caller."""
    arguments = [
        exp.ColumnDef(this=exp.to_identifier(of), kind=exp.DataType.build("TEXT")) for of in SIGNAL
    ]
    row = exp.DataType(this=exp.DType.USERDEFINED, kind=at_home(view.copy(), ENGINE.home or ""))
    path = exp.SetItem(this=exp.column("search_path").eq(exp.var(PATH)))
    properties = [
        exp.ReturnsProperty(this=exp.ColumnDef(this=exp.var("SETOF"), kind=row)),
        exp.LanguageProperty(this=exp.var("sql")),
        exp.StabilityProperty(this=exp.Literal.string("STABLE")),
        exp.SetConfigProperty(this=exp.Set(expressions=[path])),
    ]
    return exp.Create(
        this=exp.UserDefinedFunction(this=name, expressions=arguments, wrapped=True),
        kind="FUNCTION",
        properties=exp.Properties(expressions=properties),
        expression=template.text(ENGINE.text(signal_rows(view))),
    )


_BY_BYTES = partial(compare_by_bytes, BYTES)

ENGINE = Engine.named(
    "postgres",
    working=settings(_AT_WORK["settings"] | _AT_WORK["planned_alone"]),
    resting=[exp.Command(this="RESET", expression=name) for name in _AT_WORK["planned_alone"]],
    delays_by_column=True,
    types=Types("postgres", (("citext", "text"),)),
    storage=Storage(column=_by_bytes, index=True),
    of_signal=of_signal,
    opening=(exp.Command(this="SET", expression=f"search_path TO {PATH}"),),
    most_in_set=_MOST_IN_SET,
    rewrites=(_BY_BYTES, keep_small_steps, fence_reads, fence_sets),
    ordering=(_BY_BYTES,),  # a column of another collation than its index's finds nothing in it
)
