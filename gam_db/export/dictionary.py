"""What each column of a package means, in the words of the state tables' own comments.

This module owns where a description comes from: the migrations for columns, the files of ``sql/`` for
models. Nothing is said twice.
"""

from sqlglot import exp

from gam_db import template
from gam_db.stored.migration_files import definitions

#: Columns that a package has and the state tables have not.
_OWN = {
    "calibration_no": "Which rule of calibration applies: 0 the general one, 1, 2, ... the overrides"
}

#: Where a column is looked for that the table of the same name has not.
_ELSEWHERE = ("channel", "version", "fleet", "health")


def about(path: str) -> str:
    """Return what a model holds, as the file of ``sql/`` says, without its title and line ends."""
    said = " ".join(template.load(path).comment.split())
    told = said.partition(": ")[2]
    return f"{told[:1].upper()}{told[1:]}"


def meaning(table: str, column: str) -> str:
    """Return what a column means."""
    if column in _OWN:
        return _OWN[column]
    for name in (table, *_ELSEWHERE):
        columns = definitions()[name].columns
        if column in columns:
            return columns[column].name
    raise KeyError(column)


def is_always_there(table: str, column: str) -> bool:
    """Tell whether a column of a table is never NULL; nothing is said of views but of their names."""
    for name in (table, "channel", "version"):
        definition = definitions()[name]
        if column in definition.columns and not definition.is_view:
            (found,) = (one for one in definition.create.this.expressions if one.name == column)
            return found.find(exp.NotNullColumnConstraint) is not None
    return False
