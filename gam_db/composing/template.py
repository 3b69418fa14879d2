"""Templates: one formula, one ``.sql`` file, parsed once; slots are filled on the tree.

A file may begin with macros of DuckDB; their bodies replace their calls.

This module owns reading a file of ``sql/`` and putting nodes in the place of its ``:slots``. It knows
neither the method nor any engine, and it never makes SQL from text.

Four kinds of slot value:

* a number, put in as a typed literal (a float as ``CAST(... AS DOUBLE)``: DuckDB would read ``0.1``
  as a decimal),
* ``None``, put in as ``NULL``,
* a node (a quoted column, a condition, a string literal made by :func:`text`),
* a list of nodes, spliced into a list of columns or of what orders rows.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, reduce
from itertools import takewhile
from pathlib import Path
from typing import TypeAlias

import sqlglot
from sqlglot import exp
from sqlglot.dialects.duckdb import DuckDB
from sqlglot.errors import SqlglotError

from gam_db.errors import TemplateError

Slot: TypeAlias = int | float | None | exp.Expr | Sequence[exp.Expr]

LARGEST_INTEGER = 2**63 - 1

_DOUBLE = exp.DataType.build("DOUBLE")


@dataclass(frozen=True)
class Template:
    """A parsed file of ``sql/``: name (``folder/file``), what it computes, tree, slots, tables.

    ``dialect`` is that of the only engine it is for; None for a file that serves all.
    """

    name: str
    comment: str
    tree: exp.Expr
    slots: frozenset[str]
    tables: frozenset[str]
    dialect: str | None = None


def sql_folder() -> Path:
    """Return the folder of the ``.sql`` files: in the installed package, else in the checkout."""
    installed = Path(__file__).parents[1] / "sql"
    return installed if installed.is_dir() else Path(__file__).parents[2] / "sql"


@cache
def load(name: str) -> Template:
    """Read and parse ``sql/<name>.sql``.

    Raises:
        TemplateError: the file is missing, is not one statement, selects ``*``, names a window, or
            uses a function that sqlglot does not know (it would be passed to every engine unread).
    """
    path = sql_folder() / f"{name}.sql"
    try:
        source = path.read_text(encoding="utf-8")
    except OSError as error:
        raise TemplateError(f"There is no template sql/{name}.sql.") from error
    return parse(name, source)


def parse(name: str, source: str) -> Template:
    """Parse the text of a template; see :func:`load`.

    One for a single engine says so in its head (``Dialect: clickhouse``), and may use its functions.
    What else a file must keep to is tested (``tests/tools/sql_lint.py``).
    """
    head = [line.removeprefix("--").strip() for line in source.splitlines() if line.startswith("--")]
    dialect = next((line.split()[1] for line in head if line.startswith("Dialect:")), None)
    try:
        statements = sqlglot.parse(source, dialect=dialect or DuckDB)
    except SqlglotError as error:
        raise TemplateError(f"sql/{name}.sql cannot be parsed: {error}") from error
    trees = [statement for statement in statements if statement is not None]
    if not trees or any(macro.args.get("kind") != "MACRO" for macro in trees[:-1]):
        raise TemplateError(f"sql/{name}.sql must hold exactly one statement, after macros if any.")
    *macros, tree = trees
    for place, macro in enumerate(macros):
        for reader in (*macros[place + 1 :], tree):
            _inline(macro, reader)
    after = ("Dialect:", "Reads:", "Slots:")
    comment = "\n".join(takewhile(lambda line: not line.startswith(after), head))
    for node in tree.walk():
        node.comments = None
        node._meta = None  # places in the text; copying them takes longer than all else
    slots = frozenset(node.name for node in tree.find_all(exp.Placeholder))
    tables = frozenset(node.name for node in tree.find_all(exp.Table))
    return Template(name, comment, tree, slots, tables, dialect)


def _inline(macro: exp.Expr, reader: exp.Expr) -> None:
    """Replace the calls of macros by their bodies, so that engines need no macros."""
    about: exp.Expr = macro.this
    for call in reversed(list(reader.find_all(exp.Anonymous))):  # inner calls first
        if call.name == about.this.name:
            arguments = dict(
                zip((parameter.name for parameter in about.expressions), call.expressions, strict=True)
            )
            body = exp.Paren(this=macro.expression.copy())
            for column in list(body.find_all(exp.Column)):
                column.replace(_fenced(arguments[column.name].copy(), column))
            call.replace(body)


def fill(name: str, slots: Mapping[str, Slot] | None = None) -> exp.Expr:
    """Return a copy of the tree of ``sql/<name>.sql`` with every slot filled.

    Raises:
        TemplateError: a slot of the file is not given, one that is given is not in the file, or a
            value cannot stand in SQL (NaN, infinity, an integer beyond 64 bits).
    """
    return fill_template(load(name), slots or {})


def fill_template(template: Template, slots: Mapping[str, Slot]) -> exp.Expr:
    """Return a copy of a template's tree with every slot filled; see :func:`fill`."""
    missing = template.slots - slots.keys()
    surplus = slots.keys() - template.slots
    if missing or surplus:
        raise TemplateError(
            f"sql/{template.name}.sql: "
            + "; ".join(
                f"{word} {', '.join(sorted(names))}"
                for word, names in (("no value for", missing), ("no such slot:", surplus))
                if names
            )
        )
    tree = template.tree.copy()
    for placeholder in list(tree.find_all(exp.Placeholder)):
        value = slots[placeholder.name]
        if isinstance(value, Sequence) and not isinstance(value, (str, bytes)):
            _splice(placeholder, [node.copy() for node in value])
        else:
            filled = node_of(value, template.name)
            if isinstance(filled, exp.Cast) and isinstance(placeholder.parent, exp.Cast):
                filled = filled.this if filled.to == placeholder.parent.to else filled
            if placeholder is tree:
                tree = filled
            else:
                placeholder.replace(_fenced(filled, placeholder))
    left = sorted({placeholder.name for placeholder in tree.find_all(exp.Placeholder)})
    if left:
        raise TemplateError(f"sql/{template.name}.sql: left over after filling: {', '.join(left)}.")
    return tree


def node_of(value: int | float | None | exp.Expr, where: str = "a slot") -> exp.Expr:
    """Return the node of a slot value: a typed literal, ``NULL``, or a copy of the node itself."""
    if value is None:
        return exp.Null()
    if isinstance(value, exp.Expr):
        return value.copy()
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise TemplateError(f"{where}: {type(value).__name__} cannot stand in a slot.")
    if isinstance(value, int):
        if abs(value) > LARGEST_INTEGER:
            raise TemplateError(f"{where}: {value} does not fit in 64 bits.")
        literal: exp.Expr = exp.Literal.number(abs(value))
    else:
        if not math.isfinite(value):
            raise TemplateError(f"{where}: {value} is not a finite number.")
        digits = repr(abs(value))
        # With an exponent, no engine reads a decimal first and rounds twice.
        number = exp.Literal.number(digits if "e" in digits else f"{digits}e0")
        literal = exp.Cast(this=number, to=_DOUBLE.copy())
    return exp.Neg(this=literal) if math.copysign(1, value) < 0 else literal


def text(value: str) -> exp.Expr:
    """Return a string literal; quoting is the generator's."""
    return exp.Literal.string(value)


def name(value: str) -> exp.Identifier:
    """Return a quoted identifier, taken as it is."""
    return exp.Identifier(this=value, quoted=True)


def column(value: str) -> exp.Column:
    """Return a quoted column, taken as it is."""
    return exp.Column(this=name(value))


def added(terms: Sequence[exp.Expr]) -> exp.Expr:
    """Return the sum of the terms, from left to right."""
    return reduce(lambda total, term: exp.Add(this=total, expression=term), terms)


def case(
    cases: Iterable[tuple[exp.Expr, int | None | exp.Expr]], default: int | None | exp.Expr
) -> exp.Expr:
    """Return the value of the first case whose condition holds, else the default."""
    ifs = [exp.If(this=condition, true=node_of(value)) for condition, value in cases]
    return exp.Case(ifs=ifs, default=node_of(default)) if ifs else node_of(default)


def _splice(placeholder: exp.Placeholder, nodes: Sequence[exp.Expr]) -> None:
    item: exp.Expr = placeholder
    if isinstance(placeholder.parent, exp.Ordered):
        item, nodes = placeholder.parent, [exp.Ordered(this=node) for node in nodes]
    parent = item.parent
    if parent is None or item.arg_key != "expressions":
        raise TemplateError(f"The slot :{placeholder.name} takes a list only among columns.")
    columns: list[exp.Expr] = []
    for node in parent.args["expressions"]:
        columns.extend(nodes if node is item else [node])
    parent.set("expressions", columns)


def _fenced(node: exp.Expr, placeholder: exp.Expr) -> exp.Expr:
    """Put compound expressions in brackets, so that the neighbours of a slot cannot split them."""
    compound = isinstance(
        node, (exp.Connector, exp.Binary, exp.Unary, exp.Between, exp.In)
    ) and not isinstance(node, exp.Paren)
    inside_operator = isinstance(placeholder.parent, (exp.Binary, exp.Unary, exp.Between, exp.In))
    return exp.Paren(this=node) if compound and inside_operator else node
