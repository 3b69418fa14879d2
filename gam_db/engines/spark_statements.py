"""Statements about Spark's catalogue, as trees: their names and places are data."""

from sqlglot import exp

from gam_db import template


def refresh(table: exp.Table) -> str:
    """Let Spark look anew for the files of a table."""
    return _text(exp.Refresh(this=table.copy(), kind="TABLE"))


def drop(kind: str, table: exp.Table) -> str:
    """Let Spark forget a table or view; the files of an external table stay."""
    return _text(exp.Drop(tables=[table.copy()], kind=kind, exists=True))


def make_schema(schema: str, place: str) -> str:
    """Make a schema whose own folder is elsewhere."""
    where = exp.LocationProperty(this=template.text(place))
    return _text(
        exp.Create(
            this=exp.Table(db=template.name(schema)),
            kind="SCHEMA",
            exists=True,
            properties=exp.Properties(expressions=[where]),
        )
    )


def drop_schema(schema: str) -> str:
    """Let Spark forget a schema and all that it knows of it."""
    return _text(
        exp.Drop(tables=[exp.Table(db=template.name(schema))], kind="SCHEMA", exists=True, cascade=True)
    )


def move(table: exp.Table, place: str) -> str:
    """Point a table to other files."""
    where = exp.AlterSet(location=template.text(place))
    return _text(exp.Alter(this=table.copy(), kind="TABLE", actions=[where]))


def describe(table: exp.Table) -> str:
    """Ask for all that is known of a table."""
    return _text(exp.Describe(this=table.copy(), style="EXTENDED", kind="TABLE"))


def _text(tree: exp.Expr) -> str:
    return tree.sql(dialect="spark")
