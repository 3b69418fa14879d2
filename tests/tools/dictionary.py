"""The data dictionary, from the migrations: ``python tests/tools/dictionary.py > docs/tables.md``."""

from gam_db.engines.storage import Definition
from gam_db.stored.schema.migration_files import definitions

HEAD = """\
# The tables of the state

What `gam migrate` makes, with the default prefix. The same words are comments in the database. Times are
integers: microseconds since 1970 (UTC), or steps of the source's counter.
"""


def section(name: str, definition: Definition) -> str:
    """One table or view."""
    kind = "view" if definition.is_view else "table"
    lines = [f"## gam_{name} ({kind})", "", f"{definition.comment.name}.", ""]
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
    """The whole page."""
    return "\n".join([HEAD, *(section(*made) for made in definitions().items())])


if __name__ == "__main__":
    print(text(), end="")
