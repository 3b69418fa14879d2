"""What a migration must be like, so that every engine can be given it and it is safe to run twice."""

import re
from collections.abc import Sequence
from pathlib import Path

from sqlglot import exp
from sqlglot.errors import SqlglotError

from gam_db.stored.schema.migration_files import parsed

_FILE = re.compile(r"([0-9]{4})_([a-z_]+)\.sql")


class MigrationError(Exception):
    """A file of migrations/ breaks the form."""


def check(folder: Path) -> None:
    """Refuse migrations that break the form, or whose numbers have a gap or repeat."""
    known: dict[str, list[str]] = {}
    for place, path in enumerate(sorted(folder.glob("*.sql")), start=1):
        matched = _FILE.fullmatch(path.name)
        if not matched:
            raise MigrationError(f"migrations/{path.name} is not called like 0001_name.sql.")
        number, name = int(matched[1]), matched[2]
        if number != place:
            raise MigrationError(
                f"The migrations in {folder.name}/ are not numbered 1, 2, ...: number {place} is "
                f"{'there twice' if number < place else 'missing'}."
            )
        try:
            statements = parsed(path.read_bytes())
        except SqlglotError as error:
            raise MigrationError(f"migrations/{path.name} cannot be parsed: {error}") from error
        updates = [one for one in statements if isinstance(one, exp.Update)]
        statements = [one for one in statements if not isinstance(one, exp.Update)]
        if statements and isinstance(statements[0], exp.Alter):
            if name not in known:
                raise MigrationError(
                    f"The migration number {place} adds columns to a table that no file before it makes."
                )
            added, said = _added(path.name, name, statements)
            if not set(said) <= {*added, *known[name]}:
                raise MigrationError(
                    f"The migration number {place} has a comment on a column that its table has not."
                )
            known[name] += added
        else:
            added, known[name] = [], _made(path.name, name, statements)
        if updates:
            _check_filling(path.name, name, added, updates)


def _made(file: str, name: str, statements: Sequence[exp.Expr]) -> list[str]:
    """Return the columns of what a file makes: one table or view, called like it, with all comments."""
    create, *about = statements or [exp.Null()]
    twice = isinstance(create, exp.Create) and (
        create.args.get("exists") if create.kind == "TABLE" else create.args.get("replace")
    )
    if not twice or not all(isinstance(one, exp.Comment) for one in about):
        raise MigrationError(
            f"migrations/{file} holds something else than one table (if not exists) or one view (or "
            "replace) with its comments."
        )
    target = create.find(exp.Table)
    named = create.this.expressions if isinstance(create.this, exp.Schema) else create.expression.selects
    columns = [column.alias_or_name for column in named]
    said = [one.this.name for one in about if one.args["kind"] == "COLUMN"]
    if (
        target is None
        or target.name != f"stored_{name}"
        or said != columns
        or [one.args["kind"] for one in about if one.args["kind"] != "COLUMN"] != [create.args["kind"]]
        or any(_table_of(one) != f"stored_{name}" for one in about)
    ):
        raise MigrationError(
            f"migrations/{file} must make stored_{name}, with a comment on it and then on each "
            "column, in order."
        )
    return columns


def _added(file: str, name: str, statements: Sequence[exp.Expr]) -> tuple[list[str], list[str]]:
    """Return the columns that a file adds to the table it is called after, and those it speaks of."""
    changes = [one for one in statements if isinstance(one, exp.Alter)]
    about = [one for one in statements if isinstance(one, exp.Comment)]
    columns = [
        action.name
        for change in changes
        for action in change.args["actions"]
        # Rows that are there have nothing to say in it.
        if isinstance(action, exp.ColumnDef) and action.args.get("exists") and not action.constraints
    ]
    said = [one.this.name for one in about if one.args["kind"] == "COLUMN"]
    if (
        [*changes, *about] != list(statements)
        or len(columns) != len(changes)
        or any(change.this.name != f"stored_{name}" for change in changes)
        or said[: len(columns)] != columns
        or len(about) != len({*said})
        or any(_table_of(one) != f"stored_{name}" for one in about)
    ):
        raise MigrationError(
            f"migrations/{file} must add columns to stored_{name}, one by one (add column if not "
            "exists, NULL in the rows that are there), with a comment on each, in order, and then "
            "perhaps on columns that are there and mean something else from now on."
        )
    return columns, said


def _check_filling(file: str, name: str, added: list[str], updates: Sequence[exp.Update]) -> None:
    """Refuse to fill rows that are there in a form that not every engine has."""
    update = updates[0]
    found = update.args["from_"].this if update.args.get("from_") else exp.Null()
    where = update.args["where"].this if update.args.get("where") else exp.Null()
    inner = found.this if isinstance(found, exp.Subquery) else exp.Select()
    group = inner.args.get("group") or exp.Group()
    keys = [key.name for key in group.expressions]
    wanted = [exp.column(key, "kept").eq(exp.column(key, "found")) for key in keys]
    filled = [one.this.name for one in update.expressions]
    sources = [
        exp.func("COALESCE", exp.column(column, "kept"), exp.column(column, "found"))
        for column in filled
    ]
    if (
        len(updates) > 1
        or (update.this.name, update.this.alias, found.alias) != (f"stored_{name}", "kept", "found")
        or not keys
        or list(where.flatten() if isinstance(where, exp.And) else [where]) != wanted
        or not set(filled) <= set(added)
        or [one.expression for one in update.expressions] != sources
    ):
        raise MigrationError(
            f"migrations/{file} fills columns in a form that not every engine has; it must fill those "
            "that it adds by the one statement that migrations/README.md shows, with all keys in order."
        )


def _table_of(comment: exp.Expr) -> str:
    return str(comment.this.table if isinstance(comment.this, exp.Column) else comment.this.name)
