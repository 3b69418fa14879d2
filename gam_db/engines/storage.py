"""How an engine writes the definition of a table or view: keys, formats and comments.

This module owns the forms that engines share; what an engine wants is said in its own file.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import TypeAlias

from sqlglot import exp

Note: TypeAlias = Callable[[exp.Expr], exp.Expr]


@dataclass(frozen=True)
class Definition:
    """A table or view, and what a data dictionary says of it.

    Attributes:
        create: CREATE TABLE with its columns, or CREATE VIEW with its query.
        comment: what it holds, as a literal.
        columns: what each column means, by its name, in order.
    """

    create: exp.Create
    comment: exp.Expr
    columns: Mapping[str, exp.Expr]

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


@dataclass(frozen=True)
class Addition:
    """Columns that a table gets later; rows that are there have NULL in them.

    Attributes:
        table: that is changed.
        columns: what is added, by name, in order.
        comments: what each column means, by its name.
    """

    table: exp.Table
    columns: Mapping[str, exp.ColumnDef]
    comments: Mapping[str, exp.Expr]


def with_statements(definition: Definition) -> list[exp.Expr]:
    """Return the definition with a COMMENT ON for itself and each of its columns."""
    create = definition.create.copy()
    target = create.this.this if isinstance(create.this, exp.Schema) else create.this
    whole = exp.Comment(this=target.copy(), kind=create.kind, expression=definition.comment.copy())
    return [create, whole, *_about(target, definition.columns)]


def _about(table: exp.Table, columns: Mapping[str, exp.Expr]) -> list[exp.Expr]:
    """Return a COMMENT ON for each column."""
    return [
        exp.Comment(
            this=exp.Column(this=exp.to_identifier(name), table=table.this, db=table.args.get("db")),
            kind="COLUMN",
            expression=said.copy(),
        )
        for name, said in columns.items()
    ]


def with_notes(
    definition: Definition,
    properties: Sequence[exp.Expr] = (),
    column_note: Note = lambda said: exp.CommentColumnConstraint(this=said),
    note: Note = lambda said: exp.SchemaCommentProperty(this=said),
) -> list[exp.Expr]:
    """Return the definition with its comments inside.

    Args:
        definition: what is defined.
        properties: what the engine wants to know of the storage of a table.
        column_note: how the comment of a column is written.
        note: how the comment of the whole is written.
    """
    create = definition.create.copy()
    if definition.is_view:
        named = [exp.ColumnDef(this=exp.to_identifier(name)) for name in definition.columns]
        create.set("this", exp.Schema(this=create.this, expressions=named))
    if isinstance(create.this, exp.Schema):
        for column in create.this.expressions:
            said = definition.columns[column.name].copy()
            column.append("constraints", exp.ColumnConstraint(kind=column_note(said)))
    stored = [] if definition.is_view else list(properties)
    create.set("properties", exp.Properties(expressions=[*stored, note(definition.comment.copy())]))
    return [create]


def added(addition: Addition, twice: bool = True) -> list[exp.Expr]:
    """Return an ALTER TABLE for each column, without comments.

    Args:
        addition: what is added.
        twice: whether the engine can be told to leave a column alone that is there already.
    """
    statements: list[exp.Expr] = []
    for column in addition.columns.values():
        made = column.copy()
        made.set("exists", twice or None)
        statements.append(exp.Alter(this=addition.table.copy(), kind="TABLE", actions=[made]))
    return statements


def added_with_statements(addition: Addition, twice: bool = True) -> list[exp.Expr]:
    """Return the same, and a COMMENT ON for each column."""
    return [*added(addition, twice), *_about(addition.table, addition.comments)]


def added_with_notes(
    addition: Addition,
    twice: bool = True,
    column_note: Note = lambda said: exp.CommentColumnConstraint(this=said),
) -> list[exp.Expr]:
    """Return the same with the comments inside; see :func:`with_notes`."""
    statements = added(addition, twice)
    for statement in statements:
        (column,) = statement.args["actions"]
        said = addition.comments[column.name].copy()
        column.append("constraints", exp.ColumnConstraint(kind=column_note(said)))
    return statements


def key_index(definition: Definition) -> exp.Expr:
    """Return CREATE INDEX on the key of a table, called after it."""
    table = definition.create.this.this
    index = exp.Index(
        this=exp.to_identifier(f"{table.name}_key", quoted=True),
        table=table.copy(),
        params=exp.IndexParameters(columns=[exp.Ordered(this=key) for key in definition.key]),
    )
    return exp.Create(this=index, kind="INDEX", exists=True)


def clustered(definition: Definition) -> exp.Expr:
    """Return CLUSTER BY the key of a table."""
    return exp.ClusterProperty(expressions=definition.key)
