"""Definitions of tables and views of an engine: keys, formats and comments.

This module owns the forms that engines share; the file of an engine has its choices.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import Literal, TypeAlias

from sqlglot import exp

Note: TypeAlias = Callable[[exp.Expr], exp.Expr]


@dataclass(frozen=True)
class Storage:
    """The storage of tables and views of an engine, and the comments that it supports."""

    #: Whether they are statements of their own, stand inside of definitions, or are none.
    comments: Literal["apart", "inside", "none"] = "apart"
    view_comments: bool = True  # whether views have some, too, where they stand inside
    #: How the comment of the whole is written there.
    note: Note = lambda comment: exp.SchemaCommentProperty(this=comment)
    column_note: Note = lambda comment: exp.CommentColumnConstraint(this=comment)  # the same of a column
    #: The storage clauses of a table.
    properties: Callable[["Definition"], Sequence[exp.Expr]] = lambda _: ()
    temporary: Sequence[exp.Expr] = ()  # the same of a temporary table
    #: Changes a column of a table that is made.
    column: Callable[[exp.ColumnDef], None] = lambda _: None
    #: Whether texts of any length can be in an index on the key; None for no index.
    index: bool | None = None
    replaces_views: bool = True  # whether CREATE OR REPLACE VIEW is known

    def define(self, definition: "Definition") -> list[exp.Expr]:
        """Return the statements that make a table or view of the state, the caller's own tree."""
        create, is_view = definition.create, definition.is_view
        target = create.this.this if isinstance(create.this, exp.Schema) else create.this
        is_inside = self.comments == "inside" and (self.view_comments or not is_view)
        properties = [] if is_view else list(self.properties(definition))  # the key is told by NOT NULL
        statements: list[exp.Expr] = [create]
        if is_view and not self.replaces_views:
            create.set("replace", False)
            statements.insert(0, exp.Drop(tables=[target.copy()], kind="VIEW", exists=True))
        if is_view and is_inside and definition.is_shown:
            named = [exp.ColumnDef(this=exp.to_identifier(name)) for name in definition.columns]
            create.set("this", exp.Schema(this=target, expressions=named))
        for column in create.this.expressions:
            if not is_view:
                self.column(column)
            if is_inside and definition.is_shown:
                self._comment(column, definition.columns)
        properties += [self.note(definition.comment.copy())] if is_inside else []
        if properties:
            create.set("properties", exp.Properties(expressions=properties))
        if not is_view and self.index is not None:
            statements.append(_key_index(definition, self.index))
        if self.comments == "apart":
            comment = definition.comment.copy()
            statements.append(exp.Comment(this=target.copy(), kind=create.kind, expression=comment))
            statements += _about(target, definition.columns) if definition.is_shown else []
        return statements

    def _comment(self, column: exp.ColumnDef, comments: Mapping[str, exp.Expr]) -> None:
        """Write the comment of a column inside its definition."""
        constraint = self.column_note(comments[column.name].copy())
        column.append("constraints", exp.ColumnConstraint(kind=constraint))


#: As most do.
APART = Storage()


@dataclass(frozen=True)
class Definition:
    """A table or view, and its entry in a data dictionary."""

    create: exp.Create  # CREATE TABLE with its columns, or CREATE VIEW with its query
    comment: exp.Expr  # what it holds, as a literal
    columns: Mapping[str, exp.Expr]  # what each column means, by its name, in order
    is_shown: bool = True  # whether the database says of each column what it means, too

    @property
    def is_view(self) -> bool:
        """Tell whether it is a view."""
        return str(self.create.kind) == "VIEW"

    @property
    def key(self) -> list[exp.Expr]:
        """The columns that a table is best ordered by: the first two, as far as they are never NULL."""
        columns = [] if self.is_view else self.create.this.expressions
        present = takewhile(lambda column: column.find(exp.NotNullColumnConstraint) is not None, columns)
        return [exp.column(column.this.copy()) for column in list(present)[:2]]


def _about(table: exp.Table, columns: Mapping[str, exp.Expr]) -> list[exp.Expr]:
    """Return a COMMENT ON for each column."""
    return [
        exp.Comment(
            this=exp.Column(this=exp.to_identifier(name), table=table.this, db=table.args.get("db")),
            kind="COLUMN",
            expression=comment.copy(),
        )
        for name, comment in columns.items()
    ]


def _key_index(definition: Definition, texts: bool) -> exp.Expr:
    """Return CREATE INDEX on the key of a table, called after it; without texts that do not fit."""
    table = definition.create.this.this
    kinds = {column.name: column.kind for column in definition.create.this.expressions}
    key = [
        column
        for column in definition.key
        if texts or not kinds[column.name].is_type(*exp.DataType.TEXT_TYPES)
    ]
    index = exp.Index(
        this=exp.to_identifier(f"{table.name}_key", quoted=True),
        table=table.copy(),
        params=exp.IndexParameters(columns=[exp.Ordered(this=column) for column in key]),
    )
    return exp.Create(this=index, kind="INDEX", exists=True)


def clustered(definition: Definition) -> list[exp.Expr]:
    """Return CLUSTER BY the key of a table."""
    return [exp.ClusterProperty(expressions=definition.key)]
