"""Rewrites of trees that several engines take, each with its reason."""

from sqlglot import exp
from sqlglot.dialects.dialect import Dialect


def strip_null_order(tree: exp.Expr, dialect: Dialect) -> exp.Expr:
    """Leave the order of NULLs to the engine.

    Cause: engines differ in whether NULL sorts first, so sqlglot adds NULLS LAST to keep DuckDB's
    order. Symptom: some engines refuse it in windows, and others sort slower for it. The keys we
    order by are never NULL.
    """
    ordering = dialect.NULL_ORDERING
    for ordered in tree.find_all(exp.Ordered):
        first_of_all = "nulls_are_large" if ordered.args.get("desc") else "nulls_are_small"
        ordered.set("nulls_first", ordering == first_of_all)
    return tree


def drop_flow_hint(tree: exp.Expr) -> exp.Expr:
    """Drop NOT MATERIALIZED, for engines that have no such words and let WITH entries flow anyway."""
    for entry in tree.find_all(exp.CTE):
        entry.set("materialized", None)
    return tree


def newest_as_largest(tree: exp.Expr, most: int) -> exp.Expr:
    """Ask for the largest value up to a row instead of the newest one of some rows, unless they are few.

    Cause: few engines know LAST_VALUE(... IGNORE NULLS), some take the words and ignore them, and one
    goes back row by row. Symptom: a syntax error, or NULL, or it takes as long as the frame is. Where we
    ask for it, values grow along the order, and farther back than the frame they do not matter
    (``sql/embedding/newest.sql``).
    """
    for window in tree.find_all(exp.Window):
        if isinstance(window.this, exp.IgnoreNulls):
            frame = window.args["spec"]
            if int(frame.args["start"].name) >= most:
                window.set("this", exp.Max(this=window.this.this.this))
                frame.set("start", "UNBOUNDED")
    return tree


def at_home(tree: exp.Expr, home: str) -> exp.Expr:
    """Write the schema of tables that name none, so that no search path is needed."""
    for table in tree.find_all(exp.Table):
        if isinstance(table.this, exp.Identifier) and not table.db and not _is_entry(table):
            table.set("db", _schema(home))
    for comment in tree.find_all(exp.Comment):
        if isinstance(comment.this, exp.Column) and not comment.this.db:
            comment.this.set("db", _schema(home))
    return tree


def _schema(name: str) -> exp.Identifier:
    """Return the name of a schema, quoted if that makes a difference."""
    return exp.to_identifier(name, quoted=name != "public")


def _is_entry(table: exp.Table) -> bool:
    """Tell whether a table is an entry of a WITH list around it; an entry sees those before it."""
    within: exp.Expr | None = table
    entry: exp.Expr | None = None
    while within is not None:
        entry = within if isinstance(within, exp.CTE) else entry
        entries = within.args.get("with_")
        for earlier in entries.expressions if entries is not None else ():
            if earlier is entry:
                break
            if earlier.alias == table.name:
                return True
        within = within.parent
    return False


def escape_by_backslash(tree: exp.Expr) -> exp.Expr:
    """Write LIKE patterns with a backslash before a sign that is meant as written.

    Cause: these engines have no ESCAPE clause. Symptom: a syntax error at ESCAPE, for patterns of
    assets or channels with a wildcard.
    """
    for escape in list(tree.find_all(exp.Escape)):
        like = escape.this
        pattern = like.expression.this.replace("\\", "\\\\")
        for sign in "%_!":
            pattern = pattern.replace(f"!{sign}", sign if sign == "!" else f"\\{sign}")
        like.set("expression", exp.Literal.string(pattern))
        escape.replace(like)
    return tree


def compare_by_bytes(collation: exp.Expr, tree: exp.Expr) -> exp.Expr:
    """Compare and order names by their bytes, by a collation that does, from where they are read on.

    Cause: text is compared and ordered by the collation of its column, else of the database. Symptom:
    with a common locale (en_US, not C) channels are numbered in another order than elsewhere, and the
    blocks of a pool with them; in a case-insensitive column A1 and a1 are one machine.
    """
    for alias in tree.find_all(exp.Alias):
        if isinstance(alias.this, exp.Cast) and alias.this.to.is_type(*exp.DataType.TEXT_TYPES):
            alias.set("this", exp.Collate(this=alias.this.copy(), expression=collation.copy()))
    return tree
