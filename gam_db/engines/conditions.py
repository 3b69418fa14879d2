"""The expressions that a user's condition may contain on an engine, unless all are allowed.

``conditions.toml`` lists them; this module checks a parsed condition by these lists.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from sqlglot import exp
from sqlglot.errors import ErrorLevel

from gam_db import data
from gam_db.engines.base import Engine
from gam_db.errors import wrong
from gam_db.settings.source import parsed_condition

_TABLES = data.table("gam_db.engines", "conditions.toml")

#: What sqlglot writes as it stands, or with too few signs escaped: a text there must be a name.
_PLAIN = {"Var": re.compile(r"\w+"), "JSONPathKey": re.compile(r"[^'\"\\`]+")}


@dataclass(frozen=True)
class Allowed:
    """What conditions may hold: kinds of nodes and of types, and functions in lower case."""

    nodes: frozenset[str]
    types: frozenset[str]
    functions: frozenset[str]
    moving: re.Pattern[str]  # texts that mean the clock


def _words(table: Mapping[str, str], *names: str) -> frozenset[str]:
    return frozenset(word for name in names for word in table.get(name, "").split())


_MOVING_NODES = _words(_TABLES["volatile"], "nodes")
_MOVING_WORDS = frozenset(map(str.lower, _words(_TABLES["volatile"], "functions", "words")))
_CONSTANTS = _words(_TABLES["volatile"], "constants")


@cache
def allowed_on(engine: str) -> Allowed:
    """Return what conditions may hold on the engine of a name."""
    every, of_engine = _TABLES["every"], _TABLES[_TABLES[engine].get("like", engine)]
    return Allowed(
        nodes=_words(every, "nodes") | _words(of_engine, "nodes"),
        types=_words(every, "types"),
        functions=frozenset(map(str.lower, _words(of_engine, "functions"))),
        moving=re.compile(of_engine.get("moving", "(?!)"), re.IGNORECASE | re.DOTALL),
    )


def check_conditions(where: str | None, valid_when: str | None, engine: Engine) -> None:
    """Refuse a condition that is more than a question about a row, which has one answer.

    Raises:
        SourceError: it is no condition.
        ConfigurationError: it asks other tables, may have another answer each time, or holds what is not
            listed for the engine; the message names the first such part.
    """
    for called, condition in (("where", where), ("valid_when", valid_when)):
        if condition is None:
            continue
        tree = parsed_condition(condition, called)
        parts = [tree.find(exp.Query), *tree.walk()]
        for part in filter(None, parts):
            problem = _problem(part, allowed_on(engine.name))
            if problem is None:
                continue
            if problem == "tables":
                raise wrong("where_asks_other_tables", called=called, where=condition)
            what = _shown(part)
            if problem == "moves":
                raise wrong("where_moves", called=called, where=condition, what=what)
            title = engine.title
            raise wrong("where_not_listed", called=called, where=condition, what=what, title=title)


def _problem(part: exp.Expr, allowed: Allowed) -> str | None:
    """Return the problem of one node of a condition: tables, moves or unlisted; None for no problem."""
    kind = type(part).__name__
    if isinstance(part, exp.Query) or (isinstance(part, exp.In) and _may_ask_table(part)):
        return "tables"
    if kind in _MOVING_NODES or _is_clock(part, allowed):
        return "moves"
    if isinstance(part, exp.Anonymous):
        return None if part.name.lower() in allowed.functions else "unlisted"
    is_other = (
        kind not in allowed.nodes
        # A function of a schema may be anybody's, whatever it is called.
        or (isinstance(part, exp.Dot) and not isinstance(part.expression, exp.Identifier))
        or (isinstance(part, exp.DataType) and getattr(part.this, "name", "") not in allowed.types)
        or (kind in _PLAIN and not _PLAIN[kind].fullmatch(part.name))
    )
    return "unlisted" if is_other else None


def _may_ask_table(part: exp.In) -> bool:
    """Tell whether the operand of IN may be a table: for ClickHouse a name in brackets is one."""
    return not part.expressions or any(node.find(exp.Column) for node in part.expressions)


def _is_clock(part: exp.Expr, allowed: Allowed) -> bool:
    """Tell whether a function, a bare word or a text depends on something other than the row."""
    if isinstance(part, exp.Anonymous):
        return part.name.lower() in _MOVING_WORDS or not part.expressions
    if isinstance(part, exp.Column):
        name = part.this
        is_bare = isinstance(name, exp.Identifier) and not name.quoted and not part.table
        return is_bare and name.name.lower() in _MOVING_WORDS
    if isinstance(part, (exp.Literal, exp.RawString, exp.Identifier)):
        is_text = part.args.get("is_string", True) and part.args.get("quoted", True)
        return bool(is_text and allowed.moving.fullmatch(part.name))
    is_call = isinstance(part, exp.Func) and type(part).__name__ not in _CONSTANTS
    return is_call and not any(part.iter_expressions())


def _shown(part: exp.Expr) -> str:
    """Return a part of a condition as a message names it."""
    try:
        text = part.sql("duckdb", unsupported_level=ErrorLevel.IGNORE)
    except (TypeError, ValueError):  # sqlglot reads more than it writes
        text = f"{type(part).__name__}()"
    if isinstance(part, exp.DataType):
        return f"the type {text}"
    is_call = isinstance(part, (exp.Dot, exp.Func)) and text.endswith(")")
    return f"the function {text.partition('(')[0].strip().lower()}" if is_call else text
