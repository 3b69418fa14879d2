"""How an engine writes the definition of a table or view: keys, formats and comments.

This module owns the forms that engines share; what an engine wants is said in its own file.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import TypeAlias, cast

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
        comments: what each column means, by its name, and what columns that are there mean from now on:
            an engine whose comments stand inside the definition leaves those as they are.
    """

    table: exp.Table
    columns: Mapping[str, exp.ColumnDef]
    comments: Mapping[str, exp.Expr]


@dataclass(frozen=True)
class Filling:
    """What the rows that are there have in columns that were added.

    Attributes:
        whole: the table with them.
        update: UPDATE ... AS kept SET column = COALESCE(kept.column, found.column), ... FROM (...) AS
            found WHERE kept.key = found.key AND ...; there is one row of *found* at most for each key.
    """

    whole: Definition
    update: exp.Update

    @property
    def table(self) -> exp.Table:
        """The table."""
        return cast(exp.Table, self.whole.create.this.this)

    @property
    def rows(self) -> exp.Insert:
        """All rows of the table as they are to be, inserted into it."""
        changed = {one.this.name: one.expression for one in self.update.expressions}
        names = [exp.to_identifier(name) for name in self.whole.columns]
        columns = [changed.get(name.name, exp.column(name, table="kept")) for name in names]
        named = [exp.alias_(one.copy(), name) for one, name in zip(columns, names, strict=True)]
        found, same = self.update.args["from_"].this, self.update.args["where"].this
        query = exp.select(*named).from_(self.update.this.copy())
        query = query.join(found.copy(), on=same.copy(), join_type="left")
        return exp.Insert(this=exp.Schema(this=self.table.copy(), expressions=names), expression=query)


def updated(filling: Filling) -> list[exp.Expr]:
    """Return the UPDATE as it is."""
    return [filling.update.copy()]


def merged(filling: Filling) -> list[exp.Expr]:
    """Return a MERGE, for engines whose UPDATE has no FROM."""
    update = filling.update.copy()
    matched = exp.When(matched=True, then=exp.Update(expressions=update.expressions))
    merge = exp.Merge(
        this=update.this,
        using=update.args["from_"].this,
        on=update.args["where"].this,
        whens=exp.Whens(expressions=[matched]),
    )
    return [merge]


def overwritten(filling: Filling) -> list[exp.Expr]:
    """Return an INSERT OVERWRITE of all rows, for tables that know no UPDATE."""
    insert = filling.rows
    insert.set("overwrite", True)
    return [insert]


def with_statements(definition: Definition) -> list[exp.Expr]:
    """Return the definition, the caller's own tree, with a COMMENT ON for it and for each column."""
    create = definition.create
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
    """Return the definition, the caller's own tree, with its comments inside.

    Properties are what the engine wants to know of the storage of a table.
    """
    create = definition.create
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

    *twice*: the engine can be told to leave a column alone that is there already.
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


def key_index(definition: Definition, texts: bool = True) -> exp.Expr:
    """Return CREATE INDEX on the key of a table, called after it; of all texts or none."""
    table = definition.create.this.this
    kinds = {column.name: column.kind for column in definition.create.this.expressions}
    key = [
        one for one in definition.key if texts or not kinds[one.name].is_type(*exp.DataType.TEXT_TYPES)
    ]
    index = exp.Index(
        this=exp.to_identifier(f"{table.name}_key", quoted=True),
        table=table.copy(),
        params=exp.IndexParameters(columns=[exp.Ordered(this=one) for one in key]),
    )
    return exp.Create(this=index, kind="INDEX", exists=True)


def clustered(definition: Definition) -> exp.Expr:
    """Return CLUSTER BY the key of a table."""
    return exp.ClusterProperty(expressions=definition.key)
