"""How an engine writes the definition of a table or view: keys, formats and comments.

This module owns the forms that engines share; what an engine wants is said in its own file.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import Literal, TypeAlias, cast

from sqlglot import exp

Note: TypeAlias = Callable[[exp.Expr], exp.Expr]


@dataclass(frozen=True)
class Storage:
    """How an engine keeps tables and views, and what it has of comments."""

    #: Whether they are statements of their own, stand inside of definitions, or are none.
    comments: Literal["apart", "inside", "none"] = "apart"
    view_comments: bool = True  # whether views have some, too, where they stand inside
    #: How the comment of the whole is written there.
    note: Note = lambda said: exp.SchemaCommentProperty(this=said)
    column_note: Note = lambda said: exp.CommentColumnConstraint(this=said)  # the same of a column
    #: What is said of the storage of a table.
    properties: Callable[["Definition"], Sequence[exp.Expr]] = lambda _: ()
    #: Changes a column of a table that is made or added.
    column: Callable[[exp.ColumnDef], None] = lambda _: None
    #: Whether texts of any length can be in an index on the key; None for no index.
    index: bool | None = None
    adds_twice: bool = True  # whether a column that is there can be left alone when it is added again
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
        if is_view and is_inside:
            named = [exp.ColumnDef(this=exp.to_identifier(name)) for name in definition.columns]
            create.set("this", exp.Schema(this=target, expressions=named))
        for column in create.this.expressions:
            if not is_view:
                self.column(column)
            if is_inside:
                self._comment(column, definition.columns)
        properties += [self.note(definition.comment.copy())] if is_inside else []
        if properties:
            create.set("properties", exp.Properties(expressions=properties))
        if not is_view and self.index is not None:
            statements.append(_key_index(definition, self.index))
        if self.comments == "apart":
            comment = definition.comment.copy()
            statements.append(exp.Comment(this=target.copy(), kind=create.kind, expression=comment))
            statements += _about(target, definition.columns)
        return statements

    def extend(self, addition: "Addition") -> list[exp.Expr]:
        """Return an ALTER TABLE for each column that is added, and the comments."""
        statements: list[exp.Expr] = []
        for column in addition.columns.values():
            made = column.copy()
            made.set("exists", self.adds_twice or None)
            self.column(made)
            if self.comments == "inside":
                self._comment(made, addition.comments)
            statements.append(exp.Alter(this=addition.table.copy(), kind="TABLE", actions=[made]))
        apart = _about(addition.table, addition.comments) if self.comments == "apart" else []
        return [*statements, *apart]

    def _comment(self, column: exp.ColumnDef, comments: Mapping[str, exp.Expr]) -> None:
        """Write the comment of a column inside its definition."""
        said = self.column_note(comments[column.name].copy())
        column.append("constraints", exp.ColumnConstraint(kind=said))


#: As most do.
APART = Storage()


@dataclass(frozen=True)
class Definition:
    """A table or view, and what a data dictionary says of it."""

    create: exp.Create  # CREATE TABLE with its columns, or CREATE VIEW with its query
    comment: exp.Expr  # what it holds, as a literal
    columns: Mapping[str, exp.Expr]  # what each column means, by its name, in order

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
    """Columns that a table gets later; rows that are there have NULL in them."""

    table: exp.Table  # that is changed
    columns: Mapping[str, exp.ColumnDef]  # what is added, by name, in order
    #: What each column means, by its name, and what columns that are there mean from now on: an engine
    #: whose comments stand inside the definition leaves those as they are.
    comments: Mapping[str, exp.Expr]


@dataclass(frozen=True)
class Filling:
    """What the rows that are there have in columns that were added."""

    whole: Definition  # the table with them
    #: UPDATE ... AS kept SET column = COALESCE(kept.column, found.column), ... FROM (...) AS found WHERE
    #: kept.key = found.key AND ...; there is one row of *found* at most for each key.
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


def _key_index(definition: Definition, texts: bool) -> exp.Expr:
    """Return CREATE INDEX on the key of a table, called after it; without texts that do not fit."""
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


def clustered(definition: Definition) -> list[exp.Expr]:
    """Return CLUSTER BY the key of a table."""
    return [exp.ClusterProperty(expressions=definition.key)]
