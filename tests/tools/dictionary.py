"""The data dictionary, from the migrations: ``python tests/tools/dictionary.py > docs/tables.md``."""

from gam_db.engines.storage import Definition
from gam_db.stored.schema.migration_files import definitions
from gam_db.stored.schema.tables import FOR_READERS
from state_names import called

HEAD = """\
# The tables of the state

This page lists every table, view and column that `gam migrate` makes, with the usual prefix. The same
words are comments in the database: of columns where people and other tools read, of tables and views
everywhere. Times are integers: microseconds since 1970 (UTC), or steps of the source's counter.

First what people and other tools read; then, as `gam_state_...`,
[what only gam-db uses](#what-only-gam-db-uses).

## What people and other tools read
"""

APART = """\
## What only gam-db uses

Runs write and read these; they may change with any version.
"""


def section(name: str, definition: Definition) -> str:
    """One table or view."""
    kind = "view" if definition.is_view else "table"
    lines = [f"### {called(name)} ({kind})", "", f"{definition.comment.name}.", ""]
    columns = {} if definition.is_view else {one.name: one for one in definition.create.this.expressions}
    lines += ["| column | type | |", "|---|---|---|"] if columns else ["| column | |", "|---|---|"]
    for name, said in definition.columns.items():
        kinds = ""
        if columns:
            present = any(
                rule.kind.key == "notnullcolumnconstraint" for rule in columns[name].constraints
            )
            kinds = f"{columns[name].kind.sql('snowflake')}{'' if present else ', may be NULL'} | "
        lines.append(f"| {name} | {kinds}{said.name} |")
    return "\n".join(lines) + "\n"


def text() -> str:
    """The whole page: views for readers first, then their tables, then all else."""
    made = definitions()
    shown = sorted(
        (name for name in made if name in FOR_READERS), key=lambda name: not made[name].is_view
    )
    apart = (name for name in made if name not in FOR_READERS)
    return "\n".join(
        [
            HEAD,
            *(section(name, made[name]) for name in shown),
            APART,
            *(section(name, made[name]) for name in apart),
        ]
    )


if __name__ == "__main__":
    print(text(), end="")
