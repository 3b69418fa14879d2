"""The few words of Jinja that a model needs, as nodes of a tree and as lines around a query.

This module owns how a query names what dbt knows. A node of it is put into the tree like any other table
and written as it is; the text of a query is never searched for names.
"""

from collections.abc import Mapping
from typing import Any

from sqlglot import exp

from gam_db.errors import wrong

THIS = exp.Table(this=exp.var("{{ this }}"))

_SIGNS = ("{{", "{%", "{#")


def reference(model: str) -> exp.Table:
    """Return the node that reads another model."""
    return exp.Table(this=exp.var(f"{{{{ ref({_quoted(model)}) }}}}"))


def source(name: str, table: str) -> exp.Table:
    """Return the node that reads a table of a source."""
    return exp.Table(this=exp.var(f"{{{{ source({_quoted(name)}, {_quoted(table)}) }}}}"))


def config(settings: Mapping[str, Any]) -> str:
    """Return the line that configures a model."""
    said = ", ".join(f"{name}={_value(value)}" for name, value in settings.items())
    return f"{{{{ config({said}) }}}}"


def run(statement: str) -> str:
    """Return what runs a statement in the transaction of a test, which has no hooks."""
    return f"{{% call statement('before') %}}{statement}{{% endcall %}}"


def in_two_forms(later: str, first: str) -> str:
    """Return what an incremental model says: in a later build, and in the first or a full one."""
    return f"{{% if is_incremental() %}}\n\n{later}\n\n{{% else %}}\n\n{first}\n\n{{% endif %}}"


def check_is_free(tree: exp.Expr) -> None:
    """Refuse names and texts of the user that dbt would take for Jinja."""
    for node in tree.find_all(exp.Literal, exp.Identifier):
        if any(sign in node.name for sign in _SIGNS):
            raise wrong("jinja_in_a_name", name=node.name, names=", ".join(_SIGNS))


def _value(value: Any) -> str:
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_value(one) for one in value)}]"
    return "true" if value is True else "false" if value is False else repr(value)


def _quoted(text: str) -> str:
    return '"{}"'.format(text.replace("\\", "\\\\").replace('"', '\\"')) if "'" in text else f"'{text}'"
