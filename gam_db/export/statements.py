"""Statements of a script, in order: temporary tables, checks that must find no row, appended rows.

This module owns how they are written; it knows neither what they compute nor any engine.
"""

import textwrap
from collections.abc import Mapping

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, place
from gam_db.composing.plan import insertion
from gam_db.engines.base import Engine, temporary
from gam_db.method.adding import add

#: Signs in a line of a comment.
_WIDTH = 94

_EMPTY = "Empty; the transaction fills it, which would end where a table is made."


class Script:
    """Statements in order, each with its comment; ``tables`` are those that they read, by name.

    Args:
        engine: that the script is for.
        tables: those of the state.
    """

    def __init__(self, engine: Engine, tables: Mapping[str, exp.Table]) -> None:
        self.engine, self.tables = engine, dict(tables)
        self.parts: list[tuple[str, exp.Expr]] = []
        self.verified: list[exp.Table] = []
        self._apart: int | None = None  # the place of tables that a transaction fills but cannot make

    def begin(self, comment: str) -> None:
        """Begin a transaction."""
        if self.engine.commits_definitions:
            self._apart = len(self.parts)
        self.add(command(self.engine.begins), comment)

    def keep(self, name: str, query: exp.Query, comment: str = "", called: str = "") -> None:
        """Make a temporary table of the rows of a query."""
        place(query, self.tables)
        table = self._temporary(called or name)
        self.tables[name] = table
        self._make(table, query, comment)
        if self.engine.analyzes:
            self.add(exp.Analyze(tables=[table.copy()]))

    def step(self, steps: Pipeline, name: str, called: str = "") -> None:
        """Make a temporary table of the rows of a step."""
        query = steps.query(name, self.tables, commented=True)
        self.keep(name, query, steps.steps[name].definition.comment, called)

    def verify(self, query: exp.Query, sentence: str, comment: str = "") -> None:
        """End the script with an error where a query has a row."""
        place(query, self.tables)
        steps = Pipeline()
        failure = self.engine.failure(sentence, exp.column("problem_rows", table="counted"))
        add(steps, "stored/monitor/failing", {"failure": failure})
        failing = steps.query("failing").copy()
        (problems,) = (table for table in failing.find_all(exp.Table) if table.name == "problems")
        problems.replace(_without_order(query).subquery("problems"))
        table = self._temporary(f"verified_{len(self.verified) + 1}")
        self.verified.append(table)
        self._make(table, failing, comment or f"Verified: {sentence}.")

    def append(self, steps: Pipeline, name: str, table: str, comment: str = "") -> None:
        """Append the rows of a step to a table of the state."""
        query = steps.query(name, self.tables, commented=True)
        comment = comment or steps.steps[name].definition.comment
        self.add(insertion(self.tables[f"stored_{table}"].copy(), tidied(query)), comment)

    def add(self, statement: exp.Expr, comment: str = "") -> None:
        """Add a statement."""
        self.parts.append((comment, statement))

    def text(self) -> str:
        """Return the statements as a script."""
        return "\n".join(
            f"{commented(comment)}{self.engine.text(statement, pretty=True)};\n"
            for comment, statement in self.parts
        )

    def _temporary(self, name: str) -> exp.Table:
        schema = self.engine.temporary
        return exp.Table(this=template.name(f"gam_run_{name}"), db=schema and template.name(schema))

    def _make(self, table: exp.Table, query: exp.Query, comment: str) -> None:
        for step in query.find_all(exp.CTE):
            text = " ".join(" ".join(step.this.comments or []).split())
            step.this.comments = (
                [f" {textwrap.fill(text, _WIDTH, subsequent_indent=' ' * 5)} "] if text else None
            )
        storage = self.engine.storage.temporary
        tidied(query)
        if self._apart is None:
            self.add(temporary(table, query, *storage), comment)
            return
        empty = query.copy().limit(0)
        for node in empty.walk():
            node.comments = None
        self.parts.insert(self._apart, (_EMPTY, temporary(table, empty, *storage)))
        self._apart += 1
        self.add(insertion(table.copy(), query), comment)


def command(words: str) -> exp.Expr:
    """Return a statement of plain words."""
    first, _, more = words.partition(" ")
    return exp.Command(this=first, expression=more)


def _without_order(query: exp.Query) -> exp.Query:
    query.set("order", None)
    return query


def tidied(tree: exp.Query) -> exp.Query:
    """Leave out conditions that always hold; in place."""
    for both in reversed(list(tree.find_all(exp.And))):
        left, right = both.left, both.right
        if _holds(left) or _holds(right):
            both.replace(right if _holds(left) else left)
    for select in tree.find_all(exp.Select):
        where = select.args.get("where")
        if where is not None and _holds(where.this):
            select.set("where", None)
    return tree


def _holds(condition: exp.Expr) -> bool:
    bare = condition.unnest()
    number = exp.Literal.number(1)
    return bare == exp.true() or bare == exp.EQ(this=number, expression=number.copy())


def commented(text: str) -> str:
    """Return a text as comments of SQL."""
    lines = textwrap.wrap(" ".join(text.split()), _WIDTH)
    return "".join(f"-- {line}\n" for line in lines)
