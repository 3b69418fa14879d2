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
    tables: set[str] = set()
    for place, path in enumerate(sorted(folder.glob("*.sql")), start=1):
        matched = _FILE.fullmatch(path.name)
        if not matched:
            raise MigrationError(f"migrations/{path.name} is not called like 0001_name.sql.")
        number = int(matched[1])
        if number != place:
            raise MigrationError(
                f"The migrations in {folder.name}/ are not numbered 1, 2, ...: number {place} is "
                f"{'there twice' if number < place else 'missing'}."
            )
        try:
            statements = parsed(path.read_bytes())
        except SqlglotError as error:
            raise MigrationError(f"migrations/{path.name} cannot be parsed: {error}") from error
        _check_form(path.name, statements, tables)


def _check_form(file: str, statements: Sequence[exp.Expr], tables: set[str]) -> None:
    """Refuse a file that is not one table or view after another, each with its comments."""
    starts = [n for n, one in enumerate(statements) if isinstance(one, exp.Create)]
    if not starts or starts[0] != 0:
        raise MigrationError(f"migrations/{file} must begin with a table or a view.")
    for start, end in zip(starts, [*starts[1:], len(statements)], strict=True):
        create, about = statements[start], statements[start + 1 : end]
        name = _check_definition(file, create, about)
        if create.args["kind"] == "TABLE":
            if name in tables:
                raise MigrationError(f"migrations/{file} makes {name} again.")
            tables.add(name)


def _check_definition(file: str, create: exp.Expr, about: Sequence[exp.Expr]) -> str:
    """Return the name of a table or view, which has a comment on the whole, then on each column."""
    is_safe = create.args.get("exists" if create.args["kind"] == "TABLE" else "replace")
    if not is_safe or not all(isinstance(one, exp.Comment) for one in about):
        raise MigrationError(
            f"migrations/{file} holds something else than tables (if not exists) and views (or replace) "
            "with their comments."
        )
    target = create.find(exp.Table)
    name = "" if target is None else target.name
    named = create.this.expressions if isinstance(create.this, exp.Schema) else create.expression.selects
    whole, *columns = about or [exp.Null()]
    if (
        not name.startswith("stored_")
        or whole.args.get("kind") != create.args["kind"]
        or any(one.args["kind"] != "COLUMN" for one in columns)
        or [one.this.name for one in columns] != [column.alias_or_name for column in named]
        or any(_table_of(one) != name for one in about)
    ):
        raise MigrationError(
            f"migrations/{file} must make stored_<name>, each with a comment on it and then on each "
            "column, in order."
        )
    return name


def _table_of(comment: exp.Expr) -> str:
    return str(comment.this.table if isinstance(comment.this, exp.Column) else comment.this.name)
